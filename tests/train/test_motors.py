"""Motor characteristics against their formulas, and what they refuse."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest

from train.trains import RPM
from wraparc.errors import InputError
from wraparc.train import FluidCoupling, Induction, Motor, TorqueFollower, VariableSpeed

RATED: dict[str, Any] = {"rated_power": 300e3, "rated_speed": 1485 * RPM, "gear_ratio": 20.0}
MAINS: dict[str, Any] = RATED | {"synchronous_speed": 1500 * RPM, "breakdown_ratio": 2.5}
CURVE: dict[str, Any] = {
    "coupling_load": (0.0, 0.5, 1.0, 1.5),
    "coupling_slip": (0.0, 0.012, 0.025, 0.045),
}
MOTORS: list[Motor] = [
    VariableSpeed(**RATED, droop=0.02),
    VariableSpeed(**RATED, droop=0.01, torque_limit=1.6, setting=0.8),
    Induction(**MAINS),
    FluidCoupling(**MAINS, **CURVE),
]


@pytest.mark.parametrize("load", [-2.4, -1.0, -0.1, 0.0, 0.3, 1.0, 2.2, 2.5])
def test_kloss(load: float) -> None:
    """M/M_b = 2/(s/s_b + s_b/s), s below s_b; s_b = s_r (k + sqrt(k^2 - 1)), k = M_b/M_r."""
    motor = Induction(**MAINS)
    slip = 1.0 - motor.shaft_speed(load) / (1500 * RPM)
    most = 0.01 * (2.5 + math.sqrt(2.5**2 - 1.0))
    assert abs(slip) <= most * (1.0 + 1e-12)
    if load == 0.0:
        assert slip == 0.0
    else:
        assert 2.5 * 2.0 / (slip / most + most / slip) == pytest.approx(load, rel=1e-9)


def test_rated_points() -> None:
    assert Induction(**MAINS).shaft_speed(1.0) == pytest.approx(1485 * RPM, rel=1e-12)
    assert VariableSpeed(**RATED, droop=0.02).shaft_speed(1.0) == pytest.approx(0.98 * 1485 * RPM)
    assert VariableSpeed(**RATED, setting=1.01).shaft_speed(0.7) == pytest.approx(1.01 * 1485 * RPM)
    coupled = FluidCoupling(**MAINS, **CURVE)
    # at rated torque the pump turns at rated speed, and the curve is read as it stands
    assert coupled.shaft_speed(1.0) == pytest.approx(1485 * RPM * 0.975, rel=1e-12)


def test_a_coupling_goes_with_the_square_of_its_pump_speed() -> None:
    coupled = FluidCoupling(**MAINS, **CURVE)
    pump = Induction(**MAINS).shaft_speed(0.5)
    on_curve = 0.5 * (1485 * RPM / pump) ** 2
    slip = on_curve / 0.5 * 0.012
    assert coupled.shaft_speed(0.5) == pytest.approx(pump * (1.0 - slip), rel=1e-12)
    end = coupled.largest_load()
    pump = Induction(**MAINS).shaft_speed(end)
    assert end * (1485 * RPM / pump) ** 2 == pytest.approx(1.5, rel=1e-12)


@pytest.mark.parametrize("motor", MOTORS)
def test_speed_falls_as_torque_rises(motor: Motor) -> None:
    """Also beyond the ends of the curve, where a solver may pass through."""
    torques = [motor.drum_torque * 0.02 * k for k in range(-200, 201)]
    speeds = [motor.drum_speed(t) for t in torques]
    assert all(a > b for a, b in pairwise(speeds))
    low, high = motor.limits()
    assert low == -high == -motor.largest_load()


def test_gear_losses_go_with_the_flow_of_power() -> None:
    motor = VariableSpeed(**RATED, gear_efficiency=0.9, count=2)
    full = 2 * 20.0 * 300e3 / (1485 * RPM)
    assert motor.drum_torque == pytest.approx(full)
    assert motor.load(full) == pytest.approx(1.0 / 0.9)
    assert motor.load(-full) == pytest.approx(-0.9)
    assert VariableSpeed(**RATED, brakes=False).limits() == (0.0, math.inf)


@pytest.mark.parametrize(
    ("make", "key", "complaint"),
    [
        (lambda: VariableSpeed(**RATED | {"rated_power": 0.0}), "rated_power", "more than 0"),
        (lambda: VariableSpeed(**RATED, droop=0.9), "droop", "between 0"),
        (lambda: VariableSpeed(**RATED, count=0), "count", "between 1"),
        (
            lambda: Induction(**MAINS | {"rated_speed": 1500 * RPM}),
            "rated_speed",
            "must be below the synchronous speed 1500 rpm by at most 20 %",
        ),
        (
            lambda: FluidCoupling(**MAINS, coupling_load=(0.0, 1.0), coupling_slip=(0.0,)),
            "coupling_slip",
            "as many torques as slips",
        ),
        (
            lambda: FluidCoupling(
                **MAINS, coupling_load=(0.0, 1.0, 0.5), coupling_slip=(0.0, 0.01, 0.02)
            ),
            "coupling_load",
            "must rise from 0",
        ),
        (lambda: TorqueFollower(master="a", ratio=99.0), "ratio", "between"),
    ],
)
def test_what_is_no_motor(make: Any, key: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint) as caught:
        make()
    assert key in {problem.key for problem in caught.value.problems}


def test_a_part_of_a_motor_is_none() -> None:
    with pytest.raises(InputError, match=r"count: must be a whole number of motors, got 1\.5"):
        Induction(**MAINS, count=1.5)  # type: ignore[arg-type]
