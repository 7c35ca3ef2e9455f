"""An answer as plain data, one form for every question: what a sheet says, numbers in SI.

``docs/reference/answer.schema.json`` describes it.
"""

from collections.abc import Mapping
from typing import Any

from wraparc.present.document import json_text
from wraparc.present.sheet import Row, Sheet, Table
from wraparc.units import DIMENSION_TEXT, Cell, cells_in, in_units

#: Counts up when a key goes or changes its meaning, not when one is added.
ANSWER_FORMAT = 1

Data = dict[str, Any]


def answer_json(document: Mapping[str, Any], sheet: Sheet) -> str:
    """Return a document of a question as JSON, its answer under ``answer``."""
    return json_text({**document, "answer": answer_data(sheet)})


def answer_data(sheet: Sheet) -> Data:
    """Return an answer: verdict, tables, remarks and sources.

    Every text that may hold numbers comes with them: ``text`` in metric units, and ``cells``, the
    numbers in it in their order.
    """
    told = sheet.verdict
    verdict = told and {
        "level": told.level.value,
        "word": told.told,
        "headline": _said(told.headline),
        "action": _said(told.action),
        "sentences": [_said(sentence) for sentence in told.sentences],
    }
    return {
        "format": ANSWER_FORMAT,
        "title": sheet.title,
        "subtitle": _said(sheet.subtitle),
        "verdict": verdict,
        "tables": [_table(table) for table in sheet.tables],
        "remarks": [_said(remark) for remark in sheet.remarks],
        "sources": list(sheet.sources),
    }


def _table(table: Table) -> Data:
    return {
        "name": table.name,
        "title": in_units(table.title),
        "heads": [in_units(head) for head in table.heads],
        "rows": [_row(row) for row in table.rows],
        "note": _said(table.note),
    }


def _row(row: Row) -> Data:
    return {
        "name": row.name,
        "title": _said(row.title),
        "symbol": row.symbol,
        "values": [_said(value) for value in row.values],
        "level": row.level and row.level.value,
        "note": _said(row.note),
    }


def _said(text: str) -> Data:
    return {"text": in_units(text), "cells": [_cell(c) for c in cells_in(text) if c.form != "unit"]}


def _cell(cell: Cell) -> Data:
    return {
        "name": cell.name,
        "value": cell.value,
        "from": cell.other if cell.form in ("to", "-") else None,
        "unit": DIMENSION_TEXT[cell.dimension].si_unit or "1",
    }
