"""What a page needs to read any drive itself: the catalogue, and laws as numbers.

The page reads documents, and judges what it has solved, by the functions of the program,
translated; `assemble.js` puts a drive together.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from functools import cache
from typing import Any

from wraparc import catalogue
from wraparc.drive import Lagging
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.schema.source import Document, parse
from wraparc.web.answers.documents import json_like
from wraparc.web.answers.prepared import Law, Plain, law_of

#: Conditions that published values cover.
CONDITIONS = ("dry", "wet", "wet and dirty")
#: A drive that nothing is special of.
_PROBE: Document = {
    "format": 1,
    "belt": {"preset": "Plylon Plus 1000/4", "width": "1200 mm"},
    "pulley": [
        {
            "name": "head",
            "diameter": "800 mm",
            "wrap_angle": "180 deg",
            "entry_tension": "150 kN",
            "exit_tension": "60 kN",
        }
    ],
}


class BookCatalogue(Plain):
    """What documents may name: belts, and lagging files by name."""

    belts: list[dict[str, Any]]
    laggings: dict[str, dict[str, Any]]


class BookLaw(Plain):
    """A lagging in one condition."""

    condition: str
    law: Law
    steepest_fall: float


class BookLagging(Plain):
    """The laws of a lagging by condition."""

    laws: dict[str, BookLaw]


class Book(Plain):
    """All of it."""

    laggings: dict[str, BookLagging]
    catalogue: BookCatalogue
    own: dict[str, Any]


def book(document: Document | None = None) -> Book:
    """Return what the catalogue has, and a drive document: its laggings and conditions.

    Raises
    ------
    InputError
        If a lagging of the document cannot be read.
    """
    found = _whole()
    if document is None:
        return found
    own = document.get("lagging") or {}
    conditions = dict.fromkeys(CONDITIONS) | dict(_named_conditions(document))
    names = (*catalogue.lagging_names(), *own)
    laggings = {name: _lagging(name, own, conditions) for name in names}
    return found.model_copy(update={"laggings": laggings, "own": own})


@cache
def _whole() -> Book:
    names = catalogue.lagging_names()
    return Book(
        laggings={name: _lagging(name, {}, dict.fromkeys(CONDITIONS)) for name in names},
        catalogue=BookCatalogue(
            belts=[asdict(belt) for belt in catalogue.belts()],
            laggings={name: json_like(parse(catalogue.lagging_text(name))) for name in names},
        ),
        own={},
    )


def key_of(condition: Any) -> str:
    """Return the text that a condition of a document is found by: its name, or its table."""
    if isinstance(condition, str):
        return condition
    return json.dumps(condition, separators=(",", ":"), ensure_ascii=False)


def _named_conditions(document: Document) -> Iterator[tuple[str, Any]]:
    """Yield every condition that a document names."""
    given = document.get("condition")
    rows = [*(given if isinstance(given, list) else [given])]
    rows += [t.get("condition") for t in document.get("pulley") or ()]
    rows += [t.get("condition") for t in document.get("load_case") or ()]
    yield from ((key_of(row), row) for row in rows if row is not None)


def _lagging(name: str, own: Document, conditions: Mapping[str, Any]) -> BookLagging:
    first = _read(name, own, None)
    laws = {first.condition: _law(first)}
    for key, condition in conditions.items():
        try:
            laws[key] = _law(_read(name, own, condition or key))
        except InputError:  # nothing is known of it: a drive that asks for it is refused
            continue
    return BookLagging(laws=laws)


def _read(name: str, own: Document, condition: Any) -> Lagging:
    """Return a lagging as a drive file has it."""
    pulley = {**_PROBE["pulley"][0], "lagging": name}
    more = {} if condition is None else {"condition": condition}
    document = {**_PROBE, "pulley": [pulley], "lagging": own, **more}
    return drive_from_document(document).pulleys[0].lagging


def _law(lagging: Lagging) -> BookLaw:
    law = lagging.law
    return BookLaw(condition=lagging.condition, law=law_of(law), steepest_fall=law.steepest_fall())
