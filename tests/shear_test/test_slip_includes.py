"""What the slip of a law includes: only what a plan tells is taken out of it."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import SHEAR_MODULUS, THICKNESS, fitted, laboratory, rubber
from wraparc.answer.shear_test_tables import plan_sheet
from wraparc.answer.sheet import shown
from wraparc.arc import Distributed, WrapArc
from wraparc.cli import run
from wraparc.drive import Lagging
from wraparc.drive.changes import with_pulley
from wraparc.errors import InputError
from wraparc.files import lagging_text, load_lagging
from wraparc.shear_test.plan_file import plan_from_text
from wraparc.train.file import load_drive

COVER, COVER_MODULUS = 6e-3, 0.9e6
# Clean records of a sample with shear h/G that slides on a cover with shear of its own.
RECORDS: dict[str, Any] = {
    "seed": 3, "repeats": 1, "noise": 1e-4, "lash": 0.0, "scatter_friction": 0.0,
    "scatter_slip": 0.0, "shear_compliance": THICKNESS / SHEAR_MODULUS + COVER / COVER_MODULUS,
}  # fmt: skip


def law_of(**plan: Any) -> tuple[Lagging, dict[str, str]]:
    """The fitted lagging of the records, and the circumstances in the report."""
    given, records = laboratory(**RECORDS)
    result = fitted(replace(given, **plan), records)
    rows = {
        r.title: r.values[0]
        for t in shown(plan_sheet(result), "si").tables
        for r in t.rows
        if r.values
    }
    return result.laggings[0], rows


@pytest.mark.parametrize(
    ("told", "includes", "excess"),
    [
        ({"cover_thickness": COVER, "cover_shear_modulus": COVER_MODULUS}, (), 0.0),
        ({}, ("cover shear",), COVER / COVER_MODULUS),
        (
            {"cover_thickness": COVER, "cover_shear_modulus": COVER_MODULUS, "remove_shear": False},
            ("lagging shear",),
            THICKNESS / SHEAR_MODULUS,
        ),
        (
            {"remove_shear": False},
            ("lagging shear", "cover shear"),
            THICKNESS / SHEAR_MODULUS + COVER / COVER_MODULUS,
        ),
    ],
)
def test_the_law_holds_what_was_not_told(
    told: dict[str, Any], includes: tuple[str, ...], excess: float
) -> None:
    # The known law: at stress tau = mu p its slip is that of rubber(), and what was left in adds
    # its h/G times tau: u = x + (h/G + h_b/G_b) tau.
    lagging, rows = law_of(**told)
    assert lagging.law.slip_includes == includes
    pressure, slip = 207e3, np.linspace(3e-3, 10e-3, 8)
    friction = rubber().friction(slip, pressure)
    found = lagging.law.friction(slip + excess * friction * pressure, pressure)
    # A sheared curve is no integral-log curve: from 3 mm on the fit follows it within 3 %.
    np.testing.assert_allclose(found, friction, rtol=3e-2 if excess else 5e-3)
    assert rows["Slip includes"] == " and ".join(("sliding", *includes, "the rig's own travel"))
    assert lagging.shear_compliance == (0.0 if "lagging shear" in includes else 12e-3 / 2.3e6)


def test_a_lagging_file_keeps_what_its_slip_includes(tmp_path: Path) -> None:
    old = load_lagging("diamond-rubber")
    assert old.law.slip_includes is None
    assert "slip_includes" not in lagging_text(replace(old, name="old"))
    path = tmp_path / "x.toml"
    for parts in ((), ("cover shear",), ("lagging shear", "cover shear")):
        law = replace(old.law, slip_includes=parts)
        lagging = replace(old, name="x", law=law)
        path.write_text(lagging_text(lagging))
        assert load_lagging(str(path)).law.slip_includes == parts
        assert law.scaled(friction=0.7, slip=1.2).slip_includes == parts


def test_shear_that_is_in_the_slip_is_not_added_again() -> None:
    # Lagging with its shear in the slip beside one that does not shear: the same answer.
    drive = load_drive(Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml")
    pulley = drive.pulleys[0]
    law = replace(pulley.lagging.law, slip_includes=("lagging shear",))
    found = []
    for modulus in (pulley.lagging.shear_modulus, np.inf):
        lagging = replace(pulley.lagging, law=law, shear_modulus=modulus)
        assert lagging.shear_compliance == 0.0
        there = with_pulley(drive, replace(pulley, lagging=lagging))
        arc = WrapArc.of(there, there.pulleys[0], there.load_cases[0])
        found.append(Distributed(points=40, capacities=False).solve(arc).exit_creep)
    assert found[0] == found[1]


def test_what_a_lagging_cannot_say_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["lagging", "diamond-rubber"]) == 0
    assert "shear is not stated" in capsys.readouterr().out


PLAN = """
format = 1
lagging = { name = "a", thickness = "12 mm", shear_modulus = "2 MPa" }
rig = { sample_area = "400 cm2" }
test = [{ file = "a.csv", pressure = "100 kPa" }]
"""


def test_a_cover_of_a_plan() -> None:
    belt = '[test_belt]\ncover_thickness = "4 mm"\ncover_shear_modulus = "1 MPa"\n'
    plan = plan_from_text(PLAN + belt)
    assert plan.slip_includes == ()
    assert plan.cover_compliance + plan.sample_compliance == pytest.approx(
        12e-3 / 2e6 + 4e-3 / 1e6, rel=1e-12
    )
    bare = plan_from_text(PLAN + '[test_belt]\ncover_thickness = "0 mm"\n')
    assert (bare.slip_includes, bare.cover_compliance) == ((), 0.0)
    assert plan_from_text(PLAN).slip_includes == ("cover shear",)


@pytest.mark.parametrize(
    ("belt", "sentence"),
    [
        ('cover_thickness = "4 mm"', "cover_shear_modulus: missing: the cover shears"),
        ('cover_shear_modulus = "1 MPa"', "cover_thickness"),
        ('cover_thickness = "-4 mm"', "must be"),
        ('cover_thickness = "90 mm"\ncover_shear_modulus = "1 MPa"', "between 0 mm and 60 mm"),
        ('cover_thickness = "4 mm"\ncover_shear_modulus = "1 kPa"', "at least 10 kPa"),
    ],
)
def test_covers_that_cannot_be(belt: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_from_text(f"{PLAN}[test_belt]\n{belt}\n")
    assert sentence in str(caught.value)


def test_a_figure_does_not_say_what_its_slip_includes() -> None:
    text = PLAN.replace('rig = { sample_area = "400 cm2" }', 'digitised = { source = "a paper" }')
    text += "[fit]\nremove_shear = false\n"
    assert plan_from_text(text).slip_includes is None


def test_virtual_tests_of_a_cover_tell_it_to_the_plan(tmp_path: Path) -> None:
    few = ["--pressures", "100", "--repeats", "1", "--points", "50"]
    assert run(["rig", str(tmp_path / "a"), *few, "--cover", "4", "--cover-modulus", "0.8"]) == 0
    text = (tmp_path / "a" / "plan.toml").read_text()
    assert plan_from_text(text).cover_compliance == pytest.approx(4e-3 / 0.8e6, rel=1e-12)
    assert run(["rig", str(tmp_path / "b"), *few]) == 0
    assert "test_belt" not in (tmp_path / "b" / "plan.toml").read_text()
    lagging = load_lagging("diamond-rubber")
    for name, parts in (("pure", ()), ("both", ("cover shear",))):
        law = replace(lagging.law, slip_includes=parts)
        path = tmp_path / f"{name}.toml"
        path.write_text(lagging_text(replace(lagging, name=name, law=law)))
    pure, both = str(tmp_path / "pure.toml"), str(tmp_path / "both.toml")
    assert run(["rig", str(tmp_path / "c"), *few, "--lagging", pure]) == 0
    assert plan_from_text((tmp_path / "c" / "plan.toml").read_text()).slip_includes == ()
    # with its cover in the law already, a cover in the rig would be there twice
    assert run(["rig", str(tmp_path / "d"), *few, "--lagging", both, "--cover", "4"]) == 2
    assert run(["rig", str(tmp_path / "e"), *few, "--lagging", both]) == 0
    assert plan_from_text((tmp_path / "e" / "plan.toml").read_text()).slip_includes == (
        "cover shear",
    )
