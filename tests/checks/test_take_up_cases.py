"""The take-up stands at one place and holds one tension there, whatever the load case.

Expected: drives that drive, brake and do both, solved anew with the least tension that was told set
at the take-up in every load case. They keep every check that asks for tension, and miss one with
1 % less.
"""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from answer.drives import BELT
from checks.test_least_tension import FROM_ABOVE
from checks.test_of_trains import TANDEM
from checks.test_take_up import train_of
from wraparc import (
    Drive,
    InputError,
    LoadCase,
    Tensions,
    load_drive,
    load_lagging,
    load_train,
    solve,
    solve_train,
)
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.answer.least_tension import least_table
from wraparc.answer.sheet import shown
from wraparc.checks import judge, least_tension
from wraparc.checks.of_drive import take_up
from wraparc.checks.rules import RULES
from wraparc.choose.file import load_search
from wraparc.choose.selection import choose
from wraparc.conveyor import Conveyor
from wraparc.drive import Criteria, Pulley, Sag, TakeUp
from wraparc.files.conveyor_build import load_case
from wraparc.units import parse_quantity

#: Checks that more tension on the slack side helps against.
RAISING = {rule.name for rule in RULES.values() if rule.tension == "raise"}
NAMES = ("diamond-rubber", "medium-ceramic", "full-ceramic")
RUNNING, BRAKING = "running", "braking"


def missed(of: Drive) -> set[str]:
    """Checks that ask for tension and are missed."""
    told = judge(solve(of, raise_on_failure=False))
    return {c.name for c in told.missed if c.binding or c.name in RAISING} - FROM_ABOVE


def at(of: Drive, tension: float, given: float = math.nan) -> Drive | None:
    """Return a drive with its take-up at a tension, pulls held; None where a belt would push.

    Where all tensions are lifted alike, as by a fixed take-up, `given` is the tension before.
    """
    try:
        if of.conveyor is not None:
            return by(replace(of.conveyor, take_up_tension=tension, counterweight=None), of)
        cases = []
        for case in of.load_cases:
            rise = tension - (given if of.criteria.take_up.fixed else held_in(of, case))
            raised = {
                name: Tensions(entry=t.entry + rise, exit=t.exit + rise)
                for name, t in case.tensions.items()
            }
            cases.append(replace(case, tensions=raised))
        return replace(of, load_cases=tuple(cases))
    except InputError:
        return None


def held_in(of: Drive, case: LoadCase) -> float:
    """Tension that `givens` holds in every load case: behind a pulley, or ahead of all [N]."""
    if of.criteria.take_up.after:
        return case.tensions[of.criteria.take_up.after].exit
    if of.title == "ahead":
        return case.tensions[of.pulleys[0].name].entry
    return case.tensions[of.pulleys[-1].name].exit


def by(conveyor: Conveyor, of: Drive) -> Drive:
    """Return a drive with the load cases of a conveyor."""
    cases = tuple(load_case(state, of.pulleys[0].name, {}) for state in conveyor.states())
    return replace(of, conveyor=conveyor, load_cases=cases)


def as_told(of: Drive) -> str:
    """Follow the least tension of a drive and its counterweight; return which check set it."""
    result = solve(of, raise_on_failure=False)
    found = least_tension(result)
    assert found is not None
    if not math.isfinite(found.governing.tension):
        return ""
    least = found.governing.tension
    high, low = (at(of, f * least, found.given) for f in (1.0 + 1e-6, 0.99))
    assert high is not None
    sets = {f.name for f in found.required}
    assert not missed(high) & sets
    assert low is None or missed(low) & sets
    if math.isinf(found.tension):
        return ""
    assert found.counterweight == pytest.approx(2.0 * least / 9.80665)
    table = least_table(result)
    assert table is not None
    held, mass, *_ = (shown(row, "si").values[0] for row in table.rows)
    weight = parse_quantity(mass, "mass") * 9.80665
    for tension in (parse_quantity(held, "force"), weight / 2.0):  # as printed: rounded up
        assert least <= tension < 1.011 * least
    return found.governing.name


def pulley(rng: np.random.Generator, name: str) -> Pulley:
    return Pulley(
        name=name, diameter=float(rng.uniform(0.6, 1.2)), wrap_angle=float(rng.uniform(2.9, 3.8)),
        lagging=load_lagging(str(rng.choice(NAMES))),
    )  # fmt: skip


def criteria(rng: np.random.Generator, **take_up: Any) -> Criteria:
    sag = Sag(spacing=3.0, line_mass=float(rng.uniform(20.0, 240.0)))
    return Criteria(sag=sag if rng.uniform() < 0.5 else None, take_up=TakeUp(**take_up))


def conveyors(count: int) -> list[Drive]:
    """Uphill, level and downhill, the take-up at the head, at the tail and between."""
    rng, found = np.random.default_rng(11), list[Drive]()
    belt = replace(BELT, speed=3.0, rating=400e3)
    while len(found) < count:
        length = float(rng.uniform(100.0, 800.0))
        one = Conveyor(
            length=length, lift=float(rng.uniform(-0.1, 0.06)) * length, belt_mass=22.0,
            carry_idler_mass=16.0, return_idler_mass=6.0, speed=3.0,
            material_mass=float(rng.uniform(40.0, 150.0)), take_up_tension=150e3,
            take_up_distance=float(rng.choice([0.0, 0.5, 1.0])) * length,
            drive_at=str(rng.choice(["head", "tail"])),
            start_time=float(rng.choice([12.0, 30.0])), stop_time=float(rng.choice([5.0, 20.0])),
        )  # fmt: skip
        of = Drive(
            belt=belt, pulleys=(pulley(rng, "head"),), criteria=criteria(rng),
            load_cases=(LoadCase(name="x", tensions={"head": Tensions(entry=2e5, exit=1e5)}),),
        )  # fmt: skip
        found.append(by(one, of))
    return found


def givens(count: int) -> list[Drive]:
    """One to three pulleys; driving, braking and both; gravity, winch and fixed take-ups."""
    rng, found = np.random.default_rng(7), list[Drive]()
    for number in range(count):
        names = ["a", "b", "c"][: 1 + number % 3]
        kind, after = [("gravity", ""), ("winch", ""), ("fixed", ""), ("", names[0])][number % 4]
        held, cases = float(rng.uniform(80e3, 160e3)), []
        ways = [(1, RUNNING), (-1, BRAKING), (1, "starting")]
        signs = [ways, ways[::2], [(-1, RUNNING), (-1, BRAKING)]][number // 4 % 3]
        ahead = bool(rng.uniform() < 0.3)  # of all pulleys
        for sign, what in signs:
            pulls = [sign * float(rng.uniform(5e3, 70e3 / len(names))) for _ in names]
            entry = held + (0.5 * sum(pulls) if kind == "fixed" else 0.0 if ahead else sum(pulls))
            if after:
                entry = held + pulls[0]
            pairs = {}
            for name, pull in zip(names, pulls, strict=True):
                pairs[name], entry = Tensions(entry=entry, exit=entry - pull), entry - pull
            cases.append(LoadCase(name=f"{what} {sign}", kind=what, tensions=pairs))  # type: ignore[arg-type]
        found.append(Drive(
            title="ahead" if ahead else "", belt=replace(BELT, rating=400e3),
            pulleys=tuple(pulley(rng, n) for n in names),
            criteria=criteria(rng, kind=kind, after=after), load_cases=tuple(cases),
        ))  # fmt: skip
    return found


def test_what_is_told_of_a_conveyor_is_what_it_needs_and_no_more() -> None:
    drives = conveyors(8)
    governs = [as_told(of) for of in drives]
    assert len({name for name in governs if name}) > 1
    assert any(of.take_up_place for of in drives)


def test_what_is_told_of_given_tensions_is_what_they_need_and_no_more() -> None:
    drives = givens(12)
    governs = [as_told(of) for of in drives]
    assert sum(1 for name in governs if name) > 8
    assert len({name for name in governs if name}) > 1
    places = {of.take_up_place.removesuffix(of.pulleys[-1].name) for of in drives}
    assert {"", "at the take-up behind pulley "} < places


def test_the_far_end_of_a_conveyor_does_not_hang_slack() -> None:
    """By hand: 45 m up, the belt of 20 kg/m leaves the tail 20 g 45 = 8826 N below the take-up.

    The friction of the return strand adds 0.005 (20 + 1) g 300 = 309 N.
    """
    one = Conveyor(length=300.0, lift=45.0, belt_mass=20.0, carry_idler_mass=1.0,
                   return_idler_mass=1.0, material_mass=0.001, friction_factor=0.005,
                   secondary_resistance=0.0, take_up_tension=30e3)  # fmt: skip
    of = Drive(
        belt=BELT, pulleys=(Pulley(name="head", diameter=0.8, wrap_angle=3.2,
                                   lagging=load_lagging("full-ceramic")),),
        load_cases=(LoadCase(name="x", tensions={"head": Tensions(entry=2e5, exit=1e5)}),),
    )  # fmt: skip
    found = least_tension(solve(by(one, of), raise_on_failure=False))
    assert found is not None
    taut = next(f for f in found.figures if f.name == "taut")
    assert taut.tension == pytest.approx(8826.0 - 309.0, rel=1e-3)


DOWNHILL = """\
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "1000 mm"
lagging = "diamond-rubber"
wrap_angle = "200 deg"
[conveyor]
length = "600 m"
lift = "-60 m"
capacity = "1000 t/h"
belt_mass = "22 kg/m"
carry_idler_mass = "16 kg/m"
return_idler_mass = "6 kg/m"
take_up_tension = "40 kN"
"""
SEARCH = """\
format = 1
drive = "drive.toml"
[candidates]
laggings = ["diamond-rubber", "full-ceramic"]
slack_tensions = "least"
[cost]
currency = "AUD"
tariff = 0.1
hours.full = 6000
"""


def test_a_choice_for_a_conveyor_is_what_its_drive_needs(tmp_path: Path) -> None:
    """The conveyor of the drive file, with the lagging and the tension that were chosen."""
    (tmp_path / "drive.toml").write_text(DOWNHILL, "utf-8")
    (tmp_path / "search.toml").write_text(SEARCH, "utf-8")
    found = choose(load_search(tmp_path / "search.toml"))
    best = int(found.ranking[0])
    held = float(found.slack_tension[best])
    lagging = found.search.laggings[found.grid.places[0, best]]
    base = load_drive(tmp_path / "drive.toml")
    of = replace(base, pulleys=(replace(base.pulleys[0], lagging=lagging),))
    result = least_tension(solve(of, raise_on_failure=False))
    assert result is not None
    assert held == pytest.approx(result.tension)
    enough, less = at(of, held * (1.0 + 1e-6)), at(of, 0.99 * held)
    assert enough is not None
    assert less is not None
    assert missed(enough) == set()
    assert missed(less)
    words = shown(choose_sheet(found), "si").verdict
    assert f"tension at the take-up {math.ceil(held / 100.0) / 10.0:.1f} kN" in str(words)


def test_a_candidate_that_would_push_the_belt_is_refused(tmp_path: Path) -> None:
    """The full belt pulls back 32.74 kN: the entry has so much less than the take-up."""
    (tmp_path / "drive.toml").write_text(DOWNHILL, "utf-8")
    text = SEARCH.replace('"least"', '["20 kN", "60 kN"]')
    (tmp_path / "search.toml").write_text(text, "utf-8")
    with pytest.raises(InputError) as caught:
        load_search(tmp_path / "search.toml")
    (problem,) = caught.value.problems
    assert problem.key == "candidates.slack_tensions"
    assert problem.message == "leaves -12.74 kN in load case full"


TRAIN = """
[[load_case]]
name = "stop"
kind = "braking"
train.effective_tension = "-40 kN"
[take_up]
kind = "gravity"
"""


@pytest.mark.parametrize("after", ["", "first"])
def test_a_train_that_drives_and_brakes_needs_what_is_told(tmp_path: Path, after: str) -> None:
    """The train file with another exit tension, which its load cases take over."""
    text = TANDEM.read_text("utf-8") + TRAIN + (f'after = "{after}"\n' if after else "")
    of = load_train(train_of(tmp_path, text))
    found = least_tension(solve_train(of))
    assert found is not None
    assert math.isfinite(found.tension)
    drive = solve_train(of).drive_result().drive
    assert drive.take_up_place == f"at the take-up behind pulley {after or drive.pulleys[-1].name}"
    for tension, kept in ((found.tension * (1.0 + 1e-6), True), (0.99 * found.tension, False)):
        cases = tuple(
            replace(c, entry_tension=c.entry_tension + rise, exit_tension=c.exit_tension + rise)
            for c in of.cases
            for held in (drive.load_case(c.name).tensions[after or "second"].exit,)
            for rise in (tension - held,)
        )
        told = judge(solve_train(replace(of, cases=cases), raise_on_failure=False))
        sets = {f.name for f in found.required}
        assert bool({c.name for c in told.missed} & sets) is not kept


@pytest.mark.parametrize(
    ("pairs", "after", "says"),
    [
        # exit kept: behind the last pulley, no contradiction
        (((85e3, 50e3), (25e3, 50e3)), "", ""),
        # so too where it brakes always
        (((20e3, 50e3), (25e3, 50e3)), "", ""),
        # entry kept: ahead of the first
        (((85e3, 50e3), (85e3, 120e3)), "", ""),
        # neither
        (
            ((150e3, 60e3), (60e3, 100e3)),
            "",
            "Gravity take-up needs equal T2: design has 60 kN, stop has 100 kN.",
        ),
        (((85e3, 50e3), (25e3, 50e3)), "head", ""),
    ],
)
def test_tensions_contradict_a_take_up_only_where_it_stands_nowhere(
    pairs: tuple[tuple[float, float], ...], after: str, says: str
) -> None:
    of = Drive(
        belt=BELT, pulleys=(Pulley(name="head", diameter=0.8, wrap_angle=3.2,
                                   lagging=load_lagging("full-ceramic")),),
        load_cases=tuple(
            LoadCase(name=name, tensions={"head": Tensions(entry=a, exit=b)})
            for name, (a, b) in zip(("design", "stop"), pairs, strict=True)
        ),
        criteria=Criteria(take_up=TakeUp(kind="gravity", after=after)),
    )  # fmt: skip
    found = [shown(c.text, "si") for c in take_up(of)]
    assert bool(found) == bool(says)
    assert says in "".join(found)


def test_a_contradiction_names_the_pulley_behind_which_it_could_stand() -> None:
    """100 kN behind the first pulley in both load cases, 60 and 80 kN behind the second."""
    of = Drive(
        belt=BELT, pulleys=tuple(Pulley(name=name, diameter=0.8, wrap_angle=3.2,
                                        lagging=load_lagging("full-ceramic")) for name in "ab"),
        load_cases=tuple(
            LoadCase(name=name, tensions={"a": Tensions(entry=ahead, exit=100e3),
                                          "b": Tensions(entry=100e3, exit=behind)})
            for name, ahead, behind in (("design", 180e3, 60e3), ("empty", 140e3, 80e3))
        ),
        criteria=Criteria(take_up=TakeUp(kind="gravity")),
    )  # fmt: skip
    (check,) = take_up(of)
    assert "Behind a the tension is equal in every load case." in shown(check.full_text, "si")
