"""What shear tests and their fit have shown, each in a line: the worst first."""

from dataclasses import dataclass

import numpy as np

from wraparc.answer.shear_test_tables import maximum_deviation
from wraparc.answer.sheet import named
from wraparc.checks import Level
from wraparc.shear_test.analysis import ConditionResult, PlanResult
from wraparc.shear_test.campaign import NOT_STATED
from wraparc.shear_test.reduce import UNKNOWN_ZERO
from wraparc.units import Cell, percent


@dataclass(frozen=True)
class Finding:
    """A finding of the tests of one condition.

    Parameters
    ----------
    title
        In three words.
    level
        OK, or ATTENTION where something is to be looked at.
    value
        What was found, with its unit.
    text
        What it means; empty where the value says so.
    tests
        How many tests it concerns; None of a value.
    """

    title: str
    level: Level
    value: str
    text: str = ""
    tests: int | None = None


def condition_findings(result: PlanResult, of: ConditionResult) -> list[Finding]:
    """Return the findings of one condition, the worst first.

    Parameters
    ----------
    result
        From `wraparc.shear_test.fit_plan`.
    of
        One of its conditions.
    """
    found = [
        *_misfit(of),
        *_circumstances(result, of),
        _peaks(of),
        _zeros(of),
        *_ranges(result, of),
    ]
    return sorted(found, key=lambda finding: (-finding.level.rank, -(finding.tests or 0)))


def _counted(
    of: ConditionResult, titles: tuple[str, str], tests: int, value: str, text: str
) -> Finding:
    """A finding that some tests of a condition have, or none of them."""
    total = len(of.tests)
    if not tests:
        return Finding(titles[1], Level.OK, value or f"{total} of {total}")
    return Finding(titles[0], Level.ATTENTION, f"{tests} of {total}", text, tests)


def _misfit(of: ConditionResult) -> list[Finding]:
    if not of.misfit:
        return []
    tests = sum(bool(test.judged.misfit) for test in of.tests)
    text = f"{of.misfit[0][:1].upper()}{of.misfit[0][1:]}."
    value = f"{tests} of {len(of.tests)}" if tests else ""
    return [Finding("Tests deviate", Level.ATTENTION, value, text, tests or len(of.tests))]


def _circumstances(result: PlanResult, of: ConditionResult) -> list[Finding]:
    """What the plan does not state of the order of the tests and of their belt."""
    if result.plan.digitised is not None:
        return []
    unordered = len(of.tests) if NOT_STATED in of.remarks else 0
    order = _counted(
        of, ("Test order missing", "Test order"), unordered, "",
        "A sample that wears, or a rig that drifts, would not be noticed.",
    )  # fmt: skip
    if result.plan.cover_thickness is not None:
        return [order]
    text = "Thickness and modulus of the cover are missing: its shear counts as slip."
    return [order, Finding("Test belt cover missing", Level.ATTENTION, "in the slip", text)]


def _peaks(of: ConditionResult) -> Finding:
    outside = sum(not test.fit.peak_inside for test in of.tests)
    text = "Outside the tested slip the law is an extrapolation."
    return _counted(of, ("Peak not reached", "Peak reached"), outside, "", text)


def _zeros(of: ConditionResult) -> Finding:
    unknown = sum(test.curve.zero_unknown > 0.0 for test in of.tests)
    text = (
        "No flat part, or a short one, before the slip starts: the intervals include up to "
        f"{percent(UNKNOWN_ZERO)} of the maximum force."
    )
    return _counted(of, ("Force zero unverified", "Force zero"), unknown, "", text)


def _ranges(result: PlanResult, of: ConditionResult) -> list[Finding]:
    pressures = [test.curve.pressure for test in of.tests]
    slip = max(test.fit.slip_max for test in of.tests)
    found = [
        Finding("Maximum deviation", Level.OK, maximum_deviation(of.tests)),
        Finding(
            "Pressure tested", Level.OK,
            Cell(max(pressures), "pressure", 3, "to", min(pressures))
            if np.ptp(pressures) > 0.0 else named("wrap_pressure", pressures[0]),
        ),
        Finding("Slip tested", Level.OK, named("slip", slip)),
    ]  # fmt: skip
    scatter = of.found.scatter
    if scatter is None or result.plan.digitised is not None:
        return found
    low, high = (percent(end, 2) for end in scatter.ends)
    title = "Repeat scatter" if scatter.of == "repeats" else "Sample scatter"
    text = f"Standard deviation of the peak friction, between {low} and {high} with 95 %."
    return [*found, Finding(title, Level.OK, percent(scatter.value, 2), text)]
