"""One action through every door: command, JSON, notebook, report and interface."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

from actions.follow import solved_document
from cli.running import wraparc
from wraparc.actions import find_action
from wraparc.render.notebook import html
from wraparc.units import in_units

EXAMPLES = Path("examples")
FILES = ("head-drive-fabric", "triple-steel-cord")


def file_of(name: str) -> str:
    return str(EXAMPLES / f"{name}.toml")


def by_command(name: str, _: Path) -> str:
    return wraparc("solve", file_of(name)).out


def by_json(name: str, _: Path) -> str:
    return str(json.loads(wraparc("solve", file_of(name), "--json", "-").out)["verdict"]["action"])


def by_notebook(name: str, _: Path) -> str:
    return html(solved_document(tomllib.loads(Path(file_of(name)).read_text("utf-8"))))


def by_report(name: str, folder: Path) -> str:
    path = folder / "report.md"
    wraparc("report", file_of(name), "-o", str(path))
    return path.read_text("utf-8")


@pytest.mark.parametrize("door", [by_command, by_json, by_notebook, by_report])
@pytest.mark.parametrize("name", FILES)
def test_door_has_the_action_that_was_tried(
    door: Callable[[str, Path], str], name: str, tmp_path: Path
) -> None:
    action = find_action(solved_document(tomllib.loads(Path(file_of(name)).read_text("utf-8"))))
    assert action is not None
    assert in_units(action.text) in " ".join(door(name, tmp_path).split())


def test_json_has_the_changes_of_each_way() -> None:
    action = json.loads(wraparc("solve", file_of("head-drive-fabric"), "--json", "-").out)
    for way in action["verdict"]["action"]["ways"]:
        assert set(way) == {"changes", "proved", "left", "text"}
        for change in way["changes"]:
            assert set(change) == {"key", "from", "to", "unit"}
            assert change["from"] != change["to"]


def test_nothing_is_searched_where_every_check_passes(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise AssertionError("a search was begun")

    monkeypatch.setattr("wraparc.actions.find.find_ways", fail)
    monkeypatch.setattr("wraparc.actions.find.source_of", fail)
    assert wraparc("solve", file_of("uphill-conveyor")).code == 0
    assert wraparc("check", file_of("head-drive-fabric")).code == 0
