"""End conditions of an arc are met: one two-point problem, with a rest arc where a law asks for it.

Where a law jumps and nothing shears, the belt rests from the entry on, u = 0 and T = T1, and slides
behind that: the creep ratio at the entry is 0 and the length of the slide is found. Where that is
more than the wrap, the belt slides all along.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

from wraparc.arc.collocation import (
    NO_SLOPES,
    ROUGH,
    TENSION,
    Course,
    Ends,
    Interface,
    Slopes,
    Solved,
    compliance_of,
    entry_of_rest,
    first_course,
    held_stiffness,
    lag_length,
    overrun_at,
    ratio_behind_rest,
    solved,
    solved_or_softened,
)
from wraparc.arc.quantities import Geometry, jumps
from wraparc.arc.traction import held_stress
from wraparc.friction.compact import CompactLaw

#: Shear-lag lengths l in an arc from which on one that holds the belt may have a rest arc; and in a
#: rest arc, of which the layers at both ends then do not feel one another.
STIFF, HELD = 40.0, 20.0
FIRST_SLIDES = (0.5, 0.1, 0.01, 1e-3)  # first guesses of a slide behind a rest arc, of the wrap
FIRST_GOAL, LEAST_GROWTH, STEPS = 0.01, 1.01, 40  # of a continuation: begin, least step, most


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
    return Interface(law, arc.shear, arc.side if rigid else 0.0, False)


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
    if may_rest(law, arc):
        behind = face._replace(slides=arc.side, rests=True)
        held = _at_rest(behind, arc, ends, guess) if arc.shear > 0.0 else None
        found = _behind_rest(behind, arc, ends, guess, tol) if held is None else held
        if found.done:
            return found
    if near is not None:
        again = solved(face, arc, ends, near, tol)
        if again.done:
            return all_sliding(face, again)
        if tol >= ROUGH:  # one of many steps: a shorter one will do
            return unmet(face, near)
    first = first_course(arc, length, guess.entry, guess.leaving, guess.creep)
    return all_sliding(face, solved_or_softened(face, arc, ends, first, tol))


def may_rest(law: CompactLaw, arc: Geometry) -> bool:
    """Whether a rest arc that is much longer than l may stand at the entry."""
    return jumps(law) and STIFF * lag_length(arc) < arc.radius * arc.wrap_angle


def all_sliding(face: Interface, found: Solved) -> Met:
    """An arc without a rest arc of its own."""
    return Met(found.done, found.course, found.slopes, 0.0, found.course.tension[0], face)


def unmet(face: Interface, at: Course) -> Met:
    """An arc that meets nothing."""
    return Met(False, at, NO_SLOPES, 0.0, at.tension[0], face)


def _at_rest(face: Interface, arc: Geometry, ends: Ends, guess: Guess) -> Met | None:
    """An arc that is held all along, much longer than l; None where it is not."""
    if ends.kind != TENSION or ends.at_entry != 1.0:
        return None
    creep = (guess.entry - guess.leaving) / held_stiffness(arc) - overrun_at(arc, guess.entry)[0]
    return held_along(face, arc, guess._replace(creep=creep))


def held_along(face: Interface, arc: Geometry, at: Guess) -> Met | None:
    """An arc that is held all along by what is known of its ends; None where it is not."""
    leaving, creep = at.leaving, at.creep
    if leaving <= 0.0:
        return None
    if abs(creep) > arc.shear * held_stress(face.law, leaving / (arc.width * arc.radius)):
        return None
    ratio = compliance_of(arc) * leaving + creep / lag_length(arc)
    return resting(face, arc, at, ratio)


def resting(face: Interface, arc: Geometry, at: Guess, ratio: float) -> Met:
    """An arc that is held all along, by what is known of its ends and K [-]."""
    leaving = at.leaving
    course = Course([0.0, 0.0], [at.creep] * 2, [leaving] * 2, [leaving] * 3, ratio)
    return Met(True, course, NO_SLOPES, arc.radius * arc.wrap_angle, at.entry, face)


def _behind_rest(face: Interface, arc: Geometry, ends: Ends, guess: Guess, tol: float) -> Met:
    """`meet` with a rest arc at the entry; not done where it is not much longer than l."""
    length = arc.radius * arc.wrap_angle
    slides = [share * length for share in FIRST_SLIDES]
    if arc.shear == 0.0 and ends.kind == TENSION:
        # next to no pull: the slide is so short that its traction is that at its end
        area = arc.width * arc.radius
        pull = abs(guess.entry - guess.leaving)
        short = pull / (arc.width * held_stress(face.law, guess.leaving / area))
        if short < slides[-1]:
            slides = [short]
    for slide in slides:
        first = first_course(arc, slide, guess.entry, guess.leaving, guess.creep)
        first = first._replace(ratio=ratio_behind_rest(face, arc, guess.entry)[0])
        found = solved(face, arc, ends, first, tol)
        if found.done:
            return with_rest(face, arc, found)
    return unmet(face, first)


def with_rest(face: Interface, arc: Geometry, found: Solved) -> Met:
    """An arc with its slide behind a rest arc; not done where that is not much longer than l."""
    course = found.course
    rest = arc.radius * arc.wrap_angle - course.place[-1]
    long = rest >= HELD * lag_length(arc)
    entry = entry_of_rest(face, arc, course.tension[0])
    return Met(long, course, found.slopes, max(rest, 0.0), entry, face)


def by_growth(law: CompactLaw, arc: Geometry, ends: Ends, guess: Guess, tol: float) -> Met:
    """Meet a goal of creep or slip at the exit by continuation in it, from a small part of it."""
    share, step, near, last = FIRST_GOAL, 2.0, None, 0.0
    met = unmet(interface(law, arc), first_course(arc, 1.0, guess.entry, guess.entry, 0.0))
    top = max(guess.entry, guess.leaving)
    for _ in range(STEPS):
        part = ends._replace(goal=share * ends.goal)
        begin = Guess(top, top, share * guess.creep)
        met = meet(law, arc, part, begin, near, ROUGH if share < 1.0 else tol)
        if met.done and share == 1.0:
            break
        if met.done:
            near = met.course if met.rest == 0.0 else None
            last, share = share, min(step * share, 1.0)
        elif near is None or step < LEAST_GROWTH:
            break
        else:
            step = sqrt(step)
            share = step * last
    return met


def ratio_of(at: Course, arc: Geometry) -> float:
    """Entry creep ratio g of a course [-]."""
    return at.ratio - compliance_of(arc) * at.tension[0]
