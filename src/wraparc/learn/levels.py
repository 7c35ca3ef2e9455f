"""What the friction of a pulley may be: the posterior along its level, not at its maximum alone.

The lower the creep is, the less it says of friction: the posterior of ln friction is skewed to high
values, and its maximum is below most of it. So friction is held at some values, everything else is
fitted anew at each, and their weights are those of the posterior there (Laplace's formula for the
rest). Draws of all unknowns are taken along that.

A motor speed that is bent by torque passes for friction. What is stated of it may be grossly wrong,
as some per cent of all data are: so some draws are those with ten times the error, as many as the
log makes probable (a contaminated normal prior).
"""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np

from wraparc.arrays import Array
from wraparc.learn.fit import CellProblem, LearnFit, far_weight, whiten

#: Values of ln friction over its standard deviation at the maximum, and draws.
_PLACES = np.linspace(-3.0, 4.5, 11)
DRAWS = 1000
#: How exactly friction is held, Gauss-Newton steps at each value, and a change that ends them [-].
_HELD, _STEPS, _SMALL = 1e-4, 4, 1e-3
#: Part of statements that are grossly wrong (Hampel et al., Robust Statistics, 1986, 1.2c: 1 to
#: 10 % of routine data), and by what factor: ten times what is assumed of an estimated speed is
#: the slip of a motor, left out [-].
_GROSS_PART, _GROSS = 0.05, 10.0


@dataclass(frozen=True, eq=False)
class FrictionDraws:
    """Draws of all unknowns of a fit, along the friction of one pulley at the end of the log.

    Attributes
    ----------
    unknowns
        One draw a row, shape (n, size).
    """

    unknowns: Array

    def of(self, rows: Array) -> Array:
        """Return the draws of some sums of unknowns, shape (n, rows)."""
        return np.asarray(self.unknowns @ rows.T)


def friction_draws(fit: LearnFit, pulley: str, stop: float, seed: int = 1) -> FrictionDraws:
    """Return draws of the posterior of a fit.

    Parameters
    ----------
    fit
        At its maximum.
    pulley
        Whose friction is followed.
    stop
        Where in time [days].
    seed
        Of the draws.
    """
    assert fit.problem is not None  # noqa: S101 - every fit of cells has it
    row = fit.weights("friction", pulley, np.array([stop]))[0]
    rng = np.random.default_rng(seed)
    as_stated = _Noise(fit, fit.problem)
    known, evidence = _along(as_stated, fit.unknowns, fit.covariance, row, rng)
    grossly = _Noise(fit, _widened(fit.problem, f"speed_by_torque.{pulley}"))
    wide, other = _along(grossly, *grossly.best(fit.unknowns), row, rng)
    odds = _GROSS_PART / (1.0 - _GROSS_PART) * float(np.exp(min(other - evidence, 50.0)))
    count = round(DRAWS * odds / (1.0 + odds))  # of draws in random order
    return FrictionDraws(np.concatenate([known[count:], wide[:count]]))


def _widened(problem: CellProblem, name: str) -> CellProblem:
    """Return a problem with an error that is grossly wrong."""
    found = copy(problem)
    found.prior = problem.prior.copy()
    found.prior[problem.places[name]] /= _GROSS
    return found


def _along(
    noise: _Noise, best: Array, covariance: Array, row: Array, rng: np.random.Generator
) -> tuple[Array, float]:
    """Return draws of all unknowns along a sum of them, and the logarithm of the evidence."""
    middle, spread = float(row @ best), float(np.sqrt(row @ covariance @ row))
    values = middle + spread * _PLACES
    nearest = int(np.argmin(np.abs(_PLACES)))
    found: dict[int, tuple[Array, Array, float]] = {}
    for order in (range(nearest, len(values)), range(nearest - 1, -1, -1)):
        x = best
        for k in order:
            found[k] = noise.held(x, row, float(values[k]))
            x = found[k][0]
    centres = np.array([found[k][0] for k in range(len(values))])
    roots = [np.linalg.cholesky(found[k][1]) for k in range(len(values))]
    density = np.array([found[k][2] for k in range(len(values))])
    at = _quantiles(values, density - density.max(), (np.arange(DRAWS) + 0.5) / DRAWS)
    rng.shuffle(at)
    place = np.interp(at, values, np.arange(len(values)))
    low = np.minimum(place.astype(int), len(values) - 2)
    part = (place - low)[:, None]
    unknowns = centres[low] * (1.0 - part) + centres[low + 1] * part
    normal = rng.standard_normal(unknowns.shape)
    for k, root in enumerate(roots):
        own = np.round(place) == k
        unknowns[own] += normal[own] @ root.T
    top = float(density.max())
    evidence = top + float(np.log(np.trapezoid(np.exp(density - top), values)))
    return unknowns, evidence + float(np.linalg.slogdet(noise.problem.prior)[1])


def _quantiles(values: Array, logarithm: Array, shares: Array) -> Array:
    """Return quantiles of a density whose logarithm is known at some values."""
    fine = np.linspace(values[0], values[-1], 601)
    # a cubic between two values each, its slopes those of the parabolas through three
    slope, step = np.gradient(logarithm, values), np.diff(values)
    k = np.clip(np.searchsorted(values, fine, side="right") - 1, 0, len(values) - 2)
    t = (fine - values[k]) / step[k]
    value = (
        logarithm[k] * (1.0 + 2.0 * t) * (1.0 - t) ** 2
        + logarithm[k + 1] * (3.0 - 2.0 * t) * t**2
        + step[k] * t * (1.0 - t) * (slope[k] * (1.0 - t) - slope[k + 1] * t)
    )
    density = np.exp(value)
    total = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    return np.interp(shares, total / total[-1], fine)


def evenly(count: int) -> Array:
    """Return evenly spread draws of a standard normal, in random order."""
    normal = NormalDist()
    even = np.array([normal.inv_cdf((k + 0.5) / count) for k in range(count)])
    return np.random.default_rng(count).permutation(even)


class _Noise:
    """The cells of a fit with the noise that it found, and what they say of unknowns."""

    def __init__(self, fit: LearnFit, problem: CellProblem) -> None:
        self.fit, self.problem = fit, problem
        residual, _ = problem.linearize(fit.unknowns)
        self.weights = [far_weight(own) for own in residual]

    def _white(self, x: Array) -> tuple[Array, Array]:
        """Return slopes and residuals of unit variance, of cells and prior."""
        problem = self.problem
        residual, slopes = problem.linearize(x)
        rows = [
            whiten(of, own, weight, sigma, tau, problem.days)
            for of, own, weight, sigma, tau in zip(
                slopes, residual, self.weights, self.fit.sigma.tolist(), self.fit.tau.tolist(),
                strict=True,
            )
        ]  # fmt: skip
        return (
            np.concatenate([of for of, _ in rows] + [problem.prior]),
            np.concatenate([own for _, own in rows] + [problem.prior @ (problem.start - x)]),
        )

    def best(self, x: Array) -> tuple[Array, Array]:
        """Return the best unknowns, from some on, and their covariance."""
        for _ in range(_STEPS):
            of, own = self._white(x)
            change = np.linalg.solve(of.T @ of, of.T @ own)
            x = x + change
            if np.abs(change).max() < _SMALL:
                break
        of, _ = self._white(x)
        return x, np.asarray(np.linalg.inv(of.T @ of))

    def held(self, x: Array, row: Array, value: float) -> tuple[Array, Array, float]:
        """Return the best unknowns where `row` of them has a value, covariance, log density."""
        rein = np.outer(row, row) / _HELD**2
        for _ in range(_STEPS):
            of, own = self._white(x)
            gradient = of.T @ own + row * (value - float(row @ x)) / _HELD**2
            change = np.linalg.solve(of.T @ of + rein, gradient)
            x = x + change
            if np.abs(change).max() < _SMALL:
                break
        of, own = self._white(x)
        normal = of.T @ of + rein
        density = -0.5 * float(own @ own) - 0.5 * float(np.linalg.slogdet(normal)[1])
        return x, np.asarray(np.linalg.inv(normal)), density
