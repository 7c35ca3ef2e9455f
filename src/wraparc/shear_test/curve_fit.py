"""One friction curve to one integral-log law, with its lash, robustly, with intervals.

Lash and curve are fitted together: the lash decides where the steep start of the curve
lies, and the curve decides what of the first travel is lash.
"""

from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array
from wraparc.friction import ab_from_peak
from wraparc.shear_test.curve_held import FREE, Held
from wraparc.shear_test.curve_model import (
    PARAMETERS,
    CurveParameters,
    friction_and_jacobian,
    slip_at,
)
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.shear_test.robust import (
    Readings,
    Robust,
    alike,
    fit_robust,
    inverse_curvature,
    sandwich,
)

BASE = ("ln_peak_slip", "ln_peak_friction", "lash")
TAILS: tuple[tuple[str, ...], ...] = (
    (),
    ("post_peak_slope",),
    ("post_peak_slope", "residual_friction"),
)
_FLOOR = 0.003
# No test tells a peak that lies further beyond it.
_LN_RANGE = np.log(20.0)
_GRID = 32
# A residual level above any peak: the curve stays at its peak.
_NO_LEVEL = 1e9
#: Standard normal quantile of a two-sided 95 % interval.
Z95 = 1.959964


@dataclass(frozen=True, kw_only=True, eq=False)
class CurveFit:
    """The law of one curve.

    Parameters
    ----------
    parameters
        Best values; what was not fitted has its fixed value.
    free
        Names of the fitted parameters, in the order of `covariance`.
    covariance
        Of the fitted parameters, from the scatter of the data about the curve, its
        correlation along the curve included, and from a zero of the force that the record does
        not show, shape (k, k).
    by_zero
        Part of that zero in the parameters, one standard deviation, shape (k,).
    flatness
        Inverse curvature of the loss in ln x_pk, ln mu_pk, all bins independent, shape (2, 2).
    bending
        Travel taken off for the shear of sample and rig, per unit of friction [m].
    slip
        Slip of the bins [m], shape (m,): travel less lash and bending.
    friction
        Friction of the bins, zero taken off [-], shape (m,).
    fitted
        Friction of the fit at the same travel [-], shape (m,).
    weights
        Inverse standard deviation given to each bin.
    slip_max
        Largest slip in the test [m].
    r_squared
        1 - residual / total sum of squares over the bins.
    noise
        Robust standard deviation of one reading about the curve [-].
    remainder
        Root mean square of the smoothed residual [-], what noise would leave taken off.
    held
        What was not fitted, but given.
    """

    parameters: CurveParameters
    free: tuple[str, ...]
    covariance: Array
    by_zero: Array
    flatness: Array
    bending: float
    slip: Array
    friction: Array
    fitted: Array
    weights: Array
    slip_max: float
    r_squared: float
    noise: float
    remainder: float
    held: Held = FREE

    @property
    def peak_inside(self) -> bool:
        """Whether the peak lies inside the tested slip."""
        return self.parameters.peak_slip < 0.995 * self.slip_max

    def error(self, name: str) -> float:
        """Standard error of a parameter; 0 if it was not fitted."""
        if name not in self.free:
            return 0.0
        k = self.free.index(name)
        return float(np.sqrt(self.covariance[k, k]))

    def interval(self, name: str) -> tuple[float, float]:
        """95 % interval of a parameter; of ``peak_slip`` and ``peak_friction`` too."""
        if name in {"peak_slip", "peak_friction"}:
            low, high = self.interval(f"ln_{name}")
            with np.errstate(over="ignore"):  # not determined at all: no upper bound
                return float(np.exp(low)), float(np.exp(high))
        value, error = getattr(self.parameters, name), self.error(name)
        return value - Z95 * error, value + Z95 * error

    def coefficients(self, unit: float = 1e-3) -> tuple[float, float]:
        """A and b of mu = A x ln x - b x, x in `unit` metres (millimetres by default)."""
        q = self.parameters
        return ab_from_peak(q.peak_friction, q.peak_slip / unit)

    def coefficient_errors(self) -> tuple[float, float]:
        """Standard errors of A and b, by the delta method."""
        a, b = self.coefficients()
        k = [self.free.index(name) for name in BASE[:2]]
        cov = self.covariance[np.ix_(k, k)]
        by_a = np.array([-a, a])
        # b = A (1 + ln x): db = b/A dA + A dln x.
        by_b = by_a * (b / a) + np.array([a, 0.0])
        return float(np.sqrt(by_a @ cov @ by_a)), float(np.sqrt(by_b @ cov @ by_b))


@dataclass(frozen=True, kw_only=True)
class Prior:
    """What the other tests say about a curve's (ln x_pk, ln mu_pk): mean and covariance."""

    mean: Array
    covariance: Array


def fit_curve(
    curve: FrictionCurve,
    *,
    bending: float | None = None,
    lash: float | None = None,
    hold_zero: bool = False,
    start: "CurveFit | None" = None,
    prior: Prior | None = None,
    held: Held = FREE,
) -> CurveFit:
    """Fit the law to a curve.

    Parameters
    ----------
    curve
        From `reduce_record`.
    bending
        K to take off instead of the curve's own; 0 leaves the sample's shear in the slip.
    lash
        Fixed lash [m], instead of fitting it.
    hold_zero
        Whether to keep the force's zero at what the record shows before the slip starts.
    start
        An earlier fit: its form is kept, what it held fixed stays so, its values are the start.
    prior
        Knowledge from the other curves, in a joint fit.
    held
        Parameters that are given, not fitted; with `start`, those of the earlier fit.
    """
    held = held if start is None or held is not FREE else start.held
    lash = lash if held.lash is None else held.lash
    task = _Task(curve, curve.bending if bending is None else bending, prior, held)
    if start is not None:
        return task.finish(task.run(start.parameters, start.free))
    # A lash that is not the curve's own would push its misfit into the zero.
    hold_zero = hold_zero or curve.zero is None or lash is not None
    zero = () if hold_zero else ("zero",)
    base = (*(BASE if lash is None else BASE[:2]), *zero)
    runs = [task.run(task.grid(lash), base)]
    peak = runs[0].parameters.peak_slip
    if peak < 1.05 * (float(curve.travel[-1]) - runs[0].parameters.lash):
        for tail in TAILS[1:]:
            runs.append(task.run(task.tail_start(runs[-1].parameters, tail), (*base, *tail)))
    readings = task.readings(runs[-1].parameters)
    repeats = alike(readings, len(runs[0].solution.rows))
    return task.finish(min(runs, key=lambda run: run.criterion(repeats)))


def bins_alike(curve: FrictionCurve, fit: CurveFit) -> float:
    """Return how many bins of a curve tell no more than one: their readings are correlated.

    Parameters
    ----------
    curve, fit
        A curve and its fit.
    """
    fitted = np.interp(curve.travel, curve.binned_travel, fit.fitted + fit.parameters.zero)
    return alike(curve.friction - fitted, len(fit.friction))


class _Task:
    """One curve's data with its weights; what the steps of the fit share."""

    def __init__(
        self, curve: FrictionCurve, bending: float, prior: Prior | None, held: Held
    ) -> None:
        self.curve, self.bending, self.prior, self.held = curve, bending, prior, held
        self.travel, self.friction = curve.binned_travel, curve.binned_friction
        self.top = max(float(np.quantile(np.abs(self.friction), 0.98)), 1e-12)
        variance = curve.noise**2 / curve.counts + (_FLOOR * self.top) ** 2
        self.weights = 1.0 / np.sqrt(variance)

    def grid(self, lash: float | None) -> CurveParameters:
        """Start: the best of a grid of peak slips and lashes, friction flat past its peak."""
        zero = self.curve.zero or 0.0
        thin = slice(None, None, max(1, len(self.travel) // 200))
        y, w = self.friction[thin] - zero, self.weights[thin]
        reach = float(self.travel[-1])
        onset = self.curve.onset
        lashes = (
            np.array([lash])
            if lash is not None
            else np.concatenate(
                [onset * np.linspace(0.4, 1.0, 7), -reach * np.array([0.003, 0.01, 0.03])]
            )
        )
        peaks = np.geomspace(0.01, 15.0, _GRID) * reach
        slip = self.travel[thin] - self.bending * y - lashes[:, None]
        r = np.clip(slip[:, None, :] / peaks[:, None], 1e-9, 1.0)
        shape = np.where(slip[:, None, :] > 0.0, r * (1.0 - np.log(r)), 0.0)
        scale = (w**2 * y * shape).sum(-1) / np.maximum((w**2 * shape**2).sum(-1), 1e-300)
        cost = ((w * (y - scale[..., None] * shape)) ** 2).sum(-1)
        cost[scale <= 0.0] = np.inf

        i, j = np.unravel_index(np.argmin(cost), cost.shape)
        mu = max(float(scale[i, j]), 1e-6)
        return CurveParameters(
            float(np.log(peaks[j])), float(np.log(mu)), float(lashes[i]), 0.0, _NO_LEVEL, zero
        )

    def tail_start(self, q: CurveParameters, tail: tuple[str, ...]) -> CurveParameters:
        """Start of the line (and the level) past the peak, from the fit without it."""
        slip = self.travel - q.lash - self.bending * (self.friction - q.zero)
        past = slip > q.peak_slip
        gentle = -1e-3 * q.peak_friction / q.peak_slip
        if past.sum() < 5:
            return replace(q, residual_friction=0.0, post_peak_slope=gentle)
        slope = min(float(np.polyfit(slip[past], self.friction[past], 1)[0]), gentle)
        if len(tail) == 1:
            return replace(q, post_peak_slope=slope, residual_friction=0.0)
        level = float(np.median(self.friction[past][-max(3, int(past.sum()) // 4) :])) - q.zero
        return replace(q, post_peak_slope=2.0 * slope, residual_friction=max(level, 1e-6))

    def run(self, start: CurveParameters, free: tuple[str, ...]) -> "_Run":
        """Robust least squares over `free`."""
        places = [PARAMETERS.index(name) for name in free]
        values = start.vector()
        low, high = self._bounds()

        def residual(vector: Array) -> tuple[Array, Array]:
            full = values.copy()
            full[places] = vector
            q = CurveParameters(*full.tolist())
            model, jacobian = friction_and_jacobian(self.travel, self.bending, q)
            rows = self.weights * (model - self.friction)
            return rows, self.weights[:, None] * jacobian[:, places]

        first = np.clip(values[places], low[places] + 1e-9, high[places] - 1e-12)
        solution = fit_robust(residual, first, (low[places], high[places]), self._pull(free))
        values[places] = solution.vector
        return _Run(CurveParameters(*values.tolist()), free, solution)

    def _scales(self, free: tuple[str, ...]) -> Array:
        """Natural size of the parameters."""
        reach = float(self.travel[-1])
        sizes = (1.0, 1.0, 0.1 * reach, self.top / reach, self.top, 0.1 * self.top)
        return np.array([sizes[PARAMETERS.index(name)] for name in free])

    def _bounds(self) -> tuple[Array, Array]:
        """Bounds of all parameters; a record that starts flat starts before the slip."""
        reach, ln_top = float(self.travel[-1]), float(np.log(self.top))
        first_lash = -reach if self.curve.zero is None else 0.0
        steepest = -50.0 * self.top / reach
        low = [np.log(reach) - 6.0, ln_top - 3.0, first_lash, steepest, 1e-9, -self.top]
        high = [np.log(reach) + _LN_RANGE, ln_top + 4.0, 0.6 * reach, 0.0, 1e10, self.top]
        return self.held.pinned(np.array(low), np.array(high))

    def _pull(self, free: tuple[str, ...]) -> tuple[Array, Array] | None:
        """Extra rows that hold (ln x_pk, ln mu_pk) to the prior: target vector and root weight."""
        if self.prior is None:
            return None
        root = np.linalg.cholesky(np.linalg.inv(self.prior.covariance)).T
        matrix = np.zeros((2, len(free)))
        for k, name in enumerate(BASE[:2]):
            matrix[:, free.index(name)] = root[:, k]
        return matrix, root @ self.prior.mean

    def _by_zero(self, solution: Robust) -> Array:
        """Change of the fitted parameters with the zero of the force, as far as it is linear."""
        root = 1.0 / (1.0 + (solution.rows / solution.scale) ** 2) ** 0.25
        found = np.linalg.lstsq(solution.jacobian * root[:, None], self.weights * root, rcond=1e-9)
        return np.asarray(found[0])

    def readings(self, q: CurveParameters) -> Array:
        """Reading minus model for every reading."""
        model, _ = friction_and_jacobian(self.curve.travel, self.bending, q)
        return self.curve.friction - model

    def finish(self, run: "_Run") -> CurveFit:
        """Covariance and figures of merit of the chosen run."""
        q, solution = run.parameters, run.solution
        single = self.readings(q)
        counts = self.curve.counts
        readings = Readings(single, self.curve.place, self.weights / counts, counts)
        covariance = sandwich(solution, readings, self._scales(run.free))
        covariance = self.held.known(covariance, run.free)
        by_zero = self._by_zero(solution) * self.curve.zero_unknown * (np.diag(covariance) > 0.0)
        model, _ = friction_and_jacobian(self.travel, self.bending, q)
        off = self.friction - model
        total = float(((self.friction - self.friction.mean()) ** 2).sum())
        slip = slip_at(self.travel, self.bending, q)
        end = slip_at(self.curve.travel[-1:], self.bending, q)
        return CurveFit(
            parameters=q,
            free=run.free,
            covariance=covariance + np.outer(by_zero, by_zero),
            by_zero=by_zero,
            flatness=inverse_curvature(solution, self._scales(run.free))[:2, :2],
            bending=self.bending,
            slip=self.travel - q.lash - self.bending * (self.friction - q.zero),
            friction=self.friction - q.zero,
            fitted=model - q.zero,
            weights=self.weights,
            slip_max=float(end[0]),
            r_squared=1.0 - float((off**2).sum()) / max(total, 1e-300),
            noise=float(1.4826 * np.median(np.abs(single - np.median(single)))),
            remainder=_remainder(slip, off, self.weights),
            held=self.held,
        )


def _remainder(slip: Array, off: Array, weights: Array) -> float:
    """Root mean square of the residual averaged over 30 stretches of slip, less its noise."""
    stretch = np.minimum((slip / max(float(slip[-1]), 1e-12) * 30).astype(int), 29)
    squares: list[float] = []
    noise: list[float] = []
    for k in np.unique(stretch):
        inside = stretch == k
        w = weights[inside] ** 2
        squares.append(float((w * off[inside]).sum() / w.sum()) ** 2)
        noise.append(1.0 / float(w.sum()))
    return float(np.sqrt(max(float(np.mean(squares) - np.mean(noise)), 0.0)))


@dataclass(frozen=True, eq=False)
class _Run:
    parameters: CurveParameters
    free: tuple[str, ...]
    solution: Robust

    def criterion(self, repeats: float) -> float:
        """Bayesian information criterion with the noise level estimated.

        Parameters
        ----------
        repeats
            Rows that together tell no more than one, because their noise is correlated.
        """
        n = len(self.solution.rows)
        independent = n / repeats
        penalty = np.log(independent) * len(self.free)
        return float(independent * np.log(self.solution.cost / n) + penalty)
