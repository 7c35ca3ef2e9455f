"""Levels of draws: all inputs changed at once."""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan

import numpy as np

from wraparc.arc import Distributed
from wraparc.arrays import Array, Integers
from wraparc.checks.check import Level
from wraparc.checks.judge import judge
from wraparc.checks.of_arc import CREEP_INTERVAL, GROSS_SLIP
from wraparc.checks.of_rows import RowCheck, used_of_rows
from wraparc.checks.variant_rows import DESCRIBED, JudgedRows, VariantArcs, VariantRows
from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.reserve.inputs import PULL, SLACK, Input, change_drive, lift_of
from wraparc.reserve.levels import IMPOSSIBLE, UNKNOWN, LevelRows, constant_rank
from wraparc.reserve.predict import Uses, can_fit, predict_ranks
from wraparc.train.whole import Whole, by_pulley, solved

#: Draws that are solved, whatever they come to.
SOLVED = 768


class DrawLevels(LevelRows):
    """Finds levels of a drive with all inputs changed in each row."""

    def of_draws(self, draws: Array, solve_first: int = SOLVED) -> Integers:
        """Return the ranks of the level with factors on all inputs at once, shape (n, inputs).

        What needs no solution is checked in every draw. The first draws are solved, then those
        others that may be near a limit: of the rest the solved ones tell, see `predict_ranks`.
        What rows do not solve is solved by the solver of one arc; `IMPOSSIBLE` where there is no
        such drive.
        """
        margins, ranks = self._described_draws(draws)
        arcs = self._drawn(draws, margins).arcs()
        rank = self._ranks(arcs.check_described(), ranks)
        first = solve_first if can_fit(solve_first, draws.shape[1]) else len(draws)
        done = np.arange(min(first, len(draws)))
        rank[done], uses = self._solved_draws(draws, done, arcs, ranks)
        others = np.arange(len(done), len(draws))
        if not len(others):
            return rank
        bounds = predict_ranks(draws[done], uses, draws[others])
        low, high = (np.maximum(rank[others], bound) for bound in bounds)
        there = rank[others] > IMPOSSIBLE
        sure = ((low == high) | (rank[others] == Level.FAILS.rank)) & (rank[done] > 0).all()
        rank[others] = np.where(there, low, IMPOSSIBLE)
        near = others[~sure & there]
        if len(near):
            rank[near] = self._solved_draws(draws, near, arcs, ranks)[0]
        return rank

    def level_of_all(self, factors: Array) -> int:
        """Return the rank of the level with factors on all inputs, by the solver of one arc."""
        try:
            result = solved(self._all_changed(factors), Distributed(capacities=False))
        except InputError:
            return IMPOSSIBLE
        # friction is drawn from its interval: the end of it is no limit of a draw
        checks = (c for c in judge(result).checks if c.name != CREEP_INTERVAL.name)
        return max([c.level.rank for c in checks] + [self._constant, Level.OK.rank])

    def _solved_draws(
        self, draws: Array, which: Integers, arcs: VariantArcs, ranks: Integers
    ) -> tuple[Integers, list[Uses]]:
        """Return the ranks of draws that are solved, and what they use of the limits."""
        judged = arcs.variants(which).judge()
        rank = self._ranks(judged, ranks[which])
        for row in np.flatnonzero(rank == UNKNOWN).tolist():
            rank[row] = self.level_of_all(draws[which[row]])
        checks = (check for check in judged.checks if check.rule not in DESCRIBED)
        return rank, [use for check in checks for use in _uses(check, judged)]

    def _ranks(self, judged: JudgedRows, ranks: Integers) -> Integers:
        """Return the ranks of what is judged, with those of what else is missed."""
        worst = np.zeros(len(ranks), dtype=np.int64)
        for check in judged.checks:
            worst = np.maximum(worst, judged.by_place(check.rank).max(axis=0).astype(np.int64))
        total = np.maximum(np.maximum(worst, self._constant), np.maximum(ranks, Level.OK.rank))
        total = np.where(worst >= Level.FAULT.rank, UNKNOWN, total)
        return np.where(judged.possible & (ranks > IMPOSSIBLE), total, IMPOSSIBLE)

    def _drawn(self, draws: Array, margins: Array) -> VariantRows:
        """Return the rows of draws."""
        n, pulleys = len(draws), [p.name for p in self.drive.pulleys]
        lift, pull, columns = np.zeros(n), np.ones(n), dict[str, Array]()
        for of, factors in zip(self.inputs, draws.T, strict=True):
            if of.name == SLACK:
                lift = (factors - 1.0) * lift_of(self.drive, 2.0)
            elif of.name == PULL:
                pull = factors
            else:
                column = columns.setdefault(of.name, np.ones((len(pulleys), n)))
                for name in of.pulleys or pulleys:
                    column[pulleys.index(name)] *= factors
        zeros, drives = np.zeros(n, dtype=np.int64), (self.drive,)
        return VariantRows(
            drives=drives, which=zeros, lift=lift, pull=pull, factors=columns, odd=margins
        )

    def _all_changed(self, factors: Array) -> Drive:
        """Return the drive with factors on all inputs, the tensions shifted before they grow."""
        of, later = self.drive, lambda place: self.inputs[place].name != SLACK
        for place in sorted(range(len(factors)), key=later):
            of = change_drive(of, self.inputs[place], float(factors[place]))
        return of

    def _described_draws(self, draws: Array) -> tuple[Array, Integers]:
        """Return least margins of implausible sizes, and ranks of what tensions alone miss.

        Both go one way with an input: where nothing is missed at the ends of each alone, nor at
        those of all, nothing is between.
        """
        ends, alone = np.stack([draws.min(axis=0), draws.max(axis=0)]), np.eye(draws.shape[1]) > 0.0
        corners = [*ends, *(np.where(only, end, 1.0) for end in ends for only in alone)]
        found = [self._described_all(corner) for corner in corners]
        margin, rank = self._now
        if all(least >= 0.0 and worst <= Level.OK.rank for least, worst in (*found, self._now)):
            return np.full(len(draws), margin), np.full(len(draws), rank)
        rows = [self._described_all(row) for row in draws]
        return np.array([row[0] for row in rows]), np.array([row[1] for row in rows])

    def _described_all(self, factors: Array) -> tuple[float, int]:
        try:
            return self._described(self._all_changed(factors))
        except InputError:
            return self._now[0], IMPOSSIBLE


def draw_levels(result: Whole, inputs: tuple[Input, ...]) -> DrawLevels:
    """Return the levels of a solved drive or train, its inputs drawn."""
    constant, meets = constant_rank(result)
    return DrawLevels(by_pulley(result).drive, inputs, constant, meets=meets)


def _uses(check: RowCheck, judged: JudgedRows) -> Iterator[Uses]:
    """Yield what a check uses of its limit at every place."""
    rule = check.rule
    fails = rule.missed is Level.FAILS or rule.firm is not None or rule is GROSS_SLIP
    most = Level.FAILS if fails or not isnan(rule.fails_beyond) else Level.ATTENTION
    used = np.where(
        np.isfinite(check.margin), used_of_rows(check.margin, at_most=rule.at_most), np.nan
    )
    ranks = judged.by_place(check.rank).astype(np.int64)
    for of_place, rank in zip(judged.by_place(used), ranks, strict=True):
        yield Uses(of_place, rank, most.rank)
