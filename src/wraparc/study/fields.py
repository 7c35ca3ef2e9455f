"""Fields of a drive file by key path: what may be written there."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from wraparc.drive import Limit
from wraparc.errors import InputError, Problem
from wraparc.schema.kinds import (
    ByName,
    Kind,
    OneOrMore,
    Quantity,
    Rows,
    TextOr,
    WordOr,
    table_labels,
)
from wraparc.schema.problems import Place, place_text
from wraparc.schema.shared_keys import ALIASES
from wraparc.schema.source import Document
from wraparc.schema.tables import Table, Variant, unknown_key_remedy
from wraparc.train.keys import TRAIN_FILE

FRICTION_FACTOR, SLIP_FACTOR = "friction_factor", "slip_factor"
#: Keys below the lagging of a pulley that no drive file has: they scale its law.
SCALING = (FRICTION_FACTOR, SLIP_FACTOR)
FACTOR = Quantity("number", Limit("number", open=True, most=100.0))


def canonical(steps: Place, document: Document) -> Place:
    """Return a key path with tables of arrays called by their names, and keys by their own."""
    node: Any = document
    found: list[str | int] = []
    for step in steps:
        name: str | int = step
        if isinstance(node, list):
            labels = table_labels(node)
            if isinstance(step, int) and 1 <= step <= len(labels):
                name = labels[step - 1]
            place = labels.index(name) if name in labels else -1
            node = node[place] if place >= 0 else None
        else:
            if isinstance(step, str) and len(found) == 2 and found[0] == "pulley":
                name = ALIASES.get(step, step)
            node = node.get(step) if isinstance(node, dict) else None
        found.append(name)
    return tuple(found)


def kind_of(steps: Place) -> Kind:
    """Return what may stand at a key path of a drive file.

    Raises
    ------
    InputError
        If there is no such key, with the nearest ones.
    """
    if len(steps) == 4 and steps[0] == "pulley" and steps[2] == "lagging" and steps[3] in SCALING:
        return FACTOR
    kind: Kind = TRAIN_FILE
    for number, step in enumerate(steps):
        kind = _below(kind, step, steps[: number + 1])
    return _plain(kind)


def _plain(kind: Kind) -> Kind:
    """Return the kind of a value where a word, or a table, might stand instead."""
    while isinstance(kind, WordOr | TextOr):
        kind = kind.kind if isinstance(kind, WordOr) else kind.text
    return kind


def _below(kind: Kind, step: str | int, place: Place) -> Kind:
    if isinstance(kind, WordOr):
        return _below(kind.kind, step, place)
    if isinstance(kind, TextOr):
        return _below(kind.table, step, place)
    if isinstance(kind, ByName | Rows):
        return kind.kind
    if isinstance(kind, OneOrMore):
        position = isinstance(step, int) or step.isdecimal()
        return kind.kind if position else _below(kind.kind, step, place)
    tables: Iterable[Table] = ()
    if isinstance(kind, Table):
        tables = (kind,)
    elif isinstance(kind, Variant):
        tables = kind.tables.values()
    keys: dict[str, Kind] = {e.key: e.kind for table in tables for e in reversed(table.entries)}
    if step in keys:
        return keys[str(step)]
    if not keys:
        message = f"{place_text(place[:-1])} is a value, with nothing below it"
        raise InputError(Problem(message=message))
    known = (*keys, *SCALING) if len(place) == 4 and place[2] == "lagging" else tuple(keys)
    raise InputError(
        Problem(
            message="a drive file has no such field",
            remedy=unknown_key_remedy(str(step), known),
        )
    )
