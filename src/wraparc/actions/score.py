"""How much an outcome leaves, and what may not come of a change: plain numbers only."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import NamedTuple

from wraparc.actions.variant import Outcome
from wraparc.checks.check import Level

#: Checks that data are missing for: no change of the drive answers them, and none is held to them.
DATA_CHECKS = (
    "condition", "fit", "usual_sizes", "belt_thickness", "tested_slip_speed", "case_kind",
    "profile_extent", "reserve", "data", "sense",
)  # fmt: skip
#: Rank of a check that fails.
FAILS = Level.FAILS.rank


class Score(NamedTuple):
    """How much is left, the less the better: checks that are missed, and the worst level."""

    left: int
    level: int

    @property
    def weight(self) -> int:
        """One number to compare by."""
        return 100 * self.left + self.level


def names_left(levels: Mapping[str, int]) -> list[str]:
    """Return the checks that are missed and that a change of the drive may answer."""
    return [name for name in levels if name not in DATA_CHECKS]


def score_of(outcome: Outcome) -> Score:
    """Return how much an outcome leaves.

    What is not checked because of gross slip, or of a creep that is too large dry, counts too.
    """
    names = names_left(outcome.levels)
    ranks = [outcome.levels[name] for name in names]
    slips = "operating_point" in names or outcome.levels.get("gross_slip", 0) >= FAILS
    count = len(names)
    if slips and "creep" not in names:
        count += 1
    if (slips or "creep" in names) and "wet_creep" not in names:
        count += 1
    return Score(count, max(ranks, default=0))


def is_allowed(outcome: Outcome, now: Outcome) -> bool:
    """Return whether no check is missed that passed, and none is at a worse level."""
    if not outcome.possible:
        return False
    for name, rank in outcome.levels.items():
        if name in now.passed or rank > now.levels.get(name, inf):
            return False
    return True


def answers_first(outcome: Outcome, now: Outcome) -> bool:
    """Return whether the governing check, the first of those missed now, passes or fails less.

    Who reads of a creep is not advised what mends another check and leaves the creep as it is.
    """
    first = next(iter(now.levels), "")
    return outcome.levels.get(first, -1) < now.levels.get(first, 0)
