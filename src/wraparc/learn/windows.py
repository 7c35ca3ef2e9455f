"""Steady windows of a log, cells of a day and a load, and the days on which the zero jumps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.learn.grid import STEP, Grid
from wraparc.learn.tags import Log

DAY = 86400.0
#: Steps of a window (3 min), its spread of torque [-] and speed [-], width of a cell in torque [-].
WINDOW, _TORQUE, _SPEED, CELL = 18, 0.04, 0.02, 0.07
#: Play of the take-up, in torque [-]; windows of a cell at least.
PLAY, _FEWEST = 0.08, 4
#: What a jump of the zero is at least [-], over the usual change from day to day, and days apart.
_JUMP, _OVER_NOISE, _APART, _MOST_CUTS = 0.002, 6.0, 8, 3


@dataclass(frozen=True, eq=False)
class Windows:
    """Steady windows of k pulleys.

    Attributes
    ----------
    time
        Middle of each, from the start of the log [s], shape (n,).
    torque
        Over rated torque [-], shape (k, n).
    difference
        1 - v/(omega R/i) [-], shape (k, n).
    play
        Where the take-up is in its friction, -1 where the pull rose last, to 1, shape (n,).
    tension
        T2 where it is measured [N], shape (n,); None where it is not.
    """

    time: Array
    torque: Array
    difference: Array
    play: Array
    tension: Array | None = None

    @property
    def day(self) -> Integers:
        """Day of each window, from 0."""
        return np.asarray((self.time // DAY).astype(np.int64))

    @property
    def hours(self) -> float:
        """Steady hours."""
        return len(self.time) * WINDOW * STEP / 3600.0

    def at(self, which: Flags) -> Windows:
        """Return some of the windows."""
        tension = None if self.tension is None else self.tension[which]
        return Windows(
            self.time[which], self.torque[:, which], self.difference[:, which],
            self.play[which], tension,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Cells:
    """Medians of the windows of one day and one load; fields as of `Windows`.

    Attributes
    ----------
    count
        Windows of each.
    day
        Day of each.
    """

    time: Array
    torque: Array
    difference: Array
    play: Array
    count: Integers
    day: Integers


def find_windows(grid: Grid, log: Log, radii: Sequence[float]) -> Windows:
    """Return the steady windows of a log.

    Parameters
    ----------
    grid
        The signals.
    log
        Whose pulleys they are.
    radii
        At which the belt runs unloaded, by pulley [m].
    """
    names = [choice.pulley for choice in log.pulleys]
    count = len(grid.time) // WINDOW

    def cut(values: Array) -> Array:
        return values[: count * WINDOW].reshape(count, WINDOW)

    speeds = [cut(grid.values[f"speed.{name}"]) for name in names]
    torques = [cut(grid.values[f"torque.{name}"]) for name in names]
    belt = cut(grid.values["belt_speed"])
    good = np.all([np.isfinite(x).all(axis=1) for x in (*speeds, *torques, belt)], axis=0)
    means = [np.where(good, x.sum(axis=1) / WINDOW, np.nan) for x in torques]
    for speed in speeds:
        full = np.nanquantile(speed, 0.99)
        good &= np.nan_to_num(speed).min(axis=1) > 0.2 * full
    for torque, mean in zip(torques, means, strict=True):
        step = np.abs(np.diff(mean))
        good &= np.append(step, np.nan) < _TORQUE
        good &= np.insert(step, 0, np.nan) < _TORQUE
        good &= np.std(torque, axis=1) < _TORQUE
    for x in (*speeds, belt):
        top = np.quantile(np.where(np.isfinite(x), x, 0.0), 0.99)
        good &= np.ptp(x, axis=1) < _SPEED * top
    kept = np.flatnonzero(good)
    gears = [choice.gear_ratio or 1.0 for choice in log.pulleys]
    v = belt[kept].mean(axis=1)
    differences = [
        1.0 - v * gear / (radius * speed[kept].mean(axis=1))
        for speed, gear, radius in zip(speeds, gears, radii, strict=True)
    ]
    total = np.mean([grid.values[f"torque.{name}"] for name in names], axis=0)
    play = cut(play_of(total, PLAY))[kept].mean(axis=1)
    tension = None
    if "tension" in grid.values:
        tension = cut(grid.values["tension"])[kept].mean(axis=1)
    time = cut(grid.time)[kept].mean(axis=1)
    return Windows(time, np.array([m[kept] for m in means]), np.array(differences), play, tension)


def play_of(torque: Array, width: float) -> Array:
    """Return where the take-up is in its friction, from -1 where the pull rose last to 1."""
    place, last, found = 0.0, 0.0, np.empty(len(torque))
    for i, value in enumerate((torque / width).tolist()):
        if value == value:
            place = min(max(place, value - 1.0), value + 1.0)
            last = place - value
        found[i] = last
    return found


def find_cells(windows: Windows, kept: Flags) -> Cells:
    """Return the medians by day and load; bins of equal width, so that no load is bent away."""
    pulleys = len(windows.torque)
    total = windows.torque.sum(axis=0)
    low, high = np.quantile(total[kept], [0.002, 0.998])
    kept = kept & (total >= low) & (total <= high)
    bins = max(4, int((high - low) / (pulleys * CELL)))
    edges = np.linspace(low, high, bins + 1)
    load = np.clip(np.searchsorted(edges, total) - 1, 0, bins - 1)
    days = windows.day
    key = days * 1000 + load
    order = np.flatnonzero(kept)[np.argsort(key[kept], kind="stable")]
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    groups = [g for g in np.split(order, starts[1:]) if len(g) >= _FEWEST]
    return Cells(
        time=np.array([windows.time[g].mean() for g in groups]),
        torque=np.array([np.median(windows.torque[:, g], axis=1) for g in groups])
        .reshape(-1, pulleys)
        .T,
        difference=np.array([np.median(windows.difference[:, g], axis=1) for g in groups])
        .reshape(-1, pulleys)
        .T,
        play=np.array([windows.play[g].mean() for g in groups]),
        count=np.array([len(g) for g in groups], dtype=np.int64),
        day=np.array([days[g[0]] for g in groups], dtype=np.int64),
    )


def find_jumps(cells: Cells, zero: Array) -> list[int]:
    """Return the days on which the zero jumps and stays: relagged, or another wheel.

    Parameters
    ----------
    cells
        The cells.
    zero
        Their difference less that of the drive as described [-], shape (k, n).
    """
    days = np.unique(cells.day)
    total = cells.torque.sum(axis=0)
    light = total <= np.quantile(total, 0.4)

    def median(day: int) -> Array:
        own = cells.day == day
        chosen = own & light if (own & light).any() else own
        return np.median(zero[:, chosen], axis=1)

    level = np.array([median(day) for day in days.tolist()]).T
    if len(days) < 8:
        return []
    noise = np.median(np.abs(np.diff(level, axis=1)), axis=1)
    found = []
    for i in range(3, len(days) - 3):
        after = np.median(level[:, i : i + 5], axis=1)
        jump = np.abs(after - np.median(level[:, max(i - 5, 0) : i], axis=1))
        if np.any(jump > np.maximum(_JUMP, _OVER_NOISE * noise)):
            found.append((float(jump.max()), i))
    cuts: list[int] = []
    for _, place in sorted(found, reverse=True):
        day = int(days[_sharpest(level, place)])
        if all(abs(day - other) > _APART for other in cuts) and len(cuts) < _MOST_CUTS:
            cuts.append(day)
    return sorted(cuts)


def _sharpest(level: Array, place: int, reach: int = 4) -> int:
    """Return the day near one that parts its neighbours best, by least absolute deviations."""
    start, stop = max(place - 2 * reach, 0), min(place + 2 * reach, level.shape[1])

    def misfit(at: int) -> float:
        parts = level[:, start:at], level[:, at:stop]
        return sum(float(np.abs(p - np.median(p, axis=1, keepdims=True)).sum()) for p in parts)

    near = range(max(place - reach, start + 2), min(place + reach, stop - 2) + 1)
    return min(near, key=misfit)
