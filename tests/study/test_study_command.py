"""`wraparc study`: shipped examples, outputs, and input that cannot be used."""

import re
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from cli.running import wraparc

EXAMPLES = Path(__file__).parents[2] / "examples" / "studies"


@pytest.fixture(autouse=True)
def _wide(monkeypatch: pytest.MonkeyPatch) -> None:
    """As wide as the tables need: narrower ones break the lines that are looked for."""
    monkeypatch.setenv("COLUMNS", "140")


def test_the_grid(tmp_path: Path) -> None:
    ran = wraparc("study", EXAMPLES / "take-up-grid.toml", "-o", tmp_path / "a.parquet")
    assert ran.code == 0, ran.err
    assert "117 designs; engineering setting" in ran.words
    assert "diamond-rubber, 30 kN, 180 deg ATTENTION: the creep limit" in ran.words
    assert "57 more designs are in the file" in ran.words
    assert pq.read_metadata(tmp_path / "a.parquet").num_rows == 117
    assert "Data Friction, block, E_c illustrative; G estimated." in ran.words


def test_the_hypercube_with_all_outputs(tmp_path: Path) -> None:
    outputs = ["--plot", tmp_path / "a.svg", "--report", tmp_path / "a.html"]
    ran = wraparc(
        "study", EXAMPLES / "tolerances.toml", "-o", tmp_path / "a.parquet", *outputs,
        "--json", "-", "--set", "sampling.samples=200", "--set", "sampling.seed=5",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert ran.json["study"]["seed"] == 5
    (group,) = ran.json["groups"]
    assert group["counts"]["solved"] == 200
    assert group["convergence"][-1]["draws"] == 200
    assert "Convergence" in (tmp_path / "a.svg").read_text("utf-8")
    page = (tmp_path / "a.html").read_text("utf-8")
    assert page.count("<svg") == 1
    assert "latin-hypercube draws, seed 5" in page
    assert "<script" not in page
    assert "http" not in page.replace("http://www.w3.org", "").replace("http://purl.org", "")[:400]


def test_monte_carlo_of_a_wet_and_dry_drive(tmp_path: Path) -> None:
    ran = wraparc(
        "study", EXAMPLES / "wet-dry.toml", "-o", tmp_path / "a.parquet",
        "--set", "sampling.samples=64", "--set", 'load_cases=["design"]', "--units", "us",
        "--full",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert "design, wet: probability by exit tension" in ran.words
    assert "each condition counted by its share of the time" in ran.words
    assert "T2 for the limit 50 % [lbf]" in ran.words
    assert "wet: illustrative (about the 0.78 of the wet-season example)" in ran.words


def test_sensitivity(tmp_path: Path) -> None:
    ran = wraparc(
        "study", EXAMPLES / "sensitivity.toml", "-o", tmp_path / "a.parquet",
        "--set", "sampling.samples=64", "--plot", tmp_path / "a.png",
        "--report", tmp_path / "a.html", "--full",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert "Creep at exit, design: part of the variance (Sobol indices)" in ran.words
    assert "Peak shear stress, design: each input alone" in ran.words
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "a.html").read_text("utf-8").count("<svg") == 3


def test_load_cases_at_the_accuracy_of_solve(tmp_path: Path) -> None:
    ran = wraparc("study", EXAMPLES / "load-cases.toml", "-o", tmp_path / "a.parquet")
    assert ran.code == 0, ran.err
    assert "8 designs in 3 cases; precise setting" in ran.words
    assert "start: by belt, thickness of the lagging" in ran.words


def test_a_dry_run_only_tells_the_size(tmp_path: Path) -> None:
    ran = wraparc(
        "study", EXAMPLES / "wet-dry.toml", "-o", tmp_path / "a.parquet", "--dry-run",
        "--set", "sampling.samples=1000000",
    )  # fmt: skip
    assert ran.code == 0, ran.err
    assert "5,000,000 designs in 4 cases: 20,000,000 rows" in ran.words
    assert re.search(r" About [\d,.]+ minutes on [1-9]\d* processors?\.$", ran.words.strip())
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--set", "sampling.samples=1000000"], "--confirm 20000000"),
        (["--scheduler", "tcp://127.0.0.1:1"], "no Dask scheduler answers there"),
        (["--set", "axis[2].median=-1"], "median: must be more than 0"),
        (["--set", "axis[2].field=belt.colour"], "no such drive field"),
        (["-o", "no/such/a.parquet"], "its folder does not exist"),
        (["-o", "a.xlsx"], "must end in .parquet"),
        (["--plot", "a.gif"], "must end in .svg or .png or .pdf"),
    ],
)
def test_bad_input_is_told_before_any_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], sentence: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = wraparc("study", EXAMPLES / "wet-dry.toml", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert sentence in ran.err
    assert list(tmp_path.iterdir()) == []
