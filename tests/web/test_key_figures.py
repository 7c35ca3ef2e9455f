"""One list of key figures: what is added to it reaches every answer and interface."""

import json
import math
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from web.calculators import document
from wraparc import load_drive, solve
from wraparc.answer import key_figures as listed
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.key_figures import KeyFigure
from wraparc.answer.sheet import Table
from wraparc.answer.short import short_sheet
from wraparc.answer.train_sheet import case_table, train_sheet
from wraparc.answer.what_if_sheet import what_if_document, what_if_sheet
from wraparc.choose.what_if import Change, what_if
from wraparc.glossary import GLOSSARY
from wraparc.render import workbook
from wraparc.render.note import NoteHead, compose_note
from wraparc.train import solve_train
from wraparc.train.file import load_train
from wraparc.web.answers.compare import compare
from wraparc.web.answers.form import form
from wraparc.web.asked import CompareRequest

EXAMPLES = Path(__file__).parents[2] / "examples"
#: Of a solved arc and the glossary, and no key figure yet.
NEW = KeyFigure("peak_shear_position", "low")
TITLE = GLOSSARY[NEW.name].title


@pytest.fixture
def added(monkeypatch: pytest.MonkeyPatch) -> None:
    """Add a quantity to the list."""
    monkeypatch.setattr(listed, "KEY_FIGURES", (*listed.KEY_FIGURES, NEW))
    form.cache_clear()
    monkeypatch.setattr("wraparc.web.answers.form.form", form.__wrapped__)


def named(tables: tuple[Table, ...], name: str) -> list[str]:
    """Titles of rows and columns of the tables of a name."""
    found = [t for t in tables if t.name == name]
    return [title for t in found for title in (*t.heads, *(row.title for row in t.rows))]


@pytest.mark.usefixtures("added")
def test_it_stands_in_the_full_answer_the_short_one_and_the_report() -> None:
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"))
    full = drive_sheet([result])
    assert TITLE in named(full.tables, "result")
    assert f"{TITLE} [" in "".join(named(full.tables, "figures"))
    assert TITLE in named(short_sheet(full).tables, "result")
    note = compose_note([result], NoteHead())
    tables = tuple(t for section in note.sections for t in section.tables)
    assert TITLE in named(tables, "result")
    assert f"{TITLE} [" in "".join(named(tables, "figures"))
    assert workbook([result])[:2] == b"PK"


@pytest.mark.usefixtures("added")
def test_it_stands_in_the_rows_of_drives_on_one_belt() -> None:
    result = solve_train(load_train(EXAMPLES / "tandem-fabric.toml"))
    row = next(row for row in case_table(result.cases[0]).rows if row.name == NEW.name)
    assert len(row.values) == 2
    assert TITLE in named(train_sheet(result, search=False).tables, "result")


@pytest.mark.usefixtures("added")
def test_it_stands_before_and_after_a_change() -> None:
    drive = load_drive(EXAMPLES / "head-drive-fabric.toml")
    found = what_if(
        drive, "head", "design", [Change("higher limit", replace(drive, creep_limit=0.01))]
    )
    assert TITLE in named(what_if_sheet(found, "").tables, "changes")
    assert NEW.name in what_if_document(found)["results"][0]


@pytest.mark.usefixtures("added")
def test_it_is_a_column_of_a_comparison() -> None:
    answer = compare(CompareRequest(document=document(), names=["full-ceramic"]))
    (column,) = (c for c in answer.columns if c.key == NEW.name)
    assert (column.title, column.better) == (TITLE, "low")
    assert all(row.cells[NEW.name].value is not None for row in answer.rows)


def page(numbers: dict[str, Any]) -> dict[str, list[str]]:
    """Titles of the tiles and pins of an arc with some numbers."""
    arc = {
        "numbers": numbers, "creep_limit": 6.35e-3, "status": "solved", "level": "OK",
        "levels": {}, "profile": {"wrap_pressure": [3e5, 1e5]},
    }  # fmt: skip
    given = {"form": form.__wrapped__().model_dump(mode="json"), "arc": arc}
    done = subprocess.run(
        ["node", str(Path(__file__).with_name("key_figure_cases.mjs"))], input=json.dumps(given),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: dict[str, list[str]] = json.loads(done.stdout)
    return found


def test_tiles_and_pins_of_the_page_are_those_of_the_list(monkeypatch: pytest.MonkeyPatch) -> None:
    numbers = solve(load_drive(EXAMPLES / "head-drive-fabric.toml")).arcs[0].scalars()
    finite = {name: value for name, value in numbers.items() if math.isfinite(value)}
    before = page(finite)
    assert TITLE not in (*before["tiles"], *before["pins"])
    assert {"Mean friction", "Slip at exit", "Power lost to creep"} <= {*before["tiles"]}
    assert {GLOSSARY["tension_ratio"].title, "Peak shear stress"} <= {*before["pins"]}
    monkeypatch.setattr(listed, "KEY_FIGURES", (*listed.KEY_FIGURES, NEW))
    after = page(finite)
    assert after["tiles"].count(TITLE) == after["pins"].count(TITLE) == 1
