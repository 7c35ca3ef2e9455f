"""Drive files of several drives on one belt to trains."""

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, cast

from wraparc.drive import DESIGN, Belt, Drive, Pulley, ReadFrom
from wraparc.errors import InputError, Problem, placed
from wraparc.files.conditions import asking, build_conditions, in_each_condition
from wraparc.files.drive_build import (
    Laggings,
    build_belt,
    build_criteria,
    build_pulley,
    report_together,
)
from wraparc.files.drive_file import drive_from_document, overridden
from wraparc.files.tensions import KEYS, report_uncertain_twice
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import Report, place_text
from wraparc.schema.source import Document, parse, read_tables
from wraparc.schema.tables import Record
from wraparc.train.conveyed import build_train_conveyor, conveyor_cases, train_take_up
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.reader import Reader
from wraparc.train.train import Train, TrainCase


def load_train(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Train:
    """Return the train of a drive file.

    A file with a ``[train]`` table says how the load divides; without one the tensions of the
    pulleys say it.

    Parameters
    ----------
    path, overrides, allow_paths
        As for `load_drive`.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    read = load_drive_or_train(path, overrides=overrides, allow_paths=allow_paths)
    return read if isinstance(read, Train) else Train.of(read)


def load_drive_or_train(
    path: str | os.PathLike[str],
    *,
    overrides: Overrides = (),
    allow_paths: bool = True,
    conditions: Sequence[str] = (),
    also: Callable[..., None] | None = None,
) -> Drive | Train:
    """Return what a drive file describes: a train if it has a ``[train]`` table.

    Parameters
    ----------
    path, overrides, allow_paths
        As for `load_drive`.
    conditions
        Conditions to solve it in, ``("dry", "wet")``, whatever the file says of them.
    also
        Reads what else stands in the document, called with it and its `file`; its faults are told
        with the others.
    """

    def read(document: Document, **more: Any) -> Drive | Train:
        if conditions:
            with placed("--conditions", str(more.get("file", ""))):
                document = asking(document, conditions)
        return drive_or_train_from_document(document, also, **more)

    return load(path, read, overrides, TRAIN_FILE, "drive", allow_paths=allow_paths)


def drive_or_train_from_document(
    document: Document, also: Callable[..., None] | None = None, **more: Any
) -> Drive | Train:
    """Return what a drive file describes that is already parsed, see `load_drive_or_train`."""
    reader = train_from_document if "train" in document else drive_from_document
    if also is None:
        return reader(document, **more)
    problems: list[Problem] = []
    try:
        also(document, file=str(more.get("file", "")))
    except InputError as error:
        problems += error.problems
    try:
        found = reader(document, **more)
    except InputError as error:
        raise InputError([*error.problems, *problems]) from None
    if problems:
        raise InputError(problems)
    return found


def load_drive(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Drive:
    """Return the drive of a drive file, with the tensions of every pulley.

    A train comes with the tensions that its load divides into; where speeds or motors divide it,
    it is solved for them.

    Parameters
    ----------
    path
        The file, TOML or JSON.
    overrides
        Values put over those of the file, ``KEY=VALUE`` or by key path.
    allow_paths
        Whether a lagging may be named by the path of its file.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(
        path, any_drive_from_document, overrides, file_kind="drive", allow_paths=allow_paths
    )


def any_drive_from_document(document: Document, **more: Any) -> Drive:
    """Return the drive of a drive file that is already parsed, see `load_drive`."""
    whole = overridden(document, more.pop("overrides", ()), file=more.get("file", ""))
    if "train" in whole:
        from wraparc.train.as_drive import as_drive  # takes the solver, which few files need

        return as_drive(train_from_document(whole, **more))
    return drive_from_document(whole, **more)


def train_from_text(text: str, *, file: str = "", folder: str = "") -> Train:
    """Return the train of the text of a drive file; paths of lagging files are refused."""
    return train_from_document(parse(text, file), file=file, folder=folder)


def train_from_document(
    document: Document,
    *,
    file: str = "",
    folder: str = "",
    overrides: Overrides = (),
    allow_paths: bool = False,
) -> Train:
    """Return the train of a drive file that is already parsed; the document is not changed."""
    document = overridden(document, overrides, file=file)
    if "train" not in document:
        drive = drive_from_document(document, file=file, folder=folder, allow_paths=allow_paths)
        return Train.of(drive)
    record, report = read_tables(TRAIN_FILE, document, file)
    belt_record = record.get("belt")
    belt = build_belt(belt_record, report) if isinstance(belt_record, Record) else None
    own = record.get("lagging")
    laggings = Laggings(own if isinstance(own, dict) else {}, folder, allow_paths, report)
    records = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    conditions = build_conditions(record, report)
    pulleys = [build_pulley(item, laggings, conditions, report) for item in records]
    _refuse_pulley_tensions(record, records, report)
    report_uncertain_twice(record, report)
    criteria = build_criteria(record, belt, report)
    conveyor = None
    if "conveyor" in document:
        conveyor = build_train_conveyor(record, belt, criteria.take_up, report)
    train = record.get("train")
    ends = (
        [train[key] for key in ("entry_tension", "exit_tension") if key in train]
        if isinstance(train, Record)
        else []
    )
    report_together(belt_record, belt, pulleys, {"train": min(ends)} if ends else {}, report)
    report.raise_all()
    # nothing was reported, so nothing is None
    known = cast(Belt, belt), [cast(Pulley, p) for p in pulleys]
    reader = Reader(record, *known, report, criteria.take_up)
    parts = {key: record[key] for key in ("title", "description", "creep_limit") if key in record}
    cases: list[TrainCase] = []
    if conveyor is None:
        cases = reader.cases()
    else:
        division = reader.division()
        if division is not None:
            conveyor, cases = conveyor_cases(conveyor, division, record["conveyor"], report)
            criteria = replace(criteria, take_up=train_take_up(criteria.take_up, conveyor))
    report.raise_all()
    try:
        return Train(
            belt=reader.belt,
            pulleys=reader.actual,
            cases=in_each_condition(cases, conditions),
            criteria=criteria,
            nominal_diameters=reader.nominal if reader.actual != tuple(reader.pulleys) else (),
            read_from=ReadFrom(document, folder, allow_paths),
            conveyor=conveyor,
            **parts,
        )
    except InputError as error:
        told: dict[tuple[str, str], Problem] = {}  # once only what several cases have from [train]
        for problem in error.problems:
            told.setdefault((problem.message, problem.value), _placed(problem, cases, file))
        raise InputError(told.values()) from None


def _placed(problem: Problem, cases: Sequence[TrainCase], file: str) -> Problem:
    """Return a problem of a load case of the code where the file has it."""
    for case in cases:
        prefix = f"load_case.{case.name}."
        if problem.key.startswith(prefix):
            rest = problem.key.removeprefix(prefix)
            own = () if case.name == DESIGN else ("load_case", case.name)
            return replace(problem, key=f"{place_text((*own, 'train'))}.{rest}", file=file)
    return replace(problem, file=file)


def _refuse_pulley_tensions(record: Record, pulleys: Sequence[Record], report: Report) -> None:
    """Report tensions of single pulleys: in a train they follow."""
    message = "the tensions of single pulleys follow from [train]"
    for pulley in pulleys:
        for key in (key for key in KEYS if key in pulley):
            report.add((*pulley.place, key), message, "Leave it out.", pulley.raw[key])
    for case in record.get("load_case") or ():
        if isinstance(case, Record) and "pulley" in case:
            remedy = "Write a [load_case.train] table."
            report.add((*case.place, "pulley"), message, remedy)
