"""Numbers read off a marched profile: order, peak stress, active arc, slip, share outside tests.

Plain numbers and buffers only, like the march: compiled for batches. A profile is `count` records
of (s, q, slip, creep, shear stress, friction work, kink), see :mod:`wraparc.arc.kernel.march`.
"""

from __future__ import annotations

from math import exp, nan

from wraparc.arc.kernel.quantities import RECORD, Buffer, Parameters


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

    The vertex of the parabola through the largest record and its neighbours, or through the last
    three if the largest is the last; kinks of the law are records themselves.
    """
    best = 0
    for i in range(1, count):
        if abs(out[RECORD * i + 4]) > abs(out[RECORD * best + 4]):
            best = i
    s, t = out[RECORD * best], abs(out[RECORD * best + 4])
    i, j = best - 1, best + 1
    kink = out[RECORD * best + 6] == 1.0
    if best == count - 1:
        i, j = best - 2, best - 1
        kink = i >= 0 and out[RECORD * j + 6] == 1.0
    if i < 0 or kink:
        return t, s
    a, fa = out[RECORD * i] - s, abs(out[RECORD * i + 4]) - t
    b, fb = out[RECORD * j] - s, abs(out[RECORD * j + 4]) - t
    if a == 0.0 or b == 0.0 or a == b:
        return t, s
    # t + m y + k y^2 through both
    k = (fb / b - fa / a) / (b - a)
    m = fa / a - k * a
    if k >= 0.0:
        return t, s
    y = -0.5 * m / k
    if a < y < max(b, 0.0):
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
    w = (0.01 - a) / (b - a) if b != a else 1.0
    s = out[RECORD * i] + w * (out[RECORD * (i + 1)] - out[RECORD * i])
    return out[end] - s


def largest_slip(out: Buffer, count: int) -> float:
    """Largest magnitude of slip along the arc [m]."""
    most = 0.0
    for i in range(count):
        most = max(most, abs(out[RECORD * i + 2]))
    return most


def steepest_slip(out: Buffer, count: int, length: float) -> float:
    """Largest change of slip along the arc per length [-]; times the belt speed, the slip speed."""
    most = nan
    for i in range(count - 1):
        a, b = RECORD * i, RECORD * (i + 1)
        step = out[b] - out[a]
        if step > 1e-9 * length:  # records of a kink may coincide
            change = abs(out[b + 2] - out[a + 2]) / step
            most = change if most != most else max(most, change)
    return most


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
        p0, p1 = par.entry_pressure * exp(out[a + 1]), par.entry_pressure * exp(out[b + 1])
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
