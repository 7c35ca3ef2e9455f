"""The answer to a drive as files: those that ``wraparc solve`` writes."""

from typing import Literal

from wraparc.answer.answer_data import answer_json
from wraparc.answer.document import solved_document
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.train_sheet import train_sheet
from wraparc.arc import Distributed, DriveResult, solve
from wraparc.drive import Drive
from wraparc.render.profile_csv import profile_csv
from wraparc.train import TrainResult, solve_train
from wraparc.web.answers.documents import read
from wraparc.web.asked import ExportRequest

ExportKind = Literal["json", "csv"]


def export(asked: ExportRequest, kind: ExportKind) -> bytes:
    """Return results as JSON, or profiles as CSV."""
    thing = read(asked.document)
    train: TrainResult | None = None
    result: DriveResult
    if isinstance(thing, Drive):
        result = solve(thing, method=Distributed(), raise_on_failure=False)
    else:
        train = solve_train(thing, raise_on_failure=False)
        result = train.drive_result()
    if kind == "csv":
        return profile_csv(list(result), asked.units).encode("utf-8")
    document = solved_document([result], train, file=f"{asked.name}.toml")
    sheet = drive_sheet([result]) if train is None else train_sheet(train)
    return answer_json(document, sheet).encode("utf-8")
