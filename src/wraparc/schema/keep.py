"""Keeping what the user wrote: units and form of values that have not changed."""

from typing import Any

from wraparc.schema.below import below, tables_of
from wraparc.schema.kinds import Kind, OneOrMore, table_labels
from wraparc.schema.problems import NOTHING, Report


def kept(value: Any, like: Any, kind: Kind | None) -> Any:
    """Return `value` with every part that reads as the same part of `like` taken from there."""
    if kind is None:
        return value
    if _same(value, like, kind):
        return like
    if isinstance(kind, OneOrMore) and isinstance(value, dict) and isinstance(like, list):
        like = like[0] if len(like) == 1 else like
    if isinstance(value, dict) and isinstance(like, dict):
        entries = [e for table in tables_of(kind, value) for e in table.entries]
        like = {**like, **{e.key: like[e.alias] for e in entries if e.alias in like}}
        return {
            key: kept(item, like[key], below(kind, key, value)) if key in like else item
            for key, item in value.items()
        }
    if isinstance(value, list) and isinstance(like, list):
        by_label = dict(zip(table_labels(like), like, strict=True))
        return [
            kept(item, by_label[label], below(kind, 1)) if label in by_label else item
            for label, item in zip(table_labels(value), value, strict=True)
        ]
    return value


def _same(value: Any, like: Any, kind: Kind) -> bool:
    report = Report()
    read = kind.read(value, (), report)
    return read is not NOTHING and read == kind.read(like, (), report) and not report.problems
