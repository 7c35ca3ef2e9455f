"""Checks of a solved arc: grip, standard, creep, lagging, tested slip, balance of the solution."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from wraparc.alike import largest
from wraparc.arc import ArcResult, Status
from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.design_standard import asked
from wraparc.checks.gross_slip import rises, sliding
from wraparc.checks.numbers import asked_slack, balance_miss, steepest
from wraparc.checks.of_drive import (
    MORE_CREEP,
    judged,
    not_checked,
    origin,
    tests_of,
)
from wraparc.checks.rules import NO_GRIP, RULES, idle, standard_rule, start_factor
from wraparc.checks.sliding import CREEP, MOST, NOT_CARRIED, SLIDES, TESTED, Sliding
from wraparc.drive import CREEP_LIMIT, Drive, LoadCase, Pulley, TakeUp
from wraparc.drive.pitch import turns_an_hour
from wraparc.units import Dimension

#: Largest miss of the energy balance that a solution is trusted with [-]; the usual mesh misses by
#: 1.4e-5 at 0.8 m of creep, and by less than 1e-7 at creeps that a drive has.
BALANCE = 1e-4
#: Title of the check of the interval that a fitted law leaves.
INTERVAL = "Creep at exit, end of the 95 % interval of the law"
OWN_FACTORS = "taken where the drive file says nothing"
#: What helps against slip, with more tension and without.
MORE_GRIP = (
    "Raise the slack-side tension, enlarge the wrap angle, or choose a lagging with more friction."
)
NO_TENSION = (
    "No slack-side tension is enough: enlarge the wrap angle, or choose a lagging with more "
    "friction."
)
GRIP = "Safety against gross slip, {}"
#: What comes first where a belt slides: in a title, and as a sentence begins.
FIRST = {
    CREEP: ("by creep", "The belt slides (creep of {slides})"),
    TESTED: ("by tested slip", "The slip leaves the tests of lagging ⟦lagging⟧"),
    MOST: ("by the largest friction", "All friction of the wrap is used up"),
}


def no_state(result: ArcResult) -> str:
    """Say why an arc that is not solved has no numbers to be checked."""
    if result.status is Status.UNSOLVED:
        return "the arc was not solved"
    return "in gross slip the belt has no state at rest"


def _known(check: Check, result: ArcResult) -> Check:
    """Return a check of what an arc does, as not made where it is not solved."""
    if result.status.solved or check.level is Level.NOT_CHECKED:
        return check
    return not_checked(check.name, check.title, no_state(result), check.place)


def grip(drive: Drive, case: LoadCase, arcs: Sequence[ArcResult], index: int) -> Check:
    """Check whether an arc carries its load, and with which factor in hand."""
    result = arcs[index]
    take_up, name = drive.criteria.take_up, RULES["gross_slip"].name
    place = Place(result.arc.pulley, case.name)
    title = GRIP.format(case.kind)
    if result.status is Status.UNSOLVED:
        return Check(
            name=name, title=title, level=Level.FAULT, short="not solved",
            says=escaped(str(result.status)), place=place,
        )  # fmt: skip
    if idle(result.arc):
        return Check(
            name=name, title="No pull to carry", level=Level.OK, short="not driven", place=place
        )
    rise = rises([r.arc for r in arcs], index, take_up)
    return of_sliding(drive, case, result, sliding(result, rise))


def of_sliding(drive: Drive, case: LoadCase, result: ArcResult, found: Sliding) -> Check:
    """Return the check of the pull at which the belt slides, by what comes first there."""
    safety, take_up, lagging = drive.criteria.safety, drive.criteria.take_up, result.arc.pulley
    rule, factor, gone = RULES["gross_slip"], safety.of(case.kind), not result.status.solved
    by, first = FIRST[found.cause]
    title = f"{GRIP.format(case.kind)}, {by}"
    place = Place(result.arc.pulley, case.name)
    if math.isnan(found.place) and not gone:
        return not_checked(rule.name, title, "where the belt slides was not found", place)
    if found.cause == TESTED:  # what is not known to slide needs attention, and does not fail
        rule = replace(rule, fails_beyond=math.nan)
    first = first.replace("⟦lagging⟧", escaped(drive.pulley(lagging).lagging.name))
    says = f"{first} at {{value}} times the pull, below {{limit}}; safety factor {case.kind}, "
    says += f"{held_words(take_up)}."
    check = judged(
        rule,
        title,
        min(found.place, NOT_CARRIED) if gone else found.place,
        factor,
        "number",
        source=f"safety factor {case.kind}: {safety.source or OWN_FACTORS}",
        short="pull beyond tests" if found.cause == TESTED else "near gross slip",
        says=says,
        because="So it slides.",
        remedy=MORE_GRIP,
        otherwise=NO_TENSION,
        more={"slides": (SLIDES, "length")},
        place=place,
    )
    if not gone:
        return check
    says = f"Gross slip: no creep carries the pull. {says}"
    return replace(check, level=NO_GRIP, says=says, short="gross slip", miss=None)


def held_words(take_up: TakeUp) -> str:
    """Return what a take-up holds, in words."""
    if take_up.fixed:
        return "T1 + T2 held (fixed take-up)"
    where = f"tension behind pulley {take_up.after}" if take_up.after else "T2"
    return f"{escaped(where)} held (gravity take-up)"


def standard(drive: Drive, case: LoadCase, result: ArcResult) -> Check | None:
    """Check the slack side against the design standard; None where none is asked for."""
    criteria, lagging = drive.criteria, drive.pulley(result.arc.pulley).lagging
    found = asked(criteria.standard, criteria.take_up, lagging, result.arc.wrap_angle)
    if found is None or idle(result.arc):
        return None
    place = Place(result.arc.pulley, case.name)
    if math.isnan(found.wrap_factor):
        title = f"Slack side by {found.rule}"
        if not criteria.standard.name:
            return not_checked("design_standard", title, found.why_not, place)
        return Check(
            name="design_standard",
            title=title,
            level=Level.FAILS if criteria.standard.binding else Level.ATTENTION,
            place=place,
            short="standard not applicable",
            says=escaped(f"{found.rule} was chosen and cannot be applied: {found.why_not}."),
            remedy="Give what it asks for, or choose another design standard.",
            binding=criteria.standard.binding,
        )
    slack = min(result.arc.entry_tension, result.arc.exit_tension)
    limit = design_slack(drive, case, result, found.wrap_factor)
    chosen = "" if criteria.standard.name else " No standard was chosen: CEMA was taken."
    start, (rule, _, how) = "", found.rule.partition(", ")
    if criteria.standard.start_factor != 1.0 and case.kind == "running":
        start = f" at {criteria.standard.start_factor:g} times the pull"
    return judged(
        standard_rule(criteria),
        f"Slack side by {found.rule}",
        slack,
        limit,
        "force",
        source=found.source,
        short="below standard",
        says=f"Slack side {{value}} is below the {{limit}} of {rule}; {how}{start}.{chosen}",
        remedy="Raise the slack-side tension, or choose the design standard.",
        otherwise="Choose the design standard.",
        binding=criteria.standard.binding,
        place=place,
    )


def design_slack(drive: Drive, case: LoadCase, result: ArcResult, factor: float) -> float:
    """Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]."""
    start = start_factor(drive.criteria, case.kind)
    return asked_slack(factor, start, result.arc.effective_tension)


def creep(drive: Drive, result: ArcResult) -> Check:
    """Check the creep at the exit."""
    title, place = "Creep at exit", Place(result.arc.pulley, result.arc.load_case)
    if not result.status.solved:
        return not_checked("creep", title, no_state(result), place)
    limit = result.arc.creep_limit
    return judged(
        RULES["creep"],
        title,
        abs(result.exit_creep),
        limit,
        "length",
        place=place,
        source="conservative limit, 1/4 in; B. DeVries, A model of lagging friction"
        if limit == CREEP_LIMIT
        else "given",
        short="over creep limit",
        more={
            "fabric": (MORE_CREEP["fabric"], "force_per_width"),
            "slides": (SLIDES, "length"),
            "allowed": (RULES["creep"].tolerates, "length"),
        },
        says="Creeps {value}, more than the limit of {limit}.",
        allows=_qualifies(drive, limit),
        because="A belt that creeps more than {slides} slides.",
        remedy=MORE_GRIP,
        otherwise=NO_TENSION,
    )


#: Of a law that does not say what its slip includes, on a belt with a cover.
COVER_UNKNOWN = "Whether the tested slip includes the shear of the belt cover is not known"


def cover_creep(result: ArcResult) -> Check | None:
    """Check the creep with the cover of the belt in series, where the law may include its shear."""
    place, found = Place(result.arc.pulley, result.arc.load_case), result.covered_creep
    title = "Creep at exit, with the cover of the belt in series"
    if result.arc.cover_left_out == 0.0:
        return None
    if not result.status.solved:
        return not_checked("cover_creep", title, no_state(result), place)
    told = "the creep is {value}" if math.isfinite(found) else "the belt slips through"
    return judged(
        RULES["cover_creep"],
        title,
        abs(found),
        result.arc.creep_limit,
        "length",
        place=place,
        source="shear of the cover of the belt",
        short="limit within belt cover",
        says=f"{COVER_UNKNOWN}: with the cover in series {told}, beyond the limit of {{limit}}.",
        remedy="State the cover of the test belt with the shear tests, or raise the slack-side "
        "tension.",
        otherwise="State the cover of the test belt with the shear tests.",
        binding=False,
    )


def creep_interval(drive: Drive, result: ArcResult) -> Check | None:
    """Check the end of the interval that the uncertainty of a fitted law leaves of the creep."""
    place, ends = Place(result.arc.pulley, result.arc.load_case), result.creep_interval
    if result.arc.fit is not None and result.arc.fit.knots and not result.status.solved:
        return not_checked("creep_interval", INTERVAL, no_state(result), place)
    if math.isnan(ends[0]):
        return None
    most = largest(ends, abs)
    told = "reaches {value}" if math.isfinite(most) else "reaches gross slip"
    return judged(
        RULES["creep_interval"],
        INTERVAL,
        abs(most),
        result.arc.creep_limit,
        "length",
        place=place,
        source=tests_of(drive.pulley(result.arc.pulley)),
        short="limit within uncertainty",
        says=f"By the uncertainty of the friction law the creep {told}, beyond {{limit}}; that is "
        "the end of its 95 % interval.",
        remedy="Raise the slack-side tension, or test more samples of the lagging.",
        otherwise="Test more samples of the lagging.",
        binding=False,
    )


def _qualifies(drive: Drive, limit: float) -> str:
    """Say whether the belt may creep more than the customary limit."""
    belt = drive.belt
    if limit != CREEP_LIMIT:
        return ""
    least = MORE_CREEP.get(belt.kind)
    steel, rating = belt.kind == "steel cord", belt.rating
    if least is None or (rating is None and not steel):
        return "Whether this belt may creep more is not known: its carcass or rating is not given."
    strong = belt.breaking_strength or 0.0
    over = strong > least if steel else (rating or 0.0) > least * (1.0 + 1e-9)
    if over:
        return (
            "Practice may allow this belt up to {allowed}, as it does steel cord above ST1600 and "
            "fabric above {fabric} (B. DeVries)."
        )
    if steel and not strong:
        return "Steel cord above ST1600 may creep more; the name does not tell its strength."
    return (
        "This belt does not qualify for more, as steel cord above ST1600 and fabric above "
        "{fabric} do (B. DeVries)."
    )


def lagging_stress(pulley: Pulley, result: ArcResult) -> Iterator[Check]:
    """Check the peak shear stress against bond and fatigue of the lagging."""
    place = Place(pulley.name, result.arc.load_case)
    yield _known(bond(pulley, result.peak_shear_stress, place), result)
    often = ""
    more: dict[str, tuple[float, Dimension]] = {}
    if result.arc.belt_speed is not None:
        often = "; the belt passes {passes} times an hour"
        pitch = result.arc.radius + result.arc.offset
        more["passes"] = turns_an_hour(result.arc.belt_speed, pitch), "number"
    fatigue = _stress(
        pulley, result.peak_shear_stress, place, "fatigue_stress", "fatigue_limit",
        "Shear stress of lagging and bond, at every pass", "lagging tires",
        "At every pass the shear stress reaches {value}, above the fatigue limit {limit}"
        f"{often}.",
        more,
    )  # fmt: skip
    yield _known(fatigue, result)


def bond(pulley: Pulley, stress: float, place: Place) -> Check:
    """Check a shear stress against what lagging and bond bear once."""
    title = "Shear stress of lagging and bond, steady"
    if place.event:
        title = "Largest shear stress of lagging and bond"
    return _stress(
        pulley, stress, place, "bond_stress", "bond_strength", title, "bond overstressed",
        "The shear stress of lagging and bond, {value}, is above their {limit}.",
    )  # fmt: skip


def _stress(
    pulley: Pulley, stress: float, place: Place, name: str, key: str, title: str, short: str,
    says: str, more: Mapping[str, tuple[float, Dimension]] | None = None,
) -> Check:  # fmt: skip
    lagging = pulley.lagging
    limit = getattr(lagging, key)
    if limit is None:
        why = f"the {key.replace('_', ' ')} of lagging {lagging.name} is not given"
        return not_checked(name, title, why, place)
    return judged(
        RULES[name],
        title,
        stress,
        limit,
        "pressure",
        source=origin(lagging.source_of(key)),
        short=short,
        says=says,
        remedy="Choose a lagging with a stronger bond, a larger pulley, or less pull.",
        place=place,
        more=more,
    )


def tested_slip(pulley: Pulley, result: ArcResult) -> Iterator[Check]:
    """Check slip and slip speed of an arc against the tests of the lagging."""
    place = Place(pulley.name, result.arc.load_case)
    slip = speed = math.inf
    if result.status.solved:
        slip, speed = largest_slip(result), slip_speed(result)
    elif result.arc.belt_speed is None:
        speed = math.nan
    for check in slip_in_tests(pulley, slip, speed, place):
        yield _known(check, result)


def slip_in_tests(pulley: Pulley, slip: float, speed: float, place: Place) -> Iterator[Check]:
    """Check slip and slip speed against the tests of the lagging, where its law states any."""
    tested = pulley.lagging.law.tested
    if tested is None:
        return
    yield judged(
        RULES["tested_slip"],
        "Largest slip, tested",
        slip,
        tested.slip_max,
        "length",
        source=tests_of(pulley),
        short="slip beyond tests",
        says="The slip {value} is beyond the {limit} that lagging "
        f"{escaped(pulley.lagging.name)} was tested to: there the friction is an extrapolation.",
        remedy="Raise the slack-side tension, or test the lagging to this slip.",
        otherwise="Test the lagging to this slip.",
        place=place,
    )
    title = "Slip speed, tested"
    if tested.slip_speed is None:
        why = "the friction law does not say at which speed it was tested"
        unchecked = not_checked("tested_slip_speed", title, why, place)
        found = speed if math.isfinite(speed) else math.nan
        yield replace(unchecked, value=found, dimension="speed")
    elif math.isnan(speed):
        yield not_checked("tested_slip_speed", title, "the belt speed is not given", place)
    else:
        yield judged(
            RULES["tested_slip_speed"],
            title,
            speed,
            tested.slip_speed,
            "speed",
            source=tests_of(pulley),
            short="slips faster than tests",
            says="The belt slips at up to {value}, lagging "
            f"{escaped(pulley.lagging.name)} was tested at {{limit}}: how its friction changes "
            "with speed is not known.",
            remedy="Test the lagging at this speed, or keep a larger safety factor.",
            binding=False,
            place=place,
        )


def largest_slip(result: ArcResult) -> float:
    """Largest slip of the belt on the lagging along the arc [m]."""
    return float(np.abs(result.profile.slip).max())


def slip_speed(result: ArcResult) -> float:
    """Largest speed of the belt on the lagging along the arc [m/s]; nan without a belt speed."""
    speed = result.arc.belt_speed
    if speed is None or len(result.profile) < 2:
        return math.nan
    profile, arc = result.profile, result.arc
    position, slip = profile.position.tolist(), profile.slip.tolist()
    pitch = arc.radius + arc.offset  # the shell turns v/pitch under the belt
    return speed * steepest(position, slip, len(position), pitch, pitch * arc.wrap_angle)


def balance(result: ArcResult) -> Check | None:
    """Check the energy balance of the solution: a miss is a fault of the program."""
    error = result.energy.identity_error
    if not result.status.solved or math.isnan(error):
        return None
    arc = result.arc
    pull, g = result.effective_tension, result.entry_creep_ratio
    value = balance_miss(error, pull, g, arc.entry_tension, arc.compliance)
    return judged(
        RULES["balance"],
        "Energy balance of the solution",
        value,
        BALANCE,
        "number",
        source="tolerance of the program",
        short="out of balance",
        says="The energy balance of the solution misses by {value}, more than {limit}.",
        remedy="Please report the drive file; until then change a value slightly.",
        place=Place(arc.pulley, arc.load_case),
        binding=False,
    )
