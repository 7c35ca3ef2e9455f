"""The designs of a search by the reserve of their verdicts."""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from wraparc.checks import Level
from wraparc.checks.judge import judge
from wraparc.choose.selection import MOST_JUDGED, Selection
from wraparc.drive import Drive
from wraparc.reserve.find import Flip, find_reserve
from wraparc.train.whole import by_pulley


class DesignReserve(NamedTuple):
    """How little of an input makes the verdict on a design worse.

    Attributes
    ----------
    design
        Its place in the search.
    drive
        As it is solved.
    level
        Of the verdict, the worst in all conditions.
    flip
        The nearest change to a worse level in units of its uncertainty; None without one.
    reason
        Why nothing is known; empty where it is.
    """

    design: int
    drive: Drive
    level: Level
    flip: Flip | None
    reason: str

    @property
    def units(self) -> float:
        """The size of the change in units of its uncertainty, infinite without one [-]."""
        return inf if self.flip is None else self.flip.units


def rank_by_reserve(selection: Selection, most: int = MOST_JUDGED) -> tuple[DesignReserve, ...]:
    """Return the first designs of a ranking, those of the largest reserve first.

    Behind those with a better verdict; of which nothing is known come last in their level.
    """
    found = [_reserve_of(selection, int(design)) for design in selection.ranking[:most]]
    return tuple(sorted(found, key=lambda of: (of.level.rank, bool(of.reason), -of.units)))


def _reserve_of(selection: Selection, design: int) -> DesignReserve:
    results = selection.results(design)
    level = max((judge(result).level for result in results), key=lambda of: of.rank)
    reserves = [find_reserve(result, every=False) for result in results]
    worse = [f for reserve in reserves for f in reserve.flips if f.level.rank > level.rank]
    nearest = min(worse, key=lambda flip: flip.units, default=None)
    reason = next((reserve.reason for reserve in reserves if reserve.reason), "")
    return DesignReserve(design, by_pulley(results[0]).drive, level, nearest, reason)
