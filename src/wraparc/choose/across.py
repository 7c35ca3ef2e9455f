"""The belt across its width in a search: what the designs make of an uneven pulley."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from wraparc.across import AcrossResult, AcrossSolver, wide_arc
from wraparc.arrays import Array, Integers
from wraparc.checks.of_across import EDGE_FACTOR
from wraparc.checks.of_drive import tension_factor
from wraparc.choose.search import Grid, Search
from wraparc.drive import Belt, LoadCase

#: Most designs that are solved across the width: the first ones of the ranking.
MOST = 100


@dataclass(frozen=True, eq=False, kw_only=True)
class Edges:
    """The tightest place of designs on an uneven pulley, in the worst case, shape (n,) each.

    Attributes
    ----------
    unevenness
        Largest over mean entry tension [-]; nan where a design was not solved across the width.
    tension, limit
        Tension where the belt is tightest and what an edge may carry [N/m]; infinite where a strip
        goes slack or the belt is not carried; the limit nan without a rating.
    where
        Place of the worst case, as in `wraparc.choose.limits.Held`.
    """

    unevenness: Array
    tension: Array
    limit: Array
    where: Integers

    @classmethod
    def none(cls, size: int) -> Edges:
        """Return that nothing was solved yet."""
        nan = np.full((3, size), np.nan)
        return cls(
            unevenness=nan[0], tension=nan[1], limit=nan[2], where=np.zeros(size, dtype=np.int64)
        )


def is_uneven(search: Search) -> bool:
    """Whether the pulley of a search says what is uneven across its width."""
    return search.base.across is not None


def solve_edges(search: Search, grid: Grid, which: Integers, known: Edges) -> Edges:
    """Return the edges of further designs, in every load case and condition, with those known."""
    found = replace(
        known,
        **{
            name: getattr(known, name).copy()
            for name in ("unevenness", "tension", "limit", "where")
        },
    )
    cases = search.drive.load_cases
    for i in map(int, which):
        worst = -np.inf
        drives = [grid.drive(i, condition) for condition in range(len(search.conditions))]
        for condition, k in product(range(len(search.conditions)), range(len(cases))):
            drive, case = drives[condition], drives[condition].load_cases[k]
            result = AcrossSolver().solve(wide_arc(drive, drive.pulleys[0], case))
            limit = _limit(drive.belt, case)
            tight = _tightest(result)
            excess = tight if np.isnan(limit) else tight / limit
            found.unevenness[i] = np.fmax(found.unevenness[i], _uneven(result))
            if excess > worst:
                worst = excess
                found.tension[i], found.limit[i] = tight, limit
                found.where[i] = k + condition * len(cases)
    return found


def _tightest(result: AcrossResult) -> float:
    """Largest tension at an edge or of a strip, running and at standstill [N/m]."""
    if not result.status.solved:
        return np.inf
    return max(result.largest_running_tension, result.largest_static_tension)


def _uneven(result: AcrossResult) -> float:
    return result.entry_unevenness if result.status.solved else np.inf


def _limit(belt: Belt, case: LoadCase) -> float:
    if belt.rating is None:
        return np.nan
    return EDGE_FACTOR * tension_factor(belt, case.kind) * belt.rating


def excess_of(edges: Edges) -> Mapping[str, Array]:
    """Return how far the tightest place is beyond its limit, as `Held` wants it."""
    with np.errstate(invalid="ignore"):
        excess = edges.tension / edges.limit - 1.0
    slack = np.isinf(edges.tension)
    excess = np.where(slack, np.inf, excess)
    return {"excess": excess, "value": edges.tension, "limit": edges.limit}
