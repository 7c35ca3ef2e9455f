"""Solve one arc across the width."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from wraparc.across.collocation import Found, State, System, along, between, newton, started
from wraparc.across.elements import Elements, graded
from wraparc.across.result import AcrossResult, AcrossStatus, Fields, Slack
from wraparc.across.stresses import stresses
from wraparc.across.wide_arc import Array, WideArc
from wraparc.alike import place_of_largest
from wraparc.arc import ArcResult, Distributed, Status

#: trials of putting the unevenness on little by little, where it fails all at once
_MOST_TRIALS = 12
#: places along a transition where the tension is looked at
_SPAN_PLACES = 41
#: a share of the mean tension below which a strip counts as nearly slack
_NEARLY = 0.15
#: elements, and parts of each for friction: a solve is held against one with more
_LEVELS = ((12, 1), (16, 4), (24, 8), (36, 12), (48, 16))
#: how much nearer, at least, a level comes than the one before: 2 with kinks, 10 and more without
_GAIN = 2.0
#: places along the arc that a result tells, finer at the entry nip: s = L (i/48)^4
_PLACES = np.linspace(0.0, 1.0, 49) ** 4


@dataclass(frozen=True)
class AcrossSolver:
    """Strips across the width, all at once by collocation along the arc.

    Attributes
    ----------
    accuracy
        Largest error of tensions, creep and drum number along the arc, over the largest of each;
        elements are added until the estimate is below it, or there are as many as may be.
    """

    accuracy: float = 1e-6

    def solve(self, wide: WideArc, *, start: AcrossResult | None = None) -> AcrossResult:
        """Solve one arc; a failure is a result too, see `AcrossStatus`.

        Parameters
        ----------
        wide
            The arc.
        start
            Result of one like it, to begin from; None to begin from the even belt.
        """
        even = start.even if start is not None and start.wide.arc is wide.arc else None
        even = even or Distributed(capacities=False).solve(wide.arc)
        if even.status is not Status.SOLVED:
            broken = even.status is Status.BREAKAWAY
            status = AcrossStatus.BREAKAWAY if broken else AcrossStatus.UNSOLVED
            return _without_state(wide, even, status)
        system = System(wide, Elements(graded(wide.arc.length, _LEVELS[0][0])))
        if start is not None and start.status.solved:
            found = newton(system, _from(start, system))
            if found.solved:
                return self._finer(found, even)
        begin = started(system, even)
        found = newton(system, begin)
        if found.solved:
            return self._finer(found, even)
        return _gradually(system, begin, even, found.iterations)

    def _finer(self, found: Found, even: ArcResult) -> AcrossResult:
        """Refine a solution until its error is as small as asked for."""
        error = math.inf
        for count, fineness in _LEVELS[1:]:
            last = found
            elements = Elements(graded(last.system.wide.arc.length, count), fineness)
            found = newton(replace(last.system, elements=elements), between(last, elements.stages))
            found = found._replace(iterations=last.iterations + found.iterations)
            if not found.solved:
                return _result(found, even, AcrossStatus.UNSOLVED)
            error = distance(last, found) / _GAIN
            if error < self.accuracy:
                break
        return replace(_judged(found, even), error_estimate=error)


def distance(one: Found, other: Found) -> float:
    """How far two solutions are apart: tensions, creep, Gamma, over the largest of each."""
    a, b = one.point, other.point
    pairs = (
        (a.state.entry, b.state.entry), (a.tension_end, b.tension_end),
        (a.creep_end, b.creep_end), (a.state.drum, b.state.drum),
    )  # fmt: skip
    return max(float(np.max(np.abs(x - y)) / np.max(np.abs(y))) for x, y in pairs)


def _from(result: AcrossResult, system: System) -> State:
    """The state of a result, on other elements."""
    places = system.elements.stages / result.wide.arc.radius
    columns = [np.interp(places, result.angle, c) for c in result.fields.tension.T]
    return State(np.array(columns).T, result.entry_tension, result.drum_number)


def _judged(found: Found, even: ArcResult) -> AcrossResult:
    """Result of conditions that are met: solved, or slack somewhere on the arc."""
    result = _result(found, even, AcrossStatus.SOLVED)
    if result.least_tension > 0.0:
        return result
    return replace(result, status=AcrossStatus.SLACK, slack=_slackest(result))


def _slackest(result: AcrossResult) -> Slack:
    where = np.unravel_index(place_of_largest(-result.fields.tension), result.fields.tension.shape)
    return Slack(
        position=float(result.position[where[1]]),
        angle=float(result.angle[where[0]]),
        tension=result.least_tension,
    )


def _gradually(system: System, start: State, even: ArcResult, iterations: int) -> AcrossResult:
    """Put the unevenness on little by little; where it will not go further, say why."""
    none = replace(system, amount=0.0)
    done, step, last = 0.0, 0.5, Found(none, none.at(start), True, 0)
    before: tuple[float, AcrossResult] | None = None
    for _ in range(_MOST_TRIALS):
        amount = min(done + step, 1.0)
        found = newton(replace(system, amount=amount), last.point.state)
        iterations += found.iterations
        if not found.solved:
            step *= 0.5
            continue
        part = _judged(found, even)
        if part.status is AcrossStatus.SLACK or amount == 1.0:
            return _at_last(part, before, amount, iterations)
        before, done, last = (amount, part), amount, found
        step = min(2.0 * step, 1.0 - amount)
    part = _result(last, even, AcrossStatus.UNSOLVED)
    return _stopped(part, done, iterations)


def _at_last(
    part: AcrossResult, before: tuple[float, AcrossResult] | None, amount: float, iterations: int
) -> AcrossResult:
    """Say at which share of the unevenness the first strip went slack."""
    part = replace(part, iterations=iterations)
    if part.slack is None or amount == 1.0:
        return part
    first, least = (0.0, float("nan")) if before is None else (before[0], before[1].least_tension)
    if before is None:
        least = min(part.even.entry_tension, part.even.exit_tension) / part.wide.arc.width
    fall = (least - part.least_tension) / (amount - first)
    slack = replace(
        part.slack,
        share=first + least / fall,
        tension=part.least_tension - fall * (1.0 - amount),
    )
    return replace(part, slack=slack)


def _stopped(part: AcrossResult, done: float, iterations: int) -> AcrossResult:
    """Name what stopped a solve: a strip that is nearly slack, or friction at its end."""
    part = replace(part, iterations=iterations)
    arc = part.wide.arc
    slackest = min(arc.entry_tension, arc.exit_tension) / arc.width
    if done > 0.0 and part.least_tension < _NEARLY * slackest:
        fall = (slackest - part.least_tension) / done
        slack = replace(
            _slackest(part),
            share=min(slackest / fall, 1.0),
            tension=min(slackest - fall, 0.0),
        )
        return replace(part, status=AcrossStatus.SLACK, slack=slack)
    if part.even.status is Status.SOLVED and _near_gross_slip(part.even):
        return replace(part, status=AcrossStatus.BREAKAWAY)
    return part


def _near_gross_slip(even: ArcResult) -> bool:
    """Whether the even belt is within a tenth of breaking away."""
    whole = Distributed().solve(even.arc).capacities
    margin = whole.gross_slip_margin
    return math.isfinite(margin) and margin < 1.1


def _result(found: Found, even: ArcResult, status: AcrossStatus) -> AcrossResult:
    """Read off a solution along the arc what is reported."""
    system, point = found.system, found.point
    wide, state, elements = system.wide, point.state, system.elements
    arc, n, drift = wide.arc, wide.strips, system.drift(point.state)
    places = _places(found)
    creep, tension = along(found, places)
    stress = stresses(system.law, wide.shear, creep, tension / arc.radius)
    rate = drift - wide.compliance_in_wrap * elements.at_points(state.tension)
    work = elements.integral(point.stress.stress * rate, places)
    energy = work - 0.5 * wide.shear * (stress.stress**2 - stress.stress[0] ** 2)
    lag = system.entry_lag(state.entry) + creep - creep[0]
    edges = lag[:, -1] - lag[:, 0]
    static = wide.entry_profile if wide.static_profile is None else wide.static_profile
    return AcrossResult(
        status=status,
        wide=wide,
        even=even,
        angle=places / arc.radius,
        fields=Fields(
            tension=tension,
            wrap_pressure=tension / arc.radius,
            creep=creep,
            slip=stress.slip,
            shear_stress=stress.stress,
            lag=lag,
            frictional_energy=energy,
        ),
        drum_number=state.drum,
        friction_force=elements.total(point.stress.stress),
        entry_creep_ratio=drift - wide.compliance * state.entry
        if arc.recovery
        else drift - state.entry / wide.belt_modulus,
        span_tension=_span_tension(system, state.entry),
        static_tension=arc.entry_tension / arc.width + system.amount * static,
        yaw_moment=float(np.sum(state.entry * wide.position) * arc.width / n),
        entry_guide_force=float(wide.shear_stiffness * edges[0]),
        exit_guide_force=float(wide.shear_stiffness * edges[-1]),
        identity_error=_identity_error(found, lag),
        iterations=found.iterations,
    )


def _places(found: Found) -> Array:
    """Places that a result tells [m]: with that of the least tension, where it is between."""
    elements, point = found.system.elements, found.point
    places = elements.nodes[-1] * _PLACES
    p0, p1, p2 = elements.parabolas(point.pulled)
    # slope c0 + c1 x + c2 x^2 on an element, x from 0 to 1: where it rises through nothing
    c0, c1, c2 = p0 - p1 + p2, 2.0 * p1 - 6.0 * p2, 6.0 * p2
    root = np.sqrt(np.maximum(c1**2 - 4.0 * c0 * c2, 0.0))
    with np.errstate(all="ignore"):
        x = np.where(c1 > 0.0, -2.0 * c0 / (c1 + root), (root - c1) / (2.0 * c2))
    x = np.where((x > 0.0) & (x < 1.0), x, 0.0)
    least = np.cumsum(p0, axis=0) - p0 + x * (c0 + x * (c1 / 2.0 + x * c2 / 3.0))
    where = np.unravel_index(place_of_largest(-(point.state.entry + least)), least.shape)
    if x[where] == 0.0:
        return places
    element = where[0]
    return np.union1d(places, elements.nodes[element] + x[where] * elements.lengths[element])


def _without_state(wide: WideArc, even: ArcResult, status: AcrossStatus) -> AcrossResult:
    """Result where not even the even belt finds a state: nan all over."""
    strips, nan = np.full(wide.strips, math.nan), math.nan
    given: dict[str, Any] = {f.name: nan for f in fields(AcrossResult)}
    rows = np.tile(strips, (2, 1))
    return AcrossResult(
        **given
        | {
            "status": status,
            "wide": wide,
            "even": even,
            "angle": np.array([0.0, wide.arc.wrap_angle]),
            "fields": Fields(**{f.name: rows for f in fields(Fields)}),
            "friction_force": strips,
            "entry_creep_ratio": strips,
            "span_tension": strips,
            "static_tension": strips,
            "slack": None,
            "iterations": 0,
        }
    )


def _span_tension(system: System, entry: Array) -> Array:
    """Largest tension of each strip in the span before the pulley [N/m]."""
    wide = system.wide
    mean = wide.arc.entry_tension / wide.arc.width
    free = system.amount * wide.entry_profile
    span = wide.transition
    if span is None:
        return np.asarray(np.maximum(mean + free, entry))
    c = wide.modes[1:]
    if system.amount != 1.0:
        span = replace(span, strain=system.amount * span.strain)
    places = span.length * np.linspace(0.0, 2.0, _SPAN_PLACES)
    along = [span.tension(c @ entry, c @ free, d) @ c for d in places]
    return np.asarray(mean + np.max(along, axis=0))


def _identity_error(found: Found, lag: Array) -> float:
    """Relative miss of the exact balance of energy, friction read between the points of the solve.

    int int tau du ds dy = int (t1 - t2)[g + (t1 - t2)/(2 M')] dy - (S/2) int (lag_y^2)| dy
    """
    system, point = found.system, found.point
    wide, state, elements = system.wide, point.state, system.elements
    finer = replace(elements, fineness=2 * elements.fineness)
    drift, (creep, tension) = system.drift(point.state), along(found, finer.points)
    stress = stresses(system.law, wide.shear, creep, tension / wide.arc.radius).stress
    work = finer.total(stress * (drift - wide.compliance_in_wrap * tension))
    t1, t2 = state.entry, point.tension_end
    g = drift - wide.compliance_in_wrap * t1
    gained = np.sum((t1 - t2) * (g + 0.5 * (t1 - t2) * wide.compliance_in_wrap))
    gained += 0.5 * (lag[-1] @ wide.coupling @ lag[-1] - lag[0] @ wide.coupling @ lag[0])
    scale = float(np.sum(np.abs(work)))
    return abs(float(gained - np.sum(work))) / scale if scale > 0.0 else 0.0
