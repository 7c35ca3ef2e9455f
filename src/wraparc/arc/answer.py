"""The operating point of an arc: one two-point problem, with a rest arc where a law asks for it.

Where a law jumps and nothing shears, the belt rests from the entry on, u = 0 and T = T1, and slides
behind that: the creep ratio at the entry is 0 and the length of the slide is found. Where that is
more than the wrap, the belt slides all along.
"""

from __future__ import annotations

from math import inf, log, sqrt
from typing import NamedTuple

from wraparc.arc.collocation import (
    CREEP,
    MESH,
    NO_SLOPES,
    ROUGH,
    TENSION,
    Course,
    Ends,
    Interface,
    Slopes,
    Solved,
    between_tensions,
    compliance_of,
    entry_of_rest,
    first_course,
    lag_length,
    mean_creep,
    overrun_at,
    ratio_behind_rest,
    solved,
    solved_or_eased,
)
from wraparc.arc.gross_slip import plateau_capacity
from wraparc.arc.quantities import (
    BREAKAWAY,
    SOLVED,
    UNSOLVED,
    Geometry,
    jumps,
)
from wraparc.arc.traction import held_stress
from wraparc.friction.compact import CompactLaw

#: Shear-lag lengths l in an arc from which on one that holds the belt may have a rest arc; and in a
#: rest arc, of which the layers at both ends then do not feel one another.
STIFF, HELD = 40.0, 20.0
FIRST_SLIDES = (0.5, 0.1, 0.01, 1e-3)  # first guesses of a slide behind a rest arc, of the wrap
NO_PULL = 1e-12  # ln of a tension ratio that is rounding
LEAST_GUESS, CREEPS, CLOSE = 1e-7, 40, 1e-3  # of a continuation in creep: from [m], steps, end
RATIO_END = 1.0  # entry creep ratio from which on the belt would stand still


class Met(NamedTuple):
    """An arc that meets what was asked, or does not.

    Attributes
    ----------
    done
        Whether it does.
    course
        Creep and tension where it slides.
    slopes
        How its ends answer.
    rest
        Length of the rest arc in front of the course [m].
    entry
        Entry tension [N].
    face
        The interface it was solved with.
    """

    done: bool
    course: Course
    slopes: Slopes
    rest: float
    entry: float
    face: Interface


def interface(law: CompactLaw, arc: Geometry) -> Interface:
    """Traction of an arc by its law."""
    rigid = jumps(law) and arc.shear == 0.0
    return Interface(law, arc.shear, 1.0, 0.0, arc.side if rigid else 0.0, False)


class Guess(NamedTuple):
    """First guess of an arc: tensions at its ends [N], creep at the exit [m]."""

    entry: float
    leaving: float
    creep: float


def meet(
    law: CompactLaw, arc: Geometry, ends: Ends, guess: Guess, near: Course | None, tol: float
) -> Met:
    """Meet end conditions.

    Parameters
    ----------
    law, arc
        What is solved.
    ends
        What is asked.
    guess
        Where to begin.
    near
        The course of an arc nearly the same, to begin with instead.
    tol
        Misfit of an element, of the change of tension, that is let stand [-].
    """
    face, length = interface(law, arc), arc.radius * arc.wrap_angle
    if jumps(law) and STIFF * lag_length(arc) < length:
        behind = face._replace(slides=arc.side, rests=True)
        held = _at_rest(behind, arc, ends, guess) if arc.shear > 0.0 else None
        found = _behind_rest(behind, arc, ends, guess, tol) if held is None else held
        if found.done:
            return found
    if near is not None:
        again = solved(face, arc, ends, near, tol)
        if again.done:
            return _all_sliding(face, again)
    first = first_course(arc, length, guess.entry, guess.leaving, guess.creep)
    return _all_sliding(face, solved_or_eased(face, arc, ends, first, tol))


def _all_sliding(face: Interface, found: Solved) -> Met:
    """An arc without a rest arc of its own."""
    return Met(found.done, found.course, found.slopes, 0.0, found.course.tension[0], face)


def _unmet(face: Interface, at: Course) -> Met:
    return Met(False, at, NO_SLOPES, 0.0, at.tension[0], face)


def _at_rest(face: Interface, arc: Geometry, ends: Ends, guess: Guess) -> Met | None:
    """An arc that is held all along, much longer than l; None where it is not."""
    area, lag, length = arc.width * arc.radius, lag_length(arc), arc.radius * arc.wrap_angle
    taken = arc.width * lag / arc.shear
    overrun, entry, leaving = overrun_at(arc, guess.entry)[0], guess.entry, guess.leaving
    if ends.kind != TENSION or ends.at_entry != 1.0:
        return None
    creep = (entry - leaving) / taken - overrun
    if abs(creep) > arc.shear * held_stress(face.law, leaving / area):
        return None
    course = Course([0.0, 0.0], [creep] * 2, [leaving] * 2, [leaving] * 3, 0.0)
    course = course._replace(ratio=compliance_of(arc) * leaving + creep / lag)
    return Met(True, course, NO_SLOPES, length, entry, face)


def _behind_rest(face: Interface, arc: Geometry, ends: Ends, guess: Guess, tol: float) -> Met:
    """`meet` with a rest arc at the entry; not done where it is not much longer than l."""
    length = arc.radius * arc.wrap_angle
    first = first_course(arc, length, guess.entry, guess.leaving, guess.creep)
    for share in FIRST_SLIDES:
        first = first_course(arc, share * length, guess.entry, guess.leaving, guess.creep)
        first = first._replace(ratio=ratio_behind_rest(face, arc, guess.entry)[0])
        done, course, slopes = solved(face, arc, ends, first, tol)
        if done:
            rest = length - course.place[-1]
            long = rest >= HELD * lag_length(arc)
            entry = entry_of_rest(face, arc, course.tension[0])
            return Met(long, course, slopes, max(rest, 0.0), entry, face)
    return _unmet(face, first)


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
    goal = arc.side * log(entry / leaving)
    area, face = arc.width * arc.radius, interface(law, arc)
    if abs(goal) < NO_PULL and arc.kick == 0.0 and arc.kick_coefficient == 0.0:
        return Answer(SOLVED, _still(face, arc, entry))
    top = max(entry, leaving) / area
    creep = 2.0 * mean_creep(face, arc, entry, leaving)
    guess = Guess(entry, leaving, creep)
    if goal >= plateau_capacity(law, top, arc.wrap_angle):
        first = first_course(
            arc, arc.radius * arc.wrap_angle, guess.entry, guess.leaving, guess.creep
        )
        return Answer(BREAKAWAY, _unmet(face, first))
    met = meet(law, arc, between_tensions(entry, leaving), guess, None, MESH)
    if not (met.done and _rises(arc, met)):
        met = _by_creep(law, arc, guess)
    if not met.done:
        return Answer(UNSOLVED, met)
    if met.rest == 0.0 and ratio_of(met.course, arc) >= RATIO_END:
        return Answer(BREAKAWAY, met)
    return Answer(SOLVED if _rises(arc, met) else UNSOLVED, met)


def _rises(arc: Geometry, met: Met) -> bool:
    """Whether more is carried as creep grows: friction is not exhausted.

    With more tension at the entry; or, where an overrun grows so fast with it that it takes more
    than that, with less at the exit.
    """
    first, through = met.slopes.first, met.slopes.first_goal
    return met.rest > 0.0 or first > 0.0 or (arc.side > 0.0 and first * through > 0.0)


def _by_creep(law: CompactLaw, arc: Geometry, goal: Guess) -> Met:
    """Operating point by continuation in the creep at the exit, the tight side held.

    What is carried grows with it until friction is exhausted: where creep grows a lot for little
    more friction, tensions alone say little of it.
    """
    drives = arc.side > 0.0
    tight, slack = max(goal.entry, goal.leaving), min(goal.entry, goal.leaving)
    at_entry = 1.0 if drives else 0.0
    asked, low, high = log(tight / slack), 0.0, inf
    creep, near = max(abs(goal.creep), LEAST_GUESS), None
    met = _unmet(interface(law, arc), first_course(arc, 1.0, goal.entry, goal.leaving, goal.creep))
    for _ in range(CREEPS):
        ends = Ends(at_entry, 1.0 - at_entry, tight, CREEP, arc.side * creep)
        guess = goal._replace(creep=arc.side * creep)
        met = meet(law, arc, ends, guess, near, ROUGH)
        if met.done:
            near = met.course
            carried = abs(log(met.entry / near.tension[-1]))
            if abs(carried - asked) < CLOSE * asked:
                break
            low, high = (creep, high) if carried < asked else (low, creep)
        else:
            high = creep
        creep = 3.0 * low if high == inf else sqrt(low * high) if low > 0.0 else 0.3 * high
    if not met.done:
        return met
    ends = between_tensions(goal.entry, goal.leaving)
    return meet(law, arc, ends, goal, met.course, MESH)


def _still(face: Interface, arc: Geometry, tension: float) -> Met:
    """A belt that nothing drives."""
    course = first_course(arc, arc.radius * arc.wrap_angle, tension, tension, 0.0)
    return Met(True, course, NO_SLOPES, 0.0, tension, face)


def ratio_of(at: Course, arc: Geometry) -> float:
    """Entry creep ratio g of a course [-]."""
    return at.ratio - compliance_of(arc) * at.tension[0]
