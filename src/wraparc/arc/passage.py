"""An arc by its entry tension and exit creep: what leaves it, how fast it turns, and their slopes.

The exit creep u(L) says how an arc works, from braking through idling and rest to driving, with the
entry tension held: the exit tension falls and the entry creep ratio rises with it, for every length
of the arc. What follows from both, and how, comes out of the solver's own matrix.
"""

from __future__ import annotations

from math import exp, inf, sqrt
from typing import NamedTuple

from wraparc.arc.capacity import LARGEST_FALL, stress_about
from wraparc.arc.collocation import (
    COARSELY,
    CREEP,
    FIRST_STEPS,
    LATER_STEPS,
    Ends,
    Interface,
    Solved,
    compliance_of,
    converged,
    first_course,
    held_stiffness,
    lag_length,
    meshed,
    misfits,
    overrun_at,
    ratio_behind_rest,
    solved,
    solved_or_softened,
    start_at,
)
from wraparc.arc.meet import (
    Guess,
    Met,
    all_sliding,
    by_growth,
    held_along,
    interface,
    may_rest,
    with_rest,
)
from wraparc.arc.profile import entry_ratio
from wraparc.arc.quantities import POINT_STEPS, Geometry, counted
from wraparc.arc.traction import held_stress
from wraparc.friction.compact import CompactLaw

SETTLED = 1e-6  # change of a tension, of the pull, that ends Newton's method where meshes adapt
NO_MESH = inf  # misfit where the mesh stays as it is
MESHES = 3  # that are tried, of an arc nearly the same
AFRESH = 1e-2  # misfit that is let stand at most where there is no arc to begin with
ROUNDING = 1e-9  # of an entry creep ratio
SLIDE = 1e-6  # change of tension, of tension, up to which a slide behind a rest arc is a parabola


class Passed(NamedTuple):
    """An arc passed by the belt.

    Attributes
    ----------
    met
        The arc.
    leaving, ratio
        Exit tension T(L) [N] and entry creep ratio g [-].
    leaving_by_entry, leaving_by_creep
        Slopes of the exit tension by entry tension and exit creep [-, N/m].
    ratio_by_entry, ratio_by_creep
        Of the entry creep ratio [1/N, 1/m].
    """

    met: Met
    leaving: float
    ratio: float
    leaving_by_entry: float
    leaving_by_creep: float
    ratio_by_entry: float
    ratio_by_creep: float


def passed(
    law: CompactLaw, arc: Geometry, entry: float, creep: float, near: Met | None, tol: float
) -> Passed:
    """Pass an arc with an entry tension [N] and an exit creep [m].

    Parameters
    ----------
    law, arc
        What is solved; its side is that of the creep.
    entry, creep
        T(0) and u(L).
    near
        An arc nearly the same, to begin with.
    tol
        Misfit of an element that is let stand; `NO_MESH` keeps the mesh of `near` [-].
    """
    arc, ends = counted(arc, POINT_STEPS), Ends(1.0, 0.0, entry, CREEP, creep)
    if arc.shear > 0.0 and may_rest(law, arc):
        held = _held(law, arc, ends)
        if held is not None:
            return held
    met = None if near is None else _again(law, arc, ends, near, tol)
    if met is None:
        met = _afresh(law, arc, ends, min(tol, AFRESH))
    return _told(arc, met)


def slide_slope(law: CompactLaw, arc: Geometry, entry: float) -> float:
    """(T(0) - T(L))/sqrt(u(L)) of a short slide behind a rest arc where nothing shears [N/m^0.5].

    With T' = -B tau and u' = C (T(0) - T) over a length s, T(0) - T(L) = B tau s and
    u(L) = C B tau s^2/2.
    """
    stress = held_stress(law, entry / (arc.width * arc.radius))
    return sqrt(2.0 * arc.width * stress / compliance_of(arc))


def _held(law: CompactLaw, arc: Geometry, ends: Ends) -> Passed | None:
    """An arc that is held all along, much longer than l; None where it is not."""
    lag, taken = lag_length(arc), held_stiffness(arc)
    overrun, by_tension = overrun_at(arc, ends.tension)
    leaving = ends.tension - taken * (overrun + ends.goal)
    face = interface(law, arc)._replace(slides=arc.side, rests=True)
    met = held_along(face, arc, Guess(ends.tension, leaving, ends.goal))
    if met is None:
        return None
    return Passed(
        met, leaving, -overrun / lag, 1.0 - taken * by_tension, -taken, -by_tension / lag, 0.0
    )


def _again(law: CompactLaw, arc: Geometry, ends: Ends, near: Met, tol: float) -> Met | None:
    """The arc from one nearly the same; None where it is another kind."""
    length, at, rests = arc.radius * arc.wrap_angle, near.course, near.face.rests
    if not near.done or at.place[-1] == 0.0 or near.face.slides * ends.goal < 0.0:
        return None
    face = interface(law, arc)._replace(slides=near.face.slides, rests=rests)
    if not rests and at.place[-1] != length:  # a drum of another size
        at = at._replace(place=[length / at.place[-1] * place for place in at.place])
    enough = COARSELY if tol == NO_MESH else SETTLED
    found = converged(face, arc, ends, at, FIRST_STEPS, enough)
    for _ in range(MESHES if tol < NO_MESH else 0):
        if not found.done:
            return None
        if max(misfits(face, arc, found.course, CREEP)) <= tol:
            break
        finer, _, new = meshed(face, arc, found.course, CREEP, tol)
        if not finer:
            break
        found = converged(face, arc, ends, new, LATER_STEPS, enough)
    return _checked(face, arc, found) if found.done else None


def _checked(face: Interface, arc: Geometry, found: Solved) -> Met | None:
    """The arc found, or None where it has a rest arc and should not, or the other way round."""
    if face.rests:
        behind = with_rest(face, arc, found)
        return behind if behind.done else None
    met = all_sliding(face, found)
    return None if face.slides * entry_ratio(arc, met) < -ROUNDING else met


def _afresh(law: CompactLaw, arc: Geometry, ends: Ends, tol: float) -> Met:
    """The arc from a guess of its tensions."""
    face = interface(law, arc)
    if may_rest(law, arc):
        behind = _behind_rest(face._replace(slides=arc.side, rests=True), arc, ends, tol)
        if behind is not None:
            return behind
    p = ends.tension / (arc.width * arc.radius)
    used = stress_about(face, p, 0.6 * ends.goal)
    fall = min(0.9 * used / p * arc.wrap_angle, LARGEST_FALL)
    guess = Guess(ends.tension, ends.tension * exp(-arc.side * fall), ends.goal)
    first = first_course(arc, arc.radius * arc.wrap_angle, guess.entry, guess.leaving, guess.creep)
    found = solved_or_softened(face, arc, ends, first, tol)
    met = all_sliding(face, found)
    if not met.done:
        met = by_growth(law, arc, ends, guess, tol)
    if met.rest == 0.0 and met.face.slides * entry_ratio(arc, met) < -ROUNDING:
        return met._replace(done=False)
    return met


def _behind_rest(face: Interface, arc: Geometry, ends: Ends, tol: float) -> Met | None:
    """The arc with a rest arc at its entry, or None: from a slide under the traction that holds.

    From the creep u_r at its start it grows by (u_r/l) s + C B tau s^2/2 over a length s.
    """
    stress = held_stress(face.law, ends.tension / (arc.width * arc.radius))
    bend = 0.5 * compliance_of(arc) * arc.width * stress
    more = abs(ends.goal) - arc.shear * stress
    if more <= 0.0:
        return None
    lag = lag_length(arc)
    grows = 0.0 if lag == 0.0 else arc.shear * stress / lag
    slide = 2.0 * more / (grows + sqrt(grows * grows + 4.0 * bend * more))
    slide = min(slide, arc.radius * arc.wrap_angle)
    fall = min(arc.width * stress * slide / ends.tension, LARGEST_FALL)
    leaving = ends.tension * exp(-arc.side * fall)
    first = first_course(arc, slide, ends.tension, leaving, ends.goal)
    first = first._replace(ratio=ratio_behind_rest(face, arc, ends.tension)[0])
    found = solved(face, arc, ends, first, tol)
    return _checked(face, arc, found) if found.done else None


def _told(arc: Geometry, met: Met) -> Passed:
    """What an arc says, with its slopes."""
    first, last, first_goal, last_goal = met.slopes
    leaving = met.course.tension[-1]
    if met.rest > 0.0:  # the start of the slide follows from the entry
        overrun_slope = overrun_at(arc, met.entry)[1]
        lag = lag_length(arc)
        ratio_by_entry = 0.0 if lag == 0.0 else -overrun_slope / lag
        if arc.shear > 0.0:
            taken = held_stiffness(arc)
            end_slope = start_at(met.face, arc, met.course.tension[0])[1]
            part = (1.0 - taken * overrun_slope) / (1.0 + taken * end_slope)
        else:
            part = 1.0
        by_creep = last_goal - last * first_goal / first
        ratio = entry_ratio(arc, met)
        return Passed(met, leaving, ratio, last / first * part, by_creep, ratio_by_entry, 0.0)
    by_creep = last_goal - last * first_goal / first
    ratio_by_entry = 1.0 / first - compliance_of(arc)
    return Passed(
        met, leaving, entry_ratio(arc, met), last / first, by_creep, ratio_by_entry,
        -first_goal / first,
    )  # fmt: skip
