"""All checks in the order they are told.

The rule of a check stands beside its words; those across the width, whose solver is loaded for
uneven pulleys alone, stand here.
"""

import math

from wraparc.arc import ArcResult
from wraparc.checks import of_arc
from wraparc.checks.case_kind import CASE_KIND
from wraparc.checks.check import Level, Place
from wraparc.checks.of_arc import GROSS_SLIP, OF_GRIP, OF_LAGGING, OF_SLIP
from wraparc.checks.of_data import OF_LAW
from wraparc.checks.of_drive import BELT_THICKNESS, OF_BELT, OF_TESTS, PULLEY_DIAMETER, SAG, TAUT
from wraparc.checks.of_train import OF_MOTORS, TRAIN_BALANCE_RULE
from wraparc.checks.of_wet import WET_CREEP
from wraparc.checks.rule import Rule, Spot, State
from wraparc.checks.usual import USUAL_RULE
from wraparc.drive import Drive, LoadCase, Pulley
from wraparc.drive.pitch import centrifugal_of

#: Those of one pulley in one load case, and in an event where they are asked of runs.
OF_PULLEY = (*OF_GRIP, WET_CREEP, *OF_BELT, *OF_LAGGING, *OF_TESTS, *OF_LAW, *OF_SLIP, SAG)
RULES = {
    rule.name: rule
    for rule in (
        BELT_THICKNESS,  # as of a train, before those of its pulleys: the first of equals governs
        GROSS_SLIP,
        *OF_PULLEY,
        TAUT,
        PULLEY_DIAMETER,
        USUAL_RULE,
        CASE_KIND,
        *OF_MOTORS,
        TRAIN_BALANCE_RULE,
    )
}
#: The checks of a belt across its width; they bind no slack-side tension.
ACROSS_RULES = {
    rule.name: rule
    for rule in (
        Rule(
            "edge_tension", "the tension of an edge", missed=Level.FAILS, binding=False,
            dimension="force_per_width", tension="lower",
        ),
        Rule(
            "static_edge_tension", "the tension of an edge at standstill", missed=Level.FAILS,
            dimension="force_per_width", binding=False,
        ),
        Rule(
            "static_centre_tension", "the slackest strip at standstill", missed=Level.FAILS,
            dimension="force_per_width", at_most=False, binding=False,
        ),
        Rule(
            "transition_length", "the length of the transition", dimension="length",
            at_most=False, binding=False,
        ),
        Rule(
            "uneven_pressure", "the maximum wrap pressure tested, across the width",
            dimension="pressure", tension="lower", binding=False,
        ),
        Rule(
            "uneven_face_pressure", "the pressure on the pulley face, across the width",
            dimension="pressure", tension="lower", binding=False,
        ),
        Rule(
            "uneven_bond_stress", "the bond strength of the lagging, across the width",
            dimension="pressure", binding=False,
        ),
        Rule(
            "uneven_fatigue_stress", "the fatigue limit of the lagging, across the width",
            dimension="pressure", binding=False,
        ),
        Rule(
            "uneven_creep", "the creep limit, across the width", dimension="length",
            tension="raise", binding=False,
        ),
        Rule("crown", "the crown of the pulley", dimension="length", binding=False),
        Rule(
            "profile_extent", "the extent of a profile", dimension="length", at_most=False,
            binding=False,
        ),
        Rule(
            "across_balance", "the energy balance across the width", missed=Level.FAULT,
            binding=False,
        ),
    )
}  # fmt: skip
#: Names of all checks across the width, those without a limit too.
ACROSS_CHECKS = frozenset({*ACROSS_RULES, "slack_edge", "uneven_wear"})
#: What the checks of a pulley compare of its solution.
RESULTS = tuple(dict.fromkeys(rule.result for rule in OF_PULLEY if rule.result))


def spot_of(drive: Drive, case: LoadCase, pulley: Pulley, result: ArcResult | None = None) -> Spot:
    """Return a pulley in a load case as its checks are asked, with its arc if that is solved."""
    tensions, belt = case.tensions[pulley.name], drive.belt
    known = result is not None and result.status.solved
    first, last = drive.pulleys[0], drive.pulleys[-1]
    driving = case.tensions[first.name].entry >= case.tensions[last.name].exit
    slack = last if driving else first
    return Spot(
        drive=drive,
        case=case,
        pulley=pulley,
        place=Place(pulley.name, case.name),
        state=State(
            tight=max(tensions.entry, tensions.exit),
            slack=min(tensions.entry, tensions.exit),
            slack_end=drive.slack_end(case) if pulley.name == slack.name else math.nan,
            width=belt.width,
            diameter=pulley.diameter,
            strength=math.nan if belt.breaking_strength is None else belt.breaking_strength,
            centrifugal=centrifugal_of(belt),
            creep_limit=drive.creep_limit_of(pulley),
            motor=math.nan,
            found=_found(result) if result is not None and known else {},
        ),
        result=result,
        unknown="" if result is None or known else of_arc.no_state(result),
    )


def _found(result: ArcResult) -> dict[str, float]:
    """Return what the checks compare of a solved arc [SI]."""
    course = {"largest_slip": of_arc.largest_slip, "slip_speed": of_arc.slip_speed}
    return {
        name: course[name](result) if name in course else abs(getattr(result, name))
        for name in RESULTS
        # no check compares the slip speed of a law without tests, and it is long to find
        if name != "slip_speed" or result.arc.law.tested is not None
    }
