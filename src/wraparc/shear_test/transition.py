"""The transition pressure: whether the tests show one, where, and how well they tell it.

A law of two pieces bends wherever a smooth one curves, so that it is the better of the trend
lines does not make a transition. It is reported only where it beats the best smooth law,
polynomials of ln x_pk and ln mu_pk over ln p, by 6 of Akaike's criterion (AICc) and by more than
any of 19 laboratories drawn from that smooth law.
"""

from collections.abc import Callable, Sequence

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import Transition
from wraparc.shear_test.pressure_choice import PressureChoice
from wraparc.shear_test.pressure_fit import (
    CurvePoints,
    PressureFit,
    at_least,
    fit_form,
    scatter_within,
    transition_bounds,
)
from wraparc.shear_test.student import t95

_PROFILE = 41
_DEGREES = (1, 2, 3)
# Difference of AICc that pays for having chosen the best of several laws of two pieces. Ours.
_CLEARLY = 6.0
_DRAWS = 19


def find_transition(
    law: PressureFit | None, choice: PressureChoice | None, points: CurvePoints
) -> Transition | None:
    """Return the transition of the law, or of the best law of two pieces.

    None where there are too few pressures, or where a smooth law does as well.

    Parameters
    ----------
    law, choice
        Fit over pressure and how it was chosen; None for a single pressure.
    points
        The curves.
    """
    if law is None or choice is None:
        return None
    two = law if law.form.has_transition else choice.two_pieces
    if two is None or two.transition_pressure is None:
        return None
    if two is not law:
        given = two.transition_pressure if two.transition_given else None
        two = fit_form(two.form, points, two.scatter, transition=given, start=two.theta)
    if not two.transition_given and not is_earned(two, points):
        return None
    return Transition(
        pressure=float(np.exp(two.theta[-1])),
        given=two.transition_given,
        in_law=two is law,
        inside=is_inside(two, points),
    )


def is_earned(two: PressureFit, points: CurvePoints) -> bool:
    """Whether a law of two pieces beats the best smooth law by more than chance lets it."""
    total = points.covariance + _scatter(points)
    roots = np.asarray(
        np.linalg.cholesky(np.linalg.inv(total) * two.weights[:, None, None]), dtype=np.float64
    )
    designs = _designs(points)

    def gain(cloud: CurvePoints) -> tuple[float, Array]:
        smooth, criterion = _best_smooth(designs, roots, cloud.value)
        pieces = fit_form(
            two.form, cloud, total[0] - points.covariance[0], weights=two.weights, start=two.theta
        )
        return criterion - pieces.criterion, smooth

    own, smooth = gain(points)
    if own <= _CLEARLY:
        return False
    rng = np.random.default_rng(1)
    spread = np.linalg.cholesky(total)
    for _ in range(_DRAWS):
        drawn = smooth + np.einsum("nij,nj->ni", spread, rng.normal(size=smooth.shape))
        cloud = CurvePoints(points.pressure, drawn, points.covariance, points.level)
        if gain(cloud)[0] >= own:
            return False
    return True


def _designs(points: CurvePoints) -> list[Array]:
    """Powers of ln p, orthonormal, for each degree that leaves a pressure over."""
    count = len(points.level_pressures)
    x = np.log(points.pressure / points.pressure.mean())
    powers = [np.vander(x, degree + 1) for degree in _DEGREES if degree + 1 < count]
    return [np.linalg.qr(matrix)[0] for matrix in powers]


def _scatter(points: CurvePoints) -> Array:
    """Scatter between samples: of the repeats, else about the most flexible smooth law."""
    within = scatter_within(points)
    if within is not None:
        return within
    design = _designs(points)[-1]
    off = points.value - design @ (design.T @ points.value)
    freedom = max(len(off) - design.shape[1], 1)
    return at_least(off.T @ off / freedom - points.covariance.mean(0))


def _best_smooth(designs: Sequence[Array], roots: Array, value: Array) -> tuple[Array, float]:
    """Values of the best pair of polynomials at the points, and its AICc."""
    n = value.size
    target = np.einsum("nji,nj->ni", roots, value).ravel()
    best: tuple[Array, float] | None = None
    for first in designs:
        for second in designs:
            a, b = first.shape[1], second.shape[1]
            design = np.zeros((len(value), 2, a + b))
            design[:, 0, :a], design[:, 1, a:] = first, second
            rows = np.einsum("nji,njk->nik", roots, design).reshape(n, -1)
            theta = np.linalg.lstsq(rows, target, rcond=None)[0]
            free = a + b
            if n <= free + 1:
                continue
            chi = float(((rows @ theta - target) ** 2).sum())
            criterion = chi + 2.0 * free + 2.0 * free * (free + 1) / (n - free - 1)
            if best is None or criterion < best[1]:
                best = (design @ theta, criterion)
    return best if best is not None else (value, np.inf)


def transition_interval(fit: PressureFit, points: CurvePoints) -> tuple[float, float]:
    """95 % interval of a transition pressure, from the profile of chi-squared over it [Pa]."""
    best = fit.transition_pressure
    assert best is not None  # noqa: S101 - asked only of forms with one
    if fit.transition_given:
        return best, best
    low, high = transition_bounds(points)
    limit = t95(fit.freedom) ** 2

    def excess(pressure: float) -> float:
        start = fit.theta.copy()
        start[-1] = np.log(pressure)
        profile = fit_form(
            fit.form, points, fit.scatter, transition=pressure, weights=fit.weights, start=start
        )
        return profile.chi_squared - fit.chi_squared - limit

    ends = []
    for bound in (low, high):
        steps = np.geomspace(best, bound, _PROFILE)[1:] if bound != best else np.array([])
        inner, found = best, bound
        for step in steps:
            if excess(float(step)) > 0.0:
                found = _crossing(excess, inner, float(step))
                break
            inner = float(step)
        ends.append(found)
    return ends[0], ends[1]


def is_inside(fit: PressureFit, points: CurvePoints) -> bool:
    """Whether a transition lies inside, not at the edge of, where the points could show one."""
    low, high = transition_bounds(points)
    at = fit.transition_pressure
    return at is not None and (fit.transition_given or 1.001 * low < at < 0.999 * high)


def _crossing(excess: Callable[[float], float], inner: float, outer: float) -> float:
    for _ in range(12):
        middle = float(np.sqrt(inner * outer))
        if excess(middle) > 0.0:
            outer = middle
        else:
            inner = middle
    return float(np.sqrt(inner * outer))
