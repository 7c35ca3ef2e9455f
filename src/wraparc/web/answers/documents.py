"""Documents as they come from a page, to drives and trains."""

import json
from dataclasses import replace
from typing import Any

from wraparc.arc import Distributed
from wraparc.drive import Drive, LoadCase, Pulley
from wraparc.errors import InputError, input_error, placed
from wraparc.schema.source import Document, decoded, parse
from wraparc.train import Train
from wraparc.train.as_drive import nearest_drive
from wraparc.web.answers.shown import DriveKind

#: Most pulleys times load cases: 5 s of work, and 10 MB of answer before it is packed in 3.
MOST_ARCS = 200


def without_none(value: Any) -> Any:
    """Return a document without keys that hold nothing: fields left empty."""
    if isinstance(value, dict):
        return {k: without_none(v) for k, v in value.items() if v is not None}
    if isinstance(value, list):
        return [without_none(item) for item in value if item is not None]
    return value


def kind_of(document: Document) -> DriveKind:
    """Return ``train`` for several pulleys on one belt, else ``drive``."""
    pulleys = document.get("pulley")
    several = isinstance(pulleys, list) and len(pulleys) > 1
    return "train" if several or "train" in document else "drive"


def json_like(value: Any) -> Any:
    """Return a document with dates and times as text: JSON has none."""
    if isinstance(value, dict):
        return {key: json_like(item) for key, item in value.items()}
    if isinstance(value, list):
        return [json_like(item) for item in value]
    if isinstance(value, bool | int | float | str):
        finite = not isinstance(value, float) or abs(value) < float("inf")
        return value if finite else str(value)
    return str(value)


def toml_as_json(content: bytes) -> bytes:
    """Return the text of a drive file as the request that it stands for."""
    document = json_like(parse(decoded(content)))
    return json.dumps({"document": document}, ensure_ascii=False).encode("utf-8", "surrogatepass")


def read(document: Document) -> Drive | Train:
    """Return what a document describes; several pulleys on one belt are a train, as for `solve`.

    Raises
    ------
    InputError
        With everything that is wrong; paths of files are refused, and more than a page can show.
    """
    from wraparc.train.file import drive_or_train_from_document

    document = without_none(document)
    found = drive_or_train_from_document(document, _motion if "motion" in document else None)
    cases = found.load_cases if isinstance(found, Drive) else found.cases
    _check_arcs(len(found.pulleys), len(cases))
    return Train.of(found) if isinstance(found, Drive) and len(found.pulleys) > 1 else found


def _motion(document: Document, *, file: str = "") -> None:
    """Refuse what is wrong in ``[motion]``; what is missing there a form has not come to yet."""
    from wraparc.motion.file import check_motion  # drives in time are loaded for these alone

    try:
        check_motion(document, file=file)
    except InputError as error:
        wrong = [problem for problem in error.problems if problem.code != "missing"]
        if wrong:
            raise InputError(wrong) from None


def _check_arcs(pulleys: int, cases: int) -> None:
    """Refuse what takes longer, and is longer, than anybody waits for before a page."""
    if pulleys * cases <= MOST_ARCS:
        return
    several = f" on {pulleys} pulleys" if pulleys > 1 else ""
    raise input_error(
        key="load_case",
        message=f"{cases:,} load cases{several} with conditions, at most {MOST_ARCS // pulleys}",
        remedy="Leave some out, or run wraparc solve FILE.",
    )


def kind_if_read(document: Document) -> bytes:
    """Return the kind of a document that can be read."""
    read(document)
    return kind_of(document).encode()


def divided(train: Train, points: int = 180) -> Drive:
    """Return the drive of a train with the tensions that its division of the load makes."""
    return nearest_drive(train, Distributed(points=points, capacities=False))


def case_only(train: Train, name: str | None) -> Train:
    """Return a train with one of its load cases, with all for None."""
    if name is None:
        return train
    with placed("load_case"):
        return replace(train, cases=(train.case(name),))


def asked_for(drive: Drive, pulley: str | None, case: str | None) -> tuple[Pulley, LoadCase]:
    """Return a pulley and a load case by name; for None what `Drive` means by none."""
    with placed("pulley"):
        found = drive.pulley(pulley)
    with placed("load_case"):
        return found, drive.load_case(case)
