"""The belt across its width in a search: what the designs make of an uneven pulley."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from wraparc.across import AcrossResult, AcrossSolver, wide_arc
from wraparc.arrays import Array, Integers
from wraparc.checks import Level
from wraparc.checks.check import margin_to
from wraparc.checks.of_across import across
from wraparc.checks.rules import ACROSS_RULES
from wraparc.choose.judged import Standing, places_of
from wraparc.choose.search import Grid, Search
from wraparc.drive import Drive, LoadCase

EDGE = ACROSS_RULES["edge_tension"]
#: Most designs that are solved across the width: the first ones of the ranking.
MOST = 100


@dataclass(frozen=True, eq=False, kw_only=True)
class Edges:
    """The tightest place of designs on an uneven pulley, in the worst case, shape (n,) each.

    Attributes
    ----------
    unevenness
        Largest over mean entry tension [-]; nan where a design was not solved across the width.
    rank, tension, limit
        The worst check of an edge, see `wraparc.checks.of_across`: rank of its level, 0 where it
        was not made, the tension where the belt is tightest and what an edge may carry [N/m]. The
        tension is infinite where a strip goes slack or the belt is not carried.
    where
        Place of the worst case, as of `wraparc.choose.judged.Standing`.
    """

    unevenness: Array
    rank: Array
    tension: Array
    limit: Array
    where: Integers

    @classmethod
    def none(cls, size: int) -> Edges:
        """Return that nothing was solved yet."""
        nan = np.full((3, size), np.nan)
        where = np.zeros(size, dtype=np.int64)
        return cls(
            unevenness=nan[0], rank=np.zeros(size), tension=nan[1], limit=nan[2], where=where
        )

    def standings(self) -> dict[str, Standing]:
        """Return how the designs stand to the check of an edge, by its name."""
        margin = margin_to(self.tension, self.limit, at_most=True)
        every = np.ones(len(self.rank), dtype=bool)
        standing = Standing(EDGE, self.rank, margin, self.tension, self.limit, every, self.where)
        return {EDGE.name: standing}


def is_uneven(search: Search) -> bool:
    """Whether the pulley of a search says what is uneven across its width."""
    return search.base.across is not None


def solve_edges(search: Search, grid: Grid, which: Integers, known: Edges) -> Edges:
    """Return the edges of further designs, in every load case and condition, with those known."""
    names = ("unevenness", "rank", "tension", "limit", "where")
    found = replace(known, **{name: getattr(known, name).copy() for name in names})
    for i in map(int, which):
        worst: tuple[float, float] | None = None
        for where, at in enumerate(places_of(search)):
            if at.pulley.name != search.pulley:
                continue
            drive = grid.drive(i, at.condition)
            case = drive.load_case(at.case.name)
            result = AcrossSolver().solve(wide_arc(drive, drive.pulley(search.pulley), case))
            uneven = result.entry_unevenness if result.status.solved else np.inf
            found.unevenness[i] = np.fmax(found.unevenness[i], uneven)
            for rank, tension, limit in _edges(drive, case, result):
                order = rank, tension if np.isnan(limit) else tension / limit
                if worst is None or order > worst:
                    worst = order
                    found.rank[i], found.tension[i], found.limit[i] = rank, tension, limit
                    found.where[i] = where
    return found


def _edges(
    drive: Drive, case: LoadCase, result: AcrossResult
) -> Iterator[tuple[int, float, float]]:
    """Yield rank, tension and limit of the checks of the edges, running and at standstill."""
    for check in across(drive, case, result):
        if check.name == "slack_edge" and check.missed:
            yield check.level.rank, np.inf, np.nan
        elif check.name in ("edge_tension", "static_edge_tension"):
            known = check.level is not Level.NOT_CHECKED
            yield check.level.rank, check.value if known else _tightest(result), check.limit


def _tightest(result: AcrossResult) -> float:
    """Largest tension at an edge or of a strip, running and at standstill [N/m]."""
    return max(result.largest_running_tension, result.largest_static_tension)
