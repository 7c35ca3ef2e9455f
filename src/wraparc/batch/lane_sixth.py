"""The kernel's own march in tension (:mod:`wraparc.arc.kernel.tension_march`) in the lanes.

The same sixth-order steps on the same mesh, each lane on its own, so that the numbers are those of
the scalar kernel to rounding. Made for slip that keeps its direction and stays short of the peak of
an integral-log law. A lane that has reached its end takes steps of no length beside the others.

A step is kept as the Q it begins at and five places (0, 1/3, 1/2, 2/3, 1) of `PLACE` numbers:
1/x_pk, R/mu_pk, |T1 - T| C, sigma c p (mu + p mu_p), sigma c p p mu x_pk'/x_pk, c p mu/x_pk, mu p,
and dQ.
"""

from __future__ import annotations

from wraparc.arc.kernel.tension_table import GRADED_END
from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    anywhere,
    full_ex,
    full_ln,
    lanes,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_law import BUCKETS, HEAD
from wraparc.batch.lane_look import fetch, read_head
from wraparc.batch.lane_slots import (
    ABOVE,
    AT,
    BELOW,
    BUCKET,
    BUCKETS_PER_PASCAL,
    CELL_AT,
    END,
    END_AT,
    ENDED,
    ETA,
    GRADED,
    GRADED_PART,
    HIGH,
    INSIDE,
    KICK,
    LENGTH,
    LIMIT,
    LOW,
    P1,
    PART,
    PLAIN_STEP,
    Q_AT,
    Q_FROM,
    Q_SPAN,
    Q_TO,
    RADIUS,
    RATE_1,
    RATE_2,
    RATE_3,
    RATE_4,
    RATE_5,
    RATE_6,
    RATE_S,
    RATIO,
    ROW,
    S_FROM,
    S_PAST,
    SHEAR,
    SIDE,
    SMALLEST,
    STEEPEST,
    STEP_BY,
    STEP_FROM,
    STEP_TO,
    STOP,
    SUM_S,
    SUM_W,
    SUM_X,
    WEIGHED_BY,
    WORK,
    WORK_FROM,
    X_FROM,
    G,
    S,
    X,
)

PLACE = 8
SIXTH_STEP = 1 + 5 * PLACE
SIXTH_TRACE = 5  # recorded where steps begin: s, slip, work, shear stress, slope of slip
MOST_SIXTH = 320  # steps that there is room for
LANDINGS = 5  # of Newton's method, each with a step of its own
FARTHEST = 1e300
INWARDS = 1e-13  # of a pressure: the piece of the law that a step goes into


def lay_steps(w: Lanes, laws: Table, nodes: Lanes) -> int:
    """Lay the mesh up to STOP of every lane, and a step of no length there.

    Returns the steps of the longest lane before that one.
    """
    n = lanes()
    read_head(w, laws)
    for i in range(n):
        w[Q_AT, i] = w[ETA, i] = 0.0
    for k in range(MOST_SIXTH):
        find_piece(w, laws)
        set_step(w, nodes, k)
        for place in range(5):
            lay_place(w, nodes, k, place)
        left = 0
        for i in range(n):
            left = left + select(w[Q_AT, i] < w[STOP, i], 1, 0)
            w[Q_AT, i] = w[STEP_TO, i]
        if not anywhere(left > 0):
            return k
    return MOST_SIXTH - 1


def find_piece(w: Lanes, laws: Table) -> None:
    """The piece of the law that the step from Q_AT goes into."""
    n = lanes()
    for i in range(n):
        side = w[SIDE, i]
        p = w[P1, i] * full_ex(-side * w[Q_AT, i]) * (1.0 - side * INWARDS)
        low, high = w[LOW, i], w[HIGH, i]
        w[ABOVE, i], w[BELOW, i] = select(p > high, 1.0, 0.0), select(p < low, 1.0, 0.0)
        w[INSIDE, i] = inside = lower(upper(p, low), high)
        part = (inside - low) * w[BUCKETS_PER_PASCAL, i]
        w[BUCKET, i] = w[ROW, i] + HEAD + lower(part, BUCKETS - 0.5) - 0.5
    fetch(w, laws)


def set_step(w: Lanes, nodes: Lanes, k: int) -> None:
    """Where a step goes, as `tension_table.extend` has it."""
    n = lanes()
    first = 1.0 if k == 0 else 0.0
    for i in range(n):
        q, end = w[Q_AT, i], w[END, i]
        falls, above, below = w[SIDE, i] > 0.0, w[ABOVE, i] > 0.5, w[BELOW, i] > 0.5
        floor = select(above, w[HIGH, i], w[CELL_AT, i])
        ceiling = select(below, w[LOW, i], w[CELL_AT + 1, i])
        way = select(falls, w[P1, i] / floor, ceiling / w[P1, i])
        last = select(falls, below, above)
        wall = select(last, end, lower(end, full_ln(way)))
        top = lower(GRADED_END, end)
        graded = q < top * (1.0 - 1e-12)
        goes = q < w[STOP, i]
        near, part, eta = lower(wall, top), w[GRADED_PART, i], w[ETA, i]
        most = full_ex(0.1 * full_ln(near / top))
        stops = most - eta < 1.3 * part
        to = select(stops, most, eta + part)
        to_2 = to * to
        to_4 = to_2 * to_2
        far = select(stops, near, top * (to_4 * to_4 * to_2))
        h = select(wall - q > 1.3 * w[PLAIN_STEP, i], w[PLAIN_STEP, i], wall - q)
        plain = select(q + h >= wall * (1.0 - 1e-13), wall, q + h)
        by = select(goes, select(graded, to - eta, h), 0.0)
        w[ETA, i] = to
        w[GRADED, i] = select(graded, top, 0.0)
        w[STEP_FROM, i], w[STEP_BY, i] = select(graded, eta, q), by
        w[STEP_TO, i] = select(goes, select(graded, far, plain), q)
        # without a kick the first step is closed analytically
        w[WEIGHED_BY, i] = select((w[KICK, i] <= 0.0) & (first > 0.5), 0.0, by)
        nodes[SIXTH_STEP * k, i] = q


def lay_place(w: Lanes, nodes: Lanes, k: int, place: int) -> None:
    """Numbers of one place of a step."""
    n = lanes()
    o = SIXTH_STEP * k + 1 + PLACE * place
    part = 0.0 if place == 0 else (1.0 if place == 4 else (1.0 + place) / 6.0)
    for i in range(n):
        top, side, shear = w[GRADED, i], w[SIDE, i], w[SHEAR, i]
        e = w[STEP_FROM, i] + part * w[STEP_BY, i]
        e_2 = e * e
        e_4 = e_2 * e_2
        e_9 = e_4 * e_4 * e
        graded = top > 0.0
        fall = full_ex(-side * select(graded, top * e_9 * e, e))
        p = w[P1, i] * fall
        above, below = w[ABOVE, i] > 0.5, w[BELOW, i] > 0.5
        t = select(above, w[HIGH, i], select(below, w[LOW, i], p)) - w[CELL_AT, i]
        x1, x2, x3 = w[CELL_AT + 3, i], w[CELL_AT + 4, i], w[CELL_AT + 5, i]
        m1, m2, m3 = w[CELL_AT + 7, i], w[CELL_AT + 8, i], w[CELL_AT + 9, i]
        slip = w[CELL_AT + 2, i] + t * (x1 + t * (x2 + t * x3))
        friction = w[CELL_AT + 6, i] + t * (m1 + t * (m2 + t * m3))
        friction = friction * select(above, w[HIGH, i] / p, 1.0)
        varies = select(above | below, 0.0, p)
        slip_p = varies * (x1 + t * (2.0 * x2 + 3.0 * t * x3))
        friction_p = varies * (m1 + t * (2.0 * m2 + 3.0 * t * m3))
        friction_p = select(above, -friction, friction_p)
        inverse, traction = 1.0 / slip, friction * p
        soft = shear * traction * inverse
        nodes[o, i] = inverse
        nodes[o + 1, i] = w[RADIUS, i] / friction
        nodes[o + 2, i] = w[RATIO, i] * side * (1.0 - fall)
        nodes[o + 3, i] = side * shear * p * (friction + friction_p)
        nodes[o + 4, i] = side * soft * slip_p
        nodes[o + 5, i] = soft
        nodes[o + 6, i] = traction
        nodes[o + 7, i] = w[WEIGHED_BY, i] * select(graded, 10.0 * top * e_9, 1.0)


def rates(
    a: Number,
    g: Number,
    inverse: Number,
    resistance: Number,
    shrinkage: Number,
    bend: Number,
    turn: Number,
    steep: Number,
    traction: Number,
    weight: Number,
) -> tuple[Number, Number, Number, Number]:
    """Rates of arc, slip and friction work by a step, and slip over peak slip."""
    r = a * inverse
    log_r = full_ln(upper(r, SMALLEST))
    fall = r * log_r
    form = r - fall
    stiff = 1.0 - steep * log_r
    part = weight / (form * stiff)
    dx = ((g + shrinkage) * resistance + form * (bend * form + turn * fall)) * part
    return resistance * stiff * part, dx, traction * form * dx, r


def march(w: Lanes, nodes: Lanes, trace: Lanes, steps: int) -> None:
    """March from S, X and WORK to STOP, or until a step passes LIMIT; record where steps begin.

    A lane that would pass LIMIT stays where that step begins; S_PAST is where it leads. STEEPEST is
    the largest x/x_pk on the way.
    """
    n = lanes()
    for i in range(n):
        w[STEEPEST, i] = w[ENDED, i] = w[S_PAST, i] = w[Q_FROM, i] = w[Q_TO, i] = 0.0
    for k in range(steps):
        o, t = SIXTH_STEP * k + 1, SIXTH_TRACE * k
        first_stage(w, nodes, trace, o, t)
        next_stages(w, nodes, o)
    first_stage(w, nodes, trace, SIXTH_STEP * steps + 1, SIXTH_TRACE * steps)


def rates_at(w: Lanes, nodes: Lanes, o: int, i: int) -> tuple[Number, Number, Number, Number]:
    """`rates` of a lane at a place, with the slip AT."""
    return rates(
        w[AT, i],
        w[G, i],
        nodes[o, i],
        nodes[o + 1, i],
        nodes[o + 2, i],
        nodes[o + 3, i],
        nodes[o + 4, i],
        nodes[o + 5, i],
        nodes[o + 6, i],
        nodes[o + 7, i],
    )


def first_stage(w: Lanes, nodes: Lanes, trace: Lanes, o: int, t: int) -> None:
    """The first stage of a step, and where it begins."""
    n = lanes()
    for i in range(n):
        x, resistance = w[X, i], nodes[o + 1, i]
        r = x * nodes[o, i]
        log_r = full_ln(upper(r, SMALLEST))
        fall = r * log_r
        form = r - fall
        stiff = 1.0 - nodes[o + 5, i] * log_r
        part = 1.0 / (resistance * stiff)
        creep = (w[G, i] + nodes[o + 2, i]) * resistance
        slope = (creep + form * (nodes[o + 3, i] * form + nodes[o + 4, i] * fall)) * part
        ds = nodes[o + 7, i] * resistance / form
        dx, stress = slope * ds, nodes[o + 6, i] * form
        dw = stress * dx
        trace[t, i], trace[t + 1, i], trace[t + 2, i] = w[S, i], x, w[WORK, i]
        trace[t + 3, i], trace[t + 4, i] = stress, slope
        w[STEEPEST, i] = upper(w[STEEPEST, i], select(w[ENDED, i] > 0.5, 0.0, r))
        w[RATE_1, i] = dx
        w[SUM_S, i], w[SUM_X, i], w[SUM_W, i] = 11.0 * ds, 11.0 * dx, 11.0 * dw
        w[AT, i] = w[X, i] + dx / 3.0


def next_stages(w: Lanes, nodes: Lanes, o: int) -> None:
    """The other stages of a step (:mod:`wraparc.arc.kernel.butcher`), and its end."""
    n = lanes()
    n1, n2, n3, n4 = o + PLACE, o + 2 * PLACE, o + 3 * PLACE, o + 4 * PLACE
    for i in range(n):
        _, dx, _, _ = rates_at(w, nodes, n1, i)
        w[RATE_2, i] = dx
        w[AT, i] = w[X, i] + dx * (2.0 / 3.0)
    for i in range(n):
        ds, dx, dw, _ = rates_at(w, nodes, n3, i)
        w[RATE_3, i] = dx
        w[SUM_S, i] = w[SUM_S, i] + 81.0 * ds
        w[SUM_X, i] = w[SUM_X, i] + 81.0 * dx
        w[SUM_W, i] = w[SUM_W, i] + 81.0 * dw
        w[AT, i] = w[X, i] + (w[RATE_1, i] + 4.0 * w[RATE_2, i] - dx) / 12.0
    for i in range(n):
        ds, dx, dw, _ = rates_at(w, nodes, n1, i)
        w[RATE_4, i] = dx
        w[SUM_S, i] = w[SUM_S, i] + 81.0 * ds
        w[SUM_X, i] = w[SUM_X, i] + 81.0 * dx
        w[SUM_W, i] = w[SUM_W, i] + 81.0 * dw
        due = 18.0 * w[RATE_2, i] - w[RATE_1, i] - 3.0 * w[RATE_3, i] - 6.0 * dx
        w[AT, i] = w[X, i] + due / 16.0
    for i in range(n):
        ds, dx, dw, _ = rates_at(w, nodes, n2, i)
        w[RATE_5, i] = dx
        w[SUM_S, i] = w[SUM_S, i] - 32.0 * ds
        w[SUM_X, i] = w[SUM_X, i] - 32.0 * dx
        w[SUM_W, i] = w[SUM_W, i] - 32.0 * dw
        due = 9.0 * w[RATE_2, i] - 3.0 * w[RATE_3, i] - 6.0 * w[RATE_4, i] + 4.0 * dx
        w[AT, i] = w[X, i] + due / 8.0
    for i in range(n):
        ds, dx, dw, _ = rates_at(w, nodes, n2, i)
        w[RATE_6, i] = dx
        w[SUM_S, i] = w[SUM_S, i] - 32.0 * ds
        w[SUM_X, i] = w[SUM_X, i] - 32.0 * dx
        w[SUM_W, i] = w[SUM_W, i] - 32.0 * dw
        due = 9.0 * w[RATE_1, i] - 36.0 * w[RATE_2, i] + 63.0 * w[RATE_3, i]
        w[AT, i] = w[X, i] + (due + 72.0 * w[RATE_4, i] - 64.0 * dx) / 44.0
    for i in range(n):
        ds, dx, dw, r = rates_at(w, nodes, n4, i)
        s = w[S, i] + (w[SUM_S, i] + 11.0 * ds) / 120.0
        ended = w[ENDED, i] > 0.5
        stays = ended | (s >= w[LIMIT, i])
        w[S_PAST, i] = select(ended, w[S_PAST, i], s)
        w[Q_FROM, i] = select(ended, w[Q_FROM, i], nodes[o - 1, i])
        w[Q_TO, i] = select(ended, w[Q_TO, i], nodes[o - 1 + SIXTH_STEP, i])
        w[ENDED, i] = select(stays, 1.0, 0.0)
        w[STEEPEST, i] = upper(w[STEEPEST, i], select(stays, 0.0, r))
        w[RATE_S, i] = ds
        w[S, i] = select(stays, w[S, i], s)
        x, work = w[X, i] + (w[SUM_X, i] + 11.0 * dx) / 120.0, w[WORK, i]
        w[X, i] = select(stays, w[X, i], x)
        w[WORK, i] = select(stays, work, work + (w[SUM_W, i] + 11.0 * dw) / 120.0)


def land(w: Lanes, laws: Table, nodes: Lanes, trace: Lanes) -> None:
    """Go on from where lanes have ended to LIMIT, a part of a step: S, X, WORK and END_AT there.

    Newton's method on the length of the part, as `tension_march` cuts a step.
    """
    n = lanes()
    for i in range(n):
        w[S_FROM, i], w[X_FROM, i], w[WORK_FROM, i] = w[S, i], w[X, i], w[WORK, i]
        w[Q_AT, i] = w[STEP_FROM, i] = w[Q_FROM, i]
        w[Q_SPAN, i] = w[Q_TO, i] - w[Q_FROM, i]
        w[PART, i] = (w[LENGTH, i] - w[S, i]) / (w[S_PAST, i] - w[S, i])
        w[GRADED, i], w[LIMIT, i] = 0.0, FARTHEST
    find_piece(w, laws)
    for _ in range(LANDINGS):
        for i in range(n):
            w[S, i], w[X, i], w[WORK, i] = w[S_FROM, i], w[X_FROM, i], w[WORK_FROM, i]
            w[ENDED, i] = 0.0
            by = w[PART, i] * w[Q_SPAN, i]
            w[STEP_BY, i] = w[WEIGHED_BY, i] = by
            w[END_AT, i] = w[STEP_FROM, i] + by
        for place in range(5):
            lay_place(w, nodes, MOST_SIXTH, place)
        first_stage(w, nodes, trace, SIXTH_STEP * MOST_SIXTH + 1, SIXTH_TRACE * MOST_SIXTH)
        next_stages(w, nodes, SIXTH_STEP * MOST_SIXTH + 1)
        for i in range(n):
            w[PART, i] = w[PART, i] * (1.0 - (w[S, i] - w[LENGTH, i]) / w[RATE_S, i])
    for i in range(n):
        w[LIMIT, i] = w[LENGTH, i]
