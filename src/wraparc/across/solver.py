"""Solve one arc across the width."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any, NamedTuple

import numpy as np

from wraparc.across.collocation import Found, State, System, along, between, newton, started
from wraparc.across.elements import Elements, graded
from wraparc.across.result import AcrossResult, AcrossStatus, Fields, Slack
from wraparc.across.stresses import stresses
from wraparc.across.wide_arc import WideArc
from wraparc.alike import place_of_largest
from wraparc.arc import ArcResult, Distributed, Status
from wraparc.arrays import Array

#: trials of putting the unevenness on little by little, where it fails all at once
_MOST_TRIALS = 12
#: places along a transition where the tension is looked at
_SPAN_PLACES = 41
#: a share of the tension lacking that counts as nothing, where the share of slack is sought
_NOTHING = 3e-3
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
        found = newton(system, started(system, even))
        return self._finer(found, even) if found.solved else self._gradually(found, even)

    def _finer(self, found: Found, even: ArcResult) -> AcrossResult:
        """Refine a solution until its error is as small as asked for."""
        error = math.inf
        for count, fineness in _LEVELS:
            if count <= len(found.system.elements.lengths):
                continue
            last = found
            elements = Elements(graded(even.arc.length, count), fineness)
            found = newton(replace(last.system, elements=elements), between(last, elements.stages))
            found = found._replace(iterations=last.iterations + found.iterations)
            if not found.solved:
                return self._gradually(found, even)
            error = distance(last, found) / _GAIN
            if least_tension(found).tension <= 0.0:
                return _slack(found, even)
            if error < self.accuracy:
                break
        return replace(_result(found, even, AcrossStatus.SOLVED), error_estimate=error)

    def _gradually(self, failed: Found, even: ArcResult) -> AcrossResult:
        """Put the unevenness on little by little; where it will not go further, say why."""
        last = _without_defects(failed.system, even)
        iterations, step = failed.iterations, 0.5
        for _ in range(_MOST_TRIALS):
            amount = min(last.system.amount + step, 1.0)
            found = newton(replace(failed.system, amount=amount), last.point.state)
            iterations += found.iterations
            found = found._replace(iterations=iterations)
            if not found.solved:
                step *= 0.5
                continue
            if least_tension(found).tension <= 0.0:
                return _slack(found, even)
            if amount == 1.0:
                return self._finer(found, even)
            last, step = found, 2.0 * step
        part = _result(last._replace(iterations=iterations), even, AcrossStatus.UNSOLVED)
        return replace(part, status=AcrossStatus.BREAKAWAY) if _near_gross_slip(even) else part


def distance(one: Found, other: Found) -> float:
    """How far two solutions are apart: tensions, creep, Gamma, over the largest of each.

    Of creep and Gamma no less than a thousandth of what the belt strains counts as largest.
    """
    a, b, system = one.point, other.point, one.system
    strain = 1e-3 * float(np.max(b.state.entry)) * system.drum_unit
    pairs = (
        (a.state.entry, b.state.entry, 0.0), (a.tension_end, b.tension_end, 0.0),
        (a.creep_end, b.creep_end, strain * system.wide.arc.length),
        (a.state.drum, b.state.drum, strain),
    )  # fmt: skip
    return max(float(np.max(np.abs(x - y)) / max(np.max(np.abs(y)), z)) for x, y, z in pairs)


def _from(result: AcrossResult, system: System) -> State:
    """The state of a result, on other elements."""
    places = system.elements.stages / result.wide.arc.radius
    columns = [np.interp(places, result.angle, c) for c in result.fields.tension.T]
    return State(np.array(columns).T, result.entry_tension, result.drum_number)


class Least(NamedTuple):
    """The least tension above m v^2/B on the arc [N/m], its place there [m] and its strip."""

    tension: float
    place: float
    strip: int


def least_tension(found: Found) -> Least:
    """Least tension that presses, by the solution's parabolas: between its points, too."""
    elements, point = found.system.elements, found.point
    p0, p1, p2 = elements.parabolas(point.pulled)
    # slope c0 + c1 x + c2 x^2 on an element, x from 0 to 1: where it rises through nothing
    c0, c1, c2 = p0 - p1 + p2, 2.0 * p1 - 6.0 * p2, 6.0 * p2
    root: Array = np.sqrt(np.maximum(c1**2 - 4.0 * c0 * c2, 0.0))
    with np.errstate(all="ignore"):
        x = np.where(c1 > 0.0, -2.0 * c0 / (c1 + root), (root - c1) / (2.0 * c2))
    x = np.where((x > 0.0) & (x < 1.0), x, 0.0)
    fall = np.cumsum(p0, axis=0) - p0 + x * (c0 + x * (c1 / 2.0 + x * c2 / 3.0))
    tension = np.vstack([point.state.entry + fall, point.tension_end])
    place = elements.nodes[:, None] + np.vstack([x * elements.lengths[:, None], 0.0 * x[:1]])
    row, strip = np.unravel_index(place_of_largest(-tension), tension.shape)
    least = float(tension[row, strip]) - found.system.wide.lift
    return Least(least, float(place[row, strip]), int(strip))


def _without_defects(system: System, even: ArcResult) -> Found:
    none = replace(system, amount=0.0)
    return Found(none, none.at(started(none, even)), True, 0)


def _slack(found: Found, even: ArcResult) -> AcrossResult:
    """Result of a belt that goes slack: where, from which share of its unevenness on, how far.

    The share where the least tension is nothing is found by false position (Illinois).
    """
    result, least = _result(found, even, AcrossStatus.SLACK), least_tension(found)
    arc, amount = even.arc, found.system.amount
    low, high, at = 0.0, amount, _without_defects(found.system, even)
    above = min(arc.entry_tension, arc.exit_tension) / arc.width - found.system.wide.lift
    below = least.tension
    for _ in range(_MOST_TRIALS):
        share = (low * below - high * above) / (below - above)
        trial = newton(replace(found.system, amount=share), at.point.state)
        there = least_tension(trial).tension
        if not trial.solved or abs(there) < _NOTHING * abs(least.tension):
            break
        if there > 0.0:
            low, above, below, at = share, there, 0.5 * below, trial
        else:
            high, below, above = share, there, 0.5 * above
    slack = Slack(
        position=float(result.position[least.strip]),
        angle=least.place / arc.radius,
        tension=least.tension * (1.0 - share) / (amount - share),
        share=share,
    )
    return replace(result, slack=slack)


def _near_gross_slip(even: ArcResult) -> bool:
    """Whether the even belt is within a tenth of breaking away."""
    whole = Distributed().solve(even.arc).capacities
    margin = whole.extrapolated_gross_slip_margin
    return math.isfinite(margin) and margin < 1.1


def _result(found: Found, even: ArcResult, status: AcrossStatus) -> AcrossResult:
    """Read off a solution along the arc what is reported."""
    system, point = found.system, found.point
    wide, state, elements = system.wide, point.state, system.elements
    arc, drift = wide.arc, system.drift(point.state)
    places = np.union1d(arc.length * _PLACES, least_tension(found).place)
    creep, tension = along(found, places)
    stress = stresses(system.law, wide.shear, creep, wide.pressure(tension))
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
            wrap_pressure=wide.pressure(tension),
            creep=creep,
            slip=stress.slip,
            shear_stress=stress.stress,
            lag=lag,
            frictional_energy=energy,
        ),
        drum_number=state.drum,
        friction_force=wide.pulled_share * elements.total(point.stress.stress),
        entry_creep_ratio=drift - wide.compliance * state.entry
        if arc.recovery
        else drift - state.entry / wide.belt_modulus,
        span_tension=_span_tension(system, state.entry),
        static_tension=arc.entry_tension / arc.width + system.amount * static,
        yaw_moment=float(np.sum(state.entry * wide.position) * arc.width / wide.strips),
        entry_guide_force=float(wide.shear_stiffness * edges[0]),
        exit_guide_force=float(wide.shear_stiffness * edges[-1]),
        identity_error=_identity_error(found, lag),
        iterations=found.iterations,
    )


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
    stress = stresses(system.law, wide.shear, creep, wide.pressure(tension)).stress
    work = wide.pulled_share * finer.total(stress * (drift - wide.compliance_in_wrap * tension))
    t1, t2 = state.entry, point.tension_end
    g = drift - wide.compliance_in_wrap * t1
    gained = np.sum((t1 - t2) * (g + 0.5 * (t1 - t2) * wide.compliance_in_wrap))
    gained += 0.5 * (lag[-1] @ wide.coupling @ lag[-1] - lag[0] @ wide.coupling @ lag[0])
    scale = float(np.sum(np.abs(work)))
    return abs(float(gained - np.sum(work))) / scale if scale > 0.0 else 0.0
