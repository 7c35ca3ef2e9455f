"""Words that once misled: constant friction, braking pulleys, idle pulleys, the k factor."""

import math
import re
from dataclasses import replace

import pytest

from answer.drives import drive, solved
from wraparc import DriveResult, solve
from wraparc.answer.checks_table import used_text
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.sheet import Row, percent
from wraparc.answer.sheet import shown as told_in
from wraparc.checks import Check, Level
from wraparc.drive import Drive
from wraparc.friction import Constant


def constant(entry: float, leaving: float, friction: float) -> DriveResult:
    base = drive(entry, leaving, overrun=0.0)
    lagging = replace(base.pulleys[0].lagging, law=Constant(friction_coefficient=friction))
    described: Drive = replace(base, pulleys=(replace(base.pulleys[0], lagging=lagging),))
    return solve(described, raise_on_failure=False)


def rows(result: DriveResult, table: str) -> dict[str, Row]:
    found = next(
        t for t in told_in(drive_sheet([result]), "si").tables if t.title.startswith(table)
    )
    return {row.title: row for row in found.rows}


def test_constant_friction_reaches_gross_slip_with_the_whole_wrap_slipping() -> None:
    """Euler and Eytelwein: exp(0.4 pi) = 3.514, at any creep beyond the onset."""
    gross = rows(constant(150e3, 60e3, 0.4), "Capacity")["Capacity at gross slip"]
    assert gross.values == ("3.51",)
    assert gross.note.endswith("the whole wrap slips")
    assert "extrapolation" not in gross.note
    sheet = told_in(drive_sheet([constant(150e3, 30e3, 0.4)]), "si")
    assert sheet.verdict is not None
    safety = (math.exp(0.4 * math.pi) - 1.0) * 30.0 / 120.0  # 0.628 where the whole wrap slips
    told = re.fullmatch(
        r"Gross slip: safety ([\d.]+) is below 1 \(head, full\)\.", sheet.verdict.text
    )
    assert told is not None
    assert float(told[1]) == pytest.approx(safety, rel=0.02)
    assert float(told[1]) <= safety, "63.5 mm of creep come before"
    assert any(s.startswith("T1/T2 required: 5; ") for s in sheet.verdict.sentences)


def test_ratios_of_a_braking_pulley_are_headed_by_the_ratio_that_they_are() -> None:
    """exp(0.35 pi) = 3.003 is tight side over slack side: T2/T1 where T2 is the tight side."""
    for entry, leaving, head in ((150e3, 60e3, "T1/T2 up to"), (60e3, 150e3, "T2/T1 up to")):
        result = solved(entry, leaving)
        table = next(
            t
            for t in told_in(drive_sheet([result]), "si").tables
            if t.title == "Compared with constant friction"
        )
        assert table.heads[1] == head
        assert next(r for r in table.rows if r.title == "CEMA, rubber").values[1] == "3.00"


def test_parts_that_cancel_are_no_shares() -> None:
    """An idle pulley: the overrun and what takes it back again are many times their sum."""
    for row in rows(solved(100e3, 100e3), "Creep by source").values():
        assert "%" not in row.values[0]
    for row in rows(constant(100e3, 100e3, 0.35), "Creep by source").values():
        assert row.values == ("0 mm",)  # of none at all
    driving = rows(solved(), "Creep by source")
    assert "%" in driving["Global creep"].values[0]


@pytest.mark.parametrize(
    ("share", "text"), [(-3.64e-17, "0 %"), (0.0, "0 %"), (1e-6, "0.0001 %"), (-0.5, "-50 %")]
)
def test_rounding_of_the_solution_is_no_share(share: float, text: str) -> None:
    assert told_in(percent(share), "si") == text


def test_the_k_factor_is_equation_7_of_the_paper() -> None:
    """k = belt modulus x belt width / length of the active arc, by hand from the result."""
    result = solved().arcs[0]
    arc = result.arc
    length = result.active_arc * arc.diameter / 2.0
    assert result.k_factor == pytest.approx(arc.axial_stiffness / length, rel=1e-15)
    assert result.scalars()["k_factor"] == result.k_factor
    shown = rows(solved(), "Result")["Spring rate (k factor)"]
    assert shown.values == (f"{float(f'{result.k_factor / 1e3:.2e}'):.0f} kN/m",)
    assert "equation 7" in shown.note


@pytest.mark.parametrize(
    ("value", "limit", "at_most", "text"),
    [
        (0.553, 6.35e-3, True, "> 10 times"),  # 553/6.35 = 87.1
        (63.4e-3, 6.35e-3, True, "998 %"),
        (63.6e-3, 6.35e-3, True, "> 10 times"),
        (13.0e-3, 6.35e-3, True, "205 %"),
        (500.0, 1.25, False, "0.25 %"),
        (0.1, 1.25, False, "> 10 times"),
        (0.0, 1.25, False, "> 10 times"),
    ],
)
def test_what_is_far_from_its_limit_is_told_in_times(
    value: float, limit: float, at_most: bool, text: str
) -> None:
    """By hand: value over a maximum, a minimum over the value."""
    check = Check(name="x", title="x", level=Level.OK, value=value, limit=limit, at_most=at_most)
    assert told_in(used_text(check), "si") == text
