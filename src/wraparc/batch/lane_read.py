"""What a finished march of the lane kernel says of each arc, beyond its exit."""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    ex,
    lanes,
    ln,
    lower,
    root,
    select,
    upper,
)
from wraparc.batch.lane_slots import (
    ACTIVE,
    ACTIVE_PLACE,
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
    PEAK_STRESS,
    Q0,
    S_ACTIVE,
    S_HIGH,
    S_LOW,
    S_SLIP,
    SHEAR,
    SLIP_MAX,
    SMALLEST,
    STEEPEST,
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
        zero = 0.0 * r
        w[PEAK_STRESS, i], w[PEAK_AT, i], w[STEEPEST, i] = trace[3, i], zero, zero
        w[S_ACTIVE, i] = w[S_HIGH, i] = w[S_LOW, i] = zero
        w[S_SLIP, i] = w[S, i]
        # where 1 % of the tension change has taken place
        q = -ln(1.0 - ACTIVE_SHARE * (1.0 - ex(-w[END, i])))
        part = upper(q - w[Q0, i], 0.0) / (w[END, i] - w[Q0, i])
        w[ACTIVE_PLACE, i] = steps * root(root(part))
    for j in range(steps):
        find_places(w, nodes, trace, j)
    for i in range(n):
        scale = w[LENGTH, i] / w[S, i]
        w[ACTIVE, i] = w[LENGTH, i] - scale * w[S_ACTIVE, i]
        # outside: before s_high, and past the first of s_low and s_slip
        high = select(w[PASS_HIGH, i] >= steps, w[S, i], w[S_HIGH, i])
        low = select(
            w[PASS_LOW, i] < 0.0, 0.0, select(w[PASS_LOW, i] >= steps, w[S, i], w[S_LOW, i])
        )
        inside = upper(lower(low, w[S_SLIP, i]) - high, 0.0)
        w[OUTSIDE, i] = 1.0 - inside / w[S, i]
        w[PEAK_AT, i] = scale * w[PEAK_AT, i]


def find_places(w: Lanes, nodes: Lanes, trace: Lanes, j: int) -> None:
    """Look into step j for the places sought, and at its end for the largest stress so far."""
    n = lanes()
    a, b = TRACE * j, TRACE * (j + 1)
    place = float(j)
    for i in range(n):
        s0, s1, d0, d1 = trace[a, i], trace[b, i], trace[a + 2, i], trace[b + 2, i]
        w[S_ACTIVE, i] = within(w[ACTIVE_PLACE, i] - place, s0, s1, d0, d1, w[S_ACTIVE, i])
        w[S_HIGH, i] = within(w[PASS_HIGH, i] - place, s0, s1, d0, d1, w[S_HIGH, i])
        w[S_LOW, i] = within(w[PASS_LOW, i] - place, s0, s1, d0, d1, w[S_LOW, i])
    for i in range(n):
        x0, x1, s0, s1 = trace[a + 1, i], trace[b + 1, i], trace[a, i], trace[b, i]
        limit = w[SLIP_MAX, i]
        crossing = s0 + (s1 - s0) * (limit - x0) / upper(x1 - x0, SMALLEST)
        first = (x0 <= limit) & (x1 > limit) & (w[S_SLIP, i] >= w[S, i])
        w[S_SLIP, i] = select(first, crossing, select((x0 > limit) & (j == 0), 0.0, w[S_SLIP, i]))
        w[STEEPEST, i] = upper(w[STEEPEST, i], x1 * nodes[NODE * 2 * (j + 1), i])
    for i in range(n):
        s0, s1, d0, d1 = trace[a, i], trace[b, i], trace[a + 2, i], trace[b + 2, i]
        f, stress = crown(trace[a + 3, i], trace[b + 3, i], trace[a + 4, i], trace[b + 4, i])
        new = stress > w[PEAK_STRESS, i]
        w[PEAK_AT, i] = select(new, cubic(f, s0, s1, d0, d1), w[PEAK_AT, i])
        w[PEAK_STRESS, i] = select(new, stress, w[PEAK_STRESS, i])


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


def within(f: Number, s0: Number, s1: Number, d0: Number, d1: Number, other: Number) -> Number:
    """The cubic at the fraction f of a step, else `other`."""
    return select((f >= 0.0) & (f < 1.0), cubic(f, s0, s1, d0, d1), other)


def cubic(f: Number, s0: Number, s1: Number, d0: Number, d1: Number) -> Number:
    """Cubic through s0 and s1 with slopes d0 and d1, at the fraction f."""
    e = 1.0 - f
    return e * e * ((1.0 + 2.0 * f) * s0 + f * d0) + f * f * ((3.0 - 2.0 * f) * s1 - e * d1)
