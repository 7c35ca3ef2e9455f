"""Tests under each other in one table: rows that a column without change sets apart.

A table of many tests has a column that names the test, or says its pressure, its speed, its
condition: constant over the rows of one, another in the next. Where the travel begins anew with it,
or the rows of several stand in turn, each is a test of its own.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.machine_tables import NamedColumn, plain_name
from wraparc.shear_test.reduce import LEAST_POINTS
from wraparc.shear_test.roles import Role, suitability

# More values than this are readings, no names of tests.
_MOST_TESTS = 200
# Part of the way of a test by which travel goes back where the next one begins. Ours.
_BACK = 0.5
_STEP = re.compile(r"\b(cycle|zyklus|step|segment|schritt|phase|block|hub|stroke)\b")


@dataclass(frozen=True, eq=False)
class Part:
    """Rows of one test: its name as the columns tell it, and its rows, shape (n,)."""

    name: str
    rows: Integers


def divide(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    words: Callable[[int], Sequence[str]],
    travel: NamedColumn | None = None,
) -> list[Part]:
    """Divide the rows of a table into tests; one part of all rows if they are of one test.

    Parameters
    ----------
    named, data
        Columns, and the numbers of each, shape (n,).
    words
        Gives the cells of a column that holds no numbers, as text.
    travel
        The column of the travel, if its name does not tell.
    """
    by_name = max(named, key=lambda c: suitability(c.name, Role.TRAVEL))
    count = len(data[by_name.index])
    whole = [Part("", np.arange(count))]
    if travel is None and suitability(by_name.name, Role.TRAVEL) == 0.0:
        return whole
    travel = travel or by_name
    parts = whole
    for column in named:
        if column.index == travel.index or not column.name or _STEP.search(plain_name(column.name)):
            continue
        parts = [
            finer
            for part in parts
            for finer in _by_column(part, column, data, words, data[travel.index])
        ]
    return parts


def _by_column(
    part: Part,
    column: NamedColumn,
    data: Mapping[int, Array],
    words: Callable[[int], Sequence[str]],
    travel: Array,
) -> list[Part]:
    """Divide a part by a column, or leave it whole."""
    values = data[column.index][part.rows]
    names: Sequence[str]
    if np.isfinite(values).all():
        codes, names = _coded(values)
    elif not np.isfinite(values).any():
        cells = [words(column.index)[row].strip() for row in part.rows]
        if not all(cells):
            return [part]
        found, codes = np.unique(cells, return_inverse=True)
        names = found.tolist()
    else:
        return [part]
    if not 1 < len(names) <= _MOST_TESTS:
        return [part]
    groups = _groups(codes)
    if min(map(len, groups)) < LEAST_POINTS or not _begin_anew(groups, travel[part.rows]):
        return [part]
    label = f"{column.label} "
    return [
        Part(", ".join(filter(None, [part.name, f"{label}{names[codes[rows[0]]]}"])),
             part.rows[rows])
        for rows in groups
    ]  # fmt: skip


def _coded(values: Array) -> tuple[Integers, Sequence[str]]:
    found, codes = np.unique(values, return_inverse=True)
    return codes, [f"{value:.6g}" for value in found[: _MOST_TESTS + 1]]


def _groups(codes: Integers) -> list[Integers]:
    """Rows of each run of one value; of each value, where values stand in turn."""
    bounds = np.flatnonzero(np.diff(codes)) + 1
    runs = np.split(np.arange(len(codes)), bounds)
    if len(runs) <= _MOST_TESTS and min(map(len, runs)) >= LEAST_POINTS:
        return runs
    first = {int(code): k for k, code in reversed(list(enumerate(codes)))}
    return [np.flatnonzero(codes == code) for code in sorted(first, key=lambda c: first[c])]


def _begin_anew(groups: Sequence[Integers], travel: Array) -> bool:
    """Whether the travel of each group but the first begins behind where the one before ended."""
    ways = [travel[rows] for rows in groups]
    return all(
        np.isfinite(way).all()
        and np.isfinite(before).all()
        and abs(before[-1] - way[0]) > _BACK * max(float(np.ptp(way)), float(np.ptp(before)) * 0.2)
        and abs(before[-1] - before[0]) > 0.0
        and (before[-1] - way[0]) * (before[-1] - before[0]) > 0.0
        for before, way in pairwise(ways)
    )
