"""A [motion] table that is written reads back equal: every control, every happening."""

from dataclasses import replace
from pathlib import Path

import pytest

from motion.stations import TRAINS
from wraparc import InputError, load_motion, load_train
from wraparc.motion import (
    Control,
    CoupledMotor,
    Droop,
    Drum,
    Event,
    ExactSpeed,
    Follower,
    Happening,
    InductionMotor,
    LoadStep,
    Measured,
    OnBelt,
    OnDrum,
    PowerFailure,
    SpeedLoop,
    Start,
    Station,
    Stop,
    Trim,
    motion_text,
)
from wraparc.motion.file import Motion, motion_from_text

FILE = Path("examples/tandem-fabric.toml").read_text("utf-8")
TRAIN = FILE[: FILE.index("[motion]")]
FABRIC = load_train("examples/tandem-fabric.toml")

CONTROLS: list[Control] = [
    ExactSpeed(rated_torque=21e3),
    Droop(),
    Droop(droop=0.02, lag=0.05, torque_limit=2.0),
    SpeedLoop(bandwidth=2.0, reset=1.5),
    InductionMotor(starting_ratio=1.7, rated_slip=0.012),
    CoupledMotor(pump_inertia=300.0, coupling_slip=0.04),
    Follower(master="first", ratio=0.8, dead_time=0.1, damping=0.03),
]
HAPPENINGS: list[Happening] = [
    Start(shape="coupling-fill", time=12.0),
    Stop(at=30.0, shape="ramp"),
    PowerFailure(at=1.5),
    PowerFailure(at=2.5, brakes=True),
    LoadStep(at=3.0, factor=1.25, time=0.5),
    OnBelt(at=1.0, length=2.5, friction=0.5),
    OnBelt(at=1.0, length=2.5, rise=1e-3, compliance=0.7),
    OnDrum(pulley="second", run_out=3e-4, order=3),
    OnDrum(pulley="first", joint_rise=2e-4, joints=6),
    OnDrum(pulley="first", ripple=0.02, order=6),
    Measured(pulley="first", times=(0.0, 0.1, 1.0 / 3.0), values=(6.0, 6.1, 0.1 + 0.2)),
    Measured(pulley="second", times=(0.0, 1.0), values=(2e4, 2.2e4), what="torque"),
]


@pytest.mark.parametrize("name", TRAINS)
def test_the_shipped_files_read_back_equal(name: str) -> None:
    motion = load_motion(f"examples/tandem-{name}.toml")
    text = Path(f"examples/tandem-{name}.toml").read_text("utf-8")
    assert motion_from_text(text[: text.index("[motion]")] + motion_text(motion)) == motion


@pytest.mark.parametrize("control", CONTROLS, ids=lambda c: c.words)
def test_every_control_reads_back_equal(control: Control) -> None:
    drum = Drum(
        inertia=1234.5, run=4.25, control=control, trim=Trim(gain=0.01, dead_time=0.5),
        backstop=False, brake_torque=15e3,
    )  # fmt: skip
    station = Station(
        train=FABRIC, drums=(Drum(inertia=2200.0, control=Droop()), drum),
        conveyor_mass=123e3, carry_run=61.0, lift_share=0.1, take_up="winch", winch_speed=0.2,
        source="given",
    )  # fmt: skip
    event = Event(name="start", happenings=(Start(),))
    motion = Motion(station, (event,))
    assert motion_from_text(TRAIN + motion_text(motion)) == motion
    usual = motion_from_text(TRAIN + motion_text(replace(motion, events=(), assumed=True)))
    assert usual.assumed  # a file without events has the usual ones
    assert motion_from_text(TRAIN + motion_text(usual)) == usual


def test_every_happening_reads_back_equal() -> None:
    motion = load_motion("examples/tandem-fabric.toml")
    event = Event(name="all of it", duration=45.0, happenings=tuple(HAPPENINGS))
    motion = replace(motion, events=(event,))
    assert motion_from_text(TRAIN + motion_text(motion)) == motion


def test_what_is_two_things_becomes_two() -> None:
    both = OnBelt(at=1.0, length=2.0, friction=0.5, rise=1e-3)
    motion = replace(
        load_motion("examples/tandem-fabric.toml"), events=(Event(happenings=(both,)),)
    )
    back = motion_from_text(TRAIN + motion_text(motion)).events[0].happenings
    assert back == (replace(both, rise=0.0), replace(both, friction=1.0))
    with pytest.raises(InputError, match="nothing happens"):
        motion_text(replace(motion, events=(Event(),)))
