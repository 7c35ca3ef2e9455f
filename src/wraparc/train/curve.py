"""The shares of a train against one quantity, with the places worth knowing marked."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem, shown
from wraparc.train.newton import Settled
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.roots import bracketed_root
from wraparc.train.train import Motors, Train
from wraparc.train.walk import Axis, Walk

Measure = Callable[[Settled, float], float]

#: Shares at which a curve ends when nobody says where, and how far it goes for them.
_SHARES = (-0.4, 1.4)
_FURTHEST = 0.03
_LOADS = (0.05, 1.25)
#: Miss of a share, or of a creep over its limit, at a mark.
_MARK_MISS = 4e-6
_BISECTIONS = 10


class MarkKind(StrEnum):
    """What happens at a mark; the value ends a sentence that begins with the drive."""

    OPERATING = "is where it is now"
    EQUAL = "takes an equal share"
    UNLOADED = "transmits nothing"
    CREEP_LIMIT = "reaches its creep limit"
    TESTED_SLIP = "slips as far as its lagging was tested"
    BREAKAWAY = "reaches gross slip"


@dataclass(frozen=True)
class Mark:
    """A marked place of a curve.

    Attributes
    ----------
    kind, drive
        What happens to which drive (by index).
    value
        Where on the axis [-].
    shares
        Of every drive there [-].
    loss_ratio
        Power lost to creep there over power at the surfaces [-].
    """

    kind: MarkKind
    drive: int
    value: float
    shares: tuple[float, ...]
    loss_ratio: float


@dataclass(frozen=True, eq=False)
class ShareCurve:
    """Shares of a train against one quantity, the set speeds held.

    Attributes
    ----------
    train, case
        The train with its speeds held, and the load case, solved.
    axis, drive
        What is varied, and of which drive (by index).
    values
        Trim (of drives on motors: speed setting over that of now), diameter over nominal diameter,
        or load over that of the case; (n,) [-].
    shares
        Of every drive; nan where one of them breaks away; (n, drives) [-].
    creeps
        At the exits; (n, drives) [m].
    loss_ratio
        Power lost to creep over power at the surfaces; (n,) [-].
    marks
        Places worth knowing, in order.
    """

    train: Train
    case: CaseResult
    axis: Axis
    drive: int
    values: Array
    shares: Array
    creeps: Array
    loss_ratio: Array
    marks: tuple[Mark, ...]

    @property
    def quantity(self) -> str:
        """What the values are, by its name in the glossary."""
        motors = isinstance(self.case.case.division, Motors)
        return "speed_setting" if motors and self.axis is Axis.TRIM else self.axis.value

    def at(self, kind: MarkKind, drive: int | None = None) -> tuple[float, ...]:
        """Where something happens, to one drive or to any [-]."""
        return tuple(m.value for m in self.marks if m.kind is kind and drive in (None, m.drive))


def share_curve(
    result: TrainResult,
    case: str = "",
    *,
    axis: Axis = Axis.TRIM,
    drive: int = 1,
    span: tuple[float, float] | None = None,
    points: int = 101,
) -> ShareCurve:
    """Return the shares of a solved train while one quantity is varied and the speeds are held.

    Parameters
    ----------
    result, case
        The solved train, and the load case to start from (the first one without a name).
    axis, drive
        What is varied, and of which drive (by index).
    span
        Ends of the axis; unless given, so that the drives exchange the whole load.
    points
        Points of the curve.

    Raises
    ------
    InputError
        If the load case has no solution to start from, or the axis no meaning for the drive.
    """
    _check(span, points)
    walk = Walk(result, case, axis, drive)
    values = np.linspace(*(span or _span(walk)), points)
    states = walk.outward([float(v) for v in values])
    count = len(walk.train.pulleys)
    shares, creeps = np.full((points, count), np.nan), np.full((points, count), np.nan)
    loss = np.full(points, np.nan)
    for i, value in enumerate(values):
        state = states[float(value)]
        if state is not None:
            shares[i] = walk.shares(state, value)
            creeps[i] = [p.creep for p in state.passages]
            loss[i] = walk.loss_ratio(state, value)
    marks = tuple(sorted(_marks(walk, states), key=lambda m: m.value))
    return ShareCurve(walk.train, walk.case, axis, drive, values, shares, creeps, loss, marks)


def _check(span: tuple[float, float] | None, points: int) -> None:
    problems = []
    if span is not None and not 0.0 < span[0] < span[1] < math.inf:
        message = "must be two positive numbers, the smaller one first"
        problems.append(Problem(key="span", value=shown(list(span)), message=message))
    if not 3 <= points <= 10_001:
        message = "must be between 3 and 10001"
        problems.append(Problem(key="points", value=str(points), message=message))
    if problems:
        raise InputError(problems)


def _span(walk: Walk) -> tuple[float, float]:
    """Ends of the axis between which the drive takes and gives away the whole load."""
    if walk.axis is Axis.LOAD:
        return _LOADS
    share = walk.case.members[walk.drive].share
    slope = abs(walk.case.sensitivity[walk.drive][walk.drive])
    low, high = _SHARES

    def reach(change: float) -> float:
        return min(max(change, 0.3) / slope, _FURTHEST) if slope > 0.0 else _FURTHEST

    # raising the speed raises the share of the total, whatever the sign of that
    down, up = reach(share - low), reach(high - share)
    if walk.case.case.effective_tension < 0.0:
        down, up = up, down
    return walk.here - down, walk.here + up


def _marks(walk: Walk, states: dict[float, Settled | None]) -> Iterator[Mark]:
    """Find where something happens, between the points of a curve."""
    now = walk.case
    yield Mark(MarkKind.OPERATING, walk.drive, walk.here, now.shares, now.loss_ratio)
    points = sorted(states.items(), key=lambda point: point[0])
    for i, (a, b) in enumerate(pairwise(points)):
        if a[1] is not None and b[1] is not None:
            known = [(v, s) for v, s in points[max(i - 1, 0) : i + 3] if s is not None]
            yield from _events(walk, (a[0], a[1]), (b[0], b[1]), known)
        elif a[1] is not None or b[1] is not None:
            yield from _breakaway(walk, *((a, b) if b[1] is None else (b, a)))


def _measures(walk: Walk) -> Iterator[tuple[MarkKind, int, Measure]]:
    """What to look for: functions that change their sign where it happens."""
    train = walk.train
    fair = 1.0 / len(train.pulleys)

    def share_above(drive: int, level: float) -> Measure:
        return lambda state, value: walk.shares(state, value)[drive] - level

    def creep_above(drive: int, limit: float) -> Measure:
        return lambda state, _: abs(state.passages[drive].creep) / limit - 1.0

    def slip_above(drive: int, limit: float) -> Measure:
        return lambda state, _: abs(state.passages[drive].slip) / limit - 1.0

    yield MarkKind.EQUAL, walk.drive, share_above(walk.drive, fair)
    for i, pulley in enumerate(train.pulleys):
        yield MarkKind.UNLOADED, i, share_above(i, 0.0)
        yield MarkKind.CREEP_LIMIT, i, creep_above(i, train.creep_limit_of(pulley))
        tested = pulley.lagging.law.tested
        if tested is not None:
            yield MarkKind.TESTED_SLIP, i, slip_above(i, tested.slip_max)


def _events(
    walk: Walk,
    a: tuple[float, Settled],
    b: tuple[float, Settled],
    known: list[tuple[float, Settled]],
) -> Iterator[Mark]:
    """Whatever happens between two solutions, with the ones around them known."""
    for kind, drive, measure in _measures(walk):
        at_a, at_b = measure(a[1], a[0]), measure(b[1], b[0])
        if (at_a < 0.0) == (at_b < 0.0):
            continue

        def miss(value: float, measure: Measure = measure) -> float:
            walk.begin(*sorted(known, key=lambda point: -abs(point[0] - value)))
            state = walk.to(value)
            return math.nan if state is None else measure(state, value)

        value, _ = bracketed_root(miss, a[0], at_a, b[0], at_b, _MARK_MISS)
        state = walk.to(value)
        if state is not None:
            yield _mark(walk, kind, drive, value, state)


def _mark(walk: Walk, kind: MarkKind, drive: int, value: float, state: Settled) -> Mark:
    loss = walk.loss_ratio(state, value)
    return Mark(kind, drive, value, tuple(walk.shares(state, value)), loss)


def _breakaway(
    walk: Walk, good: tuple[float, Settled | None], bad: tuple[float, Settled | None]
) -> Iterator[Mark]:
    """The value, between a solution and none, at which the solutions end."""
    inside, outside = good[0], bad[0]
    fallen: tuple[int, ...] = ()
    state = good[1]
    for _ in range(_BISECTIONS):
        if state is not None:
            walk.begin((inside, state))
        middle = 0.5 * (inside + outside)
        found = walk.to(middle)
        if found is None:
            outside, fallen = middle, walk.fallen
        else:
            inside, state = middle, found
    if state is not None:
        for drive in fallen:
            yield _mark(walk, MarkKind.BREAKAWAY, drive, inside, state)
