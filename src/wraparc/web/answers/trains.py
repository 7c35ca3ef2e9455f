"""Trains: how several drives share the load, and how exactly they must be matched."""

from dataclasses import replace

import numpy as np

from wraparc.answer.document import sources_of
from wraparc.answer.train_document import matching_document, train_document
from wraparc.answer.train_sheet import matching_sheet, train_sheet
from wraparc.answer.words import format_verdict, stated_action
from wraparc.arc import Distributed
from wraparc.checks import judge
from wraparc.errors import InputError, input_error, shown
from wraparc.train import Matching, Train, TrainResult, match_drives, share_map, solve_train
from wraparc.train.file import train_from_document
from wraparc.train.matching import wet_laggings
from wraparc.units import Dimension, parse_quantity
from wraparc.web.answers.documents import case_only, without_none
from wraparc.web.answers.shown import Answer, Data, Numbers, Sheet, Source, Verdict, plain, sheet
from wraparc.web.asked import TrainRequest

_MAP_POINTS = 61


class Mark(Answer):
    """A point of a curve that has a name."""

    what: str
    pulley: str
    at: float | None
    shares: Numbers
    loss_ratio: float | None


class Curve(Answer):
    """Shares and creeps [m] over a difference between the drives, by pulley."""

    axis: str
    values: Numbers
    shares: dict[str, Numbers]
    exit_creep: dict[str, Numbers]
    loss_ratio: Numbers
    marks: list[Mark]


class Map(Answer):
    """Shares over two differences at once, by pulley."""

    across: str
    down: str
    x: Numbers
    y: Numbers
    shares: dict[str, list[Numbers]]


class MatchingPart(Sheet):
    """How exactly the drives must be matched."""

    format: int
    program: dict[str, str]
    file: str
    drive: str
    load_case: Data
    equal_shares: Data
    curves: list[Curve]
    changes: list[Data]
    map: Map | None = None


class TrainPart(Sheet):
    """How the drives share the load, by load case [SI]."""

    solved: bool
    least_tension: Data | None
    load_cases: list[Data]
    sources: list[Source]


class TrainAnswer(TrainPart):
    """A train with its load divided; `judged` is each of its load cases."""

    judged: list[Verdict]
    matching: MatchingPart | None


def train(asked: TrainRequest) -> TrainAnswer:
    """Several drives on one belt; with ``match``, how the load moves with speed and diameter."""
    thing = train_from_document(without_none(asked.document))
    case_only(thing, asked.load_case or None)  # which is refused if there is none of this name
    result = solve_train(thing, method=Distributed(capacities=False), raise_on_failure=False)
    matching = _matching(thing, result, asked) if asked.match else None
    told = (judge(result).within(case.case.name) for case in result)
    judged = [Verdict.of(format_verdict(of, of.full, stated_action(of))) for of in told]
    return TrainAnswer(judged=judged, matching=matching, **train_part(result).model_dump())


def train_part(result: TrainResult, *, search: bool = True) -> TrainPart:
    """Return what a solved train has to say beside its arcs."""
    told = {
        **plain(train_document(result, search=search)),
        **sheet(train_sheet(result, search=search)),
    }
    return TrainPart(**told, sources=[Source(**s) for s in sources_of(result.drive_result().drive)])


def _matching(thing: Train, result: TrainResult, asked: TrainRequest) -> MatchingPart:
    case, drive, span = asked.load_case or "", _drive(thing, asked.drive), asked.span
    matching = match_drives(
        result,
        case,
        drive=drive,
        wear=_quantity("wear", asked.wear, "length"),
        laggings=wet_laggings(thing),
        span=None if span is None else (_trim(span[0]), _trim(span[1])),
        points=asked.points,
    )
    over = None
    if asked.map:
        values = matching.trim.values
        over = share_map(
            result,
            case,
            drive=drive,
            x=np.linspace(values[0], values[-1], _MAP_POINTS),
            y=np.linspace(0.1, 1.25, _MAP_POINTS),
        )
    told = plain(matching_document(result, matching, over))
    return MatchingPart(**{**told, **_sheet(result, matching)})


def _sheet(result: TrainResult, matching: Matching) -> Data:
    return sheet(matching_sheet(result, matching))


def _drive(thing: Train, name: str | None) -> int:
    names = [p.name for p in thing.pulleys]
    if len(names) < 2:
        message = "trim needs two or more drive pulleys; this drive has one"
        raise input_error(message=message, remedy="Add a pulley.", key="pulley")
    if name is None:
        return 1
    if name in names[1:]:
        return names.index(name)
    message = "trims are relative to the first drive" if name in names else "no such pulley"
    remedy = f"Choose one of {', '.join(map(shown, names[1:]))}."
    raise input_error(message=message, remedy=remedy, key="drive", value=shown(name))


def _trim(text: str) -> float:
    return _quantity("span", text, "number")


def _quantity(key: str, text: str, dimension: Dimension) -> float:
    try:
        return parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(replace(error.problems[0], key=key)) from None
