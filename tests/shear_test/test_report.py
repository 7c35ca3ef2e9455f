"""Reports of a fitted plan: what stands in them, and that all of it is drawn."""

import math
import re
from dataclasses import replace
from html import unescape
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from shear_test.virtual import PRESSURES, fitted, laboratory
from wraparc.answer.shear_test_tables import plan_sheet
from wraparc.answer.sheet import Sheet, Table, shown
from wraparc.checks import Level
from wraparc.errors import InputError
from wraparc.plot.shear_test import condition_pictures
from wraparc.render.shear_test import Report, make_report
from wraparc.shear_test import PlanResult


@pytest.fixture(scope="module")
def result() -> PlanResult:
    """Five pressures, two repeats, one of them a duplicate, a peak inside at the lowest."""
    plan, records = laboratory(pressures=PRESSURES[[0, 2, 3, 5, 7]], repeats=2, points=400)
    tests = [
        replace(test, temperature=294.15, date="2026-03-02", speed=10e-3 / 60)
        for test in plan.tests
    ]
    records["p4r1"] = records["p4r0"]
    return fitted(replace(plan, tests=tuple(tests), title="A <b>lagging</b> & more"), records)


@pytest.fixture(scope="module")
def sheet(result: PlanResult) -> Sheet:
    return shown(plan_sheet(result), "si")


@pytest.fixture(scope="module")
def report(result: PlanResult) -> Report:
    return make_report(result)


def table(sheet: Sheet, title: str) -> Table:
    return next(t for t in sheet.tables if t.title == title)


def test_the_tables_say_what_was_fitted(sheet: Sheet, result: PlanResult) -> None:
    tests = table(sheet, "Tests")
    assert len(tests.rows) == 9
    first = result.conditions[0].tests[0]
    assert tests.rows[0].title == first.test.file
    pressure, slip, friction, lash, _, _ = tests.rows[0].values
    assert pressure == "34"
    assert slip.startswith("(")  # beyond the tested slip
    assert float(friction.split(" ")[0]) == pytest.approx(
        first.fit.parameters.peak_friction,
        abs=5e-3,  # three digits
    )
    assert float(lash.split(" ")[0]) == pytest.approx(0.5, abs=0.1)


def test_a_and_b_stand_beside_those_of_the_derivative(sheet: Sheet) -> None:
    rows = table(sheet, "Coefficients of the tests")
    assert rows.heads == ("A [1/mm]", "b [1/mm]", "A of derivative", "b of derivative")
    for row in rows.rows:
        a, b, by_a, by_b = (float(value.split(" ")[0]) for value in row.values)
        assert by_a == pytest.approx(a, rel=0.15)
        assert by_b == pytest.approx(b, rel=0.15)


def test_a_and_b_of_the_law_are_those_of_its_peak(sheet: Sheet) -> None:
    for row in table(sheet, "Law of all tests").rows:
        slip, friction = (float(value.split(" ")[0]) for value in row.values[:2])
        a, b = map(float, row.values[2:4])
        # x_pk = exp(b/A - 1), mu_pk = -A x_pk, in mm
        assert math.exp(b / a - 1.0) == pytest.approx(slip, rel=5e-3)
        assert -a * slip == pytest.approx(friction, rel=5e-3)


def test_what_was_left_out_comes_first(sheet: Sheet) -> None:
    assert sheet.tables[0].title == "Tests left out"
    assert "contains the same data as test[9]" in sheet.tables[0].rows[0].title
    assert sheet.verdict is not None
    assert sheet.verdict.level is Level.ATTENTION
    assert sheet.verdict.text.startswith("1 of 10 tests could not be used")


def test_files_and_circumstances(sheet: Sheet) -> None:
    files = table(sheet, "Files")
    assert files.heads == (
        "rows", "used", "of the stroke", "normal force", "slip [mm]",
        "temperature", "speed", "date",
    )  # fmt: skip
    assert files.rows[0].values[5:] == ("21 degC", "10 mm/min", "2026-03-02")
    said = " ".join(sheet.remarks)
    assert "9 tests: 34 to 690 kPa, slip up to 14.8 mm, 21 degC, 10 mm/min, 2026-03-02." in said


def test_us_units(result: PlanResult) -> None:
    heads = table(shown(plan_sheet(result), "us"), "Tests").heads
    assert heads[0] == "pressure [psi]"
    assert heads[1] == "peak slip [in]"


def test_the_page_is_whole_and_safe(report: Report, tmp_path: Path) -> None:
    report.save(tmp_path / "fit.html")
    page = (tmp_path / "fit.html").read_text("utf-8")
    assert "<b>lagging</b>" not in page
    assert "A <b>lagging</b> & more" in unescape(page)
    assert not re.search(r"(?:src|href)=[\"']?(?:https?:)?//", page)  # needs no other file
    for text in ("Tests left out", "Equations over pressure"):  # lines, no columns
        assert f"<strong>{text}</strong></p><pre>" in page
    assert "<caption>Law of all tests</caption>" in page
    assert page.count("<svg") == page.count("</svg>") == 3
    identifiers = re.findall(r'\bid="([^"]+)"', page)
    assert len(identifiers) == len(set(identifiers))
    for used in re.findall(r"url\(#([^)]+)\)", page):
        assert used in identifiers


def test_pdf_and_png(report: Report, tmp_path: Path) -> None:
    report.save(tmp_path / "fit.pdf")
    report.save(tmp_path / "fit.png")
    pdf, png = ((tmp_path / f"fit.{kind}").read_bytes() for kind in ("pdf", "png"))
    assert pdf.startswith(b"%PDF-")
    assert len(pdf) > 30_000
    assert png.startswith(b"\x89PNG")
    width, height = (int.from_bytes(png[k : k + 4], "big") for k in (16, 20))
    assert height > 1.5 * width  # one long page
    with pytest.raises(InputError, match=r"\.pdf or \.png or \.html"):
        report.save(tmp_path / "fit.docx")


def test_every_picture_is_drawn(report: Report) -> None:
    assert len(report.drawings) == 3
    for drawing in report.drawings:
        assert drawing.caption.endswith(".")
        ET.fromstring(drawing.draw().to_bytes("svg"))  # noqa: S314 - our own


def axes(result: PlanResult, which: str) -> list[Any]:
    pictures = condition_pictures(result.conditions[0], result.plan.saturation_pressure)
    return pictures[which][1]().figure.axes


def test_a_panel_for_each_pressure(result: PlanResult) -> None:
    panels = axes(result, "curves")
    assert [ax.get_title("left") for ax in panels] == [
        "34 kPa", "103 kPa", "138 kPa", "276 kPa", "690 kPa",
    ]  # fmt: skip
    assert [len(ax.lines) for ax in panels] == [5, 5, 5, 5, 3]  # dots and fit a test, and the law


def test_quantities_over_pressure_with_bands_and_predictions(result: PlanResult) -> None:
    found = axes(result, "pressure")
    assert [ax.get_title("left") for ax in found] == [
        "Peak slip [mm]", "Peak friction", "A [1/mm]", "b [1/mm]", "Pressures left out in turn",
    ]  # fmt: skip
    assert all(ax.collections for ax in found[:4])
    assert len(found[4].patches) == 5


def test_residuals_and_derivative(result: PlanResult) -> None:
    left, right = axes(result, "checks")
    assert left.get_ylim()[1] < 4.0  # noise levels
    assert right.get_xscale() == "log"
    assert len(right.lines) == 2 * 9


def test_one_pressure_has_a_report_too(tmp_path: Path) -> None:
    one = fitted(*laboratory(pressures=[207e3], repeats=1, points=300))
    make_report(one).save(tmp_path / "one.pdf")
    titles = [t.title for t in shown(plan_sheet(one), "si").tables]
    assert "Equations over pressure" not in titles
    assert "Law of all tests" in titles
