"""What an arc could carry: the questions of capacity as end conditions of the same problem.

`carry` meets a limit of creep or slip at the exit with the tight side held (T1 driving, T2
braking); `least_slack` meets it with the pull held; `largest_ratio` is gross slip, in closed form
but where friction falls past its peak and carries most at a finite creep.
"""

from __future__ import annotations

from math import exp, expm1, inf, log, nan, sqrt
from typing import NamedTuple

from wraparc.arc.collocation import (
    CREEP,
    MOST_USED,
    ROUGH,
    SLIP,
    Course,
    Ends,
    Interface,
    Slopes,
    compliance_of,
    mean_creep,
    overrun_at,
    traction_at,
)
from wraparc.arc.gross_slip import Line, outweighs, plateau_capacity, residual_capacity
from wraparc.arc.meet import Guess, Met, by_growth, interface, meet
from wraparc.arc.quantities import CAPACITY_STEPS, Geometry, Load, counted
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
FIRST_PART, ON_THE_RISE, WIDER, LOOKS, MOST_LOOKS, NEAR_PEAK = 0.4, 0.6, 1.5, 14, 40, 1e-6

FAR, HALVINGS = 200.0, 12  # of the tension, where a first guess is looked for along a line

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
    law: CompactLaw, arc: Geometry, tight: float, limit: Limit, near: Course | None = None,
    tol: float = MISFIT,
) -> Met:  # fmt: skip
    """Meet a limit of creep or slip at the exit with the tension of the tight side held [N]."""
    arc, ends = counted(arc, CAPACITY_STEPS), ends_at(arc, 1.0, 0.0, tight, limit)
    guess = _guess_at(law, arc, tight, limit)
    met = meet(law, arc, ends, guess, near, tol)
    return met if met.done else by_growth(law, arc, ends, guess, tol)


class Along(NamedTuple):
    """Where on a line of tensions a limit at the exit is met: k, and the arc there."""

    place: float
    met: Met


def carry_along(law: CompactLaw, arc: Geometry, line: Line, limit: Limit, at_tight: Met) -> Along:
    """Meet a limit of creep or slip at the exit with tensions on a line, T = T(1) + (k - 1) rise.

    Both tensions on it are one condition more at the ends. `at_tight` is the arc at the limit with
    the tight side of k = 1, to begin with. The place is nan where that is not met, or where the
    ratio of the tensions does not grow along the line.
    """
    arc = counted(arc, CAPACITY_STEPS)
    tight, slack, tight_rise, slack_rise = line
    if not at_tight.done:
        return Along(nan, at_tight)
    if tight_rise == 0.0 and slack_rise < 0.0:  # the tight side is held: it is met
        return Along(1.0 + (sides(arc, at_tight)[1] - slack) / slack_rise, at_tight)
    top, low = _first_along(law, arc, line, limit, at_tight)
    if not (top > 0.0 and low > 0.0):
        return Along(nan, at_tight)
    size = max(abs(tight_rise), abs(slack_rise))
    at_top, at_low = slack_rise / size, -tight_rise / size
    goal = at_top * (tight - tight_rise) + at_low * (slack - slack_rise)
    guess = _guess(arc, top, low, at_tight.course.creep[-1])
    met = meet(law, arc, ends_at(arc, at_top, at_low, goal, limit), guess, _near(at_tight), MISFIT)
    if not met.done:
        return Along(nan, met)
    found, other = sides(arc, met)
    if not tight_rise * other > slack_rise * found:
        return Along(nan, met)
    by_tight = abs(tight_rise) >= abs(slack_rise)
    step = (found - tight) / tight_rise if by_tight else (other - slack) / slack_rise
    return Along(1.0 + step, met)


def _first_along(
    law: CompactLaw, arc: Geometry, line: Line, limit: Limit, at_tight: Met
) -> tuple[float, float]:
    """Tensions of a line at which a limit is met, about: of the tight and of the slack side [N]."""
    tight, slack, tight_rise, slack_rise = line
    ratio = exp(log_ratio(arc, at_tight))
    if tight_rise > ratio * slack_rise:
        k = 1.0 + (ratio * slack - tight) / (tight_rise - ratio * slack_rise)
        return tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise
    if not tight_rise > 0.0:
        return nan, nan
    # both sides grow: where friction that falls with pressure meets their ratio
    face, area = interface(law, arc), arc.width * arc.radius
    low, high = tight, FAR * tight
    first = stress_about(face, tight / area, 0.6 * limit.most) / tight
    for _ in range(HALVINGS):
        middle = sqrt(low * high)
        used = stress_about(face, middle / area, 0.6 * limit.most) / middle
        asked = log(middle / (slack + (middle - tight) / tight_rise * slack_rise))
        if asked < used / first * log_ratio(arc, at_tight):
            low = middle
        else:
            high = middle
    return middle, slack + (middle - tight) / tight_rise * slack_rise


def sides(arc: Geometry, met: Met) -> tuple[float, float]:
    """Tensions of the tight and of the slack side of an arc [N]."""
    entry, leaving = met.entry, met.course.tension[-1]
    return (entry, leaving) if arc.side > 0.0 else (leaving, entry)


def log_ratio(arc: Geometry, met: Met) -> float:
    """ln(tight/slack) of an arc [-]; negative where a large overrun pulls the other way."""
    tight, slack = sides(arc, met)
    return log(tight / slack)


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
    arc = counted(arc, CAPACITY_STEPS)
    if at_tight.done:
        carried = -expm1(-log_ratio(arc, at_tight))
        first = max(min(pull / carried, top) if carried > 0.0 else 0.0, 1.02 * pull)
        guess = _guess(arc, first, first - pull, at_tight.course.creep[-1])
        ends = ends_at(arc, 1.0, -1.0, pull, limit)
        met = meet(law, arc, ends, guess, _near(at_tight), MISFIT)
        if met.done and _pull_slope(arc, met.slopes) > 0.0:
            found = sides(arc, met)[0]
            if found <= top:
                return Least(found - pull, nan)
    return _least_sought(law, arc, pull, limit, at_tight, top)


def _pull_slope(arc: Geometry, slopes: Slopes) -> float:
    """d(pull)/d(tight-side tension) along a limit at the exit [-]."""
    first, last = slopes.first, slopes.last
    if arc.side > 0.0:
        return 1.0 - last / first
    return 1.0 - first / last


def _least_sought(
    law: CompactLaw, arc: Geometry, pull: float, limit: Limit, at_tight: Met, top: float
) -> Least:
    """`least_slack` along the tension: the pull at the limit grows with it, up to a largest one.

    Newton's method for ln pull by ln tension, which is next to straight, in a bracket.
    """
    high = log(top)
    low = min(log(pull) + LEAST_OVER, high - DEEPEST)
    met, t, over = at_tight, high, False
    if met.done:
        t = log(sides(arc, met)[0])
    if not (met.done and t < high and _pull_slope(arc, met.slopes) > 0.0):
        t, met = high, carry(law, arc, top, limit)
    for _ in range(ROUNDS):
        if not met.done:
            break
        carried, slope = _pull(arc, met, exp(t)), _pull_slope(arc, met.slopes)
        miss = log(carried / pull) if carried > 0.0 else -inf  # an overrun takes all of the limit
        if abs(miss) < NEAR and slope > 0.0:
            return Least(exp(t) - pull, nan)
        if miss < 0.0 and slope > 0.0 and t >= high:
            return Least(nan, carried)  # the largest tension carries the most
        if miss < 0.0 and slope <= 0.0:  # the largest pull lies below
            t, carried, near = _largest_pull(law, arc, limit, (low, t), _near(met), pull)
            if not carried >= pull:
                return Least(nan, carried)
            high, over = t, True
            met = carry(law, arc, exp(t), limit, near)
            continue
        low, high = (low, t) if miss > 0.0 else (t, high)
        over = over or miss > 0.0
        by_log = slope * exp(t) / carried  # d ln pull/d ln T
        new = t - miss / by_log if by_log > 0.0 else low
        # up to the largest tension, if need be; between two that were tried strictly
        new = high if new >= high and not over else new
        t = new if low < new < high or (new == high and not over) else 0.5 * (low + high)
        met = carry(law, arc, exp(t), limit, _near(met))
    return Least(nan, nan)


def _pull(arc: Geometry, met: Met, tight: float) -> float:
    """Pull of an arc with a tension of the tight side [N]."""
    return tight * -expm1(-log_ratio(arc, met))


def _largest_pull(
    law: CompactLaw, arc: Geometry, limit: Limit, within: tuple[float, float],
    near: Course | None, enough: float,
) -> tuple[float, float, Course | None]:  # fmt: skip
    """Ln tight-side tension of the largest pull at a limit, that pull [N], and its course.

    Where its slope ends between two tensions; one that carries `enough` will do.
    """
    low, high = within
    best, most, at, up, down, t = high, -inf, near, 0.0, 0.0, low
    for _ in range(ROUNDS):
        last, t = t, _between(low, up, high, down)
        met = carry(law, arc, exp(t), limit, at)
        if not met.done:
            break
        pull = _pull(arc, met, exp(t))
        if pull > most:
            best, most, at = t, pull, _near(met)
        if most >= enough or high - low < NEAR_TOP or abs(t - last) < NEAR_TOP:
            break
        slope = _pull_slope(arc, met.slopes)
        if slope > 0.0:
            low, up, down = t, slope, 0.5 * down
        else:
            high, down, up = t, slope, 0.5 * up
    return best, most, at


def _between(low: float, up: float, high: float, down: float) -> float:
    """Where a slope ends that is `up` > 0 at one end and `down` < 0 at the other.

    By a straight line; halfway where one of them is not known.
    """
    place = low + (high - low) * up / (up - down) if up > 0.0 > down else low
    return place if low < place < high else 0.5 * (low + high)


def largest_ratio(
    law: CompactLaw, arc: Geometry, tight: float, softening: bool
) -> tuple[float, float]:
    """Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m].

    A law flat past its peak has a supremum, with the friction of its plateau everywhere and no
    finite creep (inf). A softening law is left with its residual everywhere, at no finite creep
    either, unless more is carried at some creep on the way there (`outweighs`).
    """
    pressure = tight / (arc.width * arc.radius)
    plateau = plateau_capacity(law, pressure, arc.wrap_angle)
    residual = residual_capacity(law, pressure, arc.wrap_angle) if softening else plateau
    if residual >= plateau:
        return plateau, inf
    if not outweighs(law, arc, tight, residual):
        return residual, inf
    most, creep = _largest_at_creep(law, arc, tight, residual)
    return (residual, inf) if most <= residual else (most, creep)


def _largest_at_creep(
    law: CompactLaw, arc: Geometry, tight: float, residual: float
) -> tuple[float, float]:
    """Largest ln(tight/slack) of a held tight side over creeps, and its creep [m].

    Where what is carried no longer grows with creep; -inf where no creep is followed by less, nan
    where the search does not end. Not before the belt slides all along, which takes the peak of the
    law and its own shrinkage.
    """
    arc = arc._replace(left=[CAPACITY_STEPS])  # a search of its own
    best, low, high, up, down = -inf, 0.0, 0.0, 0.0, 0.0
    peak = mean_creep(interface(law, arc), arc, tight, tight * exp(-10.0), ON_THE_RISE)
    slack = tight * exp(-residual)
    entry = tight if arc.side > 0.0 else slack
    shrinks = compliance_of(arc) * arc.radius * arc.wrap_angle
    shrinks *= arc.side * (entry - (tight - slack) / residual)
    creep = FIRST_PART * max(abs(peak), shrinks + arc.side * overrun_at(arc, entry)[0])
    at, near, before, risen, found = None, None, 0.0, 0.0, False
    for look in range(MOST_LOOKS):  # a soft belt shrinks far past the peak of its law
        if look >= LOOKS and risen <= 0.0:
            break
        met = carry(law, arc, tight, Limit(CREEP, creep), near, ROUGH)
        if met.done:
            near, grows = _near(met), growth(arc, met.slopes)
            if log_ratio(arc, met) > best and (grows > 0.0 or before > 0.0):
                best = log_ratio(arc, met)
                at, found = _near(met), True
                low, up, high = (creep, grows, 0.0) if grows > 0.0 else (before, risen, creep)
                down = grows
            if grows <= 0.0 and high == 0.0:
                high, down = creep, grows
            before, risen = creep, grows
        creep *= WIDER
    if not found or high == 0.0:
        return -inf, inf
    creep, last = high, low
    while high - low > NEAR_PEAK * high and abs(creep - last) > NEAR_PEAK * high:
        last = creep
        creep = _between(low, up, high, down)
        met = carry(law, arc, tight, Limit(CREEP, creep), at)
        if not met.done:
            return nan, nan
        at, best, grows = _near(met), log_ratio(arc, met), growth(arc, met.slopes)
        if grows > 0.0:
            low, up, down = creep, grows, 0.5 * down
        else:
            high, down, up = creep, grows, 0.5 * up
    return best, creep


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
    arc = counted(arc, CAPACITY_STEPS)
    tight = max(load.entry_tension, load.exit_tension)
    pull = abs(load.entry_tension - load.exit_tension)
    by_creep = by_slip = gross = gross_creep = least = most = nan
    limit, near = Limit(CREEP, load.creep_limit), None
    if parts & (CREEP_LIMIT + LEAST):
        met = carry(law, arc, tight, limit)
        if met.done:
            by_creep, near = log_ratio(arc, met), _near(met)
        if parts & LEAST and pull > 1e-6 * tight:
            top = highest_tight(load.pressure_max, arc.width * arc.radius, tight)
            least, most = least_slack(law, arc, pull, limit, met, top)
    if parts & TESTED_SLIP and load.slip_max == load.slip_max:
        met = carry(law, arc, tight, Limit(SLIP, load.slip_max), near)
        if met.done:
            by_slip = log_ratio(arc, met)
    if parts & GROSS_SLIP:
        gross, gross_creep = largest_ratio(law, arc, tight, load.steepest_fall < 0.0)
        # past the largest ratio of a softening law creep grows and the ratio falls
        if gross_creep <= load.creep_limit:
            by_creep = gross
        if gross_creep <= load.slip_max:
            by_slip = gross
    return Carried(by_creep, by_slip, gross, gross_creep, least, most)
