"""Speeds, diameters, motors and runs: limits, identities, and one against the other.

Expected values: closed forms where stated, otherwise the same train asked another way round.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from train.trains import (
    QUICK,
    RPM,
    STEEL,
    case,
    held,
    pulleys,
    random_train,
    solved,
    train,
    tried,
)
from wraparc.drive import Belt
from wraparc.errors import BreakawayError, InputError
from wraparc.train import (
    FluidCoupling,
    Induction,
    Motors,
    Shares,
    Speeds,
    TorqueFollower,
    Train,
    TrainStatus,
    VariableSpeed,
    solve_train,
)

DRIVE = VariableSpeed(rated_power=300e3, rated_speed=1485 * RPM, gear_ratio=20.0)
DROOPING = replace(DRIVE, droop=0.01)
MAINS = Induction(
    rated_power=300e3, rated_speed=1485 * RPM, synchronous_speed=1500 * RPM, gear_ratio=20.0
)
COUPLED = FluidCoupling(
    rated_power=300e3,
    rated_speed=1485 * RPM,
    synchronous_speed=1500 * RPM,
    gear_ratio=20.0,
    coupling_load=(0.0, 0.5, 1.0, 1.5),
    coupling_slip=(0.0, 0.012, 0.025, 0.045),
)
RANDOM_LAWS = ["rubber", "softening", "pieces", "table", "constant", "power", "elastic-plastic"]


@pytest.mark.parametrize("law", RANDOM_LAWS)
def test_random_trains_there_and_back(law: str) -> None:
    """Shares to speeds to shares, with drives that brake among them."""
    rng = np.random.default_rng([11, RANDOM_LAWS.index(law)])
    done = 0
    while done < 4:
        of = random_train(rng, law, int(rng.integers(2, 5)))
        asked = tried(of)
        if not asked.status.solved:
            continue
        back = solved(held(of, asked))
        assert back.shares == pytest.approx(asked.shares, abs=1e-8)
        assert back.tension_error < 1e-10
        assert back.speed_error < 1e-9
        done += 1


def test_speeds_in_rpm_set_the_belt_speed() -> None:
    of = pulleys(2)
    relative = solved(train(of, case(Speeds((1.0, 0.998)))))
    absolute = solved(train(of, case(Speeds((70 * RPM, 69.86 * RPM), absolute=True))))
    assert absolute.shares == pytest.approx(relative.shares, abs=1e-10)
    assert relative.belt_speed == 3.0
    for m, rpm in zip(absolute, (70.0, 69.86), strict=True):
        assert m.rotation_speed == pytest.approx(rpm * RPM, rel=1e-12)
    first = absolute.members[0]
    assert absolute.belt_speed == pytest.approx(
        first.surface_speed * (1.0 - first.arc.entry_creep_ratio), rel=1e-12
    )


def test_a_worn_drum_at_equal_speed_is_a_slower_one() -> None:
    """A diameter 0.2 % smaller moves the share about as a trim of -0.2 % does."""
    of = pulleys(2)
    worn = (of[0], replace(of[1], diameter=0.8 * 0.998))
    by_diameter = solved(train(worn, case(Speeds((1.0, 1.0))), nominal=(0.8, 0.8)))
    by_trim = solved(train(of, case(Speeds((1.0, 0.998)))))
    assert by_diameter["p2"].share == pytest.approx(by_trim["p2"].share, abs=2e-3)
    assert by_diameter["p2"].share != by_trim["p2"].share
    assert by_diameter["p2"].speed_trim == pytest.approx(1.0, abs=1e-12)
    unworn = solved(train(of, case(Speeds((1.0, 1.0)))))
    assert by_diameter["p2"].share < unworn["p2"].share - 0.1


def test_drives_that_hold_their_speed_are_speeds() -> None:
    of = pulleys(3)
    motors = Motors((DRIVE, replace(DRIVE, setting=0.999), replace(DRIVE, setting=1.001)))
    by_motor = solved(train(of, case(motors)))
    speed = DRIVE.rated_speed / 20.0
    by_speed = solved(train(of, case(Speeds((speed, 0.999 * speed, 1.001 * speed), True))))
    assert by_motor.shares == pytest.approx(by_speed.shares, abs=1e-10)
    assert by_motor.belt_speed == pytest.approx(by_speed.belt_speed, rel=1e-12)


@pytest.mark.parametrize("motor", [DROOPING, MAINS, COUPLED])
def test_motors_work_on_their_curves(motor: VariableSpeed | Induction) -> None:
    of = pulleys(2)
    result = solved(train(of, case(Motors((motor, motor)))))
    assert result.speed_error < 1e-9
    for m in result:
        assert m.motor is not None
        assert m.rotation_speed == pytest.approx(motor.drum_speed(m.drum_torque), rel=1e-9)
        assert m.motor.motor_load == pytest.approx(m.drum_torque / (20.0 * motor.rated_torque))
        assert m.motor.motor_power == pytest.approx(m.drum_power + m.motor.losses, rel=1e-9)
        assert (m.motor.coupling_loss > 0.0) is (motor is COUPLED)
        assert m.motor.motor_loss != m.motor.motor_loss  # no efficiency was given
    # give evens the shares out
    rigid = solved(train(of, case(Speeds((1.0, 1.0)))))
    assert 0.5 < result["p2"].share < rigid["p2"].share
    assert abs(result.sensitivity[1][1]) < abs(rigid.sensitivity[1][1])


def test_much_droop_shares_by_rated_torque() -> None:
    """Where droop is large beside all creep, torques go with ratings: 2 to 1."""
    strong = VariableSpeed(rated_power=400e3, rated_speed=1485 * RPM, gear_ratio=20.0, droop=0.3)
    weak = replace(strong, rated_power=200e3)
    result = solved(train(pulleys(2), case(Motors((strong, weak)))))
    assert result.shares == pytest.approx((2 / 3, 1 / 3), abs=0.01)


@pytest.mark.parametrize("ratio", [-0.2, 0.0, 0.5, 1.0, 2.0])
@pytest.mark.parametrize("leads", [0, 1])
@pytest.mark.parametrize("master", [DRIVE, DROOPING])
def test_a_torque_follower(ratio: float, leads: int, master: VariableSpeed) -> None:
    """Two drives: torques in a ratio, so that the pulls follow by hand."""
    follower = TorqueFollower(master=f"p{leads + 1}", ratio=ratio)
    motors = (master, follower) if leads == 0 else (follower, master)
    result = solved(train(pulleys(2), case(Motors(motors))))
    torques = [m.drum_torque for m in result]
    assert torques[1 - leads] == pytest.approx(ratio * torques[leads], rel=1e-9, abs=1e-3)
    assert sum(m.arc.effective_tension for m in result) == pytest.approx(100e3, rel=1e-9)
    assert result.members[1 - leads].motor is None
    assert result.sensitivity[0][1 - leads] == 0.0


def test_followers_among_several() -> None:
    motors = Motors(
        (
            TorqueFollower(master="p3"),
            TorqueFollower(master="p4", ratio=0.5),
            DRIVE,
            DROOPING,
        )
    )
    result = solved(train(pulleys(4), case(motors)))
    torques = [m.drum_torque for m in result]
    assert torques[0] == pytest.approx(torques[2], rel=1e-8)
    assert torques[1] == pytest.approx(0.5 * torques[3], rel=1e-8)
    assert result.speed_error < 1e-9


def test_gears_and_counts() -> None:
    geared = replace(DROOPING, gear_efficiency=0.95, count=2, rated_power=150e3)
    one = replace(DROOPING, gear_efficiency=0.95)
    of = pulleys(2)
    both = solved(train(of, case(Motors((geared, geared)))))
    single = solved(train(of, case(Motors((one, one)))))
    assert both.shares == pytest.approx(single.shares, abs=1e-10)
    for m, s in zip(both, single, strict=True):
        assert m.motor is not None
        assert s.motor is not None
        assert m.motor.motor_power == pytest.approx(m.drum_power / (2 * 0.95), rel=1e-9)
        assert m.motor.motor_load == pytest.approx(s.motor.motor_load, rel=1e-9)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_power_from_the_mains_to_the_drum(way: float) -> None:
    """Pump and turbine apart; all that is lost on the way sums up, driving and holding back."""
    motor = replace(COUPLED, gear_efficiency=0.95, motor_efficiency=0.9)
    tensions = (150e3, 50e3) if way > 0.0 else (50e3, 150e3)
    result = solved(train(pulleys(2), case(Motors((motor, motor)), *tensions)))
    for m in result:
        at = m.motor
        assert at is not None
        pump = Induction.shaft_speed(motor, at.motor_load)  # Kloss, whatever the coupling
        assert at.motor_speed == pytest.approx(pump, rel=1e-12)
        assert at.gear_speed == pytest.approx(m.rotation_speed * 20.0, rel=1e-12)
        assert (at.motor_speed > at.gear_speed) is (way > 0.0)
        slip = at.motor_torque * (pump - 20.0 * m.rotation_speed)
        assert at.coupling_loss == pytest.approx(slip, rel=1e-12)
        assert min(at.coupling_loss, at.gear_loss, at.motor_loss) > 0.0
        share = 0.9 if way > 0.0 else 1.0 / 0.9
        assert at.motor_power == pytest.approx(at.electrical_power * share, rel=1e-12)
        assert at.electrical_power == pytest.approx(m.drum_power + at.losses, rel=1e-9)
    assert result.motor_losses == pytest.approx(sum(m.motor.losses for m in result if m.motor))


@pytest.mark.parametrize("run", [-8e3, 12e3])
def test_a_run_between_drives_changes_the_tension(run: float) -> None:
    of = pulleys(2)
    result = solved(train(of, case(Shares((0.5, 0.5)), runs=(run,))))
    first, second = (m.arc for m in result)
    assert second.entry_tension == pytest.approx(first.exit_tension + run, rel=1e-15)
    assert first.effective_tension == pytest.approx(0.5 * (100e3 + run), rel=1e-12)
    stiffness = 1.2 * 12.96e6
    contraction = -(first.entry_tension - second.entry_tension) / stiffness
    assert result["p2"].contraction_term == pytest.approx(contraction, rel=1e-12)
    back = solved(held(train(of, case(Shares((0.5, 0.5)), runs=(run,))), result))
    assert back.shares == pytest.approx((0.5, 0.5), abs=1e-9)


@pytest.mark.parametrize(
    ("law", "overrun"),
    [("rubber", None), ("rubber", 0.0), ("softening", None), ("constant", 0.0)],
)
def test_driving_turns_to_braking_smoothly(law: str, overrun: float | None) -> None:
    """As the trim falls the share of drive 2 passes through 0 without a step."""
    of = pulleys(2, law, overrun=overrun)
    first = solved(train(of, case(Shares((1.0, 0.0)))))
    start = first["p2"].speed_trim
    shares = []
    for step in np.linspace(-2e-4, 2e-4, 5):
        result = solved(train(of, case(Speeds((1.0, start + float(step))))))
        shares.append(result["p2"].share)
        assert result.tension_error < 1e-10
    assert shares[2] == pytest.approx(0.0, abs=1e-8)
    steps = np.diff(shares)
    assert np.all(steps > 0.0)
    assert steps.max() < 4.0 * steps.min()


def test_one_brakes_while_another_drives() -> None:
    result = solved(train(pulleys(2), case(Shares((1.3, -0.3)), 150e3, 60e3)))
    assert result["p2"].arc.effective_tension == pytest.approx(-27e3)
    assert result["p2"].arc.arc.side == -1.0
    back = solved(held(train(pulleys(2), case(Shares((1.3, -0.3)), 150e3, 60e3)), result))
    assert back.shares == pytest.approx((1.3, -0.3), abs=1e-9)


def test_a_train_that_brakes_as_a_whole() -> None:
    of = train(pulleys(2), case(Shares((0.5, 0.5)), 60e3, 150e3))
    result = solved(of)
    assert all(m.arc.arc.side == -1.0 for m in result)
    assert solved(held(of, result)).shares == pytest.approx((0.5, 0.5), abs=1e-9)


def test_nothing_to_share() -> None:
    """Equal tensions at both ends: speeds decide whether drives pull against each other."""
    result = solved(train(pulleys(2), case(Speeds((1.0, 1.001)), 90e3, 90e3)))
    pulls = [m.arc.effective_tension for m in result]
    assert pulls[0] == pytest.approx(-pulls[1], rel=1e-9)
    assert pulls[1] > 1e3
    assert all(math.isnan(m.share) for m in result)


def test_ten_drives_of_mixed_laggings() -> None:
    laws = ["rubber", "softening", "table", "pieces", "rubber"] * 2
    of = tuple(
        replace(pulleys(1, law, diameter=1.0)[0], name=f"p{i}") for i, law in enumerate(laws)
    )
    asked = train(of, case(Shares((0.1,) * 10), 400e3, 60e3), belt=STEEL)
    result = solved(asked)
    back = solved(held(asked, result))
    assert back.shares == pytest.approx(result.shares, abs=1e-8)
    assert back.tension_error < 1e-10


def test_a_drum_faster_than_its_motor_allows() -> None:
    slow = replace(DROOPING, gear_ratio=20.6, brakes=False)
    failed = tried(train(pulleys(2), case(Motors((DROOPING, slow)))))
    assert failed.status is TrainStatus.BEYOND_MOTOR
    assert failed.reason == (
        "The belt drives pulley p2 at 72.20 rpm, faster than its motor allows: 72.09 rpm at "
        "most, where it cannot brake."
    )
    with pytest.raises(InputError, match="faster than its motor allows"):
        solve_train(train(pulleys(2), case(Motors((DROOPING, slow)))), method=QUICK)
    # one that can hold back does so
    braking = solved(train(pulleys(2), case(Motors((DROOPING, replace(slow, brakes=True))))))
    assert braking["p2"].share < 0.0


def test_a_motor_asked_for_more_than_it_has() -> None:
    small = replace(MAINS, rated_power=30e3)
    failed = tried(train(pulleys(2), case(Motors((small, small)))))
    assert failed.status is TrainStatus.BEYOND_MOTOR
    assert failed.reason.startswith("The motor of p1 needs")
    assert "its curve ends at 2.5; its pulley turns at" in failed.reason


def test_shares_beyond_friction_name_the_drive() -> None:
    with pytest.raises(BreakawayError, match=r"load case full: Gross slip on p2") as caught:
        solve_train(
            train(pulleys(2, "constant", overrun=0.0), case(Shares((0.05, 0.95)), 150e3, 30e3)),
            method=QUICK,
        )
    assert caught.value.result.cases[0].status is TrainStatus.BREAKAWAY


def test_a_drum_that_slides_as_much_as_it_can_has_no_speed() -> None:
    """The second drum moves no belt at an entry creep ratio of 1: its speeds are not known."""
    result = tried(train(pulleys(2), case(Shares((0.5, 0.5)), exit_=2e3)))
    assert result.status is TrainStatus.BREAKAWAY
    assert math.isnan(result["p2"].speed_ratio)
    assert math.isnan(result["p2"].surface_speed)


def test_many_load_cases() -> None:
    of = pulleys(2)
    cases = tuple(
        case(Shares((0.5, 0.5)), 60e3 + 10e3 * i, 50e3, name=f"case {i}") for i in range(5)
    )
    result = solve_train(train(of, *cases), method=QUICK)
    assert [c.case.name for c in result] == [c.name for c in cases]
    assert result.solved
    assert result.governing.case.name == "case 4"
    assert result["case 2"].members[0].arc.entry_tension == 80e3
    arcs = result.drive_result()
    assert len(arcs) == 10
    assert arcs.arc("p2", "case 3") is result["case 3"]["p2"].arc
    with pytest.raises(KeyError):
        result["case 9"]


def test_a_drive_with_tensions_is_a_train() -> None:
    from wraparc.drive import Drive, LoadCase, Tensions

    of = pulleys(2)
    tensions = {"p1": Tensions(entry=150e3, exit=100e3), "p2": Tensions(entry=108e3, exit=50e3)}
    drive = Drive(
        belt=Belt(name="b", width=1.2, modulus=12.96e6),
        pulleys=of,
        load_cases=(LoadCase(name="c", tensions=tensions),),
    )
    as_train = Train.of(drive)
    assert as_train.cases[0].runs == (8e3,)
    result = solved(as_train)
    assert result["p1"].arc.exit_tension == 100e3
    assert result["p2"].arc.entry_tension == 108e3
    assert result["p2"].share == pytest.approx(58 / 108)
