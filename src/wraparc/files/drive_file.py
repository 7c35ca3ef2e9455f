"""Drive files to drives."""

import os
from dataclasses import replace
from typing import cast

from wraparc.drive import DESIGN, Belt, Drive, LoadCase, Pulley, ReadFrom, TakeUp, repeated
from wraparc.drive.drive import least_tensions
from wraparc.drive.load_case import UNCERTAIN_OF_CASE
from wraparc.drive.pitch import pitch_offset
from wraparc.errors import InputError, name_remedy
from wraparc.files.across_keys import check_width
from wraparc.files.conditions import build_conditions, condition_name, in_each_condition
from wraparc.files.conveyor_build import build_conveyor
from wraparc.files.drive_build import (
    Laggings,
    build_belt,
    build_criteria,
    build_pulley,
    report_together,
)
from wraparc.files.drive_keys import A_PULLEY, DRIVE
from wraparc.files.tensions import KEYS, Given, complete, report_uncertain_twice, resolve
from wraparc.schema.overrides import Overrides, load, put_over
from wraparc.schema.problems import Report, place_text
from wraparc.schema.source import Document, check_format, parse, read_tables
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import read_uncertainty


def load_drive(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Drive:
    """Return the drive of a drive file.

    Parameters
    ----------
    path
        A TOML file; laggings that it names by path are relative to it.
    overrides
        Values put over those of the file, by key path: ``{"belt.width": "1400 mm"}`` or
        texts like ``"belt.width=1400 mm"``.
    allow_paths
        Whether the file may name lagging files.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, drive_from_document, overrides, DRIVE, "drive", allow_paths=allow_paths)


def overridden(document: Document, overrides: Overrides, *, file: str = "") -> Document:
    """Return the document of a drive file with values put over its own, see `put_over`."""
    return put_over(document, overrides, DRIVE, file=file)


def drive_from_text(
    text: str,
    *,
    file: str = "",
    folder: str = "",
    overrides: Overrides = (),
    allow_paths: bool = False,
) -> Drive:
    """Return the drive of the text of a drive file.

    Parameters
    ----------
    text
        The text.
    file
        What to call it in messages.
    folder
        What the paths of lagging files are relative to.
    overrides, allow_paths
        As for `load_drive`; paths are refused unless allowed.
    """
    return drive_from_document(
        parse(text, file), file=file, folder=folder, overrides=overrides, allow_paths=allow_paths
    )


def drive_from_document(
    document: Document,
    *,
    file: str = "",
    folder: str = "",
    overrides: Overrides = (),
    allow_paths: bool = False,
) -> Drive:
    """Return the drive of a drive file that is already parsed; the document is not changed."""
    document = overridden(document, overrides, file=file)
    if "train" in document:
        check_format(document, file)
        report = Report(file)
        message = "makes it a train, not one drive"
        report.add(("train",), message, "Use wraparc.load_train.")
        report.raise_all()
    record, report = read_tables(DRIVE, document, file)
    belt_record = record.get("belt")
    belt = build_belt(belt_record, report) if isinstance(belt_record, Record) else None
    own = record.get("lagging")
    laggings = Laggings(own if isinstance(own, dict) else {}, folder, allow_paths, report)
    records = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    _name_pulley(records, report)
    conditions = build_conditions(record, report)
    pulleys = [build_pulley(item, laggings, conditions, report) for item in records]
    check_width(records, belt_record, report)
    report_uncertain_twice(record, report)
    criteria = build_criteria(record, belt, report)
    conveyor = None
    if "conveyor" in document:
        conveyor, cases = build_conveyor(record, belt, criteria.take_up, report)
    else:
        cases = _load_cases(record, records, belt, criteria.take_up, report)
    report_together(belt_record, belt, pulleys, least_tensions(cases), report)
    report.raise_all()
    parts = {key: record[key] for key in ("title", "description", "creep_limit") if key in record}
    return report.sure(
        lambda: Drive(
            # nothing was reported, so nothing is None
            belt=cast(Belt, belt),
            pulleys=tuple(cast(Pulley, pulley) for pulley in pulleys),
            load_cases=in_each_condition(cases, conditions),
            criteria=criteria,
            conveyor=conveyor,
            read_from=ReadFrom(document, folder, allow_paths),
            **parts,
        )
    )


def _name_pulley(pulleys: list[Record], report: Report) -> None:
    """Put the name of the only pulley into the hints that ask for one."""
    if len(pulleys) == 1 and "name" in pulleys[0]:
        hint, own = f"pulley.{A_PULLEY}.", f"{place_text(('pulley', pulleys[0]['name']))}."
        report.problems = [
            replace(problem, remedy=problem.remedy.replace(hint, own))
            for problem in report.problems
        ]


def _load_cases(
    record: Record,
    pulleys: list[Record],
    built_belt: Belt | None,
    take_up: TakeUp,
    report: Report,
) -> tuple[LoadCase, ...]:
    """Return the load case of the pulleys' own tensions, if they have them, and the others."""
    belt = record.get("belt")
    names = [item["name"] for item in pulleys if "name" in item]
    cases = [item for item in record.get("load_case") or () if isinstance(item, Record)]
    for problem in repeated("pulley", names):
        report.take(InputError(problem), ())
    if not names or len(set(names)) < len(record["pulley"]) or not isinstance(belt, Record):
        return ()
    sure = belt.sound("speed") and all(item.sound(*KEYS) for item in pulleys)
    speed = belt.get("speed")
    own = [Given.of(item["name"], item, _pulled_at(item, built_belt)) for item in pulleys]
    built = []
    if not cases or complete(own, speed):
        tensions = resolve(own, speed, report, sure=sure)
        built.append(LoadCase(name=DESIGN, tensions=tensions))
        sure = sure and len(tensions) == len(own)  # said once, not in every case that takes it over
    for case in cases:
        if "train" in case:
            report.add((*case.place, "train"), "there is no [train] table", "Write one.")
        given = _of_case(case, own, take_up, speed, report)
        whole = sure and case.sound()
        tensions = resolve(given, speed, report, sure=whole)
        if "name" in case:
            more = {"kind": case.get("kind", "running"), "condition": condition_name(case)}
            more["description"] = case.get("description", "")
            more["uncertainty"] = _uncertainty_of(case, report)
            built.append(LoadCase(name=case["name"], tensions=tensions, **more))
    for problem in repeated("load_case", (case.name for case in built)):
        report.take(InputError(problem), ())
    return tuple(built)


def _uncertainty_of(case: Record, report: Report) -> dict[str, dict[str, float]]:
    """Return the uncertainties that a load case states, by pulley."""
    found = {}
    for name, table in case.get("pulley", {}).items():
        if isinstance(table, Record):
            of = read_uncertainty(table, UNCERTAIN_OF_CASE, report)
            if of:
                found[name] = of
    return found


def _pulled_at(pulley: Record, belt: Belt | None) -> float | None:
    """Return the diameter that a torque pulls at, that of the tension member [m]."""
    diameter: float | None = pulley.get("diameter")
    if diameter is None or belt is None:
        return diameter
    return diameter + 2.0 * (pitch_offset(belt, pulley.get("side", "pulley")) or 0.0)


def _of_case(
    case: Record, own: list[Given], take_up: TakeUp, speed: float | None, report: Report
) -> list[Given]:
    """Return the tensions of the pulleys with those of a load case put over them."""
    tables = case.get("pulley", {})
    names = [item.name for item in own]
    for name in tables if own else ():  # without any pulley that is read, it is told elsewhere
        if name not in names:
            place = (*case.place, "pulley", name)
            report.add(place, "no such pulley", name_remedy(name, names))
    given = []
    for item in own:
        table = tables.get(item.name)
        place = (*case.place, "pulley", item.name)
        over = table if isinstance(table, Record) else Record({}, place, {})
        given.append(item.overridden(over, fixed=take_up.fixed, speed=speed))
    return given
