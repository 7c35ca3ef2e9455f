"""Operating points by creep: idling and braking pulleys, measured tables.

Expected values: the scalar kernel, which marches with slip as the state and cuts its steps at the
pieces of a law; the twin of tests/arc/twin.py, by SciPy, with creep as the state and a root inside;
`MeasuredTable` for the friction of a table.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from arc.drives import JUMP_TABLE, LAWS, RUBBER, SOFTENING, TABLE, random_arc
from arc.twin import Twin
from arc.wide import any_table, wide_arc
from batch.batches import columns_of, designs, lagging
from wraparc.arc import WrapArc
from wraparc.arc.kernel.quantities import SOLVED
from wraparc.batch import creep_rows, engineering, precise, row, solve_arcs
from wraparc.batch.arcs import Arcs, Array, arcs_of_table
from wraparc.batch.creep_rows import Flags, solve_left
from wraparc.batch.elementwise import Lanes
from wraparc.batch.lane_creep_law import friction_of_creep, read_law
from wraparc.batch.lane_slots import (
    AT_T,
    AT_U,
    FRICTION,
    MISSED,
    P1,
    ROW,
    SHEAR,
    SLIP,
    SLOTS,
)
from wraparc.batch.lane_tables import LaneTables
from wraparc.batch.laws import LawBank
from wraparc.errors import InputError
from wraparc.files import load_lagging
from wraparc.friction import FrictionLaw, MeasuredTable

SHIPPED = [load_lagging(name) for name in ("diamond-rubber", "medium-ceramic", "full-ceramic")]
ONE_PRESSURE = MeasuredTable(
    slip=(0.0, 1e-3, 5e-3), pressure=(2e5,), values=((0.0, 0.4, 0.6),)
)  # fmt: skip
#: a quarter of the friction within 20 um: slip all but stops there
STEP = MeasuredTable(
    slip=(0.0, 1e-3, 1.02e-3, 8e-3),
    pressure=(1e5, 4e5),
    values=((0.0, 0.3, 0.55, 0.9), (0.0, 0.2, 0.4, 0.6)),
)


def arcs_of(draw: Callable[[np.random.Generator], WrapArc], n: int, seed: int) -> list[WrapArc]:
    """Random arcs that the reader does not refuse."""
    found: list[WrapArc] = []
    for k in range(10 * n):
        try:
            found.append(draw(np.random.default_rng([seed, k])))
        except InputError:
            continue
        if len(found) == n:
            break
    return found


def columns(arcs: list[WrapArc]) -> Arcs:
    laws = {id(a.law): a.law for a in arcs}
    return columns_of(arcs, [lagging(f"law {k}", law) for k, law in enumerate(laws.values())])


def solved(arcs: Arcs) -> tuple[Array, Flags]:
    batch = engineering.LaneBatch(arcs)
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    return found, solve_left(arcs, batch.laws, batch.tables, batch.rows, batch.live, found)


def compare(arcs: Arcs, share: float) -> None:
    """Every number against the scalar kernel, of at least a share of the arcs that it solves."""
    found, done = solved(arcs)
    exact = precise.solve_precisely(arcs, row.TENSIONS)
    assert np.mean(done[exact[:, row.OUTCOME] == SOLVED]) > share
    assert not done[exact[:, row.OUTCOME] != SOLVED].any()
    a, b = found[done], exact[done]
    some = arcs.rows(np.flatnonzero(done))
    length, shear = 0.5 * some.diameter * some.wrap_angle, some.shear_compliance
    stress = b[:, row.PEAK_STRESS]
    # of the largest that there is on the arc: what is left at the exit of an idling arc is small
    creep = np.maximum(np.abs(b[:, row.EXIT_CREEP]), shear * b[:, row.ENTRY_STRESS])
    energy = stress * b[:, row.LARGEST_SLIP] + shear * stress**2
    for place, size, within in (
        (row.EXIT_CREEP, creep, 1e-4),
        (row.EXIT_SLIP, b[:, row.LARGEST_SLIP], 1e-4),
        (row.LARGEST_SLIP, b[:, row.LARGEST_SLIP], 1e-4),
        (row.EXIT_STRESS, stress, 3e-4),
        (row.ENTRY_STRESS, stress, 1e-6),
        (row.PEAK_STRESS, stress, 2e-3),
        (row.WORK, energy, 1e-4),
        (row.CREEP_RATIO, creep / length, 2e-4),
        (row.LOG_RATIO, 1.0, 1e-8),
        (row.OUTSIDE, 1.0, 2e-2),
    ):
        miss = np.abs(a[:, place] - b[:, place]) / size
        assert np.nanmax(miss) < within, (place, np.nanmax(miss))
    np.testing.assert_array_equal(a[:, row.STUCK_LENGTH], 0.0)
    np.testing.assert_array_equal(np.isnan(a[:, row.OUTSIDE]), np.isnan(b[:, row.OUTSIDE]))
    # the scalar kernel takes the tension as straight between 180 points
    change = np.abs(np.expm1(b[:, row.LOG_RATIO])) > 1e-3
    miss = np.abs(a[:, row.ACTIVE] - b[:, row.ACTIVE]) / length
    assert np.max(miss[change]) < 2e-3
    # of equal stresses along the arc (friction over 1/p, a table's plateau) either may take any
    miss = np.abs(a[:, row.PEAK_AT] - b[:, row.PEAK_AT]) / length
    assert np.quantile(miss, 0.9) < 1e-4
    # the scalar kernel's is the mean between two points, the lanes' that at a node: it is more by
    # up to a tenth, and less where slip turns between two nodes; whoever decides by it allows that
    ratio = a[:, row.STEEPEST_SLIP] / b[:, row.STEEPEST_SLIP]
    assert np.max(ratio) < 1.1
    assert np.min(ratio) > 1.0 / creep_rows.SURELY_BY
    assert np.quantile(ratio, 0.03) > 0.93


@pytest.mark.parametrize("law", [RUBBER, SOFTENING, TABLE, STEP, ONE_PRESSURE], ids=lambda x: "")
def test_numbers_are_those_of_the_scalar_kernel(law: FrictionLaw) -> None:
    """Driving, braking and idling, with and without a kick."""
    share = 0.5 if law is STEP else 0.9
    compare(columns(arcs_of(lambda rng: random_arc(law, rng), 300, 61)), share)


def test_any_table_is_solved_right_or_not_at_all() -> None:
    """Lazy at first, falling, jumping; cells of 20 um to 5 mm."""
    compare(columns(arcs_of(lambda rng: random_arc(any_table(rng), rng), 400, 62)), 0.4)


@pytest.mark.parametrize("name", ["any table", "table", "rubber", "softening"])
def test_whatever_the_reader_takes_is_solved_right_or_not_at_all(name: str) -> None:
    """Wraps of 30 to 720 deg, moduli over five powers of ten, ratios from 1 to 50."""
    compare(columns(arcs_of(lambda rng: wide_arc(name, rng), 300, 63)), 0.3)


@pytest.mark.parametrize("lag", SHIPPED, ids=lambda lag: lag.name)
def test_shipped_laggings_brake_and_idle(lag: Any) -> None:
    """Soft and stiff belts, some without a kick, one in twenty beyond what friction carries."""
    rng, n = np.random.default_rng(64), 300
    table: dict[str, Any] = dict(designs(n, 64))
    table["exit_tension"], table["entry_tension"] = table["entry_tension"], table["exit_tension"]
    idles = rng.random(n) < 0.3
    nearly = table["exit_tension"] * (1.0 + np.exp(rng.uniform(-18.0, -6.0, n)))
    table["entry_tension"] = np.where(idles, nearly, table["entry_tension"])
    table["entry_tension"] = np.where(rng.random(n) < 0.05, 1e2, table["entry_tension"])
    table["belt_modulus"] = np.exp(rng.uniform(np.log(4e6), np.log(2e8), n))
    table["overrun"] = np.where(~idles & (rng.random(n) < 0.3), 0.0, np.nan)
    compare(arcs_of_table(table, lag), 0.9)


@pytest.mark.parametrize("law", [RUBBER, TABLE, STEP], ids=["rubber", "table", "step"])
def test_they_agree_with_the_twin(law: FrictionLaw) -> None:
    arcs = arcs_of(lambda rng: random_arc(law, rng), 24, 65)
    found, done = solved(columns(arcs))
    for i in np.flatnonzero(done):
        twin = Twin(arcs[i])
        _, there = twin.solve_near(float(found[i, row.CREEP_RATIO]))
        size = max(abs(there.creep), abs(twin.kick))
        assert found[i, row.EXIT_CREEP] == pytest.approx(there.creep, abs=1e-4 * size)
        assert found[i, row.PEAK_STRESS] == pytest.approx(there.peak_stress, rel=2e-3)


@pytest.mark.parametrize("law", [TABLE, STEP, ONE_PRESSURE], ids=["table", "step", "one pressure"])
def test_slip_and_creep_belong_together(law: MeasuredTable) -> None:
    """Within and beyond the pressures and slips of the table, whatever was asked before."""
    bank = LawBank.of([TABLE, law])
    tables = LaneTables.of(bank)
    rng, n = np.random.default_rng(66), 500
    w = Lanes(SLOTS)
    w[ROW, 0] = np.full(n, float(tables.row[1]))
    w[P1, 0] = np.exp(rng.uniform(np.log(2e4), np.log(1e6), n))
    w[SHEAR, 0] = np.exp(rng.uniform(np.log(1e-10), np.log(3e-8), n))
    w[MISSED, 0] = np.zeros(n)
    read_law(w, tables.numbers, tables.halvings)
    for _ in range(4):
        t = rng.uniform(0.3, 3.0, n)
        u = rng.choice([-1.0, 1.0], n) * np.exp(rng.uniform(np.log(1e-7), np.log(3e-2), n))
        w[AT_T, 0], w[AT_U, 0] = t, u
        friction_of_creep(w, tables.numbers, tables.halvings)
        p, x = w[P1, 0] * t, np.sign(u) * w[SLIP, 0]
        np.testing.assert_allclose(w[FRICTION, 0], law.friction(x, p), rtol=1e-10)
        np.testing.assert_allclose(x + w[SHEAR, 0] * p * w[FRICTION, 0], u, rtol=1e-9)
    assert np.max(w[MISSED, 0]) < 1e-9


def test_tables_that_begin_with_friction_are_not_for_the_lanes() -> None:
    tables = LaneTables.of(LawBank.of([JUMP_TABLE, TABLE, *LAWS.values()]))
    assert tables.row[0] == -1
    assert np.flatnonzero(tables.row >= 0).tolist() == [1, 5]  # `TABLE` again


def test_past_where_a_table_falls_the_scalar_kernel_decides() -> None:
    """Another creep may meet the same tensions there."""
    falling = MeasuredTable(
        slip=(0.0, 1e-3, 2e-3, 9e-3), pressure=(1e5, 5e5),
        values=((0.0, 0.5, 0.6, 0.3), (0.0, 0.4, 0.5, 0.25)),
    )  # fmt: skip
    table = designs(200, 67)
    table["exit_tension"] = table["entry_tension"] / np.linspace(1.05, 3.0, 200)
    found, done = solved(arcs_of_table(table, lagging("falling", falling)))
    assert done.any()
    assert not done.all()
    assert np.max(found[done, row.LARGEST_SLIP]) <= 2e-3 * (1.0 + 1e-6)


def test_few_rows_are_interpreted_to_the_same_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    laws = (RUBBER, TABLE)
    arcs = columns([a for law in laws for a in arcs_of(lambda r: random_arc(law, r), 40, 68)])  # noqa: B023
    found, done = solved(arcs)
    monkeypatch.setattr(creep_rows, "pays", lambda *_: False)
    few, done_few = solved(arcs)
    np.testing.assert_array_equal(done, done_few)
    places = list(row.PLACES[row.TENSIONS])
    size = np.nanmax(np.abs(found[done][:, places]), axis=0) + 1e-9
    miss = np.abs(few[done][:, places] - found[done][:, places]) / size
    assert np.nanmax(miss) < 1e-9


def test_a_slip_speed_near_that_of_the_tests_is_left_to_the_scalar_kernel() -> None:
    table = designs(40, 69)
    table["exit_tension"] = table["entry_tension"] * 1.5
    arcs = arcs_of_table(table, SHIPPED[0])
    found, done = solved(arcs)
    assert done.all()
    for times, expected in ((3.0, True), (1.0, False), (0.3, True)):
        arcs.laws.tested_speed[:] = 1e-3
        arcs.belt_speed[:] = times * 1e-3 / found[:, row.STEEPEST_SLIP]
        assert (solved(arcs)[1] == expected).all()


def test_the_engineering_setting_takes_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """And an arc's numbers depend on itself alone."""
    monkeypatch.setattr(creep_rows, "pays", lambda *_: True)
    monkeypatch.setattr(precise, "pays", lambda *_: True)
    laws = (RUBBER, TABLE, STEP)
    arcs = columns([a for law in laws for a in arcs_of(lambda r: random_arc(law, r), 60, 70)])  # noqa: B023
    whole = solve_arcs(arcs, capacities=False).found
    order = np.random.default_rng(71).permutation(len(arcs))[:50]
    part = solve_arcs(arcs.rows(order), capacities=False).found
    np.testing.assert_array_equal(whole[order], part)
    alone = solve_arcs(arcs.rows(slice(65, 66)), capacities=False).found
    np.testing.assert_array_equal(whole[65:66], alone)
    found, done = solved(arcs)
    monkeypatch.setattr(engineering, "solve_precisely", None)  # it is not asked
    tables = np.flatnonzero(done & (arcs.law == 1))
    np.testing.assert_array_equal(
        solve_arcs(arcs.rows(tables), capacities=False).found, found[tables]
    )


def test_capacities_that_were_found_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the lanes have the capacities of a driving arc but not its operating point."""
    arcs = arcs_of_table(designs(60, 72), SHIPPED[0])
    whole = solve_arcs(arcs).found

    def lost(self: engineering.LaneBatch) -> None:
        self.left[self.fit] |= row.TENSIONS

    monkeypatch.setattr(engineering.LaneBatch, "find_tensions", lost)
    monkeypatch.setattr(engineering, "solve_precisely", None)
    found = solve_arcs(arcs).found
    np.testing.assert_array_equal(np.isnan(found), np.isnan(whole))
    capacities = [p for part, of in row.PLACES.items() if part != row.TENSIONS for p in of]
    np.testing.assert_array_equal(found[:, capacities], whole[:, capacities])
    np.testing.assert_allclose(found[:, row.EXIT_CREEP], whole[:, row.EXIT_CREEP], rtol=1e-4)
