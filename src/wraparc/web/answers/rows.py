"""Answers as CSV, for spreadsheets that ask the server themselves: a line for each of a kind."""

import csv
import io
from collections.abc import Callable, Iterable
from typing import Any

from wraparc.render.profile_csv import no_formula
from wraparc.web.answers.compare import CompareAnswer
from wraparc.web.answers.drives import FastAnswer, SolveAnswer
from wraparc.web.answers.shown import Answer, Data
from wraparc.web.answers.trains import TrainAnswer

MEDIA = "text/csv"
#: Which answers have lines.
WITH_ROWS = (FastAnswer, SolveAnswer, CompareAnswer, TrainAnswer)


def csv_of(function: Callable[..., Answer], *asked: Any) -> bytes:
    """Return what a function gives as CSV: numbers are SI, under the names of the glossary."""
    return csv_bytes(rows_of(function(*asked)))


def rows_of(answer: Answer) -> list[Data]:
    """Return the lines of an answer."""
    if isinstance(answer, FastAnswer):
        return [_arc(answer)]
    if isinstance(answer, SolveAnswer):
        return [_arc(arc) for arc in answer.arcs]
    if isinstance(answer, CompareAnswer):
        what = {"name", "title", "condition", "level", "short", "kind", "source"}
        return [
            row.model_dump(include=what) | {key: cell.value for key, cell in row.cells.items()}
            for row in answer.rows
        ]
    if isinstance(answer, TrainAnswer):
        return [
            {"load_case": case["load_case"], "status": case["status"], **drive}
            for case in answer.load_cases
            for drive in case["drives"]
        ]
    raise TypeError(type(answer).__name__)


def _arc(arc: Any) -> Data:
    return {**arc.model_dump(include={"pulley", "load_case", "status", "level"}), **arc.numbers}


def _cell(value: Any) -> Any:
    if isinstance(value, float):
        return value + 0.0  # no -0.0
    return no_formula(value) if isinstance(value, str) else value


def csv_bytes(rows: Iterable[Data]) -> bytes:
    """Return lines as CSV in UTF-8, with a mark for Excel; no text becomes a formula."""
    found = list(rows)
    names = list(dict.fromkeys(name for row in found for name in row))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(names)
    for row in found:
        cells = (row.get(name) for name in names)
        writer.writerow([_cell(cell) for cell in cells])
    return out.getvalue().encode("utf-8-sig")
