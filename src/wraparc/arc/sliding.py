"""The pull at which a belt slides: plain numbers only, see `checks.numbers`.

A belt slides at the first of three: a creep of `SLIDES`, the end of what the lagging was tested to,
the largest friction of the law. What a law says beyond them is an extrapolation, and no capacity.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, inf, isnan, log, nan
from typing import NamedTuple

from wraparc.arc.answer import operating_point
from wraparc.arc.capacity import CREEP_LIMIT as BY_CREEP
from wraparc.arc.capacity import GROSS_SLIP as BY_LAW
from wraparc.arc.capacity import TESTED_SLIP as BY_SLIP
from wraparc.arc.capacity import (
    Limit,
    carry,
    carry_along,
    find_capacities,
    least_slack,
    log_ratio,
    sides,
)
from wraparc.arc.collocation import CREEP as CREEP_KIND
from wraparc.arc.collocation import SLIP as SLIP_KIND
from wraparc.arc.gross_slip import Line, plateau_capacity
from wraparc.arc.meet import Met
from wraparc.arc.quantities import SOLVED, Geometry, Load
from wraparc.drive import CREEP_LIMIT
from wraparc.friction.compact import CompactLaw, plateau_at, segment_of

#: Creep beyond which a belt slides and does not creep any more: ten customary limits [m]; ours.
SLIDES = 10.0 * CREEP_LIMIT
#: What comes first.
CREEP, TESTED, MOST = 0, 1, 2
#: The most that is told of a pull which no creep carries, over that pull [-].
NOT_CARRIED = 0.999
#: Relative difference of two capacities that is rounding.
ALIKE = 1e-6
EARLY = 0.8  # of `SLIDES`: where the tests end before, they come first
ROUNDS, FARTHEST = 60, 200.0  # of a search, and how far it goes
DIFFERENCE = 1e-3  # of a tension, for a slope
_NEAR = 1e-8  # last step over the place
LEAST_CARRIED = 1e-9  # ln(tight/slack) where an overrun takes all that friction could carry [-]


class Loaded(NamedTuple):
    """An arc that is asked when its belt slides."""

    law: CompactLaw
    geometry: Geometry
    load: Load
    peaks: bool  # whether friction may have its largest ratio at some creep


class Sliding(NamedTuple):
    """Where a belt slides."""

    place: float  # on the line; inf where it never does, nan where that is not found
    cause: int  # CREEP, TESTED or MOST


def carried_at(of: Loaded, tight: float) -> tuple[float, int]:
    """Largest ln(tight/slack) before the belt slides with a tight side held [N], and the cause."""
    driving = of.geometry.side > 0.0
    load = of.load._replace(
        entry_tension=tight if driving else 0.5 * tight,
        exit_tension=0.5 * tight if driving else tight,
        creep_limit=SLIDES,
    )
    most = _most_at(of, tight)
    parts = BY_CREEP + BY_SLIP + (BY_LAW if of.peaks else 0)
    if not of.peaks and _tests_end_first(of, tight):
        parts = BY_SLIP
    found = find_capacities(of.law, of.geometry, load, parts)
    q, cause = found.creep_limit, CREEP
    if isnan(q) or found.tested_slip < q * (1.0 - ALIKE):
        q, cause = found.tested_slip, TESTED
    if q >= most * (1.0 - ALIKE) or (of.peaks and q >= found.gross_slip * (1.0 - ALIKE)):
        cause = MOST
    return q, cause


def _most_at(of: Loaded, tight: float) -> float:
    """ln(tight/slack) with the largest friction everywhere, for a tension of the tight side [N]."""
    pressure = tight / (of.geometry.width * of.geometry.radius)
    return plateau_capacity(of.law, pressure, of.geometry.wrap_angle)


def _tests_end_first(of: Loaded, tight: float) -> bool:
    """Whether the tested slip ends well before the creep of sliding."""
    pressure = tight / (of.geometry.width * of.geometry.radius)
    friction = plateau_at(of.law, segment_of(of.law, pressure), pressure)
    # the creep at the end of the tests is their slip and what the lagging shears
    return of.load.slip_max + of.geometry.shear * friction * pressure < EARLY * SLIDES


class AtLimit(NamedTuple):
    """What ends the grip of a law that does not fall, and the arc there with its tight side."""

    limit: Limit
    cause: int
    met: Met


def at_limits(of: Loaded) -> list[AtLimit]:
    """What ends the grip of an arc, whichever comes first; nothing of a law that falls."""
    tight, found = max(of.load.entry_tension, of.load.exit_tension), []
    if of.peaks:
        return []
    if of.load.slip_max == of.load.slip_max:
        limit = Limit(SLIP_KIND, of.load.slip_max)
        found.append(AtLimit(limit, TESTED, carry(of.law, of.geometry, tight, limit)))
    if not _tests_end_first(of, tight):
        limit = Limit(CREEP_KIND, SLIDES)
        found.append(AtLimit(limit, CREEP, carry(of.law, of.geometry, tight, limit)))
    return found


def slide_place(of: Loaded, line: Line, way: float, low: float, start: float) -> Sliding:
    """Place k of a line at which the belt begins to slide (way 1) or ends to (way -1).

    The root of ln(T_tight(k)/T_slack(k)) = q(T_tight(k)) from `low` upwards, by secants in a
    bracket, from `start`: in ln k, over which the logarithms of both sides are nearly straight, or
    where the slack side falls or is sought in k, over which T_slack - T_tight exp(-q) is. Inf if
    there is none up to `FARTHEST`.
    """
    falls = line.slack_rise < 0.0
    even = falls or way < 0.0
    ends = Bracket(low, inf)
    if line.slack_rise != 0.0:  # beyond it there is no slack side
        end = 1.0 - line.slack / line.slack_rise
        ends = Bracket(low, end) if falls else Bracket(max(low, end), inf)
    k = 0.5 * (ends.low + ends.high) if start >= ends.high else start
    last, spare_last, cause = nan, nan, CREEP
    for _ in range(ROUNDS):
        q, cause = carried_at(of, line.tight + (k - 1.0) * line.tight_rise)
        if isnan(q):
            return Sliding(nan, cause)
        at, spare, slope = _spare(of, line, k, q, even)
        if last == last and at != last:
            slope = (spare - spare_last) / (at - last)
        if (spare < 0.0) == (way > 0.0):
            ends = Bracket(ends.low, k)
        elif k >= FARTHEST:
            return Sliding(inf, cause)
        else:
            ends = Bracket(k, ends.high)
        last, spare_last = at, spare
        new = at - spare / slope if way * slope < 0.0 else inf
        if not even:
            new = exp(min(new, 30.0))
        if abs(new - k) <= _NEAR * k:
            return Sliding(new, cause)
        new = _within(ends, new, k)
        if abs(new - k) <= 1e-14 * k:
            return Sliding(new, cause)
        k = new
    return Sliding(k, cause)


class Bracket(NamedTuple):
    """Between which a place lies."""

    low: float
    high: float


def _within(ends: Bracket, new: float, k: float) -> float:
    """A step to `new`, kept between the ends."""
    new = min(new, FARTHEST)
    if ends.low < new < ends.high:
        return new
    return 0.5 * (ends.low + ends.high) if ends.high < inf else min(4.0 * k + 1.0, FARTHEST)


def _spare(of: Loaded, line: Line, k: float, q: float, even: bool) -> tuple[float, float, float]:
    """What friction has to spare at a place of a line, over what, and about its slope."""
    tight = line.tight + (k - 1.0) * line.tight_rise
    slack = line.slack + (k - 1.0) * line.slack_rise
    if even:
        kept = exp(-q)
        return k, slack - tight * kept, line.slack_rise - line.tight_rise * kept
    asked, area = log(tight / slack), of.geometry.width * of.geometry.radius
    wrap = of.geometry.wrap_angle
    # friction at the creep of sliding falls with pressure about as the largest friction does
    here = plateau_capacity(of.law, tight / area, wrap)
    there = plateau_capacity(of.law, tight * (1.0 + DIFFERENCE) / area, wrap)
    fall = (there - here) / (here * DIFFERENCE) * k * line.tight_rise / tight
    grows = k * (line.tight_rise / tight - line.slack_rise / slack) / asked
    return log(k), log(max(q, LEAST_CARRIED) / asked), fall - grows


def pull_at_sliding(of: Loaded, line: Line, begin: Sequence[AtLimit]) -> Sliding:
    """Pull at which the belt slides over the pull, tensions growing along a line.

    `begin` is what `at_limits` says of the arc.
    """
    if line.tight == line.slack:
        return Sliding(inf, CREEP)
    first = Sliding(inf, CREEP)
    for limit, cause, first_met in begin:
        place, met = carry_along(of.law, of.geometry, line, limit, first_met)
        if not place > 0.0:  # not found so
            return slide_place(of, line, 1.0, 0.0, 1.0)
        tight = sides(of.geometry, met)[0]
        exhausted = log_ratio(of.geometry, met) >= _most_at(of, tight) * (1.0 - ALIKE)
        if place < first.place * (1.0 - ALIKE):
            first = Sliding(place, MOST if exhausted else cause)
    return slide_place(of, line, 1.0, 0.0, 1.0) if first.place == inf else first


def tight_at_sliding(of: Loaded, pull: float, begin: Sequence[AtLimit]) -> float:
    """Least tension of the tight side with which a pull does not slide the belt [N]; inf if none.

    Sought up to 200 times the pull; `begin` as for `pull_at_sliding`.
    """
    if pull <= 0.0:
        return 0.0
    tight, needed = max(of.load.entry_tension, of.load.exit_tension), 0.0
    for limit, _, met in begin:
        slack = least_slack(of.law, of.geometry, pull, limit, met, FARTHEST * pull).slack
        needed = max(needed, slack + pull) if slack == slack and needed == needed else nan
    if needed > 0.0:
        return needed
    # in units of the pull: T = k pull
    line = Line(pull, 0.0, pull, pull)
    return pull * slide_place(of, line, -1.0, 1.0, max(tight / pull, 1.0 + 1e-6)).place


def with_friction(geometry: Geometry, factor: float) -> Geometry:
    """Return the geometry whose answers are those of an arc with a factor on its friction.

    An arc under f mu is one under mu of f times the wrap, with a belt of 1/f and a lagging of f
    times the compliance: exact.
    """
    return geometry._replace(
        wrap_angle=factor * geometry.wrap_angle,
        compliance=geometry.compliance / factor,
        shear=factor * geometry.shear,
    )


def wet_creep(of: Loaded, factor: float) -> float:
    """Creep at the exit with a factor on the friction [m]; inf in gross slip, nan without a factor.

    Of rows `wraparc.batch.sliding.wet_creeps`.
    """
    if isnan(factor):
        return nan
    wet = with_friction(of.geometry, factor)
    found = operating_point(of.law, wet, of.load.entry_tension, of.load.exit_tension)
    return abs(found.met.course.creep[-1]) if found.outcome == SOLVED else inf


def lift_for_safety(
    of: Loaded, factor: float, tight_rise: float, begin: Sequence[AtLimit]
) -> float:
    """How much all tensions must rise for a safety factor against sliding [N].

    All tensions rise by the lift, and then with the pull of the whole drive, the tight side by
    `tight_rise` as it doubles [N].
    """
    tight = max(of.load.entry_tension, of.load.exit_tension)
    pull = abs(of.load.entry_tension - of.load.exit_tension)
    return tight_at_sliding(of, factor * pull, begin) - tight - (factor - 1.0) * tight_rise
