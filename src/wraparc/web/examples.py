"""The example drives that ship with the program."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from wraparc.errors import InputError
from wraparc.schema.source import Document, parse
from wraparc.web.answers.documents import kind_of
from wraparc.web.answers.shown import DriveKind

_FIRST = "head-drive-fabric"


@dataclass(frozen=True)
class Example:
    """One example.

    Attributes
    ----------
    name
        Name of its file without the ending.
    text
        The file.
    document
        Its tables.
    """

    name: str
    text: str
    document: Document

    @property
    def kind(self) -> DriveKind:
        """``drive``, or ``train`` for several pulleys on one belt."""
        return kind_of(self.document)


@cache
def examples() -> tuple[Example, ...]:
    """Return every example drive, the first to show first."""
    package = Path(__file__).parents[1]
    folders = (package / "examples", package.parents[1] / "examples")
    folder = next((f for f in folders if (f / f"{_FIRST}.toml").is_file()), None)
    paths = sorted(folder.glob("*.toml")) if folder else []
    found = []
    for path in paths:
        text = path.read_text("utf-8")
        try:
            document = parse(text, path.name)
        except InputError:
            continue
        if "pulley" in document and "belt" in document:
            found.append(Example(path.stem, text, document))
    return tuple(sorted(found, key=lambda example: (example.name != _FIRST, example.name)))
