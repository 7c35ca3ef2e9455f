"""Tables of keys: which keys a table may hold, read with everything that is wrong at once."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import MISSING, Field, dataclass, field, fields, replace
from functools import cached_property
from typing import Any, NamedTuple

from wraparc.errors import format_list, near, nearest, shown
from wraparc.schema.kinds import Choice, Flag, Kind, Quantity, WordOr
from wraparc.schema.limits import Limit
from wraparc.schema.problems import NOTHING, Place, Report


class _OfClass(Kind):
    """What the class of the table says of the field: its limit, or that it is true or false."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Nothing: a table puts the kind of the field in its place."""
        raise TypeError

    def schema(self) -> dict[str, Any]:
        """Nothing: a table puts the kind of the field in its place."""
        raise TypeError


OF_CLASS = _OfClass()


@dataclass(eq=False, repr=False)
class Entry:
    """One key of a table: a row from which it is read, written, explained and put into schemas.

    Parameters
    ----------
    key
        How it is written.
    meaning
        Help text of a form field, and of the documentation.
    kind
        What may stand there; left out where the class that the table describes has a limit.
    title
        Label of a form field; the key in words if left out.
    required
        Whether it must be there.
    alias
        Another key that is read as this one.
    example
        What to write if it is missing; needed where the kind does not tell.
    attribute
        What the class calls it, if not the key.
    unless
        Another key that may stand instead of a required one.
    stated
        Whether it is written even where leaving it out would mean the same.
    """

    key: str
    meaning: str = ""
    kind: Kind = OF_CLASS
    title: str = field(default="", kw_only=True)
    required: bool = field(default=False, kw_only=True)
    alias: str = field(default="", kw_only=True)
    example: str = field(default="", kw_only=True)
    attribute: str = field(default="", kw_only=True)
    unless: str = field(default="", kw_only=True)
    stated: bool = field(default=False, kw_only=True)

    def __post_init__(self) -> None:
        self.title = self.title or self.key.replace("_", " ").capitalize()
        self.attribute = self.attribute or self.key


def need(key: str, meaning: str = "", kind: Kind = OF_CLASS, **more: Any) -> Entry:
    """Return an entry that must be there."""
    return replace(Entry(key, meaning, kind, **more), required=True)


def limited(owner: type, key: str) -> Quantity:
    """Return the kind of a quantity that a class of descriptions limits."""
    limit: Limit = owner.LIMITS[key]  # type: ignore[attr-defined]
    return Quantity(limit.dimension, limit)


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


class Misplaced(NamedTuple):
    """Keys that users put into tables and that belong elsewhere: one problem for all of them.

    Attributes
    ----------
    keys
        The keys.
    message, remedy
        What is wrong and what to do; ``{key}`` is the first of them.
    owner
        Key of the table that they belong into: what it lacks then is not told.
    """

    keys: tuple[str, ...]
    message: str
    remedy: str
    owner: str


class Table(Kind):
    """A table with known keys; any other key is a fault.

    Parameters
    ----------
    title
        What it is called.
    entries
        Its keys, in the order they are shown.
    of
        Class of what it describes, which states limits and what is if a key is left out.
    on_one_line
        Whether it reads best written on a line.
    misplaced
        Keys that belong elsewhere.
    """

    def __init__(
        self,
        title: str,
        *entries: Entry,
        of: type | None = None,
        on_one_line: bool = False,
        misplaced: Misplaced | None = None,
    ) -> None:
        self.title, self.of, self.on_one_line = title, of, on_one_line
        self.misplaced = misplaced
        self.entries = tuple(
            replace(e, kind=_kind_of(of, e.attribute)) if e.kind is OF_CLASS else e for e in entries
        )
        self._known = {entry.key: entry for entry in self.entries}

    @cached_property
    def _fields(self) -> frozenset[str]:
        """Fields of the class."""
        return frozenset(f.name for f in fields(self.of)) if self.of else frozenset()

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return a `Record`."""
        if not isinstance(raw, dict):
            report.add(place, "must be a table", "Write its keys below its name in [ ].", raw)
            return NOTHING
        given = self._renamed(raw, place, report)
        known = self._known
        record = Record({}, place, given)
        unknown = [key for key in given if key not in known]
        if self.misplaced is not None:
            unknown = self._without_misplaced(unknown, record, report)
        for key in unknown:
            record.faulty.update(self._report_unknown(key, given, place, report))
        misspelt = set(record.faulty)
        for key, entry in known.items():
            if key in given:
                value = entry.kind.read(given[key], (*place, key), report)
                if not _sound(value):
                    record.faulty.add(key)
                if value is not NOTHING:
                    record[key] = value
            elif entry.required and not (entry.unless and entry.unless in given):
                record.faulty.add(key)
                if misspelt.isdisjoint((key, entry.unless)):  # else its name is the fault
                    report.add((*place, key), "missing", missing_remedy(entry))
        return record

    def built(self, value: Any, report: Report, **more: Any) -> Any:
        """Return what a table describes, an object of its class, or None after reporting.

        Parameters
        ----------
        value
            The table as read; None if it is not there.
        report
            Takes what is wrong.
        more
            Attributes that stand elsewhere, or stand for what the table says.
        """
        if not isinstance(value, Record) or not value.sound() or self.of is None:
            return None
        made, record = self.of, value
        values = {
            e.attribute: _frozen(record[e.key])
            for e in self.entries
            if e.key in record
            and e.attribute in self._fields
            and not isinstance(record[e.key], dict)
        }
        names = {e.attribute: e.key for e in self.entries}
        return report.tried(lambda: made(**{**values, **more}), record.place, record.raw, names)

    def written(self, value: Any, **instead: Any) -> dict[str, Any]:
        """Return the table that describes an object, without what is as if left out.

        Parameters
        ----------
        value
            The object.
        instead
            What is written under single keys, as it is written; None for nothing.
        """
        usual = {f.name: _default(f) for f in fields(value)}
        table = {}
        for e in self.entries:
            if e.key in instead:
                table[e.key] = instead[e.key]
            elif e.attribute in usual:
                own = getattr(value, e.attribute)
                said = own not in (None, ()) and own != usual[e.attribute]
                if said or e.required or e.stated:
                    table[e.key] = e.kind.written(own)
        return {key: item for key, item in table.items() if item is not None}

    def rows(self, thing: Any) -> list[dict[str, Any]]:
        """Return an object of columns as the tables of its rows; empty columns are left out."""
        columns = {e: column for e in self.entries if (column := getattr(thing, e.attribute))}
        return [
            {e.key: e.kind.written(value) for e, value in zip(columns, row, strict=True)}
            for row in zip(*columns.values(), strict=True)
        ]

    def having(self, *entries: Entry) -> "Table":
        """Return the table with other entries in place of those of the same keys."""
        other = {entry.key: entry for entry in entries}
        these = [other.get(e.key, e) for e in self.entries]
        return Table(self.title, *these, of=self.of, misplaced=self.misplaced)

    def _report_unknown(
        self, key: str, given: dict[str, Any], place: Place, report: Report
    ) -> list[str]:
        """Report an unknown key; return the absent key that it may be, sought if it is listed."""
        if report.full:
            report.add((*place, key), "unknown key")
            return []
        close = near(key, [k for k in self._known if k not in given], 1)
        remedy, meant = unknown_key_remedy(key, self._known), close[0] if close else ""
        report.add((*place, key), "unknown key", remedy, code="unknown_key", meant=meant)
        return close

    def _without_misplaced(self, unknown: list[str], record: Record, report: Report) -> list[str]:
        """Return unknown keys without those that belong elsewhere, which are one problem."""
        of = self.misplaced
        there = [] if of is None else [key for key in unknown if key in of.keys]
        if of is not None and there:
            record.faulty.add(of.owner)
            if all(problem.message != of.message for problem in report.problems):
                remedy = of.remedy.replace("{key}", there[0])
                report.add((*record.place, there[0]), of.message, remedy)
        return [key for key in unknown if key not in there]

    def _renamed(self, raw: dict[str, Any], place: Place, report: Report) -> dict[str, Any]:
        given = dict(raw)
        for entry in self.entries:
            if not entry.alias or entry.alias not in given:
                continue
            value = given.pop(entry.alias)
            if entry.key in given:
                message = f"means the same as {entry.key}, which is also there"
                report.add((*place, entry.alias), message, "Remove one of them.", value)
            else:
                given[entry.key] = value
        return given

    def schema(self) -> dict[str, Any]:
        """An object without other keys."""
        properties = {}
        for entry in self.entries:
            words = {"title": entry.title}
            if entry.meaning:
                words["description"] = entry.meaning
            properties[entry.key] = words | entry.kind.schema()
        return {
            "type": "object",
            **({"title": self.title} if self.title else {}),
            "properties": properties,
            "required": [e.key for e in self.entries if e.required and not e.unless],
            "additionalProperties": False,
        }


class Variant(Kind):
    """A table whose keys depend on the word under one of them.

    Parameters
    ----------
    tag
        That key.
    meaning
        What it says.
    tables
        One table for each word, which is its title; the tag is added to it.
    """

    def __init__(self, tag: str, meaning: str, *tables: Table) -> None:
        self.tag = tag
        self.tables = {
            t.title: Table(t.title, need(tag, meaning, Choice((t.title,))), *t.entries, of=t.of)
            for t in tables
        }

    def built(self, value: Any, report: Report, **more: Any) -> Any:
        """Return what the table describes, or None after reporting; see `Table.built`."""
        if not isinstance(value, Record) or not value.sound():
            return None
        return self.tables[value[self.tag]].built(value, report, **more)

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

    def written(self, value: Any) -> Any:
        """Return the table that describes an object, with its word."""
        word, table = next((w, t) for w, t in self.tables.items() if t.of is type(value))
        return {self.tag: word, **table.written(value, **{self.tag: None})}

    def schema(self) -> dict[str, Any]:
        """One object for each word."""
        return {"oneOf": [table.schema() for table in self.tables.values()]}


def json_schema(table: Kind) -> dict[str, Any]:
    """Return the JSON Schema of a file, for web forms and editors.

    Quantities are text with a unit; ``x-dimension``, ``x-units``, ``x-allowed`` and
    ``x-bounds-si`` say what a form must know of them.
    """
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **table.schema()}


def _kind_of(owner: type | None, attribute: str) -> Kind:
    """Return what a class says of a field."""
    if owner is None:
        raise TypeError(f"{attribute} has neither a kind nor a class that says it")
    if attribute in getattr(owner, "LIMITS", {}):
        kind = limited(owner, attribute)
        rigid = kind.limit is not None and kind.limit.rigid
        return WordOr("rigid", kind, math.inf) if rigid else kind
    types = {f.name: f.type for f in fields(owner)}
    if types[attribute] in (bool, "bool"):
        return Flag()
    raise TypeError(f"{owner.__name__} does not say what {attribute} may be")


def _default(of: Field[Any]) -> Any:
    return of.default if of.default_factory is MISSING else of.default_factory()


def _frozen(value: Any) -> Any:
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


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
    """Return the nearest known keys, or which there are."""
    return nearest(key, known) or f"Write one of {format_list([*known])}."


def missing_remedy(entry: Entry) -> str:
    """Return how to write a missing entry."""
    kind = entry.kind
    if entry.example:
        return f"Write {entry.example}."
    if isinstance(kind, Quantity):
        return f"Write for example {entry.key} = {shown(kind.example())}."
    if isinstance(kind, Choice):
        return f"Write {entry.key} = {shown(kind.options[0])} or another word."
    return f"Add {entry.key}."
