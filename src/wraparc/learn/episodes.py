"""Wet or dirty episodes: friction that falls within minutes, found by a cumulative sum.

The level at which the sum alarms comes from the log itself: friction does not rise by 15 % within
minutes, so what the mirrored sum does is noise alone, and its excursions have an exponential tail.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.learn.fit import LearnFit
from wraparc.learn.grid import STEP
from wraparc.learn.windows import DAY, WINDOW, Windows

YEAR = 365.25 * DAY
#: Fall of ln friction that is sought, false alarms a running year that are wanted, and the factor
#: by which the mirror's promise was too low in trials.
SHIFT, WANTED, PROMISE = -0.15, 2.0, 4.0
#: Signal over noise below which no episode is sought on a drive, squared that of a window below
#: which it says nothing; longest pause of a sum [s].
LEAST_SENSITIVITY, _SEEN, _PAUSE = 2.0, 0.5, 7200.0
#: Changes of ln friction that are tried.
_CHANGES = np.linspace(-1.2, 0.3, 61)
_CLIP, _TAIL, _LOWEST, _HIGHEST, _USUAL = 3.0, 30, 6.0, 60.0, 15.0


@dataclass(frozen=True)
class Episode:
    """A span in which friction was lower.

    Attributes
    ----------
    start, stop
        From the start of the log [s].
    alarmed
        When it was known [s].
    change
        Of friction, as a part of that before [-].
    torque
        Highest in it, over the rated one [-].
    """

    start: float
    stop: float
    alarmed: float
    change: float
    torque: float


@dataclass
class _Span:
    """First window of an excursion, that in which it was known, and the last before it falls."""

    first: int
    known: int
    last: int


@dataclass(frozen=True, eq=False)
class Episodes:
    """What was found.

    Attributes
    ----------
    found
        The episodes in time order.
    low
        Windows in which friction was lower, shape (n,).
    sensitivity
        Change of y by ln friction at peak torque, over the spread of a window, by pulley [-].
    spread
        Of the residual of a window by pulley [-].
    residual
        y less what is expected [-], shape (k, n).
    """

    found: tuple[Episode, ...]
    low: Flags
    sensitivity: tuple[float, ...]
    spread: Array
    residual: Array


def find_episodes(windows: Windows, fit: LearnFit, cuts: Sequence[int] = ()) -> Episodes:
    """Return the episodes of lower friction in steady windows, none on the days of cuts."""
    days = windows.time / DAY
    normal = fit.curve(windows.torque, days, windows.play)
    shift = fit.curve(windows.torque, days, windows.play, SHIFT) - normal
    residual = windows.difference - fit.course("zero", days) - normal
    spread = np.array([1.4826 * np.median(np.abs(r - np.median(r))) for r in residual])
    spread = np.maximum(spread, 1e-5)
    top = np.quantile(windows.torque, 0.99, axis=1)
    peak = [m >= 0.95 * t for m, t in zip(windows.torque, top, strict=True)]
    sensitivity = tuple(
        abs(float(np.median(s[p])) / SHIFT) / float(sd) if p.any() else 0.0
        for s, p, sd in zip(shift, peak, spread, strict=True)
    )
    none = Episodes((), np.zeros(len(days), dtype=bool), sensitivity, spread, residual)
    if max(sensitivity) < LEAST_SENSITIVITY or len(days) < 100:
        return none
    inverse = np.asarray(np.linalg.inv(2.0 * _covariance(residual, spread)))
    power = np.einsum("in,ij,jn->n", shift, inverse, shift)
    seen = (2.0 * power > _SEEN) & ~np.isin(windows.day, list(cuts))

    def gain(of: Array) -> Array:
        linear = np.einsum("in,ij,jn->n", shift, inverse, of)
        return np.asarray(seen * np.clip(linear - 0.5 * power, -_CLIP, _CLIP))

    forward, mirrored = gain(residual), gain(-residual)
    years = len(days) * WINDOW * STEP / YEAR
    level = _level(_sum(windows.time, mirrored, 1e9)[2], years)
    spans, low, _ = _sum(windows.time, forward, level)
    found = [_episode(windows, fit, inverse, span) for span in spans]
    found = [e for e in found if e.change < 0.0]
    return Episodes(tuple(found), low, sensitivity, spread, residual)


def _covariance(residual: Array, spread: Array) -> Array:
    """Covariance of the residuals of several pulleys: a wheel that wobbles counts once."""
    count = len(spread)
    correlation: Array = np.eye(count)
    if count > 1:
        quiet = np.all(np.abs(residual) < 4.0 * spread[:, None], axis=0)
        correlation = np.asarray(np.corrcoef(residual[:, quiet]))
    return np.outer(spread, spread) * correlation + 1e-8


def _sum(time: Array, gain: Array, level: float) -> tuple[list[_Span], Flags, Array]:
    """Return the spans in which a sum is above a level, their windows, and all excursions."""
    total, start, top, span = 0.0, 0, 0.0, None
    spans: list[_Span] = []
    low, tops = np.zeros(len(gain), dtype=bool), []
    pauses = np.diff(time, prepend=time[0]) > _PAUSE
    for i, (step, paused) in enumerate(zip(gain.tolist(), pauses.tolist(), strict=True)):
        if paused:
            total = min(total, 0.5 * level)
        if total == 0.0:
            start = i
            if top > 0.0:
                tops.append(top)
            top, span = 0.0, None
        total = max(0.0, min(total + step, 2.0 * level))
        if span is None and total > level:
            span = _Span(start, i, i)
            spans.append(span)
            low[start:i] = True
        if span is not None:
            low[i] = True
            if total >= top:
                span.last = i
        top = max(top, total)
    return spans, low, np.array(tops)


def _level(tops: Array, years: float) -> float:
    """Return the level that noise passes as often as wanted, from the tail of its excursions."""
    ordered = np.sort(tops)[::-1]
    count = min(_TAIL, len(ordered) - 1)
    if count <= 8:
        return _USUAL
    rate = count / float(np.sum(ordered[:count] - ordered[count]))
    level = ordered[count] + np.log(count / (WANTED * years)) / rate
    return float(np.clip(level, _LOWEST, _HIGHEST))


def _episode(windows: Windows, fit: LearnFit, inverse: Array, of: _Span) -> Episode:
    """Return an episode with the change of ln friction that explains its differences best."""
    span = slice(of.first, of.last + 1)
    days, torque = windows.time[span] / DAY, windows.torque[:, span]
    above = windows.difference[:, span] - fit.course("zero", days)
    misses = []
    for change in _CHANGES.tolist():
        left = above - fit.curve(torque, days, windows.play[span], change)
        misses.append(np.minimum(np.einsum("in,ij,jn->n", left, inverse, left), 50.0).sum())
    half = 0.5 * WINDOW * STEP
    return Episode(
        float(windows.time[of.first] - half), float(windows.time[of.last] + half),
        float(windows.time[of.known] + half),
        float(np.expm1(_CHANGES[int(np.argmin(misses))])), float(torque.max()),
    )  # fmt: skip
