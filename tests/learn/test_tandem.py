"""Two drives on one belt: expected is what the made-up tandem was made from."""

import json
import math
from pathlib import Path

import pytest

from cli.running import wraparc
from learn.tandem import LEARN, NAMES, ZEROS, written
from wraparc import load_drive
from wraparc.learn.write import learned_levels
from wraparc.schema.overrides import read_document

DAYS, FALLS = 16.0, (0.0, 0.009)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("tandem")
    written(folder, DAYS, FALLS)
    return folder


def test_each_drive_has_its_own_zero_friction_and_line(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    ran = wraparc("learn", "learn.toml", "--json", "a.json", "-o", "learned.toml")
    assert ran.code == 0, ran.err
    assert "\nATTENTION  Friction fell " in ran.out
    assert " since 1 March (second).\n" in ran.out
    answer = json.loads(Path("a.json").read_text("utf-8"))
    assert [p["name"] for p in answer["pulleys"]] == list(NAMES)
    for own, zero, fall in zip(answer["pulleys"], ZEROS, FALLS, strict=True):
        last = own["zero"][-1]
        assert last["low"] < zero < last["high"]
        change = own["change"]
        assert change["low"] < math.exp(-fall * DAYS) < change["high"], own["name"]
        level = own["friction"]
        assert level["low"] < math.exp(-fall * DAYS) < level["high"], own["name"]
    assert answer["pulleys"][1]["change"]["high"] < 1.0
    assert answer["episodes"] == []
    levels = learned_levels(read_document("learned.toml"))
    assert [one.pulley for one in levels] == list(NAMES)
    assert len(load_drive("learned.toml").pulleys) == len(NAMES)


def test_a_tandem_needs_both_drives_in_the_log(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    one = LEARN[: LEARN.rindex("[[pulley]]")]
    Path("one.toml").write_text(one, "utf-8")
    ran = wraparc("learn", "one.toml")
    assert ran.code == 2
    assert "the log needs all 2 pulleys of the drive" in ran.err
