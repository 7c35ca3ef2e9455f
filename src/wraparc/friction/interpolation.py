"""Monotone cubic interpolation (PCHIP), as polynomial coefficients.

F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
interpolants", SIAM J. Sci. Stat. Comput. 5 (1984) 300-304. Written out here because the
interpolant must reach the solvers as plain numbers without importing SciPy.
"""

from __future__ import annotations

import numpy as np

from wraparc.arrays import Array


def _end_slope(h0: float, h1: float, d0: float, d1: float) -> float:
    """One-sided three-point slope at an end, limited so that the first interval stays monotone."""
    slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if slope * d0 <= 0.0:
        return 0.0
    if d0 * d1 <= 0.0 and abs(slope) > 3.0 * abs(d0):
        return 3.0 * d0
    return slope


def pchip(x: Array, y: Array) -> Array:
    """Coefficients of the monotone cubic interpolant.

    Parameters
    ----------
    x
        Knots, strictly ascending, shape (n,), n >= 2.
    y
        Values at the knots, shape (n,).

    Returns
    -------
    numpy.ndarray
        Shape (n - 1, 4): c0 + c1 t + c2 t**2 + c3 t**3 with t = x - x[i] on interval i.
    """
    h = np.diff(x)
    d = np.diff(y) / h
    n = len(x)
    m = np.zeros(n)
    if n == 2:
        m[:] = d[0]
    else:
        w1 = 2.0 * h[1:] + h[:-1]
        w2 = h[1:] + 2.0 * h[:-1]
        same = d[:-1] * d[1:] > 0.0
        with np.errstate(divide="ignore", invalid="ignore"):
            mean = (w1 + w2) / (w1 / d[:-1] + w2 / d[1:])
        m[1:-1] = np.where(same, mean, 0.0)
        m[0] = _end_slope(h[0], h[1], d[0], d[1])
        m[-1] = _end_slope(h[-1], h[-2], d[-1], d[-2])
    c2 = (3.0 * d - 2.0 * m[:-1] - m[1:]) / h
    c3 = (m[:-1] + m[1:] - 2.0 * d) / h**2
    return np.column_stack([y[:-1], m[:-1], c2, c3])


def evaluate(x: Array, coefficients: Array, at: Array) -> Array:
    """Value of the interpolant, shape of `at`; the end cubics are continued outside the knots."""
    i = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(x) - 2)
    t = at - x[i]
    c = coefficients[i]
    value: Array = c[..., 0] + t * (c[..., 1] + t * (c[..., 2] + t * c[..., 3]))
    return value
