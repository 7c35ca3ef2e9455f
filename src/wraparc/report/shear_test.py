"""The report of a fitted test plan: PDF, PNG or HTML."""

import html
import io
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

from wraparc.errors import InputError, MissingExtraError
from wraparc.present.sheet import Sheet, Table
from wraparc.report.shear_test_pictures import condition_pictures
from wraparc.report.shear_test_tables import plan_sheet
from wraparc.saving import save_file, saving_problems
from wraparc.shear_test.analysis import PlanResult
from wraparc.units import System
from wraparc.version import __version__

#: Endings that a report may have.
SUFFIXES = (".pdf", ".png", ".html")
_PPI = 110

_Pictures = tuple[tuple[str, str, bytes], ...]


@dataclass(frozen=True)
class Report:
    """The report of a fitted plan, its pictures drawn, ready to be saved.

    Parameters
    ----------
    sheet
        Verdict, tables and remarks.
    pictures
        File name, caption and SVG of each.
    footer
        Version and date.
    """

    sheet: Sheet
    pictures: tuple[tuple[str, str, bytes], ...]
    footer: str

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the report, whole or not at all.

        Parameters
        ----------
        path
            Ends in ``.pdf``, ``.png`` (one long page) or ``.html`` (no other file needed).

        Raises
        ------
        MissingExtraError
            If typst is not installed, for PDF and PNG.
        InputError
            If the ending is another, or the file cannot be written.
        """
        problems = saving_problems(path, suffixes=SUFFIXES)
        if problems:
            raise InputError(problems)
        kind = Path(path).suffix.lower()
        if kind == ".html":
            save_file(path, _page(self.sheet, self.pictures, self.footer))
        else:
            save_file(path, _typeset(self, kind[1:]))


def make_report(result: PlanResult, system: System = "si") -> Report:
    """Return the report of a fitted plan.

    Parameters
    ----------
    result
        From `fit_plan`.
    system
        Units to show in the tables; pictures are in mm and kPa, like A and b.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    """
    return Report(
        plan_sheet(result, system),
        tuple(_pictures(result)),
        f"wraparc {__version__}, {result.date}",
    )


def _pictures(result: PlanResult) -> Iterator[tuple[str, str, bytes]]:
    several = len(result.conditions) > 1
    for number, condition in enumerate(result.conditions):
        pictures = condition_pictures(condition, result.plan.saturation_pressure)
        for name, caption, picture in pictures:
            stream = io.BytesIO()
            picture.figure.savefig(stream, format="svg", metadata={"Date": None})
            text = f"{condition.condition}: {caption}" if several else caption
            yield f"{name}-{number}.svg", text, stream.getvalue()


def _typeset(report: Report, kind: str) -> bytes:
    try:
        import typst
    except ImportError:
        raise MissingExtraError("typst", "report") from None
    parts = {name: data for name, _, data in report.pictures}
    parts["main.typ"] = files("wraparc.report").joinpath("shear_test.typ").read_bytes()
    parts["data.json"] = json.dumps(_data(report, single=kind == "png")).encode()
    # The stub of typst does not know that it takes files by name.
    compile_files: Any = typst.compile
    if kind == "png":
        return bytes(compile_files(parts, format="png", ppi=_PPI))
    return bytes(compile_files(parts, format="pdf", pdf_standards=["a-2a", "ua-1"]))


def _data(report: Report, *, single: bool) -> dict[str, Any]:
    sheet, verdict = report.sheet, report.sheet.verdict
    return {
        "title": sheet.title,
        "subtitle": sheet.subtitle,
        "level": str(verdict.level) if verdict else "",
        "headline": verdict.headline if verdict else "",
        "sentences": list(verdict.sentences) if verdict else [],
        "remarks": list(sheet.remarks),
        "sources": list(sheet.sources),
        "pictures": [{"file": name, "caption": caption} for name, caption, _ in report.pictures],
        "tables": [_table(table) for table in sheet.tables],
        "footer": report.footer,
        "single": single,
    }


def _table(table: Table) -> dict[str, Any]:
    notes = table.has_notes
    return {
        "title": table.title,
        "heads": list(table.heads),
        "notes": notes,
        "note": table.note,
        "rows": [[row.title, *row.values, *([row.note] if notes else [])] for row in table.rows],
    }


_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em;
  color: #1a1a1a; background: #fff; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; }
th, td { padding: 2px 9px; text-align: right; white-space: nowrap; }
th:first-child, td:first-child, td.note { text-align: left; }
thead th { border-bottom: 1px solid #444; }
.verdict { padding: .6em 1em; border-left: 5px solid #b26a00; background: #fdf1dc; }
.OK { border-color: #1d7a3f; background: #e7f4ec; }
figure { margin: 1.5em 0; } figure svg { width: 100%; height: auto; }
figcaption, .remark { color: #444; font-size: 13px; }
pre { font-size: 13px; overflow-x: auto; }
"""


def _page(sheet: Sheet, pictures: _Pictures, footer: str) -> str:
    def text(value: str) -> str:
        return html.escape(value)

    def listed(sentences: tuple[str, ...]) -> str:
        return "<ul>" + "".join(f"<li>{text(s)}</li>" for s in sentences) + "</ul>"

    parts = [f"<h1>{text(sheet.title)}</h1><p>{text(sheet.subtitle)}</p>"]
    if sheet.verdict:
        level, sentences = str(sheet.verdict.level), sheet.verdict.sentences
        parts.append(
            f'<div class="verdict {text(level)}"><strong>{text(level)}.</strong> '
            f"{text(sheet.verdict.headline)}{listed(sentences) if sentences else ''}</div>"
        )
    if sheet.remarks:
        parts.append(f"<h2>Remarks</h2>{listed(sheet.remarks)}")
    for name, caption, data in pictures:
        parts.append(
            f'<figure role="img" aria-label="{text(caption)}">{_inline(data, name)}'
            f"<figcaption>{text(caption)}</figcaption></figure>"
        )
    parts += [_html_table(table) for table in sheet.tables]
    parts.append(f"<h2>Sources</h2>{listed(sheet.sources)}<p class='remark'>{text(footer)}</p>")
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{text(sheet.title)}</title><style>{_STYLE}</style></head>"
        f"<body><main>{''.join(parts)}</main></body></html>\n"
    )


def _inline(svg: bytes, name: str) -> str:
    """Return the SVG without its XML head, its identifiers made unique to the page."""
    text = svg.decode("utf-8")
    body = text[text.index("<svg") :]
    prefix = name.removesuffix(".svg")
    for before in ('id="', 'href="#', "url(#"):
        body = body.replace(before, f"{before}{prefix}-")
    return body


def _html_table(table: Table) -> str:
    data = _table(table)
    title = f"<h2>{html.escape(table.title)}</h2>"
    if not table.heads:
        lines = "\n".join(html.escape(row.title) for row in table.rows)
        return f"{title}<pre>{lines}</pre>"
    heads = "".join(f'<th scope="col">{html.escape(h)}</th>' for h in ["", *data["heads"]])
    if data["notes"]:
        heads += "<th></th>"
    rows = "".join(
        "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>"
        for row in data["rows"]
    )
    note = f'<p class="remark">{html.escape(table.note)}</p>' if table.note else ""
    grid = f"<table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>"
    return f'{title}<div class="wide">{grid}</div>{note}'
