"""Secondary and special resistances by themselves, as ISO 5048 and DIN 22101 itemise them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from wraparc.conveyor.flight import HEAD, LoadingPoint, place_problems
from wraparc.conveyor.resistance import GRAVITY
from wraparc.errors import Problem, shown
from wraparc.schema.limits import Limit, limit_problems, raise_all

#: Where the formulas stand.
OF_LOADING = "ISO 5048:1989; DIN 22101:2002-08, 6.3.2: I_m (v - v0), and the skirts beside it"
OF_WRAP = (
    "ISO 5048:1989: 9 B (140 + 0.01 F/B) d/D of fabric belts, 12 B (200 + 0.01 F/B) d/D of "
    "steel-cord belts"
)
OF_BEARING = "ISO 5048:1989: 0.005 F_T d0/D, at pulleys that are not driven"
OF_CLEANER = "ISO 5048:1989: A p mu3"
OF_SKIRT = "ISO 5048:1989: mu2 I_V^2 rho g l/(v^2 b1^2)"
OF_TILT = "ISO 5048:1989: C_eps mu0 L (m'G + m'L) g cos delta sin eps"
_POSITION = Limit("length", most=1e5)
_SIZE = Limit("length", open=True, most=10.0)
_FRICTION = Limit("number", open=True, most=2.0)


@dataclass(frozen=True, kw_only=True)
class PulleyResistance:
    """What one or several alike pulleys take: the belt that bends, and their bearings.

    Parameters
    ----------
    at, position
        Where it stands, see `DrivePlace`.
    diameter
        Of the pulley D [m].
    shaft_diameter
        Of the shaft in its bearings d0 [m]; 0 for a drive pulley, whose bearings are the motor's.
    wrap_angle
        Angle over which the belt lies on it [rad].
    mass
        Of the pulley [kg].
    count
        So many of them.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "diameter": _SIZE,
        "shaft_diameter": Limit("length", most=2.0),
        "wrap_angle": Limit("angle", open=True, most=2.0 * math.pi),
        "mass": Limit("mass", most=1e5),
    }

    at: str = HEAD
    position: float | None = None
    diameter: float
    shaft_diameter: float = 0.0
    wrap_angle: float = math.pi
    mass: float = 0.0
    count: int = 1

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS) + place_problems(self.at, self.position))

    def wrap(self, tension: float, width: float, thickness: float, *, steel: bool) -> float:
        """Return the resistance of the belt that bends about it [N].

        Parameters
        ----------
        tension
            Mean tension of the belt at the pulley F [N].
        width, thickness
            Of the belt, B and d [m].
        steel
            Whether the belt has steel cords.
        """
        first, constant = (12.0, 200.0) if steel else (9.0, 140.0)
        one = first * width * (constant + 0.01 * tension / width) * thickness / self.diameter
        return self.count * one

    def bearing(self, tension: float) -> float:
        """Return the resistance of its bearings [N]; `tension` as of `wrap`."""
        load = math.hypot(2.0 * tension * math.sin(0.5 * self.wrap_angle), self.mass * GRAVITY)
        return self.count * 0.005 * load * self.shaft_diameter / self.diameter


@dataclass(frozen=True, kw_only=True)
class CleanerResistance:
    """What one or several alike cleaners take, A p mu3.

    Parameters
    ----------
    at, position
        Where it stands, see `DrivePlace`.
    width, thickness
        Of the blade on the belt [m].
    pressure
        Between blade and belt [Pa]; 30 to 100 kPa by ISO 5048.
    friction
        Of blade and belt mu3 [-].
    count
        So many of them.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "width": _SIZE,
        "thickness": _SIZE,
        "pressure": Limit("pressure", open=True, most=1e6),
        "friction": _FRICTION,
    }

    at: str = HEAD
    position: float | None = None
    width: float
    thickness: float
    pressure: float
    friction: float = 0.6
    count: int = 1

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS) + place_problems(self.at, self.position))

    @property
    def force(self) -> float:
        """What it takes [N]."""
        return self.count * self.width * self.thickness * self.pressure * self.friction


@dataclass(frozen=True, kw_only=True)
class SkirtResistance:
    """What skirts beside the moving material take.

    Parameters
    ----------
    position
        From the tail to where they begin [m].
    length, width
        Their length l, and the width between them b1 [m].
    density
        Bulk density of the material [kg/m3].
    friction
        Of material and skirts mu2 [-].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "length": Limit("length", open=True, most=1e4),
        "width": _SIZE,
        "density": Limit("density", open=True, most=20_000.0),
        "friction": _FRICTION,
    }

    position: float = 0.0
    length: float
    width: float
    density: float
    friction: float = 0.7

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    def force(self, material: float) -> float:
        """Return what they take of a material per length [kg/m] on the belt [N].

        ``mu2 I_V^2 rho g l/(v^2 b1^2)`` with the volume flow ``I_V = m' v/rho``.
        """
        squared = material * material / (self.density * self.width**2)
        return self.friction * squared * GRAVITY * self.length


@dataclass(frozen=True, kw_only=True)
class TiltResistance:
    """What idlers that toe in take.

    Parameters
    ----------
    strand
        ``carry`` or ``return``.
    angle
        By which they stand forward, eps [rad].
    trough_coefficient
        C_eps of the trough [-], 0.4 of 30 deg and 0.5 of 45 deg; on a return strand the cosine
        of its trough angle.
    friction
        Of idlers and belt mu0 [-].
    length
        Of the conveyor that has such idlers, evenly spread over it [m]; all of it unless given.
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "angle": Limit("angle", open=True, most=0.2),
        "trough_coefficient": Limit("number", open=True, most=1.0),
        "friction": _FRICTION,
        "length": Limit("length", open=True, most=1e5),
    }

    strand: str = "carry"
    angle: float
    trough_coefficient: float = 0.4
    friction: float = 0.3
    length: float | None = None

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if self.strand not in ("carry", "return"):
            message = "must be one of carry, return"
            problems.append(Problem(key="strand", value=shown(self.strand), message=message))
        raise_all(problems)

    def per_weight(self, whole: float) -> float:
        """Return what it takes over the weight across the belt, of a conveyor of a length [-]."""
        part = 1.0 if self.length is None else min(1.0, self.length / whole)
        return self.trough_coefficient * self.friction * math.sin(self.angle) * part


@dataclass(frozen=True, kw_only=True)
class PointResistance:
    """A force on the belt at one place: a plough, a tripper, a washing station.

    Parameters
    ----------
    at, position
        Where it acts, see `DrivePlace`.
    force
        How large it is [N].
    """

    LIMITS: ClassVar[Mapping[str, Limit]] = {
        "position": _POSITION,
        "force": Limit("force", open=True, most=1e8),
    }

    at: str = HEAD
    position: float | None = None
    force: float

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS) + place_problems(self.at, self.position))


Local = PulleyResistance | CleanerResistance | SkirtResistance | TiltResistance | PointResistance


def loading_force(point: LoadingPoint, flow: float, speed: float) -> float:
    """Return what it takes to bring the material to the speed of the belt [N].

    ``I_m (v - v0)``, and beside skirts ``mu2 I_V^2 rho g l_b/(((v + v0)/2)^2 b1^2)``.

    Parameters
    ----------
    point
        The loading point.
    flow
        Its mass flow in the load case [kg/s].
    speed
        Of the belt [m/s].
    """
    landing = point.material_speed
    force = flow * (speed - landing)
    if point.skirt_width is None or point.density is None:
        return force
    long = point.acceleration_length
    if long is None:
        long = abs(speed**2 - landing**2) / (2.0 * GRAVITY * point.belt_friction)
    mean = 0.5 * (speed + landing)
    rubbing = flow * flow / point.density * GRAVITY * long / (mean * point.skirt_width) ** 2
    return force + point.skirt_friction * rubbing
