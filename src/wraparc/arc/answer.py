"""The operating point of an arc between two tensions, or that no creep carries them."""

from __future__ import annotations

from math import inf, log, sqrt
from typing import NamedTuple

from wraparc.arc.capacity import Limit, ends_at, growth, largest_ratio, log_ratio
from wraparc.arc.collocation import (
    CREEP,
    MESH,
    NO_SLOPES,
    ROUGH,
    Course,
    Interface,
    between_tensions,
    compliance_of,
    first_course,
    mean_creep,
)
from wraparc.arc.gross_slip import plateau_capacity
from wraparc.arc.meet import (
    LEAST_GROWTH,
    STEPS,
    Guess,
    Met,
    interface,
    meet,
    ratio_of,
    resting,
    unmet,
)
from wraparc.arc.quantities import BREAKAWAY, POINT_STEPS, SOLVED, UNSOLVED, Geometry, counted
from wraparc.friction.compact import CompactLaw

NO_PULL = 1e-12  # ln of a tension ratio that is rounding
#: Of a continuation in creep: from [m]; how near to the tensions asked they are tried, then nearer;
#: steps of a factor to the first creep that is met, and from there upwards.
LEAST_GUESS, CLOSE, NEARER, AWAY, WIDER = 1e-7, 1e-3, 1e-2, 8.0, 3.0
RATIO_END = 1.0  # entry creep ratio from which on the belt would stand still


class Answer(NamedTuple):
    """The operating point of an arc.

    Attributes
    ----------
    outcome
        SOLVED, BREAKAWAY or UNSOLVED.
    met
        Its course.
    """

    outcome: int
    met: Met


def operating_point(law: CompactLaw, arc: Geometry, entry: float, leaving: float) -> Answer:
    """Operating point of an arc between two tensions [N]."""
    arc = counted(arc, POINT_STEPS)
    goal = arc.side * log(entry / leaving)
    area, face = arc.width * arc.radius, interface(law, arc)
    if abs(goal) < NO_PULL and arc.overrun_constant == 0.0 and arc.overrun_coefficient == 0.0:
        return Answer(SOLVED, _still(face, arc, entry))
    top = max(entry, leaving) / area
    creep = 2.0 * mean_creep(face, arc, entry, leaving)
    guess = Guess(entry, leaving, creep)
    if goal >= plateau_capacity(law, top, arc.wrap_angle):
        first = first_course(
            arc, arc.radius * arc.wrap_angle, guess.entry, guess.leaving, guess.creep
        )
        return Answer(BREAKAWAY, unmet(face, first))
    met = meet(law, arc, between_tensions(entry, leaving), guess, None, MESH)
    if not (met.done and _rises(met)):
        if goal >= largest_ratio(law, arc, max(entry, leaving), True)[0]:
            return Answer(BREAKAWAY, met)
        met = _by_creep(law, arc, guess)
    if not met.done:
        return Answer(UNSOLVED, met)
    if met.rest == 0.0 and ratio_of(met.course, arc) >= RATIO_END:
        return Answer(BREAKAWAY, met)
    return Answer(SOLVED if _rises(met) else UNSOLVED, met)


def _rises(met: Met) -> bool:
    """Whether more is carried as creep grows: friction is not exhausted.

    With more tension at the entry, that of the exit held; or, where an overrun grows so fast with
    it that it takes more than that, with less at the exit, that of the entry held.
    """
    first, through = met.slopes.first, met.slopes.first_goal
    return met.rest > 0.0 or first > 0.0 or first * through > 0.0


class _Tried(NamedTuple):
    """A creep at the exit [m], ln(tight/slack) there, and the course, None with a rest arc."""

    creep: float
    carried: float
    course: Course | None


def _by_creep(law: CompactLaw, arc: Geometry, goal: Guess) -> Met:
    """Operating point by continuation in the creep at the exit, the tight side held.

    What is carried grows with it until friction is exhausted: where creep grows a lot for little
    more friction, tensions alone say little of it.
    """
    tight, slack = max(goal.entry, goal.leaving), min(goal.entry, goal.leaving)
    asked, close, first = log(tight / slack), CLOSE, max(abs(goal.creep), LEAST_GUESS)
    low, high, creep = _Tried(0.0, 0.0, None), _Tried(inf, inf, None), first
    at = low
    met = unmet(interface(law, arc), first_course(arc, 1.0, goal.entry, goal.leaving, goal.creep))
    for i in range(STEPS):
        ends = ends_at(arc, 1.0, 0.0, tight, Limit(CREEP, creep))
        guess = goal._replace(creep=arc.side * creep)
        met = meet(law, arc, ends, guess, at.course, ROUGH)
        if met.done:
            at = _Tried(creep, log_ratio(arc, met), met.course if met.rest == 0.0 else None)
            if abs(at.carried - asked) < close * asked:
                between = between_tensions(goal.entry, goal.leaving)
                there = meet(law, arc, between, goal, at.course, MESH)
                if there.done and _rises(there):
                    return there
                close *= NEARER
            if at.carried < asked and (met.rest > 0.0 or growth(arc, met.slopes) > 0.0):
                low = at
            else:
                high = at
            if high.creep == inf:
                creep = WIDER * low.creep
            elif low.creep == 0.0:
                creep = 0.3 * high.creep
            else:
                rise = high.carried - low.carried
                share = (asked - low.carried) / rise if high.carried > asked else 0.5
                share = min(max(share, 0.1), 0.9)
                creep = low.creep * (high.creep / low.creep) ** share
                at = low if share < 0.5 else high
        elif at.creep == 0.0:  # more, less, more: what is known of the creep may be far off
            creep = first * AWAY ** ((i + 2) // 2 if i % 2 == 0 else -((i + 1) // 2))
        elif LEAST_GROWTH * min(creep, at.creep) > max(creep, at.creep):
            break
        else:  # nearer to one that was met
            creep = sqrt(creep * at.creep)
    return unmet(interface(law, arc), met.course)


def _still(face: Interface, arc: Geometry, tension: float) -> Met:
    """A belt that nothing drives: it rests, and no stress is on it."""
    if face.slides != 0.0:
        return resting(face, arc, Guess(tension, tension, 0.0), compliance_of(arc) * tension)
    course = first_course(arc, arc.radius * arc.wrap_angle, tension, tension, 0.0)
    return Met(True, course, NO_SLOPES, 0.0, tension, face)
