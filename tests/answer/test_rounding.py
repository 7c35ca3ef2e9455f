"""What rounding leaves is shown by no door: results moved in their last bits read the same.

Expected: the texts of the same result, every number of it moved by a few units in the last place,
and every zero by what is left of a difference of two equal numbers of that size.
"""

import json
import math
import re
import shutil
from collections.abc import Iterator
from dataclasses import replace
from functools import cache, partial
from importlib import import_module
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typst
from python_calamine import CalamineWorkbook

from answer.moving import moved
from cli.running import wraparc
from wraparc import Distributed, TrainResult, load_drive, load_train, shear_test, solve, solve_train
from wraparc.across import AcrossSolver
from wraparc.answer.arc_tables import answer_table
from wraparc.answer.checks_table import check_data, check_table, used_text
from wraparc.answer.document import json_text
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.sheet import Sheet, percent, shown
from wraparc.answer.sheet import shown as told_in
from wraparc.answer.train_sheet import signed, train_sheet
from wraparc.answer.train_words import case_sentences
from wraparc.answer.verdict_data import verdict_object
from wraparc.checks import Check, Level, judge
from wraparc.checks.numbers import MOST_USED, margin_of, order_of
from wraparc.cli import motion
from wraparc.drive import Tensions
from wraparc.motion import vibration
from wraparc.render.profile_csv import profile_csv
from wraparc.study.parameter_study import Study
from wraparc.units import System, display
from wraparc.web.answers.rows import csv_bytes

EXAMPLES = Path(__file__).parents[2] / "examples"
TRAINS = ("tandem-fabric", "triple-steel-cord")
IDLE = ["pulley.head.entry_tension=60 kN"]


def differing(one: Sheet, other: Sheet) -> list[tuple[str, str]]:
    """Return the pairs of texts in which two sheets differ."""

    def texts(sheet: Sheet) -> Iterator[str]:
        yield from (sheet.title, sheet.subtitle, *sheet.remarks, *sheet.sources)
        if sheet.verdict is not None:
            data = verdict_object(sheet.verdict, str)  # with its numbers and places
            yield from (f"{name}: {told}" for name, told in words(data))
        for table in sheet.tables:
            yield from (table.title, table.note, *table.heads)
            for row in table.rows:
                yield f"{row.title}: {' | '.join(map(str, row.values))} {row.note} {row.level}"

    pairs = zip_longest(texts(one), texts(other))
    return [(a, b) for a, b in pairs if a != b]


@pytest.mark.parametrize("name", TRAINS)
def test_a_train_reads_the_same(name: str) -> None:
    train = load_train(EXAMPLES / f"{name}.toml")
    result = solve_train(train, method=Distributed(capacities=False, points=20))
    systems: tuple[System, ...] = ("si", "us")
    for seed in range(3):
        other: TrainResult = moved(result, np.random.default_rng(seed))
        assert other != result
        for system in systems:
            assert differing(*(shown(train_sheet(r), system) for r in (result, other))) == []


@pytest.mark.parametrize(
    ("name", "changes"),
    [("head-drive-fabric", []), ("head-drive-fabric", IDLE), ("downhill-braking", [])],
)
def test_a_drive_reads_the_same(
    name: str, changes: list[str], request: pytest.FixtureRequest
) -> None:
    if changes:  # the command of `IDLES` has its action
        request.getfixturevalue("untried")
    drive = load_drive(EXAMPLES / f"{name}.toml", overrides=changes)
    result = solve(drive, method=Distributed(points=20))
    for seed in range(3):
        other = moved(result, np.random.default_rng(seed))
        assert differing(*(shown(drive_sheet([r]), "si") for r in (result, other))) == []


def test_tensions_equal_to_rounding_are_equal() -> None:
    """Expected: the texts of a pulley that idles exactly."""
    drive = load_drive(EXAMPLES / "head-drive-fabric.toml", overrides=IDLE)
    (case, *_) = drive.load_cases
    texts = []
    for part in (0.0, 2.3e-16, -2.3e-16, 5e-13):
        level = {n: Tensions(entry=60e3 * (1.0 + part), exit=60e3) for n in case.tensions}
        idle = replace(drive, load_cases=(replace(case, tensions=level),))
        result = solve(idle, method=Distributed(points=20))
        assert result.arcs[0].effective_tension == 0.0
        texts.append(shown(drive_sheet([result]), "si"))
    assert all(differing(texts[0], text) == [] for text in texts[1:])


def test_an_idle_pulley_has_no_spring_rate() -> None:
    """Expected: equation 7 of the paper divides the stretch, of which there is none."""
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"), method=Distributed(points=20))
    for creep in (0.0, 1e-18, -3e-17):
        arcs = tuple(replace(arc, exit_creep=creep) for arc in result.arcs)
        titles = [row.title for row in told_in(answer_table(arcs), "si").rows]
        assert not any("Spring rate" in title for title in titles)
        assert all(math.isnan(arc.k_factor) for arc in arcs)
    assert any("Spring rate" in row.title for row in told_in(answer_table(result.arcs), "si").rows)


def test_what_is_below_its_accuracy_is_told_so() -> None:
    """Expected: by hand, the limit of a check of the solution is the accuracy of its value."""
    kept = Check(name="balance", title="Balance", level=Level.OK, value=2e-16, limit=1e-4)
    assert told_in(kept.texts(), "si") == ("< 1e-4", "1e-4")
    assert told_in(kept.text, "si") == "Balance: < 1e-4 of 1e-4."
    assert (kept.margin, told_in(used_text(kept), "si")) == (1.0, "-")
    data = check_data(kept)
    assert (data["value"], data["floor"]) == (2e-16, 1e-4)
    missed = replace(kept, level=Level.FAULT, value=3e-4, headline="Misses by {value}")
    assert told_in(missed.text, "si") == "Misses by 0.0003."
    assert missed.margin == pytest.approx(-2.0)
    creep = replace(kept, name="creep", value=2e-3, limit=6.35e-3, dimension="length")
    assert (told_in(creep.texts(), "si")[0], creep.floor) == ("2 mm", 0.0)


def test_the_place_of_a_check_of_the_solution_is_not_that_of_the_largest_noise() -> None:
    result = solve(load_drive(EXAMPLES / "triple-steel-cord.toml"), method=Distributed(points=20))
    places = {next(c.place for c in judge(r).listed if c.name == "balance")
              for r in (result, moved(result, np.random.default_rng(1)))}  # fmt: skip
    assert len(places) == 1
    rows = told_in(check_table(judge(result)), "si").rows
    values = {row.name: row.values[0] for row in rows if "balance" in row.name}
    assert values == {"balance": "< 1e-4"}


def test_nothing_is_minus_nothing() -> None:
    assert display(-0.0, "force") == display(-3e-7, "force") == "0 kN"
    assert display(-4e-13, "length", digits=3) == "0 mm"
    assert display(4e-12, "wear_coefficient") == "0.004 mm3/J"
    assert display(1.2e-19, "wear_coefficient") == "1.200e-10 mm3/J"
    assert (
        told_in(percent(-0.0), "si")
        == told_in(percent(-1e-12), "si")
        == told_in(percent(3e-13), "si")
        == "0 %"
    )
    assert [told_in(signed(v), "si") for v in (-0.0, 2e-9, -2e-9)] == 3 * ["0 %"]
    assert "-0" not in json_text({"a": -0.0, "b": [-0.0], "c": {"d": (-0.0,)}})
    assert math.copysign(1.0, margin_of(2.0, 2.0, False)) == 1.0
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"), method=Distributed(points=20))
    arc = result.arcs[0]
    columns = dict(moved(arc.profile, np.random.default_rng(1)).columns())
    assert all(not (0.0 < abs(v) < 4e-15 * abs(c).max()) for c in columns.values() for v in c)
    still = replace(arc, profile=replace(arc.profile, slip=np.full(len(arc.profile), -0.0)))
    cells = {cell for line in profile_csv([still]).splitlines() for cell in line.split(",")}
    assert "0" in cells
    assert "-0" not in cells
    assert b"-0" not in csv_bytes([{"a": -0.0, "b": 1.0}])
    assert math.isfinite(json.loads(json_text({"a": -0.0}))["a"])


def test_a_term_of_which_no_digit_shows_has_no_sign() -> None:
    """Expected: by hand, terms of speeds are told in percent to three places behind the point."""
    result = solve_train(
        load_train(EXAMPLES / "tandem-fabric.toml"), method=Distributed(capacities=False, points=20)
    )
    (case, *_), told = result, {}
    for term in (0.0, -0.0, 3e-16, -3e-16, 4.9e-6, -4.9e-6, 5.1e-6, -5.1e-6):
        first, second = case.members
        members = (first, replace(second, contraction_term=term))
        changed = replace(case, members=members)
        sentences = told_in(tuple(case_sentences(changed, result.cases)), "si")
        (told[repr(term)],) = (s for s in sentences if "belt contraction" in s)
    shown = {t: s.partition("contraction ")[2].partition(",")[0] for t, s in told.items()}
    assert (shown.pop("5.1e-06"), shown.pop("-5.1e-06")) == ("+0.001 %", "-0.001 %")
    assert set(shown.values()) == {"0 %"}


def test_alike_margins_govern_in_their_order_however_large() -> None:
    """Expected: by hand; equal to rounding is equal, and what cannot be rounded is itself."""
    for missed in (False, True):
        place = partial(order_of, missed=missed, kind=0.0)
        assert place(0.3) == place(0.3 + 3e-16)
        assert place(0.3) > place(0.3 + 3e-9), "the most used first"
        assert place(3e3) > place(MOST_USED) == place(1e305) == place(math.inf)
    assert order_of(math.nan, False, 0.0) == math.inf, "without a number: last of what passes"
    assert order_of(math.nan, True, 0.0) == order_of(math.inf, True, 0.0), "first of what misses"
    assert order_of(0.1, True, 1.0) > order_of(math.inf, True, 0.0), "the kind before the use"
    assert order_of(math.inf, True, 1.0) > order_of(0.1, True, 0.0)


#: Letters of a picture, which stay letters.
LABEL = re.compile(r"<text[^>]*>([^<]*)<")


def source(parts: dict[str, bytes], **_: Any) -> bytes:
    """Return what a PDF is set from, in the place of the PDF: its words, the labels it draws."""
    lines = [f"{k} {v}" for k, v in words(json.loads(parts["data.json"]))]
    for name in sorted(parts):
        lines += LABEL.findall(parts[name].decode("utf-8")) if name.endswith(".svg") else []
    return "\n".join(lines).encode("utf-8")


def doors(folder: Path, *arguments: str) -> list[str]:
    """Return the lines that a command prints and writes, the cells of a workbook in rows."""
    ran = wraparc(*arguments)
    assert ran.code in (0, 1), ran.err
    lines = ran.out.splitlines()
    for file in sorted(folder.glob("out.*")):
        if file.suffix == ".svg":
            lines += LABEL.findall(file.read_text("utf-8"))
        elif file.suffix == ".parquet":
            pass  # data, to their last bit
        elif file.suffix == ".xlsx":
            sheets = CalamineWorkbook.from_path(file)
            for name in sheets.sheet_names:
                for row in sheets.get_sheet_by_name(name).to_python():
                    # numbers have every digit: nine are known
                    cells = [f"{c:.9g}" if isinstance(c, float) else f"{c}" for c in row]
                    lines.append(" | ".join(cells))
        elif file.suffix == ".json":
            lines += [f"{k} {v}" for k, v in words(json.loads(file.read_text("utf-8")))]
        else:
            lines += file.read_text("utf-8").splitlines()
    return lines


def words(value: Any, place: str = "") -> Iterator[tuple[str, str]]:
    """Yield what a JSON answer holds: every key, and every text under it."""
    if isinstance(value, dict):
        for key, under in value.items():
            yield from words(under, f"{place}.{key}")
    elif isinstance(value, list):
        for number, under in enumerate(value):
            yield from words(under, f"{place}[{number}]")
    else:
        yield place, value if isinstance(value, str) else type(value).__name__


across = import_module("wraparc.across.solve")  # which keeps what was solved
IDLES = ("head-drive-fabric.toml", "--set", *IDLE)  # nothing is carried, all is zero
COMMANDS = [
    ("solve", *IDLES),
    ("solve", *IDLES, "--no-reserve", "--full", "--json", "out.json", "--csv", "out.csv", "--plot",
     "out.svg"),
    ("solve", f"worn-{IDLES[0]}", *IDLES[1:], "--full", "--json", "out.json"),
    ("field", *IDLES, "--wear-coefficient", "0.001 mm3/J", "--full", "--json", "out.json"),
    ("what-if", "idle.toml", "--thickness", "10 mm", "--full", "--json", "out.json"),
    ("report", *IDLES, "-o", "out.md", "--date", "-"),
    ("solve", "worn-head-drive-fabric.toml", "--full", "--json", "out.json", "--plot", "out.svg",
     "--map", "out.map.svg"),
    ("solve", "tandem-steel-cord.toml", "--full", "--json", "out.json", "--units", "us",
     "--plot", "out.svg"),
    ("trim", "tandem-fabric.toml", "--points", "3", "--full", "--json", "out.json",
     "--plot", "out.svg"),
    ("what-if", "studies/head-drive.toml", "--belt", "Flexsteel ST1000", "--lagging",
     "full-ceramic", "--worn", "6 mm", "--wet", "0.7", "--full", "--json", "out.json"),
    ("field", "head-drive-fabric.toml", "--wear-coefficient", "0.001 mm3/J", "--full",
     "--json", "out.json"),
    ("seek", "head-drive-fabric.toml", "--vary", "pulley.head.wrap_angle", "--result",
     "exit_creep", "--value", "6 mm", "--full", "--json", "out.json"),
    ("family", "head-drive-fabric.toml", "--ratios", "1.5,2", "--json", "out.json",
     "--plot", "out.svg"),
    ("choose", "wet-season/choose.toml", "--full", "--json", "out.json", "--csv", "out.csv",
     "--plot", "out.svg"),
    ("run", "tandem-fabric.toml", "--event", "run-out", "--quiet", "--full", "--plot", "out.svg",
     "--points", "10"),
    ("stability", "tandem-fabric.toml", "--full"),
    ("fit", "shear_tests/plan.toml", "--full", "--json", "out.json"),
    ("overlay", "test-pulley/published-pair.toml", "--full"),
    ("calibrate", "test-pulley/published-pair.toml", "--full", "--json", "out.json"),
    ("study", "studies/sensitivity.toml", "-o", "out.parquet", "--full", "--json", "out.json",
     "--plot", "out.svg", "--set", "sampling.samples=64"),
    ("report", "downhill-braking.toml", "-o", "out.md", "--date", "-"),
    ("report", "worn-head-drive-fabric.toml", "-o", "out.pdf", "--date", "-", "--units", "us"),
    ("report", "tandem-steel-cord.toml", "-o", "out.pdf", "--date", "-"),
    ("report", "tandem-steel-cord.toml", "-o", "out.xlsx", "--date", "-"),
]  # fmt: skip
_IDLE = 6  # commands that idle


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_door_reads_the_same(
    command: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    request: pytest.FixtureRequest,
) -> None:
    """Every solution that a command is made of moved: arcs, belts across, events, columns, fits.

    Short answers, and what the server says, are moved so by `golden/test_golden.py`, the page of
    one file by `web/test_page_file_trains.py`. Read are texts, JSON, tables, cells, what a PDF is
    set from, and the labels of pictures.
    """
    shutil.copytree(EXAMPLES, tmp_path, dirs_exist_ok=True)
    idle = (EXAMPLES / IDLES[0]).read_text("utf-8").replace('"150 kN"', '"60 kN"')
    (tmp_path / "idle.toml").write_text(idle, "utf-8")
    monkeypatch.chdir(tmp_path)
    if command in COMMANDS[1:_IDLE]:  # the first has its action, which takes seconds to find
        request.getfixturevalue("untried")
    seeds: list[int] = []

    def moving(solve: Any) -> Any:
        def moved_after(*arguments: Any, **more: Any) -> Any:
            found = solve(*arguments, **more)
            return moved(found, np.random.default_rng(seeds[0])) if seeds else found

        return moved_after

    def fitted(*arguments: Any, **more: Any) -> Any:
        if not seeds:  # the second time the same is asked
            kept.append(fit_plan(*arguments, **more))
        return kept[-1]

    monkeypatch.setattr(typst, "compile", source)
    monkeypatch.setattr(Distributed, "solve", cache(Distributed.solve))
    kept, fit_plan = list[Any](), shear_test.fit_plan
    monkeypatch.setattr(shear_test, "fit_plan", fitted)
    for owner, name in (
        (Distributed, "solve"), (AcrossSolver, "solve"), (across, "_solved"),
        (Study, "solve_values"), (motion, "simulate"), (vibration, "stability"),
        (shear_test, "fit_plan"),
    ):  # fmt: skip
        monkeypatch.setattr(owner, name, moving(getattr(owner, name)))
    expected = doors(tmp_path, *command)
    assert len(expected) > 5
    seeds.append(2)
    found = doors(tmp_path, *command)
    assert [x for x in zip_longest(expected, found) if x[0] != x[1]] == []
