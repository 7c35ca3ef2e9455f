"""What a load case of a conveyor comes to: resistances, and the belt tension at every point."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from wraparc.alike import least
from wraparc.conveyor.resistance import Resistance
from wraparc.errors import Problem
from wraparc.units import display

#: The strands of the belt, in the order in which it travels from the tail pulley on.
CARRY, RETURN = "carry", "return"
STRANDS = (CARRY, RETURN)
#: Stretches of a conveyor of one flight: it, and both ends.
ONE_FLIGHT = 3


@dataclass(frozen=True)
class BeltPoint:
    """A point of the belt, in belt order from the tail pulley on.

    Attributes
    ----------
    strand, position
        ``carry`` from the tail or ``return`` from the head, and how far along it [m].
    name, kind
        What stands there: a flight that begins, a drive, the take-up, a loading point.
    before, after
        Belt tension on arrival and on leaving [N]; they differ where a force acts at the point.
    """

    strand: str
    position: float
    name: str
    kind: str
    before: float
    after: float


@dataclass(frozen=True)
class Stretch:
    """A flight on one strand, with the tension at its ends and what resists between them.

    Attributes
    ----------
    flight, strand
        Name of the flight, or ``head`` and ``tail`` for what stands at the ends of the conveyor.
    start, end, least
        Belt tension where the belt enters it and leaves it, and the lowest on it [N].
    forces
        What resists on it, by name [N].
    driven
        Sum of the effective tensions of the drives on it [N].
    mass
        Mean mass of belt and material per length [kg/m].
    """

    flight: str
    strand: str
    start: float
    end: float
    least: float
    forces: Mapping[str, float]
    driven: float
    mass: float

    @property
    def resistance(self) -> float:
        """Sum of its resistances [N]."""
        return sum(self.forces.values())


@dataclass(frozen=True)
class DrivePull:
    """What one drive does in a load case.

    Attributes
    ----------
    pulley, share
        Its pulley, and its part of the effective tension of all [-].
    entry, exit
        Belt tension where the belt meets and leaves it [N].
    """

    pulley: str
    share: float
    entry: float
    exit: float


@dataclass(frozen=True)
class Standstill:
    """What pulls a belt that stands, without its motors.

    Attributes
    ----------
    slope
        Pull of gravity along the belt, against its travel where positive [N].
    friction
        Main resistance of the running belt [N].
    """

    slope: float
    friction: float

    def holding(self, share: float) -> float:
        """Return the force that keeps it at rest when a share of the friction does its part [N].

        Positive against running back, a holdback; negative against running away, a brake.
        """
        rest = abs(self.slope) - share * self.friction
        return 0.0 if rest <= 0.0 else rest if self.slope > 0.0 else -rest


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
        Belt tension where the belt meets and leaves the drive pulley, T1 and T2 [N]; of several
        where it meets the first and leaves the last.
    acceleration
        Of the belt [m/s2].
    points, stretches, drives, standstill
        Every point, every flight, every drive, and what pulls at rest; empty and None of a
        conveyor without flights.
    """

    name: str
    kind: str
    resistances: tuple[Resistance, ...]
    head: float
    tail: float
    entry: float
    exit: float
    acceleration: float = 0.0
    points: tuple[BeltPoint, ...] = ()
    stretches: tuple[Stretch, ...] = ()
    drives: tuple[DrivePull, ...] = ()
    standstill: Standstill | None = field(default=None)

    @property
    def pull(self) -> float:
        """Sum of all resistances, T1 - T2 [N]; negative where the drive holds back."""
        return sum(resistance.total for resistance in self.resistances)

    @property
    def lowest(self) -> float:
        """Lowest belt tension of the load case [N]."""
        ends = (self.head, self.tail, self.entry, self.exit)
        return min((*ends, *(min(p.before, p.after) for p in self.points)))

    @property
    def highest(self) -> float:
        """Highest belt tension of the load case [N]."""
        ends = (self.head, self.tail, self.entry, self.exit)
        return max((*ends, *(max(p.before, p.after) for p in self.points)))

    def slack_problem(self) -> Problem | None:
        """Return the problem of a load case in which the belt is pushed, None where it is not."""
        lowest = self.lowest
        if lowest > 0.0:
            return None
        where = "at the drive pulley" if lowest in (self.entry, self.exit) else "at the far end"
        if len({stretch.flight for stretch in self.stretches}) > ONE_FLIGHT:
            spot = least(self.points, lambda p: min(p.before, p.after))
            where = f"at {spot.name} ({spot.strand})"
        message = f"leaves {display(lowest, 'force')} {where} in load case {self.name}"
        remedy = "Give a larger take-up tension."
        return Problem(key="take_up_tension", message=message, remedy=remedy)
