"""What each check allows: its sense and what missing it means, once for one drive and for many.

The numbers that are compared stand here too, as functions of plain numbers or of columns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from wraparc.arc import WrapArc
from wraparc.arrays import Number
from wraparc.checks.check import Level
from wraparc.checks.numbers import USUAL_STRENGTH, idles
from wraparc.checks.sliding import SLIDES
from wraparc.drive import CREEP_LIMIT, Belt, Criteria

#: Breaking strength over the largest tension that is customary, by carcass, where no rating says
#: it: 15 % of the strength of steel cord, 8 of fabric; and the least of any belt [-].
CUSTOMARY_SAFETY, WEAKEST = {"steel cord": 1.0 / 0.15, "fabric": 8.0}, 3.0
#: Strength over rating of any belt, at least: a rating that leaves less is not one to rely on [-].
LEAST_RATED = USUAL_STRENGTH[0]


@dataclass(frozen=True)
class Rule:
    """One check.

    Attributes
    ----------
    name
        Its key, the same in every door.
    what
        What sets the limit, in words.
    missed
        Level where it is not kept.
    fails_beyond
        Value beyond which a miss fails [SI]; nan for none.
    tolerates
        Value up to which practice may allow a miss [SI]; nan for none.
    at_most
        Whether the limit is an upper one.
    """

    name: str
    what: str
    missed: Level = Level.ATTENTION
    at_most: bool = True
    fails_beyond: float = math.nan
    tolerates: float = math.nan


#: The checks of an arc in the order they are told; the balance of the solution is none of a row.
RULES = {
    rule.name: rule
    for rule in (
        Rule("gross_slip", "the safety against gross slip", at_most=False, fails_beyond=1.0),
        Rule("design_standard", "the design standard", at_most=False),
        Rule("creep", "the creep limit", fails_beyond=SLIDES, tolerates=2.0 * CREEP_LIMIT),
        Rule("cover_creep", "the creep limit, with the cover of the belt in series"),
        Rule("creep_interval", "the creep limit, at the end of the interval of the law"),
        Rule("belt_tension", "the rating of the belt", Level.FAILS),
        Rule("momentary_tension", "the momentary rating of the belt", Level.FAILS),
        Rule("belt_safety", "the safety factor of the belt", at_most=False, fails_beyond=WEAKEST),
        Rule("face_pressure", "the pressure on the pulley face"),
        Rule("bond_stress", "the bond strength of the lagging"),
        Rule("fatigue_stress", "the fatigue limit of the lagging"),
        Rule("tested_pressure_max", "the largest wrap pressure tested"),
        Rule("tested_pressure_min", "the least wrap pressure tested", at_most=False),
        Rule("condition", "friction that was not tested in the condition"),
        Rule("fit", "friction that does not fit its tests"),
        Rule("tested_slip", "the largest slip tested"),
        Rule("tested_slip_speed", "the slip speed tested"),
        Rule("balance", "the energy balance", Level.FAULT),
        Rule("sag", "the sag of the belt", at_most=False),
        Rule("taut", "a belt that nowhere hangs slack", at_most=False),
        Rule("pulley_diameter", "the least pulley of the belt", Level.FAILS, at_most=False),
        Rule("belt_thickness", "a trim without the thickness of the belt"),
        Rule("usual_sizes", "an unusual size"),
        Rule("motor_load", "the rating of a motor", fails_beyond=1.15),
        Rule("momentary_load", "the torque that a motor bears in a start"),
        Rule("motor_heat", "the heat that a motor bears"),
        Rule("train_balance", "the balance of the train", Level.FAULT),
    )
}
#: The checks of a belt across its width; they bind no slack-side tension.
ACROSS_RULES = {
    rule.name: rule
    for rule in (
        Rule("edge_tension", "the tension of an edge", Level.FAILS),
        Rule("static_edge_tension", "the tension of an edge at standstill", Level.FAILS),
        Rule("static_centre_tension", "the slackest strip at standstill", Level.FAILS, False),
        Rule("transition_length", "the length of the transition", at_most=False),
        Rule("uneven_pressure", "the largest wrap pressure tested, across the width"),
        Rule("uneven_face_pressure", "the pressure on the pulley face, across the width"),
        Rule("uneven_bond_stress", "the bond strength of the lagging, across the width"),
        Rule("uneven_fatigue_stress", "the fatigue limit of the lagging, across the width"),
        Rule("uneven_creep", "the creep limit, across the width"),
        Rule("crown", "the crown of the pulley"),
        Rule("profile_extent", "the extent of a profile", at_most=False),
        Rule("across_balance", "the energy balance across the width", Level.FAULT),
    )
}
#: Names of all checks across the width, those without a limit too.
ACROSS_CHECKS = frozenset({*ACROSS_RULES, "slack_edge", "uneven_wear"})
#: Where gross slip cannot be avoided, whatever its safety factor.
NO_GRIP = Level.FAILS


def idle(arc: WrapArc) -> bool:
    """Whether an arc hands nothing over: its pulley is not driven."""
    return idles(arc.entry_tension, arc.exit_tension)


def standard_rule(criteria: Criteria) -> Rule:
    """Return the rule of the design standard: it fails a drive only if it binds."""
    rule = RULES["design_standard"]
    return replace(rule, missed=Level.FAILS) if criteria.standard.binding else rule


def tension_rule(kind: str) -> Rule:
    """Return the rule of the belt tension in a kind of load case."""
    return RULES["belt_tension" if kind == "running" else "momentary_tension"]


def tension_factor(belt: Belt, kind: str) -> float:
    """Tension allowed in a kind of load case over the rating of the belt [-]."""
    return 1.0 if kind == "running" else belt.momentary_factor or 1.0


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


def start_factor(criteria: Criteria, kind: str) -> float:
    """Pull that the design standard is applied to over that of a load case [-]."""
    return criteria.standard.start_factor if kind == "running" else 1.0


def wrap_pressure(tension: Number, width: Number, diameter: Number, centrifugal: Number) -> Number:
    """Pressure of the belt on the pulley, 2 T/(B D) [Pa]."""
    return 2.0 * (tension - centrifugal) / (width * diameter)
