"""The note is the answer: the same tables as the full answer on the screen, none of its own."""

from functools import cache

import pytest

from render.cases import EXAMPLES
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.sheet import Sheet, Table
from wraparc.answer.train_sheet import train_sheet
from wraparc.cli.solve import solved
from wraparc.render.note import Note, NoteHead, compose_note
from wraparc.train.file import load_drive_or_train

pytestmark = pytest.mark.usefixtures("solved_once")

#: One pulley, several on one belt, one in two conditions, one that is uneven across its width.
FILES = (
    "head-drive-fabric", "tandem-fabric", "head-drive-fabric dry wet", "worn-head-drive-fabric",
)  # fmt: skip
#: A note lists every input of the drive; the answer those of the arc that is shown in full.
INPUTS = "inputs"


@cache
def answer_and_note(name: str) -> tuple[Sheet, Note]:
    """The full answer by both methods, and the note of the same results."""
    file, *conditions = name.split()
    read = load_drive_or_train(EXAMPLES / f"{file}.toml", conditions=conditions)
    results, train = solved(read, "both", None, None, "")
    sheet = (
        drive_sheet(results, reserve="all", probability=True)
        if train is None
        else train_sheet(train, None, results, reserve="all", probability=True)
    )
    return sheet, compose_note(results, NoteHead(), train)


def cells(tables: list[Table]) -> set[tuple[str, str, str, str]]:
    """Every value with its table, row and head."""
    return {
        (table.title, row.title, head, value)
        for table in tables
        for row in table.rows
        for head, value in zip(table.heads, row.values, strict=True)
    }


@pytest.mark.parametrize("name", FILES)
def test_a_note_has_every_table_of_the_answer_and_no_other(name: str) -> None:
    sheet, note = answer_and_note(name)
    answered = [table for table in sheet.tables if table.name != INPUTS]
    noted = [t for section in note.sections for t in section.tables if t.name != INPUTS]
    assert len(answered) >= 10
    assert cells(answered) - cells(noted) == set()
    laws = "coefficients"  # stand beside the inputs
    assert {t.title for t in noted if t.name != laws} == {t.title for t in answered}


@pytest.mark.parametrize("name", FILES)
def test_the_box_of_a_note_has_the_lines_of_the_first_screen(name: str) -> None:
    sheet, note = answer_and_note(name)
    assert sheet.verdict is not None
    assert (note.told.word, note.told.text) == (sheet.verdict.word, sheet.verdict.text)
    assert note.told.lines == sheet.verdict.lines


def test_energy_wear_and_the_creep_ratio_stand_in_a_note_by_both_methods() -> None:
    """What a client asks of a report, and what it lacked."""
    _, note = answer_and_note("head-drive-fabric")
    tables = {t.name: t for section in note.sections for t in section.tables}
    assert {row.name for row in tables["energy"].rows} >= {"power_loss", "frictional_energy"}
    ratio = next(row for row in tables["result"].rows if row.title == "Creep ratio")
    assert len(ratio.values) == 2
