"""The calculation note of a drive."""

from datetime import UTC, datetime
from typing import Any

from wraparc.arc import Distributed, PaperMarch, solve
from wraparc.drive import Drive
from wraparc.motion.file import motion_from_document
from wraparc.motion.reported import asks, followed
from wraparc.render import NoteHead, markdown, pdf, workbook
from wraparc.train import solve_train
from wraparc.web.answers.documents import read, without_none
from wraparc.web.asked import ReportRequest

_KINDS: dict[str, Any] = {"pdf": pdf, "xlsx": workbook, "md": markdown}


def report(asked: ReportRequest, kind: str) -> bytes:
    """Return the note as a file: ``pdf``, ``xlsx`` or ``md``."""
    thing = read(asked.document)
    given = {key: text for key, text in asked.head.model_dump().items() if text}
    date = datetime.now(UTC).date().isoformat()
    head = NoteHead(**{"date": date, "file": f"{asked.name}.toml", **given})
    train = None
    if isinstance(thing, Drive):
        first = solve(thing, method=Distributed(), raise_on_failure=False)
    else:
        train = solve_train(thing, raise_on_failure=False)
        first = train.drive_result()
    second = solve(first.drive, method=PaperMarch(), raise_on_failure=False)
    document, in_time = without_none(asked.document), None
    if asks(document):
        in_time = followed(motion_from_document(document))
    made = _KINDS[kind]([first, second], head, system=asked.units, train=train, in_time=in_time)
    return made.encode("utf-8") if isinstance(made, str) else bytes(made)
