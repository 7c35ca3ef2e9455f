"""The precise setting: the kernel's numbers, from where the engineering setting leaves off."""

from __future__ import annotations

import numpy as np

from wraparc.arc.kernel import answer
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.engineering import LaneBatch
from wraparc.batch.lane_kernel import CREEP, LEAST, SLIP, TENSIONS
from wraparc.batch.native import available, pays
from wraparc.batch.precise import FEW, solve_precisely
from wraparc.batch.sixth import carry_in_sixth, solve_in_sixth


def solve_from_lanes(arcs: Arcs, parts: int = row.EVERYTHING) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of the precise setting.

    The kernel's march in the lanes does what it is made for. The rest is left to the scalar kernel,
    which begins with what the engineering setting has found.

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted.
    """
    batch = LaneBatch(arcs)
    batch.find(parts, to_begin=True)
    if not (available() and pays(len(arcs), FEW) and parts & row.TENSIONS):
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
