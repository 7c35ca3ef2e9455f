"""Shares over two quantities at once: a hundred by a hundred answers from tables of the pulleys."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem
from wraparc.train.member import Member
from wraparc.train.passage_table import LARGEST_RATIO, RATIO_SCALE, PassageTable
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.solve import Setup
from wraparc.train.system import System
from wraparc.train.train import Train
from wraparc.train.walk import Axis, check_axis, held, place, varied

_LEVELS = 48  # to look for the solution at, before it is closed in on
_CLOSING = 14
_MISS = 1e-9
_NARROW = 1.02  # ratio of diameters between which two tables are enough
#: Ends of the tabulated tensions, over the least and the largest at the ends of the train.
_SLACKEST, _TIGHTEST = 0.6, 1.5


@dataclass(frozen=True, eq=False)
class ShareMap:
    """Shares of a train over two quantities, the set speeds held.

    Attributes
    ----------
    train, case
        The train with its speeds held, and the load case, solved.
    drive
        Whose trim or diameter is varied, by index.
    across, down
        The axes.
    x, y
        Values along them, (nx,) and (ny,) [-].
    shares
        Of every drive, (ny, nx, drives) [-]; nan where there is no solution with entry creep ratios
        up to 5 % and tensions from 0.6 times the least to 1.5 times the largest at the ends.
    creeps
        At the exits, (ny, nx, drives) [m].
    """

    train: Train
    case: CaseResult
    drive: int
    across: Axis
    down: Axis
    x: Array
    y: Array
    shares: Array
    creeps: Array


def share_map(
    result: TrainResult,
    case: str = "",
    *,
    drive: int = 1,
    x: Array,
    y: Array,
    across: Axis = Axis.TRIM,
    down: Axis = Axis.LOAD,
) -> ShareMap:
    """Return the shares of a solved train over two quantities, the speeds of the drums held.

    Parameters
    ----------
    result, case
        The solved train, and the load case to start from (the first one without a name).
    drive
        Whose trim or diameter is varied, by index.
    x, y
        Values on the axes, see `ShareCurve.values` [-].
    across, down
        What is varied.

    Raises
    ------
    InputError
        If a law holds the belt without slip (its answers are no smooth function of the speeds), the
        drives follow motors, or the axes have no meaning for the drive.

    Notes
    -----
    Each pulley is tabulated once; the solutions are found in the tables. Where friction falls
    with slip, the solution with the least creep is taken.
    """
    train, solved = held(result, case)
    for axis in (across, down):
        check_axis(solved, axis, drive)
    setup = Setup.of(train, train.cases[0])
    _check(setup.system, train, across, down)
    origin = [place(train, solved, axis, drive) for axis in (across, down)]
    grid = _Grid(setup.system, train, drive, (across, down), origin)
    x, y = np.asarray(x, float), np.asarray(y, float)
    shares, creeps = grid.solve(x, y)
    return ShareMap(train, solved, drive, across, down, x, y, shares, creeps)


def _check(system: System, train: Train, across: Axis, down: Axis) -> None:
    problems = []
    for pulley, member in zip(train.pulleys, system.members, strict=True):
        if member.holds:
            message = f"no map for the law of lagging {pulley.lagging.name}, which sticks"
            remedy = "Use curves against one quantity."
            problems.append(Problem(key=f"pulley.{pulley.name}", message=message, remedy=remedy))
    if any(line.follows or line.motor is not None for line in system.lines):
        message = "no map for motors with slip or droop"
        remedy = "Use curves against one quantity."
        problems.append(Problem(key="train.motor", message=message, remedy=remedy))
    if across is down:
        message = f"both axes are {across}"
        problems.append(Problem(key="axis", message=message, remedy="Choose two."))
    if problems:
        raise InputError(problems)


class _Grid:
    """Answers for all pairs of values on two axes."""

    def __init__(
        self,
        base: System,
        train: Train,
        drive: int,
        axes: tuple[Axis, Axis],
        origin: Sequence[float],
    ) -> None:
        self._base, self._train, self._drive = base, train, drive
        self._axes, self._origin = axes, origin

    def solve(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Shares and exit creeps, (ny, nx, drives)."""
        across, down = np.meshgrid(x / self._origin[0], y / self._origin[1])
        base = self._base
        load = self._factor(Axis.LOAD, across, down)
        size = self._factor(Axis.DIAMETER, across, down)
        trim = self._factor(Axis.TRIM, across, down)
        entry = base.exit - sum(base.runs) + load * base.pull
        speeds = [np.full(across.shape, line.speed) for line in base.lines]
        speeds[self._drive] = speeds[self._drive] + np.log(trim * size)
        ends = (_SLACKEST * min(base.exit, entry.min()), _TIGHTEST * max(base.exit, entry.max()))
        chain = _Chain(base, self._pulleys(entry, size, ends), speeds, entry, ends)
        entries, exits, ratios = chain.solve()
        shares = np.stack([a - b for a, b in zip(entries, exits, strict=True)], axis=-1)
        shares /= (load * base.pull)[..., None]
        creeps = np.stack(
            [p.creep(a, g) for p, a, g in zip(chain.pulleys, entries, ratios, strict=True)], axis=-1
        )
        good = np.all([np.abs(g) < LARGEST_RATIO for g in ratios], axis=0)
        good &= np.all([(ends[0] < a) & (a < ends[1]) for a in entries], axis=0)
        shares[~good], creeps[~good] = np.nan, np.nan
        return shares, creeps

    def _factor(self, axis: Axis, across: Array, down: Array) -> Array:
        """Change of a quantity over the grid; 1 where it is on no axis."""
        if axis is self._axes[0]:
            return across
        return down if axis is self._axes[1] else np.ones_like(across)

    def _pulleys(self, entry: Array, size: Array, other: tuple[float, float]) -> list[_Pulley]:
        """Tables of all pulleys; equal ones share theirs."""
        base = self._base
        spread = 1.0 + 1e-3  # of a table that one tension would do for
        first = (float(entry.min()) / spread, float(entry.max()) * spread)
        made: dict[tuple[Member, tuple[float, float]], PassageTable] = {}

        def table(member: Member, ends: tuple[float, float]) -> PassageTable:
            if (member, ends) not in made:
                made[member, ends] = PassageTable.of(member, *ends)
            return made[member, ends]

        pulleys = []
        for i, member in enumerate(base.members):
            ends = first if i == 0 else other
            sizes = [1.0]
            if i == self._drive and Axis.DIAMETER in self._axes:
                nodes_of_size = 2 if size.max() < _NARROW * size.min() else 3
                sizes = list(np.linspace(size.min(), size.max(), nodes_of_size))
            nodes = [
                varied(base, self._train, Axis.DIAMETER, i, s).members[i] if s != 1.0 else member
                for s in sizes
            ]
            scale = size if i == self._drive else np.ones_like(size)
            pulleys.append(_Pulley(member, sizes, [table(m, ends) for m in nodes], scale))
        return pulleys


class _Pulley:
    """A pulley over the whole grid, where its size may differ from place to place."""

    def __init__(
        self, member: Member, sizes: Sequence[float], tables: Sequence[PassageTable], size: Array
    ) -> None:
        self._member, self._tables, self._size = member, tables, size
        self._weights = [
            np.prod([(size - t) / (s - t) for t in sizes if t != s], axis=0) for s in sizes
        ]

    def stretch_log(self, entry: Array) -> Array:
        """ln(1 + T1/EA) - ln(1 - delta/R)."""
        member = self._member
        squeeze = member.squeeze / (member.radius * self._size**2)
        return np.asarray(np.log1p(entry * member.stretch) - np.log1p(-squeeze * entry))

    def exit(self, entry: Array, ratio: Array) -> Array:
        """Exit tension [N]."""
        logs = np.log(entry)
        parts = (t.exit_log(logs, ratio) for t in self._tables)
        return np.asarray(np.exp(sum(w * p for w, p in zip(self._weights, parts, strict=True))))

    def creep(self, entry: Array, ratio: Array) -> Array:
        """Exit creep [m]."""
        logs = np.log(entry)
        parts = (t.creep(logs, ratio) for t in self._tables)
        return np.asarray(sum(w * p for w, p in zip(self._weights, parts, strict=True)))


class _Chain:
    """The belt followed over all pulleys, for every place of the grid at once."""

    def __init__(
        self,
        base: System,
        pulleys: Sequence[_Pulley],
        speeds: Sequence[Array],
        entry: Array,
        ends: tuple[float, float],
    ) -> None:
        self.pulleys = pulleys
        self._base, self._speeds, self._entry = base, speeds, entry
        self._ends = ends
        middle = 0.5 * (entry + base.exit)
        levels = [p.stretch_log(middle) - s for p, s in zip(pulleys, speeds, strict=True)]
        self._center = np.asarray(sum(levels) / len(levels))

    def follow(self, w: Array) -> tuple[list[Array], list[Array], list[Array]]:
        """Entry tensions, exit tensions and entry creep ratios at the levels of w."""
        level = self._center + RATIO_SCALE * np.sinh(w)
        entry, entries, exits, ratios = self._entry, [], [], []
        for pulley, speed, run in zip(self.pulleys, self._speeds, self._base.runs, strict=True):
            ratio = -np.expm1(pulley.stretch_log(entry) - speed - level)
            out = pulley.exit(entry, ratio)
            entries.append(entry)
            exits.append(out)
            ratios.append(ratio)
            entry = np.clip(out + run, *self._ends)
        return entries, exits, ratios

    def miss(self, w: Array) -> Array:
        """ln(given over reached last tension)."""
        return np.asarray(np.log(self._base.exit / self.follow(w)[1][-1]))

    def solve(self) -> tuple[list[Array], list[Array], list[Array]]:
        """Close in on the solution with the least creep, everywhere."""
        end = float(np.arcsinh(LARGEST_RATIO / RATIO_SCALE))
        shape = self._entry.shape
        low, high = np.full(shape, np.nan), np.full(shape, np.nan)
        f_low, f_high = low.copy(), high.copy()
        last_w, last = np.full(shape, -end), self.miss(np.full(shape, -end))
        for node in np.linspace(-end, end, _LEVELS)[1:]:
            w = np.full(shape, node)
            f = self.miss(w)
            nearer = ~(np.minimum(np.abs(low), np.abs(high)) <= abs(node))
            found = (last < 0.0) & (f >= 0.0) & nearer
            low[found], high[found] = last_w[found], node
            f_low[found], f_high[found] = last[found], f[found]
            last_w, last = w, f
        for i in range(_CLOSING):
            w = (low * f_high - high * f_low) / (f_high - f_low)
            f = self.miss(w)
            if not np.any(np.abs(f) > _MISS):
                break
            below = f < 0.0
            low, f_low = np.where(below, w, low), np.where(below, f, f_low)
            high, f_high = np.where(below, high, w), np.where(below, f_high, f)
            if i % 2:  # Illinois: do not let one end stand still
                f_low, f_high = (
                    np.where(below, f_low, 0.5 * f_low),
                    np.where(below, 0.5 * f_high, f_high),
                )
        return self.follow(w)
