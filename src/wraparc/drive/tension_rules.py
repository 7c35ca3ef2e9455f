"""Which quantities fix the tensions of a pulley: rules for files, studies, trains and the page.

Numbers are floats, or arrays of them; None is what is not given. The page has these functions
translated (`tools/page_kernel.py`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from wraparc.drive.load_case import pull_of_power, pull_of_torque

#: Keys that all fix the effective tension.
EFFECTIVE = ("effective_tension", "torque", "power")
ENDS = ("entry_tension", "exit_tension")
FEW = "Give two of entry_tension, exit_tension, effective_tension (torque, power)."
ONE_TOO_MANY = "Leave one of them out."
#: Difference of two pulls over the larger that is rounding [-].
_ALIKE = 1e-6


class LoadGiven(NamedTuple):
    """What is given of the tensions of one pulley; None where nothing."""

    entry_tension: float | None = None  # [N]
    exit_tension: float | None = None  # [N]
    effective_tension: float | None = None  # [N]
    torque: float | None = None  # [N m]
    power: float | None = None  # [W]


class DrumAt(NamedTuple):
    """What turns a torque or a power into a pull."""

    diameter: float | None  # of the pulley [m]
    speed: float | None  # of the belt [m/s]


class NipTensions(NamedTuple):
    """Tensions at the nips, as far as they follow from what is given [N]."""

    entry: float | None
    exit: float | None


class RunsGain(NamedTuple):
    """What the belt gains between the pulleys, in all [N]."""

    base: float = 0.0  # where the load case takes over from
    case: float = 0.0  # in the load case


class LoadFault(NamedTuple):
    """What is wrong with the tensions that are given."""

    message: str
    remedy: str
    lacks: str  # what is missing, a key or "tensions"; empty where too much is given


def effective_keys(of: LoadGiven) -> list[str]:
    """The keys given that fix the effective tension."""
    return [key for key in EFFECTIVE if getattr(of, key) is not None]


def families(of: LoadGiven) -> list[str]:
    """One key for each independent quantity given."""
    keys = [key for key in ENDS if getattr(of, key) is not None]
    pulls = effective_keys(of)
    if len(pulls) > 0:
        keys.append(pulls[0])
    return keys


def overdetermined(of: LoadGiven) -> bool:
    """Whether more is given than fixes the tensions."""
    return len(effective_keys(of)) > 1 or len(families(of)) > 2


def pull_given(of: LoadGiven, at: DrumAt) -> float | None:
    """Effective tension that is given [N]; None where it is not, or does not follow."""
    if of.effective_tension is not None:
        return of.effective_tension
    if of.torque is not None:
        return None if at.diameter is None else pull_of_torque(of.torque, at.diameter)
    if of.power is None or at.speed is None:
        return None
    return pull_of_power(of.power, at.speed)


def filled(entry: float | None, leaving: float | None, pull: float | None) -> NipTensions:
    """Both tensions by one of them and the pull [N]."""
    if pull is not None and leaving is None and entry is not None:
        return NipTensions(entry, entry - pull)
    if pull is not None and entry is None and leaving is not None:
        return NipTensions(leaving + pull, leaving)
    return NipTensions(entry, leaving)


def ends_of(of: LoadGiven, at: DrumAt) -> NipTensions:
    """Tensions at the nips, as far as they follow [N]."""
    return filled(of.entry_tension, of.exit_tension, pull_given(of, at))


def less_runs(of: LoadGiven, runs: float, at: DrumAt) -> LoadGiven:
    """What is given with the pull between the outer tensions: that of the pulleys less the runs.

    What the pulleys of a train pull together is entry less exit tension and what the runs between
    them add [N].
    """
    pull = pull_given(of, at)
    if runs == 0.0 or pull is None:
        return of
    return LoadGiven(of.entry_tension, of.exit_tension, pull - runs, None, None)


def overridden(
    of: LoadGiven, over: LoadGiven, fixed: bool, at: DrumAt, runs: RunsGain
) -> LoadGiven:
    """What is given of a pulley with what a load case gives put over it.

    Two independent quantities replace all; a single one replaces its own kind. A pull alone takes
    the exit tension with it, or under a fixed take-up the sum of both tensions; where that sum is
    not known it is not enough.

    Parameters
    ----------
    of, over
        Of the pulley; of the load case.
    fixed
        Whether the take-up holds the sum of both tensions.
    at
        What turns torques and powers into pulls.
    runs
        What of the pull the belt gains between the pulleys.
    """
    if len(families(over)) >= 2:
        return over
    pull = pull_given(over, at)
    if fixed and pull is not None and len(effective_keys(over)) == 1:
        ends = ends_of(less_runs(of, runs.base, at), at)
        if ends.entry is None or ends.exit is None:
            return over
        half, between = 0.5 * (ends.entry + ends.exit), 0.5 * (pull - runs.case)
        return LoadGiven(half + between, half - between, None, None, None)
    by = over if len(effective_keys(over)) > 0 else of
    return LoadGiven(
        of.entry_tension if over.entry_tension is None else over.entry_tension,
        of.exit_tension if over.exit_tension is None else over.exit_tension,
        by.effective_tension,
        by.torque,
        by.power,
    )


class BehindTakeUp(NamedTuple):
    """What lies behind a take-up between drives, of a train."""

    share: float  # of the whole pull that the drives behind it take [-]
    behind: float  # what the runs behind it add [N]
    runs: float  # what all runs add [N]


def behind_take_up(
    now: NipTensions, first: NipTensions, after: BehindTakeUp, before: BehindTakeUp
) -> NipTensions | None:
    """Tensions of a load case that gives its pull alone, by a take-up between drives [N].

    It keeps the tension behind its pulley; what the pulleys behind it then pull leaves the exit
    tension of the last one. None where a tension is not known.

    Parameters
    ----------
    now, first
        Outer tensions of the load case, and of what it takes over from.
    after, before
        What lies behind the take-up in each.
    """
    if now.entry is None or now.exit is None or first.entry is None or first.exit is None:
        return None
    pull, pull_0 = now.entry - now.exit, first.entry - first.exit
    lost = after.share * (pull + after.runs) - after.behind
    lost -= before.share * (pull_0 + before.runs) - before.behind
    return NipTensions(first.exit - lost + pull, first.exit - lost)


def fault_of(
    of: LoadGiven, inherited: bool, at: DrumAt, force: Callable[[float], str]
) -> LoadFault | None:
    """What is wrong with what is given of one pulley, by itself.

    Parameters
    ----------
    of
        What is given.
    inherited
        Whether a load case takes some of it over from its pulley.
    at
        What turns torques and powers into pulls.
    force
        Tells a force [N] with its unit.
    """
    pulls, given = effective_keys(of), families(of)
    if not overdetermined(of):
        return None
    if len(pulls) > 1:
        return LoadFault(f"{listed(pulls)} each fix the effective tension", ONE_TOO_MANY, "")
    message = f"{listed(given)} are one too many"
    pull, ends = pull_given(of, at), ends_of(of, at)
    if pull is not None and ends.entry is not None and ends.exit is not None:
        between = ends.entry - ends.exit
        if abs(pull - between) > _ALIKE * abs(between):
            message = f"{pulls[0]} makes {force(pull)}, the tensions {force(between)}"
    remedy = f"Give two of {', '.join(given)} in the load case."
    return LoadFault(message, remedy if inherited else ONE_TOO_MANY, "")


def speed_missing(of: LoadGiven, at: DrumAt) -> LoadFault | None:
    """Whether a power is given, and no belt speed to make a pull of it."""
    if at.speed is not None or of.power is None:
        return None
    remedy = 'Write speed = "3 m/s" in [belt], or give effective_tension.'
    return LoadFault("power needs the belt speed", remedy, "power")


def too_few(of: LoadGiven) -> LoadFault:
    """What is said where the tensions do not follow."""
    given = families(of)
    if len(given) == 0:
        return LoadFault("tensions missing", FEW, "tensions")
    message = f"{given[0]} alone does not fix the tensions"
    return LoadFault(message, FEW, "tensions")


def listed(keys: Sequence[str]) -> str:
    """Keys in words."""
    return f"{', '.join(keys[:-1])} and {keys[-1]}"
