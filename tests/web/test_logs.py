"""Logs of a plant on the server and on the page: dropped, learned from, cancelled, refused.

Expected are the answers of the command of the same files, and the faults that were put in.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect
from starlette.testclient import TestClient

from cli.running import wraparc
from learn.plant import DRIVE, GEAR, RATED_TORQUE, Made, readings, written
from web.browser import Visitor
from web.calculators import API, client, wait_for
from worded import worded
from wraparc.schema.overrides import read_document
from wraparc.web.answers.documents import json_like

PULLEY = {
    "name": "head", "speed_is": "encoder", "gear_ratio": GEAR,
    "rated_torque": f"{RATED_TORQUE:g} N m",
}  # fmt: skip


@pytest.fixture(scope="module")
def logged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A log of four days, 30 s a row."""
    folder = tmp_path_factory.mktemp("log")
    written(folder, readings(Made(days=4.0)))
    return folder


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


@pytest.fixture(scope="module")
def drive() -> dict[str, Any]:
    document: dict[str, Any] = json_like(read_document(str(DRIVE)))
    return document


def dropped(api: TestClient, *files: Path) -> str:
    """Return a session with some logs."""
    session: str = api.post(f"{API}/logs").json()["session"]
    sent = [("files", (file.name, file.read_bytes())) for file in files]
    answer = api.post(f"{API}/logs/{session}/files", files=sent)
    assert [file["name"] for file in answer.json()["files"]] == [file.name for file in files]
    return session


def ended(api: TestClient, session: str, asked: dict[str, Any]) -> dict[str, Any]:
    """Return how learning ended."""
    answer = api.post(f"{API}/logs/{session}/learn", json=asked)
    assert answer.status_code == 202, answer.text
    job = f"{API}/logs/jobs/{answer.json()['id']}"
    wait_for(lambda: api.get(job).json()["state"] not in ("queued", "running"))
    found: dict[str, Any] = api.get(job).json()
    return found


def test_the_answer_is_that_of_the_command(
    api: TestClient, logged: Path, drive: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(logged)
    ran = wraparc("learn", "learn.toml", "-o", "learned.toml")
    assert ran.code == 0, ran.err
    session = dropped(api, logged / "trend.csv")
    settings = {"title": "Overland CV-07", "pulley": [PULLEY], "belt_speed": {"at": "tail"}}
    found = ended(api, session, {"document": drive, "learn": settings})
    assert found["state"] == "done", found
    verdict = found["verdict"]
    text = worded(verdict["text"])
    assert f"{verdict['level']} {text}" in ran.words
    assert found["pictures"] == ["levels, head.svg", "course, head.svg"]
    job = f"{API}/logs/jobs/{found['id']}"
    for name in found["pictures"]:
        picture = api.get(f"{job}/pictures/{name}")
        assert picture.status_code == 200
        assert picture.text.lstrip().startswith("<?xml")
    assert [f["title"] for f in found["findings"]][:1] == ["Friction of its law"]
    # the learned drive is that of the command: levels and friction alike
    assert "[learned]" in found["toml"]
    mine = Path(logged, "page.toml")
    mine.write_text(found["toml"], "utf-8")
    ours, theirs = (read_document(str(p))["learned"] for p in (mine, logged / "learned.toml"))
    assert ours == theirs
    assert api.delete(job).status_code == 204
    assert api.get(job).status_code == 404


def test_what_is_missing_is_asked_for_by_its_key(
    api: TestClient, logged: Path, drive: dict[str, Any]
) -> None:
    session = dropped(api, logged / "trend.csv")
    found = ended(api, session, {"document": drive, "learn": {"pulley": [{"name": "head"}]}})
    assert found["state"] == "failed"
    said = [problem["sentence"] for problem in found["problems"]]
    assert any(
        s.startswith("logs: pulley.head.gear_ratio: missing. Write gear_ratio = ?") for s in said
    ), said
    assert all(len(s.split()) <= 20 for s in said), said


def test_what_is_no_log_is_named_without_its_folder(
    api: TestClient, tmp_path: Path, drive: dict[str, Any]
) -> None:
    (tmp_path / "notes.csv").write_text("a,b\n1,2\n", "utf-8")
    session = dropped(api, tmp_path / "notes.csv")
    found = ended(api, session, {"document": drive, "learn": {"pulley": [PULLEY]}})
    assert found["state"] == "failed"
    (problem,) = found["problems"]
    assert problem["sentence"].startswith("notes.csv: ")


def test_without_a_log_nothing_is_learned(api: TestClient, drive: dict[str, Any]) -> None:
    session = api.post(f"{API}/logs").json()["session"]
    answer = api.post(f"{API}/logs/{session}/learn", json={"document": drive})
    assert answer.status_code == 422
    assert "Drop the logs of the drive first." in answer.text


def test_on_the_page_a_log_is_dropped_learned_and_refused(visitor: Visitor, logged: Path) -> None:
    visitor.open()
    visitor.anew(lambda: visitor.load(Path(DRIVE)))
    page = visitor.open("logs")
    page.set_input_files("#log-files", logged / "trend.csv")
    expect(page.locator("#logs-verdict")).to_contain_text("1 log ready.")
    page.get_by_role("button", name="Learn from the logs").click()
    # what the log does not say is asked for
    expect(page.locator("#logs-verdict")).to_contain_text(
        "pulley.head.gear_ratio: missing", timeout=120_000
    )
    page.get_by_label("Gear ratio").fill(f"{GEAR:g}")
    page.get_by_label("Rated torque").fill(f"{RATED_TORQUE:g} N m")
    page.get_by_label("Motor speed by").select_option("encoder")
    # cancelled, it may begin again
    page.get_by_role("button", name="Learn from the logs").click()
    page.get_by_role("button", name="Cancel").click()
    expect(page.locator("#logs-verdict")).to_contain_text("1 log ready.")
    page.get_by_role("button", name="Learn from the logs").click()
    page.get_by_role("button", name="Save the learned drive").wait_for(timeout=120_000)
    assert page.locator("#logs .curves img").count() == 2
    expect(page.locator("#logs [aria-label=Findings]")).to_contain_text("Friction reserve")
    # findings stand as far from the edge as their head, pictures are no wider than their card
    edge, text = (
        page.locator(f"#logs [aria-label=Findings] {which}").first.evaluate(
            "e => e.getBoundingClientRect().left + parseFloat(getComputedStyle(e).paddingLeft)"
        )
        for which in ("h2", ".facts p")
    )
    assert text == edge
    page.set_viewport_size({"width": 390, "height": 844})
    card = page.locator("#logs .hero").bounding_box()
    picture = page.locator("#logs .curves img").first.bounding_box()
    assert card is not None
    assert picture is not None
    assert picture["x"] + picture["width"] <= card["x"] + card["width"]
    page.get_by_label("Gear ratio").fill("21")
    expect(page.locator("#logs-verdict")).to_contain_text("Inputs changed.")
