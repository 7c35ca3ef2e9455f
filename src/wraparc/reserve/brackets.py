"""Steps of an input within which the level of the verdict changes.

A side of an input is looked at at few points, the nearer the closer together (`GRID`). Between two
of them a level may come and go again: where one check that decides is missed before and another
behind, and where a margin turns near 0, as a parabola through three points has it. There the step
is divided until nothing can be hidden in it, or until it is as short as a change is exact. The
nearest step with a change is divided in `divide.py`.
"""

from __future__ import annotations

from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import Setting
from wraparc.checks.check import Level
from wraparc.checks.of_arc import GROSS_SLIP
from wraparc.reserve.levels import FACTORS, FAR, IMPOSSIBLE, JUDGED, RULES, LevelRows, Levels

#: Places of the points of a side: of `_STEPS` equal steps from the input as it is to its end.
GRID, _STEPS = (0, 1, 2, 4, 7, 11, 16, 22, 27, 33), 33
#: Those of them at which the safety against gross slip is found first.
_SLIDING = [0, 5, 9]
#: Equal parts that a step is divided into where something may be hidden in it.
_PARTS = 6
#: Width of the step that a change is found in: of the input, and of the change [-].
WIDTH, OF_CHANGE = 1e-3, 5e-3
#: How much farther than a parabola a margin may go beyond its nearest point [-].
_BEYOND = 0.5
#: By how much of a step lines are off the place where a margin is 0 [-].
_SWAPPED = 0.15

_Number = TypeVar("_Number", np.int64, np.float64)


class Brackets(NamedTuple):
    """Steps within which a level changes, columns of shape (n,).

    Attributes
    ----------
    which
        Place of the input.
    near, far
        Factors: the last with the level as it is, and the first with another [-].
    beside, beyond
        Two factors outside of them [-].
    at_near, at_far, at_beside, at_beyond
        The levels there.
    """

    which: Integers
    near: Array
    far: Array
    beside: Array
    beyond: Array
    at_near: Levels
    at_far: Levels
    at_beside: Levels
    at_beyond: Levels

    def rows(self, which: Integers) -> Brackets:
        """Return some of them."""
        return Brackets(
            self.which[which],
            self.near[which],
            self.far[which],
            self.beside[which],
            self.beyond[which],
            self.at_near.rows(which),
            self.at_far.rows(which),
            self.at_beside.rows(which),
            self.at_beyond.rows(which),
        )

    def put(self, which: Integers, steps: Brackets) -> None:
        """Take others in the place of some."""
        factors = "which", "near", "far", "beside", "beyond"
        for name in factors:
            getattr(self, name)[which] = getattr(steps, name)
        for name in ("at_near", "at_far", "at_beside", "at_beyond"):
            getattr(self, name).put(which, getattr(steps, name))

    @property
    def width(self) -> Array:
        """How far apart both factors are, shape (n,) [-]."""
        return np.abs(self.far - self.near)


class Strips(NamedTuple):
    """Points of inputs in rows, from the nearest on.

    Attributes
    ----------
    which
        Place of the input, shape (n,).
    factors
        Factors on it, shape (n, points) [-].
    levels
        The levels, the points of a strip one after the other.
    """

    which: Integers
    factors: Array
    levels: Levels

    def grid(self, column: NDArray[_Number]) -> NDArray[_Number]:
        """Return a column of levels with the points of each strip in its last axis."""
        return column.reshape(*column.shape[:-1], *self.factors.shape)

    def brackets(self, of: Integers, step: Integers) -> Brackets:
        """Return the steps of some strips, by their places."""
        points = self.factors.shape[1]
        near = of * points + step
        beside = near + np.where(step > 0, -1, 2)
        beyond = near + np.where(step == 0, 3, np.where(step < points - 2, 2, -2))
        factors = self.factors.ravel()
        return Brackets(
            self.which[of],
            factors[near],
            factors[near + 1],
            factors[beside],
            factors[beyond],
            self.levels.rows(near),
            self.levels.rows(near + 1),
            self.levels.rows(beside),
            self.levels.rows(beyond),
        )


def first_brackets(levels: LevelRows, now: int) -> Brackets | None:
    """Return the nearest step of each input and side with a change, where there is one.

    None where rows find another level of the drive as it is than `now`.
    """
    for setting in Setting:
        strips = _solve_grid(levels, setting)
        if strips.levels.rank[0] == now:
            break
    else:
        return None
    found: dict[int, Brackets] = {}
    owners = np.arange(len(strips.which))
    while True:
        changes, hidden = _look(strips, now, levels)
        _take(found, owners, changes, strips)
        of, step = np.nonzero(hidden)
        steps = strips.brackets(of, step)
        owners = owners[of]
        live = [i for i, at in enumerate(owners.tolist()) if _is_open(found.get(at), steps, i)]
        if not live:
            return _joined([found[at] for at in sorted(found)], strips)
        owners, steps = owners[live], steps.rows(np.array(live, dtype=np.int64))
        strips = _solve(levels, steps.which, _parts(steps), setting)


def _solve_grid(levels: LevelRows, setting: Setting) -> Strips:
    """Solve the points of all sides, the drive as it is once.

    The safety against gross slip, which is the longest to find, at three points of a side; at the
    others only if by a parabola through them it does not pass by far everywhere.
    """
    n, points = len(levels.inputs), len(GRID)
    ends = np.repeat(FACTORS, n)
    factors = 1.0 + (ends[:, None] - 1.0) * np.array(GRID) / _STEPS
    rows = np.arange(factors.size).reshape(factors.shape)
    rows[:, 0] = 0
    which = np.repeat(np.tile(np.arange(n), 2), points)
    some, back = np.unique(rows, return_inverse=True)
    three = np.isin(np.arange(points), _SLIDING)
    sliding = np.broadcast_to(three, factors.shape).ravel()[some]
    found, slide = levels.slide_later(which[some], factors.ravel()[some], setting, sliding)
    strips = Strips(which[::points], factors, found.rows(back.ravel()))
    unclear = np.repeat(_fill_sliding(strips), points) & ~np.tile(three, 2 * n)
    rest = np.flatnonzero(unclear)
    if len(rest):
        place, again = RULES[GROSS_SLIP.name], slide(back.ravel()[rest])
        strips.levels.ranks[place][:, rest], strips.levels.margins[place][:, rest] = again
    every = Levels.of(*strips.levels[1:], strips.levels.rank > IMPOSSIBLE)
    return strips._replace(levels=levels.known(every, which, factors.ravel()))


def _fill_sliding(strips: Strips) -> Flags:
    """Fill in the safety against gross slip between three points, and return where it is unclear.

    One flag a strip, shape (n,).
    """
    place = RULES[GROSS_SLIP.name]
    ranks = strips.grid(strips.levels.ranks)[place]
    margins = strips.grid(strips.levels.margins)[place]
    there, x = margins[..., _SLIDING], strips.factors[:, _SLIDING]
    passes = (ranks <= Level.OK.rank).all(axis=-1)
    none, finite = np.isposinf(there).all(axis=-1), np.isfinite(there).all(axis=-1)
    parabola = np.full(margins.shape, np.inf)
    for k in range(3) if finite.any() else ():
        i, j = (other for other in range(3) if other != k)
        ends = x[:, [i]], x[:, [j]]
        weight = (strips.factors - ends[0]) * (strips.factors - ends[1])
        weight = weight / ((x[:, [k]] - ends[0]) * (x[:, [k]] - ends[1]))
        with np.errstate(invalid="ignore"):
            part = np.where(finite, there[..., k], 0.0)[..., None] * weight
        parabola = part if k == 0 else parabola + part
    clear = passes & (none | (finite & (parabola > FAR).all(axis=-1)))
    filled = np.where(finite[..., None], parabola, np.inf)
    between = np.setdiff1d(np.arange(margins.shape[-1]), _SLIDING)
    margins[..., between] = filled[..., between]
    ranks[..., between] = ranks[..., _SLIDING].max(axis=-1)[..., None]
    return np.asarray(~clear.all(axis=0))


def _is_open(found: Brackets | None, steps: Brackets, i: int) -> bool:
    """Return whether a step may hide a nearer change than the one that is found."""
    nearer = found is None or abs(steps.near[i] - 1.0) < abs(found.far[0] - 1.0)
    return nearer and bool(steps.width[i] > WIDTH)


def _solve(levels: LevelRows, which: Integers, factors: Array, setting: Setting) -> Strips:
    rows = np.repeat(which, factors.shape[1])
    found = levels(rows, factors.ravel(), setting)
    return Strips(which, factors, levels.known(found, rows, factors.ravel()))


def _parts(steps: Brackets) -> Array:
    part = np.linspace(0.0, 1.0, _PARTS + 1)
    return np.asarray(steps.near[:, None] + (steps.far - steps.near)[:, None] * part)


def _take(found: dict[int, Brackets], owners: Integers, changes: Integers, strips: Strips) -> None:
    """Keep the first change of each strip, where it is the nearest of its side."""
    for i in np.flatnonzero(changes < strips.factors.shape[1] - 1).tolist():
        new = strips.brackets(np.array([i]), changes[[i]])
        old = found.get(int(owners[i]))
        if old is None or abs(new.far[0] - 1.0) < abs(old.far[0] - 1.0):
            found[int(owners[i])] = new


def _joined(every: list[Brackets], strips: Strips) -> Brackets:
    """Return brackets as columns."""
    if not every:
        return strips.brackets(np.zeros(0, np.int64), np.zeros(0, np.int64))

    return Brackets(
        np.concatenate([b.which for b in every]),
        np.concatenate([b.near for b in every]),
        np.concatenate([b.far for b in every]),
        np.concatenate([b.beside for b in every]),
        np.concatenate([b.beyond for b in every]),
        Levels.joined([b.at_near for b in every]),
        Levels.joined([b.at_far for b in every]),
        Levels.joined([b.at_beside for b in every]),
        Levels.joined([b.at_beyond for b in every]),
    )


def _look(strips: Strips, now: int, levels: LevelRows) -> tuple[Integers, Flags]:
    """Return the step with the first change of each strip, and the steps that may hide one.

    Without a change it is the number of steps. Behind what is no drive nothing is looked for.
    """
    rank, steps = strips.grid(strips.levels.rank), strips.factors.shape[1] - 1
    ends = rank == IMPOSSIBLE
    changed = ((rank != now) & (rank > 0)) | ends
    first = np.where(changed.any(axis=1), changed.argmax(axis=1) - 1, steps)
    before = np.arange(steps) <= first[:, None]
    hidden = (_swaps(strips, now) | _turns(strips, now, levels)) & before
    lost = np.take_along_axis(ends, np.minimum(first + 1, steps)[:, None], axis=1)[:, 0]
    return np.where(lost, steps, first), hidden


def _swaps(strips: Strips, now: int) -> Flags:
    """Return the steps at whose ends different checks decide: all may pass between them.

    Not where, by their margins, one is missed well before the other passes.
    """
    ranks, others = strips.grid(strips.levels.ranks), strips.grid(strips.levels.others)
    lowest = np.minimum(ranks[..., :-1], ranks[..., 1:]).max(axis=(0, 1))
    lowest = np.maximum(lowest, np.minimum(others[:, :-1], others[:, 1:]))
    rank = strips.grid(strips.levels.rank)
    ends = np.minimum(rank[:, :-1], rank[:, 1:])
    lowest = np.maximum(lowest, Level.OK.rank)
    margins = strips.grid(strips.levels.margins)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = margins[..., :-1] / (margins[..., :-1] - margins[..., 1:])
    share = np.where((share > 0.0) & (share < 1.0), share, np.nan)
    passes = np.where(ranks[..., :-1] > lowest, np.nan_to_num(share, nan=0.0), 0.0)
    misses = np.where(ranks[..., 1:] > lowest, np.nan_to_num(share, nan=1.0), 1.0)
    open_ = passes.max(axis=(0, 1)) < misses.min(axis=(0, 1)) + _SWAPPED
    return np.asarray((lowest < ends) & (rank[:, :-1] == now) & open_)


def _turns(strips: Strips, now: int, levels: LevelRows) -> Flags:
    """Return the steps beside which a margin turns so near to 0 that it may have another sign."""
    ranks, margins = strips.grid(strips.levels.ranks), strips.grid(strips.levels.margins)
    found = np.zeros((len(strips.which), strips.factors.shape[1] - 1), dtype=bool)
    for check, rule in enumerate(JUDGED):
        finite = np.isfinite(margins[check])
        if not finite.any():
            continue
        passes = ranks[check] <= Level.OK.rank
        fails = Level.FAILS.rank if levels.is_firm(rule) else rule.missed.rank
        holds = ranks[check] == now
        turns = nears_zero(strips.factors, margins[check]) & finite[..., 1:-1]
        same = (passes[..., :-2] == passes[..., 1:-1]) & (passes[..., 1:-1] == passes[..., 2:])
        able = np.where(passes[..., 1:-1], fails > now, holds[..., 1:-1])
        beside = (turns & same & able).any(axis=0)
        found[:, :-1] |= beside
        found[:, 1:] |= beside
    return found


def nears_zero(factors: Array, margins: Array) -> Flags:
    """Return the points at which the parabola through three turns beside 0, or beyond it."""
    x, y = factors - 1.0, np.where(np.isfinite(margins), margins, 0.0)
    a, b, c = x[:, :-2], x[:, 1:-1], x[:, 2:]
    p, q, r = y[..., :-2], y[..., 1:-1], y[..., 2:]
    first, second = (q - p) / (b - a), (r - q) / (c - b)
    bend = (second - first) / (c - a)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = 0.5 * (a + b) - 0.5 * first / bend
        top = p + (at - a) * (first + bend * (at - b))
        within = (at - a) * (at - c) < 0.0
        farther = top + _BEYOND * (top - q)
        return np.asarray(within & (farther * q <= 0.0) & (np.abs(bend) > 0.0))
