"""Documents as they come from a page, to drives and trains."""

from typing import Any

from wraparc.drive import Drive
from wraparc.files import drive_from_document
from wraparc.schema.source import Document
from wraparc.train import Train


def without_none(value: Any) -> Any:
    """Return a document without keys that hold nothing: fields left empty."""
    if isinstance(value, dict):
        return {k: without_none(v) for k, v in value.items() if v is not None}
    if isinstance(value, list):
        return [without_none(item) for item in value if item is not None]
    return value


def read(document: Document) -> Drive | Train:
    """Return what a document describes; several pulleys on one belt are a train, as for `solve`.

    Raises
    ------
    InputError
        With everything that is wrong; paths of files are refused.
    """
    document = without_none(document)
    if "train" in document:
        from wraparc.train.file import train_from_document

        return train_from_document(document)
    drive = drive_from_document(document)
    return drive if len(drive.pulleys) == 1 else Train.of(drive)
