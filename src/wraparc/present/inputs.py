"""What a solve was given: belt, pulley, lagging and tensions, each with its source."""

import math

from wraparc.arc import WrapArc
from wraparc.drive import Belt, Drive, Lagging, Pulley
from wraparc.present.sheet import Row, Table, between, named, percent, quantity, row_of
from wraparc.present.sources import Sources
from wraparc.units import System


def input_table(drive: Drive, pulley: Pulley, arc: WrapArc, system: System, of: Sources) -> Table:
    """Return what was given for one arc."""
    rows = (
        *belt_rows(drive.belt, system, of),
        *_pulley_rows(pulley, arc, system, of),
        *lagging_rows(pulley.lagging, system, of),
        *_tension_rows(drive.belt, pulley, arc, system, of),
    )
    return Table(f"Inputs: pulley {pulley.name}, load case {arc.load_case}", rows)


def belt_rows(belt: Belt, system: System, of: Sources) -> tuple[Row, ...]:
    """Return the rows of a belt."""

    def source(field: str) -> str:
        return of.note(belt.sources.get(field, belt.provenance))

    rows = [
        Row("Belt", (belt.name,), note=belt.kind),
        row_of("belt_width", belt.width, system=system),
        row_of("belt_modulus", belt.modulus, system=system, note=source("modulus")),
        row_of("axial_stiffness", belt.axial_stiffness, system=system, note="M B"),
    ]
    if belt.rating is not None:
        rating = quantity(belt.rating, "force_per_width", system)
        rows.append(Row("Rating of the belt", (rating,), note=source("rating")))
    if belt.speed is not None:
        rows.append(row_of("belt_speed", belt.speed, system=system))
    return tuple(rows)


def _pulley_rows(pulley: Pulley, arc: WrapArc, system: System, of: Sources) -> tuple[Row, ...]:
    def source(field: str) -> str:
        return of.note(pulley.sources[field]) if field in pulley.sources else ""

    overrun = source("overrun") if pulley.overrun is not None else "1.25 delta sqrt(delta/R)"
    return (
        row_of("diameter", pulley.diameter, system=system, note=source("diameter")),
        row_of("wrap_angle", pulley.wrap_angle, system=system, note=source("wrap_angle")),
        row_of("overrun", arc.entry_overrun, system=system, note=overrun),
        *(() if pulley.recovery else (Row("Recovery of the lagging", ("not counted",)),)),
        row_of("creep_limit", arc.creep_limit, system=system, note=source("creep_limit")),
    )


def lagging_rows(lagging: Lagging, system: System, of: Sources) -> tuple[Row, ...]:
    """Return the rows of a lagging."""
    rows = [
        Row("Lagging", (lagging.name,), note=lagging.title),
        Row("Condition", (lagging.condition,)),
        Row("Friction law", (lagging.law.title,), note=of.note(lagging.source_of("law"))),
    ]
    for name, field in (
        ("lagging_thickness", "thickness"),
        ("shear_modulus", "shear_modulus"),
        ("compression_modulus", "compression_modulus"),
    ):
        value, note = getattr(lagging, field), of.note(lagging.source_of(field))
        if math.isinf(value):
            title = row_of(name, value).title
            rows.append(Row(title, ("rigid",), row_of(name, value).symbol, name=name))
        else:
            rows.append(row_of(name, value, system=system, note=note))
    if lagging.wear_coefficient is not None:
        note = of.note(lagging.source_of("wear_coefficient"))
        rows.append(row_of("wear_coefficient", lagging.wear_coefficient, system=system, note=note))
    tested = lagging.law.tested
    if tested is not None:
        ends = between("wrap_pressure", tested.pressure_min, tested.pressure_max, system)
        slip = named("slip", tested.slip_max, system)
        rows.append(Row("Tested range", (ends,), "p", f"slip up to {slip}"))
    return tuple(rows)


def _tension_rows(
    belt: Belt, pulley: Pulley, arc: WrapArc, system: System, of: Sources
) -> tuple[Row, ...]:
    entry, leaving = arc.entry_tension, arc.exit_tension
    used = ""
    if belt.rating is not None:
        used = f"{percent(max(entry, leaving) / (belt.rating * belt.width))} of the belt's rating"
    tight = "entry_tension" if entry >= leaving else "exit_tension"

    def note(field: str) -> str:
        source = of.note(pulley.sources[field]) if field in pulley.sources else ""
        return "; ".join(part for part in (source, used if field == tight else "") if part)

    return (
        row_of("entry_tension", entry, system=system, note=note("entry_tension")),
        row_of("exit_tension", leaving, system=system, note=note("exit_tension")),
        row_of("effective_tension", arc.effective_tension, system=system, note=arc.duty),
        row_of("tension_ratio", entry / leaving, system=system),
    )
