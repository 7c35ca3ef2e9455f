"""How long a question may take: every one is asked with the bound that docs/server.md says.

Nothing is solved: in place of a process stands what notes the bound. The expected numbers are those
of the page, 90 s, 10 minutes, 5 for a fit, 4 hours.
"""

import pickle
from collections.abc import Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

from web.calculators import ADDRESS, API, document, wait_for
from wraparc.web import work
from wraparc.web.app import create_app
from wraparc.web.errors import refused
from wraparc.web.processes import answer
from wraparc.web.settings import Settings
from wraparc.web.work import Workers

SHORT, LONG, FIT, JOB, READ = 90.0, 600.0, 300.0, 4 * 3600.0, 60.0
#: Functions that are done, since the next question needs what they find.
_DONE = ("events.check", "studies.check", "shear_tests.read_files", "shear_tests.virtual_files")
#: Bound of what is done by a task of its own, after its request was answered.
_LATER = {"/studies": "studies.run", "/events": "events.run"}
STUDY = {
    "format": 1,
    "axis": [{"field": "belt.width", "values": ["1200 mm", "1300 mm"]}],
}
SHELL = {"across": {"shell_profile": {"crown": "1 mm"}}}


class _Nobody:
    """A process that does nothing."""

    alive, ended, stepped_back = True, False, False

    def end(self) -> None:
        """End nothing."""


@pytest.fixture
def bound(monkeypatch: pytest.MonkeyPatch) -> dict[str, float | None]:
    """By function, the bound that it was last asked with [s]."""
    found: dict[str, float | None] = {}

    async def started(*_: object, **__: object) -> _Nobody:
        return _Nobody()

    async def asked(_: object, __: object, question: bytes, limit: Any, ___: object = None) -> Any:
        function, given = pickle.loads(question)  # noqa: S301 - of the server under test
        if function is work._alone:
            function, given = given[1], given[2:]
        name = f"{function.__module__.rpartition('.')[2]}.{function.__name__}"
        found[name] = limit
        if name in _DONE:
            return answer(function, *given)
        raise refused(503, "not now")

    monkeypatch.setattr(Workers, "_started", started)
    monkeypatch.setattr(Workers, "_asked", asked)
    return found


@pytest.fixture
def api(bound: dict[str, float | None]) -> Iterator[TestClient]:
    app = create_app(Settings(workers=1))
    with TestClient(app, base_url=ADDRESS, raise_server_exceptions=False) as found:
        wait_for(lambda: bound)  # the drive to begin with
        bound.clear()
        yield found


_MEASURED = {"parameters": ["friction"], "files": [{"name": "a.csv", "data": "eA=="}]}
QUESTIONS: list[tuple[str, dict[str, Any], float]] = [
    ("/solve/fast", {}, SHORT),
    ("/solve", {}, SHORT),
    ("/solve/action", {}, SHORT),
    ("/solve/reserve", {}, SHORT),
    ("/check", {}, SHORT),
    ("/toml/write", {}, SHORT),
    ("/compare", {}, SHORT),
    ("/seek", {"field": "belt.width", "result": "exit_creep", "value": "5 mm"}, SHORT),
    ("/what-if", {}, SHORT),
    ("/field", {}, SHORT),
    ("/measured", _MEASURED, LONG),
    ("/choose", {"thicknesses": ["10 mm"]}, LONG),
    ("/train", {}, SHORT),
    ("/train", {"match": True}, LONG),
    ("/across", SHELL, SHORT),
    ("/across/wear", SHELL, LONG),
    ("/across/thickness", {"thicknesses": ["8 mm", "12 mm"], **SHELL}, SHORT),
    ("/report/pdf", {}, SHORT),
    ("/results/csv", {}, SHORT),
    ("/studies/toml", {"study": STUDY}, SHORT),
    ("/studies", {"study": STUDY}, JOB),
    ("/events", {"what": "run"}, JOB),
]


@pytest.mark.parametrize(
    ("path", "more", "most"), QUESTIONS, ids=[f"{p}{'+' * ('match' in m)}" for p, m, _ in QUESTIONS]
)
def test_a_question_ends_after_its_time(
    api: TestClient, bound: dict[str, float | None], path: str, more: dict[str, Any], most: float
) -> None:
    tandem = path in ("/train", "/events")
    asked = {"document": document("tandem-fabric" if tandem else "head-drive-fabric"), **more}
    if across := asked.pop("across", None):
        asked["document"]["pulley"][0]["across"] = across
    status = api.post(API + path, json=asked).status_code
    if path in _LATER:
        assert status == 202
        wait_for(lambda: _LATER[path] in bound)
    else:
        assert status == 503, bound
    (name,) = set(bound) - {*_DONE}
    assert bound[name] == most
    assert all(limit in (SHORT, LONG) for done, limit in bound.items() if done in _DONE)


def test_files_of_tests_and_their_fit_end_after_their_time(
    api: TestClient, bound: dict[str, float | None]
) -> None:
    session = api.post(f"{API}/tests").json()["session"]
    assert api.post(f"{API}/tests/{session}/example").status_code == 200
    fit = {"lagging": {"name": "a"}, "rig": {}}
    assert api.post(f"{API}/tests/{session}/fit", json=fit).status_code == 503
    assert bound["shear_tests.read_files"] == READ
    assert bound["shear_tests.fit"] == FIT


def test_every_question_that_a_server_answers_by_solving_is_among_them() -> None:
    app = create_app(Settings(workers=0))
    here = {path for path, _, _ in QUESTIONS} | {"/report/{kind}", "/results/{kind}"}
    plain = {"/toml/read", "/lagging/read", "/quantities", "/across/profile"}  # nothing is solved
    plain |= {"/studies/{study}/files/{name}/link"}
    paths = app.openapi()["paths"]
    posts = {path.removeprefix(API) for path, methods in paths.items() if "post" in methods}
    others = {path for path in posts if not path.startswith(("/designs", "/tests", "/logs"))}
    assert others - plain <= here, others - plain - here
