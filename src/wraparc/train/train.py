"""Several drive pulleys on one belt: what is described, and how the load divides."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import ClassVar, NamedTuple

from wraparc.conveyor import Conveyor
from wraparc.drive import (
    CREEP_LIMIT,
    MOST_PULLEYS,
    Belt,
    CaseKind,
    Criteria,
    Drive,
    Lagging,
    Limit,
    LoadCase,
    Pulley,
    ReadFrom,
    Tensions,
    condition_problems,
    laggings_of,
    repeated,
)
from wraparc.drive.drive import covered_problems, flying_problems, named, side_problems
from wraparc.drive.load_case import UNCERTAIN_OF_CASE, heaviest
from wraparc.errors import Problem, name_remedy, shown
from wraparc.schema.limits import limit_problems, name_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.units import display

#: How far shares may miss their sum.
_SHARE_SUM = 1e-6


@dataclass(frozen=True)
class Shares:
    """The load divides as given.

    Attributes
    ----------
    fractions
        Part of the total effective tension of each pulley, in belt order; they sum to 1. A
        negative one brakes.
    """

    fractions: tuple[float, ...]


@dataclass(frozen=True)
class Pulls:
    """Every pulley pulls as given.

    Attributes
    ----------
    effective_tensions
        T1 - T2 of each pulley, in belt order [N]; negative where it brakes. They sum to the total.
    """

    effective_tensions: tuple[float, ...]


@dataclass(frozen=True)
class Speeds:
    """The drums turn at given speeds, whatever their torque.

    Attributes
    ----------
    rotation_speeds
        Of each drum, in belt order [rad/s]; only their ratios count unless `absolute`.
    absolute
        Whether the belt speed follows from them; otherwise it is that of the belt.
    """

    rotation_speeds: tuple[float, ...]
    absolute: bool = False


@dataclass(frozen=True)
class Motors:
    """The drums turn as their motors do.

    Attributes
    ----------
    motors
        A motor or a torque follower for each pulley, in belt order.
    """

    motors: tuple[Motor | TorqueFollower, ...]


Division = Shares | Pulls | Speeds | Motors


@dataclass(frozen=True, kw_only=True)
class TrainCase:
    """One load case of a train.

    Attributes
    ----------
    name
        Name of the state of the conveyor.
    entry_tension
        Tension where the belt meets the first pulley [N].
    exit_tension
        Tension where it leaves the last one [N].
    division
        What decides how the load divides.
    runs
        Rise of tension over the run from each pulley to the next, negative where it falls [N]; 0
        where drives stand together. Empty for none.
    kind, condition, description
        As in `LoadCase`.
    uncertainty
        How far its tensions may be off either way (95 %), by `UNCERTAIN_OF_CASE` [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = {
        "entry_tension": Tensions.LIMITS["entry"],
        "exit_tension": Tensions.LIMITS["exit"],
    }

    name: str
    entry_tension: float
    exit_tension: float
    division: Division
    runs: tuple[float, ...] = ()
    kind: CaseKind = "running"
    condition: str = ""
    description: str = ""
    uncertainty: Mapping[str, float] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        problems = name_problems("name", self.name) + limit_problems(self, self.LIMITS)
        raise_all(problems + uncertainty_problems(self.uncertainty, UNCERTAIN_OF_CASE))

    @property
    def effective_tension(self) -> float:
        """Sum of T1 - T2 over all pulleys [N]."""
        return self.entry_tension - self.exit_tension + sum(self.runs)

    @property
    def pulls_given(self) -> bool:
        """Whether the pulls are given, and the speeds follow."""
        return isinstance(self.division, Shares | Pulls)

    @property
    def on_motors(self) -> bool:
        """Whether the drums turn as their motors do."""
        return isinstance(self.division, Motors)

    def run(self, index: int) -> float:
        """Rise of tension from pulley `index` to the next [N]."""
        return self.runs[index] if index < len(self.runs) else 0.0


@dataclass(frozen=True, kw_only=True)
class Train:
    """Drive pulleys on one belt, in belt order.

    Attributes
    ----------
    title, description
        What it is called, and anything worth saying.
    belt
        The belt.
    pulleys
        1 to 10, in the order in which a point of the belt meets them.
    cases
        The load cases.
    nominal_diameters
        The diameters that the drums are taken to have when their speeds are set [m]; empty for
        those of the pulleys. They differ where a lagging has worn.
    creep_limit
        Largest creep accepted at the exit of a pulley [m].
    criteria
        What the train is held against, as in `Drive`.
    read_from
        As in `Drive`.
    conveyor
        What the load cases were computed from, or None where their tensions are given.

    Raises
    ------
    InputError
        With everything that is wrong.
    """

    LIMITS: ClassVar[dict[str, Limit]] = {"creep_limit": Pulley.LIMITS["creep_limit"]}

    title: str = ""
    description: str = ""
    belt: Belt
    pulleys: tuple[Pulley, ...]
    cases: tuple[TrainCase, ...]
    nominal_diameters: tuple[float, ...] = ()
    creep_limit: float = CREEP_LIMIT
    criteria: Criteria = field(default_factory=Criteria)
    read_from: ReadFrom | None = field(default=None, compare=False, repr=False)
    conveyor: Conveyor | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        count = len(self.pulleys)
        if not 1 <= count <= MOST_PULLEYS:
            message = f"a train needs 1 to {MOST_PULLEYS} pulleys"
            problems.append(Problem(key="pulley", value=str(count), message=message))
        problems += repeated("pulley", (p.name for p in self.pulleys))
        problems += repeated("load_case", (c.name for c in self.cases))
        problems += self.criteria.take_up.place_problems([p.name for p in self.pulleys])
        if not self.cases:
            problems.append(Problem(key="load_case", message="a train needs a load case"))
        if self.nominal_diameters:
            problems += _count_problems("nominal_diameters", self.nominal_diameters, count)
            if not all(0.0 < d < math.inf for d in self.nominal_diameters):
                message = "must be positive and finite"
                given = str(list(self.nominal_diameters))
                problems.append(Problem(key="nominal_diameters", value=given, message=message))
        names = [p.name for p in self.pulleys]
        for case in self.cases:
            problems += _case_problems(case, names)
            problems += condition_problems(case.name, case.condition, self.pulleys)
            least = min(case.entry_tension, case.exit_tension)
            problems += flying_problems(self.belt, f"load_case.{case.name}", least)
        problems += side_problems(self.belt, self.pulleys)
        problems += covered_problems(self.criteria, self.conditions, self.pulleys)
        raise_all(problems)

    @classmethod
    def of(cls, drive: Drive) -> Train:
        """Return a drive as a train: its shares are those of its tensions.

        Where the entry tension of a pulley is not the exit tension of the one before, the
        difference is taken as the rise of tension over the run between them.
        """
        return cls(
            title=drive.title,
            description=drive.description,
            belt=drive.belt,
            pulleys=drive.pulleys,
            cases=tuple(_case_of(drive, case) for case in drive.load_cases),
            creep_limit=drive.creep_limit,
            criteria=drive.criteria,
            read_from=drive.read_from,
        )

    @property
    def nominal(self) -> tuple[float, ...]:
        """Nominal diameters of the drums [m]."""
        return self.nominal_diameters or tuple(p.diameter for p in self.pulleys)

    def case(self, name: str = "") -> TrainCase:
        """Return the load case of a name, the running one of the largest pull without a name.

        Raises
        ------
        InputError
            If there is none, with those there are.
        """
        if not name:
            return heaviest(self.cases, lambda case: case.entry_tension - case.exit_tension)
        return named("load case", name, self.cases, of="the train")

    @property
    def conditions(self) -> tuple[str, ...]:
        """Conditions that the load cases name, in their order; empty where none does."""
        return tuple(dict.fromkeys(c.condition for c in self.cases if c.condition))

    @property
    def laggings(self) -> tuple[Lagging, ...]:
        """Every lagging of the pulleys once, in every condition that a load case has."""
        return laggings_of(self.pulleys, [case.condition for case in self.cases])

    def in_case(self, case: TrainCase) -> Train:
        """Return the train with its laggings in the condition of a load case."""
        if not case.condition:
            return self
        return replace(self, pulleys=tuple(p.in_condition(case.condition) for p in self.pulleys))

    def creep_limit_of(self, pulley: Pulley) -> float:
        """Return the creep limit that holds for a pulley [m]."""
        return self.creep_limit if pulley.creep_limit is None else pulley.creep_limit


def _case_of(drive: Drive, case: LoadCase) -> TrainCase:
    pairs = [case.tensions[p.name] for p in drive.pulleys]
    runs = tuple(b.entry - a.exit for a, b in pairwise(pairs))
    return TrainCase(
        name=case.name,
        entry_tension=pairs[0].entry,
        exit_tension=pairs[-1].exit,
        division=Pulls(tuple(pair.effective for pair in pairs)),
        runs=runs if any(runs) else (),
        kind=case.kind,
        condition=case.condition,
        description=case.description,
    )


class Pair(NamedTuple):
    """Tensions of a pulley [N]."""

    entry: float
    exit: float


def along(entry: float, exit_: float, runs: Sequence[float], pulls: Sequence[float]) -> list[Pair]:
    """Return the tensions of pulleys whose pulls are known; `runs` has 0 behind the last [N]."""
    pairs = []
    now = entry
    for i, (pull, run) in enumerate(zip(pulls, runs, strict=True)):
        out = exit_ if i == len(pulls) - 1 else now - pull
        pairs.append(Pair(now, out))
        now = out + run
    return pairs


def tensions_at(case: TrainCase, pulls: Sequence[float]) -> list[Pair]:
    """Return entry and exit tension of each pulley for its effective tension [N]."""
    runs = [case.run(i) for i in range(len(pulls))]
    return along(case.entry_tension, case.exit_tension, runs, pulls)


def _count_problems(key: str, values: Sequence[object], count: int) -> list[Problem]:
    if len(values) == count:
        return []
    message = f"must have one value for each of the {count} pulleys"
    return [Problem(key=key, value=f"{len(values)} values", message=message)]


def _case_problems(case: TrainCase, names: list[str]) -> list[Problem]:
    """Return what is wrong with a load case of a train of such pulleys."""
    where, count = f"load_case.{case.name}", len(names)
    problems: list[Problem] = []
    if case.runs and len(case.runs) != count - 1:
        message = f"must have one value for each of the {count - 1} runs between pulleys"
        given = f"{len(case.runs)} values"
        problems.append(Problem(key=f"{where}.run", value=given, message=message))
    elif not all(map(math.isfinite, case.runs)):
        problems.append(Problem(key=f"{where}.run", message="must be finite"))
    if problems:
        return problems
    division = case.division
    if isinstance(division, Shares):
        return _share_problems(f"{where}.share", division.fractions, case, count)
    if isinstance(division, Pulls):
        return _pull_problems(f"{where}.share", division.effective_tensions, case, count)
    if isinstance(division, Speeds):
        speeds = division.rotation_speeds
        problems = _count_problems(f"{where}.speeds", speeds, count)
        if not all(0.0 < speed < math.inf for speed in speeds):
            message = "every speed must be positive and finite"
            problems.append(Problem(key=f"{where}.speeds", message=message))
        return problems
    return _motor_problems(f"{where}.motor", division.motors, names)


def _share_problems(
    key: str, fractions: Sequence[float], case: TrainCase, count: int
) -> list[Problem]:
    problems = _count_problems(key, fractions, count)
    total = math.fsum(fractions)
    if not problems and not abs(total - 1.0) <= _SHARE_SUM:
        given = ", ".join(f"{f:g}" for f in fractions)
        message = f"must sum to 1, not to {total:.6g}"
        remedy = "Give fractions like 0.5 or 50 %."
        problems.append(Problem(key=key, value=f"[{given}]", message=message, remedy=remedy))
    pulls = [f * case.effective_tension for f in fractions]
    return problems or _slack_problems(key, pulls, case)


def _pull_problems(key: str, pulls: Sequence[float], case: TrainCase, count: int) -> list[Problem]:
    problems = _count_problems(key, pulls, count)
    total, asked = math.fsum(pulls), case.effective_tension
    size = max(case.entry_tension, case.exit_tension)
    if not problems and not abs(total - asked) <= _SHARE_SUM * size:
        message = (
            f"the pulleys make {display(total, 'force', digits=6)}, the tensions "
            f"{display(asked, 'force', digits=6)}"
        )
        problems.append(Problem(key=key, message=message))
    return problems or _slack_problems(key, pulls, case)


def _slack_problems(key: str, pulls: Sequence[float], case: TrainCase) -> list[Problem]:
    low = min(min(pair) for pair in tensions_at(case, pulls))
    if low > 0.0:
        return []
    message = f"leaves a belt tension of {display(low, 'force')}"
    remedy = "Give other shares, or raise T2."
    return [Problem(key=key, message=message, remedy=remedy)]


def _motor_problems(
    key: str, motors: Sequence[Motor | TorqueFollower], names: list[str]
) -> list[Problem]:
    problems = _count_problems(key, motors, len(names))
    if problems:
        return problems
    by_name = dict(zip(names, motors, strict=True))
    for name, motor in by_name.items():
        if not isinstance(motor, TorqueFollower):
            continue
        leads = by_name.get(motor.master)
        where = f"{key}.{name}.master"
        if leads is None:
            remedy = name_remedy(motor.master, names)
            value, message = shown(motor.master), "no such pulley"
            problems.append(Problem(key=where, value=value, message=message, remedy=remedy))
        elif isinstance(leads, TorqueFollower):
            message = "must not follow another drive itself"
            problems.append(Problem(key=where, value=shown(motor.master), message=message))
    if Counter(map(type, motors))[TorqueFollower] == len(motors):
        message = "every drive follows another one"
        problems.append(Problem(key=key, message=message))
    return problems
