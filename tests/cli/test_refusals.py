"""Refusals: each a fault, the value and a fix in twenty words, the same at every door."""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from cli.running import DRIVE, drive_file, wraparc
from refusing import (
    MOST_WORDS,
    faults_of,
    refusal_of,
    sources,
    spoilt,
    with_value,
    word_count,
)
from web.calculators import API, client
from wraparc import load_drive
from wraparc.errors import InputError, Problem

SOURCES = {name: (folder, document) for name, folder, document in sources()}
#: Of the faults of a file so many are left out for each that is tried.
EVERY = 11
_EXAMPLE = re.compile(r'for example ("[^"]*")\.$')


@pytest.mark.parametrize("number", range(len(SOURCES)), ids=list(SOURCES))
def test_every_refusal_of_a_spoilt_file_follows_the_grammar(number: int) -> None:
    folder, document = list(SOURCES.values())[number]
    assert refusal_of(document, folder) == ()
    count = 0
    for place, bad in spoilt(document, EVERY, number % EVERY):
        problems = refusal_of(bad, folder)
        texts = [str(problem) for problem in problems]
        assert len(set(texts)) == len(texts), (place, texts)
        for problem in problems:
            count += 1
            assert faults_of(problem) == [], (place, str(problem), word_count(problem))
    assert count > 10


@pytest.mark.parametrize("name", ["steel-cord-drive.toml", "tandem-fabric.toml", "plan.toml"])
def test_an_example_in_a_fix_may_stand_where_it_is_given(name: str) -> None:
    """Users copy it: it has the dimension that is needed there, and an allowed size."""
    folder, document = SOURCES[name]
    tried = 0
    for place, bad in spoilt(document, EVERY):
        (problem, *others) = refusal_of(bad, folder) or (Problem(message="none"),)
        match = _EXAMPLE.search(problem.remedy)
        if match is None or others or " where " not in problem.message:
            continue
        tried += 1
        again = refusal_of(with_value(document, place, match[1].strip('"')), folder)
        same = [p.message for p in again if p.key == problem.key]
        assert not any(re.search(r"where an? |must be [a-z ]+ [-\d]", m) for m in same), (
            problem,
            same,
        )
    assert tried > 8


def test_a_long_sentence_or_one_out_of_order_is_found() -> None:
    """The measure itself: twenty words pass, with numbers and quoted names as one each."""
    fault = "must be " + " ".join(["more"] * 13)
    good = Problem(file="a b.toml", key="belt.width", message=fault, value='"5 mm"', remedy="Go.")
    assert word_count(good) == MOST_WORDS
    assert faults_of(good) == []
    named = Problem(key="k", message='must be "x y z" at 12.5 kN/m', remedy='Write "a b".')
    assert word_count(named) == 8
    assert faults_of(Problem(message=f"{fault} and more things than that are too many for it"))
    assert "one fault" in faults_of(Problem(message="is wrong. It is"))
    assert "value once" in faults_of(Problem(message="is 150 kN now", value="150 kN"))
    assert "one fix" in faults_of(Problem(message="is wrong", remedy="Do this. Do that."))


# ---- files ----


@pytest.mark.parametrize(
    ("command", "suffix"),
    [(name, "toml") for name in ("solve", "study", "choose", "fit", "calibrate", "run", "check")]
    + [("read", "csv"), ("profile", "csv"), ("import", "csv")],
)
def test_what_is_no_readable_file_is_told_of_the_file(
    command: str, suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("folder").mkdir()
    Path(f"empty.{suffix}").write_text("\n")
    Path(f"binary.{suffix}").write_bytes(bytes(range(256)) * 4)
    said = {name: wraparc(command, name) for name in (f"nofile.{suffix}", "folder")}
    assert said[f"nofile.{suffix}"].err == f"Error: nofile.{suffix}: file not found.\n"
    assert said["folder"].err == "Error: folder: is a folder. Name a file in it.\n"
    for name, fault in (("empty", "is empty."), ("binary", "is ")):
        ran = wraparc(command, f"{name}.{suffix}")
        assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
        assert re.match(rf"Error: {name}\.{suffix}(, line \d+)?: {fault}", ran.err)
        assert len(ran.err.split()) <= MOST_WORDS + 1


def test_a_file_that_may_not_be_read_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = drive_file(tmp_path)

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("builtins.open", refuse)
    with pytest.raises(InputError) as caught:
        load_drive(path)
    assert str(caught.value) == f"{path}: cannot be read: Permission denied. Check the path."


# ---- one cause, one problem ----


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('name = "head"', 'nam = "head"', 'pulley[1].nam: unknown key. Did you mean "name"?'),
        (
            'exit_tension = "60 kN"',
            'exit_tention = "60 kN"',
            'pulley.head.exit_tention: unknown key. Did you mean "exit_tension" or '
            '"entry_tension" or "effective_tension"?',
        ),
        ('width = "1200 mm"', 'widht = "1200 mm"', 'belt.widht: unknown key. Did you mean "width"'),
    ],
)
def test_a_misspelt_key_is_not_told_as_missing_too(old: str, new: str, sentence: str) -> None:
    assert old in DRIVE
    (problem,) = refusal_of(tomllib.loads(DRIVE.replace(old, new, 1)), "")
    assert str(problem).startswith(sentence)


def test_a_value_that_cannot_be_read_is_not_told_as_contradicting_too() -> None:
    document = tomllib.loads(DRIVE)
    document["load_case"] = [
        {
            "name": "start",
            "pulley": {"head": {"exit_tension": "3 kn", "effective_tension": "10 kN"}},
        }
    ]
    (problem,) = refusal_of(document, "")
    assert str(problem).startswith('load_case.start.pulley.head.exit_tension: unknown unit "kn"')
    problems = refusal_of({**document, "pulley": True}, "")
    assert [p.key for p in problems] == ["pulley", "load_case.start.pulley.head.exit_tension"]


# ---- doors ----


@pytest.fixture(scope="module")
def local() -> Iterator[TestClient]:
    with client() as found:
        yield found


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("150 kN", "1,5 kN"),
        ("1200 mm", "1200 kN"),
        ('"diamond-rubber"', '"diamond-ruber"'),
        ('width = "1200 mm"', ""),
        ("180 deg", "9000 deg"),
        ("60 kN", "-60 kN"),
    ],
)
def test_every_door_tells_a_refusal_in_the_same_words(
    old: str, new: str, local: TestClient, tmp_path: Path
) -> None:
    path = drive_file(tmp_path, DRIVE.replace(old, new))
    with pytest.raises(InputError) as caught:
        load_drive(path)
    assert len(caught.value.problems) == 1
    sentence = str(caught.value)
    ran = wraparc("solve", path)
    assert (ran.code, ran.err) == (2, f"Error: {sentence}\n")
    body: dict[str, Any] = {"document": tomllib.loads(path.read_text("utf-8"))}
    answer = local.post(f"{API}/solve", json=body)
    assert answer.status_code == 422
    (problem,) = answer.json()["problems"]
    assert f"{path}: {problem['sentence']}" == sentence
