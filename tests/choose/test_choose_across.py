"""Choosing a lagging for an uneven pulley: unevenness left, creep paid, edges that hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import load_drive
from wraparc.across import cushion

DRIVE = Path(__file__).parents[2] / "examples" / "worn-head-drive-steel-cord.toml"
CHOOSE = """
format = 1
drive = "drive.toml"
[candidates]
laggings = ["full-ceramic"]
thicknesses = ["12 mm", "20 mm"]
[limits]
creep = "15 mm"
tested_pressure = false
belt_rating = false
[cost]
currency = "AUD"
years = 10
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    text = DRIVE.read_text("utf-8").replace('after = { kind = "pulley"', "strips = 8\n#after = {")
    (tmp_path / "drive.toml").write_text(text, "utf-8")
    path = tmp_path / "choose.toml"
    path.write_text(CHOOSE, "utf-8")
    return path


def test_thickness_is_chosen_with_the_unevenness_it_leaves(file: Path) -> None:
    """Source: `cushion`, which solves each thickness by itself."""
    clean = 'build_up = [["200 mm", "0 mm"], ["600 mm", "0.4 mm"]]'
    drive = file.parent / "drive.toml"
    lines = [clean if x.startswith("build_up") else x for x in drive.read_text("utf-8").split("\n")]
    drive.write_text("\n".join(lines), "utf-8")
    ran = wraparc("choose", file, "--json", "-")
    assert ran.code == 0, ran.out
    found = cushion(load_drive(drive), [12e-3, 20e-3])
    for design, result in zip(ran.json["designs"], found.results, strict=True):
        assert design["entry_unevenness"] == pytest.approx(result.entry_unevenness, rel=1e-6)
        assert design["creep"] > 0.0
    thin, thick = (d["entry_unevenness"] for d in ran.json["designs"])
    assert thick < thin
    assert "uneven: tightest strip at the entry over the mean" in wraparc("choose", file).words


def test_a_design_whose_edge_is_over_its_rating_is_rejected(file: Path) -> None:
    ran = wraparc("choose", file)
    assert ran.code == 1
    words = ran.words.partition("tension of an edge")[2]
    assert "at most 345" in words, ran.words
