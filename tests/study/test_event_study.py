"""Studies over an event: each row is what `wraparc run` of that design gives."""

import csv
import errno
import json
import math
from pathlib import Path

import pyarrow.parquet
import pytest

from cli.running import wraparc
from wraparc import InputError, load_motion, simulate
from wraparc.answer.event_study_sheet import event_study_sheet
from wraparc.checks import Level, judge_run
from wraparc.saving import alone, to_disk, unwritable
from wraparc.study import event_rows
from wraparc.study.event_rows import run_event_study
from wraparc.study.event_study import EventRow, event_study_from_document, load_event_study
from wraparc.units.cell import in_units

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
    file, table, data = (tmp_path / name for name in ("study.toml", "rows.csv", "rows.json"))
    picture = tmp_path / "rows.svg"
    made = study()
    lines = [f"{key} = {made[key]!r}" for key in ("format", "drive", "event", "points", "set")]
    lines += ["[[axis]]", 'field = "motion.event.start.happens[1].time"']
    file.write_text("\n".join([*lines, 'values = ["0.5 s", "10 s"]']), "utf-8")
    done = wraparc("study", file, "-o", table, "--json", data, "--plot", picture)
    assert done.code == 0, done.err
    assert "2 designs" in done.out
    assert not table.with_name("rows.csv.part").exists()
    rows = list(csv.DictReader(table.read_text("utf-8").splitlines()))
    # a start in half a second is beyond the motors
    assert rows[0]["worst check"] == "REFUSED"
    assert "the start needs 1308 kN, the motors give 314.8 kN." in rows[0]["text"]
    assert rows[0]["peak creep [m]"] == ""
    # independent: the run itself
    overrides = [*map(str, made["set"]), "motion.event.start.happens[1].time=10 s"]  # type: ignore[call-overload]
    motion = load_motion(DRIVE, overrides=overrides)
    run = simulate(motion.station, motion.event("start"), points=20)
    assert float(rows[1]["peak creep [m]"]) == pytest.approx(run.peak_creep.value, rel=1e-6)
    assert float(rows[1]["peak tension [N]"]) == pytest.approx(run.peak_tension.value, rel=1e-6)
    assert rows[1]["worst check"] == str(judge_run(run).level)
    assert rows[1]["verdict"] == judge_run(run).label
    assert float(rows[1]["oscillates at [Hz]"]) == 0.0
    worst = judge_run(run).governing
    assert worst is not None
    used = float(rows[1]["limit used [-]"] or math.nan)
    assert used == pytest.approx(worst.used, rel=1e-6, nan_ok=True)
    assert rows[1]["governing check"] == in_units(judge_run(run).closest)
    # the other doors tell the same
    assert judge_run(run).level is Level.ATTENTION
    assert "ATTENTION 1 needs attention, 1 refused of 2 designs." in " ".join(done.out.split())
    refused, followed = json.loads(data.read_text("utf-8"))["designs"]
    assert (refused["label"], refused["peak_creep"]) == ("refused", None)
    assert followed["peak_creep"] == float(rows[1]["peak creep [m]"])
    drawn = picture.read_text("utf-8")
    assert judge_run(run).label in drawn
    assert "1 refused: not drawn" in drawn


def test_an_interrupted_study_goes_on_to_the_same_rows(tmp_path: Path) -> None:
    field = "motion.event.start.happens[1].time"
    asked = event_study_from_document(
        study(axis=[{"field": field, "values": ["0.5 s", "9 s", "10 s"]}], points=10)
    )
    cut, whole = tmp_path / "cut.csv", tmp_path / "whole.parquet"

    def breaks(done: int, total: int) -> None:
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_event_study(asked, cut, progress=breaks)
    part = tmp_path / "cut.csv.part"
    assert not cut.exists()
    with pytest.raises(InputError, match="an interrupted run has left rows"):
        run_event_study(asked, cut)
    kept = part.read_bytes()
    part.write_bytes(kept + b'{"values": ["10 s"], "peak')  # killed while it wrote
    begun: list[int] = []
    rows = run_event_study(asked, cut, resume=True, progress=lambda done, total: begun.append(done))
    assert begun == [2, 3]  # what is there is not followed again
    assert not part.exists()
    # independent: all at once
    at_once = run_event_study(asked, whole)
    assert repr(rows) == repr(at_once)
    table = pyarrow.parquet.read_table(whole).to_pylist()
    assert [row[field] for row in table] == ["0.5 s", "9 s", "10 s"]
    assert table[2]["peak tension [N]"] == at_once[2].peak_tension
    lines = list(csv.DictReader(cut.read_text("utf-8").splitlines()))
    assert [float(line["peak creep [m]"] or "nan") for line in lines[1:]] == [
        row.peak_creep for row in at_once[1:]
    ]
    # rows of another study are not taken for its own
    part.write_bytes(kept)
    other = event_study_from_document(study(axis=[{"field": field, "values": ["0.5 s"]}]))
    with pytest.raises(InputError, match="of another study"):
        run_event_study(other, cut, resume=True)


def test_a_full_disk_keeps_the_designs_that_were_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # both designs are refused at once: what is kept matters here
    axis = {"field": "motion.event.start.happens[1].time", "values": ["0.4 s", "0.5 s"]}
    asked = event_study_from_document(study(axis=[axis]))
    path, part = tmp_path / "a.csv", tmp_path / "a.csv.part"
    disk, asked_for = to_disk, iter([1, 2, 3])
    monkeypatch.setattr(
        event_rows, "to_disk", lambda file: full(file) if next(asked_for) == 2 else disk(file)
    )
    monkeypatch.setattr(event_rows, "save_file", unwritten)
    for count, place in ((1, part), (2, path)):  # at last there is no room for the whole file
        with pytest.raises(InputError) as caught:
            run_event_study(asked, path, resume=count > 1)
        assert str(caught.value) == (
            f"{place}: cannot be written: No space left on device; {count} of 2 designs are "
            f"saved in {part}. Make room and go on with --resume."
        )
        assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv.part"]
    monkeypatch.undo()
    rows = run_event_study(asked, path, resume=True)
    run_event_study(asked, tmp_path / "whole.csv")
    assert path.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert [row.values for row in rows] == [("0.4 s",), ("0.5 s",)]


def full(_: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


def unwritten(path: Path, _: object) -> None:
    try:
        full(path)
    except OSError as error:
        raise InputError(unwritable(path, error)) from None


def test_two_runs_do_not_write_the_same_rows(tmp_path: Path) -> None:
    asked = event_study_from_document(study())
    with alone(tmp_path / "a.csv"), pytest.raises(InputError, match="another run is writing"):
        run_event_study(asked, tmp_path / "a.csv")


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


def test_designs_that_all_pass_say_which_is_closest_to_a_limit() -> None:
    rows = [
        EventRow((text,), used=used, closest=f"peak creep {text} of 6.35 mm (head)", level="OK")
        for text, used in (("3.00", 0.47), ("6.00", 0.94), ("4.00", math.nan))
    ]
    made = event_study_from_document(study())
    verdict = event_study_sheet(made, rows).verdict
    assert verdict is not None
    assert verdict.text == "All 3 designs pass. Closest: peak creep 6.00 of 6.35 mm (head)."


def test_options_of_other_studies_are_refused(tmp_path: Path) -> None:
    file = DRIVE.parent / "studies" / "start-ramp.toml"
    assert "--part: not for a study over an event" in wraparc("study", file, "--part", "5").err
    assert "6 designs, each followed through start" in wraparc("study", file, "--dry-run").out
