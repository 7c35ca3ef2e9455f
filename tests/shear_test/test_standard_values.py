"""Static and kinetic friction and that at standard slips, against the law of noiseless tests."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import fitted, laboratory, single
from wraparc.answer.shear_test_standard import standard_tables
from wraparc.answer.sheet import shown
from wraparc.shear_test import PlanResult
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.standard_values import (
    STANDARD_SLIPS,
    Statistic,
    kinetic_span,
    law_at_slips,
    standard_values,
)

#: Peak friction 0.8 at 4 mm, then down 20 per metre to 0.7, which is reached at 9 mm.
FALLING = single(0.8, 4e-3, post_peak_slope=-20.0, residual_friction=0.7)


def lab(law: Any = FALLING, **more: Any) -> PlanResult:
    rig = {"noise": 1e-5, "lash": 0.5e-3, "points": 1200} | more
    plan, records = laboratory(
        pressures=[100e3, 200e3], repeats=2, law=law, shear_compliance=0.0, **rig
    )
    return fitted(replace(plan, thickness=None), records)


@pytest.fixture(scope="module")
def result() -> PlanResult:
    return lab()


def test_friction_at_standard_slips_is_that_of_the_curve(result: PlanResult) -> None:
    for of in standard_values(result.conditions[0]):
        assert of.tests == 2
        # the closed form of the curve at each slip
        wanted = [float(FALLING.friction(slip, of.pressure)) for slip in STANDARD_SLIPS]
        assert [s.mean for s in of.at_slip] == pytest.approx(wanted, abs=1.5e-3)
        assert [s.count for s in of.at_slip] == [2] * 5
        assert np.all(np.isnan(of.beyond))


def test_static_is_the_peak_and_kinetic_the_mean_behind_it(result: PlanResult) -> None:
    condition = result.conditions[0]
    for of in standard_values(condition):
        assert of.static.mean == pytest.approx(0.8, abs=1.5e-3)
        assert of.rising == 0
        first, last = of.kinetic_slip
        assert first == pytest.approx(5e-3, rel=0.02)  # 1.25 peak slips
        assert last == pytest.approx(15e-3, rel=0.02)  # 15.5 mm of stroke less the lash
        slips = np.linspace(first, last, 4001)
        wanted = float(np.mean(FALLING.friction(slips, of.pressure)))
        assert of.kinetic.mean == pytest.approx(wanted, abs=1e-3)


def test_the_deviation_is_that_between_tests() -> None:
    one = Statistic.of([0.40, 0.44, float("nan")])
    # by hand: mean 0.42, s = 0.02 * sqrt(2)
    assert (one.mean, one.deviation, one.count) == pytest.approx((0.42, 0.0282843, 2), abs=1e-7)
    alone = Statistic.of([0.4])
    assert np.isnan(alone.deviation)
    for of in standard_values(lab(scatter_friction=0.05, points=500).conditions[0]):
        assert 1e-3 < of.static.deviation < 0.2


def test_a_slip_that_no_test_reached_is_the_law_in_brackets() -> None:
    short = lab(single(0.8, 16e-3), stroke=6e-3, points=400)
    condition = short.conditions[0]
    of = standard_values(condition)[0]
    assert [s.count for s in of.at_slip] == [2, 2, 2, 0, 0]
    law = condition.lagging.law
    assert of.beyond[3:] == pytest.approx(
        [float(law.friction(x, of.pressure)) for x in (6.35e-3, 10e-3)]
    )
    static, slips, _ = shown(tuple(standard_tables(condition, "")), "si")
    assert slips.rows[0].values[7] == f"[{of.beyond[3]:.3f}]"
    assert slips.rows[0].values[8] == "-"
    assert "extrapolated" in slips.note
    # nor has it a peak, nor anything behind it
    assert of.rising == 2
    assert static.rows[0].values[1] == f"> {of.static.mean:.3f}"
    assert static.rows[0].values[3] == static.rows[0].values[5] == "-"
    assert static.rows[0].note == "still rising at the end of 2 of 2"
    assert kinetic_span(condition.tests[0]) is None


def test_a_slip_that_some_tests_reached_says_how_many(result: PlanResult) -> None:
    condition = result.conditions[0]
    first, *others = condition.found.tests
    fit = replace(first.judged.fit, slip_max=8e-3)
    short = replace(first, judged=replace(first.judged, fit=fit))
    condition = replace(condition, found=replace(condition.found, tests=(short, *others)))
    _, slips, _ = shown(tuple(standard_tables(condition, "")), "us")
    assert slips.heads[1::2] == ("0.0394 in", "0.0787 in", "0.157 in", "0.25 in", "0.394 in")
    assert slips.rows[0].values[9].endswith(" (1)")
    assert slips.rows[1].values[9].count("(") == 0


def test_the_law_at_standard_slips_has_the_uncertainty_of_its_peaks() -> None:
    """Spread of 4,000 draws of peaks and lash, by other code, against the closed form; 6 %."""
    plan, records = laboratory(repeats=2, pressures=[60e3, 120e3, 250e3], points=250)
    condition = fitted(replace(plan, uncertainty=Uncertainty()), records).conditions[0]
    assert condition.fit is not None
    friction, expanded = law_at_slips(condition)
    at = np.array([60e3, 120e3, 250e3])
    mean, covariance = condition.fit.peaks(at), condition.fit.own_covariance(at)
    random = np.random.default_rng(2)
    for k in range(3):
        logs = random.multivariate_normal(mean[k], covariance[k], 4000)
        own = [
            t
            for t, level in zip(condition.tests, condition.found.levels, strict=True)
            if level == k
        ]
        errors = np.array([t.fit.error("lash") for t in own])
        late = random.normal(0.0, np.sqrt((errors**2).sum()) / len(own), 4000)
        for j, slip in enumerate(STANDARD_SLIPS):
            r = (slip + late) / np.exp(logs[:, 0])
            drawn = np.exp(logs[:, 1]) * r * (1.0 - np.log(r))
            assert friction[k, j] == pytest.approx(float(np.median(drawn)), rel=0.01)
            wanted = condition.fit.coverage_factor * float(np.std(drawn))
            assert expanded[k, j] == pytest.approx(wanted, rel=0.06)
    (table,) = (
        t
        for t in shown(tuple(standard_tables(condition, "")), "si")
        if t.title.startswith("Law at")
    )
    assert " \u00b1 " in table.rows[0].values[0]
    assert table.rows[0].values[4].startswith("[") == (
        STANDARD_SLIPS[4] > max(t.fit.slip_max for t in condition.tests[:2])
    )
