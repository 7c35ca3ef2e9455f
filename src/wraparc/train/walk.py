"""Vary one quantity of a solved train with the speeds held: from solution to solution."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum
from math import log

from wraparc.errors import InputError, Problem, input_error
from wraparc.train.locate import locate
from wraparc.train.member import SHARP, Member
from wraparc.train.newton import Settled, settle
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.solve import Setup, arc_of
from wraparc.train.system import System
from wraparc.train.train import Motors, Speeds, Train

_TOLERANCE = 1e-10  # of a speed equation; the last tension is met to 1e-7
#: Least distance of places that are extrapolated from, in parts of the way that is known.
_APART = 0.05
_FURTHEST_GUESS = 1.0  # how far ahead, in parts of the way that is known, it is extrapolated


class Axis(StrEnum):
    """What is varied, by its name in the glossary."""

    TRIM = "speed_trim"
    DIAMETER = "diameter_ratio"
    LOAD = "load_ratio"


def held(result: TrainResult, case: str = "") -> tuple[Train, CaseResult]:
    """Return a train whose drums keep the speeds of a solved load case, and that case.

    Drives on motors keep their motors: those have their own way with speeds.

    Raises
    ------
    InputError
        If the load case has no solution: there are no speeds to keep.
    """
    found = result[case or result.train.case().name]
    if not found.status.solved:
        message = f"load case {found.case.name} has no solution to start from: {found.reason}"
        raise input_error(key="load_case", message=message)
    train = result.train.in_case(found.case)
    alone = replace(found.case, condition="")  # the laggings are in it
    if isinstance(found.case.division, Motors):
        return replace(train, cases=(alone,)), found
    trims = (m.speed_trim for m in found.members)
    speeds = tuple(t / d for t, d in zip(trims, train.nominal, strict=True))
    return replace(train, cases=(replace(alone, division=Speeds(speeds)),)), found


class Walk:
    """Goes along an axis, each solution the start of the next one.

    Parameters
    ----------
    result, case
        The solved train, and the load case to start from (the first one without a name).
    axis, drive
        What is varied, and of which drive (by index).

    Raises
    ------
    InputError
        If there is nothing to start from, or the axis has no meaning for the drive.
    """

    def __init__(self, result: TrainResult, case: str, axis: Axis, drive: int) -> None:
        self.train, self.case = held(result, case)
        check_axis(self.case, axis, drive)
        self.axis, self.drive = axis, drive
        setup = Setup.of(self.train, self.train.cases[0])
        self.here = place(self.train, self.case, axis, drive)
        self._names = [p.name for p in self.train.pulleys]
        self._softening = any(p.lagging.law.steepest_fall() < 0.0 for p in self.train.pulleys)
        self._base = setup.system
        state = locate(setup.system, self._names, self._softening).settled
        if state is not None:  # on coarser meshes
            passages = [replace(p, met=None) for p in state.passages]
            state = settle(setup.system, passages, state.level, SHARP, _TOLERANCE)
        if state is None:
            raise input_error(message="the speeds held have no solution to start from")
        self._start = (self.here, state)
        self._past = [self._start]  # the last solutions, newest last
        self.fallen: tuple[int, ...] = ()  # drives that broke away where the last step failed

    def system(self, value: float) -> System:
        """Return the equations at a value."""
        return varied(self._base, self.train, self.axis, self.drive, value / self.here)

    def restart(self) -> None:
        """Go back to the start."""
        self.begin(self._start)

    def begin(self, *known: tuple[float, Settled]) -> None:
        """Go on from known solutions, the nearest one last."""
        self._past = list(known)

    def to(self, value: float) -> Settled | None:
        """Return the stable solution at a value, or None; it becomes the next start."""
        system = self.system(value)
        found = self._from_here(system, value)
        if found is None or (self._softening and not found.stable):
            located = locate(system, self._names, self._softening)
            found = located.settled if located.status.solved else None
            self.fallen = located.fallen
        if found is not None and all(at != value for at, _ in self._past):
            self._past = [*self._past[-2:], (value, found)]
        return found

    def outward(self, values: Sequence[float]) -> dict[float, Settled | None]:
        """Solutions at all values, going both ways from the start."""
        states = {}
        ahead = sorted(v for v in values if v >= self.here)
        behind = sorted((v for v in values if v < self.here), reverse=True)
        for way in (ahead, behind):
            self.restart()
            for value in way:
                states[value] = self.to(value)
        return states

    def _from_here(self, system: System, value: float) -> Settled | None:
        """Return the solution near the one foretold by the last ones."""
        state = self._past[-1][1]
        weights = _extrapolation([at for at, _ in self._past], value)
        old = [past for _, past in self._past]
        places = [
            sum(w * s.passages[i].place for w, s in zip(weights, old, strict=True))
            for i in range(len(state.passages))
        ]
        level = sum(w * s.level for w, s in zip(weights, old, strict=True))
        passages = [replace(p, place=x) for p, x in zip(state.passages, places, strict=True)]
        return settle(system, passages, level, SHARP, _TOLERANCE)

    def shares(self, state: Settled, value: float) -> list[float]:
        """Shares of a state [-]."""
        total = self.system(value).pull
        return [(p.entry - p.exit) / total for p in state.passages]

    def loss_ratio(self, state: Settled, value: float) -> float:
        """Power lost to creep over power at the surfaces [-]."""
        loss = power = 0.0
        for member, p in zip(self.system(value).members, state.passages, strict=True):
            speed = (1.0 + p.entry * member.stretch) / (1.0 - p.ratio)
            pull = p.entry - p.exit
            loss += speed * pull * (p.ratio + 0.5 * pull * member.compliance)
            power += speed * pull
        return loss / abs(power) if power != 0.0 else math.nan


def _extrapolation(at: Sequence[float], value: float) -> list[float]:
    """Weights of known values, the newest last, for another place.

    By Lagrange through those that lie well apart: two that nearly coincide would blow up their
    rounding. Only the newest one counts where the place is further off than all that is known.
    """
    reach = max(at) - min(at)
    used: list[float] = []
    for x in reversed(at):
        if all(abs(x - other) > _APART * reach for other in used):
            used.append(x)
    if len(used) == 1 or min(abs(value - x) for x in used) > _FURTHEST_GUESS * reach:
        used = [at[-1]]
    weights = dict.fromkeys(at, 0.0)
    for x in used:
        weights[x] = math.prod((value - other) / (x - other) for other in used if other != x)
    return [weights[x] for x in at]


def place(train: Train, case: CaseResult, axis: Axis, drive: int) -> float:
    """Return where a solved case is on an axis [-]."""
    if axis is Axis.TRIM:  # a motor has its own way with speeds: what is changed is its setting
        motors = isinstance(case.case.division, Motors)
        return 1.0 if motors else case.members[drive].speed_trim
    if axis is Axis.DIAMETER:
        return train.pulleys[drive].diameter / train.nominal[drive]
    return 1.0


def varied(base: System, train: Train, axis: Axis, drive: int, change: float) -> System:
    """Return the equations with one quantity changed by a factor.

    Parameters
    ----------
    base, train
        The equations, and the train they are of.
    axis, drive
        What is changed, and of which drive.
    change
        New over old value [-].
    """
    if axis is Axis.LOAD:
        return replace(base, entry=base.exit - sum(base.runs) + change * base.pull)
    line = base.lines[drive]
    # a larger drum that turns as fast as before has a faster surface
    line = replace(line, speed=line.speed + log(change), scale=line.scale * change)
    lines = (*base.lines[:drive], line, *base.lines[drive + 1 :])
    if axis is Axis.TRIM:
        return replace(base, lines=lines)
    pulley = train.pulleys[drive]
    pulley = replace(pulley, diameter=pulley.diameter * change)
    arc = arc_of(train, train.cases[0], pulley, (base.entry,) * 2)
    members = (*base.members[:drive], Member.of(arc), *base.members[drive + 1 :])
    return replace(base, lines=lines, members=members)


def check_axis(case: CaseResult, axis: Axis, drive: int) -> None:
    """Raise if an axis has no meaning for a drive."""
    problems = []
    count, name = len(case.members), case.case.name
    if count < 2:
        message = "one pulley alone shares its load with nobody"
        problems.append(Problem(key="pulley", value="1", message=message))
    elif not 0 <= drive < count:
        message = f"the drives are 0 to {count - 1}, in belt order"
        problems.append(Problem(key="drive", value=str(drive), message=message))
    elif axis is Axis.TRIM and drive == 0:
        message = "trims are relative to the first drive"
        problems.append(Problem(key="drive", value="0", message=message))
    if case.case.effective_tension == 0.0:
        message = f"in load case {name} the drives together pull nothing that they could share"
        problems.append(Problem(key="load_case", message=message))
    if problems:
        raise InputError(problems)
