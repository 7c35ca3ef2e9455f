"""The smallest change of each input at which the level of the whole verdict changes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from weakref import WeakKeyDictionary

import numpy as np

from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Integers
from wraparc.checks.check import Level
from wraparc.checks.judge import judge
from wraparc.checks.of_train import OF_MOTORS
from wraparc.errors import InputError
from wraparc.friction import Constant, PressurePower
from wraparc.reserve.brackets import Brackets, first_brackets
from wraparc.reserve.confirm import confirm
from wraparc.reserve.divide import divide
from wraparc.reserve.inputs import PULL, Input, inputs_of
from wraparc.reserve.levels import LevelRows, level_rows
from wraparc.reserve.uncertainty import Uncertainty, uncertainty_of
from wraparc.train import Motors, Speeds, TrainResult
from wraparc.train.whole import Whole, by_pulley

#: What of one pulley alone counts as farther than all together [-].
_TOGETHER = 1.01
#: How many changes a line has of a verdict that is OK, and to either side of another.
_OF_OK, _OF_OTHERS = 3, 2
_LEVELS = {level.rank: level for level in Level}


@dataclass(frozen=True)
class Flip:
    """A change of an input at which the level changes.

    Attributes
    ----------
    input
        What is changed.
    change
        The smallest change with which the level is another, of the input as it is [-].
    level
        The level there.
    load_case
        Name of the load case that decides there.
    uncertainty
        How far the input may be off.
    """

    input: Input
    change: float
    level: Level
    load_case: str
    uncertainty: Uncertainty

    @property
    def units(self) -> float:
        """The size of the change in units of the uncertainty [-]."""
        return self.uncertainty.units(self.change)

    @property
    def is_within(self) -> bool:
        """Whether the input may be off by as much."""
        return self.uncertainty.has(self.change)


@dataclass(frozen=True, eq=False)
class Reserve:
    """How far the inputs of a verdict may be off until its level is another.

    Attributes
    ----------
    level
        Of the verdict.
    inputs
        What was changed, one at a time.
    flips
        The nearest change of each input to either side, where there is one within `FACTORS`; those
        first that are nearest in units of their uncertainty.
    reason
        Why nothing is known; empty where it is.
    fixed
        What does not change with the inputs, though it would; empty where all is counted.
    """

    level: Level
    inputs: tuple[Input, ...] = ()
    flips: tuple[Flip, ...] = ()
    reason: str = ""
    fixed: str = ""


_reserves: WeakKeyDictionary[Whole, dict[bool, Reserve]] = WeakKeyDictionary()


def stated_count(level: Level) -> int:
    """Return how many changes a line has to a better and to a worse level."""
    return _OF_OK if level is Level.OK else _OF_OTHERS


def find_reserve(result: Whole, *, every: bool = True) -> Reserve:
    """Return the smallest changes that change the level of the verdict on a drive or train.

    Each input alone is changed by a factor within `FACTORS`, and the nearest step in which the
    level changes is divided until it is right to 0.1 % of the input, see `brackets.py`. Pulleys
    keep their shares of the load. The same result is asked once.

    Parameters
    ----------
    result
        The solved drive or train.
    every
        Whether the change of every input is wanted, and not of those alone that are nearest in
        units of their uncertainty (`stated_count`). The latter are confirmed by the solver of one
        arc. A change of all pulleys stands for that of one of them.
    """
    known = _reserves.setdefault(result, {})
    if every not in known:
        known[every] = _find(result, every=every)
    return known[every]


def _find(result: Whole, *, every: bool) -> Reserve:
    verdict = judge(result)
    reason = find_reason(result)
    if reason:
        return Reserve(verdict.level, reason=reason)
    levels, now = level_rows(result, changed_inputs(result)), verdict.level.rank
    try:
        brackets = first_brackets(levels, now)
    except InputError:
        return Reserve(verdict.level, reason="drive without rows")
    if brackets is None:
        return Reserve(verdict.level, reason="verdict within rounding of a limit")
    count = stated_count(verdict.level)
    if not every:
        brackets = brackets.rows(_nearest(levels, brackets, now, count))
    brackets = divide(levels, brackets, now)
    flips = _flips(levels, brackets)
    stated = {id(flip) for flip in nearest_flips(flips, verdict.level, count)}
    asked = np.array([id(flip) in stated for flip in flips], dtype=bool)
    flips = _flips(levels, confirm(levels, brackets, np.flatnonzero(asked), now))
    flips.sort(key=lambda flip: flip.units)
    chosen = tuple(flips) if every else nearest_flips(flips, verdict.level, count)
    return Reserve(verdict.level, levels.inputs, chosen, fixed=_fixed(result))


def _flips(levels: LevelRows, brackets: Brackets) -> list[Flip]:
    """Return the changes that brackets end in."""
    return [
        Flip(
            levels.inputs[brackets.which[i]],
            float(brackets.far[i] - 1.0),
            _LEVELS[int(brackets.at_far.rank[i])],
            levels.places[int(brackets.at_far.ranks[..., i].max(axis=0).argmax())][1],
            uncertainty_of(levels.drive, levels.inputs[brackets.which[i]]),
        )
        for i in range(len(brackets.which))
    ]


def _nearest(levels: LevelRows, brackets: Brackets, now: int, count: int) -> Integers:
    """Return the brackets that the nearest changes to a better and to a worse level may be in."""
    inputs = [levels.inputs[place] for place in brackets.which.tolist()]
    sides = np.sign(brackets.far - 1.0).tolist()
    units = [
        uncertainty_of(levels.drive, of).units(side) for of, side in zip(inputs, sides, strict=True)
    ]
    off = 1.0 / np.array(units)
    least, most = np.abs(brackets.near - 1.0) / off, np.abs(brackets.far - 1.0) / off
    chosen = np.zeros(len(inputs), dtype=bool)
    for side in (brackets.at_far.rank < now, brackets.at_far.rank > now):
        by_name: dict[str, float] = {}
        for i in np.flatnonzero(side).tolist():
            name = inputs[i].name
            by_name[name] = min(by_name.get(name, inf), float(most[i]))
        bounds = sorted(by_name.values())
        if bounds:
            chosen |= side & (least <= _TOGETHER * bounds[min(count, len(bounds)) - 1])
    return np.flatnonzero(chosen)


def nearest_flips(flips: Sequence[Flip], now: Level, count: int) -> tuple[Flip, ...]:
    """Return the nearest changes to a better and to a worse level, each input once on either side.

    A change of all pulleys together stands for that of one that is no nearer.
    """
    found: list[Flip] = []
    ordered = sorted(flips, key=lambda f: f.units * (_TOGETHER if f.input.label else 1.0))
    for better in (True, False):
        side = [f for f in ordered if (f.level.rank < now.rank) is better]
        names = dict.fromkeys(f.input.name for f in side)
        firsts = [next(f for f in side if f.input.name == name) for name in names]
        found += firsts[:count]
    return tuple(found)


def find_reason(result: Whole) -> str:
    """Return why no reserve is sought; empty where one is.

    Rows know no strips of an uneven pulley; those of a friction that is there without slip or shear
    are solved one by one.
    """
    if judge(result).level is Level.FAULT:
        return "no solution"
    if any(pulley.across is not None for pulley in by_pulley(result).drive.pulleys):
        return "pulley uneven across its width"
    if isinstance(result, TrainResult) and not all(case.status.solved for case in result):
        return "load of the drives not divided"
    if any(_is_rigid(arc.arc) for arc in by_pulley(result)):
        return "friction without slip or shear"
    return ""


def _is_rigid(arc: WrapArc) -> bool:
    return isinstance(arc.law, Constant | PressurePower) and arc.shear_compliance == 0.0


def _divides(result: Whole) -> bool:
    """Return whether speeds or motors divide the load, which no row does anew."""
    return isinstance(result, TrainResult) and any(
        isinstance(case.division, Speeds | Motors) for case in result.train.cases
    )


def changed_inputs(result: Whole) -> tuple[Input, ...]:
    """Return what is changed: not the effective tension where motors are judged by it."""
    inputs = inputs_of(by_pulley(result).drive)
    motors = {rule.name for rule in OF_MOTORS}
    judged = any(check.name in motors and check.compares for check in judge(result).listed)
    return tuple(of for of in inputs if not (judged and of.name == PULL))


def _fixed(result: Whole) -> str:
    return "load shares" if _divides(result) else ""
