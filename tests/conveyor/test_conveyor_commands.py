"""Choosing, studies and what-if on a drive whose tensions follow from its ``[conveyor]`` table.

Expected: the drive file solved with the value put into it, and the checks of the drive itself.
"""

from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import load_drive, solve
from wraparc.answer.least_tension import at_least
from wraparc.answer.sheet import shown
from wraparc.checks import least_tension

EXAMPLE = Path(__file__).parents[2] / "examples" / "uphill-conveyor.toml"
LESS = 'conveyor.capacity="500 t/h"'
STUDY = """
format = 1
drive = "uphill.toml"
load_cases = ["full"]
outputs = ["exit_creep", "tension_ratio"]
[[axis]]
field = "conveyor.capacity"
values = ["500 t/h", "1000 t/h"]
"""
CHOOSE = """
format = 1
drive = "uphill.toml"
[candidates]
laggings = ["diamond-rubber"]
slack_tensions = "least"
[cost]
currency = "AUD"
years = 10
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "uphill.toml").write_text(EXAMPLE.read_text("utf-8"), "utf-8")
    return tmp_path


def creep(*settings: str) -> float:
    return solve(load_drive(EXAMPLE, overrides=settings)).arc("head", "full").exit_creep


def test_what_if_takes_a_change_of_the_conveyor(folder: Path) -> None:
    ran = wraparc(
        "what-if", folder / "uphill.toml", "--load-case", "full", "--change", LESS, "--json", "-"
    )
    assert ran.code == 0, ran.err
    found = [column["exit_creep"] for column in ran.json["results"]]
    assert found == pytest.approx([creep(), creep(LESS)], rel=1e-9)


def test_a_study_varies_the_conveyor(folder: Path) -> None:
    import pyarrow.parquet as pq

    (folder / "study.toml").write_text(STUDY, "utf-8")
    ran = wraparc("study", folder / "study.toml", "-o", folder / "a.parquet", "--full")
    assert ran.code == 0, ran.err
    rows = pq.read_table(folder / "a.parquet")["exit_creep"].to_pylist()
    assert rows == pytest.approx([creep(LESS), creep()], rel=1e-3)
    assert "Rows leave out the energy balance of each solution" in ran.words


def test_the_choice_has_the_least_tension_of_the_checks(folder: Path) -> None:
    (folder / "choose.toml").write_text(CHOOSE, "utf-8")
    result = solve(load_drive(EXAMPLE))
    found = least_tension(result)
    assert found is not None
    told = shown(at_least(found.tension), "si")
    ran = wraparc("choose", folder / "choose.toml")
    assert f"Lowest cost: diamond-rubber with tension at the take-up {told}, " in ran.words
