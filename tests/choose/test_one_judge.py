"""Designs of a search are judged as `solve` judges their drives, and given its least tension.

Expected values are `judge` and `least_tension` of each design, solved as a drive by itself.
"""

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from checks.test_advised_tension import as_shown, fitted
from checks.test_advised_tension import random_drives as mixed_drives
from choose.searches import FABRIC, price
from cli.running import wraparc
from wraparc import Drive, InputError, Lagging, Tensions, load_lagging, solve
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.answer.sheet import shown
from wraparc.checks import Level, Verdict, judge, least_tension
from wraparc.choose.cost import BeltPrice, Costing
from wraparc.choose.file import search_from_document
from wraparc.choose.search import Limits, Search
from wraparc.choose.selection import Selection, choose, own_slack
from wraparc.drive.conditions import Condition
from wraparc.train import solve_train
from wraparc.train.file import load_train
from wraparc.units import in_units

pytestmark = pytest.mark.usefixtures("solved_once")

SHIPPED = tuple(load_lagging(n) for n in ("diamond-rubber", "medium-ceramic", "full-ceramic"))


def search_of(of: Drive, laggings: tuple[Lagging, ...], **changes: object) -> Search:
    costing = Costing(
        currency="EUR", laggings={lag.name: price(600, 2.0) for lag in laggings},
        belts=dict.fromkeys((of.belt.name, "soft"), BeltPrice(price=50e3, life_years=10)),
    )  # fmt: skip
    base = Search(
        drive=of, pulley=of.pulleys[0].name, laggings=laggings, belts=(of.belt,),
        diameters=(0.8, 1.1), wrap_angles=(3.2, 3.6), costing=costing,
    )  # fmt: skip
    return replace(base, **changes)  # type: ignore[arg-type]


@cache
def searches() -> tuple[Search, ...]:
    """Searches over mixed drives: one to two pulleys, one to two conditions, two belts."""
    rng, found = np.random.default_rng(3), []
    conditions = (Condition(name="dry"), Condition(name="wet", factor=0.85))
    for number, one in enumerate(mixed_drives()[:24]):
        of = one
        (head,), (case,) = of.pulleys, of.load_cases
        second = case.tensions["head"]
        if number % 3 == 0:
            pull = float(rng.uniform(-0.2, 0.4)) * abs(second.entry - second.exit)
            pulleys = (head, replace(head, name="second", lagging=SHIPPED[number % 2]))
            pair = Tensions(entry=second.exit, exit=second.exit + pull)
            cases = (replace(case, tensions={**case.tensions, "second": pair}),)
            of = replace(of, pulleys=pulleys, load_cases=cases)
        own = {lag.name: lag for lag in (*SHIPPED, head.lagging)}
        soft = replace(of.belt, name="soft", modulus=0.5 * of.belt.modulus, momentary_factor=1.4)
        found.append(
            search_of(
                of, tuple(own.values()), belts=(of.belt, soft), wrap_angles=(3.4,),
                conditions=conditions[: 1 + (number % 4 == 1)],
            )
        )  # fmt: skip
    return tuple(found)


def usable(of: Search) -> bool:
    """Return whether every lagging has its friction in every condition."""
    try:
        of.conditioned()
    except InputError:
        return False
    return True


def same_standing(found: Selection, design: int) -> None:
    """Compare a design with the worst of each check of its drive."""
    verdict = found.judged(design)
    for name, standing in found.standings.items():
        checks = [c for c in verdict.checks if c.name == name and c.level is not Level.NOT_CHECKED]
        rank = max((c.level.rank for c in checks), default=0)
        assert standing.rank[design] == rank, (name, design)
        value = float(standing.value[design])
        if not checks or math.isnan(value) or not math.isfinite(standing.limit[design]):
            continue
        worst = min((c for c in checks if c.level.rank == rank), key=lambda c: c.margin)
        assert value == pytest.approx(worst.value, rel=1e-5, abs=1e-9), (name, design)
        assert standing.limit[design] == pytest.approx(worst.limit, rel=1e-9), (name, design)
    binding = {c.name for c in verdict.missed if c.binding}
    assert set(found.broken(design)) == binding & found.standings.keys()
    # how drives oppose each other is not for the design of one pulley to say
    assert binding <= {*found.standings, "opposing_drives"}


@pytest.mark.parametrize("number", range(0, 24, 4))
def test_every_design_stands_as_solve_judges_it(number: int) -> None:
    for of in searches()[number : number + 4]:
        if usable(of):
            found = choose(of)
            for design in range(0, len(found), 3):
                same_standing(found, design)


@pytest.mark.parametrize("number", range(0, 24, 4))
def test_every_design_has_the_least_tension_of_its_drive(number: int) -> None:
    for of in searches()[number : number + 4]:
        if not usable(of):
            continue
        found = choose(replace(of, slack_tensions=()))
        own = choose(of).grid
        for design in range(0, len(found), 5):
            drives = (own.drive(design, k) for k in range(len(of.conditions)))
            leasts = [least_tension(solve(d, raise_on_failure=False)) for d in drives]
            if any(least is None for least in leasts):
                continue
            asked = max(least.governing.tension for least in leasts if least is not None)
            if math.isinf(asked):
                assert found.slack_tension[design] == pytest.approx(own_slack(of))
            elif asked > 2.0:
                assert found.slack_tension[design] == pytest.approx(asked, rel=2e-5)


def test_an_interval_and_a_tested_slip_set_the_least_tension() -> None:
    of = mixed_drives()[0]
    head = replace(of.pulleys[0], lagging=fitted(0.05))
    drive = replace(of, pulleys=(head,), belt=replace(FABRIC, rating=None), creep_limit=4e-3)
    found = choose(search_of(drive, (head.lagging,), slack_tensions=()))
    for design in range(len(found)):
        least = least_tension(solve(choose(search_of(drive, (head.lagging,))).grid.drive(design)))
        assert least is not None
        assert found.slack_tension[design] == pytest.approx(least.tension, rel=2e-5)
        assert "creep_interval" in {figure.name for figure in least.required}


DRIVE = """format = 1
title = "edge"
covered = true
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
effective_tension = "80 kN"
exit_tension = "{slack}"
[design_standard]
name = "none"
{more}
"""
SEARCH = """format = 1
drive = "drive.toml"
[candidates]
slack_tensions = {slack}
[limits]
{limits}
[cost]
currency = "AUD"
"""
SAG = '[sag]\nidler_spacing = "6 m"\nline_mass = "200 kg/m"'


def files(folder: Path, slack: str, more: str = "", limits: str = "", least: bool = False) -> Path:
    (folder / "drive.toml").write_text(DRIVE.format(slack=slack, more=more), "utf-8")
    kept = '"least"' if least else f'["{slack}"]'
    (folder / "search.toml").write_text(SEARCH.format(slack=kept, limits=limits), "utf-8")
    return folder / "search.toml"


@pytest.mark.parametrize(
    ("slack", "more"),
    [
        ("61171.240 N", ""),  # on the creep limit in four digits
        ("80 kN", ""),
        ("45 kN", ""),  # over the creep limit
        ("2 kN", ""),  # gross slip
        ("62 kN", SAG),
        ("300 kN", ""),  # over the rating
    ],
)
def test_the_only_candidate_is_told_as_solve_tells_it(
    slack: str, more: str, tmp_path: Path
) -> None:
    search = files(tmp_path, slack, more)
    solved, chosen = wraparc("solve", tmp_path / "drive.toml"), wraparc("choose", search)
    assert (chosen.code, chosen.err) == (solved.code, "")
    drive = search_from_document({"format": 1, "drive": str(tmp_path / "drive.toml"),
                                  "candidates": {}, "cost": {"currency": "AUD"}}).drive  # fmt: skip
    verdict = judge(solve(drive, raise_on_failure=False))
    assert re.search(rf"^{verdict.level.value}  ", chosen.out, re.MULTILINE)
    assert solved.words.partition(" ")[2].startswith(verdict.level.value)
    also_of(chosen.words, verdict)


def also_of(words: str, verdict: Verdict) -> None:
    """The first two that are missed are told, and how many more there are."""
    for check in verdict.missed[:2]:
        level = "" if check.level is verdict.level else f"{check.level}: "
        assert f"Also {level}{in_units(check.text)}" in words
    more = len(verdict.missed) - 2
    assert (f"Also {more} more (" in words) == (more > 0)


MOTOR = """[train.motor.{name}]
kind = "induction"
rated_power = "{power} kW"
rated_speed = "1480 rpm"
synchronous_speed = "1500 rpm"
gear_ratio = 20.666
"""


@pytest.mark.parametrize("power", [60, 110, 130])  # overloaded, by 3 % in one, enough
def test_motors_are_judged_as_solve_judges_them(power: int, tmp_path: Path) -> None:
    """The load of a train divides anew by its motors in what a search recommends."""
    search = files(tmp_path, "45 kN")
    text = (tmp_path / "drive.toml").read_text("utf-8")
    pulley = "".join(row for row in pulley_of(text).splitlines(True) if "tension" not in row)
    train = '[train]\nexit_tension = "45 kN"\neffective_tension = "72 kN"\n'
    for name in ("head", "second"):
        train += MOTOR.format(name=name, power=power)
    pulleys = pulley + pulley.replace('"head"', '"second"')
    (tmp_path / "drive.toml").write_text(text.replace(pulley_of(text), pulleys + train), "utf-8")
    search.write_text(
        'format = 1\ndrive = "drive.toml"\npulley = "head"\n[candidates]\n'
        '[cost]\ncurrency = "AUD"\n', "utf-8",
    )  # fmt: skip
    chosen = wraparc("choose", search)
    drive = load_train(tmp_path / "drive.toml")
    verdict = judge(solve_train(drive, raise_on_failure=False))
    assert chosen.code == (1 if verdict.level is Level.FAILS else 0)
    assert {c.name for c in verdict.missed if "motor" in c.name} == (
        set() if power == 130 else {"motor_load"}
    )
    also_of(chosen.words, verdict)


def pulley_of(text: str) -> str:
    """Return the pulleys of a drive file."""
    return text[text.index("[[pulley]]") : text.index("[design_standard]")]


def test_the_least_tension_of_a_search_is_that_of_the_sag_of_the_drive(tmp_path: Path) -> None:
    """By hand: m' g l/(8 h) = 200 kg/m 9.80665 m/s2 6 m/0.16 = 73.55 kN."""
    chosen = wraparc("choose", files(tmp_path, "62 kN", SAG, least=True))
    assert "Lowest cost: diamond-rubber with T2 73.6 kN," in chosen.words
    assert as_shown(200.0 * 9.80665 * 6.0 / 0.16) == 73.6e3


def test_a_search_again_is_advised_where_a_limit_was_named_alone(tmp_path: Path) -> None:
    again = "Search again with that limit"
    named = wraparc("choose", files(tmp_path, "45 kN", limits='creep = "20 mm"'))
    assert again in named.words
    unnamed = files(tmp_path, "45 kN")
    assert again not in wraparc("choose", unnamed).words
    # it passes what it must, and wet, of which no limit was named, it does not
    open_air = files(tmp_path, "80 kN")
    text = (tmp_path / "drive.toml").read_text("utf-8").replace("covered = true\n", "")
    (tmp_path / "drive.toml").write_text(text, "utf-8")
    ran = wraparc("choose", open_air)
    assert "Wet creep" in ran.words
    assert again not in ran.words


def test_other_numbers_of_a_search_judge_the_same_checks() -> None:
    """Design by design: a limit at the value that `solve` finds is kept, one below is not."""
    of = search_of(mixed_drives()[1], SHIPPED)
    found = choose(of)
    design = int(np.flatnonzero(~np.isnan(found.creep))[0])
    for name, value in (("creep", found.creep), ("bond_stress", found.bond_stress)):
        for factor, broken in ((1.0 + 1e-5, False), (0.99, True)):
            limits = Limits(**{name: float(value[design]) * factor})  # type: ignore[arg-type]
            standing = choose(replace(of, limits=limits)).standings[name]
            assert bool(standing.broken[design]) is broken
    safety = float(found.standings["gross_slip"].value[design])
    for factor, broken in ((1.0 - 1e-5, False), (1.01, True)):
        limits = Limits(gross_slip_safety=safety * factor)
        standing = choose(replace(of, limits=limits)).standings["gross_slip"]
        assert bool(standing.broken[design]) is broken


def test_the_old_name_of_a_limit_is_refused_with_the_new_one(tmp_path: Path) -> None:
    ran = wraparc("choose", files(tmp_path, "80 kN", limits="gross_slip_margin = 1.5"))
    assert ran.code == 2
    assert (
        "limits.gross_slip_margin: no check compares this extrapolated ratio, got 1.5."
        in " ".join(ran.err.split())
    )
    assert "limits.gross_slip_safety" in " ".join(ran.err.split())


def test_a_covered_drive_is_not_searched_wet(tmp_path: Path) -> None:
    search = files(tmp_path, "80 kN")
    search.write_text(search.read_text("utf-8") + '[[condition]]\nname = "wet"\n', "utf-8")
    ran = wraparc("choose", search)
    assert ran.code == 2
    assert 'covered: contradicts condition "wet", got true.' in " ".join(ran.err.split())


def test_the_sheet_of_a_search_without_a_good_design_names_the_closest() -> None:
    of = search_of(mixed_drives()[1], SHIPPED, limits=Limits(creep=1e-4))
    found = choose(of)
    told = shown(choose_sheet(found), "si").verdict
    assert told is not None
    assert told.level is Level.FAILS
    assert told.text.startswith("No candidate passes. Closest: ")
    assert "the creep limit" in " ".join(told.sentences)
