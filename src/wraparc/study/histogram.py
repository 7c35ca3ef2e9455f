"""How a result is spread over the rows of a study, and which of them keep its limit."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.checks.numbers import kept
from wraparc.checks.of_arc import EXIT_CREEP, GROSS_SLIP, OF_LAGGING
from wraparc.checks.of_drive import BELT_TENSION, MOMENTARY_TENSION
from wraparc.checks.of_rows import kept_rows
from wraparc.checks.rule import Rule

#: Results whose limit is a number of the row, most an upper one on their size, in the column
#: `limit_column`, and the checks that it is of.
LIMITED: dict[str, tuple[Rule, ...]] = {
    "exit_creep": (EXIT_CREEP,),
    "entry_tension": (BELT_TENSION, MOMENTARY_TENSION),
    **{rule.result: (rule,) for rule in reversed(OF_LAGGING)},
    "gross_slip_safety": (GROSS_SLIP,),
}
#: Those of `LIMITED` whose limit is a lower one.
LOWER = frozenset(name for name, rules in LIMITED.items() if not rules[0].at_most)
#: Results whose limit is the same for every row, a lower one.
LEAST = {"creep_limit_margin": 1.0, "tested_slip_margin": 1.0}
_FEWEST, _MOST = 8, 30  # bars
_TAIL = 1.5  # spans from 1 % to 99 % that are drawn beyond them


def limit_column(name: str) -> str:
    """Return the column of the limit of a result."""
    return f"{name}_limit"


@dataclass(frozen=True)
class Limit:
    """What a result is held against.

    Attributes
    ----------
    least, most
        Ends of the limits of the rows, nan where there is none [SI].
    at_most
        Whether it is an upper one, on the size of the result.
    """

    least: float = math.nan
    most: float = math.nan
    at_most: bool = True

    @property
    def one(self) -> bool:
        """Whether all rows have the same one, in the digits that are compared."""
        return kept(self.most, self.least, True)

    def joined(self, least: float, most: float) -> Limit:
        """Return the limit of these rows and of others."""
        return Limit(_fmin(self.least, least), -_fmin(-self.most, -most), self.at_most)


def _fmin(a: float, b: float) -> float:
    return b if math.isnan(a) else a if math.isnan(b) else min(a, b)


def limit_of(name: str, column: Array | None) -> Limit:
    """Return the limit of a result in rows with a column of limits, if it has one."""
    if name in LEAST:
        return Limit(LEAST[name], LEAST[name], at_most=False)
    known = column[~np.isnan(column)] if column is not None else np.empty(0)
    upper = name not in LOWER
    if not len(known):
        return Limit(at_most=upper)
    return Limit(float(known.min()), float(known.max()), at_most=upper)


def misses(name: str, values: Array, column: Array | None) -> Flags:
    """Return which values are beyond the limit; those that are none or have no limit are not."""
    if name in LEAST:
        least = np.full(len(values), LEAST[name])
        return ~np.isnan(values) & ~kept_rows(values, least, at_most=False)
    if column is None:
        return np.zeros(len(values), dtype=bool)
    there = ~np.isnan(values) & ~np.isnan(column)
    return there & ~kept_rows(np.abs(values), column, at_most=name not in LOWER)


@dataclass(frozen=True)
class Histogram:
    """How a result is spread.

    Attributes
    ----------
    edges
        Of the bars, one more than these [SI]; the limit is one of them where it lies between.
        The outer bars hold what lies further out as well.
    counts
        Rows of each bar.
    limit
        What it is held against.
    beyond
        Rows that do not keep the limit: beyond it, slipping on the whole arc, or without an answer.
    away, unanswered
        Rows without a number because the drive slips, or because there is no answer.
    total
        All rows.
    """

    edges: tuple[float, ...]
    counts: tuple[int, ...]
    limit: Limit
    beyond: int
    away: int
    unanswered: int
    total: int


def bars(numbers: Array, known: int, limit: Limit) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """Return edges and counts of bars of equal width; `known` rows stand for the numbers.

    2 n^(1/3) bars by Rice's rule, within limits.
    """
    if not len(numbers):
        return (), ()
    low, high = _ends(numbers)
    if high <= low:
        half = 0.01 * abs(low) or 0.5
        return (low - half, low + half), (known,)
    wanted = min(max(math.ceil(2.0 * len(numbers) ** (1.0 / 3.0)), _FEWEST), _MOST)
    width = (high - low) / wanted
    first, places = low, wanted
    mark = math.copysign(limit.least, high + low) if limit.at_most else limit.least
    if limit.one and low < mark < high:
        before = math.ceil((mark - low) / width)
        first, places = mark - before * width, before + math.ceil((high - mark) / width)
    edges = first + width * np.arange(places + 1)
    found, _ = np.histogram(np.clip(numbers, edges[0], edges[-1]), edges)
    scale = known / len(numbers)
    return tuple(edges.tolist()), tuple(round(n * scale) for n in found.tolist())


def _ends(numbers: Array) -> tuple[float, float]:
    """Ends of what is drawn: all of it but a far tail."""
    low, high = float(numbers.min()), float(numbers.max())
    one, most = np.percentile(numbers, (1.0, 99.0)).tolist()
    reach = _TAIL * (most - one)
    return (max(low, one - reach), min(high, most + reach)) if reach > 0.0 else (low, high)
