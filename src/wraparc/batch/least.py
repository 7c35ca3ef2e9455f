"""Least tension, or largest pull, at a creep limit for many arcs: a search along the tension.

The pull at the creep limit grows with the tight-side tension up to a top, and may fall past it:
more tension makes friction worse and shrinks the belt more. Where the pull asked for lies above the
top there is no least tension, and the top is told.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers

#: pull [N] at the creep limit for ln tight-side tensions of some rows, and which of it is found;
Pull = Callable[[Array, Integers], tuple[Array, Flags]]

LOWEST = 1e-4  # of ln tight-side tension above the pull, where slack-side tension ends
DEEPEST = 3.0  # below the top of the tested pressures, in ln tension, that is looked at
GROWTH = 2.5  # of the steps down from the top
NARROWINGS = 7  # of the bracket of the largest pull; at a kink of the law it needs so many
EVEN = 1e-7  # of a pull: one that is less by that is as large
TOO_NEAR = 3e-5  # of ln pull to the largest one: the least tension is ill-conditioned
ROUNDS, NEAR = 40, 1e-7  # of false position, and of ln pull


class Least(NamedTuple):
    """What is found, shapes (n,): tight-side tensions and pulls [N]."""

    least: Array  # the least tension, nan where there is none
    most: Array  # the largest pull, nan where there is a least tension
    good: Flags
    top: Array  # ln of the tension of the largest pull


def search_least(pull_within: Pull, pull: Array, highest: Array) -> Least:
    """Least tight-side tension that carries a pull at the creep limit, else the largest pull.

    Parameters
    ----------
    pull_within
        Pull at the creep limit.
    pull
        Pull to be carried, shape (n,) [N].
    highest
        Largest tight-side tension to consider, shape (n,) [N].
    """
    rows = np.arange(len(pull))
    low, high = np.log(pull) + LOWEST, np.log(highest)
    top, most, good = _top(pull_within, low, high)
    away = np.log(most / pull)
    good &= (low < high) & (np.abs(away) > TOO_NEAR)
    least = np.full(len(pull), np.nan)
    inside = rows[good & (away > 0.0)]
    least[inside], found = _root(pull_within, inside, low[inside], top[inside], pull[inside])
    good[inside[~found]] = False
    most[~good | (away > 0.0)] = np.nan
    return Least(np.exp(least), most, good, top)


def _climbs(lower: Array, higher: Array) -> Flags:
    """Whether the pull does not fall towards the lower of two tensions.

    Far above the tested pressures it is the same for all, where traction is held.
    """
    return np.asarray(lower > (1.0 - EVEN) * higher)


def _top(pull_within: Pull, low: Array, high: Array) -> tuple[Array, Array, Flags]:
    """Tension in [low, high], as a logarithm, of the largest pull; that pull; where it is found.

    Steps down from `high` that grow, until the pull falls; then parabolas through the three best.
    """
    rows = np.arange(len(low))
    step = np.minimum(0.02 * (high - low), 0.05)
    bottom = np.maximum(low, high - DEEPEST)
    right, middle = high.copy(), high.copy()
    best, good = pull_within(high, rows)
    f_right = best.copy()
    left = middle - step
    f_left, sound = pull_within(left, rows)
    good &= sound
    climbing = rows[good & _climbs(f_left, best)]
    inside = climbing
    while len(climbing):
        i = climbing
        right[i], f_right[i], middle[i], best[i] = middle[i], best[i], left[i], f_left[i]
        left[i] = np.maximum(left[i] - GROWTH * (right[i] - middle[i]), bottom[i])
        f_left[i], sound = pull_within(left[i], i)
        climbs = _climbs(f_left[i], best[i])
        good[i] &= sound & ~(climbs & (left[i] <= bottom[i]))
        climbing = i[good[i] & climbs]
    x, f = np.stack([left, middle, right]), np.stack([f_left, best, f_right])
    for _ in range(NARROWINGS):
        i = inside = inside[good[inside]]
        at = crown(x[:, i], f[:, i])
        new, sound = pull_within(at, i)
        good[i] &= sound
        x[:, i], f[:, i] = narrowed(x[:, i], f[:, i], at, new)
    return x[1], f[1], good


def crown(x: Array, f: Array) -> Array:
    """Top of the parabola through three points in order, shape (3, n), kept off them."""
    (a, b, c), (f_a, f_b, f_c) = x, f
    left, right = (b - a) * (f_b - f_c), (c - b) * (f_b - f_a)
    at = b + 0.5 * ((c - b) * right - (b - a) * left) / np.maximum(left + right, 1e-300)
    apart = 0.02 * (c - a)
    at = np.where(np.abs(at - b) < apart, b + np.where(c - b > b - a, apart, -apart), at)
    nearest = 0.5 * np.minimum(apart, np.minimum(b - a, c - b))
    return np.asarray(np.minimum(np.maximum(at, a + nearest), c - nearest))


def narrowed(x: Array, f: Array, at: Array, new: Array) -> tuple[Array, Array]:
    """Three points around the best of four: the worse of the two inner ones becomes an end."""
    better = new > f[1]  # False where it is not known
    worse, f_worse = np.where(better, x[1], at), np.where(better, f[1], new)
    to_left = (at > x[1]) == better
    return (
        np.stack(
            [
                np.where(to_left, worse, x[0]),
                np.where(better, at, x[1]),
                np.where(to_left, x[2], worse),
            ]
        ),
        np.stack(
            [
                np.where(to_left, f_worse, f[0]),
                np.where(better, new, f[1]),
                np.where(to_left, f[2], f_worse),
            ]
        ),
    )


def _root(
    pull_within: Pull, which: Integers, low: Array, high: Array, pull: Array
) -> tuple[Array, Flags]:
    """Tension below the top, as a logarithm, that carries the pull: false position."""
    if not len(which):
        return high, np.zeros(0, dtype=bool)
    low, high = low.copy(), high.copy()
    f_low, sound_low = _miss(pull_within, which, low, pull)
    f_high, sound_high = _miss(pull_within, which, high, pull)
    good = sound_low & sound_high & (f_low < 0.0) & (f_high > 0.0)
    found, last = high.copy(), np.zeros(len(which))
    open_ = np.flatnonzero(good)
    for _ in range(ROUNDS):
        i = open_
        if not len(i):
            break
        at = (low[i] * f_high[i] - high[i] * f_low[i]) / (f_high[i] - f_low[i])
        f, sound = _miss(pull_within, which[i], at, pull[i])
        good[i] &= sound
        found[i] = at
        above = f > 0.0
        # Illinois: the end that is kept twice counts half
        f_low[i] *= np.where(above & (last[i] > 0.0), 0.5, 1.0)
        f_high[i] *= np.where(~above & (last[i] < 0.0), 0.5, 1.0)
        high[i], f_high[i] = np.where(above, at, high[i]), np.where(above, f, f_high[i])
        low[i], f_low[i] = np.where(above, low[i], at), np.where(above, f_low[i], f)
        last[i] = np.where(above, 1.0, -1.0)
        open_ = i[sound & (np.abs(f) > NEAR)]
    good[open_] = False
    return found, good


def _miss(pull_within: Pull, which: Integers, at: Array, pull: Array) -> tuple[Array, Flags]:
    """Relative miss of a pull, as a logarithm, and where it is known."""
    carried, sound = pull_within(at, which)
    return np.log(np.maximum(carried, 1e-9 * pull) / pull), sound
