"""Which rows of a file are one test: side by side, in pieces, without marks and results."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.errors import InputError
from wraparc.machine_tables import (
    Cells,
    NamedColumn,
    NumeralStyle,
    RawTable,
    find_column,
    plain_name,
)
from wraparc.shear_test.noise import noise_level
from wraparc.shear_test.record import Choices
from wraparc.shear_test.reduce import LEAST_POINTS
from wraparc.shear_test.roles import Role, is_known, suitability

# Steps of time or travel that may lie between two pieces, in steps inside them. Ours.
_STEPS = 10.0
# Readings on either side of a seam, and standard deviations of their median. Ours.
_SIDE, _SEAM_NOISE = 5, 4.0
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

    They have the same columns, or a travel and a force by name, and rows enough for a pull.
    """
    others = [table for table in tables if table not in read and table.rows >= LEAST_POINTS]
    return sum(alike(table, read[0]) or names_a_pull(table) for table in others)


def names_a_pull(table: RawTable) -> bool:
    """Whether a table has a travel and a force by name."""
    columns, _ = table.named(is_known)
    return all(
        any(suitability(c.name, role) > 0 for c in columns) for role in (Role.TRAVEL, Role.FORCE)
    )


def one_run(
    tables: Sequence[RawTable], best: RawTable, choices: Choices | None = None
) -> list[RawTable]:
    """Return the tables of a file that make one run with the best of them, in their order.

    Heads and units agree, and time runs on from each to the next, or travel and force do.

    Parameters
    ----------
    tables, best
        Of the file.
    choices
        Which columns are travel and force, where their names do not tell.
    """
    # without a head the best is like those that have one, and not like itself
    same = [table for table in tables if table is best or alike(table, best)]
    if len(same) < 2:
        return [best]
    style = _style(same)
    first = last = same.index(best)
    said = choices or Choices()
    while first > 0 and _runs_on(same[first - 1], same[first], style, said):
        first -= 1
    while last + 1 < len(same) and _runs_on(same[last], same[last + 1], style, said):
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


def _runs_on(before: RawTable, after: RawTable, style: NumeralStyle, choices: Choices) -> bool:
    if before.sheet != after.sheet:
        return False
    ends = {}
    for role in (Role.TIME, Role.TRAVEL, Role.FORCE):
        column = _column_of(before, role, choices)
        if column is not None:
            ends[role] = tuple(table.numbers(column.index, style) for table in (before, after))
    if Role.TIME in ends and _goes_on(*ends[Role.TIME]):
        return True
    if Role.TRAVEL not in ends or not _goes_on(*ends[Role.TRAVEL]):
        return False
    return Role.FORCE not in ends or _stays(*ends[Role.FORCE])


def _column_of(table: RawTable, role: Role, choices: Choices) -> NamedColumn | None:
    """The column that is said to be of a role, or is by its name."""
    named, _ = table.named(is_known)
    said = getattr(choices, role.value)
    if said is not None:
        return find_column(named, said)
    best = max(named, key=lambda c: suitability(c.name, role))
    return best if suitability(best.name, role) > 0.0 else None


def _goes_on(before: Array, after: Array) -> bool:
    """Whether a column goes on behind a seam: medians of some readings on either side of it.

    A single reading of a noisy travel says nothing; the medians lie as many steps apart as readings
    are between them, but for their noise and a pause.
    """
    count = min(_SIDE, len(before) // 2, len(after) // 2)
    own, later = before[np.isfinite(before)], after[np.isfinite(after)]
    if count < 1 or len(own) < 3 or len(later) < 2:
        return False
    usual = _usual_step(own) or float(np.median(np.diff(own)))
    if usual == 0.0:
        return False
    apart = float(np.median(later[:count]) - np.median(own[-count:])) / usual - count
    # of a median of normal readings 1.25 s/sqrt(n), of the difference of two 1.77
    noise = 1.77 * _SEAM_NOISE * noise_level(own) / abs(usual) / count**0.5
    # the next piece goes the same way; of a few readings that is not asked
    same_way = len(later) < 3 * _SIDE or _usual_step(later) / usual > 0.0
    return -max(noise, 0.99) < apart <= _STEPS + noise and same_way


def _usual_step(values: Array) -> float:
    """Mean step between the first and the last third, which noise hardly moves."""
    third = max(len(values) // 3, 1)
    return float(np.median(values[-third:]) - np.median(values[:third])) / max(
        len(values) - third, 1
    )


def _stays(before: Array, after: Array) -> bool:
    """Whether a force is behind a seam what it was before: no other test, no release."""
    count = min(_SIDE, len(before), len(after))
    own, later = before[np.isfinite(before)], after[np.isfinite(after)]
    if not len(own) or not len(later):
        return False
    apart = abs(float(np.median(later[:count]) - np.median(own[-count:])))
    # what it may change over the readings looked at, at the rate of either side
    rates = [abs(_usual_step(part[-3 * _SIDE :])) for part in (own, later[: 3 * _SIDE])]
    noise = max(noise_level(own), noise_level(later))
    largest = float(np.abs(np.concatenate([own, later])).max())
    return apart < max(0.1 * largest, 3.0 * _SIDE * max(rates), 6.0 * noise)


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
