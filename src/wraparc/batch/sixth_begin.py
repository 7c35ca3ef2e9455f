"""How rows come into the lanes of :mod:`wraparc.batch.lane_sixth`, and where a march begins."""

from __future__ import annotations

from math import exp, log, nan
from typing import Any

from wraparc.arc.kernel.effort import mesh_steps
from wraparc.arc.kernel.quantities import SOLVED, Buffer, Parameters, parameters_at, zeros
from wraparc.arc.kernel.tension_march import start_of
from wraparc.arc.kernel.tension_table import FIRST
from wraparc.batch.elementwise import Lanes
from wraparc.batch.lane_sixth import FARTHEST, MOST_SIXTH, SIXTH_STEP
from wraparc.batch.lane_slots import (
    END,
    G_AT_FIRST,
    GRADED_PART,
    KICK,
    LENGTH,
    LIMIT,
    LOG_AT_FIRST,
    LOG_TENSION,
    MISS_LAST,
    P1,
    PLAIN_STEP,
    RADIUS,
    RATIO,
    ROW,
    SHEAR,
    SIDE,
    SLOPE,
    STOP,
    SUM_AT_FIRST,
    WORK,
    X_AT_FIRST,
    Z_LAST,
    G,
    S,
    X,
    Z,
)
from wraparc.batch.laws import law_of
from wraparc.batch.row import geometry_of
from wraparc.friction.compact import CompactLaw

#: numbers of a row that the lanes of the engineering setting have found: g and its derivative by z,
#: the slope by z of what is to be met, ln(T1/T2), and T1 [N]
BEGUN = 5


def sort_by_size(
    given: Any, bank: Any, which: Any, begun: Any, steps: int, fine: Buffer, order: Buffer
) -> None:
    """Fineness of the mesh of every row, and an order of rows by the steps that they take.

    A block takes as many steps as its longest lane.
    """
    places, keys = zeros(MOST_SIXTH + 1), zeros(len(fine))
    for j in range(len(fine)):
        par = parameters_at(begun[j][4], geometry_of(given[j]))
        fine[j] = mesh_steps(law_of(bank, which[j]), par, steps)
        keys[j] = min(fine[j] * (0.75 + begun[j][3] / 1.44), MOST_SIXTH - 1.0)
        places[int(keys[j]) + 1] += 1.0
    for k in range(MOST_SIXTH):
        places[k + 1] += places[k]
    for j in range(len(fine)):
        key = int(keys[j])
        order[int(places[key])] = float(j)
        places[key] += 1.0


def take(
    law: CompactLaw,
    given: Buffer,
    fine: float,
    row: float,
    begun: Buffer,
    w: Lanes,
    i: int,
    table: Buffer,
) -> None:
    """Fill a lane. It marches to the ln(T1/T2) that has been found, if nothing else is said."""
    w[ROW, i] = row
    w[GRADED_PART, i], w[PLAIN_STEP, i] = 1.0 / (0.75 * fine), 1.44 / fine
    w[END, i] = w[STOP, i] = begun[3]
    w[LIMIT, i] = FARTHEST
    w[G, i] = w[G_AT_FIRST, i] = begun[0]
    w[SUM_AT_FIRST, i], w[SLOPE, i] = begun[1], begun[2]
    w[Z, i] = w[Z_LAST, i] = w[MISS_LAST, i] = 0.0
    w[LOG_TENSION, i] = w[LOG_AT_FIRST, i] = log(begun[4])
    set_tension(law, given, w, i, table)


def set_tension(law: CompactLaw, given: Buffer, w: Lanes, i: int, table: Buffer) -> None:
    """What follows from the entry tension of a lane."""
    par = parameters_at(exp(w[LOG_TENSION, i]), geometry_of(given))
    put(par, w, i)
    w[X_AT_FIRST, i] = 0.0
    if par.kick > 0.0:
        begin = start_of(law, par, 0.0, table)
        w[X_AT_FIRST, i] = begin[3]


def put(par: Parameters, w: Lanes, i: int) -> None:
    """Numbers of an arc into a lane."""
    w[SIDE, i], w[RADIUS, i], w[LENGTH, i] = par.side, par.radius, par.length
    w[SHEAR, i], w[P1, i], w[KICK, i] = par.shear, par.entry_pressure, par.kick
    w[RATIO, i] = par.entry_tension * par.compliance


def set_out(law: CompactLaw, given: Buffer, nodes: Lanes, w: Lanes, i: int, table: Buffer) -> None:
    """Where the march of a lane begins; without a kick at the end of the first step."""
    w[S, i], w[X, i], w[WORK, i] = 0.0, w[X_AT_FIRST, i], 0.0
    if w[KICK, i] > 0.0:
        return
    par = parameters_at(exp(w[LOG_TENSION, i]), geometry_of(given))
    leave(law, par, nodes, w, i, table)


def leave(law: CompactLaw, par: Parameters, nodes: Lanes, w: Lanes, i: int, table: Buffer) -> None:
    """Where the march of an arc without a kick begins: at the end of the first step."""
    table[FIRST] = nodes[SIXTH_STEP, i]
    status, _, s, x, work = start_of(law, par, w[G, i], table)
    w[S, i], w[X, i], w[WORK, i] = s if status == SOLVED else nan, x, work
