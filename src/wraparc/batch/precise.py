"""The scalar kernel for rows of arcs: compiled where numba is there and the rows are worth it."""

from __future__ import annotations

from typing import Any

import numpy as np

from wraparc.arc.kernel.answer import CAPACITIES
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.laws import law_of
from wraparc.batch.native import available, compiled, pays
from wraparc.batch.row import (
    EVERYTHING,
    FOUND_NUMBERS,
    STARTS,
    capacities_of_row,
    tensions_of_row,
)

STEPS, POINTS = 24, 180  # as `wraparc.arc.Distributed` has them


def tension_rows(
    given: Any,
    bank: Any,
    which: Any,
    parts: Any,
    mesh: Any,
    found: Any,
    records: Any,
    starts: Any,
) -> int:
    """Begin rows of arcs, each with its law, and find operating points; compiled only.

    `mesh` has the mesh steps and the equal parts of the wrap in a profile. The profile of the last
    arc is left in `records` where it fits; its number of records is returned.
    """
    count = 0
    for i in range(len(given)):
        law = law_of(bank, which[i])
        count = tensions_of_row(
            law, given[i], parts[i], mesh[0], mesh[1], found[i], records, starts[i]
        )
    return count


def capacity_rows(
    given: Any, bank: Any, which: Any, parts: Any, steps: int, found: Any, starts: Any
) -> None:
    """Find capacities. An entry of its own: what is not asked for need not be compiled."""
    for i in range(len(given)):
        capacities_of_row(law_of(bank, which[i]), given[i], parts[i], steps, found[i], starts[i])


#: rows of a chunk that are left to the interpreter: one takes 5 ms to 25 ms, with capacities 10 ms
#: to 150 ms; to load the compiled code takes 1 s, to compile it 10 s to 40 s
FEW, FEW_WITH_CAPACITIES = 20, 12


def solve_precisely(
    arcs: Arcs, parts: int | Integers = EVERYTHING, starts: Array | None = None
) -> Array:
    """Rows of results (see :mod:`wraparc.batch.row`) of every arc, shape (n, 21).

    Few rows are left to the interpreter: the same functions, with the same numbers to 1e-12.

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted, of all arcs or of each.
    starts
        Where searches begin, shape (n, 6), see `row.STARTS`; it decides speed only.
    """
    given, n = arcs.inputs(), len(arcs)
    wanted = np.broadcast_to(np.asarray(parts, dtype=np.int64), (n,)).copy()
    found = np.empty((n, FOUND_NUMBERS))
    starts = np.full((n, STARTS), np.nan) if starts is None else starts
    bank, which = arcs.laws.arrays, np.flatnonzero(wanted & CAPACITIES)
    if available() and pays(n, FEW):
        mesh = (STEPS, POINTS)
        compiled(tension_rows)(given, bank, arcs.law, wanted, mesh, found, np.empty(0), starts)
    else:
        _interpret(arcs, given, wanted, found, starts)
    if not len(which):
        return found
    if available() and pays(len(which), FEW_WITH_CAPACITIES):
        compiled(capacity_rows)(given, bank, arcs.law, wanted, STEPS, found, starts)
    else:
        for i in which.tolist():
            row = found[i].tolist()
            law = arcs.laws.compact(int(arcs.law[i]))
            begin = starts[i].tolist()
            capacities_of_row(law, given[i].tolist(), int(wanted[i]), STEPS, row, begin)
            found[i] = row
    return found


def _interpret(arcs: Arcs, given: Array, wanted: Integers, found: Array, starts: Array) -> None:
    """Begin rows and find operating points, in the interpreter."""
    for i in range(len(given)):
        row: list[float] = [0.0] * FOUND_NUMBERS
        law = arcs.laws.compact(int(arcs.law[i]))
        begin = starts[i].tolist()
        tensions_of_row(law, given[i].tolist(), int(wanted[i]), STEPS, POINTS, row, [], begin)
        found[i] = row
