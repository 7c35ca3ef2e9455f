"""What results say: probabilities, percentiles, convergence, sensitivities."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest

from study.studies import EXAMPLES, FRICTION, TAKE_UP, study_of
from study.test_study_run import CONDITIONS, small
from wraparc.answer.sheet import shown
from wraparc.answer.study_words import histogram_sentence, part
from wraparc.arc import Distributed, WrapArc
from wraparc.arrays import Array
from wraparc.checks import Level
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.schema.source import parse, read_text
from wraparc.study.histogram import limit_column
from wraparc.study.monte_carlo import PERCENTS, _Collected, over_conditions, summarise
from wraparc.study.parameter_study import OUTPUTS
from wraparc.study.plan import Saltelli
from wraparc.study.run import run_study
from wraparc.study.sampling import LatinHypercube, Sobol
from wraparc.study.sensitivity import (
    RANGE,
    global_sensitivity,
    local_sensitivity,
    sobol_indices,
)
from wraparc.study.share import wilson

pytestmark = pytest.mark.usefixtures("solved_once")


@pytest.mark.parametrize(
    ("count", "total", "interval"),
    [
        (81, 263, (0.2553, 0.3662)),
        (15, 148, (0.0624, 0.1605)),
        (0, 20, (0.0, 0.1611)),
        (1, 29, (0.0061, 0.1718)),
    ],
)
def test_wilsons_interval(count: int, total: int, interval: tuple[float, float]) -> None:
    """R. G. Newcombe, Statist. Med. 17 (1998) 857, table I, method 3."""
    assert wilson(count, total) == pytest.approx(interval, abs=6e-5)
    low, high = wilson(total - count, total)
    assert (1.0 - high, 1.0 - low) == pytest.approx(interval, abs=6e-5)


def test_the_interval_covers_the_truth() -> None:
    """Independent: of 4,000 samples of 200 draws at 3 %, about 95 % have it in their interval."""
    counts = np.random.default_rng(1).binomial(200, 0.03, 4000)
    inside = [low <= 0.03 <= high for low, high in (wilson(int(c), 200) for c in counts)]
    assert 0.93 < np.mean(inside) < 0.98


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("results") / "a.parquet"
    run_study(small(outputs=list(OUTPUTS)), path)
    return path


def test_groups_are_what_a_table_says(results: Path) -> None:
    """Independent: pandas over the whole file."""
    frame = pq.read_table(results).to_pandas()
    summary = summarise(results)
    assert len(summary.groups) == 4 * 2 * 2
    for group in summary.groups:
        rows = frame[
            np.isclose(frame["pulley.head.exit_tension"], group.levels["pulley.head.exit_tension"])
            & (frame.load_case == group.load_case)
            & (frame.condition == group.condition)
        ]
        assert len(rows) == 40 == group.rows
        over = int((~rows.within_creep_limit).sum())
        assert (group.over_limit.count, group.over_limit.total) == (over, 40)
        for name in ("exit_creep", "least_exit_tension", "peak_shear_stress"):
            values = rows[name].fillna(math.inf) if name != "peak_shear_stress" else rows[name]
            told = np.percentile(values, PERCENTS, method="inverted_cdf")
            assert group.percentiles[name] == tuple(told), name
            assert group.known[name] == int(rows[name].notna().sum())
        ordered = rows.sort_values("design").within_creep_limit.to_numpy()
        assert [step.draws for step in group.steps] == [16, 32, 40]
        for step in group.steps:
            assert step.over_limit.count == int((~ordered[: step.draws]).sum())


def test_conditions_count_by_their_share(results: Path) -> None:
    summary = summarise(results)
    for group, away, over in over_conditions(summary):
        both = [
            g for g in summary.groups
            if g.levels == group.levels and g.load_case == group.load_case
        ]  # fmt: skip
        assert over == pytest.approx(sum(0.5 * g.over_limit.value for g in both))
        assert away == 0.0
    assert len(CONDITIONS) == 2


def test_many_draws_are_thinned_evenly() -> None:
    """Percentiles of a million numbers of which some thousand are kept: within 1 % in rank."""
    rng = np.random.default_rng(2)
    gathered = _Collected(("exit_creep",), 100_000)
    numbers = rng.normal(size=(20, 50_000))
    for some in numbers:
        status = np.zeros(len(some), dtype=np.int64)
        gathered.take(status, np.ones(len(some), dtype=bool), status, {"exit_creep": some})
    group = gathered.group(levels={}, load_case="a", condition="", share=None)
    assert sum(map(len, gathered.kept["exit_creep"])) <= 100_000
    assert group.known["exit_creep"] == 1_000_000
    for percent, value in zip(PERCENTS, group.percentiles["exit_creep"], strict=True):
        assert np.mean(numbers < value) == pytest.approx(percent / 100.0, abs=0.01)


def test_breakaways_are_counted_and_have_a_creep_without_bound(tmp_path: Path) -> None:
    """A tenth of the friction carries nothing: every draw breaks away."""
    axis = {"field": "pulley.head.wrap_angle", "values": ["40 deg", "180 deg"]}
    study = study_of(
        axis, {**FRICTION, "from": 0.04, "to": 0.05}, sampling={"samples": 8, "seed": 1}
    )
    run_study(study.study, tmp_path / "a.parquet")
    first, _ = summarise(tmp_path / "a.parquet").groups
    assert first.breakaway.value == 1.0
    assert first.over_limit.value == 1.0
    assert first.percentiles["exit_creep"][0] == math.inf
    assert first.judged.share(Level.FAILS).value == 1.0
    assert first.judged.missed == {"gross_slip": 8}


def test_a_histogram_holds_every_row_and_ends_a_bar_at_the_limit(results: Path) -> None:
    """Independent: pandas over the whole file."""
    frame = pq.read_table(results).to_pandas()
    for group in summarise(results).groups:
        rows = frame[
            np.isclose(frame["pulley.head.exit_tension"], group.levels["pulley.head.exit_tension"])
            & (frame.load_case == group.load_case)
            & (frame.condition == group.condition)
        ]
        for name in ("exit_creep", "creep_limit_margin", "peak_shear_stress"):
            found, values = group.histograms[name], rows[name].dropna()
            assert sum(found.counts) == len(values)
            inside = values.between(found.edges[0], found.edges[-1])
            again, _ = np.histogram(values[inside], found.edges)
            assert list(found.counts[1:-1]) == list(again[1:-1])
        found = group.histograms["exit_creep"]
        (limit,) = set(rows.exit_creep_limit)
        assert (found.limit.least, found.limit.one) == (limit, True)
        assert found.beyond == int((~rows.within_creep_limit).sum())
        if found.edges[0] < limit < found.edges[-1]:
            assert min(abs(edge - limit) for edge in found.edges) < 1e-12


def test_draws_without_an_answer_are_no_draws_that_keep_the_limit() -> None:
    """By hand: of ten draws four creep 1 mm, three 9 mm, two slip, one is no drive; limit 8 mm."""
    creep = np.array([1.0] * 4 + [9.0] * 3 + [np.nan] * 3) / 1e3
    status = np.array([0] * 7 + [1, 1, 4])
    gathered = _Collected(("exit_creep",))
    values = {"exit_creep": creep, limit_column("exit_creep"): np.full(10, 8e-3)}
    gathered.take(status, creep <= 8e-3, np.zeros(10, dtype=np.int64), values)
    group = gathered.group(levels={}, load_case="a", condition="", share=None)
    found = group.histograms["exit_creep"]
    assert (found.beyond, found.away, found.unanswered, found.total) == (6, 2, 1, 10)
    assert (group.over_limit.count, group.over_limit.total) == (6, 10)
    assert (group.breakaway.count, group.breakaway.total) == (2, 10)
    assert shown(histogram_sentence("exit_creep", found), "si") == (
        "60 % of 10 draws exceed the 8 mm creep limit, "
        "2 in gross slip and 1 without an answer among them."
    )


def test_a_share_is_rounded_to_neither_all_nor_none() -> None:
    """By hand."""
    assert [part(n, 100_000) for n in (0, 99_999, 100_000)] == ["none", "all but 1", "all"]
    assert part(97, 100) == "97 %"


def test_a_file_that_is_no_results(tmp_path: Path) -> None:
    (tmp_path / "a.parquet").write_bytes(b"PAR1")
    with pytest.raises(InputError, match="is no file of results of a study"):
        summarise(tmp_path / "a.parquet")


def ishigami(x: Array) -> Array:
    found: Array = np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2
    return found + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


def saltelli_points(samples: int) -> Array:
    from wraparc.study.distributions import Uniform
    from wraparc.study.plan import DrawnField

    ends = Uniform(low=-math.pi, high=math.pi)
    drawn = tuple(
        DrawnField(field=f"x{i}", distribution=ends, dimension="number") for i in (1, 2, 3)
    )
    plan = Saltelli(drawn=drawn, samples=samples, seed=8, sampling=Sobol())
    return np.stack(list(plan.values(0, len(plan)).values()), axis=1)


def test_sobol_indices_of_the_ishigami_function() -> None:
    """Closed form (a = 7, b = 0.1), T. Ishigami and T. Homma, ISUMA'90 (1990) 398."""
    found = sobol_indices(ishigami(saltelli_points(8192)), ("x1", "x2", "x3"))
    by_name = {index.name: index for index in found.inputs}
    pi4, pi8 = math.pi**4, math.pi**8
    variance = 49.0 / 8.0 + 0.1 * pi4 / 5.0 + 0.01 * pi8 / 18.0 + 0.5
    first = 0.5 * (1.0 + 0.1 * pi4 / 5.0) ** 2
    with_third = 0.01 * pi8 * (1.0 / 18.0 - 1.0 / 50.0)
    closed = {
        "x1": (first / variance, (first + with_third) / variance),
        "x2": (49.0 / 8.0 / variance, 49.0 / 8.0 / variance),
        "x3": (0.0, with_third / variance),
    }
    for name, (alone, total) in closed.items():
        assert by_name[name].first == pytest.approx(alone, abs=0.01)
        assert by_name[name].total == pytest.approx(total, abs=0.01)
        low, high = by_name[name].total_interval
        assert low - 0.01 < total < high + 0.01
    assert found.deviation == pytest.approx(math.sqrt(variance), rel=0.01)


def test_indices_are_those_of_scipy_on_the_same_points() -> None:
    from scipy.stats import sobol_indices as of_scipy

    y = ishigami(saltelli_points(512)).reshape(5, 512)
    theirs = of_scipy(func={"f_A": y[None, 0], "f_B": y[None, 1], "f_AB": y[2:, None]}, n=512)
    ours = {i.name: i for i in sobol_indices(y.ravel(), ("x1", "x2", "x3")).inputs}
    for k, name in enumerate(("x1", "x2", "x3")):
        assert ours[name].first == pytest.approx(float(theirs.first_order[k]), rel=1e-9)
        assert ours[name].total == pytest.approx(float(theirs.total_order[k]), rel=1e-9)


def test_the_intervals_of_indices_cover_the_truth() -> None:
    """Independent: 300 plans of random points on a sum of two inputs, whose indices are known."""
    rng = np.random.default_rng(3)
    inside = []
    for _ in range(300):
        a, b = rng.normal(size=(2, 400, 2))
        blocks = [a, b, np.stack([b[:, 0], a[:, 1]], 1), np.stack([a[:, 0], b[:, 1]], 1)]
        y = np.concatenate([2.0 * x[:, 0] + x[:, 1] for x in blocks])
        for index in sobol_indices(y, ("p", "q")).inputs:
            truth = 0.8 if index.name == "p" else 0.2
            for low, high in (index.first_interval, index.total_interval):
                inside.append(low < truth < high)
    assert 0.92 < np.mean(inside) < 0.98


def test_no_indices_where_designs_lack_the_result() -> None:
    y = ishigami(saltelli_points(512))
    y[:20] = np.nan
    found = sobol_indices(y, ("x1", "x2", "x3"))
    assert (found.inputs, found.lost) == ((), 20)
    y[5:20] = 0.0
    assert sobol_indices(y, ("x1", "x2", "x3")).lost == 5


SENSITIVE: list[dict[str, Any]] = [
    {
        "field": "pulley.head.exit_tension",
        "distribution": "uniform",
        "from": "50 kN",
        "to": "70 kN",
    },
    {**FRICTION, "from": 0.9, "to": 1.1},
]


def test_swings_are_those_of_solving_one_drive(tmp_path: Path) -> None:
    """Independent: the drive file solved at the ends of the range, and 1 % to either side."""
    asked = study_of(*SENSITIVE, sampling={"samples": 8, "seed": 1}, setting="precise",
                     sensitivity={"outputs": ["exit_creep"]})  # fmt: skip
    swings = local_sensitivity(asked.study)[("design", "")]["exit_creep"]
    assert swings[0].field.endswith("friction_factor")
    (swing,) = [s for s in swings if s.field == "pulley.head.exit_tension"]
    document = parse(read_text(EXAMPLES / "studies" / "head-drive.toml"), "")

    def creep(tension: float) -> float:
        drive = drive_from_document(
            document, overrides={"pulley.head.exit_tension": f"{tension!r} N"}
        )
        arc = WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0])
        return Distributed().solve(arc).exit_creep

    low, high = (50e3 + share * 20e3 for share in RANGE)
    assert (swing.low, swing.high) == pytest.approx((low, high))
    assert swing.base == pytest.approx(creep(60e3), rel=1e-6)
    assert (swing.at_low, swing.at_high) == pytest.approx((creep(low), creep(high)), rel=1e-6)
    per_percent = 0.5 * (creep(60.6e3) - creep(59.4e3))
    assert swing.per_percent == pytest.approx(per_percent, rel=1e-5)
    run_study(asked.study, tmp_path / "a.parquet")
    found = global_sensitivity(tmp_path / "a.parquet", asked.study, ("exit_creep",))
    assert found[("design", "")]["exit_creep"].samples == 8
    run_study(study_of(TAKE_UP).study, tmp_path / "b.parquet")
    with pytest.raises(InputError, match="not those of a sensitivity study"):
        global_sensitivity(tmp_path / "b.parquet", asked.study, ("exit_creep",))


def test_a_hypercube_needs_fewer_draws_for_a_mean() -> None:
    """Spread of the mean creep over seeds: the reason to offer it, McKay and others (1979)."""
    means = {}
    for method in ("random", LatinHypercube.name):
        found = []
        for seed in range(12):
            study = study_of(
                *SENSITIVE,
                sampling={"samples": 64, "seed": seed, "method": method},
                outputs=["exit_creep"],
            ).study
            found.append(study.solve(0, 64)["exit_creep"].mean())
        means[method] = float(np.std(found))
    assert means[LatinHypercube.name] < 0.3 * means["random"]
