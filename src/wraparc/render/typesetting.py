"""Setting a document in type: PDF for keeping and for reading aloud, pages to look at."""

import json
import shutil
from collections.abc import Sequence
from datetime import UTC, datetime
from importlib.resources import files
from tempfile import TemporaryDirectory
from typing import Any

from wraparc.errors import MissingExtraError
from wraparc.plot.picture import picture_fonts
from wraparc.render.drawings import Drawing
from wraparc.render.lacking import PROBE, boxed, find_lacking

#: Level A of PDF/A-2 and PDF/UA: tagged, every picture and equation told in words.
STANDARDS = ("a-2a", "ua-1")
#: Faces that the typesetter brings with it; a script they lack is looked for on the system.
FONTS = ("Libertinus Serif", "New Computer Modern", "DejaVu Sans Mono")
_NO_GLYPH = "could not be displayed with"


def typeset_pdf(data: dict[str, Any], drawings: Sequence[Drawing], date: str) -> bytes:
    """Return a document as PDF.

    The same document gives the same bytes if its date is one, like 2026-11-21.

    Parameters
    ----------
    data
        What the template asks for.
    drawings
        Its pictures, in order.
    date
        When the document says it was made.

    Letters that no font at hand has are boxes with their codes, and a line says so.

    Raises
    ------
    MissingExtraError
        If typst or matplotlib is not installed.
    """
    settings = {"format": "pdf", "pdf_standards": list(STANDARDS), "timestamp": _made(date)}
    return bytes(_typeset(data, drawings, settings))


def typeset_pages(
    data: dict[str, Any], drawings: Sequence[Drawing], *, ppi: float = 100.0
) -> list[bytes]:
    """Return the pages of a document as PNG; parameters and errors as for `typeset_pdf`.

    Parameters
    ----------
    data, drawings
        The document.
    ppi
        Points of the picture to an inch.
    """
    pages = _typeset(data, drawings, {"format": "png", "ppi": ppi})
    return [pages] if isinstance(pages, bytes) else [bytes(page) for page in pages]


def _typeset(data: dict[str, Any], drawings: Sequence[Drawing], settings: dict[str, Any]) -> Any:
    try:
        import typst
    except ImportError:
        raise MissingExtraError("typst", "report") from None
    # The stub of typst does not know that it takes files by name.
    compile_files: Any = typst.compile
    parts = {f"{n}.svg": d.draw().to_bytes("svg") for n, d in enumerate(drawings)}
    parts["main.typ"] = files("wraparc.render").joinpath("document.typ").read_bytes()
    of_file = {"title": data["title"], "author": data["author"], "description": data["headline"]}
    data = {**data, "fonts": FONTS, "file": of_file, "letters": ""}
    parts["data.json"] = json.dumps(data).encode()
    with TemporaryDirectory(prefix="wraparc-fonts-") as folder:
        for face in picture_fonts():
            shutil.copy(face, folder)
        settings["font_paths"] = [folder]
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
        fonts = {"font_paths": [folder]}
        lacking = find_lacking(data, parts, lambda probe: compile_files(probe, **fonts, **PROBE))
        return compile_files(boxed(data, parts, lacking), **settings)


def _made(date: str) -> datetime:
    """Return the time that the document says it was made: its date, if that is one."""
    try:
        made = datetime.fromisoformat(date)
    except ValueError:
        made = datetime.now(UTC)
    return made.replace(microsecond=0, tzinfo=UTC)
