"""What a march of :mod:`wraparc.batch.lane_sixth` says of an arc, read as the kernel reads it.

From records of the few steps where there is something to be read, with the kernel's own functions.
"""

from __future__ import annotations

from math import exp, log, nan

from wraparc.arc.kernel.answer import LOSS_MISS, loss_miss
from wraparc.arc.kernel.quantities import (
    RECORD,
    SOLVED,
    Buffer,
    Load,
    Parameters,
    parameters_at,
)
from wraparc.arc.kernel.search import TOLERANCE, tension_shot
from wraparc.arc.kernel.tension_march import record_point, record_step
from wraparc.batch.elementwise import Lanes
from wraparc.batch.lane_sixth import SIXTH_STEP, SIXTH_TRACE
from wraparc.batch.lane_slots import END, MISS, Q_AT, STEEPEST, WORK, X_AT_FIRST, G, X
from wraparc.batch.row import FOUND_NUMBERS, OUTCOME, geometry_of, load_of, read_profile
from wraparc.friction.compact import RISE, CompactLaw, segment_of

ACTIVE_SHARE = 0.01  # of the tension change that lies before the active arc


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
    gamma, end = w[G, i], w[END, i]
    if not (abs(w[MISS, i]) <= TOLERANCE and w[STEEPEST, i] <= 1.0 and w[Q_AT, i] >= end):
        return False
    if gamma * par.length < -0.1 * par.kick:
        return False
    shot = tension_shot(law, par, gamma, end, w[X, i], w[WORK, i])
    if not loss_miss(law, par, shot) < LOSS_MISS:
        return False
    count = record_some(law, par, load, gamma, w, nodes, trace, i, points, table, out)
    if count == 0:
        return False
    for k in range(FOUND_NUMBERS):
        found[k] = nan
    found[OUTCOME] = SOLVED
    read_profile(law, par, load, shot, out, count, found)
    return True


def record_some(
    law: CompactLaw,
    par: Parameters,
    load: Load,
    gamma: float,
    w: Lanes,
    nodes: Lanes,
    trace: Lanes,
    i: int,
    points: int,
    table: Buffer,
    out: Buffer,
) -> int:
    """Record a profile where there is something to be read, and its ends; 0 if slip does not grow.

    That is where stress is largest, where slip grows fastest, where the active arc begins and where
    pressure or slip leave the tested range.
    """
    end = w[END, i]
    first = 1 if par.kick == 0.0 else 0
    last, peak, steep, mean = find_places(end, first, nodes, trace, i)
    if last == 0:
        return 0
    tension = load.entry_tension + ACTIVE_SHARE * (load.exit_tension - load.entry_tension)
    side = par.side
    begins = side * log(par.entry_tension / tension)
    enters = side * log(par.entry_pressure / load.pressure_max)
    leaves = side * log(par.entry_pressure / load.pressure_min)
    for k in range(RECORD):
        out[k] = 0.0
    if first == 0:
        record_point(law, par, 0.0, 0.0, w[X_AT_FIRST, i], 0.0, out, 0)
    count, recorded = 1, first
    for k in range(first, last):
        q, q1 = nodes[SIXTH_STEP * k, i], nodes[SIXTH_STEP * (k + 1), i]
        t = SIXTH_TRACE * k
        start = (q, trace[t, i], trace[t + 1, i], trace[t + 2, i])
        t += SIXTH_TRACE
        stop = (q1, trace[t, i], trace[t + 1, i], trace[t + 2, i])
        if (
            k in (peak - 1, peak, steep - 1, steep, mean)
            or q <= begins <= q1
            or q <= enters <= q1
            or q <= leaves <= q1
            or start[2] <= load.slip_max <= stop[2]
        ):
            if recorded < k:
                record_point(law, par, q, start[1], start[2], start[3], out, count)
                count += 1
            segment = segment_of(law, par.entry_pressure * exp(-0.5 * side * (q + q1)))
            count = record_step(
                law, par, gamma, segment, RISE, start, stop, points, table, out, count
            )
            recorded = k + 1
    if recorded < last:
        t = SIXTH_TRACE * last
        s, x, work = trace[t, i], trace[t + 1, i], trace[t + 2, i]
        record_point(law, par, end, s, x, work, out, count)
        count += 1
    return count


def find_places(
    end: float, first: int, nodes: Lanes, trace: Lanes, i: int
) -> tuple[int, int, int, int]:
    """Numbers of steps: of all; at whose beginnings stress is largest and slip grows fastest.

    The last is the one over which slip grows fastest. All are 0 if slip does not grow throughout.
    """
    peak, most, steep, steepest = first, 0.0, first, 0.0
    mean, most_mean = first, 0.0
    last = first
    while True:
        t = SIXTH_TRACE * last
        if trace[t + 3, i] > most:
            peak, most = last, trace[t + 3, i]
        if trace[t + 4, i] > steepest:
            steep, steepest = last, trace[t + 4, i]
        if not nodes[SIXTH_STEP * last, i] < end:
            break
        ds = trace[t + SIXTH_TRACE, i] - trace[t, i]
        dx = trace[t + SIXTH_TRACE + 1, i] - trace[t + 1, i]
        if not (ds > 0.0 and dx >= 0.0):
            return 0, 0, 0, 0
        if dx > most_mean * ds:
            mean, most_mean = last, dx / ds
        last += 1
    return last, peak, steep, mean
