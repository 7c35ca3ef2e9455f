"""Checks, least tension and choice of trains, in every door.

The least tension behind the last pulley is tested by solving the train anew at it, at 1 % less, and
at the bound from above and 1 % more. Expected capstan ratios are worked by hand.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from answer.drives import BELT
from checks.test_least_tension import FROM_ABOVE
from checks.test_rows import NONE
from cli.running import wraparc
from files.samples import example
from render.test_note_files import sheets
from worded import worded
from wraparc import Train, TrainResult, load_drive, load_lagging, load_train, solve_train
from wraparc.answer.document import result_document
from wraparc.answer.least_tension import at_least
from wraparc.answer.sheet import shown
from wraparc.answer.train_document import train_document
from wraparc.answer.train_sheet import train_sheet
from wraparc.checks import Level, judge, least_tension
from wraparc.checks.check import INFO_CHECKS
from wraparc.checks.rules import RULES
from wraparc.drive import Criteria, DesignStandard, Pulley, Sag, TakeUp
from wraparc.files.write import drive_document
from wraparc.render import markdown, workbook
from wraparc.train import Shares, TrainCase
from wraparc.units import in_units
from wraparc.web.answers.trains import train_part

pytestmark = pytest.mark.usefixtures("solved_once")

#: Checks that more tension on the slack side helps against.
RAISING = {rule.name for rule in RULES.values() if rule.tension == "raise"}
TANDEM = example("tandem-steel-cord")


def random_trains(count: int, seed: int = 3) -> Iterator[Train]:
    """Yield trains of two and three drums, driving and braking, with take-ups of both kinds."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        slack = float(np.exp(rng.uniform(np.log(40e3), np.log(120e3))))
        pull = slack * float(rng.uniform(0.4, 2.0))
        entry, leaving = (slack + pull, slack) if rng.uniform() < 0.7 else (slack, slack + pull)
        drums = int(rng.integers(2, 4))
        parts = rng.uniform(0.5, 1.0, drums)
        names = ("diamond-rubber", "medium-ceramic", "full-ceramic")
        pulleys = tuple(
            Pulley(
                name=f"p{i}",
                diameter=float(rng.uniform(0.7, 1.3)),
                wrap_angle=float(rng.uniform(2.9, 3.7)),
                lagging=load_lagging(str(rng.choice(names))),
            )
            for i in range(drums)
        )
        sag = Sag(spacing=3.0, line_mass=float(rng.uniform(20.0, 80.0)))
        criteria = Criteria(
            take_up=TakeUp(kind=str(rng.choice(["gravity", "fixed"]))),
            standard=DesignStandard(name="CEMA", binding=bool(rng.uniform() < 0.3)),
            sag=sag if rng.uniform() < 0.5 else None,
        )
        case = TrainCase(
            name="full",
            entry_tension=entry,
            exit_tension=leaving,
            division=Shares(tuple(float(v) for v in parts / parts.sum())),
            kind=str(rng.choice(["running", "starting"])),  # type: ignore[arg-type]
        )
        belt = replace(BELT, rating=400e3)
        yield Train(belt=belt, pulleys=pulleys, cases=(case,), criteria=criteria, creep_limit=9e-3)


@cache
def solved(number: int) -> TrainResult:
    return solve_train(list(random_trains(6))[number], raise_on_failure=False)


def with_slack(of: Train, slack: float) -> Train:
    """Return the train with its slack end at a tension and its pull held."""
    (case,) = of.cases
    rise = slack - min(case.entry_tension, case.exit_tension)
    raised = replace(
        case, entry_tension=case.entry_tension + rise, exit_tension=case.exit_tension + rise
    )
    return replace(of, cases=(raised,))


def missed(of: Train, slack: float) -> set[str]:
    verdict = judge(solve_train(with_slack(of, slack), raise_on_failure=False))
    return {c.name for c in verdict.missed if c.binding or c.name in RAISING}


@pytest.mark.parametrize("number", range(6))
def test_solved_anew_a_train_keeps_its_checks_and_less_or_more_does_not(number: int) -> None:
    of, found = solved(number).train, least_tension(solved(number))
    assert found is not None
    least, top, sets = found.governing, found.highest, {f.name for f in found.required}
    if math.isfinite(least.tension):
        assert not missed(of, least.tension * (1.0 + 1e-6)) & sets
        assert missed(of, 0.99 * least.tension) & sets
    assert top is not None  # the tests of a lagging bound every train from above
    assert not missed(of, top.tension * (1.0 - 1e-6)) & FROM_ABOVE
    assert missed(of, 1.01 * top.tension) & FROM_ABOVE
    if math.isfinite(found.tension):
        assert not missed(of, found.tension * (1.0 + 1e-6)) & (sets | FROM_ABOVE)
        assert found.given == min(of.cases[0].entry_tension, of.cases[0].exit_tension)


def test_of_the_random_trains_most_have_one() -> None:
    found = [least_tension(solved(number)) for number in range(6)]
    assert sum(f is not None and math.isfinite(f.tension) for f in found) >= 3
    assert len({f.governing.name for f in found if f is not None}) >= 2


@pytest.mark.parametrize("number", [0, 4])
def test_every_door_tells_the_verdict_of_a_train(number: int) -> None:
    result = solved(number)
    verdict = judge(result)
    worst = max((c.level for c in verdict.checks), key=lambda level: level.rank)
    assert verdict.level is max(worst, Level.OK, key=lambda level: level.rank)
    told = train_document(result)["verdict"]
    assert (told["level"], told["label"]) == (verdict.level.value, verdict.label)
    sheet = shown(train_sheet(result), "si")
    assert sheet.verdict is not None
    assert (sheet.verdict.level, sheet.verdict.word) == (verdict.level, verdict.label)
    assert f"**{verdict.label}** " in markdown([result.drive_result()], train=result)
    assert result_document([result.drive_result()])["solved"]
    listed = {c.title: c.level.value for c in verdict.listed}
    assert {c["title"]: c["level"] for c in told["checks"]} == listed
    page = train_part(result)
    assert page.verdict is not None
    assert (page.verdict.level, page.verdict.label) == (verdict.level, verdict.label)
    assert worded(page.verdict.text) == in_units(verdict.text)
    rows = sheets(workbook([result.drive_result()], train=result))["Summary"]
    rated = {c.title: c.level.value for c in verdict.listed if c.name not in INFO_CHECKS}
    assert {str(row[0]): row[6] for row in rows if len(row) > 6 and row[0] in listed} == rated


def test_the_command_line_tells_the_verdict_of_a_train() -> None:
    verdict = judge(solve_train(load_train(TANDEM)))
    ran = wraparc("solve", TANDEM)
    assert ran.out.splitlines()[2].startswith(verdict.label)
    assert ran.code == {Level.FAILS: 1, Level.FAULT: 3}.get(verdict.level, 0)
    told = wraparc("solve", TANDEM, "--json", "-").json["verdict"]
    assert (told["level"], told["label"]) == (verdict.level.value, verdict.label)


def test_a_fixed_take_up_holds_the_sum_where_a_load_case_gives_the_pull_of_the_train_alone(
    tmp_path: Path,
) -> None:
    """The outer tensions of the full train stay in sum: 325 + 65 = 390 kN, 80 kN of pull."""
    text = TANDEM.read_text("utf-8") + '\n[take_up]\nkind = "fixed"\n'
    path = tmp_path / "fixed.toml"
    path.write_text(text, "utf-8")
    case = load_train(path).case("empty")
    assert (case.entry_tension, case.exit_tension) == pytest.approx((235e3, 155e3))
    assert load_train(TANDEM).case("empty").exit_tension == 65e3


def test_a_fixed_take_up_holds_the_sum_of_the_whole_train() -> None:
    """Two equal drums of friction 0.4 over pi, 30 kN each, the sum of the outer tensions held.

    At k times the pull the slack end falls by 30 (k - 1) kN, and the second drum, with 30 k on it,
    keeps its tight side: it slips where 90/(60 - 30 (k - 1)) is exp(0.4 pi).
    """
    from checks.test_rows import rigid

    drum = Pulley(name="one", diameter=0.8, wrap_angle=math.pi, lagging=rigid(0.4), overrun=0.0)
    case = TrainCase(name="full", entry_tension=120e3, exit_tension=60e3,
                     division=Shares((0.5, 0.5)))  # fmt: skip
    fixed = replace(NONE, take_up=TakeUp(kind="fixed"))
    of = Train(belt=BELT, pulleys=(drum, replace(drum, name="two")), cases=(case,),
               criteria=fixed, creep_limit=1.0)  # fmt: skip
    told = judge(solve_train(of)).at("two", "full")
    found = next(c for c in told.checks if c.name == "gross_slip")
    assert found.value == pytest.approx(1.0 + (60e3 - 90e3 / math.exp(0.4 * math.pi)) / 30e3)


def test_a_drum_without_pull_is_not_driven(tmp_path: Path) -> None:
    text = TANDEM.read_text("utf-8").replace('["50 %", "50 %"]', '["100 %", "0 %"]')
    path = tmp_path / "idle.toml"
    path.write_text(text, "utf-8")
    ran = wraparc("solve", path, "--full")
    assert "first takes 100 %, second is not driven." in ran.words
    assert "e-12 kW" not in ran.words
    assert ran.words.count("not driven") >= 4


def test_a_file_of_a_train_reads_as_a_drive_with_the_tensions_of_its_pulleys() -> None:
    of, train = load_drive(TANDEM), load_train(TANDEM)
    at = of.load_case("design").tensions
    assert (at["first"].entry, at["second"].exit) == (325e3, 65e3)
    assert at["first"].exit == at["second"].entry == pytest.approx(195e3)
    assert drive_document(of)["pulley"][1]["name"] == train.pulleys[1].name
    triple = load_drive(example("triple-steel-cord"))
    result = solve_train(load_train(example("triple-steel-cord")))
    assert (
        triple.load_case("empty").tensions
        == result.drive_result().drive.load_case("empty").tensions
    )


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            ("what-if", TANDEM, "--pulley", "second", "--worn", "10 mm", "--full"),
            "behind the drives",
        ),
        (("field", TANDEM, "--pulley", "second"), "Normal speed difference up to"),
        (("family", TANDEM, "--ratios", "1.5,2"), "T1/T2 = 1.5"),
        (("report", TANDEM, "-o", "-"), "Minimum T2"),
    ],
)
def test_a_tandem_goes_through_every_command(arguments: tuple[str, ...], words: str) -> None:
    ran = wraparc(*arguments)
    assert ran.code == 0, ran.err
    assert words in ran.words


def test_what_a_change_does_to_the_shares_is_seen(tmp_path: Path) -> None:
    """Equal drum speeds: a worn drum is slower, and gives its load to the other."""
    text = TANDEM.read_text("utf-8").replace('share = ["50 %", "50 %"]', 'speeds = "equal"')
    path = tmp_path / "equal.toml"
    path.write_text(text, "utf-8")
    ran = wraparc("what-if", path, "--pulley", "second", "--worn", "11 mm", "--full")
    assert "the load divides anew" in ran.words


CHOOSE = """
format = 1
drive = "tandem.toml"
pulley = "{pulley}"
[candidates]
laggings = ["diamond-rubber"]
slack_tensions = "least"
[cost]
currency = "AUD"
years = 10
"""


@pytest.mark.parametrize("pulley", ["first", "second"])
def test_the_choice_for_a_pulley_has_the_least_tension_of_the_train(
    pulley: str, tmp_path: Path
) -> None:
    """As it is, the least tension chosen is that of the checks of the whole train."""
    (tmp_path / "tandem.toml").write_text(TANDEM.read_text("utf-8"), "utf-8")
    (tmp_path / "choose.toml").write_text(CHOOSE.format(pulley=pulley), "utf-8")
    found = least_tension(solve_train(load_train(TANDEM)))
    assert found is not None
    ran = wraparc("choose", tmp_path / "choose.toml")
    told = shown(at_least(found.tension), "si")
    assert f"T2 {told}" in ran.words
