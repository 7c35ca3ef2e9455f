"""The steps that are chosen: against the same march in steps a tenth as long.

Only the error in time is looked at; that in space is seen by the tests of arcs.
"""

from dataclasses import fields
from functools import cache

import numpy as np
import pytest

from motion.stations import moving, station
from wraparc.motion.control import CoupledMotor, Droop, ExactSpeed
from wraparc.motion.event import Event, LoadStep, PowerFailure, Start, Stop
from wraparc.motion.follow import simulate
from wraparc.motion.march import March
from wraparc.motion.result import Extremes, RunResult
from wraparc.motion.station import Station

START = Event(duration=13.0, happenings=(Start(time=12.0),))
STATION = moving("fabric", ExactSpeed(), ExactSpeed())


@cache
def both() -> tuple[RunResult, RunResult]:
    """A start in the steps that are chosen, and in steps an eighth as long."""
    long = simulate(STATION, START, points=50)
    return long, simulate(STATION, START, points=50, step=long.step / 8)


def test_a_start_in_long_steps() -> None:
    """Tensions to 2e-4, torque, creep and stress to 7e-4 of their largest at the end of every step,
    2e-5 and 1e-4 at half of them, but for the instant in which old and fresh contact part, where
    creep jumps: less than 50 pieces of lagging err by (7e-4, 7e-5)."""
    long, fine = both()
    assert long.time == pytest.approx(fine.time[::8], abs=1e-9)
    for d, e in zip(long, fine, strict=True):
        for name, most, half in (
            ("entry_tension", 2e-4, 2e-5), ("exit_tension", 2e-4, 2e-5), ("torque", 5e-4, 1e-4),
            ("exit_creep", 7e-4, 1e-4), ("peak_shear", 7e-4, 1e-4),
        ):  # fmt: skip
            expected = getattr(e, name)[::8]
            off = np.sort(np.abs(getattr(d, name) - expected) / np.max(np.abs(expected)))
            assert off[-4] < most, name
            assert np.median(off) < half, name


def test_what_is_told_of_a_start_in_long_steps() -> None:
    """Largest values, friction work and time over the limit."""
    for d, e in zip(*both(), strict=True):
        for field in fields(Extremes):
            most = 6e-3 if field.name == "slip_speed" else 1e-3
            found = getattr(d.extremes, field.name).value
            assert found == pytest.approx(getattr(e.extremes, field.name).value, rel=most)
        assert d.friction_energy == pytest.approx(e.friction_energy, rel=5e-4)
        assert d.drum_work == pytest.approx(e.drum_work, rel=1e-4)
        assert d.over_limit == pytest.approx(e.over_limit, abs=2e-3)


def test_the_joint_of_old_and_fresh_contact_leaves_in_small_parts() -> None:
    """By definition: a quarter of a piece of lagging each, when it is at the exit nip."""
    march = March(STATION, START, points=50)
    places: list[tuple[float, float]] = []
    arc = march.drums[0].arc
    march.watch = lambda: places.append((arc.travel, arc.travel - arc.joint))
    while march.t < 6.0:
        march.step()
    travel, since = np.array(places).T
    small = np.diff(travel)[np.abs(since[1:] / arc.shape.length - 1.0) < 0.02] / arc.spacing
    assert len(small) >= 8
    assert np.max(small) < 0.3


def test_a_load_step_comes_when_it_comes() -> None:
    """In the middle of a step: to 1e-3 of the change it makes, which a shift by half a step would
    miss by 1e-2. Unstretched belt stays, 1e-10."""
    closed = station("fabric", Droop(), Droop(), conveyor_mass=100e3, take_up="fixed")
    h = March(closed, Event(duration=2.0), points=40).h
    event = Event(duration=2.0, happenings=(LoadStep(at=13.5 * h, factor=1.2),))
    long, fine = (simulate(closed, event, points=40, step=step) for step in (None, h / 8))
    assert long.belt_error < 1e-10
    found, expected = (run.drums[0].entry_tension for run in (long, fine))
    assert found == pytest.approx(expected[::8], abs=1e-3 * np.ptp(expected))


def test_steps_end_where_something_begins_or_ends() -> None:
    happenings = (
        Start(at=0.11, time=0.5), LoadStep(at=0.83, factor=1.1, time=0.3), Stop(at=1.3, time=0.2),
        PowerFailure(at=1.72),
    )  # fmt: skip
    march = March(STATION, Event(duration=2.0, happenings=happenings), points=40)
    times = []
    march.watch = lambda: times.append(march.t)
    while march.t < 1.8:
        march.step()
    for t in (0.11, 0.61, 0.83, 1.13, 1.3, 1.5, 1.72):
        assert min(abs(np.array(times) - t)) < 0.021 * march.h


@pytest.mark.parametrize(
    ("given", "longest"),
    [
        (STATION, 0.07 * 1.2566 / 2.97),
        # a conveyor of 1 t on 5 m of belt swings with 7 Hz: a quarter of a radian a step
        (moving("fabric", Droop(), Droop(), carry_run=5.0), 0.0293),
    ],
)
def test_steps_are_long_but_short_for_a_swing(given: Station, longest: float) -> None:
    """By definition; never shorter than with a piece of lagging each, and rows meet them."""
    march = March(given, Event(duration=60.0, happenings=(Start(),)), points=100)
    assert march.h <= 1.001 * longest
    assert 60.0 / march.h == pytest.approx(round(60.0 / march.h), abs=1e-9)
    assert march.finest <= march.h
    assert march.h * march.swing < 0.26


def test_a_swing_neither_grows_nor_dies_by_its_steps() -> None:
    """A conveyor on its belt after a load step, drums at exact speed: fine steps to 2e-3."""
    event = Event(duration=30.0, happenings=(LoadStep(at=0.5, factor=1.3),))
    ends = []
    for step in (None, 0.01):
        run = simulate(STATION, event, points=20, every=0.1, step=step)
        late = run.time > 25.0
        ends.append(np.ptp(run.drums[0].entry_tension[late]))
    assert ends[0] == pytest.approx(ends[1], rel=2e-3)


def test_a_direct_start_is_taken_in_parts() -> None:
    """Largest values of a start with couplings against steps a tenth as long."""
    s = moving("fabric", CoupledMotor(pump_inertia=300.0), CoupledMotor(pump_inertia=300.0))
    event = Event(duration=3.0, happenings=(Start(shape="direct", time=8.0),))
    long, fine = (simulate(s, event, step=h) for h in (None, 0.0025))
    for d, e in zip(long, fine, strict=True):
        for name in ("creep", "shear", "pull", "torque", "most_entry_tension"):
            expected = getattr(e.extremes, name).value
            assert getattr(d.extremes, name).value == pytest.approx(expected, rel=1e-2), name
