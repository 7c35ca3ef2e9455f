"""Field numbers in a sheet: speeds, alarm and trip, wear and life."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

from wraparc.answer.checks_table import verdict_document
from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict, named, percent, quantity
from wraparc.answer.words import under
from wraparc.calibrate.field_numbers import TRIP_RULES, FieldNumbers
from wraparc.checks import Level, Place
from wraparc.checks import Verdict as Judgement
from wraparc.checks.action import Action
from wraparc.checks.of_arc import COVER_UNKNOWN
from wraparc.checks.of_drive import LAYERS
from wraparc.drive.pitch import USUAL_OFFSET
from wraparc.train.turning import surface_sentence
from wraparc.units import display, either

#: Wear that a tape around the drum, read to 1 mm of circumference, tells [m].
TAPE = 1e-3 / (2.0 * math.pi)


def field_sheet(
    found: FieldNumbers | None,
    drive: Verdict,
    title: str,
    pulley: str,
    wear_source: str = "",
    learned: tuple[Table, ...] = (),
) -> Sheet:
    """Return what to expect of a pulley in the field; `drive` is the verdict on the whole drive.

    `learned` are the levels that its own logs gave.
    """
    if found is None:
        subtitle = f"Pulley {pulley}: nothing to measure, as the belt slips on it."
        return Sheet(title=title, subtitle=subtitle, verdict=drive)
    rows = [
        Row(
            f"Healthy, {name}",
            tuple(percent(v) for v in (*pair, *(found.shown[name] if found.shown else ()))),
            name="healthy",
        )
        for name, pair in found.healthy.items()
    ]
    by_shaft = ("shaft to belt at entry", "at exit") if found.shown else ()
    speeds = Table(
        "Pulley speed less belt speed, over pulley speed",
        tuple(rows),
        ("belt at entry", "belt at exit", *by_shaft),
        "pulley speed: of the lagging surface where the belt meets it, on the radius less its "
        "compression; behind the pulley the belt runs as its strain does, v2/v1 = (1 + T2/EA)/"
        "(1 + T1/EA)"
        + (
            "; shaft to belt: 1 - v/(omega R), what a tachometer pair shows, as the belt runs on "
            "the radius of its tension member"
            if found.shown
            else ""
        ),
        "speeds",
    )
    return Sheet(
        title=title,
        subtitle=f"Pulley {pulley}: numbers to measure and to set.",
        verdict=_verdict(found, drive, pulley),
        tables=(speeds, *learned, _levels(found), *_wear(found, wear_source)),
        remarks=tuple(_remarks(found)),
        sources=tuple(f"{rule.name}: {rule.source}" for rule in TRIP_RULES),
    )


def _verdict(found: FieldNumbers, drive: Verdict, pulley: str) -> Verdict:
    worst = found.worst
    at_once, again = [*_at_once(found, worst)], _circumference(found)
    # no level that a tachometer pair is set by is an OK without the thickness of the belt
    surface = () if found.shown else (surface_sentence(found.diameter),)
    covered = tuple(_covered(found))
    doubt = not found.shown or at_once or found.alarms_at(found.covered or found.worst_seen)
    own = Verdict(
        Level.ATTENTION if doubt else Level.OK,
        _levels_sentence(found, pulley),
        (*at_once, *surface, *covered, *_rules(found, worst), again),
        action=_action(found, drive),
        name="field",
    )
    return under(own, drive)


def _action(found: FieldNumbers, drive: Verdict) -> Action | None:
    """Return what to do: about a drive that alarms; else the layers of the belt, where missing."""
    alarms = found.alarms_at(found.worst_seen)
    if alarms and drive.action:
        return None
    if found.shown:
        return Action("Set each load case's own alarm level (--table levels).") if alarms else None
    belt, points = quantity(2.0 * USUAL_OFFSET, "length"), 200.0 * USUAL_OFFSET / found.diameter
    return Action(f"{LAYERS}: {belt} of belt shifts all by {points:.2f} points.")


def _levels_sentence(found: FieldNumbers, pulley: str) -> str:
    """Say the normal speed difference with its levels, or that it is beyond the alarm."""
    forward, seen = found.side > 0.0, found.worst_seen
    alarm, trip = (percent(found.seen(level, 0.0)) for level in (found.alarm, found.trip))
    if found.alarms_at(seen):
        relation = "exceeds" if forward else "is below"
        place = Place(pulley, found.worst_case).bracket
        return f"Speed difference {percent(seen)} {relation} the {alarm} alarm level{place}."
    bound = "up to" if forward else "down to"
    return (
        f"Normal speed difference {bound} {percent(seen)}; alarm {alarm}, trip {trip} ({pulley})."
    )


def _circumference(found: FieldNumbers) -> str:
    """Say that wear of the lagging shows as a difference, and when to measure the drum again."""
    moved = percent(2.0 * found.depth / found.diameter)
    depth = quantity(found.depth, "length")
    steps = 1e-3, 0.0254 / 16.0
    each = either(*(quantity(step, "length") for step in steps))
    moved_each = either(*(percent(step * found.drift) for step in steps))
    worn, again = found.wear_to_alarm, 0.25 * found.wear_to_alarm
    alarms, measure = "any wear", "the pulley's surface instead of its shaft"
    if math.isinf(worn):
        return (
            "These levels need the pulley speed from a measured circumference: wear since it was "
            f"measured hides the slip of a brake, {each} moves every difference by {moved_each}, "
            f"and {depth} by {moved}. Measure {measure}."
        )
    if again >= TAPE:
        alarms = f"{quantity(worn, 'length')} of wear"
        every = quantity(again, "length")
        measure = f"the circumference again for every {every} worn off, or measure {measure}"
    return (
        f"These levels need the pulley speed from a measured circumference: {alarms} since it "
        f"was measured raises the alarm by itself, {each} moves every difference by {moved_each}, "
        f"and {depth} by {moved}. Measure {measure}."
    )


def _at_once(found: FieldNumbers, worst: float) -> Iterator[str]:
    limits = {name: ratio for name, (ratio, _) in found.limits.items()}
    beyond = [n for n, ratio in limits.items() if max(map(abs, found.healthy[n])) > ratio]
    if beyond or (not limits and found.at_limit is not None and worst > found.at_limit):
        yield (
            "As described, the drive already exceeds its creep limit, where the alarm is set: "
            "it alarms at once."
        )
    elif found.alarms_at(found.worst_seen):
        yield (
            "One load case sets this alarm, and another shows more within its creep limit: "
            "set each load case's own level, that of its creep limit."
        )


def _covered(found: FieldNumbers) -> Iterator[str]:
    if found.covered is None:
        return
    told = "the belt slips through"
    if math.isfinite(found.covered):
        told = (
            f"a healthy drive shows at {'most' if found.side > 0.0 else 'least'} "
            f"{percent(found.covered)}"
        )
    yield f"{COVER_UNKNOWN}: with the cover in series {told}."


def _rules(found: FieldNumbers, worst: float) -> Iterator[str]:
    for rule in TRIP_RULES:
        slack = 1.0 - rule.speed_share
        healthy, trip = (
            display(float(f"{slack / of:.2g}"), "number", digits=3) for of in (worst, found.trip)
        )
        yield (
            f"A switch at {rule.name} trips at a difference of {percent(slack, 2)}: {healthy} "
            f"times the healthy one, {trip} times the trip level in this table."
        )


def _levels(found: FieldNumbers) -> Table:
    def row(name: str, title: str, share: float, note: str = "") -> Row:
        shown = (percent(found.seen(share, worn)) for worn in (0.0, found.depth))
        return Row(title, tuple(shown), note=note, name=name)

    healthy = (found.worst_seen, found.worn_seen(found.depth))
    rows = [Row("Healthy, at most", tuple(percent(v) for v in healthy), name="healthy")]
    limits = found.limits if found.shown else {}
    for name, (ratio, seen) in limits.items():
        worn = seen + (1.0 - found.side * ratio) * found.depth * found.drift
        rows.append(
            Row(
                f"At the creep limit, {name}", (percent(seen), percent(worn)), name="at_creep_limit"
            )
        )
    if found.at_limit is not None and not limits:
        rows.append(row("at_creep_limit", "At the creep limit", found.at_limit))
    rows.append(row("alarm", "Alarm", found.alarm, note="at the creep limit"))
    rows.append(row("trip", "Trip", found.trip, note="twice the alarm, or gross slip"))
    if found.at_breakaway is not None:
        note = "creep at gross slip over the wrap length; an extrapolation"
        rows.append(row("gross_slip", "Gross slip", found.at_breakaway, note=note))
    rows += [
        Row(f"Switch at {rule.name}", (percent(1.0 - rule.speed_share), NONE), name="switch")
        for rule in TRIP_RULES
    ]
    depth = quantity(found.depth, "length")
    heads = ("circumference measured", f"{depth} worn since")
    note = (
        "The second column is what shaft speed times the circumference before the wear shows: set "
        "a level by the first, and measure the circumference regularly."
    )
    return Table("Alarm and trip levels", tuple(rows), heads, note, "levels")


def _wear(found: FieldNumbers, source: str) -> Iterator[Table]:
    if found.passes_per_year <= 0.0:
        return
    rows = [
        Row("Turns in a year", (quantity(found.passes_per_year, "number"),), name="turns"),
        Row(
            "Frictional energy in a year",
            (named("frictional_energy", found.energy_per_year),),
            name="frictional_energy",
        ),
    ]
    if not math.isnan(found.wear_per_year):
        wear, life = quantity(found.wear_per_year, "length"), quantity(found.life_years, "number")
        rows.append(Row("Wear in a year", (wear,), note=source, name="wear"))
        rows.append(Row("Life of the depth allowed", (f"{life} years",), name="life"))
    yield Table("Wear of the lagging", tuple(rows), name="wear")


def _remarks(found: FieldNumbers) -> Iterator[str]:
    yield (
        "Speeds are steady ones; starts and stops show more. The factors 1.25 and 2 of alarm and "
        "trip are this program's choice, not a rule of a standard."
    )
    if found.passes_per_year > 0.0 and math.isnan(found.wear_per_year):
        yield (
            "No wear coefficient: give --wear-coefficient, or --measured-wear and the hours it "
            "took, to have the wear in a year."
        )
    if found.at_breakaway is None:
        yield "No creep marks gross slip: the maximum Te is approached as creep grows."


def _pairs(differences: Mapping[str, tuple[float, float]]) -> dict[str, dict[str, float]]:
    """Return differences before the drum and behind it by load case [-]."""
    return {name: {"entry": a, "exit": b} for name, (a, b) in differences.items()}


def field_document(found: FieldNumbers | None, judged: Judgement) -> dict[str, Any]:
    """Return verdict and numbers as plain data [SI] for JSON."""
    told = {"format": 3, "verdict": verdict_document(judged)}
    if found is None:
        return told
    return {
        **told,
        "healthy": _pairs(found.healthy),
        "at_creep_limit": found.at_limit,
        "at_gross_slip": found.at_breakaway,
        "alarm": found.alarm,
        "trip": found.trip,
        "shown": {
            "healthy": _pairs(found.shown),
            "alarm": found.seen(found.alarm, 0.0),
            "trip": found.seen(found.trip, 0.0),
        }
        if found.shown
        else None,
        "drift": found.drift,
        "alarm_when_worn": found.seen(found.alarm, found.depth),
        "with_cover_in_series": found.covered,
        "wear_to_alarm": found.wear_to_alarm,
        "customary_trips": {r.name: 1.0 - r.speed_share for r in TRIP_RULES},
        "wear_per_year": found.wear_per_year,
        "life_years": found.life_years,
        "frictional_energy_per_year": found.energy_per_year,
        "turns_per_year": found.passes_per_year,
    }
