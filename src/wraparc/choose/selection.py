"""Choose: every design solved, held to its limits, priced, ranked; and why the others fall out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.checks import Level, judge
from wraparc.checks.least_tension import taut
from wraparc.checks.of_wet import WET_CREEP
from wraparc.checks.verdict import Verdict
from wraparc.choose.across import Edges, excess_of, is_uneven, solve_edges
from wraparc.choose.answers import solve_columns
from wraparc.choose.life_cycle import Costs, costs_of
from wraparc.choose.limits import OF_THE_ARC, Held, feasible, held_to
from wraparc.choose.ranking import front, named, next_dearer, ordered, recommended
from wraparc.choose.search import Grid, Search
from wraparc.choose.slack_rules import (
    below_standard,
    gross_slip_slack,
    others_slack,
    sag_slack,
    slack_offset,
    standard_slack,
)
from wraparc.drive.criteria import is_wet
from wraparc.train.whole import solved

#: Designs of the ranking that are judged at most, where the first one misses a check.
MOST_JUDGED = 12

Solver = Callable[..., Mapping[str, Array]]

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
    held
        Limits by name.
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
    held: Mapping[str, Held]
    costs: Costs
    ranking: Integers
    creep_front: Integers
    slack_front: Integers

    def __len__(self) -> int:
        return len(self.grid)

    @property
    def feasible(self) -> Flags:
        """Whether each design keeps every limit."""
        return feasible(self.held, len(self))

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
        """Return what a design comes to in all conditions, judged as every drive is.

        The pulleys beside it are judged too. Left out is its design standard, which the answer
        tells of itself.
        """
        search = self.search
        wholes = (self.grid.whole(design, k) for k in range(len(search.conditions)))
        verdicts = (judge(solved(whole)) for whole in wholes)
        checks = (check for verdict in verdicts for check in verdict.checks)
        told, own = "design_standard", search.pulley
        solved_wet = any(is_wet(condition.name) for condition in search.conditions)
        return Verdict(
            tuple(
                c
                for c in checks
                if (c.name != told or c.place.pulley != own)
                and not (solved_wet and c.name == WET_CREEP.name)
            )
        )

    def broken(self, design: int) -> tuple[str, ...]:
        """Names of the limits that a design breaks."""
        return tuple(name for name, held in self.held.items() if held.broken[design])

    def place(self, where: int) -> tuple[str, str]:
        """Load case and condition of a place in `Held.where`."""
        cases = self.search.drive.load_cases
        condition, case = divmod(int(where), len(cases))
        return cases[case].name, self.search.conditions[condition].name

    def nearest(self) -> int:
        """The infeasible design whose worst excess is least; of no use where one is feasible."""
        worst = np.nanmax([held.excess for held in self.held.values()], axis=0)
        return int(np.argmin(worst))

    def next_dearer(self) -> int | None:
        """Cheapest feasible design with a lagging dearer than that of the cheapest design.

        Dearer to buy for the same area, not over its life: None if no feasible design has one.
        """
        return next_dearer(self.search, self.grid, self.ranking)


def choose(search: Search, *, solve: Solver = solve_columns) -> Selection:
    """Solve every design of a search and rank those that keep every limit.

    Parameters
    ----------
    search
        What is searched.
    solve
        What solves columns of arcs.

    Returns
    -------
    Selection
        The ranking, the fronts, and how every design stands to every limit.
    """
    grid = replace(Grid.of(search), others=others_slack(search))
    shortage = np.zeros(len(grid))
    # a least tension meets its limit exactly, and few designs cost little
    precise = search.least_slack or len(grid) <= MOST_PRECISE
    if search.least_slack:
        least, shortage = least_slack(search, grid, solve)
        grid = grid.with_slack(np.where(np.isfinite(least), least, own_slack(search)))
    cases = search.drive.load_cases
    ends = [grid.ends(case) for case in cases]
    slack = np.min([least for least, _ in ends], axis=0)
    below = below_standard(search, grid, slack)
    answers = _answers(search, grid, solve, np.arange(len(grid)), precise=precise)
    refined, edges = np.full(len(grid), precise), Edges.none(len(grid))
    while True:
        held = held_to(search, grid, answers, shortage)
        if is_uneven(search):
            held = {**held, "edge_tension": Held(**excess_of(edges), where=edges.where)}
        costs = costs_of(search, grid, answers[: len(cases)])
        creep = _worst([np.abs(a["exit_creep"]) for a in answers])
        by_cost = ordered(feasible(held, len(grid)), costs.total, creep, slack)
        ranking = recommended(by_cost, grid, below)
        again = _undecided(held, ranking, refined)
        if not len(again):
            fronts = [front(by_cost, costs.total, other) for other in (creep, slack)]
            told = named(search, grid, ranking, fronts)
            told = told[np.isnan(edges.unevenness[told])]
            if not is_uneven(search) or not len(told):
                break
            edges = solve_edges(search, grid, told, edges)
            continue
        for old, new in zip(
            answers, _answers(search, grid, solve, again, precise=True), strict=True
        ):
            for name, column in old.items():
                column[again] = new[name]
        refined[again] = True
    tight = np.max([most for _, most in ends], axis=0)
    return Selection(
        search=search,
        grid=grid,
        creep=creep,
        bond_stress=_worst([np.abs(a["peak_shear_stress"]) for a in answers]),
        tight_tension=tight,
        slack_tension=slack,
        unevenness=edges.unevenness,
        held=held,
        costs=costs,
        ranking=ranking,
        creep_front=fronts[0],
        slack_front=fronts[1],
    )


def _answers(
    search: Search, grid: Grid, solve: Solver, which: Integers, *, precise: bool
) -> list[dict[str, Array]]:
    """What the solver says of some designs, load case by load case, condition by condition."""
    wanted = search.limits.needs_capacities
    return [
        dict(solve(grid.arcs(case, condition).rows(which), capacities=wanted, precise=precise))
        for condition in range(len(search.conditions))
        for case in search.drive.load_cases
    ]


def _undecided(held: Mapping[str, Held], ranking: Integers, refined: Flags) -> Integers:
    """Designs so near a limit, or so high in the ranking, that they must be solved precisely."""
    close = np.zeros(len(refined), dtype=bool)
    close[ranking[:RANKED_PRECISELY]] = True
    for name in OF_THE_ARC & held.keys():
        with np.errstate(invalid="ignore"):
            close |= np.abs(held[name].excess) < UNDECIDED
    return np.flatnonzero(close & ~refined)


def least_slack(search: Search, grid: Grid, solve: Solver = solve_columns) -> tuple[Array, Array]:
    """Least tension at the take-up with which each design keeps every check in every load case.

    The rule of `wraparc.checks.least_tension`: creep, the safety factor on gross slip, the design
    standard even where it does not bind, as what is recommended is never below it, and the lowest
    tested wrap pressure and the sag of the belt where these are limits.

    Returns
    -------
    least
        The largest, over load cases and conditions, of the least tension of each; nan where one
        has none with its tight-side wrap pressure in the tested range [N].
    shortage
        Where there is none: the pull over the largest that could be carried so [-], else 0.
    """
    own = grid.with_slack(np.full(len(grid), np.nan))
    found, shortage = _slack_floor(search, grid), np.zeros(len(grid))
    for condition in range(len(search.conditions)):
        for case in search.drive.load_cases:
            pull = abs(case.tensions[search.pulley].effective)
            if pull == 0.0:
                continue
            answer = solve(own.arcs(case, condition), capacities=True, precise=True)
            for asked in (gross_slip_slack, standard_slack):
                found = np.maximum(found, asked(search, grid, case, condition))
            least = answer["least_exit_tension"] + slack_offset(search, case)
            found = np.maximum(found, least)  # nan stays nan
            missing = np.isnan(answer["least_exit_tension"])
            most = answer["largest_effective_tension"]
            short = np.where(most > 0.0, pull / np.where(most > 0.0, most, 1.0), np.inf)
            shortage = np.maximum(shortage, np.where(missing, short, 0.0))
    return found, shortage


def _slack_floor(search: Search, grid: Grid) -> Array:
    """Tension at the take-up that sag and the lowest tested wrap pressure, p B D/2, ask for [N]."""
    cases, conveyor = search.drive.load_cases, search.drive.conveyor
    ends = 0.0 if conveyor is None else taut(conveyor).tension
    asked = max(sag_slack(search, case) for case in cases)
    least = np.full(len(grid), max(asked, ends, grid.others))
    if not search.limits.tested_pressure:
        return least
    tested = [lag.law.tested for lag in search.laggings]
    low = np.array([0.0 if t is None else t.pressure_min for t in tested])[grid.places[0]]
    tested_least = 0.5 * low * search.drive.belt.width * grid.diameter
    tested_least += max(slack_offset(search, case) for case in cases)
    return np.asarray(np.maximum(least, tested_least))


def own_slack(search: Search) -> float:
    """Tension at the take-up of the drive as it is: the largest over its load cases [N]."""
    return max(search.drive.take_up_tension(case) for case in search.drive.load_cases)


def _worst(columns: Sequence[Array]) -> Array:
    return np.asarray(np.max(np.stack(columns), axis=0))  # nan (a breakaway) stays nan
