"""Field numbers in a sheet: speeds, alarm and trip, wear and life."""

import math
from collections.abc import Iterator
from typing import Any

from wraparc.calibrate.field_numbers import TRIP_RULES, FieldNumbers
from wraparc.checks import Level
from wraparc.present.sheet import Row, Sheet, Table, Verdict, percent, quantity
from wraparc.units import System


def field_sheet(
    found: FieldNumbers, title: str, pulley: str, wear_source: str = "", system: System = "si"
) -> Sheet:
    """Return what to expect of a drive in the field."""
    rows = [
        Row(f"Healthy, {name}", (percent(entry), percent(leaving)), "g, g2")
        for name, (entry, leaving) in found.healthy.items()
    ]
    speeds = Table(
        "Drum speed less belt speed, over drum speed",
        tuple(rows),
        ("belt at entry", "belt at exit"),
        "drum speed: of the lagging surface under the belt, which runs on the radius less its "
        "compression",
    )
    return Sheet(
        title=title,
        subtitle=f"Pulley {pulley}: numbers to measure and to set.",
        verdict=_verdict(found),
        tables=(speeds, _levels(found), *_wear(found, wear_source, system)),
        remarks=tuple(_remarks(found)),
        sources=tuple(f"{rule.name}: {rule.source}" for rule in TRIP_RULES),
    )


def _verdict(found: FieldNumbers) -> Verdict:
    worst = max(max(map(abs, pair)) for pair in found.healthy.values())
    level = Level.OK
    if found.at_limit is not None and worst > found.at_limit:
        level = Level.ATTENTION
    return Verdict(
        level,
        f"A healthy drive shows at most {percent(worst)} between drum and belt; alarm at "
        f"{percent(found.alarm)}, trip at {percent(found.trip)}.",
        tuple(_rules(found, worst)),
    )


def _rules(found: FieldNumbers, worst: float) -> Iterator[str]:
    if found.at_limit is not None and worst > found.at_limit:
        yield (
            f"As described, the drive already creeps beyond its limit, which corresponds to "
            f"{percent(found.at_limit)}; the levels are relative to the drive as described."
        )
    for rule in TRIP_RULES:
        slack = 1.0 - rule.speed_share
        yield (
            f"A switch at {rule.name} trips at a difference of {percent(slack, 2)}: "
            f"{slack / worst:.2g} times the healthy one, {slack / found.trip:.2g} times the trip "
            "level given here."
        )


def _levels(found: FieldNumbers) -> Table:
    rows = []
    if found.at_limit is not None:
        rows.append(Row("At the creep limit", (percent(found.at_limit),), "g2"))
    rows.append(Row("Alarm", (percent(found.alarm),), note="at the creep limit, or 1.25 healthy"))
    rows.append(Row("Trip", (percent(found.trip),), note="twice the alarm, or gross slip"))
    if found.at_breakaway is not None:
        note = "creep at gross slip over the wrap length; an extrapolation"
        rows.append(Row("Gross slip", (percent(found.at_breakaway),), note=note))
    rows += [
        Row(f"Switch at {rule.name}", (percent(1.0 - rule.speed_share),)) for rule in TRIP_RULES
    ]
    return Table("Alarm and trip levels", tuple(rows))


def _wear(found: FieldNumbers, source: str, system: System) -> Iterator[Table]:
    if found.passes_per_year <= 0.0:
        return
    rows = [
        Row("Turns in a year", (f"{found.passes_per_year:.4g}",)),
        Row(
            "Frictional energy in a year",
            (f"{found.energy_per_year / 1e6:.4g} MJ/m2",),
        ),
    ]
    if not math.isnan(found.wear_per_year):
        rows.append(
            Row("Wear in a year", (quantity(found.wear_per_year, "length", system),), note=source)
        )
        rows.append(Row("Life of the depth allowed", (f"{found.life_years:.3g} years",)))
    yield Table("Wear of the lagging", tuple(rows))


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
        yield "The friction law is flat past its peak, so no particular creep marks gross slip."


def field_document(found: FieldNumbers) -> dict[str, Any]:
    """Return the numbers as plain data [SI] for JSON."""
    return {
        "format": 1,
        "healthy": {
            name: {"entry_creep_ratio": a, "exit_creep_ratio": b}
            for name, (a, b) in found.healthy.items()
        },
        "at_creep_limit": found.at_limit,
        "at_gross_slip": found.at_breakaway,
        "alarm": found.alarm,
        "trip": found.trip,
        "customary_trips": {r.name: 1.0 - r.speed_share for r in TRIP_RULES},
        "wear_per_year": found.wear_per_year,
        "life_years": found.life_years,
        "frictional_energy_per_year": found.energy_per_year,
        "turns_per_year": found.passes_per_year,
    }
