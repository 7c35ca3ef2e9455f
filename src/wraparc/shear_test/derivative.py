"""The paper's own check: the 5-point derivative of a curve against A ln x + (A - b).

B. DeVries found the law this way: the numerical derivative of a measured curve was a
logarithm. Here the curve's own A and b are drawn through it, and a straight line in ln x is
fitted to it for comparison.
"""

from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.curve_fit import CurveFit

_STEPS = 48


@dataclass(frozen=True, kw_only=True, eq=False)
class DerivativeCheck:
    """The derivative of one curve.

    Parameters
    ----------
    slip
        [m], shape (n,).
    slope
        Five-point derivative of the friction [1/m], shape (n,).
    law
        A ln x + (A - b) of the fitted curve there [1/m], shape (n,).
    a, b
        Of the logarithm fitted to the derivative itself, x in millimetres [1/mm].
    r_squared
        Of that fit.
    """

    slip: Array
    slope: Array
    law: Array
    a: float
    b: float
    r_squared: float


def five_point_derivative(values: Array, step: float) -> Array:
    """(f[i-2] - 8 f[i-1] + 8 f[i+1] - f[i+2]) / (12 h) at all but two values at each end."""
    f = values
    return np.asarray((f[:-4] - 8.0 * f[1:-3] + 8.0 * f[3:-1] - f[4:]) / (12.0 * step))


def derivative_check(fit: CurveFit) -> DerivativeCheck | None:
    """Differentiate a curve up to its peak; None if too little of it rises.

    The friction is averaged over equal steps of slip, then differentiated.
    """
    order = np.argsort(fit.slip)
    slip, friction = fit.slip[order], fit.friction[order]
    end = min(float(slip[-1]), fit.parameters.peak_slip)
    if end <= 0.0 or int(((slip > 0.0) & (slip < end)).sum()) < 2 * _STEPS:
        return None
    # Means over equal steps of slip, of the straight lines between the bins.
    area = np.concatenate([[0.0], np.cumsum(np.diff(slip) * 0.5 * (friction[1:] + friction[:-1]))])
    edges = np.linspace(0.0, end, _STEPS + 1)
    step = end / _STEPS
    mean = np.diff(np.interp(edges, slip, area)) / step
    slip = (np.arange(_STEPS, dtype=np.float64) + 0.5)[2:-2] * step
    slope = five_point_derivative(mean, step)
    a, b = fit.coefficients(1.0)
    line = np.polyfit(np.log(slip / 1e-3), slope * 1e-3, 1)
    left = slope * 1e-3 - np.polyval(line, np.log(slip / 1e-3))
    total_squares = float(((slope - slope.mean()) ** 2).sum()) * 1e-6
    return DerivativeCheck(
        slip=slip,
        slope=slope,
        law=a * np.log(slip) + (a - b),
        a=float(line[0]),
        b=float(line[0] - line[1]),
        r_squared=1.0 - float(left @ left) / max(total_squares, 1e-300),
    )
