"""The kernel's march in the lanes against the scalar kernel.

Expected values: `wraparc.batch.precise.solve_precisely`, the scalar kernel, whose searches end
within 1e-10; and NumPy's logarithms and exponentials.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from arc.drives import PIECEWISE, RUBBER, SOFTENING, integral_log
from batch.batches import designs, lagging
from wraparc.arc.kernel import answer
from wraparc.arc.kernel.quantities import BREAKAWAY, SOLVED
from wraparc.batch import Setting, engineering, from_lanes, precise, row, solve_arcs
from wraparc.batch.arcs import Arcs, Array, arcs_of_table
from wraparc.batch.elementwise import full_ex, full_ln
from wraparc.batch.lane_kernel import CREEP, LEAST, SLIP, TENSIONS
from wraparc.batch.native import compiled
from wraparc.batch.sixth import Flags, carry_in_sixth, solve_in_sixth
from wraparc.drive import Lagging
from wraparc.files import load_lagging

SHIPPED = [load_lagging(name) for name in ("diamond-rubber", "medium-ceramic", "full-ceramic")]
OTHERS = [lagging("rubber", RUBBER), lagging("free of pressure", integral_log(peak=0.6, slip=2e-2))]

FALLING = [
    *SHIPPED[1:],
    lagging("softening", SOFTENING),
    lagging("residual", integral_log(peak=0.8, slip=3e-3, slope=-15.0, residual=0.7)),
]


def both_ways(arcs: Arcs) -> tuple[Array, Flags, Array]:
    """Rows of results by the lanes, which of them are solved, and rows by the scalar kernel."""
    batch = engineering.LaneBatch(arcs)
    batch.find(row.TENSIONS)
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    done = solve_in_sixth(arcs, batch.laws, batch.begun[TENSIONS], found)
    return found, done, precise.solve_precisely(arcs, row.TENSIONS)


def wide(n: int, seed: int) -> dict[str, Any]:
    """Also far above and below the tested pressures, with soft belts, and some without a kick."""
    rng = np.random.default_rng(seed)
    table: dict[str, Any] = dict(designs(n, seed))
    factor = np.exp(rng.uniform(np.log(0.1), np.log(4.0), n))
    table["entry_tension"] = table["entry_tension"] * factor
    table["exit_tension"] = table["exit_tension"] * factor
    table["belt_modulus"] = np.exp(rng.uniform(np.log(2e6), np.log(2e8), n))
    table["overrun"] = np.where(rng.random(n) < 0.3, 0.0, np.nan)
    table["recovery"] = np.where(rng.random(n) < 0.5, 1.0, 0.0)
    return table


@pytest.mark.parametrize("lag", SHIPPED + OTHERS, ids=lambda lag: lag.name)
def test_every_number_is_that_of_the_scalar_kernel(lag: Lagging) -> None:
    arcs = arcs_of_table(wide(400, 31), lag)
    found, done, exact = both_ways(arcs)
    assert np.mean(done[exact[:, row.OUTCOME] != BREAKAWAY]) > 0.6
    for place in row.PLACES[row.TENSIONS]:
        # the fastest growth of slip may hide beside a knot of the law
        within = 3e-3 if place == row.STEEPEST_SLIP else 1e-9
        small = 1e-9 if place in (row.OUTSIDE, row.CREEP_RATIO) else 1e-12
        np.testing.assert_allclose(
            found[done, place], exact[done, place], rtol=within, atol=small, err_msg=str(place)
        )


def test_few_designs_of_shipped_laggings_are_left_to_the_scalar_kernel() -> None:
    """Those that pass the peak of friction."""
    for lag in SHIPPED:
        _, done, exact = both_ways(arcs_of_table(designs(300, 32), lag))
        assert np.mean(done[exact[:, row.OUTCOME] == SOLVED]) > 0.95


@pytest.mark.parametrize("lag", SHIPPED + OTHERS, ids=lambda lag: lag.name)
def test_every_capacity_is_that_of_the_scalar_kernel(lag: Lagging) -> None:
    """Slack-side tensions are small differences of what a search meets to 1e-9."""
    table = wide(100, 35)
    table["creep_limit"] = np.random.default_rng(36).uniform(1e-3, 6.35e-3, 100)
    arcs = arcs_of_table(table, lag)
    batch = engineering.LaneBatch(arcs)
    batch.find(row.EVERYTHING, to_begin=True)
    found = np.full((100, row.FOUND_NUMBERS), np.nan)
    left = np.full(100, row.EVERYTHING)
    from_lanes.carry(batch, found, left)
    exact = precise.solve_precisely(arcs, answer.CAPACITIES)
    for part, place, share, within in (
        (answer.CREEP_LIMIT, row.CREEP_CAPACITY, 0.6, 1e-9),
        (answer.TESTED_SLIP, row.SLIP_CAPACITY, 0.0, 1e-9),
        (answer.LEAST, row.LEAST_SLACK, 0.3, 2e-7),
        (answer.LEAST, row.MOST_PULL, 0.3, 1e-6),
        (answer.GROSS_SLIP, row.GROSS_CAPACITY, 0.0, 1e-12),
    ):
        done = (left & part) == 0
        assert np.mean(done) >= share, place
        np.testing.assert_allclose(found[done, place], exact[done, place], rtol=within)
    assert np.isfinite(found[left & answer.GROSS_SLIP == 0, row.GROSS_CAPACITY]).all()


def test_all_capacities_of_rubber_but_a_few_least_tensions_are_found_in_the_lanes() -> None:
    """Largest pulls at, just below and far below the highest tension included."""
    table = {k: np.tile(v, 4) for k, v in designs(300, 37).items()}
    # the highest tension carries about the largest pull: loads that reach it, by creep limits
    table["creep_limit"] = np.repeat([2e-3, 3e-3, 4.5e-3, 6.35e-3], 300)
    table["exit_tension"] = table["entry_tension"] * 0.3
    arcs = arcs_of_table(table, SHIPPED[0])
    batch = engineering.LaneBatch(arcs)
    batch.find(row.EVERYTHING, to_begin=True)
    found, left = np.full((1200, row.FOUND_NUMBERS), np.nan), np.full(1200, row.EVERYTHING)
    from_lanes.carry(batch, found, left)
    assert np.mean(left == row.TENSIONS) > 0.96
    assert not (left & ~(row.TENSIONS | answer.CREEP_LIMIT | answer.LEAST)).any()
    some = np.flatnonzero(np.isfinite(found[:, row.MOST_PULL]))
    assert len(some) > 100
    exact = precise.solve_precisely(arcs.rows(some), answer.LEAST)[:, row.MOST_PULL]
    np.testing.assert_allclose(found[some, row.MOST_PULL], exact, rtol=1e-7)


@pytest.mark.parametrize("lag", FALLING, ids=lambda lag: lag.name)
def test_capacities_past_the_peak_of_friction_are_those_of_the_scalar_kernel(lag: Lagging) -> None:
    """On the line and on the residual friction, and where pressure moves the peak past the slip."""
    table = wide(120, 38)
    table["creep_limit"] = np.random.default_rng(39).uniform(2e-3, 25e-3, 120)
    arcs = arcs_of_table(table, lag)
    batch = engineering.LaneBatch(arcs)
    batch.find(row.EVERYTHING, to_begin=True)
    exact = precise.solve_precisely(arcs, answer.CAPACITIES & ~answer.GROSS_SLIP)
    for what, place, within in (
        (CREEP, row.CREEP_CAPACITY, 1e-9),
        (SLIP, row.SLIP_CAPACITY, 1e-9),
        (LEAST, row.LEAST_SLACK, 2e-7),
    ):
        begun = batch.begun[what]
        if what == SLIP and lag.law.tested is None:
            assert np.isnan(begun).all()
            continue
        value = carry_in_sixth(arcs, batch.laws, what, begun, cut=True)[:, 0]
        if what == LEAST:
            value = np.where(value <= batch.top, value - batch.pull, np.nan)
        met = np.isfinite(value)
        assert np.mean(met[np.isfinite(begun[:, 0])]) > 0.9, place
        short = np.isnan(carry_in_sixth(arcs, batch.laws, what, begun)[:, 0])
        assert np.mean(met & short) > 0.05, place  # those that pass the peak
        np.testing.assert_allclose(value[met], exact[met, place], rtol=within, err_msg=str(place))


def test_what_lanes_are_not_made_for_is_the_scalar_kernels() -> None:
    """Past the peak, laws by trend lines, and breakaways: not a bit is another one."""
    laggings = [lagging("softening", SOFTENING), lagging("pieces", PIECEWISE), SHIPPED[0]]
    table: dict[str, Any] = {**designs(300, 33), "lagging": np.arange(300) % 3}
    table["entry_tension"] = table["entry_tension"] * 0.35
    table["exit_tension"] = table["entry_tension"] / np.linspace(2.0, 300.0, 300)
    arcs = arcs_of_table(table, laggings)
    _, done, _ = both_ways(arcs)
    assert set(arcs.law[~done]) == {0, 1, 2}
    assert 0 in arcs.law[done]
    batch = engineering.LaneBatch(arcs)
    batch.find(row.TENSIONS)
    exact = precise.solve_precisely(arcs, row.TENSIONS, batch.starts)
    found = solve_arcs(arcs, setting=Setting.PRECISE, capacities=False).found
    np.testing.assert_array_equal(found[~done], exact[~done])


def logarithms(x: Any, out: Any) -> None:
    """Compiled for the test below."""
    for i in range(len(x)):
        out[i] = full_ln(x[i])


def exponentials(x: Any, out: Any) -> None:
    """Compiled for the test below."""
    for i in range(len(x)):
        out[i] = full_ex(x[i])


def test_logarithms_and_exponentials_are_full() -> None:
    rng = np.random.default_rng(34)
    x = np.exp(rng.uniform(-200.0, 200.0, 100_000))
    x[:50_000] = np.exp(rng.uniform(-1.0, 1.0, 50_000))
    out = np.empty_like(x)
    compiled(logarithms)(x, out)
    np.testing.assert_allclose(out, np.log(x), rtol=4e-16, atol=4e-16)
    x = np.concatenate([rng.uniform(-600.0, 600.0, 50_000), rng.uniform(-1.0, 1.0, 50_000)])
    compiled(exponentials)(x, out)
    np.testing.assert_allclose(out, np.exp(x), rtol=1e-15)
