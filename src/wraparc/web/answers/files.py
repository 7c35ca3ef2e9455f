"""The answer to a drive as files: those that ``wraparc solve`` writes, and its calculation note."""

from datetime import UTC, datetime
from typing import Any, Literal

from wraparc.answer.answer_data import answer_json
from wraparc.answer.document import solved_document
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.train_sheet import train_sheet
from wraparc.arc import DriveResult, PaperMarch, solve
from wraparc.motion.file import motion_from_document
from wraparc.motion.reported import asks, followed
from wraparc.render import NoteHead, markdown, pdf, workbook
from wraparc.render.profile_csv import profile_csv
from wraparc.schema.source import Document
from wraparc.train import TrainResult
from wraparc.train.whole import by_pulley, solved
from wraparc.web.answers.documents import read, without_none
from wraparc.web.asked import ExportRequest, ReportRequest

ExportKind = Literal["json", "csv"]
NoteKind = Literal["pdf", "xlsx", "md"]
_NOTES: dict[str, Any] = {"pdf": pdf, "xlsx": workbook, "md": markdown}


def _solved(document: Document) -> tuple[DriveResult, TrainResult | None]:
    whole = solved(read(document))
    return by_pulley(whole), whole if isinstance(whole, TrainResult) else None


def export(asked: ExportRequest, kind: ExportKind) -> bytes:
    """Return results as JSON, or profiles as CSV."""
    result, train = _solved(asked.document)
    if kind == "csv":
        return profile_csv(list(result), asked.units).encode("utf-8")
    document = solved_document([result], train, file=f"{asked.name}.toml", reserve=True)
    if train is None:
        return answer_json(document, drive_sheet([result], reserve="all")).encode("utf-8")
    sheet = train_sheet(train, pulleys=[result], reserve="all")
    return answer_json(document, sheet).encode("utf-8")


def report(asked: ReportRequest, kind: NoteKind) -> bytes:
    """Return the calculation note."""
    first, train = _solved(asked.document)
    given = {key: text for key, text in asked.head.model_dump().items() if text}
    date = datetime.now(UTC).date().isoformat()
    head = NoteHead(**{"date": date, "file": f"{asked.name}.toml", **given})
    second = solve(first.drive, method=PaperMarch(), raise_on_failure=False)
    document, in_time = without_none(asked.document), None
    if asks(document):
        in_time = followed(motion_from_document(document))
    made = _NOTES[kind]([first, second], head, system=asked.units, train=train, in_time=in_time)
    return made.encode("utf-8") if isinstance(made, str) else bytes(made)
