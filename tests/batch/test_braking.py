"""Braking pulleys of a batch: the kick used up, then the march in tension.

Expected values: the scalar kernel, which marches in position on another mesh; and the same march in
the interpreter.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from batch.batches import designs
from wraparc.arc.kernel.quantities import SOLVED
from wraparc.batch import engineering, precise, row, sixth_braking, solve_arcs
from wraparc.batch.arcs import Arcs, Array, arcs_of_table
from wraparc.batch.sixth_braking import Flags, brake_rows
from wraparc.drive import Lagging
from wraparc.files import load_lagging

SHIPPED = [load_lagging(name) for name in ("diamond-rubber", "medium-ceramic", "full-ceramic")]


def braking(n: int, seed: int, lag: Lagging) -> Arcs:
    """Soft and stiff belts, some without a kick, one in twenty beyond what friction carries."""
    rng = np.random.default_rng(seed)
    table: dict[str, Any] = dict(designs(n, seed))
    table["exit_tension"], table["entry_tension"] = table["entry_tension"], table["exit_tension"]
    table["entry_tension"] = np.where(rng.random(n) < 0.05, 1e2, table["entry_tension"])
    table["belt_modulus"] = np.exp(rng.uniform(np.log(4e6), np.log(2e8), n))
    table["overrun"] = np.where(rng.random(n) < 0.3, 0.0, np.nan)
    return arcs_of_table(table, lag)


def solved(arcs: Arcs) -> tuple[Array, Flags]:
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    laws = engineering.LaneBatch(arcs).laws
    return found, brake_rows(arcs, laws, np.ones(len(arcs), dtype=bool), found)


@pytest.mark.parametrize("lag", SHIPPED, ids=lambda lag: lag.name)
def test_numbers_are_those_of_the_scalar_kernel(lag: Lagging) -> None:
    arcs = braking(300, 41, lag)
    found, done = solved(arcs)
    exact = precise.solve_precisely(arcs, row.TENSIONS)
    assert np.mean(done[exact[:, row.OUTCOME] == SOLVED]) > 0.8
    assert not done[exact[:, row.OUTCOME] != SOLVED].any()
    within = {row.ACTIVE: 1e-3, row.PEAK_AT: 1e-3, row.CREEP_RATIO: 1e-4}
    for place in set(row.PLACES[row.TENSIONS]) - {row.STEEPEST_SLIP}:
        np.testing.assert_allclose(
            found[done, place], exact[done, place],
            rtol=within.get(place, 2e-5), atol=1e-9, err_msg=str(place),
        )  # fmt: skip


@pytest.mark.parametrize("lag", SHIPPED, ids=lambda lag: lag.name)
def test_few_rows_are_interpreted_to_the_same_numbers(
    lag: Lagging, monkeypatch: pytest.MonkeyPatch
) -> None:
    arcs = braking(40, 42, lag)
    found, done = solved(arcs)
    monkeypatch.setattr(sixth_braking, "available", lambda: False)
    few, done_few = solved(arcs)
    np.testing.assert_array_equal(done, done_few)
    places = sorted(set(row.PLACES[row.TENSIONS]) - {row.STEEPEST_SLIP})
    np.testing.assert_allclose(found[:, places], few[:, places], rtol=1e-9, atol=1e-12)


def test_an_unsure_slip_speed_is_left_to_the_scalar_kernel() -> None:
    """So slow that the bound of the lanes does not tell that slip is faster than in the tests."""
    arcs = braking(40, 43, SHIPPED[0])
    arcs.laws.tested_speed[:] = 1e-3
    for speed, expected in ((5.0, True), (1e-3, False)):
        arcs.belt_speed[:] = speed
        _, done = solved(arcs)
        assert done.any() == expected


def test_no_cut_changes_a_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sixth_braking, "pays", lambda *_: True)
    monkeypatch.setattr(precise, "pays", lambda *_: True)
    arcs = braking(150, 44, SHIPPED[2])
    whole = solve_arcs(arcs, capacities=False).found
    order = np.random.default_rng(45).permutation(150)[:37]
    np.testing.assert_array_equal(
        whole[order], solve_arcs(arcs.rows(order), capacities=False).found
    )
    alone = solve_arcs(arcs.rows(slice(3, 4)), capacities=False).found
    np.testing.assert_array_equal(whole[3:4], alone)
