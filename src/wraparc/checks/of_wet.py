"""The creep when wet of a drive that was computed dry only, estimated by its dry friction."""

from __future__ import annotations

import math
from collections.abc import Iterator

from wraparc.arc.grip import wet
from wraparc.checks.check import Check, escaped, keeps
from wraparc.checks.rule import At, Rule, Spot, Words, idle, not_checked
from wraparc.drive import Drive, Lagging, LoadCase
from wraparc.drive.conditions import DRY, Condition
from wraparc.errors import InputError

TITLE = "Wet creep"


def is_dry_only(drive: Drive, case: LoadCase) -> bool:
    """Return whether a load case stands for a drive of which only dry friction is solved.

    Not where another load case is wet, or dirty, or the drive is in another condition than this
    load case names.
    """
    laggings = (lag for p in drive.pulleys for lag in (p.lagging, *p.conditions))
    named = [c.condition for c in drive.load_cases if c.condition]
    dry = all(lag.condition == DRY for lag in laggings) and all(name == DRY for name in named)
    return dry and (not case.condition or len(named) == len(drive.load_cases))


def wet_factor(lagging: Lagging) -> float:
    """Return wet friction over the dry friction of a lagging, nan if not known [-]."""
    try:
        return Condition(name="wet").factor_of(lagging)[0]
    except InputError:  # nothing is published on its surface
        return math.nan


def estimate_factor(of: At) -> float:
    """Return the factor on the friction of a pulley for its estimate when wet [-].

    Returns
    -------
    Wet friction over dry friction, nan if not known; 0 where there is no estimate: the drive is
    covered, or is not computed dry only.
    """
    if of.drive.criteria.covered or not is_dry_only(of.drive, of.case):
        return 0.0
    return wet_factor(of.pulley.lagging)


def _wet_creep(of: Spot) -> Iterator[Check]:
    """Check the creep when wet, estimated, where only dry friction is solved."""
    factor = estimate_factor(of)
    if of.result is None or factor == 0.0 or idle(of.result.arc):
        return
    name, lagging = WET_CREEP.name, of.pulley.lagging
    limit, missing = of.state.creep_limit, of.unknown
    if not missing and not keeps(abs(of.result.exit_creep), limit):
        missing = "the dry creep exceeds its limit"
    if missing or math.isnan(factor):
        missing = missing or f"{lagging.name} has no wet friction"
        yield not_checked(name, TITLE, missing, of.place)
        return
    creep = wet(of.result, factor)
    slips, exceeds = math.isinf(creep), "Wet creep {value} (estimated) exceeds the {limit} limit."
    words = Words(
        title=TITLE,
        source=f"creep limit; wet friction {factor:.3g} of dry, "
        f"{Condition(name='wet').factor_of(lagging)[1]}",
        short="gross slip when wet" if slips else "over creep limit wet",
        says="Gross slip when wet (estimated)." if slips else exceeds,
        remedy=f"Test lagging {escaped(lagging.name)} wet, or give covered = true if the drive "
        "never runs wet.",
    )
    yield WET_CREEP.judged(creep, limit, of.place, words)


WET_CREEP = Rule(
    "wet_creep", "the creep limit when wet (estimated)", dimension="length", tension="raise",
    binding=False, of_runs=False, asked=_wet_creep,
)  # fmt: skip
