"""What both kinds of file share: the format number, provenance, entries of the glossary."""

from collections.abc import Mapping
from typing import Any

from wraparc.glossary import GLOSSARY
from wraparc.provenance import Kind as Origin
from wraparc.schema.kinds import ByName, Choice, Kind, Quantity, Text
from wraparc.schema.limits import Limit
from wraparc.schema.tables import Entry, Table

#: The newest format of drive and lagging files that is read, and the one that is written.
FORMAT = 1

#: Other words for keys, by which they are also read.
ALIASES = {"wrap": "wrap_angle"}


def limited(limits: Mapping[str, Limit], key: str) -> Quantity:
    """Return the kind of a quantity that a description in the code limits."""
    return Quantity(limits[key].dimension, limits[key])


def known(key: str, kind: Kind, name: str = "", **more: Any) -> Entry:
    """Return the entry of a quantity of the glossary, with the words it has there."""
    quantity = GLOSSARY[name or key]
    return Entry(key, kind, quantity.title, quantity.meaning, **more)


PROVENANCE = Table(
    (
        Entry(
            "kind",
            Choice(tuple(kind.value for kind in Origin)),
            "Kind",
            "How the number came to be.",
            required=True,
        ),
        Entry("source", Text(500), "Source", "Author or maker, title, year, page or table."),
        Entry("date", Text(60), "Date", "When it was measured, published or retrieved."),
        Entry("note", Text(1000), "Note", "What a reader must know before using it."),
    ),
    "Provenance",
)
ORIGINS = (
    Entry("provenance", PROVENANCE, "Provenance", "Where the numbers of this table came from."),
    Entry(
        "sources",
        ByName(PROVENANCE),
        "Sources",
        "Where single numbers came from, by key, if elsewhere.",
    ),
)

FORMAT_ENTRY = Entry(
    "format",
    Quantity("number"),
    "Format",
    f"Format of the file, {FORMAT}.",
    required=True,
    example=f"format = {FORMAT}",
)
