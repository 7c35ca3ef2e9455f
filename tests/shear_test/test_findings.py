"""Findings of shear tests, as the page lists them."""

from dataclasses import replace
from pathlib import Path

import pytest

from wraparc.answer.shear_test_findings import Finding, condition_findings
from wraparc.checks import Level
from wraparc.shear_test.analysis import PlanResult
from wraparc.shear_test.fit_plan import fit_plan
from wraparc.shear_test.plan_file import load_plan
from wraparc.units import in_units

PLAN = Path(__file__).parents[2] / "examples/shear_tests/plan.toml"


@pytest.fixture(scope="module")
def result() -> PlanResult:
    plan = load_plan(str(PLAN))
    few = tuple(t for t in plan.tests if t.condition == "dry" and "-1." in t.file)
    return fit_plan(replace(plan, tests=few))


def found_in(result: PlanResult) -> dict[str, Finding]:
    findings = condition_findings(result, result.conditions[0])
    assert [f.level.rank for f in findings] == sorted(
        (f.level.rank for f in findings), reverse=True
    )
    return {finding.title: finding for finding in findings}


def test_findings_of_the_shipped_tests(result: PlanResult) -> None:
    # expected: the plan states no order and no belt cover; the friction of the law that made the
    # tests rises beyond their slip; set pressures are 34 to 690 kPa
    found = found_in(result)
    n = len(result.plan.tests)
    for title in ("Test order missing", "Peak not reached"):
        assert (found[title].level, found[title].tests) == (Level.ATTENTION, n)
        assert found[title].value == f"{n} of {n}"
    assert found["Test belt cover missing"].level is Level.ATTENTION
    low, to, high, unit = in_units(found["Pressure tested"].value).split()
    assert (to, unit) == ("to", "kPa")
    assert float(low) == pytest.approx(34, rel=0.01)
    assert float(high) == pytest.approx(690, rel=0.01)
    last = max(test.fit.slip[-1] for test in result.conditions[0].tests)
    assert in_units(found["Slip tested"].value) == f"{1e3 * last:.1f} mm"


def test_an_order_that_is_stated_is_no_finding(result: PlanResult) -> None:
    condition = result.conditions[0]
    ordered = (replace(condition, remarks=()),)
    found = found_in(replace(result, conditions=ordered))
    assert found["Test order"].level is Level.OK
    assert "Test order missing" not in found
