"""The safety that Python, rows and studies give, against the check of `solve`.

Expected: the value of the check "Safety against gross slip" of one drive, and the closed form
exp(mu phi) of constant friction under a lagging that does not shear.
"""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from checks.test_least_tension import random_drives
from checks.test_rows import quiet, rigid
from study.studies import FOLDER, TAKE_UP, study_of
from wraparc import Drive, Tensions, load_drive, load_lagging, solve
from wraparc.batch import Setting, solve_arcs, solve_batch
from wraparc.checks import judge
from wraparc.drive import Criteria, TakeUp
from wraparc.errors import InputError
from wraparc.files.write import drive_document
from wraparc.study.run import run_study
from wraparc.study.source import DriveSource

OLD, NEW = "gross_slip_margin", "gross_slip_safety"
DRIVES = random_drives(12, seed=11)
#: Mu phi = 1.0996: T2 held it slides at 3.003 T2; T1 + T2 held at (3.003 - 1)/(3.003 + 1) of both.
MU_PHI = 0.35 * math.pi


def value_of_check(of: Drive) -> float:
    """Return the safety that the check states."""
    result = solve(of, raise_on_failure=False)
    (check,) = (c for c in judge(result).checks if c.name == "gross_slip")
    assert check.value is not None
    return check.value


def held(kind: str) -> Drive:
    return quiet(
        entry=45e3, leaving=20e3, lagging=rigid(0.35), criteria=Criteria(take_up=TakeUp(kind=kind))
    )


@pytest.mark.parametrize(
    ("kind", "pull"),
    [
        ("gravity", 20e3 * math.expm1(MU_PHI)),
        ("fixed", 65e3 * math.expm1(MU_PHI) / (math.exp(MU_PHI) + 1.0)),
    ],
)
def test_the_take_up_decides_which_tension_is_held(kind: str, pull: float) -> None:
    (arc,) = solve(held(kind), raise_on_failure=False)
    assert arc.gross_slip_safety == pytest.approx(pull / 25e3, rel=1e-6)


@pytest.mark.parametrize("number", range(len(DRIVES)))
def test_python_and_rows_have_the_value_of_the_check(number: int) -> None:
    of = DRIVES[number]
    expected = value_of_check(of)
    (arc,) = solve(of, raise_on_failure=False)
    assert arc.gross_slip_safety == pytest.approx(expected, rel=1e-12)
    assert arc.scalars()[NEW] == arc.gross_slip_safety
    rows = DriveSource(drive_document(of), "head", ()).rows({}, 1, of.load_cases[0].name)
    row = solve_arcs(rows.arcs, setting=Setting.PRECISE, capacities=False)
    row = row.growing(rows.held.tight_rise, rows.held.slack_rise)
    assert row[NEW][0] == pytest.approx(expected, rel=1e-5)


def test_a_study_has_the_value_of_the_check(tmp_path: Path) -> None:
    names = ["entry_tension", "exit_tension", NEW]
    study = study_of({**TAKE_UP, "count": 3}, outputs=names, load_cases="all").study
    run_study(study, tmp_path / "a.parquet")
    found = pq.read_table(tmp_path / "a.parquet").to_pylist()
    head = load_drive(Path(FOLDER) / "head-drive.toml")
    assert len(found) == 3 * len(head.load_cases)
    for row in found:
        case = head.load_case(row["load_case"])
        tensions = {"head": Tensions(entry=row["entry_tension"], exit=row["exit_tension"])}
        of = replace(head, load_cases=(replace(case, tensions=tensions),))
        assert row[NEW] == pytest.approx(value_of_check(of), rel=1e-4)


def test_the_old_name_is_refused_and_the_new_one_named() -> None:
    rows = solve_batch(
        {"entry_tension": 160e3, "exit_tension": 60e3, "diameter": 0.8, "wrap_angle": math.pi,
         "belt_width": 1.2, "belt_modulus": 10e6}, DRIVES[0].pulleys[0].lagging,
    )  # fmt: skip
    assert OLD not in rows
    with pytest.raises(KeyError, match=NEW):
        rows[OLD]
    with pytest.raises(InputError, match=f"no such result, .*Write {NEW}"):
        study_of(TAKE_UP, outputs=[OLD])


def test_a_belt_that_both_sides_pull_tight_slides_far_beyond_the_tested_pressures() -> None:
    """A brake before the take-up; at the place the slip of the arc is the tested 15 mm."""
    lagging = replace(load_lagging("full-ceramic"), compression_modulus=math.inf)
    table = {"entry_tension": 17.25e3, "exit_tension": 51.5e3, "diameter": 0.98, "wrap_angle": 3.65,
             "belt_width": 0.877, "belt_modulus": 112e6}  # fmt: skip
    row = solve_batch(table, lagging, setting=Setting.PRECISE)
    row = row.growing(np.array([136.4e3]), np.array([102.2e3]))
    place = float(row[NEW][0])
    assert place == pytest.approx(10.2, abs=0.2)
    far = table | {
        "entry_tension": 17.25e3 + (place - 1.0) * 102.2e3,
        "exit_tension": 51.5e3 + (place - 1.0) * 136.4e3,
    }
    assert abs(solve_batch(far, lagging, setting=Setting.PRECISE)["exit_slip"][0]) == pytest.approx(
        15e-3, rel=1e-4
    )


FALLING = """
format = 1
name = "falling"
thickness = "5.6 mm"
shear_modulus = "0.889 MPa"
compression_modulus = "7.52 MPa"
[law]
kind = "integral-log"
tested_slip = "18.5 mm"
[[law.knots]]
pressure = "21.5 kPa"
peak_friction = 0.6145
peak_slip = "7.805 mm"
post_peak_slope = "-0.0157 1/mm"
residual_friction = 0.3687
[[law.knots]]
pressure = "994 kPa"
peak_friction = 0.5949
peak_slip = "8.112 mm"
post_peak_slope = "-0.0147 1/mm"
residual_friction = 0.357
"""


def test_a_search_passes_pressures_at_which_a_falling_law_has_several_creeps(
    tmp_path: Path,
) -> None:
    """At the place the slip of the arc is the tested 18.5 mm; on the way it tries 10 MPa."""
    (tmp_path / "falling.toml").write_text(FALLING, "utf-8")
    lagging = load_lagging(tmp_path / "falling.toml")
    table = {"entry_tension": 21.16e3, "exit_tension": 30.18e3, "diameter": 1.1155,
             "wrap_angle": 3.952, "belt_width": 0.7176, "belt_modulus": 28.7e6}  # fmt: skip
    row = solve_batch(table, lagging, setting=Setting.PRECISE)
    row = row.growing(np.array([21.885e3]), np.array([12.865e3]))
    place = float(row[NEW][0])
    assert place == pytest.approx(53.4, abs=1.0)
    far = table | {
        "entry_tension": 21.16e3 + (place - 1.0) * 12.865e3,
        "exit_tension": 30.18e3 + (place - 1.0) * 21.885e3,
    }
    slip = abs(solve_batch(far, lagging, setting=Setting.PRECISE)["exit_slip"][0])
    assert slip == pytest.approx(18.5e-3, rel=1e-4)
