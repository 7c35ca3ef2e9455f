"""No false OK and no false ATTENTION: known laws and known faults behind virtual laboratories."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import PRESSURES, as_record, fitted, laboratory, single
from wraparc.answer.shear_test_tables import verdict
from wraparc.answer.sheet import shown as told_in
from wraparc.checks import Level
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.shear_test import (
    MachineRecord,
    PlanResult,
    Sample,
    TestPlan,
    VirtualRig,
    reduce_record,
    run_virtual_test,
)
from wraparc.shear_test.correlation import noise_kernel
from wraparc.shear_test.curve_fit import fit_curve
from wraparc.units import in_units

SCATTERED = {"points": 250, "scatter_friction": 0.02, "scatter_slip": 0.03}
SMALL = PRESSURES[[0, 2, 4, 6]]


def smooth() -> IntegralLog:
    """Powers of pressure, without any corner."""
    p = np.round(np.geomspace(PRESSURES[0], PRESSURES[-1], 60), 3)
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=tuple(p.tolist()),
            peak_friction=tuple((1.25 * (p / p[0]) ** -0.3).tolist()),
            peak_slip=tuple((0.010 * (p / p[0]) ** 0.15).tolist()),
        )
    )


def scattered(**options: Any) -> tuple[TestPlan, dict[str, MachineRecord]]:
    return laboratory(**(SCATTERED | options))


@cache
def sound(seed: int, repeats: int) -> PlanResult:
    return fitted(
        *scattered(seed=seed, repeats=repeats, pressures=PRESSURES if repeats == 1 else SMALL)
    )


def test_a_sound_laboratory_is_not_accused() -> None:
    """A limit of two noise levels for left-out pressures accused this one."""
    assert told_in(verdict(sound(4, 2)), "si").level is Level.OK


def test_a_pressure_that_the_others_miss_is_named() -> None:
    """Expected: the shift of 35 % at one pressure of eight, both repeats, is far over chance."""
    plan, records = scattered(seed=1, repeats=2)
    for name in ("p3r0", "p3r1"):
        records[name] = replace(records[name], force=1.35 * records[name].force)
    found = fitted(plan, records)
    missed = [
        round(item.pressure, -3) for item in found.conditions[0].found.left_out if item.missed
    ]
    assert 138e3 in missed
    assert told_in(verdict(found), "si").level is Level.ATTENTION
    assert "standard deviations where chance reaches" in " ".join(found.conditions[0].misfit)


def test_three_pressures_cannot_tell_the_error_of_their_predictions() -> None:
    found = fitted(*scattered(seed=1, repeats=2, pressures=SMALL[:3])).conditions[0].found
    assert all(np.isnan(item.distance) and not item.missed for item in found.left_out)


def test_a_smooth_law_shows_no_transition() -> None:
    found: Any = fitted(*scattered(seed=2, repeats=2, law=smooth())).conditions[0]
    assert found.found.choice.two_pieces is not None
    assert found.found.transition is None
    assert any(
        r.startswith("no transition is shown: a smooth law does as well") for r in found.remarks
    )


def shifted(factor: float, name: str, load: float = 1.0, **options: Any) -> PlanResult:
    """A small laboratory with one test whose pull, or whose typed pressure, is off by a factor."""
    plan, records = scattered(**({"repeats": 2, "pressures": SMALL} | options))
    record = records[name]
    assert record.normal_force is not None
    records[name] = replace(
        record, force=factor * record.force, normal_force=load * record.normal_force
    )
    tests = [
        replace(test, pressure=load * test.pressure)
        if test.file == name and test.pressure
        else test
        for test in plan.tests
    ]
    return fitted(replace(plan, tests=tuple(tests)), records)


@pytest.mark.parametrize("pressures", [SMALL[:3], SMALL])
@pytest.mark.parametrize("factor", [0.5, 0.71])
def test_a_test_at_half_its_friction_is_no_ok(pressures: Any, factor: float) -> None:
    found = shifted(factor, "p1r1", seed=1, pressures=pressures)
    assert told_in(verdict(found), "si").level is Level.ATTENTION


@pytest.mark.parametrize(("name", "load", "asked"), [("p3r1", 0.1, 414.0), ("p0r0", 10.0, 34.0)])
def test_a_pressure_typed_ten_times_off_is_asked_about(
    name: str, load: float, asked: float
) -> None:
    found = shifted(1.0, name, load, seed=2, law=smooth())
    told = in_units(" ".join([*map(str, found.left_out), *found.conditions[0].misfit]))
    if found.left_out:
        assert "if its pressure or normal force were 10 times as large" in told
    else:
        assert f"({name}): was its pressure {asked:.3g} kPa, not {load * asked:.4g} kPa?" in told
    assert told_in(verdict(found), "si").level is Level.ATTENTION


def test_a_pull_in_another_unit_within_the_limits_is_asked_about() -> None:
    """Expected: 4.448 times smaller, as if lbf had been read as N."""
    found = shifted(1 / 4.448222, "p1r0", seed=1).conditions[0]
    assert any("if its force were 4.45 times as large" in sentence for sentence in found.misfit)


def test_sound_tests_are_not_asked_about() -> None:
    assert not any("would fit" in s for s in sound(4, 2).conditions[0].misfit)


def test_tests_of_different_speeds_are_no_repeats() -> None:
    """12 % more friction at 50 times the speed is taken off, not taken for scatter."""
    plan, records = scattered(seed=1, repeats=2, pressures=SMALL)
    tests = []
    for test in plan.tests:
        fast = test.file.endswith("r1")
        record = records[test.file]
        assert record.time is not None
        if fast:  # 50 times as fast, and 12 % more friction
            records[test.file] = replace(record, force=1.12 * record.force, time=record.time / 50)
        tests.append(replace(test, speed=10e-3 / 60 if not fast else None))
    found = fitted(replace(plan, tests=tuple(tests)), records)
    of = found.conditions[0].found
    assert of.separated.by_slip_speed is not None
    assert of.separated.by_slip_speed.factor == pytest.approx((1.0, 1.12), abs=0.05)
    assert not any("share one law" in s for s in found.conditions[0].misfit)
    assert any("from 10 mm/min to 500 mm/min friction changes by +1" in in_units(remark)
               for remark in found.conditions[0].remarks)  # fmt: skip
    assert not of.flagged.any()
    said = replace(plan, tests=tuple(replace(test, speed=10e-3 / 60) for test in plan.tests))
    wrong = fitted(said, records).conditions[0].misfit
    assert sum("time and travel of the file say 500 mm/min" in in_units(s) for s in wrong) == 4


def test_a_zero_that_the_record_does_not_show_is_said_and_in_the_interval() -> None:
    """Expected: the 2 % of the largest force that are taken for it, through the fit itself."""
    plan, records = scattered(seed=1, pressures=[207e3], lash=0.0)
    kept = fitted(plan, records).conditions[0]
    offset = {
        name: replace(record, force=record.force + 0.02 * record.force.max())
        for name, record in records.items()
    }
    moved = fitted(plan, offset).conditions[0]
    for before, after in zip(kept.tests, moved.tests, strict=True):
        assert before.curve.zero_unknown == pytest.approx(
            0.02 * before.curve.friction.max(), rel=0.1
        )
        change = after.fit.parameters.ln_peak_friction - before.fit.parameters.ln_peak_friction
        assert before.fit.error("ln_peak_friction") > 0.6 * abs(change)
    assert any("cannot be verified" in remark for remark in kept.remarks)
    flat = fitted(*scattered(seed=1, pressures=[207e3])).conditions[0]
    assert not any("cannot be verified" in remark for remark in flat.remarks)
    error = [c.tests[0].fit.error("ln_peak_friction") for c in (flat, kept)]
    assert error[1] > 2.0 * error[0]


def test_half_the_peak_is_not_taken_for_a_zero() -> None:
    """Expected: friction 1.33 at the peak, of which 0.6 stands before the slip starts."""
    plan, records = scattered(
        seed=1, repeats=1, pressures=[69e3], scatter_friction=0.0, noise=0.002,
        law=single(0.73, 8e-3),
    )  # fmt: skip
    record = records["p0r0"]
    records["p0r0"] = replace(record, force=record.force + 0.6 * 2.0 * 69e3 * 0.04)
    (test,) = fitted(plan, records).conditions[0].tests
    low, high = test.fit.interval("peak_friction")
    assert low < 1.33 < high
    assert low > 0.5
    (told,) = (s.text for s in test.judged.misfit if s.about == "rubbing")
    assert told.startswith("before the slip starts the force is 45 % of its maximum")
    assert "nothing was taken off" in told


def test_what_a_usual_compliance_would_do_is_computed() -> None:
    """Expected: the peak slip of the same laboratory, fitted with that compliance."""
    plan, records = scattered(seed=1, repeats=1, pressures=SMALL[:2])
    remarks = in_units(" ".join(fitted(plan, records).conditions[0].remarks))
    given = fitted(replace(plan, rig=replace(plan.rig, compliance=0.05e-6)), records).conditions[0]
    slip = given.tests[-1].fit.parameters.peak_slip * 1e3
    assert f"would put the peak slip at 103 kPa at {slip:.3g} mm instead of" in remarks
    assert "compliance" not in in_units(" ".join(given.remarks))


def test_a_remainder_is_judged_by_noise_and_by_size() -> None:
    """A wave of 1.5 % under noise of 0.1 % stood under "within their noise" once."""
    plan, records = scattered(seed=1, repeats=1, pressures=[207e3], points=1500, noise=0.001)
    quiet = fitted(plan, records)
    assert "noise levels" in told_in(verdict(quiet), "si").sentences[0]
    record = records["p0r0"]
    wave = 1.0 + 0.04 * np.sin(record.travel / record.travel[-1] * 20.0)
    records["p0r0"] = replace(record, force=record.force * wave)
    found = fitted(plan, records)
    assert told_in(verdict(found), "si").level is Level.ATTENTION
    (told,) = (s for s in found.conditions[0].misfit if "systematic remainder" in s)
    assert "% of the maximum friction (" in told
    assert "noise levels)" in told


def test_a_law_that_is_hardly_known_is_no_ok() -> None:
    found = shifted(0.4, "p1r0", seed=1, repeats=1, pressures=SMALL[:3])
    assert told_in(verdict(found), "si").level is Level.ATTENTION


@pytest.mark.parametrize("memory", [9.5, 0.0])
def test_intervals_of_curves_hold_the_truth_in_correlated_noise(memory: float) -> None:
    """Expected: 95 of 100. Of 40 curves at least 34 (p = 0.01); 61 % before, of memory 9.5."""
    rig = VirtualRig(law=single(0.9, 10e-3), points=300, correlation=memory)
    held = []
    for seed in range(20):
        drawn = as_record(run_virtual_test(rig, 138e3, seed))
        fit = fit_curve(reduce_record(drawn, Sample(area=0.04)))
        for name, truth in (("peak_slip", 10e-3), ("peak_friction", 0.9)):
            low, high = fit.interval(name)
            held.append(low <= truth <= high)
    assert sum(held) >= 34


def test_the_memory_of_noise_is_found_under_the_fit() -> None:
    """Expected: the sum of a first-order autoregression's covariances, rho^distance."""
    rng = np.random.default_rng(1)
    rho, count = 0.9, 4000
    noise = np.zeros(count)
    for k in range(1, count):
        noise[k] = rho * noise[k - 1] + np.sqrt(1.0 - rho**2) * rng.normal()
    design = np.vander(np.linspace(-1.0, 1.0, count), 4)
    residual = noise - design @ np.linalg.lstsq(design, noise, rcond=None)[0]
    kernel = noise_kernel(residual, design)
    assert kernel is not None
    total = (1.0 + rho) / (1.0 - rho)  # readings that tell no more than one
    assert 0.8 * total < 2.0 * kernel.sum() - kernel[0] < 1.5 * total
    assert noise_kernel(rng.normal(size=count), design) is None
