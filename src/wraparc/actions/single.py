"""Variants judged one by one, by the solver and the judge of every door."""

from __future__ import annotations

from dataclasses import replace
from math import isfinite

from wraparc.actions.document import Source
from wraparc.actions.score import is_allowed, score_of
from wraparc.actions.search import Evaluate
from wraparc.actions.variant import IMPOSSIBLE, Outcome, Variant
from wraparc.arc import Distributed
from wraparc.checks.check import Level
from wraparc.checks.judge import judge
from wraparc.checks.least_tension import least_tension
from wraparc.checks.verdict import Verdict
from wraparc.drive import Drive, Tensions
from wraparc.errors import InputError
from wraparc.train import Train
from wraparc.train.whole import Described, Whole, by_pulley, solved

#: Variants that are solved one by one where rows do not know all that is checked, and at once.
MOST_SINGLE, MOST_AT_ONCE = 6, 2


class SingleEvaluator:
    """Judges the variants of a drive or train, each solved in all its load cases."""

    def __init__(self, source: Source) -> None:
        self._source = source

    def __call__(self, variants: list[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        return [self.judged(variant) for variant in variants]

    def judged(self, variant: Variant) -> Outcome:
        """Return the outcome of one variant, with its minimum tension."""
        return self._judged(variant, stated=True)

    def confirmed(self, variant: Variant) -> Outcome:
        """Return the same without its minimum tension."""
        return self._judged(variant, stated=False)

    def _judged(self, variant: Variant, stated: bool) -> Outcome:
        try:
            described = self._source.read(self._source.changes(variant))
            if variant.pull:
                described = with_pull(described, variant.pull)
            if stated or len(described.pulleys) > 1:
                return outcome_of(solved(described), stated)
            return outcome_of(solved(described, Distributed(capacities=False)), stated)
        except InputError:
            return IMPOSSIBLE


class FilteredEvaluator:
    """Judges variants by rows, and those one by one that promise most by them.

    Rows know no strips and no interval of a law: what these miss they take as it is now.
    """

    def __init__(self, rows: Evaluate, single: SingleEvaluator, now: Outcome) -> None:
        self._rows, self._single, self._now, self._left = rows, single, now, MOST_SINGLE

    def __call__(self, variants: list[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        found = self._rows(variants)
        some = [i for i, outcome in enumerate(found) if is_allowed(outcome, self._now)]
        some.sort(key=lambda i: score_of(found[i]).weight)
        for i in some[: min(MOST_AT_ONCE, self._left)]:
            found[i] = self._single.confirmed(variants[i])
            self._left -= 1
        return found


def outcome_of(result: Whole, stated: bool) -> Outcome:
    """Return what the judgement of a solved drive or train comes to.

    `stated` is whether with the minimum tension at the take-up.
    """
    verdict, (least, most) = judge(result), _stated(result) if stated else (0.0, 0.0)
    used = {c.name: share_of(c.value, c.limit, c.at_most) for c in verdict.missed}
    creeps = [abs(arc.exit_creep) for arc in by_pulley(result) if arc.status.solved]
    return Outcome(
        possible=True,
        levels={c.name: c.level.rank for c in verdict.missed},
        passed=passed_of(verdict),
        used=used,
        creep=max(creeps, default=0.0),
        least=least,
        most=most,
    )


def _stated(result: Whole) -> tuple[float, float]:
    """Return minimum and maximum tension at the take-up by the checks, 0 without one [N]."""
    found = least_tension(result)
    if found is None:
        return 0.0, 0.0
    least, top = found.tension, found.highest
    most = 0.0 if top is None else top.tension
    return (least if isfinite(least) else 0.0), (most if isfinite(most) and most > 0.0 else 0.0)


def passed_of(verdict: Verdict) -> tuple[str, ...]:
    """Return the names of the checks that pass."""
    return tuple(c.name for c in verdict.listed if c.level is Level.OK)


def share_of(value: float, limit: float, at_most: bool) -> float:
    """Return a value over its maximum, or a minimum over its value [-]; 0 where there is none."""
    over, under = (value, limit) if at_most else (limit, value)
    return over / under if under > 0.0 and isfinite(over) else 0.0


def with_pull(described: Described, factor: float) -> Described:
    """Return a drive or train with a factor on its effective tension, the slack side as it is."""
    if isinstance(described, Train):
        cases = []
        for case in described.cases:
            slack, rise = min(case.entry_tension, case.exit_tension), case.entry_tension
            rise -= case.exit_tension
            ends = (slack + factor * max(rise, 0.0), slack + factor * max(-rise, 0.0))
            cases.append(replace(case, entry_tension=ends[0], exit_tension=ends[1]))
        return replace(described, cases=tuple(cases), conveyor=None)
    return with_drive_pull(described, factor)


def with_drive_pull(drive: Drive, factor: float) -> Drive:
    """Return the same of a drive of one pulley."""
    cases = []
    for case in drive.load_cases:
        tensions = {}
        for name, at in case.tensions.items():
            slack = min(at.entry, at.exit)
            ends = (slack + factor * (at.entry - slack), slack + factor * (at.exit - slack))
            tensions[name] = Tensions(entry=ends[0], exit=ends[1])
        cases.append(replace(case, tensions=tensions))
    return replace(drive, load_cases=tuple(cases), conveyor=None)
