"""What a test report states beside the numbers, and how it writes its numbers."""

from dataclasses import replace
from pathlib import Path

import pytest

from shear_test.virtual import fitted, laboratory
from wraparc.answer.shear_test_numbers import slope
from wraparc.answer.shear_test_tables import plan_sheet
from wraparc.answer.sheet import Sheet, Table, shown
from wraparc.errors import InputError
from wraparc.plot.shear_test import condition_pictures
from wraparc.provenance import Kind
from wraparc.render.shear_test import Report, make_report
from wraparc.shear_test import PlanResult, TestPlan
from wraparc.shear_test.plan_file import plan_from_text
from wraparc.units import in_units, plus_minus

PLAN = """
format = 1
[lagging]
name = "my-rubber"
[rig]
sample_area = "400 cm2"
name = "two-sided shear rig"
machine = "Machine 50 kN"
operator = "A. Tester"
[rig.force_cell]
make = "Cell 25 kN"
serial = "A123"
accuracy = "class 0.5"
calibrated = "2026-01-15"
[report]
laboratory = "Our laboratory"
number = "2026-14"
tested_by = "A. Tester"
checked_by = "B. Checker"
[all_tests]
humidity = "50 %"
lot = "7"
belt_cover = "DIN X"
conditioning = "24 h at 21 degC"
speed = "10 mm/min"
[[test]]
file = "p0r0"
pressure = "34 kPa"
[[test]]
file = "p0r1"
pressure = "34 kPa"
humidity = "40 %"
operator = "C. Other"
lot = "8"
[[test]]
file = "p1r0"
pressure = "207 kPa"
[[test]]
file = "p1r1"
pressure = "207 kPa"
use = false
reason = "the sample slipped in its clamp"
"""


@pytest.fixture(scope="module")
def result() -> PlanResult:
    _, records = laboratory(pressures=[34e3, 207e3], repeats=2, points=300, shear_compliance=0.0)
    records = {
        name: replace(record, digest=name.encode().hex().zfill(64))
        for name, record in records.items()
    }
    return fitted(plan_from_text(PLAN), records)


@pytest.fixture(scope="module")
def report(result: PlanResult) -> Report:
    return make_report(result)


def table(sheet: Sheet, title: str) -> Table:
    return next(t for t in sheet.tables if t.title == title)


def stated(sheet: Sheet) -> dict[str, str]:
    return {row.title: row.values[0] for row in table(sheet, "Specimen, rig and conditions").rows}


def test_what_holds_for_all_tests_is_overruled_by_one() -> None:
    first, second, third, _ = plan_from_text(PLAN).tests
    assert [t.humidity for t in (first, second, third)] == [0.5, 0.4, 0.5]
    assert (first.operator, second.operator) == ("", "C. Other")
    assert (second.lot, third.lot) == ("8", "7")
    assert (second.belt_cover, second.conditioning) == ("DIN X", "24 h at 21 degC")
    assert second.speed == pytest.approx(10e-3 / 60)


def test_the_laboratorys_report_is_the_source_of_the_law(result: PlanResult) -> None:
    provenance = plan_from_text(PLAN).provenance
    assert (provenance.kind, provenance.source) == (Kind.MEASURED, "Our laboratory, report 2026-14")
    assert result.laggings[0].provenance == provenance
    said = PLAN.replace(
        "[[test]]", '[provenance]\nkind = "measured"\nsource = "Thesis"\n[[test]]', 1
    )
    assert plan_from_text(said).provenance.source == "Thesis"


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("operator =", "operater =", "rig.operater: unknown key. Did you mean"),
        ("serial =", "serail =", "rig.force_cell.serail: unknown key. Did you mean"),
        ("laboratory =", "labratory =", "report.labratory"),
        (
            '"50 %"',
            '"150 %"',
            "all_tests.humidity: must be a percentage from 0 % to 100 %",
        ),
        ('"40 %"', "40", 'test[2].humidity: must be a percentage, got 40. Write "40 %".'),
        (
            '"40 %"',
            '"40 degC"',
            ('test[2].humidity: must be a percentage from 0 % to 100 %, got "40 degC"'),
        ),
        ("use = false", 'use = "no"', "test[4].use: must be true or false"),
        (
            'reason = "the sample slipped in its clamp"',
            "",
            "test[4].reason: missing. Write why the test is left out.",
        ),
    ],
)
def test_what_is_wrong_is_said(old: str, new: str, sentence: str) -> None:
    assert old in PLAN
    with pytest.raises(InputError) as caught:
        plan_from_text(PLAN.replace(old, new, 1), file="plan.toml")
    (problem,) = caught.value.problems
    assert sentence in str(problem)


def test_circumstances_and_what_is_not_stated(report: Report) -> None:
    said = stated(report.sheet)
    assert said["Lot"] == "7; 8"
    assert said["Operator"] == "A. Tester; C. Other"
    assert said["Humidity"] == "40 % to 50 %"
    assert said["Test speed"] == "10 mm/min"
    assert said["Load cell, force"] == "Cell 25 kN, serial A123"
    assert said["Calibration, force"] == "class 0.5, 2026-01-15"
    assert said["Normal force"] == "measured"
    for title in ("Temperature", "Date of the tests", "Compliance of the rig"):
        assert said[title] == "not stated"


def test_a_normal_force_that_is_set_has_no_load_cell(result: PlanResult) -> None:
    condition = result.conditions[0]
    tests = tuple(
        replace(test, record=replace(test.record, normal_force=None)) for test in condition.tests
    )
    conditions = (replace(condition, found=replace(condition.found, tests=tests)),)
    said = stated(shown(plan_sheet(replace(result, conditions=conditions)), "si"))
    assert said["Normal force"] == "as set, not measured"
    assert "Load cell, normal force" not in said


def test_what_is_stated_of_some_tests_only(result: PlanResult) -> None:
    first, *others = result.plan.tests
    plan = replace(result.plan, tests=(replace(first, temperature=294.15), *others))
    condition = result.conditions[0]
    tests = (replace(condition.tests[0], test=plan.tests[0]), *condition.tests[1:])
    conditions = (replace(condition, found=replace(condition.found, tests=tests)),)
    said = stated(shown(plan_sheet(replace(result, plan=plan, conditions=conditions)), "si"))
    assert said["Temperature"] == "21 degC (2 of 3 tests: not stated)"


def test_a_test_that_the_plan_leaves_out_is_said(report: Report, result: PlanResult) -> None:
    assert [t.test.file for t in result.conditions[0].tests] == ["p0r0", "p0r1", "p1r0"]
    sheet = report.sheet
    assert sheet.subtitle.startswith("3 of 4 tests used, 1 not used, as the plan says")
    (row,) = table(sheet, "Tests not used, as the plan says").rows
    assert row.title == "test[4] (p1r1): the sample slipped in its clamp"
    said = " ".join(result.laggings[0].notes)
    assert "1 test was not used, as the plan says: p1r1 (the sample slipped in its clamp)" in said


def test_a_plan_that_uses_no_test(result: PlanResult) -> None:
    tests = tuple(replace(test, use=False, reason="x") for test in result.plan.tests)
    with pytest.raises(InputError, match="uses no test"):
        fitted(replace(result.plan, tests=tests), {})


def test_digests_and_signatures_are_in_the_report(report: Report, tmp_path: Path) -> None:
    digests = table(report.sheet, "Digests (SHA-256) of the machine files")
    assert digests.rows[0].title == f"{b'p0r0'.hex().zfill(64)}  p0r0"
    assert len(digests.rows) == 3
    report.save(tmp_path / "fit.html")
    page = (tmp_path / "fit.html").read_text("utf-8")
    for text in (
        "Our laboratory",
        "2026-14",
        "Tested by",
        "Checked by",
        "B. Checker",
        "not stated",
    ):
        assert text in page
    report.save(tmp_path / "fit.pdf")
    assert (tmp_path / "fit.pdf").read_bytes().startswith(b"%PDF-")


def test_a_plan_that_states_nothing_still_has_the_lines_to_fill_in() -> None:
    plan, records = laboratory(pressures=[207e3], repeats=1, points=300)
    said = stated(make_report(fitted(plan, records)).sheet)
    assert isinstance(plan, TestPlan)
    assert sum(text == "not stated" for text in said.values()) >= 10


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (1.2938, 0.0092, "1.29 \u00b1 0.01"),
        (15.68, 0.21, "15.7 \u00b1 0.2"),
        (0.498, 0.033, "0.498 \u00b1 0.033"),
        (24.4, 1.04, "24.4 \u00b1 1.0"),
        (-0.10258, 0.00099, "-0.103 \u00b1 0.001"),
        (1.2938, 0.0032, "1.294 \u00b1 0.003"),
        (0.806, 0.00000051, "0.8060 \u00b1 < 0.0001"),
        (312.0, 0.2, "312.0 \u00b1 0.2"),
        (1234.0, 56.0, "1234 \u00b1 56"),
        (0.5, 3.0, "0.50 \u00b1 3.0"),
        (0.40312, 0.0, "0.403"),
        (0.40312, float("inf"), "0.403"),
    ],
)
def test_an_interval_has_no_more_digits_than_its_value(
    value: float, error: float, text: str
) -> None:
    assert in_units(plus_minus(value, error)) == text


def test_a_slope_of_rounding_is_none() -> None:
    assert in_units(slope(-3.6e-15, 1e-14, 30.0)) == "0"
    assert in_units(slope(-12.6, 1.2, 30.0)) == "-0.0126 \u00b1 0.0012"
    assert in_units(slope(-12.6, 1.2, 30.0), "us") == "-0.320 \u00b1 0.030"


def test_one_remark_is_one(result: PlanResult) -> None:
    condition = result.conditions[0]
    one = replace(result, conditions=(replace(condition, misfit=("p0r0: rises twice",)),))
    verdict = shown(plan_sheet(one), "si").verdict
    assert verdict is not None
    assert verdict.text == "Fit rejected: the law does not describe its tests (1 remark)."


def test_the_line_of_two_noise_levels_is_named() -> None:
    result = fitted(*laboratory(pressures=[34e3, 103e3, 207e3], repeats=1, points=300))
    _, draw = condition_pictures(result.conditions[0], None)["pressure"]
    legend = draw().figure.axes[4].get_legend()
    assert legend is not None
    assert "2 noise levels" in [text.get_text() for text in legend.get_texts()]
