"""Runs are judged by what grows in them and by what heats their motors."""

from dataclasses import replace

import numpy as np
import pytest

from motion.stations import station
from wraparc.answer.motion_sheet import run_sheet
from wraparc.answer.sheet import shown
from wraparc.checks import Check, Level, judge_run
from wraparc.checks.of_run import otherwise
from wraparc.motion import Event, LoadStep, Start, simulate, stability
from wraparc.motion.control import Droop, ExactSpeed, Follower
from wraparc.motion.result import RunResult
from wraparc.units import in_units


def named(run: RunResult, name: str) -> list[Check]:
    return [c for c in judge_run(run).checks if c.name == name]


def short(event: Event, *controls: Droop | ExactSpeed | Follower) -> RunResult:
    return simulate(station("fabric", *controls), event, points=30, step=0.05)


STEP = Event(name="step", duration=1.0, happenings=(LoadStep(factor=1.01),))


def test_growing_vibration_leads_a_run_that_shows_little_of_it() -> None:
    # expected: the same root as `wraparc stability`; a follower without damping (test_stability)
    run = short(STEP, ExactSpeed(), Follower(master="first", lag=0.1))
    (check,) = named(run, "vibration")
    assert check.level is Level.FAILS
    assert check.value > 0.0
    said = in_units(judge_run(run).text)
    assert said.startswith("Self-excited oscillation at ")
    assert " Hz, doubling time " in said
    assert said.endswith("(step).")


def test_calm_station_tells_its_least_damped_vibration() -> None:
    (check,) = named(short(STEP, ExactSpeed(), ExactSpeed()), "vibration")
    assert check.level is Level.OK
    assert check.value < 0.0


def test_what_a_length_by_default_is_worth_is_told() -> None:
    # expected: the same start with 200 m of belt before the first drum, followed by itself
    start = Event(name="start", duration=5.0, happenings=(Start(time=4.0),))
    of = station("fabric", ExactSpeed(), ExactSpeed(), carry_run=50.0, conveyor_mass=100e3)
    brief = replace(start, duration=0.5)
    assert otherwise(simulate(of, brief, points=20)) == ()  # nothing is left out
    run = simulate(replace(of, taken=("carry_run",)), start, points=20)
    (told,) = otherwise(run)
    longer = simulate(replace(of, carry_run=200.0), start, points=20)
    assert (told.key, told.taken, told.other) == ("carry_run", 50.0, 200.0)
    assert told.tension == pytest.approx(longer.peak_tension.value, rel=1e-9)
    said = shown(run_sheet(run), "si").verdict
    assert said is not None
    assert any(s.startswith("carry_run is missing: 50 m") for s in said.sentences)


@pytest.mark.parametrize(
    ("load", "seconds", "levels"),
    [
        # (load^2 - 1) t against (1.5^2 - 1) 120 s = 150 s; the end against the rating
        (0.9, 400.0, ("OK", "OK", "OK")),
        (1.42, 60.0, ("OK", "FAILS", "OK")),  # 61 s of 150 s, but it lasts
        (1.42, 160.0, ("OK", "FAILS", "ATTENTION")),  # 163 s
        (1.7, 20.0, ("ATTENTION", "FAILS", "OK")),
    ],
)
def test_motors_of_a_run_are_judged(
    load: float, seconds: float, levels: tuple[str, str, str]
) -> None:
    rated = 10e3
    of = station("fabric", Droop(rated_torque=rated), ExactSpeed())
    run = simulate(of, replace(STEP, duration=0.2), points=30, step=0.05)
    drum = run.drums[0]
    torque = np.full(run.time.shape, load * rated)
    peak = replace(drum.extremes.torque, value=load * rated)
    drum = replace(drum, torque=torque, extremes=replace(drum.extremes, torque=peak))
    time = np.linspace(0.0, seconds, run.time.size)
    made = replace(run, time=time, drums=(drum, run.drums[1]))
    found = [named(made, name)[0] for name in ("momentary_load", "motor_load", "motor_heat")]
    assert [str(c.level) for c in found] == list(levels)
    assert found[2].value == pytest.approx(max(load**2 - 1.0, 0.0) * seconds)
    # of the other drum no rating is known
    assert named(made, "motor_heat")[1].level is Level.NOT_CHECKED


def test_the_length_that_a_fixed_take_up_keeps_is_no_growth() -> None:
    """Expected: the length of the whole belt is a constant, a root at 0, and stability agrees."""
    of = station("fabric", Droop(), Droop(), conveyor_mass=100e3, take_up="fixed")
    (check,) = named(simulate(of, STEP, points=20), "vibration")
    assert check.level is Level.OK
    assert stability(of).controls[0].stable


def test_stations_grow_in_a_run_where_stability_says_so() -> None:
    """Expected: the words of `wraparc stability`; that a run moves so, see test_stability.

    A follower without damping pulsates, the more so the later it follows; a droop calms it.
    """
    rng, ends = np.random.default_rng(5), set()
    step = replace(STEP, duration=0.2)
    for number in range(4):
        lag = float(rng.uniform(0.02, 0.3))
        other = Follower(master="first", lag=lag) if number % 2 else Droop()
        of = station("fabric", ExactSpeed() if number % 4 < 2 else Droop(), other)
        told = stability(of)
        (check,) = named(simulate(of, step, points=15, step=0.05), "vibration")
        grows = check.level is Level.FAILS
        assert grows is not told.controls[0].stable
        assert check.value == pytest.approx(told.root.real, rel=1e-9, abs=1e-6, nan_ok=True)
        ends.add(grows)
    assert ends == {True, False}
