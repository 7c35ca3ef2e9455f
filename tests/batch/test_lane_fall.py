"""Laws that fall past their peak, in the lanes.

Expected values: `wraparc.friction.compact`, which the scalar kernel reads, for the law at one slip
and pressure, and central differences for slopes; the precise setting for capacities.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from arc.drives import PIECEWISE, SOFTENING, integral_log
from batch.batches import designs, lagging
from wraparc.batch import BatchResult, Setting, engineering, solve_batch
from wraparc.batch.arcs import arcs_of_table
from wraparc.batch.elementwise import Lanes
from wraparc.batch.lane_fall import friction_of, lay_tail, rates_of
from wraparc.batch.lane_kernel import NODES
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_look import look_up, read_head
from wraparc.batch.lane_march import lay_node
from wraparc.batch.lane_slots import (
    END,
    FRICTION_AT,
    P1,
    PASS_HIGH,
    PASS_LOW,
    PRESSURE,
    Q0,
    RADIUS,
    ROW,
    SHEAR,
    SLIP_AT,
    SLOTS,
)
from wraparc.batch.laws import LawBank
from wraparc.drive import Lagging
from wraparc.files import load_lagging
from wraparc.friction import CoefficientPieces, FrictionLaw, Piece, Trend
from wraparc.friction.compact import branch_of, friction_at, segment_of

Array = NDArray[np.float64]

FALLING_PIECES = replace(
    PIECEWISE,
    coefficients=CoefficientPieces(
        pressure=(40e3, 600e3),
        pieces=(
            Piece(
                a=Trend(coefficients=(-47.25, 2.5e-5)),
                b=Trend(coefficients=(135.9, -6e-5)),
                post_peak_slope=Trend(coefficients=(-9.0, 8e-6)),
                residual_friction=Trend(coefficients=(0.7, -4e-7)),
            ),
        ),
        continuity=0.01,
    ),
)
FALLING: dict[str, FrictionLaw] = {
    "knots": SOFTENING,
    "pieces": FALLING_PIECES,
    "free of pressure": integral_log(slope=-20.0, residual=0.55),
    "full ceramic": load_lagging("full-ceramic").law,
}


def node_of(law: FrictionLaw, pressure: Array) -> tuple[Lanes, Lanes]:
    """Slots and one node of the lane kernel at pressures within the range of a law."""
    table = LaneLaws.of(LawBank.of([law]))
    w, nodes = Lanes(SLOTS), Lanes(NODES)
    one = np.ones_like(pressure)
    w[PRESSURE, 0] = w[P1, 0] = pressure
    given = {ROW: 0.0, RADIUS: 0.5, SHEAR: 5e-9, Q0: 0.0, END: 1.0, PASS_HIGH: -1.0, PASS_LOW: 1e9}
    for slot, value in given.items():
        w[slot, 0] = value * one
    read_head(w, table.numbers)
    look_up(w, table.numbers)
    lay_node(w, 0, 1.0, nodes)
    lay_tail(w, 0, nodes)
    return w, nodes


@pytest.mark.parametrize("name", FALLING)
def test_friction_past_the_peak_is_that_of_the_scalar_kernel(name: str) -> None:
    law, rng = FALLING[name], np.random.default_rng(4)
    compact = law.compact()
    pressure = np.exp(rng.uniform(np.log(45e3), np.log(590e3), 400))
    w, nodes = node_of(law, pressure)
    r = rng.uniform(0.05, 4.0, 400)
    slip = r * w[SLIP_AT, 0]
    log_r = np.minimum(np.log(r), 0.0)
    numbers = [nodes[k, 0] for k in (4, 5, 9, 10, 11, 12)]
    form, form_r, traction, _ = friction_of(r, log_r, *numbers)
    peak = w[FRICTION_AT, 0]
    branches = set()
    for i, (x, p) in enumerate(zip(slip.tolist(), pressure.tolist(), strict=True)):
        segment = segment_of(compact, p)
        branch = branch_of(compact, segment, x, p)
        branches.add(branch)
        mu, mu_x, mu_p = friction_at(compact, segment, branch, x, p)
        assert peak[i] * form[i] == pytest.approx(mu, rel=2e-6)
        assert peak[i] * form_r[i] / w[SLIP_AT, 0][i] == pytest.approx(mu_x, rel=1e-4, abs=1e-9)
        # sampling trend lines costs the slope by pressure some digits
        assert traction[i] == pytest.approx(mu + p * mu_p, rel=1e-3, abs=1e-4)
    assert branches == {0, 1, 2}


def test_rates_by_slip_are_their_differences() -> None:
    rng = np.random.default_rng(5)
    _, nodes = node_of(SOFTENING, np.exp(rng.uniform(np.log(45e3), np.log(250e3), 300)))
    numbers = [nodes[k, 0] for k in (4, 5, 9, 10, 11, 12)]
    weight, bend, steep = nodes[1, 0], nodes[3, 0], nodes[6, 0]

    def rates(r: Array) -> tuple[Array, ...]:
        log_r = np.minimum(np.log(r), 0.0)
        rise = np.where(r < 1.0, 1.0 - log_r, 0.0)
        return rates_of(*friction_of(r, log_r, *numbers), 0.004, weight, bend, steep, rise)

    r = rng.uniform(0.05, 4.0, 300)
    form_r = friction_of(r, np.minimum(np.log(r), 0.0), *numbers)[1]
    before, after = (friction_of(q, np.minimum(np.log(q), 0.0), *numbers)[1]
                     for q in (r - 1e-6, r + 1e-6))  # fmt: skip
    smooth = np.abs(before - after) < 1e-3 + 1e-4 * np.abs(form_r)  # no kink in between
    assert smooth.mean() > 0.95
    up, down, here = rates(r + 1e-6), rates(r - 1e-6), rates(r)
    for k in (0, 1):
        slope = (up[k] - down[k])[smooth] / 2e-6
        np.testing.assert_allclose(here[2 + k][smooth], slope, rtol=1e-5, atol=1e-7)


@pytest.mark.parametrize("name", ["knots", "pieces", "full ceramic"])
def test_capacities_are_those_of_the_precise_setting(name: str) -> None:
    """And the lanes find them all: nothing but a few tensions is left to the scalar kernel."""
    lag = lagging(name, FALLING[name])
    table = designs(120, 31)
    arcs = arcs_of_table(table, lag)
    batch = engineering.LaneBatch(arcs)
    found, left = engineering.solve_in_lanes(arcs)
    assert left.mean() < 0.05
    assert batch.softens.all()
    near, exact = BatchResult(arcs, found), solve_batch(table, lag, setting=Setting.PRECISE)
    np.testing.assert_array_equal(near["status"], exact["status"])
    for column, within in {
        "creep_limit_capacity": 1e-3,
        "tested_slip_capacity": 1e-3,
        "gross_slip_capacity": 5e-4,
        "gross_slip_creep": 5e-2,  # the place of a flat maximum
        "least_exit_tension": 1e-3,
        "largest_effective_tension": 1e-4,
    }.items():
        np.testing.assert_allclose(near[column], exact[column], rtol=within, err_msg=column)


def test_a_law_that_falls_does_not_change_one_that_does_not() -> None:
    """Rows of both kinds in one batch, to the last bit what they are alone."""
    laggings: list[Lagging] = [load_lagging("diamond-rubber"), load_lagging("full-ceramic")]
    table = designs(64, 32)
    mixed = solve_batch({**table, "lagging": np.arange(64) % 2}, laggings)
    for k, lag in enumerate(laggings):
        alone = solve_batch({name: v[k::2] for name, v in table.items()}, lag)
        np.testing.assert_array_equal(mixed.found[k::2], alone.found)
