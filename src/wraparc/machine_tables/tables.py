"""Text to raw tables: delimiter, header, names, units, cells. Knows no brand.

A table is a run of lines that have the same number of cells, at least two of them
numbers. What stands above it is its header; whole lines in quotes are unwrapped.
"""

import itertools
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.errors import shown
from wraparc.machine_tables.code_pages import printable
from wraparc.machine_tables.columns import (
    NamedColumn,
    are_numbers_of_columns,
    is_unit_text,
    name_columns,
)
from wraparc.machine_tables.limits import MOST_TABLES, beyond, refused
from wraparc.machine_tables.lines import split_all, splitter
from wraparc.machine_tables.numerals import NumeralStyle, looks_numeric, numbers, style_of

Cells = Sequence[object] | Array
_LARGEST_GAP, _LONGEST_REPEAT, _RISING, _FEW, _LOOKED_BACK = 2, 5, 5, 3, 20
_NO_WORDS = {
    *(
        "nan",
        "qnan",
        "ind",
        "inf",
        "na",
        "div",
        "value",
        "wert",
        "nv",
        "null",
        "none",
        "error",
        "err",
    ),
    *("over", "ovl", "overload", "overflow", "under"),
}
_HEADER_KEPT, _MOST_SETTINGS = 40, 100
_ALL_NUMERIC = re.compile(r'(?=.*[0-9])[-+\u22120-9eE.,;|\t "]*')
_BETWEEN = re.compile(r"(?<=\d)[.'’\s](?=\d{3})")
EMPTY = ' ;,|\t"'
_LONG_NAMES, _LOOKED_AT = 5000, 200
_RAGGED = f"its rows change their number of cells more than {MOST_TABLES} times"


@dataclass(frozen=True, eq=False)
class RawTable:
    """One table of a file, its cells as written.

    Parameters
    ----------
    place
        Where it stands, for example ``"lines 13 to 2196"`` or ``"sheet 'Data'"``.
    header
        Lines above it, as cells; the nearest is the last.
    columns
        Cells, column by column.
    lines
        Line (or sheet row) of each row, counted from 1.
    skipped
        Line and reason of each line inside the table that is no row of it.
    delimiter
        What stands between the cells; empty for a workbook.
    cut
        Whether the last row ends the file without a line end, so that its last number may be
        incomplete.
    shorter
        Whether that number also has fewer decimals than those above it.
    sheet
        Name of the sheet in a workbook.
    style
        Decimal sign, where the columns hold numbers converted already.
    """

    place: str
    header: tuple[tuple[str, ...], ...]
    columns: tuple[Cells, ...]
    lines: Integers
    skipped: tuple[tuple[int, str], ...] = ()
    delimiter: str = ""
    cut: bool = False
    shorter: bool = False
    sheet: str = ""
    style: NumeralStyle | None = None

    @property
    def is_settings(self) -> bool:
        """Whether its rows are settings, each under a name of its own, not readings."""
        if self.rows > _MOST_SETTINGS:
            return False
        for column in self.columns:
            words = [str(cell).strip() for cell in column if isinstance(cell, str)]
            if len(words) == self.rows and all(map(_is_word, words)):
                return len(set(words)) >= max(2, 0.8 * self.rows)
        return False

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self.lines)

    def named(self, known: Callable[[str], object]) -> tuple[list[NamedColumn], str]:
        """Return the columns with their names and units, and a complaint; see `name_columns`."""
        last = self.columns[-1]
        empty = (
            bool(np.isnan(last).all())
            if isinstance(last, np.ndarray)
            else not any(str(cell).strip() for cell in last)
        )
        return name_columns(self.header, len(self.columns), known, last_empty=empty)

    def found_style(self, file: str, remedy: str = "") -> NumeralStyle:
        """Return the decimal sign that its cells prove, or raise; see `style_of`."""
        columns = [] if self.style else [numeric_text(column) for column in self.columns]
        return self.style or style_of([column for column in columns if column], file, remedy)

    def numbers(self, place: int, style: NumeralStyle) -> Array:
        """Return the numbers of a column, NaN where there is none."""
        return numbers(self.columns[place], style)


def numeric_text(column: Cells) -> Sequence[str]:
    """Cells of a column that holds numbers as text; of a mixed one, those that are text."""
    step = max(1, len(column) // 50)
    sample = [cell for cell in column[::step] if isinstance(cell, str) and cell.strip()]
    if 2 * sum(map(looks_numeric, sample)) < len(sample) or not sample:
        return ()
    return [cell for cell in column if isinstance(cell, str)]


def careful_tables(
    lines: Sequence[str],
    sign: str,
    offset: int = 0,
    file: str = "",
    header: Sequence[Sequence[str]] = (),
) -> list[RawTable]:
    """Find the tables cell by cell; `offset` lines stand before the first, under a `header`.

    Raises
    ------
    InputError
        If there are more than `MOST_TABLES`, as rows of changing numbers of cells make them.
    """
    cells = split_all(lines, sign)
    runs = _runs(cells, _row_widths(lines, cells), file, header)
    tables = []
    for run, start in _with_starts(runs, cells):
        above = [line for line in lines[start : run.first] if line.strip(EMPTY)]
        names = tuple(_header_cells(line, sign, run.width) for line in above[-_HEADER_KEPT:])
        tables.append(_text_table(cells, run, names, sign, offset))
    return tables


def tables_in_rows(rows: Sequence[Sequence[object]], sheet: str, file: str = "") -> list[RawTable]:
    """Find every table in the rows of a worksheet; cells are text or numbers."""
    widths = np.array([_mixed_width(row) for row in rows], dtype=np.int64)
    texts = _Texts(rows)
    runs = _runs(texts, widths, file, ())
    if not runs:
        refuse_units_in_cells([texts[k] for k in range(min(len(rows), _LOOKED_AT))], file)
    tables = []
    for run, start in _with_starts(runs, texts):
        above = [row for row in map(texts.__getitem__, range(start, run.first)) if any(row)]
        picked = [rows[k] for k in run.rows]
        tables.append(
            RawTable(
                place=f"sheet {sheet!r}, rows {run.first + 1} to {run.last + 1}",
                header=tuple(map(tuple, above[-_HEADER_KEPT:])),
                columns=tuple(zip(*picked, strict=True)),
                lines=np.array(run.rows, dtype=np.int64) + 1,
                skipped=tuple((k + 1, reason) for k, reason in run.skipped),
                sheet=sheet,
            )
        )
    return tables


def refuse_units_in_cells(rows: Sequence[Sequence[str]], file: str) -> None:
    """Refuse rows whose numbers have their units behind them: such cells are text.

    Raises
    ------
    InputError
        Where five rows have two such cells or more.
    """
    found = [[cell for cell in row if _with_unit(cell)] for row in rows]
    found = [cells for cells in found if len(cells) > 1]
    if len(found) < _RISING:
        return
    raise refused(
        file,
        f"its cells are text with units, such as {shown(found[0][0])}",
        "Write units into the heading, numbers alone below.",
    )


def _with_unit(cell: str) -> bool:
    number, _, unit = cell.strip().rpartition(" ")
    return looks_numeric(number) and is_unit_text(unit)


class _Texts(Sequence[list[str]]):
    """Cells of a worksheet as text, made of the few rows that are no rows of numbers."""

    def __init__(self, rows: Sequence[Sequence[object]]) -> None:
        self._rows = rows

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, row: Any) -> Any:
        return [_text(cell) for cell in self._rows[row]]


def _text(cell: object) -> str:
    return "" if cell is None else printable(str(cell)).strip()


def _mixed_width(row: Sequence[object]) -> int:
    numeric = sum(
        looks_numeric(cell)
        if isinstance(cell, str)
        else isinstance(cell, int | float) and not isinstance(cell, bool)
        for cell in row
    )
    if numeric >= 2:
        return len(row)
    return -1 if any(_text(cell) for cell in row) else 0


def _text_table(
    cells: Sequence[list[str]],
    run: "_Run",
    header: tuple[tuple[str, ...], ...],
    sign: str,
    offset: int,
) -> RawTable:
    before = offset + 1
    return RawTable(
        place=f"lines {run.first + before} to {run.rows[-1] + before}",
        header=header,
        columns=tuple(zip(*[cells[k] for k in run.rows], strict=True)),
        lines=np.array(run.rows, dtype=np.int64) + before,
        skipped=tuple((k + before, reason) for k, reason in run.skipped),
        delimiter=sign,
    )


def _header_cells(line: str, sign: str, width: int) -> tuple[str, ...]:
    if sign != " ":
        return tuple(cell.strip() for cell in splitter(sign)(line))
    if len(line) > _LONG_NAMES:
        return tuple(line.split())
    # Blanks also stand inside names: prefer the reading that fits the number of columns.
    for pattern in (r"\S+(?: \S+)*", r"[^\s\[(]+\s*[\[(][^\])]*[\])]|\S+"):
        parts = re.findall(pattern, line)
        if len(parts) == width:
            return tuple(parts)
    return tuple(line.split())


def _row_widths(lines: Sequence[str], cells: Sequence[Sequence[str]]) -> Integers:
    """Cells of each line that is a row of numbers; 0 for an empty line, -1 for any other."""
    widths = np.fromiter(map(len, cells), dtype=np.int64, count=len(cells))
    matches = _ALL_NUMERIC.fullmatch
    plain = np.fromiter((matches(x) is not None for x in lines), dtype=bool, count=len(lines))
    for k in np.flatnonzero(~plain | (widths < 2)).tolist():
        if widths[k] < 2 or sum(map(looks_numeric, cells[k])) < 2:
            widths[k] = -1 if lines[k].strip(EMPTY) else 0
    return widths


@dataclass
class _Run:
    """Rows of one width under each other, being collected."""

    first: int
    last: int
    width: int
    rows: list[int] = field(default_factory=list)
    skipped: list[tuple[int, str]] = field(default_factory=list)


def _runs(
    cells: Sequence[Sequence[str]],
    widths: Integers,
    file: str,
    header: Sequence[Sequence[str]],
) -> list[_Run]:
    """Group rows into tables; a line or two that is no row does not end a table."""
    bounds = [0, *(np.flatnonzero(np.diff(widths)) + 1).tolist(), len(widths)]
    stretches = [
        (a, b, int(widths[a])) for a, b in itertools.pairwise(bounds) if b > a and widths[a] != 0
    ]
    found: list[_Run] = []
    gap: list[int] = []
    for place, (start, stop, width) in enumerate(stretches):
        run = found[-1] if found else None
        following = [w for _, _, w in stretches[place + 1 : place + 3] if w > 0]
        if width < 0:
            gap.extend(range(start, stop))
            continue
        if run and width == run.width and _repeats_header(gap, cells, run, start, header):
            run.skipped.extend((k, "the header again") for k in gap)
            run.rows.extend(range(start, stop))
            run.last = stop - 1
        elif run and width == run.width and not _ends_table(gap, cells, run, start):
            run.skipped.extend((k, f"not a row of numbers: {_shown(cells[k])}") for k in gap)
            run.rows.extend(range(start, stop))
            run.last = stop - 1
        elif (
            run and not gap and stop - start <= _LARGEST_GAP and following[:1] in ([], [run.width])
        ):
            run.skipped.extend(
                (k, f"{width} cells instead of {run.width}") for k in range(start, stop)
            )
            run.last = stop - 1
        elif len(found) == MOST_TABLES:
            raise beyond(_RAGGED, file, start + 1)
        else:
            found.append(_Run(start, stop - 1, width, list(range(start, stop))))
        gap = []
    if found and len(gap) == 1 and gap[0] == len(widths) - 1:
        found[-1].skipped.append((gap[0], f"not a row of numbers: {_shown(cells[gap[0]])}"))
    return found


def _ends_table(gap: Sequence[int], cells: Sequence[Sequence[str]], run: _Run, after: int) -> bool:
    """Whether lines between rows end a table: many, names, or a title of what does not go on."""
    if len(gap) > _LARGEST_GAP:
        return True
    goes_on = _rises_on(cells, run, after)
    widths = [abs(len(cells[k]) - run.width) for k in gap if sum(map(_is_text, cells[k])) >= 2]
    return goes_on is False or 0 in widths or (1 in widths and goes_on is None)


def _joined(row: Sequence[str]) -> str:
    return " ".join(" ".join(row).split())


def _repeats_header(
    gap: Sequence[int],
    cells: Sequence[Sequence[str]],
    run: _Run,
    after: int,
    header: Sequence[Sequence[str]],
) -> bool:
    """Whether the lines between are those above the table, and its first rising column rises on."""
    if not 0 < len(gap) <= _LONGEST_REPEAT:
        return False
    above = {_joined(row) for row in header}
    above |= {_joined(cells[k]) for k in range(max(0, run.first - _LONGEST_REPEAT), run.first)}
    return all(_joined(cells[k]) in above for k in gap) and _rises_on(cells, run, after) is True


def _rises_on(cells: Sequence[Sequence[str]], run: _Run, after: int) -> bool | None:
    """Whether most columns that rise over the last rows go on in the row after; None of none."""
    rows = [cells[k] for k in run.rows[-_LOOKED_BACK:]]
    columns = [
        [_roughly(row[column]) for row in (*rows, cells[after])] for column in range(run.width)
    ]
    rising = [c for c in columns if all(a < b for a, b in itertools.pairwise(c[:-1]))]
    if not rising or len(rows) < _FEW:
        return None
    return sum(c[-1] > c[-2] for c in rising) > len(rising) / 2


def _roughly(cell: str) -> float:
    """Return the number of a cell, its last sign a decimal one, to compare it with others."""
    whole, point, part = cell.replace(",", ".").rpartition(".")
    try:
        return float(_BETWEEN.sub("", whole) + point + part)
    except ValueError:
        return np.nan


def _with_starts(
    runs: Sequence[_Run], cells: Sequence[Sequence[str]]
) -> Iterator[tuple[_Run, int]]:
    """Yield the tables, each with where its header starts; names that are numbers are names."""
    start = 0
    for place, run in enumerate(runs):
        following = runs[place + 1] if place + 1 < len(runs) else None
        if (
            len(run.rows) == 1
            and following is not None
            and following.width == run.width
            and following.first - run.last - 1 in (1, 2)
            and _is_header(cells[run.first], [cells[k] for k in following.rows[:5]])
        ):
            continue  # above a line of units
        first = cells[run.first]
        if len(run.rows) > _RISING and _is_header(first, [cells[k] for k in run.rows[1:6]]):
            run.rows.pop(0)
            run.first += 1
        while len(run.rows) > _RISING and _is_setting(cells, run):
            line = run.rows.pop(0)
            run.skipped.append((line, f"not a row of numbers: {_shown(cells[line])}"))
        yield run, start
        # settings, each behind its name, are part of the head of what follows
        few = len(run.rows) <= _FEW and all(cells[k] and _is_text(cells[k][0]) for k in run.rows)
        start = start if few else run.last + 1


def _is_setting(cells: Sequence[Sequence[str]], run: _Run) -> bool:
    """Whether the first row has a word where the rows below it have numbers, as one of factors."""
    below = [cells[k] for k in run.rows[1 : 1 + _RISING]]
    words = [k for k, cell in enumerate(cells[run.rows[0]]) if _is_word(cell)]
    return any(2 * sum(looks_numeric(row[k]) for row in below) > len(below) for k in words)


def _is_header(first: Sequence[str], following: Sequence[Sequence[str]]) -> bool:
    """Whether the first row of numbers holds names: words above numbers, or numbers of columns."""
    if are_numbers_of_columns(first):
        return any("." in cell or "," in cell for row in following for cell in row)
    numeric = [all(looks_numeric(row[k]) for row in following) for k in range(len(first))]
    words = [k for k, cell in enumerate(first) if numeric[k] and _is_word(cell)]
    others = [cell for k, cell in enumerate(first) if k not in words and cell.strip()]
    return bool(words) and all(cell.strip().isdecimal() or _is_word(cell) for cell in others)


def _is_word(cell: str) -> bool:
    return sum(map(str.isalpha, cell)) >= 2 and _is_text(cell)


def _is_text(cell: str) -> bool:
    """Whether a cell is neither a number nor what machines write for one that is missing."""
    letters = "".join(filter(str.isalpha, cell)).casefold()
    return bool(letters) and letters not in _NO_WORDS and not looks_numeric(cell)


def _shown(row: Sequence[str]) -> str:
    text = " ".join(cell.strip() for cell in row if cell.strip())
    return text if len(text) <= 40 else text[:37] + "..."
