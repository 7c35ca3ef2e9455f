"""A drive learned from the logs of its control system, in a process of its own."""

import os
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from wraparc.answer.learn_sheet import learn_document, learn_sheet
from wraparc.answer.sheet import Row
from wraparc.errors import InputError
from wraparc.learn.file import plan_from_document
from wraparc.learn.learn import Learned, learn
from wraparc.learn.write import learned_text
from wraparc.schema.emit import document_text
from wraparc.web.answers.documents import read, without_none
from wraparc.web.answers.shear_tests import MachineFile
from wraparc.web.answers.shown import Answer, Data, Sheet, Text, plain, sheet, worded
from wraparc.web.answers.texts import file_stem
from wraparc.web.asked import LearnRequest
from wraparc.web.progress import tell

_DRIVE = "drive.toml"
#: Steps in the words of the page.
_STEPS = {
    "reading": "reading the logs", "windows": "looking for steady running",
    "tables": "solving the drive", "fit": "fitting friction and zero",
    "episodes": "looking for wet episodes", "results": "summing up",
}  # fmt: skip


class LogFinding(Answer):
    """One line of what was found: of a pulley, where there are several."""

    title: str
    value: Text
    text: Text


class LearnedResult(Sheet):
    """What came out of the logs of a drive."""

    summary: Data
    findings: list[LogFinding]
    pictures: dict[str, str]
    toml: str
    name: str


def run(asked: LearnRequest, files: list[MachineFile]) -> LearnedResult:
    """Learn a drive from logs; tells of its progress.

    Raises
    ------
    InputError
        As the command raises it, of files by their names.
    """
    if hasattr(os, "nice"):
        os.nice(5)  # others are served meanwhile
    document = without_none(asked.document)
    read(document)
    with TemporaryDirectory() as folder:
        Path(folder, _DRIVE).write_text(document_text(document), "utf-8")
        names = []
        for number, file in enumerate(files, start=1):
            names.append(file.name if file.name not in names else f"{number} {file.name}")
            Path(folder, names[-1]).write_bytes(file.data)
        settings = {**without_none(asked.learn), "format": 1, "drive": _DRIVE, "files": names}
        try:
            plan = plan_from_document(settings, file="logs", folder=folder)
            learned = learn(plan, lambda step, share: tell(round(100 * share), 100, _STEPS[step]))
        except InputError as error:
            raise InputError([replace(p, file=_name(p.file)) for p in error.problems]) from None
        title = document.get("title")
        return _result(learned, f"{file_stem(title)}-learned.toml")


def _name(file: str) -> str:
    """Return the name of a file, without the folder that it has for a while."""
    return Path(file).name if file else file


def _result(learned: Learned, name: str) -> LearnedResult:
    from wraparc.plot.learn import learned_pictures

    told = learn_sheet(learned)
    drawn = {f"{of.name}.svg": of.draw() for of in learned_pictures(learned)}
    return LearnedResult(
        summary=plain(learn_document(learned)),
        findings=[
            _finding(row) for table in told.tables if table.name == "learned" for row in table.rows
        ],
        pictures={file: one.to_bytes("svg").decode("utf-8") for file, one in drawn.items()},
        toml=learned_text(learned),
        name=name,
        **sheet(told),
    )


def _finding(row: Row) -> LogFinding:
    value, *more = row.values
    rest = ", ".join(text for text in (*more, row.note) if text)
    return LogFinding(title=row.title, value=worded(value), text=worded(rest))
