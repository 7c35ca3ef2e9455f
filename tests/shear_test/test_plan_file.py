"""Shear test plans: what is read, and every error as the sentence the user sees."""

import pytest

from wraparc.errors import InputError
from wraparc.provenance import Kind
from wraparc.shear_test import PlannedTest, Rig, TestPlan
from wraparc.shear_test.law import slip_speed
from wraparc.shear_test.plan_file import load_plan, plan_from_text

PLAN = """
format = 1

[lagging]
name = "my-rubber"
thickness = "12 mm"
elastic_modulus = "6.9 MPa"
roughness = "0.3 mm"

[rig]
sample_area = "400 cm2"
compliance = "0.02 mm/kN"

[columns]
travel = "Stroke"
units = { Load = "N" }

[[test]]
file = "a.csv"
pressure = "34 kPa"
temperature = "21 degC"
speed = "10 mm/min"
date = "2026-03-02"

[[test]]
file = "b.csv"
normal_force = "2760 N"
normal_force_column = 4
condition = "wet"
repeat = "second"
units = { Stroke = "mm" }
"""


def refused(*changes: tuple[str, str]) -> list[str]:
    text = PLAN
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(InputError) as caught:
        plan_from_text(text, file="plan.toml")
    return [str(problem) for problem in caught.value.problems]


def test_a_plan_is_read_in_si() -> None:
    plan = plan_from_text(PLAN)
    assert plan.rig.area == pytest.approx(0.04)
    assert plan.rig.compliance == pytest.approx(0.02e-3 / 1e3)
    assert plan.rig.faces == 2
    assert plan.provenance.kind is Kind.MEASURED
    # E * roughness / thickness = 6.9 MPa * 0.3 / 12
    assert plan.saturation_pressure == pytest.approx(172.5e3)
    # h/G with G = E/3
    assert plan.shear_compliance == pytest.approx(12e-3 / 2.3e6)
    first, second = plan.tests
    assert (first.place, first.pressure, first.condition) == ("test[1]", 34e3, "dry")
    assert first.temperature == pytest.approx(294.15)
    assert first.speed == pytest.approx(10e-3 / 60)
    assert second.normal_force == 2760.0
    assert second.repeat == "second"


def test_what_holds_for_all_files_is_overruled_by_a_test() -> None:
    first, second = plan_from_text(PLAN).tests
    assert (first.choices.travel, second.choices.travel) == ("Stroke", "Stroke")
    assert first.choices.normal_force is None
    assert second.choices.normal_force == 4
    assert dict(second.choices.units) == {"Load": "N", "Stroke": "mm"}


def test_all_problems_come_at_once() -> None:
    problems = refused(
        ('"400 cm2"', '"400"'),
        ("thickness =", "thikness ="),
        ('"34 kPa"', '"-34 kPa"'),
        ('"21 degC"', '"21"'),
        ("normal_force_column = 4", "normal_force_column = 0"),
    )
    assert [p.split(". ")[0].removeprefix("plan.toml: ") for p in problems] == [
        "lagging.thikness: unknown key",
        'rig.sample_area: no unit, where an area is needed, got "400"',
        'test[1].pressure: must be between 0.5 kPa and 20 MPa, got "-34 kPa".',
        'test[1].temperature: no unit, where a temperature is needed, got "21"',
        "test[2].normal_force_column: must be a number from 1, got 0",
    ]


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('sample_area = "400 cm2"', "", 'plan.toml: rig.sample_area: missing'),
        ('file = "a.csv"', "", "plan.toml: test[1].file: missing"),
        ('name = "my-rubber"', "", "plan.toml: lagging.name: missing"),
        ("[columns]", "[[columns]]", "plan.toml: columns"),
        ('pressure = "34 kPa"', 'pressure = "34 kN"', "a force, where a pressure is needed"),
        (
            'pressure = "34 kPa"',
            'pressure = "34 kPa"\nnormal_force = "1 kN"',
            'test[1].normal_force: contradicts pressure, got "1 kN". Remove one of them.',
        ),
        ("0.02 mm/kN", "0.02 mm", "rig.compliance: must be a length over a force, got"),
        ("0.02 mm/kN", "0.02 kN/mm", "rig.compliance"),
        ("0.02 mm/kN", "-0.02 mm/kN", "rig.compliance: must be a length over a force, got"),
        ("format = 1", "format = 2", "format"),
        ("[rig]", "[rig]\nfaces = 3", "must be a whole number from 1 to 2"),
        ('condition = "wet"', "condition = 1", "test[2].condition: must be text, got 1."),
        ("[columns]", "[fit]\npieces = 3\n[columns]", ("fit.pieces: must be a whole number "
                                                       "from 1 to 2, got 3.")),
        ("[columns]", '[fit]\nvariables = "x"\n[columns]', ('fit.variables: must be one of "peak", '
                                                            '"coefficients", got "x".')),
        ("[columns]", "[columns", "line"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said(old: str, new: str, sentence: str) -> None:
    problems = refused((old, new))
    assert len(problems) == 1
    assert sentence in problems[0]


def test_a_plan_without_tests() -> None:
    text = PLAN[: PLAN.index("[[test]]")]
    with pytest.raises(InputError, match=r"test: missing"):
        plan_from_text(text, file="plan.toml")


def test_a_plan_that_is_not_there() -> None:
    with pytest.raises(InputError, match="file not found"):
        load_plan("nowhere/plan.toml")


def test_a_law_was_tested_at_the_fastest_crosshead_of_its_condition() -> None:
    def test(speed: float | None, condition: str = "dry") -> PlannedTest:
        return PlannedTest(file="t.csv", place="test[1]", speed=speed, condition=condition)

    tests = (test(1e-4), test(2e-4), test(None), test(None, "wet"))
    plan = TestPlan(name="made-up", rig=Rig(area=0.04), tests=tests)
    assert slip_speed(plan, "dry") == 2e-4
    assert slip_speed(plan, "wet") is None
