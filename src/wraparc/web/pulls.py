"""What a drive file gives of the tensions of its pulley, as plain numbers.

The page reads tensions by it, translated to `static/kernel.js`; `files.tensions` reads files.
"""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from wraparc.drive.load_case import pull_of_power, pull_of_torque


class Pulls(NamedTuple):
    """What a table of a drive file gives of the tensions of its pulley; nan where nothing [SI]."""

    entry_tension: float
    exit_tension: float
    effective_tension: float
    torque: float
    power: float


#: What is wrong with the tensions that are given.
SEVERAL_PULLS, ALL_THREE, TOO_FEW, NO_SPEED = 1, 2, 3, 4


def pulls(of: Pulls) -> int:
    """How many quantities are given that fix the effective tension."""
    count = 1 if of.effective_tension == of.effective_tension else 0
    count += 1 if of.torque == of.torque else 0
    return count + (1 if of.power == of.power else 0)


def families(of: Pulls) -> int:
    """How many independent quantities are given."""
    count = 1 if of.entry_tension == of.entry_tension else 0
    count += 1 if of.exit_tension == of.exit_tension else 0
    return count + (1 if pulls(of) > 0 else 0)


def pull_given(of: Pulls, diameter: float, speed: float) -> float:
    """Effective tension that is given, nan where it is not [N]."""
    if of.effective_tension == of.effective_tension:
        return of.effective_tension
    if of.torque == of.torque:
        return pull_of_torque(of.torque, diameter)
    return pull_of_power(of.power, speed)


def both_tensions(of: Pulls, diameter: float, speed: float) -> float:
    """Sum of the tensions that are given, nan where they are not [N]."""
    pull, entry, leaving = pull_given(of, diameter, speed), of.entry_tension, of.exit_tension
    first = entry if entry == entry else leaving + pull
    return first + (leaving if leaving == leaving else entry - pull)


def overridden(of: Pulls, over: Pulls, fixed: bool, diameter: float, speed: float) -> Pulls:
    """Tensions of a pulley with those of a load case put over them.

    As `files.tensions.Given.overridden` has it.
    """
    if families(over) >= 2:
        return over
    pull = pull_given(over, diameter, speed)
    if fixed and pull == pull and pulls(over) == 1:
        both = both_tensions(of, diameter, speed)
        if both != both:
            return over
        return Pulls(0.5 * both + 0.5 * pull, 0.5 * both - 0.5 * pull, nan, nan, nan)
    entry, leaving, taken = over.entry_tension, over.exit_tension, pulls(over) > 0
    return Pulls(
        entry if entry == entry else of.entry_tension,
        leaving if leaving == leaving else of.exit_tension,
        over.effective_tension if taken else of.effective_tension,
        over.torque if taken else of.torque,
        over.power if taken else of.power,
    )


def fault_of(of: Pulls, speed: float) -> int:
    """What is wrong with the tensions that are given; 0 where nothing is."""
    if pulls(of) > 1:
        return SEVERAL_PULLS
    if families(of) > 2:
        return ALL_THREE
    if families(of) < 2:
        return TOO_FEW
    return NO_SPEED if of.power == of.power and speed != speed else 0
