"""Numbers read off a marched profile: order, peak shear stress, active arc, share outside tests.

Plain numbers and buffers only, like the march: compiled for batches. A profile is `count` records
of (s, q, slip, creep, shear stress, friction work, kink), see :mod:`wraparc.arc.march`.
"""

from __future__ import annotations

from math import exp

from wraparc.arc.march import P1, RECORD, Buffer, Parameters


def sort(out: Buffer, count: int) -> None:
    """Put records in order of s (insertion sort: they are nearly in order)."""
    for i in range(1, count):
        j = i
        while j > 0 and out[RECORD * j] < out[RECORD * (j - 1)]:
            a, b = RECORD * j, RECORD * (j - 1)
            for k in range(RECORD):
                out[a + k], out[b + k] = out[b + k], out[a + k]
            j -= 1


def peak_stress(out: Buffer, count: int) -> tuple[float, float]:
    """Largest magnitude of shear stress [Pa] and where it is, s [m].

    Inside the arc it is the vertex of the parabola through the largest record and its neighbours;
    kinks of the law are records themselves.
    """
    best = 0
    for i in range(1, count):
        if abs(out[RECORD * i + 4]) > abs(out[RECORD * best + 4]):
            best = i
    s, t = out[RECORD * best], abs(out[RECORD * best + 4])
    if 0 < best < count - 1 and out[RECORD * best + 6] == 0.0:
        a = out[RECORD * (best - 1)] - s
        b = out[RECORD * (best + 1)] - s
        fa = abs(out[RECORD * (best - 1) + 4]) - t
        fb = abs(out[RECORD * (best + 1) + 4]) - t
        if a < 0.0 < b and fa < 0.0 and fb < 0.0:
            # t + m y + k y^2 through both neighbours
            k = (fb / b - fa / a) / (b - a)
            m = fa / a - k * a
            y = -0.5 * m / k
            if a < y < b:
                return t - 0.25 * m * m / k, s + y
    return t, s


def active_length(out: Buffer, count: int) -> float:
    """Length of the exit part of the arc that takes 99 % of the tension change [m]."""
    end = RECORD * (count - 1)
    change = 1.0 - exp(out[end + 1])
    if change == 0.0:
        return 0.0
    i = count - 1
    while i > 0 and (1.0 - exp(out[RECORD * i + 1])) / change > 0.01:
        i -= 1
    if i == count - 1:
        return 0.0
    a = (1.0 - exp(out[RECORD * i + 1])) / change
    b = (1.0 - exp(out[RECORD * (i + 1) + 1])) / change
    w = (0.01 - a) / (b - a)
    s = out[RECORD * i] + w * (out[RECORD * (i + 1)] - out[RECORD * i])
    return out[end] - s


def share_outside(
    par: Parameters,
    out: Buffer,
    count: int,
    pressure_min: float,
    pressure_max: float,
    slip_max: float,
) -> float:
    """Fraction of the arc where pressure or slip lies outside the tested range.

    Crossings are interpolated linearly between records.
    """
    outside = 0.0
    for i in range(count - 1):
        a, b = RECORD * i, RECORD * (i + 1)
        low, high = 0.0, 1.0
        p0, p1 = par[P1] * exp(out[a + 1]), par[P1] * exp(out[b + 1])
        x0, x1 = abs(out[a + 2]), abs(out[b + 2])
        for f0, f1 in (
            (pressure_min - p0, pressure_min - p1),
            (p0 - pressure_max, p1 - pressure_max),
            (x0 - slip_max, x1 - slip_max),
        ):
            if f0 > 0.0 and f1 > 0.0:
                high = -1.0
            elif f0 > 0.0:
                low = max(low, f0 / (f0 - f1))
            elif f1 > 0.0:
                high = min(high, f0 / (f0 - f1))
        outside += (out[b] - out[a]) * (1.0 - max(high - low, 0.0))
    return outside / (out[RECORD * (count - 1)] - out[0])
