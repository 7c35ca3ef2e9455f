"""Rows of belts with thickness, covers and mass, against the solver of one arc."""

from __future__ import annotations

import numpy as np
import pytest

from arc.drives import LAWS, random_arc
from arc.test_thick_belt import thick
from batch.batches import lagging
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.batch import Setting, solve_batch
from wraparc.drive import Lagging

COLUMNS = {
    "entry_tension": "entry_tension", "exit_tension": "exit_tension", "diameter": "diameter",
    "wrap_angle": "wrap_angle", "belt_width": "width", "lagging_thickness": "thickness",
    "shear_modulus": "shear_modulus", "compression_modulus": "compression_modulus",
    "creep_limit": "creep_limit", "belt_speed": "belt_speed", "pitch_offset": "pitch_offset",
    "cover_compliance": "cover_compliance", "centrifugal_force": "centrifugal",
}  # fmt: skip


def rows(arcs: list[WrapArc]) -> dict[str, list[float]]:
    table = {name: [getattr(a, own) for a in arcs] for name, own in COLUMNS.items()}
    return table | {
        "belt_modulus": [a.axial_stiffness / a.width for a in arcs],
        "overrun": [np.nan if a.overrun is None else a.overrun for a in arcs],
        "recovery": [float(a.recovery) for a in arcs],
    }


@pytest.mark.parametrize("name", ["rubber", "softening", "constant", "elastic-plastic"])
def test_rows_are_those_of_the_solver_of_one(name: str) -> None:
    rng = np.random.default_rng([39, sorted(LAWS).index(name)])
    arcs = [thick(random_arc(LAWS[name], rng), rng) for _ in range(12)]
    of: Lagging = lagging(name, LAWS[name])
    for setting, within in ((Setting.PRECISE, 1e-6), (Setting.ENGINEERING, 5e-4)):
        found = solve_batch(rows(arcs), of, setting=setting)
        for i, arc in enumerate(arcs):
            told = Distributed().solve(arc)
            assert found.solved[i] == (told.status is Status.SOLVED)
            scalars = told.scalars()
            for key in ("exit_creep", "creep_limit_capacity", "least_exit_tension", "power_loss",
                        "gross_slip_capacity", "sliding_power", "efficiency", "creep_shrinkage",
                        "creep_limit_margin"):  # fmt: skip
                value = scalars[key]
                size = max(abs(value), 1e-5) if np.isfinite(value) else 1.0
                assert found[key][i] == pytest.approx(value, abs=within * size, nan_ok=True), key
