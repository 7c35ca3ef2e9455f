"""Quantiles of Student's t, by which intervals of few tests are wider."""

import math
from functools import lru_cache

import numpy as np


def t95(freedom: float) -> float:
    """Quantile of Student's t for a two-sided 95 % interval; one degree of freedom at least."""
    return two_sided(freedom, 0.95)


@lru_cache
def two_sided(freedom: float, level: float) -> float:
    """Quantile of Student's t for a two-sided interval that holds with probability `level`.

    The density is summed from 0 to t (Simpson) and t moved by Newton's steps: from below, where
    the distribution is concave, they do not overshoot. To import SciPy for it took longer than to
    read and fit a test.

    Parameters
    ----------
    freedom
        Degrees of freedom; one at least is taken.
    level
        From 0.95.
    """
    n, t = max(freedom, 1.0), 1.959964
    top = math.exp(math.lgamma(0.5 * (n + 1.0)) - math.lgamma(0.5 * n)) / math.sqrt(n * math.pi)
    for _ in range(40):
        x = np.linspace(0.0, t, 2001)
        density = top * (1.0 + x**2 / n) ** (-0.5 * (n + 1.0))
        odd, even = density[1:-1:2].sum(), density[2:-1:2].sum()
        below = (density[0] + density[-1] + 4.0 * odd + 2.0 * even) * t / 6000.0
        step = float((0.5 * level - below) / density[-1])
        t += step
        if abs(step) < 1e-10:
            break
    return t
