"""All checks in the order they are told.

The rule of a check stands beside its words; those across the width, whose solver is loaded for
uneven pulleys alone, stand here.
"""

from wraparc.checks.check import Level
from wraparc.checks.of_arc import GROSS_SLIP, OF_GRIP, OF_LAGGING, OF_SLIP
from wraparc.checks.of_data import OF_LAW
from wraparc.checks.of_drive import BELT_THICKNESS, OF_BELT, OF_TESTS, PULLEY_DIAMETER, SAG, TAUT
from wraparc.checks.of_train import OF_MOTORS, TRAIN_BALANCE_RULE
from wraparc.checks.rule import Rule
from wraparc.checks.usual import USUAL_RULE

#: Those of one pulley in one load case, and in an event where they are asked of runs.
OF_PULLEY = (*OF_GRIP, *OF_BELT, *OF_LAGGING, *OF_TESTS, *OF_LAW, *OF_SLIP, SAG)
RULES = {
    rule.name: rule
    for rule in (
        GROSS_SLIP,
        *OF_PULLEY,
        TAUT,
        PULLEY_DIAMETER,
        BELT_THICKNESS,
        USUAL_RULE,
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
            "uneven_pressure", "the largest wrap pressure tested, across the width",
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
