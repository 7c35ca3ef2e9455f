"""Rows of belts with thickness, covers and mass, against the solver of one arc."""

from __future__ import annotations

from dataclasses import replace

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


def test_the_lagging_slips_under_the_belt_as_fast_as_the_shell_turns() -> None:
    """The same arc without thickness, on R + e: its lagging passes by R/(R + e) faster."""
    rng = np.random.default_rng(40)
    arcs = [thick(random_arc(LAWS["rubber"], rng), rng) for _ in range(6)]
    thin = [
        replace(
            a,
            diameter=a.diameter + 2.0 * a.offset,
            wrap_angle=a.wrap_angle * a.radius / (a.radius + a.offset),
            width=a.width * a.radius / (a.radius + a.offset),
            compression_modulus=np.inf,
            overrun=1e-5,
            pitch_offset=0.0,
        )
        for a in arcs
    ]
    same = [replace(a, compression_modulus=np.inf, overrun=1e-5) for a in arcs]
    of: Lagging = lagging("rubber", LAWS["rubber"])
    own, other = (solve_batch(rows(part), of).slip_speed for part in (same, thin))
    for a, found, told in zip(arcs, own, other, strict=True):
        assert found == pytest.approx(told * a.radius / (a.radius + a.offset), rel=1e-6)
