"""A motor speed that is bent by torque: told where the log shows it, else in the intervals.

The logs are those of `benchmarks.plant_log`, whose law, noise and errors are not the learner's. The
motor speed is read wrong by 0.4 % at rated torque, ten times what is assumed of an encoder.
"""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from benchmarks.plant_log import DRIVE, learn_text, make_plant, truth_of, write_csv

from cli.running import wraparc
from wraparc.learn.errors import LogErrors
from wraparc.learn.file import load_plan
from wraparc.learn.fit import LearnFit, fit_cells
from wraparc.learn.learn import Learned, learn

SLOPE = 0.004


def written(folder: Path, seed: int, days: float, slope: float) -> Path:
    drive, plant = make_plant(seed, days, slope=slope)
    write_csv(plant, folder / "trend.csv")
    (folder / "drive.toml").write_text(DRIVE.read_text("utf-8"), "utf-8")
    (folder / "learn.toml").write_text(learn_text(drive, plant), "utf-8")
    (folder / "truth.json").write_text(json.dumps(truth_of(plant)), "utf-8")
    return folder / "learn.toml"


def test_a_reading_that_is_too_low_is_told(tmp_path: Path) -> None:
    """Friction can hide it only by more than doubling, and then four errors with it."""
    path = written(tmp_path, 205, 12.0, -SLOPE)
    ran = wraparc("learn", path, "--table", "errors", "--json", tmp_path / "a.json")
    assert ran.code == 0, ran.err
    answer = json.loads((tmp_path / "a.json").read_text("utf-8"))
    assert answer["errors"]["moved"]["speed_by_torque.head"] < -3.0
    (pulley,) = answer["pulleys"]
    assert (pulley["friction"], pulley["change"], pulley["friction_reserve"]) == (None, None, None)
    assert pulley["zero_change"] is not None
    # of its own statement alone, so by other errors as they are stated, it would be what it is
    (row,) = (line for line in ran.out.splitlines() if "Speed by torque" in line)
    assert float(row.split("assumed")[1].split("%")[1]) == pytest.approx(-0.4, abs=0.1)
    first = wraparc("learn", path)
    assert "\nATTENTION  " in first.out
    assert "standard deviations off: friction not identified." in first.words
    assert "Speed by torque (head)" in first.words
    assert "Friction of its law" not in first.out


@pytest.fixture(scope="module")
def high(tmp_path_factory: pytest.TempPathFactory) -> tuple[Learned, dict[str, float]]:
    folder = tmp_path_factory.mktemp("high")
    found = learn(load_plan([str(written(folder, 203, 20.0, SLOPE))]))
    return found, json.loads((folder / "truth.json").read_text("utf-8"))


def misfit(fit: LearnFit, spread: float) -> float:
    """Return the sum of the squared differences of all cells, over a spread, far ones less."""
    assert fit.problem is not None
    (own,) = fit.problem.linearize(fit.unknowns)[0] / spread
    return float(np.sum(np.where(np.abs(own) < 2.5, own**2, 5.0 * np.abs(own) - 6.25)))


def test_a_reading_that_is_too_high_looks_like_less_friction(
    high: tuple[Learned, dict[str, float]],
) -> None:
    """The log is as probable with the statement and with ten times it: it cannot tell."""
    found, _ = high
    fit = found.fit
    assert fit.problem is not None
    wide = fit_cells(
        fit.problem.cells, fit.model, LogErrors({"speed_by_torque": 0.004}), [False],
        found.cuts, found.stop,
    )  # fmt: skip
    assert wide.nuisance()["speed_by_torque.head"] > 3.0 * fit.prior_sd["speed_by_torque.head"]
    spread = math.hypot(float(fit.sigma[0]), float(fit.tau[0]))
    # twice the difference of the logarithms of the likelihoods: 9 would be three deviations
    assert abs(misfit(fit, spread) - misfit(wide, spread)) < 4.0
    ends = np.array([found.stop - 0.01])
    apart = wide.course("friction", ends)[0, 0] - fit.course("friction", ends)[0, 0]
    assert apart > 0.1  # which friction it is differs


def test_the_intervals_hold_what_the_log_cannot_tell(
    high: tuple[Learned, dict[str, float]],
) -> None:
    found, truth = high
    assert found.moved == {}
    (pulley,) = found.pulleys
    assert pulley.friction is not None
    assert pulley.reserve is not None
    assert pulley.friction.low < math.exp(truth["ln_friction"]) < pulley.friction.high
    assert pulley.reserve.low < math.exp(truth["ln_reserve"]) < pulley.reserve.high
