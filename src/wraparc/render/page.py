"""Sheets as HTML: a piece for a notebook, or a whole page that needs no other file."""

import json
from collections.abc import Iterator, Sequence
from html import escape
from typing import TYPE_CHECKING

from wraparc.answer.sheet import Sheet, Table, shown
from wraparc.units import System

if TYPE_CHECKING:
    from wraparc.study.monte_carlo import Summary

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em;
  color: #1a1a1a; background: #fff; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums;
  margin: 1.4em 0 .3em; display: block; overflow-x: auto; }
caption { text-align: left; font-size: 18px; font-weight: 600; padding-bottom: .3em; }
th, td { padding: 2px 9px; text-align: right; white-space: nowrap; border-bottom: 1px solid #ddd; }
th:first-child, td.note { text-align: left; font-weight: normal; }
thead th { border-bottom: 1px solid #444; font-weight: 600; }
figure { margin: 1.5em 0; } figure svg { max-width: 100%; height: auto; }
figcaption, footer, table + p { color: #444; font-size: 13px; }
pre { font-size: 13px; overflow-x: auto; }
"""


def study_page(
    sheet: Sheet, pictures: Sequence[str], summary: "Summary", system: System = "si"
) -> str:
    """Return a study as one HTML page: its sheet, pictures as SVG, and the input it rests on."""
    named = [(f"Picture {n}: {sheet.title}", svg) for n, svg in enumerate(pictures, start=1)]
    data = json.dumps(summary.data["input"], indent=1, ensure_ascii=False, default=str)
    program, print_ = summary.data["program"], summary.data["fingerprint"]
    foot = f"{program}, fingerprint {print_}. Input:\n{data}"
    return sheet_page(shown(sheet, system), named, foot)


def sheet_page(sheet: Sheet, pictures: Sequence[tuple[str, str]], footer: str) -> str:
    """Return a sheet as a page.

    Parameters
    ----------
    sheet
        What it says.
    pictures
        Caption and SVG of each.
    footer
        What stands at its foot, lines kept as they are.
    """
    title = escape(sheet.title)
    figures = "".join(
        f'<figure role="img" aria-label="{escape(caption)}">{_inline(svg, f"p{number}-")}'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
        for number, (caption, svg) in enumerate(pictures, start=1)
    )
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{_STYLE}</style></head><body><main>\n"
        f"{_joined(_top(sheet, 'h1'))}\n{figures}\n{_joined(_rest(sheet))}\n"
        f"<footer><pre>{escape(footer)}</pre></footer></main></body></html>\n"
    )


def sheet_html(sheet: Sheet) -> str:
    """Return a sheet as a piece of HTML, without styles of its own."""
    return f'<div class="wraparc">{_joined(_top(sheet, "h3"))}{_joined(_rest(sheet))}</div>'


def _joined(parts: Iterator[str]) -> str:
    return "\n".join(part for part in parts if part)


def _top(sheet: Sheet, heading: str) -> Iterator[str]:
    yield f"<{heading}>{escape(sheet.title)}</{heading}>"
    yield f"<p>{escape(sheet.subtitle)}</p>" if sheet.subtitle else ""
    if sheet.verdict:
        pairs = ((sheet.verdict.word, sheet.verdict.text), *sheet.verdict.lines)
        rows = (f"<dt>{escape(label)}</dt><dd>{escape(text)}</dd>" for label, text in pairs)
        yield f"<dl>{''.join(rows)}</dl>"
        yield _list("ul", sheet.verdict.sentences)


def _rest(sheet: Sheet) -> Iterator[str]:
    yield from map(_table, sheet.tables)
    yield _list("ul", sheet.remarks)
    yield _list("ol", sheet.sources)
    yield from (f"<p>{escape(line)}</p>" for line in sheet.foot)


def _list(tag: str, sentences: Sequence[str]) -> str:
    items = "".join(f"<li>{escape(sentence)}</li>" for sentence in sentences)
    return f"<{tag}>{items}</{tag}>" if items else ""


def _table(table: Table) -> str:
    if not table.heads:  # lines, as of equations
        text = "\n".join(escape(row.title) for row in table.rows)
        return f"<p><strong>{escape(table.title)}</strong></p><pre>{text}</pre>"
    heads = ["", *(["symbol"] if table.has_symbols else []), *table.heads]
    heads += ["note"] if table.has_notes else []
    head = "".join(f'<th scope="col">{escape(text)}</th>' for text in heads)
    lines = []
    for row in table.rows:
        mark = f"{row.mark}: " if row.mark else ""
        cells = [row.symbol] if table.has_symbols else []
        line = "".join(f"<td>{escape(cell)}</td>" for cell in (*cells, *row.values))
        line += f'<td class="note">{escape(mark + row.note)}</td>' if table.has_notes else ""
        lines.append(f'<tr><th scope="row">{escape(row.title)}</th>{line}</tr>')
    note = f"<p>{escape(table.note)}</p>" if table.note else ""
    caption = f"<caption>{escape(table.title)}</caption>"
    body = f"<thead><tr>{head}</tr></thead><tbody>{''.join(lines)}</tbody>"
    return f"<table>{caption}{body}</table>{note}"


def _inline(svg: str, prefix: str) -> str:
    """Return an SVG without its XML head, its identifiers made unique to the page."""
    body = svg[svg.index("<svg") :]
    for before in ('id="', 'href="#', "url(#"):
        body = body.replace(before, f"{before}{prefix}")
    return body
