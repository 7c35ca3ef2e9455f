"""Tables of keys: which keys a table may hold, read with everything that is wrong at once."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from wraparc.errors import nearest, shown
from wraparc.schema.kinds import Choice, Kind, Quantity
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.units import DIMENSION_TEXT


@dataclass(eq=False, repr=False)
class Entry:
    """One key of a table.

    Parameters
    ----------
    key, kind
        How it is written.
    title, meaning
        Label and help text of a form field.
    required
        Whether it must be there.
    alias
        Another key that is read as this one.
    example
        What to write if it is missing; needed where the kind does not tell.
    """

    key: str
    kind: Kind
    title: str = ""
    meaning: str = ""
    required: bool = False
    alias: str = ""
    example: str = ""


class Record(dict[str, Any]):
    """A table as read: the values of its keys that are there and could be read.

    `faulty` are the keys that are missing or hold a fault, however deep; `place` and `raw`
    say where the table stood and what it held.
    """

    def __init__(
        self,
        values: Mapping[str, Any],
        place: Place,
        raw: Mapping[str, object],
        faulty: Iterable[str] = (),
    ) -> None:
        super().__init__(values)
        self.place = place
        self.raw = raw
        self.faulty = set(faulty)

    def sound(self, *keys: str) -> bool:
        """Whether none of the keys is faulty; of all keys if none are named."""
        return self.faulty.isdisjoint(keys) if keys else not self.faulty


@dataclass(eq=False, repr=False)
class Table(Kind):
    """A table with known keys; any other key is a fault."""

    entries: tuple[Entry, ...]
    title: str = ""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return a `Record`."""
        if not isinstance(raw, dict):
            report.add(place, "must be a table", "Write its keys below its name in [ ].", raw)
            return NOTHING
        given = self._renamed(raw, place, report)
        known = {entry.key: entry for entry in self.entries}
        for key in [key for key in given if key not in known]:
            remedy = "" if report.full else unknown_key_remedy(key, known)
            report.add((*place, key), "unknown key", remedy, given[key])
        record = Record({}, place, given)
        for key, entry in known.items():
            if key in given:
                value = entry.kind.read(given[key], (*place, key), report)
                if not _sound(value):
                    record.faulty.add(key)
                if value is not NOTHING:
                    record[key] = value
            elif entry.required:
                record.faulty.add(key)
                report.add((*place, key), "missing", missing_remedy(entry))
        return record

    def having(self, *entries: Entry) -> "Table":
        """Return the table with other entries in place of those of the same keys."""
        other = {entry.key: entry for entry in entries}
        return Table(tuple(other.get(entry.key, entry) for entry in self.entries), self.title)

    def _renamed(self, raw: dict[str, Any], place: Place, report: Report) -> dict[str, Any]:
        given = dict(raw)
        for entry in self.entries:
            if not entry.alias or entry.alias not in given:
                continue
            value = given.pop(entry.alias)
            if entry.key in given:
                message = f"means the same as {entry.key}, which is also there"
                report.add((*place, entry.alias), message, "Keep one of them.", value)
            else:
                given[entry.key] = value
        return given

    def schema(self) -> dict[str, Any]:
        """An object without other keys."""
        properties = {}
        for entry in self.entries:
            words = {"title": entry.title or entry.key.replace("_", " ").capitalize()}
            if entry.meaning:
                words["description"] = entry.meaning
            properties[entry.key] = words | entry.kind.schema()
        return {
            "type": "object",
            **({"title": self.title} if self.title else {}),
            "properties": properties,
            "required": [entry.key for entry in self.entries if entry.required],
            "additionalProperties": False,
        }


@dataclass(eq=False, repr=False)
class Variant(Kind):
    """A table whose keys depend on the word under one of them."""

    tag: str
    tables: Mapping[str, Table]

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the `Record` of the variant that the tag names."""
        if not isinstance(raw, dict):
            report.add(place, "must be a table", "Write its keys below its name in [ ].", raw)
            return NOTHING
        options = tuple(self.tables)
        if self.tag not in raw:
            allowed = ", ".join(shown(option) for option in options)
            report.add((*place, self.tag), "missing", f"Write one of {allowed}.")
            return NOTHING
        word = Choice(options).read(raw[self.tag], (*place, self.tag), report)
        return NOTHING if word is NOTHING else self.tables[word].read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """One object for each word."""
        return {"oneOf": [table.schema() for table in self.tables.values()]}


def _sound(value: object) -> bool:
    """Whether a value was read whole, with everything below it."""
    if isinstance(value, Record):
        return value.sound()
    if isinstance(value, dict):
        return all(map(_sound, value.values()))
    if isinstance(value, list):
        return all(map(_sound, value))
    return value is not NOTHING


def unknown_key_remedy(key: str, known: Iterable[str]) -> str:
    """Return the nearest known keys, or all of them."""
    return nearest(key, known) or f"The keys here are {', '.join(known)}."


def missing_remedy(entry: Entry) -> str:
    """Return how to write a missing entry."""
    kind = entry.kind
    if entry.example:
        return f"Write {entry.example}."
    if isinstance(kind, Quantity):
        return f"Write for example {entry.key} = {shown(DIMENSION_TEXT[kind.dimension].example)}."
    if isinstance(kind, Choice):
        return f"Write {entry.key} = {shown(kind.options[0])} or another of its words."
    return f"Add {entry.key}."
