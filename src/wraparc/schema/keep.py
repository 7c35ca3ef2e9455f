"""Keeping what the user wrote: units and form of values that have not changed."""

from typing import Any

from wraparc.schema.kinds import ByName, Kind, OneOrMore, Rows, TextOr, table_labels
from wraparc.schema.problems import NOTHING, Report
from wraparc.schema.tables import Table, Variant


def kept(value: Any, like: Any, kind: Kind) -> Any:
    """Return `value` with every part that reads as the same part of `like` taken from there."""
    if _same(value, like, kind):
        return like
    if isinstance(kind, TextOr):
        kind = kind.table
    if isinstance(kind, Variant) and isinstance(value, dict):
        kind = kind.tables.get(value.get(kind.tag, ""), kind)
    if isinstance(kind, OneOrMore) and isinstance(value, dict):
        kind = kind.kind
        return kept(value, like[0] if isinstance(like, list) and len(like) == 1 else like, kind)
    if isinstance(kind, Table) and isinstance(value, dict) and isinstance(like, dict):
        like = {**like, **{e.key: like[e.alias] for e in kind.entries if e.alias in like}}
        kinds = {entry.key: entry.kind for entry in kind.entries}
        return {
            key: kept(item, like[key], kinds[key]) if key in like else item
            for key, item in value.items()
        }
    if isinstance(kind, ByName) and isinstance(value, dict) and isinstance(like, dict):
        return {
            key: kept(item, like[key], kind.kind) if key in like else item
            for key, item in value.items()
        }
    if isinstance(kind, Rows | OneOrMore) and isinstance(value, list) and isinstance(like, list):
        by_label = dict(zip(table_labels(like), like, strict=True))
        return [
            kept(item, by_label[label], kind.kind) if label in by_label else item
            for label, item in zip(table_labels(value), value, strict=True)
        ]
    return value


def _same(value: Any, like: Any, kind: Kind) -> bool:
    report = Report()
    read = kind.read(value, (), report)
    return read is not NOTHING and read == kind.read(like, (), report) and not report.problems
