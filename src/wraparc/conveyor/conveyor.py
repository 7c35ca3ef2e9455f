"""A conveyor, its drives at head, tail or between: resistances and tensions by load case."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from wraparc.conveyor.choices import choices
from wraparc.conveyor.course import course_states
from wraparc.conveyor.description import UNCERTAIN, ConveyorData
from wraparc.conveyor.fits import flight_misfits
from wraparc.conveyor.resistance import no_coefficient
from wraparc.conveyor.state import State
from wraparc.errors import Problem, shown
from wraparc.schema.limits import limit_problems, raise_all
from wraparc.schema.uncertain import uncertainty_problems
from wraparc.units import display

#: Where the drive pulley sits.
DRIVES_AT = ("head", "tail")


@dataclass(frozen=True, kw_only=True)
class Conveyor(ConveyorData):
    """A conveyor, checked, with its load cases.

    Raises
    ------
    InputError
        With every number outside its limit, with what is missing and what is said twice, and
        with what does not fit together.
    """

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        given = {key for key in self.LIMITS if getattr(self, key) is not None}
        problems += choices(given | ({"loading"} if self.loadings else set()))
        if self.drive_at not in DRIVES_AT:
            message = f"must be one of {', '.join(DRIVES_AT)}"
            problems.append(Problem(key="drive_at", value=shown(self.drive_at), message=message))
        problems += uncertainty_problems(self.uncertainty, UNCERTAIN)
        problems += [
            Problem(key=f"uncertainty.{key}", message=f"{key} is missing", remedy="Give both.")
            for key in UNCERTAIN
            if key in self.uncertainty and getattr(self, key) is None
        ]
        raise_all(problems or list(self.misfits()))

    def misfits(self) -> Iterator[Problem]:
        """Yield what does not fit together, each number by itself being allowed."""
        long = display(self.length, "length")
        if abs(self.lift) >= self.length:
            given = display(self.lift, "length")
            yield Problem(key="lift", value=given, message=f"must be less than the length {long}")
        if self.take_up_distance > self.length:
            given = display(self.take_up_distance, "length")
            message = f"must be at most the length {long}"
            yield Problem(key="take_up_distance", value=given, message=message)
        stated = self.secondary_resistance is not None or self.length_coefficient is not None
        if not stated and not self.itemised:
            yield from no_coefficient(self.length)
        yield from flight_misfits(self)

    def states(self) -> tuple[State, ...]:
        """Return the load cases: full and empty, starting and stopping where they are told.

        Raises
        ------
        InputError
            If a belt tension comes out as zero or less, or a conveyor that runs by itself is to
            start with a factor.
        """
        states = self.reckoned()
        raise_all(self.unfit(states))
        return tuple(states)

    def reckoned(self) -> list[State]:
        """Return the load cases, whatever tensions they leave."""
        return course_states(self)

    def unfit(self, states: Sequence[State]) -> list[Problem]:
        """Return what keeps the belt from running so."""
        problems = []
        if self.start_factor is not None and states[0].pull <= 0.0:
            message = "no factor starts a conveyor that runs by itself"
            remedy = 'Write start_time = "20 s" instead.'
            problems.append(Problem(key="start_factor", message=message, remedy=remedy))
        for state in states:
            slack = state.slack_problem()
            problems += [] if slack is None else [slack]
        return problems
