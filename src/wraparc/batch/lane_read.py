"""What a finished march of the lane kernel says of each arc, beyond its exit."""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    ex,
    index,
    lanes,
    ln,
    lower,
    root,
    select,
    upper,
)
from wraparc.batch.lane_slots import (
    ACTIVE,
    END,
    ENTRY_STRESS,
    EXIT_CREEP,
    EXIT_STRESS,
    EXIT_X,
    KICK,
    LENGTH,
    NODE,
    OUTSIDE,
    PASS_HIGH,
    PASS_LOW,
    PEAK_AT,
    PEAK_NODE,
    PEAK_STRESS,
    Q0,
    SHEAR,
    SLIP_MAX,
    SLIP_STEPS,
    SMALLEST,
    TRACE,
    S,
)

ACTIVE_SHARE = 0.01  # of the tension change that lies before the active arc


def read(w: Lanes, nodes: Lanes, trace: Lanes, steps: int) -> None:
    """Exit and entry stress, peak, active arc, share outside the tested range."""
    n = lanes()
    last = NODE * 2 * steps
    for i in range(n):
        r = upper(w[EXIT_X, i] * nodes[last, i], SMALLEST)
        log_r = lower(ln(r), 0.0)
        stress = lower(r, 1.0) * (1.0 - log_r) * nodes[last + 7, i]
        w[EXIT_STRESS, i] = trace[TRACE * steps + 3, i] = stress
        w[EXIT_CREEP, i] = w[EXIT_X, i] + w[SHEAR, i] * stress
        w[ENTRY_STRESS, i] = select(w[KICK, i] > 0.0, trace[3, i], 0.0)
    for i in range(n):
        # where 1 % of the tension change has taken place
        q = -ln(1.0 - ACTIVE_SHARE * (1.0 - ex(-w[END, i])))
        part = upper(q - w[Q0, i], 0.0) / (w[END, i] - w[Q0, i])
        at = arc_at(trace, i, steps, steps * root(root(part)))
        w[ACTIVE, i] = w[LENGTH, i] * (1.0 - at / w[S, i])
    find_outside(w, trace, steps)
    find_peak(w, trace, steps)


def find_outside(w: Lanes, trace: Lanes, steps: int) -> None:
    """Share of the arc outside the tested range.

    That is before the pressure passes HIGH, and past the first of LOW and SLIP_MAX. Slip grows all
    along, and is taken as straight in a step.
    """
    n = lanes()
    for i in range(n):
        high = place_of(trace, i, steps, w[PASS_HIGH, i], w[S, i])
        low = place_of(trace, i, steps, w[PASS_LOW, i], w[S, i])
        o = TRACE * step_of(w[SLIP_STEPS, i] - 0.5, steps)
        s0, x0, s1, x1 = trace[o, i], trace[o + 1, i], trace[o + TRACE, i], trace[o + TRACE + 1, i]
        limit = w[SLIP_MAX, i]
        crossing = s0 + (s1 - s0) * lower((limit - x0) / upper(x1 - x0, SMALLEST), 1.0)
        crossing = select(w[SLIP_STEPS, i] > 0.0, select(x1 > limit, crossing, w[S, i]), 0.0)
        inside = upper(lower(low, crossing) - high, 0.0)
        w[OUTSIDE, i] = 1.0 - inside / w[S, i]


def find_peak(w: Lanes, trace: Lanes, steps: int) -> None:
    """Largest shear stress and where: beside the node where it is largest, on the side it rises."""
    n = lanes()
    for i in range(n):
        at = select(w[EXIT_STRESS, i] > w[PEAK_STRESS, i], 1.0 * steps, w[PEAK_NODE, i])
        k = TRACE * index(at)
        rises = trace[k + 4, i] > 0.0
        o = TRACE * step_of(select(rises, at + 0.5, at - 0.5), steps)
        s0, s1, d0, d1 = trace[o, i], trace[o + TRACE, i], trace[o + 2, i], trace[o + TRACE + 2, i]
        f, stress = crown(
            trace[o + 3, i], trace[o + TRACE + 3, i], trace[o + 4, i], trace[o + TRACE + 4, i]
        )
        inside = (f < 1.0) & (stress > trace[k + 3, i])
        where = select(inside, cubic(f, s0, s1, d0, d1), trace[k, i])
        w[PEAK_AT, i] = where * w[LENGTH, i] / w[S, i]
        w[PEAK_STRESS, i] = select(inside, stress, trace[k + 3, i])


def step_of(place: Number, steps: int) -> Number:
    """Number of the step that a place on the mesh lies in."""
    return index(lower(upper(place, 0.5), steps - 0.5) - 0.5)


def arc_at(trace: Lanes, i: int, steps: int, place: Number) -> Number:
    """S at a place on the mesh [m]."""
    j = step_of(place, steps)
    o = TRACE * j
    return cubic(
        place - j, trace[o, i], trace[o + TRACE, i], trace[o + 2, i], trace[o + TRACE + 2, i]
    )


def place_of(trace: Lanes, i: int, steps: int, place: Number, end: Number) -> Number:
    """S at a place that may lie before the entry or beyond the exit, which is at `end` [m]."""
    within = arc_at(trace, i, steps, lower(upper(place, 0.0), 1.0 * steps))
    return select(place < 0.0, 0.0, select(place >= steps, end, within))


def crown(t0: Number, t1: Number, d0: Number, d1: Number) -> tuple[Number, Number]:
    """Largest value, and its place, of the cubic through t0 and t1 with slopes d0 and d1.

    Inside if the slopes point to a top in between, else at the end of the step.
    """
    a = 3.0 * (d0 + d1) - 6.0 * (t1 - t0)
    b = 6.0 * (t1 - t0) - 4.0 * d0 - 2.0 * d1
    # d0 + b f + a f^2 = 0, written so that it stays good for small a
    f = 2.0 * d0 / (root(upper(b * b - 4.0 * a * d0, 0.0)) - b)
    inside = (d0 > 0.0) & (d1 < 0.0) & (f > 0.0) & (f < 1.0)
    f = select(inside, f, 1.0)
    return f, cubic(f, t0, t1, d0, d1)


def cubic(f: Number, s0: Number, s1: Number, d0: Number, d1: Number) -> Number:
    """Cubic through s0 and s1 with slopes d0 and d1, at the fraction f."""
    e = 1.0 - f
    return e * e * ((1.0 + 2.0 * f) * s0 + f * d0) + f * f * ((3.0 - 2.0 * f) * s1 - e * d1)
