"""The answer in words: the verdict of the checks, and what to know of an arc that governs."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from wraparc.answer.least_tension import least_sentence
from wraparc.answer.sheet import Verdict, named
from wraparc.arc import ArcResult, DriveResult, Status
from wraparc.checks import Level, idle, judge
from wraparc.checks import Verdict as Judgement
from wraparc.drive import Drive, LoadCase, Tensions

if TYPE_CHECKING:
    from wraparc.train import TrainResult

#: Stands for a place without bound, which JSON does not have.
_FAR = 1e12
#: Which drive is judged beside the answer to another question.
AS_IT_IS = "As it is"


def verdict(result: DriveResult) -> Verdict:
    """Return the answer for a whole drive: the check that governs, then what else is missed."""
    told = judge(result)
    worst = result.governing
    least = least_sentence(result)
    sentences = [*([least] if least else []), *told.others]
    if worst.status is Status.BREAKAWAY:
        sentences += _breakaway(worst)
    said = (*told_twice(told), *([least] if _says_none(told) else []))
    return in_words(told, sentences, [s for s in sentences if s not in said])


def told_twice(told: Judgement) -> tuple[str, ...]:
    """Return the sentence on the data, which the remarks of a short answer tell in full."""
    weak = told.level.rank > Level.OK.rank and told.qualifier and told.data
    return told.others[-1:] if weak else ()


def _says_none(told: Judgement) -> bool:
    """Whether the headline says that no tension is enough."""
    worst = told.governing
    return worst is not None and worst.missed and worst.remedy == worst.otherwise != ""


def in_words(
    told: Judgement, sentences: Sequence[str], kept: Sequence[str] | None = None
) -> Verdict:
    """Return a verdict with its sentences, as a sheet shows it; `kept` are those of a short one."""
    return Verdict(
        told.level,
        told.lead,
        tuple(sentences),
        told.word,
        told.action,
        None if kept is None else tuple(kept),
    )


def as_it_is(told: Judgement, of: str = AS_IT_IS) -> str:
    """Return the verdict on a drive in a sentence, for an answer to another question about it."""
    return f"{of}: {told.lead}"


def in_short(told: Judgement, of: str = AS_IT_IS) -> str:
    """Return what a drive misses as it is, in a few words; else nothing."""
    worst = told.governing
    if worst is None or not worst.missed:
        return ""
    where = f" ({worst.place})" if str(worst.place) else ""
    return f"{of}: {worst.short}{where}."


def under(told: Verdict, judged: Judgement, of: str = AS_IT_IS) -> Verdict:
    """Return the answer to another question about a drive under the verdict on the drive.

    The worse of both leads; `of` says which drive that is.
    """
    level = max(told.level, judged.level, key=lambda of: of.rank)
    as_is = [as_it_is(judged, of)] if judged.missed else []
    return replace(
        told,
        level=level,
        headline=f"{told.headline} {in_short(judged, of)}".rstrip(),
        sentences=(*as_is, *told.sentences),
        word=judged.word if level is Level.OK else "",
    )


def level_of(result: "DriveResult | TrainResult", arc: ArcResult) -> Level:
    """Return how good the news of one arc of a drive or train is."""
    return judge(result).at(arc.arc.pulley, arc.arc.load_case).level


def order_in(told: Judgement) -> float:
    """Return the place of a verdict among those of its level: the least comes off worst."""
    worst = told.governing
    return 0.0 if worst is None else max(-_FAR, min(told.nearness(worst)[1], _FAR))


def short(result: "DriveResult | TrainResult", arc: ArcResult) -> str:
    """Return the answer for one arc in a few words, for a table."""
    if arc.status is Status.BREAKAWAY:
        return "breaks away"
    worst = judge(result).at(arc.arc.pulley, arc.arc.load_case).governing
    if worst is not None and worst.missed:
        return worst.short
    return "not driven" if idle(arc.arc) else "carries"


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
        return  # the paper's march finds no capacities
    ratio = c.creep_limit_capacity if arc.side > 0.0 else 1.0 / c.creep_limit_capacity
    yield (
        f"Asked for T1/T2 = {named('tension_ratio', result.tension_ratio)}; at the creep limit it "
        f"carries T1/T2 = {named('tension_ratio', ratio)}."
    )
