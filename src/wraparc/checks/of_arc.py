"""Checks of a solved arc: grip, standard, creep, lagging, tested slip, balance of the solution."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from wraparc.alike import largest
from wraparc.arc import ArcResult, Status
from wraparc.arc.grip import sliding
from wraparc.arc.sliding import CREEP, MOST, NOT_CARRIED, SLIDES, TESTED, Sliding
from wraparc.arrays import Number
from wraparc.checks.check import Amount, Check, Level, Place, escaped
from wraparc.checks.design_standard import find_requirement
from wraparc.checks.numbers import balance_miss, required_slack
from wraparc.checks.of_drive import EXTRAPOLATED, LARGER_CREEP, tests_of
from wraparc.checks.rule import At, CheckText, Rule, Spot, State, idle, not_checked, origin
from wraparc.drive import CREEP_LIMIT, Criteria, Drive, LoadCase, TakeUp
from wraparc.drive.pitch import turns_an_hour
from wraparc.drive.pull import idles

#: Largest miss of the energy balance that a solution is trusted with [-]; the usual mesh misses by
#: 1.4e-5 at 0.8 m of creep, and by less than 1e-7 at creeps that a drive has.
BALANCE = 1e-4
#: What to do about an error of the program.
REPORT = "Do not use this result. Report the drive file."
#: Noun of the slack-side tension that a design standard asks for.
STANDARD_NOUN = "T2 by the design standard"
#: Title and noun of the check of the interval that a fitted law leaves.
INTERVAL, INTERVAL_NOUN = "Creep, 95 % bound", "creep, 95 % bound"
OWN_FACTORS = "default of wraparc"
GRIP, GRIP_NOUN = "Gross-slip safety", "gross-slip safety"
#: Where gross slip cannot be avoided, whatever its safety factor.
NO_GRIP = Level.FAILS
#: What comes first where a belt slides, for --full.
FIRST = {
    CREEP: "A creep of {slides} comes first.",
    TESTED: "The end of the tested slip of lagging ⟦lagging⟧ comes first.",
    MOST: "The whole friction of the wrap comes first.",
}
TESTED_HEADLINE = "Tested friction transmits {value} times Te, minimum {limit}"


def no_state(result: ArcResult) -> str:
    """Say why an arc that is not solved has no numbers to be checked."""
    return "not solved" if result.status is Status.UNSOLVED else "gross slip"


def grip(drive: Drive, case: LoadCase, arcs: Sequence[ArcResult], index: int) -> Check:
    """Check whether an arc carries its load, and with which factor in hand."""
    result = arcs[index]
    name = GROSS_SLIP.name
    place = Place(result.arc.pulley, case.name)
    if result.status is Status.UNSOLVED:
        return Check(
            name=name, title=GRIP, noun=GRIP_NOUN, level=Level.FAULT, label="not solved",
            headline="No solution", full=escaped(str(result.status)), action=REPORT, place=place,
        )  # fmt: skip
    if idle(result.arc):
        return Check(
            name=name, title=GRIP, noun=GRIP_NOUN, level=Level.OK, label="not driven", place=place
        )
    return of_sliding(drive, case, result, sliding(result))


def of_sliding(drive: Drive, case: LoadCase, result: ArcResult, found: Sliding) -> Check:
    """Return the check of the pull at which the belt slides, by what comes first there."""
    safety, take_up = drive.criteria.safety, drive.criteria.take_up
    rule, factor, gone = GROSS_SLIP, safety.of(case.kind), not result.status.solved
    place = Place(result.arc.pulley, case.name)
    if math.isnan(found.place) and not gone:
        why = "gross slip not located"
        return not_checked(rule.name, GRIP, GRIP_NOUN, place, why=why)
    tested = found.cause == TESTED and not gone
    if tested:  # what is not known to slide needs attention, and does not fail
        rule = replace(rule, fails_beyond=math.nan)
    lagging = escaped(drive.pulley(result.arc.pulley).lagging.name)
    value = min(found.place, NOT_CARRIED) if gone else found.place
    text = CheckText(
        title=GRIP,
        noun=GRIP_NOUN,
        source=f"safety factor {case.kind}: {safety.source or OWN_FACTORS}",
        label="slip outside tests" if tested else "gross slip",
        headline=TESTED_HEADLINE
        if tested
        else "Gross-slip safety {value} is below the {limit} minimum",
        fails=NO_SAFETY,
        full=f"{FIRST[found.cause].replace('⟦lagging⟧', lagging)} Safety factor {case.kind}, "
        f"{constant_words(take_up)}.",
        more={
            "slides": Amount(SLIDES, "length"),
            "safety": Amount(value, "number"),
            "one": Amount(1.0, "number"),
        },
    )
    check = rule.compare(value, factor, place, text)
    return replace(check, level=NO_GRIP, headline=NO_SAFETY) if gone else check


#: What a belt that slides says.
NO_SAFETY = "Gross slip: safety {safety} is below {one}"
GROSS_SLIP = Rule(
    "gross_slip", "the gross-slip safety", at_most=False, fails_beyond=1.0,
    tension="raise",
)  # fmt: skip


def constant_words(take_up: TakeUp) -> str:
    """Return what a take-up leaves constant, in words."""
    if take_up.fixed:
        return "T1 + T2 constant (fixed take-up)"
    where = f"tension behind pulley {take_up.after}" if take_up.after else "T2"
    return f"{escaped(where)} constant (gravity take-up)"


def _standard(of: Spot) -> Iterator[Check]:
    """Check the slack side against the design standard, where one is asked for."""
    criteria, pulley = of.drive.criteria, of.pulley
    found = find_requirement(criteria.standard, criteria.take_up, pulley.lagging, pulley.wrap_angle)
    tensions, rule = of.case.tensions[pulley.name], DESIGN_STANDARD.for_drive(of.drive)
    if found is None or idles(tensions.entry, tensions.exit):
        return
    title, noun = f"T2 by {found.name}", STANDARD_NOUN
    if math.isnan(found.wrap_factor):
        if not criteria.standard.name:
            yield not_checked(rule.name, title, noun, of.place, why=found.why_not)
            return
        yield Check(
            name=rule.name,
            title=title,
            noun=noun,
            level=rule.missed,
            place=of.place,
            label="standard not applicable",
            headline=escaped(f"{found.name} does not apply: {found.why_not}"),
            action=escaped(found.remedy),
            binding=rule.binding,
        )
        return
    assumed = "" if criteria.standard.name or criteria.standard.friction is not None else (
        " No standard was chosen: CEMA assumed."
    )  # fmt: skip
    start = ""
    if criteria.standard.start_factor != 1.0 and of.case.kind == "running":
        start = f" at {criteria.standard.start_factor:g} times Te"
    slack = "Slack-side tension T1" if tensions.entry < tensions.exit else "T2"
    text = CheckText(
        title=title,
        noun=noun,
        source=found.source,
        label="below standard",
        headline=escaped(f"{slack} ")
        + "{value} "
        + escaped(f"is below the {found.name} minimum ")
        + "{limit}",
        action="Set design_standard.name." if assumed else "",
        full=f"{escaped(found.how)}{start}.{assumed}",
    )
    limit = design_slack(of, found.wrap_factor)
    yield rule.compare(of.state.slack, limit, of.place, text)


def design_slack(of: At, factor: float) -> float:
    """Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]."""
    start = start_factor(of.drive.criteria, of.case.kind)
    return required_slack(factor, start, of.case.tensions[of.pulley.name].effective)


def start_factor(criteria: Criteria, kind: str) -> float:
    """Pull that the design standard is applied to over that of a load case [-]."""
    return criteria.standard.start_factor if kind == "running" else 1.0


def _binds(drive: Drive) -> bool:
    return drive.criteria.standard.binding


DESIGN_STANDARD = Rule(
    "design_standard", "the design standard", at_most=False, dimension="force", tension="raise",
    firm=_binds, pulls=True, of_runs=False, find_checks=_standard,
)  # fmt: skip


def _creep_limit(_: Number, state: State[Number]) -> Number:
    return state.creep_limit


def _creep(of: Spot) -> CheckText:
    """Of the creep at the exit."""
    limit = of.state.creep_limit
    return CheckText(
        title="Creep",
        noun="creep",
        source="conservative limit, 1/4 in; B. DeVries, A model of lagging friction"
        if limit == CREEP_LIMIT
        else "input",
        label="creep",
        headline="Creep {value} exceeds the {limit} limit",
        fails="Creep {creep} exceeds the {slides} gross-slip limit",
        full=_allowance(of.drive, limit),
        more={
            "creep": Amount(of.state.found.get("exit_creep", math.nan), "length"),
            "slides": Amount(SLIDES, "length"),
            "fabric": Amount(LARGER_CREEP["fabric"], "force_per_width"),
            "allowed": Amount(2.0 * CREEP_LIMIT, "length"),
        },
    )


EXIT_CREEP = Rule(
    "creep", "the creep limit", fails_beyond=SLIDES,
    dimension="length", tension="raise", result="exit_creep", limit=_creep_limit,
    of_runs=False, text=_creep,
)  # fmt: skip


#: Of a law that does not say what its slip includes, on a belt with a cover.
COVER_UNKNOWN = "Unknown whether the tested slip includes the shear of the belt cover"


def _cover_creep(of: Spot) -> Iterator[Check]:
    """Check the creep with the cover of the belt in series, where the law may include its shear."""
    rule, title, noun = COVER_CREEP, "Creep with cover", "creep with cover"
    if of.result is None or of.result.arc.cover_left_out == 0.0:
        return
    if of.unknown:
        yield not_checked(rule.name, title, noun, of.place, why=of.unknown)
        return
    found = of.result.covered_creep
    text = CheckText(
        title=title,
        noun=noun,
        source="shear of the cover of the belt",
        label="creep with cover",
        headline="Creep {value} with belt cover shear exceeds the {limit} limit"
        if math.isfinite(found)
        else "Gross slip with belt cover in series",
        action="State the cover of the tested belt ([test_belt]).",
        full=f"{COVER_UNKNOWN}.",
    )
    yield rule.compare(abs(found), of.state.creep_limit, of.place, text)


COVER_CREEP = Rule(
    "cover_creep", "the creep limit, with the cover of the belt in series", dimension="length",
    tension="raise", binding=False, of_runs=False, find_checks=_cover_creep,
)  # fmt: skip


def creep_interval(of: Spot) -> Iterator[Check]:
    """Check the end of the interval that the uncertainty of a fitted law leaves of the creep."""
    if of.result is None:
        return
    fit = of.result.arc.fit
    if fit is not None and fit.knots and of.unknown:
        yield not_checked(CREEP_INTERVAL.name, INTERVAL, INTERVAL_NOUN, of.place, why=of.unknown)
        return
    ends = of.result.creep_interval
    if math.isnan(ends[0]):
        return
    most = largest(ends, abs)
    text = CheckText(
        title=INTERVAL,
        noun=INTERVAL_NOUN,
        source=tests_of(of.pulley),
        label="creep, 95 % bound",
        headline="Creep {value} (95 % bound) exceeds the {limit} limit"
        if math.isfinite(most)
        else "Gross slip is within the 95 % interval",
        action="Try testing more samples.",
        full="The bound is the end of the 95 % interval of the creep by the fitted friction law.",
    )
    yield CREEP_INTERVAL.compare(abs(most), of.state.creep_limit, of.place, text)


CREEP_INTERVAL = Rule(
    "creep_interval", "the creep limit, at the end of the interval of the law",
    dimension="length", tension="raise", binding=False, of_rows=False,
    of_runs=False, find_checks=creep_interval,
)  # fmt: skip
OF_GRIP = (DESIGN_STANDARD, EXIT_CREEP, COVER_CREEP, CREEP_INTERVAL)


def _allowance(drive: Drive, limit: float) -> str:
    """Say whether the belt may creep more than the customary limit."""
    belt = drive.belt
    if limit != CREEP_LIMIT:
        return ""
    least = LARGER_CREEP.get(belt.kind)
    steel, rating = belt.kind == "steel cord", belt.rating
    if least is None or (rating is None and not steel):
        return "Unknown whether this belt may creep more: belt.kind or belt.rating missing."
    strong = belt.breaking_strength or 0.0
    over = strong > least if steel else (rating or 0.0) > least * (1.0 + 1e-9)
    if over:
        return "DeVries allows {allowed} for this belt (creep_limit)."
    if steel and not strong:
        return "DeVries allows more for steel cord above ST1600; the strength is unknown."
    return (
        "This belt does not qualify for more, as steel cord above ST1600 and fabric above "
        "{fabric} do (B. DeVries)."
    )


def _bond_strength(of: At) -> float | None:
    return of.pulley.lagging.bond_strength


def _bond(of: Spot) -> CheckText:
    return replace(
        _stress(of, "bond_strength"),
        title="Bond shear stress",
        noun="bond shear stress",
        label="bond stress",
        headline="Bond shear stress {value} exceeds the strength {limit}",
        action="Use a lagging with bond strength {stress} or more.",
    )


BOND_STRESS = Rule(
    "bond_stress", "the bond strength of the lagging", dimension="pressure",
    result="peak_shear_stress", allowed=_bond_strength, text=_bond,
)  # fmt: skip


def _fatigue_limit(of: At) -> float | None:
    return of.pulley.lagging.fatigue_limit


def _fatigue(of: Spot) -> CheckText:
    text, speed, full = _stress(of, "fatigue_limit"), of.drive.belt.speed, ""
    more = dict(text.more)
    if speed is not None and of.result is not None:
        full = "The belt passes {passes} times an hour."
        pitch = of.result.arc.radius + of.result.arc.offset
        more["passes"] = Amount(turns_an_hour(speed, pitch), "number")
    return replace(
        text,
        title="Cyclic shear stress",
        noun="cyclic shear stress",
        label="fatigue",
        headline="Cyclic shear stress {value} exceeds the fatigue limit {limit}",
        action="Use a lagging with fatigue limit {stress} or more.",
        full=full,
        more=more,
    )


FATIGUE_STRESS = Rule(
    "fatigue_stress", "the fatigue limit of the lagging", dimension="pressure",
    result="peak_shear_stress", allowed=_fatigue_limit, of_runs=False, text=_fatigue,
)  # fmt: skip
OF_LAGGING = (BOND_STRESS, FATIGUE_STRESS)


def _stress(of: Spot, key: str) -> CheckText:
    """Of the shear stress of lagging and bond."""
    lagging, stress = of.pulley.lagging, of.state.found.get("peak_shear_stress", math.nan)
    return CheckText(
        title="",
        source=origin(lagging.source_of(key)),
        more={"stress": Amount(stress, "pressure", "up")},
        missing=f"lagging.{key}" if getattr(lagging, key) is None else "",
    )


def _slip_max(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.slip_max


def _slip(of: Spot) -> CheckText | None:
    if of.pulley.lagging.law.tested is None:
        return None
    slip = of.state.found.get("largest_slip", math.nan)
    return CheckText(
        title="Slip, tested range",
        noun="slip",
        source=tests_of(of.pulley),
        label="slip outside tests",
        headline="Slip {value} exceeds the tested {limit}",
        action="Test the lagging to {slip} slip.",
        full=EXTRAPOLATED,
        more={"slip": Amount(slip, "length", "up")},
    )


TESTED_SLIP = Rule(
    "tested_slip", "the maximum slip tested", dimension="length", tension="raise",
    result="largest_slip", allowed=_slip_max, text=_slip,
)  # fmt: skip


def _tested_speed(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.slip_speed


def _speed(of: Spot) -> CheckText | None:
    tested, title, noun = of.pulley.lagging.law.tested, "Slip speed, tested", "slip speed"
    if tested is None:
        return None
    if tested.slip_speed is None:
        missing = "law.slip_speed"
        return CheckText(title=title, noun=noun, missing=missing, show_value=True)
    speed = of.state.found.get("slip_speed", 0.0)
    if of.drive.belt.speed is None or math.isnan(speed):
        return CheckText(title=title, noun=noun, missing="belt.speed")
    return CheckText(
        title=title,
        noun=noun,
        source=tests_of(of.pulley),
        label="slip speed outside tests",
        headline="Slip speed {value} exceeds the tested {limit}",
        action="Test the lagging at {speed}.",
        full="How the friction changes with slip speed is unknown.",
        more={"speed": Amount(speed, "speed", "up")},
    )


TESTED_SLIP_SPEED = Rule(
    "tested_slip_speed", "the slip speed tested", dimension="speed", binding=False,
    result="slip_speed", allowed=_tested_speed, text=_speed,
)  # fmt: skip


def largest_slip(result: ArcResult) -> float:
    """Largest slip of the belt on the lagging along the arc [m]."""
    return float(np.abs(result.profile.slip).max())


def slip_speed(result: ArcResult) -> float:
    """Largest speed of the belt on the lagging along the arc [m/s]; nan without a belt speed."""
    arc, speed = result.arc, result.arc.belt_speed
    if speed is None:
        return math.nan
    pitch = arc.radius + arc.offset  # the shell turns v/pitch under the belt
    return speed * arc.radius / pitch * result.steepest_slip


def _balance(of: Spot) -> Iterator[Check]:
    """Check the energy balance of the solution: a miss is a fault of the program."""
    result = of.result
    if result is None or of.unknown or math.isnan(result.energy.identity_error):
        return
    error, arc = result.energy.identity_error, result.arc
    pull, g = result.effective_tension, result.entry_creep_ratio
    value = balance_miss(error, pull, g, arc.entry_tension, arc.compliance)
    text = CheckText(
        title="Energy balance",
        noun="energy balance error",
        source="tolerance of the program",
        label="internal error",
        headline="Energy balance error {value} exceeds {limit}",
        action=REPORT,
    )
    yield ENERGY_BALANCE.compare(value, BALANCE, of.place, text)


ENERGY_BALANCE = Rule(
    "balance", "the energy balance", missed=Level.FAULT, binding=False, of_rows=False,
    of_runs=False, find_checks=_balance,
)  # fmt: skip
OF_SLIP = (TESTED_SLIP, TESTED_SLIP_SPEED, ENERGY_BALANCE)
