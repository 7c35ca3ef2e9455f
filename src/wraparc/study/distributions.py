"""How a quantity that is not known exactly is distributed: quantiles, cut to what can be."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, MissingExtraError, Problem

#: least part of a distribution that must lie within its limits
LEAST_KEPT = 1e-3


@dataclass(frozen=True, kw_only=True)
class Distribution(ABC):
    """A distribution, cut at `least` and `most`: what lies beyond is left out, the rest is whole.

    Attributes
    ----------
    least, most
        Where it is cut [the unit of the quantity].
    """

    least: float = -math.inf
    most: float = math.inf

    @abstractmethod
    def uncut(self, share: Array) -> Array:
        """Quantile of the distribution before it is cut."""

    @abstractmethod
    def share_below(self, value: float) -> float:
        """Cumulative probability at a value, before it is cut."""

    @abstractmethod
    def problems(self) -> list[Problem]:
        """What is wrong with its numbers."""

    def __post_init__(self) -> None:
        problems = self.problems()
        if not self.least < self.most:
            text = f"{self.least:g} to {self.most:g}"
            problems.append(Problem(key="least", value=text, message="least must be below most"))
        elif not problems and self.kept < LEAST_KEPT:
            problems.append(
                Problem(
                    message=f"only {self.kept:.2g} of the distribution lies within its limits "
                    f"{self.least:g} to {self.most:g}",
                    remedy="Check its numbers and their units.",
                )
            )
        if problems:
            raise InputError(problems)

    @property
    def kept(self) -> float:
        """Part of the distribution within its limits [-]."""
        return self._ends[1] - self._ends[0]

    @property
    def _ends(self) -> tuple[float, float]:
        low = 0.0 if self.least == -math.inf else self.share_below(self.least)
        high = 1.0 if self.most == math.inf else self.share_below(self.most)
        return low, high

    def quantile(self, share: Array) -> Array:
        """Value below which a share in (0, 1) of the cut distribution lies; any shape."""
        low, high = self._ends
        value = self.uncut(low + (high - low) * np.asarray(share, dtype=float))
        return np.clip(value, self.least, self.most)


@dataclass(frozen=True, kw_only=True)
class Uniform(Distribution):
    """Every value from `low` to `high` alike."""

    low: float
    high: float

    def problems(self) -> list[Problem]:
        """Return whether the ends are in order."""
        return _ascending(("from", self.low), ("to", self.high))

    def uncut(self, share: Array) -> Array:
        """Quantile low + share (high - low)."""
        return self.low + share * (self.high - self.low)

    def share_below(self, value: float) -> float:
        """(value - low)/(high - low)."""
        return min(1.0, max(0.0, (value - self.low) / (self.high - self.low)))


@dataclass(frozen=True, kw_only=True)
class Normal(Distribution):
    """Normal distribution of a mean and a standard deviation."""

    mean: float
    standard_deviation: float

    def problems(self) -> list[Problem]:
        """Return whether it has a width."""
        return _positive("standard_deviation", self.standard_deviation)

    def uncut(self, share: Array) -> Array:
        """Quantile of the normal distribution."""
        return self.mean + self.standard_deviation * normal_quantile(share)

    def share_below(self, value: float) -> float:
        """Cumulative normal distribution."""
        return _normal_share((value - self.mean) / self.standard_deviation)


@dataclass(frozen=True, kw_only=True)
class Lognormal(Distribution):
    """A quantity whose logarithm is normal.

    Attributes
    ----------
    median
        Value that half lie below, > 0.
    geometric_standard_deviation
        Factor, > 1: 68 % lie between the median over it and the median times it [-].
    """

    median: float
    geometric_standard_deviation: float

    def problems(self) -> list[Problem]:
        """Return whether it has a place and a width."""
        found = _positive("median", self.median)
        if not 1.0 < self.geometric_standard_deviation < math.inf:
            found.append(
                Problem(
                    key="geometric_standard_deviation",
                    value=f"{self.geometric_standard_deviation:g}",
                    message="must be a factor of more than 1",
                    remedy="Write 1.1 for about 10 % to either side.",
                )
            )
        return found

    def uncut(self, share: Array) -> Array:
        """Median * s^z with the normal quantile z."""
        width = math.log(self.geometric_standard_deviation)
        return self.median * np.exp(width * normal_quantile(share))

    def share_below(self, value: float) -> float:
        """Cumulative normal distribution of the logarithm."""
        if value <= 0.0:
            return 0.0
        width = math.log(self.geometric_standard_deviation)
        return _normal_share(math.log(value / self.median) / width)


@dataclass(frozen=True, kw_only=True)
class Triangular(Distribution):
    """From `low` over the most probable value `mode` to `high`, in straight lines."""

    low: float
    mode: float
    high: float

    def problems(self) -> list[Problem]:
        """Return whether the corners are in order."""
        found = _ascending(("from", self.low), ("to", self.high))
        if not found and not self.low <= self.mode <= self.high:
            text = f"must lie between from and to, {self.low:g} and {self.high:g}"
            found.append(Problem(key="mode", value=f"{self.mode:g}", message=text))
        return found

    def uncut(self, share: Array) -> Array:
        """Quantile: the square root of the area from the nearer end."""
        width, left = self.high - self.low, self.mode - self.low
        right = self.high - self.mode
        rising = self.low + np.sqrt(share * width * left)
        falling = self.high - np.sqrt((1.0 - share) * width * right)
        return np.where(share * width < left, rising, falling)

    def share_below(self, value: float) -> float:
        """Area to the left."""
        width, left, right = self.high - self.low, self.mode - self.low, self.high - self.mode
        if value <= self.low:
            return 0.0
        if value >= self.high:
            return 1.0
        if value < self.mode:
            return (value - self.low) ** 2 / (width * left)
        return 1.0 - (self.high - value) ** 2 / (width * right)


def _positive(key: str, value: float) -> list[Problem]:
    if 0.0 < value < math.inf:
        return []
    return [Problem(key=key, value=f"{value:g}", message="must be more than 0 and finite")]


def _ascending(low: tuple[str, float], high: tuple[str, float]) -> list[Problem]:
    if -math.inf < low[1] < high[1] < math.inf:
        return []
    message = f"{low[0]} must be below {high[0]}, and both finite"
    return [Problem(key=high[0], value=f"{low[1]:g} to {high[1]:g}", message=message)]


def normal_quantile(share: Array) -> Array:
    """Standard normal quantile of shares in (0, 1)."""
    try:
        from scipy.special import ndtri
    except ImportError as error:
        raise MissingExtraError("scipy", "study") from error
    return np.asarray(ndtri(share), dtype=float)


def _normal_share(z: float) -> float:
    return 0.5 * math.erfc(-z / math.sqrt(2.0))
