"""The zero and the friction in time, with every error of the log, at the maximum of the posterior.

Gauss-Newton over cells; residuals of a day share an error (tau) beside their own (sigma), far ones
count less (Huber). The maximum is that of a skewed posterior: what friction may be is in `levels`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.learn.curves import FRICTION
from wraparc.learn.errors import TAKE_UP_FRICTION, LogErrors
from wraparc.learn.model import SpeedModel
from wraparc.learn.windows import DAY, Cells

#: Days between knots of ln friction and of the zero; standard deviations of the level of the zero
#: and of the change from knot to knot [-].
FRICTION_DAYS, ZERO_DAYS = 15.0, 5.0
_ZERO_LEVEL = 0.05
_WALK = {"friction": 0.06, "zero": 2.5e-4}
#: Torques between which the torque signal may bend [-].
BENDS = np.array([0.08, 0.22, 0.36, 0.50, 0.64, 0.78, 0.92])
_HUBER, _LONGEST_STEP, _SMALL = 2.5, 0.5, 2e-4
#: Part of its variance that a log must take from an error to say anything of it [-].
_LEAST_SHARE = 0.05
#: Least sigma and tau [-].
LEAST_SIGMA, LEAST_TAU = 3e-5, 5e-5
_COMMON = ("exit_tension", "belt_modulus", "peak_slip", "lagging_shear", "take_up_friction")
_OWN = ("torque_gain", "torque_offset", "speed_by_torque")


@dataclass(frozen=True, eq=False)
class Basis:
    """Piecewise linear courses in time that may jump at cuts.

    Attributes
    ----------
    blocks
        Knots between two cuts each [days].
    """

    blocks: tuple[Array, ...]

    @classmethod
    def of(cls, cuts: Sequence[float], stop: float, every: float) -> Basis:
        """Return the basis with knots at most so many days apart."""
        ends = [0.0, *cuts, stop]
        return cls(
            tuple(
                np.linspace(a, b, max(2, int(np.ceil((b - a) / every)) + 1))
                for a, b in pairwise(ends)
            )
        )

    @property
    def size(self) -> int:
        """Number of knots."""
        return sum(map(len, self.blocks))

    def rows(self, days: Array) -> Array:
        """Return the weights of the knots at some days, shape (n, size)."""
        columns = []
        for i, knots in enumerate(self.blocks):
            inside = days >= knots[0] if i else np.ones(len(days), dtype=bool)
            if i < len(self.blocks) - 1:
                inside = inside & (days < knots[-1])
            columns.append(hat(days, knots) * inside[:, None])
        return np.hstack(columns)

    def prior(self, level: float, walk: float) -> Array:
        """Return the rows of a prior: a level for each block, then changes from knot to knot."""
        rows = np.zeros((self.size, self.size))
        place = 0
        for knots in self.blocks:
            rows[place, place] = 1.0 / level
            for i in range(place + 1, place + len(knots)):
                rows[i, i], rows[i, i - 1] = 1.0 / walk, -1.0 / walk
            place += len(knots)
        return rows


def hat(x: Array, knots: Array) -> Array:
    """Return the weights of knots in a piecewise linear course, constant beyond its ends."""
    return np.array([np.interp(x, knots, row) for row in np.eye(len(knots))]).T


@dataclass(frozen=True, eq=False)
class LearnFit:
    """The posterior of a log.

    Attributes
    ----------
    model
        The drive.
    unknowns
        Values at its maximum.
    covariance
        Of them.
    places
        Where each part of the unknowns stands, by name.
    expected, prior_sd
        Of the errors, before the log, by name.
    zero_basis, friction_basis, drift_knots
        Courses in time [days].
    sigma, tau
        Own and daily spread of a cell by pulley [-].
    problem
        What was fitted.
    """

    model: SpeedModel
    unknowns: Array
    covariance: Array
    places: dict[str, slice]
    expected: dict[str, float]
    prior_sd: dict[str, float]
    zero_basis: Basis
    friction_basis: Basis
    drift_knots: Array
    sigma: Array = field(default_factory=lambda: np.zeros(0))
    tau: Array = field(default_factory=lambda: np.zeros(0))
    problem: CellProblem | None = None

    def nuisance(self, unknowns: Array | None = None) -> dict[str, float]:
        """Return the errors by name."""
        x = self.unknowns if unknowns is None else unknowns
        return {name: float(x[self.places[name]][0]) for name in self.prior_sd}

    def course(self, what: str, days: Array, unknowns: Array | None = None) -> Array:
        """Return ``zero`` or ``friction`` (its logarithm) at some days, shape (k, n)."""
        x = self.unknowns if unknowns is None else unknowns
        basis = self.zero_basis if what == "zero" else self.friction_basis
        rows = basis.rows(days)
        return np.array([rows @ x[self.places[f"{what}.{n}"]] for n in self.model.names], float)

    def weights(self, what: str, pulley: str, days: Array) -> Array:
        """Return rows over all unknowns that give ``zero`` or ``friction`` at some days."""
        basis = self.zero_basis if what == "zero" else self.friction_basis
        rows = np.zeros((len(days), len(self.unknowns)))
        rows[:, self.places[f"{what}.{pulley}"]] = basis.rows(days)
        return rows

    def spread(self, rows: Array) -> Array:
        """Return the standard deviation of sums of unknowns, shape (n,)."""
        variance = np.einsum("ij,jk,ik->i", rows, self.covariance, rows)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0)))

    def curve(self, torque: Array, days: Array, play: Array | float, shift: float = 0.0) -> Array:
        """Return y without its zero, friction changed by `shift` of its logarithm, shape (k, n)."""
        nuisance, x = self.nuisance(), self.unknowns
        curve = self.model.curve(torque, self.course("friction", days) + shift, nuisance, play)
        drift = hat(days, self.drift_knots) @ x[self.places["belt_modulus_drift"]]
        bends = [hat(m, BENDS) @ x[self.places[f"torque_curve.{n}"]]
                 for n, m in zip(self.model.names, torque, strict=True)]  # fmt: skip
        return np.asarray(curve - self.model.strain(torque, nuisance) * drift + np.array(bends))

    def moved(self) -> dict[str, float]:
        """Return by how many standard deviations the log shifts each error of which it says any.

        The shift x - x0 from what is stated has the variance P - C, that of the statement less
        that of the posterior. P alone would hide what others can stand for: each is shifted by a
        part. Baarda, A testing procedure for use in geodetic networks (1968).
        """
        return {
            n: (now - self.expected[n]) / (self.prior_sd[n] * math.sqrt(share))
            for n, now, share in self._shifts()
        }

    def by_log_alone(self) -> dict[str, float]:
        """Return what each error of which the log says any would be, were nothing stated of it."""
        return {n: self.expected[n] + (x - self.expected[n]) / r for n, x, r in self._shifts()}

    def _shifts(self) -> Iterator[tuple[str, float, float]]:
        """Yield errors, their values, and which part of its variance the log takes from each."""
        for name, value in self.nuisance().items():
            place = self.places[name].start
            share = 1.0 - float(self.covariance[place, place]) / self.prior_sd[name] ** 2
            if share > _LEAST_SHARE:
                yield name, value, share


def fit_cells(
    cells: Cells,
    model: SpeedModel,
    errors: LogErrors,
    estimated: Sequence[bool],
    cuts: Sequence[int],
    stop: float,
    steps: int = 8,
) -> LearnFit:
    """Return the posterior of zero, friction and errors.

    Parameters
    ----------
    cells
        What was measured.
    model, errors
        The drive, and how wrong what was measured may be.
    estimated
        Whether the speed of each pulley is estimated.
    cuts
        Days on which zero and friction may jump.
    stop
        End of the log [days].
    steps
        Of Gauss-Newton at most.
    """
    problem = CellProblem(cells, model, errors, estimated, [float(c) for c in cuts], stop)
    x = problem.start.copy()
    count = len(model.names)
    sigma, tau = np.full(count, 2e-4), np.full(count, 1e-4)
    normal = np.eye(len(x))
    for step in range(steps):
        residual, slopes = problem.linearize(x)
        normal = problem.prior.T @ problem.prior
        gradient = problem.prior.T @ (problem.prior @ (problem.start - x))
        for j in range(count):
            own, of = residual[j], slopes[j]
            weight = far_weight(own)
            if step:
                sigma[j], tau[j] = _spreads(own, weight, problem.days)
            white, white_residual = whiten(of, own, weight, sigma[j], tau[j], problem.days)
            normal = normal + white.T @ white
            gradient = gradient + white.T @ white_residual
        change = np.linalg.solve(normal, gradient)
        longest = max(np.abs(change[problem.places[f"friction.{n}"]]).max() for n in model.names)
        x = x + change * min(1.0, _LONGEST_STEP / longest if longest > 0.0 else 1.0)
        for n in model.names:  # beyond its table friction changes nothing
            x[problem.places[f"friction.{n}"]] = np.clip(
                x[problem.places[f"friction.{n}"]], FRICTION[0], FRICTION[-1]
            )
        if step > 1 and np.abs(change).max() < _SMALL:
            break
    return LearnFit(
        model, x, np.asarray(np.linalg.inv(normal)), problem.places, problem.expected,
        problem.prior_sd,
        problem.zero_basis, problem.friction_basis, problem.drift_knots, sigma, tau, problem,
    )  # fmt: skip


def _spreads(own: Array, weight: Array, days: Sequence[Integers]) -> tuple[float, float]:
    """Return the spread of a cell within its day, and that of the days."""
    large = [d for d in days if len(d) > 3] or list(days)
    means = np.array([np.average(own[d], weights=weight[d]) for d in large])
    within = np.concatenate([own[d] - m for d, m in zip(large, means, strict=True)])
    sigma = max(LEAST_SIGMA, float(1.4826 * np.median(np.abs(within))))
    return sigma, max(LEAST_TAU, float(1.4826 * np.median(np.abs(means))))


def far_weight(own: Array) -> Array:
    """Return the weights of residuals: those beyond 2.5 spreads count less (Huber)."""
    spread = 1.4826 * np.median(np.abs(own - np.median(own)))
    far = np.abs(own) / (_HUBER * max(float(spread), LEAST_SIGMA))
    return np.asarray(1.0 / np.maximum(1.0, far))


def whiten(
    slopes: Array,
    residual: Array,
    weight: Array,
    sigma: float,
    tau: float,
    days: Sequence[Integers],
) -> tuple[Array, Array]:
    """Return slopes and residuals of unit variance, those of a day freed of their common error.

    C = D + tau^2 1 1' has the inverse root (I - b u u') D^(-1/2), u = D^(-1/2) 1 / |D^(-1/2) 1|.
    """
    root = np.sqrt(weight) / sigma
    white, own = slopes * root[:, None], residual * root
    for d in days:
        u = root[d]
        size = float(u @ u)
        b = (1.0 - 1.0 / np.sqrt(1.0 + tau**2 * size)) / size
        white[d] -= b * np.outer(u, u @ white[d])
        own[d] = own[d] - b * u * float(u @ own[d])
    return white, own


class CellProblem:
    """Unknowns with their priors, and what they give for the cells."""

    def __init__(
        self,
        cells: Cells,
        model: SpeedModel,
        errors: LogErrors,
        estimated: Sequence[bool],
        cuts: Sequence[float],
        stop: float,
    ) -> None:
        self.cells, self.model = cells, model
        self.at = cells.time / DAY
        self.zero_basis = Basis.of(cuts, stop, ZERO_DAYS)
        self.friction_basis = Basis.of(cuts, stop, FRICTION_DAYS)
        knots = max(2, int(stop / FRICTION_DAYS) + 1)
        self.drift_knots = np.linspace(0.0, stop, knots)
        self.days = [np.flatnonzero(cells.day == d) for d in np.unique(cells.day)]
        self.prior_sd = {key: errors.sd(key) for key in _COMMON}
        for name, own in zip(model.names, estimated, strict=True):
            for key in _OWN:
                self.prior_sd[f"{key}.{name}"] = errors.sd(key, is_estimated=own)
        self.expected = dict.fromkeys(self.prior_sd, 0.0)
        self.expected["take_up_friction"] = TAKE_UP_FRICTION
        blocks: list[tuple[str, Array]] = [
            (name, np.array([[1.0 / sd]])) for name, sd in self.prior_sd.items()
        ]
        levels = {"zero": _ZERO_LEVEL, "friction": errors.sd("friction_level")}
        for what, basis in (("zero", self.zero_basis), ("friction", self.friction_basis)):
            rows = basis.prior(levels[what], _WALK[what])
            blocks += [(f"{what}.{name}", rows) for name in model.names]
        blocks.append(("belt_modulus_drift", np.eye(knots) / errors.sd("belt_modulus_drift")))
        bend = np.eye(len(BENDS)) / errors.sd("torque_curve")
        blocks += [(f"torque_curve.{name}", bend) for name in model.names]
        self.places: dict[str, slice] = {}
        size = sum(len(rows) for _, rows in blocks)
        self.prior = np.zeros((size, size))
        place = 0
        for name, rows in blocks:
            self.places[name] = slice(place, place + len(rows))
            self.prior[self.places[name], self.places[name]] = rows
            place += len(rows)
        self.start = np.zeros(size)
        for name, value in self.expected.items():
            self.start[self.places[name]] = value
        nominal = model.curve(cells.torque, np.zeros_like(cells.torque), self.expected, cells.play)
        for j, name in enumerate(model.names):
            middle = float(np.median(cells.difference[j] - nominal[j]))
            self.start[self.places[f"zero.{name}"]] = middle
        self.zero_rows = self.zero_basis.rows(self.at)
        self.friction_rows = self.friction_basis.rows(self.at)
        self.drift_rows = hat(self.at, self.drift_knots)
        self.bend_rows = [hat(m, BENDS) for m in cells.torque]

    def linearize(self, x: Array) -> tuple[Array, Array]:
        """Return residuals, shape (k, n), and slopes of what is expected, shape (k, n, size)."""
        model, cells = self.model, self.cells
        nuisance = {name: float(x[self.places[name]][0]) for name in self.prior_sd}
        ln_f = np.array([self.friction_rows @ x[self.places[f"friction.{n}"]] for n in model.names])
        strain = model.strain(cells.torque, nuisance)
        drift = self.drift_rows @ x[self.places["belt_modulus_drift"]]
        expected = model.curve(cells.torque, ln_f, nuisance, cells.play) - strain * drift
        slopes = np.zeros((*cells.torque.shape, len(x)))
        for name in self.prior_sd:
            changed = [
                model.curve(cells.torque, ln_f, {**nuisance, name: nuisance[name] + h}, cells.play)
                for h in (1e-3, -1e-3)
            ]
            slopes[:, :, self.places[name]] = ((changed[0] - changed[1]) / 2e-3)[:, :, None]
        by_friction = [model.curve(cells.torque, ln_f + h, nuisance, cells.play)
                       for h in (0.01, -0.01)]  # fmt: skip
        slope = (by_friction[0] - by_friction[1]) / 0.02
        slopes[:, :, self.places["belt_modulus_drift"]] = -strain[:, :, None] * self.drift_rows
        for j, n in enumerate(model.names):
            zero, bend = self.places[f"zero.{n}"], self.places[f"torque_curve.{n}"]
            expected[j] += self.zero_rows @ x[zero] + self.bend_rows[j] @ x[bend]
            slopes[j][:, zero], slopes[j][:, bend] = self.zero_rows, self.bend_rows[j]
            slopes[j][:, self.places[f"friction.{n}"]] = slope[j][:, None] * self.friction_rows
        return cells.difference - expected, slopes


def kept_days(day: Integers, left: Sequence[int]) -> Flags:
    """Return which windows are not on some days."""
    return np.asarray(~np.isin(day, list(left)))
