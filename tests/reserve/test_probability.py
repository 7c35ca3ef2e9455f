"""The probability of a verdict: closed forms, the single solver, and what is left unsolved."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest
from scipy.stats import binomtest, qmc

from cli.running import wraparc
from reserve.test_find import result_of
from reserve.test_stated import TO_FRICTION, TO_PULL, document
from wraparc import load_drive
from wraparc.answer.probability_words import probability_text, share_text
from wraparc.checks import Level
from wraparc.drive import NORMAL_95, Drive
from wraparc.reserve import Input, Probability, Uncertainty, find_probability, uncertainty_of
from wraparc.reserve.draws import SOLVED, DrawLevels
from wraparc.reserve.predict import Uses, predict_ranks
from wraparc.reserve.probability import DRAWS, SEED, draw_factors, drawn_levels
from wraparc.reserve.sobol import MOST_DIMENSIONS, shifted_points, sobol_points
from wraparc.train.whole import solved

EXAMPLES = Path(__file__).parents[2] / "examples"
EXACT = {
    "belt": {"modulus": "0 %"},
    "pulley": {"diameter": "0 %", "wrap": "0 %", "effective_tension": "0 %", "exit_tension": "0 %"},
    "lagging": {"friction": "0 %", "slip": "0 %"},
}


def uncertain(table: str, key: str, percent: float) -> dict[str, Any]:
    """Return the drive of Euler's formula with one number that is not exact."""
    stated = {name: dict(values) for name, values in EXACT.items()}
    stated[table][key] = f"{percent} %"
    return document(**stated)


def test_points_are_those_of_scipy() -> None:
    expected = qmc.Sobol(MOST_DIMENSIONS, scramble=False, bits=30).random(1024)
    np.testing.assert_array_equal(sobol_points(MOST_DIMENSIONS, 1024), expected)
    points = shifted_points(MOST_DIMENSIONS + 3, 1024, SEED)
    assert points.min() > 0.0
    assert points.max() < 1.0
    # one in each of 1,024 intervals of every dimension
    assert (np.sort((1024 * points).astype(int), axis=0) == np.arange(1024)[:, None]).all()


@pytest.mark.parametrize(
    ("table", "key", "flip", "percent"),
    [
        ("pulley", "effective_tension", TO_PULL, 90.0),
        ("lagging", "friction", TO_FRICTION, 30.0),
        ("lagging", "friction", TO_FRICTION, 60.0),
    ],
)
def test_one_uncertain_input_has_a_closed_form(
    table: str, key: str, flip: float, percent: float
) -> None:
    # expected: the normal distribution up to the change that Euler's formula gives
    below = NormalDist().cdf(abs(flip) / (percent / 100.0 / NORMAL_95))
    found = find_probability(result_of(uncertain(table, key, percent)))
    assert found.shares[Level.OK] == pytest.approx(below, abs=2e-3)
    assert sum(found.shares.values()) == pytest.approx(1.0)
    assert found.draws == DRAWS


def levels_of(drive: Drive) -> tuple[DrawLevels, list[Uncertainty]]:
    levels = drawn_levels(solved(drive))
    return levels, [uncertainty_of(levels.drive, of) for of in levels.inputs]


def test_shares_are_those_of_the_single_solver() -> None:
    drive = load_drive(EXAMPLES / "uphill-conveyor.toml")
    start = replace(drive, load_cases=(drive.load_case("start"),), conveyor=None)
    levels, uncertainties = levels_of(start)
    random = draw_factors(np.random.default_rng(9).random((300, len(uncertainties))), uncertainties)
    one = [levels.level_of_all(row) for row in random]
    shares = find_probability(solved(start)).shares
    for level, share in shares.items():
        number = sum(rank == level.rank for rank in one)
        low, high = binomtest(number, len(one)).proportion_ci(0.999)
        assert low <= share <= high
    assert levels.of_draws(random).tolist() == one  # and row by row
    assert 0.5 < shares[Level.OK] < 0.9


@pytest.mark.parametrize("name", ["downhill-braking.toml", "tandem-fabric.toml"])
def test_what_is_not_solved_is_as_if_it_were(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    levels, uncertainties = levels_of(load_drive(EXAMPLES / name))
    draws = draw_factors(shifted_points(len(uncertainties), 2048, SEED), uncertainties)
    every = levels.of_draws(draws, solve_first=len(draws))
    counts = []
    solve = DrawLevels._solved_draws

    def counted(self: DrawLevels, of: Any, which: Any, *more: Any) -> Any:
        counts.append(len(which))
        return solve(self, of, which, *more)

    monkeypatch.setattr(DrawLevels, "_solved_draws", counted)
    assert (levels.of_draws(draws) == every).all()
    assert len(set(every.tolist())) > 1
    assert SOLVED <= sum(counts) < 1200


def test_predictions_are_sure_where_no_limit_is_near() -> None:
    rng = np.random.default_rng(3)
    draws = 1.0 + 0.1 * rng.standard_normal((900, 2))
    # a limit at 1, of what no quadratic is good for
    used = draws[:, 0] ** 2 / draws[:, 1] * (1.0 + 0.02 * np.sin(40.0 * draws[:, 0]))
    rank = np.where(used > 1.0, 2, 1)
    uses = [Uses(used[:600], rank[:600], 3)]
    low, high = predict_ranks(draws[:600], uses, draws[600:])
    sure = low == high
    assert 0.7 < sure.mean() < 1.0
    assert (low[sure] == rank[600:][sure]).all()
    # what misses without a number may do so with any rank
    hidden = np.where(used > 1.3, np.nan, used)
    low, high = predict_ranks(draws[:600], [Uses(hidden[:600], rank[:600], 3)], draws[600:])
    assert (high[rank[600:] == 2] > 1).all()
    assert (high[used[600:] > 1.1] == 3).all()


def test_friction_of_one_lagging_is_drawn_once() -> None:
    levels, _ = levels_of(load_drive(EXAMPLES / "tandem-fabric.toml"))
    names = [of.name for of in levels.inputs]
    assert names.count("friction") == 1
    assert names.count("diameter") == 2


def test_a_static_modulus_is_drawn_upwards() -> None:
    given = uncertain("belt", "modulus", 0.0)
    del given["belt"]["uncertainty"]
    given["belt"] |= {"modulus_test": "static", "kind": "fabric"}
    levels = drawn_levels(result_of(given))
    of = uncertainty_of(levels.drive, Input("belt_modulus"))
    assert (of.value, of.towards(-1.0), of.kind) == (1.0, 0.2, "usual")
    factors = draw_factors(np.array([[0.025], [0.5], [0.975]]), [of])
    assert factors.ravel() == pytest.approx([0.8, 1.0, 2.0], abs=1e-4)


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.0, "0 %"), (0.001, "< 1 %"), (0.926, "93 %"), (0.9999, "> 99 %"), (1.0, "100 %")],
)
def test_shares_read_all_or_none_of_these_alone(share: float, text: str) -> None:
    assert share_text(share) == text


def test_a_sentence_says_which_uncertainties() -> None:
    usual = (Input("friction"), Uncertainty(0.1))
    stated = (Input("belt_modulus"), Uncertainty(0.1, "stated", "drive file"))
    shares = {Level.OK: 0.93, Level.ATTENTION: 0.07, Level.FAILS: 0.0}
    text = probability_text(Probability(shares, 4096, (usual, stated)))
    assert text == "OK in 93 % of 4,096 draws of the stated and usual uncertainties."
    text = probability_text(Probability(shares, 4096, (usual,)))
    assert text == "OK in 93 % of 4,096 draws of the usual uncertainties."
    assert probability_text(Probability(reason="no solution")) == "Not calculated: no solution."


def test_solve_says_it_where_asked() -> None:
    file = EXAMPLES / "uphill-conveyor.toml"
    ran = wraparc("solve", file, "--probability", "--no-reserve")
    assert "Probability OK in 71 % of 4,096 draws of the usual uncertainties." in ran.words
    assert "Probability" not in wraparc("solve", file, "--no-reserve").out
    table = wraparc("solve", file, "--table", "probability")
    assert "ATTENTION 29 %" in table.words
    assert "belt modulus 20 % usual" in table.words
