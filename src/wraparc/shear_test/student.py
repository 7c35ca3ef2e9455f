"""Quantiles of Student's t and chi-square, by which intervals of few tests are wider."""

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


def chi_square_ends(freedom: float) -> tuple[float, float]:
    """Quantiles 2.5 % and 97.5 % of chi-square."""
    return chi_square(freedom, 0.025), chi_square(freedom, 0.975)


@lru_cache
def chi_square(freedom: float, level: float) -> float:
    """Quantile of chi-square, by bisection of the incomplete gamma series."""

    def below(x: float) -> float:
        """P(a, x) = x^a e^-x sum_k x^k / gamma(a + k + 1), a = freedom / 2, x = chi-square / 2."""
        a = 0.5 * freedom
        part = total = math.exp(a * math.log(x) - x - math.lgamma(a + 1.0))
        k = 1
        while part > 1e-16 * total:
            part *= x / (a + k)
            total += part
            k += 1
        return total

    low, high = 1e-9, freedom + 20.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if below(middle) < level else (low, middle)
    return low + high
