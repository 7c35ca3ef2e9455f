"""The calculator as one HTML file: no server, no network, opened by a double click.

Scripts and styles come ready (`one_file/built`, made by ``make kernel``); here the drive and all
that the page knows of laggings, belts, rules and units go into it.
"""

import base64
import hashlib
import html
import json
import re
import zlib
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

from wraparc.drive import Drive, Pulley
from wraparc.drive.pull import idles
from wraparc.errors import InputError, Problem
from wraparc.schema.source import Document, parse
from wraparc.train import Train
from wraparc.train.as_drive import as_drive
from wraparc.units import DIMENSIONS, unit_factor, unit_names
from wraparc.version import __version__
from wraparc.web.answers import book, catalogue, compare
from wraparc.web.answers.documents import json_like, read
from wraparc.web.answers.form import form
from wraparc.web.examples import examples

_FOLDER = Path(__file__).with_name("one_file")
_STATIC = Path(__file__).with_name("static")
#: Licences of what is bundled; they go with every file.
_LICENCES = (
    _STATIC / "vendor" / "preact-LICENSE.txt",
    _FOLDER / "smol-toml-LICENSE.txt",
)
#: Parts of the form that the file has fields for.
_SECTIONS = ["drive", "belt", "pulley", "tensions", "lagging", "load_case", "train", "conveyor"]
#: Keys of a lagging table in a pulley whose law the page was not made with.
_OTHER_LAW = ("law", "condition_factor", "slip_speed", "temperature")
_PLACE = re.compile(r"\{\{(\w+)\}\}")
_UNIT = re.compile(r"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?\s*(\S.*?)\s*")
_SOLVES = "Use wraparc solve or wraparc serve."


def page_file(document: Document, name: str, text: str) -> str:
    """Return the HTML of a file that solves a drive.

    Parameters
    ----------
    document
        Of the drive, with the lagging files that it names put into it.
    name
        What to call it.
    text
        Its drive file.

    Raises
    ------
    InputError
        If a page alone cannot solve such a drive.
    """
    _check(document)
    data = json.dumps(page_data(document, name, text), ensure_ascii=False, separators=(",", ":"))
    style, start = _built("page.css"), _built("start.js")
    solver, program = _built("solver.js"), _built("page.js")
    icon = base64.b64encode((_STATIC / "built" / "icon.svg").read_bytes()).decode("ascii")
    parts = {
        "licences": "\n".join(path.read_text("utf-8") for path in _LICENCES),
        "policy": _policy(style, (start, solver, program)),
        "version": __version__,
        "title": html.escape(str(document.get("title") or name)),
        "icon": f"data:image/svg+xml;base64,{icon}",
        "style": packed(style),
        "data": packed(data),
        "start": start,
        "solver": packed(solver),
        "program": packed(program),
    }
    frame = (_FOLDER / "page.html").read_text("utf-8")
    return _PLACE.sub(lambda found: parts[found[1]], frame)


def packed(text: str) -> str:
    """Return a text compressed, in digits of base 85 that begin no element, see `unpacked.js`."""
    digits = base64.b85encode(zlib.compress(text.encode("utf-8"), 9)).decode("ascii")
    return digits.replace("<", ",")


@cache
def _built(name: str) -> str:
    return (_FOLDER / "built" / name).read_text("utf-8")


def _policy(style: str, scripts: tuple[str, ...]) -> str:
    """Return what the page may do: run these scripts, and reach nothing and nobody."""

    def hashed(text: str) -> str:
        digest = hashlib.sha256(text.encode("utf-8")).digest()
        return f"'sha256-{base64.b64encode(digest).decode('ascii')}'"

    return "; ".join(
        [
            "default-src 'none'",
            f"script-src {' '.join(map(hashed, scripts))}",
            f"style-src {hashed(style)}",
            "img-src data:",
            "worker-src blob:",
            "connect-src 'none'",
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )


def page_data(document: Document, name: str, text: str) -> dict[str, Any]:
    """Return what the scripts know."""
    plain = json_like(document)
    found = {e.name: e for e in examples() if _alone(e.document)}
    whole = catalogue.whole()
    kept = [example for example in whole.examples if example.name in found]
    return {
        "about": {"name": "wraparc", "version": __version__},
        "form": _form(document),
        "catalogue": _plain(whole.model_copy(update={"examples": kept, "design_friction": []})),
        "book": _plain(book.book(plain)),
        "compare": {
            "columns": [_plain(c) for c in compare.columns() if not c.key.startswith("cost")],
            "remarks": {"laggings": [compare.SAME, compare.OF_LAGGINGS], "belts": [compare.SAME]},
            "neighbours": compare.NEIGHBOURS,
        },
        "start": {"name": name, "file": name, "document": plain, "toml": text},
        "examples": {
            key: {"document": json_like(e.document), "toml": e.text} for key, e in found.items()
        },
    }


def _plain(answer: Any) -> Any:
    return json.loads(answer.model_dump_json())


def _form(document: Document) -> dict[str, Any]:
    """Return the form of a drive, its units and every unit that the drive is written in."""
    found: dict[str, Any] = _plain(form())
    shown = {*_SECTIONS, *found["criteria"]}
    found["sections"] = [s for s in found["sections"] if s["key"] in shown]
    for unit in {*unit_names(), *_units(document)}:
        for dimension in DIMENSIONS:
            try:
                factor = unit_factor(unit, dimension)
            except InputError:
                continue
            found["units"][dimension]["factors"].setdefault(unit, factor)
    return found


def _units(value: Any) -> Iterator[str]:
    """Yield the units of the quantities in a document."""
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            yield from _units(item)
    match = _UNIT.fullmatch(value) if isinstance(value, str) else None
    if match:
        yield match[1]


def _alone(document: Document) -> bool:
    try:
        _check(document)
    except InputError:
        return False
    return True


def _check(document: Document) -> None:
    """Refuse a drive that the page alone cannot solve."""
    drive = read(document)
    problems = list(_problems(document, drive))
    if problems:
        raise InputError(problems)


def _problems(document: Document, drive: Drive | Train) -> Iterator[Problem]:
    def beyond(key: str, what: str, remedy: str = _SOLVES) -> Problem:
        return Problem(key=key, message=f"{what} a page without a server", remedy=remedy)

    if isinstance(drive, Drive) and len(drive.pulleys) > 1:
        what = "several pulleys without a [train] table are not solved in"
        yield beyond("pulley", what)
    for pulley, table in zip(drive.pulleys, document["pulley"], strict=True):
        yield from _pulley_problems(f"pulley.{pulley.name}", pulley, table, beyond)


def _pulley_problems(
    place: str, pulley: Pulley, table: Document, beyond: Callable[..., Problem]
) -> Iterator[Problem]:
    if pulley.across is not None:
        remedy = "Use wraparc solve or wraparc serve."
        yield beyond(f"{place}.across", "is not solved in", remedy)
    lagging = table["lagging"]
    for key in lagging if isinstance(lagging, dict) else ():
        if key in _OTHER_LAW:
            remedy = "Put the lagging into a [lagging.NAME] table of the drive file."
            yield beyond(f"{place}.lagging.{key}", "is not read in", remedy)


def not_judged(document: Document) -> str:
    """Return why the page has no answer to a drive that it holds; empty where it has one."""
    drive = read(document)
    try:
        one = as_drive(drive) if isinstance(drive, Train) else drive
    except InputError:  # not solved: the page says so itself
        return ""
    reasons = [
        f"pulley {name} transmits no Te in load case {case.name}"
        for case in one.load_cases
        for name, pair in case.tensions.items()
        if idles(pair.entry, pair.exit)
    ]
    if not reasons:
        return ""
    told = f"The page opens with this drive but does not judge it: {reasons[0]}."
    return f"{told} wraparc solve does."


def first_example() -> tuple[Document, str, str]:
    """Return document, name and text of the drive that is shown where none is given."""
    first = examples()[0]
    return first.document, first.name, first.text


def file_of(document: Document, text: str) -> str:
    """Return the text of a drive file, written anew where other files were put into it."""
    if parse(text) == document:
        return text
    from wraparc.schema.emit import document_text
    from wraparc.train.keys import TRAIN_FILE

    return document_text(document, TRAIN_FILE)
