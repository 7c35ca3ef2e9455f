"""The precise setting: the scalar kernel for every arc, compiled where numba is there."""

from __future__ import annotations

from typing import Any

import numpy as np

from wraparc.study.arcs import Arcs, Array, Integers
from wraparc.study.batch.elementwise import memory
from wraparc.study.batch.native import available, compiled
from wraparc.study.batch.row import EVERYTHING, FOUND_NUMBERS, solve_row

STEPS, POINTS = 24, 180  # as `wraparc.arc.Distributed` has them


def solve_rows(
    given: Any,
    kinds: Any,
    numbers: Any,
    places: Any,
    which: Any,
    parts: Any,
    steps: int,
    points: int,
    found: Any,
) -> None:
    """Solve rows of arcs, each with its law; compiled only."""
    for i in range(len(given)):
        e, ne, c, nc, s, ns = places[which[i]]
        law = (
            kinds[which[i]],
            memory(numbers[e : e + ne], "edges"),
            memory(numbers[c : c + nc], "coefficients"),
            memory(numbers[s : s + ns], "slips"),
        )
        solve_row(law, given[i], parts[i], steps, points, found[i])


def solve_precisely(arcs: Arcs, parts: int | Integers = EVERYTHING) -> Array:
    """Rows of results (see :mod:`wraparc.study.batch.row`) of every arc, shape (n, 19).

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
    laws = arcs.laws
    if available():
        kernel = compiled(solve_rows)
        kernel(given, laws.kind, laws.numbers, laws.places, arcs.law, wanted, STEPS, POINTS, found)
        return found
    for i in range(n):
        kind, *parts_of_law = laws.compact(int(arcs.law[i]))
        edges, c, slips = (tuple(p.tolist()) for p in parts_of_law)
        row: list[float] = [0.0] * FOUND_NUMBERS
        solve_row((kind, edges, c, slips), given[i].tolist(), int(wanted[i]), STEPS, POINTS, row)
        found[i] = row
    return found
