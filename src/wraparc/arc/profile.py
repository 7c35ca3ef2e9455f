"""Numbers read off a course: points, largest shear stress, active arc, share outside tests.

Everywhere by the polynomials of the solver; in front of the course by the closed form of a rest
arc. Records are five numbers a point: s [m], ln(T/T1), slip [m], creep [m], shear stress [Pa].
"""

from __future__ import annotations

from collections.abc import Callable
from math import exp, log, nan
from typing import NamedTuple

from wraparc.arc.collocation import (
    C0,
    C1,
    C2,
    KINK,
    compliance_of,
    held_stiffness,
    kinks,
    lag_length,
    overrun_at,
    state_at,
    traction_at,
)
from wraparc.arc.meet import Met, ratio_of
from wraparc.arc.quantities import Buffer, Geometry, jumps, zeros
from wraparc.arc.traction import Traction
from wraparc.drive.load_case import ROUNDING

RECORD = 5
#: Places between the ends of an element, and weights, of Lobatto's rule of four points.
LOBATTO, AT_ENDS, INSIDE = 0.27639320225002106, 1.0 / 12.0, 5.0 / 12.0
ACTIVE_SHARE = 0.01  # of the change of tension that lies before the active arc
HALVINGS, NEAR = 45, 1e-9  # of a place between two points; how near to an end a slope is looked at
ALIKE = 1e-12  # of the arc: places that are one
#: How near to a kink an element ends, and a little, as a fraction of it; where x' is looked at.
BESIDE = 1.2 * KINK
PLACES = (BESIDE, 0.25, 0.5, 0.75, 1.0 - BESIDE)
#: Share of the largest x' from which on a top beside it is looked for; parabolas; halvings.
ABOUT, NARROWER, SIDES = 0.9, 4, 24


class Point(NamedTuple):
    """A place on an arc.

    Attributes
    ----------
    place
        s from the entry [m].
    tension, creep, slip, stress
        T [N], u [m], x [m], tau [Pa].
    """

    place: float
    tension: float
    creep: float
    slip: float
    stress: float


def point_of(arc: Geometry, met: Met, i: int, c: float) -> Point:
    """Point at a fraction c of element i of the course."""
    at = met.course
    u, tension = state_at(arc, at, i, c)
    if i == 0 and c == 0.0:
        u, tension = at.creep[0], at.tension[0]
    felt = traction_of(arc, met, tension, u)
    place = met.rest + at.place[i] + c * (at.place[i + 1] - at.place[i])
    return Point(place, tension, u, felt.slip, felt.stress)


def traction_of(arc: Geometry, met: Met, tension: float, creep: float) -> Traction:
    """Traction at a tension [N] and a creep [m] of a course."""
    return traction_at(met.face, tension / (arc.width * arc.radius), creep)


def point_at_rest(arc: Geometry, met: Met, s: float) -> Point:
    """Point of a rest arc: held by the shear of the lagging alone, or by nothing that gives way."""
    at = met.course
    if arc.shear == 0.0:
        return Point(s, met.entry, 0.0, 0.0, 0.0)
    lag, overrun = lag_length(arc), overrun_at(arc, met.entry)[0]
    early, late = exp(-s / lag), exp((s - met.rest) / lag)
    creep = overrun * early + at.creep[0] * late
    taken = held_stiffness(arc) * (overrun * (1.0 - early) + at.creep[0] * late)
    return Point(s, met.entry - taken, creep, 0.0, creep / arc.shear)


def point_at(arc: Geometry, met: Met, s: float) -> Point:
    """Point at a place [m]."""
    if s < met.rest or met.course.place[-1] == 0.0:
        return point_at_rest(arc, met, s)
    places, low, high = met.course.place, 0, len(met.course.place) - 2
    while low < high:
        middle = (low + high + 1) // 2
        if places[middle] <= s - met.rest:
            low = middle
        else:
            high = middle - 1
    c = (s - met.rest - places[low]) / (places[low + 1] - places[low])
    return point_of(arc, met, low, min(max(c, 0.0), 1.0))


def samples(arc: Geometry, met: Met) -> list[Point]:
    """Points at the ends and the stages of all elements, and at the entry of a rest arc."""
    found = [] if met.rest == 0.0 else [point_at_rest(arc, met, 0.0)]
    at, length = met.course, arc.radius * arc.wrap_angle
    if at.place[-1] == 0.0:
        found.append(point_at_rest(arc, met, length))
        return found
    for i in range(len(at.place) - 1):
        found += [point_of(arc, met, i, c) for c in (0.0, C0, C1, C2)]
    found.append(point_of(arc, met, len(at.place) - 2, 1.0))
    return found


def records(arc: Geometry, met: Met, points: int) -> tuple[Buffer, int]:
    """Profile at equal parts of the wrap and at kinks of the law; records, and their number."""
    length, places = arc.radius * arc.wrap_angle, kink_places(arc, met)
    out, count, k = zeros(RECORD * (points + 2 * len(places) + 3)), 0, 0
    slides = met.rest > 0.0 and met.course.place[-1] > 0.0
    for j in range(points + 1):
        s = length * j / points
        while k < len(places) and places[k] < s - ALIKE * length:
            count = _record(met, out, count, point_at(arc, met, places[k]))
            k += 1
        while k < len(places) and places[k] < s + ALIKE * length:
            k += 1
        if slides and s > met.rest and out[RECORD * (count - 1)] < met.rest:
            # held up to there; where nothing gives way the stress sets in at once
            count = _record(met, out, count, point_at_rest(arc, met, met.rest))
            if arc.shear == 0.0:
                count = _record(met, out, count, point_of(arc, met, 0, 0.0))
        count = _record(met, out, count, point_at(arc, met, s))
    return out, count


def _record(met: Met, out: Buffer, count: int, at: Point) -> int:
    o = RECORD * count
    out[o], out[o + 1], out[o + 2] = at.place, log(at.tension / met.entry), at.slip
    out[o + 3], out[o + 4] = at.creep, at.stress
    return count + 1


def kink_places(arc: Geometry, met: Met) -> list[float]:
    """Where the course passes into another piece of the law [m]."""
    if met.course.place[-1] == 0.0:
        return []
    return [met.rest + where for where, turns in kinks(met.face, arc, met.course) if not turns]


def stuck_length(arc: Geometry, met: Met, along: list[Point]) -> float:
    """Length of the entry part of the arc over which the belt does not slip [m]."""
    if met.rest > 0.0 or not jumps(met.face.law) or along[0].slip != 0.0:
        return met.rest
    i = 0
    while i + 1 < len(along) and along[i + 1].slip == 0.0:
        i += 1
    if i + 1 == len(along):
        return along[i].place

    def held(s: float) -> bool:
        return point_at(arc, met, s).slip == 0.0

    return _border(held, along[i].place, along[i + 1].place)[0]


def _border(before: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    """Where between two places what holds at the first ends to hold: from below and above [m]."""
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if before(middle):
            low = middle
        else:
            high = middle
    return low, high


def loss_along(arc: Geometry, met: Met, along: list[Point]) -> float:
    """Int tau du along the arc by Lobatto's rule: of the course, at places of its own [J/m2]."""
    at, c, total = met.course, compliance_of(arc), 0.0
    for i in range(len(at.place) - 1):
        h = at.place[i + 1] - at.place[i]
        if h == 0.0:
            continue
        ends = (point_of(arc, met, i, 0.0), point_of(arc, met, i, 1.0))
        inner = (point_of(arc, met, i, LOBATTO), point_of(arc, met, i, 1.0 - LOBATTO))
        for weight, pair in ((AT_ENDS, ends), (INSIDE, inner)):
            for p in pair:
                total += weight * h * p.stress * (at.ratio - c * p.tension)
    if met.rest > 0.0 and arc.shear > 0.0:  # of the layers of a rest arc, in closed form
        end = at.creep[0]
        total += 0.5 / arc.shear * (end * end - along[0].creep * along[0].creep)
    return total


def peak_stress(arc: Geometry, met: Met, along: list[Point]) -> tuple[float, float]:
    """Largest magnitude of shear stress [Pa] and where it is, s [m].

    The largest of the points; or, where the stress rises and falls again beside it, where its slope
    ends.
    """
    best = 0
    for i in range(1, len(along)):
        if abs(along[i].stress) > abs(along[best].stress):
            best = i
    most, where = abs(along[best].stress), along[best].place
    for i in (best - 1, best):
        if i < 0 or i + 1 >= len(along) or along[i].place < met.rest:
            continue
        low, high = along[i].place, along[i + 1].place
        edge = NEAR * (high - low)
        f_low, f_high = _slope_at(arc, met, low + edge), _slope_at(arc, met, high - edge)
        if not (f_low > 0.0 > f_high):
            continue
        for _ in range(HALVINGS):
            share = min(max(f_low / (f_low - f_high), 0.05), 0.95)
            s = low + (high - low) * share
            f = _slope_at(arc, met, s)
            if f > 0.0:
                low, f_low, f_high = s, f, 0.5 * f_high
            else:
                high, f_high, f_low = s, f, 0.5 * f_low
            if high - low < edge:
                break
        at = point_at(arc, met, 0.5 * (low + high))
        if abs(at.stress) > most:
            most, where = abs(at.stress), at.place
    return most, where


def _slope_at(arc: Geometry, met: Met, s: float) -> float:
    """Slope of the magnitude of shear stress along the arc [Pa/m]."""
    at = point_at(arc, met, s)
    felt = traction_of(arc, met, at.tension, at.creep)
    growth = met.course.ratio - compliance_of(arc) * at.tension
    loss = felt.by_pressure * felt.stress / arc.radius
    return (1.0 if felt.stress >= 0.0 else -1.0) * (felt.by_creep * growth - loss)


def active_length(arc: Geometry, met: Met, along: list[Point]) -> float:
    """Length of the exit part of the arc that takes 99 % of the tension change [m]."""
    end = along[-1]
    change = met.entry - end.tension
    if abs(change) <= ROUNDING * met.entry:
        return 0.0
    i = len(along) - 1
    while i > 0 and (met.entry - along[i].tension) / change > ACTIVE_SHARE:
        i -= 1
    if i == len(along) - 1:
        return 0.0

    def idle(s: float) -> bool:
        return (met.entry - point_at(arc, met, s).tension) / change <= ACTIVE_SHARE

    return end.place - _border(idle, along[i].place, along[i + 1].place)[0]


class Range(NamedTuple):
    """A tested range: wrap pressures [Pa] and largest slip [m]."""

    pressure_min: float
    pressure_max: float
    slip_max: float


def share_outside(arc: Geometry, met: Met, along: list[Point], tested: Range) -> float:
    """Fraction of the arc where pressure or slip lies outside the tested range."""
    outside = 0.0
    for i in range(len(along) - 1):
        a, b = along[i], along[i + 1]
        low, high = a.place, b.place
        for kind in range(3):
            f_a, f_b = _beyond(arc, a, tested, kind), _beyond(arc, b, tested, kind)
            if f_a > 0.0 and f_b > 0.0:
                high = low - 1.0
            elif f_a > 0.0:
                low = max(low, _crossing(arc, met, a, b, tested, kind))
            elif f_b > 0.0:
                high = min(high, _crossing(arc, met, a, b, tested, kind))
        outside += b.place - a.place - max(high - low, 0.0)
    return outside / (along[-1].place - along[0].place)


def _beyond(arc: Geometry, at: Point, tested: Range, kind: int) -> float:
    """How far a point lies beyond one of the limits of a tested range, > 0 outside."""
    pressure = at.tension / (arc.width * arc.radius)
    if kind == 0:
        return tested.pressure_min - pressure
    if kind == 1:
        return pressure - tested.pressure_max
    return abs(at.slip) - tested.slip_max


def _crossing(arc: Geometry, met: Met, a: Point, b: Point, tested: Range, kind: int) -> float:
    """Where between two points a limit is crossed [m]."""
    outside = _beyond(arc, a, tested, kind) > 0.0

    def same(s: float) -> bool:
        return (_beyond(arc, point_at(arc, met, s), tested, kind) > 0.0) == outside

    low, high = _border(same, a.place, b.place)
    return 0.5 * (low + high)


class Read(NamedTuple):
    """What an arc says; see `Summary` and the row of a batch.

    Attributes
    ----------
    creep, slip, stress
        At the exit [m, m, Pa].
    entry_stress, creep_ratio
        tau and g at the entry [Pa, -].
    loss, miss
        int tau du [J/m2], by the balance of energy, and how far that along the course misses it.
    stuck, active
        Lengths of the rest arc and of the active arc [m].
    peak, peak_at
        Largest shear stress [Pa], and where [m].
    outside
        Share of the arc outside the tested range, nan without one [-].
    """

    creep: float
    slip: float
    stress: float
    entry_stress: float
    creep_ratio: float
    loss: float
    miss: float
    stuck: float
    active: float
    peak: float
    peak_at: float
    outside: float


def read(arc: Geometry, met: Met, tested: Range) -> Read:
    """Read an arc that is solved; `tested` is of nan without a tested range."""
    along = samples(arc, met)
    end, g, c = along[-1], entry_ratio(arc, met), compliance_of(arc)
    pull = met.entry - end.tension
    loss = pull * (g + 0.5 * pull * c) / arc.width
    peak, where = peak_stress(arc, met, along)
    outside = nan
    if tested.slip_max == tested.slip_max:
        outside = share_outside(arc, met, along, tested)
    return Read(
        met.course.creep[-1],
        end.slip,
        end.stress,
        along[0].stress,
        g,
        loss,
        abs(loss_along(arc, met, along) - loss),
        stuck_length(arc, met, along),
        active_length(arc, met, along),
        peak,
        where,
        outside,
    )


def along_slip(arc: Geometry, met: Met) -> tuple[float, float]:
    """Largest magnitude of slip along the arc [m], and of its growth per length [-]."""
    most = 0.0
    for at in samples(arc, met):
        most = max(most, abs(at.slip))
    return most, steepest_slip(arc, met)


def steepest_slip(arc: Geometry, met: Met) -> float:
    """Largest growth of slip per length along the arc [-].

    x' = u' - (h/G) tau' has a top of its own, or a jump where an element ends at a kink of the law:
    it is the larger one of both sides then.
    """
    n = len(met.course.place) - 1
    if met.course.place[-1] == 0.0:
        return 0.0
    rates = [[_slip_growth(arc, met, i, c) for c in PLACES] for i in range(n)]
    most = max(_slip_growth(arc, met, 0, NEAR), _slip_growth(arc, met, n - 1, 1.0))
    for part in rates:
        most = max(most, max(part))  # noqa: PLW3301
    for i in range(n):
        part = rates[i]
        for k in range(1, len(PLACES) - 1):
            if part[k] >= ABOUT * most and part[k] >= max(part[k - 1], part[k + 1]):
                most = max(most, _top_growth(arc, met, i, PLACES[k]))
        if i + 1 < n:
            before, behind = part[-1], rates[i + 1][0]
            if max(before, behind) >= (1.0 - BESIDE) * most and before != behind:
                most = max(most, _growth_at_kink(arc, met, i, before, behind))
    return most


def _slip_growth(arc: Geometry, met: Met, i: int, c: float) -> float:
    """Magnitude of x' at a fraction of an element [-]; 0 where the belt does not slip."""
    u, tension = state_at(arc, met.course, i, c)
    felt = traction_of(arc, met, tension, u)
    if felt.slip == 0.0:
        return 0.0
    growth = met.course.ratio - compliance_of(arc) * tension
    loss = felt.by_pressure * felt.stress / arc.radius
    return abs(growth - arc.shear * (felt.by_creep * growth - loss))


def _top_growth(arc: Geometry, met: Met, i: int, c: float) -> float:
    """Top of x' in an element beside a place: of parabolas through three that are ever closer."""
    most, wide = 0.0, PLACES[2] - PLACES[1]
    for _ in range(NARROWER):
        before, here, behind = (
            _slip_growth(arc, met, i, c - wide),
            _slip_growth(arc, met, i, c),
            _slip_growth(arc, met, i, c + wide),
        )
        most = max(most, before, here, behind)
        bend = before - 2.0 * here + behind
        if not bend < 0.0:
            break
        c += wide * min(max(0.5 * (before - behind) / bend, -0.5), 0.5)
        wide *= 0.25
        c = min(max(c, PLACES[0] + wide), PLACES[-1] - wide)
    return max(most, _slip_growth(arc, met, i, c))


def _growth_at_kink(arc: Geometry, met: Met, i: int, before: float, behind: float) -> float:
    """Larger x' of both sides of the kink beside the end of an element."""
    places = met.course.place
    wide, next_wide = places[i + 1] - places[i], places[i + 2] - places[i + 1]
    low, high = -BESIDE * wide, BESIDE * next_wide
    for _ in range(SIDES):
        middle = 0.5 * (low + high)
        j, c = (i, 1.0 + middle / wide) if middle < 0.0 else (i + 1, middle / next_wide)
        rate = _slip_growth(arc, met, j, c)
        if abs(rate - before) < abs(rate - behind):
            low, before = middle, rate
        else:
            high, behind = middle, rate
    return max(before, behind)


def entry_ratio(arc: Geometry, met: Met) -> float:
    """Entry creep ratio g [-]."""
    if met.rest == 0.0:
        return ratio_of(met.course, arc)
    if arc.shear == 0.0:
        return 0.0
    lag, overrun = lag_length(arc), overrun_at(arc, met.entry)[0]
    return (met.course.creep[0] * exp(-met.rest / lag) - overrun) / lag
