"""Advice holds when it is followed: taken as it is printed, the drive is solved again.

Expected: what the sentence says. A tension that is recommended keeps every check that binds, no
advice of one answer works against another, a trim divides the load as told.
"""

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import tomli_w

from checks.test_least_tension import FROM_ABOVE, random_drives, with_slack
from judgement.rows import MOTION, event
from judgement.rows import Row as BenchRow
from wraparc import Drive, load_train, solve, solve_train
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.answer.least_tension import at_least, least_table
from wraparc.answer.sheet import Row, shown
from wraparc.answer.train_words import matching_verdict
from wraparc.answer.what_if_sheet import what_if_sheet
from wraparc.answer.words import verdict
from wraparc.checks import Check, Verdict, judge, judge_run
from wraparc.checks.least_tension import least_tension
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.choose.file import search_from_document
from wraparc.choose.named_changes import Named, changes_of
from wraparc.choose.selection import choose
from wraparc.choose.what_if import what_if
from wraparc.drive import Across, WidthProfile
from wraparc.errors import InputError
from wraparc.files.write import drive_document
from wraparc.motion import RunResult, simulate
from wraparc.motion.file import motion_from_text
from wraparc.train import Speeds, Train, match_drives
from wraparc.units import parse_quantity

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
#: The check of an even pulley that stands beside one across the width.
EVEN = {
    "uneven_creep": "creep", "uneven_pressure": "tested_pressure_max",
    "uneven_face_pressure": "face_pressure", "uneven_bond_stress": "bond_stress",
    "uneven_fatigue_stress": "fatigue_stress",
}  # fmt: skip


#: Titles of the minimum tension in a table.
MINIMUM = ("Minimum T2", "Minimum slack-side tension T1")


def missed(of: Drive) -> set[str]:
    """Checks that bind and are missed."""
    told = judge(solve(of, raise_on_failure=False))
    return {c.name for c in told.missed if c.binding}


def printed(text: str) -> float:
    """A tension as it is printed [N]."""
    return parse_quantity(text, "force")


def followed(of: Drive) -> None:
    """Follow what `solve` advises on a drive: its least and its largest tension, in its words."""
    result = solve(of, raise_on_failure=False)
    told, found = shown(verdict(result), "si"), least_tension(result)
    assert found is not None
    least = re.search(
        r"Minimum (?:slack-side tension )?T[12] (\S+ \S+) \(", " ".join(told.sentences)
    )
    if least is None:
        assert re.search(r"No (slack-side tension )?T[12] ", " ".join(told.sentences))
        return
    raised = with_slack(of, printed(least[1]))
    table = shown(least_table(result), "si")
    assert table is not None
    texts = [row.values[0] for row in table.rows]
    most = min(printed(text[len("max ") :]) for text in texts if text.startswith("max "))
    assert missed(raised) - FROM_ABOVE == set()
    if printed(least[1]) <= most:
        assert not missed(raised) & {"belt_tension", "tested_pressure_max", "face_pressure"}


@pytest.mark.parametrize("start", range(0, 20, 10))
def test_the_tension_that_solve_prints_keeps_every_binding_check(start: int) -> None:
    """20 of them; `benchmarks/advice.py` has 300."""
    for of in random_drives(20, seed=11)[start : start + 10]:
        followed(of)


def followed_what_if(of: Drive) -> None:
    """Follow the least tension that what-if prints for a thicker lagging."""
    case = of.load_cases[0].name
    changes = list(changes_of(of, of, "head", Named(thicknesses=("18 mm",))))
    sheet = shown(what_if_sheet(what_if(of, "head", case, changes), ""), "si")
    rows: dict[str, Row] = {row.title: row for row in sheet.tables[0].rows}
    for place, whole in enumerate((of, *(change.drive for change in changes))):
        (text,) = (
            row.values[place] for title, row in rows.items() if re.match("Minimum .*T[12]$", title)
        )
        assert isinstance(whole, Drive)
        standards = (row for title, row in rows.items() if title.startswith("The same by"))
        standard = next(standards, None)
        asked = [] if standard is None else [standard.values[place]]
        if text in ("none", "-"):
            continue
        assert missed(with_slack(whole, printed(text))) - FROM_ABOVE == set()
        for other in asked:
            told = judge(solve(with_slack(whole, printed(other)), raise_on_failure=False))
            assert "design_standard" not in {c.name for c in told.missed}


@pytest.mark.parametrize("number", range(0, 40, 8))
def test_the_tension_that_what_if_prints_keeps_every_binding_check(number: int) -> None:
    followed_what_if(random_drives(40, seed=11)[number])


def followed_choice(of: Drive, folder: Path) -> None:
    """Follow what choose recommends: the lagging, with the tension as it is printed."""
    path = folder / "drive.toml"
    path.write_text(tomli_w.dumps(drive_document(of)), "utf-8")
    search = search_from_document(
        {
            "format": 1,
            "candidates": {
                "laggings": ["diamond-rubber", "full-ceramic"],
                "slack_tensions": "least",
            },
            "limits": {"tested_pressure": True},
            "cost": {"currency": "AUD", "years": 10},
            "drive": str(path),
        }
    )
    selection = choose(search)
    sheet = shown(choose_sheet(selection), "si")
    assert sheet.verdict is not None
    found = re.search(r"Lowest cost: (\S+?),? .*T2 (\S+ \S+?), ", sheet.verdict.text)
    if found is None:
        assert not len(selection.ranking)
        return
    lagging = next(lag for lag in search.laggings if lag.name == found[1])
    (head,) = search.drive.pulleys
    chosen = replace(search.drive, pulleys=(replace(head, lagging=lagging),))
    told = judge(solve(with_slack(chosen, printed(found[2])), raise_on_failure=False))
    also = (one.text for one in sheet.verdict.also)
    words = " ".join((sheet.verdict.text, *sheet.verdict.sentences, *also))
    says = any(text in words for text in ("cannot be applied", "does not apply"))
    if says:  # of a rule that says nothing on this drive
        told = Verdict(tuple(c for c in told.checks if c.name != "design_standard"))
    assert {c.name for c in told.missed if c.binding or c.name == "design_standard"} == set()
    assert "below" not in sheet.verdict.text


@pytest.mark.parametrize("number", range(0, 40, 8))
def test_what_choose_recommends_keeps_every_check(number: int, tmp_path: Path) -> None:
    followed_choice(random_drives(40, seed=11)[number], tmp_path)


def followed_trim(train: Train) -> None:
    """Set the trim that is told: the load is shared equally, within what is printed of it."""
    result = solve_train(train, raise_on_failure=False)
    if not result.cases[0].status.solved or len(train.pulleys) != 2:
        return
    matching = match_drives(result, points=5)
    action = shown(matching_verdict(result, matching), "si").action
    if action is None:
        assert not matching.equal.status.solved
        return
    found = re.match(r"Set trim (?:from \S+ % )?to (\S+) (?:% ?)?(?:± (\S+) %)?", action.text)
    assert found is not None, action.text
    for off in (0.0, *(() if found[2] is None else (0.99, -0.99))):
        trim = 0.01 * (float(found[1]) + off * float(found[2] or 0.0))
        case = replace(train.cases[0], division=Speeds((1.0, trim)))
        after = solve_train(replace(train, cases=(case,)), raise_on_failure=False).cases[0]
        share = after.members[1].share
        # to the third digit of the trim, and the curve within the tolerance nearly straight
        assert share == pytest.approx(0.5, abs=0.053 if off else 0.004)


def test_the_trim_that_is_told_shares_the_load() -> None:
    for name in ("tandem-fabric.toml", "tandem-steel-cord.toml"):
        followed_trim(load_train(EXAMPLES / name))


def unevened(of: Drive, number: int) -> Drive:
    """A drive with a pulley that is uneven across the width, in one way or another."""
    (head,) = of.pulleys
    size = 1.0 + 0.37 * (number % 7)
    ways = (
        Across(misalignment=0.4e-3 * size),
        Across(shell_profile=WidthProfile(crown=0.8e-3 * size)),
        Across(deflection=0.4e-3 * size),
    )
    return replace(of, pulleys=(replace(head, across=ways[number % 3]),))


def margin_of(told: Verdict, check: Check) -> float:
    """The margin that a check has in another verdict, infinite where it is kept or not asked."""
    found = [c for c in told.checks if (c.name, c.place) == (check.name, check.place) and c.missed]
    return found[0].margin if found else math.inf


def followed_across(of: Drive, number: int) -> None:
    """Even out the pulley, as the checks across the width advise."""
    told = judge(solve(unevened(of, number), raise_on_failure=False))
    even = judge(solve(of, raise_on_failure=False))
    for check in told.missed:
        if "even pulley face" in check.action_text and check.name in EVEN:
            assert check.name in ACROSS_CHECKS
            margins = [c.margin for c in even.listed if c.name == EVEN[check.name]]
            assert min(margins) > check.margin, check.text


@pytest.mark.parametrize("number", [0, 1, 2, 7, 43])
def test_what_is_advised_across_the_width_helps(number: int) -> None:
    followed_across(random_drives(44, seed=11)[number], number)


def followed_run(number: int) -> None:
    """Start more slowly, as a run advises."""
    rng = np.random.default_rng(number)
    numbers = {"time": rng.uniform(3.0, 14.0), "slack": rng.uniform(25.0, 110.0),
               "pull": rng.uniform(30.0, 90.0)}  # fmt: skip
    try:
        run = started(**numbers)
    except InputError as error:  # what it says to take instead starts
        advised = str(error).partition(". Start in ")[2].partition(", or raise")[0]
        numbers["time"] = parse_quantity(advised, "time")
        run = started(**numbers)
    for check in judge_run(run).missed:
        if "slower start" in check.action_text:
            after = judge_run(started(**numbers | {"time": 2.0 * numbers["time"]}))
            assert margin_of(after, check) > check.margin, check.text


def started(time: float, slack: float, pull: float) -> RunResult:
    """A start of the tandem of the bench [s, kN, kN], followed until its speed is reached."""
    changes = (("70 kN", f"{slack} kN"), ("60 kN", f"{pull} kN"))
    text = BenchRow("", (*event(f'kind = "start", time = "{time} s"', f"{time + 3.0} s"), *changes),
               (), base=MOTION).text  # fmt: skip
    motion = motion_from_text(text)
    return simulate(motion.station, motion.event("start"), points=15)


@pytest.mark.parametrize("number", [2, 3, 116])
def test_what_a_run_advises_helps(number: int) -> None:
    """Start 116 creeps too much and is pressed beyond the tests: neither more nor less helps."""
    followed_run(number)


def test_where_a_binding_standard_cannot_be_applied_no_tension_is_advised(tmp_path: Path) -> None:
    """Drive 44: CEMA binds, its table of manual take-ups begins at 180 deg, the wrap is less."""
    of = random_drives(45, seed=11)[44]
    assert of.pulleys[0].wrap_angle < 3.14
    assert of.criteria.standard.binding
    assert of.criteria.take_up.fixed
    told = shown(verdict(solve(of, raise_on_failure=False)), "si")
    assert told.sentences[0] == "No T2 passes: T2 by CEMA does not apply (head, full)."
    followed(of)
    followed_what_if(of)
    followed_choice(of, tmp_path)


def test_where_no_tension_passes_none_is_named() -> None:
    """A pull that no tension carries within belt and tests: neither more nor less is advised."""
    of = next(d for d in random_drives(40, seed=11) if _none(d))
    told = shown(verdict(solve(of, raise_on_failure=False)), "si")
    assert told.sentences[0].startswith("No T2 ")


def _none(of: Drive) -> bool:
    found = least_tension(solve(of, raise_on_failure=False))
    return found is not None and found.tension == float("inf")


@pytest.mark.parametrize(
    ("tension", "text"),
    [(118.63e3, "119 kN"), (118.6e3, "118.6 kN"), (119.01e3, "120 kN"), (119e3, "119 kN"),
     (16.32e3, "16.32 kN"),
     (9.996e3, "9.996 kN"), (9.9951e3, "10.0 kN"), (9.9949e3, "10.0 kN"), (1234.56e3, "1240 kN")],
)  # fmt: skip
def test_a_least_tension_is_rounded_upwards(tension: float, text: str) -> None:
    assert shown(at_least(tension), "si") == text
    assert printed(text) >= tension * (1.0 - 1e-9)
