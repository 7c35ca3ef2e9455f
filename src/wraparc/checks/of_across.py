"""Checks of a belt across its width: its edges, slack strips, the worst place, wear that grows."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from wraparc.across import AcrossResult, AcrossStatus
from wraparc.checks.check import Amount, Check, Level, Place
from wraparc.checks.of_arc import REPORT
from wraparc.checks.of_drive import NO_RATING, tension_factor, tests_of
from wraparc.checks.rule import CheckText, not_checked, origin
from wraparc.checks.rules import ACROSS_RULES
from wraparc.drive import Belt, Drive, LoadCase, Pulley, Transition

#: Tension at an edge that a belt may bear over its rating [-].
EDGE_FACTOR = 1.15
_EDGE = "edge at most 115 % of the rating; Goodyear, belt maintenance manual (2010)"
#: Minimum length of a full trough transition over the belt width, at trough angles of 20, 35 and
#: 45 deg, for belts tensioned above 90, above 60, and up to 60 % of their rating; half troughs need
#: half.
_TRANSITIONS = {
    "steel cord": ((4.0, 6.8, 8.0), (3.2, 5.2, 6.4), (2.0, 3.6, 4.4)),
    "fabric": ((1.8, 3.2, 4.0), (1.6, 2.4, 3.2), (1.2, 1.8, 2.4)),
}
_ANGLES = np.radians([20.0, 35.0, 45.0])
_TRANSITION_SOURCE = (
    "customary lengths by carcass, trough angle and tension; Useful Conveyor Design Data"
)
#: Maximum crown, on diameter per width: 1/8 in per foot.
LARGEST_CROWN = 1.0 / 96.0
#: Minimum extent of a profile over the belt width [-]: an inch read as a millimetre leaves a 25th.
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
    text = CheckText(
        title="Energy balance, width",
        noun="energy balance error",
        source="tolerance of the program",
        label="internal error",
        headline="Energy balance error {value} exceeds {limit}",
        action=REPORT,
    )
    yield ACROSS_RULES["across_balance"].compare(result.identity_error, BALANCE, place, text)


def _carried(result: AcrossResult, place: Place) -> Check:
    solved = result.status is AcrossStatus.SOLVED
    fault = result.status is AcrossStatus.UNSOLVED
    slack, more, full = result.slack, dict[str, Amount](), ""
    headline, action = "Gross slip: uneven pulley cannot transmit Te", UNEVEN_TENSION
    if slack is not None:
        headline = "Strip at {position} goes slack"
        more = {
            "position": Amount(slack.position, "length"),
            "lacks": Amount(-slack.tension, "force_per_width"),
        }
        full = "The position is from the middle of the belt; the strip lacks {lacks}."
    if fault:
        headline, action = "No solution across the width", REPORT
    return Check(
        name="slack_edge",
        title="Strip tension",
        noun="strip tension",
        level=Level.OK if solved else Level.FAULT if fault else Level.FAILS,
        value=result.least_tension if solved else math.nan,
        limit=0.0 if solved else math.nan,
        dimension="force_per_width",
        at_most=False,
        label="" if solved else "not solved" if fault else "slack strip" if slack else "gross slip",
        headline="" if solved else headline,
        action="" if solved else action,
        full="" if solved else full,
        more=more,
        place=place,
        binding=False,
    )


#: What to do about a pulley that is too uneven, and about an edge that is too tight.
UNEVEN_TENSION = "Try a higher T2 or an even pulley face."
EVEN_EDGE = "Try an even pulley face or a longer transition."


def _edge(
    belt: Belt, case: LoadCase, name: str, title: str, tension: tuple[float, float], place: Place
) -> Check:
    """Check a tension per width against 115 % of the rating, with the factor of the load case.

    Judged is the tension at the very edge, the safer of both; that of the tightest strip is told.
    """
    value, strip = tension
    if belt.rating is None:
        return not_checked(name, title, "edge tension", place, missing=NO_RATING)
    factor = EDGE_FACTOR * tension_factor(belt, case.kind)
    share = 100.0 * value / belt.rating
    still = " at standstill" if name == "static_edge_tension" else ""
    text = CheckText(
        title=title,
        noun=f"edge tension{still}",
        source=f"{_EDGE}; rating: {origin(belt.sources.get('rating', belt.provenance))}",
        label="edge tension",
        headline=f"Edge tension {{value}} exceeds the {{limit}} limit{still}",
        action=EVEN_EDGE,
        full=f"{share:.3g} % of the rating; the tightest strip has {{strip}}.",
        more={"strip": Amount(strip, "force_per_width")},
    )
    return ACROSS_RULES[name].compare(value, factor * belt.rating, place, text)


def _static(
    drive: Drive, case: LoadCase, pulley: Pulley, result: AcrossResult, place: Place
) -> Iterator[Check]:
    """Check a trough transition at standstill: what the standards look at."""
    before = pulley.across.before if pulley.across else None
    if not isinstance(before, Transition):
        return
    yield _edge(drive.belt, case, "static_edge_tension", "Edge tension, standstill",
                (result.largest_static_tension, float(np.max(result.static_tension))),
                place)  # fmt: skip
    least = float(np.min(result.static_tension))
    text = CheckText(
        title="Centre tension, standstill",
        noun="centre tension at standstill",
        source="centre not below 0; Goodyear, belt maintenance manual (2010)",
        label="centre tension",
        headline="Centre tension {value} is below 0 at standstill",
        action="Try a longer transition, or a higher pulley.",
        full="The belt buckles there.",
    )
    yield ACROSS_RULES["static_centre_tension"].compare(least, 0.0, place, text)
    title, noun, belt = "Transition length", "transition length", drive.belt
    if belt.rating is None or belt.kind not in _TRANSITIONS:
        missing = NO_RATING if belt.rating is None else "belt.kind"
        yield not_checked("transition_length", title, noun, place, missing=missing)
        return
    share = result.wide.arc.entry_tension / (belt.rating * belt.width)
    text = CheckText(
        title=title,
        noun=noun,
        source=_TRANSITION_SOURCE,
        label="transition length",
        headline="Transition {value} is below the usual minimum {limit}",
        action="Use a transition of {limit} or more.",
        full=f"For {belt.kind} at {100.0 * share:.3g} % of the rating.",
    )
    least_length = least_transition(belt, before, share)
    yield ACROSS_RULES["transition_length"].compare(before.length, least_length, place, text)


def least_transition(belt: Belt, transition: Transition, share: float) -> float:
    """Least length of a transition of a belt at a share of its rating [m]."""
    row = 0 if share > 0.9 else 1 if share > 0.6 else 2
    table = _TRANSITIONS[belt.kind][row]
    full = float(np.interp(transition.trough_angle, _ANGLES, table)) * belt.width
    return full * (0.5 if transition.depth == "half" else 1.0)


def _worst_place(
    drive: Drive, pulley: Pulley, result: AcrossResult, place: Place
) -> Iterator[Check]:
    """Check pressure, shear and creep of the worst strip."""
    lagging, tested, belt = pulley.lagging, pulley.lagging.law.tested, drive.belt
    pressure, stress = result.largest_pressure, float(np.max(result.peak_shear_stress))
    rows = (
        ("uneven_pressure", "Wrap pressure", "maximum wrap pressure", pressure,
         None if tested is None else tested.pressure_max, tests_of(pulley) if tested else "",
         "Wrap pressure {value} exceeds the tested {limit}", "pressure above tests"),
        ("uneven_face_pressure", "Face pressure", "face pressure", pressure,
         belt.largest_wrap_pressure, origin(belt.source_of("largest_wrap_pressure")),
         "Face pressure {value} exceeds the belt limit {limit}", "face pressure"),
        ("uneven_bond_stress", "Bond shear stress", "bond shear stress", stress,
         lagging.bond_strength, origin(lagging.source_of("bond_strength")),
         "Bond shear stress {value} exceeds the strength {limit}", "bond stress"),
        ("uneven_fatigue_stress", "Cyclic shear stress", "cyclic shear stress", stress,
         lagging.fatigue_limit, origin(lagging.source_of("fatigue_limit")),
         "Cyclic shear stress {value} exceeds the fatigue limit {limit}", "fatigue"),
        ("uneven_creep", "Creep", "creep", abs(result.largest_creep),
         result.wide.arc.creep_limit, "as for the even belt",
         "Creep {value} exceeds the {limit} limit", "creep"),
    )  # fmt: skip
    for name, title, noun, value, limit, source, headline, label in rows:
        if limit is None:
            continue
        text = CheckText(
            title=f"{title}, worst strip",
            noun=noun,
            source=source,
            headline=headline,
            label=label,
            action="Try an even pulley face.",
        )
        yield ACROSS_RULES[name].compare(value, limit, place._replace(spot=WORST_STRIP), text)
    yield from _crown(drive, pulley)


#: Where an uneven pulley is judged.
WORST_STRIP = "worst face strip"


def _crown(drive: Drive, pulley: Pulley) -> Iterator[Check]:
    shell = pulley.across.shell_profile if pulley.across else None
    if shell is None or shell.crown <= 0.0:
        return
    cord = drive.belt.kind == "steel cord"
    on_diameter = 2.0 * shell.crown
    text = CheckText(
        title="Crown",
        noun="pulley crown",
        source="at most 1/8 in per foot of width for fabric, none for steel cord; customary",
        label="crown",
        headline="Crown {value} is not allowed with steel cord"
        if cord
        else "Crown {value} on diameter exceeds the {limit} limit",
        action="Use a pulley without crown." if cord else "Use a crown of {limit} or less.",
    )
    most = 0.0 if cord else LARGEST_CROWN * drive.belt.width
    yield ACROSS_RULES["crown"].compare(on_diameter, most, Place(pulley.name), text)


def _extent(belt: Belt, pulley: Pulley) -> Iterator[Check]:
    """Ask about a profile too narrow to be one of the whole face: inches read as millimetres."""
    least = LEAST_EXTENT * belt.width
    for name, profile in (pulley.across.profiles() if pulley.across else {}).items():
        if not profile.position or profile.position[-1] - profile.position[0] >= least:
            continue
        text = CheckText(
            title="Profile width",
            noun="profile width",
            source="a tenth of the belt width",
            label="profile width",
            headline=f"Profile {name} covers {{value}} of a {{width}} belt",
            action="Check the unit of position: inches.",
            more={"width": Amount(belt.width, "length")},
        )
        extent = profile.position[-1] - profile.position[0]
        yield ACROSS_RULES["profile_extent"].compare(extent, least, Place(pulley.name), text)


def _wear(result: AcrossResult, place: Place) -> Check:
    """Say whether uneven wear heals or grows."""
    depth = result.levelling_depth
    grows = result.wear_grows
    level = float(np.min(np.abs(depth[depth < 0.0]))) if grows else float(np.max(depth))
    return Check(
        name="uneven_wear",
        title="Wear across width",
        noun="wear across width",
        level=Level.ATTENTION if grows else Level.OK,
        label="uneven wear" if grows else "",
        headline="Uneven wear grows 2.7 times per {depth} worn" if grows else "",
        action="Try measuring the lagging across its width at each stop." if grows else "",
        more={"depth": Amount(level, "length")},
        place=place,
        binding=False,
    )
