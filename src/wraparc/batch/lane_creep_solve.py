"""Operating points by the march with creep as the state: the entry creep ratio that meets T2.

The unknown is carried as z, g = g0 + g1 sinh z, such that in an arc whose friction is proportional
to slip, u = x_c cosh(s/l) + g l sinh(s/l), the creep at the exit is that of the guess times sinh z:
whichever way the belt leaves the pulley, and however short its shear-lag length l is.
"""

from __future__ import annotations

from typing import Any

from wraparc.batch.elementwise import (
    Lanes,
    Table,
    anywhere,
    full_ex,
    full_ln,
    lanes,
    lower,
    memory,
    root,
    select,
    upper,
)
from wraparc.batch.lane_creep import FIRST_STEPS, march
from wraparc.batch.lane_creep_law import Cells, read_law
from wraparc.batch.lane_creep_read import read
from wraparc.batch.lane_kernel import take
from wraparc.batch.lane_look import look_up
from wraparc.batch.lane_slots import (
    ACTIVE,
    CHANGE,
    CHANGE_FIRST,
    COMPLIANCE,
    CREEP_GUESS,
    END,
    ENTRY_STRESS,
    EXIT_CREEP,
    EXIT_STRESS,
    EXIT_X,
    FASTEST,
    FRICTION_AT,
    G_MIDDLE,
    G_SCALE,
    G_Z,
    KICK,
    KICK_FORMULA,
    KICK_GIVEN,
    LARGEST,
    LENGTH,
    MISS,
    MISSED,
    OUTSIDE,
    P1,
    PEAK_AT,
    PEAK_STRESS,
    PRESSURE,
    RADIUS,
    RATIO,
    SHEAR,
    SLIP_AT,
    SMALLEST,
    STEEPEST,
    STIFF_GUESS,
    T_Z,
    TENSION,
    U_COARSE,
    U_COARSEST,
    U_Z,
    WIDTH,
    Z_HIGH,
    Z_LOW,
    Z_STEP,
    G,
    S,
    T,
    U,
    Z,
)

#: slots that a row fills beyond those of `lane_kernel.GIVEN`, and what a row of results has
GIVEN_MORE = (CREEP_GUESS, STIFF_GUESS)
TOLD = (
    MISS,
    CHANGE,
    CHANGE_FIRST,
    MISSED,
    G,
    EXIT_X,
    EXIT_CREEP,
    EXIT_STRESS,
    ENTRY_STRESS,
    PEAK_STRESS,
    PEAK_AT,
    ACTIVE,
    OUTSIDE,
    LARGEST,
    FASTEST,
    STEEPEST,
    Z,
)
ROUNDS = 24  # of the first search: 2 or 3 are usual
NEARLY = 0.03  # last change of z in it
LONGEST = 30.0  # shear-lag lengths that a guess knows
FARTHEST = 40.0  # |z|
LEAST_CREEP = 1e-9  # guessed at the exit [m]
REACH = 2.0  # of a step of z
EXIT_OVER_MEAN = 1.6  # of friction, guessed


def load(w: Lanes, laws: Table, cells: Cells, first: bool) -> None:
    """What follows from the entry tension and the guess."""
    n = lanes()
    for i in range(n):
        p = w[TENSION, i] / (w[WIDTH, i] * w[RADIUS, i])
        w[P1, i], w[RATIO, i] = p, w[TENSION, i] * w[COMPLIANCE, i]
        w[KICK, i] = w[KICK_GIVEN, i] + w[KICK_FORMULA, i] * p * root(p)
        w[S, i] = w[LENGTH, i]
        w[MISSED, i] = 0.0 * p
        w[PRESSURE, i] = p * full_ex(-0.5 * w[END, i])
    read_law(w, laws, cells)
    if cells is None:
        look_up(w, laws)
        guess_of_form(w)
    for i in range(n):
        p = w[P1, i]
        # creep for traction at small slip, and the shear-lag length of that
        soft = w[SHEAR, i] + 1.0 / (w[STIFF_GUESS, i] * p)
        lag = root(soft / (w[WIDTH, i] * w[COMPLIANCE, i]))
        e = full_ex(lower(w[LENGTH, i] / lag, LONGEST))
        sinh, cosh = 0.5 * (e - 1.0 / e), 0.5 * (e + 1.0 / e)
        scale = upper(upper(w[CREEP_GUESS, i], -w[CREEP_GUESS, i]), w[KICK, i])
        scale = upper(scale, LEAST_CREEP)
        w[G_MIDDLE, i], w[G_SCALE, i] = -w[KICK, i] * cosh / (lag * sinh), scale / (lag * sinh)
        v = w[CREEP_GUESS, i] / scale
        size = upper(v, -v)
        z = full_ln(size + root(size * size + 1.0))
        w[Z, i] = select(first, select(v < 0.0, -z, z), w[Z, i])
        w[Z_LOW, i], w[Z_HIGH, i] = z * 0.0 - FARTHEST, z * 0.0 + FARTHEST
        w[Z_STEP, i] = z * 0.0 + FARTHEST


def guess_of_form(w: Lanes) -> None:
    """Creep at the exit and stiffness at small slip, of an integral-log law.

    Friction grows from the entry to the exit: what it is at the exit is a good half above its mean.
    The slip of the kick has to be made good by as much.
    """
    n = lanes()
    for i in range(n):
        slip, friction = w[SLIP_AT, i], w[FRICTION_AT, i]
        mean = w[END, i] * w[RADIUS, i] / w[LENGTH, i]
        share = lower(EXIT_OVER_MEAN * upper(mean, -mean) / friction, 0.9)
        r = 0.3 * share + SMALLEST
        for _ in range(4):
            log_r = full_ln(r)
            r = lower(upper(r - (share - r * (1.0 - log_r)) / log_r, 0.3 * r), 0.9)
        creep = r * slip + w[SHEAR, i] * friction * share * w[PRESSURE, i]
        w[CREEP_GUESS, i] = select(mean < 0.0, -creep, creep) - w[KICK, i]
        small = lower(upper(0.3 * r, 0.3 * w[KICK, i] / slip) + 1e-9, 1.0)
        w[STIFF_GUESS, i] = friction / slip * (1.0 - full_ln(small))


def set_ratio(w: Lanes) -> None:
    """G and dg/dz of z."""
    n = lanes()
    for i in range(n):
        e = full_ex(lower(upper(w[Z, i], -FARTHEST), FARTHEST))
        w[G, i] = w[G_MIDDLE, i] + w[G_SCALE, i] * 0.5 * (e - 1.0 / e)
        w[G_Z, i] = w[G_SCALE, i] * 0.5 * (e + 1.0 / e)


def correct(w: Lanes) -> bool:
    """One step of Newton's method of z for T(L) = T2 within its bracket; whether all are near.

    The more creep, the more friction, and the less tension is left. A lane that is near is left.
    """
    n = lanes()
    far = 0
    for i in range(n):
        z, low, high = w[Z, i], w[Z_LOW, i], w[Z_HIGH, i]
        miss = full_ln(w[T, i]) + w[END, i]
        slope = w[T_Z, i] / w[T, i]
        low, high = select(miss > 0.0, z, low), select(miss > 0.0, high, z)
        step = -miss / lower(slope, -SMALLEST)
        limited = lower(upper(step, -REACH), REACH)
        new = z + select(slope < 0.0, limited, select(miss > 0.0, REACH, -REACH))
        new = select((new > low) & (new < high), new, 0.5 * (low + high))
        off = upper(w[Z_STEP, i], -w[Z_STEP, i]) > NEARLY
        w[Z_STEP, i] = select(off, new - z, w[Z_STEP, i])
        w[Z, i] = select(off, new, z)
        w[Z_LOW, i], w[Z_HIGH, i] = low, high
        off = upper(w[Z_STEP, i], -w[Z_STEP, i]) > NEARLY
        far = far + select(off, 1, 0)
    return not anywhere(far > 0)


def newton(w: Lanes) -> None:
    """One step of Newton's method of z, limited; Z_STEP is what it should be."""
    n = lanes()
    for i in range(n):
        miss = full_ln(w[T, i]) + w[END, i]
        slope = w[T_Z, i] / w[T, i]
        step = select(slope < 0.0, -miss / lower(slope, -SMALLEST), 1.0)
        w[Z_STEP, i] = step
        w[Z, i] = w[Z, i] + lower(upper(step, -1.0), 1.0)


def meet_tensions(
    w: Lanes, laws: Table, cells: Cells, trace: Lanes, first: bool, steps: int
) -> None:
    """Find z: a search on few steps if `first`, then steps on a third, on half, on all of the mesh.

    The last march is recorded. One call of the march: what is written once is compiled once.
    """
    k = 0 if first else 1
    for tries in range(ROUNDS + 3):
        set_ratio(w)
        march(w, laws, cells, FIRST_STEPS if k == 0 else steps // (4 - k), k == 3, trace)
        if k > 0:
            newton(w)
            remember(w, k)
            k = k + 1
        elif correct(w) or tries == ROUNDS - 1:
            k = 1
        if k == 4:
            break


def remember(w: Lanes, k: int) -> None:
    """Keep the creep at the exit of a coarser mesh, brought to T2 by the derivatives."""
    n = lanes()
    for i in range(n):
        u = w[U, i] + w[U_Z, i] * w[Z_STEP, i]
        w[U_COARSEST, i] = select(k == 1, u, w[U_COARSEST, i])
        w[U_COARSE, i] = select(k == 2, u, w[U_COARSE, i])
        w[MISSED, i] = select(k == 3, w[MISSED, i], 0.0)


def solve_block(w: Lanes, laws: Table, cells: Cells, trace: Lanes, first: bool, steps: int) -> None:
    """Solve a block for its tensions, from a guess if it is the `first` time, else from Z."""
    load(w, laws, cells, first)
    meet_tensions(w, laws, cells, trace, first, steps)
    read(w, laws, cells, trace, steps)
    set_ratio(w)


def table_rows(
    rows: Any,
    more: Any,
    laws_: Any,
    halvings: int,
    first: bool,
    steps: int,
    w_: Any,
    trace_: Any,
    out: Any,
) -> None:
    """Solve rows of drives under measured tables into rows of `TOLD`; compiled only."""
    w, trace, laws = memory(w_, "w"), memory(trace_, "trace"), memory(laws_, "tables")
    n, count = lanes(), len(rows)
    for begin in range(0, count, n):
        fill(rows, more, begin, count, w)
        solve_block(w, laws, halvings, trace, first, steps)
        tell(w, begin, count, out)


def form_rows(
    rows: Any,
    more: Any,
    laws_: Any,
    halvings: int,
    first: bool,
    steps: int,
    w_: Any,
    trace_: Any,
    out: Any,
) -> None:
    """The same under integral-log laws."""
    w, trace, laws = memory(w_, "w"), memory(trace_, "trace"), memory(laws_, "tables")
    n, count = lanes(), len(rows)
    for begin in range(0, count, n):
        fill(rows, more, begin, count, w)
        solve_block(w, laws, None, trace, first, steps)
        tell(w, begin, count, out)


def fill(rows: Any, more: Any, begin: int, count: int, w: Lanes) -> None:
    """Fill a block from rows; past the last one with copies of it."""
    take(rows, begin, count, w)
    n = lanes()
    for i in range(n):
        source = min(begin + i, count - 1)
        for k in range(len(GIVEN_MORE)):
            w[GIVEN_MORE[k], i] = more[source, k]


def tell(w: Lanes, begin: int, count: int, out: Any) -> None:
    """Write what a block has found."""
    n = lanes()
    for i in range(min(n, count - begin)):
        for k in range(len(TOLD)):
            out[begin + i, k] = w[TOLD[k], i]
