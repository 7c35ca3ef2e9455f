"""Slip that belongs to a creep under a measured table, by its own equation.

The friction of the law is that of `MeasuredTable.friction`, which reads the table by itself.
"""

from __future__ import annotations

import pytest

from wraparc.arc.kernel.table_slip import slip_under_table
from wraparc.friction import MeasuredTable
from wraparc.friction.compact import segment_of

SLIPS = (0.0, 0.0004, 0.001, 0.003)
PRESSURES = (60e3, 150e3, 400e3)
VALUES = (
    (0.05, 0.25, 0.45, 0.62),  # a jump at no slip: the belt is held there
    (0.02, 0.30, 0.52, 0.55),
    (0.01, 0.22, 0.40, 0.33),
)


@pytest.mark.parametrize("pressure", [20e3, 60e3, 90e3, 149e3, 151e3, 390e3, 900e3])
@pytest.mark.parametrize("share", [1.0, 0.6, 1e-3])
@pytest.mark.parametrize("shear", [0.0, 2e-9, 3e-8])
def test_slip_and_shear_of_the_lagging_are_the_creep(
    pressure: float, share: float, shear: float
) -> None:
    """Creep = x + (h/G) mu(x, p) p at every creep, below, at and above the tested pressures."""
    law = MeasuredTable(slip=SLIPS, pressure=PRESSURES, values=VALUES)
    compact = law.compact()
    segment = segment_of(compact, pressure)
    ease = shear * pressure
    for creep in (1e-6, 3e-5, 2e-4, 1.1e-3, 4e-3, 2e-2):
        mu, x = slip_under_table(compact, segment, ease, pressure, creep, share)
        held = float(law.friction(1e-300, pressure))
        if shear > 0.0 and creep <= ease * held:
            assert x == 0.0
            assert mu == pytest.approx(creep / ease, rel=1e-12)
            continue
        assert 0.0 < x <= creep
        assert mu == pytest.approx(float(law.friction(x, pressure)), rel=1e-11)
        assert x + ease * mu == pytest.approx(creep, rel=1e-12)
