"""Steps with a change of the level, divided until the change is known.

Where the change is expected is found from what the checks use of their limits at the ends of a step
and beyond; the points to solve are about there, so that one round or two are enough.
"""

from __future__ import annotations

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.batch import Setting
from wraparc.checks.check import Level
from wraparc.reserve.brackets import OF_CHANGE, WIDTH, Brackets, Strips
from wraparc.reserve.levels import JUDGED, LevelRows, Levels

#: Least width, below which numbers of the solver end [-].
_LEAST = 1e-7
#: Steps of Newton's method on a curve.
_NEWTON = 3
#: Where a step is divided: from where the change is expected, in widths, and in equal parts.
_ABOUT = (-14.0, -6.0, -3.15, -2.25, -1.35, -0.45, 0.45, 1.35, 2.25, 3.15, 6.0, 14.0)
_THIRDS = 1.0 / 3.0, 2.0 / 3.0
#: Sign of the share of a limit in its margin, by check: minus where the value is at most the limit.
_SIGN = np.array([-1.0 if rule.at_most else 1.0 for rule in JUDGED])[:, None, None]


def divide(levels: LevelRows, brackets: Brackets, now: int) -> Brackets:
    """Return the same steps so short that the change is known."""
    while True:
        live = np.flatnonzero(brackets.width > _wide(brackets.far))
        if not len(live):
            return brackets
        described = levels.are_described(brackets.at_near.rows(live), brackets.at_far.rows(live))
        for some in (live[described], live[~described]):
            if len(some):
                _divide(levels, brackets, some, now)


def _wide(factors: Array) -> Array:
    """Return how wide a step may be in which a change is found [-]."""
    return np.maximum(np.minimum(WIDTH, OF_CHANGE * np.abs(factors - 1.0)), _LEAST)


def _divide(levels: LevelRows, brackets: Brackets, which: Integers, now: int) -> None:
    """Divide some steps: all described ones, or none of them."""
    steps = brackets.rows(which)
    at = _points(steps, _crossings(levels, steps, now))
    rows = np.repeat(np.arange(len(which)), at.shape[1])
    ends = steps.at_near.rows(rows), steps.at_far.rows(rows)
    found = levels(steps.which[rows], at.ravel(), Setting.PRECISE, ends)
    changed = ((found.rank != now) & (found.rank > 0)).reshape(at.shape)
    first = np.where(changed.any(axis=1), changed.argmax(axis=1), at.shape[1])
    strips = _between(steps, at, found)
    brackets.put(which, strips.brackets(np.arange(len(which)), first))


def _between(steps: Brackets, at: Array, found: Levels) -> Strips:
    """Return points within steps as strips, with the ends of the steps."""
    n, points = at.shape
    every = Levels.joined([steps.at_near, found, steps.at_far])
    inner = n + np.arange(n * points).reshape(n, points)
    ends = np.arange(n)[:, None]
    order = np.concatenate([ends, inner, ends + n * (points + 1)], axis=1)
    factors = np.concatenate([steps.near[:, None], at, steps.far[:, None]], axis=1)
    return Strips(steps.which, factors, every.rows(order.ravel()))


def _points(steps: Brackets, share: Array) -> Array:
    """Return factors within steps: about where the change is expected, and in equal parts."""
    wide = _wide(steps.near + (steps.far - steps.near) * share)
    about = share[:, None] + np.array(_ABOUT) * (wide / steps.width)[:, None]
    parts = np.broadcast_to(_THIRDS, (len(share), len(_THIRDS)))
    some = np.sort(np.concatenate([np.clip(about, 0.02, 0.98), parts], axis=1), axis=1)
    equal = np.arange(1, some.shape[1] + 1) / (some.shape[1] + 1.0)
    shares = np.where(np.isnan(share)[:, None], equal, some)
    return np.asarray(steps.near[:, None] + (steps.far - steps.near)[:, None] * shares)


def _crossings(levels: LevelRows, steps: Brackets, now: int) -> Array:
    """Return about where in its step each level changes, by margins; nan if not known [-]."""
    near, far = steps.at_near, steps.at_far
    share = _roots(steps, levels.fails_at)
    worse = far.rank > now
    rises = (far.ranks > now) & (near.ranks <= now) & worse
    falls = (near.ranks > far.rank) & (far.ranks <= far.rank) & ~worse
    known = np.isfinite(share) & (share > 0.0) & (share < 1.0)
    first = np.where(rises & known, share, np.inf).min(axis=(0, 1))
    last = np.where(falls & known, share, -np.inf).max(axis=(0, 1))
    found = np.where(worse, first, last)
    return np.where(np.isfinite(found), found, np.nan)


def _roots(steps: Brackets, fails_at: Array) -> Array:
    """Return where in its step each check changes its rank, of shape as margins [-].

    Where the logarithm of what is used of the limit is 0, over that of the factor, for both are
    about powers: by Newton's method from the straight line, on the curve through four points; where
    only one end of the step has a number, by the line through it and the next, or of a slope of 1.
    Where a check is missed at both ends, it is the margin from which on a drive fails.
    """
    ends = steps.at_near, steps.at_far, steps.at_beside, steps.at_beyond
    missed = np.minimum(steps.at_near.ranks, steps.at_far.ranks) > Level.OK.rank
    with np.errstate(all="ignore"):
        width = np.log(steps.far / steps.near)
        a, b = np.log(steps.beside / steps.near) / width, np.log(steps.beyond / steps.near) / width
        beyond = np.where(missed, np.log1p(_SIGN * fails_at[..., None]), 0.0)
        y, z, v, w = (_SIGN * (np.log1p(_SIGN * of.margins) - beyond) for of in ends)
        slope = z - y
        bend = _finite((v - y - slope * a) / (a * (a - 1.0)))
        turn = _finite((w - y - slope * b - bend * b * (b - 1.0)) / (b * (b - 1.0) * (b - a)))
        line = root = -y / slope
        for _ in range(_NEWTON):
            t = root
            value = y + t * (slope + (t - 1.0) * (bend + turn * (t - a)))
            along = t * (t - 1.0) + (2.0 * t - 1.0) * (t - a)
            root = t - value / (slope + bend * (2.0 * t - 1.0) + turn * along)
        root = np.where((root > 0.0) & (root < 1.0), root, line)
        before, after = (v - y) / a, (w - z) / (b - 1.0)
        before = np.where(np.isfinite(before) & (before > 0.0), before, np.abs(width))
        after = np.where(np.isfinite(after) & (after < 0.0), after, -np.abs(width))
        root = np.where(np.isposinf(steps.at_far.margins), -y / before, root)
        root = np.where(np.isposinf(steps.at_near.margins), 1.0 - z / after, root)
        return np.asarray(np.expm1(root * width) / np.expm1(width))


def _finite(of: Array) -> Array:
    return np.where(np.isfinite(of), of, 0.0)
