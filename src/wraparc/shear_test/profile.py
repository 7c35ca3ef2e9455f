"""Interval of a peak slip from the profile of its likelihood.

A curve that ends long before its peak tells its initial slope well, and the peak slip badly: the
likelihood falls steeply to one side and hardly to the other. An interval from the curvature at the
best value then misses on both sides. The profile holds the peak slip at a value, fits everything
else, and asks how much worse the curve becomes (Bates and Watts 1988, Nonlinear regression
analysis and its applications, 6.1).
"""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from wraparc.shear_test.curve_fit import CurveFit, bins_alike, fit_curve
from wraparc.shear_test.reduce import FrictionCurve

# Chi-squared of one degree of freedom that is exceeded once in twenty.
_LIMIT = 3.841459
# Steps outwards and halvings of the last one, in ln x_pk; as far as `fit_curve` looks.
_STEPS, _HALVINGS, _LEAST, _REACH = 12, 6, 0.02, math.log(20.0)


def profile_interval(curve: FrictionCurve, fit: CurveFit) -> tuple[float, float]:
    """Return the 95 % interval of the peak slip [m].

    Parameters
    ----------
    curve, fit
        A curve and its fit.

    Returns
    -------
    low, high
        `high` is infinite where a peak at 20 times the tested slip is not excluded.
    """
    best = fit.parameters.ln_peak_slip
    independent = len(fit.friction) / bins_alike(curve, fit)
    least = _squares(fit)

    def excess(ln_slip: float) -> float:
        held = replace(fit.held, peak_slip=math.exp(ln_slip))
        squares = _squares(fit_curve(curve, bending=fit.bending, start=fit, held=held))
        return independent * math.log(max(squares / least, 1e-12)) - _LIMIT

    far = math.log(curve.travel[-1]) + _REACH
    low = _end(excess, best, max(best - 3.0, math.log(curve.travel[-1]) - 6.0))
    high = _end(excess, best, far)
    return math.exp(low), math.inf if high >= far - 1e-6 else math.exp(high)


def _end(excess: Callable[[float], float], best: float, bound: float) -> float:
    """Where the profile crosses its limit between the best value and a bound; else the bound."""
    inner = best
    for outer in best + (bound - best) * np.geomspace(_LEAST, 1.0, _STEPS):
        if excess(float(outer)) > 0.0:
            break
        inner = float(outer)
    else:
        return bound
    outer = float(outer)
    for _ in range(_HALVINGS):
        middle = 0.5 * (inner + outer)
        if excess(middle) > 0.0:
            outer = middle
        else:
            inner = middle
    return 0.5 * (inner + outer)


def _squares(fit: CurveFit) -> float:
    """Weighted sum of squares, large residuals counted less, as the fit does."""
    rows = fit.weights * (fit.friction - fit.fitted)
    return float((2.0 * (np.sqrt(1.0 + rows**2 / 4.0) - 1.0) * 4.0).sum())
