"""Drives in time through the API: started, followed, cancelled, thinned, and what is refused."""

import json
from collections.abc import Iterator
from threading import Event
from typing import Any

import numpy as np
import pytest
from starlette.testclient import TestClient

from cli.running import wraparc
from web.calculators import API, PATIENCE, client, document, wait_for
from worded import worded
from wraparc import load_motion, simulate
from wraparc.web.answers.events import played

FABRIC = "examples/tandem-fabric.toml"


@pytest.fixture(scope="module")
def api() -> Iterator[TestClient]:
    with client() as found:
        yield found


def short(name: str = "tandem-fabric", duration: str = "3 s") -> dict[str, Any]:
    """Return a shipped tandem whose events are short."""
    found = document(name)
    for event in found["motion"]["event"]:
        event["duration"] = duration
    return found


def asked(api: TestClient, **body: Any) -> Any:
    """Return the answer of a run, or the problems with it."""
    begun = api.post(f"{API}/events", json=body)
    if begun.status_code != 202:
        assert begun.status_code == 422, begun.text
        return begun.json()
    where = f"{API}/events/{begun.json()['id']}"
    assert begun.headers["location"] == where
    wait_for(lambda: api.get(where).json()["state"] not in ("queued", "running"))
    return api.get(where).json()


def test_a_run_has_the_words_and_numbers_of_the_command_line(api: TestClient) -> None:
    answer = asked(api, document=short(), event="start", points=20)
    assert answer["state"] == "done"
    # expected: what `wraparc run` and `wraparc stability` print
    settings = ("--set", "motion.event.start.duration=3 s", "--points", "20", "--quiet")
    told = (
        wraparc("run", FABRIC, *settings, "--full").out + wraparc("stability", FABRIC, "--full").out
    )
    told = " ".join(told.split())
    for part in ("run", "stability"):
        verdict = answer[part]["verdict"]
        for sentence in (verdict["text"], *verdict["sentences"]):
            assert worded(sentence) in told
    assert len(json.dumps(answer["played"])) < 400_000


def test_what_is_played_keeps_the_largest_values() -> None:
    motion = load_motion(FABRIC, overrides=["motion.event.splice.duration=4 s"])
    run = simulate(motion.station, motion.event("splice"), points=20, step=0.003)
    thin = played(run)
    assert len(run.time) > 1000 > 2 * len(thin.time)
    for drum, shown in zip(run.drums, thin.drums, strict=True):
        for name in ("exit_creep", "exit_tension", "torque", "peak_shear"):
            column = getattr(drum, name)
            kept = np.array(getattr(shown, name), float)
            assert np.max(kept) == pytest.approx(np.max(column), rel=1e-4)
            assert np.min(kept) == pytest.approx(np.min(column), rel=1e-4)
    assert (thin.time[0], thin.time[-1]) == pytest.approx((0.0, run.time[-1]))
    # the travel is the area under the speed, taken before anything is thinned
    area = np.trapezoid(run.belt_speed, run.time)
    assert thin.travel[-1] == pytest.approx(area, rel=1e-5)
    assert np.array(shown.creep, float).shape == (len(thin.frame_time), 31)
    assert shown.shear[-1][0] == pytest.approx(drum.shear[-1, 0], rel=2e-3)


def test_without_events_the_usual_ones_are_there_and_it_is_said(api: TestClient) -> None:
    bare = short()
    del bare["motion"]["event"]
    answer = asked(api, document=bare, event="no such")
    assert '"start", "start and stop"' in answer["detail"]
    answer = asked(api, document=bare, what="stability", run_out="1 mm")
    assert answer["note"].startswith("The file has no events")
    assert answer["played"] is None
    where = f"{API}/events/{answer['id']}/pictures"
    picture = api.get(f"{where}/{answer['pictures'][0]}")
    assert picture.headers["content-type"] == "image/svg+xml"
    assert b"</svg>" in picture.content
    assert api.get(f"{where}/no.svg").status_code == 404


@pytest.mark.parametrize(
    ("path", "value", "sentence"),
    [
        ("drum.first.inertia", None, "motion.drum.first.inertia: missing. Write"),
        ("drum", None, "motion.drum: missing"),
        ("", None, "motion.drum.first.inertia: missing. Write [motion.drum.first]"),
        ("drum.first.control", {"kind": "speed-loop"}, "motion.drum.first.control.bandwidth: mis"),
        ("conveyor_mass", None, "motion.conveyor_mass: missing: starts and stops need it"),
        ("take_up", "fixd", 'Did you mean "fixed"?'),
        ("event.0.happens.0.file", "/etc/passwd", "happens[1].file: unknown key"),
    ],
)
def test_what_is_wrong_is_told_at_its_field(
    api: TestClient, path: str, value: Any, sentence: str
) -> None:
    wrong: Any = {"motion": short()["motion"]}
    keys = ["motion", *filter(None, path.split("."))]
    place: Any = wrong
    for key in keys[:-1]:
        place = place[int(key)] if key.isdigit() else place[key]
    place[keys[-1]] = value
    answer = asked(api, document={**short(), **wrong}, event="start")
    assert sentence in answer["detail"]


def test_contradictory_boundaries_are_told(api: TestClient) -> None:
    wrong = short()
    del wrong["motion"]["conveyor_mass"]
    wrong["motion"]["take_up"] = "winch"
    answer = asked(api, document=wrong, event="splice")
    assert (
        'motion.take_up: needs conveyor_mass, got "winch". Give conveyor_mass' in answer["detail"]
    )


def test_a_coarse_step_is_refused_with_the_one_needed(api: TestClient) -> None:
    answer = asked(api, document=short(), event="run-out", step="0.2 s")
    assert answer["state"] == "failed"
    assert "Take 0.052 s or less." in answer["problems"][0]["sentence"]
    assert "must be more than 0" in asked(api, document=short(), step="0 s")["detail"]


def test_a_belt_that_goes_slack_on_the_way_is_an_answer_kept_up_to_there(api: TestClient) -> None:
    hard = short()
    back = {"kind": "load-step", "at": "0.5 s", "factor": -2.0, "time": "0.5 s"}
    hard["motion"]["event"] = [{"name": "runs away", "duration": "3 s", "happens": [back]}]
    answer = asked(api, document=hard, points=20)
    assert answer["state"] == "done"
    assert answer["played"]["outcome"] == "slack"
    assert 0.5 < answer["played"]["time"][-1] < 3.0
    verdict = answer["run"]["verdict"]
    assert verdict["level"] == "FAILS"
    assert "Belt goes slack before first at 1.3" in worded(verdict["text"])


def test_a_run_is_cancelled_and_forgotten(api: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    let_go = Event()

    def held(*_: Any, **__: Any) -> None:  # a run that lasts until it is let go
        let_go.wait(PATIENCE)

    monkeypatch.setattr("wraparc.web.answers.events.simulate", held)
    begun = api.post(f"{API}/events", json={"document": short(), "points": 10}).json()
    where = f"{API}/events/{begun['id']}"
    try:
        assert api.delete(where).status_code == 204
        assert api.get(where).json()["state"] == "cancelled"
        assert api.get(f"{where}/pictures/map.svg").status_code == 409
        assert api.delete(where).status_code == 204
        assert "there is no such run" in api.get(where).text
    finally:
        let_go.set()
