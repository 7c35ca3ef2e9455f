"""A row is its arc alone, whatever stands beside it.

Expected values: `wraparc.arc.Distributed` of each row as an arc; and the row in a table of its own,
to the last bit. `WRAPARC_MIXED_ROWS=2000` draws as many rows.
"""

from __future__ import annotations

import math
import os
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from arc.drives import SOFTENING
from batch.batches import OF_OPERATING_POINT, SMALL
from batch.mixed import SHIPPED, any_laggings, any_row, arc_of, table_of
from wraparc.arc import Distributed, WrapArc
from wraparc.arc.quantities import BREAKAWAY
from wraparc.batch import STATUSES, Setting, solve_batch
from wraparc.batch.arcs import arcs_of_table
from wraparc.batch.precise import solve_precisely
from wraparc.batch.row import EVERYTHING, OUTCOME, TENSIONS
from wraparc.batch.rows import solve_rows
from wraparc.files import load_lagging
from wraparc.friction import IntegralLog, PressurePower

ROWS = int(os.environ.get("WRAPARC_MIXED_ROWS", "40"))
WITHIN = 1e-6
#: places of an extreme: its neighbours are next to as large, or as large where traction is held
FLAT = {"gross_slip_creep": 1e-3, "peak_shear_position": math.inf}
#: of what is a small difference: what it is a part of
PART_OF = {
    "exit_slip": "exit_creep",
    "creep_shrinkage": "exit_creep",
    "creep_compression": "exit_creep",
    "creep_global": "exit_creep",
}


@pytest.mark.parametrize("seed", [1, 2])
def test_a_row_is_its_arc(seed: int) -> None:
    rng = np.random.default_rng([52, seed])
    laggings = any_laggings(rng)
    rows = [any_row(rng, laggings) for _ in range(ROWS)]
    columns = dict(solve_batch(table_of(rows), laggings, setting=Setting.PRECISE))
    for i, row in enumerate(rows):
        arc, name = arc_of(row, laggings), laggings[row["lagging"]].name
        if isinstance(arc, str):
            assert "unfit" in STATUSES[int(columns["status"][i])], (i, name, arc)
            continue
        result = Distributed().solve(arc)
        assert STATUSES[int(columns["status"][i])] == result.status.value, (i, name)
        told = {key: float(column[i]) for key, column in columns.items()}
        misses = missed(arc, result.scalars(), told, solved=result.status.solved)
        assert not misses, (i, name, misses)


def missed(
    arc: WrapArc, alone: dict[str, float], row: dict[str, float], *, solved: bool
) -> dict[str, tuple[float, float]]:
    """The numbers of an arc that its row has otherwise, by name."""
    found = {}
    # the arc alone knows no cap of what friction past its peak carries: rows may know more
    capped = math.isnan(alone["gross_slip_capacity"])
    for name in alone.keys() & row.keys():
        expected, got = alone[name], row[name]
        capacity = name not in OF_OPERATING_POINT
        if (not capacity and not solved) or (capacity and capped):
            continue
        if not math.isfinite(expected) or not math.isfinite(got):
            if str(expected) != str(got):
                found[name] = expected, got
            continue
        size = abs(alone[PART_OF[name]]) if PART_OF.get(name) else abs(expected)
        size = arc.wrap_angle if name.endswith("_arc") else size
        if name in (
            "frictional_energy",
            "sliding_power",
            "wear_rate",
        ):  # what of the loss is not of shear
            loss = 0.1 * abs(alone["exit_creep"] * alone["peak_shear_stress"])
            size *= max(loss / max(abs(alone["frictional_energy"]), 1e-300), 1.0)
        if capacity:  # found as ln(tight/slack)
            size *= max(math.log(alone["gross_slip_capacity"]), 1.0)
        allowed = FLAT.get(name, WITHIN) * size + SMALL.get(name, 1e-18)
        if abs(got - expected) > allowed:
            found[name] = expected, got
    return found


@pytest.mark.parametrize("seed", [1, 2])
def test_a_row_alone_has_the_same_bits(seed: int) -> None:
    rng = np.random.default_rng([53, seed])
    laggings = any_laggings(rng)
    rows = [any_row(rng, laggings) for _ in range(40)]
    accuracy = Setting.ENGINEERING.accuracy
    together = solve_rows(arcs_of_table(table_of(rows), laggings), EVERYTHING, accuracy)[0]
    for i, row in enumerate(rows):
        lagging = laggings[row["lagging"]]
        own = arcs_of_table(table_of([{**row, "lagging": 0}]), lagging)
        alone = solve_rows(own, EVERYTHING, accuracy)[0][0]
        np.testing.assert_array_equal(alone, together[i], err_msg=f"row {i}, {lagging.name}")


def test_a_law_of_fewer_knots_holds_its_traction_above_the_tests() -> None:
    """Beside another of more knots: at 800 kPa where the tests end at 690 kPa."""
    laggings = [load_lagging(name) for name in ("diamond-rubber", "medium-ceramic")]
    knots = [
        len(lag.law.coefficients.pressure) for lag in laggings if isinstance(lag.law, IntegralLog)
    ]
    assert knots[0] < knots[1]
    row = {
        "entry_tension": 384e3, "exit_tension": 153.6e3, "diameter": 0.8, "wrap_angle": math.pi,
        "belt_width": 1.2, "belt_modulus": 15e6,
    }  # fmt: skip
    alone = solve_batch(row, laggings[0], setting=Setting.PRECISE)
    mixed = solve_batch(
        table_of([{**row, "lagging": i} for i in range(2)]), laggings, setting=Setting.PRECISE
    )
    for name in ("exit_creep", "gross_slip_capacity", "creep_limit_capacity"):
        assert mixed[name][0] == pytest.approx(alone[name][0], rel=1e-12), name


def test_a_power_of_pressure_without_tests_ends_no_table() -> None:
    """Of a rough mesh the tension between its points may fall below 0: no root of it is taken."""
    law = PressurePower(friction_coefficient=0.7, reference_pressure=2e5, exponent=0.4)
    lagging = load_lagging("diamond-rubber")
    lagging = type(lagging)(name="power", law=law, thickness=12e-3, shear_modulus=2.3e6)
    ratio = np.linspace(1.2, 3.0, 7)
    table: dict[str, Any] = {
        "entry_tension": 144e3, "exit_tension": 144e3 / ratio, "diameter": 0.8,
        "wrap_angle": math.pi, "belt_width": 1.2, "belt_modulus": 12.96e6, "overrun": 0.0,
    }  # fmt: skip
    batch = solve_batch(table, lagging)
    assert batch.solved.all()
    # all of the wrap slips: n mu (p0/p1)^n phi = 1 - r^-n, by the law integrated over the arc
    p1, n = 144e3 / (1.2 * 0.4), 0.4
    most = (1.0 - n * 0.7 * (2e5 / p1) ** n * math.pi) ** (-1.0 / n)
    assert batch["gross_slip_capacity"] == pytest.approx(most, rel=1e-6)


def test_the_compression_modulus_follows_the_thickness_of_rows() -> None:
    """Blocks that are lower bulge less: E_c of `Lagging.with_thickness`, unless it is given."""
    laggings = [load_lagging(name) for name in SHIPPED]
    rng = np.random.default_rng(54)
    rows = [
        any_row(rng, laggings) | {"lagging_thickness": float(rng.uniform(3e-3, 20e-3))}
        for _ in range(12)
    ]
    batch = solve_batch(table_of(rows), laggings, setting=Setting.PRECISE, capacities=False)
    fixed = {**table_of(rows), "compression_modulus": np.full(12, 2e7)}
    for i, row in enumerate(rows):
        thick = laggings[row["lagging"]].with_thickness(row["lagging_thickness"])
        arc = arc_of({**row, "lagging": 0}, [thick])
        assert isinstance(arc, WrapArc)
        result = Distributed(capacities=False).solve(arc)
        assert batch["exit_creep"][i] == pytest.approx(result.exit_creep, rel=1e-6, nan_ok=True)
    moduli = arcs_of_table(fixed, laggings).compression_modulus
    np.testing.assert_array_equal(moduli, 2e7)


def test_an_overrun_beyond_the_creep_limit_leaves_no_capacity() -> None:
    """A brake on thick soft lagging; expected: `solve` of the arc, with the tight side behind."""
    lagging = replace(load_lagging("diamond-rubber"), compression_modulus=1e6, thickness=30e-3)
    table = {"entry_tension": 100e3, "exit_tension": 400e3, "diameter": 0.8, "wrap_angle": math.pi,
             "belt_width": 1.0, "belt_modulus": 50e6}  # fmt: skip
    row = solve_batch(table, lagging, setting=Setting.PRECISE)
    arc = WrapArc(
        law=lagging.law, entry_tension=100e3, exit_tension=400e3, diameter=0.8, wrap_angle=math.pi,
        width=1.0, axial_stiffness=50e6, thickness=30e-3, shear_modulus=lagging.shear_modulus,
        compression_modulus=1e6,
    )  # fmt: skip
    alone = Distributed().solve(arc)
    capacity = alone.capacities.creep_limit_capacity
    assert capacity < 1.0
    assert row["creep_limit_capacity"][0] == pytest.approx(capacity, rel=1e-5)


def test_rows_that_idle_on_an_overrun_need_no_scalar_solver() -> None:
    """They are as solvable as any: creep from the overrun, which no pull carries. Twin: one arc."""
    rng = np.random.default_rng(54)
    laggings = [load_lagging(name) for name in SHIPPED]
    n = 24
    tension = rng.uniform(30e3, 150e3, n)
    pull = np.where(np.arange(n) % 2 == 0, 0.0, rng.uniform(-9e-6, 9e-6, n))
    table: dict[str, Any] = {
        "entry_tension": tension, "exit_tension": tension * np.exp(pull),
        "diameter": rng.uniform(0.6, 1.4, n), "wrap_angle": rng.uniform(2.8, 4.0, n),
        "belt_width": 1.2, "belt_modulus": 13e6, "lagging": np.arange(n) % 3,
    }  # fmt: skip
    arcs = arcs_of_table(table, laggings)
    assert not solve_rows(arcs, TENSIONS, 1e-6)[1].any()
    columns = dict(solve_batch(table, laggings, setting=Setting.PRECISE, capacities=False))
    for i in range(n):
        of = laggings[i % 3]
        arc = WrapArc(
            law=of.law, entry_tension=float(tension[i]),
            exit_tension=float(table["exit_tension"][i]), diameter=float(table["diameter"][i]),
            wrap_angle=float(table["wrap_angle"][i]), width=1.2, axial_stiffness=1.2 * 13e6,
            thickness=of.thickness, shear_modulus=of.shear_modulus,
            compression_modulus=of.compression_modulus,
        )  # fmt: skip
        alone = Distributed(capacities=False).solve(arc)
        for key in ("exit_creep", "peak_shear_stress", "entry_creep_ratio"):
            assert columns[key][i] == pytest.approx(getattr(alone, key), rel=WITHIN)


def test_rows_that_break_away_past_the_peak_need_no_scalar_solver() -> None:
    """Tensions that no creep carries, though the plateau of friction would. Twin: one arc each."""
    of = load_lagging("diamond-rubber")
    law = replace(SOFTENING, tested=None)
    lagging = replace(of, law=law)
    tight, ratios = 150e3, np.exp(np.linspace(3.8, 5.0, 25))
    table: dict[str, Any] = {
        "entry_tension": tight, "exit_tension": tight / ratios, "diameter": 0.8,
        "wrap_angle": 3.2, "belt_width": 1.2, "belt_modulus": 13e6,
    }  # fmt: skip
    arcs = arcs_of_table(table, lagging)
    found, left = solve_rows(arcs, TENSIONS, 1e-6)
    exact = solve_precisely(arcs, TENSIONS)
    assert (found[:, OUTCOME] == exact[:, OUTCOME]).all()
    away = exact[:, OUTCOME] == BREAKAWAY
    assert 5 < away.sum() < 25
    assert left[away].sum() <= 1  # one may be next to the largest ratio
