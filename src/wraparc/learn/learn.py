"""A drive learned from its logs, step by step: signals, windows, cells, cuts, fit, episodes."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.errors import InputError, Problem
from wraparc.learn.episodes import LEAST_SENSITIVITY, Episodes, find_episodes
from wraparc.learn.file import LearnPlan
from wraparc.learn.fit import LearnFit, fit_cells, kept_days
from wraparc.learn.grid import Grid, on_grid, refuse_computed
from wraparc.learn.levels import friction_draws
from wraparc.learn.lines import (
    AlarmLine,
    Interval,
    UsedUp,
    alarm_line,
    as_factor,
    draws_interval,
    interval_of,
    reserve_of,
    used_up,
)
from wraparc.learn.model import SpeedModel, running_radius, speed_model
from wraparc.learn.tags import Log, read_signals
from wraparc.learn.windows import DAY, Windows, find_cells, find_jumps, find_windows

#: What a log must have for more than its zero: days, steady hours, range of torque [-].
LEAST_DAYS, LEAST_HOURS, LEAST_RANGE = 3.0, 30.0, 0.25
#: Part of the running in which a tag may be missing before it is what a log lacks [-].
_MOSTLY = 0.5
#: What a zero is at most [-], an error is moved by in its standard deviations, a spread over usual.
MOST_ZERO, MOST_MOVED = 0.05, 3.0
USUAL_SIGMA, USUAL_TAU, MOST_SPREAD = 2e-4, 1.5e-4, 5.0

Progress = Callable[[str, float], None]


@dataclass(frozen=True, eq=False, kw_only=True)
class LearnedPulley:
    """What was learned of a pulley.

    Attributes
    ----------
    name
        In the drive file.
    is_estimated
        Whether the converter estimates its speed.
    zero, zero_change
        Of the speed ratio at the end, and its change since the last cut [-].
    zero_course, friction_course
        Value, low and high at `Learned.days` [-], shape (3, n); friction as a factor on the law.
    friction, friction_change
        Factor on its law at the end, and the factor since the last cut; None where it is not told.
    reserve
        Friction at the end over that of gross slip at the highest torque, None where none is told.
    used_up
        When it is used up.
    top_torque
        Highest torque seen over the rated one, 99.9 % [-].
    line
        Levels to alarm by.
    sensitivity
        Change of speed by ln friction at peak torque over the spread of a window [-].
    """

    name: str
    is_estimated: bool
    zero: Interval
    zero_change: Interval
    zero_course: Array
    friction_course: Array | None
    friction: Interval | None
    friction_change: Interval | None
    reserve: Interval | None
    used_up: UsedUp | None
    top_torque: float
    line: AlarmLine
    sensitivity: float


@dataclass(frozen=True, eq=False, kw_only=True)
class Learned:
    """What was learned of a drive.

    Attributes
    ----------
    plan, log, grid, windows, fit, episodes
        What it was learned from, and how.
    days
        Days from the start at which courses are told, shape (n,).
    stop
        Length of the log [days].
    cuts
        Days on which zero and friction jump.
    pulleys
        In belt order.
    moved
        By error, how many standard deviations it was moved by, those beyond `MOST_MOVED`.
    cannot
        What is not told, a sentence each.
    """

    plan: LearnPlan
    log: Log
    grid: Grid
    windows: Windows
    fit: LearnFit
    episodes: Episodes
    days: Array
    stop: float
    cuts: tuple[int, ...]
    pulleys: tuple[LearnedPulley, ...]
    moved: dict[str, float]
    cannot: tuple[str, ...]
    unlike: tuple[str, ...] = field(default=())

    @property
    def since(self) -> float:
        """Start of what changes are counted from: the last cut, else the start [days]."""
        return float(self.cuts[-1]) if self.cuts else 0.0

    @property
    def tells_friction(self) -> bool:
        """Whether friction is told of any pulley."""
        return any(p.friction is not None for p in self.pulleys)


def learn(plan: LearnPlan, progress: Progress | None = None) -> Learned:
    """Return what the logs of a plan say of its drive.

    Raises
    ------
    InputError
        If the logs cannot be read, are no records of what was, or are too short.
    """
    note = progress or (lambda step, share: None)
    note("reading", 0.0)
    log = read_signals(plan)
    note("windows", 0.4)
    grid = on_grid(log, plan.file)
    _refuse_short(plan, grid)
    radii = [running_radius(plan.drive, c.pulley) for c in log.pulleys]
    windows = find_windows(grid, log, radii)
    _refuse_short(plan, grid, windows.hours)
    refuse_computed(windows.difference[0], log.signals["belt_speed"].tag, plan.file)
    note("tables", 0.5)
    top = float(np.quantile(windows.torque, 0.999))
    return learn_windows(
        plan, log, grid, windows, speed_model(plan, log.pulleys, max(top, 1.0)), note
    )


def learn_windows(
    plan: LearnPlan,
    log: Log,
    grid: Grid,
    windows: Windows,
    model: SpeedModel,
    note: Progress = lambda step, share: None,
) -> Learned:
    """Return the same of steady windows, with the model of the drive."""
    errors, estimated = plan.errors, [c.is_estimated for c in log.pulleys]
    stop = float(grid.time[-1]) / DAY + 0.01
    kept: Flags = np.ones(len(windows.time), dtype=bool)
    expected = {"take_up_friction": 0.03}
    cells = find_cells(windows, kept)
    nominal = model.curve(cells.torque, np.zeros_like(cells.torque), expected, cells.play)
    jumps = find_jumps(cells, cells.difference - nominal)
    cuts = _with_events(plan, grid, jumps, stop)
    _refuse_ratio(plan, log, cells.difference - nominal)
    kept = kept_days(windows.day, cuts)
    one_load = _load_range(windows) < LEAST_RANGE
    note("fit", 0.6)
    fit = fit_cells(find_cells(windows, kept), model, errors, estimated, cuts, stop, 5)
    note("episodes", 0.8)
    episodes = find_episodes(windows, fit, cuts)
    if episodes.low.any():
        cells = find_cells(windows, kept & ~episodes.low)
        fit = fit_cells(cells, model, errors, estimated, cuts, stop)
        episodes = find_episodes(windows, fit, cuts)
    else:
        fit = fit_cells(find_cells(windows, kept), model, errors, estimated, cuts, stop)
        episodes = find_episodes(windows, fit, cuts)
    note("results", 0.9)
    moved = {n: m for n, m in fit.moved().items() if abs(m) > MOST_MOVED}
    unlike = tuple(_unlike(fit))
    cannot = []
    if one_load:
        cannot.append("one load: only the zero is known")
        episodes = replace(episodes, found=(), low=np.zeros(len(windows.time), dtype=bool))
    if max(episodes.sensitivity) < LEAST_SENSITIVITY:
        cannot.append("wet episodes: friction hardly shows in the speeds")
    tells = not one_load and not moved and not unlike
    if tells:  # the fit is as good with the law of another: nothing in the speeds shows it
        cannot.append("which lagging is on the pulley")
    days = np.linspace(0.0, stop - 0.01, max(2, min(400, int(stop) + 1)))
    pulleys = tuple(
        _pulley(plan, log, windows, fit, episodes, days, stop, cuts, k, tells)
        for k in range(len(log.pulleys))
    )
    return Learned(
        plan=plan, log=log, grid=grid, windows=windows, fit=fit, episodes=episodes, days=days,
        stop=stop, cuts=tuple(cuts), pulleys=pulleys, moved=moved, cannot=tuple(cannot),
        unlike=unlike,
    )  # fmt: skip


def _pulley(
    plan: LearnPlan,
    log: Log,
    windows: Windows,
    fit: LearnFit,
    episodes: Episodes,
    days: Array,
    stop: float,
    cuts: list[int],
    k: int,
    tells: bool,
) -> LearnedPulley:
    """Return what was learned of one pulley."""
    name = log.pulleys[k].pulley
    since = float(cuts[-1]) if cuts else 0.0
    wheel, shape = plan.errors.sd("wheel"), plan.errors.sd("law_shape")
    ends = np.array([since + 1e-9, stop - 1e-9])

    def change(what: str) -> Array:
        rows = fit.weights(what, name, ends)
        return np.asarray(rows[1:] - rows[:1])

    zero = interval_of(fit, fit.weights("zero", name, ends[1:]))
    shift = interval_of(fit, change("zero"), wheel)
    top = np.quantile(windows.torque, 0.999, axis=1)
    friction = friction_change = reserve = told = course = None
    best = math.nan
    if tells:
        draws = friction_draws(fit, name, stop - 1e-9)
        found = reserve_of(fit, draws, k, top, stop - 1e-9, shape)
        of_days = plan.errors.sd("friction_days")
        end = draws.of(fit.weights("friction", name, ends[1:]))[:, 0]
        friction = as_factor(draws_interval(end, math.hypot(shape, of_days)))
        changed = draws.of(change("friction"))[:, 0]
        friction_change = as_factor(draws_interval(changed, math.sqrt(2.0) * of_days))
        told = used_up(fit, draws, k, found.interval, since, stop)
        reserve = None if found.interval is None else as_factor(found.interval)
        courses = draws.of(fit.weights("friction", name, days))
        course = np.exp(np.quantile(courses, [0.5, 0.025, 0.975], axis=0))
        best = found.best
    line = alarm_line(fit, k, windows, episodes, best, stop)
    return LearnedPulley(
        name=name, is_estimated=log.pulleys[k].is_estimated, zero=zero, zero_change=shift,
        zero_course=_course(fit, "zero", name, days), friction_course=course, friction=friction,
        friction_change=friction_change, reserve=reserve, used_up=told, top_torque=float(top[k]),
        line=line, sensitivity=episodes.sensitivity[k],
    )  # fmt: skip


def _course(fit: LearnFit, what: str, name: str, days: Array) -> Array:
    """Return value, low and high of a course in time, shape (3, n)."""
    rows = fit.weights(what, name, days)
    value, half = rows @ fit.unknowns, 1.959964 * fit.spread(rows)
    return np.array([value, value - half, value + half])


def _with_events(plan: LearnPlan, grid: Grid, jumps: list[int], stop: float) -> list[int]:
    """Return the days on which zero and friction may jump: stated, and found far from these."""
    stated = [int((e.when - grid.start) // DAY) for e in plan.events]
    stated = sorted({d for d in stated if 1 <= d < stop - 1})
    found = [d for d in jumps if all(abs(d - s) > 3 for s in stated)]
    return sorted({*stated, *found})


def _load_range(windows: Windows) -> float:
    """Return the range of torque between the lightest and the heaviest hundredth [-]."""
    low, high = np.quantile(windows.torque.mean(axis=0), [0.01, 0.99])
    return float(high - low)


def _unlike(fit: LearnFit) -> list[str]:
    """Yield pulleys whose speeds differ from every drive of this kind."""
    return [
        name
        for name, sigma, tau in zip(fit.model.names, fit.sigma, fit.tau, strict=True)
        if sigma > MOST_SPREAD * USUAL_SIGMA or tau > MOST_SPREAD * USUAL_TAU
    ]


def _refuse_short(plan: LearnPlan, grid: Grid, hours: float | None = None) -> None:
    """Refuse a log that is too short to say anything: by its days, then by its steady hours."""
    days = float(grid.time[-1]) / DAY
    worst = max(grid.missing, key=lambda tag: grid.missing[tag])
    if days >= LEAST_DAYS and grid.missing[worst] > _MOSTLY:
        raise InputError(
            Problem(
                file=plan.file, key=worst, value=f"{100.0 * grid.missing[worst]:.0f} % of running",
                message="frozen or missing for too long",
                remedy="Log it every minute, with its decimals.",
            )
        )  # fmt: skip
    if days >= LEAST_DAYS and (hours is None or hours >= LEAST_HOURS):
        return
    got = f"{24.0 * days:.2g} h" if hours is None else f"{hours:.2g} h steady"
    needs = f"{LEAST_DAYS:g} days with {LEAST_HOURS:g} h of steady running"
    raise InputError(
        Problem(
            file=plan.file, key="files", value=got, message="log too short",
            remedy=f"Export at least {needs}.",
        )
    )  # fmt: skip


def _refuse_ratio(plan: LearnPlan, log: Log, zero: Array) -> None:
    """Refuse speeds that no wear or dirt explains: a ratio of a gear or a unit."""
    for choice, own in zip(log.pulleys, zero, strict=True):
        middle = float(np.median(own))
        if abs(middle) > MOST_ZERO:
            ratio = (choice.gear_ratio or 1.0) / (1.0 - middle)
            raise InputError(
                Problem(
                    file=plan.file, key=f"pulley.{choice.pulley}.gear_ratio",
                    value=f"{choice.gear_ratio or 1.0:g}",
                    message=f"speeds differ by {100.0 * middle:.3g} %, more than wear or dirt",
                    remedy=f"Check gear ratio ({ratio:.4g} by the speeds), units and diameter.",
                )
            )  # fmt: skip
