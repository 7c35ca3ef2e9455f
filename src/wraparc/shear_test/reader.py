"""Machine files to records: find the table, its columns and units; ask for what is missing."""

import hashlib
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.errors import InputError, format_list, shown
from wraparc.machine_tables import (
    DELIMITER_NAMES,
    NamedColumn,
    NumeralStyle,
    RawTable,
    column_words,
    find_column,
    find_tables,
    looks_numeric,
    read_bytes,
    refused,
)
from wraparc.shear_test.choose import Chosen, choose_columns
from wraparc.shear_test.clock import clock_seconds
from wraparc.shear_test.divided import Part, divide
from wraparc.shear_test.one_test import (
    further_tests,
    joined,
    last_row,
    names_a_pull,
    off_trend,
    one_run,
    results_at_ends,
    sentinel_rows,
    side_by_side,
)
from wraparc.shear_test.record import Choices, ColumnInfo, Dropped, MachineRecord
from wraparc.shear_test.roles import Role, is_known, suitability
from wraparc.shear_test.stated import Stated, stated_in_file

_EXPORT = "Export travel and force, one row a reading."
_FACTORS = re.compile(r"(?i)fa[ck]t|gain|scal|skal|multipl|verst|sensit|empf|offset|calib|kalib")
_NO_FACTOR = {"0", "1", "0.0", "1.0", "0,0", "1,0"}
_NAME_DECIMAL = "Give --decimal (in a plan: decimal)."


def read_machine_file(path: str | Path, choices: Choices | None = None) -> MachineRecord:
    """Read the table of one test from a machine's export.

    Text with any delimiter, decimal sign and encoding, and Excel workbooks. See
    `read_machine_bytes` for what is found and what is asked for.

    Raises
    ------
    InputError
        If the file is missing or too large (200 MB), and as `read_machine_bytes`.
    """
    return read_machine_bytes(read_bytes(path, _EXPORT), str(path), choices)


def read_machine_bytes(data: bytes, file: str, choices: Choices | None = None) -> MachineRecord:
    """Read the table of one test from the bytes of a machine's export.

    Delimiter, decimal sign, encoding, the table, its columns and units are found by
    content. The unit of a column is never inferred: where the file has none, it must be
    given in ``choices.units``.

    Parameters
    ----------
    data
        The file.
    file
        Its name, for notes and errors.
    choices
        What the user says about it.

    Raises
    ------
    InputError
        If there is no table, or something cannot be decided: the sentence says what to
        add, and all that must be added stands in one error.
    """
    return _records(data, file, choices or Choices(), every=False)[0]


def read_machine_tests(path: str | Path, choices: Choices | None = None) -> list[MachineRecord]:
    """Read all tests that stand in the table of a machine's export, side by side or divided.

    Raises
    ------
    InputError
        As `read_machine_file`.
    """
    chosen = choices or Choices()
    return _records(read_bytes(path, _EXPORT), str(path), chosen, every=True)


def table_columns(data: bytes, file: str, choices: Choices) -> list[NamedColumn]:
    """Return names and units of the columns of the table that would be read.

    Raises
    ------
    InputError
        If there is no table, or it cannot be told which is meant.
    """
    found = find_tables(
        data, file, encoding=choices.encoding, delimiter=choices.delimiter, sheet=choices.sheet
    )
    return _pick_table(found.tables, choices, file)[0].named(is_known)[0]


def _records(data: bytes, file: str, chosen: Choices, *, every: bool) -> list[MachineRecord]:
    found = find_tables(
        data, file, encoding=chosen.encoding, delimiter=chosen.delimiter, sheet=chosen.sheet
    )
    table, said, unread = _pick_table(found.tables, chosen, file)
    source = _Source(file, found.encoding, hashlib.sha256(data).hexdigest())
    named = _named(table, chosen, file)
    blocks = side_by_side(named)
    if chosen.travel is not None and chosen.force is not None and chosen.block is None:
        blocks = [named]
    read = _numbers(table, named, chosen, file)

    def words(column: int) -> list[str]:
        return column_words(data, table, column, found.encoding)

    blocks = [_with_clock(block, read, words) for block in blocks]
    tests = [test for block in blocks for test in _tests(table, block, read, chosen, words)]
    if len(blocks) > 1:
        tests = [replace(t, table=own, read=numbers) for t in tests
                 for own, numbers in [_to_its_end(t.table, t.columns, t.read)]]  # fmt: skip
    wanted = _wanted_tests(tests, len(blocks), chosen, file, every=every)
    notes = (*found.notes, *said)
    records = []
    for k in wanted:
        of = tests[k]
        record = _record(of.table, of.columns, of.read, chosen, source, notes)
        stated = _stated(of, record, words)
        records.append(
            replace(record, block=k + 1, blocks=len(tests), part=of.part, stated=stated,
                    unread=unread)
        )  # fmt: skip
    return records


def _with_clock(
    block: Sequence[NamedColumn], read: "_Numbers", words: Callable[[int], Sequence[str]]
) -> list[NamedColumn]:
    """Columns of a test; a time that a clock wrote has seconds, and numbers in `read`."""
    found = []
    for column in block:
        is_time = suitability(column.name, Role.TIME) > 0.0
        if is_time and not np.isfinite(read.values[column.index]).any():
            seconds = clock_seconds(words(column.index))
            if seconds is not None:
                read.values[column.index] = seconds
                column = replace(column, unit="s")  # noqa: PLW2901 - the same, understood
        found.append(column)
    return found


@dataclass(frozen=True, eq=False)
class _Test:
    """One test of a table: its rows, its columns and their numbers, and what it is called."""

    table: RawTable
    columns: list[NamedColumn]
    read: "_Numbers"
    part: str
    rows: Integers


def _tests(
    table: RawTable,
    block: list[NamedColumn],
    read: "_Numbers",
    choices: Choices,
    words: Callable[[int], Sequence[str]],
) -> list[_Test]:
    """Divide the rows of a table into its tests."""
    travel = None if choices.travel is None else find_column(block, choices.travel)
    parts = divide(block, read.values, words, travel)
    if len(parts) == 1:
        return [_Test(table, block, read, "", parts[0].rows)]
    return [_rows_of(table, block, read, part) for part in parts]


def _rows_of(table: RawTable, block: list[NamedColumn], read: "_Numbers", part: Part) -> _Test:
    """Return the rows of one test of a table."""
    rows = part.rows
    first, last = (int(table.lines[rows[k]]) for k in (0, -1))
    sheet = f"sheet {table.sheet!r}, rows" if table.sheet else "lines"
    own = replace(
        table,
        place=f"{sheet} {first} to {last}",
        columns=tuple(
            cells[rows] if isinstance(cells, np.ndarray) else [cells[k] for k in rows.tolist()]
            for cells in table.columns
        ),
        lines=table.lines[rows],
        skipped=tuple(item for item in table.skipped if first <= item[0] <= last),
        cut=table.cut and rows[-1] == len(table.lines) - 1,
    )
    values = {index: column[rows] for index, column in read.values.items()}
    return _Test(own, block, replace(read, values=values), part.name, rows)


def _stated(
    of: _Test, record: MachineRecord, words: Callable[[int], Sequence[str]]
) -> tuple[Stated, ...]:
    """What the file says of a test in columns that are no readings, and above them."""
    used = {column.name for column in record.columns if column.role}
    one_word: dict[int, str] = {}
    for column in of.columns:
        if column.name and not np.isfinite(of.read.values[column.index]).any():
            cells = words(column.index)
            own = {cells[k].strip() for k in of.rows.tolist()}
            if len(own) == 1:
                one_word[column.index] = own.pop()
    used_places = [c.index for c in of.columns if c.label in used]
    return stated_in_file(of.columns, of.read.values, one_word, of.table.header, used_places)


def _to_its_end(
    table: RawTable, block: Sequence[NamedColumn], read: "_Numbers"
) -> tuple[RawTable, "_Numbers"]:
    """A test side by side with longer ones ends with its own last reading."""
    own = [
        read.values[c.index]
        for c in block
        if any(suitability(c.name, role) > 0.0 for role in (Role.TRAVEL, Role.FORCE))
    ]
    there = np.any([np.isfinite(values) for values in own], axis=0)
    end = len(there) - int(np.argmax(there[::-1]))
    values = {index: column[:end] for index, column in read.values.items()}
    columns = tuple(column[:end] for column in table.columns)
    cut = replace(
        table, lines=table.lines[:end], columns=columns, cut=table.cut and end == len(there)
    )
    return cut, replace(read, values=values)


def _wanted_tests(
    blocks: Sequence[_Test], beside: int, choices: Choices, file: str, *, every: bool
) -> list[int]:
    """Which of the tests of a table are to be read, counted from 0."""
    under = f" under each other ({blocks[0].part}, ...)" if blocks[0].part else ""
    where = " side by side" if beside > 1 else under
    if choices.block is not None and not 1 <= choices.block <= len(blocks):
        count = f"{len(blocks)} tests{where}" if len(blocks) > 1 else "one test only"
        raise refused(
            file,
            f"contains {count}",
            f"Write a number from 1 to {len(blocks)}." if len(blocks) > 1 else "Leave it out.",
            key="block",
            value=str(choices.block),
        )
    if choices.block is not None:
        return [choices.block - 1]
    if every or len(blocks) == 1:
        return list(range(len(blocks)))
    raise refused(
        file,
        f"contains {len(blocks)} tests{where}",
        "Write block = 1 for the first (wraparc read FILE shows all).",
    )


def _columns(block: Sequence[NamedColumn]) -> str:
    return " and ".join(
        f"{c.label!r} in column {c.index + 1}"
        for c in block
        if any(suitability(c.name, role) > 0 for role in (Role.TRAVEL, Role.FORCE))
    )


@dataclass(frozen=True, eq=False)
class _Numbers:
    """Numbers of the columns, in their own units, and how they were written."""

    values: dict[int, Array]
    style: NumeralStyle
    notes: tuple[str, ...]


def _numbers(
    table: RawTable, named: Sequence[NamedColumn], choices: Choices, file: str
) -> _Numbers:
    style, notes = _style(table, choices, file)
    return _Numbers({c.index: table.numbers(c.index, style) for c in named}, style, notes)


@dataclass(frozen=True)
class _Source:
    file: str
    encoding: str
    digest: str


def _pick_table(
    tables: Sequence[RawTable], choices: Choices, file: str
) -> tuple[RawTable, tuple[str, ...], int]:
    """The table to read, notes on the others, and how many of them look like further tests."""
    if not tables:
        raise refused(file, "has no line with two numbers", _EXPORT)
    if choices.table is not None:
        if not 1 <= choices.table <= len(tables):
            raise refused(
                file,
                f"has {len(tables)} tables",
                f"Write a number from 1 to {len(tables)}.",
                key="table",
                value=str(choices.table),
            )
        return tables[choices.table - 1], (), 0
    readings = [table for table in tables if not table.is_settings]
    if not readings:
        raise _only_settings(tables, file)
    best = max(readings, key=_merit)
    _refuse_ragged(tables, best, file)
    pieces = one_run(readings, best, choices)
    if len(pieces) > 1:
        whole = joined(pieces)
        notes = [f"the run was written in {len(pieces)} pieces, {whole.place}, and read as one"]
        left = [f"{t.place} ({t.rows} rows)" for t in tables if t not in pieces and t.rows > 1]
        if left:
            notes.append(f"not read, for they do not go on from it: {format_list(left, 5)}")
        return whole, tuple(notes), further_tests(tables, pieces)
    others = [f"{t.place} ({t.rows} rows)" for t in tables if t is not best and t.rows > 1]
    if not others:
        return best, (), 0
    number = tables.index(best) + 1
    listed = ", ".join(others[:5]) + (f" and {len(others) - 5} more" if len(others) > 5 else "")
    note = (
        f"the file has {len(tables)} tables; number {number}, {best.place}, was read; "
        f"the others are {listed}"
    )
    return best, (note,), further_tests(tables, [best])


def _only_settings(tables: Sequence[RawTable], file: str) -> InputError:
    return refused(
        file,
        f"contains settings or results in {tables[0].place}, no readings",
        f"{_EXPORT}",
    )


def _merit(table: RawTable) -> tuple[bool, int]:
    """Tables with a travel and a force by name come first, then the longest."""
    return names_a_pull(table) and table.rows >= 3, table.rows


def _refuse_ragged(tables: Sequence[RawTable], best: RawTable, file: str) -> None:
    """Rows of changing width are what decimal commas do in a file delimited by commas."""
    total = sum(table.rows for table in tables)
    if len(tables) < 6 or best.rows > total / 2 or best.delimiter != ",":
        return
    raise refused(
        file,
        "its rows change their number of cells, as decimal commas make them",
        "Export with decimal points, semicolons or tabs.",
        line=int(best.lines[0]),
    )


def _named(table: RawTable, choices: Choices, file: str) -> list[NamedColumn]:
    named, complaint = table.named(is_known)
    if _is_split(table, len(named)) and choices.travel is None:
        raise refused(
            file,
            f"its {len(named)} columns of whole numbers look split at decimal commas",
            "Export with decimal points, semicolons or tabs.",
            line=int(table.lines[0]),
        )
    if complaint and choices.travel is None:
        raise refused(
            file,
            complaint,
            "Name the columns by number: --travel 1 --force 2.",
            line=int(table.lines[0]),
        )
    return named


def _is_split(table: RawTable, width: int) -> bool:
    """Whether decimal commas were taken for delimiters: whole numbers, and too few names."""
    names = [sum(bool(cell) for cell in row) for row in table.header[-3:]]
    if table.delimiter != "," or not any(1 < n < width <= 2 * n for n in names):
        return False
    step = max(1, table.rows // 200)
    columns = [table.numbers(k, NumeralStyle())[::step] for k in range(width)]
    # the second half of a number has no sign
    whole = all(np.all(values == np.round(values)) for values in columns)
    return whole and sum(bool(np.all(values >= 0.0)) for values in columns) >= width // 2


def _record(
    table: RawTable,
    named: Sequence[NamedColumn],
    read: _Numbers,
    choices: Choices,
    source: _Source,
    notes: tuple[str, ...],
) -> MachineRecord:
    data, style, texts = read.values, read.style, read.notes
    _refuse_factors(table, source.file)
    above = [cell for row in table.header for cell in row]
    chosen = choose_columns(named, data, choices, source.file, above)
    keep, dropped = _kept_rows(table, data, chosen)
    picked = {role: data[c.index][keep] * u.factor for role, (c, u) in chosen.columns.items()}
    if not keep.any():
        raise _no_rows(source.file, dropped)
    used = {column.index: role.value for role, (column, _) in chosen.columns.items()}
    stated = {column.index: unit.text for column, unit in chosen.columns.values()}
    return MachineRecord(
        file=source.file,
        place=table.place,
        encoding=source.encoding,
        delimiter=DELIMITER_NAMES.get(table.delimiter, ""),
        decimal=style.decimal,
        columns=tuple(
            _info(c.label, stated.get(c.index, c.unit), used.get(c.index, ""), data[c.index])
            for c in named
            if c.name or not np.isnan(data[c.index]).all()
        ),
        travel=picked[Role.TRAVEL],
        force=picked[Role.FORCE],
        normal_force=picked.get(Role.NORMAL_FORCE),
        time=_going_on(picked.get(Role.TIME)),
        lines=table.lines[keep],
        rows=table.rows,
        dropped=dropped,
        notes=(*notes, *texts, *chosen.notes),
        passed_over=chosen.passed_over,
        header=tuple(" ".join(filter(None, row)) for row in table.header),
        digest=source.digest,
    )


def _going_on(time: Array | None) -> Array | None:
    """Time that goes on over the pieces of a run, each of which counts from its own start."""
    if time is None or len(time) < 3:
        return time
    steps = np.diff(time)
    usual = float(np.nanmedian(steps))
    back = np.flatnonzero(steps < -3.0 * abs(usual))
    if not len(back) or usual <= 0.0:
        return time
    shift = np.zeros(len(time))
    for k in back:
        shift[k + 1 :] += usual - steps[k]
    return np.asarray(time + shift)


def _refuse_factors(table: RawTable, file: str) -> None:
    """Refuse a table with a row of factors above its readings: whether they are in is not said."""
    for line, reason in table.skipped:
        said = reason.partition(": ")[2].split()
        if any(map(_FACTORS.match, said)) and any(
            looks_numeric(x) and x not in _NO_FACTOR for x in said
        ):
            raise refused(
                file,
                f"has factors above the readings: {' '.join(said[:4])}",
                "Multiply the readings by them, and delete the line.",
                line=line,
            )


def _style(table: RawTable, choices: Choices, file: str) -> tuple[NumeralStyle, tuple[str, ...]]:
    if choices.decimal is not None:
        if choices.decimal not in {".", ","}:
            raise refused(
                file,
                "no decimal sign",
                'Write "." or ",".',
                key="decimal",
                value=shown(choices.decimal),
            )
        if table.style is None or table.style.decimal == choices.decimal:
            return NumeralStyle(choices.decimal), ()
        raise refused(
            file,
            f"contradicts {table.style.proof} in the file",
            "Leave the decimal sign out.",
            key="decimal",
            value=shown(choices.decimal),
        )
    style = table.found_style(file, _NAME_DECIMAL)
    if style.decimal == ",":
        return style, (f"the comma is the decimal sign, as {style.proof} shows",)
    return style, ()


def _kept_rows(
    table: RawTable, data: Mapping[int, Array], chosen: Chosen
) -> tuple[np.ndarray[tuple[int], np.dtype[np.bool_]], tuple[Dropped, ...]]:
    keep = np.ones(table.rows, dtype=bool)
    dropped = [Dropped(reason=reason, count=1, line=line) for line, reason in table.skipped[:20]]
    if len(table.skipped) > 20:
        line, count = table.skipped[20][0], len(table.skipped) - 20
        dropped.append(Dropped(reason="further lines that are no rows", count=count, line=line))

    def drop(mask: np.ndarray[tuple[int], np.dtype[np.bool_]], reason: str) -> None:
        mask = mask & keep
        if mask.any():
            first = int(table.lines[mask][0])
            dropped.append(Dropped(reason=reason, count=int(mask.sum()), line=first))
            keep[mask] = False

    for role, (column, _) in chosen.columns.items():
        if role is not Role.TIME:
            drop(np.isnan(data[column.index]), f"no number in {column.label!r}")
    travel, force = (data[chosen.columns[r][0].index] for r in (Role.TRAVEL, Role.FORCE))
    ends = results_at_ends(data.values(), keep)
    drop(ends, "at an end of the table, and does not go on as the readings do: a result or setting")
    drop(sentinel_rows(travel, force, keep), "a mark of the machine, not a reading")
    if table.cut:
        cut = last_row(keep) if table.shorter else off_trend(travel, force, keep)
        drop(cut, "the last line is cut short")
    return keep, tuple(dropped)


def _no_rows(file: str, dropped: Sequence[Dropped]) -> InputError:
    first = max(dropped, key=lambda d: d.count)
    return refused(file, f"no usable row ({first.count} rows: {first.reason})", "See wraparc read.")


def _info(name: str, unit: str, role: str, values: Array) -> ColumnInfo:
    if np.isnan(values).all():
        return ColumnInfo(name=name, unit=unit, role=role)
    return ColumnInfo(
        name=name, unit=unit, role=role, low=float(np.nanmin(values)), high=float(np.nanmax(values))
    )
