"""The numeric form of a friction law that the solvers read: scalars and flat arrays only.

Every law hands over a :class:`CompactLaw`: a kind, the pressures where its pieces meet, and the
coefficients of the pieces. The functions below evaluate it for one slip and one pressure with both
derivatives. They are written for plain floats and anything that can be indexed, so that the same
source runs in the interpreter and translated for the page.

A *segment* is an interval of pressure: -1 below the lowest tested pressure, 0 .. n - 2 between the
n edges, n - 1 above the highest. A *branch* is an interval of slip. Friction has kinks only where
they meet.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, log
from typing import NamedTuple

Floats = Sequence[float]

LIMIT = 0  # traction limited by mu(p) after an elastic onset: constant, elastic-plastic, power
KNOTS = 1  # integral-log, peak friction and peak slip as cubics in pressure
PIECES = 2  # integral-log, A and b as trend lines in pressure
TABLE = 3  # measured table: cubics in slip, linear in pressure

RISE, LINE, RESIDUAL = 0, 1, 2  # branches of the integral-log law
ELASTIC, PLASTIC = 0, 1  # branches of a limit; one without elastic onset is always plastic

#: least slip over peak slip at which the logarithm is taken; a trial stage may ask for less
SMALLEST = 1e-16

#: floats per segment: 4 columns of 4 coefficients; pieces carry 2 form codes a column more, and
#: the unit of slip of A and b [m]
KNOT_STRIDE = 16
PIECE_STRIDE = 25


#: of a cell of a table, how far a cubic goes on beyond it: no kink is to fall inside a step
BEYOND_CELL = 0.1
#: Largest exponent of a slip at the peak, either way: a step that is tried may be far off a trend.
MOST_EXPONENT = 300.0


class CompactLaw(NamedTuple):
    """A friction law as numbers.

    Attributes
    ----------
    kind
        One of LIMIT, KNOTS, PIECES, TABLE.
    edges
        Pressures where the segments meet, ascending [Pa]; empty for a law without a tested range.
    coefficients
        The coefficients of the segments, one after the other (SI).
    slips
        Slips where the branches of a table meet, ascending from 0 [m]; empty otherwise.
    onset_compliance
        Slip per shear stress before the limit of an elastic-plastic law is reached [m/Pa].
    """

    kind: int
    edges: Floats
    coefficients: Floats
    slips: Floats = ()
    onset_compliance: float = 0.0


def segment_of(law: CompactLaw, pressure: float) -> int:
    """Segment of a pressure [Pa]: -1 below the first edge, n - 1 from the last edge on."""
    edges = law.edges
    n = len(edges)
    if n == 0 or pressure < edges[0]:
        return -1
    if pressure >= edges[n - 1]:
        return n - 1
    low, high = 0, n - 1
    while high - low > 1:
        middle = (low + high) // 2
        if pressure >= edges[middle]:
            low = middle
        else:
            high = middle
    return low


def _cubic(c: Floats, o: int, t: float) -> tuple[float, float]:
    """Value and derivative of the cubic with coefficients c[o:o+4] at t."""
    a1, a2, a3 = c[o + 1], c[o + 2], c[o + 3]
    return c[o] + t * (a1 + t * (a2 + t * a3)), a1 + t * (2.0 * a2 + 3.0 * t * a3)


def _trend(c: Floats, o: int, p: float) -> tuple[float, float]:
    """Value and derivative of a trend line f(c0 + c1 v + c2 v^2 + c3 v^3).

    v = p and f(y) = y, but c[o + 4] = 1 takes v = ln p, and c[o + 5] = +-1 takes f = +-exp.
    """
    logarithmic = c[o + 4] != 0.0
    v = log(p) if logarithmic else p
    y, dy = _cubic(c, o, v)
    if logarithmic:
        dy /= p
    if c[o + 5] != 0.0:
        y = c[o + 5] * exp(y)
        dy *= y
    return y, dy


def peak(law: CompactLaw, segment: int, pressure: float) -> tuple[float, float, float, float]:
    """Peak slip [m], peak friction [-] and their derivatives by pressure, integral-log laws."""
    edges, c = law.edges, law.coefficients
    last = len(edges) - 1
    if law.kind == KNOTS:
        if segment < 0:
            return c[0], c[4], 0.0, 0.0
        if segment >= last:
            segment, pressure = last - 1, edges[last]
        o = segment * KNOT_STRIDE
        t = pressure - edges[segment]
        slip, slip_p = _cubic(c, o, t)
        friction, friction_p = _cubic(c, o + 4, t)
        return slip, friction, slip_p, friction_p
    held = segment < 0
    if held:
        segment, pressure = 0, edges[0]
    elif segment >= last:
        segment, pressure = last - 1, edges[last]
    o = segment * PIECE_STRIDE
    a, a_p = _trend(c, o, pressure)
    b, b_p = _trend(c, o + 6, pressure)
    unit = c[o + 24]
    number = exp(min(max(b / a - 1.0, -MOST_EXPONENT), MOST_EXPONENT))
    if held:
        return unit * number, -a * number, 0.0, 0.0
    number_p = number * (b_p - b * a_p / a) / a
    return unit * number, -a * number, unit * number_p, -a_p * number - a * number_p


def tail(law: CompactLaw, segment: int, pressure: float) -> tuple[float, float, float, float]:
    """Post-peak slope [1/m], residual friction [-] and their derivatives by pressure."""
    kind, edges, c = law.kind, law.edges, law.coefficients
    last = len(edges) - 1
    held = segment < 0
    if held:
        if kind == KNOTS:
            return c[8], c[12], 0.0, 0.0
        segment, pressure = 0, edges[0]
    elif segment >= last:
        segment, pressure = last - 1, edges[last]
    if kind == KNOTS:
        o = segment * KNOT_STRIDE
        t = pressure - edges[segment]
        slope, slope_p = _cubic(c, o + 8, t)
        residual, residual_p = _cubic(c, o + 12, t)
    else:
        o = segment * PIECE_STRIDE
        slope, slope_p = _trend(c, o + 12, pressure)
        residual, residual_p = _trend(c, o + 18, pressure)
    if held:
        return slope, residual, 0.0, 0.0
    return slope, residual, slope_p, residual_p


def friction_at(
    law: CompactLaw, segment: int, branch: int, slip: float, pressure: float
) -> tuple[float, float, float]:
    """Friction of one piece of a law and its derivatives.

    Parameters
    ----------
    law
        The law.
    segment, branch
        The piece; it is continued smoothly where slip or pressure lie beyond it.
    slip
        Magnitude of the slip, > 0 for the integral-log law [m].
    pressure
        Wrap pressure [Pa].

    Returns
    -------
    mu, mu_x, mu_p
        Friction [-] and its derivatives by slip [1/m] and pressure [1/Pa]. Below the lowest edge
        friction is held, above the highest the traction mu p is held.
    """
    kind, edges, c = law.kind, law.edges, law.coefficients
    if kind == TABLE:
        return _table(law, segment, branch, slip, pressure)
    last = len(edges) - 1
    if kind == KNOTS and branch == RISE and 0 <= segment < last:
        # the common case, written out: `peak` and the formula below in one go
        o = segment * KNOT_STRIDE
        t = pressure - edges[segment]
        x1, x2, x3 = c[o + 1], c[o + 2], c[o + 3]
        m1, m2, m3 = c[o + 5], c[o + 6], c[o + 7]
        slip_pk = c[o] + t * (x1 + t * (x2 + t * x3))
        mu_pk = c[o + 4] + t * (m1 + t * (m2 + t * m3))
        r = slip / slip_pk
        if r < SMALLEST:
            r = SMALLEST
        lr = log(r)
        form = r - r * lr
        return (
            mu_pk * form,
            -mu_pk * lr / slip_pk,
            (m1 + t * (2.0 * m2 + 3.0 * t * m3)) * form
            + mu_pk * lr * r * (x1 + t * (2.0 * x2 + 3.0 * t * x3)) / slip_pk,
        )
    at = pressure
    if segment >= last and last >= 0:
        at = edges[last]
    elif segment < 0 and last >= 0:
        at = edges[0]
    if kind in (KNOTS, PIECES):
        slip_pk, mu_pk, slip_pk_p, mu_pk_p = peak(law, segment, pressure)
        if branch == RISE:
            r = max(slip / slip_pk, SMALLEST)
            lr = log(r)
            form = r - r * lr
            mu = mu_pk * form
            mu_x = -mu_pk * lr / slip_pk
            mu_p = mu_pk_p * form + mu_pk * lr * r * slip_pk_p / slip_pk
        else:
            slope, residual, slope_p, residual_p = tail(law, segment, pressure)
            if branch == LINE:
                d = slip - slip_pk
                mu = mu_pk + slope * d
                mu_x = slope
                mu_p = mu_pk_p + slope_p * d - slope * slip_pk_p
            else:
                mu_x = 0.0
                mu, mu_p = (residual, residual_p) if residual < mu_pk else (mu_pk, mu_pk_p)
    elif kind == LIMIT and branch == ELASTIC:
        mu_x = 1.0 / (c[3] * pressure)
        mu = slip * mu_x
        return mu, mu_x, -mu / pressure
    else:
        mu_x = 0.0
        mu, mu_p = _limit(c, at)
    return _held(law, segment, pressure, mu, mu_x, mu_p)


def _held(
    law: CompactLaw, segment: int, pressure: float, mu: float, mu_x: float, mu_p: float
) -> tuple[float, float, float]:
    """Friction held below the tested pressures, the traction held above them."""
    last = len(law.edges) - 1
    if last >= 0 and segment >= last:
        factor = law.edges[last] / pressure
        return mu * factor, mu_x * factor, -mu * factor / pressure
    if segment < 0 <= last:
        return mu, mu_x, 0.0
    return mu, mu_x, mu_p


def _limit(c: Floats, pressure: float) -> tuple[float, float]:
    """The limit mu_0 (p / p_0)^-n and its derivative by pressure."""
    if c[2] == 0.0:
        return c[0], 0.0
    at = max(pressure, 1e-12)  # a trial far off the solution may have no pressure left
    mu = c[0] * (at / c[1]) ** (-c[2])
    return mu, -c[2] * mu / at


def limit_at(law: CompactLaw, segment: int, pressure: float) -> tuple[float, float]:
    """Limit of friction [-] and its derivative by pressure [1/Pa], for a law with a limit."""
    last = len(law.edges) - 1
    at = pressure
    if last >= 0 and segment >= last:
        at = law.edges[last]
    elif segment < 0 <= last:
        at = law.edges[0]
    mu, mu_p = _limit(law.coefficients, at)
    mu, _, mu_p = _held(law, segment, pressure, mu, 0.0, mu_p)
    return mu, mu_p


def cell_of(slips: Floats, slip: float) -> int:
    """Cell of a table that a slip [m] lies in; the last one has no end."""
    cell = 0
    while cell < len(slips) - 1 and slip >= slips[cell + 1]:
        cell += 1
    return cell


def _table(
    law: CompactLaw, segment: int, branch: int, slip: float, pressure: float
) -> tuple[float, float, float]:
    """A measured table: a cubic in slip for each pressure, blended linearly in pressure.

    Well outside its cell a cubic goes on along its tangent: its own course knows no bounds.
    """
    edges, c, slips = law.edges, law.coefficients, law.slips
    last, cells = len(edges) - 1, len(slips)
    t = at = slip - slips[branch]
    if branch < cells - 1:  # the last cell is the constant past the last slip
        cell = slips[branch + 1] - slips[branch]
        if t > (1.0 + BEYOND_CELL) * cell:
            at = (1.0 + BEYOND_CELL) * cell
        elif t < -BEYOND_CELL * cell:
            at = -BEYOND_CELL * cell
    row = last if segment >= last else segment
    o = 4 * (max(row, 0) * cells + branch)
    c1, c2, c3 = c[o + 1], c[o + 2], c[o + 3]
    mu_x = c1 + at * (2.0 * c2 + 3.0 * at * c3)
    mu = c[o] + at * (c1 + at * (c2 + at * c3)) + mu_x * (t - at)
    if segment < 0 or last < 0:
        return mu, mu_x, 0.0
    if segment >= last:  # the traction is held
        factor = edges[last] / pressure
        return mu * factor, mu_x * factor, -mu * factor / pressure
    o += 4 * cells
    c1, c2, c3 = c[o + 1], c[o + 2], c[o + 3]
    high_x = c1 + at * (2.0 * c2 + 3.0 * at * c3)
    higher = c[o] + at * (c1 + at * (c2 + at * c3)) + high_x * (t - at) - mu
    width = edges[segment + 1] - edges[segment]
    w = (pressure - edges[segment]) / width
    return mu + w * higher, mu_x + w * (high_x - mu_x), higher / width


def branch_of(law: CompactLaw, segment: int, slip: float, pressure: float) -> int:
    """Branch that holds at a magnitude of slip [m] and a pressure [Pa]."""
    kind, c, slips = law.kind, law.coefficients, law.slips
    if kind == LIMIT:
        limit = plateau_at(law, segment, pressure) * pressure
        return ELASTIC if c[3] > 0.0 and slip < c[3] * limit else PLASTIC
    if kind == TABLE:
        return cell_of(slips, slip)
    slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
    if slip <= slip_pk:
        return RISE
    slope, residual, _, _ = tail(law, segment, pressure)
    if mu_pk + slope * (slip - slip_pk) < min(residual, mu_pk):
        return RESIDUAL
    return LINE


def plateau_at(law: CompactLaw, segment: int, pressure: float) -> float:
    """Largest friction a law offers at a pressure at any slip [-]."""
    kind, edges, slips = law.kind, law.edges, law.slips
    last = len(edges) - 1
    if kind in (KNOTS, PIECES):
        _, mu, _, _ = peak(law, segment, pressure)
        if last >= 0 and segment >= last:
            mu *= edges[last] / pressure
        return mu
    if kind == LIMIT:
        mu, _, _ = friction_at(law, segment, PLASTIC, 0.0, pressure)
        return mu
    best = 0.0
    for branch in range(len(slips)):
        mu, _, _ = friction_at(law, segment, branch, slips[branch], pressure)
        best = max(best, mu)
    return best


def residual_at(law: CompactLaw, segment: int, pressure: float) -> float:
    """Friction a law is left with at a pressure, at slips without bound [-]."""
    kind, edges, slips = law.kind, law.edges, law.slips
    last = len(edges) - 1
    if kind in (KNOTS, PIECES):
        _, mu, _, _ = peak(law, segment, pressure)
        slope, residual, _, _ = tail(law, segment, pressure)
        if slope < 0.0:
            mu = min(residual, mu)
        if last >= 0 and segment >= last:
            mu *= edges[last] / pressure
        return mu
    if kind == LIMIT:
        return plateau_at(law, segment, pressure)
    cell = len(slips) - 1
    mu, _, _ = friction_at(law, segment, cell, slips[cell], pressure)
    return mu


def excess_at(law: CompactLaw, segment: int, pressure: float) -> float:
    """Friction beyond the residual over all slips at a pressure, int (mu - mu_residual) dx [m].

    3/4 mu_pk x_pk is the integral up to the peak of an integral-log law.
    """
    kind, slips = law.kind, law.slips
    if kind == LIMIT:
        return 0.0
    left = residual_at(law, segment, pressure)
    if kind == TABLE:
        total = 0.0
        for cell in range(len(slips) - 1):
            width = slips[cell + 1] - slips[cell]
            # Gauss's rule of two points is exact for a cubic
            for place in (0.2113248654051871, 0.7886751345948129):
                slip = slips[cell] + place * width
                mu, _, _ = friction_at(law, segment, cell, slip, pressure)
                total += 0.5 * width * (mu - left)
        return total
    slip_pk, _, _, _ = peak(law, segment, pressure)
    slope, _, _, _ = tail(law, segment, pressure)
    top = plateau_at(law, segment, pressure)
    fall = top - left
    total = slip_pk * (0.75 * top - left)
    if fall > 0.0:
        hold = top / peak(law, segment, pressure)[1]
        total -= 0.5 * fall * fall / (slope * hold)
    return total
