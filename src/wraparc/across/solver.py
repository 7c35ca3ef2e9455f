"""Solve one arc across the width."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from wraparc.across.compiled import Marches, quickest
from wraparc.across.mesh import Mesh, mesh_of
from wraparc.across.newton import Found, System, Unknowns, newton, started
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


@dataclass(frozen=True)
class AcrossSolver:
    """Strips across the width, marched together.

    Attributes
    ----------
    steps
        Mesh steps over the arc; 48 leave 1e-7 to 5e-6 of the entry tension, less than strips do.
    marches
        What carries the strips along the arc: compiled once that is prepared in this process.
    """

    steps: int = 48
    marches: Marches = field(default_factory=quickest)

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
        mesh = mesh_of(wide, even, self.steps)
        system = System(wide, mesh, self.marches)
        begin = started(wide, even, mesh)
        if start is not None and start.status.solved:
            found = newton(system, _from(start, mesh))
            if found.solved:
                return _judged(found, even)
        found = newton(system, begin)
        if found.solved:
            return _judged(found, even)
        return _gradually(system, begin, even, found.iterations)


def _from(result: AcrossResult, mesh: Mesh) -> Unknowns:
    """The unknowns of a result, at the cuts of another mesh."""
    fields, places = result.fields, mesh.nodes[list(mesh.cuts[1:-1])] / result.wide.arc.radius
    columns = np.concatenate([fields.tension, fields.creep], axis=1)
    states = np.array([[np.interp(s, result.angle, c) for c in columns.T] for s in places])
    states = states.reshape(len(places), columns.shape[1])
    return Unknowns(fields.tension[0], result.drum_number, states)


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


def _gradually(system: System, start: Unknowns, even: ArcResult, iterations: int) -> AcrossResult:
    """Put the unevenness on little by little; where it will not go further, say why."""
    done, step, last = 0.0, 0.5, Found(replace(system, amount=0.0), start, True, 0)
    before: tuple[float, AcrossResult] | None = None
    for _ in range(_MOST_TRIALS):
        amount = min(done + step, 1.0)
        found = newton(replace(system, amount=amount), last.unknowns)
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
    """Trace a solution along the arc and read off it what is reported."""
    system, at = found.system, found.unknowns
    wide, mesh = system.wide, system.mesh
    n, arc = wide.strips, wide.arc
    records, _, drift = system.trace(at)
    tension, creep, work = records[:, :n], records[:, n : 2 * n], records[:, 2 * n : 3 * n]
    kick = creep[0]
    lag1 = entry_lag(system, at)
    stress, slip = _stress_and_slip(wide, tension, creep)
    energy = work - 0.5 * wide.shear * (stress**2 - stress[0] ** 2)
    lag = lag1 + creep - kick
    fields = Fields(
        tension=tension,
        wrap_pressure=tension / arc.radius,
        creep=creep,
        slip=slip,
        shear_stress=stress,
        lag=lag,
        frictional_energy=energy,
    )
    edges = lag[:, -1] - lag[:, 0]
    width = arc.width / n
    static = wide.entry_profile if wide.static_profile is None else wide.static_profile
    return AcrossResult(
        status=status,
        wide=wide,
        even=even,
        angle=mesh.nodes / arc.radius,
        fields=fields,
        drum_number=at.drum,
        friction_force=records[-1, 3 * n :],
        entry_creep_ratio=drift - wide.compliance * tension[0]
        if arc.recovery
        else drift - tension[0] / wide.belt_modulus,
        span_tension=_span_tension(system, tension[0]),
        static_tension=arc.entry_tension / arc.width + system.amount * static,
        yaw_moment=float(np.sum(tension[0] * wide.position) * width),
        entry_guide_force=float(wide.shear_stiffness * edges[0]),
        exit_guide_force=float(wide.shear_stiffness * edges[-1]),
        identity_error=_identity_error(wide, drift, fields, work[-1]),
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


def entry_lag(system: System, at: Unknowns) -> Array:
    """Lag of the label line at the entry nip by strip, mean 0 [m]."""
    wide = system.wide
    misfit = system.amount * wide.spread(np.ones(wide.strips - 1)) @ wide.entry_misfit
    free = system.amount * wide.entry_profile - at.tension
    return np.asarray(misfit + wide.spread(wide.length_before) @ free / wide.belt_modulus)


def _stress_and_slip(wide: WideArc, tension: Array, creep: Array) -> tuple[Array, Array]:
    """Shear stress [Pa] and slip [m] over arc and width."""
    law, shape = wide.arc.law.compact(), tension.shape
    shear = np.broadcast_to(wide.shear, shape).ravel()
    found = stresses(law, wide.knots, shear, creep.ravel(), tension.ravel() / wide.arc.radius)
    return found[0].reshape(shape), found[3].reshape(shape)


def _identity_error(wide: WideArc, drift: Array, fields: Fields, work: Array) -> float:
    """Relative miss of the exact balance of energy.

    int int tau du ds dy = int (t1 - t2)[g + (t1 - t2)/(2 M')] dy - (S/2) int (lag_y^2)| dy
    """
    numbers = wide.numbers
    t1, t2 = fields.tension[0], fields.tension[-1]
    g = drift - numbers.compliance * t1
    gained = np.sum((t1 - t2) * (g + 0.5 * (t1 - t2) * numbers.compliance))
    first, last = fields.lag[0], fields.lag[-1]
    gained += 0.5 * (last @ numbers.coupling @ last - first @ numbers.coupling @ first)
    whole = float(np.sum(work))
    scale = float(np.sum(np.abs(work)))
    return abs(float(gained) - whole) / scale if scale > 0.0 else 0.0
