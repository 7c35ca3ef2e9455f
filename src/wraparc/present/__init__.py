"""Results in words and tables, once for every way of showing them."""

from wraparc.present.catalogue_sheets import belts_sheet, lagging_sheet, laggings_sheet
from wraparc.present.document import json_text, result_document
from wraparc.present.drive_sheet import arc_sheet, drive_sheet, input_sheet
from wraparc.present.notebook import frame, html, sheet_html, sheet_of
from wraparc.present.profile_csv import profile_csv
from wraparc.present.sheet import Level, Row, Sheet, Table, Verdict
from wraparc.present.words import verdict

__all__ = [
    "Level",
    "Row",
    "Sheet",
    "Table",
    "Verdict",
    "arc_sheet",
    "belts_sheet",
    "drive_sheet",
    "frame",
    "html",
    "input_sheet",
    "json_text",
    "lagging_sheet",
    "laggings_sheet",
    "profile_csv",
    "result_document",
    "sheet_html",
    "sheet_of",
    "verdict",
]
