"""Parameters that the plan holds, and intervals from the profile of the likelihood."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import as_record, fitted, laboratory, single
from wraparc.answer.document import json_text
from wraparc.answer.shear_test_document import plan_document
from wraparc.answer.shear_test_tables import curves_table, plan_sheet
from wraparc.answer.sheet import shown
from wraparc.errors import InputError
from wraparc.shear_test import Sample, VirtualRig, fit_curve, reduce_record, run_virtual_test
from wraparc.shear_test.curve_held import Held
from wraparc.shear_test.plan_file import plan_from_text
from wraparc.shear_test.profile import profile_interval
from wraparc.shear_test.reduce import FrictionCurve

LAW = single(0.8, 16e-3)
PLAN = """
format = 1
[lagging]
name = "mine"
[rig]
sample_area = "400 cm2"
[fit]
fixed = { peak_slip = "16 mm", lash = "0.5 mm" }
[[test]]
file = "a.csv"
pressure = "34 kPa"
"""


def curve(**rig: Any) -> FrictionCurve:
    of = replace(VirtualRig(law=LAW, points=500, noise=0.005), **rig)
    return reduce_record(as_record(run_virtual_test(of, 200e3, 3)), Sample(area=0.04))


def test_what_is_held_is_read_from_the_plan() -> None:
    assert plan_from_text(PLAN).held == Held(peak_slip=16e-3, lash=0.5e-3)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('"16 mm"', '"16"', "fit.fixed.peak_slip"),
        ('"16 mm"', '"-1 mm"', "fit.fixed.peak_slip"),
        ("peak_slip =", "peak_slipp =", "fit.fixed.peak_slipp"),
        ('lash = "0.5 mm"', 'lash = "1 kN"', "a force, where a length is needed"),
    ],
)
def test_what_is_wrong_with_it_is_said(old: str, new: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_from_text(PLAN.replace(old, new))
    (problem,) = caught.value.problems
    assert sentence in str(problem)


def test_a_held_peak_slip_stays_and_the_rest_is_known_better() -> None:
    short = curve(stroke=5e-3)
    free = fit_curve(short)
    held = fit_curve(short, held=Held(peak_slip=16e-3))
    assert held.parameters.peak_slip == pytest.approx(16e-3, rel=1e-8)
    assert held.parameters.peak_friction == pytest.approx(0.8, rel=0.01)
    assert held.error("ln_peak_friction") < 0.5 * free.error("ln_peak_friction")
    # an earlier fit as start keeps it
    again = fit_curve(short, start=held)
    assert again.parameters.peak_slip == pytest.approx(16e-3, rel=1e-8)


def test_a_held_lash_and_a_held_peak_friction_stay() -> None:
    found = fit_curve(curve(), held=Held(lash=0.4e-3, peak_friction=0.7)).parameters
    assert found.lash == 0.4e-3
    assert found.peak_friction == pytest.approx(0.7, rel=1e-8)


def test_the_report_says_what_was_held() -> None:
    plan, records = laboratory(pressures=[100e3, 200e3, 300e3], repeats=1, points=300)
    result = fitted(replace(plan, held=Held(peak_slip=16e-3, lash=0.5e-3)), records)
    condition = result.conditions[0]
    for row in shown(curves_table(condition, ""), "si").rows:
        assert row.values[1] == "16 (fixed)"
        assert row.values[3] == "0.5 (fixed)"
    slips = np.exp(condition.fit.peaks(np.array([100e3, 200e3, 300e3])))[:, 0]  # type: ignore[union-attr]
    assert slips == pytest.approx([16e-3] * 3, rel=1e-3)
    said = " ".join(shown(plan_sheet(result), "si").remarks)
    assert "as the plan says, not fitted: peak slip 16 mm, lash 0.5 mm" in said


def test_the_profile_of_a_peak_inside_is_the_curvature() -> None:
    """A well determined peak: both intervals are the same within their own accuracy."""
    whole = curve(stroke=15.5e-3)
    fit = fit_curve(whole)
    low, high = profile_interval(whole, fit)
    near_low, near_high = fit.interval("peak_slip")
    width = near_high - near_low
    assert low == pytest.approx(near_low, abs=0.3 * width)
    assert high == pytest.approx(near_high, abs=0.3 * width)


def test_the_profile_of_a_peak_far_beyond_is_skewed_and_holds_the_truth() -> None:
    short = curve(stroke=1.6e-3, noise=0.03)
    fit = fit_curve(short)
    assert fit.error("ln_peak_slip") > 0.1
    low, high = profile_interval(short, fit)
    best = fit.parameters.peak_slip
    assert low < 16e-3 < high
    # in ln x_pk the upper side is longer, which no interval from the curvature can be
    assert np.log(high / best) > 1.15 * np.log(best / low)


def test_a_peak_without_an_upper_end_is_said_to_have_none() -> None:
    plan, records = laboratory(pressures=[200e3], repeats=1, points=80, stroke=1.2e-3, noise=0.05)
    condition = fitted(plan, records).conditions[0]
    (test,) = condition.tests
    assert test.is_skewed
    assert test.peak_slip_interval[1] == np.inf
    assert shown(curves_table(condition, ""), "si").rows[0].values[1].endswith("to ?)")
    document = json_text(plan_document(fitted(plan, records)))
    assert "Infinity" not in document


def test_a_held_lash_longer_than_the_test_leaves_it_out() -> None:
    plan, records = laboratory(pressures=[200e3], repeats=1, points=300)
    with pytest.raises(InputError, match=r"lash 20 mm leaves no slip of 15\.5 mm travel"):
        fitted(replace(plan, held=Held(lash=20e-3)), records)
