"""Answer, action and reserve of a drive are of one result, which is solved once.

Expected: counted calls of the solver; what any other text, value or load case is asked for with is
solved anew; and each answer is that of a process that has solved nothing before, byte for byte.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from web.calculators import document
from wraparc.arc import Distributed
from wraparc.train import TrainResult
from wraparc.train.file import load_drive_or_train
from wraparc.train.whole import solved
from wraparc.web.answers import solved as room
from wraparc.web.answers.drives import nearest_changes, propose_action, solve_all
from wraparc.web.asked import ActionRequest, SolveRequest

EXAMPLES = Path(__file__).parents[2] / "examples"
QUESTIONS: tuple[tuple[Callable[[Any], Any], Callable[..., Any]], ...] = (
    (solve_all, SolveRequest),
    (propose_action, ActionRequest),
    (nearest_changes, ActionRequest),
)


@pytest.fixture(autouse=True)
def nothing_is_kept() -> Iterator[None]:
    room._kept.clear()
    yield
    room._kept.clear()


@pytest.fixture
def methods(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The methods of all drives and trains that are solved."""
    found: list[str] = []
    solve, solve_train = vars(room)["solve"], vars(room)["solve_train"]

    def solve_one(drive: Any, **how: Any) -> Any:
        found.append(how["method"].name)
        return solve(drive, **how)

    def solve_several(train: Any, **how: Any) -> Any:
        found.append("train")
        return solve_train(train, **how)

    monkeypatch.setattr(room, "solve", solve_one)
    monkeypatch.setattr(room, "solve_train", solve_several)
    return found


def ask(given: dict[str, Any], **more: Any) -> list[str]:
    """Return what each question about a drive is answered with."""
    return [
        function(request(document=given, **more)).model_dump_json()
        for function, request in QUESTIONS
    ]


@pytest.mark.parametrize(
    ("name", "once"),
    [
        ("head-drive-fabric", ["distributed", "paper"]),
        ("tandem-fabric", ["train", "paper"]),
    ],
)
def test_three_questions_solve_once(name: str, once: list[str], methods: list[str]) -> None:
    first = ask(document(name))
    assert sorted(methods) == sorted(once)
    assert ask(document(name)) == first
    assert sorted(methods) == sorted(once)
    room._kept.clear()
    assert ask(document(name)) == first


def test_another_text_is_another_drive(methods: list[str]) -> None:
    """Of titles, descriptions and conveyors no comparison of drives knows."""
    given = document("uphill-conveyor")
    solve_all(SolveRequest(document=given))
    for key in ("title", "description"):
        other = {**given, key: "Another"}
        assert getattr(solve_all(SolveRequest(document=other)), key) == "Another"
    heavier = {**given, "conveyor": {**given["conveyor"], "counterweight": "9 t"}}
    least = [solve_all(SolveRequest(document=d)).least_tension for d in (given, heavier)]
    assert least[0] is not None
    assert least[1] is not None
    assert least[0].given != least[1].given
    assert methods.count("distributed") == 4


def test_load_case_and_points_are_asked_for_again(methods: list[str]) -> None:
    given = document()
    solve_all(SolveRequest(document=given))
    one = solve_all(SolveRequest(document=given, load_case="start"))
    few = solve_all(SolveRequest(document=given, points=20))
    assert {arc.load_case for arc in one.arcs} == {"start"}
    assert len(few.arcs[0].profile.position) < len(one.arcs[0].profile.position)
    assert methods.count("distributed") == 3


def test_some_results_are_kept_and_no_more(methods: list[str]) -> None:
    given = document()
    for k in range(room._MOST_KEPT + 1):
        propose_action(ActionRequest(document={**given, "title": f"Drive {k}"}))
    assert len(room._kept) == room._MOST_KEPT
    solved_before = len(methods)
    propose_action(ActionRequest(document={**given, "title": "Drive 1"}))
    assert len(methods) == solved_before
    propose_action(ActionRequest(document={**given, "title": "Drive 0"}))
    assert len(methods) == solved_before + 1
    propose_action(ActionRequest(document={**given, "title": "Drive 1"}))  # asked for last but one
    assert len(methods) == solved_before + 1


def test_a_train_has_its_pulleys_once() -> None:
    """What is judged of them and their least tension is remembered by the result."""
    train = solved(load_drive_or_train(EXAMPLES / "tandem-fabric.toml"), Distributed())
    assert isinstance(train, TrainResult)
    assert train.drive_result() is train.drive_result()
