"""The law's dependence on pressure, by generalised least squares over the curves.

Each curve gives y = (ln x_pk, ln mu_pk) with its covariance S from the scatter of its
readings. Samples of one lagging differ too: that scatter, Psi, is estimated from the curves
and added, V = S + Psi, so that intervals are as wide as repeated tests disagree.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.budget import Budget, Common
from wraparc.shear_test.pressure_form import LawForm, coefficients_from_peaks, ln_peaks, node_count
from wraparc.shear_test.robust import minimise
from wraparc.shear_test.student import t95

# Samples are never taken to agree better than this in ln x_pk, ln mu_pk.
_LEAST_SCATTER = 3e-4
_FAR_CURVE = 3.0
_EM_STEPS = 40
_TRIES = 4


@dataclass(frozen=True, eq=False)
class CurvePoints:
    """The curves as points over pressure.

    Parameters
    ----------
    pressure
        Shape (n,) [Pa].
    value
        (ln x_pk, ln mu_pk), shape (n, 2).
    covariance
        S, shape (n, 2, 2).
    level
        Number of the nominal pressure of each, shape (n,): 0, 1, ... in ascending order.
    """

    pressure: Array
    value: Array
    covariance: Array
    level: np.ndarray[tuple[int], np.dtype[np.int64]]

    def only(self, mask: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> "CurvePoints":
        """Return the points of a mask."""
        return CurvePoints(
            self.pressure[mask], self.value[mask], self.covariance[mask], self.level[mask]
        )

    @property
    def level_pressures(self) -> Array:
        """Mean pressure of each level that is there [Pa]."""
        return np.array([self.pressure[self.level == k].mean() for k in np.unique(self.level)])


@dataclass(frozen=True, kw_only=True, eq=False)
class PressureFit:
    """One form fitted to the points.

    Parameters
    ----------
    form
        The form.
    theta
        Parameters, in the order of ``form.names()``.
    covariance
        Of theta, shape (k, k).
    ends
        Lowest and highest tested pressure [Pa].
    scatter
        Psi, between samples, shape (2, 2).
    weights
        Of the curves: 1, or less for one far from all others, shape (n,).
    distances
        Distance of each curve from the law in standard deviations, shape (n,).
    chi_squared
        Sum of the squared, weighted distances.
    criterion
        Akaike's information criterion for few data (AICc).
    freedom
        Degrees of freedom for intervals.
    transition_given
        Whether the transition pressure was given, not fitted.
    alternatives
        Other forms that the data do not refuse, each with its Akaike weight: how far their
        laws differ from this one is part of its uncertainty (Burnham and Anderson 2002).
    lack
        Covariance of (ln x_pk, ln mu_pk) for what the form lacks, shape (2, 2); None if
        nothing shows it.
    lack_reach
        Ratio of pressures, as its logarithm, over which what it lacks changes.
    common
        Errors common to all tests, or None.
    """

    form: LawForm
    theta: Array
    covariance: Array
    ends: tuple[float, float]
    scatter: Array
    weights: Array
    distances: Array
    chi_squared: float
    criterion: float
    freedom: float
    transition_given: bool = False
    alternatives: tuple[tuple[float, "PressureFit"], ...] = ()
    lack: Array | None = None
    lack_reach: float = 1.0
    common: Common | None = None

    @property
    def coverage_factor(self) -> float:
        """Standard errors to either side of a 95 % interval: Student's t.

        The degrees of freedom are those of the scatter, more where errors that are known make up
        part of the uncertainty (Welch and Satterthwaite); the least over the tested pressures.
        """
        pressure = np.geomspace(*self.ends, 5)
        whole = np.einsum("nii->ni", self.own_covariance(pressure))
        known = 0.0
        if self.common is not None:
            known = np.einsum("nnii->ni", self.common.covariance(self.peaks, pressure))
        return t95(self.freedom * float(np.min((whole / (whole - known)) ** 2)))

    @property
    def transition_pressure(self) -> float | None:
        """Where the pieces meet [Pa]; None for one piece."""
        return float(np.exp(self.theta[-1])) if self.form.has_transition else None

    def peaks(self, pressure: Array) -> Array:
        """(ln x_pk, ln mu_pk) at pressures [Pa], shape (n, 2)."""
        return ln_peaks(self.form, self.theta, self.ends, pressure)[0]

    def peak_errors(self, pressure: Array) -> Array:
        """Standard errors of `peaks`, shape (n, 2)."""
        return np.asarray(np.sqrt(np.einsum("nii->ni", self.own_covariance(pressure))))

    def own_covariance(self, pressure: Array) -> Array:
        """Covariance of (ln x_pk, ln mu_pk) at each pressure by itself, shape (n, 2, 2)."""
        spread = self._spread(pressure)
        own = spread @ spread.transpose(0, 2, 1)
        if self.lack is not None:
            own = own + self.lack
        for weight, off in self._differences(pressure):
            own = own + weight * off[:, :, None] * off[:, None, :]
        if self.common is not None:
            own = own + np.einsum("nnij->nij", self.common.covariance(self.peaks, pressure))
        return np.asarray(own)

    def peak_covariance(self, pressure: Array) -> Array:
        """Covariance of `peaks`, shape (n, n, 2, 2)."""
        spread = self._spread(pressure)
        whole = np.einsum("nik,mjk->nmij", spread, spread)
        if self.lack is not None:
            apart = np.abs(np.log(pressure[:, None] / pressure[None, :]))
            whole = whole + np.exp(-apart / self.lack_reach)[:, :, None, None] * self.lack
        for weight, off in self._differences(pressure):
            whole = whole + weight * off[:, None, :, None] * off[None, :, None, :]
        if self.common is not None:
            whole = whole + self.common.covariance(self.peaks, pressure)
        return np.asarray(whole)

    def budget(self, points: CurvePoints) -> Budget:
        """Return what the uncertainty at the tested pressures is made of.

        Parameters
        ----------
        points
            What it was fitted to: their readings are one part, the scatter between samples another.
        """
        pressure = points.level_pressures
        _, design = ln_peaks(self.form, self.theta, self.ends, points.pressure)
        _, at = ln_peaks(self.form, self.theta, self.ends, pressure)
        total = np.linalg.inv(points.covariance + self.scatter) * self.weights[:, None, None]
        gain = np.einsum("kl,nil,nij->knj", self.covariance, design, total)
        readings = np.einsum("knj,njm,lnm->kl", gain, points.covariance, gain)
        noise = np.einsum("nik,kl,nil->ni", at, readings, at)
        law = self._spread(pressure)
        scatter = np.maximum(np.einsum("nik,nik->ni", law, law) - noise, 0.0)
        form = np.zeros_like(scatter)
        if self.lack is not None:
            form = form + np.diag(self.lack)
        for weight, off in self._differences(pressure):
            form = form + weight * off**2
        parts = {
            "repeatability": noise,
            "scatter between samples": scatter,
            "form of the law": form,
        }
        found = {name: np.sqrt(np.maximum(part, 0.0)) for name, part in parts.items()}
        if self.common is not None:
            effects = self.common.effects(self.peaks, pressure)
            found |= {name: np.abs(effect) for name, effect in effects.items()}
        return Budget(pressure=pressure, parts=found, coverage_factor=self.coverage_factor)

    def _spread(self, pressure: Array) -> Array:
        """Jacobian times a root of the covariance, shape (n, 2, k).

        Squared it gives no negative variance, also where a piece that the data hardly
        determine makes the covariance ill-conditioned.
        """
        _, jacobian = ln_peaks(self.form, self.theta, self.ends, pressure)
        values, vectors = np.linalg.eigh(self.covariance)
        return np.asarray(jacobian @ (vectors * np.sqrt(np.maximum(values, 0.0))))

    def _differences(self, pressure: Array) -> list[tuple[float, Array]]:
        peaks = self.peaks(pressure)
        return [(weight, fit.peaks(pressure) - peaks) for weight, fit in self.alternatives]


def fit_form(
    form: LawForm,
    points: CurvePoints,
    scatter: Array,
    *,
    transition: float | None = None,
    weights: Array | None = None,
    ends: tuple[float, float] | None = None,
    start: Array | None = None,
) -> PressureFit:
    """Fit one form, the scatter between samples and the weights of the curves given.

    Parameters
    ----------
    form
        The form.
    points
        The curves.
    scatter
        Psi, shape (2, 2).
    transition
        Given transition pressure [Pa].
    weights
        Of the curves.
    ends
        Pressures of the outer nodes [Pa], if not those of the points.
    start
        First parameters, instead of several found in the points.
    """
    at = ends or (float(points.pressure.min()), float(points.pressure.max()))
    w = np.ones(len(points.pressure)) if weights is None else weights
    whiten = np.linalg.cholesky(np.linalg.inv(points.covariance + scatter) * w[:, None, None])
    free = form.size - (form.has_transition and transition is not None)

    def residual(theta: Array) -> tuple[Array, Array]:
        value, jacobian = ln_peaks(form, theta, at, points.pressure)
        rows = np.einsum("nji,nj->ni", whiten, value - points.value).ravel()
        slopes = np.einsum("nji,njk->nik", whiten, jacobian).reshape(len(rows), -1)
        slopes[:, free:] = 0.0
        return rows, slopes

    low, high = np.full(form.size, -np.inf), np.full(form.size, np.inf)
    if form.has_transition and transition is None:
        low[-1], high[-1] = np.log(transition_bounds(points))
    starts = _best_start(form, points, at, transition) if start is None else [start]
    ended = [minimise(residual, np.clip(first, low, high), (low, high)) for first in starts]
    theta = min(ended, key=lambda vector: float((residual(vector)[0] ** 2).sum()))
    rows, slopes = residual(theta)
    covariance = np.zeros((form.size, form.size))
    covariance[:free, :free] = np.linalg.pinv(slopes[:, :free].T @ slopes[:, :free], hermitian=True)
    distances = np.sqrt((rows.reshape(-1, 2) ** 2).sum(1) / np.maximum(w, 1e-12))
    n, chi = len(rows), float(rows @ rows)
    correction = 2.0 * free * (free + 1) / (n - free - 1) if n > free + 1 else np.inf
    return PressureFit(
        form=form,
        theta=theta,
        covariance=covariance,
        ends=at,
        scatter=scatter,
        weights=w,
        distances=distances,
        chi_squared=chi,
        criterion=chi + 2.0 * free + correction,
        freedom=max(n / 2.0 - free / 2.0, 1.0),
        transition_given=form.has_transition and transition is not None,
    )


def transition_bounds(points: CurvePoints) -> tuple[float, float]:
    """Pressures between which a transition can be told: two levels on each side [Pa]."""
    levels = points.level_pressures
    if len(levels) < 4:
        return float(levels[0]), float(levels[-1])
    return float(levels[1]), float(levels[-2])


def _best_start(
    form: LawForm, points: CurvePoints, ends: tuple[float, float], transition: float | None
) -> list[Array]:
    """Starts: the means of the levels, read off at the nodes, for some transition pressures."""
    levels = points.level_pressures
    if form.nodes:
        near = [np.abs(points.pressure - node).argmin() for node in form.nodes]
        return [points.value[near].T.ravel()]
    means = np.stack([points.value[points.level == k].mean(0) for k in np.unique(points.level)])
    if form.variables == "coefficients":
        means = np.stack(coefficients_from_peaks(means[:, 0], means[:, 1]), axis=-1)

    def read(quantity: int, trends: tuple[str, ...], at: float) -> list[float]:
        places = [ends[0], at, ends[1]] if len(trends) > 1 else list(ends)
        values = np.interp(places[: node_count(trends)], levels, means[:, quantity])
        return [float(means[:, quantity].mean())] if node_count(trends) == 1 else values.tolist()

    if not form.has_transition:
        return [np.array(read(0, form.first, 0.0) + read(1, form.second, 0.0))]
    if transition is not None:
        tries = np.array([transition])
    else:
        low, high = transition_bounds(points)
        tries = np.geomspace(low, high, _TRIES + 2)[1:-1] if high > low else np.array([low])
    return [np.array([*read(0, form.first, p), *read(1, form.second, p), np.log(p)]) for p in tries]


def scatter_between(form: LawForm, points: CurvePoints, first: Array, **options: Any) -> Array:
    """Psi by restricted maximum likelihood (EM), the law refitted as it changes.

    Parameters
    ----------
    form
        The law, whose lack of fit counts as scatter too.
    points
        The curves.
    first
        First Psi.
    **options
        Passed to `fit_form`.
    """
    scatter = first
    fit = fit_form(form, points, scatter, **options)
    for _ in range(3):
        value, design = ln_peaks(fit.form, fit.theta, fit.ends, points.pressure)
        off = points.value - value
        for _ in range(_EM_STEPS):
            total = np.linalg.inv(points.covariance + scatter)
            weighted = np.einsum("nij,njk->nik", total, design)
            inverse = np.linalg.pinv(np.einsum("nij,nik->jk", design, weighted), hermitian=True)
            projected = total - np.einsum("nij,jk,nlk->nil", weighted, inverse, weighted)
            pulled = np.einsum("ij,njk,nk->ni", scatter, total, off)
            scatter = (
                np.einsum("ni,nj->ij", pulled, pulled) / len(off)
                + scatter
                - scatter @ projected.mean(0) @ scatter
            )
            scatter = at_least(0.5 * (scatter + scatter.T))
        fit = fit_form(form, points, scatter, **(options | {"start": fit.theta}))
    return scatter


def at_least(scatter: Array) -> Array:
    """Psi with its standard deviations not below 0.03 %."""
    values, vectors = np.linalg.eigh(scatter)
    return np.asarray((vectors * np.maximum(values, _LEAST_SCATTER**2)) @ vectors.T)


def scatter_within(points: CurvePoints) -> Array | None:
    """Psi from tests repeated at one pressure; None where there are fewer than 3 repeats."""
    freedom, total, noise = 0, np.zeros((2, 2)), np.zeros((2, 2))
    for k in np.unique(points.level):
        inside = points.level == k
        count = int(inside.sum())
        if count > 1:
            off = points.value[inside] - points.value[inside].mean(0)
            total += off.T @ off
            noise += points.covariance[inside].mean(0) * (count - 1)
            freedom += count - 1
    if freedom < 3:
        return None
    return at_least((total - noise) / freedom)


def down_weighted(fit: PressureFit) -> Array:
    """Weights that bound the pull of a curve further than 3 standard deviations from the law."""
    return np.minimum(1.0, _FAR_CURVE / np.maximum(fit.distances, 1e-12))
