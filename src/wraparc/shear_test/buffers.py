"""One run that a machine wrote in pieces, each under a head of its own."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from wraparc.errors import InputError
from wraparc.machine_tables import Array, Cells, NumeralStyle, RawTable
from wraparc.shear_test.reduce import LEAST_POINTS
from wraparc.shear_test.roles import Role, is_known, suitability

# Steps of time or travel that may lie between two pieces, in steps inside them. Ours.
_STEPS = 10.0


def alike(table: RawTable, other: RawTable) -> bool:
    """Whether two tables have the same columns by name and unit."""
    (own, _), (others, _) = table.named(is_known), other.named(is_known)
    return table.rows > 1 and own == others and any(column.name for column in own)


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
    same = [table for table in tables if alike(table, best)]
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
