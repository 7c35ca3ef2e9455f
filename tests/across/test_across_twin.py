"""The solver across the width against a twin by finite volumes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from across.twin import Twin
from across.wides import CORD, FABRIC, braking, mode, wide
from wraparc.across.solver import AcrossSolver
from wraparc.arc import WrapArc
from wraparc.arrays import Array

#: a fifth of the slack-side tension presses on no pulley; its lagging is squeezed unevenly
THICK = replace(FABRIC, pitch_offset=12e-3, cover_compliance=6e-9, centrifugal=12e3)


def misses(arc: WrapArc, stiffness: float, strips: int) -> tuple[float, float]:
    """How far the twin is away at entry and exit, as shares of the deviation."""
    shape = 1e-3 * mode(1, strips) - 0.2e-3 * mode(2, strips)
    given = wide(
        arc,
        strips,
        stiffness,
        radius_deviation=shape,
        entry_misfit=3e-4 * mode(1, strips),
        thickness=arc.thickness * (1.0 + (0.2 if arc.centrifugal else 0.0) * mode(1, strips)),
    )
    found = AcrossSolver().solve(given)
    twin = Twin(given).solve(found.drum_number)

    def miss(a: Array, b: Array) -> float:
        return float(np.max(np.abs(a - b)) / np.max(np.abs(a - np.mean(a))))

    assert twin.drum == pytest.approx(found.drum_number, rel=2e-4, abs=1e-6)
    return (
        miss(found.entry_tension, twin.entry_tension),
        miss(found.exit_tension, twin.exit_tension),
    )


@pytest.mark.parametrize(
    ("arc", "stiffness"),
    [(CORD, 4e4), (braking(FABRIC), 1e5), (THICK, 1e5)],
    ids=["cord", "braking", "thick and heavy"],
)
def test_twin_by_finite_volumes(arc: WrapArc, stiffness: float) -> None:
    """Source: another discretisation of the whole belt; the distance falls with more strips.

    32 strips: python benchmarks/belt_width.py twin.
    """
    few, many = misses(arc, stiffness, 8), misses(arc, stiffness, 16)
    assert few[0] < 2e-2
    assert few[1] < 3e-2
    assert many[0] < 7e-3
    assert many[1] < 1e-2
    assert many[0] < 0.5 * few[0]
