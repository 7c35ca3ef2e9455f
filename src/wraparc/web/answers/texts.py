"""Documents to and from TOML, and quantities as typed."""

import re
from dataclasses import replace
from typing import Any, get_args

from wraparc.errors import InputError, Problem, shown
from wraparc.files.lagging_file import lagging_from_document
from wraparc.schema.emit import document_text
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.shared_keys import FORMAT
from wraparc.schema.source import Document, parse
from wraparc.units import DIMENSIONS, Dimension, System, display, display_unit, parse_quantity
from wraparc.web.answers.documents import read, without_none
from wraparc.web.answers.shown import Data, both
from wraparc.web.errors import problem_data, problems_data

_NAME = re.compile(r"[^A-Za-z0-9]+")


def read_toml(request: Data) -> Data:
    """Return the document of a text, with what is wrong in it."""
    document = json_like(parse(request["toml"], request["name"]))
    return {"document": document, **_state(document)}


def write_toml(request: Data) -> Data:
    """Return the text of a document, with what is wrong in it."""
    document = request["document"]
    state = _state(document)
    try:
        text = document_text({"format": FORMAT, **without_none(document)})
        parse(text)
    except (TypeError, ValueError, RecursionError) as error:
        if isinstance(error, InputError):
            raise
        message = "holds what a drive file cannot hold"
        raise InputError(Problem(message=message, remedy="Use text, numbers, tables.")) from None
    title = document.get("title")
    return {"toml": text, "name": f"{file_stem(title)}.toml", **state}


def _state(document: Document) -> Data:
    kind = "train" if "train" in document else "drive"
    pulleys = document.get("pulley")
    if isinstance(pulleys, list) and len(pulleys) > 1:
        kind = "train"
    try:
        read(document)
    except InputError as error:
        return {"kind": kind, "valid": False, "problems": problems_data(error.problems)}
    return {"kind": kind, "valid": True, "problems": []}


def file_stem(title: object) -> str:
    """Return a file name without ending for a title."""
    stem = _NAME.sub("-", title[:200]).strip("-").lower() if isinstance(title, str) else ""
    return stem[:60].strip("-") or "drive"


def json_like(value: Any) -> Any:
    """Return a document with dates and times as text: JSON has none."""
    if isinstance(value, dict):
        return {key: json_like(item) for key, item in value.items()}
    if isinstance(value, list):
        return [json_like(item) for item in value]
    if isinstance(value, bool | int | float | str):
        finite = not isinstance(value, float) or abs(value) < float("inf")
        return value if finite else str(value)
    return str(value)


def read_lagging(request: Data) -> Data:
    """Return the lagging of the text of a lagging file, as a table for a drive document."""
    document = parse(request["toml"])
    first = lagging_from_document(document)[0]
    table = {k: v for k, v in json_like(document).items() if k not in ("format", "name")}
    return {"name": first.name, "title": first.title, "lagging": table}


def quantities(request: Data) -> Data:
    """Return typed quantities as values and as texts in both systems."""
    return {"items": [_quantity(item["text"], item["dimension"]) for item in request["items"]]}


def _quantity(text: str, dimension: str) -> Data:
    empty: Data = {"value": None, "text": None, "exact": None, "problem": None}
    if dimension not in DIMENSIONS:
        known = ", ".join(DIMENSIONS)
        problem = Problem(
            message="no such dimension", remedy=f"Known are {known}.", value=shown(dimension)
        )
        return {**empty, "problem": problem_data(problem)}
    of: Dimension = next(d for d in get_args(Dimension) if d == dimension)
    try:
        value = parse_quantity(text, of)
    except InputError as error:
        problem = replace(error.problems[0], value=error.problems[0].value or shown(text))
        return {**empty, "problem": problem_data(problem)}
    return {
        "value": value,
        "text": both(lambda system: display(value, of, system)),
        "exact": both(lambda system: exact_text(value, of, system)),
        "problem": None,
    }


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
