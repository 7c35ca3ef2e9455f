"""Numbers read off a marched profile: order, peak stress, active arc, slip, share outside tests.

Plain numbers and buffers only, like the march: compiled for batches. A profile is `count` records
of (s, q, slip, creep, shear stress, friction work), see :mod:`wraparc.arc.kernel.march`.
"""

from __future__ import annotations

from math import exp, expm1, nan, sqrt

from wraparc.arc.kernel.layer_march import friction_of_creep
from wraparc.arc.kernel.quantities import RECORD, Buffer, Parameters
from wraparc.friction.compact import CompactLaw, branch_of, friction_at, segment_of

GOLDEN = 0.6180339887498949
PEAK_TOLERANCE = 1e-6  # relative, of a cubic's vertex


def sort(out: Buffer, count: int) -> None:
    """Put records in order of s (insertion sort: they are nearly in order)."""
    for i in range(1, count):
        j = i
        while j > 0 and out[RECORD * j] < out[RECORD * (j - 1)]:
            a, b = RECORD * j, RECORD * (j - 1)
            for k in range(RECORD):
                out[a + k], out[b + k] = out[b + k], out[a + k]
            j -= 1


def peak_stress(
    law: CompactLaw, par: Parameters, g: float, out: Buffer, count: int
) -> tuple[float, float]:
    """Largest magnitude of shear stress [Pa] and where it is, s [m].

    Between the largest record and its neighbours, where stress rises and falls again; kinks of the
    law are records themselves.
    """
    best = 0
    for i in range(1, count):
        if abs(out[RECORD * i + 4]) > abs(out[RECORD * best + 4]):
            best = i
    most, where = abs(out[RECORD * best + 4]), out[RECORD * best]
    for i in (best - 1, best):
        if i < 0 or i + 1 >= count:
            continue
        a, b = RECORD * i, RECORD * (i + 1)
        f, there = _peak_between(law, par, g, out, a, b)
        if there > most:
            most, where = there, out[a] + f * (out[b] - out[a])
    return most, where


def _peak_between(
    law: CompactLaw, par: Parameters, g: float, out: Buffer, a: int, b: int
) -> tuple[float, float]:
    """Fraction of the way between two records at which stress is largest, and the stress [Pa].

    The vertex of the cubic with the slopes at both ends, if the stress there is that of the cubic;
    else, in a steep cell of a table, golden section.
    """
    h, sign = out[b] - out[a], 1.0 if out[a + 4] + out[b + 4] > 0.0 else -1.0
    if h <= 0.0 or sign * out[a + 4] <= 0.0 or sign * out[b + 4] <= 0.0:
        return 0.0, 0.0
    start = h * sign * _stress_slope(law, par, g, out, a, b, a)
    end = h * sign * _stress_slope(law, par, g, out, a, b, b)
    if not start > 0.0 or not end < 0.0:
        return 0.0, 0.0
    # slope start + m f + k f^2 at the fraction f of the way
    rise = sign * (out[b + 4] - out[a + 4])
    m, k = 6.0 * rise - 4.0 * start - 2.0 * end, 3.0 * (start + end) - 6.0 * rise
    f = 2.0 * start / (-m + sqrt(max(m * m - 4.0 * k * start, 0.0)))
    vertex = sign * out[a + 4] + f * (start + f * (0.5 * m + f * k / 3.0))
    there = _stress_between(law, par, g, out, a, b, f)
    if abs(there - vertex) <= PEAK_TOLERANCE * vertex:
        return f, there
    low, high = 0.0, 1.0
    c, d = 1.0 - GOLDEN, GOLDEN
    at_c = _stress_between(law, par, g, out, a, b, c)
    at_d = _stress_between(law, par, g, out, a, b, d)
    for _ in range(40):
        if at_c >= at_d:
            high, d, at_d = d, c, at_c
            c = high - GOLDEN * (high - low)
            at_c = _stress_between(law, par, g, out, a, b, c)
        else:
            low, c, at_c = c, d, at_d
            d = low + GOLDEN * (high - low)
            at_d = _stress_between(law, par, g, out, a, b, d)
    return (c, at_c) if at_c >= at_d else (d, at_d)


def _stress_between(
    law: CompactLaw, par: Parameters, g: float, out: Buffer, a: int, b: int, f: float
) -> float:
    """Magnitude of shear stress at a fraction of the way between two records [Pa].

    Of the creep and the tension there, which are smooth whatever the law is: cubics with slopes.
    """
    e, h = 1.0 - f, out[b] - out[a]
    near, far = e * e * (1.0 + 2.0 * f), f * f * (3.0 - 2.0 * f)
    to_a, to_b = e * e * f * h, -f * f * e * h
    q, u = near * out[a + 1] + far * out[b + 1], near * out[a + 3] + far * out[b + 3]
    for at, part in ((a, to_a), (b, to_b)):
        tension = par.entry_tension * exp(out[at + 1])
        q -= part * out[at + 4] * par.width / tension
        u += part * (g + (par.entry_tension - tension) * par.compliance)
    tau, _ = friction_of_creep(law, par, par.entry_tension * exp(q), u)
    return abs(tau)


def _stress_slope(
    law: CompactLaw, par: Parameters, g: float, out: Buffer, a: int, b: int, at: int
) -> float:
    """D tau/ds [Pa/m] at one end of the way between two records, in the piece of law between."""
    q, tau, slip = out[at + 1], out[at + 4], 0.5 * (out[a + 2] + out[b + 2])
    w = g + par.entry_tension * -expm1(q) * par.compliance
    if slip == 0.0:
        return w / par.shear if par.shear > 0.0 else 0.0
    sign = 1.0 if slip > 0.0 else -1.0
    between = par.entry_pressure * exp(0.5 * (out[a + 1] + out[b + 1]))
    segment = segment_of(law, between)
    branch = branch_of(law, segment, sign * slip, between)
    p = par.entry_pressure * exp(q)
    mu, mu_x, mu_p = friction_at(law, segment, branch, sign * out[at + 2], p)
    # tau = mu(x, p) p with x = u - c tau and p' = -tau/R
    turn = -sign * (mu + p * mu_p) * tau / par.radius
    return (p * mu_x * w + turn) / (1.0 + par.shear * p * mu_x)


def active_length(out: Buffer, count: int) -> float:
    """Length of the exit part of the arc that takes 99 % of the tension change [m]."""
    end = RECORD * (count - 1)
    change = -expm1(out[end + 1])
    if change == 0.0:
        return 0.0
    i = count - 1
    while i > 0 and -expm1(out[RECORD * i + 1]) / change > 0.01:
        i -= 1
    if i == count - 1:
        return 0.0
    a = -expm1(out[RECORD * i + 1]) / change
    b = -expm1(out[RECORD * (i + 1) + 1]) / change
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
