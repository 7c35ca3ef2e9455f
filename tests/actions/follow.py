"""Follow an action: put its changes over the file, solve again, and see what is missed then."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from wraparc.actions import find_action, settings_of
from wraparc.actions.score import DATA_CHECKS
from wraparc.actions.variant import rounded_up
from wraparc.checks import Check, Level, Verdict, judge
from wraparc.checks.action import Action, Way
from wraparc.errors import shown
from wraparc.schema.overrides import put_over
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.whole import Whole, solved
from wraparc.units import in_units

#: Most actions that are followed one after the other: each leaves less than the one before.
MOST = 12


@dataclass
class Followed:
    """What came of following every way that is offered.

    Attributes
    ----------
    wrong
        What a way did not do that it says, in words.
    ways, rounds
        Ways that were followed, and actions after each other.
    end
        How it ends: OK, in words that no way follows from, or by how much Te is too large.
    """

    wrong: list[str]
    ways: int = 0
    rounds: int = 0
    end: str = ""


def solved_document(document: dict[str, Any]) -> Whole:
    """Solve a document as the command line does."""
    return solved(drive_or_train_from_document(document, allow_paths=True))


def left_of(verdict: Verdict) -> int:
    """Count what is missed and is no lack of data."""
    return sum(check.name not in DATA_CHECKS for check in verdict.missed)


def with_way(document: dict[str, Any], way: Way) -> dict[str, Any]:
    """Put the changes of a way over a document, as ``--set`` does."""
    return put_over(document, settings_of(way.changes), TRAIN_FILE)


def follow(document: dict[str, Any]) -> Followed:
    """Follow every way that is offered, and the first one until nothing is offered any more."""
    told = Followed([])
    result = solved_document(document)
    seen = []
    while told.rounds < MOST:
        action = find_action(result)
        if action is None or not action.ways:
            told.end = end_of(judge(result), action)
            told.wrong += faults_of_words(document, judge(result))
            return told
        told.rounds += 1
        first: tuple[dict[str, Any], Whole] | None = None
        for way in action.ways:
            after = with_way(document, way)
            then = solved_document(after)
            told.wrong += faults_of(judge(result), judge(then), way)
            told.ways += 1
            first = first or (after, then)
        assert first is not None
        seen.append(document)
        document, result = first
        if document in seen:
            told.wrong.append(f"a circle: {in_units(action.text)}")
            return told
    told.wrong.append("no end")
    return told


def carried_out(check: Check) -> dict[str, object]:
    """Return what a check asks for in words, as values of keys; empty where nobody can give it."""
    key = f"pulley.{shown(check.place.pulley)}"
    if check.name in ("bond_stress", "fatigue_stress"):
        name = "bond_strength" if check.name == "bond_stress" else "fatigue_limit"
        return {f"{key}.lagging.{name}": f"{rounded_up(check.value)!r} Pa"}
    if check.name == "belt_thickness":
        return {"belt.pulley_cover": "4 mm", "belt.carry_cover": "6 mm", "belt.carcass": "8 mm"}
    if check.name == "crown":
        return {f"{key}.across.shell_profile": {"crown": f"{check.limit / 2.0!r} m"}}
    return {}


def faults_of_words(document: dict[str, Any], before: Verdict) -> list[str]:
    """Return which check is missed still when what it asks for in words is given."""
    worst = before.governing
    given = carried_out(worst) if worst is not None and worst.missed else {}
    if worst is None or not given:
        return []
    after = judge(solved_document(put_over(document, given, TRAIN_FILE)))
    missed = worst.name in {check.name for check in after.missed}
    return [f"{worst.name} is missed still, given {given}"] if missed else []


def end_of(verdict: Verdict, action: Action | None) -> str:
    """Return how following ends."""
    if verdict.level is Level.OK:
        return "OK"
    if left_of(verdict) == 0:
        return "OK but for data"
    return "A0" if action and action.text.startswith("No T2") else "words"


def faults_of(before: Verdict, after: Verdict, way: Way) -> list[str]:
    """Return what a way did not do that it says."""
    passed = {check.name for check in before.listed if check.level is Level.OK}
    words, found = in_units(way.text), [check.name for check in after.missed]
    wrong = [f"{name} failed then: {words}" for name in found if name in passed]
    if left_of(after) != way.left:
        wrong.append(f"{left_of(after)} left, not {way.left}: {words} {found}")
    levels = {check.name: check.level for check in before.missed}
    wrong += [
        f"{check.name} is worse then: {words}"
        for check in after.missed
        if check.name in levels and check.level.rank > levels[check.name].rank
    ]
    return wrong
