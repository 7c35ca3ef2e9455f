"""What to do about the verdict on a solved drive or train."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, isfinite
from weakref import WeakKeyDictionary

from wraparc import catalogue
from wraparc.actions.by_check import GRIP, first_phrase, kinds_of, last_phrase
from wraparc.actions.document import Source, source_of
from wraparc.actions.rows import RowEvaluator
from wraparc.actions.score import DATA_CHECKS, names_left
from wraparc.actions.search import Evaluate, find_ways
from wraparc.actions.single import FilteredEvaluator, SingleEvaluator, outcome_of
from wraparc.actions.texts import Names, none_text, phrase_of, sentence_of
from wraparc.actions.too_large import percent_too_large
from wraparc.actions.variant import DIAMETER, LAGGING, RAISE, WRAP, Task
from wraparc.checks.action import Action, Way
from wraparc.checks.check import Check, Level
from wraparc.checks.judge import judge
from wraparc.checks.least_tension import least_tension
from wraparc.checks.of_drive import allowed_tension
from wraparc.checks.of_wet import WET_CREEP
from wraparc.checks.usual import USUAL_RULE
from wraparc.checks.verdict import Verdict
from wraparc.drive import Drive
from wraparc.train.whole import Whole, by_pulley

#: Largest tension that is tried over that of now [-]; and twice what the belt is allowed.
_MOST_TENSION = 4.0
#: Part of the tension that a belt keeps where least of it is tried [-].
_LEAST_TENSION = 0.05
#: Times its usual end, an input is one that no drive has [-].
_FAR_OUTSIDE = 3.0
#: Tensions that are tried first, by rows and one by one, and values then at once.
_ROW_POINTS, _ROW_SPLITS, _SINGLE_POINTS = 24, 24, 4

_actions: WeakKeyDictionary[Whole, list[Action | None]] = WeakKeyDictionary()


def find_action(result: Whole) -> Action | None:
    """Return what to do about the verdict on a drive or train, tried before it is told.

    A way is offered first if the whole verdict is OK with it: one change alone, then two, then
    three; if none is, the one that leaves fewest checks missed. It never makes a check fail that
    passed. The same result is asked once, however often it is told.

    Returns
    -------
    None where every check passes.
    """
    if result not in _actions:
        _actions[result] = [_find(result)]
    return _actions[result][0]


def _find(result: Whole) -> Action | None:
    verdict = judge(result)
    worst = verdict.governing
    if worst is None or not worst.missed:
        return None
    if worst.level is Level.FAULT or worst.name in DATA_CHECKS or not kinds_of(worst):
        return own_action(worst)
    doubtful = verdict.kind_in_doubt or _implausible(verdict)
    if doubtful is not None:
        return own_action(doubtful)
    if worst.name == "operating_point" and worst.action:  # a motor: no tension, wrap or lagging
        return own_action(worst)
    source = source_of(result, _pulleys(verdict, result), _take_up(result))
    if source is None:
        return own_action(worst)
    task = _task(result, verdict, source)
    evaluate = _evaluation(result, source, task)
    found = find_ways(task, evaluate, SingleEvaluator(source).confirmed)
    names = Names(_slack(result), _some_pulleys(source), _called(verdict))
    phrases = [phrase_of(way, task, names) for way in found.ways]
    ways = tuple(
        Way(
            source.changes(way.variant),
            True,
            len(names_left(way.outcome.levels)),
            sentence_of([phrase]),
        )
        for way, phrase in zip(found.ways, phrases, strict=True)
    )
    first = first_phrase(worst)
    last = last_phrase(worst, _lagging(worst, result), source.described.belt)
    alone = sum(check.name not in DATA_CHECKS for check in verdict.missed) == 1
    if first is not None:
        phrases.insert(0, first)
    if last is not None and len(phrases) < 2 and (alone or not phrases):
        phrases.append(last)
    if phrases:
        return Action(sentence_of(phrases), ways)
    if worst.action or RAISE not in kinds_of(worst):
        return own_action(worst)
    percent = percent_too_large(task, evaluate, worst.name, found.tried)
    return Action(none_text(percent, task))


def _called(verdict: Verdict) -> dict[str, str]:
    """Return how the checks of a verdict are called, by name."""
    return {check.name: check.noun for check in verdict.listed} | {WET_CREEP.name: "wet creep"}


def _implausible(verdict: Verdict) -> Check | None:
    """Return the input that is farthest outside of what drives have, None if none is far outside.

    By such a number nothing can be advised: it is another one that is meant.
    """
    sizes = [c for c in verdict.missed if c.name == USUAL_RULE.name and c.used > _FAR_OUTSIDE]
    return max(sizes, key=lambda check: check.used, default=None)


def own_action(check: Check) -> Action | None:
    """Return what a check says itself is to be done: no number of it was tried."""
    return Action(check.action_text) if check.action else None


def _evaluation(result: Whole, source: Source, task: Task) -> Evaluate:
    """Return how variants are judged: by rows where those know all that is checked."""
    rows = RowEvaluator(source, by_pulley(result).drive, task.now)
    if is_served(result):
        return rows
    return FilteredEvaluator(rows, SingleEvaluator(source), task.now)


def is_served(result: Whole) -> bool:
    """Return whether rows know all that is checked: of even pulleys, no interval of a law."""
    interval = any(check.name == "creep_interval" for check in judge(result).listed)
    return not interval and all(p.across is None for p in by_pulley(result).drive.pulleys)


def _task(result: Whole, verdict: Verdict, source: Source) -> Task:
    rows, drive = is_served(result), by_pulley(result).drive
    belt, sag = drive.belt, drive.criteria.sag
    now, tension = outcome_of(result, stated=True), source.take_up
    lowest, highest = tension_ends(drive, tension)
    worst = verdict.governing
    own = {pulley.lagging.name for pulley in drive.pulleys if pulley.name in source.pulleys}
    left_out = source.own_laggings | (own if len(own) == 1 else set())
    laggings = [name for name in catalogue.lagging_names() if name not in left_out]
    kinds = [kind for check in verdict.missed for kind in kinds_of(check)]
    if RAISE in kinds:
        kinds += GRIP
    fixed = {DIAMETER} if source.has_worn_diameters else set[str]()
    if not source.wrap:
        fixed |= {WRAP}

    def some(every: Sequence[str]) -> tuple[str, ...]:
        return tuple(kind for kind in dict.fromkeys(every) if kind not in fixed)

    return Task(
        now=now,
        first=some(kinds_of(worst) if worst else ()),
        kinds=some(kinds),
        tension=tension,
        lowest=lowest,
        highest=highest,
        wrap=source.wrap,
        laggings=tuple(laggings),
        rating=belt.rating or 0.0,
        strength=belt.breaking_strength or 0.0,
        diameter=max(p.diameter for p in drive.pulleys if p.name in source.pulleys),
        spacing=sag.spacing if sag is not None else 0.0,
        points=_ROW_POINTS if rows else _SINGLE_POINTS,
        wrap_step=10 if rows else 30,
        splits=_ROW_SPLITS if rows else 1,
        within=1 if rows else 20,
    )


def tension_ends(drive: Drive, tension: float) -> tuple[float, float]:
    """Return between what tensions at the take-up others are tried [N]."""
    pairs = [at for case in drive.load_cases for at in case.tensions.values()]
    least, most = (
        min(min(p.entry, p.exit) for p in pairs),
        max(max(p.entry, p.exit) for p in pairs),
    )
    rating = allowed_tension(drive.belt, "starting") or inf
    highest = min(_MOST_TENSION * most, 2.0 * rating * drive.belt.width)
    return tension - (1.0 - _LEAST_TENSION) * least, tension + highest - most


def _take_up(result: Whole) -> float:
    """Return the tension at the take-up that the table of minimum tensions states as now [N]."""
    least = least_tension(result)
    if least is not None and isfinite(least.given) and least.given > 0.0:
        return least.given
    drive = by_pulley(result).drive
    return drive.take_up_tension(drive.load_case())


def _slack(result: Whole) -> str:
    """Return how the tension at the take-up is called."""
    drive = by_pulley(result).drive
    place = drive.take_up_place
    if not place:
        case = drive.load_case()
        driving = drive.slack_end(case) == case.tensions[drive.pulleys[-1].name].exit
        return "T2" if driving else "T1 (slack-side tension)"
    take_up = drive.criteria.take_up
    if take_up.after:
        return f"the take-up tension behind {take_up.after}"
    return "T2" if take_up.fixed else "the take-up tension"


def _pulleys(verdict: Verdict, result: Whole) -> tuple[str, ...]:
    """Return the pulleys whose lagging or diameter is changed: where a check is missed that asks.

    All of them where none is named.
    """
    wanted = {
        check.place.pulley
        for check in verdict.checks
        if check.missed and {LAGGING, DIAMETER} & set(kinds_of(check))
    }
    names = [pulley.name for pulley in by_pulley(result).drive.pulleys]
    return tuple(name for name in names if name in wanted) or tuple(names)


def _some_pulleys(source: Source) -> tuple[str, ...]:
    """Return the pulleys that are changed, empty where all of them are."""
    return source.pulleys if len(source.pulleys) < len(source.described.pulleys) else ()


def _lagging(check: Check, result: Whole) -> str:
    drive = by_pulley(result).drive
    names = {pulley.name: pulley.lagging.name for pulley in drive.pulleys}
    name = names.get(check.place.pulley, "")
    return f"lagging {name}" if name else "the lagging"
