"""What there is to show, before anybody decides how: sheets of labelled rows.

Command line, notebook, web page and documents all draw the same sheets, so that a number has one
label, one unit and one remark wherever it appears.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from wraparc.checks import Level
from wraparc.glossary import GLOSSARY, Quantity
from wraparc.provenance import Kind
from wraparc.units import RESULT_DIGITS, Dimension, System, display, display_unit

#: What stands where there is no number.
NONE = "-"


@dataclass(frozen=True)
class Row:
    """One line of a table.

    Attributes
    ----------
    title
        What it is.
    values
        One text for each column of the table, with units.
    symbol
        Letter of the equations.
    note
        What to know about it.
    name
        Name in the glossary, or empty.
    level
        Whether it is good or bad news, or None.
    """

    title: str
    values: tuple[str, ...]
    symbol: str = ""
    note: str = ""
    name: str = ""
    level: Level | None = None


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
        What a short answer shows of it, where `wraparc.present.short` does not pick the rows.
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
class Verdict:
    """The answer in words.

    Attributes
    ----------
    level
        How good it is.
    headline
        One sentence.
    sentences
        What follows from it: how far from a limit, what to do, what limits the answer.
    word
        What stands for the level, ``OK, on illustrative data``; the level itself unless given.
    action
        What to do, as the headline says it; empty where it says nothing of the kind.
    kept
        Those of the sentences that a short answer keeps; all of them unless given.
    """

    level: Level
    headline: str
    sentences: tuple[str, ...] = ()
    word: str = ""
    action: str = ""
    kept: tuple[str, ...] | None = None

    @property
    def told(self) -> str:
        """Word of the verdict."""
        return self.word or str(self.level)


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


#: Kinds of data that a short answer names.
WEAK = (Kind.ILLUSTRATIVE, Kind.CALIBRATED)


def weak_sources(sources: Iterable[str]) -> tuple[str, ...]:
    """Return the sources that tell of data which describe no product, or were fitted to a drive."""
    return tuple(s for s in sources if any(f": {kind}" in s for kind in WEAK))


def quantity(
    value: float, dimension: Dimension, system: System = "si", digits: int = RESULT_DIGITS
) -> str:
    """Return a value [SI] with its unit, `NONE` for nan and words for infinity."""
    if math.isnan(value):
        return NONE
    if math.isinf(value):
        return "without bound"
    return display(value, dimension, system, digits)


def term(name: str) -> Quantity:
    """Return what the glossary has of a quantity."""
    return GLOSSARY[name]


def named(name: str, value: float, system: System = "si") -> str:
    """Return the value [SI] of a quantity of the glossary with its unit."""
    return quantity(value, term(name).dimension, system)


def number(name: str, value: float, system: System = "si") -> str:
    """Return the value [SI] of a quantity of the glossary in the unit of its tables, bare."""
    _, size = display_unit(GLOSSARY[name].dimension, system)
    return quantity(value / size, "number")


def between(name: str, first: float, last: float, system: System = "si", by: str = " to ") -> str:
    """Return two values [SI] of a quantity of the glossary, ``387.5 to 125.0 kPa``."""
    texts = [named(name, value, system) for value in (first, last)]
    if texts[0] == texts[1]:
        return texts[0]
    number, _, unit = texts[0].partition(" ")
    return f"{number if texts[1].endswith(' ' + unit) else texts[0]}{by}{texts[1]}"


def row_of(
    name: str,
    *values: float,
    system: System = "si",
    note: str = "",
    title: str = "",
    level: Level | None = None,
) -> Row:
    """Return the row of a quantity of the glossary, its words taken from there."""
    entry = GLOSSARY[name]
    texts = tuple(named(name, value, system) for value in values)
    return Row(title or entry.title, texts, entry.symbol, note, name, level)


def percent(share: float, digits: int = 3) -> str:
    """Return a share as percent, `NONE` for nan."""
    if math.isnan(share):
        return NONE
    return f"{display(100.0 * share, 'number', digits=digits)} %"


def started(sentence: str) -> str:
    """Return a sentence with its capital."""
    return sentence[:1].upper() + sentence[1:]
