"""The law over pressure. Expected values: the known law behind virtual tests; closed forms."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from shear_test.virtual import PRESSURES, TRANSITION, fitted, laboratory, rubber
from wraparc.errors import InputError
from wraparc.files import lagging_from_text
from wraparc.files.write import lagging_text
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.shear_test import PressureOptions, TestPlan
from wraparc.shear_test.lack_of_fit import with_lack_of_fit
from wraparc.shear_test.law import knot_pressures
from wraparc.shear_test.pressure_fit import CurvePoints, fit_form
from wraparc.shear_test.pressure_form import LawForm, equations, ln_peaks
from wraparc.shear_test.transition import transition_interval
from wraparc.units import in_units

FEW = {"points": 400}
ENDS = (34e3, 690e3)


def condition(**rig: Any) -> Any:
    return fitted(*laboratory(**(FEW | rig))).conditions[0]


@pytest.fixture(scope="module")
def plain() -> Any:
    """Eight pressures, three repeats, 1 % noise, samples alike."""
    return condition(seed=4)


def test_the_law_is_found(plain: Any) -> None:
    slip, friction, _, _ = rubber().parameters(PRESSURES)
    found = np.exp(plain.fit.peaks(PRESSURES))
    np.testing.assert_allclose(found[:, 0], slip, rtol=0.02)
    np.testing.assert_allclose(found[:, 1], friction, rtol=0.02)


def test_the_transition_is_found_and_compared(plain: Any) -> None:
    transition = plain.found.transition
    assert transition.pressure == pytest.approx(TRANSITION, rel=0.10)
    low, high = transition_interval(plain.fit, plain.found.points)
    assert low < TRANSITION < high
    assert transition.in_law
    told = next(in_units(r) for r in plain.remarks if r.startswith("transition pressure about"))
    assert "95 %" not in told  # the interval is too narrow where samples scatter
    # E * roughness / thickness = 6.9 MPa * 0.3 / 12 = 172.5 kPa
    assert any(
        "the saturation estimate E * roughness / thickness is 172.5 kPa" in in_units(r)
        for r in plain.remarks
    )


def test_left_out_pressures_are_predicted(plain: Any) -> None:
    inside = [item for item in plain.found.left_out if item.inside]
    assert len(inside) == 6
    assert max(item.noise_levels for item in inside) < 2.0


def test_nothing_is_said_against_a_law_that_describes_its_tests(plain: Any) -> None:
    assert plain.misfit == ()


def test_the_lagging_has_the_law_its_covariance_and_its_range(plain: Any) -> None:
    lagging = plain.lagging
    law = lagging.law
    assert (law.tested.pressure_min, law.tested.pressure_max) == pytest.approx(ENDS, rel=1e-3)
    assert 13e-3 < law.tested.slip_max < 15e-3
    for pressure in (40e3, 172e3, 500e3):
        slips = np.linspace(0.5e-3, 13e-3, 20)
        np.testing.assert_allclose(
            law.friction(slips, pressure), rubber().friction(slips, pressure), rtol=0.01
        )
    fit = lagging.fit
    knots = law.coefficients.pressure
    assert fit.parameters[0] == "knots[1].peak_slip"
    assert len(fit.values) == 2 * len(knots)
    # Standard errors of the knots are those of the law there; at its corner they jump.
    own = plain.fit.peak_errors(np.array(knots)).T.ravel() * np.array(fit.values)
    smooth = np.tile(np.abs(np.array(knots) / plain.fit.transition_pressure - 1.0) > 1e-3, 2)
    assert (~smooth).sum() == 2
    errors = np.sqrt(np.diag(np.array(fit.covariance)))
    np.testing.assert_allclose(errors[smooth], own[smooth], rtol=1e-4)
    assert lagging_from_text(lagging_text(lagging)) == (lagging,)


def test_a_given_transition_is_kept() -> None:
    plan, records = laboratory(repeats=1, **FEW)
    plan = replace(plan, options=PressureOptions(transition_pressure=200e3, pieces=2))
    found: Any = fitted(plan, records).conditions[0]
    assert found.fit.transition_pressure == pytest.approx(200e3)
    assert "transition pressure, input: 200 kPa" in in_units(" ".join(found.remarks))


def test_one_piece_where_one_is_asked_for() -> None:
    plan, records = laboratory(repeats=1, **FEW)
    plan = replace(plan, options=PressureOptions(pieces=1))
    found: Any = fitted(plan, records).conditions[0]
    assert not found.fit.form.has_transition


def test_pieces_of_a_and_b() -> None:
    plan, records = laboratory(repeats=1, **FEW)
    plan = replace(plan, options=PressureOptions(variables="coefficients"))
    found: Any = fitted(plan, records).conditions[0]
    assert str(found.fit.form).startswith("A ")
    assert equations(found.fit.form, found.fit.theta, found.fit.ends)[0].startswith("A/(1/mm) = -")
    friction = found.lagging.law.friction(np.array([6e-3]), 207e3)
    assert friction[0] == pytest.approx(
        float(rubber().friction(np.array([6e-3]), 207e3)[0]), rel=0.03
    )


def test_one_pressure_gives_a_curve_and_says_so() -> None:
    found = condition(pressures=[207e3])
    assert found.fit is None
    assert found.lagging.law.coefficients.pressure == pytest.approx((207e3,), rel=1e-2)
    told = in_units(" ".join(found.remarks))
    assert "tested at 207 kPa only: the law does not depend on pressure" in told


def test_where_no_trend_will_do_each_pressure_has_its_value() -> None:
    p = tuple(PRESSURES.tolist())
    friction = (1.0, 1.4, 0.8, 1.3, 0.7, 1.1, 0.6, 0.9)
    law = IntegralLog(
        coefficients=PressureKnots(pressure=p, peak_friction=friction, peak_slip=(0.02,) * 8)
    )
    found = condition(law=law)
    assert found.fit.form.nodes
    np.testing.assert_allclose(np.exp(found.fit.peaks(PRESSURES)[:, 1]), friction, rtol=0.02)
    assert "no trend line follows the curves within their scatter" in " ".join(found.remarks)
    assert "left out, these pressures are missed by the law of the others" in " ".join(found.misfit)


values = st.floats(-3.0, 1.0)


@given(st.sampled_from(["linear", "logarithmic", "exponential", "power"]), st.data())
def test_the_law_is_positive_and_continuous_by_construction(trend: str, data: Any) -> None:
    form = LawForm((trend, "linear"), (trend, trend))
    theta = np.array([data.draw(values) for _ in range(6)] + [np.log(150e3)])
    p = np.array([34e3, 150e3 * (1 - 1e-9), 150e3 * (1 + 1e-9), 690e3])
    found, _ = ln_peaks(form, theta, ENDS, p)
    assert np.all(np.isfinite(found))
    np.testing.assert_allclose(found[1], found[2], atol=1e-6)
    np.testing.assert_allclose(found[[0, 1, 3], 0], theta[:3], atol=1e-6)
    np.testing.assert_allclose(found[[0, 1, 3], 1], theta[3:6], atol=1e-6)


@given(st.sampled_from(["linear", "logarithmic", "exponential", "power"]), st.data())
def test_the_jacobian_of_the_form_is_its_derivative(trend: str, data: Any) -> None:
    form = LawForm((trend, "power"), ("exponential", trend))
    theta = np.array([data.draw(values) for _ in range(6)] + [np.log(150e3)])
    p = np.array([40e3, 100e3, 200e3, 600e3])
    _, jacobian = ln_peaks(form, theta, ENDS, p)
    for k in range(7):
        step = np.zeros(7)
        step[k] = 1e-6
        ends = [ln_peaks(form, theta + s * step, ENDS, p)[0] for s in (1, -1)]
        np.testing.assert_allclose((ends[0] - ends[1]) / 2e-6, jacobian[:, :, k], atol=1e-4)


@pytest.mark.parametrize("trend", ["constant", "linear", "logarithmic", "exponential", "power"])
def test_the_printed_equations_are_the_law(trend: str) -> None:
    # Independent: the printed text, evaluated.
    form = LawForm((trend,), (trend,))
    theta = np.log([0.016, 0.9] if trend == "constant" else [0.016, 0.025, 1.3, 0.4])
    lines = equations(form, theta, ENDS)
    want = np.exp(ln_peaks(form, theta, ENDS, np.array([207e3]))[0][0])
    for line, value in zip(lines, (want[0] / 1e-3, want[1]), strict=False):
        text = line.split(" = ")[1].split("    ")[0]
        text = text.replace("e^(", "* np.exp(").replace("p^", "* p ** ").replace(" ln p", " * lnp")
        text = text.replace(" p", " * p") if "*" not in text else text.replace(" p)", " * p)")
        known = {"np": np, "p": 207.0, "lnp": np.log(207.0)}
        assert eval(text, known) == pytest.approx(value, rel=2e-4)  # noqa: S307 - our own text


def points(repeats: int, shift: float, seed: int = 1) -> CurvePoints:
    """Two straight pieces with scatter, one pressure in the middle shifted."""
    level = np.repeat(np.arange(8), repeats)
    p = PRESSURES[level]
    slip, friction, _, _ = rubber().parameters(p)
    rng = np.random.default_rng(seed)
    value = np.log(np.stack([slip, friction], axis=-1)) + 0.01 * rng.normal(size=(len(p), 2))
    value[level == 4, 1] += shift
    return CurvePoints(p, value, np.tile(1e-8 * np.eye(2), (len(p), 1, 1)), level)


def test_what_the_form_lacks_is_in_its_intervals() -> None:
    """Expected: 0.1 in one of eight pressures is 0.1**2/8 of variance, the rest next to none."""
    form = LawForm(("linear", "linear"), ("linear", "linear"))
    for shift, most in ((0.0, 0.01), (0.1, 0.05)):
        cloud = points(4, shift)
        law = fit_form(form, cloud, 1e-4 * np.eye(2), transition=TRANSITION)
        lacking = with_lack_of_fit(law, cloud, np.zeros(32, dtype=bool))
        more = (
            lacking.own_covariance(np.array([207e3]))[0] - law.own_covariance(np.array([207e3]))[0]
        )
        root = float(np.sqrt(max(more[1, 1], 0.0)))
        assert root < most
        if shift:
            assert root > 0.015
    alone = points(1, 0.1)
    law = fit_form(form, alone, 1e-4 * np.eye(2), transition=TRANSITION)
    lacking = with_lack_of_fit(law, alone, np.zeros(8, dtype=bool))  # no repeats to tell it
    assert lacking.lack is not None
    np.testing.assert_allclose(lacking.lack, 0.2 * law.scatter)


def test_covariances_have_no_negative_eigenvalue() -> None:
    """Also where a piece is next to undetermined: a transition beside the last pressure."""
    form = LawForm(("power",), ("logarithmic", "linear"))
    law = fit_form(form, points(3, 0.0), 4e-4 * np.eye(2), transition=None)
    law = replace(law, theta=np.append(law.theta[:-1], np.log(690e3 * (1 - 1e-9))))
    p = np.geomspace(34e3, 690e3, 13)
    whole = law.peak_covariance(p).transpose(2, 0, 3, 1).reshape(26, 26)
    scale = np.sqrt(np.diag(whole))
    assert np.linalg.eigvalsh(whole / np.outer(scale, scale))[0] > -1e-10


def test_the_covariance_of_the_law_is_that_of_its_parameters() -> None:
    """Expected: J C J' with the jacobian by differences."""
    form = LawForm(("linear", "linear"), ("linear", "exponential"))
    law = fit_form(form, points(3, 0.0), 1e-4 * np.eye(2))
    p = np.array([50e3, 150e3, 400e3])

    def peaks(theta: Any) -> Any:
        return ln_peaks(form, theta, law.ends, p)[0].ravel()

    steps = 1e-6 * np.eye(7)
    columns = [(peaks(law.theta + h) - peaks(law.theta - h)) / 2e-6 for h in steps]
    jacobian = np.stack(columns, axis=-1)
    wanted = jacobian @ law.covariance @ jacobian.T
    found = law.peak_covariance(p).transpose(0, 2, 1, 3).reshape(6, 6)
    np.testing.assert_allclose(found, wanted, rtol=1e-4, atol=1e-9)
    own = law.own_covariance(p)
    np.testing.assert_allclose(own[1], found[2:4, 2:4], rtol=1e-9)


def test_a_pressure_that_rounding_moves_off_an_end_is_no_knot_of_its_own() -> None:
    """Its law had two knots at one pressure, and a sound test was left out for it."""
    end = 30e3 * (1.0 + 1e-9)
    tails: Any = SimpleNamespace(pressure=np.array([end, 200e3]), slope=np.array([-2.0, -1.0]))
    fit: Any = SimpleNamespace(
        form=SimpleNamespace(nodes=()), ends=(30e3, 200e3), transition_pressure=None,
        peaks=lambda p: np.stack([np.log(p / 3e6), np.log(3e4 / p)], axis=-1),
    )  # fmt: skip
    assert np.all(np.diff(np.log(knot_pressures(fit, tails))) > 1e-4)


def test_no_test_can_be_used() -> None:
    plan, records = laboratory(pressures=[69e3], repeats=2, **FEW)
    broken = {k: replace(r, force=np.zeros_like(r.force)) for k, r in records.items()}
    with pytest.raises(InputError) as caught:
        fitted(plan, broken)
    assert len(caught.value.problems) == 2
    assert "the force is zero throughout" in str(caught.value)


def test_conditions_become_laws_of_one_lagging() -> None:
    dry, dry_records = laboratory(pressures=[69e3, 207e3], repeats=1, **FEW)
    wet, wet_records = laboratory(
        pressures=[69e3, 207e3], repeats=1, friction_factor=0.7, seed=2, **FEW
    )
    tests = [replace(t, file=f"w-{t.file}", condition="wet") for t in wet.tests]
    plan: TestPlan = replace(dry, tests=(*dry.tests, *tests))
    records = dry_records | {f"w-{k}": r for k, r in wet_records.items()}
    result = fitted(plan, records)
    assert [lagging.condition for lagging in result.laggings] == ["dry", "wet"]
    slips = np.array([5e-3])
    first, second = (lagging.law.friction(slips, 207e3)[0] for lagging in result.laggings)
    assert second / first == pytest.approx(0.7, rel=0.01)
    assert lagging_from_text(lagging_text(result.laggings)) == result.laggings
