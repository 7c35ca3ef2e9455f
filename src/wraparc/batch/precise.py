"""The scalar solver for rows of arcs."""

from __future__ import annotations

import numpy as np

from wraparc.arc.capacity import CAPACITIES
from wraparc.arrays import Array, Integers
from wraparc.batch.arcs import Arcs
from wraparc.batch.row import FOUND_NUMBERS, capacities_of_row, tensions_of_row


def solve_precisely(arcs: Arcs, parts: int | Integers) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of every arc, shape (n, 23).

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted, of all arcs or of each.
    """
    given, n = arcs.inputs(), len(arcs)
    wanted = np.broadcast_to(np.asarray(parts, dtype=np.int64), (n,)).tolist()
    found = np.empty((n, FOUND_NUMBERS))
    for i, numbers in enumerate(given.tolist()):
        row, law = [0.0] * FOUND_NUMBERS, arcs.laws.compact(int(arcs.law[i]))
        tensions_of_row(law, numbers, wanted[i], row)
        if wanted[i] & CAPACITIES:
            capacities_of_row(law, numbers, wanted[i], row)
        found[i] = row
    return found
