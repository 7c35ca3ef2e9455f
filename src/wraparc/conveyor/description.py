"""A conveyor as it is described: lengths, masses, flights, drives, the take-up."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import nan
from typing import ClassVar

from wraparc.conveyor.extras import Cema, Travel
from wraparc.conveyor.flight import (
    CARRY,
    HEAD,
    TAIL,
    ConveyorCase,
    DrivePlace,
    Flight,
    LoadingPoint,
)
from wraparc.conveyor.local import Local
from wraparc.conveyor.resistance import GRAVITY, coefficient_at
from wraparc.schema.limits import Limit

#: What the only flight of a conveyor without flights is called.
WHOLE = "conveyor"
#: Friction factors f of conveyors that are driven [-] (DIN 22101:2002-08, 6.2.3; ISO 5048).
USUAL_FRICTION = (0.016, 0.030)
#: Numbers that have an uncertainty.
UNCERTAIN = (
    "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance",
    "material_mass", "capacity", "belt_mass", "carry_idler_mass", "return_idler_mass", "lift",
    "start_factor", "take_up_tension", "counterweight",
)  # fmt: skip
_MASS = Limit("mass_per_length", open=True, most=10_000.0)
_FORCE = Limit("force", most=1e8)
_SPACING = Limit("length", open=True, most=100.0)
_TIME = Limit("time", open=True, most=3600.0)


@dataclass(frozen=True, kw_only=True)
class ConveyorData:
    """What a conveyor is described by: what DIN 22101 and ISO 5048 need.

    Without flights it has one slope and one drive pulley at its head or tail.

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
    flights
        The flights from the tail to the head; length and lift are then their sums.
    loadings
        Where material comes onto the belt, instead of `material_mass` or `capacity` at the tail.
    cases
        Load cases of its own, besides full, empty, start and stop.
    drives
        Where each drive pulley stands, in belt order, and what part of the pull it has.
    locals
        Secondary and special resistances by themselves, instead of C.
    take_up_after
        Pulley right behind which the take-up stands, instead of `take_up_distance`.
    carry_spacing, return_spacing
        Distance of the idlers of both strands [m]; without it no sag is told.
    sag_limit
        Largest sag over the spacing of the idlers [-].
    rest_friction
        Part of the running main resistance that helps to hold the belt at rest [-].
    width, thickness, steel
        Width and thickness of the belt [m], and whether it has steel cords: what its bending
        about pulleys takes.
    travel
        What the travel of the take-up is made of, or None.
    cema
        What the pull by CEMA needs, or None.
    uncertainty
        How far single numbers may be off either way (95 %), by key: `UNCERTAIN` [-].

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
        "carry_spacing": _SPACING,
        "return_spacing": _SPACING,
        "sag_limit": Limit("number", open=True, most=0.1),
        "rest_friction": Limit("number", most=1.0),
        "width": Limit("length", open=True, most=10.0),
        "thickness": Limit("length", open=True, most=0.2),
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
    flights: tuple[Flight, ...] = ()
    loadings: tuple[LoadingPoint, ...] = ()
    cases: tuple[ConveyorCase, ...] = ()
    drives: tuple[DrivePlace, ...] = ()
    locals: tuple[Local, ...] = ()
    take_up_after: str = ""
    carry_spacing: float | None = None
    return_spacing: float | None = None
    sag_limit: float = 0.01
    rest_friction: float = 0.5
    width: float | None = None
    thickness: float | None = None
    steel: bool = False
    travel: Travel | None = None
    cema: Cema | None = None
    uncertainty: Mapping[str, float] = field(default_factory=dict, hash=False)

    @property
    def material(self) -> float:
        """Mass of the material on the full belt m'_L [kg/m], behind the last loading point."""
        if self.loadings:
            return sum(self.loading_mass(i) for i in range(len(self.loadings)))
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
    def weight(self) -> float:
        """Mass of the counterweight at the take-up [kg]."""
        return self.take_up * self.sheave_ratio / GRAVITY

    @property
    def coefficient(self) -> float | None:
        """Coefficient C [-], or None where the secondary resistances are given."""
        if self.secondary_resistance is not None or self.itemised:
            return None
        return _known(self.length_coefficient, coefficient_at(self.length))

    @property
    def itemised(self) -> bool:
        """Whether secondary resistances are given one by one."""
        return len(self.locals) > 0

    @property
    def course_flights(self) -> tuple[Flight, ...]:
        """Its flights; a conveyor of one slope is one."""
        return self.flights or (Flight(name=WHOLE, length=self.length, lift=self.lift),)

    @property
    def course_drives(self) -> tuple[DrivePlace, ...]:
        """Where its drives stand; one of which nothing is said at `drive_at`."""
        return self.drives or (DrivePlace(pulley="", at=self.drive_at),)

    @property
    def take_up_behind(self) -> str | None:
        """Pulley behind which the take-up stands between two drives, None outside of them."""
        if len(self.drives) < 2 or self.take_up_after == self.drives[-1].pulley:
            return None
        if self.take_up_after:
            return self.take_up_after
        whole = 2.0 * self.length
        first = self.along(self.drives[0])
        ways = [(self.along(drive) - first) % whole for drive in self.drives]
        at_tail = self.take_up_distance >= self.length * (1.0 - 1e-9)
        # at the tail it stands before its pulleys
        way = (self.length + self.take_up_distance - first - (1e-6 if at_tail else 0.0)) % whole
        passed = [drive.pulley for drive, at in zip(self.drives, ways, strict=True) if at <= way]
        return None if len(passed) == len(self.drives) else passed[-1]

    def along(self, drive: DrivePlace) -> float:
        """Return how far a drive is from the tail pulley in the direction of travel [m]."""
        if drive.at == HEAD:
            return self.length
        if drive.at == TAIL:
            return 2.0 * self.length
        position = _known(drive.position, 0.0)
        return position if drive.at == CARRY else self.length + position

    def loading_mass(self, index: int) -> float:
        """Return what one loading point adds to a metre of belt [kg/m]."""
        if not self.loadings:
            return self.material
        point = self.loadings[index]
        if point.material_mass is not None:
            return point.material_mass
        return _known(point.capacity, 0.0) / _known(self.speed, 1.0)

    def loading_positions(self) -> list[float]:
        """Return how far from the tail each loading point is [m]."""
        starts, now = {"": 0.0}, 0.0
        for flight in self.flights:
            starts[flight.name] = now
            now += flight.length
        if not self.loadings:
            return [0.0]
        return [
            starts.get(point.flight, 0.0) if point.position is None else point.position
            for point in self.loadings
        ]

    @property
    def unusual_friction(self) -> str:
        """What there is to say of a friction factor that is not usual."""
        least, most = USUAL_FRICTION
        if least <= self.friction_factor <= most:
            return ""
        return f", outside the usual {least:.3f} to {most:.3f}"


def _known(value: float | None, other: float) -> float:
    return other if value is None else value
