"""What the page of one file finds from a conveyor: translated to `one_file/train_kernel.js`."""

from __future__ import annotations

from collections.abc import Sequence

from wraparc.checks.numbers import usual
from wraparc.conveyor import USUAL_CONVEYOR, Conveyor, State
from wraparc.errors import Problem


def misfits(of: Conveyor) -> list[Problem]:
    """What of a conveyor does not fit together."""
    return list(of.misfits())


def unusual(of: Conveyor) -> str:
    """Key of a size that conveyors do not have; empty where all are usual."""
    for value, (key, least, most) in zip(of.sizes(), USUAL_CONVEYOR, strict=True):
        if not usual(value, least, most):
            return key
    return ""


def states(of: Conveyor) -> list[State]:
    """Load cases of a conveyor, whatever tensions they leave."""
    return of.reckoned()


def unfit(of: Conveyor, found: Sequence[State]) -> list[Problem]:
    """What keeps the belt from running so."""
    return of.unfit(found)
