"""The precise setting: the scalar kernel for every arc, compiled where numba is there."""

from __future__ import annotations

from typing import Any

import numpy as np

from wraparc.arc.kernel.answer import CAPACITIES
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.elementwise import memory
from wraparc.batch.native import available, compiled
from wraparc.batch.row import (
    EVERYTHING,
    FOUND_NUMBERS,
    capacities_of_row,
    tensions_of_row,
)
from wraparc.friction.compact import CompactLaw

STEPS, POINTS = 24, 180  # as `wraparc.arc.Distributed` has them


def tension_rows(
    given: Any, bank: Any, which: Any, parts: Any, mesh: Any, found: Any, records: Any
) -> int:
    """Begin rows of arcs, each with its law, and find operating points; compiled only.

    `mesh` has the mesh steps and the equal parts of the wrap in a profile. The profile of the last
    arc is left in `records` where it fits; its number of records is returned.
    """
    count = 0
    for i in range(len(given)):
        law = law_of(bank, which[i])
        count = tensions_of_row(law, given[i], parts[i], mesh[0], mesh[1], found[i], records)
    return count


def capacity_rows(given: Any, bank: Any, which: Any, parts: Any, steps: int, found: Any) -> None:
    """Find capacities. An entry of its own: what is not asked for need not be compiled."""
    for i in range(len(given)):
        capacities_of_row(law_of(bank, which[i]), given[i], parts[i], steps, found[i])


def law_of(bank: Any, which: int) -> CompactLaw:
    """One law of a bank of (kinds, numbers, places, onsets), in memory that is not counted."""
    kinds, numbers, places, onsets = bank
    e, ne, c, nc, s, ns = places[which]
    return CompactLaw(
        kinds[which],
        memory(numbers[e : e + ne], "edges"),
        memory(numbers[c : c + nc], "coefficients"),
        memory(numbers[s : s + ns], "slips"),
        onsets[which],
    )


def solve_precisely(arcs: Arcs, parts: int | Integers = EVERYTHING) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of every arc, shape (n, 21).

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted, of all arcs or of each.
    """
    given, n = arcs.inputs(), len(arcs)
    wanted = np.broadcast_to(np.asarray(parts, dtype=np.int64), (n,)).copy()
    found = np.empty((n, FOUND_NUMBERS))
    if available():
        bank = arcs.laws.arrays
        mesh = (STEPS, POINTS)
        compiled(tension_rows)(given, bank, arcs.law, wanted, mesh, found, np.empty(0))
        if np.any(wanted & CAPACITIES):
            compiled(capacity_rows)(given, bank, arcs.law, wanted, STEPS, found)
        return found
    for i in range(n):
        law, numbers, part = arcs.laws.compact(int(arcs.law[i])), given[i].tolist(), int(wanted[i])
        row: list[float] = [0.0] * FOUND_NUMBERS
        tensions_of_row(law, numbers, part, STEPS, POINTS, row, [])
        capacities_of_row(law, numbers, part, STEPS, row)
        found[i] = row
    return found
