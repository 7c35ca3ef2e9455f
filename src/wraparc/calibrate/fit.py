"""Least squares of a calibration: residuals of the data and priors, and their derivatives."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from wraparc.arc import ArcResult, Distributed
from wraparc.arrays import Array
from wraparc.calibrate.problem import (
    OVERRUN_UNIT,
    Problemset,
    State,
    Trace,
    arc_of,
    calibrated_drive,
    most_pull,
    offset_by,
    predicted_number,
    value_of,
    variable_of,
)
from wraparc.errors import InputError, MissingExtraError, input_error

Solved = dict[State, ArcResult]

# how exactly to fit: the best fit, and a refit of which only the sum of squares counts
_FULLY: dict[str, Any] = {"xtol": 1e-7, "ftol": 1e-9, "gtol": 1e-9, "max_nfev": 60}
_ENOUGH: dict[str, Any] = {"xtol": 1e-4, "ftol": 2e-4, "gtol": 1e-9, "max_nfev": 20}
#: loose rein on directions that the data leave free [-]
_REIN = 3.0
#: how many times off a trial may be [-]: far beyond what is told, and short of what no drive may be
_FARTHEST = 100.0
_STEP = 2e-4
#: errors that change no arc
_OF_SPEEDS = ("speed_zero", "speed_by_torque")
#: points whose arcs are kept: the end of a usual fit asks again for its start and its best
_KEPT = 64
#: misfit of a trial at gross slip over the size of what was measured [-]: more than a drive that
#: just carries its load creeps
_GROSS_SLIP = 200.0
#: Of a trial that is no drive, whose belt would be slack: more than of any at gross slip [-].
_IMPOSSIBLE = 1e4


class Fit:
    """Residuals of a problem in the fitted variables."""

    def __init__(self, problem: Problemset) -> None:
        self.problem = problem
        start = problem.start
        if not all(math.isfinite(start[n]) for n in problem.parameters):
            rigid = [n for n in problem.parameters if not math.isfinite(start[n])]
            message = "infinite in the drive, so there is nothing to start from"
            raise input_error(key=f"parameters.{rigid[0]}", message=message)
        self.names = problem.variables
        self.start = np.array([variable_of(n, start[n]) for n in self.names])
        # a zero of the speeds changes no arc: those are solved for the other variables
        self._arcs_of = [k for k, n in enumerate(self.names) if n not in _OF_SPEEDS]
        self._most = most_pull(problem.drive, problem.pulley)
        self._known: dict[bytes, Solved] = {}
        self.first_sd = [
            t.sd if t.sd is not None else 0.01 * float(np.abs(t.value).max())
            for t in problem.traces
        ]

    def values(self, x: Array) -> dict[str, float]:
        """Parameters by name [SI], those that are not an overrun at most `_FARTHEST` times off."""
        most = math.log(_FARTHEST)
        near = np.clip(x, self.start - most, self.start + most)
        held = np.where([name == "overrun" for name in self.names], x, near)
        return {n: value_of(n, v) for n, v in zip(self.names, held.tolist(), strict=True)}

    def model(self, x: Array) -> tuple[list[float], list[Array]]:
        """What would be measured with parameters."""
        p, key = self.problem, x[self._arcs_of].tobytes()
        if key not in self._known:
            if len(self._known) == _KEPT:
                del self._known[next(iter(self._known))]
            self._known[key] = self._solved(x)
        results = self._known[key]
        if not results:
            return self._impossible()
        values = self.values(x)
        zero, slope = values.get("speed_zero", 1.0), values.get("speed_by_torque", 1.0) - 1.0
        beyond = {name: 0.0 if r.status.solved else _beyond(r) for name, r in results.items()}
        numbers = []
        for n in p.numbers:
            result, far = results[n.state], beyond[n.state]
            share = (result.arc.entry_tension - result.arc.exit_tension) / self._most
            value = predicted_number(result, n, zero * (1.0 - slope * share))
            numbers.append(n.value + far * max(abs(n.value), n.sd) if far else value)
        traces = []
        for t in p.traces:
            state: State = (t.load_case, None)
            profile, far = results[state].profile, beyond[state]
            if far:
                traces.append(t.value + far * float(np.abs(t.value).max()))
                continue
            traces.append(np.interp(t.position, profile.position, getattr(profile, t.quantity)))
        return numbers, traces

    def _solved(self, x: Array) -> Solved:
        """Return the arcs with parameters; none where a trial is no drive, such as a slack belt."""
        p, values = self.problem, self.values(x)
        drive = calibrated_drive(p.drive, p.pulley, values)
        errors = {name: values[name] for name in p.errors}
        try:
            arcs = {state: arc_of(drive, p.pulley, state, errors) for state in p.used}
        except InputError:
            if np.array_equal(x, self.start):  # so is the drive that was given
                raise
            return {}
        return {state: p.method.solve(arc) for state, arc in arcs.items()}

    def _impossible(self) -> tuple[list[float], list[Array]]:
        """Return what is farther from every measurement than any drive is."""
        p = self.problem
        numbers = [n.value + _IMPOSSIBLE * max(abs(n.value), n.sd) for n in p.numbers]
        traces = [t.value + _IMPOSSIBLE * float(np.abs(t.value).max()) for t in p.traces]
        return numbers, traces

    def offset(self, x: Array) -> float | None:
        """Offset e that the zero record shows with drum and wheel as stated [m], None without one.

        Corrected for the creep, the compression and the strain there, see `speed_over_shaft`.
        """
        zero = self.problem.zero
        if zero is None:
            return None
        self.model(x)
        result = self._known[x[self._arcs_of].tobytes()][zero.state]
        return offset_by(result.arc, result.entry_creep_ratio, zero)

    def data_residuals(self, x: Array, scales: Sequence[float]) -> Array:
        """Misfits over their standard deviations."""
        numbers, traces = self.model(x)
        p = self.problem
        parts = [np.array([(m - n.value) / n.sd for m, n in zip(numbers, p.numbers, strict=True)])]
        for m, t, sd, scale in zip(traces, p.traces, self.first_sd, scales, strict=True):
            parts.append((m - t.value) / (sd * scale))
        return np.concatenate(parts)

    def prior_residuals(self, x: Array) -> Array:
        """How far the parameters are from their priors, and a loose rein on those without."""
        rows = []
        for k, name in enumerate(self.names):
            prior = self.problem.priors.get(name)
            centre, sd = float(self.start[k]), _REIN
            if prior is not None:
                centre = variable_of(name, prior.mean)
                sd = prior.sd / OVERRUN_UNIT if name == "overrun" else prior.sd / prior.mean
            elif name in self.problem.errors:
                sd = self.problem.errors[name]
            elif name == "overrun":
                sd = 100.0
            rows.append((x[k] - centre) / sd)
        return np.array(rows)

    def best(
        self, x: Array, scales: Sequence[float], held: int | None = None
    ) -> tuple[Array, float]:
        """Least squares from a start, one variable held or none; the sum of squares with it."""
        try:
            from scipy.optimize import least_squares
        except ImportError as error:
            raise MissingExtraError("scipy", "study") from error

        free = [k for k in range(len(x)) if k != held]

        def whole(v: Array) -> Array:
            full = x.copy()
            full[free] = v
            return full

        def residuals(v: Array) -> Array:
            at = whole(v)
            return np.concatenate([self.data_residuals(at, scales), self.prior_residuals(at)])

        if not free:
            return x, float(np.sum(residuals(x[free]) ** 2))
        names = [self.names[k] for k in free]
        low = [0.0 if n == "overrun" else -np.inf for n in names]
        begin = np.maximum(x[free], np.array(low) + 1e-6)
        found: Any = least_squares(
            residuals,
            begin,
            jac=partial(_jacobian, residuals, names),
            bounds=(low, np.inf),
            **(_FULLY if held is None else _ENOUGH),
        )
        return whole(np.asarray(found.x, dtype=float)), 2.0 * float(found.cost)

    def jacobian(self, residuals: Callable[[Array], Array], x: Array) -> Array:
        """Differences of residuals by each variable."""
        return _jacobian(residuals, self.names, x)

    def misfit(self, x: Array, trace: Trace) -> float:
        """Root mean square misfit of a trace, for as many degrees of freedom as it has."""
        m = self.model(x)[1][self.problem.traces.index(trace)]
        free = max(len(m) - len(self.problem.parameters) / max(1, len(self.problem.traces)), 1.0)
        return float(np.sqrt(np.sum((m - trace.value) ** 2) / free))


def _jacobian(residuals: Callable[[Array], Array], names: Sequence[str], x: Array) -> Array:
    """Differences of residuals by each variable, shape (data, variables)."""
    here, columns = residuals(x), []
    for k, name in enumerate(names):
        step = _STEP if name != "overrun" else 10.0 * _STEP
        aside = x.copy()
        aside[k] += step
        columns.append((residuals(aside) - here) / step)
    return np.stack(columns, axis=1)


def _beyond(result: ArcResult) -> float:
    """Misfit of a trial that friction cannot carry [-]: the farther beyond it, the larger.

    There is no state to compare then; this leads a search back to where there is one.
    """
    margin = Distributed().solve(result.arc).capacities.extrapolated_gross_slip_margin
    return _GROSS_SLIP * (1.0 - math.log(min(margin, 1.0)))
