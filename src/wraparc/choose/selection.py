"""Choose: every design solved, held to its limits, priced, ranked; and why the others fall out."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.wear import HOUR, WORN_SHARE
from wraparc.batch.arcs import Arcs
from wraparc.choose.across import Edges, excess_of, is_uneven, solve_edges
from wraparc.choose.answers import solve_columns
from wraparc.choose.cost import energy_cost, lagging_cost, purchases
from wraparc.choose.ranking import front, named, next_dearer, ordered
from wraparc.choose.search import Grid, Search
from wraparc.choose.slack_rules import (
    gross_slip_slack,
    others_slack,
    slack_offset,
    standard_slack,
)
from wraparc.drive import LoadCase

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Solver = Callable[..., Mapping[str, Array]]

#: a value may pass its limit by this much, as a least tension meets its limit exactly [-]
TOLERANCE = 1e-6
#: designs up to which all are solved precisely; else those this near a limit, and the first ones
MOST_PRECISE, UNDECIDED, RANKED_PRECISELY = 1000, 3e-3, 100
#: stands for a tension that no belt has [N]
NO_TENSION = 1e12
#: limits in the order they are told
LIMITS = (
    "traction",
    "creep",
    "bond_stress",
    "creep_limit_margin",
    "tested_slip_margin",
    "gross_slip_margin",
    "tested_pressure",
    "gross_slip",
    "design_standard",
    "least_slack",
    "belt_sag",
    "other_pulleys",
    "belt_rating",
    "edge_tension",
    "least_pulley_diameter",
)
#: limits of what the solver answers
OF_THE_ARC = {"creep", "bond_stress", "creep_limit_margin", "tested_slip_margin",
              "gross_slip_margin"}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Held:
    """How every design stands to one limit.

    Attributes
    ----------
    excess
        How far the worst case is beyond the limit, as a share of it: > 0 broken, nan where the
        limit does not apply, shape (n,) [-].
    value, limit
        What it is in the worst case and what is allowed [SI], shape (n,).
    where
        Place of the worst case: load case + condition * number of load cases, shape (n,).
    """

    excess: Array
    value: Array
    limit: Array
    where: Integers

    @property
    def broken(self) -> NDArray[np.bool_]:
        """Whether each design breaks it."""
        return self.excess > TOLERANCE


@dataclass(frozen=True, eq=False)
class Costs:
    """Life-cycle cost of every design by part, shape (n,) [currency]."""

    lagging: Array
    lagging_least: Array
    lagging_most: Array
    belt: Array
    energy: Array

    @property
    def total(self) -> Array:
        """Lagging at the middle of its life, belt, energy."""
        return self.lagging + self.belt + self.energy


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
        Largest tension, and smallest, over the load cases [N].
    unevenness
        Largest over mean entry tension across the width [-]; nan where the pulley is even, or a
        design was not solved across the width: see `unjudged`.
    held
        Limits by name.
    costs
        Costs of every design.
    ranking
        Feasible designs, cheapest first; then by creep, slack tension and order.
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
    def feasible(self) -> NDArray[np.bool_]:
        """Whether each design keeps every limit."""
        return feasible(self.held, len(self))

    @property
    def unjudged(self) -> Integers:
        """Designs of the ranking on an uneven pulley whose edges nobody looked at."""
        if not is_uneven(self.search):
            return self.ranking[:0]
        return self.ranking[np.isnan(self.unevenness[self.ranking])]

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
        grid = grid.with_slack(np.where(np.isnan(least), own_slack(search), least))
    cases = search.drive.load_cases
    ends = [grid.ends(case) for case in cases]
    slack = np.min([least for least, _ in ends], axis=0)
    answers = _answers(search, grid, solve, np.arange(len(grid)), precise=precise)
    refined, edges = np.full(len(grid), precise), Edges.none(len(grid))
    while True:
        held = _held(search, grid, answers, shortage)
        if is_uneven(search):
            held = {**held, "edge_tension": Held(**excess_of(edges), where=edges.where)}
        costs = _costs(search, grid, answers[: len(cases)])
        creep = _worst([np.abs(a["exit_creep"]) for a in answers])
        ranking = ordered(feasible(held, len(grid)), costs.total, creep, slack)
        again = _undecided(held, ranking, refined)
        if not len(again):
            told = named(search, grid, ranking, costs.total, (creep, slack))
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
        creep_front=front(ranking, costs.total, creep),
        slack_front=front(ranking, costs.total, slack),
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


def _undecided(held: Mapping[str, Held], ranking: Integers, refined: NDArray[np.bool_]) -> Integers:
    """Designs so near a limit, or so high in the ranking, that they must be solved precisely."""
    close = np.zeros(len(refined), dtype=bool)
    close[ranking[:RANKED_PRECISELY]] = True
    for name in OF_THE_ARC & held.keys():
        with np.errstate(invalid="ignore"):
            close |= np.abs(held[name].excess) < UNDECIDED
    return np.flatnonzero(close & ~refined)


def least_slack(search: Search, grid: Grid, solve: Solver = solve_columns) -> tuple[Array, Array]:
    """Least slack-side tension with which each design keeps every check in every load case.

    The rule of `wraparc.checks.least_tension`: creep, the safety factor on gross slip, a binding
    design standard, and the lowest tested wrap pressure and the sag of the belt where these are
    limits.

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
    """Slack-side tension that sag and the lowest tested wrap pressure, p B D/2, ask for [N]."""
    sag = search.limits.sag
    least = np.full(len(grid), max(0.0 if sag is None else sag.tension, grid.others))
    if not search.limits.tested_pressure:
        return least
    tested = [lag.law.tested for lag in search.laggings]
    low = np.array([0.0 if t is None else t.pressure_min for t in tested])[grid.places[0]]
    tested_least = 0.5 * low * search.drive.belt.width * grid.diameter
    tested_least += max(slack_offset(search, case) for case in search.drive.load_cases)
    return np.asarray(np.maximum(least, tested_least))


def feasible(held: Mapping[str, Held], n: int) -> NDArray[np.bool_]:
    """Whether each design keeps every limit, shape (n,)."""
    good = np.ones(n, dtype=bool)
    for one in held.values():
        good &= ~one.broken
    return good


def own_slack(search: Search) -> float:
    """Slack-side tension of the drive as it is: the largest over its load cases [N]."""
    return max(search.drive.slack_end(case) for case in search.drive.load_cases)


def _worst(columns: Sequence[Array]) -> Array:
    return np.asarray(np.max(np.stack(columns), axis=0))  # nan (a breakaway) stays nan


def _held(
    search: Search,
    grid: Grid,
    answers: Sequence[Mapping[str, Array]],
    shortage: Array,
) -> dict[str, Held]:
    limits, cases = search.limits, search.drive.load_cases
    n = len(grid)
    parts: dict[str, list[tuple[Array, Array]]] = {name: [] for name in LIMITS}
    for k, answer in enumerate(answers):
        condition, at = divmod(k, len(cases))
        _of_arc(search, parts, answer)
        if limits.tested_pressure:
            _of_pressure(parts["tested_pressure"], grid.arcs(cases[at], condition))
        _of_slack(search, grid, parts, cases[at], condition)
    if limits.rating is not None:
        for case in cases:
            parts["belt_rating"].append(_of_rating(search, grid, case))
    sag = limits.sag.tension if limits.sag is not None else 0.0
    for name, least in (("belt_sag", sag), ("other_pulleys", min(grid.others, NO_TENSION))):
        if least > 0.0:
            parts[name] += [(-grid.ends(case)[0], np.full(n, -least)) for case in cases]
    if limits.least_pulley_diameter:
        asked = _of_belts(search, grid, "least_pulley_diameter")
        # the other way round: what is allowed is the least
        parts["least_pulley_diameter"].append((-grid.diameter, -asked))
    if search.least_slack:
        parts["least_slack"].append((shortage, np.ones(n)))
    return {name: _of_parts(pairs, n) for name, pairs in parts.items() if pairs}


def _of_slack(
    search: Search,
    grid: Grid,
    parts: dict[str, list[tuple[Array, Array]]],
    case: LoadCase,
    condition: int,
) -> None:
    """Add what safety against gross slip and a binding standard ask of the slack side."""
    slack, _ = grid.ends(case)
    for name, rule in (("gross_slip", gross_slip_slack), ("design_standard", standard_slack)):
        least = rule(search, grid, case, condition)
        if least.any():
            parts[name].append((-slack, -np.minimum(least, NO_TENSION)))


def _of_arc(
    search: Search, parts: dict[str, list[tuple[Array, Array]]], answer: Mapping[str, Array]
) -> None:
    """Add what one load case in one condition says of the limits (value, limit); signs as there."""
    limits, n = search.limits, len(answer["solved"])
    solved = answer["solved"] > 0.0
    # a breakaway misses by the ratio it would have to carry over the largest it can
    gross = answer["gross_slip_margin"]
    beyond = np.where(gross > 0.0, 1.0 / np.where(gross > 0.0, gross, 1.0), np.inf)
    beyond = np.where(beyond > 1.0, beyond, 1.0 + 1e-3)
    parts["traction"].append((np.where(solved, 0.0, beyond), np.ones(n)))
    parts["creep"].append((np.abs(answer["exit_creep"]), np.full(n, search.creep_limit)))
    if limits.bond_stress is not None:
        stress = np.abs(answer["peak_shear_stress"])
        parts["bond_stress"].append((stress, np.full(n, limits.bond_stress)))
    for name in ("creep_limit_margin", "tested_slip_margin", "gross_slip_margin"):
        least = getattr(limits, name)
        if least is not None:
            parts[name].append((-answer[name], np.full(n, -least)))


def _of_pressure(parts: list[tuple[Array, Array]], arcs: Arcs) -> None:
    low, high, _ = arcs.laws.tested[arcs.law].T
    area = arcs.belt_width * arcs.diameter
    most = 2.0 * np.maximum(arcs.entry_tension, arcs.exit_tension) / area
    least = 2.0 * np.minimum(arcs.entry_tension, arcs.exit_tension) / area
    above, below = most / high - 1.0, low / least - 1.0
    # one number for both ends: the worse of them
    upper = ~(below > above)
    parts.append((np.where(upper, most, -least), np.where(upper, high, -low)))


def _of_rating(search: Search, grid: Grid, case: LoadCase) -> tuple[Array, Array]:
    share: Array | float | None = (search.limits.rating or {}).get(case.name)
    if share is None:
        momentary = np.nan_to_num(_of_belts(search, grid, "momentary_factor"), nan=1.0)
        share = 1.0 if case.kind == "running" else momentary
    tight = grid.ends(case)[1] / search.drive.belt.width
    return np.asarray(tight), share * _of_belts(search, grid, "rating")


def _of_belts(search: Search, grid: Grid, name: str) -> Array:
    values = [getattr(b, name) for b in search.belts]
    known: Array = np.array([np.nan if v is None else v for v in values], dtype=float)
    return np.asarray(known[grid.places[2]])


def _of_parts(pairs: list[tuple[Array, Array]], n: int) -> Held:
    """Worst of several (value, limit) pairs; negative ones are lower limits."""
    values = np.stack([v for v, _ in pairs])
    bounds = np.stack([b for _, b in pairs])
    with np.errstate(invalid="ignore", divide="ignore"):
        excess = np.where(
            bounds > 0.0, values / bounds - 1.0, 1.0 - np.abs(values) / np.abs(bounds)
        )
    ranked = np.where(np.isnan(excess), -np.inf, excess)
    where = np.argmax(ranked, axis=0)
    at = np.arange(n)
    return Held(
        excess=excess[where, at],
        value=np.abs(values[where, at]),
        limit=np.abs(bounds[where, at]),
        where=where.astype(np.int64),
    )


def _area(search: Search, grid: Grid) -> Array:
    face = search.costing.face_width or search.drive.belt.width
    return np.asarray(math.pi * grid.diameter * face)


def _lives(search: Search, grid: Grid, dry: Sequence[Mapping[str, Array]]) -> Array:
    """Life of every lagging by the energy that wears it [years]; nan where it cannot be told.

    Half the thickness may be worn off; hours are those of the costs, by load case.
    """
    known = [lag.wear_coefficient for lag in search.laggings]
    coefficient = np.array([math.nan if k is None else k for k in known])[grid.places[0]]
    speeds = np.array([math.nan if b.speed is None else b.speed for b in search.belts])
    passes = speeds[grid.places[2]] * HOUR / (math.pi * grid.diameter)
    energy = np.zeros(len(grid))
    for case, answer in zip(search.drive.load_cases, dry, strict=True):
        hours = search.costing.hours.get(case.name, 0.0)
        if hours > 0.0:
            energy = energy + hours * passes * np.abs(answer["frictional_energy"])
    worn = coefficient * energy
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(worn > 0.0, WORN_SHARE * grid.thickness / worn, np.nan)


def _costs(search: Search, grid: Grid, dry: Sequence[Mapping[str, Array]]) -> Costs:
    """Cost of every design; energy by the first condition."""
    c, n = search.costing, len(grid)
    area = _area(search, grid)
    parts = np.zeros((3, n))
    life = _lives(search, grid, dry)
    for place, lagging in enumerate(search.laggings):
        mine = grid.places[0] == place
        cost = c.laggings[lagging.name].cost
        parts[:, mine] = lagging_cost(cost, area[mine], c.years, life[mine])
    belts = np.zeros(len(search.belts))
    for place, belt in enumerate(search.belts):
        if belt.name in c.belts:
            price = c.belts[belt.name]
            belts[place] = price.price * float(purchases(c.years, price.life_years))
    energy = np.zeros(n)
    if c.tariff is not None:
        for case, answer in zip(search.drive.load_cases, dry, strict=True):
            hours = c.hours.get(case.name, 0.0)
            if hours > 0.0:
                energy = energy + energy_cost(answer["power_loss"], hours, c.tariff, c.years)
    return Costs(parts[0], parts[1], parts[2], belts[grid.places[2]], energy)
