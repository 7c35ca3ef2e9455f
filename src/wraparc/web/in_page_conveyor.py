"""What the page of one file finds from a conveyor: translated to `one_file/train_kernel.js`."""

from __future__ import annotations

from collections.abc import Sequence

from wraparc.checks.numbers import usual
from wraparc.conveyor import EMPTIEST, FULLEST, STEEPEST, USUAL_CONVEYOR, Conveyor, State
from wraparc.errors import Problem


def misfits(of: Conveyor) -> list[Problem]:
    """What of a conveyor does not fit together."""
    return list(of.misfits())


def unusual(of: Conveyor, width: float) -> str:
    """Key of a size that conveyors of a belt width [m] do not have; empty where all are usual."""
    for value, (key, least, most) in zip(of.sizes(), USUAL_CONVEYOR, strict=True):
        if not usual(value, least, most):
            return key
    if not usual(of.material, EMPTIEST * width**2, FULLEST * width**2):
        return "material_mass" if of.capacity is None else "capacity"
    return "lift" if abs(of.lift) > STEEPEST * of.length else ""


def states(of: Conveyor) -> list[State]:
    """Load cases of a conveyor, whatever tensions they leave."""
    return of.reckoned()


def unfit(of: Conveyor, found: Sequence[State]) -> list[Problem]:
    """What keeps the belt from running so."""
    return of.unfit(found)
