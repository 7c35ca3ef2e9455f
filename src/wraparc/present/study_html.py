"""A study as one HTML page that needs nothing else: tables, pictures, input."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from html import escape

from wraparc.present.sheet import Sheet, Table
from wraparc.study.monte_carlo import Summary

_STYLE = (
    "body{font:15px/1.45 system-ui,sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;margin:.5rem 0}caption{text-align:left;font-weight:600}"
    "td,th{padding:.15rem .7rem;border-bottom:1px solid #ddd;text-align:right}"
    "td:first-child,th:first-child{text-align:left}svg{max-width:100%;height:auto}"
    "pre{background:#f6f6f6;padding:.7rem;overflow:auto}"
)


def study_html(sheet: Sheet, pictures: Sequence[str], summary: Summary) -> str:
    """Return the page.

    Parameters
    ----------
    sheet
        What the study says.
    pictures
        SVG texts.
    summary
        The results, for the input they hold.
    """
    return "\n".join(_lines(sheet, pictures, summary)) + "\n"


def _lines(sheet: Sheet, pictures: Sequence[str], summary: Summary) -> Iterator[str]:
    title = escape(sheet.title)
    yield '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
    yield '<meta name="viewport" content="width=device-width">'
    yield f"<title>{title}</title><style>{_STYLE}</style></head><body><main>"
    yield f"<h1>{title}</h1>\n<p>{escape(sheet.subtitle)}</p>"
    if sheet.verdict:
        yield f"<p><strong>{escape(sheet.verdict.headline)}</strong></p>"
        yield from (f"<p>{escape(sentence)}</p>" for sentence in sheet.verdict.sentences)
    for number, picture in enumerate(pictures, start=1):
        svg = picture[picture.index("<svg") :]
        yield f'<figure role="img" aria-label="Picture {number}: {title}">{svg}</figure>'
    for table in sheet.tables:
        yield from _table(table)
    if sheet.remarks:
        yield "<h2>Remarks</h2>\n<ul>"
        yield from (f"<li>{escape(remark)}</li>" for remark in sheet.remarks)
        yield "</ul>"
    if sheet.sources:
        yield "<h2>Sources</h2>\n<ul>"
        yield from (f"<li>{escape(source)}</li>" for source in sheet.sources)
        yield "</ul>"
    data = json.dumps(summary.data["input"], indent=1, ensure_ascii=False, default=str)
    program, print_ = summary.data["program"], summary.data["fingerprint"]
    yield f"<h2>Input</h2>\n<p>{escape(program)}, fingerprint {escape(print_)}</p>"
    yield f"<pre>{escape(data)}</pre>\n</main></body></html>"


def _table(table: Table) -> Iterator[str]:
    yield f"<table><caption>{escape(table.title)}</caption><thead><tr><th></th>"
    yield "".join(f"<th>{escape(head)}</th>" for head in table.heads) + "</tr></thead><tbody>"
    for row in table.rows:
        cells = "".join(f"<td>{escape(value)}</td>" for value in row.values)
        yield f"<tr><td>{escape(row.title)}</td>{cells}</tr>"
    yield "</tbody></table>" + (f"<p>{escape(table.note)}</p>" if table.note else "")
