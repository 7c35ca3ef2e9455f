"""Speed and temperature of the tests, told apart in laboratories whose effects are known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from shear_test.virtual import fitted, laboratory
from wraparc.files.lagging_file import lagging_from_text
from wraparc.files.write import lagging_text
from wraparc.shear_test import MachineRecord, TestPlan
from wraparc.shear_test.analysis import ConditionResult

SLOW, FAST = 10e-3 / 60, 100e-3 / 60
COLD, WARM = 293.15, 323.15
PRESSURES = (60e3, 120e3, 250e3)
Circumstance = tuple[float, float]  # speed [m/s], temperature [K]


def laboratory_at(
    circumstances: dict[tuple[int, int], Circumstance], exponent: float, per_kelvin: float
) -> tuple[TestPlan, dict[str, MachineRecord]]:
    """Forces times (v/v_0)^c and exp(k (T - T_0)), in the order pressure, repeat."""
    repeats = 1 + max(r for _, r in circumstances)
    plan, records = laboratory(repeats=repeats, pressures=PRESSURES, points=250, noise=3e-3)
    tests = []
    for test in plan.tests:
        place = (int(test.file[1]), int(test.file[3]))
        speed, temperature = circumstances[place]
        factor = (speed / SLOW) ** exponent * np.exp(per_kelvin * (temperature - COLD))
        record = records[test.file]
        time = np.abs(record.travel) / speed
        records[test.file] = replace(record, force=factor * record.force, time=time)
        tests.append(replace(test, speed=speed, temperature=temperature))
    return replace(plan, tests=tuple(tests)), records


def condition(
    circumstances: dict[tuple[int, int], Circumstance], exponent: float, per_kelvin: float
) -> ConditionResult:
    return fitted(*laboratory_at(circumstances, exponent, per_kelvin)).conditions[0]


def crossed(speeds: bool = True, warm: bool = True) -> dict[tuple[int, int], Circumstance]:
    """Every pressure slow and fast, cold and warm."""
    of = [(SLOW, COLD), (FAST if speeds else SLOW, COLD)]
    of += [(SLOW, WARM if warm else COLD), (FAST if speeds else SLOW, WARM if warm else COLD)]
    return {(k, r): of[r] for k in range(3) for r in range(4)}


def test_both_effects_come_back() -> None:
    """Truth: -6 % a decade of speed, -0.4 % a kelvin; the law is that of slow and cold tests."""
    exponent, per_kelvin = np.log(0.94) / np.log(10.0), -0.004
    found = condition(crossed(), exponent, per_kelvin)
    of = found.found.separated
    assert of.by_slip_speed is not None
    assert of.by_temperature is not None
    assert of.by_slip_speed.at == pytest.approx((SLOW, FAST))
    assert of.by_slip_speed.factor == pytest.approx((1.0, 0.94), rel=0.01)
    assert of.by_temperature.factor == pytest.approx((1.0, np.exp(-0.12)), rel=0.01)
    alone = condition(dict.fromkeys(crossed(), (SLOW, COLD)), 0.0, 0.0)
    at = np.array(PRESSURES)
    np.testing.assert_allclose(found.peaks_at(at)[1], alone.peaks_at(at)[1], rtol=0.01)
    assert found.misfit == ()


def test_the_lagging_keeps_them_and_uses_the_least() -> None:
    found = condition(crossed(), -0.03, -0.004)
    lagging = found.lagging
    assert lagging.factors is not None
    least = 10.0**-0.03 * np.exp(-0.12)
    ratio = lagging.law.friction(4e-3, 1e5) / lagging.factors.law.friction(4e-3, 1e5)
    assert ratio == pytest.approx(least, rel=0.015)
    assert lagging.law.tested is not None
    assert lagging.law.tested.slip_speed == pytest.approx(FAST)
    assert lagging_from_text(lagging_text(lagging)) == (lagging,)


def test_no_effect_is_found_where_there_is_none() -> None:
    of = condition(crossed(), 0.0, 0.0).found.separated
    assert of.by_slip_speed is None
    assert of.by_temperature is None
    assert sum("no effect of" in remark for remark in of.remarks) == 2


def test_what_changed_together_is_not_told_apart() -> None:
    """Fast tests warm, slow ones cold: the sum is known, the parts are not."""
    both = {(k, r): ((SLOW, COLD), (FAST, WARM))[r % 2] for k in range(3) for r in range(4)}
    of = condition(both, -0.03, -0.004).found.separated
    assert of.by_slip_speed is None
    assert of.by_temperature is None
    assert any("changed together" in remark for remark in of.remarks)


def test_a_speed_for_each_pressure_tells_nothing_of_speed() -> None:
    speeds = (SLOW, FAST, 3.0 * FAST)
    own = {(k, r): (speeds[k], COLD) for k in range(3) for r in range(2)}
    found = condition(own, -0.03, 0.0)
    assert found.found.separated.by_slip_speed is None
    assert any("what speed does is not known" in said for said in found.misfit)


def test_a_temperature_for_each_pressure_tells_nothing_of_temperature() -> None:
    own = {(k, r): (SLOW, (COLD, WARM, WARM)[k]) for k in range(3) for r in range(2)}
    of = condition(own, 0.0, -0.002).found.separated
    assert of.by_temperature is None
    assert any("no pressure was tested at more than one temperature" in r for r in of.remarks)
