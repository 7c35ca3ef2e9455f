"""Every design of a search by the rules of `wraparc.checks`, in its worst place."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.arcs import Arcs
from wraparc.checks import Level
from wraparc.checks.check import margin_to
from wraparc.checks.least_rows import figures_of_rows
from wraparc.checks.least_tension import TAUT, taut
from wraparc.checks.numbers import NUMBERLESS
from wraparc.checks.of_drive import tension_factor, tension_rule
from wraparc.checks.of_rows import OF_ROWS, Held, RowCheck, held_by, row_checks
from wraparc.checks.rule import Rule
from wraparc.checks.rules import OF_PULLEY
from wraparc.choose.search import RATING, Grid, Search
from wraparc.drive import Lagging, LoadCase, Pulley

#: Margins to capacities that a search may limit beside the checks.
MARGINS = (
    Rule(
        "creep_limit_margin", "the margin to the creep limit", at_most=False,
        result="creep_limit_margin",
    ),
    Rule(
        "tested_slip_margin", "the margin to the edge of tested slip", at_most=False,
        result="tested_slip_margin",
    ),
)  # fmt: skip
#: Of the pulley that is searched, in the first condition, what the costs are made of.
_OF_COSTS = ("power_loss", "frictional_energy")


class DesignPlace(NamedTuple):
    """Where designs are judged: a pulley in a load case and a condition."""

    pulley: Pulley
    case: LoadCase
    condition: int


@dataclass(frozen=True, eq=False)
class Standing:
    """How every design stands to one check, in its worst place, columns of shape (n,).

    Attributes
    ----------
    rule
        The check.
    rank, margin, value, limit
        As of `wraparc.checks.of_rows.RowCheck`.
    counts
        Whether a design must pass the check.
    where
        Place of the worst, in `places_of`.
    """

    rule: Rule
    rank: Array
    margin: Array
    value: Array
    limit: Array
    counts: Flags
    where: Integers

    @classmethod
    def none(cls, rule: Rule, n: int) -> Standing:
        """Return that nothing is compared yet."""
        nan, no = np.full(n, math.nan), np.zeros(n, dtype=bool)
        return cls(rule, np.zeros(n), np.full(n, math.inf), nan, nan, no, np.zeros(n, np.int64))

    @property
    def missed(self) -> Flags:
        """Whether each design misses it."""
        return np.asarray(self.rank > Level.OK.rank)

    @property
    def broken(self) -> Flags:
        """Whether each design misses it and must not."""
        return self.missed & self.counts

    @property
    def excess(self) -> Array:
        """How far each is beyond the limit over the limit [-]; infinite where no number says so."""
        with np.errstate(invalid="ignore", divide="ignore"):
            excess = -margin_to(self.value, self.limit, at_most=self.rule.at_most)
        numberless = self.missed & (np.isnan(excess) | (self.margin == NUMBERLESS))
        return np.where(numberless, math.inf, excess)

    def with_worse(self, of: RowCheck, counts: Flags, where: int) -> Standing:
        """Return the worse of this and of the same check at another place."""
        worse = of.is_worse(self.rank, self.margin)
        return replace(
            self,
            rank=np.where(worse, of.rank, self.rank),
            margin=np.where(worse, of.margin, self.margin),
            value=np.where(worse, of.value, self.value),
            limit=np.where(worse, of.limit, self.limit),
            counts=np.where(worse, counts, self.counts),
            where=np.where(worse, where, self.where),
        )

    def with_rows(self, which: Integers, of: Standing) -> Standing:
        """Return the same with some rows judged anew."""
        columns = {}
        for name in ("rank", "margin", "value", "limit", "counts", "where"):
            columns[name] = getattr(self, name).copy()
            columns[name][which] = getattr(of, name)
        return replace(self, **columns)


@dataclass(frozen=True, eq=False)
class Judged:
    """Designs of a search by every check.

    Attributes
    ----------
    standings
        By name of the check.
    creep, bond_stress
        Worst of the pulley [m] and [Pa], shape (n,); nan in gross slip.
    of_costs
        ``power_loss`` and ``frictional_energy`` of the pulley in the first condition by load case.
    """

    standings: Mapping[str, Standing]
    creep: Array
    bond_stress: Array
    of_costs: tuple[Mapping[str, Array], ...]

    def with_rows(self, which: Integers, of: Judged) -> Judged:
        """Return the same with some designs judged anew."""
        creep, stress = self.creep.copy(), self.bond_stress.copy()
        creep[which], stress[which] = of.creep, of.bond_stress
        every = []
        for old, new in zip(self.of_costs, of.of_costs, strict=True):
            columns = {name: old[name].copy() for name in _OF_COSTS}
            for name, column in columns.items():
                column[which] = new[name]
            every.append(columns)
        standings = {
            name: standing.with_rows(which, of.standings[name])
            for name, standing in self.standings.items()
        }
        return Judged(standings, creep, stress, tuple(every))


def places_of(search: Search) -> list[DesignPlace]:
    """Return every place that designs are judged at."""
    return [
        DesignPlace(pulley, case, condition)
        for condition in range(len(search.conditions))
        for case in search.drive.load_cases
        for pulley in search.drive.pulleys
    ]


def rules_of(search: Search) -> list[Rule]:
    """Return the checks that a design must pass, or that speak of a standard."""
    left_out, limits = search.limits.left_out, search.limits
    binding = (rule for rule in OF_ROWS if rule.binding or rule.firm is not None)
    margins = (rule for rule in MARGINS if getattr(limits, rule.name) is not None)
    return [*(rule for rule in binding if rule.name not in left_out), *margins]


def judge_rows(search: Search, grid: Grid, which: Integers, setting: Setting) -> Judged:
    """Judge some designs of a search by every check, in every place."""
    rules, n = rules_of(search), len(which)
    standings = {rule.name: Standing.none(rule, n) for rule in rules}
    creep, stress, of_costs = np.zeros(n), np.zeros(n), list[Mapping[str, Array]]()
    one = np.ones(n)
    for where, spot in enumerate(places_of(search)):
        own = spot.pulley.name == search.pulley
        some, inverse = (which, np.arange(n)) if own else _different(grid, which)
        arcs, held, _ = rows_at(search, grid, spot, some)
        capacities = own and search.limits.needs_capacities
        solved = solve_arcs(arcs, setting=setting, capacities=capacities)
        if own:
            creep = np.maximum(creep, np.abs(solved["exit_creep"]))  # nan stays nan
            stress = np.maximum(stress, np.abs(solved["peak_shear_stress"]))
            if spot.condition == 0:
                of_costs.append({name: np.array(solved[name]) for name in _OF_COSTS})
        factors = one[: len(some)], one[: len(some)]
        here = rules if own else [rule for rule in rules if rule not in MARGINS]
        for check in row_checks(solved, held, factors, setting, here):
            name = check.rule.name
            every = RowCheck(
                check.rule,
                *(getattr(check, c)[inverse] for c in ("rank", "margin", "value", "limit")),
            )
            counts = held.firm.get(name, np.full(len(some), check.rule.binding))[inverse]
            standings[name] = standings[name].with_worse(every, counts, where)
    return Judged(standings, creep, stress, tuple(of_costs))


def _different(grid: Grid, which: Integers) -> tuple[Integers, Integers]:
    """Return designs that differ in belt or tension: all that another pulley sees of them."""
    key = np.stack([grid.places[2][which].astype(float), np.nan_to_num(grid.slack[which])])
    _, first, inverse = np.unique(key, axis=1, return_index=True, return_inverse=True)
    return which[first], np.ravel(inverse)


def rows_at(
    search: Search, grid: Grid, spot: DesignPlace, which: Integers
) -> tuple[Arcs, Held, tuple[Lagging, ...]]:
    """Return arcs of some designs at a place, what they are held against, and their laggings."""
    own = spot.pulley.name == search.pulley
    if own:
        arcs, laggings = grid.arcs(spot.case, spot.condition), search.conditioned()
    else:
        arcs, laggings = grid.arcs_beside(spot.pulley, spot.case), (spot.pulley.lagging,)
    drives, of = grid.described(spot.condition)
    entry, leaving = (tension[:, which] for tension in grid.tensions(spot.case))
    arcs = arcs.rows(which)
    held = held_by(drives, of[which], spot.pulley.name, spot.case.name, arcs, (entry, leaving))
    return arcs, _limited(search, grid, spot, which, held), laggings


def _limited(search: Search, grid: Grid, spot: DesignPlace, which: Integers, held: Held) -> Held:
    """Return what rows are held against with the numbers that the search has instead."""
    limits, n, own = search.limits, len(which), spot.pulley.name == search.pulley
    allowed = dict(_shares(search, grid, spot.case, which, held))
    if own:
        allowed |= {
            name: np.full(n, value)
            for name in ("bond_stress", *(rule.name for rule in MARGINS))
            if (value := getattr(limits, name)) is not None
        }
    if own and limits.gross_slip_safety is not None:
        held = replace(held, safety=np.full(n, limits.gross_slip_safety))
    return held.allowing(allowed)


def _shares(
    search: Search, grid: Grid, case: LoadCase, which: Integers, held: Held
) -> Iterator[tuple[str, Array]]:
    """Yield what a share of the rating allows in a load case, by name of the check."""
    share = (search.limits.rating or {}).get(case.name)
    if share is None:
        return
    belts = grid.places[2][which]
    ratings = np.array([b.rating or math.nan for b in search.belts])[belts]
    factors = np.array([tension_factor(b, case.kind) for b in search.belts])[belts]
    yield tension_rule(case.kind).name, share * ratings
    safety = RATING[-1]
    yield safety, np.maximum(held.allowed[safety] * factors / share, 1.0)


def least_slack(search: Search, grid: Grid) -> Array:
    """Return the least tension at the take-up of every design [N]; infinite where there is none.

    As `wraparc.checks.least_tension`, for all pulleys, load cases and conditions.
    """
    own, n = grid.with_slack(np.full(len(grid), np.nan)), len(grid)
    every, rules = np.arange(n), rules_for_least(search)
    asks: dict[str, Array] = {"taut": np.full(n, _taut(search))}
    binding, top = {"taut": np.ones(n, dtype=bool)}, np.full(n, math.inf)
    for spot in places_of(search):
        beside = spot.pulley.name != search.pulley
        some, inverse = _different(own, every) if beside else (every, every)
        arcs, held, laggings = rows_at(search, own, spot, some)
        end = search.drive.take_up_tension(spot.case)
        for figure in figures_of_rows(arcs, held, laggings, rules):
            tension, name = (end + figure.rise)[inverse], figure.rule.name
            if not figure.at_least:
                top = np.fmin(top, tension)
                continue
            asks[name] = np.fmax(asks.get(name, np.full(n, math.nan)), tension)
            binding[name] = binding.get(name, np.zeros(n, dtype=bool)) | figure.binding[inverse]
    least = np.full(n, -math.inf)
    for name, tension in asks.items():
        counts = binding[name] | ((tension <= top) & np.isfinite(tension))
        least = np.fmax(least, np.where(counts, tension, math.nan))
    return least


def rules_for_least(search: Search) -> list[Rule]:
    """Return the checks that the least tension of a search is to pass."""
    return [rule for rule in OF_PULLEY if rule.name not in search.limits.left_out]


def _taut(search: Search) -> float:
    """Return the tension at the take-up with which the belt nowhere hangs slack [N]."""
    drive = search.drive
    least = [
        drive.take_up_tension(case) - min(min(t.entry, t.exit) for t in case.tensions.values())
        for case in drive.load_cases
    ]
    ends = -math.inf if drive.conveyor is None else taut(drive.conveyor).tension
    return max(max(least) + TAUT, ends)
