"""Errors as they are stated: what a bench draws, what the fit weighs, what the interval holds."""

from __future__ import annotations

from dataclasses import replace
from math import log, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.running import wraparc
from shear_test.virtual import benchmark_module
from wraparc import Distributed, WrapArc
from wraparc.calibrate.calibration import Number, Problemset, calibrate
from wraparc.calibrate.fit import Fit
from wraparc.files import load_drive

BENCH = benchmark_module("calibrate_speeds")
DRIVE = load_drive(Path(__file__).parents[2] / "examples" / "head-drive-fabric.toml")


@pytest.mark.parametrize("index", range(len(BENCH.KINDS)), ids=[k.title for k in BENCH.KINDS])
def test_at_the_truth_the_residuals_are_what_was_drawn(index: int) -> None:
    """Of each channel: nothing is drawn that is not stated, drawn twice, or weighed otherwise.

    But for what the fit leaves out: an offset or a radius off by 0.5 mm is the zero of the speeds
    and 0.1 % of the traction's exponent, a creep ratio of 1e-5 and a fifth of a reading's error.
    """
    station = BENCH.STATIONS[index % len(BENCH.STATIONS)]
    record = BENCH.Record(station, BENCH.KINDS[index], seed=7 + index)
    problem = record.problem()
    fit, x = Fit(problem), record.truth.variables(problem.variables)
    drawn = record.draws(problem)
    assert np.abs(drawn).max() > 0.5
    read = len(record.noise)
    assert BENCH.readings(fit, x) == pytest.approx(drawn[:read], abs=0.3)
    count = len(problem.parameters)
    assert fit.prior_residuals(x)[count:] == pytest.approx(drawn[read + count :], rel=1e-12)


@pytest.mark.parametrize("index", [0, 3, 5, 6, 7])
def test_errors_of_a_plant_that_are_assumed_are_those_of_its_record(index: int) -> None:
    """The same where the twin has torque at no load, a rubbing take-up, another belt and law.

    The file states none of them: what it assumes is what moves the readings.
    """
    station = BENCH.STATIONS[index % len(BENCH.STATIONS)]
    record = BENCH.Record(station, BENCH.KINDS[index], seed=7 + index, plant=True)
    problem = record.problem()
    assert "slip_axis" in problem.assumed
    cells = BENCH.KINDS[index].tensions == "cells"
    assert any(name.startswith("take_up.") for name in problem.errors) is not cells
    fit, x = Fit(problem), record.truth.variables(problem.variables)
    drawn, read = record.draws(problem), len(record.noise)
    assert BENCH.readings(fit, x) == pytest.approx(drawn[:read], abs=0.3)
    # with any of them left out the readings are off by far more than their errors
    without = x.copy()
    for k, name in enumerate(problem.variables):
        if name in problem.assumed or name.startswith("take_up."):
            without[k] = 0.0
    assert np.abs(BENCH.readings(fit, without) - drawn[:read]).max() > 1.0


@pytest.mark.parametrize("kind", [BENCH.KINDS[0], BENCH.KINDS[4]], ids=lambda k: k.title)
def test_the_bench_draws_what_it_states(kind: Any) -> None:
    """Mean squares over what is stated are 1 within 4 of their deviations, sqrt(2/2000)."""
    station = BENCH.STATIONS[0]
    drive = BENCH.described(station.example, station.side)
    stated = BENCH.STATED | BENCH.TENSIONS[kind.tensions]
    radius, e = 0.4, 4e-3 + 0.5 * 8.6e-3
    zero = sqrt(1e-3**2 + (0.5e-3 / (radius + e)) ** 2 + (0.5 * 0.4e-3 / (radius + e)) ** 2)
    deviations = {"speed_zero": zero} | {k: v for k, v in stated.items() if v >= 1e-2}
    rng = np.random.default_rng(1)
    truths = [BENCH.Truth(drive, kind, stated, rng) for _ in range(2000)]
    x = np.array([t.variables(tuple(deviations)) for t in truths]) / list(deviations.values())
    for name, square in zip(deviations, np.mean(x**2, axis=0), strict=True):
        assert square == pytest.approx(1.0, abs=4.0 * sqrt(2.0 / 2000.0)), name
    apart = np.corrcoef(x.T) - np.eye(len(deviations))
    assert np.abs(apart).max() < 4.0 / sqrt(2000.0)


@pytest.mark.parametrize(("stated", "repeats"), [(0.1, 1), (0.1, 10), (0.03, 10)])
def test_a_common_error_is_not_averaged_down(stated: float, repeats: int) -> None:
    """The arc knows G over the factor of `lagging_shear` alone: ln G is that known and ln factor.

    Its variance is the sum of both, of n alike readings of gamma with the standard deviation s:
    stated^2 + (s/gamma)^2/n/(d ln gamma/d ln G)^2. The first stays, however many there are.
    """
    case = DRIVE.load_cases[0]
    arc = WrapArc.of(DRIVE, DRIVE.pulleys[0], case)

    def angle(factor: float) -> float:
        off = replace(arc, shear_modulus=arc.shear_modulus * factor)
        return Distributed(points=120, capacities=False).solve(off).peak_shear_angle

    steepness = (log(angle(1.01)) - log(angle(0.99))) / (log(1.01) - log(0.99))
    number = Number(
        quantity="peak_shear_angle", value=angle(1.0), sd=0.02 * angle(1.0), load_case=case.name
    )
    (found,) = calibrate(
        Problemset(
            drive=DRIVE, pulley="head", parameters=("shear_modulus",),
            numbers=(number,) * repeats, errors={"lagging_shear": stated},
        )
    ).estimates  # fmt: skip
    assert found.low is not None
    assert found.high is not None
    half = 1.959964 * sqrt(stated**2 + (0.02 / steepness) ** 2 / repeats)
    assert 0.5 * log(found.high / found.low) == pytest.approx(half, rel=0.01)
    assert found.parts["lagging_shear"] == pytest.approx((1.959964 * stated / half) ** 2, rel=0.02)


def test_what_is_assumed_of_a_plant_is_marked_in_the_answer() -> None:
    pair = Path(__file__).parents[2] / "examples/test-pulley/published-pair.toml"
    plant = ("--set", 'errors.assumed="plant"')
    ran = wraparc("calibrate", pair, *plant, "--full")
    assert ran.code == 0, ran.err
    assert "Belt modulus 10 %, assumed" in ran.words
    assert "Friction of the take-up (design) 3.6 %, assumed" in ran.words
    plain = wraparc("calibrate", pair, "--full")
    assert "assumed 0 %" not in plain.words
    stated = wraparc("calibrate", pair, *plant, "--set", "errors.modulus=5 %", "--full")
    assert "Belt modulus 5 %" in stated.words
    found = wraparc("calibrate", pair, "--set", "errors.modulus=5 %",
                    "--set", 'parameters=["friction", "belt_modulus"]')  # fmt: skip
    assert found.code == 2
    assert "contradicts belt_modulus in parameters" in found.err


def test_a_trial_that_leaves_the_belt_slack_is_farther_off_than_any_drive() -> None:
    """A search tries such steps; T1 of a brake with 3 times its torque would be below 0."""
    station = next(s for s in BENCH.STATIONS if s.title == "fabric, braking")
    record = BENCH.Record(station, BENCH.KINDS[1], seed=8, plant=True)
    fit = Fit(record.problem())
    slack = fit.start.copy()
    slack[fit.names.index("effective_tension")] = log(3.0)
    misfit = np.abs(fit.data_residuals(slack, []))
    assert np.isfinite(misfit).all()
    slips = fit.start.copy()
    slips[fit.names.index("friction")] = log(0.02)  # cannot carry its load
    assert misfit.min() > np.abs(fit.data_residuals(slips, [])).max()
