"""What to do about a verdict, by the interface: with the whole answer, or asked for by itself."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from wraparc.schema.overrides import put_over
from wraparc.train.keys import TRAIN_FILE

pytest.importorskip("fastapi")

from wraparc.web.answers.drives import propose_action, solve_all
from wraparc.web.asked import ActionRequest, SolveRequest

EXAMPLES = Path(__file__).parents[2] / "examples"


def document_of(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8"))


def plain(of: Any) -> Any:
    return of.model_dump(by_alias=True)


def test_first_way_put_over_the_document_passes_every_check() -> None:
    document = document_of("head-drive-fabric")
    action = propose_action(ActionRequest(document=document, sequence=3))
    assert action.sequence == 3
    assert action.action is not None
    way = action.action.ways[0]
    assert (way.proved, way.left) == (True, 0)
    settings = {
        change["key"]: f"{change['to']!r} {change['unit']}" if change["unit"] else change["to"]
        for change in way.changes
    }
    after = solve_all(SolveRequest(document=put_over(document, settings, TRAIN_FILE)))
    assert after.verdict.level == "OK"
    assert after.verdict.action is None


@pytest.mark.parametrize("name", ["head-drive-fabric", "triple-steel-cord"])
def test_whole_answer_has_the_same_action(name: str) -> None:
    document = document_of(name)
    alone = propose_action(ActionRequest(document=document)).action
    assert alone is not None
    whole = solve_all(SolveRequest(document=document)).verdict.action
    assert whole is not None
    assert plain(whole) == plain(alone)


def test_whole_answer_without_search_offers_no_ways() -> None:
    document = document_of("head-drive-fabric")
    action = solve_all(SolveRequest(document=document, search=False)).verdict.action
    assert action is None or action.ways == []


def test_nothing_is_proposed_where_every_check_passes() -> None:
    assert propose_action(ActionRequest(document=document_of("uphill-conveyor"))).action is None
