"""What a conveyor is built of: flights, loading points, drives, and load cases made of them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from wraparc.errors import Problem, shown
from wraparc.schema.limits import Limit, limit_problems, name_problems, raise_all
from wraparc.units import display

#: Where a drive or a pulley stands; the strands need a position.
HEAD, TAIL, CARRY, RETURN = "head", "tail", "carry", "return"
PLACES = (HEAD, TAIL, CARRY, RETURN)
#: Words for the flights that a load case loads.
ALL, NONE, INCLINES, DECLINES = "all", "none", "inclines", "declines"
LOADED_WORDS = (ALL, NONE, INCLINES, DECLINES)
#: By how much lift and slope may differ: what an angle printed to 0.1 deg leaves open [-].
SLOPE_ROUNDING = 0.00175
_LENGTH = Limit("length", open=True, most=1e5)
_MASS = Limit("mass_per_length", open=True, most=10_000.0)
_ROTATING = Limit("mass_per_length", most=10_000.0)
_SPACING = Limit("length", open=True, most=100.0)
_POSITION = Limit("length", most=1e5)
_FRICTION = Limit("number", open=True, most=2.0)


@dataclass(frozen=True, kw_only=True)
class Flight:
    """A length of conveyor with one slope, from the tail to the head.

    Parameters
    ----------
    name
        What load cases call it.
    length
        Along the belt [m].
    lift, slope
        From its beginning to its end, negative downhill [m], or its angle to the horizontal
        [rad]; level if neither is given, and both must agree.
    curve_radius
        Radius of the vertical curve from the flight before [m].
    friction_factor, carry_idler_mass, return_idler_mass, carry_spacing, return_spacing
        As of the conveyor, where they differ on this flight.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "length": _LENGTH,
        "lift": Limit("length", least=-5e3, most=5e3),
        "slope": Limit("angle", least=-1.0, most=1.0),
        "curve_radius": Limit("length", open=True, most=1e6),
        "friction_factor": Limit("number", least=0.005, most=0.1),
        "carry_idler_mass": _ROTATING,
        "return_idler_mass": _ROTATING,
        "carry_spacing": _SPACING,
        "return_spacing": _SPACING,
    }

    name: str
    length: float
    lift: float | None = None
    slope: float | None = None
    curve_radius: float | None = None
    friction_factor: float | None = None
    carry_idler_mass: float | None = None
    return_idler_mass: float | None = None
    carry_spacing: float | None = None
    return_spacing: float | None = None

    def __post_init__(self) -> None:
        raise_all(name_problems("name", self.name) + limit_problems(self, self.LIMITS))

    def misfits(self) -> list[Problem]:
        """Return what does not fit together: too steep, lift and slope that contradict."""
        if abs(self.rise) >= self.length:
            given, long = display(self.rise, "length"), display(self.length, "length")
            message = f"must be less than the length {long}"
            return [Problem(key="lift", value=given, message=message)]
        if self.lift is None or self.slope is None:
            return []
        steep = self.length * math.sin(self.slope)
        room = max(0.01 * abs(steep), SLOPE_ROUNDING * self.length)
        if abs(self.lift - steep) <= room:
            return []
        message = f"contradicts lift {display(self.lift, 'length')}, it makes "
        message += display(steep, "length")
        remedy = "Correct one of them, or leave it out."
        given = display(self.slope, "angle")
        return [Problem(key="slope", value=given, message=message, remedy=remedy)]

    @property
    def rise(self) -> float:
        """Lift from its beginning to its end [m]."""
        if self.lift is not None:
            return self.lift
        return 0.0 if self.slope is None else self.length * math.sin(self.slope)

    @property
    def sine(self) -> float:
        """Sine of its angle to the horizontal [-]."""
        return self.rise / self.length

    @property
    def cosine(self) -> float:
        """Cosine of its angle to the horizontal [-]."""
        return math.sqrt(1.0 - self.sine**2)


@dataclass(frozen=True, kw_only=True)
class LoadingPoint:
    """Where material comes onto the belt.

    Parameters
    ----------
    name
        What it is called.
    flight, position
        At the beginning of a flight, or so far from the tail [m]; the tail if neither is given.
    capacity, material_mass
        Mass flow [kg/s], or mass per length of belt behind it [kg/m], of this point alone.
    material_speed
        Speed of the material along the belt as it lands [m/s].
    skirt_width
        Width between the skirts [m]; without it they do not rub.
    acceleration_length
        Length over which the material takes up the belt speed [m]; the least one,
        ``(v^2 - v0^2)/(2 g mu1)``, unless given.
    belt_friction, skirt_friction
        Of the material on belt and skirts, mu1 and mu2 [-].
    density
        Bulk density of the material [kg/m3].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "capacity": Limit("mass_flow", open=True, most=1e5),
        "material_mass": _MASS,
        "material_speed": Limit("speed", most=20.0),
        "skirt_width": Limit("length", open=True, most=10.0),
        "acceleration_length": _SPACING,
        "belt_friction": _FRICTION,
        "skirt_friction": _FRICTION,
        "density": Limit("density", open=True, most=20_000.0),
    }

    name: str
    flight: str = ""
    position: float | None = None
    capacity: float | None = None
    material_mass: float | None = None
    material_speed: float = 0.0
    skirt_width: float | None = None
    acceleration_length: float | None = None
    belt_friction: float = 0.5
    skirt_friction: float = 0.7
    density: float | None = None

    def __post_init__(self) -> None:
        problems = name_problems("name", self.name) + limit_problems(self, self.LIMITS)
        if self.flight and self.position is not None:
            message, remedy = "contradicts flight", "Leave one of them out."
            given = display(self.position, "length")
            problems.append(Problem(key="position", value=given, message=message, remedy=remedy))
        if self.capacity is not None and self.material_mass is not None:
            message = "means the same as capacity"
            remedy = "Leave one of them out."
            problems.append(Problem(key="material_mass", message=message, remedy=remedy))
        if self.capacity is None and self.material_mass is None:
            remedy = 'Write capacity = "1000 t/h", or material_mass.'
            problem = Problem(key="capacity", message="missing", remedy=remedy, code="missing")
            problems.append(problem)
        if self.skirt_width is not None and self.density is None:
            remedy = 'Write density = "1600 kg/m3".'
            problem = Problem(key="density", message="missing", remedy=remedy, code="missing")
            problems.append(problem)
        raise_all(problems)


@dataclass(frozen=True, kw_only=True)
class DrivePlace:
    """Where one drive of a conveyor stands.

    Parameters
    ----------
    pulley
        Name of its pulley.
    at, position
        ``head``, ``tail``, or on a strand so far along it: ``carry`` from the tail, ``return``
        from the head [m].
    brake_share
        Part of the effective tension of a braking load case [-]; that of running unless given.
    share
        Part of the effective tension of all drives otherwise [-], which the train says.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "brake_share": Limit("number", least=-10.0, most=10.0),
    }

    pulley: str
    at: str = HEAD
    position: float | None = None
    brake_share: float | None = None
    share: float = 1.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS) + place_problems(self.at, self.position))


def place_problems(at: str, position: float | None) -> list[Problem]:
    """Return what is wrong with a place: no such one, a position that is missing or too many."""
    if at not in PLACES:
        message = f"must be one of {', '.join(PLACES)}"
        return [Problem(key="at", value=shown(at), message=message)]
    on_strand = at in (CARRY, RETURN)
    if on_strand and position is None:
        end = "tail" if at == CARRY else "head"
        remedy = f'Write position = "120 m" from the {end}.'
        return [Problem(key="position", message="missing", remedy=remedy, code="missing")]
    if position is not None and not on_strand:
        message = f'goes with "carry" or "return", not {at}'
        given = display(position, "length")
        return [Problem(key="position", value=given, message=message, remedy="Leave it out.")]
    return []


@dataclass(frozen=True, kw_only=True)
class ConveyorCase:
    """A load case of a conveyor, made of its flights.

    Parameters
    ----------
    name
        What it is called.
    loaded
        ``all``, ``none``, ``inclines``, ``declines``, or the names of the flights with material.
    factor
        Material on a flight over that of the full belt, by flight; 1 where nothing is said.
    kind
        ``running``, ``starting`` or ``braking``.
    """

    name: str
    loaded: str | tuple[str, ...] = ALL
    factor: Mapping[str, float] = field(default_factory=dict)
    kind: str = "running"

    def __post_init__(self) -> None:
        raise_all(name_problems("name", self.name))

    def factor_of(self, flight: Flight) -> float:
        """Return the material on a flight over that of the full belt [-]."""
        return self.factor.get(flight.name, 1.0) if self.loads(flight) else 0.0

    def loads(self, flight: Flight) -> bool:
        """Return whether a flight has material on it."""
        if self.loaded == INCLINES:
            return flight.rise > 0.0
        if self.loaded == DECLINES:
            return flight.rise < 0.0
        if self.loaded in (ALL, NONE):
            return self.loaded == ALL
        return flight.name in self.loaded
