"""The law's parameters sampled from their posterior with emcee, in the same outputs.

Sampled together: the parameters of the form (transition pressure included) and the scatter
between samples. Likelihood of a curve: its point y = (ln x_pk, ln mu_pk) is normal about the
law with covariance S + Psi. Priors: flat in the logarithms of node values and, between its
bounds, of the transition pressure; half-normal of width 0.2 for the standard deviations in
Psi, flat for its correlation. What this adds to least squares is the true shape of the
posterior: of the transition pressure above all, and of Psi when there are few repeats.
"""

from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import MissingExtraError
from wraparc.shear_test.analysis import ConditionResult, PlanResult
from wraparc.shear_test.law import lagging_of
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit, transition_bounds
from wraparc.shear_test.pressure_form import ln_peaks

_WALKERS_PER_PARAMETER = 4
_STEPS, _BURN = 1500, 500
_PRIOR_WIDTH = 0.2
# Degrees of freedom of intervals that need no correction for few data.
_MANY = 1e6


@dataclass(frozen=True, eq=False)
class Posterior:
    """Log posterior density of (theta, ln of two standard deviations, atanh of correlation)."""

    points: CurvePoints
    law: PressureFit
    weights: Array

    def __call__(self, vectors: Array) -> Array:
        """Log density of each row of `vectors`, shape (w, k + 3) to (w,)."""
        return np.array([self._one(vector) for vector in vectors])

    def _one(self, vector: Array) -> float:
        theta, spread = vector[:-3], np.exp(vector[-3:-1])
        correlation = np.tanh(vector[-1])
        form, free = self.law.form, not self.law.transition_given
        if np.any(spread > 2.0) or np.any(spread < 1e-4) or abs(vector[-1]) > 3.0:
            return -np.inf
        if form.has_transition and free:
            low, high = np.log(transition_bounds(self.points))
            if not low <= theta[-1] <= high:
                return -np.inf
        value, _ = ln_peaks(form, theta, self.law.ends, self.points.pressure)
        off = self.points.value - value
        scatter = np.outer(spread, spread) * np.array([[1.0, correlation], [correlation, 1.0]])
        total = self.points.covariance + scatter
        determinant = total[:, 0, 0] * total[:, 1, 1] - total[:, 0, 1] ** 2
        squares = (
            total[:, 1, 1] * off[:, 0] ** 2
            - 2.0 * total[:, 0, 1] * off[:, 0] * off[:, 1]
            + total[:, 0, 0] * off[:, 1] ** 2
        ) / determinant
        likelihood = -0.5 * float((self.weights * (squares + np.log(determinant))).sum())
        # Flat in the standard deviations under the half-normal: + ln of them for the logarithm.
        prior = float((-0.5 * (spread / _PRIOR_WIDTH) ** 2 + np.log(spread)).sum())
        return likelihood + prior + float(np.log1p(-(correlation**2)))


def sampled(result: PlanResult, *, seed: int = 1) -> PlanResult:
    """Replace the least-squares law of each condition by the posterior mean and covariance.

    Conditions of a single pressure are left as they are.

    Parameters
    ----------
    result
        From `fit_plan`.
    seed
        Of the random numbers.

    Raises
    ------
    MissingExtraError
        If emcee is not installed.
    """
    conditions = tuple(
        _sampled(result, condition, seed) if condition.fit is not None else condition
        for condition in result.conditions
    )
    return replace(result, conditions=conditions)


def _sampled(result: PlanResult, condition: ConditionResult, seed: int) -> ConditionResult:
    found, law = condition.found, condition.found.fit
    assert law is not None  # noqa: S101 - asked only where there is one
    theta = posterior_chain(found.points, law, seed)[:, :-3]
    mean = replace(
        law,
        theta=theta.mean(0),
        covariance=np.atleast_2d(np.cov(theta, rowvar=False)),
        freedom=_MANY,
    )
    remarks = (
        *condition.remarks,
        f"the law's parameters are means of {len(theta)} draws from their posterior (emcee), "
        "and the intervals those of the draws",
    )
    found = replace(found, fit=mean)
    lagging = lagging_of(result.plan, found, condition.misfit, remarks)
    return replace(condition, found=found, lagging=lagging, remarks=remarks)


def posterior_chain(points: CurvePoints, law: PressureFit, seed: int) -> Array:
    """Draws of (theta, ln standard deviations, atanh correlation), one a row."""
    try:
        import emcee
    except ImportError:
        raise MissingExtraError("emcee", "bayes") from None
    rng = np.random.default_rng(seed)
    spread = np.sqrt(np.diag(law.scatter))
    correlation = law.scatter[0, 1] / (spread[0] * spread[1])
    turned = np.arctanh(np.clip(correlation, -0.9, 0.9))
    centre = np.concatenate([law.theta, np.log(spread), [turned]])
    given = law.form.has_transition and law.transition_given
    size = len(centre)
    walkers = _WALKERS_PER_PARAMETER * size
    errors = np.sqrt(np.clip(np.diag(law.covariance), 1e-12, None))
    widths = np.concatenate([errors, [0.1, 0.1, 0.1]])
    start = centre + 0.5 * widths * rng.normal(size=(walkers, size))
    if given:
        start[:, len(law.theta) - 1] = law.theta[-1] + 1e-9 * rng.normal(size=walkers)
    if law.form.has_transition and not given:
        low, high = np.log(transition_bounds(points))
        gap = 1e-3 * (high - low)
        start[:, len(law.theta) - 1] = np.clip(start[:, len(law.theta) - 1], low + gap, high - gap)
    sampler = emcee.EnsembleSampler(
        walkers, size, Posterior(points, law, law.weights), vectorize=True
    )
    sampler.random_state = np.random.RandomState(seed).get_state()
    sampler.run_mcmc(start, _STEPS)
    return np.asarray(sampler.get_chain(discard=_BURN, thin=5, flat=True))
