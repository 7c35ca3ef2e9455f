"""Long work: studies followed, cancelled and equal to the command line; shear tests in memory."""

import asyncio
import io
import json
import tomllib
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import xlsxwriter
from starlette.testclient import TestClient

from cli.running import wraparc
from web.calculators import API, PATIENCE, Process, client, wait_for
from wraparc.errors import InputError, Problem
from wraparc.web.errors import ApiError
from wraparc.web.jobs import MOST_WAITING, Jobs
from wraparc.web.progress import Tell
from wraparc.web.sessions import (
    LIFE,
    MOST_FILE,
    MOST_FILES,
    MOST_IN_ALL,
    MOST_SESSIONS,
    Sessions,
    shown_name,
)

STUDIES = Path(__file__).parents[2] / "examples" / "studies"


def study(name: str) -> dict[str, Any]:
    return tomllib.loads((STUDIES / f"{name}.toml").read_text("utf-8"))


@pytest.mark.processes
def test_a_study_has_the_numbers_of_the_command_line(server: Process, tmp_path: Path) -> None:
    body = {"study": study("wet-dry"), "document": study("head-drive")}
    body["study"]["sampling"]["samples"] = 64
    job = server.ask(f"{API}/studies", body)
    assert job.status == 202, job.body
    path = f"{API}/studies/{job.json()['id']}"
    wait_for(lambda: server.ask(path).json()["state"] == "done")
    found = server.ask(path).json()
    assert found["done"] == found["total"]
    code, out, error = wraparc(
        "study", STUDIES / "wet-dry.toml", "--set", "sampling.samples=64", "--json", "-",
        "-o", tmp_path / "out.parquet",
    )  # fmt: skip
    assert code == 0, error
    expected = json.loads(out)
    assert numbers(found["summary"]["groups"]) == pytest.approx(
        numbers(expected["groups"]), rel=1e-6
    )
    assert found["tables"]
    picture = server.ask(f"{path}/pictures/{found['pictures'][0]}")
    assert picture.headers["content-type"] == "image/svg+xml"
    assert b"<svg" in picture.body
    assert server.ask(f"{path}/files/results.parquet").body.startswith(b"PAR1")
    href = server.ask(f"{path}/files/results.parquet/link", {}).json()["href"]
    with urllib.request.urlopen(f"http://127.0.0.1:{server.port}{href}") as answer:
        assert answer.read().startswith(b"PAR1")
    assert server.ask(href).status == 404  # it was used
    assert server.ask(f"{path}/files/passwd/link", {}).status == 404
    assert server.ask(f"{path}/files/passwd").status == 404
    assert server.ask(f"{path}/pictures/passwd").status == 404
    assert server.ask(path, method="DELETE").status == 204
    assert server.ask(path).status == 404


@pytest.mark.processes
def test_a_study_is_cancelled_and_others_are_served_meanwhile(
    server: Process, folder: Path
) -> None:
    body = {"study": study("sensitivity"), "document": study("head-drive")}
    body["study"]["sampling"]["samples"] = 65536  # minutes of work
    job = server.ask(f"{API}/studies", body).json()
    path = f"{API}/studies/{job['id']}"
    wait_for(lambda: server.ask(path).json()["message"] == "solving")
    assert list(folder.glob("wraparc-task-*"))
    fast = server.ask(f"{API}/solve/fast", {"document": study("head-drive")})
    assert fast.status == 200
    assert server.ask(f"{path}/pictures/x.svg").status == 409
    assert server.ask(path, method="DELETE").status == 204
    assert server.ask(path).json()["state"] == "cancelled"
    wait_for(lambda: not list(folder.glob("wraparc-task-*")))
    assert job["id"] in [j["id"] for j in server.ask(f"{API}/studies").json()["jobs"]]


def test_a_study_names_no_file_and_tells_what_is_wrong(server: Process) -> None:
    wrong = study("tolerances")
    wrong["set"] = ['pulley.head.lagging="/etc/passwd"']
    wrong["axis"][0]["field"] = "belt.preset"
    wrong["axis"][0] |= {"values": ["../x.toml", "C:\\x.toml"]}
    told = server.ask(f"{API}/studies", {"study": wrong, "document": study("head-drive")})
    assert told.status == 422
    paths = [p["path"] for p in told.json()["problems"]]
    assert paths == ["axis[1].values[1]", "axis[1].values[2]", "set[1]"]
    empty = server.ask(f"{API}/studies", {"study": {}, "document": study("head-drive")})
    assert {"axis"} <= {p["path"] for p in empty.json()["problems"]}


def numbers(data: Any) -> list[float]:
    """Return every number of plain data, in order."""
    if isinstance(data, dict):
        return [n for item in data.values() for n in numbers(item)]
    if isinstance(data, list):
        return [n for item in data for n in numbers(item)]
    return [float(data)] if isinstance(data, int | float) else []


class FakeWork:
    """Work that ends when it is told to."""

    def __init__(self, outcome: object = b"{}") -> None:
        self.go, self.outcome = asyncio.Event(), outcome

    async def __call__(self, tell: Tell) -> object:
        tell(1, 2, "working")
        await self.go.wait()
        if isinstance(self.outcome, Exception):
            raise self.outcome
        return self.outcome


@pytest.mark.processes
def test_jobs_wait_their_turn_and_end_in_every_way() -> None:
    async def scenario() -> None:
        now = [0.0]
        jobs = Jobs(clock=lambda: now[0])
        # a fault of the program is an end too: it left the job running for ever
        wrong = InputError(Problem(message="wrong"))
        outcomes = [b"1", wrong, RuntimeError("secret"), b"not reached"]
        works = [FakeWork(outcome) for outcome in outcomes]
        started = [jobs.start("me", str(i), 2, work) for i, work in enumerate(works)]
        await until(lambda: started[0].state == "running")
        assert (started[0].done, started[0].message) == (1, "working")
        assert [job.state for job in started[1:]] == ["queued"] * 3
        jobs.end(started[3].id)
        assert started[3].state == "cancelled"
        for work in works[:3]:
            work.go.set()
        await until(lambda: not any(job.busy for job in started))
        assert [job.state for job in started] == ["done", "failed", "failed", "cancelled"]
        assert started[0].result == b"1"
        assert started[1].problems[0].message == "wrong"
        assert "RuntimeError" in started[2].problems[0].message
        assert "secret" not in started[2].problems[0].message
        now[0] = 1e6  # much later
        assert jobs.listed() == []

    asyncio.run(scenario())


def test_a_running_job_is_cancelled_and_the_next_one_runs() -> None:
    async def scenario() -> None:
        jobs = Jobs()
        works = [FakeWork(), FakeWork()]
        first, second = [jobs.start("me", "", 1, work) for work in works]
        await until(lambda: first.state == "running")
        jobs.end(first.id)
        await until(lambda: second.state == "running")
        assert first.state == "cancelled"
        jobs.stop()

    asyncio.run(scenario())


@pytest.mark.processes
def test_too_many_jobs_are_refused() -> None:
    async def scenario() -> None:
        jobs = Jobs()
        for _ in range(MOST_WAITING + 1):
            jobs.start("me", "", 1, FakeWork())
        with pytest.raises(ApiError) as raised:
            jobs.start("me", "", 1, FakeWork())
        assert raised.value.status_code == 429
        assert int((raised.value.headers or {})["retry-after"]) > 0
        jobs.stop()

    asyncio.run(scenario())


async def until(condition: Callable[[], bool]) -> None:
    """Wait until something holds."""
    async with asyncio.timeout(PATIENCE):
        while not condition():
            await asyncio.sleep(0)


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


def test_virtual_tests_are_read_fitted_and_used_at_once(api: TestClient) -> None:
    place = f"{API}/tests/{api.post(f'{API}/tests').json()['session']}"
    files = api.post(f"{place}/example").json()["files"]
    assert all(file["read"] for file in files)
    assert [file["pressure"] for file in files][:2] == ["34 kPa", "69 kPa"]
    lagging = {"name": "mine", "thickness": "12 mm", "shear_modulus": "2.3 MPa"}
    asked = {"lagging": lagging, "rig": {"sample_area": "0.04 m2"}}
    found = api.post(f"{place}/fit", json=asked)
    assert found.status_code == 200, found.text
    fitted = found.json()
    assert len(fitted["conditions"][0]["curves"]) == len(files)
    # the files are virtual tests of the catalogue's rubber: its law comes back
    drive = study("head-drive")
    truth = api.post(f"{API}/solve/fast", json={"document": drive}).json()["numbers"]
    drive["lagging"] = {"mine": fitted["lagging"]}
    drive["pulley"][0]["lagging"] = "mine"
    own = api.post(f"{API}/solve/fast", json={"document": drive}).json()["numbers"]
    assert own["exit_creep"] == pytest.approx(truth["exit_creep"], rel=0.05)
    assert api.post(f"{API}/lagging/read", json={"toml": fitted["toml"]}).json()["name"] == "mine"
    assert "illustrative" in fitted["toml"]
    wrong = api.post(f"{place}/fit", json={"lagging": {}, "rig": {}})
    assert {p["path"] for p in wrong.json()["problems"]} >= {"lagging.name", "rig.sample_area"}
    assert api.delete(place).status_code == 204
    assert api.get(place).status_code == 404


def test_files_are_described_and_taken_away(api: TestClient) -> None:
    place = f"{API}/tests/{api.post(f'{API}/tests').json()['session']}"
    rows = "".join(f"{0.05 * i:.2f};{min(3000, 90 * i)}\n" for i in range(200))
    named = ("../../etc/a 207kPa.csv", ("way;load\n" + rows).encode(), "text/csv")
    sent = api.post(f"{place}/files", files=[("files", named), ("files", ("b", b"\0\1", "x/y"))])
    first, second = sent.json()["files"]
    assert (first["name"], first["pressure_guess"]) == ("a 207kPa.csv", "207 kPa")
    assert not first["read"]
    assert not second["read"]
    assert second["problems"]
    choices: dict[str, Any] = {"travel": "way", "force": "load"}
    said = {"pressure": "207 kPa", "choices": choices}
    told = api.put(f"{place}/files/{first['id']}", json=said).json()
    assert "unit" in told["problems"][0]["message"]
    # A field for the unit of each column, though the file is not understood yet.
    assert [(c["name"], c["unit"]) for c in told["columns"]] == [("way", ""), ("load", "")]
    choices |= {"units": {"way": "mm", "load": "N"}}
    told = api.put(f"{place}/files/{first['id']}", json=said).json()
    assert told["read"], told["problems"]
    assert told["preview"]["force"][-1] == 3000.0
    wrong = api.put(f"{place}/files/{first['id']}", json={"pressure": "207"}).json()
    assert wrong["problems"][0]["path"].endswith("pressure")
    assert api.delete(f"{place}/files/{second['id']}").status_code == 204
    assert [f["id"] for f in api.get(place).json()["files"]] == [first["id"]]
    assert api.delete(f"{place}/files/9").status_code == 404
    assert api.post(f"{API}/tests/none/files", files=[("files", named)]).status_code == 404
    many = [("files", ("c", b"1", "x/y"))] * (MOST_FILES + 1)
    assert api.post(f"{place}/files", files=many).status_code in (413, 422)


def test_tests_side_by_side_and_files_beyond_a_test(api: TestClient) -> None:
    """What a file may need at most holds here as in the command line, and is told the same way."""
    place = f"{API}/tests/{api.post(f'{API}/tests').json()['session']}"
    rows = "".join(f"{0.05 * i:.2f};{9 * i};{0.05 * i:.2f};{8 * i}\n" for i in range(100))
    beside = ("two.csv", ("Weg;Kraft;Weg;Kraft\nmm;N;mm;N\n" + rows).encode(), "text/csv")
    wide = ("wide.csv", b"1," * 5000, "text/csv")
    out = io.BytesIO()
    with xlsxwriter.Workbook(out) as book:
        book.add_worksheet().write("XFD1048576", 1.0)
    far = ("far.xlsx", out.getvalue(), "application/x")
    sent = api.post(f"{place}/files", files=[("files", file) for file in (beside, wide, far)])
    first, second, third = sent.json()["files"]
    assert "contains 2 tests side by side" in first["problems"][0]["message"]
    assert "has 5001 cells, more than 1000" in second["problems"][0]["message"]
    assert "more than 4 million cells" in third["problems"][0]["message"]
    said = {"choices": {"block": 2, "stroke": "last"}}
    told = api.put(f"{place}/files/{first['id']}", json=said).json()
    assert told["preview"]["force"][-1] == 8.0 * 99
    assert "test 2 of 2 in its table" in told["place"]
    wrong = api.put(f"{place}/files/{first['id']}", json={"choices": {"stroke": "middle"}}).json()
    assert "stroke" in wrong["problems"][0]["path"]


def test_sessions_are_limited_and_end() -> None:
    now = [0.0]
    sessions = Sessions(clock=lambda: now[0])
    mine = sessions.create()
    with pytest.raises(ApiError, match="413"):
        sessions.add(mine, "big", b"x" * (MOST_FILE + 1))
    for _ in range(3):
        sessions.add(mine, "file", b"x" * MOST_FILE)
    with pytest.raises(ApiError, match="413"):
        sessions.add(mine, "one more", b"x")
    now[0] = LIFE - 1
    assert sessions.get(mine.id) is mine
    now[0] += LIFE + 1
    with pytest.raises(ApiError, match="404"):
        sessions.get(mine.id)


def test_nobody_is_shut_out_by_the_sessions_of_others() -> None:
    now = [0.0]
    sessions = Sessions(clock=lambda: now[0])
    mine = sessions.create()
    sessions.add(mine, "mine", b"x")
    for _ in range(2 * MOST_SESSIONS):  # opened one after the other and left
        now[0] += 0.1
        sessions.create()
    assert sessions.get(mine.id).uploads
    now[0] += 0.1
    for _ in range(4):  # the memory is full of the files of others
        now[0] += 0.1
        other = sessions.create()
        for _ in range(3):
            sessions.add(other, "big", b"x" * MOST_FILE)
    assert sessions.add(sessions.create(), "next", b"x" * MOST_FILE).id
    held = sum(session.size for session in sessions._sessions.values())
    assert held <= MOST_IN_ALL


def test_uploads_never_touch_the_disk(api: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a file was made on the disk")

    monkeypatch.setattr("tempfile.TemporaryFile", refuse)
    place = f"{API}/tests/{api.post(f'{API}/tests').json()['session']}"
    content = b"1;2\n" * 1_000_000
    sent = api.post(f"{place}/files", files=[("files", ("a.csv", content, "text/csv"))])
    assert sent.status_code == 200
    assert sent.json()["files"][0]["bytes"] == len(content)


def test_names_of_uploads_are_only_words() -> None:
    assert shown_name("C:\\tests\\a.csv") == "a.csv"
    assert shown_name("/etc/passwd") == "passwd"
    assert shown_name("\x1b[31m\n") == "[31m"
    assert shown_name(None) == shown_name("") == "file"
    assert len(shown_name("x" * 999)) == 120
