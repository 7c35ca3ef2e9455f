"""Loads of shaft and belt in the columns of a study.

Expected: the strands of a half turn pull alike, R = T1 + T2, in the line of T1; at 3/4 of a turn
they stand square on each other, R^2 = T1^2 + T2^2. Torque T_e D/2; strength over the larger
tension.
"""

import math
from pathlib import Path

import pytest

from cli.running import DRIVE
from judgement.rows import MOTORS
from wraparc.checks import judge
from wraparc.checks.of_rows import LEVELS, NAMES
from wraparc.study.file import load_study
from wraparc.train import solve_train
from wraparc.train.file import train_from_text

PLAN = """
format = 1
drive = "drive.toml"
outputs = ["resultant_force", "resultant_angle", "belt_safety", "drum_torque"]
[[axis]]
field = "pulley.head.wrap_angle"
values = ["180 deg", "270 deg"]
"""


def test_a_study_tells_the_loads_of_shaft_and_belt(tmp_path: Path) -> None:
    text = DRIVE.split("[[load_case]]")[0]
    text = text.replace("[[pulley]]", 'strength = "1000 kN/m"\n[[pulley]]')
    (tmp_path / "drive.toml").write_text(text, "utf-8")
    (tmp_path / "plan.toml").write_text(PLAN, "utf-8")
    found = load_study(str(tmp_path / "plan.toml")).study.solve(0, 2)
    assert found["resultant_force"] == pytest.approx([210e3, math.hypot(150e3, 60e3)])
    assert found["resultant_angle"] == pytest.approx([0.0, math.atan2(-60e3, 150e3)], abs=1e-9)
    assert found["belt_safety"] == pytest.approx([8.0, 8.0])
    assert found["drum_torque"] == pytest.approx([36e3, 36e3])


MOTOR_PLAN = """
format = 1
drive = "drive.toml"
pulley = "two"
outputs = ["motor_load", "motor_torque", "drum_torque", "most_shaft_load", "least_shaft_load"]
[[axis]]
field = "train.effective_tension"
values = ["40 kN", "60 kN"]
"""


def test_a_study_tells_and_judges_the_torque_of_motors(tmp_path: Path) -> None:
    """Expected: as `solve_train` finds and judges the same trains, one by one."""
    text = MOTORS.replace('["800 mm"', '["786 mm"').replace(
        'name = "two"', 'name = "two"\nmass = "1 t"'
    )
    (tmp_path / "drive.toml").write_text(text, "utf-8")
    (tmp_path / "plan.toml").write_text(MOTOR_PLAN, "utf-8")
    found = load_study(str(tmp_path / "plan.toml")).study.solve(0, 2)
    for row, pull in enumerate(("40 kN", "60 kN")):
        train = train_from_text(
            text.replace('effective_tension = "60 kN"', f'effective_tension = "{pull}"')
        )
        result = solve_train(train)
        member = result.cases[0]["two"]
        assert member.motor is not None
        assert found["motor_load"][row] == pytest.approx(member.motor.motor_load, rel=1e-3)
        assert found["drum_torque"][row] == pytest.approx(member.drum_torque, rel=1e-3)
        told = judge(result).at("two", "design").governing
        assert told is not None
        assert (LEVELS[found["verdict"][row]], NAMES[found["governing"][row]]) == (
            told.level,
            told.name,
        )
    assert NAMES[found["governing"][1]] == "motor_load"
    weight = found["most_shaft_load"] - found["least_shaft_load"]
    assert weight == pytest.approx(2.0 * 9806.65)
