"""A lagging table, its keys already read, to laggings: one for each of its laws."""

from dataclasses import fields, replace
from typing import Any

from wraparc.drive import Block, ConditionFactor, Factors, Lagging, compression_modulus
from wraparc.drive.conditions import SCALED
from wraparc.drive.lagging import UNCERTAIN_OF_LAGGING
from wraparc.files.lagging_keys import (
    BLOCK,
    CONDITION_FACTOR,
    COST,
    FIT,
    LAGGING_FILE,
    SPEED_FACTOR,
    TEMPERATURE_FACTOR,
)
from wraparc.files.laws import read_law
from wraparc.friction import FrictionLaw
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance, read_provenance, read_sources
from wraparc.schema.problems import Report
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import read_uncertainty
from wraparc.units import display

_KEYS = tuple(entry.key for entry in LAGGING_FILE.entries)
_MEASURED = ("thickness", "shear_modulus", "compression_modulus")
#: Keys of a table of their own, and keys that are fields of a lagging as they stand.
_TABLES = ("law", "block", "cost", "uncertainty", "provenance", "sources", "notes")
_SAME = tuple(
    part.name
    for part in fields(Lagging)
    if part.name in _KEYS and part.name not in (*_TABLES, *_MEASURED)
)
_ELASTIC = ("elastic_modulus", "shear_modulus", "compression_modulus", "block")


def build_laggings(record: Record, report: Report) -> tuple[Lagging, ...]:
    """Return the laggings of a table; none if anything was or is reported about it."""
    found = len(report.problems)
    sources = read_sources(record, _KEYS, report)
    common: dict[str, Any] = {key: record[key] for key in _SAME if key in record}
    common["provenance"] = own_provenance(record, report) or Provenance()
    common["uncertainty"] = read_uncertainty(record, UNCERTAIN_OF_LAGGING, report)
    common["cost"] = COST.built(record.get("cost"), report)
    common |= _elasticity(record, sources, common["provenance"], report)
    laws = [law for law in record.get("law", ()) if isinstance(law, Record)]
    notes = tuple(record.get("notes", ()))
    common["condition_factors"] = _condition_factors(record, report)
    parts = [_law_parts(law, record, sources, notes, report) for law in laws]
    _check_conditions(laws, report)
    if not record.get("law") and record.sound("law"):
        report.add((*record.place, "law"), "missing", "Add a [law] table, as the examples show.")
    if len(report.problems) > found or not record.sound():
        return ()
    made = report.tried(
        lambda: tuple(Lagging(**common, **part) for part in parts), record.place, record.raw
    )
    return made or ()


def _law_parts(
    law: Record,
    record: Record,
    sources: dict[str, Provenance],
    notes: tuple[str, ...],
    report: Report,
) -> dict[str, Any]:
    """Return what a law gives to its lagging: the law, its condition, fit, notes and sources."""
    own, scaled = own_provenance(law, report), None
    if isinstance(law.get("condition_source"), Record):
        scaled = read_provenance(law["condition_source"], report)
    parts = {"law": own, SCALED: scaled}
    tested = read_law(law, report)
    factors = _factors(tested, law, record, report) if tested is not None else None
    if factors is not None:
        parts |= factors.sources
    return {
        "law": factors.used if factors is not None else tested,
        "factors": factors,
        "condition": law.get("condition", "dry"),
        "scaled_by": law.get("condition_factor"),
        "fit": FIT.built(law.get("fit"), report),
        "notes": (*notes, *law.get("notes", ())),
        "sources": sources | {part: of for part, of in parts.items() if of},
    }


def _factors(tested: FrictionLaw, law: Record, record: Record, report: Report) -> Factors | None:
    """Return what speed and temperature do to a law; None where nothing is said of them."""
    tables: dict[str, Any] = {}
    for key, table in (("slip_speed", SPEED_FACTOR), ("temperature", TEMPERATURE_FACTOR)):
        if f"{key}_factor" in law:
            source = read_provenance(law[f"{key}_factor"].get("provenance"), report)
            found = table.built(law[f"{key}_factor"], report, source=source)
            if found is None:
                return None
            tables[f"by_{key}"] = found
        if key in record:
            tables[key] = record[key]
    if not tables:
        return None
    made: Factors | None = report.tried(
        lambda: Factors(law=tested, **tables), record.place, record.raw
    )
    return made


def _condition_factors(record: Record, report: Report) -> dict[str, ConditionFactor]:
    found = {}
    for row in record.get("condition_factor", ()):
        if isinstance(row, Record) and row.sound():
            source = read_provenance(row["provenance"], report)
            found[row["condition"]] = CONDITION_FACTOR.built(row, report, source=source)
    return {name: factor for name, factor in found.items() if factor is not None}


def _check_conditions(laws: list[Record], report: Report) -> None:
    seen: set[str] = set()
    for law in laws:
        condition = law.get("condition", "dry")
        if condition in seen:
            message = "a second law for this condition"
            place = (*law.place, "condition")
            report.add(place, message, "Give each law its own condition.", condition)
        seen.add(condition)


def _elasticity(
    record: Record, sources: dict[str, Provenance], provenance: Provenance, report: Report
) -> dict[str, Any]:
    """Return thickness and moduli, those not given estimated from those given.

    What is estimated says so in `sources`: G = E/3 of an incompressible rubber, E = 3 G,
    and the compression modulus from E and the shape of the blocks, or equal to E. Moduli that are
    given with blocks are those of the rubber: over the gross area the blocks shear by f G.
    """
    given = [key for key in _ELASTIC if key in record]
    if not record.sound("thickness", *_ELASTIC):
        return {}
    if "thickness" not in record:
        if given:
            place = (*record.place, "thickness")
            report.add(place, f"missing: {given[0]} needs it", 'Write thickness = "12 mm".')
        return {}
    if "compression_modulus" in record and "block" in record:
        message = "contradicts compression_modulus"
        report.add((*record.place, "block"), message, "Remove one of them.")
        return {}
    known = "elastic_modulus" in record or "shear_modulus" in record
    if not known and record["thickness"] > 0.0:
        place = (*record.place, "shear_modulus")
        remedy = "Give shear_modulus or elastic_modulus."
        report.add(place, "missing for a lagging with thickness", remedy)
        return {}
    stated = {key: record[key] for key in _MEASURED if key in record}
    return stated | _estimated(record, sources, provenance, report) if known else stated


def _estimated(
    record: Record, sources: dict[str, Provenance], provenance: Provenance, report: Report
) -> dict[str, Any]:
    """Return the moduli over the gross area, and say in `sources` how they were estimated."""
    least = Block.LIMITS["height"].least
    shape = record.get("block", record.get("replaced_block", {}))
    height = {} if "height" in shape else {"height": record["thickness"]}
    if "block" in record and height and record["thickness"] < least:
        message = f"must be at least {display(least, 'length')} with blocks"
        remedy = "Give the thickness, or a lagging without blocks."
        report.add((*record.place, "thickness"), message, remedy, record.raw.get("thickness"))
        return {}
    height = {key: max(value, least) for key, value in height.items()}
    block: Block | None = BLOCK.built(shape, report, **height)
    moduli: dict[str, Any] = {"block" if "block" in record else "replaced_block": block}
    contact = 1.0 if block is None else block.contact_fraction
    moduli |= _shear_modulus(record, contact, sources, provenance)
    if "compression_modulus" not in record:
        basis = "elastic_modulus" if "elastic_modulus" in record else "shear_modulus"
        young = record[basis] * (1.0 if basis == "elastic_modulus" else 3.0)
        moduli["compression_modulus"] = compression_modulus(young, block) if block else young
        text = _compression_note(block, "E" if basis == "elastic_modulus" else "3 G")
        of = sources.get("block" if "block" in sources else basis, provenance)
        sources.setdefault("compression_modulus", replace(of, note=f"estimated: {text}"))
    return moduli


def _shear_modulus(
    record: Record, contact: float, sources: dict[str, Provenance], provenance: Provenance
) -> dict[str, float]:
    """Return f G of blocks that cover a part of the area, or E/3 where G is not given."""
    if "shear_modulus" not in record:
        text = "G = E/3, incompressible rubber"
        if contact < 1.0:
            text += of_blocks(contact)
        of = sources.get("elastic_modulus", provenance)
        sources.setdefault("shear_modulus", replace(of, note=f"estimated: {text}"))
        return {"shear_modulus": contact * (record["elastic_modulus"] / 3.0)}
    if contact == 1.0:
        return {}
    own = sources.get("shear_modulus")
    note = shear_note(contact)
    if own is not None and own.note:
        note += f"; {own.note}"
    sources["shear_modulus"] = replace(own or provenance, note=note)
    return {"shear_modulus": contact * record["shear_modulus"]}


def of_blocks(contact: float) -> str:
    """Say what a shear modulus of the rubber became where blocks cover a part of the area."""
    return f", over the gross area times the contact fraction {contact:g}"


def shear_note(contact: float) -> str:
    """Say how a shear modulus that was given for the rubber came to be that over the gross area."""
    return f"estimated: G of the rubber{of_blocks(contact)}"


def _compression_note(block: Block | None, modulus: str) -> str:
    if block is None:
        return f"E_c = {modulus}, no stiffening by the shape of blocks"
    return (
        f"E_c from {modulus} and the shape of the blocks, Gent and Lindley (1959), "
        f"{block.shape}, S = {block.shape_factor:.3g}, k = {block.stiffening:g}, "
        f"contact fraction {block.contact_fraction:g}"
    )
