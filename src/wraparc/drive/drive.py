"""A whole drive: a belt, its drive pulleys, and the load cases to be carried."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Protocol, TypeVar

from wraparc.conveyor import Conveyor
from wraparc.drive.belt import Belt
from wraparc.drive.criteria import Criteria
from wraparc.drive.load_case import LoadCase
from wraparc.drive.pulley import Pulley
from wraparc.errors import Problem, no_such, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.views import Viewable

#: Conservative limit of creep, 1/4 inch [m] (B. DeVries, "A model of lagging friction").
CREEP_LIMIT = 6.35e-3
MOST_PULLEYS = 10


@dataclass(frozen=True, kw_only=True)
class Drive(Viewable):
    """The drive of a conveyor, complete and checked.

    Parameters
    ----------
    title
        What the drive is called.
    belt
        The belt.
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

    Raises
    ------
    InputError
        With all names that repeat, tensions that are missing and limits that are broken.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {"creep_limit": Limit("length", open=True)}

    title: str = ""
    belt: Belt
    pulleys: tuple[Pulley, ...]
    load_cases: tuple[LoadCase, ...]
    creep_limit: float = CREEP_LIMIT
    criteria: Criteria = field(default_factory=Criteria)
    description: str = ""
    conveyor: Conveyor | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if not 1 <= len(self.pulleys) <= MOST_PULLEYS:
            message = f"a drive needs 1 to {MOST_PULLEYS} pulleys"
            problems.append(Problem(key="pulley", value=str(len(self.pulleys)), message=message))
        problems += repeated("pulley", (p.name for p in self.pulleys))
        problems += repeated("load_case", (c.name for c in self.load_cases))
        names = {p.name for p in self.pulleys}
        for case in self.load_cases:
            if case.tensions.keys() != names:
                problems.append(_wrong_pulleys(case, names))
        raise_all(problems)

    def pulley(self, name: str | None = None) -> Pulley:
        """Return a pulley by name, the first for None.

        Raises
        ------
        InputError
            If there is none of this name, with those there are.
        """
        return named("pulley", name, self.pulleys)

    def load_case(self, name: str | None = None) -> LoadCase:
        """Return a load case by name, the first for None; errors as for `pulley`."""
        return named("load case", name, self.load_cases)

    def creep_limit_of(self, pulley: Pulley) -> float:
        """Return the creep limit that holds for a pulley [m]."""
        return self.creep_limit if pulley.creep_limit is None else pulley.creep_limit


def repeated(key: str, names: Iterable[str]) -> list[Problem]:
    """Return a problem for every name that is used more than once."""
    return [
        Problem(
            key=f"{key}.name",
            value=shown(name),
            message=f"used {count} times",
            remedy="Give each its own name.",
        )
        for name, count in Counter(names).items()
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
