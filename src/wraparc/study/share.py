"""Estimated probabilities, and how far they can be trusted."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Share:
    """An estimated probability.

    Attributes
    ----------
    count, total
        How many of how many.
    """

    count: int
    total: int

    @property
    def value(self) -> float:
        """count/total; nan of nothing [-]."""
        return self.count / self.total if self.total else math.nan

    @property
    def interval(self) -> tuple[float, float]:
        """Wilson's score interval at `CONFIDENCE`."""
        return wilson(self.count, self.total)


def wilson(count: int, total: int) -> tuple[float, float]:
    """Wilson's score interval of a proportion at `CONFIDENCE` [-].

    (p + z^2/2n +- z sqrt(p (1 - p)/n + z^2/4n^2)) / (1 + z^2/n) for independent draws; Latin
    hypercube and Sobol draws are spread more evenly, and their estimate is mostly better than that.

    References
    ----------
    E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
    """
    if not total:
        return 0.0, 1.0
    z = NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE)
    p, n = count / total, float(total)
    middle = p + z * z / (2.0 * n)
    half = z * math.sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n))
    low, high = (middle - half) / (1.0 + z * z / n), (middle + half) / (1.0 + z * z / n)
    return (0.0 if count == 0 else max(0.0, low)), (1.0 if count == total else min(1.0, high))
