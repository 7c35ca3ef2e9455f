"""Lagging files to laggings, one for each condition."""

import os
from collections.abc import Iterable
from functools import lru_cache

from wraparc.catalogue import lagging_text
from wraparc.drive import Lagging
from wraparc.errors import input_error, name_remedy, shown
from wraparc.files.lagging_build import build_laggings
from wraparc.files.lagging_keys import LAGGING_FILE
from wraparc.schema.file_kinds import refuse_other
from wraparc.schema.problems import Report
from wraparc.schema.source import Document, parse, read_tables, read_text
from wraparc.schema.tables import Record

_SUFFIX = ".toml"


def load_lagging(
    name_or_path: str | os.PathLike[str], condition: str | None = None, *, allow_paths: bool = True
) -> Lagging:
    """Return a lagging of the catalogue or of a lagging file, in one condition.

    Parameters
    ----------
    name_or_path
        Name in the catalogue, or path of a file (ending in ``.toml``).
    condition
        Which law (``dry``, ``wet`` ...); None for the first of the file.
    allow_paths
        Whether a path may be given; False where the name comes from elsewhere.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    laggings = load_lagging_conditions(name_or_path, allow_paths=allow_paths)
    return pick_condition(laggings, condition)


def load_lagging_conditions(
    name_or_path: str | os.PathLike[str], *, allow_paths: bool = True
) -> tuple[Lagging, ...]:
    """Return a lagging in every condition of its file, in the order of the file."""
    name = os.fspath(name_or_path)
    if not is_path(name):
        return catalogue_laggings(name)
    return _built(*lagging_record(name, "", allow_paths))


def catalogue_laggings(name: str) -> tuple[Lagging, ...]:
    """Return a lagging of the catalogue in every condition; built once, for it is asked for often.

    Raises
    ------
    InputError
        If there is none of the name, or with everything that is wrong with it.
    """
    return _catalogue_laggings(name, lagging_text(name))


@lru_cache(maxsize=64)
def _catalogue_laggings(name: str, text: str) -> tuple[Lagging, ...]:
    return _built(_catalogue_record(name, text), f"catalogue lagging {name}")


def lagging_from_text(text: str, *, file: str = "") -> tuple[Lagging, ...]:
    """Return the laggings of the text of a lagging file, one for each condition."""
    return _built(_record(text, file), file)


def lagging_from_document(document: Document, *, file: str = "") -> tuple[Lagging, ...]:
    """Return the laggings of a lagging file that is already parsed."""
    return _built(_checked_record(document, file), file)


def pick_condition(laggings: Iterable[Lagging], condition: str | None) -> Lagging:
    """Return the lagging of a condition, or the first for None.

    Raises
    ------
    InputError
        If there is no law for the condition.
    """
    laggings = tuple(laggings)
    if condition is None:
        return laggings[0]
    found = next((lagging for lagging in laggings if lagging.condition == condition), None)
    if found is None:
        known = [lagging.condition for lagging in laggings]
        raise input_error(
            message=f"lagging {shown(laggings[0].name)} has no law for this condition",
            remedy=name_remedy(condition, known),
            key="condition",
            value=shown(condition),
        )
    return found


def lagging_record(name_or_path: str, folder: str, allow_paths: bool) -> tuple[Record, str]:
    """Return a lagging file as read but not yet built, and what to call it in messages.

    Parameters
    ----------
    name_or_path
        Name in the catalogue, or path of a file.
    folder
        What a relative path is relative to.
    allow_paths
        Whether a path may be given.
    """
    if not is_path(name_or_path):
        text = lagging_text(name_or_path)
        return _catalogue_record(name_or_path, text), f"catalogue lagging {name_or_path}"
    if not allow_paths:
        raise input_error(
            message="cannot be a path here",
            remedy="Write a catalogue name, or add a [lagging.NAME] table.",
            value=shown(name_or_path),
        )
    path = os.path.join(folder, name_or_path)
    document = parse(read_text(path), path)
    refuse_other(document, "lagging", path)
    return _checked_record(document, path), path


def is_path(text: str) -> bool:
    """Whether a text is the path of a lagging file, not a name: it ends so or has a folder."""
    return text.endswith(_SUFFIX) or "/" in text or os.sep in text


@lru_cache(maxsize=64)
def _catalogue_record(name: str, text: str) -> Record:
    record = _record(text, f"catalogue lagging {name}")
    if record["name"] != name:
        raise input_error(
            file=f"catalogue lagging {name}",
            key="name",
            value=shown(record["name"]),
            message="is not the name of its file",
            remedy=f"Write name = {shown(name)}, or rename the file.",
        )
    return record


def _record(text: str, file: str) -> Record:
    return _checked_record(parse(text, file), file)


def _checked_record(document: Document, file: str) -> Record:
    record: Record
    record, report = read_tables(LAGGING_FILE, document, file)
    if report.problems:
        build_laggings(record, report)
        report.raise_all()
    return record


def _built(record: Record, file: str) -> tuple[Lagging, ...]:
    report = Report(file)
    laggings = build_laggings(record, report)
    report.raise_all()
    return laggings
