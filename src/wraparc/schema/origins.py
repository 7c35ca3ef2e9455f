"""Provenance tables, and where the numbers of a table with a preset come from."""

from collections.abc import Iterable

from wraparc.provenance import Kind, Provenance
from wraparc.schema.problems import Report
from wraparc.schema.shared_keys import PROVENANCE
from wraparc.schema.tables import Record, unknown_key_remedy


def read_provenance(record: Record, report: Report) -> Provenance | None:
    """Return the provenance of a table of its keys, or None after reporting."""
    kind = {"kind": Kind(record["kind"])} if "kind" in record else {}
    made: Provenance | None = PROVENANCE.built(record, report, **kind)
    return made


def read_sources(record: Record, keys: Iterable[str], report: Report) -> dict[str, Provenance]:
    """Return the ``sources`` of a table by key, reporting names that are no keys."""
    keys = [key for key in keys if key not in ("sources", "provenance", "name", "preset")]
    sources = {}
    for key, table in record.get("sources", {}).items():
        if key not in keys:
            place = (*record.place, "sources", key)
            remedy = "" if report.full else unknown_key_remedy(key, keys)
            report.add(place, "is no key of this table", remedy)
        elif isinstance(table, Record):
            provenance = read_provenance(table, report)
            if provenance is not None:
                sources[key] = provenance
    return sources


def own_provenance(record: Record, report: Report) -> Provenance | None:
    """Return the ``provenance`` of a table, or None if it has none or a faulty one."""
    table = record.get("provenance")
    return read_provenance(table, report) if isinstance(table, Record) else None
