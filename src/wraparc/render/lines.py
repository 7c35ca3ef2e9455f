"""Sheets as lines of text, for a terminal or a file.

Laid out here rather than by a library: it takes a fiftieth of the time that one takes to be
imported and to do it, and numbers are never cut or broken while there is a note to be wrapped.
"""

from collections.abc import Iterator, Sequence
from itertools import zip_longest
from textwrap import wrap
from typing import Any
from unicodedata import east_asian_width

import click

from wraparc.answer.sheet import Row, Sheet, Table, Verdict
from wraparc.checks import Level

_STYLES: dict[Level, dict[str, Any]] = {
    Level.OK: {"fg": "green"},
    Level.NOT_CHECKED: {"dim": True},
    Level.ATTENTION: {"fg": "yellow", "bold": True},
    Level.FAILS: {"fg": "red", "bold": True},
    Level.FAULT: {"fg": "red", "bold": True},
}
_GAP = 2
# Least width of a column before the next kind of column has to give way: notes, then titles.
_LEAST_NOTE, _LEAST_TITLE = 24, 14


def lines_of(sheet: Sheet, width: int) -> list[str]:
    """Return a sheet in lines: the answer first, then tables, remarks and sources; with colours."""
    return list(_page(sheet, width))


def plain_text(sheet: Sheet, width: int) -> str:
    """Return a sheet as text without colours."""
    return "\n".join(click.unstyle(line).rstrip() for line in lines_of(sheet, width))


def table_lines(tables: Sequence[Table], width: int, *, close: bool = False) -> Iterator[str]:
    """Yield tables in lines, blank ones between them; `close` puts a title beside its heads."""
    for number, table in enumerate(tables):
        if number:
            yield ""
        title, (first, *others) = table.title, [*_table(table, width), ""]
        if close and first.startswith(" " * (_cells(title) + _GAP)):
            yield click.style(title, bold=True) + first[_cells(title) :]
        else:
            yield click.style(title, bold=True)
            yield first
        yield from others[:-1]
        if table.note:
            yield from _item("", table.note, width)


def _page(sheet: Sheet, width: int) -> Iterator[str]:
    yield click.style(sheet.title, bold=True)
    yield from wrap(sheet.subtitle, width)
    if sheet.verdict:
        yield ""
        yield from headline_lines(sheet.verdict, width)
        for sentence in sheet.verdict.sentences:
            yield from _item("-", sentence, width)
    if sheet.tables:
        yield ""
        yield from table_lines(sheet.tables, width, close=bool(sheet.foot))
    numbers = [f"[{number}]" for number in range(1, len(sheet.sources) + 1)]
    for title, marks, texts in (
        ("Remarks", ["-"] * len(sheet.remarks), sheet.remarks),
        ("Sources", numbers, sheet.sources),
    ):
        if texts:
            yield ""
            yield click.style(title, bold=True)
            for mark, text in zip(marks, texts, strict=True):
                yield from _item(mark, text, width)
    if sheet.foot:
        yield ""
        for text in sheet.foot:
            yield from wrap(text, width, subsequent_indent="  ", break_on_hyphens=False)


def headline_lines(verdict: Verdict, width: int) -> list[str]:
    """Return the lines of a verdict, each under its label: level, action, also, wet, data."""
    pairs = ((verdict.word, verdict.text), *verdict.lines)
    room = max(len(label) for label, _ in pairs) + _GAP
    lines = [line for pair in pairs for line in _labelled(*pair, room, width)]
    lines[0] = _marked(lines[0], verdict.level)
    return lines


def _labelled(label: str, text: str, room: int, width: int) -> list[str]:
    """Return a text beside its label, its further lines below its first."""
    return wrap(
        text,
        width,
        initial_indent=label.ljust(room),
        subsequent_indent=" " * room,
        break_on_hyphens=False,
    )


def _item(mark: str, text: str, width: int) -> list[str]:
    start = f" {mark} "
    return wrap(
        text,
        width,
        initial_indent=start,
        subsequent_indent=" " * len(start),
        break_on_hyphens=False,
    )


def _table(table: Table, width: int) -> Iterator[str]:
    columns = [["", *(row.title for row in table.rows)]]
    if table.has_symbols:
        columns.append(["", *(row.symbol for row in table.rows)])
    first_value = len(columns)
    for i, head in enumerate(table.heads):
        columns.append([head, *(row.values[i] for row in table.rows)])
    if table.has_notes:
        columns.append(["", *map(_note, table.rows)])
    widths = _fitted(columns, first_value, table.has_notes, width - 1)
    values = range(first_value, first_value + len(table.heads))
    right = values if len(table.heads) > 1 else range(0)
    for i in range(0 if any(table.heads) else 1, len(table.rows) + 1):
        row = table.rows[i - 1] if i else None
        cells = [
            wrap(column[i], w, break_on_hyphens=False)
            for column, w in zip(columns, widths, strict=True)
        ]
        for number, parts in enumerate(zip_longest(*cells, fillvalue="")):
            texts = [
                _padded(part, w, right=c in right)
                for c, (part, w) in enumerate(zip(parts, widths, strict=True))
            ]
            yield " " + _coloured(texts, row, values, first_line=number == 0)


def _fitted(columns: list[list[str]], first_value: int, has_notes: bool, room: int) -> list[int]:
    """Return the widths: heads give way first, then notes, titles, and words before numbers."""
    widths = [max(map(_cells, column)) for column in columns]
    last = len(columns) - 1
    order = [
        (i, max(_longest_word(columns[i][:1]), *map(_cells, columns[i][1:])))
        for i in range(first_value, len(columns) - has_notes)
    ]
    order += [(last, _LEAST_NOTE)] if has_notes else []
    order += [(0, _LEAST_TITLE)]
    words = [(i, max(1, _longest_word(column))) for i, column in enumerate(columns)]
    numbers = range(first_value, len(columns) - has_notes)
    short = {i for i in numbers if widths[i] <= _LEAST_TITLE}
    order += sorted(words, key=lambda column: (column[0] in short, -widths[column[0]]))
    excess = sum(widths) + _GAP * last - room
    for column, least in order:
        given = min(max(0, widths[column] - least), max(0, excess))
        widths[column] -= given
        excess -= given
    return [max(1, width) for width in widths]


def _longest_word(texts: list[str]) -> int:
    return max((_cells(word) for text in texts for word in text.split()), default=0)


def _cells(text: str) -> int:
    """Return how many columns of a terminal a text takes."""
    if text.isascii():
        return len(text)
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _padded(text: str, width: int, *, right: bool) -> str:
    blanks = " " * (width - _cells(text))
    return blanks + text if right else text + blanks


def _note(row: Row) -> str:
    return ": ".join(dict.fromkeys(part for part in (row.mark, row.note) if part))


def _coloured(texts: list[str], row: Row | None, values: range, *, first_line: bool) -> str:
    """Join the cells of a line; values stand out, in the colour of bad news if they are."""
    styled = list(texts)
    if row is not None:
        style = (
            {"bold": True}
            if row.level in (None, Level.OK, Level.NOT_CHECKED)
            else _STYLES[row.level]
        )
        for i in values:
            styled[i] = click.style(texts[i], **style)
        if first_line and row.level and texts[-1].startswith(row.level):
            styled[-1] = _marked(texts[-1], row.level)
    return (" " * _GAP).join(styled)


def _marked(text: str, level: Level) -> str:
    if not text.startswith(level):  # broken over lines that are shorter than the word
        return text
    return click.style(str(level), **_STYLES[level]) + text.removeprefix(level)
