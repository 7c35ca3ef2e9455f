"""The precise setting: the kernel's numbers, from where the engineering setting leaves off."""

from __future__ import annotations

import numpy as np

from wraparc.arc.kernel import answer
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.engineering import BEGUN_PLACES, LaneBatch
from wraparc.batch.lane_kernel import CREEP, LEAST, SLIP, TENSIONS
from wraparc.batch.native import available, pays
from wraparc.batch.precise import FEW, solve_precisely
from wraparc.batch.sixth import carry_in_sixth, solve_in_sixth

BESIDE = 0.02  # of ln tension, from pull to pull, and as `arc.kernel.least_slack` has it


def solve_from_lanes(arcs: Arcs, parts: int = row.EVERYTHING, of: int | None = None) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of the precise setting.

    The kernel's march in the lanes does what it is made for. The rest is left to the scalar kernel,
    which begins with what the engineering setting has found.

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted.
    of
        Arcs of the whole batch, if these are a chunk of it: few are left to the interpreter, but
        not the last few of many.
    """
    batch = LaneBatch(arcs)
    batch.find(parts, to_begin=True)
    if not (available() and pays(len(arcs) if of is None else of, FEW) and parts & row.TENSIONS):
        return solve_precisely(arcs, parts, batch.starts)
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    left = np.full(len(arcs), parts)
    done = solve_in_sixth(arcs, batch.laws, batch.begun[TENSIONS], found)
    left[done] &= ~row.TENSIONS
    if parts & answer.CAPACITIES:
        carry(batch, found, left)
    which = np.flatnonzero(left)
    if len(which):
        rest = solve_precisely(arcs.rows(which), left[which], batch.starts[which])
        for part, places in row.PLACES.items():
            these = (left[which] & part) > 0
            found[np.ix_(which[these], places)] = rest[np.ix_(these, places)]
    batch.cap_by_gross(found)
    return found


def carry(batch: LaneBatch, found: Array, left: Integers) -> None:
    """Find capacities in the lanes, and take them from what is left."""
    arcs, laws = batch.arcs, batch.laws
    for what, part, place in (
        (CREEP, answer.CREEP_LIMIT, row.CREEP_CAPACITY),
        (SLIP, answer.TESTED_SLIP, row.SLIP_CAPACITY),
        (LEAST, answer.LEAST, row.LEAST_SLACK),
    ):
        if what not in batch.begun:
            continue
        carried = carry_in_sixth(arcs, laws, what, batch.begun[what])
        past = np.flatnonzero(batch.softens & np.isnan(carried[:, 0]))
        if len(past):
            begun = batch.begun[what][past]
            carried[past] = carry_in_sixth(arcs.rows(past), laws, what, begun, cut=True)
        value, plateau = carried[:, 0], carried[:, 1]
        if what == LEAST:
            value = np.where(value <= batch.top, value - batch.pull, np.nan)
            left[batch.fit & ~batch.asks_pull] &= ~part
        met = np.isfinite(value)
        found[met, place] = value[met]
        left[met] &= ~part
        flat = np.isfinite(plateau) & ~batch.softens
        found[flat, row.GROSS_CAPACITY], found[flat, row.GROSS_CREEP] = plateau[flat], np.inf
        left[flat] &= ~answer.GROSS_SLIP
    find_most(batch, found, left)


def find_most(batch: LaneBatch, found: Array, left: Integers) -> None:
    """Find largest pulls where no tension carries what is asked, of laws flat past their peak.

    At the top of the parabola through three pulls near to where the engineering setting finds the
    largest, twice; at the highest tension, if it is there.
    """
    asked = batch.fit & batch.asks_pull & ~batch.softens & (left & answer.LEAST > 0)
    which = np.flatnonzero(asked)
    near = batch.search_most(which)
    none = near.good & np.isfinite(near.most)
    which, at, high = which[none], near.top[none], np.log(batch.top[which[none]])

    def pulls(*log_tensions: Array) -> Array:
        """Pulls at the creep limit, all at once; a row for each of the tensions."""
        rows, tension = np.tile(which, len(log_tensions)), np.exp(np.concatenate(log_tensions))
        limit = batch.of("creep_limit")[rows]
        out, good = batch.solve(rows, batch.rows(rows, limit, tension), CREEP)
        begun = np.where(good[:, None], out[:, BEGUN_PLACES], np.nan)
        carried = carry_in_sixth(batch.arcs.rows(rows), batch.laws, CREEP, begun)
        return (-tension * np.expm1(-carried[:, 0])).reshape(len(log_tensions), -1)

    middle, good = at, np.ones(len(which), dtype=bool)
    for _ in range(2 if len(which) else 0):
        # the three keep to below the highest tension, on whichever side of them the top is
        centre = np.minimum(middle, high - BESIDE)
        before, here, after = pulls(centre - BESIDE, centre, centre + BESIDE)
        bend = before - 2.0 * here + after
        move = 0.5 * (before - after) / bend
        ends = (centre >= high - BESIDE) & (here <= after)  # as the scalar kernel decides
        good &= ends | ((bend < 0.0) & (np.abs(move) < 2.0))
        middle = np.where(ends, high, np.minimum(centre + np.where(good, move, 0.0) * BESIDE, high))
    (most,) = pulls(middle)
    good &= most < batch.pull[which]
    found[which[good], row.MOST_PULL] = most[good]
    left[which[good]] &= ~answer.LEAST
