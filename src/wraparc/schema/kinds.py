"""What a value of a file may be, said once: for reading, for web forms, for JSON Schema.

Every value has a kind (quantity, text, choice ...). Reading goes on
after a fault and reports everything. The standard library and a few classes do here what
a validation library would: importing one costs a third of a second, half of what a whole
run of the command line may take.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Any

from wraparc.errors import InputError, format_names, nearest
from wraparc.schema.limits import Limit
from wraparc.schema.problems import NOTHING, Place, Report, place_text
from wraparc.schema.quantity_text import quantity_text
from wraparc.units import DIMENSION_TEXT, Dimension, display_unit, parse_quantity
from wraparc.units.numbers import split_number

# The kinds are constants of the key modules. They are not frozen because making a frozen
# dataclass takes five times as long, and every run of the command line makes them all.
_NO_CONTROLS = str.maketrans("", "", "\n\t")  # those that a text of lines may hold
#: What an example is scaled with, until it is allowed.
_TENS = ("1", "0.1", "0.01", "0.001", "10")


class Kind(ABC):
    """How one value is written."""

    @abstractmethod
    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the value, or NOTHING after putting the reason into the report."""

    @abstractmethod
    def schema(self) -> dict[str, Any]:
        """Return its JSON Schema; what forms need beyond the standard is in ``x-`` keys."""

    def built(self, value: Any, report: Report, **more: Any) -> Any:
        """Return what a value as read stands for: of a table, the object that it describes."""
        return value

    def written(self, value: Any) -> Any:
        """Return a value as it is written, to be read back equal."""
        return list(map(self.written, value)) if isinstance(value, tuple) else value


@dataclass(eq=False, repr=False)
class Quantity(Kind):
    """A number with its unit, read to SI."""

    dimension: Dimension
    limit: Limit | None = None

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the SI value."""
        try:
            value = parse_quantity(raw, self.dimension)
        except InputError:  # once more, with an example that may stand here
            report.tried(lambda: parse_quantity(raw, self.dimension, self.example()), place, raw)
            return NOTHING
        refusal = self.limit.refusal(value) if self.limit else ""
        if refusal:
            report.add(place, refusal, value=raw)
            return NOTHING
        return value

    def example(self) -> str:
        """Return the example of the dimension, times a power of ten that the limit allows."""
        text = DIMENSION_TEXT[self.dimension].example
        number, unit = split_number(text)
        for factor in _TENS:
            scaled = f"{(number * Decimal(factor)).normalize():f} {unit}".strip()
            if self.limit and not self.limit.refusal(parse_quantity(scaled, self.dimension)):
                return scaled
        return text

    def written(self, value: Any) -> Any:
        """Return the number with a usual unit."""
        return value if self.dimension == "number" else quantity_text(value, self.dimension)

    def schema(self) -> dict[str, Any]:
        """Text with a unit; a plain number may also be a JSON number."""
        text = DIMENSION_TEXT[self.dimension]
        number = self.dimension == "number"
        schema: dict[str, Any] = {
            "type": ["number", "string"] if number else "string",
            "examples": [text.example],
            "x-dimension": self.dimension,
            "x-units": {s: display_unit(self.dimension, s)[0] for s in ("si", "us")},
        }
        if self.limit:
            schema["x-allowed"] = str(self.limit)
            bounds = (self.limit.least, self.limit.most)
            schema["x-bounds-si"] = [b if abs(b) < float("inf") else None for b in bounds]
        return schema


@dataclass(eq=False, repr=False)
class Percent(Quantity):
    """A part of one that is written with its %: a bare 0.5 could be half, or half a per cent."""

    def __init__(self, most: float = 1.0) -> None:
        super().__init__("number", Limit("number", most=most))
        self.most = most

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the part of one."""
        text = str(raw).replace(",", ".").strip()
        if text and not text.strip("+-.0123456789"):
            report.add(place, "must be a percentage", f'Write "{text} %".', raw)
            return NOTHING
        found = super().read(raw, place, Report())
        if found is NOTHING:
            message = f"must be a percentage from 0 % to {100.0 * self.most:g} %"
            report.add(place, message, 'Write for example "0.5 %".', raw)
        return found

    def written(self, value: Any) -> Any:
        """Return the number with its %."""
        return f"{100.0 * value:g} %"

    def schema(self) -> dict[str, Any]:
        """Text with a %."""
        return super().schema() | {"type": "string", "examples": ["0.5 %"]}


@dataclass(eq=False, repr=False)
class Text(Kind):
    """Printable text."""

    longest: int = 200
    lines: bool = False

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the text."""
        if not isinstance(raw, str):
            report.add(place, "must be text", "Put it in quotes.", raw)
        elif len(raw) > self.longest:
            report.add(place, f"longer than {self.longest} characters", "Shorten it.", raw)
        elif not (raw.translate(_NO_CONTROLS) if self.lines else raw).isprintable():
            report.add(place, "contains characters that cannot be printed", "Remove them.", raw)
        else:
            return raw
        return NOTHING

    def schema(self) -> dict[str, Any]:
        """Text of limited length."""
        return {"type": "string", "maxLength": self.longest}


@dataclass(eq=False, repr=False)
class Name(Kind):
    """A name that other places refer to."""

    longest: int = 60

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the name."""
        value = Text(self.longest).read(raw, place, report)
        if value is not NOTHING and not value.strip():
            report.add(place, "must not be empty", "Write a name.", raw)
            return NOTHING
        return value

    def schema(self) -> dict[str, Any]:
        """Text that is not empty."""
        return {"type": "string", "minLength": 1, "maxLength": self.longest}


@dataclass(eq=False, repr=False)
class Choice(Kind):
    """One of a few words; `others` are read as one of them, ``stopping`` as ``braking``."""

    options: tuple[str, ...]
    others: Mapping[str, str] = field(default_factory=dict)

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the word."""
        if isinstance(raw, str) and raw in self.options:
            return raw
        if isinstance(raw, str) and raw in self.others:
            return self.others[raw]
        message = f"must be one of {format_names(self.options)}"
        remedy = "" if report.full else nearest(raw, self.options, 1)
        report.add(place, message, remedy, raw)
        return NOTHING

    def written(self, value: Any) -> Any:
        """Return the word."""
        return str(value)

    def schema(self) -> dict[str, Any]:
        """An enumeration."""
        return {"type": "string", "enum": [*self.options, *self.others]}


@dataclass(eq=False, repr=False)
class Flag(Kind):
    """True or false."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the truth value."""
        if isinstance(raw, bool):
            return raw
        report.add(place, "must be true or false", "Write it without quotes.", raw)
        return NOTHING

    def schema(self) -> dict[str, Any]:
        """A truth value."""
        return {"type": "boolean"}


@dataclass(eq=False, repr=False)
class Count(Kind):
    """A whole number."""

    least: int
    most: int

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the number."""
        whole = isinstance(raw, int) and not isinstance(raw, bool)
        if whole and self.least <= raw <= self.most:  # type: ignore[operator]
            return raw
        message = f"must be a whole number from {self.least} to {self.most}"
        report.add(place, message, value=raw)
        return NOTHING

    def schema(self) -> dict[str, Any]:
        """An integer between bounds."""
        return {"type": "integer", "minimum": self.least, "maximum": self.most}


@dataclass(eq=False, repr=False)
class WordOr(Kind):
    """A word that stands for a value of its own, or a value of another kind."""

    word: str
    kind: Kind
    meaning: float | None = None

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return what the word means, else the value."""
        return self.meaning if raw == self.word else self.kind.read(raw, place, report)

    def written(self, value: Any) -> Any:
        """Return the word for what it means."""
        return self.word if value == self.meaning else self.kind.written(value)

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [{"const": self.word}, self.kind.schema()]}


@dataclass(eq=False, repr=False)
class Rows(Kind):
    """An array of values of one kind; tables with a name are called by it in messages."""

    kind: Kind
    least: int = 0
    most: int = 1000

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the values that could be read, NOTHING for the others."""
        if isinstance(raw, dict) and place:  # [pulley] for [[pulley]]
            name = place_text(place)
            report.add(place, "must be an array of tables", f"Write [[{name}]] for [{name}].")
            return NOTHING
        if not isinstance(raw, list):
            report.add(place, "must be an array", "Put it in [ ], as the examples show.", raw)
            return NOTHING
        if not self.least <= len(raw) <= self.most:
            count = f"{self.least} to {self.most}" if self.least else f"at most {self.most}"
            report.add(place, f"must have {count} entries", value=len(raw))
            return NOTHING
        labels = table_labels(raw)
        return [
            self.kind.read(item, (*place, label), report)
            for item, label in zip(raw, labels, strict=True)
        ]

    def written(self, value: Any) -> Any:
        """Return an array."""
        return [self.kind.written(item) for item in value]

    def schema(self) -> dict[str, Any]:
        """An array."""
        return {
            "type": "array",
            "items": self.kind.schema(),
            "minItems": self.least,
            "maxItems": self.most,
        }


@dataclass(eq=False, repr=False)
class ByName(Kind):
    """A table of values of one kind under names that the user chooses."""

    kind: Kind
    most: int = 200

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the values by name."""
        if not isinstance(raw, dict):
            report.add(place, "must be a table", f"Write [{place[-1]}.NAME].", raw)
            return NOTHING
        if len(raw) > self.most:
            report.add(place, f"must have at most {self.most} entries", value=len(raw))
            return NOTHING
        return {
            name: self.kind.read(item, (*place, name), report)
            for name, item in raw.items()
            if Name().read(name, (*place, name), report) is not NOTHING
        }

    def written(self, value: Any) -> Any:
        """Return a table by name."""
        return {name: self.kind.written(item) for name, item in value.items()}

    def schema(self) -> dict[str, Any]:
        """An object with free names."""
        return {"type": "object", "additionalProperties": self.kind.schema()}


@dataclass(eq=False, repr=False)
class TextOr(Kind):
    """Text (or a number), or a table."""

    text: Kind
    table: Kind

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the text or the table."""
        return (self.table if isinstance(raw, dict) else self.text).read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [self.text.schema(), self.table.schema()]}


@dataclass(eq=False, repr=False)
class Elsewhere(Kind):
    """A table that another room reads; taken as it is."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return what is there."""
        return raw

    def schema(self) -> dict[str, Any]:
        """Any table."""
        return {"type": "object"}


@dataclass(eq=False, repr=False)
class OneOrMore(Kind):
    """One value of a kind, or an array of them; read as a list either way."""

    kind: Kind
    most: int = 50

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the list."""
        if not isinstance(raw, list):
            return [self.kind.read(raw, place, report)]
        return Rows(self.kind, 1, self.most).read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [self.kind.schema(), Rows(self.kind, 1, self.most).schema()]}


def table_labels(rows: Sequence[object]) -> list[str | int]:
    """Return what to call each row: its name if no other row has it, else its position."""
    names = [row.get("name") if isinstance(row, dict) else None for row in rows]
    return [
        name if isinstance(name, str) and name.strip() and names.count(name) == 1 else position
        for position, name in enumerate(names, start=1)
    ]
