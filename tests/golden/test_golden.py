"""Every answer of every shipped example is what it was, through every door.

Expected: pinned, as recorded before the rooms were moved; regenerate with
``PYTHONPATH=tests python -m golden.record``, which refuses to change a number unless told to.
What a new feature adds to an answer is no failure; it is held from when it is recorded.

The last bits of exp and log, of fused multiplications and of linear algebra differ from machine to
machine. So that this never shows, every arc has its numbers moved in their last bits before they
are answered with: numbers agree within `ARC`, `TRAIN` and `FIT`, and of a number in a text at most
the last digit may turn.
"""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest

from answer.moving import moved
from golden.answers import DOORS, TRAINS
from golden.compare import Difference, Kind, differences
from golden.plain import plain
from golden.record import DATA, answers_of, golden
from once import solve, solved_once
from wording.texts import answer_texts
from wording.words import in_context
from wraparc.arc import ArcResult, Distributed, WrapArc

#: Largest relative differences, some ten times what one changed last bit of belt width or sample
#: area moved: 1e-11 on a pulley, 1e-8 where speeds of a train are found by iterating. Fits stop at
#: a tolerance of their own.
ARC, TRAIN, FIT = 1e-10, 1e-6, 1e-6
_FITS = ("cli-calibrate", "cli-fit", "web-shear-tests")
_SHOWN = 30


@pytest.fixture(scope="module", autouse=True)
def each_arc_is_solved_once() -> Iterator[None]:
    """Many doors ask for the same arcs and trains of the same examples: each has one answer."""

    @cache
    def solve_and_move(self: Distributed, arc: WrapArc) -> ArcResult:
        found: ArcResult = moved(solve(self, arc), np.random.default_rng(1))
        return found

    with solved_once(solve_and_move):
        yield


def tolerance(door: str, name: str) -> float:
    """Return the tolerance of an answer."""
    if door in _FITS or name.startswith(("fit ", "calibrate ")):
        return FIT
    return TRAIN if door == "web-trains" or any(train in name for train in TRAINS) else ARC


@pytest.fixture(scope="module", params=DOORS)
def answered(request: pytest.FixtureRequest) -> tuple[str, dict[str, Any]]:
    """Return a door and its answers: asked once, for the numbers and for the words."""
    return request.param, answers_of(request.param)


def test_no_answer_has_a_word_of_the_list(answered: tuple[str, dict[str, Any]]) -> None:
    door, answers = answered
    every = [hit for _, text in answer_texts(answers, door) for hit in in_context(text)]
    assert list(dict.fromkeys(every)) == []


def test_answers_are_what_they_were(answered: tuple[str, dict[str, Any]]) -> None:
    door, answers = answered
    old, new = golden(door), {name: plain(answer) for name, answer in answers.items()}
    found: list[Difference] = []
    for name in old.keys() | new.keys():
        one, other = ({name: side[name]} if name in side else {} for side in (old, new))
        found += differences(one, other, tolerance(door, name))
    found.sort(key=lambda d: (d.kind is Kind.ADDED, d.place))
    if any(d.kind is not Kind.ADDED for d in found):
        lines = "\n".join(f"  {door}: {difference}" for difference in found[:_SHOWN])
        more = f"\n  and {len(found) - _SHOWN} more" if len(found) > _SHOWN else ""
        again = f"PYTHONPATH=tests python -m golden.record {door}"
        pytest.fail(f"{len(found)} differences:\n{lines}{more}\nIf meant: {again}")


def test_every_door_has_its_golden_file() -> None:
    assert {file.stem for file in DATA.glob("*.json")} == set(DOORS)


@pytest.mark.parametrize(
    ("old", "new", "tolerance", "kinds"),
    [
        ({"a": 1.0}, {"a": 1.0000000000000002}, 0.0, ["number"]),
        ({"a": 1.0}, {"a": 1.0000000000000002}, 1e-12, []),
        ({"a": 1.0}, {"a": 1.00000000001}, 1e-12, ["number"]),
        ({"a": 0.0}, {"a": -0.0}, 0.0, ["number"]),
        ({"a": 1.0}, {"a": "inf"}, 1e-12, ["number"]),
        ({"a": 1.0}, {"a": None}, 1e-12, ["number"]),
        ({"a": True}, {"a": False}, 1e-12, ["number"]),
        ({"a": 1.0}, {"b": 1.0}, 0.0, ["missing", "added"]),
        ({"a": [1.0, 2.0]}, {"a": [1.0]}, 0.0, ["missing"]),
        ({"a": [1.0, 1e-9]}, {"a": [1.0, 1.0005e-9]}, 1e-12, []),  # of the largest of the row
        ({"a": ["1.20 mm"]}, {"a": ["3 %", "1.20 mm"]}, 0.0, ["added"]),
        ({"level": "OK"}, {"level": "FAILS"}, 1e-12, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.20 m"]}, 0.0, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.21 mm"]}, 1e-12, []),  # the last digit shown may turn
        ({"a": ["1.20 mm"]}, {"a": ["1.22 mm"]}, 1e-12, ["text"]),
        ({"a": ["1.20 mm"]}, {"a": ["1.21 mm"]}, 0.0, ["text"]),
    ],
)
def test_differences_are_seen(
    old: dict[str, object], new: dict[str, object], tolerance: float, kinds: list[str]
) -> None:
    assert [d.kind for d in differences(old, new, tolerance)] == kinds


def test_a_difference_says_where_it_is() -> None:
    old, new = {"head-drive": {"arcs": [{"slip": 1.0}]}}, {"head-drive": {"arcs": [{"slip": 2.0}]}}
    (found,) = differences(old, new)
    assert found.kind == Kind.NUMBER
    assert str(found) == "head-drive.arcs[0].slip: number was 1.0, is 2.0"
