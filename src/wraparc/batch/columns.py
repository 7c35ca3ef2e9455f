"""Columns as users have them: lists, arrays of any kind, masked ones, pandas and Polars.

A column becomes an array of its own of plain numbers; what is no number stays known by its row, so
that all faults of a table can be told at once.
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from typing import Any, SupportsFloat, cast

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.errors import Problem, format_names, shown
from wraparc.units import DIMENSION_TEXT, Dimension, display

NO_VALUE = "no value"  # masked, None, NA
_MOST_LISTED = 5  # rows that a message names
_MISSING = ("NAType", "NaTType")  # of pandas, which need not be there


@dataclass(frozen=True, eq=False)
class Column:
    """A column that has been read.

    Attributes
    ----------
    value
        Its numbers, nan where there is none; one number for all rows, or one for each.
    strange
        What was given in place of a number, by row; missing values are no fault in themselves.
    """

    value: Array
    strange: Mapping[int, str] = field(default_factory=dict)

    def told(self, row: int, dimension: Dimension | None) -> str:
        """Return what a row holds, with its unit."""
        if row in self.strange:
            return self.strange[row]
        number = float(np.atleast_1d(self.value)[row if self.value.ndim and row else 0])
        if dimension is None or not math.isfinite(number):
            return f"{number:g}"
        return display(number, dimension)


def columns_of(table: Any) -> dict[str, Any]:
    """Return the columns of a mapping or of a frame by their names, as they are."""
    names = table if isinstance(table, Mapping) else getattr(table, "columns", table)
    return {str(name): table[name] for name in names}


def read_column(raw: Any, *, flags: bool = False) -> Column:
    """Return a column as plain numbers of its own; `flags`, where truth values mean 1 and 0."""
    if isinstance(raw, np.ma.MaskedArray):
        read, mask = read_column(np.ma.getdata(raw), flags=flags), np.ma.getmaskarray(raw)
        value = np.where(mask, math.nan, read.value)
        gone = {int(i): NO_VALUE for i in np.flatnonzero(mask)}
        return Column(value, {**read.strange, **gone})
    # of a list numpy would make texts of numbers beside texts, and numbers of truth values
    given = np.asarray(raw, dtype=object if isinstance(raw, list | tuple) else None)
    if given.dtype.kind in "fiu" or (flags and given.dtype.kind == "b"):
        return Column(np.array(given, dtype=float, order="C"))
    found, strange = np.full(given.size, math.nan), {}
    for i, item in enumerate(given.ravel().tolist()):
        number = _number(item, flags)
        if isinstance(number, str):
            strange[i] = number
        else:
            found[i] = number
    return Column(found.reshape(given.shape), strange)


def _number(item: object, flags: bool) -> float | str:
    """Return a number, or how what is none is told."""
    if item is None or type(item).__name__ in _MISSING:
        return NO_VALUE
    truth = isinstance(item, bool | np.bool_)
    if truth and not flags:
        return shown(bool(item))
    if not truth and not isinstance(item, numbers.Real | Decimal):
        return shown(item)
    try:
        return float(cast(SupportsFloat, item))
    except OverflowError:
        return shown(item)


def length_problems(shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, list[Problem]]:
    """Return the number of rows, and a problem for every column of another length."""
    n = max((shape[0] for shape in shapes.values() if len(shape) == 1), default=1)
    problems = [
        Problem(
            key=f"column {shown(name)}",
            value=f"{len(shape)} dimensions" if len(shape) > 1 else f"{shape[0]} rows",
            message=f"must be one number or have {n} rows",
        )
        for name, shape in shapes.items()
        if len(shape) > 1 or (len(shape) == 1 and shape[0] != n)
    ]
    return n, problems


def refused(
    name: str,
    column: Column,
    good: Flags,
    allowed: str,
    *,
    dimension: Dimension | None,
    may_be_missing: bool = False,
) -> list[Problem]:
    """Return the problem of a column, with all its rows: what is no number, and what cannot be.

    Parameters
    ----------
    name, column
        The column.
    good
        Which numbers can be, in the shape of the column.
    allowed
        End of the sentence "must be ...".
    dimension
        What it measures, for the unit.
    may_be_missing
        Whether a row may have no value.
    """
    missing = {i for i, told in column.strange.items() if told == NO_VALUE}
    unit = DIMENSION_TEXT[dimension].si_unit if dimension else ""
    number = f"must be a number [{unit}]" if unit else "must be a number"
    no_number = sorted(column.strange.keys() - (missing if may_be_missing else set()))
    good = np.array(good).ravel()
    good[[i for i in column.strange if i < len(good)]] = True
    wrong = np.flatnonzero(~good).tolist()
    return [
        row_problem(name, rows, column.told(rows[0], dimension), message, column.value.ndim > 0)
        for rows, message in ((no_number, number), (wrong, allowed))
        if rows
    ]


def row_problem(
    name: str, rows: Sequence[int], value: str, allowed: str, by_row: bool = True
) -> Problem:
    """Return the problem of some rows of a column, the first with its value."""
    key, remedy = f"column {shown(name)}", ""
    if by_row:
        key += f", row {rows[0]}"
    if len(rows) > 1:
        remedy = f"Correct rows {format_names(rows, _MOST_LISTED)}."
    return Problem(key=key, value=value, message=allowed, remedy=remedy)
