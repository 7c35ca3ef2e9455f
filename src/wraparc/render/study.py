"""A study as a page that needs no other file."""

import json
from collections.abc import Sequence

from wraparc.answer.sheet import Sheet, shown
from wraparc.render.page import sheet_page
from wraparc.study.monte_carlo import Summary
from wraparc.units import System


def study_page(
    sheet: Sheet, pictures: Sequence[str], summary: Summary, system: System = "si"
) -> str:
    """Return a study as one HTML page: its sheet, pictures as SVG, and the input it rests on."""
    named = [(f"Picture {n}: {sheet.title}", svg) for n, svg in enumerate(pictures, start=1)]
    data = json.dumps(summary.data["input"], indent=1, ensure_ascii=False, default=str)
    program, print_ = summary.data["program"], summary.data["fingerprint"]
    foot = f"{program}, fingerprint {print_}. Input:\n{data}"
    return sheet_page(shown(sheet, system), named, foot)
