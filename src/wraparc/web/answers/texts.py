"""Documents to and from TOML, and quantities as typed."""

import re
from dataclasses import replace
from typing import get_args

from wraparc.errors import InputError, Problem, input_error, name_remedy, shown
from wraparc.files.lagging_file import lagging_from_document
from wraparc.schema.emit import document_text
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.shared_keys import FORMAT
from wraparc.schema.source import Document, parse
from wraparc.schema.tables import Table
from wraparc.train.keys import TRAIN_FILE
from wraparc.units import (
    DIMENSIONS,
    GIVEN_DIGITS,
    Dimension,
    System,
    display_unit,
    either,
    parse_quantity,
    quantity,
)
from wraparc.web.answers.documents import json_like, kind_of, read, without_none
from wraparc.web.answers.shown import Answer, Data, DriveKind, Text, worded
from wraparc.web.asked import DocumentRequest, LaggingRequest, QuantitiesRequest, TomlRequest
from wraparc.web.errors import ToldProblem, told

_NAME = re.compile(r"[^A-Za-z0-9]+")


class State(Answer):
    """Whether a document describes a drive, and what is wrong in it."""

    kind: DriveKind
    valid: bool
    problems: list[ToldProblem]


class ReadAnswer(State):
    """The document of a text."""

    document: Data


class WriteAnswer(State):
    """The text of a document."""

    toml: str
    name: str


class PlanAnswer(Answer):
    """A plan as the text of its file."""

    toml: str
    name: str


class ReadLaggingAnswer(Answer):
    """A lagging as a table for a drive document."""

    name: str
    title: str
    lagging: Data


class Quantity(Answer):
    """A quantity as read [SI]; `exact` reads back to the same number."""

    value: float | None = None
    text: Text | None = None
    exact: Text | None = None
    problem: ToldProblem | None = None


class QuantitiesAnswer(Answer):
    """Quantities as read."""

    items: list[Quantity]


def read_toml(asked: TomlRequest) -> ReadAnswer:
    """Text of a drive file to its document."""
    document = json_like(parse(asked.toml, asked.name))
    return ReadAnswer(document=document, **_state(document))


def write_toml(asked: DocumentRequest) -> WriteAnswer:
    """Document to the text of a drive file."""
    document = asked.document
    state = _state(document)
    try:
        text = document_text({"format": FORMAT, **without_none(document)}, TRAIN_FILE)
        parse(text)
    except (TypeError, ValueError, RecursionError) as error:
        if isinstance(error, InputError):
            raise
        message = "contains what a drive file cannot"
        raise input_error(message=message, remedy="Use text, numbers, tables.") from None
    return WriteAnswer(toml=text, name=f"{file_stem(document.get('title'))}.toml", **state)


def plan_text(document: Document, table: Table, name: object, otherwise: str) -> PlanAnswer:
    """Return a plan as its file; `name` is what it is called, `otherwise` where it has no name."""
    text = document_text({"format": FORMAT, **without_none(document)}, table)
    return PlanAnswer(toml=text, name=f"{file_stem(name, otherwise)}.toml")


def _state(document: Document) -> Data:
    problems: tuple[Problem, ...] = ()
    try:
        read(document)
    except InputError as error:
        problems = error.problems
    return {"kind": kind_of(document), "valid": not problems, "problems": told(problems)}


def file_stem(title: object, otherwise: str = "drive") -> str:
    """Return a file name without ending for a title."""
    stem = _NAME.sub("-", title[:200]).strip("-").lower() if isinstance(title, str) else ""
    return stem[:60].strip("-") or otherwise


def read_lagging(asked: LaggingRequest) -> ReadLaggingAnswer:
    """Text of a lagging file to a table for a drive document."""
    document = parse(asked.toml)
    first = lagging_from_document(document)[0]
    table = {k: v for k, v in json_like(document).items() if k not in ("format", "name")}
    return ReadLaggingAnswer(name=first.name, title=first.title, lagging=table)


def quantities(asked: QuantitiesRequest) -> QuantitiesAnswer:
    """Quantities as typed, read as strictly as in files, and converted."""
    return QuantitiesAnswer(items=[_quantity(item.text, item.dimension) for item in asked.items])


def _quantity(text: str, dimension: str) -> Quantity:
    of: Dimension | None = next((d for d in get_args(Dimension) if d == dimension), None)
    try:
        if of is None:
            known = name_remedy(dimension, DIMENSIONS)
            problem = Problem(message="no such dimension", remedy=known, value=shown(dimension))
            raise InputError(problem)
        value = parse_quantity(text, of)
    except InputError as error:
        problem = replace(error.problems[0], value=error.problems[0].value or shown(text))
        return Quantity(problem=told([problem])[0])
    return Quantity(
        value=value,
        text=worded(quantity(value, of, GIVEN_DIGITS)),
        exact=worded(either(*(exact_text(value, of, system) for system in get_args(System)))),
    )


def exact_text(value: float, dimension: Dimension, system: System) -> str:
    """Return a value [SI] as the shortest text in the unit of a system that reads back equal.

    The SI text if none of the other system does, as for a third of an inch.
    """
    if system == "si" or dimension == "temperature":
        return quantity_text(value, dimension)
    unit, factor = display_unit(dimension, system)
    for digits in range(3, 18):
        text = f"{value / factor:.{digits}g}"
        if "e" in text:
            text = f"{float(text):.15g}"
        if "e" not in text and parse_quantity(f"{text} {unit}".strip(), dimension) == value:
            return f"{text} {unit}".strip()
    return quantity_text(value, dimension)
