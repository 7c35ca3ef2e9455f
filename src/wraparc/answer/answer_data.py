"""An answer as plain data, one form for every question: what a sheet says, numbers in SI.

``docs/reference/answer.schema.json`` describes it.
"""

import math
from collections.abc import Mapping
from typing import Any

from wraparc.answer.document import json_text
from wraparc.answer.sheet import Row, Sheet, Table, Verdict
from wraparc.answer.verdict_data import verdict_object
from wraparc.glossary import GLOSSARY
from wraparc.units import DIMENSION_TEXT, RESULT_DIGITS, Cell, cell_of, in_units, placed
from wraparc.units.cell import RANGES

#: Counts up when a key goes or changes its meaning, not when one is added.
ANSWER_FORMAT = 4

Data = dict[str, Any]
#: A text without numbers, or one with them: see `text_data`.
Text = str | Data


def answer_json(document: Mapping[str, Any], sheet: Sheet) -> str:
    """Return a document of a question as JSON, its answer under ``answer``."""
    return json_text({**document, "answer": answer_data(sheet)})


def answer_data(sheet: Sheet) -> Data:
    """Return an answer: verdict, tables, remarks and sources."""
    told = sheet.verdict
    return {
        "format": ANSWER_FORMAT,
        "title": text_data(sheet.title),
        "subtitle": text_data(sheet.subtitle),
        "verdict": told and verdict_data(told),
        "tables": [table_data(table) for table in sheet.tables],
        "remarks": [text_data(remark) for remark in sheet.remarks],
        "sources": [in_units(source) for source in sheet.sources],
    }


def verdict_data(told: Verdict) -> Data:
    """Return a verdict, its texts with their numbers."""
    return verdict_object(told, text_data)


def table_data(table: Table) -> Data:
    """Return a table."""
    return {
        "name": table.name,
        "title": text_data(table.title),
        "heads": [text_data(head) for head in table.heads],
        "rows": [_row(row) for row in table.rows],
        "note": text_data(table.note),
    }


def _row(row: Row) -> Data:
    return {
        "name": row.name,
        "title": text_data(row.title),
        "symbol": row.symbol,
        "values": [text_data(value) for value in row.values],
        "level": row.level and row.level.value,
        "note": text_data(row.note),
    }


def text_data(text: str) -> Text:
    """Return a text as it is, if it is the same in every system of units.

    Else ``text`` has it in metric units, and ``cells`` the numbers in it in their order; ``us`` has
    it in US units where more than the numbers differs. A text that is one number is its cell.
    """
    if "\x02" not in text and "\x04" not in text:
        return text
    told, cells = placed(text)
    differs = "\x04" in text or not all(_known(cell) for _, cell in cells)
    if len(cells) == 1 and not differs and cell_of(text):
        return {"text": told, **_cell(cells[0][1])}
    found: Data = {"text": told, "cells": [{"at": at, **_cell(cell)} for at, cell in cells]}
    return {**found, "us": in_units(text, "us")} if differs else found if cells else told


def _known(cell: Cell) -> bool:
    return math.isfinite(cell.value) and not (math.isinf(cell.other) and cell.form in RANGES)


def _cell(cell: Cell) -> Data:
    """Return a number and what is said of it that is not usual."""
    found: Data = {"value": cell.value if math.isfinite(cell.value) else None}
    if math.isfinite(cell.other):
        key = "from" if cell.form in RANGES else "error" if cell.form == "bare error" else "apart"
        found[key] = cell.other
    found["unit"] = DIMENSION_TEXT[cell.dimension].si_unit or "1"
    known = GLOSSARY.get(cell.name)
    usual = {
        "name": "",
        "dimension": known and known.dimension,
        "digits": RESULT_DIGITS,
        "form": "",
    }
    told = {key: getattr(cell, key) for key in usual}
    return {**found, **{key: value for key, value in told.items() if value != usual[key]}}
