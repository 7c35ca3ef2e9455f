"""Resultant of belt tensions on a pulley, and the safety factor of the belt.

Expected by vectors: strands of T1 and T2 that leave the pulley pi - phi apart.
"""

import cmath
import math
from dataclasses import replace

import pytest

from wraparc import load_drive, solve
from wraparc.drive.load_case import resultant
from wraparc.present.drive_sheet import loads_table
from wraparc.present.sheet import shown


@pytest.mark.parametrize("wrap", [10.0, 90.0, 180.0, 210.0, 240.0])
@pytest.mark.parametrize(("entry", "leaving"), [(150e3, 60e3), (60e3, 60e3), (40e3, 90e3)])
def test_resultant_is_the_sum_of_both_strands(entry: float, leaving: float, wrap: float) -> None:
    found = resultant(entry, leaving, math.radians(wrap), 1e6)
    both = entry + leaving * cmath.exp(1j * math.radians(180.0 - wrap))
    assert found.resultant_force == pytest.approx(abs(both), rel=1e-12)
    assert found.resultant_angle == pytest.approx(cmath.phase(both), abs=1e-12)
    assert found.belt_safety == pytest.approx(1e6 / max(entry, leaving))


def test_every_pulley_and_load_case_has_its_loads() -> None:
    result = solve(load_drive("examples/head-drive-fabric.toml"))  # 180 degrees: T1 + T2
    table = shown(loads_table(result), "si")
    assert [row.title for row in table.rows] == ["design: head", "empty: head", "start: head"]
    assert table.rows[0].values == ("210 kN", "0 deg", "-")
    assert "its strength is not given" in table.note
    belt = replace(result.drive.belt, name="ST2000", rating=300e3, momentary_factor=1.5)
    strong = solve(replace(result.drive, belt=belt))
    table = shown(loads_table(strong), "si")
    # 2000 kN/m x 1.2 m over 150 kN; 2000/300 and 2000/450 are what the rating asks
    assert table.rows[0].values[2] == "16"
    assert "at least 6.67 running and 4.44 starting and stopping" in table.note
