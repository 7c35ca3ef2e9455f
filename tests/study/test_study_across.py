"""Crown, wear, thickness and stiffness as axes of a study, the belt across its width as results."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from wraparc import load_drive, solve
from wraparc.across import solve_across
from wraparc.checks import judge
from wraparc.checks.of_rows import NOT_CHECKED
from wraparc.errors import InputError
from wraparc.study.file import load_study
from wraparc.study.parameter_study import GOVERNING, JUDGED, VERDICT

EXAMPLES = Path(__file__).parents[2] / "examples"
OUTPUTS = ["largest_running_tension", "entry_unevenness", "energy_unevenness", "levelling_depth"]
_SET = (
    "pulley.head.across.strips=6",
    "pulley.head.across.after=far",
    "pulley.head.across.build_up=[]",
)


def solved(folder: Path, axes: str, given: tuple[str, ...] = _SET) -> dict[str, Any]:
    path = folder / "study.toml"
    settings = ", ".join(f"'{text}'" for text in given)
    path.write_text(
        f'format = 1\ndrive = "{(EXAMPLES / "worn-head-drive-steel-cord.toml").as_posix()}"\n'
        f"set = [{settings}]\noutputs = {OUTPUTS}\n{axes}",
        "utf-8",
    )
    study = load_study(path).study
    return dict(study.solve(0, len(study.plan)))


def axis(field: str, values: str) -> str:
    return f'[[axis]]\nfield = "{field}"\nvalues = [{values}]\n'


def test_a_study_row_is_the_drive_solved_alone(tmp_path: Path) -> None:
    """Source: `solve_across` and `judge` of each design by itself."""
    found = solved(
        tmp_path,
        axis("pulley.head.across.shell_profile.crown", '"0 mm", "6 mm"')
        + axis("pulley.head.lagging.thickness", '"12 mm", "20 mm"')
        + axis("belt.in_plane_shear_stiffness", '"20 kN/m", "80 kN/m"'),
    )
    for k in (0, 3, 5):
        crown, thick, stiff = (
            found[name][k]
            for name in (
                "pulley.head.across.shell_profile.crown",
                "pulley.head.lagging.thickness",
                "belt.in_plane_shear_stiffness",
            )
        )
        drive = load_drive(
            EXAMPLES / "worn-head-drive-steel-cord.toml",
            overrides=[
                *_SET,
                f"pulley.head.across.shell_profile.crown={crown} m",
                f'pulley.head.lagging={{ preset = "full-ceramic", thickness = "{thick} m" }}',
                f"belt.in_plane_shear_stiffness={stiff} N/m",
            ],
        )
        alone = solve_across(drive)
        for name in OUTPUTS[:3]:
            assert found[name][k] == pytest.approx(getattr(alone, name), rel=1e-6)
        told = judge(solve(drive, raise_on_failure=False)).at("head", "design")
        assert JUDGED[VERDICT][found[VERDICT][k]] == str(told.level)
        if crown:  # without, creep and worst creep are the same number to six digits
            assert told.governing is not None
            assert JUDGED[GOVERNING][found[GOVERNING][k]] == told.governing.name
        assert found["levelling_depth"][k] == pytest.approx(alone.levelling_depth[0], rel=1e-6)
    uneven = found["entry_unevenness"]
    assert np.all(uneven[4:] > uneven[:4])  # crowned
    governs = [JUDGED[GOVERNING][code] for code in found[GOVERNING]]
    assert governs[5] == "edge_tension"
    assert JUDGED[VERDICT][found[VERDICT][5]] == "FAILS"
    assert not any("width" in what for what in NOT_CHECKED)  # what counts is not said to be left


def test_the_numbers_of_a_row_reach_the_pulley_that_is_solved(tmp_path: Path) -> None:
    """Source: `solve_across` and `judge` of the drive with the same wrap and limit of tension."""
    found = solved(tmp_path, axis("pulley.head.wrap_angle", '"150 deg", "200 deg"'))
    for k, wrap in enumerate(("150 deg", "200 deg")):
        settings = [*_SET, f"pulley.head.wrap_angle={wrap}"]
        drive = load_drive(EXAMPLES / "worn-head-drive-steel-cord.toml", overrides=settings)
        alone = solve_across(drive)
        for name in OUTPUTS[:3]:
            assert found[name][k] == pytest.approx(getattr(alone, name), rel=1e-6)
    assert found["levelling_depth"][0] != found["levelling_depth"][1]


@pytest.mark.parametrize("strength", ["1 kPa", "80 kPa"])
def test_of_equal_levels_the_stress_of_the_bond_governs_before_creep(
    strength: str, tmp_path: Path
) -> None:
    """Both are missed, across the width and as a whole, whichever uses more of its limit."""
    given = (*_SET, "creep_limit=1 mm", "pulley.head.across.shell_profile={}",
             'pulley.head.lagging={ preset = "full-ceramic", '
             f'bond_strength = "{strength}" }}')  # fmt: skip
    found = solved(tmp_path, axis("pulley.head.wrap_angle", '"180 deg", "200 deg"'), given)
    settings = [*given, "pulley.head.wrap_angle=180 deg"]
    drive = load_drive(EXAMPLES / "worn-head-drive-steel-cord.toml", overrides=settings)
    told = judge(solve(drive, raise_on_failure=False)).at("head", "design")
    assert told.governing is not None
    bonds = [c for c in told.missed if "bond_stress" in c.name]
    (creep,) = [c for c in told.missed if c.name == "creep"]
    assert len(bonds) == 2
    assert told.governing is max(bonds, key=lambda check: check.used)
    assert (creep.used > told.governing.used) is (strength == "80 kPa")
    assert JUDGED[GOVERNING][found[GOVERNING][0]] == told.governing.name


def test_wear_as_an_axis(tmp_path: Path) -> None:
    """A worn profile by a factor; 0 is the even pulley."""
    field = "pulley.head.across.worn_depth"
    rows = '[["-600 mm", "0 mm"], ["0 mm", "2 mm"], ["600 mm", "0 mm"]]'
    worn = (*_SET, "pulley.head.across.shell_profile=[]", f"{field}={{ rows = {rows} }}")
    found = solved(tmp_path, axis(f"{field}.factor", "0, 0.5, 1"), worn)
    assert found["entry_unevenness"][0] == pytest.approx(1.0, abs=1e-9)
    assert np.all(np.diff(found["entry_unevenness"]) > 0.0)


def test_an_axis_of_no_profile_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such drive field"):
        solved(tmp_path, axis("pulley.head.across.shell_profile.crwon", '"1 mm", "2 mm"'))
