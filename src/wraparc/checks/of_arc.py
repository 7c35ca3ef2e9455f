"""Checks of a solved arc: grip, standard, creep, lagging, tested slip, balance of the solution."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from wraparc.alike import largest
from wraparc.arc import ArcResult, Status
from wraparc.arc.grip import sliding
from wraparc.arc.result import MORE_FRICTION
from wraparc.arc.sliding import CREEP, MOST, NOT_CARRIED, SLIDES, TESTED, Sliding
from wraparc.arrays import Number
from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.design_standard import asked
from wraparc.checks.numbers import asked_slack, balance_miss, steepest
from wraparc.checks.of_drive import MORE_CREEP, tests_of
from wraparc.checks.rule import At, Rule, Spot, State, Words, idle, not_checked, origin
from wraparc.drive import CREEP_LIMIT, Criteria, Drive, LoadCase, TakeUp
from wraparc.drive.pitch import turns_an_hour
from wraparc.drive.pull import idles
from wraparc.units import Dimension

#: Largest miss of the energy balance that a solution is trusted with [-]; the usual mesh misses by
#: 1.4e-5 at 0.8 m of creep, and by less than 1e-7 at creeps that a drive has.
BALANCE = 1e-4
#: Title of the check of the interval that a fitted law leaves.
INTERVAL = "Creep at exit, end of the 95 % interval of the law"
OWN_FACTORS = "taken where the drive file says nothing"
#: What helps against slip, with more tension and without.
MORE_GRIP = f"Raise the slack-side tension, enlarge the wrap angle, or {MORE_FRICTION}"
NO_TENSION = f"No slack-side tension is enough: enlarge the wrap angle, or {MORE_FRICTION}"
GRIP = "Safety against gross slip, {}"
#: Where gross slip cannot be avoided, whatever its safety factor.
NO_GRIP = Level.FAILS
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


def grip(drive: Drive, case: LoadCase, arcs: Sequence[ArcResult], index: int) -> Check:
    """Check whether an arc carries its load, and with which factor in hand."""
    result = arcs[index]
    name = GROSS_SLIP.name
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
    return of_sliding(drive, case, result, sliding(result))


def of_sliding(drive: Drive, case: LoadCase, result: ArcResult, found: Sliding) -> Check:
    """Return the check of the pull at which the belt slides, by what comes first there."""
    safety, take_up, lagging = drive.criteria.safety, drive.criteria.take_up, result.arc.pulley
    rule, factor, gone = GROSS_SLIP, safety.of(case.kind), not result.status.solved
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
    words = Words(
        title=title,
        source=f"safety factor {case.kind}: {safety.source or OWN_FACTORS}",
        short="pull beyond tests" if found.cause == TESTED else "near gross slip",
        says=says,
        because="So it slides.",
        remedy=MORE_GRIP,
        otherwise=NO_TENSION,
        more={"slides": (SLIDES, "length")},
    )
    value = min(found.place, NOT_CARRIED) if gone else found.place
    check = rule.judged(value, factor, place, words)
    if not gone:
        return check
    says = f"Gross slip: no creep carries the pull. {says}"
    return replace(check, level=NO_GRIP, says=says, short="gross slip", miss=None)


GROSS_SLIP = Rule(
    "gross_slip", "the safety against gross slip", at_most=False, fails_beyond=1.0,
    tension="raise",
)  # fmt: skip


def held_words(take_up: TakeUp) -> str:
    """Return what a take-up holds, in words."""
    if take_up.fixed:
        return "T1 + T2 held (fixed take-up)"
    where = f"tension behind pulley {take_up.after}" if take_up.after else "T2"
    return f"{escaped(where)} held (gravity take-up)"


def _standard(of: Spot) -> Iterator[Check]:
    """Check the slack side against the design standard, where one is asked for."""
    criteria, pulley = of.drive.criteria, of.pulley
    found = asked(criteria.standard, criteria.take_up, pulley.lagging, pulley.wrap_angle)
    tensions, rule = of.case.tensions[pulley.name], DESIGN_STANDARD.held(of.drive)
    if found is None or idles(tensions.entry, tensions.exit):
        return
    if math.isnan(found.wrap_factor):
        title = f"Slack side by {found.rule}"
        if not criteria.standard.name:
            yield not_checked(rule.name, title, found.why_not, of.place)
            return
        yield Check(
            name=rule.name,
            title=title,
            level=rule.missed,
            place=of.place,
            short="standard not applicable",
            says=escaped(f"{found.rule} was chosen and cannot be applied: {found.why_not}."),
            remedy="Give what it asks for, or choose another design standard.",
            binding=rule.binding,
        )
        return
    chosen = "" if criteria.standard.name else " No standard was chosen: CEMA was taken."
    start, (name, _, how) = "", found.rule.partition(", ")
    if criteria.standard.start_factor != 1.0 and of.case.kind == "running":
        start = f" at {criteria.standard.start_factor:g} times the pull"
    limit = design_slack(of, found.wrap_factor)
    words = Words(
        title=f"Slack side by {found.rule}",
        source=found.source,
        short="below standard",
        says=f"Slack side {{value}} is below the {{limit}} of {name}; {how}{start}.{chosen}",
        remedy="Raise the slack-side tension, or choose the design standard.",
        otherwise="Choose the design standard.",
    )
    yield rule.judged(of.state.slack, limit, of.place, words)


def design_slack(of: At, factor: float) -> float:
    """Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]."""
    start = start_factor(of.drive.criteria, of.case.kind)
    return asked_slack(factor, start, of.case.tensions[of.pulley.name].effective)


def start_factor(criteria: Criteria, kind: str) -> float:
    """Pull that the design standard is applied to over that of a load case [-]."""
    return criteria.standard.start_factor if kind == "running" else 1.0


def _binds(drive: Drive) -> bool:
    return drive.criteria.standard.binding


DESIGN_STANDARD = Rule(
    "design_standard", "the design standard", at_most=False, dimension="force", tension="raise",
    firm=_binds, pulls=True, of_runs=False, asked=_standard,
)  # fmt: skip


def _creep_limit(_: Number, state: State[Number]) -> Number:
    return state.creep_limit


def _creeps(of: Spot) -> Words:
    """Of the creep at the exit."""
    limit = of.state.creep_limit
    return Words(
        title="Creep at exit",
        source="conservative limit, 1/4 in; B. DeVries, A model of lagging friction"
        if limit == CREEP_LIMIT
        else "given",
        short="over creep limit",
        more={
            "fabric": (MORE_CREEP["fabric"], "force_per_width"),
            "slides": (SLIDES, "length"),
            "allowed": (EXIT_CREEP.tolerates, "length"),
        },
        says="Creeps {value}, more than the limit of {limit}.",
        allows=_qualifies(of.drive, limit),
        because="A belt that creeps more than {slides} slides.",
        remedy=MORE_GRIP,
        otherwise=NO_TENSION,
    )


EXIT_CREEP = Rule(
    "creep", "the creep limit", fails_beyond=SLIDES, tolerates=2.0 * CREEP_LIMIT,
    dimension="length", tension="raise", result="exit_creep", limit=_creep_limit,
    of_runs=False, words=_creeps,
)  # fmt: skip
#: Of a law that does not say what its slip includes, on a belt with a cover.
COVER_UNKNOWN = "Whether the tested slip includes the shear of the belt cover is not known"


def _cover_creep(of: Spot) -> Iterator[Check]:
    """Check the creep with the cover of the belt in series, where the law may include its shear."""
    rule, title = COVER_CREEP, "Creep at exit, with the cover of the belt in series"
    if of.result is None or of.result.arc.cover_left_out == 0.0:
        return
    if of.unknown:
        yield not_checked(rule.name, title, of.unknown, of.place)
        return
    found = of.result.covered_creep
    told = "the creep is {value}" if math.isfinite(found) else "the belt slips through"
    words = Words(
        title=title,
        source="shear of the cover of the belt",
        short="limit within belt cover",
        says=f"{COVER_UNKNOWN}: with the cover in series {told}, beyond the limit of {{limit}}.",
        remedy="State the cover of the test belt with the shear tests, or raise the slack-side "
        "tension.",
        otherwise="State the cover of the test belt with the shear tests.",
    )
    yield rule.judged(abs(found), of.state.creep_limit, of.place, words)


COVER_CREEP = Rule(
    "cover_creep", "the creep limit, with the cover of the belt in series", dimension="length",
    tension="raise", binding=False, of_runs=False, asked=_cover_creep,
)  # fmt: skip


def creep_interval(of: Spot) -> Iterator[Check]:
    """Check the end of the interval that the uncertainty of a fitted law leaves of the creep."""
    if of.result is None:
        return
    fit = of.result.arc.fit
    if fit is not None and fit.knots and of.unknown:
        yield not_checked(CREEP_INTERVAL.name, INTERVAL, of.unknown, of.place)
        return
    ends = of.result.creep_interval
    if math.isnan(ends[0]):
        return
    most = largest(ends, abs)
    told = "reaches {value}" if math.isfinite(most) else "reaches gross slip"
    words = Words(
        title=INTERVAL,
        source=tests_of(of.pulley),
        short="limit within uncertainty",
        says=f"By the uncertainty of the friction law the creep {told}, beyond {{limit}}; that is "
        "the end of its 95 % interval.",
        remedy="Raise the slack-side tension, or test more samples of the lagging.",
        otherwise="Test more samples of the lagging.",
    )
    yield CREEP_INTERVAL.judged(abs(most), of.state.creep_limit, of.place, words)


CREEP_INTERVAL = Rule(
    "creep_interval", "the creep limit, at the end of the interval of the law",
    dimension="length", tension="raise", binding=False, of_rows=False,
    of_runs=False, asked=creep_interval,
)  # fmt: skip
OF_GRIP = (DESIGN_STANDARD, EXIT_CREEP, COVER_CREEP, CREEP_INTERVAL)


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


def _bond_strength(of: At) -> float | None:
    return of.pulley.lagging.bond_strength


def _bond(of: Spot) -> Words:
    title = "Shear stress of lagging and bond, steady"
    if of.place.event:
        title = "Largest shear stress of lagging and bond"
    says = "The shear stress of lagging and bond, {value}, is above their {limit}."
    return _of_stress(of, "bond_strength", title, "bond overstressed", says)


BOND_STRESS = Rule(
    "bond_stress", "the bond strength of the lagging", dimension="pressure",
    result="peak_shear_stress", allowed=_bond_strength, words=_bond,
)  # fmt: skip


def _fatigue_limit(of: At) -> float | None:
    return of.pulley.lagging.fatigue_limit


def _tires(of: Spot) -> Words:
    often, speed, more = "", of.drive.belt.speed, dict[str, tuple[float, Dimension]]()
    if speed is not None and of.result is not None:
        often = "; the belt passes {passes} times an hour"
        pitch = of.result.arc.radius + of.result.arc.offset
        more["passes"] = turns_an_hour(speed, pitch), "number"
    title = "Shear stress of lagging and bond, at every pass"
    says = "At every pass the shear stress reaches {value}, above the fatigue limit {limit}"
    found = _of_stress(of, "fatigue_limit", title, "lagging tires", f"{says}{often}.")
    return replace(found, more=more)


FATIGUE_STRESS = Rule(
    "fatigue_stress", "the fatigue limit of the lagging", dimension="pressure",
    result="peak_shear_stress", allowed=_fatigue_limit, of_runs=False, words=_tires,
)  # fmt: skip
OF_LAGGING = (BOND_STRESS, FATIGUE_STRESS)


def _of_stress(of: Spot, key: str, title: str, short: str, says: str) -> Words:
    lagging = of.pulley.lagging
    if getattr(lagging, key) is None:
        why = f"the {key.replace('_', ' ')} of lagging {lagging.name} is not given"
        return Words(title=title, missing=why)
    return Words(
        title=title,
        source=origin(lagging.source_of(key)),
        short=short,
        says=says,
        remedy="Choose a lagging with a stronger bond, a larger pulley, or less pull.",
    )


def _slip_max(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.slip_max


def _slips(of: Spot) -> Words | None:
    if of.pulley.lagging.law.tested is None:
        return None
    return Words(
        title="Largest slip, tested",
        source=tests_of(of.pulley),
        short="slip beyond tests",
        says="The slip {value} is beyond the {limit} that lagging "
        f"{escaped(of.pulley.lagging.name)} was tested to: there the friction is an extrapolation.",
        remedy="Raise the slack-side tension, or test the lagging to this slip.",
        otherwise="Test the lagging to this slip.",
    )


TESTED_SLIP = Rule(
    "tested_slip", "the largest slip tested", dimension="length", tension="raise",
    result="largest_slip", allowed=_slip_max, words=_slips,
)  # fmt: skip


def _tested_speed(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.slip_speed


def _slips_fast(of: Spot) -> Words | None:
    tested, title = of.pulley.lagging.law.tested, "Slip speed, tested"
    if tested is None:
        return None
    if tested.slip_speed is None:
        why = "the friction law does not say at which speed it was tested"
        return Words(title=title, missing=why, told=True)
    if of.drive.belt.speed is None or math.isnan(of.state.found.get("slip_speed", 0.0)):
        return Words(title=title, missing="the belt speed is not given")
    return Words(
        title=title,
        source=tests_of(of.pulley),
        short="slips faster than tests",
        says="The belt slips at up to {value}, lagging "
        f"{escaped(of.pulley.lagging.name)} was tested at {{limit}}: how its friction changes "
        "with speed is not known.",
        remedy="Test the lagging at this speed, or keep a larger safety factor.",
    )


TESTED_SLIP_SPEED = Rule(
    "tested_slip_speed", "the slip speed tested", dimension="speed", binding=False,
    result="slip_speed", allowed=_tested_speed, words=_slips_fast,
)  # fmt: skip


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


def _balance(of: Spot) -> Iterator[Check]:
    """Check the energy balance of the solution: a miss is a fault of the program."""
    result = of.result
    if result is None or of.unknown or math.isnan(result.energy.identity_error):
        return
    error, arc = result.energy.identity_error, result.arc
    pull, g = result.effective_tension, result.entry_creep_ratio
    value = balance_miss(error, pull, g, arc.entry_tension, arc.compliance)
    words = Words(
        title="Energy balance of the solution",
        source="tolerance of the program",
        short="out of balance",
        says="The energy balance of the solution misses by {value}, more than {limit}.",
        remedy="Please report the drive file; until then change a value slightly.",
    )
    yield ENERGY_BALANCE.judged(value, BALANCE, of.place, words)


ENERGY_BALANCE = Rule(
    "balance", "the energy balance", missed=Level.FAULT, binding=False, of_rows=False,
    of_runs=False, asked=_balance,
)  # fmt: skip
OF_SLIP = (TESTED_SLIP, TESTED_SLIP_SPEED, ENERGY_BALANCE)
