"""Operating points of braking pulleys in the lanes, as :mod:`wraparc.batch.braking` has them."""

from __future__ import annotations

from math import exp, log, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.answer import LOSS_MISS, loss_miss
from wraparc.arc.kernel.creep_step import slip_at_entry
from wraparc.arc.kernel.quantities import (
    RECORD,
    Buffer,
    parameters_at,
    zeros,
)
from wraparc.arc.kernel.search import tension_shot
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.braking import (
    GUESSED_SLOPE,
    MET,
    ROUNDS,
    brake,
    exit_of,
    guess_of,
    left_of,
    read_both,
    turn_of,
)
from wraparc.batch.elementwise import Lanes, lanes, memory
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_sixth import MOST_SIXTH, lay_steps, march
from wraparc.batch.lane_slots import (
    END,
    ENDED,
    G_AT_FIRST,
    KICK,
    LOG_AT_FIRST,
    MISS,
    Q_AT,
    S_FROM,
    STEEPEST,
    STOP,
    WORK,
    X_AT_FIRST,
    G,
    S,
    X,
    Z,
)
from wraparc.batch.laws import law_of
from wraparc.batch.native import available, compiled, pays
from wraparc.batch.precise import FEW, POINTS, STEPS
from wraparc.batch.row import (
    FOUND_NUMBERS,
    STEEPEST_SLIP,
    geometry_of,
    load_of,
)
from wraparc.batch.sixth import given_of
from wraparc.batch.sixth_begin import BEGUN, leave, put, sort_by_size, take
from wraparc.batch.sixth_read import record_some
from wraparc.batch.sixth_search import correct, miss_arc
from wraparc.friction.compact import KNOTS, CompactLaw

Flags = NDArray[np.bool_]

SURELY = 1.01  # times the slip speed of the tests: above it by more than the accuracy of a batch
FAR_TOO_LONG = 1e30  # arc of a try that comes to no point of no slip [m]


def brake_rows(arcs: Arcs, laws: LaneLaws, which: Flags, found: Array) -> Flags:
    """Solve braking operating points into rows of results; returns which of them are solved.

    Few rows are left to the interpreter, which finds the same numbers to 1e-9.
    """
    done = np.zeros(len(arcs), dtype=bool)
    rows = np.flatnonzero(which & (arcs.laws.kind[arcs.law] == KNOTS) & (laws.row[arcs.law] >= 0))
    if not len(rows):
        return done
    some = arcs.rows(rows)
    out, solved = np.full((len(rows), FOUND_NUMBERS), nan), np.zeros(len(rows), dtype=bool)
    if available() and pays(len(rows), FEW):
        _brake_in_lanes(some, laws, out, solved)
    else:
        for i, given in enumerate(some.inputs().tolist()):
            law, one = some.laws.compact(int(some.law[i])), out[i].tolist()
            solved[i] = brake(law, given, STEPS, POINTS, one)
            out[i] = one
    # where the bound does not tell whether slip is faster than in the tests, the scalar kernel does
    bound, tested = some.belt_speed * out[:, STEEPEST_SLIP], some.laws.tested_speed[some.law]
    solved &= ~(bound <= SURELY * tested)
    done[rows] = solved
    found[rows[solved]] = out[solved]
    return done


def _brake_in_lanes(arcs: Arcs, laws: LaneLaws, out: Array, solved: Flags) -> None:
    begun = np.full((len(arcs), BEGUN), nan)
    begun[:, 3] = np.log(arcs.exit_tension / arcs.entry_tension)
    begun[:, 4] = arcs.entry_tension
    buffer = np.zeros(RECORD * (3 * POINTS + 2 * MOST_SIXTH))
    given = given_of(arcs, laws, begun)
    compiled(braking_rows, contract=True)(*given, (STEPS, POINTS), buffer, out, solved)


def braking_rows(
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
    """Find operating points of braking pulleys into rows of results; compiled only.

    Arguments as of `sixth.tension_rows`.
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
            begin(law, given[j], fine[j], rows[j], begun[j], w, i, table)
        for _ in range(ROUNDS):
            for i in range(n):
                j = int(order[min(first + i, count - 1)])
                turn(law_of(bank, which[j]), given[j], w, i)
            steps = lay_steps(w, laws, nodes)
            for i in range(n):
                j = int(order[min(first + i, count - 1)])
                set_off(law_of(bank, which[j]), given[j], nodes, w, i, table)
            march(w, nodes, trace, steps)
            miss_arc(w)
            if not correct(w):
                break
        for i in range(min(n, count - first)):
            j = int(order[first + i])
            law = law_of(bank, which[j])
            done[j] = tell(law, given[j], w, nodes, trace, i, points, table, out,
                           found[j])  # fmt: skip


def begin(
    law: CompactLaw,
    given: Buffer,
    fine: float,
    row: float,
    begun: Buffer,
    w: Lanes,
    i: int,
    table: Buffer,
) -> None:
    """Fill a lane, with the guess of the scalar kernel."""
    par = parameters_at(begun[4], geometry_of(given))
    g = guess_of(law, par, begun[3])
    begun[0], begun[1], begun[2] = g, g, GUESSED_SLOPE
    take(law, given, fine, row, begun, w, i, table)


def ratio_at(w: Lanes, i: int) -> float:
    """Entry creep ratio towards the slack side of the try of a lane."""
    ratio: float = w[G_AT_FIRST, i] * exp(w[Z, i])
    return ratio


def turn(law: CompactLaw, given: Buffer, w: Lanes, i: int) -> None:
    """Put the arc from the point of no slip on into a lane."""
    load = load_of(given)
    par = parameters_at(load.entry_tension, geometry_of(given))
    there, _ = turn_of(law, par, ratio_at(w, i), zeros(0))
    put(there.par, w, i)
    w[KICK, i] = par.side * there.par.kick
    w[END, i] = w[STOP, i] = par.side * log(there.par.entry_tension / load.exit_tension)
    w[G, i] = there.gamma
    w[S_FROM, i], w[LOG_AT_FIRST, i] = there.s, there.log_tension
    w[ENDED, i] = 0.0 if there.status == 1 else 1.0


def set_off(law: CompactLaw, given: Buffer, nodes: Lanes, w: Lanes, i: int, table: Buffer) -> None:
    """Where the march of a lane begins."""
    load = load_of(given)
    par = parameters_at(load.entry_tension, geometry_of(given))
    w[S, i], w[X, i], w[WORK, i] = 0.0, 0.0, 0.0
    if w[KICK, i] > 0.0:
        w[X, i] = w[X_AT_FIRST, i] = slip_at_entry(law, par, w[KICK, i], 0.0)
        return
    leave(law, left_of(par, w[S_FROM, i], w[LOG_AT_FIRST, i]), nodes, w, i, table)
    if w[ENDED, i] > 0.5:
        w[S, i] = FAR_TOO_LONG


def tell(
    law: CompactLaw,
    given: Buffer,
    w: Lanes,
    nodes: Lanes,
    trace: Lanes,
    i: int,
    points: int,
    table: Buffer,
    out: Buffer,
    found: Buffer,
) -> bool:
    """Write the results of a lane, if it is solved and was fit to be."""
    load = load_of(given)
    par = parameters_at(load.entry_tension, geometry_of(given))
    if not (abs(w[MISS, i]) <= MET and w[STEEPEST, i] <= 1.0 and w[Q_AT, i] >= w[END, i]):
        return False
    gamma = ratio_at(w, i)
    there, before = turn_of(law, par, gamma, out)
    after = tension_shot(law, there.par, there.gamma, w[END, i], w[X, i], w[WORK, i])
    shot = exit_of(par, there, after, gamma)
    if there.status != 1 or not loss_miss(law, par, shot) < 10.0 * LOSS_MISS:
        return False
    rest = out[RECORD * before : len(out)]
    more = record_some(law, there.par, load, there.gamma, w, nodes, trace, i, points, table, rest)
    if more == 0:
        return False
    read_both(law, par, load, there, shot, out, before, more, found)
    return True
