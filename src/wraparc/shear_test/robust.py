"""Robust least squares with an honest covariance.

The loss is soft-L1, rho(z) = 2 (sqrt(1 + z) - 1) with z the squared residual over the
scale: quadratic for the bulk, linear for outliers. The covariance is the sandwich of
M-estimation, with the correlation of the noise along the curve.

The minimum is sought here rather than by ``scipy.optimize.least_squares``: the rows of a prior are
quadratic beside the soft-L1 rows of the data, and of many fits in a laboratory each counts. Given a
loss of its own for every row, SciPy ends at the same minimum (on virtual tests the loss agrees to
2e-5; in its flat directions parameters differ by up to 2 %) and takes twice as long.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.shear_test.correlation import apply, noise_kernel

Residual = Callable[[Array], tuple[Array, Array]]
_SOFT = 2.0
_UNKNOWN = 10.0
# A scale of the loss that no residual reaches: plain least squares.
_QUADRATIC = 1e9


@dataclass(frozen=True, eq=False)
class Robust:
    """Solution of a robust fit.

    Parameters
    ----------
    vector
        Best parameters, shape (k,).
    rows
        Weighted residuals there, shape (n,).
    jacobian
        Of the rows, shape (n, k).
    scale
        Residual at which the loss turns linear.
    cost
        Sum of the loss.
    """

    vector: Array
    rows: Array
    jacobian: Array
    scale: float
    cost: float


def fit_robust(
    residual: Residual,
    start: Array,
    bounds: tuple[Array, Array],
    pull: tuple[Array, Array] | None = None,
) -> Robust:
    """Minimise the soft-L1 loss twice: the second time with the scale of the first's residuals.

    Parameters
    ----------
    residual
        Weighted residuals and their jacobian at a parameter vector.
    start
        First vector, inside the bounds.
    bounds
        Lower and upper.
    pull
        Matrix M and target t of further, purely quadratic rows M v - t.
    """
    vector, scale = start, _SOFT * 3.0
    for _ in range(2):
        vector = minimise(residual, vector, bounds, scale, pull)
        rows, jacobian = residual(vector)
        spread = 1.4826 * float(np.median(np.abs(rows - np.median(rows))))
        scale = _SOFT * max(spread, 1e-9)
    # The loss of both passes is reported at one scale, so that fits compare.
    cost = float((2.0 * _SOFT**2 * (np.sqrt(1.0 + (rows / _SOFT) ** 2) - 1.0)).sum())
    return Robust(vector, rows, jacobian, scale, cost)


def minimise(
    residual: Residual,
    start: Array,
    bounds: tuple[Array, Array],
    scale: float = _QUADRATIC,
    pull: tuple[Array, Array] | None = None,
) -> Array:
    """Levenberg-Marquardt on the reweighted rows, steps cut back at the bounds.

    See `fit_robust` for the parameters; `scale` is where the loss turns linear.
    """
    low, high = bounds
    vector, damping = start, 1e-3
    rows, jacobian = residual(vector)
    value = _value(rows, vector, scale, pull)
    for _ in range(60):
        weight = 1.0 / np.sqrt(1.0 + (rows / scale) ** 2)
        gradient = jacobian.T @ (weight * rows)
        curvature = jacobian.T @ (weight[:, None] * jacobian)
        if pull is not None:
            gradient = gradient + pull[0].T @ (pull[0] @ vector - pull[1])
            curvature = curvature + pull[0].T @ pull[0]
        diagonal = np.maximum(np.diag(curvature), 1e-12 * max(float(np.trace(curvature)), 1e-300))
        # A parameter held at its bound by the gradient does not move.
        held = ((vector <= low) & (gradient > 0)) | ((vector >= high) & (gradient < 0))
        improved = False
        for _ in range(12):
            matrix = curvature + damping * np.diag(diagonal)
            matrix[held, :] = 0.0
            matrix[:, held] = 0.0
            matrix[held, held] = 1.0
            step = np.linalg.solve(matrix, np.where(held, 0.0, -gradient))
            trial = np.clip(vector + step, low, high)
            trial_rows, trial_jacobian = residual(trial)
            trial_value = _value(trial_rows, trial, scale, pull)
            if trial_value < value:
                improved = True
                break
            damping = min(damping * 5.0, 1e9)
        if not improved:
            break
        gain = value - trial_value
        vector, rows, jacobian, value = trial, trial_rows, trial_jacobian, trial_value
        damping = max(damping / 5.0, 1e-9)
        if gain < 1e-9 * max(value, 1e-300):
            break
    return vector


def _value(rows: Array, vector: Array, scale: float, pull: tuple[Array, Array] | None) -> float:
    squares = rows**2
    # As rows^2 / (1 + root) the loss keeps its digits where the rows are far below the scale.
    total = float((squares / (1.0 + np.sqrt(1.0 + squares / scale**2))).sum())
    if pull is not None:
        total += 0.5 * float(((pull[0] @ vector - pull[1]) ** 2).sum())
    return total


@dataclass(frozen=True, eq=False)
class Readings:
    """Single readings behind the rows of a fit, whose correlation decides its errors.

    Parameters
    ----------
    residual
        Reading minus model, in the order they were taken, shape (m,).
    row
        Row of the fit each reading was averaged into, shape (m,).
    share
        Derivative of the weighted row by the reading: weight / count, shape (n,).
    counts
        Readings in each row, shape (n,).
    """

    residual: Array
    row: Integers
    share: Array
    counts: Array


def sandwich(fit: Robust, readings: Readings, scales: Array) -> Array:
    """Covariance of the parameters of a robust fit, B^-1 M B^-1.

    Parameters
    ----------
    fit
        The fit.
    readings
        The readings behind its rows.
    scales
        Natural size of each parameter: ten times as much is its error where the data say
        nothing about it, shape (k,).

    Notes
    -----
    B is the curvature of the loss, M = G' V G the variance of its gradient with G its
    derivative by each reading and V the covariance of the readings: their local standard
    deviation times a correlation that is the same all along the curve (`noise_kernel`).
    (Summing products of the residuals themselves, after Newey and West, fails where a few
    correlated readings decide a parameter, as at the onset of slip: the fit has made those
    residuals small.)
    """
    n, k = fit.jacobian.shape
    root = np.sqrt(1.0 + (fit.rows / fit.scale) ** 2)
    ridge = np.diag(1.0 / (_UNKNOWN * scales) ** 2)
    curvature = float(np.mean(root**-3)) * (fit.jacobian.T @ fit.jacobian) + ridge
    inverse = np.linalg.inv(curvature * np.outer(scales, scales)) * np.outer(scales, scales)
    # How much the loss has tamed the residuals, as a whole.
    tamed = np.sqrt(np.mean((fit.rows / root) ** 2) / max(float(np.mean(fit.rows**2)), 1e-300))
    gradient = (tamed * readings.share)[:, None] * fit.jacobian
    level = _local_level(readings.residual)
    spread = gradient[readings.row] * level[:, None]
    design = (fit.jacobian / (readings.share * readings.counts)[:, None])[readings.row]
    kernel = noise_kernel(readings.residual / level, design / level[:, None])
    if kernel is None:
        meat = spread.T @ spread * (n / max(n - k, 1)) + ridge
    else:
        meat = spread.T @ apply(kernel, spread) + ridge
    covariance = inverse @ meat @ inverse
    return np.asarray(0.5 * (covariance + covariance.T))


def inverse_curvature(fit: Robust, scales: Array) -> Array:
    """Inverse of the loss's second derivative at its minimum, shape (k, k).

    Parameters
    ----------
    fit, scales
        As in `sandwich`.
    """
    rows = fit.jacobian * ((1.0 + (fit.rows / fit.scale) ** 2) ** -0.75)[:, None] * scales
    ridge = np.eye(len(scales)) / _UNKNOWN**2
    return np.asarray(np.linalg.inv(rows.T @ rows + ridge) * np.outer(scales, scales))


def _local_level(residual: Array) -> Array:
    """Standard deviation of the readings, each from the tenth of the record around it."""
    width = max(20, len(residual) // 10)
    if len(residual) <= 2 * width:
        return np.full(len(residual), max(float(np.sqrt(np.mean(residual**2))), 1e-300))
    sums = np.concatenate([[0.0], np.cumsum(residual**2)])
    first = np.clip(np.arange(len(residual)) - width // 2, 0, len(residual) - width)
    means = (sums[first + width] - sums[first]) / width
    return np.asarray(np.sqrt(np.maximum(means, 1e-6 * means.max() + 1e-300)))


def correlation_length(residual: Array) -> float:
    """Lag over which the correlation of residuals is to be summed [readings].

    Andrews' rule for the Bartlett kernel, L = 1.1447 (4 rho^2 n / (1 - rho^2)^2)^(1/3) with
    rho the correlation of neighbours, taken over means of 1, 5 and 25 readings so that a
    slow part under white noise is seen; the largest counts.
    """
    longest = 0.0
    for size in (1, 5, 25):
        count = len(residual) // size
        if count < 20:
            break
        means = residual[: count * size].reshape(count, size).mean(axis=1)
        total = float((means**2).sum())
        rho = float((means[1:] * means[:-1]).sum()) / total if total > 0 else 0.0
        if rho < 2.0 / np.sqrt(count):
            continue
        rho = min(rho, 0.98)
        lag = 1.1447 * (4.0 * rho**2 * count / (1.0 - rho**2) ** 2) ** (1.0 / 3.0)
        longest = max(longest, lag * size)
    return longest


def inflation(residual: Array) -> float:
    """Readings that tell no more than one: long-run variance over variance, at least 1."""
    lags = min(int(correlation_length(residual)), len(residual) // 4)
    total = float((residual**2).sum())
    if lags == 0 or total == 0.0:
        return 1.0
    size = 2 ** int(np.ceil(np.log2(2 * len(residual))))
    power = np.abs(np.fft.rfft(residual, size)) ** 2
    correlation = np.fft.irfft(power, size)[1 : lags + 1] / total
    weights = 1.0 - np.arange(1, lags + 1) / (lags + 1.0)
    return max(1.0, 1.0 + 2.0 * float((weights * correlation).sum()))


def alike(residual: Array, bins: int) -> float:
    """Bins of the readings that tell no more than one, at least 1, see `inflation`."""
    return max(1.0, inflation(residual) * bins / len(residual))
