"""What there is to show, before anybody decides how: sheets of labelled rows.

Command line, notebook, web page and documents all draw the same sheets, so that a number has one
label and one remark wherever it appears. Numbers stand in them as cells, in SI; `shown` gives a
sheet in a system of units.
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast

from wraparc.checks import Check, Level
from wraparc.checks import Verdict as Judgement
from wraparc.checks.action import Action, Way
from wraparc.glossary import GLOSSARY, Quantity
from wraparc.units import (
    NONE,
    RESULT_DIGITS,
    Cell,
    Dimension,
    System,
    bare,
    in_units,
    percent,
    quantity,
    unit_of,
)
from wraparc.units.cell import Form

if TYPE_CHECKING:
    from wraparc.reserve import Flip, Probability

__all__ = [
    "NONE",
    "Also",
    "ReserveWanted",
    "Row",
    "Sheet",
    "Table",
    "Verdict",
    "bare",
    "between",
    "headed",
    "named",
    "number",
    "percent",
    "quantity",
    "row_of",
    "shown",
    "started",
    "term",
]  # fmt: skip
_T = TypeVar("_T")


@dataclass(frozen=True)
class Row:
    """One line of a table.

    Attributes
    ----------
    title
        What it is.
    values
        For each column of the table a cell (`wraparc.units.Cell`), or a text.
    symbol
        Letter of the equations.
    note
        What to know about it.
    name
        Name in the glossary, of a check, or of the row in its table, which stays when the title
        is worded anew; empty where the title is its name.
    level
        Whether it is good or bad news, or None.
    """

    title: str
    values: tuple[str, ...]
    symbol: str = ""
    note: str = ""
    name: str = ""
    level: Level | None = None

    @property
    def mark(self) -> str:
        """The word of its level, where no value says it."""
        word = str(self.level or "")
        said = any(value == word or value.startswith(f"{word} ") for value in self.values)
        return "" if said else word


@dataclass(frozen=True)
class Table:
    """Rows under one heading.

    Attributes
    ----------
    title
        Heading.
    rows
        Lines; each has as many values as `heads`.
    heads
        Headings of the value columns; a single empty one needs no line of its own.
    note
        What to know about the whole table.
    name
        Word that it is asked for by; several tables of a sheet may share it.
    short
        What a short answer shows of it, where `wraparc.answer.short` does not pick the rows.
    brief
        What a short answer says of it at its foot.
    """

    title: str
    rows: tuple[Row, ...]
    heads: tuple[str, ...] = ("",)
    note: str = ""
    name: str = ""
    short: "Table | None" = None
    brief: str = ""

    @property
    def has_symbols(self) -> bool:
        """Whether any row has a symbol."""
        return any(row.symbol for row in self.rows)

    @property
    def has_notes(self) -> bool:
        """Whether any row has a note."""
        return any(row.note for row in self.rows)


@dataclass(frozen=True)
class Also:
    """What else is missed: one sentence.

    Attributes
    ----------
    level, text
        How bad it is, and the sentence.
    check
        The check that says it; None where another answer does.
    """

    level: Level
    text: str
    check: Check | None = None


#: How much of its reserve is sought with a verdict: the line alone, or every input.
ReserveWanted = Literal["", "line", "all"]


@dataclass(frozen=True)
class Verdict:
    """The answer in a few lines, each one object that every door shows as it is.

    Attributes
    ----------
    level
        How good it is.
    text
        One sentence.
    sentences
        What a full answer says besides: reasons, allowances, assumptions.
    label
        What stands for the level, ``OK (dry)``; the level itself unless given.
    action
        What to do; None where nothing is to be done.
    also
        What else is missed, the worst first.
    wet, data
        What wet would give, and on what data the answer is based; empty where nothing is to be
        said.
    reserve
        What little change of an input changes the verdict.
    flips
        The same as data.
    probability, shares
        How probable the level is, and the same as data; empty and None where it is not asked for.
    changes
        What each change of the drive comes to, a sentence each.
    checks_at
        Where all checks that are missed are listed.
    name
        Of the command, where its own sentence comes first; else that of the check.
    check
        The check that governs; None where a command says the sentence.
    judged
        The verdict on the drive, as data.
    """

    level: Level
    text: str
    sentences: tuple[str, ...] = ()
    label: str = ""
    action: Action | None = None
    also: tuple[Also, ...] = ()
    wet: str = ""
    data: str = ""
    reserve: tuple[str, ...] = ()
    flips: tuple["Flip", ...] = ()
    probability: str = ""
    shares: "Probability | None" = None
    changes: tuple[str, ...] = ()
    checks_at: str = "--table checks"
    name: str = ""
    check: Check | None = None
    judged: Judgement | None = None

    @property
    def word(self) -> str:
        """The level as it is shown."""
        return self.label or str(self.level)

    @property
    def lines(self) -> tuple[tuple[str, str], ...]:
        """Label and text of every line but the first, `MOST_LINES` with it."""
        action = [("Action", self.action.text)] if self.action else []
        last = [("Wet", self.wet)] if self.wet else []
        last += [("Reserve", text) for text in self.reserve]
        last += [("Probability", self.probability)] if self.probability else []
        last += [("Data", self.data)] if self.data else []
        room = MOST_LINES - 1 - len(action) - len(last)
        changes = _lines_of("Change", self.changes, room - bool(self.also), "--table changes")
        also = [
            other.text if other.level is self.level else f"{other.level}: {other.text}"
            for other in self.also
        ]
        further = _lines_of("Also", also, room - len(changes), self.checks_at, MOST_ALSO)
        return (*action, *changes, *further, *last)


def _lines_of(
    label: str, texts: Sequence[str], room: int, rest: str, most: int = 1000
) -> list[tuple[str, str]]:
    """Return the first texts, at most so many, and in the last line how many more there are."""
    if len(texts) <= min(room, most):
        return [(label, text) for text in texts]
    first = texts[: max(0, min(room - 1, most))]
    more = [(label, f"{len(texts) - len(first)} more ({rest}).")] if room > 0 else []
    return [*((label, text) for text in first), *more]


#: How many lines a first screen has above its tables, and how many further sentences.
MOST_LINES, MOST_ALSO = 8, 2


@dataclass(frozen=True)
class Sheet:
    """Everything to show of one thing.

    Attributes
    ----------
    title, subtitle
        Headings.
    verdict
        The answer in words, or None where nothing was asked.
    tables
        The tables, most important first.
    remarks
        Sentences a reader must not miss.
    sources
        Where numbers came from; a note ``[2]`` in a row refers to the second.
    foot
        Lines at its foot, without a heading.
    kept
        Remarks and sources that a short answer keeps; all remarks unless given.
    """

    title: str
    subtitle: str = ""
    verdict: Verdict | None = None
    tables: tuple[Table, ...] = ()
    remarks: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()
    foot: tuple[str, ...] = ()
    kept: tuple[str, ...] | None = None


def term(name: str) -> Quantity:
    """Return what the glossary has of a quantity."""
    return GLOSSARY[name]


def named(name: str, value: float) -> str:
    """Return the cell of the value [SI] of a quantity of the glossary."""
    return quantity(value, term(name).dimension, RESULT_DIGITS, name)


def number(name: str, value: float) -> str:
    """Return the same without its unit, which stands in the head: see `headed`."""
    return bare(value, term(name).dimension, RESULT_DIGITS, name)


def headed(words: str, dimension: Dimension) -> str:
    """Return the head of a column of numbers without units, ``creep [mm]``."""
    return words if dimension == "number" else f"{words} [{unit_of(dimension)}]"


def between(name: str, first: float, last: float, form: Form = "to") -> str:
    """Return the cell of two values [SI] of a quantity of the glossary, ``387.5 to 125.0 kPa``."""
    return Cell(last, term(name).dimension, RESULT_DIGITS, form, first, name)


def row_of(
    name: str,
    *values: float,
    note: str = "",
    title: str = "",
    level: Level | None = None,
) -> Row:
    """Return the row of a quantity of the glossary, its words taken from there."""
    entry = term(name)
    cells = tuple(named(name, value) for value in values)
    return Row(title or entry.title, cells, entry.symbol, note, name, level)


def started(sentence: str) -> str:
    """Return a sentence with its capital."""
    return sentence[:1].upper() + sentence[1:]


def shown(thing: _T, system: System) -> _T:
    """Return a text, or what is made of texts, with its cells shown in a system of units.

    The only place in which an answer meets a system of units: sheets, tables, rows, verdicts and
    tuples of them.
    """
    of: Any = thing
    if isinstance(thing, str):
        of = in_units(thing, system)
    elif isinstance(thing, tuple):
        of = tuple(shown(part, system) for part in thing)
    elif isinstance(thing, Sheet | Verdict | Also | Table | Row | Action | Way):
        parts = ((f.name, getattr(thing, f.name)) for f in fields(thing))
        of = replace(thing, **{name: shown(part, system) for name, part in parts})
    return cast(_T, of)
