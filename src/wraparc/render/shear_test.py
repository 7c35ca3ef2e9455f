"""The report of a fitted test plan: PDF, PNG or HTML."""

import os
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from wraparc.answer.shear_test_head import (
    digests_table,
    signature_table,
    signatures,
    title_box,
)
from wraparc.answer.shear_test_tables import plan_sheet, plan_tables
from wraparc.answer.sheet import Row, Sheet, Table, shown
from wraparc.errors import InputError
from wraparc.plot.shear_test import condition_pictures
from wraparc.render.drawings import Drawing
from wraparc.render.note import PROGRAM, Section
from wraparc.render.note_pdf import sections_data
from wraparc.render.page import sheet_page
from wraparc.render.typesetting import typeset_pages, typeset_pdf
from wraparc.saving import save_file, saving_problems
from wraparc.shear_test.analysis import PlanResult
from wraparc.units import System

#: Endings that a report may have.
SUFFIXES = (".pdf", ".png", ".html")


@dataclass(frozen=True)
class Report:
    """The report of a fitted plan, ready to be saved.

    Parameters
    ----------
    result
        What was fitted.
    sheet
        Verdict, tables and remarks.
    drawings
        Its pictures.
    """

    result: PlanResult
    sheet: Sheet
    drawings: tuple[Drawing, ...]

    @property
    def date(self) -> str:
        """When it was computed."""
        return self.result.date

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the report, whole or not at all.

        Parameters
        ----------
        path
            Ends in ``.pdf``, ``.png`` (one long page) or ``.html`` (no other file needed).

        Raises
        ------
        MissingExtraError
            If matplotlib is not installed, or typst for PDF and PNG.
        InputError
            If the ending is another, or the file cannot be written.
        """
        problems = saving_problems(path, suffixes=SUFFIXES)
        if problems:
            raise InputError(problems)
        kind = Path(path).suffix.lower()
        if kind == ".pdf":
            save_file(path, typeset_pdf(_data(self), self.drawings, self.date))
        elif kind == ".png":
            (page,) = typeset_pages(_data(self, single=True), self.drawings, ppi=110)
            save_file(path, page)
        else:
            pictures = [(d.caption, d.draw().to_bytes("svg").decode()) for d in self.drawings]
            save_file(path, sheet_page(_signed(self), pictures, f"{PROGRAM}, {self.date}"))


def make_report(result: PlanResult, system: System = "si", *, laws: bool = False) -> Report:
    """Return the report of a fitted plan.

    Parameters
    ----------
    result
        From `fit_plan`.
    system
        Units to show in the tables; pictures are in mm and kPa, like A and b.
    laws
        As in `plan_sheet`.
    """
    sheet = shown(plan_sheet(result, laws=laws), system)
    sheet = replace(sheet, tables=(*sheet.tables, digests_table(result)))
    return Report(result, sheet, tuple(_drawings(result)))


def _signed(report: Report) -> Sheet:
    """The sheet of a page, with what stands in the title box and in the block to sign."""
    sheet = report.sheet
    box = Table("Report", tuple(Row(name, (text,)) for name, text in title_box(report.result)))
    return replace(sheet, tables=(box, *sheet.tables, signature_table(report.result)))


def _drawings(result: PlanResult) -> Iterator[Drawing]:
    several = len(result.conditions) > 1
    for condition in result.conditions:
        pictures = condition_pictures(condition, result.plan.saturation_pressure)
        for caption, draw in pictures.values():
            text = f"{condition.condition}: {caption}" if several else caption
            yield Drawing(draw, text, text)


def _data(report: Report, *, single: bool = False) -> dict[str, Any]:
    sheet, verdict = report.sheet, report.sheet.verdict
    front = len(plan_tables(report.result))
    sections = (
        Section("", tables=sheet.tables[:front]),
        Section("Remarks", sentences=(*(verdict.sentences if verdict else ()), *sheet.remarks)),
        Section("", drawings=report.drawings),
        # each by itself, in the order of the sheet: side by side they would be too narrow
        *(Section("", tables=(table,)) for table in sheet.tables[front:]),
        Section("Sources", sentences=sheet.sources),
    )
    return {
        "kind": "Test report · friction between belt and lagging",
        "title": sheet.title,
        "subtitle": sheet.subtitle,
        "author": "",
        "date": report.date,
        "paper": "a4",
        "box": title_box(report.result),
        "footer": tuple(p for p in (PROGRAM, report.result.plan.head.number, report.date) if p),
        "single": single,
        "signatures": signatures(report.result),
        "level": str(verdict.level) if verdict else "OK",
        "headline": verdict.text if verdict else "",
        "lines": ((verdict.word, verdict.text), *verdict.lines) if verdict else (),
        "sections": sections_data(s for s in sections if s.sentences or s.tables or s.drawings),
    }
