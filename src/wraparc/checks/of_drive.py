"""Checks of a description that need no solving: belt, pulley face, take-up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from wraparc.alike import falling
from wraparc.arrays import Number
from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.numbers import (
    COVERS_APART,
    LEAST_SHIFT,
    held_alike,
    same_shown,
    trim_shift,
)
from wraparc.checks.rule import At, Rule, Spot, State, Words, origin
from wraparc.drive import Belt, Drive, LoadCase, Pulley
from wraparc.drive.pitch import pitch_offset
from wraparc.drive.pull import idles
from wraparc.drive.usual_sizes import USUAL_STRENGTH

#: Part by which tensions of neighbouring pulleys may differ: rounding of what was typed [-].
MEETS = 0.02
#: What the effect of a belt's thickness needs.
COVERS = "Give the pulley cover, carry cover and carcass of the belt."
#: Belts that may creep more than the customary limit, by carcass: rating above which [N/m].
MORE_CREEP = {"steel cord": 1600e3, "fabric": 140e3}
#: Breaking strength over the largest tension that is customary, by carcass, where no rating says
#: it: 15 % of the strength of steel cord, 8 of fabric; and the least of any belt [-].
CUSTOMARY_SAFETY, WEAKEST = {"steel cord": 1.0 / 0.15, "fabric": 8.0}, 3.0
#: Strength over rating of any belt, at least: a rating that leaves less is not one to rely on [-].
LEAST_RATED = USUAL_STRENGTH[0]
NO_RATING = "the rating of the belt is not given"


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
    why = f"{{layer}} of belt on drums of two diameters shifts it by {{shift}} % against {first}."
    if opposite:
        why = (
            f"it meets the other side of the belt than {first}, and covers that differ by "
            "{apart} shift it by {shift} %."
        )
    return Check(
        name=BELT_THICKNESS.name,
        title="Trim by the thickness of the belt",
        level=BELT_THICKNESS.missed,
        place=place,
        short="trim without belt thickness",
        says=f"The trim of {escaped(place.pulley)} is that of a belt without thickness: {why}",
        remedy=COVERS,
        more={
            "shift": (100.0 * shift, "number"),
            "apart" if opposite else "layer": (COVERS_APART if opposite else 10e-3, "length"),
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


def _running(of: Spot) -> Words | None:
    return _of_tension(of, "Belt tension, running") if of.case.kind == "running" else None


def _momentary(of: Spot) -> Words | None:
    return _of_tension(of, "Belt tension, momentary") if of.case.kind != "running" else None


def _of_tension(of: Spot, title: str) -> Words:
    belt, momentary = of.drive.belt, of.case.kind != "running"
    if belt.rating is None:
        return Words(title=title, missing=NO_RATING)
    factor = tension_factor(belt, of.case.kind)
    said = f"its rating times {factor:g}" if factor != 1.0 else "its rating"
    remedy = "Lower the slack-side tension as far as the other checks allow, or take a wider or "
    remedy, otherwise = f"{remedy}stronger belt.", "Take a wider or stronger belt."
    if momentary and belt.momentary_factor is None:
        remedy = (
            "Give the momentary factor of the belt if the maker allows more while starting and "
            "braking; else take a stronger belt."
        )
        otherwise = ""
    return Words(
        title=title,
        source=f"rating of the belt{f' times {factor:g}' if factor != 1.0 else ''}: "
        f"{origin(belt.sources.get('rating', belt.provenance))}",
        short="over belt rating",
        says=f"The belt tension {{value}} is more than {said} allows, {{limit}}; it is {{share}} % "
        "of the rating.",
        remedy=remedy,
        otherwise=otherwise,
        more={"share": (100.0 * of.state.tight / (belt.rating * belt.width), "number")},
    )


BELT_TENSION = Rule(
    "belt_tension", "the rating of the belt", missed=Level.FAILS, dimension="force",
    tension="lower", value=_tight, allowed=_running_tension, limit=_over_width, of_runs=False,
    words=_running,
)  # fmt: skip
MOMENTARY_TENSION = Rule(
    "momentary_tension", "the momentary rating of the belt", missed=Level.FAILS, dimension="force",
    tension="lower", value=_tight, allowed=_momentary_tension, limit=_over_width, of_runs=False,
    words=_momentary,
)  # fmt: skip


def asked_safety(belt: Belt, kind: str) -> float:
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


def _asked_safety(of: At) -> float:
    return asked_safety(of.drive.belt, of.case.kind)


def _rated(drive: Drive) -> bool:
    return rated(drive.belt)


def _safety(of: Spot) -> Words:
    """Against what the rating leaves, as its maker asks, or what is customary without one."""
    belt, momentary, factor = of.drive.belt, of.case.kind != "running", ""
    title = f"Safety factor of the belt, {'momentary' if momentary else 'running'}"
    if belt.breaking_strength is None:
        return Words(title=title, missing="the strength of the belt is not given")
    if math.isnan(asked_safety(belt, of.case.kind)):
        why = "neither rating nor kind of the belt tells what it is to be"
        return Words(title=title, missing=why)
    if momentary and belt.momentary_factor is not None:
        factor = f" over momentary_factor, {belt.momentary_factor:g}"
    source = f"customary for {belt.kind}, by works that follow DIN 22101{factor}"
    if belt.kind not in CUSTOMARY_SAFETY:
        source = f"the least that any belt is rated with{factor}"
    if rated(belt):
        source = f"strength over rating of the belt{factor}: {origin(belt.source_of('rating'))}"
    return Words(
        title=title,
        source=source,
        short="belt safety factor",
        says="The strength of the belt is {value} times its tension, below {limit} times.",
        because="No belt is rated at more than a third of its strength.",
        remedy="Lower the slack-side tension as far as the other checks allow, or take a wider or "
        "stronger belt.",
        otherwise="Take a wider or stronger belt.",
    )


BELT_SAFETY = Rule(
    "belt_safety", "the safety factor of the belt", at_most=False, fails_beyond=WEAKEST,
    tension="lower", firm=_rated, value=_belt_safety, allowed=_asked_safety,
    rounded=_rounded_safety, of_runs=False, words=_safety,
)  # fmt: skip


def _face_pressure(of: At) -> float | None:
    return of.drive.belt.largest_wrap_pressure


def _on_face(of: Spot) -> Words:
    belt, title = of.drive.belt, "Pressure on the pulley face"
    if belt.largest_wrap_pressure is None:
        return Words(title=title, missing="the largest wrap pressure of the belt is not given")
    return Words(
        title=title,
        source=origin(belt.sources.get("largest_wrap_pressure", belt.provenance)),
        short="face pressure",
        says="The belt presses on the pulley face with {value}, more than {limit}.",
        remedy="Take a larger or wider pulley, or less tension.",
        otherwise="Take a larger or wider pulley.",
    )


FACE_PRESSURE = Rule(
    "face_pressure", "the pressure on the pulley face", dimension="pressure", tension="lower",
    value=_tight_pressure, allowed=_face_pressure, words=_on_face,
)  # fmt: skip
#: What the belt must bear at a pulley.
OF_BELT = (BELT_TENSION, MOMENTARY_TENSION, BELT_SAFETY, FACE_PRESSURE)


def _pressure_max(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.pressure_max


def _pressure_min(of: At) -> float | None:
    tested = of.pulley.lagging.law.tested
    return None if tested is None else tested.pressure_min


def _tested_max(of: Spot) -> Words:
    if of.pulley.lagging.law.tested is None:  # of both ends, once
        why = "the friction law states no tests"
        return Words(title="Wrap pressure within the tests", missing=why)
    otherwise = "Take a larger or wider pulley, or test the lagging at this pressure."
    return _of_pressure(of, "Largest", "above", "Lower the tension, t", otherwise)


def _tested_min(of: Spot) -> Words | None:
    if of.pulley.lagging.law.tested is None:
        return None
    otherwise = "Test the lagging at this pressure."
    return _of_pressure(of, "Least", "below", "Raise the slack-side tension, or t", otherwise)


def _of_pressure(of: Spot, end: str, beyond: str, tension: str, otherwise: str) -> Words:
    return Words(
        title=f"{end} wrap pressure, tested",
        source=tests_of(of.pulley),
        short=f"pressure {beyond} tests",
        says=f"The wrap pressure {{value}} is {beyond} the {{limit}} tested on lagging "
        f"{escaped(of.pulley.lagging.name)}: there the friction is an extrapolation.",
        remedy=f"{tension}{otherwise[1:]}",
        otherwise=otherwise,
    )


PRESSURE_MAX = Rule(
    "tested_pressure_max", "the largest wrap pressure tested", dimension="pressure",
    tension="lower", value=_tight_pressure, allowed=_pressure_max, words=_tested_max,
)  # fmt: skip
PRESSURE_MIN = Rule(
    "tested_pressure_min", "the least wrap pressure tested", at_most=False, dimension="pressure",
    tension="raise", value=_slack_pressure, allowed=_pressure_min, words=_tested_min,
)  # fmt: skip
OF_TESTS = (PRESSURE_MAX, PRESSURE_MIN)


def _diameter(state: State[Number]) -> Number:
    return state.diameter


def _least_diameter(of: At) -> float | None:
    return of.drive.belt.least_pulley_diameter


def _bends(of: Spot) -> Words:
    """Of a pulley, in all load cases."""
    belt, title, pulley = of.drive.belt, "Pulley diameter, least for the belt", of.pulley
    ends = [case.tensions[pulley.name] for case in of.drive.load_cases]
    if belt.least_pulley_diameter is None:
        return Words(title=title, missing="the least pulley of the belt is not given")
    if all(idles(at.entry, at.exit) for at in ends):
        why = "that of the belt is the least drive pulley, and this one pulls nothing"
        return Words(title=title, missing=why)
    return Words(
        title=title,
        source=origin(belt.sources.get("least_pulley_diameter", belt.provenance)),
        short="pulley too small",
        says=f"Pulley {escaped(pulley.name)}, {{value}}, is smaller than the least for its "
        "belt, {limit}.",
    )


PULLEY_DIAMETER = Rule(
    "pulley_diameter", "the least pulley of the belt", missed=Level.FAILS, at_most=False,
    dimension="length", value=_diameter, allowed=_least_diameter, pulls=True, words=_bends,
)  # fmt: skip


def _slack_end(state: State[Number]) -> Number:
    return state.slack_end


def _sag_tension(of: At) -> float | None:
    return None if of.drive.criteria.sag is None else of.drive.criteria.sag.tension


def _sags(of: Spot) -> Words | None:
    """Of the pulley where the belt leaves the drives slack."""
    title, limits = "Slack-side tension, for sag", of.drive.criteria.sag
    if math.isnan(of.state.slack_end):
        return None
    if limits is None:
        return Words(title=title, missing="idler spacing and mass are not given")
    return Words(
        title=title,
        source=limits.SOURCE,
        short="sags",
        says=f"The slack side, {{value}}, sags more than {100.0 * limits.share:g} % of the idler "
        "spacing; that takes {limit}.",
        remedy="Raise the slack-side tension, or set the idlers closer.",
        otherwise="Set the idlers closer.",
    )


SAG = Rule(
    "sag", "the sag of the belt", at_most=False, dimension="force", tension="raise",
    value=_slack_end, allowed=_sag_tension, words=_sags,
)  # fmt: skip
#: What a belt that nowhere hangs slack asks for; the take-up of a conveyor is held to it.
TAUT = Rule("taut", "a belt that nowhere hangs slack", at_most=False, of_rows=False)


def take_up(drive: Drive) -> Iterator[Check]:
    """Ask for attention where the tensions contradict the take-up that the drive file names."""
    kind = drive.criteria.take_up.kind
    if not kind or drive.conveyor is not None:
        return
    fixed = drive.criteria.take_up.fixed
    held = {}
    for case in drive.load_cases:
        first, last = (case.tensions[p.name] for p in (drive.pulleys[0], drive.pulleys[-1]))
        held[case.name] = first.entry + last.exit if fixed else drive.take_up_tension(case)
    ordered = falling(held, lambda name: held[name])
    high, low = ordered[0], ordered[-1]
    if held_alike(held[low], held[high]):
        return
    place = escaped(drive.take_up_place.removeprefix("at the take-up "))
    what = f"the tension {place}" if place else "the slack-side tension"
    what = "the sum of both tensions" if fixed else what
    other = "" if fixed or drive.criteria.take_up.after else _steady(drive)
    where = f", or say that it stands after pulley {other}" if other else ""
    yield Check(
        name="take_up",
        title="Tensions that the take-up holds",
        level=Level.ATTENTION,
        source=f"take-up {kind}, as given",
        short="contradicts take-up",
        says=f"A {kind} take-up holds {what} at one value: it is {{least}} in load case "
        f"{escaped(low)} and {{most}} in load case {escaped(high)}.",
        remedy=f"Correct the tensions, or the kind of the take-up{escaped(where)}.",
        more={"least": (held[low], "force"), "most": (held[high], "force")},
        binding=False,
    )


def _steady(drive: Drive) -> str:
    """Return the pulley behind which the belt has the same tension in every load case, or none."""
    for pulley in drive.pulleys:
        behind = [case.tensions[pulley.name].exit for case in drive.load_cases]
        if held_alike(min(behind), max(behind)):
            return pulley.name
    return ""


def sense(case: LoadCase, pulley: Pulley) -> Check:
    """Return what the verdict says of a pulley that brakes, or pulls nothing where it should."""
    tensions = case.tensions[pulley.name]
    none = idles(tensions.entry, tensions.exit)
    told = "pulls nothing (T1 = T2)" if none else "brakes (T1 < T2)"
    return Check(
        name="sense",
        title=f"Pulley {pulley.name} {told}",
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
        title="Tensions of neighbouring pulleys meet",
        level=Level.ATTENTION,
        place=place,
        short="tensions do not meet",
        says=f"The belt leaves pulley {escaped(before)} with {{leaves}} and enters pulley "
        f"{escaped(after)} with {{enters}}: taken as what the run between them adds.",
        remedy="If none does, correct the tensions or the order of the pulleys; if one does, give "
        f"what the run before pulley {escaped(after)} adds.",
        more={"leaves": (leaves, "force"), "enters": (enters, "force")},
        binding=False,
    )


def tests_of(pulley: Pulley) -> str:
    """Return where the tested range of a lagging came from."""
    return f"tests of lagging {pulley.lagging.name}: {origin(pulley.lagging.source_of('law'))}"
