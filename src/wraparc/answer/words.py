"""The answer in words: the verdict of the checks, and what to know of an arc that governs."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from wraparc.answer.least_tension import least_sentence
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sheet import Also, Verdict, named
from wraparc.arc import ArcResult, DriveResult, Status
from wraparc.checks import Check, Level, idle, judge
from wraparc.checks import Verdict as Judgement
from wraparc.checks.action import Action
from wraparc.drive import Drive, LoadCase, Tensions

if TYPE_CHECKING:
    from wraparc.train import TrainResult

#: Stands for a place without bound, which JSON does not have.
_FAR = 1e12


def verdict(result: DriveResult, *, search: bool = True) -> Verdict:
    """Return the answer for a whole drive.

    Parameters
    ----------
    result
        The solved drive.
    search
        Whether changes of the drive are tried: for the action, and of stated uncertainties.
    """
    judged, worst = _judge(result, search=search), result.governing
    sentences = [*minimum_sentences(result), *judged.full]
    if worst.status is Status.BREAKAWAY:
        sentences += _breakaway(worst)
    return format_verdict(judged, sentences, action_of(result, search=search))


def whole_verdict(result: "DriveResult | TrainResult", *, search: bool = True) -> Verdict:
    """Return the verdict on a drive or train, to stand under the answer to another question."""
    judged = _judge(result, search=search)
    told = format_verdict(judged, judged.full, action_of(result, search=search))
    return replace(told, checks_at="wraparc solve")


def action_of(result: "DriveResult | TrainResult", *, search: bool = True) -> Action | None:
    """Return what to do about a drive or train: tried, or what the governing check states."""
    if not search or not judge(result).missed:
        return stated_action(_judge(result, search=search))
    from wraparc.actions import find_action  # solves rows and trains: only where something is amiss

    return find_action(result)


def _judge(result: "DriveResult | TrainResult", *, search: bool) -> Judgement:
    """Return the verdict; with the check of stated uncertainties where changes are tried at all."""
    return judge_uncertain(result) if search else judge(result)


def minimum_sentences(result: "DriveResult | TrainResult") -> Iterator[str]:
    """Yield the sentence on the minimum slack-side tension, where there is one."""
    sentence = least_sentence(result)
    if sentence:
        yield sentence


def stated_action(judged: Judgement) -> Action | None:
    """Return what the governing check states itself, for which nothing is tried."""
    worst = judged.kind_in_doubt or judged.governing
    return Action(worst.action_text) if worst is not None and worst.action else None


def format_verdict(
    judged: Judgement, sentences: Sequence[str] = (), action: Action | None = None
) -> Verdict:
    """Return the verdict on a drive as every door shows it.

    Parameters
    ----------
    judged
        What the checks come to.
    sentences
        What a full answer says besides.
    action
        What to do.
    """
    worst = judged.governing
    return Verdict(
        judged.level,
        judged.text,
        tuple(sentences),
        judged.label,
        action,
        tuple(Also(check.level, check.text, check) for check in judged.also),
        wet=judged.wet_text,
        data=judged.data.text,
        name="" if worst is None else worst.name,
        check=worst,
        judged=judged,
    )


def under(own: Verdict, drive: Verdict) -> Verdict:
    """Return the answer to another question about a drive, with the verdict on the drive under it.

    The level is the worse of both; the drive's sentence is the first of what else is missed. Where
    the other question is one of checks, as of an event, the worse of both leads.
    """
    first, second = own, drive
    if own.check is not None and drive.level.rank > own.level.rank:
        first, second = drive, own
    level = max(own.level, drive.level, key=lambda of: of.rank)
    missed = second.level.rank > Level.OK.rank
    told = {_subject(check) for check in (first.check, *(o.check for o in first.also)) if check}
    others = (other for other in second.also if _subject(other.check) not in told)
    also = (Also(second.level, second.text, second.check), *others) if missed else ()
    return replace(
        first,
        level=level,
        sentences=own.sentences,
        label=own.label or drive.label if level is Level.OK else "",
        action=first.action or second.action,
        also=(*first.also, *also),
        wet=drive.wet if own.check is None else own.wet,
        checks_at="wraparc solve" if own.check is None else own.checks_at,
        data=own.data or drive.data,
        judged=own.judged or drive.judged,
    )


def _subject(check: Check | None) -> tuple[str, str]:
    """Return what a check is of, wherever and whenever it is missed: said once."""
    return ("", "") if check is None else (check.name, check.place.pulley)


def level_of(result: "DriveResult | TrainResult", arc: ArcResult) -> Level:
    """Return how good the news of one arc of a drive or train is."""
    return judge(result).at(arc.arc.pulley, arc.arc.load_case).level


def order_in(judged: Judgement) -> float:
    """Return the place of a verdict among those of its level: the least is the worst."""
    worst = judged.governing
    return 0.0 if worst is None else max(-_FAR, min(worst.order[1], _FAR))


def short(result: "DriveResult | TrainResult", arc: ArcResult) -> str:
    """Return the answer for one arc in a few words, for a table."""
    if arc.status is Status.BREAKAWAY:
        return f"{Level.FAILS} gross slip"
    worst = judge(result).at(arc.arc.pulley, arc.arc.load_case).governing
    if worst is not None and worst.missed:
        return f"{worst.level} {worst.label}"
    return "OK, not driven" if idle(arc.arc) else str(Level.OK)


def alone(drive: Drive, arc: ArcResult) -> DriveResult:
    """Return one arc as a result to be judged: its pulley, at the tensions it was solved for."""
    name, solved = arc.arc.load_case, arc.arc
    tensions = Tensions(entry=solved.entry_tension, exit=solved.exit_tension)
    own = next((case for case in drive.load_cases if case.name == name), None)
    case = LoadCase(
        name=name,
        tensions={arc.arc.pulley: tensions},
        kind=own.kind if own else "running",
        condition=own.condition if own else "",
    )
    pulley = drive.pulley(arc.arc.pulley)
    criteria, take_up = drive.criteria, drive.criteria.take_up
    if take_up.after not in ("", pulley.name):  # it stands at a pulley that is left out
        criteria = replace(criteria, take_up=replace(take_up, after=""))
    own_case = replace(
        drive, criteria=criteria, pulleys=(pulley,), load_cases=(case,), conveyor=None
    )
    return DriveResult(own_case, (arc,))


_among: WeakKeyDictionary[DriveResult, dict[ArcResult, DriveResult]] = WeakKeyDictionary()


def alone_of(result: DriveResult, arc: ArcResult) -> DriveResult:
    """Return one arc of a drive by itself, always the same: so it is judged once."""
    known = _among.setdefault(result, {})
    if arc not in known:
        known[arc] = alone(result.drive, arc)
    return known[arc]


def _breakaway(result: ArcResult) -> Iterator[str]:
    c, arc = result.capacities, result.arc
    if math.isnan(c.creep_limit_capacity):
        return  # the paper's integration finds no capacities
    ratio = c.creep_limit_capacity if arc.side > 0.0 else 1.0 / c.creep_limit_capacity
    yield (
        f"T1/T2 required: {named('tension_ratio', result.tension_ratio)}; transmissible at the "
        f"creep limit: {named('tension_ratio', ratio)}."
    )
