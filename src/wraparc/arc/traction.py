"""Traction of a lagging at a creep: slip and shear in series, for every friction law.

The creep u of the belt against the shell is the slip x of the law plus the shear of the lagging,

    u = x + c tau(u),    tau = mu(x, p) p,    c = h/G,

where the belt slides. A law that begins with a jump holds the belt while shear alone takes the
creep up: x = 0, tau = u/c, up to u = c mu(0+, p) p. Traction is odd in creep. It is single-valued
where c p dmu/dx > -1, which `WrapArc` asks of every arc; without shear (c = 0) a law that jumps is
set-valued at no creep.

One source runs in the interpreter and translated for the page: plain floats and named tuples only.
"""

from __future__ import annotations

from math import log, sqrt
from typing import NamedTuple

from wraparc.friction.compact import (
    ELASTIC,
    KNOT_STRIDE,
    KNOTS,
    LIMIT,
    LINE,
    PLASTIC,
    RESIDUAL,
    RISE,
    SMALLEST,
    TABLE,
    CompactLaw,
    friction_at,
    limit_at,
    peak,
    plateau_at,
    segment_of,
    tail,
)

#: Least slip over peak slip, and least creep [m], at which the slope of a law is taken: that of the
#: integral-log law grows without bound as the slip vanishes.
LEAST_SHARE, LEAST_CREEP = 1e-16, 1e-16
#: Relative accuracy of the slip; the change after which the next is as small as that (Halley's
#: method triples the digits); how near to the peak, 1 - r, the parabola there is a better guess.
ACCURACY, NEAR, NEAR_PEAK = 1e-15, 1e-5, 0.8
NEWTON = 1e-8  # the same of Newton's method, which doubles them


class Traction(NamedTuple):
    """Traction at a creep and a wrap pressure.

    Attributes
    ----------
    stress
        tau, with the sign of the creep [Pa].
    by_creep
        d tau/du at that pressure [Pa/m].
    by_pressure
        d tau/dp at that creep [-].
    slip
        x, with the sign of the creep [m].
    """

    stress: float
    by_creep: float
    by_pressure: float
    slip: float


class Piece(NamedTuple):
    """Slip, and the piece of a law that it lies in.

    Attributes
    ----------
    slip
        Magnitude of the slip [m]; 0 where the belt is held.
    branch
        Branch of the law, see :mod:`wraparc.friction.compact`; -1 where the belt is held.
    """

    slip: float
    branch: int


HELD = Piece(0.0, -1)


def traction(law: CompactLaw, shear: float, pressure: float, creep: float) -> Traction:
    """Traction at a creep of either sign. Most of the time of a solve is spent here and in `_rise`.

    Parameters
    ----------
    law
        The friction law.
    shear
        c = h/G of the lagging, >= 0 [m/Pa].
    pressure
        Wrap pressure, > 0 [Pa].
    creep
        u [m].
    """
    sign = 1.0 if creep >= 0.0 else -1.0
    whole = sign * creep
    size = LEAST_CREEP if whole < LEAST_CREEP else whole
    segment, ease, slip = segment_of(law, pressure), shear * pressure, -1.0
    mu, mu_x, mu_p = 0.0, 0.0, 0.0
    if law.kind == KNOTS and 0 <= segment < len(law.edges) - 1:
        # the common case, written out: `piece_at` and `friction_at` in one go
        c, o, t = law.coefficients, segment * KNOT_STRIDE, pressure - law.edges[segment]
        x1, x2, x3 = c[o + 1], c[o + 2], c[o + 3]
        m1, m2, m3 = c[o + 5], c[o + 6], c[o + 7]
        slip_pk = c[o] + t * (x1 + t * (x2 + t * x3))
        mu_pk = c[o + 4] + t * (m1 + t * (m2 + t * m3))
        if size - slip_pk - ease * mu_pk <= 0.0:
            slip = slip_pk * _rise(ease * mu_pk / slip_pk, size / slip_pk)
            r = slip / slip_pk
            if r < SMALLEST:
                r = SMALLEST
            lr = log(r)
            form, mu_x = r - r * lr, -mu_pk * lr / slip_pk
            mu, mu_p = mu_pk * form, (m1 + t * (2.0 * m2 + 3.0 * t * m3)) * form
            mu_p += mu_pk * lr * r * (x1 + t * (2.0 * x2 + 3.0 * t * x3)) / slip_pk
    if slip < 0.0:
        slip, branch = piece_at(law, segment, shear, pressure, size)
        if branch < 0:
            return Traction(creep / shear, 1.0 / shear, 0.0, 0.0)
        mu, mu_x, mu_p = friction_at(law, segment, branch, slip, pressure)
    stiff = 1.0 / (1.0 + ease * mu_x)
    scale = whole / size  # 1 but next to no creep, where traction is a straight line
    return Traction(
        sign * mu * pressure * scale,
        pressure * mu_x * stiff,
        sign * (mu + pressure * mu_p) * stiff * scale,
        sign * slip * scale,
    )


def piece_at(law: CompactLaw, segment: int, shear: float, pressure: float, creep: float) -> Piece:
    """Slip and branch of a law at a magnitude of creep, > 0 [m]: u = x + c mu(x, p) p inverted."""
    ease = shear * pressure
    if law.kind == LIMIT:
        return _under_limit(law, segment, ease, pressure, creep)
    if law.kind == TABLE:
        return _in_table(law, segment, ease, pressure, creep)
    slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
    hold = _hold(law, segment, pressure)
    mu_pk *= hold
    beyond = creep - slip_pk - ease * mu_pk
    if beyond <= 0.0:
        return Piece(slip_pk * _rise(ease * mu_pk / slip_pk, creep / slip_pk), RISE)
    slope, residual, _, _ = tail(law, segment, pressure)
    slope, residual = hold * slope, min(hold * residual, mu_pk)
    line = beyond / (1.0 + ease * slope)
    if mu_pk + slope * line >= residual:
        return Piece(slip_pk + line, LINE)
    return Piece(creep - ease * residual, RESIDUAL)


def branch_at(law: CompactLaw, segment: int, shear: float, pressure: float, creep: float) -> int:
    """Branch of a law at a magnitude of creep, > 0 [m]; -1 where the belt is held."""
    if law.kind in (LIMIT, TABLE):
        return piece_at(law, segment, shear, pressure, creep).branch
    slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
    hold, ease = _hold(law, segment, pressure), shear * pressure
    beyond = creep - slip_pk - ease * hold * mu_pk
    if beyond <= 0.0:
        return RISE
    slope, residual, _, _ = tail(law, segment, pressure)
    line = beyond / (1.0 + ease * hold * slope)
    return LINE if mu_pk + slope * line >= min(residual, mu_pk) else RESIDUAL


def _hold(law: CompactLaw, segment: int, pressure: float) -> float:
    """Share of friction that is left where traction is held, above the tested pressures [-]."""
    last = len(law.edges) - 1
    return law.edges[last] / pressure if segment >= last >= 0 else 1.0


def _rise(k: float, w: float) -> float:
    """Slip over peak slip r <= 1 on the rise of the integral-log law: r + k r (1 - ln r) = w.

    Halley's method, from what the slip would be at the slope for all of it; near the peak from the
    parabola there.
    """
    short = 1.0 + k - w
    near = 2.0 * short / (1.0 + sqrt(1.0 + 2.0 * k * short)) if short > 0.0 else 0.0
    r = 1.0 - near if near < NEAR_PEAK else w / (1.0 + k * (1.0 - log(min(w, 1.0))))
    for _ in range(30):
        lr = log(r)
        miss, slope = r + k * r * (1.0 - lr) - w, 1.0 - k * lr
        change = miss / (slope + 0.5 * miss * k / (r * slope))
        r -= change
        if r < LEAST_SHARE:
            r = LEAST_SHARE
        elif r > 1.0:
            r = 1.0
        if -NEAR * r <= change <= NEAR * r:
            break
    return r


def _under_limit(
    law: CompactLaw, segment: int, ease: float, pressure: float, creep: float
) -> Piece:
    """Of a law with a limit, reached elastically or at once."""
    limit = limit_at(law, segment, pressure)[0]
    onset = law.coefficients[3] * pressure
    if creep > (ease + onset) * limit:
        return Piece(creep - ease * limit, PLASTIC)
    if onset > 0.0:
        return Piece(creep * onset / (ease + onset), ELASTIC)
    return HELD if ease > 0.0 else Piece(creep, PLASTIC)


def _in_table(law: CompactLaw, segment: int, ease: float, pressure: float, creep: float) -> Piece:
    """Of a measured table: the cell whose creeps hold it, then Newton's method in a bracket."""
    c, slips, edges = law.coefficients, law.slips, law.edges
    cells, last = len(slips), len(edges) - 1
    o = 4 * cells * max(min(segment, last), 0)
    up, w = o, 0.0  # rows of the table below and above the pressure, and the share of the latter
    if 0 <= segment < last:
        up, w = o + 4 * cells, (pressure - edges[segment]) / (edges[segment + 1] - edges[segment])
    if segment >= last >= 0:
        ease *= edges[last] / pressure  # the traction is held
    before, cell = ease * (c[o] + w * (c[up] - c[o])), 0
    if creep <= before:
        return HELD
    after = before
    while cell < cells - 1:
        o, up = o + 4, up + 4
        after = slips[cell + 1] + ease * (c[o] + w * (c[up] - c[o]))
        if creep <= after:
            break
        before = after
        cell += 1
    if cell == cells - 1:
        return Piece(slips[cell] + creep - after, cell)
    low, high, start = slips[cell], slips[cell + 1], slips[cell]
    o, up = o - 4, up - 4
    c0, c1 = c[o] + w * (c[up] - c[o]), c[o + 1] + w * (c[up + 1] - c[o + 1])
    c2, c3 = c[o + 2] + w * (c[up + 2] - c[o + 2]), c[o + 3] + w * (c[up + 3] - c[o + 3])
    x = low + (high - low) * (creep - before) / (after - before)
    for _ in range(100):
        t = x - start
        miss = x + ease * (c0 + t * (c1 + t * (c2 + t * c3))) - creep
        low, high = (low, x) if miss > 0.0 else (x, high)
        slope = 1.0 + ease * (c1 + t * (2.0 * c2 + 3.0 * t * c3))
        new = x - miss / slope if slope > 0.0 else low
        inside = low < new < high
        if not inside:
            new = 0.5 * (low + high)
        change, x = abs(new - x), new
        if change <= (NEWTON if inside else ACCURACY) * x:
            break
    return Piece(x, cell)


def creep_of_slip(law: CompactLaw, shear: float, pressure: float, slip: float) -> float:
    """Creep u = x + c mu(x, p) p at a magnitude of slip, > 0 [m]."""
    return slip + shear * stress_of_slip(law, pressure, slip)[0]


def stress_of_slip(law: CompactLaw, pressure: float, slip: float) -> tuple[float, float]:
    """Traction mu(x, p) p at a magnitude of slip, > 0 [Pa], and its slope by p at that slip."""
    segment = segment_of(law, pressure)
    branch = piece_at(law, segment, 0.0, pressure, slip).branch
    mu, _, mu_p = friction_at(law, segment, branch, slip, pressure)
    return mu * pressure, mu + pressure * mu_p


def held_stress(law: CompactLaw, pressure: float) -> float:
    """Largest traction that a law holds without slip [Pa]; 0 of a law that rises from nothing."""
    segment = segment_of(law, pressure)
    branch = PLASTIC if law.kind == LIMIT else 0
    return friction_at(law, segment, branch, 0.0, pressure)[0] * pressure


def plateau_stress(law: CompactLaw, pressure: float) -> float:
    """Largest traction of a law at a pressure, at any slip [Pa]."""
    return plateau_at(law, segment_of(law, pressure), pressure) * pressure
