"""Rows that are marks of the machine or remains of a broken transfer, not readings."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from wraparc.machine_tables import Array

Mask = NDArray[np.bool_]
_MARKS = (9999.0, 99999.0, 999999.0, 9999999.0, 32767.0, 32768.0, 1e30)
_ENDS = 3
# Rows of results that may stand under a table. Ours.
_MOST_RESULTS = 10
# Usual steps that a jump back is larger than. Ours.
_JUMP = 3.0


def sentinel_rows(travel: Array, force: Array, keep: Mask) -> Mask:
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


def _marks(column: Array, rows: NDArray[np.int64]) -> Mask:
    """Values written for "nothing measured", far outside all others of the column."""
    found = np.zeros(len(column), dtype=bool)
    size = np.abs(column[rows])
    suspect = np.isin(size, _MARKS) | (size >= 1e30)
    if 0 < np.count_nonzero(suspect) < len(rows) / 2:
        largest = float(size[~suspect].max())
        found[rows[suspect]] = size[suspect] > 5.0 * largest
    return found


def results_at_ends(columns: Iterable[Array], keep: Mask) -> Mask:
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


def last_row(keep: Mask) -> Mask:
    """Return the last row in use."""
    last = np.zeros(len(keep), dtype=bool)
    last[np.flatnonzero(keep)[-1:]] = True
    return last


def off_trend(travel: Array, force: Array, keep: Mask) -> Mask:
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
