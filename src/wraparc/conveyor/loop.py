"""The belt of a conveyor as a loop: segments with one slope and load, and what acts at points."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from wraparc.conveyor.description import ConveyorData
from wraparc.conveyor.flight import HEAD, TAIL, ConveyorCase, Flight
from wraparc.conveyor.local import (
    CleanerResistance,
    PointResistance,
    PulleyResistance,
    SkirtResistance,
    TiltResistance,
    loading_force,
)
from wraparc.conveyor.resistance import (
    GRAVITY,
    main_resistance,
    slope_resistance,
)
from wraparc.conveyor.state import (
    CARRY,
    RETURN,
    STRANDS,
)

#: Names of the resistances, in the order in which they are shown.
MAIN_NAME, SECONDARY_NAME, SPECIAL_NAME = "main", "secondary", "special"
LOADING, WRAP, BEARING, CLEANER, SKIRT, TILT = (
    "loading", "wrap", "bearing", "cleaner", "skirt", "tilt",
)  # fmt: skip
SLOPE_NAME, INERTIA_NAME = "slope", "inertia"
#: Order of what stands at one place, and of a take-up on the return strand at the tail.
_PULLEY_RANK, _DRIVE_RANK, _TAKE_UP_RANK, _OTHER_RANK, _BEFORE_RANK = 0.0, 1.0, 2.0, 3.0, -1.0


class Spot(NamedTuple):
    """Something that acts on the belt at a point.

    Attributes
    ----------
    strand, position
        Where it is [m].
    rank, order
        Which of several at one place comes first.
    kind, which, name
        ``drive``, ``take-up``, ``loading`` or ``local``, which of its kind, and what it is called.
    """

    strand: str
    position: float
    rank: float
    order: int
    kind: str
    which: int
    name: str


@dataclass(frozen=True)
class Segment:
    """A length of belt with one slope and one load.

    Attributes
    ----------
    strand, flight
        Where it is.
    position, length, lift
        Where it begins on the strand, its length, and its lift in the direction of travel [m].
    carried, rotating
        Mass of belt and material, and of the idlers, per length [kg/m].
    forces
        What resists without acceleration, by name [N].
    """

    strand: str
    flight: Flight
    position: float
    length: float
    lift: float
    carried: float
    rotating: float
    forces: Mapping[str, float]

    @property
    def moving(self) -> float:
        """Mass that moves with it [kg]."""
        return self.length * (self.carried + self.rotating)


Step = Segment | Spot


def belt_steps(conveyor: ConveyorData, case: ConveyorCase) -> list[Step]:
    """Return segments and spots in belt order, from the tail pulley on."""
    spots = _spots(conveyor)
    steps: list[Step] = []
    for strand in STRANDS:
        own = [spot for spot in spots if spot.strand == strand]
        places = _places(conveyor, own, strand)
        for i, place in enumerate(places):
            here = [spot for spot in own if _nearest(places, spot.position) == i]
            ordered: list[Spot] = sorted(here, key=lambda s: (s.rank, s.order))
            steps += ordered
            if i + 1 < len(places):
                steps.append(_segment(conveyor, case, strand, place, places[i + 1]))
    return steps


def _nearest(places: Sequence[float], position: float) -> int:
    distances = [abs(place - position) for place in places]
    return distances.index(min(distances))


def _places(conveyor: ConveyorData, spots: Sequence[Spot], strand: str) -> list[float]:
    """Return where a segment ends, along a strand: at flights and spots; alike ones once."""
    flights = conveyor.course_flights
    inward = list(flights) if strand == CARRY else list(reversed(flights))
    lengths = [flight.length for flight in inward]
    edges = [0.0]
    for length in lengths:
        edges.append(edges[-1] + length)
    found = list(edges)
    for spot in spots:
        if min(abs(spot.position - place) for place in found) > 1e-9 * conveyor.length:
            found.append(spot.position)
    return sorted(found)


def _spots(conveyor: ConveyorData) -> list[Spot]:
    """Return everything that acts at a point."""
    long = conveyor.length
    spots: list[Spot] = []
    for i, position in enumerate(conveyor.loading_positions()):
        name = conveyor.loadings[i].name if conveyor.loadings else "loading"
        spots.append(Spot(CARRY, position, _OTHER_RANK, i, "loading", i, name))
    after = -1
    for i, drive in enumerate(conveyor.course_drives):
        strand, position = _where(drive.at, drive.position, long)
        spots.append(Spot(strand, position, _DRIVE_RANK, i, "drive", i, drive.pulley))
        if drive.pulley != "" and drive.pulley == conveyor.take_up_after:
            after = i
            spots.append(Spot(strand, position, _DRIVE_RANK, i, "take-up", 0, "take-up"))
    if after < 0:
        at_tail = conveyor.take_up_distance >= long * (1.0 - 1e-9)
        rank = _BEFORE_RANK if at_tail else _TAKE_UP_RANK
        place = (RETURN, conveyor.take_up_distance)
        spots.append(Spot(*place, rank, 0, "take-up", 0, "take-up"))
    for i, local in enumerate(conveyor.locals):
        if isinstance(local, SkirtResistance):
            spots.append(Spot(CARRY, local.position, _OTHER_RANK, i, "local", i, "skirts"))
        elif not isinstance(local, TiltResistance):
            strand, position = _where(local.at, local.position, long)
            pulley = isinstance(local, PulleyResistance)
            rank = _PULLEY_RANK if pulley else _OTHER_RANK
            if local.at == HEAD and not pulley:  # cleaners act behind the head pulley
                strand, position = RETURN, 0.0
            name = "pulley" if pulley else "cleaner"
            if isinstance(local, PointResistance):
                name = "resistance"
            spots.append(Spot(strand, position, rank, i, "local", i, name))
    return spots


def _where(at: str, position: float | None, length: float) -> tuple[str, float]:
    """Return strand and position of a place: the head ends the one, the tail the other [m]."""
    if at == HEAD:
        return CARRY, length
    if at == TAIL:
        return RETURN, length
    return at, position or 0.0


def _segment(
    conveyor: ConveyorData, case: ConveyorCase, strand: str, start: float, end: float
) -> Segment:
    """Return a length of belt between two places of a strand, with what resists on it."""
    length, whole, carries = end - start, conveyor.length, strand == CARRY
    middle = 0.5 * (start + end)
    from_tail = middle if carries else whole - middle
    flight = _flight_at(conveyor, from_tail)
    lift = flight.sine * length * (1.0 if carries else -1.0)
    material = _material_at(conveyor, case, from_tail) if carries else 0.0
    carried = conveyor.belt_mass + material
    rotating = conveyor.carry_idler_mass if carries else conveyor.return_idler_mass
    own = flight.carry_idler_mass if carries else flight.return_idler_mass
    rotating = rotating if own is None else own
    factor = flight.friction_factor or conveyor.friction_factor
    part = length / whole * ((1.0 - conveyor.return_share) if carries else conveyor.return_share)
    tilt = sum(
        local.per_weight(whole)
        for local in conveyor.locals
        if isinstance(local, TiltResistance) and local.strand == strand
    )
    forces = {
        MAIN_NAME: main_resistance(factor, length, flight.sine * length, rotating, carried),
        SLOPE_NAME: slope_resistance(lift, carried),
        SECONDARY_NAME: part * _spread_secondary(conveyor, case),
        SPECIAL_NAME: part * conveyor.special_resistance,
        TILT: tilt * carried * GRAVITY * flight.cosine * length,
    }
    return Segment(strand, flight, start, length, lift, carried, rotating, forces)


def _spread_secondary(conveyor: ConveyorData, case: ConveyorCase) -> float:
    """Return the secondary resistances that are spread over the belt in a load case [N]."""
    coefficient = conveyor.coefficient
    if coefficient is None:
        return conveyor.secondary_resistance or 0.0
    return (coefficient - 1.0) * _main_total(conveyor, case)


def _main_total(conveyor: ConveyorData, case: ConveyorCase) -> float:
    """Return the main resistance of both strands in a load case [N]."""
    total, edges = 0.0, [0.0]
    for flight in conveyor.course_flights:
        edges.append(edges[-1] + flight.length)
    cuts = sorted({*edges, *conveyor.loading_positions()})
    for start, end in pairwise(cuts):
        middle = 0.5 * (start + end)
        flight, length = _flight_at(conveyor, middle), end - start
        factor = flight.friction_factor or conveyor.friction_factor
        lift = flight.sine * length
        own = (flight.carry_idler_mass, flight.return_idler_mass)
        carry = conveyor.carry_idler_mass if own[0] is None else own[0]
        back = conveyor.return_idler_mass if own[1] is None else own[1]
        loaded = conveyor.belt_mass + _material_at(conveyor, case, middle)
        total += main_resistance(factor, length, lift, carry, loaded)
        total += main_resistance(factor, length, lift, back, conveyor.belt_mass)
    return total


def spot_forces(
    conveyor: ConveyorData, case: ConveyorCase, spot: Spot, tension: float
) -> dict[str, float]:
    """Return what resists at a spot where the belt has a mean tension, by name [N]."""
    if spot.kind == "loading":
        if not conveyor.itemised:
            return {}  # within the coefficient
        flow = conveyor.loading_mass(spot.which) * (conveyor.speed or 0.0)
        flow *= case.factor_of(_flight_at(conveyor, spot.position))
        point = conveyor.loadings[spot.which] if conveyor.loadings else None
        if point is None or flow == 0.0:
            return {}
        return {LOADING: loading_force(point, flow, conveyor.speed or 0.0)}
    if spot.kind != "local":
        return {}
    local = conveyor.locals[spot.which]
    if isinstance(local, PulleyResistance):
        wrap = local.wrap(
            tension, conveyor.width or 0.0, conveyor.thickness or 0.0, steel=conveyor.steel
        )
        return {WRAP: wrap, BEARING: local.bearing(tension)}
    if isinstance(local, CleanerResistance):
        return {CLEANER: local.force}
    if isinstance(local, PointResistance):
        return {SPECIAL_NAME: local.force}
    if isinstance(local, SkirtResistance):
        return {SKIRT: local.force(_material_at(conveyor, case, local.position))}
    return {}


def _flight_at(conveyor: ConveyorData, position: float) -> Flight:
    """Return the flight that begins at a distance from the tail, or goes on there."""
    end = 0.0
    for flight in conveyor.course_flights:
        end += flight.length
        if position < end - 1e-9 * conveyor.length:
            return flight
    return conveyor.course_flights[-1]


def _material_at(conveyor: ConveyorData, case: ConveyorCase, position: float) -> float:
    """Return the material on the belt just behind a distance from the tail [kg/m]."""
    slack = 1e-9 * conveyor.length
    loaded = sum(
        conveyor.loading_mass(i)
        for i, start in enumerate(conveyor.loading_positions())
        if start <= position + slack
    )
    return loaded * case.factor_of(_flight_at(conveyor, position))


def is_take_up(step: Step) -> bool:
    """Return whether the take-up stands there."""
    return isinstance(step, Spot) and step.kind == "take-up"


def is_drive(step: Step, index: int) -> bool:
    """Return whether the drive of an index stands there."""
    return isinstance(step, Spot) and step.kind == "drive" and step.which == index
