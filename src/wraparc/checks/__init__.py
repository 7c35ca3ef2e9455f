"""One judgement: what a result is held against, and the verdict that follows.

A door asks ``judge(result)`` for a `Verdict` (of a `DriveResult` or a `TrainResult`) and shows what
it finds there; it judges nothing itself::

    verdict = judge(result)
    verdict.level, verdict.label     # the worst of the checks; "OK (dry)"
    verdict.text                     # one sentence; its quantities are cells
    verdict.also                     # what else is missed, the worst first
    verdict.listed                   # each check once, at the place that governs it
    verdict.at(pulley, load_case)    # the same of one arc: its level for a row of a table
    verdict.checks                   # every check at every place

``before(drive)`` gives the checks that need no solving. Units come in where a text is made; a
`Check` holds SI numbers. ``least_tension(result)`` is the least slack-side tension with which every
binding check is kept.
"""

from wraparc.checks.check import Check, Level, Place, keeps
from wraparc.checks.gross_slip import Margins, margins_of
from wraparc.checks.judge import before, judge
from wraparc.checks.least_tension import Figure, LeastTension, least_tension
from wraparc.checks.of_run import judge_run
from wraparc.checks.of_train import TRAIN_BALANCE
from wraparc.checks.rule import idle
from wraparc.checks.rules import RULES
from wraparc.checks.verdict import DataLine, Verdict

__all__ = [
    "RULES",
    "TRAIN_BALANCE",
    "Check",
    "DataLine",
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
]
