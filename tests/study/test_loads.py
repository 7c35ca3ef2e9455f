"""Loads of shaft and belt in the columns of a study.

Expected: the strands of a half turn pull alike, R = T1 + T2, in the line of T1; at 3/4 of a turn
they stand square on each other, R^2 = T1^2 + T2^2. Torque T_e D/2; strength over the larger
tension.
"""

import math
from pathlib import Path

import pytest

from cli.running import DRIVE
from wraparc.study.file import load_study

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
