"""Real answers have the form that the OpenAPI document promises, nothing more and nothing less."""

import tomllib
from collections.abc import Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

from judgement.rows import BASE, MOTORS
from web.calculators import API, client, document
from wraparc.checks import judge
from wraparc.train.whole import solved
from wraparc.web.answers import catalogue, compare, drives, form, texts, trains
from wraparc.web.answers.documents import read
from wraparc.web.asked import SolveRequest
from wraparc.web.database import store
from wraparc.web.errors import PROBLEM_JSON, Problems
from wraparc.web.routes import pages, studies

pytestmark = pytest.mark.usefixtures("solved_once")


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


def idle() -> dict[str, Any]:
    drive = document()
    drive["pulley"][0]["exit_tension"] = "150 kN"
    return drive


def beyond() -> dict[str, Any]:
    drive = document()
    drive["pulley"][0]["exit_tension"] = "2 kN"
    return drive


ASKED: list[tuple[str, Any, dict[str, Any]]] = [
    ("/solve/fast", drives.FastAnswer, {"document": document(), "tables": True}),
    ("/solve/fast", drives.FastAnswer, {"document": idle(), "prepared": True}),
    ("/solve", drives.SolveAnswer, {"document": document()}),
    ("/solve", drives.SolveAnswer, {"document": beyond()}),
    ("/solve", drives.SolveAnswer, {"document": document("tandem-fabric"), "load_case": "empty"}),
    ("/train", trains.TrainAnswer, {"document": document("tandem-fabric")}),
    ("/check", drives.SheetAnswer, {"document": document("tandem-fabric")}),
    ("/toml/read", texts.ReadAnswer, {"toml": "format = 1"}),
    ("/toml/write", texts.WriteAnswer, {"document": {}}),
    ("/quantities", texts.QuantitiesAnswer, {"items": [{"text": "1 m", "dimension": "length"}]}),
    ("/quantities", texts.QuantitiesAnswer, {"items": [{"text": "?", "dimension": "length"}]}),
    ("/compare", compare.CompareAnswer, {"document": document(), "names": ["x", "full-ceramic"]}),
    ("/compare", compare.CompareAnswer, {"document": beyond(), "names": [], "what": "belts"}),
]


@pytest.mark.parametrize(("path", "model", "body"), ASKED)
def test_an_answer_has_its_form(
    api: TestClient, path: str, model: Any, body: dict[str, Any]
) -> None:
    answer = api.post(API + path, json=body)
    assert answer.status_code == 200, answer.text
    model.model_validate_json(answer.content)


def test_designs_about_and_refusals_have_their_form(api: TestClient) -> None:
    made = api.post(f"{API}/designs", json={"name": "a", "document": document()})
    store.VersionAnswer.model_validate_json(made.content)
    path = f"{API}/designs/{made.json()['id']}"
    store.DesignAnswer.model_validate_json(api.get(path).content)
    store.VersionAnswer.model_validate_json(api.get(f"{path}/versions/1").content)
    store.Designs.model_validate_json(api.get(f"{API}/designs").content)
    form.Form.model_validate_json(api.get(f"{API}/schema").content)
    catalogue.Catalogue.model_validate_json(api.get(f"{API}/catalogue").content)
    pages.About.model_validate_json(api.get(f"{API}/about").content)
    studies.JobsAnswer.model_validate_json(api.get(f"{API}/studies").content)
    for refusal in (
        api.get(f"{API}/designs/99"),
        api.post(f"{API}/solve", json={"document": {}}),
        api.post(f"{API}/solve", json={}),
        api.get("/none"),
        api.get("/", headers={"host": "evil.example"}),
    ):
        told = Problems.model_validate_json(refusal.content)
        assert refusal.headers["content-type"] == PROBLEM_JSON
        assert told.status == refusal.status_code
        assert told.detail == " ".join(problem.sentence for problem in told.problems)


def test_the_arc_of_the_check_that_governs_comes_off_worst() -> None:
    # expected: the place of the check that governs the verdict, by the order that the page has
    text = 'pulley.head.entry_tension = "132 kN"\npulley.head.exit_tension = "55 kN"'
    more = text.replace("132", "200").replace("55", "150")
    one = BASE.replace('1000/4"', '1000/4"\nlargest_wrap_pressure = "280 kPa"')
    one += f'[[load_case]]\nname = "creeps"\n{text}\n[[load_case]]\nname = "presses"\n{more}\n'
    for source in (one, MOTORS.replace('["800 mm"', '["786 mm"'), BASE):
        asked = SolveRequest(document=tomllib.loads(source), sequence=1)
        found = drives.solve_all(asked)
        judged = judge(solved(read(asked.document)))
        assert judged.governing is not None
        place = judged.governing.place
        worst = min(found.arcs, key=lambda arc: (-arc.level.rank, arc.order))
        assert place.load_case in ("", worst.load_case)
        assert place.pulley in ("", worst.pulley)
        if judged.governing.missed:
            assert worst.short == f"{judged.governing.level} {judged.governing.label}"
