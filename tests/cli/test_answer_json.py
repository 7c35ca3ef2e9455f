"""The answer in the JSON of every command: one form, numbers in SI.

Expected: ``docs/reference/answer.schema.json``, which users are given; the glossary; and the
results of the same JSON.
"""

import csv
import json
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from wraparc.glossary import GLOSSARY
from wraparc.units import DIMENSION_TEXT

pytestmark = pytest.mark.usefixtures("solved_once")

REPOSITORY = Path(__file__).parents[2]
EXAMPLES = REPOSITORY / "examples"
SCHEMA = json.loads((REPOSITORY / "docs" / "reference" / "answer.schema.json").read_text("utf-8"))
ASKED = {
    "a drive": ("solve", EXAMPLES / "head-drive-fabric.toml"),
    "a train": ("solve", EXAMPLES / "tandem-fabric.toml"),
    "uneven": ("solve", EXAMPLES / "steel-cord-drive.toml", "--method", "both"),
    "trim": ("trim", EXAMPLES / "tandem-fabric.toml", "--points", 3),
    "field": ("field", EXAMPLES / "head-drive-fabric.toml"),
    "changed": ("what-if", EXAMPLES / "head-drive-fabric.toml", "--other-carcass"),
    "run": ("run", EXAMPLES / "tandem-fabric.toml", "--points", 12, "--step", "50 ms", "--quiet"),
    "stability": ("stability", EXAMPLES / "tandem-fabric.toml"),
    "lagging": ("lagging", "diamond-rubber"),
    "fitted": ("fit", EXAMPLES / "shear_tests" / "plan.toml", "-o", "lagging.toml"),
}


def cells_of(of: Any) -> list[dict[str, Any]]:
    """Return every cell of an answer."""
    if isinstance(of, dict):
        own = of.get("cells", [of] if "unit" in of else [])
        return [*own, *(cell for key in of if key != "cells" for cell in cells_of(of[key]))]
    return [cell for part in of for cell in cells_of(part)] if isinstance(of, list) else []


@pytest.mark.parametrize("name", ASKED)
def test_answers_are_what_the_schema_says(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = wraparc(*ASKED[name], "--json", "-")
    answer = ran.json["answer"]
    import_module("jsonschema").Draft202012Validator(SCHEMA).validate(answer)
    assert "\\u0002" not in ran.out  # a slot that nobody filled in
    assert "\\u0004" not in ran.out
    assert answer["tables"]
    cells = cells_of(answer)
    if name not in ("fitted", "lagging"):  # what is told with its interval is text
        assert len(cells) > 20
    for cell in cells:
        if "name" in cell and "level" not in cell:  # a verdict is no cell
            unit = DIMENSION_TEXT[GLOSSARY[cell["name"]].dimension].si_unit or "1"
            assert cell["unit"] == unit, cell


def test_the_numbers_are_those_of_the_results() -> None:
    """Each row of the glossary in the table of the governing arc, against the arc: not rounded."""
    document = wraparc(*ASKED["a drive"], "--json", "-").json
    place = document["governing"]
    arcs = [a for a in document["arcs"] if a["load_case"] == place["load_case"]]
    rows = next(t for t in document["answer"]["tables"] if t["name"] == "result")["rows"]
    told = {
        row["name"]: row["values"][0]["value"]
        for row in rows
        if row["name"] in arcs[0] and "value" in row["values"][0]
    }
    assert len(told) >= 6
    assert told == {name: arcs[0][name] for name in told}
    head = document["answer"]["verdict"]["text"]
    assert [cell["value"] for cell in head["cells"]][:2] == [
        document["verdict"]["value"], document["verdict"]["limit"]
    ]  # fmt: skip


def test_a_run_is_written_beside_its_rows(tmp_path: Path) -> None:
    """Expected: the largest creep of the rows, which are every step of the run."""
    event = ("run", EXAMPLES / "tandem-fabric.toml", "--points", 12, "--step", "50 ms", "--quiet")
    ran = wraparc(*event, "--csv", "-", "--json", tmp_path / "run.json")
    document = json.loads((tmp_path / "run.json").read_text("utf-8"))
    rows = list(csv.DictReader(ran.out.splitlines()))
    first = document["drums"][0]
    column = next(name for name in rows[0] if name.startswith(f"{first['name']}: exit creep"))
    largest = max(abs(float(row[column])) for row in rows)
    assert first["extremes"]["creep"]["value"] == pytest.approx(largest, rel=1e-3)
    assert document["outcome"] == "whole"
    assert "verdict" not in ran.out


def test_the_json_of_a_train_has_the_verdict_on_the_train(tmp_path: Path) -> None:
    # expected: what is printed; gross slip leads over drives that oppose each other
    file = tmp_path / "fights.toml"
    file.write_text(
        (EXAMPLES / "tandem-fabric.toml")
        .read_text("utf-8")
        .replace('["50 %", "50 %"]', '["130 %", "-30 %"]')
        .replace("format = 1", 'format = 1\ncondition = ["dry", "wet"]', 1),
        "utf-8",
    )
    told = wraparc("solve", file, "--json", "-").json
    lead = "Creep 101 mm exceeds the 63.5 mm gross-slip limit (first, design, wet)."
    assert told["verdict"]["text"] == lead
    assert told["verdict"] == told["train"]["verdict"]
    assert told["least_tension"] == told["train"]["least_tension"]
    checks = [check["name"] for check in told["arcs"][0]["checks"]]
    assert told["verdict"]["name"] == "creep"
    assert checks[0] == "opposing_drives"
    dry, wet = told["conditions"]
    assert wet["text"] == lead
    assert "opposing_drives" in dry["checks"]
    assert lead in wraparc("solve", file).words


def test_conditions_have_a_level_each_and_one_line_on_the_data(tmp_path: Path) -> None:
    file = tmp_path / "both.toml"
    text = (EXAMPLES / "tandem-fabric.toml").read_text("utf-8")
    file.write_text(
        text.replace("format = 1", 'format = 1\ncondition = ["dry", "wet"]', 1), "utf-8"
    )
    told = wraparc("solve", file, "--table", "conditions").words
    assert "dry wet Verdict OK ATTENTION " in told
    whole = wraparc("solve", file).words
    assert "ATTENTION diamond-rubber not tested wet: dry friction times 0.824 used (f" in whole
    assert (
        "Action Test lagging diamond-rubber wet. Reserve FAILS at Te +58 %. Data Friction, blo"
        in whole
    )
