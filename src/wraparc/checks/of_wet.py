"""The creep when wet of a drive that was computed dry only, estimated by its dry friction."""

from __future__ import annotations

import math
from collections.abc import Iterator

from wraparc.arc.grip import wet
from wraparc.checks.check import Check, escaped, keeps
from wraparc.checks.rule import At, CheckText, Rule, Spot, idle, not_checked
from wraparc.drive import Drive, Lagging, LoadCase
from wraparc.drive.conditions import DRY, Condition
from wraparc.errors import InputError

TITLE, NOUN = "Wet creep", "wet creep (estimated)"


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
    limit, why = of.state.creep_limit, of.unknown
    if not why and not keeps(abs(of.result.exit_creep), limit):
        why = "dry creep exceeds its limit"
    if not why and math.isnan(factor):
        why = f"{lagging.name} has no wet friction"
    if why:
        yield not_checked(name, TITLE, NOUN, of.place, why=why)
        return
    creep = wet(of.result, factor)
    exceeds = "Wet creep {value} (estimated) exceeds the {limit} limit"
    slips = f"Gross slip when wet, with dry friction times {factor:.3g} (estimated)"
    source = Condition(name="wet").factor_of(lagging)[1]
    text = CheckText(
        title=TITLE,
        noun=NOUN,
        source=f"creep limit; wet friction {factor:.3g} of dry, {source}",
        label="wet creep",
        headline=slips if math.isinf(creep) else exceeds,
        action=f"Test lagging {escaped(lagging.name)} wet.",
        full=f"Wet friction {factor:.3g} of dry ({escaped(str(source))}). A drive that never runs "
        "wet has covered = true.",
    )
    yield WET_CREEP.compare(creep, limit, of.place, text)


WET_CREEP = Rule(
    "wet_creep", "the creep limit when wet (estimated)", dimension="length", tension="raise",
    binding=False, of_runs=False, find_checks=_wet_creep,
)  # fmt: skip
