"""Sheets on standard output: short unless all or one table is asked for."""

import os
import shutil
import sys
from dataclasses import dataclass

import click

from wraparc.answer.sheet import Sheet, shown
from wraparc.answer.short import short_sheet
from wraparc.cli.pipe import reader_may_leave
from wraparc.errors import InputError, Problem, name_remedy
from wraparc.errors import shown as quoted
from wraparc.render.lines import headline_lines, lines_of, table_lines
from wraparc.units import System

#: Width of lines where no terminal says how wide it is.
_PIPED_WIDTH = 110


@dataclass(frozen=True)
class Wanted:
    """How an answer is to be printed: the short one, all, or the tables of one name; its units."""

    full: bool = False
    table: str = ""
    units: System = "si"


def show(sheet: Sheet, wanted: Wanted) -> None:
    """Print a sheet.

    A full one repeats the answer at the end of a terminal, where the eye is when the lines have
    run past. In colour on a terminal unless ``NO_COLOR`` is set; nothing hangs on the colour.
    """
    terminal = sys.stdout.isatty()
    width = shutil.get_terminal_size((_PIPED_WIDTH, 24)).columns
    sheet = shown(sheet, wanted.units)
    lines = _lines(sheet, wanted, width)
    if terminal and wanted.full and sheet.verdict:
        lines += ["", *headline_lines(sheet.verdict, width)]
    plain = [click.unstyle(line).rstrip() for line in lines]
    with reader_may_leave():
        if not terminal:
            sys.stdout.writelines(f"{line}\n" for line in plain)
        else:  # click makes colours work on every terminal
            click.echo("\n".join(plain if os.environ.get("NO_COLOR") else lines))


def _lines(sheet: Sheet, wanted: Wanted, width: int) -> list[str]:
    there = list(dict.fromkeys(table.name for table in sheet.tables if table.name))
    if wanted.table:
        tables = [table for table in sheet.tables if table.name == wanted.table]
        if not tables:
            raise InputError(no_table(wanted.table, there))
        return list(table_lines(tables, width))
    if wanted.full:
        return lines_of(sheet, width)
    rest = "--full, --table NAME"
    return lines_of(short_sheet(sheet, "--table", rest), width)


def no_table(name: str, there: list[str]) -> Problem:
    """Return the problem of a table that an answer does not have."""
    return Problem(
        key="--table",
        value=quoted(name),
        message="no such table in this answer",
        remedy=name_remedy(name, there),
    )
