"""Checks of a description that need no solving: belt, pulley face, take-up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from wraparc.alike import falling
from wraparc.arrays import Number
from wraparc.checks.check import Amount, Check, Level, Place, escaped
from wraparc.checks.numbers import (
    COVERS_APART,
    LEAST_SHIFT,
    has_equal_tension,
    same_shown,
    trim_shift,
)
from wraparc.checks.rule import At, CheckText, Rule, Spot, State, not_checked, origin
from wraparc.drive import Belt, Drive, LoadCase, Pulley
from wraparc.drive.pitch import pitch_offset
from wraparc.drive.pull import idles
from wraparc.drive.usual_sizes import USUAL_STRENGTH

#: Part by which tensions of neighbouring pulleys may differ: rounding of what was typed [-].
MEETS = 0.02
#: What the effect of a belt's thickness needs.
LAYERS = "Give pulley_cover, carry_cover and carcass"
#: Belts that may creep more than the customary limit, by carcass: rating above which [N/m].
LARGER_CREEP = {"steel cord": 1600e3, "fabric": 140e3}
#: Breaking strength over the largest tension that is customary, by carcass, where no rating says
#: it: 15 % of the strength of steel cord, 8 of fabric; and the least of any belt [-].
CUSTOMARY_SAFETY, WEAKEST = {"steel cord": 1.0 / 0.15, "fabric": 8.0}, 3.0
#: Strength over rating of any belt, at least: a rating that leaves less is not one to rely on [-].
LEAST_RATED = USUAL_STRENGTH[0]
NO_RATING = "belt.rating"


def unknown_trims(belt: Belt, pulleys: Sequence[Pulley], at: Place) -> Iterator[Check]:
    """Yield what no trim between drums is known without: the thickness of the belt.

    Parameters
    ----------
    belt, pulleys
        Of the train; those that are driven.
    at
        Load case or event.
    """
    for pulley in pulleys[1:]:
        first = pulleys[0]
        shift = open_shift(belt, first, pulley)
        if shift > 0.0:
            place, opposite = at._replace(pulley=pulley.name), pulley.side != first.side
            yield unknown_trim(first.name, shift, opposite, place)


def open_shift(belt: Belt, first: Pulley, other: Pulley) -> float:
    """Return how far the trim between two drums is open without the thickness of the belt [-]."""
    if all(pitch_offset(belt, pulley.side) is not None for pulley in (first, other)):
        return 0.0
    shift = trim_shift(first.diameter, other.diameter, first.side != other.side)
    return shift if shift > LEAST_SHIFT else 0.0


def unknown_trim(first: str, shift: float, opposite: bool, place: Place) -> Check:
    """Ask for the thickness of a belt on drums that differ: so much of the trim is open [-]."""
    first = escaped(first)
    if opposite:
        why = (
            f"The belt turns its other side to {first}: covers that differ by {{apart}} were "
            "assumed."
        )
    else:
        why = f"{{layer}} of belt assumed: pulleys of two diameters, compared with {first}."
    return Check(
        name=BELT_THICKNESS.name,
        title="Trim, belt thickness",
        noun="trim",
        level=BELT_THICKNESS.missed,
        place=place,
        label="trim without belt thickness",
        headline="Speed trim uncertain by {shift} %: belt thickness missing",
        action=f"{LAYERS}.",
        full=why,
        more={
            "shift": Amount(100.0 * shift, "number"),
            "apart" if opposite else "layer": Amount(COVERS_APART if opposite else 10e-3, "length"),
        },
        binding=False,
    )


BELT_THICKNESS = Rule("belt_thickness", "a trim without the thickness of the belt", binding=False)


def _tight(state: State[Number]) -> Number:
    return state.tight


def _tight_pressure(state: State[Number]) -> Number:
    return wrap_pressure(state.tight, state)


def _slack_pressure(state: State[Number]) -> Number:
    return wrap_pressure(state.slack, state)


def wrap_pressure(tension: Number, state: State[Number]) -> Number:
    """Pressure of the belt on the pulley, 2 (T - m v^2)/(B D) [Pa]."""
    return 2.0 * (tension - state.centrifugal) / (state.width * state.diameter)


def _over_width(allowed: Number, state: State[Number]) -> Number:
    return allowed * state.width


def tension_factor(belt: Belt, kind: str) -> float:
    """Tension allowed in a kind of load case over the rating of the belt [-]."""
    return 1.0 if kind == "running" else belt.momentary_factor or 1.0


def allowed_tension(belt: Belt, kind: str) -> float | None:
    """Tension that a belt is allowed in a kind of load case [N/m]; None without a rating."""
    return None if belt.rating is None else tension_factor(belt, kind) * belt.rating


def tension_rule(kind: str) -> Rule:
    """Return the rule of the belt tension in a kind of load case."""
    return BELT_TENSION if kind == "running" else MOMENTARY_TENSION


def _running_tension(of: At) -> float | None:
    return allowed_tension(of.drive.belt, of.case.kind) if of.case.kind == "running" else None


def _momentary_tension(of: At) -> float | None:
    return allowed_tension(of.drive.belt, of.case.kind) if of.case.kind != "running" else None


def _running(of: Spot) -> CheckText | None:
    if of.case.kind != "running":
        return None
    return tension_text(of.drive.belt, of.case.kind, of.state.tight)


def _momentary(of: Spot) -> CheckText | None:
    if of.case.kind == "running":
        return None
    return tension_text(of.drive.belt, of.case.kind, of.state.tight)


def tension_text(belt: Belt, kind: str, tension: float) -> CheckText:
    """Return the texts of the check of a belt tension [N] in a kind of load case."""
    momentary, noun = kind != "running", "belt tension"
    title = "Belt tension, momentary" if momentary else "Belt tension, running"
    if belt.rating is None:
        return CheckText(title=title, noun=noun, missing=NO_RATING)
    factor = tension_factor(belt, kind)
    times = f" times {factor:g}" if factor != 1.0 else ""
    rated = belt.rating * belt.width
    action = "Use a belt rated {rated} (now {rating})."
    if momentary and belt.momentary_factor is None:
        action = (
            "Use a belt rated {rated}, or give momentary_factor {factor} if its maker allows it."
        )
    needed = tension / (belt.width * factor)
    return CheckText(
        title=title,
        noun=noun,
        source=f"rating of the belt{times}: {origin(belt.sources.get('rating', belt.provenance))}",
        label="belt tension",
        headline="Belt tension {value} exceeds the {limit} "
        + ("momentary rating" if momentary and factor != 1.0 else "rating"),
        action=action,
        full=f"{{share}} % of the rating{f', factor {factor:g}' if times else ''}.",
        more={
            "share": Amount(100.0 * tension / rated, "number"),
            "factor": Amount(tension / rated, "number", "up"),
            "rated": Amount(needed, "force_per_width", "up"),
            "rating": Amount(belt.rating, "force_per_width"),
        },
    )


BELT_TENSION = Rule(
    "belt_tension", "the rating of the belt", missed=Level.FAILS, dimension="force",
    tension="lower", value=_tight, allowed=_running_tension, limit=_over_width, of_runs=False,
    text=_running,
)  # fmt: skip
MOMENTARY_TENSION = Rule(
    "momentary_tension", "the momentary rating of the belt", missed=Level.FAILS, dimension="force",
    tension="lower", value=_tight, allowed=_momentary_tension, limit=_over_width, of_runs=False,
    text=_momentary,
)  # fmt: skip


def required_safety(belt: Belt, kind: str) -> float:
    """Breaking strength over tension that a belt is to have in a kind of load case [-].

    What its rating leaves, the demand of its maker; without one, or where it leaves less than any
    belt has, what is customary for its carcass; nan where its strength is not known, or neither of
    them. Never less than 1.
    """
    strength, rating = belt.breaking_strength, belt.rating
    if strength is None:
        return math.nan
    asked = CUSTOMARY_SAFETY.get(belt.kind, math.nan if rating is None else LEAST_RATED)
    if rating is not None and rated(belt):
        asked = strength / rating
    asked /= tension_factor(belt, kind)
    return max(asked, 1.0)


def rated(belt: Belt) -> bool:
    """Whether the rating of a belt leaves a safety factor to rely on."""
    strength, rating = belt.breaking_strength, belt.rating
    return strength is not None and rating is not None and strength >= LEAST_RATED * rating


def _belt_safety(state: State[Number]) -> Number:
    return state.strength * state.width / state.tight


def _rounded_safety(safety: float, asked: float, state: State[float]) -> float:
    """What is asked, where the tension leaves it in the four digits it is compared in."""
    allowed = state.strength * state.width / asked
    return asked if safety < asked and same_shown(state.tight, allowed) else safety


def _required_safety(of: At) -> float:
    return required_safety(of.drive.belt, of.case.kind)


def _rated(drive: Drive) -> bool:
    return rated(drive.belt)


def _safety(of: Spot) -> CheckText:
    """Against what the rating leaves, as its maker asks, or what is customary without one."""
    belt, momentary, factor = of.drive.belt, of.case.kind != "running", ""
    title, noun = "Belt safety factor", "belt safety factor"
    if belt.breaking_strength is None:
        return CheckText(title=title, noun=noun, missing="belt.strength")
    required = required_safety(belt, of.case.kind)
    if math.isnan(required):
        return CheckText(title=title, noun=noun, missing="belt.rating")
    if momentary and belt.momentary_factor is not None:
        factor = f" over momentary_factor, {belt.momentary_factor:g}"
    source = f"customary for {belt.kind}, by works that follow DIN 22101{factor}"
    if belt.kind not in CUSTOMARY_SAFETY:
        source = f"the minimum that any belt is rated with{factor}"
    if rated(belt):
        source = f"strength over rating of the belt{factor}: {origin(belt.source_of('rating'))}"
    needed = required * of.state.tight / belt.width
    return CheckText(
        title=title,
        noun=noun,
        source=source,
        label="belt safety factor",
        headline="Belt safety factor {value} is below the {limit} minimum",
        action="Use a belt of strength {strength} or more.",
        full="The minimum is strength over rating." if rated(belt) else "The minimum is customary.",
        more={"strength": Amount(needed, "force_per_width", "up")},
    )


BELT_SAFETY = Rule(
    "belt_safety", "the safety factor of the belt", at_most=False, fails_beyond=WEAKEST,
    tension="lower", firm=_rated, value=_belt_safety, allowed=_required_safety,
    rounded=_rounded_safety, of_runs=False, text=_safety,
)  # fmt: skip


def _face_pressure(of: At) -> float | None:
    return of.drive.belt.largest_wrap_pressure


def _on_face(of: Spot) -> CheckText:
    belt, title, noun = of.drive.belt, "Face pressure", "face pressure"
    if belt.largest_wrap_pressure is None:
        return CheckText(title=title, noun=noun, missing="belt.largest_wrap_pressure")
    return CheckText(
        title=title,
        noun=noun,
        source=origin(belt.sources.get("largest_wrap_pressure", belt.provenance)),
        label="face pressure",
        headline="Face pressure {value} exceeds the belt limit {limit}",
        action=LARGER_PULLEY,
        more=_diameter_for(of, belt.largest_wrap_pressure),
    )


#: What to do about a pressure, with the diameter that it takes.
LARGER_PULLEY = "Use pulley diameter {larger} (now {diameter})."


def _diameter_for(of: Spot, allowed: float) -> dict[str, Amount]:
    """Return the diameter that leaves an allowed pressure, rounded up, and the one there is."""
    pressure = wrap_pressure(of.state.tight, of.state)
    larger = of.state.diameter * pressure / allowed
    return {
        "larger": Amount(larger, "length", "up"),
        "diameter": Amount(of.state.diameter, "length"),
    }


FACE_PRESSURE = Rule(
    "face_pressure", "the pressure on the pulley face", dimension="pressure", tension="lower",
    value=_tight_pressure, allowed=_face_pressure, text=_on_face,
)  # fmt: skip
#: What the belt must bear at a pulley.
OF_BELT = (BELT_TENSION, MOMENTARY_TENSION, BELT_SAFETY, FACE_PRESSURE)


def _pressure_max(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.pressure_max


def _pressure_min(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.pressure_min


def _tested_max(of: Spot) -> CheckText:
    tested = of.pulley.lagging.law.tested
    title, noun = "Maximum wrap pressure", "maximum wrap pressure"
    if tested is None:  # of both ends, once
        return CheckText(title=title, noun="tested wrap pressure", why="friction without tests")
    return CheckText(
        title=title,
        noun=noun,
        source=tests_of(of.pulley),
        label="pressure above tests",
        headline="Wrap pressure {value} exceeds the tested {limit}",
        action=LARGER_PULLEY,
        full=EXTRAPOLATED,
        more=_diameter_for(of, tested.pressure_max),
    )


def _tested_min(of: Spot) -> CheckText | None:
    if of.pulley.lagging.law.tested is None:
        return None
    pressure = wrap_pressure(of.state.slack, of.state)
    return CheckText(
        title="Minimum wrap pressure",
        noun="minimum wrap pressure",
        source=tests_of(of.pulley),
        label="pressure below tests",
        headline="Wrap pressure {value} is below the tested {limit}",
        action="Test the lagging at {pressure}.",
        full=EXTRAPOLATED,
        more={"pressure": Amount(pressure, "pressure", "down")},
    )


#: What is true of friction outside its tests.
EXTRAPOLATED = "There the friction is extrapolated."
PRESSURE_MAX = Rule(
    "tested_pressure_max", "the maximum wrap pressure tested", dimension="pressure",
    tension="lower", value=_tight_pressure, allowed=_pressure_max, text=_tested_max,
)  # fmt: skip
PRESSURE_MIN = Rule(
    "tested_pressure_min", "the minimum wrap pressure tested", at_most=False, dimension="pressure",
    tension="raise", value=_slack_pressure, allowed=_pressure_min, text=_tested_min,
)  # fmt: skip
OF_TESTS = (PRESSURE_MAX, PRESSURE_MIN)


def _diameter(state: State[Number]) -> Number:
    return state.diameter


def _least_diameter(of: At) -> float | None:
    return of.drive.belt.least_pulley_diameter


def _bending(of: Spot) -> CheckText:
    """Of a pulley, in all load cases."""
    belt, title, pulley = of.drive.belt, "Pulley diameter", of.pulley
    noun, least = "pulley diameter", belt.least_pulley_diameter
    ends = [case.tensions[pulley.name] for case in of.drive.load_cases]
    if least is None:
        return CheckText(title=title, noun=noun, missing="belt.least_pulley_diameter")
    if all(idles(at.entry, at.exit) for at in ends):
        return CheckText(title=title, noun=noun, why=f"{pulley.name} is not driven")
    return CheckText(
        title=title,
        noun=noun,
        source=origin(belt.sources.get("least_pulley_diameter", belt.provenance)),
        label="pulley diameter",
        headline="Pulley diameter {value} is below the belt minimum {limit}",
        action="Use pulley diameter {limit} or more.",
    )


PULLEY_DIAMETER = Rule(
    "pulley_diameter", "the minimum pulley diameter of the belt", missed=Level.FAILS, at_most=False,
    dimension="length", value=_diameter, allowed=_least_diameter, pulls=True, text=_bending,
)  # fmt: skip


def _slack_end(state: State[Number]) -> Number:
    return state.slack_end


def _sag_tension(of: At) -> float | None:
    return None if of.drive.criteria.sag is None else of.drive.criteria.sag.tension


def _sag(of: Spot) -> CheckText | None:
    """Of the pulley where the belt leaves the drives slack."""
    title, limits = "T2 for sag", of.drive.criteria.sag
    if math.isnan(of.state.slack_end):
        return None
    if limits is None:
        return CheckText(title=title, noun="sag", missing="[sag]")
    return CheckText(
        title=title,
        noun="slack-side tension for sag",
        source=limits.SOURCE,
        label="sag",
        headline=f"Slack-side tension {{value}} is below the {{limit}} for "
        f"{100.0 * limits.share:g} % sag",
        action="Use idler spacing {spacing}.",
        more={
            "spacing": Amount(
                limits.spacing * of.state.slack_end / limits.tension, "length", "down"
            )
        },
    )


SAG = Rule(
    "sag", "the sag of the belt", at_most=False, dimension="force", tension="raise",
    value=_slack_end, allowed=_sag_tension, text=_sag,
)  # fmt: skip
#: The minimum take-up tension of a belt that nowhere hangs slack.
TAUT = Rule("taut", "a belt that nowhere hangs slack", at_most=False, of_rows=False)


def take_up(drive: Drive) -> Iterator[Check]:
    """Ask for attention where the tensions contradict the take-up that the drive file names."""
    kind = drive.criteria.take_up.kind
    if not kind or drive.conveyor is not None:
        return
    fixed = drive.criteria.take_up.fixed
    tensions = {}
    for case in drive.load_cases:
        first, last = (case.tensions[p.name] for p in (drive.pulleys[0], drive.pulleys[-1]))
        tensions[case.name] = first.entry + last.exit if fixed else drive.take_up_tension(case)
    ordered = falling(tensions, lambda name: tensions[name])
    high, low = ordered[0], ordered[-1]
    if has_equal_tension(tensions[low], tensions[high]):
        return
    after = drive.criteria.take_up.after
    what = f"tension behind {escaped(after)}" if after else "T2"
    what = "T1 + T2" if fixed else what
    other = "" if fixed or after else _steady(drive)
    named = [Place(load_case=name) for name in (low, high)]
    yield Check(
        name="take_up",
        title="Take-up tension",
        noun="take-up tension",
        level=Level.ATTENTION,
        source=f"take-up {kind}, input",
        label="take-up tension",
        headline=f"{kind.capitalize()} take-up needs equal {what}: {escaped(str(named[0]))} has "
        f"{{least}}, {escaped(str(named[1]))} has {{most}}",
        action=f"Set the same {what} in both, or correct take_up.kind or take_up.after.",
        full=f"Behind {escaped(other)} the tension is equal in every load case." if other else "",
        more={"least": Amount(tensions[low], "force"), "most": Amount(tensions[high], "force")},
        binding=False,
    )


def _steady(drive: Drive) -> str:
    """Return the pulley behind which the belt has the same tension in every load case, or none."""
    for pulley in drive.pulleys:
        behind = [case.tensions[pulley.name].exit for case in drive.load_cases]
        if has_equal_tension(min(behind), max(behind)):
            return pulley.name
    return ""


def sense(case: LoadCase, pulley: Pulley) -> Check:
    """Return what the verdict says of a pulley that brakes, or pulls nothing where it should."""
    tensions = case.tensions[pulley.name]
    none = idles(tensions.entry, tensions.exit)
    what = "transmits no tension" if none else "brakes"
    return Check(
        name="sense",
        title=f"{pulley.name} {what}",
        level=Level.OK,
        place=Place(pulley.name, case.name),
        binding=False,
    )


def meeting(before: str, leaves: float, after: str, enters: float, place: Place) -> Iterator[Check]:
    """Ask about neighbouring pulleys on one belt where it leaves one with another tension [N]."""
    if abs(leaves - enters) <= MEETS * max(leaves, enters):
        return
    yield Check(
        name="meeting",
        title="Tension between pulleys",
        noun="tension between pulleys",
        level=Level.ATTENTION,
        place=place,
        label="tensions differ",
        headline=f"Belt leaves {escaped(before)} at {{leaves}} but enters {escaped(after)} at "
        "{enters}",
        action=f"Let {escaped(after)} enter at {{leaves}}, or give [train] a run of {{rise}}.",
        more={
            "leaves": Amount(leaves, "force"),
            "enters": Amount(enters, "force"),
            "rise": Amount(enters - leaves, "force"),
        },
        binding=False,
    )


def tests_of(pulley: Pulley) -> str:
    """Return where the tested range of a lagging came from."""
    return f"tests of lagging {pulley.lagging.name}: {origin(pulley.lagging.source_of('law'))}"


def reserve(drive: Drive) -> Iterator[Check]:
    """Yield that the reserve is not checked, where an uncertainty is stated: `solve` finds it."""
    if drive.states_uncertainty:
        noun, why = "reserve", "wraparc solve checks stated uncertainties"
        yield not_checked("reserve", "Reserve", noun, Place(), why=why)
