"""Signals on one clock: readings hold until the next, and are left out where they say nothing."""

from __future__ import annotations

import datetime as dt
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.errors import InputError, Problem, shown
from wraparc.learn.tags import Log, Signal

#: Step of the grid [s], and what is frozen: unchanged so long while the drive runs [s].
STEP, FROZEN = 10.0, 1800.0
_GAP, _LEAST_GAP, _RUNNING = 1.2, 60.0, 0.2
#: What is refused: part of a load signal that is straight between readings, steps of the belt
#: speed over it, and a difference of speeds that no wheel has.
_STRAIGHT, _DEAD_BAND, _COMPUTED = 0.3, 0.005, 1e-5
_LINE, _SLOPE = 6, 10.0
#: Longest log [days], and what the highest torque of a drive is over the rated one [-].
MOST_DAYS = 1500.0
_LEAST_TOP, _MOST_TOP = 0.05, 4.0


@dataclass(frozen=True)
class LeftOut:
    """A span of a tag that is left out [s since 1970], and why."""

    tag: str
    start: float
    stop: float
    why: str


@dataclass(frozen=True, eq=False)
class Grid:
    """Signals at equal steps.

    Attributes
    ----------
    start
        Of the first step [s since 1970].
    time
        From the start [s], shape (n,).
    values
        By role, nan where nothing is known, each of shape (n,).
    left_out
        Longest spans that were left out.
    share_left_out
        Part of the running time in which a signal is missing [-].
    missing
        The same of each tag, by its name.
    """

    start: float
    time: Array
    values: Mapping[str, Array]
    left_out: tuple[LeftOut, ...]
    share_left_out: float
    missing: Mapping[str, float]


def moment_of(seconds: float) -> dt.datetime:
    """Return a time of a log [s since 1970], as its clock shows it."""
    return dt.datetime.fromtimestamp(round(seconds), dt.UTC).replace(tzinfo=None)


def on_grid(log: Log, file: str) -> Grid:
    """Return the signals of a log at equal steps.

    Raises
    ------
    InputError
        If a signal is no record of what was: lines between readings, a belt speed that is computed
        from the motor, steps too large.
    """
    problems = [p for s in log.signals.values() for p in _faults(s, file)]
    if problems:
        raise InputError(problems)
    start = max(s.times[0] for s in log.signals.values())
    stop = min(s.times[-1] for s in log.signals.values())
    if stop <= start:
        raise InputError(
            Problem(file=file, message="its tags have no time in common",
                    remedy="Export all tags of the same days.")
        )  # fmt: skip
    if stop - start > 86400.0 * MOST_DAYS:
        raise InputError(
            Problem(file=file, key="files", value=f"{(stop - start) / 86400.0:.0f} days",
                    message="log too long", remedy=f"Export at most {MOST_DAYS:.0f} days.")
        )  # fmt: skip
    time = np.arange(0.0, stop - start + STEP, STEP)
    left_out: list[LeftOut] = []
    values: dict[str, Array] = {}
    for role, signal in log.signals.items():
        values[role] = _hold(signal, start + time, left_out)
    speeds = [values[f"speed.{choice.pulley}"] for choice in log.pulleys]
    full = [np.nanquantile(s, 0.99) for s in speeds]
    running = np.all(
        [np.nan_to_num(s) > _RUNNING * f for s, f in zip(speeds, full, strict=True)], 0
    )
    for role, signal in log.signals.items():
        _leave_frozen(values[role], running, signal, start, left_out)
    known = np.all([np.isfinite(v) for v in values.values()], axis=0)
    moving = _was_running(running, np.isfinite(speeds[0]))
    share = float(np.mean(~known[moving])) if moving.any() else 0.0
    missing = {
        signal.tag: float(np.mean(~np.isfinite(values[role][moving]))) if moving.any() else 0.0
        for role, signal in log.signals.items()
    }
    return Grid(start, time, values, tuple(_longest(left_out)), share, missing)


def _was_running(running: Flags, known: Flags) -> Flags:
    """Steps at which the drive ran; where its speed is missing, as before."""
    last = np.maximum.accumulate(np.where(known, np.arange(len(known)), 0))
    return np.asarray(running[last])


def _hold(signal: Signal, at: Array, left_out: list[LeftOut]) -> Array:
    """Return the last reading at each time, nan where it is stale or the clock was put back."""
    gaps = np.diff(signal.times)
    stale = max(_LEAST_GAP, _GAP * float(np.quantile(gaps, 0.9995)) if len(gaps) else 0.0)
    last = np.clip(np.searchsorted(signal.times, at, side="right") - 1, 0, None)
    fresh = at - signal.times[last] < stale
    left_out.extend(
        LeftOut(signal.tag, signal.times[k] + stale, signal.times[k + 1], "gap")
        for k in np.flatnonzero(gaps >= stale).tolist()
    )
    for first, final in signal.put_back:
        fresh &= (at < first - 60.0) | (at > final + 60.0)
        left_out.append(LeftOut(signal.tag, first, final, "clock put back"))
    return np.where(fresh, signal.values[last], np.nan)


def _leave_frozen(
    values: Array, running: Flags, signal: Signal, start: float, left_out: list[LeftOut]
) -> None:
    """Take out what did not change for long while the drive ran, of a log that repeats values."""
    if np.mean(np.diff(signal.values) == 0.0) < 0.005:
        return  # stored by exception: a value that stays has no readings
    same = np.concatenate([[False], np.diff(values) == 0.0]) & running
    edges = np.flatnonzero(np.diff(np.concatenate([[0], same.astype(np.int8), [0]])))
    for first, final in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if (final - first) * STEP >= FROZEN:
            values[max(first - 1, 0) : final] = np.nan
            span = start + STEP * first, start + STEP * final
            left_out.append(LeftOut(signal.tag, *span, "frozen"))


def _longest(left_out: list[LeftOut], most: int = 200) -> list[LeftOut]:
    by_length = sorted(left_out, key=lambda s: s.start - s.stop)[:most]
    return sorted(by_length, key=lambda s: s.start)


def _faults(signal: Signal, file: str) -> list[Problem]:
    """Return why a signal is no record of what was."""
    values = signal.values[np.isfinite(signal.values)]
    if len(values) < 2:
        return [Problem(file=file, key=signal.tag, message="has no readings",
                        remedy="Export it with its values.")]  # fmt: skip
    usual = float(np.median(np.abs(values[values != 0.0]))) if values.any() else 0.0
    if np.ptp(values) <= 1e-9 * usual:
        return [Problem(file=file, key=signal.tag, message="never changes",
                        remedy="Export what is measured, with its decimals.")]  # fmt: skip
    if float(np.median(values[np.abs(values) > _RUNNING * usual])) < 0.0:
        return [Problem(file=file, key=signal.tag, message="is negative while the drive runs",
                        remedy="Export it positive for the driving direction.")]  # fmt: skip
    top = float(np.quantile(values, 0.99))
    if signal.role.startswith("torque") and not _LEAST_TOP <= top <= _MOST_TOP:
        return [Problem(file=file, key=signal.tag, value=f"{100.0 * top:.2g} % of rated torque",
                        message="its highest readings are those of no drive",
                        remedy="Check its unit and rated_torque.")]  # fmt: skip
    if signal.role.startswith("torque") and _straight_share(values) > _STRAIGHT:
        return [Problem(file=file, key=signal.tag, message="has straight lines between readings",
                        remedy="Export stored values, without interpolation.")]  # fmt: skip
    if signal.role == "belt_speed":
        steps = np.abs(np.diff(values))
        steps = steps[(steps > 0.0) & (values[1:] > 0.5 * top)]
        size = float(np.quantile(steps, 0.05)) / top if len(steps) else 0.0
        if size > _DEAD_BAND:
            return [Problem(file=file, key=signal.tag, value=f"{100.0 * size:.2g} %",
                            message="is stored in steps above 0.5 % of speed",
                            remedy="Lower its dead band, or log more decimals.")]  # fmt: skip
    return []


def _straight_share(values: Array) -> float:
    """Return the part of the readings that lie on straight lines which no load follows [-]."""
    steps = np.diff(values)
    sizes = np.abs(steps[steps != 0.0])
    if len(sizes) < 10 * _LINE:
        return 0.0
    finest = max(float(np.quantile(sizes, 0.001)), 1e-12)
    straight = (np.abs(np.diff(steps)) <= 1.5 * finest) & (steps[1:] != 0.0)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], straight.astype(np.int8), [0]])))
    count = 0
    for first, final in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        rise = abs(values[final + 1] - values[first])
        if final - first >= _LINE and rise > _SLOPE * finest:
            count += final - first
    return count / len(values)


def refuse_computed(differences: Array, tag: str, file: str) -> None:
    """Refuse a belt speed that is computed from the motor speed.

    Parameters
    ----------
    differences
        1 - v/(omega R/i) of steady windows [-].
    """
    if len(differences) > 20 and float(np.ptp(np.quantile(differences, [0.02, 0.98]))) < _COMPUTED:
        raise InputError(
            Problem(file=file, key="belt_speed", value=shown(tag),
                    message="is computed from the motor speed",
                    remedy="Log the wheel or tachometer of the belt.")
        )  # fmt: skip
