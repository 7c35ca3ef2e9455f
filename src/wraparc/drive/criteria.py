"""What a drive is held against beyond its parts: take-up, design standard, safety factors, sag."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Literal

from wraparc.conveyor import GRAVITY
from wraparc.errors import Problem, name_remedy, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all

#: States of a conveyor that differ in their safety factors and in what a belt may bear.
CASE_KINDS = ("running", "starting", "braking")
CaseKind = Literal["running", "starting", "braking"]
#: What keeps the belt tight: a weight, a winch that follows its tension, or a fixed pulley.
TAKE_UPS = ("gravity", "winch", "fixed")
#: Design standards of the slack-side tension; ``own`` needs a friction, ``none`` asks for nothing.
STANDARDS = ("CEMA", "DIN 22101", "own", "none")
#: Conditions that DIN 22101 tells apart.
CONDITIONS = ("dry", "wet", "wet and dirty")
_FACTOR = Limit("number", least=1.0, most=10.0)


def is_wet(condition: str) -> bool:
    """Return whether a condition is a wet one: ``wet``, ``wet and dirty`` ..."""
    return "wet" in condition.lower().split()


def choice_problems(thing: object, choices: Mapping[str, tuple[str, ...]]) -> list[Problem]:
    """Return a problem for every field that is none of its words."""
    return [
        Problem(
            key=key,
            value=shown(getattr(thing, key)),
            message=f"must be one of {', '.join(word for word in words if word)}",
        )
        for key, words in choices.items()
        if getattr(thing, key) not in words
    ]


@dataclass(frozen=True, kw_only=True)
class TakeUp:
    """What keeps the belt tight.

    Parameters
    ----------
    kind
        ``gravity`` and ``winch`` hold the slack-side tension T2 whatever the pull; ``fixed`` (a
        screw, a locked carriage) holds T1 + T2. Empty: not said, taken as gravity.
    sheave_ratio
        Pull of the counterweight over the belt tension at the take-up [-]: 2 for a weight hung
        from the take-up pulley, less where ropes and sheaves multiply it.
    after
        Pulley behind which it holds the tension of the belt, where it stands between two drives.
        Empty: on the slack side of all of them, close by, on the return strand or at the tail.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "sheave_ratio": Limit("number", least=0.01, most=100.0),
    }

    kind: str = ""
    sheave_ratio: float = 2.0
    after: str = ""

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        problems += choice_problems(self, {"kind": ("", *TAKE_UPS)})
        if self.after and self.fixed:
            message = "a fixed take-up needs no place"
            remedy = "Leave it out, or correct the kind."
            given = shown(self.after)
            problems.append(Problem(key="after", value=given, message=message, remedy=remedy))
        raise_all(problems)

    def place_among(self, pulleys: Sequence[str]) -> int:
        """Return the index of the pulley it stands behind, -1 where it stands behind none."""
        return pulleys.index(self.after) if self.after else -1

    def place_problems(self, pulleys: Sequence[str]) -> list[Problem]:
        """Return a problem if it stands behind a pulley that is none of these."""
        if not self.after or self.after in pulleys:
            return []
        given, remedy = shown(self.after), name_remedy(self.after, pulleys)
        return [Problem(key="take_up.after", value=given, message="no such pulley", remedy=remedy)]

    @property
    def fixed(self) -> bool:
        """Whether it holds the sum of both tensions rather than the slack side."""
        return self.kind == "fixed"

    def counterweight(self, tension: float) -> float:
        """Mass of the counterweight for a belt tension at the take-up [kg]."""
        return self.sheave_ratio * tension / GRAVITY


@dataclass(frozen=True, kw_only=True)
class DesignStandard:
    """The rule that the slack-side tension is designed by.

    Parameters
    ----------
    name
        One of `STANDARDS`. Empty: not chosen, CEMA is taken.
    condition
        ``dry``, ``wet`` or ``wet and dirty``; empty for that of the lagging.
    friction
        Friction of one's own rule [-]; for ``own`` only.
    start_factor
        Pull that the rule is applied to over the pull of a running load case [-].
    binding
        Whether a drive below the rule fails rather than asks for attention.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "friction": Limit("number", least=0.01, most=2.0),
        "start_factor": _FACTOR,
    }

    name: str = ""
    condition: str = ""
    friction: float | None = None
    start_factor: float = 1.0
    binding: bool = False

    def __post_init__(self) -> None:
        words = {"name": ("", *STANDARDS), "condition": ("", *CONDITIONS)}
        problems = limit_problems(self, self.LIMITS) + choice_problems(self, words)
        if (self.name == "own") != (self.friction is not None):
            given = "" if self.friction is None else f"{self.friction:g}"
            message = "missing for a standard of your own"
            remedy = "Write friction = 0.30 beside it."
            if given:
                message, remedy = "only a standard of your own has one", 'Write name = "own".'
            problems.append(Problem(key="friction", value=given, message=message, remedy=remedy))
        if self.name == "none" and self.binding:
            message = "no standard was chosen that could bind"
            problems.append(Problem(key="binding", value="true", message=message))
        raise_all(problems)


@dataclass(frozen=True, kw_only=True)
class SafetyFactors:
    """Least pull at gross slip over the pull of a load case, by its kind [-].

    Parameters
    ----------
    running, starting, braking
        The factors, at least 1.
    source
        Where they came from; empty: the values that wraparc takes where nothing is said.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = dict.fromkeys(CASE_KINDS, _FACTOR)

    running: float = 1.25
    starting: float = 1.1
    braking: float = 1.1
    source: str = ""

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    def of(self, kind: str) -> float:
        """Return the factor of a kind of load case [-]."""
        return float(getattr(self, kind))


@dataclass(frozen=True, kw_only=True)
class Sag:
    """How far the slack belt may sag between the idlers that follow the pulley.

    Parameters
    ----------
    spacing
        Distance l of the idlers [m].
    line_mass
        Mass m' of what hangs between them per length of belt: the empty belt on a return strand,
        belt and load on a carrying one [kg/m].
    share
        Largest sag over spacing h [-].

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    SOURCE: ClassVar[str] = (
        "belt sag: T = m' g l/(8 h), a parabola; the rule of DIN 22101 and of CEMA, Belt Conveyors "
        "for Bulk Materials (6.25 S W for 2 %, 4.2 S W for 3 %)"
    )
    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "spacing": Limit("length", open=True, most=100.0),
        "line_mass": Limit("mass_per_length", open=True, most=10_000.0),
        "share": Limit("number", open=True, most=0.1),
    }

    spacing: float
    line_mass: float
    share: float = 0.02

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    @property
    def tension(self) -> float:
        """Least tension, m' g l/(8 h) [N]."""
        return self.line_mass * GRAVITY * self.spacing / (8.0 * self.share)


@dataclass(frozen=True, kw_only=True)
class Criteria:
    """What a drive is held against beyond its belt, pulleys and laggings.

    Attributes
    ----------
    take_up, standard, safety
        See there.
    sag
        Sag of the slack belt, or None to leave it out.
    covered
        Whether the drive never runs wet: its creep when wet is then not estimated.
    """

    take_up: TakeUp = field(default_factory=TakeUp)
    standard: DesignStandard = field(default_factory=DesignStandard)
    safety: SafetyFactors = field(default_factory=SafetyFactors)
    sag: Sag | None = None
    covered: bool = False
