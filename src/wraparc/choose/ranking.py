"""The order of the designs of a search, and those that an answer names."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from wraparc.choose.across import MOST
from wraparc.choose.search import Grid, Search
from wraparc.drive import Lagging

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
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
    if not len(ranking):
        return None
    rate = np.array([_rate(search, lag) for lag in search.laggings])
    lagging = grid.places[0][ranking]
    dearer = rate[lagging] > rate[lagging[0]] * (1.0 + 1e-9)
    if not dearer.any():
        return None
    following = np.argmin(np.where(dearer, rate[lagging], np.inf))
    return int(ranking[np.argmax(lagging == lagging[following])])


def named(
    search: Search, grid: Grid, ranking: Integers, cost: Array, others: tuple[Array, Array]
) -> Integers:
    """Designs that an answer may name as good: the first ones, the fronts, the next dearer."""
    fronts = [front(ranking, cost, other) for other in others]
    dearer = next_dearer(search, grid, ranking)
    more = np.array([] if dearer is None else [dearer], dtype=np.int64)
    return np.unique(np.concatenate([ranking[:MOST], *fronts, more]))


def ordered(good: NDArray[np.bool_], cost: Array, creep: Array, slack: Array) -> Integers:
    """Return the good designs, cheapest first; then by creep, slack tension and order.

    Costs and creeps that differ by less than `SAME` of the largest are alike: designs that were
    all given the least slack tension creep as much as is allowed, but for rounding.
    """
    designs = np.flatnonzero(good)
    order = np.lexsort((designs, slack[designs], _alike(creep[designs]), _alike(cost[designs])))
    return designs[order].astype(np.int64)


def _alike(values: Array) -> Array:
    """Return values rounded to `SAME` of the largest."""
    unit = SAME * np.max(np.abs(values), initial=0.0)
    return np.round(values / unit) if unit > 0.0 else values


def _rate(search: Search, lagging: Lagging) -> float:
    """Price of lagging a square metre once [currency/m2]."""
    cost = search.costing.laggings[lagging.name].cost
    return (cost.material + cost.installation) / cost.area
