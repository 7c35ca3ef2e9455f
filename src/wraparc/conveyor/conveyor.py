"""A conveyor with one drive pulley at its head or tail: resistances and tensions by load case."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import ClassVar

from wraparc.conveyor.resistance import (
    GIVEN,
    GRAVITY,
    INERTIA,
    MAIN,
    SECONDARY,
    SLOPE,
    Resistance,
    coefficient_at,
    inertia,
    main_resistance,
    no_coefficient,
    slope_resistance,
)
from wraparc.errors import Problem, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all
from wraparc.units import display

#: Where the drive pulley sits.
DRIVES_AT = ("head", "tail")
#: Friction factors f of conveyors that are driven [-] (DIN 22101:2002-08, 6.2.3; ISO 5048).
USUAL_FRICTION = (0.016, 0.030)
#: Of these masses the sizes below are those over the width of the belt [kg/m2].
OVER_WIDTH = ("belt_mass", "carry_idler_mass", "return_idler_mass")
#: Sizes that conveyors have, least and most, in the order of `Conveyor.sizes` [SI].
USUAL_CONVEYOR = (
    ("length", 3.0, 30e3),
    ("lift", -1500.0, 1500.0),
    ("belt_mass", 3.0, 100.0),
    ("carry_idler_mass", 2.0, 60.0),
    ("return_idler_mass", 0.7, 30.0),
    ("material_mass", 0.5, 4000.0),
    ("capacity", 0.1, 15e3),
    ("friction_factor", 0.01, 0.04),
    ("secondary_resistance", 10.0, 500e3),
    ("special_resistance", 10.0, 200e3),
    ("start_time", 1.0, 600.0),
    ("stop_time", 1.0, 600.0),
    ("take_up_tension", 300.0, 2e6),
    ("counterweight", 30.0, 200e3),
)
#: Steepest that a belt carries: lift over length [-]; a troughed belt slides its load at 0.35.
STEEPEST = 0.5
#: Least and most material per length over the square of the belt width: a trough of which the
#: thousandth part is filled, and a full one of ore [kg/m3].
EMPTIEST, FULLEST = 0.7, 700.0
_MASS = Limit("mass_per_length", open=True, most=10_000.0)
_FORCE = Limit("force", most=1e8)
_TIME = Limit("time", open=True, most=3600.0)
# Two ways to say one thing, and whether one of them is needed.
_EITHER = (
    ("material_mass", "capacity", 'material_mass = "120 kg/m"'),
    ("take_up_tension", "counterweight", 'take_up_tension = "40 kN"'),
    ("length_coefficient", "secondary_resistance", ""),
    ("start_factor", "start_time", ""),
)
_NEED_SPEED = ("capacity", "start_time", "stop_time")


@dataclass(frozen=True)
class State:
    """One load case of a conveyor.

    Attributes
    ----------
    name, kind
        ``full``, ``empty``, ``start`` or ``stop``; ``running``, ``starting`` or ``braking``.
    resistances
        What resists, by name.
    tail, head
        Belt tension beside the pulleys: where the return strand meets the tail and where it
        leaves the head, for a drive at the other end [N].
    entry, exit
        Belt tension where the belt meets and leaves the drive pulley, T1 and T2 [N].
    """

    name: str
    kind: str
    resistances: tuple[Resistance, ...]
    head: float
    tail: float
    entry: float
    exit: float

    @property
    def pull(self) -> float:
        """Sum of all resistances, T1 - T2 [N]; negative where the drive holds back."""
        return sum(resistance.total for resistance in self.resistances)


@dataclass(frozen=True, kw_only=True)
class Conveyor:
    """A conveyor of one slope, told by what DIN 22101 and ISO 5048 need.

    Parameters
    ----------
    length
        Conveying length L from the centre of the head to that of the tail pulley [m].
    lift
        Lift H from tail to head, negative downhill [m].
    belt_mass
        Mass of the belt m'_G [kg/m].
    carry_idler_mass, return_idler_mass
        Rotating mass of the idlers per length of strand m'_R [kg/m].
    material_mass
        Mass of the material m'_L on the full belt [kg/m]; or by `capacity`.
    capacity
        Mass flow of the full belt [kg/s]; over `speed` it is the material mass.
    friction_factor
        Artificial friction factor f, 0.016 to 0.030, and less where a downhill conveyor has to
        be held back [-].
    length_coefficient
        Coefficient C that stands for the secondary resistances [-]; by `length` if left out.
    secondary_resistance
        Secondary resistances F_N instead of C [N], on the empty conveyor the same.
    special_resistance
        Special resistances F_S, as of skirts and scrapers [N].
    return_share
        Part of secondary and special resistances on the return strand [-]. The standards give
        only their sum; most of it is where the material is fed.
    start_factor
        Pull at the drive while starting over that of the full conveyor [-]; or `start_time`.
    start_time, stop_time
        From rest to full speed and back at constant acceleration [s]; no such case without them.
    take_up_tension
        Belt tension that the take-up holds [N]; or by `counterweight`.
    counterweight
        Mass of the counterweight [kg]; g times it over `sheave_ratio` is the belt tension.
    take_up_distance
        From the head to the take-up along the return strand [m]; `length` is the tail.
    drive_at
        ``head`` or ``tail``.
    speed
        Belt speed [m/s].
    sheave_ratio
        Pull of the counterweight over the belt tension at the take-up [-].

    Raises
    ------
    InputError
        With every number outside its limit, with what is missing and what is said twice.

    References
    ----------
    DIN 22101:2002-08, Continuous conveyors: belt conveyors for loose bulk materials, section 6;
    ISO 5048:1989, Belt conveyors with carrying idlers.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "length": Limit("length", open=True, most=1e5),
        "lift": Limit("length", least=-5e3, most=5e3),
        "belt_mass": _MASS,
        "carry_idler_mass": Limit("mass_per_length", most=10_000.0),
        "return_idler_mass": Limit("mass_per_length", most=10_000.0),
        "material_mass": _MASS,
        "capacity": Limit("mass_flow", open=True, most=1e5),
        "friction_factor": Limit("number", least=0.005, most=0.1),
        "length_coefficient": Limit("number", least=1.0, most=10.0),
        "secondary_resistance": _FORCE,
        "special_resistance": _FORCE,
        "return_share": Limit("number", most=1.0),
        "start_factor": Limit("number", least=1.0, most=5.0),
        "start_time": _TIME,
        "stop_time": _TIME,
        "take_up_tension": Limit("force", open=True, most=1e8),
        "counterweight": Limit("mass", open=True, most=1e7),
        "take_up_distance": Limit("length", most=1e5),
        "speed": Limit("speed", open=True),
        "sheave_ratio": Limit("number", least=0.01, most=100.0),
    }

    length: float
    lift: float = 0.0
    belt_mass: float
    carry_idler_mass: float
    return_idler_mass: float
    material_mass: float | None = None
    capacity: float | None = None
    friction_factor: float = 0.02
    length_coefficient: float | None = None
    secondary_resistance: float | None = None
    special_resistance: float = 0.0
    return_share: float = 0.0
    start_factor: float | None = None
    start_time: float | None = None
    stop_time: float | None = None
    take_up_tension: float | None = None
    counterweight: float | None = None
    take_up_distance: float = 0.0
    drive_at: str = "head"
    speed: float | None = None
    sheave_ratio: float = 2.0

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        problems += choices({key for key in self.LIMITS if getattr(self, key) is not None})
        if self.drive_at not in DRIVES_AT:
            message = f"must be one of {', '.join(DRIVES_AT)}"
            problems.append(Problem(key="drive_at", value=shown(self.drive_at), message=message))
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
        if self.secondary_resistance is None and self.length_coefficient is None:
            yield from no_coefficient(self.length)

    @property
    def material(self) -> float:
        """Mass of the material on the full belt m'_L [kg/m]."""
        if self.material_mass is not None:
            return self.material_mass
        # both are there, or it was refused
        return _known(self.capacity, 0.0) / _known(self.speed, 1.0)

    def sizes(self) -> list[float]:
        """Return what is given, in the order of `USUAL_CONVEYOR`; nan for what is not [SI]."""
        return [
            self.length,
            self.lift,
            self.belt_mass,
            self.carry_idler_mass,
            self.return_idler_mass,
            _known(self.material_mass, nan),
            _known(self.capacity, nan),
            self.friction_factor,
            _known(self.secondary_resistance, nan),
            nan if self.special_resistance == 0.0 else self.special_resistance,
            _known(self.start_time, nan),
            _known(self.stop_time, nan),
            _known(self.take_up_tension, nan),
            _known(self.counterweight, nan),
        ]

    @property
    def take_up(self) -> float:
        """Belt tension at the take-up [N]."""
        if self.take_up_tension is not None:
            return self.take_up_tension
        return _known(self.counterweight, 0.0) * GRAVITY / self.sheave_ratio

    @property
    def coefficient(self) -> float | None:
        """Coefficient C [-], or None where the secondary resistances are given."""
        if self.secondary_resistance is not None:
            return None
        return _known(self.length_coefficient, coefficient_at(self.length))

    @property
    def _unusual(self) -> str:
        least, most = USUAL_FRICTION
        if least <= self.friction_factor <= most:
            return ""
        return f", outside the usual {least:.3f} to {most:.3f}"

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
        full = self._state("full", "running", self.material, 0.0)
        states = [full, self._state("empty", "running", 0.0, 0.0)]
        for name, kind, acceleration in self._changes(full.pull):
            states.append(self._state(name, kind, self.material, acceleration))
        return states

    def unfit(self, states: Sequence[State]) -> list[Problem]:
        """Return what keeps the belt from running so."""
        problems = []
        if self.start_factor is not None and states[0].pull <= 0.0:
            message = "no factor starts a conveyor that runs by itself"
            remedy = 'Write start_time = "20 s" instead.'
            problems.append(Problem(key="start_factor", message=message, remedy=remedy))
        for state in states:
            least = min(state.head, state.tail, state.entry, state.exit)
            if least <= 0.0:
                problems.append(_slack(state, least))
        return problems

    def _changes(self, pull: float) -> Iterator[tuple[str, str, float]]:
        """Yield starting and stopping with their accelerations [m/s2]."""
        if self.start_factor is not None:
            moving = self._moving(self.material) + self._moving(None)
            yield "start", "starting", (self.start_factor - 1.0) * pull / (self.length * moving)
        if self.start_time is not None and self.speed is not None:
            yield "start", "starting", self.speed / self.start_time
        if self.stop_time is not None and self.speed is not None:
            yield "stop", "braking", -self.speed / self.stop_time

    def _moving(self, material: float | None) -> float:
        """Return the mass that moves with a strand, the return strand for None [kg/m]."""
        if material is None:
            return self.return_idler_mass + self.belt_mass
        return self.carry_idler_mass + self.belt_mass + material

    def _state(self, name: str, kind: str, material: float, acceleration: float) -> State:
        resistances = tuple(self._resistances(material, acceleration))
        carrying = sum(r.carrying for r in resistances)
        returning = sum(r.returning for r in resistances)
        head = self.take_up - returning * self.take_up_distance / self.length
        tail = head + returning
        at_head = self.drive_at == "head"
        entry = tail + carrying if at_head else tail
        leaving = head if at_head else head - carrying
        return State(name, kind, resistances, head, tail, entry, leaving)

    def _resistances(self, material: float, acceleration: float) -> Iterator[Resistance]:
        belt, loaded, share = self.belt_mass, self.belt_mass + material, self.return_share
        factor, length, lift = self.friction_factor, self.length, self.lift
        main = Resistance(
            "main",
            main_resistance(factor, length, lift, self.carry_idler_mass, loaded),
            main_resistance(factor, length, lift, self.return_idler_mass, belt),
            f"{MAIN}, f = {self.friction_factor:g}{self._unusual}",
        )
        yield main
        secondary, source = self.secondary_resistance, GIVEN
        if secondary is None:
            coefficient = _known(self.coefficient, 1.0)
            secondary = (coefficient - 1.0) * main.total
            source = f"{SECONDARY}, C = {coefficient:.3g}"
            source += "" if self.length_coefficient is None else " (input)"
        yield Resistance("secondary", (1.0 - share) * secondary, share * secondary, source)
        up, down = slope_resistance(self.lift, loaded), -slope_resistance(self.lift, belt)
        yield Resistance("slope", up, down, SLOPE)
        special = self.special_resistance
        yield Resistance("special", (1.0 - share) * special, share * special, GIVEN)
        carrying = inertia(acceleration, self.length, self._moving(material))
        returning = inertia(acceleration, self.length, self._moving(None))
        yield Resistance("inertia", carrying, returning, INERTIA)


def _known(value: float | None, other: float) -> float:
    return other if value is None else value


def choices(given: Collection[str]) -> list[Problem]:
    """Return what is said twice or not at all, and what needs the belt speed.

    Parameters
    ----------
    given
        Names of the fields that are given, `speed` among them.
    """
    problems = []
    for first, second, example in _EITHER:
        if first in given and second in given:
            message = f"means the same as {first}"
            problems.append(Problem(key=second, message=message, remedy="Leave one of them out."))
        elif example != "" and first not in given and second not in given:
            remedy = f"Write {example}, or {second}."
            problems.append(Problem(key=first, message="missing", remedy=remedy, code="missing"))
    for key in _NEED_SPEED:
        if key in given and "speed" not in given:
            remedy = 'Write speed = "3 m/s" in [belt].'
            problems.append(Problem(key=key, message="needs the belt speed", remedy=remedy))
    return problems


def _slack(state: State, least: float) -> Problem:
    """Return the problem of a load case in which the belt is pushed."""
    where = "at the drive pulley" if least in (state.entry, state.exit) else "at the far end"
    message = f"leaves {display(least, 'force')} {where} in load case {state.name}"
    remedy = "Give a larger take-up tension."
    return Problem(key="take_up_tension", message=message, remedy=remedy)
