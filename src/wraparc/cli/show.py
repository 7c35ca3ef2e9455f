"""Sheets on a terminal, in a pipe, or in a file."""

import io
import os
import sys
from typing import Any, Literal

from rich.console import Console
from rich.padding import Padding
from rich.table import Table as Grid
from rich.text import Text

from wraparc.present.sheet import Level, Row, Sheet, Table, Verdict

_STYLES = {Level.GOOD: "green", Level.WARNING: "bold yellow", Level.BAD: "bold red"}
# What is printed is printed as it is.
_PLAIN: dict[str, Any] = {
    "highlight": False,
    "markup": False,
    "emoji": False,
    "force_jupyter": False,
}
#: Width of lines where no terminal says how wide it is.
_PIPED_WIDTH = 110


def show(sheet: Sheet) -> None:
    """Print a sheet: the answer first, then the tables, the remarks and the sources."""
    if sys.stdout.isatty():
        out = Console(**_PLAIN)
        _show_all(out, sheet)
        if sheet.verdict:  # once more, where the eye is when the lines have run past
            out.print()
            _show_headline(out, sheet.verdict)
        return
    width = None if "COLUMNS" in os.environ else _PIPED_WIDTH
    page = io.StringIO()
    plain = Console(file=page, width=width, **_PLAIN)
    _show_all(plain, sheet)
    sys.stdout.writelines(f"{line.rstrip()}\n" for line in page.getvalue().splitlines())


def _show_all(out: Console, sheet: Sheet) -> None:
    out.print(Text(sheet.title, style="bold"))
    if sheet.subtitle:
        out.print(Text(sheet.subtitle))
    if sheet.verdict:
        out.print()
        _show_headline(out, sheet.verdict)
        for sentence in sheet.verdict.sentences:
            _show_item(out, "-", sentence)
    for table in sheet.tables:
        _show_table(out, table)
    if sheet.remarks:
        _show_list(out, "Remarks", ["-"] * len(sheet.remarks), sheet.remarks)
    if sheet.sources:
        numbers = [f"[{number}]" for number in range(1, len(sheet.sources) + 1)]
        _show_list(out, "Sources", numbers, sheet.sources)


def _show_headline(out: Console, verdict: Verdict) -> None:
    out.print(Text.assemble((str(verdict.level), _STYLES[verdict.level]), "  ", verdict.headline))


def _show_list(out: Console, title: str, marks: list[str], sentences: tuple[str, ...]) -> None:
    out.print()
    out.print(Text(title, style="bold"))
    for mark, sentence in zip(marks, sentences, strict=True):
        _show_item(out, mark, sentence)


def _show_item(out: Console, mark: str, sentence: str) -> None:
    grid = Grid.grid(padding=(0, 1))
    grid.add_column(width=len(mark))
    grid.add_column()
    grid.add_row(Text(mark), Text(sentence))
    out.print(Padding(grid, (0, 0, 0, 1)))


def _show_table(out: Console, table: Table) -> None:
    out.print()
    out.print(Text(table.title, style="bold"))
    if table.rows:
        out.print(Padding(_grid(table), (0, 0, 0, 1)))
    if table.note:
        out.print(Padding(Text(table.note, style="dim"), (0, 0, 0, 2)))


def _grid(table: Table) -> Grid:
    grid = Grid(box=None, show_header=any(table.heads), pad_edge=False, padding=(0, 1))
    grid.add_column("", overflow="fold")
    if table.has_symbols:
        grid.add_column("", style="dim", overflow="fold")
    for head in table.heads:
        side: Literal["left", "right"] = "right" if len(table.heads) > 1 else "left"
        grid.add_column(Text(head), justify=side, overflow="fold")
    if table.has_notes:
        grid.add_column("", overflow="fold")
    for row in table.rows:
        cells = [Text(row.title)]
        cells += [Text(row.symbol)] if table.has_symbols else []
        cells += [_value(row, text) for text in row.values]
        cells += [_note(row)] if table.has_notes else []
        grid.add_row(*cells)
    return grid


def _value(row: Row, text: str) -> Text:
    style = _STYLES[row.level] if row.level in (Level.WARNING, Level.BAD) else "bold"
    return Text(text, style=style)


def _note(row: Row) -> Text:
    if row.level is None:
        return Text(row.note, style="dim")
    mark = (str(row.level), _STYLES[row.level])
    return Text.assemble(mark, (f": {row.note}" if row.note else "", "dim"))
