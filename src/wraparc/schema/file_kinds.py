"""What kind of file a document is, by keys that only this kind has: another is refused by name."""

from __future__ import annotations

import os
from typing import NamedTuple

from wraparc.errors import InputError, input_error
from wraparc.schema.source import Document, parse, read_text


class FileKind(NamedTuple):
    """A kind of file.

    Attributes
    ----------
    words
        What it is called, with its article.
    command
        What reads it.
    keys
        Some of its tables, which no other kind has.
    """

    words: str
    command: str
    keys: tuple[str, ...]


#: By the name that `refuse_other` asks for them by.
FILE_KINDS: dict[str, FileKind] = {
    "drive": FileKind("a drive file", "solve", ("belt", "train", "conveyor", "motion")),
    "choose": FileKind("a choose file", "choose", ("candidates",)),
    "study": FileKind("a study file", "study", ("axis", "sampling")),
    "plan": FileKind("a test plan", "fit", ("rig", "test", "digitised")),
    "calibrate": FileKind("a calibrate file", "calibrate", ("number", "record", "prior", "zero")),
    "learn": FileKind("a learn file", "learn", ("belt_speed", "files", "event")),
    "lagging": FileKind("a lagging file", "lagging", ("law",)),
}
#: Endings of the files of test machines.
_MACHINE = (".csv", ".tsv", ".dat", ".txt", ".tra", ".mtr", ".xlsx", ".xlsm", ".xls")
_TEST_FILE = FileKind("a test file", "read", ())


def refuse_other(document: Document, wanted: str, file: str = "") -> None:
    """Refuse a document that is another kind of file, with the command that reads it.

    Parameters
    ----------
    document
        What was read.
    wanted
        Name in `FILE_KINDS`; with none every kind is another.
    file
        What to call the document in messages.

    Raises
    ------
    InputError
        If it has tables of another kind, and none of the kind that is wanted.
    """
    if wanted and _is(document, FILE_KINDS[wanted]):
        return
    for kind in FILE_KINDS.values():
        if _is(document, kind):
            raise _other(kind, file)


def parse_kind(path: str | os.PathLike[str], wanted: str) -> Document:
    """Return the document of a file of one kind, see `refuse_other`.

    Raises
    ------
    InputError
        If the file cannot be read, is no TOML, or is of another kind.
    """
    file = os.fspath(path)
    try:
        document = parse(read_text(path), file)
    except InputError:
        if file.lower().endswith(_MACHINE) and os.path.isfile(file):
            raise _other(_TEST_FILE, file) from None
        raise
    if wanted:
        refuse_other(document, wanted, file)
    return document


def refuse_toml(path: str) -> None:
    """Refuse a file of wraparc where one with a table of numbers is read.

    Raises
    ------
    InputError
        If it is one of `FILE_KINDS`.
    """
    if not path.lower().endswith(".toml"):
        return
    try:
        document = parse(read_text(path), path)
    except InputError:
        return
    refuse_other(document, "", path)


def _is(document: Document, kind: FileKind) -> bool:
    return any(key in document for key in kind.keys)


def _other(kind: FileKind, file: str) -> InputError:
    message = f"this is {kind.words}: wraparc {kind.command} FILE"
    return input_error(file=file, message=message)
