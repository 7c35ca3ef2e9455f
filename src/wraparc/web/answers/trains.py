"""Trains: how several drives share the load, and how exactly they must be matched."""

from typing import Any

import numpy as np

from wraparc.arc import Distributed
from wraparc.drive import Lagging
from wraparc.drive.conditions import Condition
from wraparc.errors import InputError, Problem, placed, shown
from wraparc.present.document import sources_of
from wraparc.present.train_document import matching_document, train_document
from wraparc.present.train_sheet import matching_sheet, train_sheet
from wraparc.train import Train, TrainResult, match_drives, share_map, solve_train
from wraparc.train.file import train_from_document
from wraparc.units import parse_quantity
from wraparc.web.answers.documents import without_none
from wraparc.web.answers.shown import Data, rounded, sheet_data

_MAP_POINTS = 61


def train_data(result: TrainResult) -> Data:
    """Return what a solved train has to say beside its arcs."""
    sheet = sheet_data(lambda system: train_sheet(result, system))
    drive = result.drive_result().drive
    return {**clean(train_document(result)), **sheet, "sources": sources_of(drive)}


def train(request: Data) -> Data:
    """Divide the load; with ``match``, also show how it moves with speed, diameter and load."""
    thing = train_from_document(without_none(request["document"]))
    name = request["load_case"] or ""
    _known_case(thing, name)
    result = solve_train(thing, method=Distributed(capacities=False), raise_on_failure=False)
    found = train_data(result)
    found["matching"] = _matching(thing, result, request) if request["match"] else None
    return found


def _matching(thing: Train, result: TrainResult, request: Data) -> Data:
    case, drive = request["load_case"] or "", _drive(thing, request["drive"])
    span = request["span"]
    matching = match_drives(
        result,
        case,
        drive=drive,
        wear=_quantity("wear", request["wear"], "length"),
        laggings=wet_laggings(thing),
        span=None if span is None else (_trim(span[0]), _trim(span[1])),
        points=request["points"],
    )
    over = None
    if request["map"]:
        values = matching.trim.values
        over = share_map(
            result,
            case,
            drive=drive,
            x=np.linspace(values[0], values[-1], _MAP_POINTS),
            y=np.linspace(0.1, 1.25, _MAP_POINTS),
        )
    data = clean(matching_document(matching, over))
    return {"map": None, **data, **sheet_data(lambda s: matching_sheet(result, matching, s))}


def clean(value: Any) -> Any:
    """Return plain data with None for what is not finite and arrays rounded."""
    if isinstance(value, dict):
        return {key: clean(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        if value and all(isinstance(item, float) for item in value):
            return rounded(value, 7)
        return [clean(item) for item in value]
    if isinstance(value, float):
        return value if np.isfinite(value) else None
    return value


def wet_laggings(thing: Train) -> dict[str, Lagging]:
    """Return the laggings when wet, by the design values of DIN 22101 where it has some."""
    wet = Condition(name="wet", standard="DIN 22101")
    found = {}
    for pulley in thing.pulleys:
        if pulley.lagging.condition != wet.name and pulley.lagging.surface:
            try:
                found[pulley.name] = wet.lagging(pulley.lagging)
            except InputError:  # the standard says nothing about this surface
                continue
    return found


def _drive(thing: Train, name: str | None) -> int:
    names = [p.name for p in thing.pulleys]
    if len(names) < 2:
        message = "the drive has one pulley, which shares its load with nobody"
        raise InputError(Problem(message=message, remedy="Add a pulley.", key="pulley"))
    if name is None:
        return 1
    if name in names[1:]:
        return names.index(name)
    message = "trims are relative to the first drive" if name in names else "no such pulley"
    remedy = f"Choose one of {', '.join(map(shown, names[1:]))}."
    raise InputError(Problem(message=message, remedy=remedy, key="drive", value=shown(name)))


def _known_case(thing: Train, name: str) -> None:
    with placed("load_case"):
        thing.case(name)


def _trim(text: str) -> float:
    return _quantity("span", text, "number")


def _quantity(key: str, text: str, dimension: Any) -> float:
    from dataclasses import replace

    try:
        return parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(replace(error.problems[0], key=key)) from None
