"""The precise setting: the kernel's numbers, from where the engineering setting leaves off."""

from __future__ import annotations

import numpy as np

from wraparc.batch import row
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.engineering import LaneBatch
from wraparc.batch.native import available, pays
from wraparc.batch.precise import FEW, solve_precisely
from wraparc.batch.sixth import solve_in_sixth


def solve_from_lanes(arcs: Arcs, parts: int = row.EVERYTHING) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of the precise setting.

    The kernel's march in the lanes does the operating points that it is made for. The rest is left
    to the scalar kernel, which begins with what the engineering setting has found.

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted.
    """
    batch = LaneBatch(arcs)
    batch.find(parts)
    if not (available() and pays(len(arcs), FEW) and parts & row.TENSIONS):
        return solve_precisely(arcs, parts, batch.starts)
    found = np.empty((len(arcs), row.FOUND_NUMBERS))
    done = solve_in_sixth(arcs, batch.laws, batch.starts, found)
    left = np.where(done, parts & ~row.TENSIONS, parts)
    which = np.flatnonzero(left)
    if len(which):
        rest = solve_precisely(arcs.rows(which), left[which], batch.starts[which])
        places = row.PLACES[row.TENSIONS]
        rest[np.ix_(done[which], places)] = found[np.ix_(which[done[which]], places)]
        found[which] = rest
    return found
