"""The kernel's march in the lanes for the precise setting: operating points and capacities.

Searches begin with what the engineering setting has found and end as near as those of the scalar
kernel do, on its mesh; :mod:`wraparc.batch.sixth_read` reads the profile of an operating point.
"""

from __future__ import annotations

from math import exp
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.effort import is_far, mesh_steps
from wraparc.arc.kernel.gross_slip import plateau_capacity
from wraparc.arc.kernel.quantities import RECORD, Buffer, parameters_at, zeros
from wraparc.arc.kernel.search import LARGEST_LOG, TOLERANCE
from wraparc.arc.kernel.tension_table import FIRST
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.elementwise import LANES, Lanes, Table, lanes, memory
from wraparc.batch.lane_cut import CUT_NODES, march_cut
from wraparc.batch.lane_kernel import LEAST, SLIP
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_march import Falls
from wraparc.batch.lane_sixth import (
    MOST_SIXTH,
    SIXTH_TRACE,
    land,
    lay_steps,
    march,
)
from wraparc.batch.lane_slots import (
    END,
    END_AT,
    GOAL,
    LENGTH,
    LIMIT,
    LOG_TENSION,
    MISS,
    MISS_2,
    PULL,
    SLOTS,
    STEEPEST,
    STOP,
    G,
)
from wraparc.batch.laws import law_of
from wraparc.batch.native import compiled
from wraparc.batch.precise import POINTS, STEPS
from wraparc.batch.row import FOUND_NUMBERS, geometry_of, load_of
from wraparc.batch.sixth_begin import set_out, set_tension, sort_by_size, take
from wraparc.batch.sixth_read import tell
from wraparc.batch.sixth_search import correct, correct_both, miss_arc, miss_cut, miss_goal
from wraparc.friction.compact import KNOTS, CompactLaw

Flags = NDArray[np.bool_]

ROUNDS = 9  # of a search: 3 or 4 are usual, of two unknowns 5 or 6
NODES = CUT_NODES
TRACES = SIXTH_TRACE * (MOST_SIXTH + 1)
BEYOND, BEYOND_LOG = 1.02, 0.02  # what has been found, that a mesh is laid to


def solve_in_sixth(arcs: Arcs, laws: LaneLaws, begun: Array, found: Array) -> Flags:
    """Solve operating points from what has been found of them (`BEGUN`) into rows of results.

    Returns which of them are solved: driving arcs by knots whose slip grows all along, and stays
    short of the peak.
    """
    done = np.zeros(len(arcs), dtype=bool)
    which = np.flatnonzero(np.isfinite(begun[:, 0]) & (arcs.laws.kind[arcs.law] == KNOTS))
    if not len(which):
        return done
    buffer = np.zeros(RECORD * (2 * POINTS + MOST_SIXTH))
    out, solved = np.empty((len(which), FOUND_NUMBERS)), np.zeros(len(which), dtype=bool)
    given = given_of(arcs.rows(which), laws, begun[which])
    compiled(tension_rows, contract=True)(*given, (STEPS, POINTS), buffer, out, solved)
    done[which] = solved
    found[which[solved]] = out[solved]
    return done


def carry_in_sixth(
    arcs: Arcs, laws: LaneLaws, what: int, begun: Array, *, cut: bool = False
) -> Array:
    """ln(T1/T2) carried at the creep limit (CREEP) or at the largest tested slip (SLIP).

    With LEAST the entry tension at which the pull is carried at the creep limit [N]. From what has
    been found of it, shape (n,); nan where the lanes do not find it. The second column is the
    largest ln(T1/T2) with the friction of the plateau all along. With `cut` also past the peak of
    friction.
    """
    out = np.full((len(arcs), 2), np.nan)
    which = np.flatnonzero(np.isfinite(begun[:, 0]) & (arcs.laws.kind[arcs.law] == KNOTS))
    if len(which):
        found = np.full((len(which), 2), np.nan)
        given = given_of(arcs.rows(which), laws, begun[which])
        entry = compiled(cut_rows if cut else carried_rows, contract=True)
        entry(*given, STEPS, what, found)
        out[which] = found
    return out


def given_of(arcs: Arcs, laws: LaneLaws, begun: Array) -> tuple[Any, ...]:
    """What all entries begin with."""
    rows = laws.row[arcs.law].astype(float)
    scratch = (np.zeros(k * LANES) for k in (SLOTS, NODES, TRACES))
    return (
        arcs.inputs(), arcs.laws.arrays, arcs.law, laws.numbers, rows, begun, *scratch,
        np.zeros(FIRST + 1),
    )  # fmt: skip


def tension_rows(
    given: Any,
    bank: Any,
    which: Any,
    laws_: Any,
    rows: Any,
    begun: Any,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    table_: Any,
    mesh: Any,
    out_: Any,
    found: Any,
    done: Any,
) -> None:
    """Find operating points into rows of results; compiled only.

    `rows` are the places of the laws in the table `laws_`; `done` says which were found: the others
    are for the scalar kernel.
    """
    w, nodes, trace = memory(w_, "w"), memory(nodes_, "nodes"), memory(trace_, "trace")
    laws, table, out = memory(laws_, "tables"), memory(table_, "table"), memory(out_, "out")
    n, count, points = lanes(), len(rows), mesh[1]
    fine, order = zeros(count), zeros(count)
    sort_by_size(given, bank, which, begun, mesh[0], fine, order)
    for first in range(0, count, n):
        for i in range(n):
            j = int(order[min(first + i, count - 1)])
            law = law_of(bank, which[j])
            take(law, given[j], fine[j], rows[j], begun[j], w, i, table)
        steps = lay_steps(w, laws, nodes)
        for _ in range(ROUNDS):
            for i in range(n):
                j = int(order[min(first + i, count - 1)])
                set_out(law_of(bank, which[j]), given[j], nodes, w, i, table)
            march(w, nodes, trace, steps)
            miss_arc(w)
            if not correct(w):
                break
        for i in range(min(n, count - first)):
            j = int(order[first + i])
            law = law_of(bank, which[j])
            done[j] = tell(law, given[j], w, nodes, trace, i, points, table, out, found[j])


def carried_rows(
    given: Any,
    bank: Any,
    which: Any,
    laws_: Any,
    rows: Any,
    begun: Any,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    table_: Any,
    mesh: int,
    what: int,
    found: Any,
) -> None:
    """Find capacities, see `carry_in_sixth`; compiled only."""
    w, nodes, trace = memory(w_, "w"), memory(nodes_, "nodes"), memory(trace_, "trace")
    laws, table = memory(laws_, "tables"), memory(table_, "table")
    carry_rows(
        given, bank, which, laws, rows, begun, w, nodes, trace, table, mesh, what, None, found
    )


def cut_rows(
    given: Any,
    bank: Any,
    which: Any,
    laws_: Any,
    rows: Any,
    begun: Any,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    table_: Any,
    mesh: int,
    what: int,
    found: Any,
) -> None:
    """The same past the peak of friction. An entry of its own, as few laws ask for it."""
    w, nodes, trace = memory(w_, "w"), memory(nodes_, "nodes"), memory(trace_, "trace")
    laws, table = memory(laws_, "tables"), memory(table_, "table")
    carry_rows(
        given, bank, which, laws, rows, begun, w, nodes, trace, table, mesh, what, 1.0, found
    )


def carry_rows(
    given: Any,
    bank: Any,
    which: Any,
    laws: Table,
    rows: Any,
    begun: Any,
    w: Lanes,
    nodes: Lanes,
    trace: Lanes,
    table: Any,
    mesh: int,
    what: int,
    cut: Falls,
    found: Any,
) -> None:
    """Both; `cut` is None where steps are not cut."""
    n, count = lanes(), len(rows)
    fine, order = zeros(count), zeros(count)
    sort_by_size(given, bank, which, begun, mesh, fine, order)
    for first in range(0, count, n):
        for i in range(n):
            j = int(order[min(first + i, count - 1)])
            take(law_of(bank, which[j]), given[j], fine[j], rows[j], begun[j], w, i, table)
            aim(given[j], begun[j], what, w, i)
        steps = lay_steps(w, laws, nodes)
        for tries in range(ROUNDS):
            for i in range(n):
                j = int(order[min(first + i, count - 1)])
                set_out(law_of(bank, which[j]), given[j], nodes, w, i, table)
            march_to_exit(w, laws, nodes, trace, steps, 1.0 if what == SLIP else 0.0, cut)
            if what != LEAST:
                if not correct(w):
                    break
            elif correct_both(w, tries):
                for i in range(n):
                    j = int(order[min(first + i, count - 1)])
                    set_tension(law_of(bank, which[j]), given[j], w, i, table)
                steps = lay_steps(w, laws, nodes)
            else:
                break
        for i in range(min(n, count - first)):
            j = int(order[first + i])
            accept(law_of(bank, which[j]), given[j], fine[j], mesh, what, w, i, found[j])


def march_to_exit(
    w: Lanes, laws: Table, nodes: Lanes, trace: Lanes, steps: int, of_slip: float, cut: Falls
) -> None:
    """A try of every lane, and what it misses."""
    if cut is None:
        march(w, nodes, trace, steps)
        land(w, laws, nodes, trace)
        miss_goal(w, nodes, of_slip)
    else:
        march_cut(w, laws, nodes)
        miss_cut(w, of_slip)


def aim(given: Buffer, begun: Buffer, what: int, w: Lanes, i: int) -> None:
    """What a lane is to meet at the exit nip, on a mesh that does not end before it."""
    load = load_of(given)
    w[END, i], w[LIMIT, i] = LARGEST_LOG, w[LENGTH, i]
    w[STOP, i] = min(BEYOND * begun[3] + BEYOND_LOG, LARGEST_LOG)
    w[GOAL, i] = load.slip_max if what == SLIP else load.creep_limit
    w[PULL, i] = load.entry_tension - load.exit_tension


def accept(
    law: CompactLaw,
    given: Buffer,
    fine: float,
    mesh: int,
    what: int,
    w: Lanes,
    i: int,
    found: Buffer,
) -> None:
    """Write what a lane has found, if it has and was fit to."""
    tension = exp(w[LOG_TENSION, i])
    par = parameters_at(tension, geometry_of(given))
    met = abs(w[MISS, i]) <= TOLERANCE
    if what == LEAST:
        met = max(abs(w[MISS, i]), abs(w[MISS_2, i])) <= 10.0 * TOLERANCE
        met = met and fine == mesh_steps(law, par, mesh)
    else:
        found[1] = plateau_capacity(law, par.entry_pressure, par.length / par.radius)
    if met and w[STEEPEST, i] <= 1.0 and w[G, i] >= 0.0 and not is_far(law, par):
        found[0] = tension if what == LEAST else w[END_AT, i]
