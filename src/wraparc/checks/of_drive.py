"""Checks of a description that need no solving: belt, pulley face, take-up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from wraparc.alike import falling
from wraparc.checks.check import Check, Level, Miss, Place, escaped, keeps
from wraparc.checks.numbers import (
    COVERS_APART,
    LEAST_SHIFT,
    held_alike,
    idles,
    safety_of,
    trim_shift,
)
from wraparc.checks.rules import (
    CUSTOMARY_SAFETY,
    RULES,
    Rule,
    asked_safety,
    rated,
    tension_factor,
    tension_rule,
    wrap_pressure,
)
from wraparc.drive import Belt, Drive, LoadCase, Pulley
from wraparc.drive.pitch import centrifugal_of, pitch_offset
from wraparc.provenance import Provenance
from wraparc.units import Dimension

#: Part by which tensions of neighbouring pulleys may differ: rounding of what was typed [-].
MEETS = 0.02
#: What the effect of a belt's thickness needs.
COVERS = "Give the pulley cover, carry cover and carcass of the belt."
#: Belts that may creep more than the customary limit, by carcass: rating above which [N/m].
MORE_CREEP = {"steel cord": 1600e3, "fabric": 140e3}


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
        name="belt_thickness",
        title="Trim by the thickness of the belt",
        level=Level.ATTENTION,
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


def of_belt(drive: Drive, case: LoadCase, pulley: Pulley) -> Iterator[Check]:
    """Yield what the belt must bear at a pulley."""
    yield belt_tension(drive, case, pulley)
    yield belt_safety(drive, case, pulley)
    yield face_pressure(drive, case, pulley)


def belt_tension(drive: Drive, case: LoadCase, pulley: Pulley) -> Check:
    """Check the larger tension at a pulley against the rating, with the factor of the load case."""
    belt, tensions = drive.belt, case.tensions[pulley.name]
    momentary = case.kind != "running"
    title = "Belt tension, momentary" if momentary else "Belt tension, running"
    rule = tension_rule(case.kind)
    value = max(tensions.entry, tensions.exit)
    place = Place(pulley.name, case.name)
    if belt.rating is None:
        return not_checked(rule.name, title, "the rating of the belt is not given", place)
    factor = tension_factor(belt, case.kind)
    limit = factor * belt.rating * belt.width
    said = f"its rating times {factor:g}" if factor != 1.0 else "its rating"
    remedy = "Lower the slack-side tension as far as the other checks allow, or take a wider or "
    remedy, otherwise = f"{remedy}stronger belt.", "Take a wider or stronger belt."
    if momentary and belt.momentary_factor is None:
        remedy = (
            "Give the momentary factor of the belt if the maker allows more while starting and "
            "braking; else take a stronger belt."
        )
        otherwise = ""
    share = 100.0 * value / (belt.rating * belt.width)
    return judged(
        rule,
        title,
        value,
        limit,
        "force",
        source=f"rating of the belt{f' times {factor:g}' if factor != 1.0 else ''}: "
        f"{origin(belt.sources.get('rating', belt.provenance))}",
        short="over belt rating",
        says=f"The belt tension {{value}} is more than {said} allows, {{limit}}; it is {{share}} % "
        "of the rating.",
        remedy=remedy,
        otherwise=otherwise,
        more={"share": (share, "number")},
        place=place,
    )


def belt_safety(drive: Drive, case: LoadCase, pulley: Pulley) -> Check:
    """Check the strength of the belt over its larger tension at a pulley."""
    tensions = case.tensions[pulley.name]
    largest = max(tensions.entry, tensions.exit)
    return safety_factor(drive.belt, case.kind, largest, Place(pulley.name, case.name))


def safety_factor(belt: Belt, kind: str, tension: float, place: Place) -> Check:
    """Check the strength of a belt over a tension [N] in a kind of load case.

    Against what the rating leaves, as its maker asks, or what is customary without one, or where
    it leaves less than any belt has.
    """
    rule, momentary = RULES["belt_safety"], kind != "running"
    title = f"Safety factor of the belt, {'momentary' if momentary else 'running'}"
    strength, asked, factor = belt.breaking_strength, asked_safety(belt, kind), ""
    if strength is None:
        return not_checked(rule.name, title, "the strength of the belt is not given", place)
    if math.isnan(asked):
        why = "neither rating nor kind of the belt tells what it is to be"
        return not_checked(rule.name, title, why, place)
    if momentary and belt.momentary_factor is not None:
        factor = f" over momentary_factor, {belt.momentary_factor:g}"
    source = f"customary for {belt.kind}, by works that follow DIN 22101{factor}"
    if belt.kind not in CUSTOMARY_SAFETY:
        source = f"the least that any belt is rated with{factor}"
    if rated(belt):
        rule = replace(rule, missed=Level.FAILS)
        source = f"strength over rating of the belt{factor}: {origin(belt.source_of('rating'))}"
    return judged(
        rule,
        title,
        safety_of(strength * belt.width, tension, asked),
        asked,
        "number",
        source=source,
        short="belt safety factor",
        says="The strength of the belt is {value} times its tension, below {limit} times.",
        because="No belt is rated at more than a third of its strength.",
        remedy="Lower the slack-side tension as far as the other checks allow, or take a wider or "
        "stronger belt.",
        otherwise="Take a wider or stronger belt.",
        binding=rated(belt),
        place=place,
    )


def pulley_diameter(drive: Drive, pulley: Pulley) -> Check:
    """Check the diameter of a pulley against the least that its belt may bend over."""
    belt, title, why = drive.belt, "Pulley diameter, least for the belt", ""
    ends = [case.tensions[pulley.name] for case in drive.load_cases]
    least = belt.least_pulley_diameter
    if least is None:
        why = "the least pulley of the belt is not given"
    elif all(idles(at.entry, at.exit) for at in ends):
        why = "that of the belt is the least drive pulley, and this one pulls nothing"
    if why or least is None:
        return not_checked("pulley_diameter", title, why, Place(pulley.name))
    return judged(
        RULES["pulley_diameter"],
        title,
        pulley.diameter,
        least,
        "length",
        place=Place(pulley.name),
        source=origin(belt.sources.get("least_pulley_diameter", belt.provenance)),
        short="pulley too small",
        says=f"Pulley {escaped(pulley.name)}, {{value}}, is smaller than the least for its "
        "belt, {limit}.",
    )


def face_pressure(drive: Drive, case: LoadCase, pulley: Pulley) -> Check:
    """Check the largest wrap pressure against what the belt may bear on the pulley face."""
    belt, title = drive.belt, "Pressure on the pulley face"
    place = Place(pulley.name, case.name)
    if belt.largest_wrap_pressure is None:
        why = "the largest wrap pressure of the belt is not given"
        return not_checked("face_pressure", title, why, place)
    tensions = case.tensions[pulley.name]
    tight = max(tensions.entry, tensions.exit)
    value = wrap_pressure(tight, belt.width, pulley.diameter, centrifugal_of(belt))
    return judged(
        RULES["face_pressure"],
        title,
        value,
        belt.largest_wrap_pressure,
        "pressure",
        source=origin(belt.sources.get("largest_wrap_pressure", belt.provenance)),
        short="face pressure",
        says="The belt presses on the pulley face with {value}, more than {limit}.",
        remedy="Take a larger or wider pulley, or less tension.",
        otherwise="Take a larger or wider pulley.",
        place=place,
    )


def tested_pressure(drive: Drive, case: LoadCase, pulley: Pulley) -> Iterator[Check]:
    """Check both ends of the wrap pressure against the tests of the lagging."""
    tested = pulley.lagging.law.tested
    place = Place(pulley.name, case.name)
    if tested is None:
        why = "the friction law states no tests"
        yield not_checked("tested_pressure", "Wrap pressure within the tests", why, place)
        return
    tensions = case.tensions[pulley.name]
    for name, title, tension, limit, of_tension, otherwise in (
        ("tested_pressure_max", "Largest wrap pressure, tested",
         max(tensions.entry, tensions.exit), tested.pressure_max,
         "Lower the tension, take", "Take a larger or wider pulley, or test the lagging at this "
         "pressure."),
        ("tested_pressure_min", "Least wrap pressure, tested",
         min(tensions.entry, tensions.exit), tested.pressure_min,
         "Raise the slack-side tension, or test", "Test the lagging at this pressure."),
    ):  # fmt: skip
        more = "above" if RULES[name].at_most else "below"
        yield judged(
            RULES[name],
            title,
            wrap_pressure(tension, drive.belt.width, pulley.diameter, centrifugal_of(drive.belt)),
            limit,
            "pressure",
            source=tests_of(pulley),
            short=f"pressure {more} tests",
            says=f"The wrap pressure {{value}} is {more} the {{limit}} tested on lagging "
            f"{escaped(pulley.lagging.name)}: there the friction is an extrapolation.",
            remedy=f"{of_tension}{otherwise[4:]}",
            otherwise=otherwise,
            place=place,
        )


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


def sag(drive: Drive, case: LoadCase) -> Check | None:
    """Check the tension of the belt that leaves the drives slack against its sag; None if idle."""
    first, last = (case.tensions[p.name] for p in (drive.pulleys[0], drive.pulleys[-1]))
    driving = first.entry >= last.exit
    tension = last.exit if driving else first.entry
    return sags(drive, tension, Place(drive.pulleys[-1 if driving else 0].name, case.name))


def sags(drive: Drive, tension: float, place: Place) -> Check:
    """Check a tension of the slack side against its sag."""
    title, limits = "Slack-side tension, for sag", drive.criteria.sag
    if limits is None:
        return not_checked("sag", title, "idler spacing and mass are not given", place)
    return judged(
        RULES["sag"],
        title,
        tension,
        limits.tension,
        "force",
        place=place,
        source=limits.SOURCE,
        short="sags",
        says=f"The slack side, {{value}}, sags more than {100.0 * limits.share:g} % of the idler "
        "spacing; that takes {limit}.",
        remedy="Raise the slack-side tension, or set the idlers closer.",
        otherwise="Set the idlers closer.",
    )


def tests_of(pulley: Pulley) -> str:
    """Return where the tested range of a lagging came from."""
    return f"tests of lagging {pulley.lagging.name}: {origin(pulley.lagging.source_of('law'))}"


def origin(provenance: Provenance) -> str:
    """Return where a limit came from, in words."""
    return str(provenance)


def not_checked(name: str, title: str, why: str, place: Place) -> Check:
    """Return a check that could not be made, with the reason."""
    return Check(
        name=name,
        title=title,
        level=Level.NOT_CHECKED,
        place=place,
        says=escaped(f"{title}: not checked, {why}."),
        short=why,
    )


def judged(
    rule: Rule,
    title: str,
    value: float,
    limit: float,
    dimension: Dimension,
    *,
    place: Place,
    source: str = "",
    says: str = "",
    remedy: str = "",
    otherwise: str = "",
    short: str = "",
    because: str = "",
    allows: str = "",
    binding: bool = True,
    more: Mapping[str, tuple[float, Dimension]] | None = None,
) -> Check:
    """Return a check of a value against its limit: OK, or what its rule says where it misses."""
    kept = not math.isnan(value) and keeps(value, limit, at_most=rule.at_most)
    miss = Miss(
        rule.missed,
        short,
        says,
        remedy,
        rule.fails_beyond,
        because,
        rule.tolerates,
        allows,
        otherwise,
    )
    level, says = miss.at(value, rule.at_most)
    return Check(
        name=rule.name,
        title=title,
        level=Level.OK if kept else level,
        miss=miss,
        value=value,
        limit=limit,
        dimension=dimension,
        at_most=rule.at_most,
        says="" if kept else says,
        remedy="" if kept else remedy,
        otherwise="" if kept else otherwise,
        short="" if kept else short,
        place=place,
        source=source,
        binding=binding,
        more=more or {},
    )
