"""Tables of a conveyor besides its resistances: tensions, sag, curves, take-up, standstill."""

from collections.abc import Sequence
from typing import Any

from wraparc.answer.sheet import NONE, Row, Table, headed, named, number, percent, quantity
from wraparc.answer.sources import Sources
from wraparc.checks import Level
from wraparc.conveyor import Conveyor, State, curves, sags, travel_of
from wraparc.conveyor.consequences import CURVE_SOURCE, SAG_SOURCE
from wraparc.drive import Belt, Pulley
from wraparc.units import GIVEN_DIGITS, RESULT_DIGITS

#: Words for the strands.
STRANDS = {"carry": "carrying", "return": "return"}
_KINDS = {"flight": "", "drive": "drive ", "loading": "loading ", "take-up": "", "local": ""}


def tension_table(conveyor: Conveyor, states: Sequence[State]) -> Table:
    """Return the tension at every point of the belt in every load case."""
    rows: list[Row] = []
    first = states[0]
    for i, point in enumerate(first.points):
        place = quantity(point.position, "length", GIVEN_DIGITS)
        title = f"{STRANDS[point.strand]} {place}: {_KINDS[point.kind]}{point.name}"
        here = [state.points[i] for state in states]
        if all(p.before == p.after for p in here):
            cells = tuple(number("tension", p.after) for p in here)
            rows.append(Row(title, cells))
            continue
        rows.append(Row(title, tuple(number("tension", p.before) for p in here), "", "before"))
        rows.append(Row(title, tuple(number("tension", p.after) for p in here), "", "behind"))
    heads = tuple(headed(state.name, "force") for state in states)
    note = "In belt order from the tail pulley; positions from the tail, on the return strand from "
    return Table("Belt tension at every point", tuple(rows), heads, f"{note}the head.", "tensions")


def flights_table(conveyor: Conveyor, states: Sequence[State]) -> Table:
    """Return what resists on every flight of both strands, in every load case."""
    rows = [
        Row(
            f"{stretch.flight}, {STRANDS[stretch.strand]}",
            tuple(number("tension", state.stretches[i].resistance) for state in states),
        )
        for i, stretch in enumerate(states[0].stretches)
    ]
    heads = tuple(headed(state.name, "force") for state in states)
    note = "All resistances of a flight with those at its beginning; together they are Te."
    return Table("Resistance by flight", tuple(rows), heads, note, "flights")


def sag_table(conveyor: Conveyor, states: Sequence[State], of: Sources) -> list[Table]:
    """Return the sag at the lowest tension of each flight, where the idler spacing is known."""
    changing = {
        (sag.stretch.flight, sag.stretch.strand): percent(sag.share)
        for sag in sags(conveyor, states, running=False)
    }
    limit = percent(conveyor.sag_limit)
    rows = tuple(
        Row(
            f"{sag.stretch.flight}, {STRANDS[sag.stretch.strand]}",
            (
                number("tension", sag.tension),
                percent(sag.share),
                limit,
                changing.get((sag.stretch.flight, sag.stretch.strand), NONE),
            ),
            "",
            sag.load_case,
            level=Level.ATTENTION if sag.share > conveyor.sag_limit else Level.OK,
        )
        for sag in sags(conveyor, states)
    )
    if len(rows) == 0:
        return []
    heads = (headed("tension", "force"), "sag, running", "limit", "start, stop")
    note = "Sag over spacing at the lowest tension of each flight in its worst load case; no limit "
    note += f"is applied while starting and stopping {of.number(SAG_SOURCE)}."
    return [Table("Belt sag between idlers", rows, heads, note, "sag")]


def curves_table(conveyor: Conveyor, states: Sequence[State], of: Sources) -> list[Table]:
    """Return the vertical curves of the carrying strand with the radius that each needs."""
    rows: list[Row] = []
    for curve in curves(conveyor, states):
        if not curve.concave:
            continue
        small = curve.radius is not None and curve.radius < curve.least
        radius = NONE if curve.radius is None else quantity(curve.radius, "length", GIVEN_DIGITS)
        rows.append(
            Row(
                f"before {curve.flight}",
                (named("tension", curve.tension), quantity(curve.least, "length", RESULT_DIGITS),
                 radius),
                "",
                curve.load_case,
                level=Level.ATTENTION if small else None,
            )
        )  # fmt: skip
    if len(rows) == 0:
        return []
    note = f"Concave curves of the carrying strand, the belt empty there {of.number(CURVE_SOURCE)}."
    heads = ("tension", "minimum radius", "radius")
    return [Table("Vertical curves", tuple(rows), heads, note, "curves")]


def take_up_table(conveyor: Conveyor, states: Sequence[State], belt: Belt, of: Sources) -> Table:
    """Return tension, counterweight and travel of the take-up."""
    travel = travel_of(conveyor, states, belt.axial_stiffness)

    def row(title: str, value: float | None, note: str) -> Row:
        text = NONE if value is None else quantity(value, "length", RESULT_DIGITS)
        return Row(title, (text,), "", note)

    ratio = f"{conveyor.sheave_ratio:g} times the tension over g"
    rows = (
        Row("Take-up tension", (named("tension", conveyor.take_up),)),
        Row("Counterweight", (quantity(conveyor.weight, "mass", GIVEN_DIGITS),), "", ratio),
        row("Elastic travel", travel.elastic, f"from {travel.shortest} to {travel.longest}"),
        row("Thermal travel", travel.thermal, _missing(travel.thermal, "temperature_range")),
        row("Permanent", travel.permanent, _missing(travel.permanent, "permanent_elongation")),
        row("Splices", travel.splice, _missing(travel.splice, "splice_length")),
        row("Travel in all", travel.total, "half of what the belt grows longer"),
    )
    return Table("Take-up", rows, ("",), "", "take-up")


def _missing(value: float | None, key: str) -> str:
    return f"not stated (conveyor.travel.{key})" if value is None else ""


def standstill_table(
    conveyor: Conveyor, states: Sequence[State], pulleys: Sequence[Pulley]
) -> Table:
    """Return the force, and the torque on each drive alone, that keeps the loaded belt at rest."""
    running = [s for s in states if s.kind == "running" and s.standstill is not None]
    rests = [s.standstill for s in running if s.standstill is not None]
    forces = [rest.holding(conveyor.rest_friction) for rest in rests]
    rows = [
        Row("Slope resistance", tuple(named("tension", rest.slope) for rest in rests), "F_St"),
        Row("Main resistance", tuple(named("tension", rest.friction) for rest in rests), "F_H"),
        Row("Force at standstill", tuple(named("tension", force) for force in forces)),
        Row("Needs", tuple(_needs(force) for force in forces)),
    ]
    for pulley in pulleys:
        torques = (
            quantity(abs(f) * 0.5 * pulley.diameter, "torque", RESULT_DIGITS) for f in forces
        )
        rows.append(Row(f"Torque at {pulley.name} alone", tuple(torques)))
    share = percent(conveyor.rest_friction)
    note = f"Slope resistance less {share} of the main resistance; without any safety factor."
    heads = tuple(state.name for state in running)
    return Table("Standstill", tuple(rows), heads, note, "standstill")


def _needs(force: float) -> str:
    if force == 0.0:
        return "nothing"
    return "holdback" if force > 0.0 else "brake"


def parts_data(conveyor: Conveyor, states: Sequence[State], stiffness: float) -> dict[str, Any]:
    """Return sag, travel and curves for JSON."""
    travel = travel_of(conveyor, states, stiffness)
    return {
        "sag": [
            {
                "flight": sag.stretch.flight, "strand": sag.stretch.strand,
                "load_case": sag.load_case, "tension": sag.tension, "sag": sag.share,
                "limit": conveyor.sag_limit,
            }
            for running in (True, False)
            for sag in sags(conveyor, states, running=running)
        ],
        "curves": [
            {
                "flight": curve.flight, "concave": curve.concave, "radius": curve.radius,
                "minimum_radius": curve.least if curve.concave else None,
                "load_case": curve.load_case, "tension": curve.tension,
            }
            for curve in curves(conveyor, states)
        ],
        "take_up_travel": {
            "elastic": travel.elastic, "longest": travel.longest, "shortest": travel.shortest,
            "thermal": travel.thermal, "permanent": travel.permanent, "splice": travel.splice,
            "total": travel.total,
        },
    }  # fmt: skip
