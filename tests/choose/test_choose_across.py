"""Choosing a lagging for an uneven pulley: unevenness left, creep paid, edges that hold."""

from __future__ import annotations

import csv
import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from choose.searches import search
from cli.running import wraparc
from wraparc import LoadCase, Tensions, load_drive, solve_across
from wraparc.across import cushion
from wraparc.answer.choose_sheet import choose_csv, choose_document, choose_sheet
from wraparc.answer.sheet import shown
from wraparc.choose import ranking
from wraparc.choose.search import Search
from wraparc.choose.selection import choose
from wraparc.drive import Across, Transition, WidthProfile
from wraparc.drive.conditions import Condition

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
    for design, over in (
        ("full-ceramic, 12 mm", "364 kN/m, max 345 kN/m (5.6 % over)"),
        ("full-ceramic, 20 mm", "356 kN/m, max 345 kN/m (3.0 % over)"),
    ):
        assert f"{design} the tension of an edge: {over} [design]" in ran.words


def uneven(cases: dict[str, tuple[float, float]], **changes: object) -> Search:
    """A search with a crown in 4 strips, load cases by name, entry and exit tension [N]."""
    base = search(
        conditions=(Condition(name="dry"),), slack_tensions=None, wrap_angles=(3.2,), **changes
    )
    crown = Across(shell_profile=WidthProfile(crown=1e-3), strips=4)
    head = replace(base.base, across=crown)
    loads = tuple(
        LoadCase(name=name, tensions={"head": Tensions(entry=a, exit=b)})
        for name, (a, b) in cases.items()
    )
    drive = replace(base.drive, pulleys=(head,), load_cases=loads)
    return replace(base, drive=drive, costing=replace(base.costing, hours={}, tariff=None))


LOADED = {"part": (90e3, 60e3), "full": (130e3, 55e3), "empty": (70e3, 55e3)}


def test_the_worst_load_case_is_named() -> None:
    """Source: every load case solved by itself; the worst is neither the first nor the last."""
    asked = uneven(LOADED)
    found = choose(asked)
    edge = found.standings["edge_tension"]
    at = found.ranking[0]
    belt = asked.belts[found.grid.places[2, at]]
    pulley = replace(
        asked.base,
        lagging=asked.laggings[found.grid.places[0, at]],
        diameter=float(found.grid.diameter[at]),
    )
    drive = replace(asked.drive, belt=belt, pulleys=(pulley,))
    alone = {n: solve_across(drive, load_case=n).largest_running_tension for n in LOADED}
    assert max(alone, key=alone.__getitem__) == "full"
    assert found.place(int(edge.where[at])) == ("head", "full", "dry")
    assert edge.value[at] == pytest.approx(alone["full"], rel=1e-9)


def test_an_edge_at_standstill_and_a_start_count() -> None:
    """Source: `solve_across`: a short transition is worst at standstill; starting bears more."""
    asked = uneven({"full": (130e3, 55e3)}, diameters=(0.9,))
    span = Transition(length=2.0, trough_angle=0.6, centre_roll=0.465)
    head = replace(asked.base, across=replace(asked.base.across or Across(), before=span))
    case = replace(asked.drive.load_cases[0], kind="starting")
    belts = tuple(replace(belt, momentary_factor=1.4) for belt in asked.belts)
    drive = replace(asked.drive, pulleys=(head,), load_cases=(case,))
    asked = replace(asked, belts=belts, drive=drive)
    found = choose(asked)
    edge = found.standings["edge_tension"]
    at = int(np.flatnonzero(np.isfinite(edge.value))[0])
    belt = asked.belts[found.grid.places[2, at]]
    lagging = asked.laggings[found.grid.places[0, at]]
    pulley = replace(head, lagging=lagging, diameter=float(found.grid.diameter[at]))
    one = solve_across(replace(asked.drive, belt=belt, pulleys=(pulley,)))
    assert one.largest_static_tension > one.largest_running_tension
    assert edge.value[at] == pytest.approx(one.largest_static_tension, rel=1e-9)
    assert edge.limit[at] == pytest.approx(1.15 * 1.4 * (belt.rating or 0.0))


def test_designs_beyond_the_first_say_that_nobody_looked_at_their_edges(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ranking, "MOST", 2)
    found = choose(uneven({"full": (130e3, 55e3)}))
    solved = np.isfinite(found.unevenness)
    named = {*found.ranking[:2], *found.creep_front, *found.slack_front, found.next_dearer()}
    assert all(solved[i] for i in named if i is not None)
    others = len(found.ranking) - int(solved[found.ranking].sum())
    assert others == len(found.unjudged) > 0
    sheet = shown(choose_sheet(found), "si")
    assert f"{others} of them not solved across the width" in sheet.subtitle
    assert any(f"{others} further designs are not" in remark for remark in sheet.remarks)
    rows = list(csv.DictReader(io.StringIO(choose_csv(found))))
    for i, row in enumerate(rows):
        assert row["across the width"] == ("solved" if solved[i] else "not solved")
        assert bool(row["entry unevenness [-]"]) == bool(row["edge tension [N/m]"]) == solved[i]
        assert bool(row["excess edge_tension"]) == solved[i]
    best = rows[found.ranking[0]]
    unevenness = float(found.unevenness[found.ranking[0]])
    assert float(best["entry unevenness [-]"]) == pytest.approx(unevenness, rel=1e-7)
    limit = 1.15 * found.search.belts[found.grid.places[2, found.ranking[0]]].rating
    assert float(best["edge limit [N/m]"]) == pytest.approx(limit, rel=1e-7)
    told = [design["solved_across"] for design in choose_document(found)["designs"]]
    assert told == solved.tolist()


def test_every_design_solved_leaves_nothing_to_say() -> None:
    found = choose(uneven({"full": (130e3, 55e3)}, diameters=(0.9,)))
    assert not len(found.unjudged)
    sheet = shown(choose_sheet(found), "si")
    assert "not solved" not in " ".join((sheet.subtitle, *sheet.remarks))


def test_the_creep_of_a_thickness_follows_the_shape_of_its_blocks() -> None:
    """Source: one rule with `Lagging.with_thickness`, solved by itself."""
    found = choose(uneven({"full": (130e3, 55e3)}, thicknesses=(8e-3, 20e-3), diameters=(0.9,)))
    for i in found.ranking:
        lagging = found.search.laggings[found.grid.places[0, i]]
        thick = lagging.with_thickness(float(found.grid.thickness[i]))
        arcs = found.grid.arcs(found.search.drive.load_cases[0], 0)
        assert arcs.compression_modulus[i] == pytest.approx(thick.compression_modulus, rel=1e-12)
