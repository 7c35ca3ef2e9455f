"""Checks of a belt across its width: its edges, slack strips, the worst place, wear that grows."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from wraparc.across import AcrossResult, AcrossStatus, slack_words
from wraparc.arc.result import MORE_FRICTION
from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.of_drive import NO_RATING, tension_factor, tests_of
from wraparc.checks.rule import Words, not_checked, origin
from wraparc.checks.rules import ACROSS_RULES
from wraparc.drive import Belt, Drive, LoadCase, Pulley, Transition

#: Tension at an edge that a belt may bear over its rating [-].
EDGE_FACTOR = 1.15
_EDGE = "edge at most 115 % of the rating; Goodyear, belt maintenance manual (2010)"
#: Least length of a full trough transition over the belt width, at trough angles of 20, 35, 45 deg,
#: for belts tensioned above 90, above 60, and up to 60 % of their rating; half troughs need half.
_TRANSITIONS = {
    "steel cord": ((4.0, 6.8, 8.0), (3.2, 5.2, 6.4), (2.0, 3.6, 4.4)),
    "fabric": ((1.8, 3.2, 4.0), (1.6, 2.4, 3.2), (1.2, 1.8, 2.4)),
}
_ANGLES = np.radians([20.0, 35.0, 45.0])
_TRANSITION_SOURCE = (
    "customary lengths by carcass, trough angle and tension; Useful Conveyor Design Data"
)
#: Largest crown, on diameter per width: 1/8 in per foot.
LARGEST_CROWN = 1.0 / 96.0
#: Least extent of a profile over the belt width [-]: an inch read as a millimetre leaves a 25th.
LEAST_EXTENT = 0.1
#: Largest miss of the balance of energy that a solution is trusted with [-].
BALANCE = 1e-3


def across(drive: Drive, case: LoadCase, result: AcrossResult) -> Iterator[Check]:
    """Yield the checks of one pulley across the width in one load case."""
    pulley = drive.pulley(result.wide.arc.pulley)
    place = Place(pulley.name, case.name)
    yield _carried(result, place)
    yield from _static(drive, case, pulley, result, place)
    yield from _extent(drive.belt, pulley)
    if result.status is not AcrossStatus.SOLVED:
        return
    yield _edge(drive.belt, case, "edge_tension", "Edge tension, running",
                (result.largest_running_tension, result.tightest_strip_tension), place)  # fmt: skip
    yield from _worst_place(drive, pulley, result, place)
    yield _wear(result, place)
    words = Words(
        title="Energy balance across the width",
        source="tolerance of the program",
        short="out of balance",
        says="The energy balance across the width misses by {value}, more than {limit}.",
        remedy="Please report the drive file; until then use another number of strips.",
    )
    yield ACROSS_RULES["across_balance"].judged(result.identity_error, BALANCE, place, words)


def _carried(result: AcrossResult, place: Place) -> Check:
    solved = result.status is AcrossStatus.SOLVED
    fault = result.status is AcrossStatus.UNSOLVED
    return Check(
        name="slack_edge",
        title="Every strip of the belt carries tension",
        level=Level.OK if solved else Level.FAULT if fault else Level.FAILS,
        value=result.least_tension if solved else math.nan,
        limit=0.0 if solved else math.nan,
        dimension="force_per_width",
        at_most=False,
        short="" if solved else "slack edge" if result.slack else result.status.name.lower(),
        says="" if solved else escaped(f"{slack_words(result)} {result.status}".strip()),
        place=place,
        binding=False,
    )


def _edge(
    belt: Belt, case: LoadCase, name: str, title: str, tension: tuple[float, float], place: Place
) -> Check:
    """Check a tension per width against 115 % of the rating, with the factor of the load case.

    Judged is the tension at the very edge, the safer of both; that of the tightest strip is told.
    """
    value, strip = tension
    if belt.rating is None:
        return not_checked(name, title, NO_RATING, place)
    factor = EDGE_FACTOR * tension_factor(belt, case.kind)
    share = 100.0 * value / belt.rating
    words = Words(
        title=title,
        source=f"{_EDGE}; rating: {origin(belt.sources.get('rating', belt.provenance))}",
        short="edge over rating",
        says="At its tightest the belt carries {value}, more than the {limit} allowed; that is "
        f"{share:.3g} % of the rating, and its tightest strip carries {{strip}}.",
        remedy="Even out the pulley, lengthen the transition, or lower the tension.",
        otherwise="Even out the pulley, or lengthen the transition.",
        more={"strip": (strip, "force_per_width")},
    )
    return ACROSS_RULES[name].judged(value, factor * belt.rating, place, words)


def _static(
    drive: Drive, case: LoadCase, pulley: Pulley, result: AcrossResult, place: Place
) -> Iterator[Check]:
    """Check a trough transition at standstill: what the standards look at."""
    before = pulley.across.before if pulley.across else None
    if not isinstance(before, Transition):
        return
    yield _edge(drive.belt, case, "static_edge_tension", "Edge tension at standstill",
                (result.largest_static_tension, float(np.max(result.static_tension))),
                place)  # fmt: skip
    least = float(np.min(result.static_tension))
    words = Words(
        title="Centre of the belt at standstill",
        source="centre not below 0; Goodyear, belt maintenance manual (2010)",
        short="buckles",
        says="At standstill the transition leaves {value} in the slackest strip: it buckles.",
        remedy="Lengthen the transition, or raise the pulley to half the depth of the trough.",
    )
    yield ACROSS_RULES["static_centre_tension"].judged(least, 0.0, place, words)
    title, belt = "Length of the trough transition", drive.belt
    if belt.rating is None or belt.kind not in _TRANSITIONS:
        why = "carcass and rating of the belt are not given"
        yield not_checked("transition_length", title, why, place)
        return
    share = result.wide.arc.entry_tension / (belt.rating * belt.width)
    words = Words(
        title=title,
        source=_TRANSITION_SOURCE,
        short="transition short",
        says=f"The transition, {{value}}, is shorter than the {{limit}} that is customary for "
        f"{belt.kind}; it carries {100.0 * share:.3g} % of its rating.",
        remedy="Lengthen it, flatten the last troughs, or raise the pulley to half the trough.",
    )
    least_length = least_transition(belt, before, share)
    yield ACROSS_RULES["transition_length"].judged(before.length, least_length, place, words)


def least_transition(belt: Belt, transition: Transition, share: float) -> float:
    """Least length of a transition of a belt at a share of its rating [m]."""
    row = 0 if share > 0.9 else 1 if share > 0.6 else 2
    table = _TRANSITIONS[belt.kind][row]
    full = float(np.interp(transition.trough_angle, _ANGLES, table)) * belt.width
    return full * (0.5 if transition.depth == "half" else 1.0)


def _worst_place(
    drive: Drive, pulley: Pulley, result: AcrossResult, place: Place
) -> Iterator[Check]:
    """Check pressure, shear and creep of the strip that comes off worst."""
    lagging, tested = pulley.lagging, pulley.lagging.law.tested
    strip = "The worst strip"
    plain = "Even out the pulley, or choose a larger pulley."
    advice = {
        "": (plain, plain),
        "lower": (f"{plain[:-1]} or less tension.", plain),
        "raise": (
            f"Even out the pulley, raise the slack-side tension, or {MORE_FRICTION}",
            f"Even out the pulley, or {MORE_FRICTION}",
        ),
    }
    limits = [
        ("uneven_pressure", "Largest wrap pressure across the width, tested",
         result.largest_pressure, None if tested is None else tested.pressure_max,
         tests_of(pulley) if tested else "",
         f"{strip} presses with {{value}}, above the {{limit}} tested on lagging "
         f"{escaped(lagging.name)}.", "pressure above tests"),
        ("uneven_face_pressure", "Pressure on the pulley face across the width",
         result.largest_pressure, drive.belt.largest_wrap_pressure,
         origin(drive.belt.source_of("largest_wrap_pressure")),
         f"{strip} presses on the pulley face with {{value}}, more than {{limit}}.",
         "face pressure"),
        ("uneven_bond_stress", "Shear stress of the bond across the width",
         float(np.max(result.peak_shear_stress)), lagging.bond_strength,
         origin(lagging.source_of("bond_strength")),
         f"{strip} shears lagging and bond with {{value}}, more than {{limit}}.",
         "bond overstressed"),
        ("uneven_fatigue_stress", "Shear stress of the bond across the width, at every pass",
         float(np.max(result.peak_shear_stress)), lagging.fatigue_limit,
         origin(lagging.source_of("fatigue_limit")),
         f"{strip} is sheared by {{value}} at every pass, fatigue limit {{limit}}.",
         "lagging tires"),
        ("uneven_creep", "Creep at exit across the width", abs(result.largest_creep),
         result.wide.arc.creep_limit, "as for the even belt",
         f"{strip} creeps {{value}}, more than the limit of {{limit}}.", "over creep limit"),
    ]  # fmt: skip
    for name, title, value, limit, source, says, short in limits:
        if limit is not None:
            remedy, otherwise = advice[ACROSS_RULES[name].tension]
            words = Words(
                title=title,
                source=source,
                says=says,
                short=short,
                remedy=remedy,
                otherwise=otherwise,
            )
            yield ACROSS_RULES[name].judged(value, limit, place, words)
    yield from _crown(drive, pulley)


def _crown(drive: Drive, pulley: Pulley) -> Iterator[Check]:
    shell = pulley.across.shell_profile if pulley.across else None
    if shell is None or shell.crown <= 0.0:
        return
    cord = drive.belt.kind == "steel cord"
    on_diameter = 2.0 * shell.crown
    words = Words(
        title="Crown of the pulley, on diameter",
        source="at most 1/8 in per foot of width for fabric, none for steel cord; customary",
        short="crowned too high",
        says="Steel-cord belts run on pulleys without a crown; this one has {value} on diameter."
        if cord
        else "The crown, {value} on diameter, is higher than the customary {limit}.",
        remedy="Turn the crown off, or train the belt by its idlers.",
    )
    most = 0.0 if cord else LARGEST_CROWN * drive.belt.width
    yield ACROSS_RULES["crown"].judged(on_diameter, most, Place(pulley.name), words)


def _extent(belt: Belt, pulley: Pulley) -> Iterator[Check]:
    """Ask about a profile too narrow to be one of the whole face: inches read as millimetres."""
    least = LEAST_EXTENT * belt.width
    for name, profile in (pulley.across.profiles() if pulley.across else {}).items():
        if not profile.position or profile.position[-1] - profile.position[0] >= least:
            continue
        words = Words(
            title=f"Extent of the profile {name}",
            source="a tenth of the width: a profile of the face reaches further",
            short="profile too narrow",
            says=f"The rows of {name} reach over {{value}} of a belt {{width}} wide: were inches "
            "read as millimetres?",
            more={"width": (belt.width, "length")},
            remedy="Give every position its unit, and rows over the whole face.",
        )
        extent = profile.position[-1] - profile.position[0]
        yield ACROSS_RULES["profile_extent"].judged(extent, least, Place(pulley.name), words)


def _wear(result: AcrossResult, place: Place) -> Check:
    """Say whether uneven wear heals or grows."""
    depth = result.levelling_depth
    grows = result.wear_grows
    level = float(np.min(np.abs(depth[depth < 0.0]))) if grows else float(np.max(depth))
    return Check(
        name="uneven_wear",
        title="Uneven wear of the lagging levels itself",
        level=Level.ATTENTION if grows else Level.OK,
        short="uneven wear grows" if grows else "",
        says="Uneven wear grows, as on every pulley that brakes: each {depth} of mean wear makes "
        "it 2.7 times as large."
        if grows
        else "",
        remedy="Measure the lagging over its width regularly, and dress or renew it in time."
        if grows
        else "",
        more={"depth": (level, "length")},
        place=place,
        binding=False,
    )
