"""What follows from the tensions of a conveyor: sag, take-up travel, vertical curves, and CEMA."""

from collections.abc import Sequence
from dataclasses import dataclass

from wraparc.conveyor.description import ConveyorData
from wraparc.conveyor.extras import Travel
from wraparc.conveyor.resistance import GRAVITY
from wraparc.conveyor.state import CARRY, State, Stretch

SAG_SOURCE = "m' g l/(8 T), a parabola (DIN 22101:2002-08, 8.2; ISO 5048:1989)"
CURVE_SOURCE = (
    "T/(m'_G g cos delta): the empty belt does not lift off a concave curve (CEMA, Belt Conveyors "
    "for Bulk Materials; DIN 22101:2002-08)"
)
CEMA_SOURCE = (
    "CEMA, Belt Conveyors for Bulk Materials (5th edition): Te = L Kt (Kx + Ky Wb + 0.015 Wb) + "
    "Wm (L Ky + H), Kx = 0.00068 (Wb + Wm) + Ai/Si"
)
#: Ky of the return strand, and the part of the weight in Kx [-] (CEMA, 5th edition, chapter 6).
RETURN_KY, WEIGHT_IN_KX = 0.015, 0.00068


@dataclass(frozen=True)
class SagAt:
    """How far the belt sags at the lowest tension of a flight.

    Attributes
    ----------
    stretch
        The flight on its strand.
    load_case
        In which its sag is largest.
    tension
        Its lowest tension [N].
    share
        Sag over the spacing of the idlers [-].
    """

    stretch: Stretch
    load_case: str
    tension: float
    share: float


@dataclass(frozen=True)
class TravelOf:
    """The travel of a take-up, half of what the belt grows longer [m].

    Attributes
    ----------
    elastic
        Between the load cases of the longest and the shortest belt.
    longest, shortest
        Their names.
    thermal, permanent, splice
        The others; None where they are not known.
    """

    elastic: float
    longest: str
    shortest: str
    thermal: float | None
    permanent: float | None
    splice: float | None

    @property
    def total(self) -> float:
        """Of what is known together [m]."""
        parts = (self.thermal, self.permanent, self.splice)
        return self.elastic + sum(part for part in parts if part is not None)


@dataclass(frozen=True)
class CurveAt:
    """A vertical curve between two flights.

    Attributes
    ----------
    flight
        The one that begins with it.
    concave
        Whether the belt can lift off: it becomes steeper in the direction of travel.
    radius
        As it is built, or None [m].
    least
        Smallest radius at which the belt stays on the idlers [m]; of a concave curve.
    load_case
        In which it is largest.
    tension
        Of the belt there [N].
    """

    flight: str
    concave: bool
    radius: float | None
    least: float
    load_case: str
    tension: float


def sags(conveyor: ConveyorData, states: Sequence[State], *, running: bool = True) -> list[SagAt]:
    """Return the largest sag on each flight of both strands, where the idler spacing is known.

    Of the load cases that run, for which the standards limit it, or of those that start and stop.
    """
    found: dict[tuple[str, str], SagAt] = {}
    flights = {flight.name: flight for flight in conveyor.course_flights}
    for state in (s for s in states if (s.kind == "running") == running):
        for stretch in state.stretches:
            flight = flights.get(stretch.flight)
            if flight is None:
                continue
            carries = stretch.strand == CARRY
            own = flight.carry_spacing if carries else flight.return_spacing
            whole = conveyor.carry_spacing if carries else conveyor.return_spacing
            spacing = whole if own is None else own
            if spacing is None or stretch.least <= 0.0:
                continue
            share = stretch.mass * GRAVITY * flight.cosine * spacing / (8.0 * stretch.least)
            key = (stretch.strand, stretch.flight)
            if key not in found or share > found[key].share * (1.0 + 1e-9):
                found[key] = SagAt(stretch, state.name, stretch.least, share)
    return [found[key] for key in sorted(found, key=lambda key: key[0])]


def travel_of(conveyor: ConveyorData, states: Sequence[State], stiffness: float) -> TravelOf:
    """Return the travel of the take-up.

    The elastic one is the difference of ``integral T/EA ds`` over the whole belt between the load
    cases of the longest and of the shortest belt; the take-up pulley moves by half of it.

    Parameters
    ----------
    conveyor, states
        With flights, and its load cases.
    stiffness
        EA of the belt [N].
    """
    longer = {state.name: elongation(conveyor, state, stiffness) for state in states}
    longest = max(longer, key=lambda name: longer[name])
    shortest = min(longer, key=lambda name: longer[name])
    belt = 2.0 * conveyor.length
    travel = Travel() if conveyor.travel is None else conveyor.travel
    thermal, permanent, splice = (
        travel.thermal, travel.permanent_elongation, travel.splice_length,
    )  # fmt: skip
    return TravelOf(
        elastic=0.5 * (longer[longest] - longer[shortest]),
        longest=longest,
        shortest=shortest,
        thermal=None if thermal is None else 0.5 * belt * thermal,
        permanent=None if permanent is None else 0.5 * belt * permanent,
        splice=None if splice is None else 0.5 * splice,
    )


def elongation(conveyor: ConveyorData, state: State, stiffness: float) -> float:
    """Return by how much the tension of a load case makes the belt longer [m].

    The tension is linear between neighbouring points: every force is spread evenly there.
    """
    total = 0.0
    for strand in ("carry", "return"):
        points = [point for point in state.points if point.strand == strand]
        end = next(
            s.end for s in reversed(state.stretches) if s.strand == strand and s.mass > 0.0
        )  # fmt: skip
        place, tension = 0.0, points[0].after
        for point in points[1:]:
            total += 0.5 * (tension + point.before) * (point.position - place)
            place, tension = point.position, point.after
        total += 0.5 * (tension + end) * (conveyor.length - place)
    return total / stiffness


def curves(conveyor: ConveyorData, states: Sequence[State]) -> list[CurveAt]:
    """Return the vertical curves of the carrying strand, with what the worst load case needs."""
    found: list[CurveAt] = []
    for i in range(1, len(conveyor.course_flights)):
        before, flight = conveyor.course_flights[i - 1], conveyor.course_flights[i]
        if abs(flight.sine - before.sine) < 1e-6:
            continue
        tensions = {
            state.name: point.after
            for state in states
            for point in state.points
            if point.kind == "flight" and point.strand == CARRY and point.name == flight.name
        }
        worst = max(tensions, key=lambda name: tensions[name])
        cosine = min(before.cosine, flight.cosine)
        least = tensions[worst] / (conveyor.belt_mass * GRAVITY * cosine)
        concave = flight.sine > before.sine
        found.append(
            CurveAt(flight.name, concave, flight.curve_radius, least, worst, tensions[worst])
        )
    return found


def cema_pull(conveyor: ConveyorData, state: State) -> float | None:
    """Return the effective tension of a load case by CEMA [N], None without what it needs.

    Flight by flight: Wm and Ky on the carrying strand, 0.015 on the return strand.
    """
    of = conveyor.cema
    if of is None or conveyor.carry_spacing is None:
        return None
    belt, total = conveyor.belt_mass * GRAVITY, of.other
    flights = {flight.name: flight for flight in conveyor.course_flights}
    for stretch in state.stretches:
        flight = flights.get(stretch.flight)
        if flight is None or stretch.strand != CARRY:
            continue
        material = stretch.mass * GRAVITY - belt
        spacing = flight.carry_spacing or conveyor.carry_spacing
        kx = WEIGHT_IN_KX * (belt + material) + of.idler_friction / spacing
        flexing = kx + (of.ky + RETURN_KY) * belt
        total += flight.length * of.temperature_factor * flexing
        total += material * (flight.length * of.ky + flight.rise)
    return total
