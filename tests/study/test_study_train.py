"""Studies over several drives on one belt: the load divides anew in every row.

Expected values: the train of a row by `solve_train`, the worn one by `what_if`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from study.studies import EXAMPLES
from wraparc.arc import Distributed
from wraparc.checks import judge
from wraparc.checks.of_rows import LEVELS, NAMES
from wraparc.errors import InputError
from wraparc.study.file import StudyFile, study_from_document
from wraparc.study.monte_carlo import summarise
from wraparc.study.run import run_study
from wraparc.train import solve_train, what_if
from wraparc.train.file import load_train

QUICK = Distributed(capacities=False)
TANDEM = EXAMPLES / "tandem-fabric.toml"


def study_of(*axes: dict[str, Any], **more: Any) -> StudyFile:
    outputs = ["share", "speed_trim", "entry_tension", "exit_creep"]
    document = {"format": 1, "drive": TANDEM.name, "pulley": "second", "outputs": outputs}
    return study_from_document({**document, "axis": list(axes), **more}, folder=str(EXAMPLES))


def axis(key: str, *values: Any) -> dict[str, Any]:
    return {"field": key, "values": list(values)}


def test_wear_of_one_drum_shifts_the_load() -> None:
    wear = (axis("pulley.first.wear", "0 mm", "0.5 mm"), axis("pulley.second.wear", "0 mm", "1 mm"))
    study = study_of(*wear, setting="precise").study
    found = study.solve(0, 4)
    before = solve_train(load_train(TANDEM), method=QUICK)
    first = what_if(before, pulley="first", wear=0.5e-3)["second"]
    second = what_if(before, pulley="second", wear=1e-3)["second"]
    assert found["share"][0] == pytest.approx(0.5, abs=1e-6)
    for row, told in ((2, first), (1, second)):
        assert found["share"][row] == pytest.approx(told.share, rel=1e-7)
        assert found["entry_tension"][row] == pytest.approx(told.arc.entry_tension, rel=1e-7)
        assert found["exit_creep"][row] == pytest.approx(told.arc.exit_creep, rel=1e-6)


def test_tensions_and_belt_are_those_of_the_file_written_so() -> None:
    """Load cases of the file, with the values put over it."""
    asked = study_of(
        axis("train.exit_tension", "40 kN", "50 kN"), axis("belt.modulus", "12 MN/m"),
        axis("pulley.first.share", 0.4), load_cases="all",
    )  # fmt: skip
    assert "The load of the train divides anew" in asked.remarks[0]
    found = asked.study.solve(0, 2)
    for i, tension in enumerate(("40 kN", "50 kN")):
        over = {"train.exit_tension": tension, "belt.modulus": "12 MN/m",
                "train.share": [0.4, 0.6]}  # fmt: skip
        told = solve_train(load_train(TANDEM, overrides=over), method=QUICK)
        for k, case in enumerate(told.cases):
            drum = case["second"]
            assert found["entry_tension"][2 * i + k] == pytest.approx(drum.arc.entry_tension)
            assert found["speed_trim"][2 * i + k] == pytest.approx(drum.speed_trim, abs=1e-7)
            assert found["exit_creep"][2 * i + k] == pytest.approx(drum.arc.exit_creep, rel=1e-4)


def test_a_shear_modulus_is_that_of_the_rubber_as_in_the_file() -> None:
    """Both drums are lagged with blocks on 85 % of the area."""
    key = "pulley.second.lagging.shear_modulus"
    found = study_of(axis(key, "1.5 MPa", "3 MPa"), setting="precise").study.solve(0, 2)
    for i, modulus in enumerate(("1.5 MPa", "3 MPa")):
        solved = solve_train(load_train(TANDEM, overrides={key: modulus}), method=QUICK)
        told = solved.cases[0]["second"]
        assert found["exit_creep"][i] == pytest.approx(told.arc.exit_creep, rel=1e-6)
        assert found["speed_trim"][i] == pytest.approx(told.speed_trim, abs=1e-8)


def test_a_train_that_finds_no_balance_breaks_away(tmp_path: Path) -> None:
    trims = axis("pulley.second.speed_trim", "99.5 %", "99.6 %")
    weak = {"field": "pulley.first.lagging.friction_factor", "distribution": "uniform",
            "from": 0.01, "to": 0.02}  # fmt: skip
    both = axis("pulley.second.lagging.friction_factor", 0.02, 1.0)
    study = study_of(trims, weak, both, sampling={"samples": 4, "seed": 1}).study
    found = study.solve(0, len(study.plan))
    gone = found["pulley.second.lagging.friction_factor"] == 0.02
    assert np.array_equal(found["status"] == 1, gone)
    assert {LEVELS[k] for k in found["verdict"][gone]} == {"FAILS"}
    assert {NAMES[k] for k in found["governing"][gone]} == {"gross_slip"}
    assert np.isnan(found["exit_creep"][gone]).all()
    assert np.array_equal(np.isnan(found["share"]), gone)  # there are no tensions to tell it from
    assert not found["within_creep_limit"][gone].any()
    run_study(study, tmp_path / "a.parquet")
    told = {g.levels["pulley.second.lagging.friction_factor"]: g.breakaway.value
            for g in summarise(tmp_path / "a.parquet").groups}  # fmt: skip
    assert told == {0.02: 1.0, 1.0: 0.0}


def test_no_cut_changes_a_row() -> None:
    wear = {"field": "pulley.second.wear", "distribution": "uniform", "from": "0 mm", "to": "14 mm"}
    study = study_of(wear, sampling={"samples": 40, "seed": 3}).study
    whole, part = study.solve(0, 40), study.solve(17, 23)
    for name, column in part.items():
        assert column.tobytes() == whole[name][17:23].tobytes(), name
    thickness = load_train(TANDEM).pulleys[1].lagging.thickness
    assert np.array_equal(whole["status"] == 4, whole["pulley.second.wear"] > thickness)


def test_a_drive_alone_wears_too() -> None:
    """Diameter and lagging of the pulley follow: both written into the file."""
    document = {
        "format": 1, "drive": "head-drive.toml", "outputs": ["exit_creep"],
        "set": ["pulley.head.lagging.compression_modulus=9 MPa"],  # as it is, whatever is left
    }  # fmt: skip
    folder = str(EXAMPLES / "studies")
    worn = study_from_document({**document, "axis": [axis("pulley.head.wear", "0 mm", "2 mm")]},
                               folder=folder)  # fmt: skip
    drive = worn.drive.pulley("head")
    size, left = drive.diameter - 4e-3, drive.lagging.thickness - 2e-3
    written = study_from_document(
        {**document, "axis": [axis("pulley.head.diameter", f"{size!r} m"),
                              axis("pulley.head.lagging.thickness", f"{left!r} m")]},
        folder=folder,
    )  # fmt: skip
    one, other = worn.study.solve(1, 2), written.study.solve(0, 1)
    assert one["exit_creep"][0] == pytest.approx(other["exit_creep"][0], rel=1e-9)


@pytest.mark.parametrize(
    ("axes", "sentence"),
    [
        ([axis("pulley.second.share", 0.4, 0.5), axis("pulley.second.speed_trim", 1.0)],
         "decides how the load divides, as the speeds do"),
        ([axis("pulley.second.wear", "0 mm", "1 mm"),
          axis("pulley.first.lagging", "diamond-rubber", "full-ceramic")],
         "does not go with fields outside belt, pulleys and [train]"),
        ([axis("pulley.second.wear", "-1 mm", "1 mm")], "must be between 0 mm and 1000 mm"),
        ([axis("pulley.second.sharing", 0.4)],
         'Did you mean "share"'),
    ],
)  # fmt: skip
def test_faults_of_such_axes(axes: list[dict[str, Any]], sentence: str) -> None:
    with pytest.raises(InputError) as error:
        study_of(*axes)
    assert sentence in str(error.value)


def test_a_share_belongs_to_a_train() -> None:
    document = {"format": 1, "drive": "head-drive.toml",
                "axis": [axis("pulley.head.share", 0.4, 0.5)]}  # fmt: skip
    with pytest.raises(InputError, match="belongs to a train"):
        study_from_document(document, folder=str(EXAMPLES / "studies"))


@pytest.mark.parametrize(
    "way",
    ['share = ["50 %", "50 %"]', 'speeds = ["9 rad/s", "8.97 rad/s"]'],
    ids=["share", "speeds"],
)
def test_power_goes_by_the_speed_of_the_belt_at_the_pulley(tmp_path: Path, way: str) -> None:
    """Behind the first drum the belt is slower by its strain; drums may turn faster than 3 m/s."""
    drive = tmp_path / "drive.toml"
    drive.write_text(TANDEM.read_text("utf-8").replace('share = ["50 %", "50 %"]', way), "utf-8")
    outputs = ["power_loss", "sliding_power", "transmitted_power"]
    document = {"format": 1, "drive": "drive.toml", "pulley": "second", "outputs": outputs,
                "setting": "precise", "axis": [axis("train.exit_tension", "40 kN")]}  # fmt: skip
    found = study_from_document(document, folder=str(tmp_path)).study.solve(0, 1)
    whole = solve_train(load_train(drive, overrides={"train.exit_tension": "40 kN"}))
    told = whole.cases[0]["second"].arc.energy
    for column in outputs:
        assert found[column][0] == pytest.approx(getattr(told, column), rel=1e-5), column


@pytest.mark.parametrize("pulley", ["first", "second"])
def test_an_open_trim_is_that_of_the_drum_behind(tmp_path: Path, pulley: str) -> None:
    """As `judge` places it: a trim is of a drum against the first one."""
    drive = tmp_path / "drive.toml"
    text = TANDEM.read_text("utf-8").replace('"800 mm"', '"1200 mm"', 1)
    text = text.replace('preset = "Plylon Plus 1000/4"', 'modulus = "12 MN/m"\nkind = "fabric"')
    dusty = 'condition = { name = "dusty", friction_factor = 0.8 }'
    drive.write_text(f"covered = true\n{dusty}\n{text}", "utf-8")
    document = {"format": 1, "drive": "drive.toml", "pulley": pulley,
                "axis": [axis("belt.width", "1200 mm")]}  # fmt: skip
    found = study_from_document(document, folder=str(tmp_path)).study.solve(0, 1)
    verdict = judge(solve_train(load_train(drive))).at(pulley, "design")
    open_trim = "belt_thickness" in {c.name for c in verdict.checks if c.missed}
    assert open_trim is (pulley == "second")
    assert verdict.governing is not None
    assert NAMES[found["governing"][0]] == verdict.governing.name
    assert LEVELS[found["verdict"][0]] is verdict.level
