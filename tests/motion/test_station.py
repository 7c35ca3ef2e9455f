"""The station in time: run-out, followers, trim, closed belts, starts and stops.

The amplitudes, roots and gains are those of the linear theory, computed independently of this code
(pinned from the theory's own numerical study); the rest are identities and limits.
"""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from motion.stations import TRAINS, moving, station
from wraparc import InputError
from wraparc.motion.control import (
    Control,
    CoupledMotor,
    Droop,
    Duty,
    ExactSpeed,
    Follower,
    InductionMotor,
    SpeedLoop,
    Trim,
)
from wraparc.motion.event import (
    Event,
    LoadStep,
    Measured,
    OnBelt,
    OnDrum,
    PowerFailure,
    Start,
    Stop,
)
from wraparc.motion.follow import simulate
from wraparc.motion.march import March
from wraparc.motion.recorder import row_names
from wraparc.motion.result import Outcome
from wraparc.motion.station import Drum, Station
from wraparc.motion.turning import turning_of


@pytest.mark.parametrize(
    ("name", "control", "amplitude", "phase"),
    [
        ("fabric", ExactSpeed(), 3.4226e6, -81.5),
        ("steel-cord", ExactSpeed(), 1.5069e7, -64.8),
        ("steel-cord", Droop(droop=0.01), 8.2605e6, None),
    ],
)
def test_run_out_of_the_second_drum(
    name: str, control: Control, amplitude: float, phase: float | None
) -> None:
    """Theory: tension between the drums per run-out, outer tensions held, run 3 m."""
    wave = OnDrum(pulley="second", run_out=0.1e-3)
    pieces = 120 if phase and name == "steel-cord" else 100  # 2.5e-4 with 100, of second order
    march = March(station(name, control, control), Event(happenings=(wave,)), points=pieces)
    angles, tensions = [], []
    while march.t < 7.0:
        march.step()
        if march.t > 4.0:
            angles.append(march.drums[1].angle)
            tensions.append(march.T[1])
    a = np.array(angles)
    basis = np.stack([np.cos(a), np.sin(a), np.ones_like(a)], axis=1)
    c = np.linalg.lstsq(basis, np.array(tensions), rcond=None)[0]
    found = complex(c[0], -c[1]) / 0.1e-3
    assert abs(found) == pytest.approx(amplitude, rel=2e-4)
    if phase is not None:
        assert math.degrees(cmath.phase(found)) == pytest.approx(phase, abs=0.1)


def test_a_torque_follower_without_speed_feedback_grows() -> None:
    """Theory: the root of a follower with a lag of 0.1 s."""
    root = complex(2.086, 17.516)
    march = March(station("fabric", ExactSpeed(), Follower(master="first", lag=0.1)), Event())
    rows = []
    while march.t < 4.0:
        march.step()
        rows.append((march.t, march.T[1] - march.case.entry_tension))
    t, y = np.array(rows).T
    y = y - y[0]
    top = [i for i in range(1, len(y) - 1) if y[i] > y[i - 1] and y[i] > y[i + 1] and t[i] > 2.0]
    assert len(top) >= 4
    growth = np.polyfit(t[top], np.log(y[top]), 1)[0]
    period = float(np.mean(np.diff(t[top])))
    assert growth == pytest.approx(root.real, rel=0.01)
    assert 2.0 * math.pi / period == pytest.approx(root.imag, rel=0.01)


def test_speed_damping_cures_the_follower() -> None:
    follower = Follower(master="first", lag=0.1, damping=0.05)
    march = March(station("fabric", ExactSpeed(), follower), Event())
    while march.t < 3.0:
        march.step()
    assert march.T[1] == pytest.approx(march.steady.members[1].arc.entry_tension, rel=1e-3)


@pytest.mark.parametrize(("factor", "grows"), [(0.9, False), (1.1, True)])
def test_a_trim_loop_has_a_critical_gain(factor: float, grows: bool) -> None:
    """Theory: 0.0482 per s and share with a dead time of 0.5 s, steel cord, exact speeds."""
    base = station("steel-cord", ExactSpeed(), ExactSpeed())
    trim = Trim(gain=0.0482 * factor, dead_time=0.5)
    drums = (base.drums[0], replace(base.drums[1], trim=trim))
    bump = OnBelt(at=0.0, length=1.0, rise=1e-5)
    march = March(replace(base, drums=drums), Event(happenings=(bump,)), points=24)
    shares = []
    while march.t < 16.0:
        march.step()
        shares.append(march.drums[1].moment)
    y = np.array(shares) - np.mean(shares[-400:])
    early = np.ptp(y[int(0.35 * len(y)) : int(0.55 * len(y))])
    late = np.ptp(y[int(0.8 * len(y)) :])
    assert (late > early) == grows


def test_a_closed_train_keeps_its_belt() -> None:
    """Identity: unstretched belt with a fixed take-up, 1e-10."""
    event = Event(duration=3.0, happenings=(LoadStep(at=0.5, factor=1.2),))
    run = simulate(
        station("fabric", Droop(), Droop(), conveyor_mass=100e3, take_up="fixed"), event, points=40
    )
    assert run.outcome is Outcome.WHOLE
    assert run.belt_error < 1e-10


def test_a_run_without_an_event_stays_where_the_train_is() -> None:
    """Other code: `solve_train`, shares to 1e-4 over 5 s."""
    result = simulate(moving("steel-cord", Droop(), Droop()), Event(duration=5.0))
    for d in result:
        assert d.share == pytest.approx(0.5, abs=1e-4)


def test_a_start_reaches_the_steady_train_and_a_stop_stops() -> None:
    """Other code: `solve_train` at the end of the start; drums under speed control then fight."""
    happenings = (Start(time=6.0), Stop(at=16.0, time=6.0))
    s = moving("fabric", Droop(), Droop())
    run = simulate(s, Event(duration=26.0, happenings=happenings), points=50, every=0.05)
    assert run.outcome is Outcome.WHOLE
    # the conveyor swings on its belt with little damping: means over some of its swings
    late = (run.time > 8.5) & (run.time < 15.9)
    members = March(s, Event(), points=20).steady.members
    for d, m in zip(run, members, strict=True):
        assert np.mean(d.exit_creep[late]) == pytest.approx(m.arc.exit_creep, rel=0.03)
        assert np.mean(d.share[late]) == pytest.approx(m.share, abs=0.01)
        assert d.speed[-1] == pytest.approx(0.0, abs=0.05 * m.rotation_speed)
        assert 0.0 < d.friction_energy < d.drum_work
    assert run.peak_creep.value > members[1].arc.exit_creep
    assert run.build_distance > 1.0
    assert min(abs(c) for c in run.creep_left()) > 1e-4


DRIVES = (
    InductionMotor(starting_ratio=1.8),
    CoupledMotor(pump_inertia=300.0),
    SpeedLoop(bandwidth=2.0, reset=1.0),
    Droop(droop=0.02, lag=0.05),
)


@pytest.mark.parametrize("control", DRIVES, ids=lambda c: c.words)
def test_every_control_holds_the_steady_state_and_starts(control: Control) -> None:
    s = moving("fabric", control, control)
    still = simulate(s, Event(duration=1.0), points=20)
    assert still.drums[1].share == pytest.approx(0.5, abs=1e-3)
    shape = "direct" if not isinstance(control, Droop | SpeedLoop) else "s-curve"
    start = Start(shape=shape, time=8.0)  # type: ignore[arg-type]
    run = simulate(s, Event(duration=16.0, happenings=(start,)), points=12, every=0.1)
    assert run.outcome is Outcome.WHOLE
    assert run.belt_speed[-1] == pytest.approx(2.97, abs=0.2)


@pytest.mark.parametrize(
    "control",
    [*DRIVES, Follower(master="first", lag=0.1, damping=0.03)],
    ids=lambda c: c.words,
)
def test_a_drive_gives_the_steady_torque_at_the_steady_speed(control: Control) -> None:
    """Identity; its slope by differences."""
    duty = Duty(speed=7.5, torque=40e3, inertia=2200.0, radius=0.4)
    drive = turning_of(control, duty)
    drive.run(1.0, duty.speed, duty.torque)
    drive.begin(0.005, 1.0)
    torque, slope, _ = drive.torque(duty.speed, duty.torque)
    assert torque == pytest.approx(duty.torque, rel=1e-9)
    d = 1e-5 * duty.speed
    by_hand = [drive.torque(duty.speed + side * d, duty.torque)[0] for side in (1.0, -1.0)]
    assert slope == pytest.approx((by_hand[0] - by_hand[1]) / (2.0 * d), rel=1e-3)


def test_power_failure_and_emergency_stop_bring_the_belt_to_rest_or_slack() -> None:
    drums = tuple(Drum(inertia=2200.0, control=Droop(), brake_torque=20e3) for _ in range(2))
    s = Station(train=TRAINS["fabric"], drums=drums, conveyor_mass=100e3)
    run = simulate(
        s, Event(duration=6.0, happenings=(PowerFailure(at=0.5, brakes=True),)), points=30
    )
    assert run.outcome is Outcome.SLACK
    assert run.reason.startswith("Belt goes slack before first at ")
    assert run.time[-1] < 6.0  # kept up to there


def test_a_patch_on_the_belt_is_at_the_nip_while_it_passes() -> None:
    """By definition: its friction, height, compliance in its middle; the belt's own beside it."""
    patch = OnBelt(at=0.0, length=5.0, friction=0.7, rise=1e-3, compliance=1.5)
    station = moving("fabric", Droop(), Droop())
    march = March(station, Event(happenings=(patch,), duration=1.0), points=20)
    for d in march.drums:
        front = d.riders[0][1]
        middle = d.at_nip(front + 2.5, 0.0, march.stretch)
        assert middle == pytest.approx((1e-3, d.give + 0.5 * march.stretch, 0.7), rel=1e-12)
        edge = 2.0 * d.arc.spacing  # over which it begins and ends
        for beside in (front - edge, front + 5.0 + edge):
            assert d.at_nip(beside, 0.0, march.stretch) == (0.0, d.give, 1.0)
    # the second drum meets it after the first wrap and the run between them
    first, second = march.drums
    ahead = second.riders[0][1] - second.arc.travel - (first.riders[0][1] - first.arc.travel)
    assert ahead == pytest.approx(first.arc.shape.length + second.run, rel=1e-12)


def test_a_wet_patch_a_splice_and_joints_pass() -> None:
    wet = OnBelt(at=0.5, length=2.0, friction=0.5)
    splice = OnBelt(at=2.5, length=2.0, rise=1e-3, compliance=0.7)
    joints = OnDrum(pulley="first", joint_rise=0.2e-3, joints=4, joint_width=0.2)
    s = moving("fabric", Droop(), Droop())
    runs = [
        simulate(s, Event(duration=4.5, happenings=(happening,)), step=4e-3, points=24)
        for happening in (wet, splice, joints)
    ]
    for run in runs:
        assert run.outcome is Outcome.WHOLE
        assert np.ptp(run.drums[0].exit_creep) > 1e-5
    wetted = runs[0]
    assert wetted.drums[0].exit_creep[-1] == pytest.approx(wetted.drums[0].exit_creep[0], rel=0.02)


def test_a_measured_speed_drives_a_drum() -> None:
    s = moving("fabric", Droop(), Droop())
    speed = March(s, Event(), points=20).drums[0].duty.speed
    record = Measured(pulley="first", times=(0.0, 1.0, 2.0), values=(speed, speed, 0.999 * speed))
    run = simulate(s, Event(duration=3.0, happenings=(record,)), points=30)
    assert run.drums[0].share[-1] < 0.5 < run.drums[0].share[0] + 1e-3


def test_rows_are_streamed_and_what_is_kept_is_bounded() -> None:
    rows: list[object] = []
    s = moving("fabric", Droop(), Droop())
    run = simulate(s, Event(duration=2.0), points=20, every=0.1, sink=rows.append)
    assert len(rows) == pytest.approx(21, abs=1)
    assert len(row_names(s)) == len(rows[0])  # type: ignore[arg-type]
    assert len(run.time) <= 4001
    stopped = simulate(s, Event(duration=20.0), points=20, progress=lambda part: True)
    assert stopped.outcome is Outcome.CANCELLED


@pytest.mark.parametrize(
    ("s", "event", "step", "sentence"),
    [
        (station("fabric", Droop(), Droop()), Event(happenings=(Start(),)), None, "conveyor_mass"),
        (
            moving("fabric", Droop(), Droop()),
            Event(happenings=(OnDrum(pulley="third", run_out=1e-3),)),
            None,
            'no such pulley, got "third". Write one of "first", "second"',
        ),
        (
            moving("fabric", Droop(), Droop()),
            Event(happenings=(OnDrum(pulley="first", run_out=1e-3, order=20),)),
            0.01,
            "too coarse for 23.9 Hz at first, got 0.01 s. Take 0.0026 s or less",
        ),
        (
            moving("fabric", Droop(), Droop()),
            Event(happenings=(Start(at=1.0), Stop(at=1.0))),
            None,
            "two starts or stops begin together",
        ),
    ],
)
def test_what_cannot_be_followed_is_refused(
    s: Station, event: Event, step: float | None, sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        simulate(s, event, step=step)


def test_bad_stations_say_everything_at_once() -> None:
    with pytest.raises(InputError) as told:
        Station(
            train=TRAINS["fabric"],
            drums=(
                Drum(inertia=1.0, control=Follower(master="second")),
                Drum(inertia=1.0, control=Follower(master="frist")),
            ),
            take_up="fixed",
        )
    text = str(told.value)
    assert 'take_up: needs conveyor_mass, got "fixed".' in text
    assert 'Did you mean "first"?' in text
    assert "every drive follows another one" in text


def test_gaps_in_a_record_are_told() -> None:
    with pytest.raises(InputError, match="values: a value is missing or not a number"):
        Measured(pulley="first", times=(0.0, 1.0), values=(1.0, math.nan))
