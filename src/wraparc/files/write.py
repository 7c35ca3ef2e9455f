"""Drives and laggings to files that read back equal."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import takewhile
from math import inf, isnan, nextafter
from typing import Any

from wraparc import catalogue
from wraparc.conveyor.keys import CONVEYOR
from wraparc.drive import (
    DESIGN,
    Belt,
    Block,
    Criteria,
    Drive,
    Factors,
    FrictionFactor,
    Lagging,
    LoadCase,
    Pulley,
)
from wraparc.drive.belt_mass import is_of_conveyor, is_of_layers, with_mass
from wraparc.drive.changes import WORN
from wraparc.drive.conditions import SCALED
from wraparc.errors import InputError, input_error
from wraparc.files.conveyor_build import conveyor_of
from wraparc.files.drive_build import Laggings, build_belt
from wraparc.files.drive_file import drive_from_document
from wraparc.files.drive_keys import BELT, CRITERIA, DRIVE, LOAD_CASE, PULLEY
from wraparc.files.lagging_build import shear_note
from wraparc.files.lagging_file import load_lagging_conditions
from wraparc.files.lagging_keys import BLOCK, FIT, LAGGING_FILE, LAGGING_GIVEN
from wraparc.files.law_tables import law_table
from wraparc.provenance import Provenance
from wraparc.saving import save_file
from wraparc.schema.emit import document_text
from wraparc.schema.keep import kept
from wraparc.schema.kinds import ByName, Percent
from wraparc.schema.problems import Report
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.shared_keys import FORMAT, PROVENANCE
from wraparc.schema.source import Document
from wraparc.schema.uncertain import UNCERTAINTY
from wraparc.units import Dimension

Tables = dict[str, Any]


def drive_text(drive: Drive, *, like: Document | None = None) -> str:
    """Return the text of a drive file that reads back as this drive.

    Parameters
    ----------
    drive
        The drive. Laggings that are not in the catalogue are written into the file.
    like
        A document of the same drive before a change: what still holds is kept as it is
        written there, units and all.
    """
    return document_text(drive_document(drive, like=like), DRIVE)


def drive_document(drive: Drive, *, like: Document | None = None) -> Document:
    """Return the tables of a drive file that reads back as this drive; see `drive_text`."""
    document = _drive_table(drive)
    if like is None:
        return document
    for candidate in (like, _with_parts_of(like, drive, document), kept(document, like, DRIVE)):
        if candidate and _reads_as(candidate, drive):
            return dict(candidate)
    return document


def save_drive(drive: Drive, path: str | os.PathLike[str], *, like: Document | None = None) -> None:
    """Write a drive file as a whole or not at all; see `drive_text`."""
    save_file(path, drive_text(drive, like=like))


def lagging_text(laggings: Lagging | Sequence[Lagging]) -> str:
    """Return the text of a lagging file that reads back as this lagging.

    Parameters
    ----------
    laggings
        A lagging, or the same one in several conditions.

    Raises
    ------
    InputError
        If the laggings differ in more than their laws.
    """
    return document_text({"format": FORMAT, **_lagging_table(laggings)}, LAGGING_FILE)


def save_lagging(laggings: Lagging | Sequence[Lagging], path: str | os.PathLike[str]) -> None:
    """Write a lagging file as a whole or not at all; see `lagging_text`."""
    save_file(path, lagging_text(laggings))


def _reads_as(document: Document, drive: Drive) -> bool:
    try:
        return drive_from_document(document) == drive
    except InputError:
        return False


def _with_parts_of(like: Document, drive: Drive, document: Document) -> Document:
    """Return the document with belt, pulleys and load cases of `like` where they still hold."""
    try:
        before = drive_from_document(like)
    except InputError:
        return {}
    result: Document = dict(kept(document, like, DRIVE))
    if before.belt == drive.belt:
        result["belt"] = like["belt"]
    if "lagging" in like:
        result["lagging"] = like["lagging"]
    rows = {row.get("name"): row for row in like["pulley"]}
    same = {p.name for p in drive.pulleys if p in before.pulleys}
    same &= {name for name in same if _design(before).get(name) == _design(drive).get(name)}
    laggings = {p.name: p.lagging for p in before.pulleys}
    result["pulley"] = [
        rows[pulley.name]
        if pulley.name in same
        else {**table, **_lagging_as_in(rows.get(pulley.name), laggings, pulley)}
        for pulley, table in zip(drive.pulleys, result["pulley"], strict=True)
    ]
    cases = {row.get("name"): row for row in like.get("load_case", ())}
    if "load_case" in result and len(same) == len(drive.pulleys):
        result["load_case"] = [
            cases[case["name"]]
            if _case(before, case["name"]) == _case(drive, case["name"])
            else case
            for case in result["load_case"]
        ]
    return result


def _lagging_as_in(
    row: Mapping[str, Any] | None, laggings: Mapping[str, Lagging], pulley: Pulley
) -> Tables:
    if row is None or laggings.get(pulley.name) != pulley.lagging:
        return {}
    return {key: row[key] for key in ("lagging", "condition") if key in row}


def _case(drive: Drive, name: str) -> LoadCase | None:
    return next((case for case in drive.load_cases if case.name == name), None)


def _design(drive: Drive) -> Mapping[str, Any]:
    case = _case(drive, DESIGN)
    return case.tensions if case else {}


def _drive_table(drive: Drive) -> Document:
    design = _design(drive)
    conveyor = conveyor_of(drive)
    cases = [case for case in drive.load_cases if case.name != DESIGN and conveyor is None]
    light = conveyor is not None and is_of_conveyor(drive.belt)
    mass = {} if light else {"belt_mass": None}  # one of the two tables has it
    return DRIVE.written(
        drive,
        format=FORMAT,
        belt=_belt_table(drive.belt, light=light),
        pulley=[_pulley_table(pulley, design) for pulley in drive.pulleys],
        load_case=[_case_table(case) for case in cases] or None,
        conveyor=CONVEYOR.written(conveyor, **mass) if conveyor else None,
        **_criteria_tables(drive.criteria),
    )


def _criteria_tables(criteria: Criteria) -> Tables:
    """Return the tables of what a drive is held against, without what is as if left out."""
    parts = {e: getattr(criteria, e.attribute) for e in CRITERIA}
    tables = {e.key: e.kind.written(part) for e, part in parts.items() if part is not None}
    return {key: table for key, table in tables.items() if table}


def _belt_table(belt: Belt, *, light: bool = False) -> Tables:
    """Return the table of a belt, `light` without its mass."""
    belt = with_mass(belt, None) if light else belt
    table = BELT.written(belt)
    preset = _preset_of(belt.name)
    if preset is None:
        return table
    unknown = {"modulus": None} if isnan(preset.modulus) else {}
    usual = BELT.written(preset, **unknown)
    own = with_mass(belt, None) if is_of_layers(belt) else belt  # the preset computes it again
    # a number of one's own that happens to be the usual one is written: it has no band
    for key in ("modulus", "carcass"):
        if getattr(own, f"{key}_ends") != getattr(preset, f"{key}_ends"):
            usual.pop(key, None)
    short = {key: v for key, v in BELT.written(own).items() if v != usual.get(key)}
    # reading a preset says by itself that other numbers are given
    stated = {key: of for key, of in own.sources.items() if of != Provenance()}
    short["sources"] = {key: PROVENANCE.written(of) for key, of in stated.items()}
    short = {"preset": preset.name, **{k: v for k, v in short.items() if v}}
    report = Report()
    again = build_belt(BELT.read(short, (), report), report)
    again = with_mass(again, None) if again is not None and light else again
    return short if again == belt else table


def _preset_of(name: str) -> catalogue.CatalogueBelt | None:
    """Return the belt of the catalogue, or of the standard, that has this very name."""
    try:
        found = catalogue.find_belt(name)
    except InputError:  # a name like that of a standard belt, with a slip
        return None
    return found if found is not None and found.name == name else None


def _pulley_table(pulley: Pulley, design: Mapping[str, Any]) -> Tables:
    tensions = _tensions(design[pulley.name]) if pulley.name in design else {}
    lagging = _in_conditions(pulley) if pulley.conditions else _lagging_keys(pulley.lagging)
    return PULLEY.written(pulley, **lagging, **tensions)


def _case_table(case: LoadCase) -> Tables:
    tensions = {
        name: _tensions(of) | _uncertainty(case.uncertainty.get(name, {}))
        for name, of in case.tensions.items()
    }
    return LOAD_CASE.written(case, pulley=tensions)


def _uncertainty(of: Mapping[str, float]) -> Tables:
    return {UNCERTAINTY: ByName(Percent()).written(of)} if of else {}


def _tensions(tensions: Any) -> Tables:
    return {
        "entry_tension": quantity_text(tensions.entry, "force"),
        "exit_tension": quantity_text(tensions.exit, "force"),
    }


def _lagging_keys(lagging: Lagging) -> Tables:
    """Return the name of a catalogue lagging, or its whole table."""
    if lagging.name not in catalogue.lagging_names():
        return {"lagging": _lagging_table(lagging)}
    conditions = load_lagging_conditions(lagging.name)
    if lagging == conditions[0]:
        return {"lagging": lagging.name}
    if lagging in conditions:
        return {"lagging": lagging.name, "condition": lagging.condition}
    usual, table = _common(conditions[0]), _common(_of_rubber(lagging))
    changed = {
        key: table[key]
        for key in Lagging.LIMITS
        if table.get(key, usual.get(key)) != usual.get(key)
    }
    of_thickness = {key: text for key, text in changed.items() if key == "thickness"}
    for keys in (of_thickness, changed):
        short = {"preset": lagging.name, **keys}
        report = Report()
        record = LAGGING_GIVEN.read(short, ("lagging",), report)
        if Laggings({}, "", False, report).of(record, ())[:1] == (lagging,):
            return {"lagging": short}
    return {"lagging": _lagging_table(lagging)}


def _in_conditions(pulley: Pulley) -> Tables:
    """Return a lagging with a law for each condition that it has."""
    laws = {lagging.condition: lagging for lagging in (pulley.lagging, *pulley.conditions)}
    return {"lagging": _lagging_table(tuple(laws.values()))}


def _lagging_table(laggings: Lagging | Sequence[Lagging]) -> Tables:
    several = (laggings,) if isinstance(laggings, Lagging) else tuple(laggings)
    first = several[0]
    shared = _shared_notes(several)
    commons = [_common(replace(lagging, notes=shared)) for lagging in several]
    if any(common != commons[0] for common in commons):
        message = f"laggings of one file differ in more than their laws: {first.name}"
        raise input_error(message=message, remedy="Write them into files of their own.")
    laws = [_law(lagging, lagging.notes[len(shared) :]) for lagging in several]
    table = {**commons[0], "law": laws if len(laws) > 1 else laws[0]}
    if first.block is None:
        return table
    of_rubber = _common(_of_rubber(replace(first, notes=shared)))
    shaped = _with_blocks({**of_rubber, "law": table["law"]}, first, first.block)
    again = _laggings_of(shaped)
    same = again == several and all(lagging.block == first.block for lagging in again)
    return shaped if same else table


def _with_blocks(table: Tables, lagging: Lagging, block: Block) -> Tables:
    """Return the table of a lagging with its blocks in the place of the moduli that they make."""
    made = ("compression_modulus", *(("shear_modulus",) if _follows(lagging) else ()))
    sources = {k: of for k, of in (table.get("sources") or {}).items() if k not in made}
    rest = {key: value for key, value in table.items() if key not in (*made, "sources")}
    return {**rest, "block": BLOCK.written(block), **({"sources": sources} if sources else {})}


def _follows(lagging: Lagging) -> bool:
    """Whether blocks on a part of the area make the shear modulus out of the elastic modulus."""
    contact, young = lagging.contact_fraction, lagging.elastic_modulus
    return contact < 1.0 and young is not None and lagging.shear_modulus == contact * (young / 3.0)


def _of_rubber(lagging: Lagging) -> Lagging:
    """Return a lagging with the shear modulus, and its source, that files have beside blocks."""
    contact = lagging.contact_fraction
    if contact == 1.0 or _follows(lagging):
        return lagging
    quotient, sources = lagging.shear_modulus / contact, dict(lagging.sources)
    # the shortest whose product it is: a division leaves digits, and may miss by the last one
    near = (float(f"{quotient:.14g}"), quotient, nextafter(quotient, 0.0), nextafter(quotient, inf))
    shear = next((g for g in near if contact * g == lagging.shear_modulus), quotient)
    of = sources.pop("shear_modulus", None)
    if of is not None:
        of = replace(of, note=of.note.removeprefix(shear_note(contact)).removeprefix("; "))
        if of != replace(lagging.provenance, note=""):
            sources["shear_modulus"] = of
    return replace(lagging, shear_modulus=shear, sources=sources)


def _laggings_of(table: Tables) -> tuple[Lagging, ...]:
    """Return the laggings that a table is read as; none if it is refused."""
    report = Report()
    record = LAGGING_GIVEN.read(table, ("lagging",), report)
    return Laggings({}, "", False, report).of(record, ())


def _shared_notes(laggings: Sequence[Lagging]) -> tuple[str, ...]:
    """Return the notes that all begin with; the others go with each law."""
    together = zip(*(lagging.notes for lagging in laggings), strict=False)
    return tuple(notes[0] for notes in takewhile(lambda notes: len(set(notes)) == 1, together))


def _common(lagging: Lagging) -> Tables:
    moduli = ("shear_modulus", "compression_modulus")
    rigid = lagging.thickness == 0.0 and lagging.elastic_modulus is None
    rigid = rigid and all(getattr(lagging, key) == float("inf") for key in moduli)
    of_law = ("law", SCALED, WORN, "slip_speed_factor", "temperature_factor")
    sources = {k: PROVENANCE.written(of) for k, of in lagging.sources.items() if k not in of_law}
    elsewhere: Tables = dict.fromkeys(
        (*moduli, "block") if rigid else ("block",)
    )  # blocks are written by `_with_blocks`
    of = _factors(lagging)
    for key in ("slip_speed", "temperature"):
        value = getattr(of, key, None)
        elsewhere[key] = None if value is None else quantity_text(value, _DIMENSIONS[key])
    elsewhere["condition_factor"] = [
        {
            "condition": name,
            "factor": known.factor,
            "provenance": PROVENANCE.written(known.source),
        }
        for name, known in lagging.condition_factors.items()
    ] or None
    return LAGGING_GIVEN.written(lagging, law=None, sources=sources or None, **elsewhere)


_DIMENSIONS: dict[str, Dimension] = {"slip_speed": "speed", "temperature": "temperature"}


def _factors(lagging: Lagging) -> Factors | None:
    """Return the factors of a law that still is what they make of the tested one."""
    of = lagging.factors
    return of if of is not None and of.used == lagging.law else None


def _factor_table(key: str, factor: FrictionFactor | None) -> Tables | None:
    if factor is None:
        return None
    return {
        key: [quantity_text(value, _DIMENSIONS[key]) for value in factor.at],
        "factor": list(factor.factor),
        "provenance": PROVENANCE.written(factor.source),
    }


def _law(lagging: Lagging, notes: Sequence[str]) -> Tables:
    own, scaled = lagging.sources.get("law"), lagging.sources.get(SCALED)
    of = _factors(lagging)
    return law_table(
        lagging.law if of is None else of.law,
        slip_speed_factor=_factor_table("slip_speed", of.by_slip_speed) if of else None,
        temperature_factor=_factor_table("temperature", of.by_temperature) if of else None,
        condition=lagging.condition,
        provenance=PROVENANCE.written(own) if own else None,
        condition_factor=lagging.scaled_by,
        condition_source=PROVENANCE.written(scaled) if scaled else None,
        fit=FIT.written(lagging.fit) if lagging.fit else None,
        notes=list(notes) or None,
    )
