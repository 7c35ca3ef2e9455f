"""Studies over an event: each row is what `wraparc run` of that design gives."""

import csv
from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import InputError, load_motion, simulate
from wraparc.checks import judge_run
from wraparc.study.event_study import event_study_from_document, load_event_study

DRIVE = Path(__file__).parents[2] / "examples" / "tandem-fabric.toml"
SHORT = "motion.event.start.duration=1 s"
DROOP = 'motion.drum.{}.control={{kind="droop", torque_limit=3}}'


def study(**more: object) -> dict[str, object]:
    settings = [SHORT, DROOP.format("first"), DROOP.format("second")]
    axis = [{"field": "motion.event.start.happens[1].time", "values": ["0.5 s", "10 s"]}]
    kept: dict[str, object] = {
        "format": 1, "drive": str(DRIVE), "event": "start", "points": 20, "set": settings,
        "axis": axis,
    }  # fmt: skip
    return kept | more


def test_a_row_is_the_run_of_its_design_and_a_refused_one_says_why(tmp_path: Path) -> None:
    file, table = tmp_path / "study.toml", tmp_path / "rows.csv"
    made = study()
    lines = [f"{key} = {made[key]!r}" for key in ("format", "drive", "event", "points", "set")]
    lines += ["[[axis]]", 'field = "motion.event.start.happens[1].time"']
    file.write_text("\n".join([*lines, 'values = ["0.5 s", "10 s"]']), "utf-8")
    done = wraparc("study", file, "-o", table)
    assert done.code == 0, done.err
    assert "2 designs" in done.out
    rows = list(csv.DictReader(table.read_text("utf-8").splitlines()))
    # a start in half a second is beyond the motors
    assert rows[0]["worst check"] == "REFUSED"
    assert "the torque limits of the motors give" in rows[0]["said"]
    assert rows[0]["peak creep [m]"] == ""
    # independent: the run itself
    overrides = [*map(str, made["set"]), "motion.event.start.happens[1].time=10 s"]  # type: ignore[call-overload]
    motion = load_motion(DRIVE, overrides=overrides)
    run = simulate(motion.station, motion.event("start"), points=20)
    assert float(rows[1]["peak creep [m]"]) == pytest.approx(run.peak_creep.value, rel=1e-6)
    assert float(rows[1]["peak tension [N]"]) == pytest.approx(run.peak_tension.value, rel=1e-6)
    assert rows[1]["worst check"] == str(judge_run(run).level)
    assert float(rows[1]["pulsates at [Hz]"]) == 0.0


@pytest.mark.parametrize(
    ("more", "sentence"),
    [
        ({"event": "strat"}, 'Did you mean "start"'),
        ({"axis": [{"field": "a.b", "from": "1 s", "to": "2 m", "count": 2}]}, "another unit"),
        ({"axis": [{"field": "a.b", "from": "1 s", "to": "2 s"}]}, "needs from, to and count"),
        ({"axis": [{"field": "a.b"}]}, "needs values, or from, to and count"),
        ({"axis": [{"field": "a.b", "from": "x", "to": "2 s", "count": 2}]}, "axis"),
        ({"axis": [{"field": "a", "values": ["1"] * 21}, {"field": "b", "values": ["1"] * 20}]},
         "420 designs, more than 400"),
        ({"outputs": ["creep"]}, "unknown key"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told(more: dict[str, object], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        event_study_from_document(study(**more))


def test_the_shipped_study_counts_its_values_evenly() -> None:
    shipped = load_event_study(DRIVE.parent / "studies" / "start-ramp.toml")
    assert shipped.values == (("10 s", "20 s", "30 s"), ("1 %", "3 %"))
    assert shipped.designs[1] == ("10 s", "3 %")


def test_options_of_other_studies_are_refused(tmp_path: Path) -> None:
    file = DRIVE.parent / "studies" / "start-ramp.toml"
    assert "--resume: is not for a study over an event" in wraparc("study", file, "--resume").err
    assert "6 designs, each followed through start" in wraparc("study", file, "--dry-run").out
