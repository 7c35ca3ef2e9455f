"""What a march of :mod:`wraparc.batch.lane_sixth` misses, and the next try.

A lane that has met what it is to meet stays as it is while others are on their way.
"""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    anywhere,
    full_ex,
    full_ln,
    lanes,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_sixth import MOST_SIXTH, PLACE, SIXTH_STEP
from wraparc.batch.lane_slots import (
    END_AT,
    FINISHED,
    G_AT_FIRST,
    GOAL,
    J_11,
    J_12,
    J_21,
    J_22,
    LENGTH,
    LOG_AT_FIRST,
    LOG_LAST,
    LOG_TENSION,
    MISS,
    MISS_2,
    MISS_2_LAST,
    MISS_LAST,
    PULL,
    SHEAR,
    SLOPE,
    SMALLEST,
    STEEPEST,
    SUM_AT_FIRST,
    TRACTION,
    Z_LAST,
    G,
    S,
    X,
    Z,
)

NEAR = 1e-11  # of a miss, where a search ends
FAR = 1e30
ASTRAY = 30.0  # a miss, as a logarithm, of a try that led nowhere
ASIDE = 1e-4  # of z and of ln T1, to see how the misses change


def miss_arc(w: Lanes) -> None:
    """MISS is that of s = L at the exit tension, ln(s/L)."""
    n = lanes()
    for i in range(n):
        w[MISS, i] = full_ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])


def miss_goal(w: Lanes, nodes: Lanes, of_slip: float) -> None:
    """MISS: of the creep, or if `of_slip` is 1 the slip, at the exit; MISS_2: of the pull."""
    n = lanes()
    o = SIXTH_STEP * MOST_SIXTH + 1 + 4 * PLACE
    for i in range(n):
        x = w[X, i]
        r = x * nodes[o, i]
        form = r * (1.0 - full_ln(upper(r, SMALLEST)))
        value = x + (1.0 - of_slip) * w[SHEAR, i] * form * nodes[o + 6, i]
        w[STEEPEST, i] = upper(w[STEEPEST, i], r)
        w[MISS, i] = value / w[GOAL, i] - 1.0
        pull = full_ex(w[LOG_TENSION, i]) * (1.0 - full_ex(-w[END_AT, i]))
        w[MISS_2, i] = full_ln(upper(pull, SMALLEST) / w[PULL, i])


def miss_cut(w: Lanes, of_slip: float) -> None:
    """`miss_goal` after a march whose steps are cut."""
    n = lanes()
    for i in range(n):
        value = w[X, i] + (1.0 - of_slip) * w[SHEAR, i] * w[TRACTION, i]
        met = (w[FINISHED, i] > 0.5) & (w[FINISHED, i] < 1.5)
        w[STEEPEST, i] = 0.0  # no peak is too steep
        w[MISS, i] = select(met, value / w[GOAL, i] - 1.0, 2.0 * FAR)
        pull = full_ex(w[LOG_TENSION, i]) * (1.0 - full_ex(-w[END_AT, i]))
        w[MISS_2, i] = full_ln(upper(pull, SMALLEST) / w[PULL, i])


def size_of(miss: Number) -> Number:
    """Magnitude."""
    return upper(miss, -miss)


def correct(w: Lanes) -> bool:
    """One step of z towards no MISS, a secant after the first; whether any lane is on its way.

    z is the logarithm of (g + x_c/l) over its first value.
    """
    n = lanes()
    left = 0
    for i in range(n):
        z, miss = w[Z, i], w[MISS, i]
        here = size_of(miss) <= NEAR
        secant = (miss - w[MISS_LAST, i]) / (z - w[Z_LAST, i])
        # not before there are two tries
        sound = (secant * w[SLOPE, i] > 0.0) & (size_of(secant) < FAR)
        sound &= size_of(w[MISS_LAST, i]) < ASTRAY
        slope = select(sound, secant, w[SLOPE, i])
        w[SLOPE, i] = slope
        w[MISS_LAST, i], w[Z_LAST, i] = miss, select(here, w[Z_LAST, i], z)
        z = select(here, z, z - lower(upper(miss / slope, -1.0), 1.0))
        w[Z, i] = z
        w[G, i] = w[G_AT_FIRST, i] + w[SUM_AT_FIRST, i] * (full_ex(z) - 1.0)
        left = left + select(here | (size_of(miss) >= FAR), 0, 1)
    return anywhere(left > 0)


def correct_both(w: Lanes, tries: int) -> bool:
    """One step of z and ln T1 towards no MISS and no MISS_2; whether any lane is on its way.

    The second and the third try are to see how the misses change; then Newton's method, its
    Jacobian kept up to date by Broyden's formula.
    """
    n = lanes()
    left = 0
    for i in range(n):
        m1, m2 = w[MISS, i], w[MISS_2, i]
        z, t = w[Z, i], w[LOG_TENSION, i]
        here = (upper(size_of(m1), size_of(m2)) <= NEAR) & (tries > 2)
        if tries > 2:
            dz, dt = z - w[Z_LAST, i], t - w[LOG_LAST, i]
            square = upper(dz * dz + dt * dt, SMALLEST)
            j11, j12, j21, j22 = w[J_11, i], w[J_12, i], w[J_21, i], w[J_22, i]
            e1 = (m1 - w[MISS_LAST, i] - j11 * dz - j12 * dt) / square
            e2 = (m2 - w[MISS_2_LAST, i] - j21 * dz - j22 * dt) / square
            w[J_11, i], w[J_12, i] = j11 + e1 * dz, j12 + e1 * dt
            w[J_21, i], w[J_22, i] = j21 + e2 * dz, j22 + e2 * dt
        if tries == 1:
            w[J_11, i] = (m1 - w[MISS_LAST, i]) / ASIDE
            w[J_21, i] = (m2 - w[MISS_2_LAST, i]) / ASIDE
        elif tries == 2:
            w[J_12, i] = (m1 - w[MISS_LAST, i]) / ASIDE
            w[J_22, i] = (m2 - w[MISS_2_LAST, i]) / ASIDE
            z, t = 0.0 * z, w[LOG_AT_FIRST, i]  # from the first try
            m1, m2 = w[MISS_LAST, i], w[MISS_2_LAST, i]
        if tries == 0:
            new_z, new_t = z + ASIDE, t
        elif tries == 1:
            new_z, new_t = 0.0 * z, w[LOG_AT_FIRST, i] + ASIDE
            m1, m2 = w[MISS_LAST, i], w[MISS_2_LAST, i]
        else:
            det = w[J_11, i] * w[J_22, i] - w[J_12, i] * w[J_21, i]
            new_z = z + (m2 * w[J_12, i] - m1 * w[J_22, i]) / det
            new_t = t + (m1 * w[J_21, i] - m2 * w[J_11, i]) / det
        w[MISS_LAST, i], w[MISS_2_LAST, i] = m1, m2
        w[Z_LAST, i], w[LOG_LAST, i] = z, t
        new_z = select(here, w[Z, i], new_z)
        w[Z, i], w[LOG_TENSION, i] = new_z, select(here, w[LOG_TENSION, i], new_t)
        w[G, i] = w[G_AT_FIRST, i] + w[SUM_AT_FIRST, i] * (full_ex(new_z) - 1.0)
        left = left + select(here | (size_of(m1) >= FAR), 0, 1)
    return anywhere(left > 0)
