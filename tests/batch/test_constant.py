"""Closed forms of constant friction against the solver of single arcs.

Expected values: `wraparc.batch.precise.solve_precisely`, which keeps 1e-7 of the creep; the slip
arc of a stiff lagging from its closed form, T_j = T1/(1 + mu l/R), theta_s = ln(T_j/T2)/mu.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from batch.batches import designs, lagging
from wraparc.arc.capacity import CAPACITIES
from wraparc.arc.quantities import BREAKAWAY, SOLVED
from wraparc.arrays import Array
from wraparc.batch import constant, precise, row
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.friction import Constant, PressurePower

LAGGINGS = [
    lagging("weak", Constant(friction_coefficient=0.3)),
    lagging("strong", Constant(friction_coefficient=0.6)),
    lagging("power", PressurePower(friction_coefficient=0.5, reference_pressure=2e5, exponent=0.3)),
]


def wide(n: int, seed: int) -> Arcs:
    """Driving, one in ten braking; also without overrun, and beyond what friction carries."""
    rng = np.random.default_rng(seed)
    table: dict[str, Any] = dict(designs(n, seed))
    table["exit_tension"] = table["entry_tension"] / np.exp(rng.uniform(0.01, 2.2, n))
    brakes = rng.random(n) < 0.1
    t1, t2 = table["entry_tension"], table["exit_tension"]
    table["entry_tension"] = np.where(brakes, t2, t1)
    table["exit_tension"] = np.where(brakes, t1, t2)
    table["belt_modulus"] = np.exp(rng.uniform(np.log(2e6), np.log(2e8), n))
    table["overrun"] = np.where(rng.random(n) < 0.5, 0.0, np.nan)
    table["lagging"] = rng.integers(0, 3, n)
    return arcs_of_table(table, LAGGINGS)


def test_numbers_are_those_of_single_arcs() -> None:
    arcs = wide(600, 51)
    found: Array = np.full((600, row.FOUND_NUMBERS), np.nan)
    done = constant.solve_constant(arcs, np.ones(600, dtype=bool), found)
    exact = precise.solve_precisely(arcs, row.TENSIONS)
    fit = (arcs.law < 2) & (arcs.entry_tension > arcs.exit_tension)
    assert not done[~fit].any()
    for outcome, share in ((SOLVED, 0.7), (BREAKAWAY, 0.9)):
        assert np.mean(done[fit & (exact[:, row.OUTCOME] == outcome)]) > share
    within = {row.ACTIVE: 1e-5, row.STEEPEST_SLIP: 1e-3}  # at the points of its mesh
    for place in row.PLACES[row.TENSIONS]:
        np.testing.assert_allclose(
            found[done, place], exact[done, place],
            rtol=within.get(place, 1e-7), atol=1e-9, err_msg=str(place),
        )  # fmt: skip


def test_a_stiff_lagging_slips_over_the_classical_arc() -> None:
    arcs = wide(600, 52)
    arcs.overrun[:] = 0.0
    arcs.shear_modulus[:] = 2e9
    found: Array = np.full((600, row.FOUND_NUMBERS), np.nan)
    done = constant.solve_constant(arcs, np.ones(600, dtype=bool), found)
    mu, radius = constant.constant_friction(arcs.laws)[arcs.law], 0.5 * arcs.diameter
    lag = np.sqrt(arcs.shear_compliance / (arcs.belt_width * arcs.compliance))
    junction = arcs.entry_tension / (1.0 + mu * lag / radius)
    expected = arcs.wrap_angle - np.log(junction / arcs.exit_tension) / mu
    sticks = done & (found[:, row.STUCK_LENGTH] > 25.0 * lag)
    assert np.count_nonzero(sticks) > 50
    np.testing.assert_allclose((found[:, row.STUCK_LENGTH] / radius)[sticks], expected[sticks])


def test_what_rows_have_found_is_kept() -> None:
    """Capacities are found by rows before an arc on the verge of gross slip is left to these."""
    arcs = wide(200, 53)
    found: Array = np.full((200, row.FOUND_NUMBERS), 7.0)
    constant.solve_constant(arcs, np.ones(200, dtype=bool), found)
    others = [place for part, places in row.PLACES.items() if part & CAPACITIES for place in places]
    assert (found[:, others] == 7.0).all()
