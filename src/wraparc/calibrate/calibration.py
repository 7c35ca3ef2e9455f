"""Calibrate: friction level, peak slip and elasticities of a drive from what was measured on it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from wraparc.arrays import Array
from wraparc.calibrate.fit import Fit
from wraparc.calibrate.problem import (
    ERRORS,
    PARAMETERS,
    QUANTITIES,
    Number,
    Prior,
    Problemset,
    Trace,
    calibrated_drive,
    value_of,
)
from wraparc.calibrate.profile_likelihood import profile_end
from wraparc.drive import Drive

__all__ = [
    "ERRORS",
    "FAR",
    "PARAMETERS",
    "QUANTITIES",
    "UNTOLD",
    "Calibration",
    "Deviation",
    "Estimate",
    "Number",
    "Prior",
    "Problemset",
    "Trace",
    "calibrate",
    "calibrated_drive",
]


#: a parameter whose data leave it a standard deviation beyond this is not told [-], in logarithm;
#: for the overrun, of its unit
UNTOLD = 0.5
#: an estimate this many times the value in the drive, or this part of it, is not believed [-]
FAR = 4.0
#: the curvature is trusted where the spread is below this at the best fit and at the start [-] ...
SURE = 0.1
#: ... or where both spreads are alike within this ratio; else the profile likelihood decides
ALIKE = 1.5


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
    expected
        Half the 95 % interval that such data promise before they are fitted, of the logarithm (of
        the overrun in 0.1 mm); inf where they promise nothing.
    parts
        Shares of the variance by what it comes from: ``readings``, and what of `ERRORS` is stated.
    """

    name: str
    value: float | None
    low: float | None
    high: float | None
    spread: float
    prior: Prior | None = None
    from_prior: bool = False
    expected: float = math.inf
    parts: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Deviation:
    """What the data say of an error that the drive was measured with.

    Attributes
    ----------
    name
        One of `ERRORS`.
    factor
        What was measured is off by, a factor near 1 [-].
    stated, left
        Standard deviation of its logarithm, as stated and as the data leave it [-].
    """

    name: str
    factor: float
    stated: float
    left: float


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
    loose
        Parameters without a value because others, fitted anew, make up for far too wide a range
        of them, though the curvature at the best fit promises less.
    misfit
        Root mean square misfit of each measurement [SI].
    data
        How many numbers were fitted.
    deviations
        One for each error that was fitted along.
    offset
        Offset e of the tension member that the zero record shows with the drum and the wheel as
        they are stated [m], None without one.
    covered
        The estimates with the cover of the belt in series, by name [SI]; none where the law says
        whether its slip includes that shear.
    """

    drive: Drive
    pulley: str
    estimates: tuple[Estimate, ...]
    correlation: Array
    mixed: tuple[tuple[str, ...], ...]
    far: tuple[str, ...]
    loose: tuple[str, ...]
    misfit: tuple[float, ...]
    data: int
    deviations: tuple[Deviation, ...] = ()
    offset: float | None = None
    covered: Mapping[str, float] = field(default_factory=dict)

    @property
    def told(self) -> bool:
        """Whether every parameter has a value."""
        return all(e.value is not None for e in self.estimates)


def calibrate(problem: Problemset) -> Calibration:
    """Fit parameters to measurements by least squares, and say what the data cannot tell.

    Parameters are fitted by their logarithm (the overrun in 0.1 mm). Intervals are 95 %, widened by
    Student's t where the noise is found from the misfit: from the curvature at the best fit, and
    from the profile likelihood where the curvature at the start says something else. A parameter is
    not told where the data alone leave it a standard deviation beyond `UNTOLD`, or the profile an
    interval wider than that comes to.

    Raises
    ------
    MissingExtraError
        Without scipy.
    InputError
        If there are fewer data than parameters, or the drive breaks away at the start.
    """
    fit = Fit(problem)
    scales = [1.0] * len(problem.traces)
    x = fit.start
    for again in range(2):
        x, _ = fit.best(x, scales)
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


def _told(problem: Problemset, fit: Fit, x: Array, scales: Sequence[float]) -> Calibration:
    names, count = problem.parameters, len(problem.parameters)
    readings = fit.jacobian(lambda v: fit.data_residuals(v, scales), x)
    known = fit.jacobian(fit.prior_residuals, x)
    # what is stated of errors is as good as data; what is known of parameters is not
    j = np.concatenate([readings, known[count:]])
    spread = _spreads(j)
    at_first = fit.jacobian(lambda v: fit.data_residuals(v, scales), fit.start)
    before = np.concatenate([at_first, known[count:]])
    begun = _spreads(before)
    both = np.concatenate([readings, known])
    covariance = np.linalg.inv(both.T @ both)
    sd = np.sqrt(np.diag(covariance))
    shares = (covariance @ known[count:].T) ** 2 / np.diag(covariance)[:, None]
    factor = _student(problem, len(readings) - count)
    values = fit.values(x)
    far = tuple(n for n in names if n not in problem.priors and _far(n, values[n], problem.start))
    estimates, loose = [], []
    for k, name in enumerate(names):
        prior = problem.priors.get(name)
        told = bool(spread[k] <= UNTOLD)
        weak = not told and prior is not None
        say = partial(
            Estimate,
            name=name,
            spread=float(spread[k]),
            expected=factor * float(begun[k]) if begun[k] <= UNTOLD else math.inf,
            parts=_parts(problem, shares[k]),
        )
        ends: tuple[float, float] | None
        ends = float(x[k] - factor * sd[k]), float(x[k] + factor * sd[k])
        if told and prior is None and name not in far and _doubtful(spread[k], begun[k]):
            ends = _profiled(fit, x, scales, k, factor * float(sd[k]), factor)
            if ends is None:
                loose.append(name)
        if name in far or ends is None or (not told and not weak):
            estimates.append(say(value=None, low=None, high=None))
            continue
        estimates.append(
            say(
                value=values[name],
                low=max(value_of(name, ends[0]), 0.0),
                high=value_of(name, ends[1]),
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
    covered = {}
    if (series := problem.covered) is not None:
        again = Fit(series)
        at = again.values(again.best(x, scales)[0])
        covered = {name: at[name] for name in kept}
    return Calibration(
        drive=calibrated_drive(problem.drive, problem.pulley, kept),
        pulley=problem.pulley,
        estimates=tuple(estimates),
        correlation=(covariance / np.outer(sd, sd))[:count, :count],
        mixed=tuple(_with_hiding(j, problem, group) for group in _mixed(j, problem.variables)),
        far=far,
        loose=tuple(loose),
        misfit=tuple(misfit),
        data=len(readings),
        deviations=tuple(
            Deviation(name=n, factor=values[n], stated=problem.errors[n], left=float(sd[k]))
            for k, n in enumerate(problem.variables)
            if n in problem.errors
        ),
        offset=fit.offset(x),
        covered=covered,
    )


def _parts(problem: Problemset, shares: Array) -> dict[str, float]:
    """Return the shares of a variance by what it comes from, the readings last."""
    parts = dict(zip(problem.errors, shares.tolist(), strict=True))
    return {**parts, "readings": max(1.0 - sum(parts.values()), 0.0)} if parts else {}


def _doubtful(spread: float, begun: float) -> bool:
    """Whether the curvature says another thing at the best fit than at the start."""
    low, high = sorted((spread, begun))
    return high > max(SURE, ALIKE * low)


def _profiled(
    fit: Fit, x: Array, scales: Sequence[float], k: int, half: float, goal: float
) -> tuple[float, float] | None:
    """Ends of an interval by profile likelihood, None where it is too wide to tell anything."""
    name = fit.problem.parameters[k]
    best, cost = fit.best(x, scales)
    reach = 2.0 * UNTOLD * goal  # the widest interval that still counts as told

    def refit(value: float, at: Array) -> tuple[float, Array]:
        held = at.copy()
        held[k] = value
        found, sum_of_squares = fit.best(held, scales, k)
        return sum_of_squares, found

    ends = []
    for side in (-1.0, 1.0):
        limit = float(best[k]) + side * reach
        if name == "overrun":
            limit = max(limit, 0.0)
        end = profile_end(refit, best, k, cost, side * half, goal, limit)
        if end is None and name == "overrun" and limit == 0.0:
            end = 0.0  # there is no overrun below none
        if end is None:
            return None
        ends.append(end)
    return None if ends[1] - ends[0] > reach else (ends[0], ends[1])


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


def _with_hiding(j: Array, problem: Problemset, group: tuple[str, ...]) -> tuple[str, ...]:
    """Return a group of one parameter with the errors that hide it: were one exact, it is told."""
    if len(group) != 1 or group[0] not in problem.parameters:
        return group
    k, count = problem.parameters.index(group[0]), len(problem.parameters)
    hiding = [
        name
        for m, name in enumerate(problem.errors, start=count)
        if _spreads(np.delete(j, m, axis=1))[k] <= UNTOLD
    ]
    return (*group, *hiding)


def _student(problem: Problemset, free: int) -> float:
    """Half width of the 95 % interval in standard deviations."""
    from scipy.stats import norm, t

    found = any(trace.sd is None for trace in problem.traces)
    if found and free > 0:
        return float(t.ppf(0.975, free))
    return float(norm.ppf(0.975))
