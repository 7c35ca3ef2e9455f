"""The Bayesian fit. Expected: the known law behind virtual tests; least squares, near it."""

from pathlib import Path

import numpy as np
import pytest

from cli.running import wraparc
from shear_test.virtual import PRESSURES, TRANSITION, fitted, laboratory, rubber
from wraparc.files import load_lagging_conditions
from wraparc.shear_test import bayes
from wraparc.shear_test.bayes import sampled


def test_the_posterior_agrees_with_least_squares(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bayes, "_STEPS", 160)
    monkeypatch.setattr(bayes, "_BURN", 60)
    plain = fitted(
        *laboratory(repeats=2, points=300, seed=3, scatter_friction=0.02, scatter_slip=0.03)
    )
    drawn = sampled(plain)
    before, after = plain.conditions[0].fit, drawn.conditions[0].fit
    assert before is not None
    assert after is not None
    assert after.form == before.form
    p = PRESSURES[1:-1]
    errors = before.peak_errors(p)
    assert np.all(np.abs(after.peaks(p) - before.peaks(p)) < 1.5 * errors)
    ratio = after.peak_errors(p) / errors
    assert np.all((ratio > 0.5) & (ratio < 2.5))
    slip, friction, _, _ = rubber().parameters(p)
    gap = after.peaks(p) - np.log(np.stack([slip, friction], axis=-1))
    assert np.abs(gap / after.peak_errors(p)).max() < 4.0
    if after.transition_pressure is not None:
        assert after.transition_pressure == pytest.approx(TRANSITION, rel=0.5)
    assert "draws from their posterior (emcee)" in drawn.conditions[0].remarks[-1]
    fit = drawn.conditions[0].lagging.fit
    assert fit is not None
    assert fit.parameters[0] == "knots[1].peak_slip"


def test_the_same_seed_gives_the_same_draws(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bayes, "_STEPS", 20)
    monkeypatch.setattr(bayes, "_BURN", 5)
    plain = fitted(*laboratory(pressures=PRESSURES[::2], repeats=1, points=200))
    one, same, other = (sampled(plain, seed=seed).conditions[0].fit for seed in (1, 1, 2))
    assert one is not None
    assert same is not None
    assert other is not None
    np.testing.assert_array_equal(one.theta, same.theta)
    assert np.any(one.theta != other.theta)


def test_one_pressure_is_left_as_it_is() -> None:
    plain = fitted(*laboratory(pressures=[207e3], repeats=1, points=300))
    assert sampled(plain).conditions == plain.conditions


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bayes, "_STEPS", 15)
    monkeypatch.setattr(bayes, "_BURN", 5)
    folder = tmp_path / "lab"
    options = ["--pressures", "69 138 276", "--repeats", 1, "--points", 100]
    wraparc("rig", folder, "--condition", "dry", "--condition", "wet=0.7", *options)
    ran = wraparc("fit", folder / "plan.toml", "--bayes", "-o", tmp_path / "lagging.toml")
    assert ran.code == 0
    assert "draws from their posterior (emcee)" in ran.words
    assert len(load_lagging_conditions(str(tmp_path / "lagging.toml"))) == 2
