"""A note as PDF: PDF/A-2a for keeping, PDF/UA-1 for reading aloud."""

import json
import re
from datetime import UTC, datetime
from importlib.resources import files
from typing import Any

from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.present.sheet import Table
from wraparc.report.note import Note, NoteHead, Section
from wraparc.version import __version__

#: Level A of PDF/A-2 and PDF/UA: tagged, every picture and equation told in words.
STANDARDS = ("a-2a", "ua-1")
#: Faces that the typesetter brings with it; a script they lack is looked for on the system.
_GREEK = {
    "mu": "μ", "phi": "φ", "theta": "θ", "tau": "τ", "gamma": "γ", "delta": "δ", "eta": "η",
    "omega": "ω",
}  # fmt: skip
_NO_GLYPH = "could not be displayed with"
_FONTS = ("Libertinus Serif", "New Computer Modern", "DejaVu Sans Mono")


def note_pdf(note: Note) -> bytes:
    """Return a note as PDF.

    The same note gives the same bytes if its date is one, like 2026-11-21.

    Raises
    ------
    MissingExtraError
        If typst is not installed.
    InputError
        If a text has letters that no font at hand can show.
    """
    settings = {"format": "pdf", "pdf_standards": list(STANDARDS), "timestamp": _made(note.head)}
    return bytes(_typeset(note, settings))


def note_pages(note: Note, *, ppi: float = 100.0) -> list[bytes]:
    """Return the pages of a note as PNG, to be looked at; errors as for `note_pdf`.

    Parameters
    ----------
    note
        The note.
    ppi
        Points of the picture to an inch.
    """
    pages = _typeset(note, {"format": "png", "ppi": ppi})
    return [pages] if isinstance(pages, bytes) else [bytes(page) for page in pages]


def _typeset(note: Note, settings: dict[str, Any]) -> Any:
    try:
        import typst
    except ImportError:
        raise MissingExtraError("typst", "report") from None
    # The stub of typst does not know that it takes files by name.
    compile_files: Any = typst.compile
    parts = _parts(note)
    try:
        return compile_files(parts, ignore_system_fonts=True, **settings)
    except typst.TypstError as error:
        if _NO_GLYPH not in error.message:
            raise
        # a script that the fonts brought along lack: the system may have one
        try:
            return compile_files(parts, **settings)
        except typst.TypstError as error:
            if _NO_GLYPH not in error.message:
                raise
            raise InputError(_untypeset(error)) from None


def _made(head: NoteHead) -> datetime:
    """Return the time that the document says it was made: its date, if that is one."""
    try:
        made = datetime.fromisoformat(head.date)
    except ValueError:
        made = datetime.now(UTC)
    return made.replace(microsecond=0, tzinfo=UTC)


def _untypeset(error: Any) -> Problem:
    return Problem(
        message=f"the note cannot be set as an accessible PDF: {error.message}",
        remedy="Write names and titles in letters that an installed font has, or choose .md.",
    )


def _parts(note: Note) -> dict[str, bytes]:
    parts = {
        f"{drawing.name}.svg": drawing.svg.encode()
        for section in note.sections
        for drawing in section.drawings
    }
    parts["main.typ"] = files("wraparc.report").joinpath("note.typ").read_bytes()
    parts["data.json"] = json.dumps(_data(note)).encode()
    return parts


def _data(note: Note) -> dict[str, Any]:
    head = note.head
    return {
        "fonts": list(_FONTS),
        "program": f"wraparc {__version__}",
        "head": {
            "project": head.project,
            "number": head.number,
            "revision": head.revision,
            "author": head.author,
            "date": head.date,
            "file": head.file,
            "paper": head.paper,
        },
        "title": note.title,
        "subtitle": note.subtitle,
        "belt": note.belt,
        "level": str(note.told.level),
        "headline": note.told.headline,
        "sentences": list(note.told.sentences),
        "summary": note.summary,
        "sections": [_section(section) for section in note.sections],
    }


def _section(section: Section) -> dict[str, Any]:
    return {
        "title": section.title,
        "numbered": section.numbered,
        "sentences": list(section.sentences),
        "tables": [_table(table) for table in section.tables],
        "drawings": [
            {"file": f"{d.name}.svg", "alt": d.alt, "caption": d.caption, "width": d.width}
            for d in section.drawings
        ],
        "equations": [
            {"title": e.title, "typst": e.typst, "words": e.words} for e in section.equations
        ],
    }


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
