"""What an arc could carry: the questions of capacity as end conditions of the same problem.

`carry` meets a limit of creep or slip at the exit with the tight side held (T1 driving, T2
braking); `least_slack` meets it with the pull held; `largest_ratio` is gross slip, in closed form
but where friction falls past its peak and carries most at a finite creep.
"""

from __future__ import annotations

from math import exp, expm1, inf, log, nan
from typing import NamedTuple

from wraparc.arc.collocation import (
    CREEP,
    MOST_USED,
    SLIP,
    Course,
    Ends,
    Interface,
    Slopes,
    mean_creep,
    traction_at,
)
from wraparc.arc.gross_slip import Line, outweighs, plateau_capacity, residual_capacity
from wraparc.arc.meet import Guess, Met, by_growth, interface, meet
from wraparc.arc.quantities import Geometry, Load
from wraparc.arc.traction import plateau_stress
from wraparc.friction.compact import CompactLaw

MISFIT = 1e-5  # that is let stand: tensions are a hundred times as good
LARGEST_FALL = 6.0  # of ln T, of a first guess
HIGHEST = 1e3  # times the tight side, where no largest pressure is given
LEAST_OVER = 1e-4  # of ln tight-side tension above the pull, where slack-side tension ends
DEEPEST = 3.0  # of ln tension below the largest one that the largest pull is looked for at least
ROUNDS, NEAR, NEAR_TOP = 60, 1e-9, 1e-4  # of searches along the tension, in its logarithm
#: Creeps among which the largest ratio of falling friction is looked for: from a part of the one at
#: which a share of the peak is reached, in steps of a factor, so many; and how near it is found.
FIRST_PART, ON_THE_RISE, WIDER, LOOKS, NEAR_PEAK = 0.4, 0.6, 1.5, 14, 1e-6

# capacities that may be asked for, to be added up
CREEP_LIMIT, TESTED_SLIP, LEAST, GROSS_SLIP = 2, 4, 8, 16
CAPACITIES = CREEP_LIMIT + TESTED_SLIP + LEAST + GROSS_SLIP


class Limit(NamedTuple):
    """A limit at the exit: its kind, CREEP or SLIP, and its size towards the slack side [m]."""

    kind: int
    most: float


def ends_at(arc: Geometry, at_tight: float, at_slack: float, tension: float, limit: Limit) -> Ends:
    """A limit at the exit, and at_tight T_tight + at_slack T_slack = tension [-, -, N]."""
    goal = arc.side * limit.most
    if arc.side > 0.0:
        return Ends(at_tight, at_slack, tension, limit.kind, goal)
    return Ends(at_slack, at_tight, tension, limit.kind, goal)


def _guess(arc: Geometry, tight: float, slack: float, creep: float) -> Guess:
    """A first guess by the tensions of the tight and the slack side [N], and creep [m]."""
    return Guess(tight, slack, creep) if arc.side > 0.0 else Guess(slack, tight, creep)


def _guess_at(law: CompactLaw, arc: Geometry, tight: float, limit: Limit) -> Guess:
    """Where an arc meets a limit of creep or slip, about."""
    face, area = interface(law, arc), arc.width * arc.radius
    p = tight / area
    used = stress_about(face, p, 0.6 * limit.most)
    fall = min(used / p * arc.wrap_angle, LARGEST_FALL)
    slack = tight * exp(-0.9 * fall)
    end = arc.side * (limit.most + (arc.shear * used if limit.kind == SLIP else 0.0))
    return _guess(arc, tight, slack, end)


def stress_about(face: Interface, pressure: float, creep: float) -> float:
    """Magnitude of the traction at a pressure [Pa] and a creep [m], for a first guess [Pa]."""
    return min(
        abs(traction_at(face, pressure, creep).stress),
        MOST_USED * plateau_stress(face.law, pressure),
    )


def carry(
    law: CompactLaw, arc: Geometry, tight: float, limit: Limit, near: Course | None = None
) -> Met:
    """Meet a limit of creep or slip at the exit with the tension of the tight side held [N]."""
    ends = ends_at(arc, 1.0, 0.0, tight, limit)
    guess = _guess_at(law, arc, tight, limit)
    met = meet(law, arc, ends, guess, near, MISFIT)
    return met if met.done else by_growth(law, arc, ends, guess, MISFIT)


class Along(NamedTuple):
    """Where on a line of tensions a limit at the exit is met: k, and the arc there."""

    place: float
    met: Met


def carry_along(law: CompactLaw, arc: Geometry, line: Line, limit: Limit) -> Along:
    """Meet a limit of creep or slip at the exit with tensions on a line, T = T(1) + (k - 1) rise.

    Both tensions on it are one condition more at the ends. The place is nan where that is not met:
    where the ratio of the tensions does not grow to the one that is carried now.
    """
    tight, slack, tight_rise, slack_rise = line
    first = carry(law, arc, tight, limit)
    if not first.done:
        return Along(nan, first)
    ratio = exp(log_ratio(first))
    if tight_rise <= ratio * slack_rise:
        return Along(nan, first)
    k = 1.0 + (ratio * slack - tight) / (tight_rise - ratio * slack_rise)
    top, low = tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise
    if not (top > 0.0 and low > 0.0):
        return Along(nan, first)
    size = max(abs(tight_rise), abs(slack_rise))
    at_tight, at_slack = slack_rise / size, -tight_rise / size
    goal = at_tight * (tight - tight_rise) + at_slack * (slack - slack_rise)
    ends = ends_at(arc, at_tight, at_slack, goal, limit)
    guess = _guess(arc, top, low, first.course.creep[-1])
    met = meet(law, arc, ends, guess, _near(first), MISFIT)
    if not met.done:
        return Along(nan, met)
    found, other = max(met.entry, met.course.tension[-1]), min(met.entry, met.course.tension[-1])
    by_tight = abs(tight_rise) >= abs(slack_rise)
    step = (found - tight) / tight_rise if by_tight else (other - slack) / slack_rise
    return Along(1.0 + step, met)


def log_ratio(met: Met) -> float:
    """ln(tight/slack) of an arc [-]."""
    return abs(log(met.entry / met.course.tension[-1]))


def highest_tight(pressure_max: float, area: float, tight: float) -> float:
    """Largest tight-side tension that is looked at [N]: that of the largest tested pressure.

    `area` is B R; without a tested range a thousand times the present one.
    """
    return pressure_max * area if pressure_max == pressure_max else HIGHEST * tight


class Least(NamedTuple):
    """Least slack-side tension that carries a pull, or nan and the largest pull there is [N]."""

    slack: float
    most: float


def least_slack(
    law: CompactLaw, arc: Geometry, pull: float, limit: Limit, at_tight: Met, top: float
) -> Least:
    """Least slack-side tension that carries a pull within a limit at the exit.

    Parameters
    ----------
    pull
        |T1 - T2| to be carried [N].
    limit
        Of creep or slip.
    at_tight
        The arc at the limit with some tension of the tight side, to begin with.
    top
        The largest tension of the tight side to consider [N].
    """
    if at_tight.done:
        carried = -expm1(-log_ratio(at_tight))
        first = max(min(pull / carried, top), 1.02 * pull)
        guess = _guess(arc, first, first - pull, at_tight.course.creep[-1])
        ends = ends_at(arc, 1.0, -1.0, pull, limit)
        met = meet(law, arc, ends, guess, _near(at_tight), MISFIT)
        if met.done and _pull_slope(arc, met.slopes) > 0.0:
            found = max(met.entry, met.course.tension[-1])
            if found <= top:
                return Least(found - pull, nan)
    return _least_sought(law, arc, pull, limit, top)


def _pull_slope(arc: Geometry, slopes: Slopes) -> float:
    """d(pull)/d(tight-side tension) along a limit at the exit [-]."""
    first, last = slopes.first, slopes.last
    if arc.side > 0.0:
        return 1.0 - last / first
    return 1.0 - first / last


def _least_sought(law: CompactLaw, arc: Geometry, pull: float, limit: Limit, top: float) -> Least:
    """`least_slack` along the tension: the pull at the limit grows with it, up to a largest one."""
    high = log(top)
    low = min(log(pull) + LEAST_OVER, high - DEEPEST)
    met = carry(law, arc, top, limit)
    if not met.done:
        return Least(nan, nan)
    best, most, near = high, _pull(met, top), _near(met)
    if _pull_slope(arc, met.slopes) < 0.0:  # the largest pull lies below
        best, most, near = _largest_pull(law, arc, limit, (low, high), near, pull)
    if not most >= pull:
        return Least(nan, most)
    t = high = best
    for _ in range(ROUNDS):
        # Newton's method on ln pull where it stays in the bracket, else halfway
        met = carry(law, arc, exp(t), limit, near)
        if not met.done:
            break
        near, carried = _near(met), _pull(met, exp(t))
        miss = log(carried / pull)
        low, high = (low, t) if miss > 0.0 else (t, high)
        if abs(miss) < NEAR:
            return Least(exp(t) - pull, nan)
        slope = _pull_slope(arc, met.slopes) * exp(t) / carried  # d ln pull/d ln T
        new = t - miss / slope if slope > 0.0 else low
        t = new if low < new < high else 0.5 * (low + high)
    return Least(nan, nan)


def _pull(met: Met, tight: float) -> float:
    """Pull of an arc with a tension of the tight side [N]."""
    return tight * -expm1(-log_ratio(met))


def _largest_pull(
    law: CompactLaw, arc: Geometry, limit: Limit, within: tuple[float, float],
    near: Course | None, enough: float,
) -> tuple[float, float, Course | None]:  # fmt: skip
    """Ln tight-side tension of the largest pull at a limit, that pull [N], and its course.

    Where its slope ends between two tensions; one that carries `enough` will do.
    """
    low, high = within
    best, most, at = high, -inf, near
    for _ in range(ROUNDS):
        t = 0.5 * (low + high)
        met = carry(law, arc, exp(t), limit, at)
        if not met.done:
            break
        pull = _pull(met, exp(t))
        if pull > most:
            best, most, at = t, pull, _near(met)
        if most >= enough or high - low < NEAR_TOP:
            break
        if _pull_slope(arc, met.slopes) > 0.0:
            low = t
        else:
            high = t
    return best, most, at


def largest_ratio(
    law: CompactLaw, arc: Geometry, tight: float, softening: bool
) -> tuple[float, float]:
    """Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m].

    A law flat past its peak has a supremum, with the friction of its plateau everywhere and no
    finite creep (inf). A softening law is left with its residual everywhere, at no finite creep
    either, unless more is carried at some creep on the way there (`outweighs`).
    """
    pressure = tight / (arc.width * arc.radius)
    if not softening:
        return plateau_capacity(law, pressure, arc.wrap_angle), inf
    residual = residual_capacity(law, pressure, arc.wrap_angle)
    if not outweighs(law, arc, tight, residual):
        return residual, inf
    most, creep = _largest_at_creep(law, arc, tight)
    return (most, creep) if most > residual else (residual, inf)


def _largest_at_creep(law: CompactLaw, arc: Geometry, tight: float) -> tuple[float, float]:
    """Largest ln(tight/slack) of a held tight side over creeps, and its creep [m].

    Where what is carried no longer grows with creep; -inf where no creep is followed by less.
    """
    best, low, high = -inf, 0.0, 0.0
    slack = tight * exp(-10.0)
    peak = mean_creep(interface(law, arc), arc, tight, slack, ON_THE_RISE)
    creep = FIRST_PART * abs(peak)
    at, near, before, found = None, None, 0.0, False
    for _ in range(LOOKS):
        met = carry(law, arc, tight, Limit(CREEP, creep), near)
        if met.done:
            near, grows = _near(met), growth(arc, met.slopes)
            if log_ratio(met) > best and (grows > 0.0 or before > 0.0):
                best = log_ratio(met)
                at, found = _near(met), True
                low, high = (creep, 0.0) if grows > 0.0 else (before, creep)
            if grows <= 0.0 and high == 0.0:
                high = creep
            before = creep
        creep *= WIDER
    if not found or high == 0.0:
        return -inf, inf
    while high - low > NEAR_PEAK * high:
        creep = 0.5 * (low + high)
        met = carry(law, arc, tight, Limit(CREEP, creep), at)
        if not met.done:
            break
        at, best = _near(met), log_ratio(met)
        if growth(arc, met.slopes) > 0.0:
            low = creep
        else:
            high = creep
    return best, high


def growth(arc: Geometry, slopes: Slopes) -> float:
    """How what is carried grows with the creep at the exit, in sign: less tension is left."""
    if arc.side > 0.0:  # T(0) held
        return -(slopes.last_goal - slopes.last * slopes.first_goal / slopes.first)
    return slopes.first_goal - slopes.first * slopes.last_goal / slopes.last


def _near(met: Met) -> Course | None:
    """A course to begin another question with."""
    return met.course if met.rest == 0.0 else None


class Carried(NamedTuple):
    """What an arc could carry with its tight side held, nan where it was not asked or not found."""

    creep_limit: float  # ln(tight/slack)
    tested_slip: float  # ln(tight/slack)
    gross_slip: float  # ln(tight/slack)
    gross_creep: float  # exit creep there [m]
    least_slack: float  # tension [N]
    most_pull: float  # where no tension carries the pull [N]


def find_capacities(law: CompactLaw, arc: Geometry, load: Load, parts: int) -> Carried:
    """Capacities that are asked for by `parts`."""
    tight = max(load.entry_tension, load.exit_tension)
    pull = abs(load.entry_tension - load.exit_tension)
    by_creep = by_slip = gross = gross_creep = least = most = nan
    limit, near = Limit(CREEP, load.creep_limit), None
    if parts & (CREEP_LIMIT + LEAST):
        met = carry(law, arc, tight, limit)
        if met.done:
            by_creep, near = log_ratio(met), _near(met)
        if parts & LEAST and pull > 1e-6 * tight:
            top = highest_tight(load.pressure_max, arc.width * arc.radius, tight)
            least, most = least_slack(law, arc, pull, limit, met, top)
    if parts & TESTED_SLIP and load.slip_max == load.slip_max:
        met = carry(law, arc, tight, Limit(SLIP, load.slip_max), near)
        if met.done:
            by_slip = log_ratio(met)
    if parts & GROSS_SLIP:
        gross, gross_creep = largest_ratio(law, arc, tight, load.steepest_fall < 0.0)
        # past the largest ratio of a softening law creep grows and the ratio falls
        if gross_creep <= load.creep_limit:
            by_creep = gross
        if gross_creep <= load.slip_max:
            by_slip = gross
    return Carried(by_creep, by_slip, gross, gross_creep, least, most)
