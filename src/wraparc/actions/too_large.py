"""By how much the effective tension is too large where no change of the drive is enough."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import inf

from wraparc.actions.score import Score, is_allowed, score_of
from wraparc.actions.search import MOST_WRAP, Candidate, Evaluate
from wraparc.actions.variant import WRAP, Outcome, Task, Variant, at_rung, rung_above

#: Most percent that are told.
MOST = 900
#: Tensions that are tried with each lagging and wrap.
_POINTS = 6


def percent_too_large(task: Task, evaluate: Evaluate, name: str, tried: Sequence[Candidate]) -> int:
    """Return by how many percent the effective tension is too large for a check, rounded up.

    With the best of all slack-side tensions, wraps and laggings that are tried. It is that with
    which the whole verdict is OK, or else the check passes; 0 where it then does not either.

    Parameters
    ----------
    task, evaluate
        As for `find_ways`.
    name
        The check.
    tried
        What was tried, see `Found`.
    """
    variants = _variants(task, tried, name)

    def outcomes(percent: int) -> list[Outcome]:
        factor = 100.0 / (100.0 + percent)
        some = evaluate([variant._replace(pull=factor) for variant in variants])
        return [outcome for outcome in some if is_allowed(outcome, task.now)]

    def whole(percent: int) -> bool:
        return any(score_of(outcome).left == 0 for outcome in outcomes(percent))

    def alone(percent: int) -> bool:
        return any(name not in outcome.levels for outcome in outcomes(percent))

    return least_percent(whole) or least_percent(alone)


def least_percent(passes: Callable[[int], bool]) -> int:
    """Return the least whole percent that passes; 0 where none up to `MOST` does."""
    low, high = 0, 8
    while not passes(high):
        low, high = high, 2 * high
        if high > MOST:
            return 0
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if passes(middle) else (middle, high)
    return high


def _variants(task: Task, tried: Sequence[Candidate], name: str) -> list[Variant]:
    """Return what is tried at every effective tension: of many variants few where each is dear."""
    if task.splits == 1:
        now = Candidate(Variant(), task.now, Score(0, 0))
        best = min((now, *tried), key=lambda one: one.outcome.used.get(name, inf))
        return [best.variant]
    steps = [(task.highest / task.tension) ** (k / _POINTS) for k in range(_POINTS + 1)]
    tensions = [0.0, *(at_rung(rung_above(task.tension * step)) for step in steps[1:])]
    wraps = [0.0, float(MOST_WRAP)] if WRAP in task.kinds and task.wrap < MOST_WRAP else [0.0]
    return [
        Variant(tension=tension, wrap=wrap, lagging=lagging)
        for lagging in ("", *task.laggings)
        for wrap in wraps
        for tension in tensions
    ]
