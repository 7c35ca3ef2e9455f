"""One judgement: what a result is held against, and the verdict that follows.

A door asks ``judge(result)`` for a `Verdict` (of a `DriveResult` or a `TrainResult`) and shows what
it finds there; it judges nothing itself::

    verdict = judge(result)
    verdict.level, verdict.word      # the worst of the checks; "OK, on illustrative data"
    verdict.headline(system)         # the check that governs, in a sentence, with its remedy
    verdict.sentences(system)        # what else is missed
    verdict.listed                   # each check once, where it comes off worst
    verdict.at(pulley, load_case)    # the same of one arc: its level for a row of a table
    verdict.checks                   # every check at every place

``before(drive)`` gives the checks that need no solving. Units come in where a text is made; a
`Check` holds SI numbers. ``least_tension(result)`` is the least slack-side tension with which every
binding check is kept.
"""

from wraparc.checks.check import Check, Level, Place, Verdict, keeps, placed
from wraparc.checks.gross_slip import Margins, margins_of
from wraparc.checks.judge import before, judge
from wraparc.checks.least_tension import Figure, LeastTension, least_tension
from wraparc.checks.of_run import judge_run
from wraparc.checks.of_train import TRAIN_BALANCE
from wraparc.checks.rule import idle
from wraparc.checks.rules import RULES

__all__ = [
    "RULES",
    "TRAIN_BALANCE",
    "Check",
    "Figure",
    "LeastTension",
    "Level",
    "Margins",
    "Place",
    "Verdict",
    "before",
    "idle",
    "judge",
    "judge_run",
    "keeps",
    "least_tension",
    "margins_of",
    "placed",
]
