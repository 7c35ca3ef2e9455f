"""What the results of a study say: probabilities with their intervals, percentiles, convergence.

Read from the file of results a part at a time: memory does not grow with the study.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.checks import Level
from wraparc.study.histogram import Histogram, Limit, bars, limit_column, limit_of, misses
from wraparc.study.parameter_study import (
    BREAKAWAY,
    DESIGN,
    GOVERNING,
    JUDGED,
    SOLVED,
    STATUS,
    STATUS_WORDS,
    VERDICT,
    WITHIN,
)
from wraparc.study.parquet import batches, read_data
from wraparc.study.share import Share

#: Percentiles that are told [%].
PERCENTS = (5.0, 50.0, 95.0, 99.0)
#: Numbers that are kept in all to find percentiles; where there are more, every second, fourth ...
KEPT = 2_000_000
LEAST_KEPT = 2_000
#: Results of which none at all is more than any number: no creep holds the belt, no tension is
#: enough.
WITHOUT_BOUND = ("exit_creep", "exit_slip", "least_exit_tension")
#: Most groups that are told apart.
MOST_GROUPS = 400
_CHECKS = len(JUDGED[GOVERNING])
_PAIRS = len(JUDGED[VERDICT]) * _CHECKS


@dataclass(frozen=True)
class Step:
    """The estimate when so many draws were done: of breakaway, and of creep over its limit."""

    draws: int
    breakaway: Share
    over_limit: Share


@dataclass(frozen=True)
class Judged:
    """How many rows have which verdict, and what governs them.

    Attributes
    ----------
    counts
        Rows by verdict and governing check.
    """

    counts: Mapping[tuple[str, str], int] = field(default_factory=dict)

    @property
    def verdicts(self) -> dict[str, int]:
        """Rows by verdict."""
        found: dict[str, int] = {}
        for (verdict, _), count in self.counts.items():
            found[verdict] = found.get(verdict, 0) + count
        return found

    @property
    def total(self) -> int:
        """Rows with a verdict."""
        return sum(self.counts.values())

    def share(self, level: Level) -> Share:
        """Return the part of the rows that ends so."""
        return Share(self.verdicts.get(str(level), 0), self.total)

    @property
    def missed(self) -> dict[str, int]:
        """Rows that are not OK by the check that governs them, the most first."""
        found: dict[str, int] = {}
        for (verdict, name), count in self.counts.items():
            if verdict != str(Level.OK):
                found[name] = found.get(name, 0) + count
        return dict(sorted(found.items(), key=lambda item: -item[1]))


@dataclass(frozen=True, eq=False, kw_only=True)
class Group:
    """The draws at one combination of levels, load case and condition.

    Attributes
    ----------
    levels
        Value of each axis of levels [SI], or its word.
    load_case, condition
        The case; empty for all together.
    share
        Part of the time of the condition, or None.
    counts
        Rows by their status.
    over_limit
        Rows that do not keep the creep limit, of all: those that creep beyond it, break away or
        have no answer.
    judged
        Rows by verdict and by the check that governs them, of those that have one.
    percentiles
        By result: values at `PERCENTS` of the rows with an answer; of those that have the number,
        but for results of `WITHOUT_BOUND`, which are infinite where there is none [SI].
    known
        By result: rows that have one.
    steps
        How the estimates settle, as draws are added in their order.
    histograms
        By result: how it is spread, and which rows keep its limit.
    """

    levels: Mapping[str, float | str]
    load_case: str
    condition: str
    share: float | None
    counts: Mapping[str, int]
    over_limit: Share
    judged: Judged
    percentiles: Mapping[str, tuple[float, ...]]
    known: Mapping[str, int]
    steps: tuple[Step, ...]
    histograms: Mapping[str, Histogram]

    @property
    def rows(self) -> int:
        """All rows, with and without an answer."""
        return sum(self.counts.values())

    @property
    def breakaway(self) -> Share:
        """Probability of breakaway."""
        return Share(self.counts["breakaway"], self.rows)


@dataclass(frozen=True, eq=False)
class Summary:
    """What results say.

    Attributes
    ----------
    data
        What the file says of the study.
    counts
        Rows by their status.
    judged
        Rows by verdict and by the check that governs them.
    over_limit, creep_limit
        Rows that do not keep the creep limit, and that limit.
    groups
        One for each combination of levels, load case and condition; none where there are more
        than `MOST_GROUPS`.
    """

    data: Mapping[str, Any]
    counts: Mapping[str, int]
    judged: Judged
    over_limit: Share
    creep_limit: Limit
    groups: tuple[Group, ...]

    @property
    def drawn(self) -> bool:
        """Whether anything was drawn at random."""
        return bool(self.data["sampling"])


def over_conditions(summary: Summary) -> tuple[tuple[Group, float, float], ...]:
    """Probabilities over all conditions by their share of the time, where that is known.

    Returns
    -------
    For each combination of levels and load case: a group of it, P(breakaway), P(over the limit).
    """
    sums: dict[tuple[Any, ...], list[Any]] = {}
    for group in summary.groups:
        if group.share is None:
            return ()
        key = (*group.levels.values(), group.load_case)
        entry = sums.setdefault(key, [group, 0.0, 0.0])
        entry[1] += group.share * group.breakaway.value
        entry[2] += group.share * group.over_limit.value
    return tuple((group, p, q) for group, p, q in sums.values())


@dataclass(eq=False)
class _Collected:
    """What is gathered of one group while the results go by."""

    outputs: tuple[str, ...]
    most: int = KEPT
    counts: Array = field(default_factory=lambda: np.zeros(len(STATUS_WORDS)))
    over: int = 0
    judged: Array = field(default_factory=lambda: np.zeros(_PAIRS))
    kept: dict[str, list[Array]] = field(default_factory=dict)
    known: dict[str, int] = field(default_factory=dict)
    seen: dict[str, int] = field(default_factory=dict)
    thinned: dict[str, int] = field(default_factory=dict)
    marks: list[tuple[int, int, int]] = field(default_factory=list)  # draws, breakaways, over
    beyond: dict[str, int] = field(default_factory=dict)
    limits: dict[str, Limit] = field(default_factory=dict)

    def take(
        self, status: Integers, within: Flags, judged: Integers, values: Mapping[str, Array]
    ) -> None:
        """Add rows in the order of their draws, their results and the limits of these."""
        self.judged += np.bincount(judged, minlength=_PAIRS)
        solved, away, over = (status == SOLVED), (status == BREAKAWAY), ~within
        self._mark(away, over)
        self.counts += np.bincount(status, minlength=len(STATUS_WORDS))
        self.over += int(over.sum())
        for name in self.outputs:
            self._keep(name, values[name][solved | away])
            limit = values.get(limit_column(name))
            missed = ~solved | misses(name, values[name], limit)
            self.beyond[name] = self.beyond.get(name, 0) + int(missed.sum())
            found = limit_of(name, limit)
            held = self.limits.setdefault(name, found)
            self.limits[name] = held.joined(found.least, found.most)

    def _mark(self, away: Flags, over: Flags) -> None:
        """Note the estimates at every power of 2 of draws."""
        before = int(self.counts.sum())
        power = 16 if before < 16 else 1 << before.bit_length()
        while len(away) and power <= before + len(away):
            at = power - before
            marked = int(self.counts[BREAKAWAY] + away[:at].sum())
            self.marks.append((power, marked, self.over + int(over[:at].sum())))
            power *= 2

    def _keep(self, name: str, value: Array) -> None:
        """Keep numbers for percentiles: all of them, or every second, fourth ... by their place."""
        known = np.isfinite(value)
        self.known[name] = self.known.get(name, 0) + int(known.sum())
        finite = np.where(known, value, np.inf) if name in WITHOUT_BOUND else value[known]
        before = self.seen.get(name, 0)
        self.seen[name] = before + len(finite)
        step = self.thinned.setdefault(name, 1)
        kept = self.kept.setdefault(name, [])
        kept.append(finite[(-before) % step :: step].copy())  # not the rest with it
        if sum(map(len, kept)) > self.most:
            whole = np.concatenate(kept)[::2].copy()
            self.kept[name], self.thinned[name] = [whole], 2 * step

    def group(self, **of: Any) -> Group:
        """Return the group."""
        counts = {word: int(n) for word, n in zip(STATUS_WORDS, self.counts, strict=True)}
        total = sum(counts.values())
        percentiles, histograms = {}, {}
        for name in self.outputs:
            numbers = np.concatenate(self.kept.get(name) or [np.empty(0)])
            found = _percentiles(numbers)
            percentiles[name] = tuple(float(v) for v in found)
            histograms[name] = self._histogram(name, numbers, counts)
        last = (total, counts["breakaway"], self.over)
        marks = [*self.marks, *([last] if total and last not in self.marks else [])]
        return Group(
            counts=counts,
            over_limit=Share(self.over, total),
            judged=_judged(self.judged),
            percentiles=percentiles,
            known={name: self.known.get(name, 0) for name in self.outputs},
            steps=tuple(Step(n, Share(b, n), Share(o, n)) for n, b, o in marks),
            histograms=histograms,
            **of,
        )

    def _histogram(self, name: str, numbers: Array, counts: Mapping[str, int]) -> Histogram:
        limit, total = self.limits.get(name, Limit()), sum(counts.values())
        known, answered = self.known.get(name, 0), counts["solved"] + counts["breakaway"]
        edges, found = bars(numbers[np.isfinite(numbers)], known, limit)
        return Histogram(
            edges=edges,
            counts=found,
            limit=limit,
            beyond=self.beyond.get(name, 0),
            away=min(counts["breakaway"], answered - known),
            unanswered=total - answered,
            total=total,
        )


def _percentiles(numbers: Array) -> Array:
    if not len(numbers):
        return np.full(len(PERCENTS), np.nan)
    found: Array = np.percentile(numbers, PERCENTS, method="inverted_cdf")
    return found


def summarise(path: str | os.PathLike[str]) -> Summary:
    """Return what a file of results says.

    Raises
    ------
    InputError
        If it is no file of results of a study.
    """
    data = read_data(path)
    outputs = tuple(data["outputs"])
    cases = _cases(data)
    combinations = math.prod(len(v) for v in data["levels"].values())
    counts = np.zeros(len(STATUS_WORDS))
    many = combinations * len(cases) > MOST_GROUPS
    most = max(LEAST_KEPT, KEPT // max(1, combinations * len(cases) * len(outputs)))
    collected: dict[tuple[int, int], _Collected] = {}
    per_combination = data["designs"] // max(1, combinations)
    limited = {limit_column(name) for name in data.get("limited", ())}
    columns = [DESIGN, STATUS, WITHIN, *JUDGED, *limited, *([] if many else outputs)]
    judged, over, creep_limit = np.zeros(_PAIRS), 0, Limit()
    for batch in batches(path, columns):
        status = batch[STATUS][0]
        counts += np.bincount(status, minlength=len(STATUS_WORDS))
        pairs = batch[VERDICT][0] * _CHECKS + batch[GOVERNING][0]
        judged += np.bincount(pairs, minlength=_PAIRS)
        over += int((~batch[WITHIN]).sum())
        found = limit_of("exit_creep", batch.get(limit_column("exit_creep")))
        creep_limit = creep_limit.joined(found.least, found.most)
        if many:
            continue
        combination = batch[DESIGN] // per_combination
        case = np.arange(len(status)) % len(cases)
        for key in sorted(set(zip(combination.tolist(), case.tolist(), strict=True))):
            rows = (combination == key[0]) & (case == key[1])
            group = collected.setdefault(key, _Collected(outputs, most))
            values = {name: batch[name][rows] for name in (*outputs, *limited)}
            group.take(status[rows], batch[WITHIN][rows], pairs[rows], values)
    return Summary(
        data=data,
        counts={w: int(n) for w, n in zip(STATUS_WORDS, counts, strict=True)},
        judged=_judged(judged),
        over_limit=Share(over, int(counts.sum())),
        creep_limit=creep_limit,
        groups=tuple(_groups(data, cases, collected)),
    )


def _judged(pairs: Array) -> Judged:
    """Return counts by the codes of verdict and check as counts by their words."""
    found = {}
    for code in np.flatnonzero(pairs):
        verdict, check = divmod(int(code), _CHECKS)
        if verdict:
            found[JUDGED[VERDICT][verdict], JUDGED[GOVERNING][check]] = int(pairs[code])
    return Judged(found)


def _cases(data: Mapping[str, Any]) -> list[tuple[str, str, float | None]]:
    conditions = list(data["conditions"].items()) or [("", None)]
    return [(load, name, share) for load in data["load_cases"] for name, share in conditions]


def _groups(
    data: Mapping[str, Any],
    cases: list[tuple[str, str, float | None]],
    collected: Mapping[tuple[int, int], _Collected],
) -> Iterator[Group]:
    levels: dict[str, list[Any]] = data["levels"]
    shape = tuple(len(values) for values in levels.values())
    for (combination, case), found in sorted(collected.items()):
        places = np.unravel_index(combination, shape) if shape else ()
        at = {name: v[int(p)] for (name, v), p in zip(levels.items(), places, strict=True)}
        load, condition, share = cases[case]
        yield found.group(levels=at, load_case=load, condition=condition, share=share)
