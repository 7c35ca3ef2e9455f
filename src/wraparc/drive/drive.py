"""A whole drive: a belt, its drive pulleys, and the load cases to be carried."""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import ClassVar, Protocol, Self, TypeVar

from wraparc.conveyor import Conveyor
from wraparc.drive.belt import LAYERS, THICKNESS, Belt
from wraparc.drive.belt_mass import OF_CONVEYOR, is_stated, with_mass
from wraparc.drive.criteria import Criteria, is_wet
from wraparc.drive.lagging import Lagging
from wraparc.drive.load_case import LoadCase, heaviest
from wraparc.drive.pitch import centrifugal_of, layers_of, touching_cover
from wraparc.drive.pulley import Pulley
from wraparc.drive.read_from import ReadFrom
from wraparc.errors import Problem, no_such, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.units import display
from wraparc.views import Viewable

#: Conservative limit of creep, 1/4 inch [m] (B. DeVries, "A model of lagging friction").
CREEP_LIMIT = 6.35e-3
MOST_PULLEYS = 10
SAME_MASS = 0.005  # by which the mass of the belt may differ in two places [-]
SAME_TENSION = 1e-6  # by which two tensions differ by rounding alone [-]


@dataclass(frozen=True, kw_only=True)
class Drive(Viewable):
    """The drive of a conveyor, complete and checked.

    Parameters
    ----------
    title
        What the drive is called.
    belt
        The belt; without a mass of its own it has that of `conveyor`.
    pulleys
        The drive pulleys in belt order, 1 to 10.
    load_cases
        The load cases, each with the tensions of every pulley.
    creep_limit
        Largest creep accepted at the exit of a pulley [m].
    criteria
        Take-up, design standard, safety factors and sag that it is held against.
    description
        Anything worth saying about it.
    conveyor
        What the tensions were computed from, or None where they are given. It says where they
        came from and is no part of what makes two drives equal.
    read_from
        The document that it was read from, or None; as little a part of it. A drive that was
        changed since keeps that of before.

    Raises
    ------
    InputError
        With all names that repeat, tensions that are missing and limits that are broken.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {"creep_limit": Pulley.LIMITS["creep_limit"]}

    title: str = ""
    belt: Belt
    pulleys: tuple[Pulley, ...]
    load_cases: tuple[LoadCase, ...]
    creep_limit: float = CREEP_LIMIT
    criteria: Criteria = field(default_factory=Criteria)
    description: str = ""
    conveyor: Conveyor | None = field(default=None, compare=False)
    read_from: ReadFrom | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.conveyor is not None and not is_stated(self.belt):
            mass = self.conveyor.belt_mass
            if self.belt.mass != mass:
                object.__setattr__(self, "belt", with_mass(self.belt, mass, OF_CONVEYOR))
        problems = limit_problems(self, self.LIMITS)
        if not 1 <= len(self.pulleys) <= MOST_PULLEYS:
            message = f"a drive needs 1 to {MOST_PULLEYS} pulleys"
            problems.append(Problem(key="pulley", value=str(len(self.pulleys)), message=message))
        problems += repeated("pulley", (p.name for p in self.pulleys))
        problems += repeated("load_case", (c.name for c in self.load_cases))
        problems += self.criteria.take_up.place_problems([p.name for p in self.pulleys])
        names = {p.name for p in self.pulleys}
        for case in self.load_cases:
            if case.tensions.keys() != names:
                problems.append(_wrong_pulleys(case, names))
            problems += condition_problems(case.name, case.condition, self.pulleys)
        problems += covered_problems(self.criteria, self.conditions, self.pulleys)
        problems += side_problems(self.belt, self.pulleys)
        problems += self._mass_problems()
        for pulley in self.pulleys:
            if pulley.across is not None:
                key = f"pulley.{pulley.name}.across"
                problems += pulley.across.problems(key, self.belt.width)
        raise_all(problems)

    def _mass_problems(self) -> list[Problem]:
        """Return what is wrong with the mass of the belt: two masses, a belt that flies."""
        problems: list[Problem] = []
        mass = self.belt.mass
        if mass is None:
            return problems
        if self.conveyor is not None and abs(self.conveyor.belt_mass / mass - 1.0) > SAME_MASS:
            other = display(self.conveyor.belt_mass, "mass_per_length")
            problems.append(
                Problem(
                    message=f"must equal belt_mass {other} of [conveyor]",
                    remedy="Give one of them, or the same twice.",
                    key="belt.mass",
                    value=display(mass, "mass_per_length"),
                )
            )
        for key, least in least_tensions(self.load_cases).items():
            problems += flying_problems(self.belt, key, least)
        return problems

    def pulley(self, name: str | None = None) -> Pulley:
        """Return a pulley by name, the first for None.

        Raises
        ------
        InputError
            If there is none of this name, with those there are.
        """
        return named("pulley", name, self.pulleys)

    def load_case(self, name: str | None = None) -> LoadCase:
        """Return a load case by name, the running one of the largest pull for None.

        Errors as for `pulley`.
        """
        if name is None:
            return heaviest(self.load_cases, _pull)
        return named("load case", name, self.load_cases)

    @property
    def conditions(self) -> tuple[str, ...]:
        """Conditions that the load cases name, in their order; empty where none does."""
        return tuple(dict.fromkeys(c.condition for c in self.load_cases if c.condition))

    @property
    def laggings(self) -> tuple[Lagging, ...]:
        """Every lagging of the pulleys once, in every condition that a load case has."""
        return laggings_of(self.pulleys, [case.condition for case in self.load_cases])

    def in_case(self, case: LoadCase) -> Self:
        """Return the drive with its laggings in the condition of a load case."""
        if not case.condition:
            return self
        return replace(self, pulleys=tuple(p.in_condition(case.condition) for p in self.pulleys))

    def slack_end(self, case: LoadCase) -> float:
        """Tension of the belt that leaves all pulleys slack in a load case [N]."""
        entry, leaving = self._ends(case)
        return leaving if _pull(case) >= 0.0 else entry

    def take_up_tension(self, case: LoadCase) -> float:
        """Tension of the belt at the take-up in a load case: at the one place where it stands [N].

        A conveyor says where; else it stands behind `TakeUp.after`, or on the slack side, or, where
        that has another tension in every load case, on the tight side if that keeps its own. Where
        the slack side changes, it stands on the side that keeps its tension better. A fixed
        take-up lifts all tensions alike: it is told by the slack side of one load case.
        """
        take_up = self.criteria.take_up
        if self.conveyor is not None:
            return self.conveyor.take_up
        if take_up.fixed:
            return self.slack_end(self.load_case())
        if take_up.after:
            return case.tensions[take_up.after].exit
        entry, leaving = self._ends(case)
        steady = self._steady_end
        return self.slack_end(case) if steady == "" else leaving if steady == "exit" else entry

    @property
    def states_uncertainty(self) -> bool:
        """Whether it states how uncertain one of its numbers is, or belts of its name do."""
        of_pulleys = any(p.uncertainty or p.lagging.uncertainty for p in self.pulleys)
        of_cases = any(of for case in self.load_cases for of in case.uncertainty.values())
        return self.belt.is_uncertain or of_pulleys or of_cases

    @property
    def take_up_place(self) -> str:
        """Where `take_up_tension` is, in words; empty for the slack side in every load case."""
        take_up = self.criteria.take_up
        ends = [self.slack_end(case) for case in self.load_cases]
        if self.conveyor is not None:
            held = self.conveyor.take_up
            away = any(abs(end - held) > SAME_TENSION * held for end in ends)
            return "at the take-up" if away else ""
        if take_up.fixed:
            return "" if _alike(ends) else f"behind the drives in load case {self.load_case().name}"
        steady = self._steady_end
        if steady == "entry" and not take_up.after:
            return f"at the take-up ahead of pulley {self.pulleys[0].name}"
        after = take_up.after or (self.pulleys[-1].name if steady == "exit" else "")
        return f"at the take-up behind pulley {after}" if after else ""

    @property
    def _steady_end(self) -> str:
        """``entry`` or ``exit`` where the take-up is not on the slack side always; else empty."""
        pulls = [_pull(case) for case in self.load_cases]
        entries = [self._ends(case)[0] for case in self.load_cases]
        exits = [self._ends(case)[1] for case in self.load_cases]
        if min(pulls) < 0.0 < max(pulls):
            steadier = min(exits) * max(entries) >= min(entries) * max(exits)
            return "exit" if steadier else "entry"
        drives = min(pulls) >= 0.0
        slack, tight = (exits, entries) if drives else (entries, exits)
        if _alike(slack) or not _alike(tight):
            return ""
        return "entry" if drives else "exit"

    def _ends(self, case: LoadCase) -> tuple[float, float]:
        first, last = self.pulleys[0].name, self.pulleys[-1].name
        return case.tensions[first].entry, case.tensions[last].exit

    def creep_limit_of(self, pulley: Pulley) -> float:
        """Return the creep limit that holds for a pulley [m]."""
        return self.creep_limit if pulley.creep_limit is None else pulley.creep_limit


def _alike(tensions: Sequence[float]) -> bool:
    return max(tensions) - min(tensions) <= SAME_TENSION * max(tensions)


def _pull(case: LoadCase) -> float:
    return math.fsum(t.effective for t in case.tensions.values())


def laggings_of(pulleys: Sequence[Pulley], conditions: Iterable[str]) -> tuple[Lagging, ...]:
    """Return every lagging of pulleys once, by name and condition."""
    found: dict[tuple[str, str], Lagging] = {}
    for condition in conditions:
        for pulley in pulleys:
            lagging = pulley.lagging_in(condition)
            found.setdefault((lagging.name, lagging.condition), lagging)
    return tuple(found.values())


def side_problems(belt: Belt, pulleys: Iterable[Pulley]) -> list[Problem]:
    """Return a problem for every pulley that meets a side of the belt without a known cover.

    A belt of which no layer is given is one whose thickness is not known, on either side.
    """
    if all(getattr(belt, key) is None for key in (*LAYERS, THICKNESS)):
        return []
    return [
        Problem(
            message="needs carry_cover of the belt",
            remedy='Write carry_cover = "5 mm" in [belt].',
            key=f"pulley.{pulley.name}.side",
            value=shown(pulley.side),
        )
        for pulley in pulleys
        if pulley.side == "carry" and math.isnan(touching_cover(layers_of(belt), True))
    ]


def least_tensions(cases: Iterable[LoadCase]) -> dict[str, float]:
    """Return the least tension of every load case, by its key [N]."""
    return {
        f"load_case.{case.name}": min(
            (min(t.entry, t.exit) for t in case.tensions.values()), default=math.inf
        )
        for case in cases
    }


def flying_problems(belt: Belt, key: str, least: float) -> list[Problem]:
    """Return a problem where the belt is so heavy and fast that it leaves its pulley.

    Parameters
    ----------
    belt
        The belt.
    key
        Where its tensions are.
    least
        The least of them [N].
    """
    force = centrifugal_of(belt)
    if force < least:
        return []
    return [
        Problem(
            message=f"m v^2 = {display(force, 'force')} of the belt exceeds its tension "
            f"{display(least, 'force')}",
            remedy="Give the mass of one metre of belt.",
            key=key,
        )
    ]


def condition_problems(case: str, condition: str, pulleys: Iterable[Pulley]) -> list[Problem]:
    """Return a problem for every pulley that has no lagging in the condition of a load case."""
    return [
        Problem(
            key=f"load_case.{case}.condition",
            value=shown(condition),
            message=f"pulley {shown(p.name)} has no lagging in this condition",
        )
        for p in pulleys
        if condition and condition not in (lagging.condition for lagging in p.conditions)
    ]


def covered_problems(
    criteria: Criteria, conditions: Iterable[str], pulleys: Iterable[Pulley]
) -> list[Problem]:
    """Return a problem if a drive that never runs wet has a wet condition."""
    laggings = (lagging for p in pulleys for lagging in (p.lagging, *p.conditions))
    every = (*conditions, *(lagging.condition for lagging in laggings))
    wet = next(filter(is_wet, every), "")
    if not (criteria.covered and wet):
        return []
    message = f"contradicts condition {shown(wet)}"
    remedy = "Leave out covered or the condition."
    return [Problem(key="covered", value="true", message=message, remedy=remedy)]


def repeated(key: str, names: Iterable[str]) -> list[Problem]:
    """Return a problem for every name that is used more than once."""
    found = list(names)
    if len(set(found)) == len(found):
        return []
    return [
        Problem(
            key=f"{key}.name",
            value=shown(name),
            message=f"used {count} times",
            remedy="Give each its own name.",
        )
        for name, count in Counter(found).items()
        if count > 1
    ]


def _wrong_pulleys(case: LoadCase, names: set[str]) -> Problem:
    missing, unknown = sorted(names - case.tensions.keys()), sorted(case.tensions.keys() - names)
    parts = [f"no tensions for {shown(missing)}"] if missing else []
    parts += [f"tensions for {shown(unknown)}, which the drive does not have"] if unknown else []
    return Problem(key=f"load_case.{case.name}", message=" and ".join(parts))


class _Named(Protocol):
    @property
    def name(self) -> str: ...


_N = TypeVar("_N", bound=_Named)


def named(what: str, name: str | None, among: Sequence[_N], *, of: str = "the drive") -> _N:
    """Return the one of a name, the first for None; an `InputError` lists them if there is none."""
    for one in among:
        if name in (None, one.name):
            return one
    raise no_such(what, name, [one.name for one in among], of=of)
