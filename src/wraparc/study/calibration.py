"""Calibrate: friction level, peak slip and elasticities of a drive from what was measured on it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import Distributed, Method, WrapArc
from wraparc.drive import Drive
from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.study.conditions import scaled
from wraparc.study.what_if import with_pulley

Array = NDArray[np.float64]

#: what can be calibrated, and how: factors and moduli by their logarithm, the overrun as it is
PARAMETERS = ("friction", "peak_slip", "shear_modulus", "overrun", "belt_modulus")
#: single numbers that can be measured: names of the results
QUANTITIES = (
    "exit_creep",
    "exit_slip",
    "peak_shear_angle",
    "peak_shear_stress",
    "entry_creep_ratio",
    "exit_creep_ratio",
)
#: unit of the overrun in the fit [m]
_OVERRUN_UNIT = 1e-4
#: a parameter whose data leave it a standard deviation beyond this is not told [-], in logarithm;
#: for the overrun, of its unit
UNTOLD = 0.5
#: an estimate this many times the value in the drive, or this part of it, is not believed [-]
FAR = 4.0
#: loose rein on directions that the data leave free [-]
_REIN = 3.0
_STEP = 2e-4


@dataclass(frozen=True, kw_only=True)
class Prior:
    """What is known of a parameter beforehand: mean and standard deviation, in its own unit."""

    mean: float
    sd: float


@dataclass(frozen=True, kw_only=True)
class Number:
    """One measured number.

    Attributes
    ----------
    quantity
        One of `QUANTITIES`.
    value, sd
        Measured value and its standard deviation [SI].
    load_case
        In which load case.
    """

    quantity: str
    value: float
    sd: float
    load_case: str


@dataclass(frozen=True, eq=False, kw_only=True)
class Trace:
    """A measured course along the arc.

    Attributes
    ----------
    quantity
        ``creep`` or ``shear_angle``.
    position
        theta from the entry nip, shape (n,) [rad].
    value
        Measured values, driving positive, shape (n,) [SI].
    sd
        Standard deviation of one value [SI], or None to find it from the misfit.
    load_case
        In which load case.
    """

    quantity: str
    position: Array
    value: Array
    sd: float | None
    load_case: str


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """What the data say of one parameter.

    Attributes
    ----------
    name
        One of `PARAMETERS`.
    value, low, high
        Best estimate and the ends of its 95 % interval [SI], None where the data cannot tell.
    spread
        Standard deviation from the data alone: of the logarithm, of the overrun in 0.1 mm; inf if
        the data say nothing.
    prior
        What was known beforehand, or None.
    from_prior
        Whether the value comes from the prior rather than from the data.
    """

    name: str
    value: float | None
    low: float | None
    high: float | None
    spread: float
    prior: Prior | None = None
    from_prior: bool = False


@dataclass(frozen=True, eq=False)
class Calibration:
    """The result of a calibration.

    Attributes
    ----------
    drive
        The drive with the estimates put in; as it was where a parameter is not told.
    pulley
        Name of the pulley.
    estimates
        One for each parameter that was asked for.
    correlation
        Correlations of the estimates, shape (n, n) [-].
    mixed
        Groups of parameters that the data cannot tell apart.
    far
        Parameters without a value because the best fit lies more than `FAR` times off.
    misfit
        Root mean square misfit of each measurement [SI].
    data
        How many numbers were fitted.
    """

    drive: Drive
    pulley: str
    estimates: tuple[Estimate, ...]
    correlation: Array
    mixed: tuple[tuple[str, ...], ...]
    far: tuple[str, ...]
    misfit: tuple[float, ...]
    data: int

    @property
    def told(self) -> bool:
        """Whether every parameter has a value."""
        return all(e.value is not None for e in self.estimates)


@dataclass(frozen=True, eq=False, kw_only=True)
class Problemset:
    """What is calibrated to what.

    Attributes
    ----------
    drive, pulley
        The drive and the name of its pulley.
    parameters
        Names of what is to be found.
    numbers, traces
        Measurements.
    priors
        By parameter.
    method
        What solves the arc.

    Raises
    ------
    InputError
        If there are fewer data than parameters.
    """

    drive: Drive
    pulley: str
    parameters: tuple[str, ...]
    numbers: tuple[Number, ...] = ()
    traces: tuple[Trace, ...] = ()
    priors: Mapping[str, Prior] = field(default_factory=dict)
    method: Method = field(default_factory=lambda: Distributed(points=120, capacities=False))

    def __post_init__(self) -> None:
        data = len(self.numbers) + sum(len(t.position) for t in self.traces)
        known = data + len(self.priors)
        if known < len(self.parameters):
            what = "1 number" if known == 1 else f"{known} numbers"
            raise InputError(
                Problem(
                    key="parameters",
                    value=", ".join(self.parameters),
                    message=f"{len(self.parameters)} parameters, and only {what} to find them from",
                    remedy="Calibrate fewer, measure more, or give priors.",
                )
            )

    @property
    def start(self) -> dict[str, float]:
        """Values of the parameters in the drive as it is [SI]."""
        pulley = self.drive.pulley(self.pulley)
        case = self.drive.load_cases[0]
        overrun = WrapArc.of(self.drive, pulley, case).entry_overrun
        return {
            "friction": 1.0,
            "peak_slip": 1.0,
            "shear_modulus": pulley.lagging.shear_modulus,
            "overrun": overrun,
            "belt_modulus": self.drive.belt.modulus,
        }


def calibrated_drive(drive: Drive, pulley: str, values: Mapping[str, float]) -> Drive:
    """Return the drive with parameters put in: factors on the law; moduli and overrun [SI]."""
    base = drive.pulley(pulley)
    law = scaled(base.lagging.law, values.get("friction", 1.0), values.get("peak_slip", 1.0))
    lagging = replace(
        base.lagging, law=law, shear_modulus=values.get("shear_modulus", base.lagging.shear_modulus)
    )
    changed = with_pulley(
        drive, replace(base, lagging=lagging, overrun=values.get("overrun", base.overrun))
    )
    if "belt_modulus" in values:
        changed = replace(changed, belt=replace(drive.belt, modulus=values["belt_modulus"]))
    return changed


def calibrate(problem: Problemset) -> Calibration:
    """Fit parameters to measurements by least squares, and say what the data cannot tell.

    Parameters are fitted by their logarithm (the overrun in 0.1 mm). Intervals are 95 %, from the
    curvature at the best fit, widened by Student's t where the noise is found from the misfit. A
    parameter is not told where the data alone leave it a standard deviation beyond `UNTOLD`.

    Raises
    ------
    MissingExtraError
        Without scipy.
    InputError
        If there are fewer data than parameters, or the drive breaks away at the start.
    """
    fit = _Fit(problem)
    scales = [1.0] * len(problem.traces)
    x = fit.start
    for again in range(2):
        x = fit.best(x, scales)
        misfits = [fit.misfit(x, t) for t in problem.traces]
        new = [
            m / s if trace.sd is None else 1.0
            for m, s, trace in zip(misfits, fit.first_sd, problem.traces, strict=True)
        ]
        near = all(0.7 < n / o < 1.4 for n, o in zip(new, scales, strict=True))
        scales = new
        if again or near:  # the weights of the signals hardly move
            break
    return _told(problem, fit, x, scales)


class _Fit:
    """Residuals of a problem in the fitted variables."""

    def __init__(self, problem: Problemset) -> None:
        self.problem = problem
        start = problem.start
        if not all(math.isfinite(start[n]) for n in problem.parameters):
            rigid = [n for n in problem.parameters if not math.isfinite(start[n])]
            message = "infinite in the drive, so there is nothing to start from"
            raise InputError(Problem(key=f"parameters.{rigid[0]}", message=message))
        self.start = np.array([_variable(n, start[n]) for n in problem.parameters])
        self._known: dict[bytes, tuple[list[float], list[Array]]] = {}
        self.first_sd = [
            t.sd if t.sd is not None else 0.01 * float(np.abs(t.value).max())
            for t in problem.traces
        ]

    def values(self, x: Array) -> dict[str, float]:
        """Parameters by name [SI]."""
        return {n: _value(n, v) for n, v in zip(self.problem.parameters, x.tolist(), strict=True)}

    def model(self, x: Array) -> tuple[list[float], list[Array]]:
        """What would be measured with parameters."""
        key = x.tobytes()
        if key not in self._known:
            self._known = {key: self._solved(x)}  # the last one only: it is asked for again
        return self._known[key]

    def _solved(self, x: Array) -> tuple[list[float], list[Array]]:
        p = self.problem
        drive = calibrated_drive(p.drive, p.pulley, self.values(x))
        cases = {c.name: c for c in drive.load_cases}
        used = {n.load_case for n in p.numbers} | {t.load_case for t in p.traces}
        results = {
            name: p.method.solve(WrapArc.of(drive, drive.pulley(p.pulley), cases[name]))
            for name in sorted(used)
        }
        numbers = [float(results[n.load_case].scalars()[n.quantity]) for n in p.numbers]
        traces = []
        for t in p.traces:
            profile = results[t.load_case].profile
            traces.append(np.interp(t.position, profile.position, getattr(profile, t.quantity)))
        return numbers, traces

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
        for k, name in enumerate(self.problem.parameters):
            prior = self.problem.priors.get(name)
            centre, sd = float(self.start[k]), _REIN
            if prior is not None:
                centre = _variable(name, prior.mean)
                sd = prior.sd / _OVERRUN_UNIT if name == "overrun" else prior.sd / prior.mean
            elif name == "overrun":
                sd = 100.0
            rows.append((x[k] - centre) / sd)
        return np.array(rows)

    def best(self, x: Array, scales: Sequence[float]) -> Array:
        """Least squares from a start."""
        try:
            from scipy.optimize import least_squares
        except ImportError as error:
            raise MissingExtraError("scipy", "study") from error

        def residuals(v: Array) -> Array:
            return np.concatenate([self.data_residuals(v, scales), self.prior_residuals(v)])

        low = [0.0 if n == "overrun" else -np.inf for n in self.problem.parameters]
        begin = np.maximum(x, np.array(low) + 1e-6)
        found: Any = least_squares(
            residuals,
            begin,
            jac=partial(self.jacobian, residuals),
            bounds=(low, np.inf),
            xtol=1e-7,
            ftol=1e-9,
            gtol=1e-9,
            max_nfev=60,
        )
        return np.asarray(found.x, dtype=float)

    def jacobian(self, residuals: Callable[[Array], Array], x: Array) -> Array:
        """Differences of residuals by each variable."""
        here, columns = residuals(x), []
        for k, name in enumerate(self.problem.parameters):
            step = _STEP if name != "overrun" else 10.0 * _STEP
            aside = x.copy()
            aside[k] += step
            columns.append((residuals(aside) - here) / step)
        return np.stack(columns, axis=1)

    def misfit(self, x: Array, trace: Trace) -> float:
        """Root mean square misfit of a trace, for as many degrees of freedom as it has."""
        m = self.model(x)[1][self.problem.traces.index(trace)]
        free = max(len(m) - len(x) / max(1, len(self.problem.traces)), 1.0)
        return float(np.sqrt(np.sum((m - trace.value) ** 2) / free))


def _variable(name: str, value: float) -> float:
    return value / _OVERRUN_UNIT if name == "overrun" else math.log(value)


def _value(name: str, variable: float) -> float:
    return variable * _OVERRUN_UNIT if name == "overrun" else math.exp(variable)


def _told(problem: Problemset, fit: _Fit, x: Array, scales: Sequence[float]) -> Calibration:
    names = problem.parameters
    j = fit.jacobian(lambda v: fit.data_residuals(v, scales), x)
    spread = _spreads(j)
    both = np.concatenate([j, fit.jacobian(fit.prior_residuals, x)])
    covariance = np.linalg.inv(both.T @ both)
    sd = np.sqrt(np.diag(covariance))
    factor = _student(problem, len(j) - len(names))
    values = fit.values(x)
    far = tuple(n for n in names if n not in problem.priors and _far(n, values[n], problem.start))
    estimates = []
    for k, name in enumerate(names):
        prior = problem.priors.get(name)
        told = bool(spread[k] <= UNTOLD)
        weak = not told and prior is not None
        if name in far or (not told and not weak):
            estimates.append(Estimate(name=name, value=None, low=None, high=None, spread=spread[k]))
            continue
        ends = [_value(name, float(x[k] + s * factor * sd[k])) for s in (-1.0, 1.0)]
        estimates.append(
            Estimate(
                name=name,
                value=values[name],
                low=max(ends[0], 0.0),
                high=ends[1],
                spread=float(spread[k]),
                prior=prior,
                from_prior=weak,
            )
        )
    kept = {e.name: e.value for e in estimates if e.value is not None}
    numbers, traces = fit.model(x)
    misfit = [abs(m - n.value) for m, n in zip(numbers, problem.numbers, strict=True)]
    misfit += [
        float(np.sqrt(np.mean((m - t.value) ** 2)))
        for m, t in zip(traces, problem.traces, strict=True)
    ]
    return Calibration(
        drive=calibrated_drive(problem.drive, problem.pulley, kept),
        pulley=problem.pulley,
        estimates=tuple(estimates),
        correlation=covariance / np.outer(sd, sd),
        mixed=_mixed(j, names),
        far=far,
        misfit=tuple(misfit),
        data=len(j),
    )


def _far(name: str, value: float, start: Mapping[str, float]) -> bool:
    """Whether an estimate is too far from the drive to be anything but a misfit of its inputs."""
    if name == "overrun":
        return False
    return abs(math.log(value / start[name])) > math.log(FAR)


def _spreads(j: Array) -> Array:
    """Standard deviation of every variable from the data alone, inf where they say nothing."""
    _, s, vt = np.linalg.svd(j, full_matrices=True)
    inverse = np.zeros(j.shape[1])
    inverse[: len(s)] = s
    deviation = np.full(j.shape[1], np.inf)
    seen = inverse > 1e-9 * max(float(s[0]), 1e-300)
    deviation[seen] = 1.0 / inverse[seen]
    share = vt.T**2
    with np.errstate(invalid="ignore"):
        parts = np.where(share > 1e-12, share * deviation**2, 0.0)
    return np.asarray(np.sqrt(parts.sum(axis=1)))


def _mixed(j: Array, names: Sequence[str]) -> tuple[tuple[str, ...], ...]:
    """Groups of parameters that share a direction the data leave free."""
    _, s, vt = np.linalg.svd(j, full_matrices=True)
    strength = np.zeros(j.shape[1])
    strength[: len(s)] = s
    groups = []
    for k in range(j.shape[1]):
        if strength[k] * UNTOLD < 1.0:
            group = tuple(n for n, part in zip(names, vt[k], strict=True) if abs(part) > 0.2)
            groups.append(group)
    return tuple(groups)


def _student(problem: Problemset, free: int) -> float:
    """Half width of the 95 % interval in standard deviations."""
    from scipy.stats import norm, t

    found = any(trace.sd is None for trace in problem.traces)
    if found and free > 0:
        return float(t.ppf(0.975, free))
    return float(norm.ppf(0.975))
