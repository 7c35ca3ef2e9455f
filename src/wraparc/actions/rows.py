"""Variants of a drive judged together, as rows: many at once, all pulleys and load cases."""

from __future__ import annotations

from dataclasses import replace
from math import inf, radians

import numpy as np

from wraparc.actions.document import Source
from wraparc.actions.variant import IMPOSSIBLE, Outcome, Variant
from wraparc.arrays import Array
from wraparc.batch import Setting
from wraparc.checks.check import Level
from wraparc.checks.variant_rows import KNOWN, VariantRows
from wraparc.drive import Drive
from wraparc.errors import InputError

#: What is told is confirmed by the solver of one arc.
_SETTING = Setting.ENGINEERING


class RowEvaluator:
    """Judges variants of a drive whose pulleys are even.

    Every pulley keeps its share of the load. What rows do not check is taken as it is in the drive
    as it is.
    """

    def __init__(self, source: Source, drive: Drive, now: Outcome) -> None:
        self._source, self._drive, self._now = source, drive, now
        self._drives: dict[Variant, Drive | None] = {Variant(): drive}

    def __call__(self, variants: list[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        drives = [self._drive_of(variant) for variant in variants]
        which = [i for i, drive in enumerate(drives) if drive is not None]
        found = [IMPOSSIBLE] * len(variants)
        if which:
            of = [drive for drive in drives if drive is not None]
            some = _Judged(of, [variants[i] for i in which], self._source.take_up)
            for i, outcome in zip(which, some.outcomes(self._now), strict=True):
                found[i] = outcome
        return found

    def _drive_of(self, variant: Variant) -> Drive | None:
        """Return the drive that a variant is without its tensions and wrap; None if there is none.

        Those are columns.
        """
        base = variant._replace(tension=0.0, wrap=0.0, pull=0.0)
        if base not in self._drives:
            try:
                self._drives[base] = self._read(base)
            except InputError:
                self._drives[base] = None
        return self._drives[base]

    def _read(self, variant: Variant) -> Drive:
        """Return the drive of a variant; of a train at the tensions that its load divides into."""
        read = self._source.read(self._source.changes(variant))
        if isinstance(read, Drive):
            return read
        belt, pulleys, criteria = read.belt, read.pulleys, read.criteria
        return replace(self._drive, belt=belt, pulleys=pulleys, criteria=criteria)


class _Judged:
    """Variants of drives, judged as rows."""

    def __init__(self, drives: list[Drive], variants: list[Variant], tension: float) -> None:
        distinct = list({id(drive): drive for drive in drives}.values())
        places = {id(drive): place for place, drive in enumerate(distinct)}
        which = np.array([places[id(drive)] for drive in drives])
        wraps = [radians(v.wrap) / distinct[i].pulleys[0].wrap_angle if v.wrap else 1.0
                 for v, i in zip(variants, which, strict=True)]  # fmt: skip
        self.rows = VariantRows(
            drives=distinct,
            which=which,
            lift=np.array([v.tension - tension if v.tension else 0.0 for v in variants]),
            pull=np.array([v.pull or 1.0 for v in variants]),
            factors={"wrap_angle": np.array(wraps)},
        )

    def outcomes(self, now: Outcome) -> list[Outcome]:
        """Return the outcomes; `now` is that of the drive as it is."""
        n = len(self.rows.which)
        try:
            judged = self.rows.judge(_SETTING)
        except InputError:
            return [IMPOSSIBLE] * n
        levels: list[dict[str, int]] = [{} for _ in range(n)]
        used: list[dict[str, float]] = [{} for _ in range(n)]
        passed: list[list[str]] = [[] for _ in range(n)]
        for check in judged.checks:
            name, ranks = check.rule.name, check.rank
            missed = _shares(check.margin, check.rule.at_most)
            shares = np.where(ranks > Level.OK.rank, missed, 0.0)
            most = judged.by_place(shares).max(axis=0)
            for i, rank in enumerate(judged.by_place(ranks).max(axis=0).tolist()):
                if rank > Level.OK.rank:
                    levels[i][name], used[i][name] = rank, float(most[i])
                elif rank == Level.OK.rank:
                    passed[i].append(name)
        solved = judged.solved
        creeps = judged.by_place(np.where(solved.solved, np.abs(solved["exit_creep"]), 0.0))
        others = {name: rank for name, rank in now.levels.items() if name not in KNOWN}
        passes = [name for name in now.passed if name not in KNOWN]
        return [
            Outcome(
                possible=bool(judged.possible[i]),
                levels=levels[i] | others,
                passed=(*passed[i], *passes),
                used=used[i],
                creep=float(creeps[:, i].max()),
            )
            for i in range(n)
        ]


def _shares(margins: Array, at_most: bool) -> Array:
    """Return values over their maxima, or minima over values, by their margins [-]."""
    if at_most:
        return 1.0 - margins
    with np.errstate(divide="ignore"):
        return np.where(margins > -1.0, 1.0 / np.maximum(1.0 + margins, 0.0), inf)
