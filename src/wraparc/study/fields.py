"""Fields of a drive file by key path: what may be written there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from wraparc.drive import Limit
from wraparc.errors import input_error
from wraparc.schema.below import below, own_key, tables_of
from wraparc.schema.kinds import Kind, Quantity, TextOr, WordOr, table_labels
from wraparc.schema.overrides import parse_path
from wraparc.schema.problems import Place, place_text
from wraparc.schema.source import Document
from wraparc.schema.tables import unknown_key_remedy
from wraparc.train.columns import OF_DRUM
from wraparc.train.keys import TRAIN_FILE

#: From the key path of a field to its words.
Called = Callable[[str], str]

FRICTION_FACTOR, SLIP_FACTOR = "friction_factor", "slip_factor"
#: Keys below the lagging of a pulley that no drive file has: they scale its law.
SCALING = (FRICTION_FACTOR, SLIP_FACTOR)
FACTOR = Quantity("number", Limit("number", open=True, most=100.0))
#: Keys of a pulley that no drive file has: depth worn off its lagging, and within a train its share
#: of the load or its trim, the speeds of the others held.
DRUM_KEYS: Mapping[str, Quantity] = {
    key: Quantity(OF_DRUM[key].dimension, OF_DRUM[key]) for key in ("wear", "share", "speed_trim")
}


def label_of(field: str, alone: str = "") -> str:
    """Return a field in words: ``wrap angle of pulley head``.

    Parameters
    ----------
    field
        Its key path.
    alone
        The pulley that need not be named.
    """
    *above, key = (str(step).replace("_", " ") for step in parse_path(field))
    match above:
        case ["pulley", name, *parts]:
            of = [f"the {part}" for part in reversed(parts)]
            of += [] if name == alone else [f"pulley {name}"]
        case ["belt"]:
            if key == "preset":
                return "belt"
            of = ["the belt"]
        case _:
            of = [" ".join(above)] if above else []
    return " of ".join([key, *of])


def names_of(data: Mapping[str, Any]) -> Called:
    """Return the words of the fields of a study; a pulley that all are of is not named."""
    paths = [parse_path(field) for field in (*data["levels"], *data["drawn"])]
    pulleys = {str(path[1]) for path in paths if len(path) > 2 and path[0] == "pulley"}
    alone = next(iter(pulleys)) if len(pulleys) == 1 else ""

    def called(field: str) -> str:
        return label_of(field, alone)

    return called


def canonical(steps: Place, document: Document) -> Place:
    """Return a key path with tables of arrays called by their names, and keys by their own."""
    node: Any = document
    kind: Kind | None = TRAIN_FILE
    found: list[str | int] = []
    for step in steps:
        name = own_key(kind, step)
        if isinstance(node, list):
            labels = table_labels(node)
            if isinstance(step, int) and 1 <= step <= len(labels):
                name = labels[step - 1]
            place = labels.index(name) if name in labels else -1
            node = node[place] if place >= 0 else None
        else:
            node = node.get(step) if isinstance(node, dict) else None
        kind = below(kind, name)
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
    if len(steps) == 3 and steps[0] == "pulley" and steps[2] in DRUM_KEYS:
        return DRUM_KEYS[str(steps[2])]
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
    found = below(kind, step)
    if found is not None:
        return found
    keys = list(dict.fromkeys(e.key for table in tables_of(kind) for e in table.entries))
    if not keys:
        message = f"{place_text(place[:-1])} is a value, with nothing below it"
        raise input_error(message=message)
    known: Sequence[str] = (*keys, *SCALING) if len(place) == 4 and place[2] == "lagging" else keys
    if len(place) == 3 and place[0] == "pulley":
        known = [*keys, *DRUM_KEYS]
    raise input_error(message="no such drive field", remedy=unknown_key_remedy(str(step), known))
