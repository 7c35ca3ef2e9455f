"""What a file says of its test: used where the plan is silent, else held against the plan.

Expected values: those that were written into the files; force is 2 p A mu of a known friction.
"""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from machine_tables.asked import problems
from wraparc.answer.shear_test_record import record_sheet
from wraparc.answer.shear_test_tables import verdict
from wraparc.checks import Level
from wraparc.shear_test import Choices, PlanResult, fit_plan, read_machine_bytes, read_machine_file
from wraparc.shear_test.plan_file import load_plan
from wraparc.units import in_units

AREA = 0.04
TRAVEL = np.arange(0.0, 13.0, 0.1)


def force(pressure: float) -> Any:
    """Of one face pair, friction 1.0 at 9 mm [N]."""
    r = np.clip((TRAVEL - 0.3) / 9.0, 1e-9, 1.0)
    return 2.0 * pressure * AREA * r * (1.0 - np.log(r))


def rows(pressure: float, before: str = "") -> list[str]:
    return [
        f"{before}{0.5 * k:.2f},{travel:.3f},{pull:.2f}"
        for k, (travel, pull) in enumerate(zip(TRAVEL, force(pressure), strict=True))
    ]


def fitted(tmp_path: Path, text: str, *tests: str, **plan: str) -> PlanResult:
    (tmp_path / "a.csv").write_text(text, encoding="utf-8")
    said = plan.get("condition", "")
    written = "".join(f'[[test]]\nfile = "a.csv"\n{test}\n{said}\n' for test in tests)
    (tmp_path / "plan.toml").write_text(
        'format = 1\n[lagging]\nname = "x"\nsurface = "rubber"\n[rig]\nsample_area = "400 cm2"\n'
        f"faces = 2\n{written}",
        encoding="utf-8",
    )
    return fit_plan(load_plan(tmp_path / "plan.toml"))


def long_table(*pressures: float) -> str:
    lines = ["test_id,pressure_kPa,time_s,travel_mm,force_N"]
    for k, pressure in enumerate(pressures):
        lines += rows(1e3 * pressure, f"T{k + 1},{pressure:g},")
    return "\n".join(lines) + "\n"


def test_a_column_that_names_the_test_divides_a_long_table() -> None:
    data = long_table(100, 120, 800).encode()
    assert "contains 3 tests under each other (test_id T1, ...). Write block = 1" in problems(data)
    for block, pressure in enumerate((100, 120, 800), start=1):
        record = read_machine_bytes(data, "x", Choices(block=block))
        assert (record.blocks, record.part) == (3, f"test_id T{block}")
        np.testing.assert_allclose(record.force, force(1e3 * pressure), atol=0.01)


@pytest.mark.parametrize("number", [2, 12])
def test_tests_whose_rows_stand_in_turn_are_divided(number: int) -> None:
    each = [rows(1e3 * (100 + k), f"{k + 7},") for k in range(number)]
    text = "\n".join(
        ["run,time_s,travel_mm,force_N", *(r for of in zip(*each, strict=True) for r in of), ""]
    )
    record = read_machine_bytes(text.encode(), "x", Choices(block=2))
    assert (record.blocks, record.part) == (number, "run 8")
    np.testing.assert_allclose(record.force, force(101e3), atol=0.01)


def test_a_state_that_changes_within_a_pull_divides_nothing() -> None:
    lines = [f"{'a' if k < 60 else 'b'},{row}" for k, row in enumerate(rows(1e5))]
    text = "\n".join(["gear,time_s,travel_mm,force_N", *lines, ""])
    record = read_machine_bytes(text.encode(), "x")
    assert (record.blocks, len(record.travel)) == (1, len(TRAVEL))


def test_tests_under_each_other_without_a_name_are_asked_about(tmp_path: Path) -> None:
    """The light one was swallowed as an approach without load, and the next taken for it: OK."""
    lines = ["time_s,travel_mm,force_N", *rows(100e3), *rows(120e3), *rows(900e3), ""]
    result = fitted(tmp_path, "\n".join(lines), 'pressure = "100 kPa"')
    told = verdict(result)
    assert told.level is Level.ATTENTION
    assert told.text == "Fit rejected: 3 strokes of unlike force, maybe several tests (a.csv)."
    (test,) = result.conditions[0].tests
    assert test.curve.friction.max() == pytest.approx(1.0, rel=0.01)  # the first, not the next
    sheet = record_sheet(read_machine_file(tmp_path / "a.csv"))
    assert sheet.verdict is not None
    assert sheet.verdict.level is Level.ATTENTION
    assert sheet.verdict.text == "3 strokes in 390 rows: the first is used."


def test_tests_of_a_file_that_the_plan_leaves_out_are_on_the_first_screen(tmp_path: Path) -> None:
    result = fitted(tmp_path, long_table(100, 120, 800), 'pressure = "100 kPa"\nblock = 1')
    told = verdict(result)
    assert told.level is Level.OK
    assert told.also[0].text == "Not used: 2 of 3 tests of a.csv (table files)."


PLAIN = "Time (s),Travel (mm),Force (N)"


@pytest.mark.parametrize(
    ("head", "before", "planned", "said"),
    [
        (f"Normal pressure (kPa),{PLAIN}", "120,", 'pressure = "100 kPa"', "120 kPa, the plan 100"),
        (f"Flächenpressung (N/mm²),{PLAIN}", "0.12,", 'pressure = "100 kPa"', "120 kPa, the plan"),
        (f"Pression de contact [bar],{PLAIN}", "1.2,", 'normal_force = "4 kN"', "120 kPa, the"),
        (f"Normal pressure,120,kPa\n{PLAIN}", "", 'pressure = "100 kPa"', "120 kPa, the plan 100"),
        (f"Normal force: 4800 N\n{PLAIN}", "", 'pressure = "100 kPa"', "4.8 kN, the plan 4 kN"),
        (f"Temperatur [°C],{PLAIN}", "60,",
         'pressure = "100 kPa"\ntemperature = "20 degC"', "60 degC, the plan 20"),
        (f"Speed = 200 mm/min\n{PLAIN}", "",
         'pressure = "100 kPa"\nspeed = "12 mm/min"', "200 mm/min, the plan 12 mm/min"),
        (f"Sample area (cm2): 200\n{PLAIN}", "", 'pressure = "100 kPa"', "200 cm2, the plan 400"),
        (f"Condition,{PLAIN}", "wet,", 'pressure = "100 kPa"', "wet, the plan dry"),
        (f"Zustand: naß\n{PLAIN}", "", 'pressure = "100 kPa"', "wet, the plan dry"),
    ],
)  # fmt: skip
def test_a_file_that_contradicts_the_plan_is_no_ok(
    tmp_path: Path, head: str, before: str, planned: str, said: str
) -> None:
    result = fitted(tmp_path, "\n".join([head, *rows(120e3, before), ""]), planned)
    told = verdict(result)
    assert told.level is Level.ATTENTION
    assert f"the file says {said}" in in_units(told.text)
    assert len(in_units(told.text).split()) <= 17  # a number with its unit is one word


@pytest.mark.parametrize(
    ("head", "before", "planned"),
    [
        (f"Normal pressure (kPa),{PLAIN}", "102,", 'pressure = "100 kPa"'),
        (f"Air pressure (mbar),{PLAIN}", "1013,", 'pressure = "100 kPa"'),
        (f"Hydraulic pressure (bar),{PLAIN}", "160,", 'pressure = "100 kPa"'),
        (f"Peak shear pressure (kPa): 200\n{PLAIN}", "", 'pressure = "100 kPa"'),
        (f"Temperature (degC): 23\n{PLAIN}", "", 'pressure = "100 kPa"\ntemperature = "20 degC"'),
        (f"Set pressure (kPa): 1,200\n{PLAIN}", "", 'pressure = "100 kPa"'),
        (f"Speed 1: 5 mm/min\nSpeed 2: 12 mm/min\n{PLAIN}", "",
         'pressure = "100 kPa"\nspeed = "12 mm/min"'),
        (f"Condition,{PLAIN}", "dry,", 'pressure = "100 kPa"'),
    ],
)  # fmt: skip
def test_a_file_that_agrees_or_speaks_of_something_else_is_ok(
    tmp_path: Path, head: str, before: str, planned: str
) -> None:
    result = fitted(tmp_path, "\n".join([head, *rows(100e3, before), ""]), planned)
    assert verdict(result).level is Level.OK


def test_what_the_file_says_is_used_where_the_plan_is_silent(tmp_path: Path) -> None:
    head = f"Normal pressure (kPa),Temperature (degC),{PLAIN}"
    result = fitted(tmp_path, "\n".join([head, *rows(120e3, "120,35,"), ""]), "")
    (test,) = result.conditions[0].tests
    assert test.curve.pressure == pytest.approx(120e3)
    assert test.test.temperature == pytest.approx(308.15)
    assert test.fit.parameters.peak_friction == pytest.approx(1.0, rel=1e-3)


def test_rows_and_columns_that_are_left_out_are_on_the_first_screen(tmp_path: Path) -> None:
    lines = rows(100e3)
    lines[50] = lines[50].replace(lines[50].split(",")[2], "n/a")
    result = fitted(tmp_path, "\n".join([PLAIN, *lines, ""]), 'pressure = "100 kPa"')
    assert verdict(result).also[0].text.startswith("Not used: 1 of 130 rows of a.csv")
    more = [f"{row},{1.02 * float(row.split(',')[1]):.3f}" for row in rows(100e3)]
    text = "\n".join([f"{PLAIN},Position (mm)", *more, ""])
    result = fitted(tmp_path, text, 'pressure = "100 kPa"')
    assert verdict(result).also[0].text.startswith('Not used: column "Position" of a.csv')
