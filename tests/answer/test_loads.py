"""Resultant of belt tensions on a pulley, and the safety factor of the belt.

Expected by vectors: strands of T1 and T2 that leave the pulley pi - phi apart.
"""

import cmath
import math
from dataclasses import replace

import pytest

from wraparc import load_drive, solve
from wraparc.answer.drive_sheet import loads_table
from wraparc.answer.sheet import shown
from wraparc.drive.load_case import resultant
from wraparc.units import in_units


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
    assert "strength missing" in table.note
    belt = replace(result.drive.belt, name="ST2000", rating=300e3, momentary_factor=1.5)
    strong = solve(replace(result.drive, belt=belt))
    table = shown(loads_table(strong), "si")
    assert table.rows[0].values[2] == "16"  # 2000 kN/m x 1.2 m over 150 kN
    assert "strength 2000 kN/m over the larger tension; see the checks" in table.note


@pytest.mark.parametrize("lies", [0.0, 37.0, 90.0, 180.0])
def test_weight_and_resultant_add_as_vectors_between_their_ends(lies: float) -> None:
    """Expected: the vector sum, whichever way the belt lies to the vertical; R = 210 kN."""
    found = resultant(150e3, 60e3, math.pi, 1e6, 1000.0)
    weight = 9806.65
    both = abs(cmath.rect(210e3, math.radians(lies)) + weight)
    assert found.least_shaft_load - 1e-6 <= both <= found.most_shaft_load + 1e-6
    assert found.most_shaft_load == pytest.approx(210e3 + weight)
    assert found.least_shaft_load == pytest.approx(210e3 - weight)
    assert math.isnan(resultant(150e3, 60e3, math.pi, 1e6).most_shaft_load)


def test_the_weight_of_a_pulley_stands_in_its_loads() -> None:
    drive = load_drive("examples/head-drive-fabric.toml", overrides={"pulley.head.mass": "1 t"})
    table = loads_table(solve(drive))
    assert [in_units(cell) for cell in table.rows[0].values[3:]] == ["220 kN", "200 kN"]
    assert "With the weight (head 1000 kg)" in in_units(table.note)
