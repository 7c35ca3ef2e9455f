"""From a record to one friction curve and its law.

Expected values: the known law behind a virtual test; closed forms of the law (model: peak at
exp(b/A - 1), friction zero again at e x_pk); the friction room's own law, written apart.
"""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from shear_test.virtual import SHEAR_MODULUS, THICKNESS, as_record, rubber, single
from wraparc.errors import InputError
from wraparc.shear_test import Sample, VirtualRig, fit_curve, reduce_record, run_virtual_test
from wraparc.shear_test.curve_fit import CurveFit
from wraparc.shear_test.curve_model import (
    CurveParameters,
    friction_and_jacobian,
    friction_and_slope,
    slip_at,
)
from wraparc.shear_test.derivative import derivative_check, five_point_derivative
from wraparc.shear_test.noise import despiked, noise_level
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.shear_test.robust import correlation_length, inflation
from wraparc.shear_test.student import t95

COMPLIANCE = THICKNESS / SHEAR_MODULUS
SAMPLE = Sample(area=0.04, shear_compliance=COMPLIANCE)
RIG = VirtualRig(law=rubber(), shear_compliance=COMPLIANCE, points=2000)
FALLING = single(1.42, 5e-3, post_peak_slope=-16.0, residual_friction=1.33)


def curve(rig: VirtualRig = RIG, pressure: float = 207e3, seed: int = 3) -> FrictionCurve:
    return reduce_record(as_record(run_virtual_test(rig, pressure, seed)), SAMPLE)


def fit(rig: VirtualRig = RIG, pressure: float = 207e3, seed: int = 3) -> CurveFit:
    return fit_curve(curve(rig, pressure, seed))


parameters = st.builds(
    CurveParameters,
    ln_peak_slip=st.floats(-6.0, -3.0),
    ln_peak_friction=st.floats(-1.5, 0.6),
    lash=st.floats(-1e-3, 2e-3),
    post_peak_slope=st.floats(-40.0, 0.0),
    residual_friction=st.floats(0.01, 3.0),
)


@given(parameters)
def test_the_curve_is_the_law_of_the_friction_room(q: CurveParameters) -> None:
    level = min(q.residual_friction, q.peak_friction)
    law = single(
        q.peak_friction, q.peak_slip, post_peak_slope=q.post_peak_slope, residual_friction=level
    )
    slip = np.linspace(0.0, 4.0 * q.peak_slip, 300)
    np.testing.assert_allclose(friction_and_slope(slip, q)[0], law.friction(slip, 1e5), atol=1e-12)


@given(parameters, st.floats(0.0, 3e-3))
def test_slip_solves_its_equation(q: CurveParameters, bending: float) -> None:
    if bending * -q.post_peak_slope > 0.9:
        return  # the root is unique only while 1 + K mu'(z) > 0
    travel = np.linspace(0.0, 20e-3, 200)
    z = slip_at(travel, bending, q)
    np.testing.assert_allclose(
        z + bending * friction_and_slope(z, q)[0], np.maximum(travel - q.lash, 0.0), atol=2e-9
    )


@given(parameters, st.floats(0.0, 2e-3))
def test_the_jacobian_is_the_derivative(q: CurveParameters, bending: float) -> None:
    if bending * -q.post_peak_slope > 0.5:
        return
    travel = np.linspace(0.0, 20e-3, 97)
    _, jacobian = friction_and_jacobian(travel, bending, q)
    values = q.vector()
    for k, step in enumerate((1e-6, 1e-6, 1e-9, 1e-4, 1e-7, 1e-7)):
        up, down = values.copy(), values.copy()
        up[k] += step
        down[k] -= step
        if k == 3 and q.post_peak_slope > -step:
            continue  # a rising line is no law
        ends = [friction_and_jacobian(travel, bending, CurveParameters(*v))[0] for v in (up, down)]
        numeric = (ends[0] - ends[1]) / (2.0 * step)
        off = np.abs(numeric - jacobian[:, k]) > 1e-4 * (1.0 + np.abs(jacobian[:, k]))
        assert off.sum() <= 3  # at the start, the peak and the foot of the line it has a corner


def test_a_clean_curve_is_found_exactly() -> None:
    rig = replace(RIG, noise=0.0)
    found = fit(rig).parameters
    slip, friction, _, _ = rubber().parameters(207e3)
    assert found.peak_slip == pytest.approx(float(slip), rel=1e-4)
    assert found.peak_friction == pytest.approx(float(friction), rel=1e-4)
    assert found.lash == pytest.approx(0.5e-3, abs=1e-6)


@pytest.mark.parametrize("pressure", [34e3, 138e3, 690e3])
@pytest.mark.parametrize("seed", [1, 2])
def test_one_percent_noise(pressure: float, seed: int) -> None:
    found = fit(replace(RIG, points=5000), pressure, seed)
    slip, friction, _, _ = rubber().parameters(pressure)
    assert found.parameters.peak_slip == pytest.approx(float(slip), rel=0.02)
    assert found.parameters.peak_friction == pytest.approx(float(friction), rel=0.02)
    assert found.parameters.lash == pytest.approx(0.5e-3, abs=0.05e-3)
    assert not found.peak_inside


@pytest.mark.parametrize(
    "fault",
    [{"spikes": 0.01}, {"wander": 0.03}, {"unloading": True}, {"force_zero": 40.0},
     {"correlation": 20.0}, {"points": 300}, {"compliance": 2e-8}],
    ids=str,
)  # fmt: skip
def test_faults_of_real_rigs(fault: dict[str, float]) -> None:
    rig = replace(RIG, **fault)  # type: ignore[arg-type]
    test = run_virtual_test(rig, 207e3, 5)
    sample = replace(SAMPLE, compliance=rig.compliance)
    found = fit_curve(reduce_record(as_record(test), sample))
    slip, friction, _, _ = rubber().parameters(207e3)
    assert found.parameters.peak_slip == pytest.approx(float(slip), rel=0.05)
    assert found.parameters.peak_friction == pytest.approx(float(friction), rel=0.02)
    assert found.parameters.lash == pytest.approx(0.5e-3, abs=0.08e-3)


def test_a_pre_load_is_slip_before_the_record_not_lash() -> None:
    found = fit(replace(RIG, lash=0.0, pre_load=0.4e-3))
    assert found.parameters.lash == pytest.approx(-0.4e-3, abs=0.03e-3)


def test_the_zero_of_the_force_is_found() -> None:
    found = fit(replace(RIG, force_zero=200.0))
    assert found.parameters.zero == pytest.approx(200.0 / (2 * 207e3 * 0.04), abs=3e-3)


@pytest.mark.parametrize("way", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_signs_of_travel_and_force_do_not_matter(way: tuple[int, int]) -> None:
    record = as_record(run_virtual_test(RIG, 207e3, 3))
    turned = replace(record, travel=0.3 + way[0] * record.travel, force=way[1] * record.force)
    found = fit_curve(reduce_record(turned, SAMPLE)).parameters.vector()
    np.testing.assert_allclose(found, fit().parameters.vector(), rtol=1e-6)


def test_line_and_level_past_an_interior_peak() -> None:
    found = fit(replace(RIG, law=FALLING, points=5000), 69e3)
    q = found.parameters
    assert found.peak_inside
    assert q.peak_slip == pytest.approx(5e-3, rel=0.02)
    assert q.post_peak_slope == pytest.approx(-16.0, rel=0.1)
    assert q.residual_friction == pytest.approx(1.33, rel=0.01)


def test_shear_left_in_or_taken_off() -> None:
    # A clean test of a shearing sample, its shear (h/G) tau taken off by hand (model 1.1),
    # is the independent computation.
    record = as_record(run_virtual_test(replace(RIG, law=single(0.8, 8e-3), noise=0.0), 207e3, 1))
    c = reduce_record(record, SAMPLE)
    assert c.bending == pytest.approx(COMPLIANCE * 207e3)
    by_hand = replace(record, travel=record.travel - COMPLIANCE * record.force / (2 * 0.04))
    off, left = fit_curve(c).parameters, fit_curve(c, bending=0.0).parameters
    hand = fit_curve(reduce_record(by_hand, replace(SAMPLE, shear_compliance=0.0))).parameters
    assert off.peak_slip == pytest.approx(8e-3, rel=1e-3)
    assert hand.peak_slip == pytest.approx(off.peak_slip, rel=2e-3)
    assert left.peak_slip > off.peak_slip + 0.8 * c.bending


def test_dense_readings_do_not_outvote_sparse_ones() -> None:
    # The same curve, every reading of the second half given five times: same law.
    record = as_record(run_virtual_test(replace(RIG, noise=0.0), 207e3, 1))
    index = np.sort(np.concatenate([np.arange(2000), np.repeat(np.arange(1000, 2000), 4)]))
    dense = replace(
        record, travel=record.travel[index], force=record.force[index], time=None,
        normal_force=None if record.normal_force is None else record.normal_force[index],
        lines=np.arange(len(index)),
    )  # fmt: skip
    one, other = (reduce_record(r, SAMPLE) for r in (record, dense))
    at = np.linspace(0.0, 15e-3, 400)
    np.testing.assert_allclose(
        np.interp(at, other.binned_travel, other.binned_friction),
        np.interp(at, one.binned_travel, one.binned_friction),
        atol=1e-3,
    )
    (few, many) = (fit_curve(c).parameters.vector()[:3] for c in (one, other))
    np.testing.assert_allclose(many, few, rtol=1e-3)


def test_the_papers_coefficients() -> None:
    found = fit(replace(RIG, noise=0.0))
    a, b = found.coefficients()
    slip = np.exp(b / a - 1.0)  # in mm
    assert slip * 1e-3 == pytest.approx(found.parameters.peak_slip, rel=1e-12)
    assert -a * slip == pytest.approx(found.parameters.peak_friction, rel=1e-12)
    x = 7.0
    expected = friction_and_slope(np.array([x * 1e-3]), found.parameters)[0][0]
    assert a * x * np.log(x) - b * x == pytest.approx(expected, rel=1e-12)


def test_errors_of_the_coefficients_are_those_of_draws() -> None:
    # Independent computation: A and b of draws of (ln x_pk, ln mu_pk).
    found = fit()
    draws = np.random.default_rng(1).multivariate_normal(
        [found.parameters.ln_peak_slip, found.parameters.ln_peak_friction],
        found.covariance[:2, :2],
        100_000,
    )
    a = -np.exp(draws[:, 1] - draws[:, 0]) * 1e-3
    b = a * (1.0 + draws[:, 0] - np.log(1e-3))
    np.testing.assert_allclose(found.coefficient_errors(), (a.std(), b.std()), rtol=0.02)


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    # A short run of benchmarks/shear_test_coverage.py: 120 intervals, 95 % of them +- 4 sigma.
    held = np.zeros(3)
    rig = replace(RIG, points=1500)
    slip, friction, _, _ = (float(v) for v in rubber().parameters(207e3))
    truth = (np.log(slip), np.log(friction), 0.5e-3)
    for seed in range(100, 140):
        found = fit(rig, 207e3, seed)
        for k, name in enumerate(("ln_peak_slip", "ln_peak_friction", "lash")):
            low, high = found.interval(name)
            held[k] += low <= truth[k] <= high
    assert np.all(held >= 40 * 0.95 - 4.0 * np.sqrt(40 * 0.95 * 0.05))
    assert held.sum() <= 119  # intervals that always hold are too wide


def test_five_points_differentiate_a_quartic_exactly() -> None:
    x = np.arange(20) * 0.1
    np.testing.assert_allclose(
        five_point_derivative(x**4 - x, 0.1), (4 * x**3 - 1)[2:-2], rtol=1e-9
    )


def test_the_derivative_of_the_curve_is_a_logarithm() -> None:
    found = fit(replace(RIG, noise=0.0))
    check = derivative_check(found)
    assert check is not None
    a, b = found.coefficients()
    assert check.a == pytest.approx(a, rel=0.03)
    assert check.b == pytest.approx(b, rel=0.03)
    assert check.r_squared > 0.995
    np.testing.assert_allclose(check.slope[3:], check.law[3:], rtol=0.02, atol=0.1)


def test_noise_level_of_white_noise_on_a_curve() -> None:
    x = np.linspace(0, 1, 20_000)
    noise = np.random.default_rng(2).normal(0.0, 0.03, len(x))
    assert noise_level(np.sin(3 * x) + noise) == pytest.approx(0.03, rel=0.03)


def test_spikes_go_and_stick_slip_stays() -> None:
    rng = np.random.default_rng(3)
    values = np.sin(np.linspace(0, 3, 3000)) + rng.normal(0, 0.01, 3000)
    values[[100, 1500, 2900]] += 0.5
    assert np.flatnonzero(~despiked(values)).tolist() == [100, 1500, 2900]
    swinging = values + np.where(np.arange(3000) % 20 < 4, 0.5, 0.0)
    assert despiked(swinging).all()


def test_correlated_noise_counts_for_fewer_readings() -> None:
    # For an AR(1) process the readings per independent one are (1 + rho)/(1 - rho).
    rng = np.random.default_rng(4)
    rho, noise = 0.8, np.zeros(20_000)
    for k, pulse in enumerate(rng.normal(size=len(noise) - 1), start=1):
        noise[k] = rho * noise[k - 1] + pulse
    assert inflation(noise) == pytest.approx(9.0, rel=0.2)
    assert inflation(rng.normal(size=20_000)) < 1.3
    assert correlation_length(rng.normal(size=20_000)) < 200


@pytest.mark.parametrize(
    ("freedom", "quantile"), [(1, 12.7062), (2, 4.3027), (4, 2.7764), (10, 2.2281), (120, 1.9799)]
)
def test_students_t(freedom: int, quantile: float) -> None:
    # Published: Abramowitz and Stegun, Handbook of Mathematical Functions, table 26.10, A = 0.95.
    assert t95(freedom) == pytest.approx(quantile, abs=1e-3)


def test_what_is_no_test_is_refused() -> None:
    record = as_record(run_virtual_test(RIG, 207e3, 1))
    few = slice(0, 2000, 250)

    def refused(sentence: str, sample: Sample = SAMPLE, **changes: object) -> None:
        with pytest.raises(InputError, match=sentence) as caught:
            reduce_record(replace(record, **changes), sample)  # type: ignore[arg-type]
        assert caught.value.problems[0].remedy

    refused("the travel does not advance", travel=np.full(2000, 3e-3))
    refused("only 4 usable readings, minimum 10", travel=1e-3 * np.sin(np.arange(2000.0)))
    refused("the force is zero throughout", force=np.zeros(2000))
    refused("has no normal force", normal_force=None)
    refused("the measured normal force is zero in places", normal_force=np.zeros(2000))
    refused("implausible travel", force=record.force * 1e9)
    refused(
        "usable readings, minimum", travel=record.travel[few], force=record.force[few],
        normal_force=record.normal_force[few] if record.normal_force is not None else None,
        lines=record.lines[few],
    )  # fmt: skip


def test_the_way_back_and_the_release_are_left_out() -> None:
    back = curve(replace(RIG, unloading=True))
    assert "rows of the way back" in back.notes[0]
    record = as_record(run_virtual_test(RIG, 207e3, 1))
    force = record.force.copy()
    force[-20:] = 5.0
    released = reduce_record(replace(record, force=force), SAMPLE)
    assert "20 rows after the force collapsed were left out" in released.notes


@pytest.mark.parametrize("freedom", [1.0, 1.5, 2.0, 3.5, 7.0, 19.5, 400.0])
def test_students_quantile_is_that_of_scipy(freedom: float) -> None:
    from scipy.special import stdtrit

    assert t95(freedom) == pytest.approx(float(stdtrit(freedom, 0.975)), rel=1e-8)
    assert t95(0.3) == t95(1.0)
