"""Operating points of the precise setting by the kernel's march in the lanes.

The search begins with what the engineering setting has found and meets the tensions as closely as
the scalar kernel does, on its mesh; :mod:`wraparc.batch.sixth_read` reads the profile.
"""

from __future__ import annotations

from math import log, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.effort import mesh_steps
from wraparc.arc.kernel.quantities import RECORD, SOLVED, Buffer, parameters_at, zeros
from wraparc.arc.kernel.tension_march import start_of
from wraparc.arc.kernel.tension_table import FIRST
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.elementwise import (
    LANES,
    Lanes,
    anywhere,
    full_ex,
    full_ln,
    lanes,
    lower,
    memory,
    select,
    upper,
)
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_sixth import MOST_SIXTH, SIXTH_STEP, SIXTH_TRACE, lay_steps, march
from wraparc.batch.lane_slots import (
    END,
    G_AT_FIRST,
    GRADED_PART,
    KICK,
    LENGTH,
    MISS,
    MISS_LAST,
    P1,
    PLAIN_STEP,
    RADIUS,
    RATIO,
    ROW,
    SHEAR,
    SLOPE,
    SLOTS,
    SMALLEST,
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
from wraparc.batch.native import compiled
from wraparc.batch.precise import POINTS, STEPS
from wraparc.batch.row import FOUND_NUMBERS, geometry_of, load_of
from wraparc.batch.sixth_read import tell
from wraparc.friction.compact import KNOTS, CompactLaw

Flags = NDArray[np.bool_]

ROUNDS = 8  # of the search: 3 are usual
NEAR = 1e-11  # of ln(s/L), where it ends
FAR = 1e30
NODES = SIXTH_STEP * MOST_SIXTH
TRACES = SIXTH_TRACE * MOST_SIXTH


def solve_in_sixth(arcs: Arcs, laws: LaneLaws, starts: Array, found: Array) -> Flags:
    """Solve operating points from where they begin (`row.STARTS`) into rows of results.

    Returns which of them are solved: driving arcs by knots whose slip grows all along, and stays
    short of the peak.
    """
    done = np.zeros(len(arcs), dtype=bool)
    fit = np.isfinite(starts[:, 0]) & (arcs.laws.kind[arcs.law] == KNOTS)
    which = np.flatnonzero(fit)
    if not len(which):
        return done
    some = arcs.rows(which)
    scratch = (np.zeros(k * LANES) for k in (SLOTS, NODES, TRACES))
    buffers = (np.zeros(FIRST + 1), np.zeros(RECORD * (2 * POINTS + MOST_SIXTH)))
    out, solved = np.empty((len(which), FOUND_NUMBERS)), np.zeros(len(which), dtype=bool)
    rows, mesh = laws.row[some.law].astype(float), (STEPS, POINTS)
    compiled(sixth_rows, contract=True)(
        some.inputs(), some.laws.arrays, some.law, laws.numbers, rows, mesh, starts[which],
        *scratch, *buffers, out, solved,
    )  # fmt: skip
    done[which] = solved
    found[which[solved]] = out[solved]
    return done


def sixth_rows(
    given: Any,
    bank: Any,
    which: Any,
    laws_: Any,
    rows: Any,
    mesh: Any,
    starts: Any,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    table_: Any,
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
    sort_by_size(given, bank, which, mesh[0], fine, order)
    for first in range(0, count, n):
        for i in range(n):
            j = int(order[min(first + i, count - 1)])
            take(
                law_of(bank, which[j]),
                given[j],
                fine[j],
                rows[j],
                starts[j],
                w,
                i,
                table,
            )
        steps = lay_steps(w, laws, nodes)
        for _ in range(ROUNDS):
            for i in range(n):
                j = int(order[min(first + i, count - 1)])
                set_out(law_of(bank, which[j]), given[j], nodes, w, i, table)
            march(w, nodes, trace, steps)
            if not correct(w):
                break
        for i in range(min(n, count - first)):
            j = int(order[first + i])
            done[j] = tell(
                law_of(bank, which[j]),
                given[j],
                w,
                nodes,
                trace,
                i,
                points,
                table,
                out,
                found[j],
            )


def sort_by_size(
    given: Any, bank: Any, which: Any, steps: int, fine: Buffer, order: Buffer
) -> None:
    """Fineness of the mesh of every row, and an order of rows by the steps that they take.

    A block takes as many steps as its longest lane.
    """
    places = zeros(MOST_SIXTH + 1)
    keys = zeros(len(fine))
    for j in range(len(fine)):
        load = load_of(given[j])
        par = parameters_at(load.entry_tension, geometry_of(given[j]))
        fine[j] = mesh_steps(law_of(bank, which[j]), par, steps)
        size = fine[j] * (0.75 + log(load.entry_tension / load.exit_tension) / 1.44)
        keys[j] = min(size, MOST_SIXTH - 1.0)
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
    starts: Buffer,
    w: Lanes,
    i: int,
    table: Buffer,
) -> None:
    """Fill a lane."""
    load = load_of(given)
    par = parameters_at(load.entry_tension, geometry_of(given))
    w[ROW, i], w[RADIUS, i], w[LENGTH, i] = row, par.radius, par.length
    w[SHEAR, i], w[P1, i], w[KICK, i] = par.shear, par.entry_pressure, par.kick
    w[RATIO, i] = par.entry_tension * par.compliance
    w[END, i] = log(load.entry_tension / load.exit_tension)
    w[GRADED_PART, i], w[PLAIN_STEP, i] = 1.0 / (0.75 * fine), 1.44 / fine
    w[G, i] = w[G_AT_FIRST, i] = starts[0]
    w[SUM_AT_FIRST, i], w[SLOPE, i] = starts[6], starts[4] * starts[6]
    w[Z, i] = w[Z_LAST, i] = w[MISS_LAST, i] = w[MISS, i] = 0.0
    w[X_AT_FIRST, i] = 0.0
    if par.kick > 0.0:
        begin = start_of(law, par, 0.0, table)
        w[X_AT_FIRST, i] = begin[3]


def set_out(law: CompactLaw, given: Buffer, nodes: Lanes, w: Lanes, i: int, table: Buffer) -> None:
    """Where a lane's march begins; without a kick at the end of the first step."""
    w[S, i], w[X, i], w[WORK, i] = 0.0, w[X_AT_FIRST, i], 0.0
    if w[KICK, i] > 0.0:
        return
    table[FIRST] = nodes[SIXTH_STEP, i]
    par = parameters_at(load_of(given).entry_tension, geometry_of(given))
    status, _, s, x, work = start_of(law, par, w[G, i], table)
    w[S, i], w[X, i], w[WORK, i] = s if status == SOLVED else nan, x, work


def correct(w: Lanes) -> bool:
    """One step of z towards s = L, a secant after the first; whether any lane is on its way.

    z is the logarithm of (g + x_c/l) over its first value. A lane that has arrived stays there.
    """
    n = lanes()
    left = 0
    for i in range(n):
        z, g, total = w[Z, i], w[G_AT_FIRST, i], w[SUM_AT_FIRST, i]
        miss = full_ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])
        here = upper(miss, -miss) <= NEAR
        secant = (miss - w[MISS_LAST, i]) / (z - w[Z_LAST, i])
        sound = (secant < 0.0) & (secant > -FAR)  # not before there are two tries
        slope = select(sound, secant, w[SLOPE, i])
        w[SLOPE, i] = slope
        w[MISS, i] = miss
        w[MISS_LAST, i], w[Z_LAST, i] = miss, select(here, w[Z_LAST, i], z)
        z = select(here, z, z - lower(upper(miss / slope, -1.0), 1.0))
        w[Z, i] = z
        w[G, i] = g + total * (full_ex(z) - 1.0)
        left = left + select(here, 0, 1)
    return anywhere(left > 0)
