"""What may stand below a value of a kind: the kinds along a key path."""

from typing import Any

from wraparc.schema.kinds import ByName, Kind, OneOrMore, Rows, TextOr, WordOr
from wraparc.schema.tables import Table, Variant


def tables_of(kind: Kind | None, raw: object = None) -> tuple[Table, ...]:
    """Return the tables that a value of a kind may be; of a variant all, unless `raw` says one."""
    if isinstance(kind, Table):
        return (kind,)
    if isinstance(kind, Variant):
        named = kind.tables.get(str(raw.get(kind.tag))) if isinstance(raw, dict) else None
        return (named,) if named else tuple(kind.tables.values())
    if isinstance(kind, TextOr):
        return tables_of(kind.table, raw)
    within = getattr(kind, "within", None)  # of a kind that another one reads for it
    if isinstance(within, Kind):
        return tables_of(within, raw)
    return tables_of(kind.kind, raw) if isinstance(kind, WordOr | OneOrMore) else ()


def own_key(kind: Kind | None, step: str | int) -> str | int:
    """Return the key that is meant by another word for it."""
    entries = (e for table in tables_of(kind) for e in table.entries)
    return next((e.key for e in entries if e.alias and e.alias == step), step)


def below(kind: Kind | None, step: str | int, raw: object = None) -> Kind | None:
    """Return what may stand under a key, a name or a position; None if nothing may.

    Parameters
    ----------
    kind
        What the value is.
    step
        The key, name or position.
    raw
        The value, which may say which of several tables it is.
    """
    while isinstance(kind, WordOr):
        kind = kind.kind
    position = isinstance(step, int) or step.isdecimal()
    if isinstance(kind, ByName | Rows) or (isinstance(kind, OneOrMore) and position):
        return kind.kind
    key: Any = own_key(kind, step)
    found = [e.kind for table in tables_of(kind, raw) for e in table.entries if e.key == key]
    return found[-1] if found else None
