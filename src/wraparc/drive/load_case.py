"""The tensions that a drive works at."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import atan2, cos, nan, sin, sqrt
from typing import ClassVar, NamedTuple, Protocol, TypeVar

from wraparc.alike import largest
from wraparc.conveyor import GRAVITY
from wraparc.drive.criteria import CASE_KINDS, CaseKind, choice_problems
from wraparc.errors import Problem
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems

#: Name of the load case made by the tensions of the pulleys themselves.
DESIGN = "design"
#: Numbers of it that have an uncertainty; that of torque and power is the effective tension's.
UNCERTAIN_OF_CASE = ("entry_tension", "exit_tension", "effective_tension")
#: Least and largest tension that a pulley may have [N].
LEAST_TENSION, MOST_TENSION = 0.1, 1e9
#: Hours of the longest year.
YEAR = 8784.0
#: Pull over tension that rounding leaves of none [-].
ROUNDING = 1e-12


def hours_problems(hours: Mapping[str, float], key: str = "hours") -> list[Problem]:
    """Return a problem for hours of running in a year that are none, or more than it has in all."""
    said = "must be between 0 and 8784 in a year"
    problems = [
        Problem(key=f"{key}.{name}", value=f"{h:g}", message=said)
        for name, h in hours.items()
        if not 0.0 <= h <= YEAR
    ]
    total = sum(hours.values())
    if problems or total <= YEAR:
        return problems
    message, remedy = f"must sum to at most {YEAR:g}", "Give hours in one year."
    return [Problem(key=key, value=f"{total:g}", message=message, remedy=remedy)]


class Kinded(Protocol):
    """A load case of a drive or of a train."""

    @property
    def kind(self) -> CaseKind:
        """What the conveyor does in it."""
        ...


_Case = TypeVar("_Case", bound=Kinded)


def heaviest(cases: Sequence[_Case], pull: Callable[[_Case], float]) -> _Case:
    """Return the load case of the largest pull [N] either way, of those that run if any does.

    It is the one that is meant where none is named; the first of those that pull alike.
    """
    running = [case for case in cases if case.kind == "running"]
    return largest(running or cases, lambda case: abs(pull(case)))


def exit_behind(entry: float, leaving: float) -> float:
    """Return the exit tension; that of the entry where rounding alone sets the two apart [N]."""
    return entry if abs(entry - leaving) <= ROUNDING * entry else leaving


def pull_of_torque(torque: float, diameter: float) -> float:
    """Effective tension of a torque at the shaft of a pulley, 2 M/D [N]."""
    return 2.0 * torque / diameter


def pull_of_power(power: float, speed: float) -> float:
    """Effective tension of a power at a belt speed, P/v [N]."""
    return power / speed


class Resultant(NamedTuple):
    """What the belt does to shaft and bearings of a pulley, and the belt itself bears."""

    resultant_force: float  # of both belt tensions [N]
    resultant_angle: float  # from the line of the entry tension towards that of the exit [rad]
    belt_safety: float  # strength over the larger tension; nan without a strength [-]
    most_shaft_load: float  # with the weight of the pulley, the belt pulling straight down [N]
    least_shaft_load: float  # the belt pulling straight up; both nan without a mass [N]


def resultant(
    entry: float, leaving: float, wrap_angle: float, strength: float, mass: float = nan
) -> Resultant:
    """Return the resultant of the belt tensions at a pulley, and its bounds with its own weight.

    The strands leave the pulley pi - phi apart: R^2 = T1^2 + T2^2 - 2 T1 T2 cos phi, and
    tan(angle) = T2 sin phi/(T1 - T2 cos phi). How the belt lies to the vertical is not known: the
    vector sum of R and the weight W is between |R - W| and R + W, level belts at the root of
    R^2 + W^2.

    Parameters
    ----------
    entry, leaving
        T1, T2 [N].
    wrap_angle
        phi [rad].
    strength
        Breaking strength of the belt, nan where it is not known [N].
    mass
        Mass of the pulley, nan where it is not known [kg].
    """
    along, across = entry - leaving * cos(wrap_angle), leaving * sin(wrap_angle)
    force, angle = sqrt(along * along + across * across), atan2(across, along)
    weight = mass * GRAVITY
    safety = strength / max(entry, leaving)
    return Resultant(force, angle, safety, force + weight, abs(force - weight))


@dataclass(frozen=True, kw_only=True)
class Tensions:
    """Belt tensions at a pulley.

    Parameters
    ----------
    entry, exit
        Tension at the entry nip (T1) and at the exit nip (T2) [N]. T1 > T2 drives,
        T1 < T2 brakes. Apart by rounding (1e-12) alone, they are equal.
    computed
        What those that are not given were computed from, in words, by field; no part of what makes
        two equal.

    Raises
    ------
    InputError
        If one is not positive and finite.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "entry": Limit("force", least=LEAST_TENSION, most=MOST_TENSION),
        "exit": Limit("force", least=LEAST_TENSION, most=MOST_TENSION),
    }

    entry: float
    exit: float
    computed: Mapping[str, str] = field(default_factory=dict, compare=False)

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))
        object.__setattr__(self, "exit", exit_behind(self.entry, self.exit))

    @property
    def effective(self) -> float:
        """Effective tension T1 - T2 [N], negative when braking."""
        return self.entry - self.exit

    @property
    def ratio(self) -> float:
        """Tension ratio T1/T2 [-]."""
        return self.entry / self.exit


@dataclass(frozen=True, kw_only=True)
class LoadCase:
    """One state of the conveyor: full, empty, start, brake ...

    Parameters
    ----------
    name
        Name of the state.
    tensions
        Tensions by name of the pulley.
    kind
        ``running``, ``starting`` or ``braking`` (stopping): what safety factors and the belt
        allow. A conveyor that is held back all the time is running.
    condition
        Condition of the laggings, ``wet`` ...; empty for that which the pulleys say.
    description
        What happens then.
    uncertainty
        How far its tensions may be off either way (95 %), by pulley and `UNCERTAIN_OF_CASE`; of
        all pulleys together, the entry to the first and the exit of the last, by "" [-].
    """

    name: str
    tensions: Mapping[str, Tensions] = field(hash=False)
    kind: CaseKind = "running"
    condition: str = ""
    description: str = ""
    uncertainty: Mapping[str, Mapping[str, float]] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        problems = choice_problems(self, {"kind": CASE_KINDS})
        for of in self.uncertainty.values():
            problems += uncertainty_problems(of, UNCERTAIN_OF_CASE)
        raise_all(name_problems("name", self.name) + problems)
