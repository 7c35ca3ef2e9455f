"""The first sentence of an answer has fifteen words at most, its action twenty, in every door.

A number with its unit is one word. The sentences are those of drives that fail in every way of
`rows`, of their events, and of drives and trains at random.
"""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from checks.test_least_tension import random_drives
from checks.test_of_trains import random_trains
from cli.running import wraparc
from judgement.rows import ROWS, Row
from wraparc import load_drive, load_train, solve, solve_train
from wraparc.arc import DriveResult
from wraparc.checks import judge
from wraparc.train import TrainResult

pytestmark = pytest.mark.usefixtures("solved_once")

MOST, MOST_OF_ACTION = 15, 20
STEEL_CORD = Path(__file__).parents[2] / "examples" / "steel-cord-drive.toml"
#: A number with its unit, as texts hold it.
CELL = re.compile("\x02[^\x03]*\x03|\x04[^\x06]*\x06")


def word_count(text: str) -> int:
    """Return how many words a text has, a number with its unit as one."""
    return len(CELL.sub("1", text).split())


def with_slots(text: Any) -> str:
    """Return a text of an answer with one letter for every number and its unit."""
    told: str = text if isinstance(text, str) else text["text"]
    cells = [] if isinstance(text, str) else text.get("cells", [])
    for cell in reversed(cells):
        begin, end = cell["at"]
        told = f"{told[:begin]}1{told[end:]}"
    return told


def check_lengths(result: DriveResult | TrainResult) -> None:
    """Check what is said first of every pulley in every load case, and of each of these whole."""
    verdict, cases = judge(result), dict[str, set[str]]()
    for arc in result.drive_result() if isinstance(result, TrainResult) else result:
        cases.setdefault(arc.arc.load_case, set()).add(arc.arc.pulley)
    every = [verdict]
    for case, pulleys in cases.items():
        every += [verdict.within(case), *(verdict.at(pulley, case) for pulley in pulleys)]
    for of in every:
        assert 2 <= word_count(of.text) <= MOST, of.text
    said = [verdict.text, *(check.text for check in verdict.also)]
    assert len(set(said)) == len(said), said
    for check in verdict.missed:
        assert word_count(check.text) <= MOST, check.text
        assert word_count(check.action_text) <= MOST_OF_ACTION, check.action_text


@pytest.mark.parametrize("row", ROWS, ids=[row.name for row in ROWS])
def test_of_drives_that_fail_in_one_way(row: Row, tmp_path: Path) -> None:
    path = tmp_path / "drive.toml"
    path.write_text(row.text, "utf-8")
    if row.text.count("[[pulley]]") > 1 and "[train]" in row.text:
        check_lengths(solve_train(load_train(str(path)), raise_on_failure=False))
    else:
        check_lengths(solve(load_drive(str(path)), raise_on_failure=False))
    if "run" in row.doors:
        answer = wraparc("run", str(path), "--quiet", "--points", "20", "--json", "-")[1]
        told = json.loads(answer)["answer"]["verdict"]
        for said in (told["text"], *(also["text"] for also in told["also"])):
            assert word_count(with_slots(said)) <= MOST, said


def test_two_checks_missed_by_as_much_are_both_said() -> None:
    """The tension allowed in a start is 1.4 times the rating, and so is the safety factor."""
    overrides = ["pulley.head.power=600 kW", "load_case.start.pulley.head.power=2600 kW"]
    verdict = judge(solve(load_drive(STEEL_CORD, overrides=overrides), raise_on_failure=False))
    assert verdict.text.startswith("Belt tension")
    assert verdict.also[0].text.startswith("Belt safety factor")


@pytest.mark.parametrize("start", range(0, 300, 60))
def test_of_random_drives(start: int) -> None:
    for of in random_drives(300)[start : start + 60]:
        check_lengths(solve(of, raise_on_failure=False))


@pytest.mark.parametrize("start", range(0, 60, 30))
def test_of_random_trains(start: int) -> None:
    for of in [*random_trains(60)][start : start + 30]:
        check_lengths(solve_train(of, raise_on_failure=False))
