"""Drives and laggings to files that read back equal."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import takewhile
from typing import Any

from wraparc import catalogue
from wraparc.conveyor.keys import CONVEYOR
from wraparc.drive import (
    DESIGN,
    Belt,
    Criteria,
    Drive,
    Lagging,
    Limit,
    LoadCase,
    Pulley,
)
from wraparc.drive.conditions import SCALED
from wraparc.errors import InputError, Problem
from wraparc.files.conveyor_build import conveyor_of
from wraparc.files.drive_build import Laggings, build_belt
from wraparc.files.drive_file import drive_from_document
from wraparc.files.drive_keys import BELT, CRITERIA, DRIVE
from wraparc.files.lagging_file import load_lagging_conditions
from wraparc.files.lagging_keys import COST, FIT, LAGGING_GIVEN
from wraparc.files.law_tables import law_table
from wraparc.provenance import Provenance
from wraparc.saving import save_file
from wraparc.schema.emit import document_text
from wraparc.schema.keep import kept
from wraparc.schema.problems import Report
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.shared_keys import FORMAT, PROVENANCE
from wraparc.schema.source import Document

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
    return document_text(drive_document(drive, like=like))


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
    return document_text({"format": FORMAT, **_lagging_table(laggings)})


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
    document: Document = {"format": FORMAT}
    document |= {key: text for key in ("title", "description") if (text := getattr(drive, key))}
    document["creep_limit"] = quantity_text(drive.creep_limit, "length")
    document |= _criteria_tables(drive.criteria)
    document["belt"] = _belt_table(drive.belt)
    if conveyor is not None:
        document["conveyor"] = CONVEYOR.written(conveyor)
    document["pulley"] = [_pulley_table(pulley, design) for pulley in drive.pulleys]
    cases = [case for case in drive.load_cases if case.name != DESIGN]
    if cases and conveyor is None:
        document["load_case"] = [
            {
                "name": c.name,
                **({} if c.kind == "running" else {"kind": c.kind}),
                **({"condition": c.condition} if c.condition else {}),
                "pulley": {name: _tensions(t) for name, t in c.tensions.items()},
            }
            for c in cases
        ]
    return document


def _criteria_tables(criteria: Criteria) -> Tables:
    """Return the tables of what a drive is held against, without what is as if left out."""
    parts = {e: getattr(criteria, e.attribute) for e in CRITERIA}
    tables = {e.key: e.kind.written(part) for e, part in parts.items() if part is not None}
    return {key: table for key, table in tables.items() if table}


def _belt_table(belt: Belt) -> Tables:
    texts = {key: getattr(belt, key) for key in ("name", "kind")}
    explicit = {
        **{key: text for key, text in texts.items() if text},
        **_quantities(belt, Belt.LIMITS),
        **_origins(belt.provenance, belt.sources),
    }
    preset = next((b for b in catalogue.belts() if b.name == belt.name), None)
    if preset is not None:
        same = {key for key in explicit if getattr(belt, key) == getattr(preset, key, None)}
        short = {key: value for key, value in explicit.items() if key not in same}
        short["sources"] = _stated(belt.sources)
        short = {"preset": preset.name, **{k: v for k, v in short.items() if v}}
        report = Report()
        if build_belt(BELT.read(short, (), report), report) == belt:
            return short
    return explicit


def _pulley_table(pulley: Pulley, design: Mapping[str, Any]) -> Tables:
    sizes = _quantities(pulley, Pulley.LIMITS)
    table: Tables = {"name": pulley.name}
    table |= {key: sizes.pop(key) for key in ("diameter", "wrap_angle")}
    table |= _lagging_keys(pulley.lagging) if not pulley.conditions else _in_conditions(pulley)
    if pulley.name in design:
        table |= _tensions(design[pulley.name])
    table |= sizes
    if not pulley.recovery:
        table["recovery"] = False
    sources = _stated(pulley.sources, all_of_them=True)
    return table | ({"sources": sources} if sources else {})


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
    changed = {
        key: text
        for key, text in _quantities(lagging, Lagging.LIMITS).items()
        if getattr(lagging, key) != getattr(conditions[0], key)
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
        raise InputError(Problem(message=message, remedy="Write them into files of their own."))
    laws = [_law(lagging, lagging.notes[len(shared) :]) for lagging in several]
    return {**commons[0], "law": laws if len(laws) > 1 else laws[0]}


def _shared_notes(laggings: Sequence[Lagging]) -> tuple[str, ...]:
    """Return the notes that all begin with; the others go with each law."""
    together = zip(*(lagging.notes for lagging in laggings), strict=False)
    return tuple(notes[0] for notes in takewhile(lambda notes: len(set(notes)) == 1, together))


def _common(lagging: Lagging) -> Tables:
    texts = {key: getattr(lagging, key) for key in ("title", "description", "surface")}
    table: Tables = {"name": lagging.name, **{key: text for key, text in texts.items() if text}}
    moduli = ("shear_modulus", "compression_modulus")
    rigid = lagging.thickness == 0.0 and lagging.elastic_modulus is None
    rigid = rigid and all(getattr(lagging, key) == float("inf") for key in moduli)
    quantities = _quantities(lagging, Lagging.LIMITS)
    table |= {key: text for key, text in quantities.items() if not (rigid and key in moduli)}
    if lagging.cost is not None:
        table["cost"] = COST.written(lagging.cost)
    if lagging.notes:
        table["notes"] = list(lagging.notes)
    sources = {key: of for key, of in lagging.sources.items() if key not in ("law", SCALED)}
    return table | _origins(lagging.provenance, sources)


def _law(lagging: Lagging, notes: Sequence[str]) -> Tables:
    table = {"condition": lagging.condition, **law_table(lagging.law)}
    if "law" in lagging.sources:
        table["provenance"] = PROVENANCE.written(lagging.sources["law"])
    if SCALED in lagging.sources:
        table["condition_source"] = PROVENANCE.written(lagging.sources[SCALED])
    if notes:
        table["notes"] = list(notes)
    return table | ({"fit": FIT.written(lagging.fit)} if lagging.fit else {})


def _quantities(thing: object, limits: Mapping[str, Limit]) -> Tables:
    """Return the numbers of a description that are not None as texts with units."""
    values = {key: getattr(thing, key) for key in limits}
    return {
        key: "rigid" if value == float("inf") else quantity_text(value, limits[key].dimension)
        for key, value in values.items()
        if value is not None
    }


def _origins(provenance: Provenance, sources: Mapping[str, Provenance]) -> Tables:
    tables: Tables = {}
    if provenance != Provenance():
        tables["provenance"] = PROVENANCE.written(provenance)
    if sources:
        tables["sources"] = _stated(sources, all_of_them=True)
    return tables


def _stated(sources: Mapping[str, Provenance], all_of_them: bool = False) -> Tables:
    """Return sources as tables; without those that reading a preset makes by itself."""
    return {
        key: PROVENANCE.written(of)
        for key, of in sources.items()
        if all_of_them or of != Provenance()
    }
