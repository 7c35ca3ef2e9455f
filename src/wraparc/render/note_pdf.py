"""A note as PDF: PDF/A-2a for keeping, PDF/UA-1 for reading aloud."""

import re
from collections.abc import Iterable
from itertools import count
from typing import Any

from wraparc.answer.sheet import Table
from wraparc.render.note import PROGRAM, Note, Section
from wraparc.render.typesetting import typeset_pages, typeset_pdf

_GREEK = {
    "mu": "μ", "phi": "φ", "theta": "θ", "tau": "τ", "gamma": "γ", "delta": "δ", "eta": "η",
    "omega": "ω",
}  # fmt: skip


def note_pdf(note: Note) -> bytes:
    """Return a note as PDF, see `typeset_pdf`."""
    return typeset_pdf(_data(note), note.drawings, note.head.date)


def note_pages(note: Note, *, ppi: float = 100.0) -> list[bytes]:
    """Return the pages of a note as PNG, to be looked at, see `typeset_pages`."""
    return typeset_pages(_data(note), note.drawings, ppi=ppi)


def _data(note: Note) -> dict[str, Any]:
    head = note.head
    return {
        "kind": "Calculation note · drive pulley: creep, slip and traction",
        "title": note.title,
        "subtitle": note.subtitle,
        "author": head.author,
        "date": head.date,
        "paper": head.paper,
        "box": note.title_block,
        "footer": [p for p in (PROGRAM, head.number, head.revision, head.date) if p],
        "single": False,
        "signatures": (
            ("Prepared", head.author, head.date),
            ("Checked", "", ""),
            ("Approved", "", ""),
        ),
        "level": str(note.told.level),
        "headline": note.told.text,
        "lines": note.lines,
        "sections": sections_data(note.sections),
    }


def sections_data(sections: Iterable[Section]) -> list[dict[str, Any]]:
    """Return the sections of a document as its template asks for them."""
    numbers = count()
    return [
        {
            "title": section.title,
            "numbered": section.numbered,
            "sentences": section.sentences,
            "tables": [_table(table) for table in section.tables],
            "drawings": [
                {"file": f"{n}.svg", "alt": d.alt, "caption": d.caption, "width": d.width}
                for d, n in zip(section.drawings, numbers, strict=False)
            ],
            "equations": [
                {"title": e.title, "typst": e.typst, "words": e.words} for e in section.equations
            ],
        }
        for section in sections
    ]


def letters(symbol: str) -> str:
    """Return a symbol of the glossary with its Greek letters."""
    return re.sub(r"[a-z]+", lambda word: _GREEK.get(word[0], word[0]), symbol)


def _table(table: Table) -> dict[str, Any]:
    return {
        "title": table.title,
        "note": table.note,
        "heads": [letters(head) for head in table.heads],
        "symbols": table.has_symbols,
        "notes": table.has_notes,
        "rows": [
            {
                "title": row.title,
                "symbol": letters(row.symbol),
                "values": list(row.values),
                "note": row.note,
                "level": str(row.level or ""),
            }
            for row in table.rows
        ],
    }
