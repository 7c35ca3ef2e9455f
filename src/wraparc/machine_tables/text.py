"""A text to raw tables: the delimiter, and long tables in pieces, so that memory stays small."""

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.errors import InputError
from wraparc.machine_tables.bulk import OtherSignError, read_bulk
from wraparc.machine_tables.limits import LONGEST_LINE, MOST_COLUMNS, MOST_LOOSE_CELLS, beyond
from wraparc.machine_tables.lines import delimiter_of, splitter, unwrapped
from wraparc.machine_tables.numerals import (
    NumeralStyle,
    contradicts,
    looks_numeric,
    numbers,
    style_of,
)
from wraparc.machine_tables.tables import RawTable, careful_tables, numeric_text

# Lines of the first piece, which holds the header, of the others, and of one that is not halved
# where it cannot be read at once; rows that a piece must
# start and end with, so that nothing is decided across its ends; rows that show a decimal sign.
_HEAD, _PIECE, _SMALL, _SEAM, _SAMPLE = 150, 5000, 60, 3, 2000
_LAST_DECIMALS = re.compile(r"[.,](\d*)\"?\s*$")


def tables_in_text(
    text: str, *, delimiter: str | None = None, ended: bool = True, file: str = ""
) -> list[RawTable]:
    """Find every table in `text`.

    Parameters
    ----------
    text
        The file, its line ends those of Unix.
    delimiter
        What stands between cells (a blank: any run of blanks), if it is not to be found.
    ended
        Whether the last line has its line end.
    file
        Its name, for the error.

    Returns
    -------
    Tables in the order of the file; none if no line looks like a row of numbers.

    Raises
    ------
    InputError
        If it is more than a test can need: lines too long, rows of too many cells, too many
        tables, or too many cells that can only be read one by one.
    """
    lines = unwrapped(text.split("\n"))
    while lines and not lines[-1].strip():
        lines.pop()
    sign = delimiter or delimiter_of(lines)
    _refuse_long_lines(lines, sign or ",", file)
    if sign is None:
        return []
    tables = _quick(lines, sign) if len(lines) > _HEAD else None
    if tables is None:
        _refuse_many(lines, sign, file)
        tables = careful_tables(lines, sign, file=file)
    if tables and not ended and tables[-1].lines[-1] == len(lines):
        tables[-1] = replace(tables[-1], cut=True, shorter=_has_fewer_decimals(lines))
    return tables


def _refuse_long_lines(lines: Sequence[str], sign: str, file: str) -> None:
    """Refuse lines of too many characters, and of too many cells."""
    longest = max(map(len, lines), default=0)
    if longest > LONGEST_LINE:
        number = next(k for k, line in enumerate(lines, start=1) if len(line) == longest)
        message = f"has {longest} characters, more than {LONGEST_LINE}"
        raise beyond(message, file, number)
    for number, line in enumerate(lines if longest >= 2 * MOST_COLUMNS else (), start=1):
        cells = len(line.split()) if sign == " " else line.count(sign) + 1
        if cells > MOST_COLUMNS:
            message = f"has {cells} cells, more than {MOST_COLUMNS}"
            raise beyond(message, file, number)


def _refuse_many(lines: Sequence[str], sign: str, file: str) -> None:
    """Refuse what would have to be read cell by cell for long."""
    # of blanks any number stands between two cells
    cells = sum(line.count(sign) + 1 if sign != " " else len(line.split()) for line in lines)
    if cells > MOST_LOOSE_CELLS:
        raise beyond(
            f"contains {cells} cells in no plain table, more than {MOST_LOOSE_CELLS}",
            file,
        )


def _has_fewer_decimals(lines: Sequence[str]) -> bool:
    counts = []
    for line in lines[-21:]:
        match = _LAST_DECIMALS.search(line)
        counts.append(len(match[1]) if match else 0)
    return counts[-1] < min(counts[:-1], default=0)


@dataclass(eq=False)
class _Growing:
    """A table whose rows come piece by piece."""

    table: RawTable
    values: list[Array] = field(default_factory=list)
    lines: list[Integers] = field(default_factory=list)
    skipped: list[tuple[int, str]] = field(default_factory=list)
    style: NumeralStyle | None = None

    @property
    def last(self) -> int:
        """Its last line."""
        return int((self.lines[-1] if self.lines else self.table.lines)[-1])

    @property
    def width(self) -> int:
        """Cells of a row."""
        return len(self.table.columns)

    def add_rows(self, values: Array, lines: Integers) -> None:
        """Add numbers."""
        self.values.append(values)
        self.lines.append(lines)

    def add_table(self, table: RawTable, style: NumeralStyle) -> None:
        """Add the rows of a piece that was read carefully."""
        if contradicts([numeric_text(column) for column in table.columns], style):
            raise OtherSignError
        columns = [numbers(column, style) for column in table.columns]
        self.add_rows(np.column_stack(columns), table.lines)
        self.skipped += table.skipped

    def whole(self) -> RawTable:
        """Return the table with all of its rows."""
        if self.style is None or not self.lines:
            return self.table
        first = self.table
        columns = tuple(
            np.concatenate([numbers(column, self.style), *(part[:, k] for part in self.values)])
            for k, column in enumerate(first.columns)
        )
        start = int(first.lines[0])
        return replace(
            first,
            place=f"lines {start} to {self.last}",
            columns=columns,
            lines=np.concatenate([first.lines, *self.lines]),
            skipped=(*first.skipped, *self.skipped),
            style=self.style,
        )


def _quick(lines: Sequence[str], sign: str) -> list[RawTable] | None:
    """Find the tables piece by piece; None where that cannot be done."""
    found: list[_Growing] = []
    start = 0
    try:
        while start < len(lines):
            stop = _seam(lines, sign, start + (_PIECE if found else _HEAD))
            stop = _before_blank(lines, sign, start, stop)
            _add_piece(found, lines, start, stop, sign)
            start = stop
    except (OtherSignError, InputError):
        return None
    return [growing.whole() for growing in found]


def _add_piece(
    found: list[_Growing], lines: Sequence[str], start: int, stop: int, sign: str
) -> None:
    """Read the lines of a piece; they go on with the last table, and may end it."""
    piece = lines[start:stop]
    if found:
        growing = found[-1]
        if growing.style is None:
            growing.style = _style(growing.table, piece, sign)
        rows = np.arange(start + 1, stop + 1)
        if not all(piece):
            rows = np.array([k for k, line in enumerate(piece, start + 1) if line])
            piece = [line for line in piece if line]
        values = read_bulk(piece, sign, growing.width, growing.style)
        if values is not None:
            growing.add_rows(values, rows)
            return
    # what has to be read carefully is made small, by halves
    middle = _seam(lines, sign, (start + stop) // 2, stop) if found else stop
    if stop - start > _SMALL and middle < stop:
        _add_piece(found, lines, start, middle, sign)
        _add_piece(found, lines, middle, stop, sign)
        return
    _refuse_many(lines[start:stop], sign, "")
    header = found[-1].table.header if found else ()
    tables = careful_tables(lines[start:stop], sign, start, header=header)
    if found:
        first = tables.pop(0) if tables else None
        style = found[-1].style
        if first is None or style is None or len(first.columns) != found[-1].width:
            raise OtherSignError
        found[-1].add_table(first, style)
    found += [_Growing(table) for table in tables]


def _style(table: RawTable, piece: Sequence[str], sign: str) -> NumeralStyle:
    """Decimal sign that the first rows of a table prove."""
    split, width = splitter(sign), len(table.columns)
    rows = [cells for cells in map(split, piece[:_SAMPLE]) if len(cells) == width]
    columns = [
        [*map(str, own), *more]
        for own, more in itertools.zip_longest(table.columns, zip(*rows, strict=True), fillvalue=())
    ]
    return style_of([text for text in map(numeric_text, columns) if text], "")


def _seam(lines: Sequence[str], sign: str, target: int, end: int | None = None) -> int:
    """Find a place from `target` on, before `end`, with rows of one width on both sides, or it."""
    split = splitter(sign)

    def width(line: str) -> int:
        cells = split(line)
        return len(cells) if sum(map(looks_numeric, cells)) >= 2 else 0

    alike, before = 0, 0
    end = len(lines) if end is None else end
    for k in range(max(0, target - _SEAM), end):
        own = width(lines[k])
        alike = alike + 1 if own and own == before else int(own > 0)
        before = own
        if alike >= 2 * _SEAM:
            return k + 1 - _SEAM
    return end


def _before_blank(lines: Sequence[str], sign: str, start: int, stop: int) -> int:
    """End of a piece before an empty line, which may end the table, if that is far from it."""
    try:
        blank = lines.index("", start, stop)
    except ValueError:
        return stop
    return min(stop, _seam(lines, sign, blank - 2 * _SEAM)) if blank - start > _HEAD else stop
