"""What both kinds of file share: the format number, provenance, entries of the glossary."""

from typing import Any

from wraparc.glossary import GLOSSARY
from wraparc.provenance import Kind as Origin
from wraparc.provenance import Provenance
from wraparc.schema.kinds import ByName, Choice, Kind, Quantity, Text
from wraparc.schema.tables import OF_CLASS, Entry, Table, need

#: The newest format of drive and lagging files that is read, and the one that is written.
FORMAT = 1


def known(key: str, kind: Kind = OF_CLASS, *, quantity: str = "", **more: Any) -> Entry:
    """Return the entry of a quantity of the glossary, with the words it has there."""
    words = GLOSSARY[quantity or key]
    return Entry(key, words.meaning, kind, title=words.title, **more)


PROVENANCE = Table(
    "Provenance",
    need("kind", "How the number came to be.", Choice(tuple(kind.value for kind in Origin))),
    Entry("source", "Author or maker, title, year, page or table.", Text(500)),
    Entry("date", "When it was measured, published or retrieved.", Text(60)),
    Entry("note", "What a reader must know before using it.", Text(1000)),
    of=Provenance,
    on_one_line=True,
)
ORIGINS = (
    Entry("provenance", "Where the numbers of this table came from.", PROVENANCE),
    Entry("sources", "Where single numbers came from, by key, if elsewhere.", ByName(PROVENANCE)),
)

FORMAT_ENTRY = need(
    "format", f"Format of the file, {FORMAT}.", Quantity("number"), example=f"format = {FORMAT}"
)
