"""The sentence that a page shows first of an answer has fifteen words at most, in both systems.

Expected of the page: it tells the place apart, ends at the first stop or semicolon, and where that
is long at the first colon. The sentences are those of drives that fail in every way of `rows`, of
their events, and of drives and trains at random.
"""

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from checks.test_least_tension import random_drives
from checks.test_of_trains import random_trains
from cli.running import wraparc
from judgement.rows import ROWS, Row
from worded import worded
from wraparc import load_drive, load_train, solve, solve_train
from wraparc.arc import DriveResult
from wraparc.checks import judge
from wraparc.train import TrainResult

pytestmark = pytest.mark.usefixtures("solved_once")

MOST = 15
#: A place, which the page tells beside the sentence; a stop, behind a word, not behind a letter
#: that stands for a name.
_PLACE = re.compile(r"((pulley [^:,]+, )?(event|load case) [^:]+|pulley [^:,]+): ", re.I)
_STOP = re.compile(r"(?:(?<=[a-z0-9)%°])|(?<=kN))\. (?=[A-Z])")


def first(headline: str) -> str:
    """Return what the page shows first of a headline."""
    one = _STOP.split(headline[found.end() :] if (found := _PLACE.match(headline)) else headline)[0]
    return re.split(r"[;:] " if len(one.split()) > MOST else "; ", one)[0]


def headlines(result: DriveResult | TrainResult) -> Iterator[str]:
    """Yield what is said first of every pulley in every load case, and of each of these whole."""
    verdict, cases = judge(result), dict[str, set[str]]()
    for arc in result.drive_result() if isinstance(result, TrainResult) else result:
        cases.setdefault(arc.arc.load_case, set()).add(arc.arc.pulley)
    for case, pulleys in cases.items():
        for of in (verdict.within(case), *(verdict.at(pulley, case) for pulley in pulleys)):
            yield of.headline("si")
            yield of.headline("us")


def long(said: Iterator[str]) -> list[str]:
    """Return first sentences that are too long, or say nothing."""
    found = [first(headline) for headline in said]
    assert found
    return [text for text in found if not 3 <= len(text.split()) <= MOST]


@pytest.mark.parametrize("row", ROWS, ids=[row.name for row in ROWS])
def test_of_drives_that_fail_in_one_way(row: Row, tmp_path: Path) -> None:
    path = tmp_path / "drive.toml"
    path.write_text(row.text, "utf-8")
    if row.text.count("[[pulley]]") > 1 and "[train]" in row.text:
        result = solve_train(load_train(str(path)), raise_on_failure=False)
        assert long(headlines(result)) == []
    else:
        assert long(headlines(solve(load_drive(str(path)), raise_on_failure=False))) == []
    if "run" in row.doors:
        answer = wraparc("run", str(path), "--quiet", "--points", "20", "--json", "-")[1]
        told = json.loads(answer)["answer"]["verdict"]["text"]
        assert long(worded(told, system) for system in ("si", "us")) == []


@pytest.mark.parametrize("start", range(0, 300, 60))
def test_of_random_drives(start: int) -> None:
    for of in random_drives(300)[start : start + 60]:
        assert long(headlines(solve(of, raise_on_failure=False))) == []


@pytest.mark.parametrize("start", range(0, 60, 30))
def test_of_random_trains(start: int) -> None:
    for of in [*random_trains(60)][start : start + 30]:
        assert long(headlines(solve_train(of, raise_on_failure=False))) == []
