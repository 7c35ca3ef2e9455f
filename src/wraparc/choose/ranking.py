"""The order of the designs of a search, and those that an answer names."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.choose.across import MOST
from wraparc.choose.search import Grid, Search
from wraparc.drive import Lagging

#: Relative difference of costs or creeps that tells no design from another.
SAME = 1e-5


def front(ranking: Integers, cost: Array, other: Array) -> Integers:
    """Return the designs of a ranking by cost that no cheaper (or equal) one beats in `other`."""
    if not len(ranking):
        return ranking
    values = other[ranking]
    best_before = np.concatenate([[np.inf], np.minimum.accumulate(values)[:-1]])
    return ranking[values < best_before * (1.0 - SAME)]


def next_dearer(search: Search, grid: Grid, ranking: Integers) -> int | None:
    """Cheapest design of a ranking with a lagging dearer to buy than that of its first."""
    if not len(ranking) or search.unpriced:
        return None
    rate = np.array([_rate(search, lag) for lag in search.laggings])
    lagging = grid.places[0][ranking]
    dearer = rate[lagging] > rate[lagging[0]] * (1.0 + 1e-9)
    if not dearer.any():
        return None
    following = np.argmin(np.where(dearer, rate[lagging], np.inf))
    return int(ranking[np.argmax(lagging == lagging[following])])


def named(search: Search, grid: Grid, ranking: Integers, fronts: Sequence[Integers]) -> Integers:
    """Designs that an answer may name as good: the first ones, the fronts, the next dearer."""
    dearer = next_dearer(search, grid, ranking)
    more = np.array([] if dearer is None else [dearer], dtype=np.int64)
    return np.unique(np.concatenate([ranking[:MOST], *fronts, more]))


def ordered(good: Flags, cost: Array, creep: Array, slack: Array) -> Integers:
    """Return the good designs, cheapest first; then by creep, slack tension and order.

    Costs and creeps that differ by less than `SAME` of the largest are alike: designs that were
    all given the least slack tension creep as much as is allowed, but for rounding.
    """
    designs = np.flatnonzero(good)
    order = np.lexsort((designs, slack[designs], _alike(creep[designs]), _alike(cost[designs])))
    return designs[order].astype(np.int64)


def recommended(by_cost: Integers, grid: Grid, below: Flags) -> Integers:
    """Return designs in the order in which they are recommended, from their order by cost.

    Those that keep the design standard come first. More wrap and more tension save energy lost to
    creep, and what they cost themselves (a snub pulley, the take-up, the belt) is not known: of
    designs that differ in nothing else the one with least wrap and then least tension stands for
    all, at its own cost.

    Parameters
    ----------
    by_cost
        The feasible designs, cheapest first.
    grid
        The designs.
    below
        Which of all stand below the design standard.
    """
    if not len(by_cost):
        return by_cost
    _, group = np.unique(grid.places[:4, by_cost], axis=1, return_inverse=True)
    late, at_cost = below[by_cost], np.arange(len(by_cost))
    order = np.lexsort((at_cost, grid.slack[by_cost], grid.wrap_angle[by_cost], late))
    _, first = np.unique(np.ravel(group)[order], return_index=True)
    others = np.ones(len(by_cost), dtype=bool)
    others[order[first]] = False
    return by_cost[np.lexsort((at_cost, others, late))]


def _alike(values: Array) -> Array:
    """Return values rounded to `SAME` of the largest."""
    unit = SAME * np.max(np.abs(values), initial=0.0)
    return np.round(values / unit) if unit > 0.0 else values


def _rate(search: Search, lagging: Lagging) -> float:
    """Price of lagging a square metre once [currency/m2]."""
    cost = search.costing.laggings[lagging.name].cost
    return (cost.material + cost.installation) / cost.area
