"""Logs of control systems to readings by tag: a column a tag, or a row a reading.

A log has clock times. Its cells are read as they stand: what is no number is a reading that is
missing, and holds until the next one.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import repeat

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.errors import InputError, shown
from wraparc.machine_tables.clocks import has_offset, looks_like_clock, read_clocks
from wraparc.machine_tables.columns import NamedColumn, name_columns, plain_name, split_name
from wraparc.machine_tables.limits import refused
from wraparc.machine_tables.lines import DELIMITER_NAMES, split_all, splitter, unwrapped
from wraparc.machine_tables.numerals import NumeralStyle, looks_numeric, number_of, style_of
from wraparc.machine_tables.sniff import decode, is_workbook
from wraparc.machine_tables.workbook import tables_in_workbook

_SAMPLE, _PIECE, _FEWEST = 400, 20_000, 3
_TAG = ("tag", "name", "point", "variable", "signal", "item", "messstelle", "id", "channel")
_UNIT, _QUALITY = ("unit", "units", "einheit", "uom"), ("quality", "status", "qualitat", "q")
_GOOD = ("good", "ok", "gut", "192", "true", "valid", "0xc0")


@dataclass(frozen=True, eq=False)
class LogTag:
    """The readings of one tag.

    Attributes
    ----------
    name, unit
        As the file has them; empty where it has none.
    times
        Of its readings, in the order of the file [s since 1970].
    values
        Readings in their unit, nan where there is none.
    """

    name: str
    unit: str
    times: Array
    values: Array


@dataclass(frozen=True, eq=False)
class LogFile:
    """What a file of readings holds.

    Attributes
    ----------
    tags
        In the order of the file.
    is_long
        Whether a row is one reading, its tag in a column.
    is_zoned
        Whether its times state their offset, and so are UTC.
    rows
        Rows that were read.
    skipped
        Rows among them that are no readings.
    """

    tags: tuple[LogTag, ...]
    is_long: bool
    is_zoned: bool
    rows: int
    skipped: int


@dataclass
class _Layout:
    """Where what stands in a row."""

    sign: str
    width: int
    first: int
    clocks: list[int]
    numbers: list[int]
    tag: int | None = None
    unit: int | None = None
    quality: int | None = None
    style: NumeralStyle = field(default_factory=NumeralStyle)


def read_log(data: bytes, file: str, *, order: str = "") -> LogFile | None:
    """Return the readings in the bytes of a file; None where it has no clock times.

    Parameters
    ----------
    data, file
        The file, and its name for errors.
    order
        ``day first`` or ``month first``, where the dates do not prove it.

    Raises
    ------
    InputError
        If the file is no text or its numbers or dates can be read in two ways.
    """
    if is_workbook(data):
        return _read_workbook(data, file, order)
    lines = unwrapped(decode(data, file).text.split("\n"))
    layout = _layout(lines, file)
    if layout is None:
        return None
    header = [splitter(layout.sign)(line) for line in lines[: layout.first] if line.strip()]
    columns, _ = name_columns(header, layout.width, lambda cell: bool(cell.strip()))
    _assign(layout, columns, lines, file)
    return _read_rows(lines, layout, columns, file, order)


def _layout(lines: Sequence[str], file: str) -> _Layout | None:
    """Return how the rows of a log are cut, None if no column has clock times."""
    sample = [line for line in lines[:_SAMPLE] if line.strip()]
    best: tuple[int, int] = (0, 0)
    found: _Layout | None = None
    for sign in (s for s in DELIMITER_NAMES if s != " "):
        rows = split_all(sample, sign)
        timed = [row for row in rows if len(row) > 1 and any(map(looks_like_clock, row))]
        if len(timed) < _FEWEST:
            continue
        widths = [len(row) for row in timed]
        width = max(set(widths), key=widths.count)
        timed = [row for row in timed if len(row) == width]
        if (len(timed), width) > best:
            best = len(timed), width
            share = [sum(looks_like_clock(row[k]) for row in timed) for k in range(width)]
            filled = [sum(bool(row[k].strip()) for row in timed) for k in range(width)]
            clocks = [k for k in range(width) if share[k] > max(2, 0.9 * filled[k])]
            clocks = clocks or [int(np.argmax(share))]
            first = next(
                k for k, line in enumerate(lines)
                if len(row := splitter(sign)(line)) == width and looks_like_clock(row[clocks[0]])
            )  # fmt: skip
            found = _Layout(sign, width, first, clocks, [])
    return found


def _assign(
    layout: _Layout, columns: Sequence[NamedColumn], lines: Sequence[str], file: str
) -> None:
    """Find the columns of numbers, and tag, unit and quality of rows of single readings."""
    stop = min(len(lines), layout.first + 5 * _SAMPLE)
    rows = split_all([line for line in lines[layout.first : stop] if line.strip()], layout.sign)
    rows = [row for row in rows if len(row) == layout.width]
    cells = {k: [row[k].strip() for row in rows] for k in range(layout.width)}
    words = {
        k: [c for c in cells[k] if c and not looks_numeric(c)]
        for k in cells
        if k not in layout.clocks
    }
    plain = {k: plain_name(columns[k].name) for k in words}
    texts = [k for k in words if 2 * len(words[k]) > len(rows)]
    layout.quality = next((k for k in plain if plain[k].split()[:1] and
                           plain[k].split()[-1] in _QUALITY), None)  # fmt: skip
    layout.numbers = [k for k in words if k not in texts and k != layout.quality and any(cells[k])]
    tags = [k for k in texts if plain[k] not in _UNIT and k != layout.quality]
    if tags and (len(layout.numbers) == 1 or any(plain[k] in _TAG for k in tags)):
        named = [k for k in tags if any(w in _TAG for w in plain[k].split())]
        layout.tag = (named or sorted(tags, key=lambda k: -len(set(cells[k]))))[0]
        layout.unit = next((k for k in texts if plain[k] in _UNIT), None)
    numeric = [[c for c in cells[k] if looks_numeric(c)] for k in layout.numbers]
    layout.style = style_of([c for c in numeric if c], file)
    if not layout.numbers:
        raise refused(file, "has clock times and no numbers", "Export one row a reading.")


def _read_rows(
    lines: Sequence[str], layout: _Layout, columns: Sequence[NamedColumn], file: str, order: str
) -> LogFile:
    """Read all rows, piece by piece, so that memory stays small."""
    clocks: list[list[str]] = [[] for _ in layout.clocks]
    numbers: list[list[Array]] = [[] for _ in layout.numbers]
    tagged: list[Integers] = []
    places: dict[tuple[str, str], int] = {}
    skipped = 0
    for start in range(layout.first, len(lines), _PIECE):
        piece = [line for line in lines[start : start + _PIECE] if line.strip()]
        cut = split_all(piece, layout.sign)
        rows = [row for row in cut if len(row) == layout.width]
        skipped += len(cut) - len(rows)
        if not rows:
            continue
        by_column = list(zip(*rows, strict=True))
        for found, k in zip(clocks, layout.clocks, strict=True):
            found.extend(by_column[k])
        poor = _poor(by_column, layout)
        for pieces, k in zip(numbers, layout.numbers, strict=True):
            read = _values(by_column[k], layout.style)
            pieces.append(read if poor is None else np.where(poor, np.nan, read))
        if layout.tag is not None:
            of = by_column[layout.tag]
            units = repeat("", len(of)) if layout.unit is None else by_column[layout.unit]
            tagged.append(
                np.array([places.setdefault(p, len(places)) for p in zip(of, units, strict=True)])
            )
    zoned = bool(clocks[0]) and has_offset(clocks[0][0])
    at = [read_clocks(cells, file, order) for cells in clocks]
    values_of = [np.concatenate(v) if v else np.empty(0) for v in numbers]
    if layout.tag is not None:
        tags = _by_tag(places, tagged, at[0], values_of[0])
    else:
        tags = []
        for k, values in zip(layout.numbers, values_of, strict=True):
            clock = max((n for n, c in enumerate(layout.clocks) if c < k), default=0)
            there = np.isfinite(at[clock])
            if len(layout.clocks) > 1:
                there &= np.isfinite(values)
            column = columns[k]
            tags.append(LogTag(column.label, column.unit, at[clock][there], values[there]))
    there = np.isfinite(at[0])
    rows_read = int(np.count_nonzero(there))
    return LogFile(
        tuple(tags), layout.tag is not None, zoned, rows_read, skipped + len(there) - rows_read
    )


def _poor(columns: Sequence[Sequence[str]], layout: _Layout) -> Array | None:
    """Rows whose quality is not good, None where nothing says it."""
    if layout.quality is None:
        return None
    known = {cell: cell.strip().casefold() for cell in set(columns[layout.quality])}
    bad = {cell for cell, text in known.items() if text and not text.startswith(_GOOD)}
    return np.array([cell in bad for cell in columns[layout.quality]])


def _values(cells: Sequence[str], style: NumeralStyle) -> Array:
    """Return the numbers of a column, nan where there is none."""
    texts = [cell or "nan" for cell in cells]
    if style.decimal == ",":
        texts = [text.replace(",", ".") if "." not in text else text for text in texts]
    try:
        values = np.array(list(map(float, texts)))
    except ValueError:
        values = np.array([number_of(cell, style) for cell in cells])
    return np.where(np.isfinite(values), values, np.nan)


def _by_tag(
    places: dict[tuple[str, str], int], tagged: list[Integers], times: Array, values: Array
) -> list[LogTag]:
    """Return the readings of each tag of a log of single readings, one in two units as two."""
    of = np.concatenate(tagged) if tagged else np.empty(0, dtype=np.int64)
    tags = []
    for (name, own_unit), k in places.items():
        own = (of == k) & np.isfinite(times)
        label, unit = split_name(name.strip())
        tags.append(LogTag(label, own_unit.strip() or unit, times[own], values[own]))
    return tags


def _read_workbook(data: bytes, file: str, order: str) -> LogFile | None:
    """Return the readings of the largest sheet that has clock times."""
    found: LogFile | None = None
    for table in tables_in_workbook(data, file):
        texts = [["" if c is None else str(c) for c in column] for column in table.columns]
        clocks = [k for k, cells in enumerate(texts) if looks_like_clock(cells[0])]
        if not clocks or (found and found.rows >= table.rows):
            continue
        columns, _ = table.named(lambda cell: bool(cell.strip()))
        times = read_clocks(texts[clocks[0]], file, order)
        style = NumeralStyle()
        tags = [
            LogTag(columns[k].label, columns[k].unit, times, _values(cells, style))
            for k, cells in enumerate(texts)
            if k not in clocks
        ]
        found = LogFile(tuple(tags), False, False, table.rows, 0)
    return found


def refuse_no_log(file: str) -> InputError:
    """Return the error of a file without clock times."""
    return refused(
        file, "has no column of clock times", f"Export times such as {shown('2026-03-01 06:00')}."
    )
