"""A measured drive: what a record says of the friction, as `wraparc calibrate` and `overlay` do."""

from base64 import b64decode
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from wraparc.answer.calibrate_sheet import calibrate_sheet
from wraparc.answer.overlay_sheet import overlay_sheet
from wraparc.calibrate.calibration import Calibration, calibrate
from wraparc.calibrate.file import (
    Measured,
    calibrated_lagging,
    measured_from_document,
    overlays,
)
from wraparc.errors import InputError, MissingExtraError, Problem, input_error, shown
from wraparc.files import lagging_text
from wraparc.plot.overlay import plot_overlay
from wraparc.schema.emit import document_text
from wraparc.schema.source import decoded, parse
from wraparc.web.answers.documents import json_like, read, without_none
from wraparc.web.answers.shown import Data, Sheet, sheet
from wraparc.web.asked import MeasuredFile, MeasuredRequest

_DRIVE, _PLAN = "drive.toml", ".toml"


class MeasuredAnswer(Sheet):
    """Estimates, misfits and predictions, the picture, and the calibrated lagging."""

    picture: str
    lagging: Data | None
    file: str


def compare_measured(asked: MeasuredRequest) -> MeasuredAnswer:
    """Compare a drive with what was measured on it, and calibrate it to that if asked."""
    with TemporaryDirectory() as folder:
        measured = _read(asked, folder)
    predicted = overlays(measured)
    found = calibrate(measured.problem) if measured.problem.parameters else None

    problem, title = measured.problem, measured.title
    told = overlay_sheet(problem, measured.folded, predicted, title)
    if found is not None:
        sources = tuple(map(str, measured.sources))
        fit = calibrate_sheet(found, problem, title, measured.description, sources)
        tables, remarks = (*fit.tables, *told.tables), (*told.remarks, *fit.remarks)
        told = replace(fit, tables=tables, remarks=remarks)

    text = _lagging(found, measured) if found is not None and found.told else ""
    return MeasuredAnswer(
        **sheet(told),
        picture=_picture(measured, predicted),
        lagging=_table(text) if text else None,
        file=text,
    )


def _lagging(found: Calibration, measured: Measured) -> str:
    return lagging_text(calibrated_lagging(found, measured))


def _table(text: str) -> Data:
    """Return the table of a lagging in a drive document."""
    table = json_like(parse(text))
    return {key: value for key, value in table.items() if key != "format"}


def _picture(measured: Measured, predicted: Any) -> str:
    """Return the courses over their predictions as SVG; none without matplotlib or a course."""
    if not measured.problem.traces:
        return ""
    try:
        return plot_overlay(measured.problem.traces, predicted).to_bytes("svg").decode("utf-8")
    except MissingExtraError:
        return ""


def _read(asked: MeasuredRequest, folder: str) -> Measured:
    """Return what was measured; files are kept under numbers, never under a name that was sent."""
    drive = without_none(asked.document)
    read(drive)
    plans = [f for f in asked.files if f.name.lower().endswith(_PLAN)]
    records = [f for f in asked.files if f not in plans]
    if len(plans) > 1:
        raise input_error(
            message="more than one calibrate file",
            value=", ".join(shown(p.name) for p in plans),
            remedy="Choose one, with the records that it names.",
        )
    plan = _plan(plans[0]) if plans else _usual(asked, records)
    stored = {}
    for number, record in enumerate(records, start=1):
        stored[record.name] = f"record-{number}.csv"
        Path(folder, stored[record.name]).write_bytes(_bytes(record))
    problems = list(_missing(plan, stored))
    if problems:
        raise InputError(problems)
    Path(folder, _DRIVE).write_text(document_text(drive), "utf-8")
    plan = {**plan, "drive": _DRIVE, "record": _renamed(plan, stored)}
    if asked.pulley:
        plan["pulley"] = asked.pulley
    try:
        return measured_from_document(plan, folder=folder)
    except InputError as error:
        raise InputError([_as_sent(p, folder, stored) for p in error.problems]) from None


def _bytes(file: MeasuredFile) -> bytes:
    try:
        return b64decode(file.data, validate=True)
    except ValueError:
        message, remedy = "is not in base 64", "Send the bytes of the file in base 64."
        raise input_error(file=file.name, message=message, remedy=remedy) from None


def _plan(file: MeasuredFile) -> Data:
    return parse(decoded(_bytes(file), file.name), file.name)


def _usual(asked: MeasuredRequest, records: list[MeasuredFile]) -> Data:
    """Return the plan for records alone: all of one load case."""
    case = {"load_case": asked.load_case} if asked.load_case else {}
    return {
        "format": 1,
        "parameters": list(asked.parameters),
        "record": [{"file": r.name, **case} for r in records],
    }


def _named(plan: Data) -> list[Any]:
    found = plan.get("record", [])
    return found if isinstance(found, list) else []


def _missing(plan: Data, stored: dict[str, str]) -> Iterator[Problem]:
    """Yield a problem for every record that a plan names and that was not sent."""
    for number, record in enumerate(_named(plan), start=1):
        name = record.get("file") if isinstance(record, dict) else None
        if isinstance(name, str) and name not in stored:
            yield Problem(
                key=f"record[{number}].file",
                value=shown(name),
                message="was not chosen together with the calibrate file",
                remedy="Choose both.",
            )
    if not stored and not plan.get("number"):
        yield Problem(
            message="nothing measured was chosen",
            remedy="Choose the record of a pulley (CSV), or a calibrate file with its records.",
        )


def _renamed(plan: Data, stored: dict[str, str]) -> list[Any]:
    return [
        {**r, "file": stored.get(str(r.get("file")), r.get("file"))} if isinstance(r, dict) else r
        for r in _named(plan)
    ]


def _as_sent(problem: Problem, folder: str, stored: dict[str, str]) -> Problem:
    """Return a problem with the names that were sent in place of those of the files here."""
    file = problem.file.removeprefix(folder).lstrip("/\\")
    names = {here: name for name, here in stored.items()}
    return replace(problem, file=names.get(file, file))
