"""What other files say of a drive file: which it is, which pulley, which load cases."""

import os
from collections.abc import Iterable

from wraparc.drive import Drive
from wraparc.errors import shown
from wraparc.files.conditions import refuse_several
from wraparc.schema.problems import Place, Report
from wraparc.schema.tables import Record
from wraparc.train.file import load_drive


def drive_of(record: Record, folder: str, report: Report) -> Drive | None:
    """Return the drive that a file names under ``drive``, or None after reporting."""
    path = os.path.join(folder, record["drive"])

    def read() -> Drive:
        drive = load_drive(path)
        refuse_several(drive, "this file needs")
        return drive

    return report.tried(read, ("drive",))


def pulley_of(record: Record, drive: Drive, report: Report) -> str:
    """Return the name under ``pulley``, which a drive of several pulleys needs."""
    if "pulley" not in record and len(drive.pulleys) > 1:
        there = ", ".join(shown(p.name) for p in drive.pulleys)
        report.add(("pulley",), "the drive has several pulleys", f"Write which of {there}.")
    found = report.tried(lambda: drive.pulley(record.get("pulley")), ("pulley",))
    return (found or drive.pulleys[0]).name


def case_of(record: Record, drive: Drive, report: Report) -> str:
    """Return the name under ``load_case``, that of the drive that is meant if none is there."""
    place = (*record.place, "load_case")
    found = report.tried(lambda: drive.load_case(record.get("load_case")), place)
    return (found or drive.load_case()).name


def check_cases(names: Iterable[tuple[str, Place]], drive: Drive, report: Report) -> None:
    """Report names of load cases, each with its place, that the drive does not have."""
    for name, place in names:
        report.tried(lambda name=name: drive.load_case(name), place)  # type: ignore[misc]
