"""Choose: every design solved, judged, priced, ranked; and why the others fall out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import Setting
from wraparc.checks import Level, judge
from wraparc.checks.of_arc import DESIGN_STANDARD, GROSS_SLIP
from wraparc.checks.verdict import Verdict
from wraparc.choose.across import Edges, is_uneven, solve_edges
from wraparc.choose.judged import Standing, judge_rows, least_slack, places_of
from wraparc.choose.life_cycle import Costs, costs_of
from wraparc.choose.ranking import front, named, next_dearer, ordered, recommended
from wraparc.choose.search import Grid, Search
from wraparc.choose.what_if import redivided
from wraparc.drive import Drive
from wraparc.train import Train
from wraparc.train.whole import Described, Whole, solved

#: Designs of the ranking that are judged at most, where the first one misses a check.
MOST_JUDGED = 12

#: designs up to which all are solved precisely; else those this near a limit, and the first ones
MOST_PRECISE, UNDECIDED, RANKED_PRECISELY = 1000, 3e-3, 100


@dataclass(frozen=True, eq=False)
class Selection:
    """The answer of a search.

    Attributes
    ----------
    search
        What was searched.
    grid
        The designs, with the slack-side tensions they were solved at.
    creep, bond_stress
        Worst of every design [m] and [Pa]; nan where it breaks away.
    tight_tension, slack_tension
        Largest tension, and smallest at the take-up, over the load cases [N].
    unevenness
        Largest over mean entry tension across the width [-]; nan where the pulley is even, or a
        design was not solved across the width: see `unjudged`.
    standings
        How the designs stand to each check, by its name.
    costs
        Costs of every design.
    ranking
        Feasible designs as they are recommended (`ranking.recommended`), cheapest first; then by
        creep, slack tension and order.
    creep_front, slack_front
        Designs of `ranking` that nobody beats in cost and creep, in cost and slack tension.
    """

    search: Search
    grid: Grid
    creep: Array
    bond_stress: Array
    tight_tension: Array
    slack_tension: Array
    unevenness: Array
    standings: Mapping[str, Standing]
    costs: Costs
    ranking: Integers
    creep_front: Integers
    slack_front: Integers

    def __len__(self) -> int:
        return len(self.grid)

    @property
    def feasible(self) -> Flags:
        """Whether each design passes every check that it must."""
        return _feasible(self.standings, len(self))

    @property
    def unjudged(self) -> Integers:
        """Designs of the ranking on an uneven pulley whose edges nobody looked at."""
        if not is_uneven(self.search):
            return self.ranking[:0]
        return self.ranking[np.isnan(self.unevenness[self.ranking])]

    @cached_property
    def verdict(self) -> Verdict:
        """What the recommended design comes to, see `judged`."""
        return self.judged(int(self.ranking[0]))

    @cached_property
    def sounder(self) -> int | None:
        """First design of the ranking with a better verdict than the recommended one, if any."""
        if self.verdict.level.rank <= Level.OK.rank:
            return None
        others = map(int, self.ranking[1:MOST_JUDGED])
        level = self.verdict.level
        return next((i for i in others if self.judged(i).level.rank < level.rank), None)

    def judged(self, design: int) -> Verdict:
        """Return what a design comes to in all conditions, judged as `solve` does its drive."""
        verdicts = [judge(result) for result in self.results(design)]
        if len(verdicts) == 1:
            return verdicts[0]
        return Verdict(tuple(check for verdict in verdicts for check in verdict.checks))

    def results(self, design: int) -> list[Whole]:
        """Return a design as `solve` solves its drive, in every condition."""
        return [solved(self._described(design, k)) for k in range(len(self.search.conditions))]

    def _described(self, design: int, condition: int) -> Described:
        """Return a design as a file would describe it: of a train, a train."""
        drive, train = self.grid.drive(design, condition), self.search.train
        return drive if train is None else _as_train(train, drive)

    def broken(self, design: int) -> tuple[str, ...]:
        """Names of the checks that a design misses and must not."""
        return tuple(name for name, standing in self.standings.items() if standing.broken[design])

    def place(self, where: int) -> tuple[str, str, str]:
        """Pulley, load case and condition of a place in `Standing.where`."""
        at = places_of(self.search)[int(where)]
        return at.pulley.name, at.case.name, self.search.conditions[at.condition].name

    def nearest(self) -> int:
        """The infeasible design whose worst excess is least; of no use where one is feasible."""
        excess = [np.where(s.broken, s.excess, -np.inf) for s in self.standings.values()]
        return int(np.argmin(np.max(excess, axis=0)))

    def next_dearer(self) -> int | None:
        """Cheapest feasible design with a lagging dearer than that of the cheapest design.

        Dearer to buy for the same area, not over its life: None if no feasible design has one.
        """
        return next_dearer(self.search, self.grid, self.ranking)


def _as_train(train: Train, design: Drive) -> Train:
    """Return a design of a train: the load divides anew between the ends of its tensions."""
    first, last = design.pulleys[0].name, design.pulleys[-1].name
    cases = []
    for case in train.cases:
        at = design.load_case(case.name).tensions
        entry, leaving = at[first].entry, at[last].exit
        cases.append(replace(case, condition="", entry_tension=entry, exit_tension=leaving))
    changed = replace(train, cases=tuple(cases), criteria=design.criteria)
    return redivided(changed, design)


def choose(search: Search) -> Selection:
    """Judge every design of a search and rank those that pass every check they must.

    Parameters
    ----------
    search
        What is searched.

    Returns
    -------
    Selection
        The ranking, the fronts, and how every design stands to every check.
    """
    grid = Grid.of(search)
    # a least tension meets its limit exactly, and few designs cost little
    precise = search.least_slack or len(grid) <= MOST_PRECISE
    if search.least_slack:
        least = least_slack(search, grid)
        grid = grid.with_slack(np.where(np.isfinite(least), least, own_slack(search)))
    ends = [grid.ends(case) for case in search.drive.load_cases]
    slack = np.min([least for least, _ in ends], axis=0)
    every = np.arange(len(grid))
    judged = judge_rows(search, grid, every, Setting.PRECISE if precise else Setting.ENGINEERING)
    refined, edges = np.full(len(grid), precise), Edges.none(len(grid))
    while True:
        standings = dict(judged.standings)
        if is_uneven(search):
            standings |= edges.standings()
        costs = costs_of(search, grid, judged.of_costs)
        good = _feasible(standings, len(grid))
        by_cost = ordered(good, costs.total, judged.creep, slack)
        ranking = recommended(by_cost, grid, standings[DESIGN_STANDARD.name].missed)
        again = _undecided(standings, ranking, refined)
        if len(again):
            judged = judged.with_rows(again, judge_rows(search, grid, again, Setting.PRECISE))
            refined[again] = True
            continue
        fronts = [front(by_cost, costs.total, other) for other in (judged.creep, slack)]
        told = named(search, grid, ranking, fronts)
        told = told[np.isnan(edges.unevenness[told])]
        if not is_uneven(search) or not len(told):
            break
        edges = solve_edges(search, grid, told, edges)
    return Selection(
        search=search,
        grid=grid,
        creep=judged.creep,
        bond_stress=judged.bond_stress,
        tight_tension=np.max([most for _, most in ends], axis=0),
        slack_tension=slack,
        unevenness=edges.unevenness,
        standings=standings,
        costs=costs,
        ranking=ranking,
        creep_front=fronts[0],
        slack_front=fronts[1],
    )


def _feasible(standings: Mapping[str, Standing], n: int) -> Flags:
    """Return whether each design passes every check that it must, shape (n,)."""
    good = np.ones(n, dtype=bool)
    for standing in standings.values():
        good &= ~standing.broken
    return good


def _undecided(standings: Mapping[str, Standing], ranking: Integers, refined: Flags) -> Integers:
    """Designs so near a limit, or so high in the ranking, that they must be solved precisely."""
    close = np.zeros(len(refined), dtype=bool)
    close[ranking[:RANKED_PRECISELY]] = True
    for standing in standings.values():
        if standing.rule.result or standing.rule is GROSS_SLIP:
            close |= np.abs(standing.excess) < UNDECIDED
    return np.flatnonzero(close & ~refined)


def own_slack(search: Search) -> float:
    """Tension at the take-up of the drive as it is: the largest over its load cases [N]."""
    return max(search.drive.take_up_tension(case) for case in search.drive.load_cases)
