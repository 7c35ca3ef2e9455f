"""Repeats whose values lie apart, where several pressures may be so and hide each other."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.shear_test.consistency import USUAL_WEIGHT
from wraparc.shear_test.student import two_sided


class Repeats(NamedTuple):
    """A value of the tests of one pressure.

    Attributes
    ----------
    apart
        Largest less smallest.
    low, high
        Numbers of the tests that have them.
    squares, freedom
        Sum of squares about the mean, and its degrees of freedom.
    noise
        Sum of the variances of these two for their readings.
    """

    apart: float
    low: int
    high: int
    squares: float
    freedom: int
    noise: float


def repeats_of(values: Array, noise: Array, levels: Integers, use: Flags) -> list[Repeats]:
    """Return the repeats of each pressure that has some, the widest first.

    Parameters
    ----------
    values, noise
        Of each test, and its variance for its readings, shape (n,).
    levels
        Number of the pressure of each.
    use
        Which are counted.
    """
    found = []
    for k in np.unique(levels):
        own = np.flatnonzero((levels == k) & use)
        if len(own) < 2:
            continue
        low, high = int(own[np.argmin(values[own])]), int(own[np.argmax(values[own])])
        squares = float(((values[own] - values[own].mean()) ** 2).sum())
        both = float(noise[low] + noise[high])
        found.append(Repeats(float(np.ptp(values[own])), low, high, squares, len(own) - 1, both))
    return sorted(found, reverse=True)


def drawn(squares: Sequence[float], freedom: Sequence[int], usual: float) -> tuple[float, float]:
    """Variance by sums of squares, drawn towards a usual one; its degrees of freedom."""
    count = float(sum(freedom))
    variance = (float(sum(squares)) + USUAL_WEIGHT * usual**2) / (count + USUAL_WEIGHT)
    return variance, count + USUAL_WEIGHT - 1.0


def are_apart(repeats: Sequence[Repeats], usual: float, least: float, alarm: float) -> bool:
    """Return whether some are wider than the others allow.

    As many as half may be too wide: the last of the widest is compared with those that are not
    among them, from the most to one (the generalised test of Rosner 1983).

    Parameters
    ----------
    repeats
        The widest first.
    usual
        Standard deviation that counts as a few more repeats.
    least
        Difference below which nothing is apart.
    alarm
        How often sound repeats are called apart.
    """
    for count in range(min(max(len(repeats) // 2, 1), len(repeats)), 0, -1):
        own, rest = repeats[count - 1], repeats[count:]
        variance, freedom = drawn([r.squares for r in rest], [r.freedom for r in rest], usual)
        pairs = (len(rest) + 1) * own.freedom * (own.freedom + 1) / 2
        sure = two_sided(freedom, 1.0 - alarm / pairs)
        if own.apart > max(least, sure * float(np.sqrt(2.0 * variance + own.noise))):
            return True
    return False
