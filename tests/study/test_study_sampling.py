"""Points by index and distributions: closed forms, scipy, and any part without the rest."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from scipy.stats import qmc

from wraparc.arrays import Array
from wraparc.errors import InputError
from wraparc.study.distributions import Distribution, Lognormal, Normal, Triangular, Uniform
from wraparc.study.plan import DrawnField, Levels, Saltelli, Sweep
from wraparc.study.sampling import SAMPLINGS, LatinHypercube, Random, Sobol

NAMES = sorted(SAMPLINGS)


@pytest.mark.parametrize("name", NAMES)
@given(data=st.data(), count=st.integers(1, 300), seed=st.integers(0, 2**40))
def test_any_part_is_that_of_the_whole(
    name: str, data: st.DataObject, count: int, seed: int
) -> None:
    sampling = SAMPLINGS[name]
    whole = sampling.points(3, count, seed, 0, count)
    start = data.draw(st.integers(0, count))
    stop = data.draw(st.integers(start, count))
    assert np.array_equal(sampling.points(3, count, seed, start, stop), whole[start:stop])
    assert np.all((whole > 0.0) & (whole < 1.0))


@pytest.mark.parametrize("name", NAMES)
def test_a_seed_makes_the_sample(name: str) -> None:
    made = [SAMPLINGS[name].points(2, 64, seed, 0, 64) for seed in (1, 1, 2)]
    assert np.array_equal(made[0], made[1])
    assert not np.any(made[0] == made[2])


@given(count=st.integers(1, 3000), seed=st.integers(0, 2**60))
def test_a_latin_hypercube_has_one_point_in_every_interval(count: int, seed: int) -> None:
    points = LatinHypercube().points(2, count, seed, 0, count)
    for column in points.T:
        assert np.array_equal(np.sort(np.floor(column * count)), np.arange(count))


def test_a_latin_hypercube_is_as_even_as_that_of_scipy() -> None:
    """Centred discrepancy: as scipy's, a tenth of that of independent points; no correlation."""
    n = 1024
    ours = LatinHypercube().points(3, n, 5, 0, n)
    theirs = qmc.LatinHypercube(3, rng=np.random.default_rng(5)).random(n)
    free = Random().points(3, n, 5, 0, n)
    discrepancy = [qmc.discrepancy(sample) for sample in (ours, theirs, free)]
    assert discrepancy[0] < 2.0 * discrepancy[1]
    assert discrepancy[0] < 0.5 * discrepancy[2]
    off = np.asarray(np.corrcoef(ours.T))[np.triu_indices(3, 1)]
    assert np.all(np.abs(off) < 4.0 / math.sqrt(n))


def test_random_points_are_uniform_and_independent() -> None:
    """Kolmogorov-Smirnov at 1e-4; the first points of more points are those of fewer."""
    points = Random().points(4, 20_000, 3, 0, 20_000)
    for column in points.T:
        assert stats.kstest(column, "uniform").pvalue > 1e-4
    off = np.asarray(np.corrcoef(points.T))[np.triu_indices(4, 1)]
    assert np.all(np.abs(off) < 4.0 / math.sqrt(20_000))
    assert np.array_equal(Random().points(4, 7, 3, 0, 7), points[:7])


def test_sobol_points_are_those_of_scipy() -> None:
    theirs = qmc.Sobol(3, scramble=True, rng=np.random.default_rng(11)).random(64)
    assert np.array_equal(Sobol().points(3, 64, 11, 0, 64), theirs)


CASES: list[tuple[Distribution, Callable[[Array], Array]]] = [
    (Uniform(low=2.0, high=5.0), stats.uniform(2.0, 3.0).ppf),
    (Normal(mean=1.0, standard_deviation=2.0), stats.norm(1.0, 2.0).ppf),
    (
        Normal(mean=1.0, standard_deviation=2.0, least=0.0, most=4.0),
        stats.truncnorm(-0.5, 1.5, 1.0, 2.0).ppf,
    ),
    (
        Lognormal(median=3.0, geometric_standard_deviation=1.2),
        stats.lognorm(math.log(1.2), scale=3.0).ppf,
    ),
    (Triangular(low=1.0, mode=2.0, high=5.0), stats.triang(0.25, 1.0, 4.0).ppf),
    (Triangular(low=1.0, mode=1.0, high=5.0), stats.triang(0.0, 1.0, 4.0).ppf),
    (Triangular(low=1.0, mode=5.0, high=5.0), stats.triang(1.0, 1.0, 4.0).ppf),
]


@pytest.mark.parametrize("number", range(len(CASES)))
def test_quantiles_are_those_of_scipy(number: int) -> None:
    ours, theirs = CASES[number]
    share = np.linspace(0.001, 0.999, 999)
    np.testing.assert_allclose(ours.quantile(share), theirs(share), rtol=1e-9)


@pytest.mark.parametrize(
    ("make", "cut"),
    [
        (lambda **c: Triangular(low=1.0, mode=2.0, high=5.0, **c), (1.5, 4.0)),
        (lambda **c: Uniform(low=0.0, high=4.0, **c), (1.0, 3.0)),
        (lambda **c: Lognormal(median=2.0, geometric_standard_deviation=1.5, **c), (1.0, 3.0)),
    ],
)
def test_a_cut_distribution_is_the_uncut_one_between_its_ends(
    make: Callable[..., Distribution], cut: tuple[float, float]
) -> None:
    """Independent: quantiles of the uncut one, those outside thrown away."""
    share = (np.arange(400_000) + 0.5) / 400_000
    whole = make().quantile(share)
    inside = whole[(whole >= cut[0]) & (whole <= cut[1])]
    made = make(least=cut[0], most=cut[1])
    assert made.kept == pytest.approx(len(inside) / len(whole), abs=1e-5)
    at = np.linspace(0.05, 0.95, 19)
    np.testing.assert_allclose(made.quantile(at), np.quantile(inside, at), rtol=1e-4)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            lambda: Normal(mean=1.0, standard_deviation=-0.1),
            "standard_deviation: must be more than 0 and finite, got -0.1.",
        ),
        (lambda: Normal(mean=1.0, standard_deviation=math.nan), "must be more than 0 and finite"),
        (lambda: Uniform(low=2.0, high=2.0), "to: from must be below to"),
        (lambda: Triangular(low=1.0, mode=6.0, high=5.0), "mode: must lie between"),
        (
            lambda: Lognormal(median=1.0, geometric_standard_deviation=0.9),
            "must be a factor of more than 1",
        ),
        (lambda: Uniform(low=1.0, high=2.0, least=5.0, most=4.0), "least must be below most"),
        (
            lambda: Normal(mean=-10.0, standard_deviation=1.0, least=0.0),
            "of the distribution lies within its limits",
        ),
    ],
)
def test_what_is_no_distribution(make: Callable[[], Distribution], sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        make()
    assert sentence in str(caught.value)


LEVELS = (
    Levels(field="a", values=(1.0, 2.0, 3.0), dimension="number"),
    Levels(field="b", values=("x", "y")),
)
DRAWN = (
    DrawnField(field="c", distribution=Uniform(low=0.0, high=1.0), dimension="number"),
    DrawnField(field="d", distribution=Uniform(low=5.0, high=6.0), dimension="number"),
)


@pytest.mark.parametrize(
    "plan",
    [
        Sweep(levels=LEVELS),
        Sweep(levels=LEVELS, drawn=DRAWN, samples=37, seed=1, sampling=LatinHypercube()),
        Saltelli(drawn=DRAWN, samples=16, seed=1),
        Saltelli(levels=LEVELS, drawn=DRAWN, samples=16, seed=1, sampling=Random()),
    ],
    ids=["grid", "mixed", "saltelli", "saltelli of levels"],
)
def test_designs_by_any_range(plan: Sweep | Saltelli) -> None:
    whole = plan.values(0, len(plan))
    for start, stop in ((0, 1), (3, 6), (len(plan) - 2, len(plan)), (0, len(plan) // 2 + 1)):
        for name, column in plan.values(start, stop).items():
            assert np.array_equal(column, whole[name][start:stop]), (name, start)


def test_levels_are_combined_and_draws_are_shared() -> None:
    plan = Sweep(levels=LEVELS, drawn=DRAWN, samples=5, seed=1)
    values = plan.values(0, len(plan))
    assert len(plan) == 3 * 2 * 5
    pairs = set(zip(values["a"].tolist(), values["b"].tolist(), strict=True))
    assert len(pairs) == 6
    draws = values["c"].reshape(6, 5)
    assert np.all(draws == draws[0])
    assert plan.combination(3) == {"a": 1, "b": 1}


def test_a_saltelli_plan_takes_one_axis_from_the_other_sample() -> None:
    plan = Saltelli(drawn=DRAWN, samples=8, seed=3)
    c, d = (plan.values(0, 32)[name].reshape(4, 8) for name in ("c", "d"))
    assert np.array_equal(c[2], c[1])
    assert np.array_equal(d[2], d[0])
    assert np.array_equal(c[3], c[0])
    assert np.array_equal(d[3], d[1])
    assert not np.any(c[0] == c[1])
