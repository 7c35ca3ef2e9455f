"""Which rows of a file are one test: side by side, in pieces, without marks and results."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.errors import InputError
from wraparc.machine_tables import Cells, NamedColumn, NumeralStyle, RawTable, plain_name
from wraparc.shear_test.reduce import LEAST_POINTS
from wraparc.shear_test.roles import Role, is_known, suitability

# Steps of time or travel that may lie between two pieces, in steps inside them. Ours.
_STEPS = 10.0
_NUMBER = re.compile(r"\d+")
_MARKS = (9999.0, 99999.0, 999999.0, 9999999.0, 32767.0, 32768.0, 1e30)
_ENDS = 3
# Rows of results that may stand under a table. Ours.
_MOST_RESULTS = 10
# Usual steps that a jump back is larger than. Ours.
_JUMP = 3.0


def alike(table: RawTable, other: RawTable) -> bool:
    """Whether two tables have the same columns by name and unit, or one of them has no head."""
    (own, _), (others, _) = table.named(is_known), other.named(is_known)
    names = [any(c.name or c.unit for c in columns) for columns in (own, others)]
    same = own == others if all(names) else any(names) and len(own) == len(others)
    return table.rows > 1 and same


def further_tests(tables: Sequence[RawTable], read: Sequence[RawTable]) -> int:
    """How many tables of a file look like tests of their own beside those read, not like results.

    They have the same columns, and rows enough for a pull.
    """
    others = [table for table in tables if table not in read and table.rows >= LEAST_POINTS]
    return sum(alike(table, read[0]) for table in others)


def one_run(tables: Sequence[RawTable], best: RawTable) -> list[RawTable]:
    """Return the tables of a file that make one run with the best of them, in their order.

    Heads and units agree, and time or travel runs on from each to the next.
    """
    # without a head the best is like those that have one, and not like itself
    same = [table for table in tables if table is best or alike(table, best)]
    if len(same) < 2:
        return [best]
    style = _style(same)
    first = last = same.index(best)
    while first > 0 and _runs_on(same[first - 1], same[first], style):
        first -= 1
    while last + 1 < len(same) and _runs_on(same[last], same[last + 1], style):
        last += 1
    return same[first : last + 1]


def joined(pieces: Sequence[RawTable]) -> RawTable:
    """Return the pieces of a run as one table."""
    columns: list[Cells] = []
    for cells in zip(*(piece.columns for piece in pieces), strict=True):
        if all(isinstance(part, np.ndarray) for part in cells):
            columns.append(np.concatenate(cells))
        else:
            columns.append(tuple(cell for part in cells for cell in part))
    begin, end = (str(int(piece.lines[k])) for piece, k in ((pieces[0], 0), (pieces[-1], -1)))
    sheet = f"sheet {pieces[0].sheet!r}, rows" if pieces[0].sheet else "lines"
    return replace(
        pieces[0],
        place=f"{sheet} {begin} to {end}",
        columns=tuple(columns),
        lines=np.concatenate([piece.lines for piece in pieces]),
        skipped=tuple(line for piece in pieces for line in piece.skipped),
        cut=pieces[-1].cut,
        shorter=pieces[-1].shorter,
    )


def _style(tables: Sequence[RawTable]) -> NumeralStyle:
    """The decimal sign that one of the tables proves, for all of them."""
    for table in tables:
        try:
            return table.found_style("")
        except InputError:
            continue
    return NumeralStyle()


def _runs_on(before: RawTable, after: RawTable, style: NumeralStyle) -> bool:
    named, _ = before.named(is_known)
    for role in (Role.TIME, Role.TRAVEL):
        column = max(named, key=lambda c: suitability(c.name, role))
        if suitability(column.name, role) == 0.0 or before.sheet != after.sheet:
            continue
        if _goes_on(*(table.numbers(column.index, style) for table in (before, after))):
            return True
    return False


def _goes_on(before: Array, after: Array) -> bool:
    steps = np.diff(before)
    if len(steps) < 2 or len(after) < 2 or not np.all(np.isfinite([*steps, *after[:2]])):
        return False
    usual, step = float(np.median(steps)), float(after[0] - before[-1])
    return usual != 0.0 and 0.0 < step / usual <= _STEPS and (after[1] - after[0]) / usual > 0.0


def side_by_side(named: Sequence[NamedColumn]) -> list[list[NamedColumn]]:
    """Return the columns of each test; one list of all if there is one test only.

    Tests stand side by side where every travel and every force column comes as often as any
    other of them, but for numbers in the names. A column that comes once belongs to all.
    """
    groups: dict[str, list[NamedColumn]] = {}
    for column in named:
        groups.setdefault(_NUMBER.sub("", plain_name(column.name)).strip(), []).append(column)
    travels, forces = (_counts(groups, role) for role in (Role.TRAVEL, Role.FORCE))
    number = max(travels, default=1)
    if number < 2 or not travels == forces == {number}:
        return [list(named)]
    blocks: list[list[NamedColumn]] = [[] for _ in range(number)]
    for name, columns in groups.items():
        if name and len(columns) == number:
            for block, column in zip(blocks, columns, strict=True):
                block.append(column)
        elif name and len(columns) == 1:
            for block in blocks:
                block.append(columns[0])
    return [sorted(block, key=lambda column: column.index) for block in blocks]


def _counts(groups: Mapping[str, Sequence[NamedColumn]], role: Role) -> set[int]:
    """How often each column of a role comes."""
    return {len(own) for own in groups.values() if suitability(own[0].name, role) > 0.0}


def sentinel_rows(travel: Array, force: Array, keep: Flags) -> Flags:
    """Rows at either end where both columns are 0 after a jump, or hold a number like -9999.

    Parameters
    ----------
    travel, force
        In the file's own units, shape (n,).
    keep
        Rows still in use, shape (n,).
    """
    marked = np.zeros(len(travel), dtype=bool)
    rows = np.flatnonzero(keep)
    if len(rows) < 5:
        return marked
    for column in (travel, force):
        marked |= _marks(column, rows)
    steps = np.abs(np.diff(travel[rows]))
    usual = max(float(np.quantile(steps, 0.9)), float(np.median(np.abs(travel[rows]))) * 1e-6)
    for inward in (rows[::-1], rows):
        for k in range(_ENDS):
            end, inner = inward[k], inward[k + 1]
            if travel[end] == 0.0 == force[end] and abs(travel[inner]) > 20.0 * usual:
                marked[inward[: k + 1]] = True
    return marked


def _marks(column: Array, rows: Integers) -> Flags:
    """Values written for "nothing measured", far outside all others of the column."""
    found = np.zeros(len(column), dtype=bool)
    size = np.abs(column[rows])
    suspect = np.isin(size, _MARKS) | (size >= 1e30)
    if 0 < np.count_nonzero(suspect) < len(rows) / 2:
        largest = float(size[~suspect].max())
        found[rows[suspect]] = size[suspect] > 5.0 * largest
    return found


def results_at_ends(columns: Iterable[Array], keep: Flags) -> Flags:
    """Return the first and last rows that are results or settings, not readings.

    In the last a column has no number that has one before, for a word stands in its place; or one
    that rises evenly everywhere else, as time does, jumps back.

    Parameters
    ----------
    columns
        All columns of the table, shape (n,) each.
    keep
        Rows still in use, shape (n,).
    """
    rows = np.flatnonzero(keep)
    most = min(_MOST_RESULTS, len(rows) // 6)
    middle = slice(most, len(rows) - most)
    found = np.zeros(len(keep), dtype=bool)
    if not most:
        return found
    for column in columns:
        values = column[rows]
        off = ~np.isfinite(values)
        if off[middle].any():
            continue
        off[:most] = False
        steps = np.diff(values)
        usual = float(np.median(steps[middle]))
        # rows before the last jump at the start, and from the first jump at the end
        if usual > 0.0 and np.all((steps[middle] > 0.0) & (steps[middle] < _JUMP * usual)):
            jumps = np.flatnonzero(steps < -_JUMP * usual)
            begin, end = jumps[jumps < most], jumps[jumps >= most]
            off[: 1 + begin[-1] if len(begin) else 0] = True
            off[1 + end[0] if len(end) else len(off) :] = True
        found[rows[off]] = True
    return found


def last_row(keep: Flags) -> Flags:
    """Return the last row in use."""
    last = np.zeros(len(keep), dtype=bool)
    last[np.flatnonzero(keep)[-1:]] = True
    return last


def off_trend(travel: Array, force: Array, keep: Flags) -> Flags:
    """Return the last row, if its values leave the trend of those before it.

    For a file that ends without a line end: a number cut in the middle is still a number.
    """
    cut = np.zeros(len(travel), dtype=bool)
    rows = np.flatnonzero(keep)
    if len(rows) < 5:
        return cut
    for column in (travel, force):
        before, last = column[rows[-1 - min(50, len(rows) - 1) : -1]], column[rows[-1]]
        steps = np.abs(np.diff(before))
        if abs(last - before[-1]) > 5.0 * max(float(steps.max()), 1e-9 * abs(before[-1])):
            cut[rows[-1]] = True
    return cut
