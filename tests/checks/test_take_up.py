"""A take-up between two drives: what it holds, what that leaves in hand, and where it is refused.

Expected values are worked by hand (capstan ratios), or the train solved anew.
"""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from answer.drives import BELT
from checks.test_of_trains import TANDEM, missed, solved, with_slack
from checks.test_rows import NONE, rigid
from cli.running import wraparc
from wraparc import InputError, Train, load_drive, load_train, solve_train
from wraparc.answer.sheet import shown
from wraparc.answer.train_sheet import train_sheet
from wraparc.checks import judge, least_tension, margins_of
from wraparc.checks.gross_slip import rises
from wraparc.drive import Pulley, TakeUp
from wraparc.drive.pull import given_up, rise_among, rises_of
from wraparc.files.write import drive_document
from wraparc.study.file import study_from_document
from wraparc.study.run import run_study
from wraparc.train import Shares, TrainCase

RATIO = math.exp(0.4 * math.pi)
AFTER = '\n[take_up]\nkind = "gravity"\nafter = "first"\n'


def tandem(after: str, kind: str = "gravity") -> Train:
    """Two drums of friction 0.4 over pi, 75 and 15 kN: 150, 75 and 60 kN."""
    drum = Pulley(name="one", diameter=0.8, wrap_angle=math.pi, lagging=rigid(0.4), overrun=0.0)
    case = TrainCase(name="full", entry_tension=150e3, exit_tension=60e3,
                     division=Shares((5 / 6, 1 / 6)))  # fmt: skip
    return Train(belt=BELT, pulleys=(drum, replace(drum, name="two")), cases=(case,),
                 criteria=replace(NONE, take_up=TakeUp(kind=kind, after=after)),
                 creep_limit=1.0)  # fmt: skip


@pytest.mark.parametrize(
    ("after", "one", "two"),
    [
        # 75 kN held: the first slips at 75 k = 75 (r - 1), the second at 75/(75 - 15 k) = r
        ("one", RATIO - 1.0, 5.0 * (1.0 - 1.0 / RATIO)),
        # 60 kN held: the first at (60 + 90 k)/(60 + 15 k) = r, the second at 15 k = 60 (r - 1)
        ("two", 60.0 * (RATIO - 1.0) / (90.0 - 15.0 * RATIO), 4.0 * (RATIO - 1.0)),
    ],
)  # fmt: skip
def test_how_much_more_pull_is_by_where_it_stands(after: str, one: float, two: float) -> None:
    result = solve_train(tandem(after)).drive_result()
    found = [margins_of(result, arc).slack_held for arc in result]
    assert found == pytest.approx([one, two], rel=1e-6)
    nothing_said = solve_train(tandem("")).drive_result()
    if after == "two":
        assert [margins_of(nothing_said, arc).slack_held for arc in nothing_said] == found


@pytest.mark.parametrize(
    ("after", "kind", "one", "two"),
    [
        # the pull of 75 and 15 kN grows ahead of what is held, and is taken off behind it
        ("one", "gravity", (75e3, 0.0), (0.0, -15e3)),
        ("two", "gravity", (90e3, 15e3), (15e3, 0.0)),
        ("", "gravity", (90e3, 15e3), (15e3, 0.0)),
        # a fixed take-up keeps the sum of both ends
        ("", "fixed", (45e3, -30e3), (-30e3, -45e3)),
    ],
)
def test_how_tensions_grow_with_the_pull(
    after: str, kind: str, one: tuple[float, float], two: tuple[float, float]
) -> None:
    arcs = [found.arc for found in solve_train(tandem("")).drive_result()]
    take_up = TakeUp(kind=kind, after=after)
    found = [rises(arcs, i, take_up) for i in range(2)]
    assert [(r.tight, r.slack) for r in found] == [pytest.approx(one), pytest.approx(two)]


@pytest.mark.parametrize("number", [2, 3])
def test_solved_anew_a_train_keeps_its_checks_and_less_does_not(number: int) -> None:
    base = solved(number).train
    take_up = TakeUp(kind="gravity", after="p0")
    of = replace(base, criteria=replace(base.criteria, take_up=take_up))
    result = solve_train(of, raise_on_failure=False)
    found = least_tension(result)
    assert found is not None
    assert found.given == result.cases[0].members[0].arc.arc.exit_tension
    assert found.counterweight == pytest.approx(2.0 * found.tension / 9.80665)
    end = min(of.cases[0].entry_tension, of.cases[0].exit_tension)
    least = found.governing.tension - found.given + end
    if math.isfinite(least):
        assert found.governing.name not in missed(of, least * (1.0 + 1e-6))
        assert found.governing.name in missed(of, 0.99 * least)
        assert with_slack(of, least).criteria.take_up == take_up


def train_of(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "train.toml"
    path.write_text(text, "utf-8")
    return path


def test_a_case_with_its_pull_alone_keeps_the_tension_there(tmp_path: Path) -> None:
    """Half of 260 kN on each of two drums: 195 kN behind the first, where 170 kN leave 110 kN."""
    text = TANDEM.read_text("utf-8") + AFTER
    of = load_train(train_of(tmp_path, text))
    empty = load_drive(train_of(tmp_path, text)).load_case("empty")
    design = load_drive(TANDEM).load_case("design").tensions
    pull = of.case("empty").effective_tension
    assert empty.tensions["first"].exit == pytest.approx(design["first"].exit)
    assert of.case("empty").exit_tension == pytest.approx(195e3 - 0.5 * pull)
    assert drive_document(load_drive(train_of(tmp_path, text)))["take_up"]["after"] == "first"


def test_every_door_names_the_tension_that_is_held(tmp_path: Path) -> None:
    path = train_of(tmp_path, TANDEM.read_text("utf-8") + AFTER)
    ran = wraparc("solve", path, "--full")
    assert "Minimum tension at the take-up behind pulley first" in ran.words
    assert "Tension behind first constant (gravity take-up, winch)" in ran.words
    assert "slack-side tension with which" not in ran.words
    titles = [t.title for t in shown(train_sheet(solve_train(load_train(path))), "si").tables]
    assert "Minimum tension at the take-up behind pulley first by check" in titles


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('"first"\n', '"frist"\n',
         'take_up.after: no such pulley, got "frist". Did you mean "first"?'),
        ('"gravity"', '"fixed"',
         "take_up.after: a fixed take-up needs no place, "
         'got "first". Leave it out, or correct the kind.'),
        ('share = ["50 %", "50 %"]', 'speeds = "equal"',
         ("load_case.empty.train: Te alone does not fix the tensions behind the take-up. Give "
          "exit_tension too.")),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(tmp_path: Path, old: str, new: str, sentence: str) -> None:
    text = TANDEM.read_text("utf-8") + AFTER
    head, tail = text.rsplit("[take_up]", 1)
    if old.startswith("share"):
        assert old in head
        head = head.replace(old, new)
    else:
        tail = tail.replace(old, new)
    path = train_of(tmp_path, f"{head}[take_up]{tail}")
    with pytest.raises(InputError) as caught:
        load_train(path)
    assert [str(p) for p in caught.value.problems] == [f"{path}: {sentence}"]


def test_motion_and_choose_take_it_to_be_behind_the_drives(tmp_path: Path) -> None:
    text = (TANDEM.parent / "tandem-fabric.toml").read_text("utf-8")
    path = train_of(tmp_path, text + AFTER)
    ran = wraparc("run", path, "--event", "start")
    assert ran.code == 2
    assert "take_up.after" in ran.err
    assert "Leave it out." in ran.err


@pytest.mark.parametrize("pulley", ["first", "second"])
@pytest.mark.parametrize("after", ["", AFTER])
def test_a_row_of_a_study_has_the_verdict_of_solving_the_train(
    tmp_path: Path, pulley: str, after: str
) -> None:
    """The same file solved with the same override: its pull divides anew in every row."""
    path = train_of(tmp_path, TANDEM.read_text("utf-8") + after)
    values = ["20 kN", "50 kN", "90 kN"]
    document = {
        "format": 1, "drive": path.name, "pulley": pulley, "setting": "precise",
        "axis": [{"field": "train.exit_tension", "values": values}],
    }  # fmt: skip
    out = tmp_path / "rows.parquet"
    run_study(study_from_document(document, file="study.toml", folder=str(tmp_path)).study, out)
    rows = pq.read_table(out).to_pydict()
    levels = []
    for i, value in enumerate(values):
        result = solve_train(
            load_train(path, overrides=[f"train.exit_tension={value}"]), raise_on_failure=False
        )
        expected = judge(result).at(pulley, "design")
        levels.append(str(expected.level))
        assert expected.governing is not None
        assert (rows["verdict"][i], rows["governing"][i]) == (levels[-1], expected.governing.name)
    assert len(set(levels)) > 1 or pulley == "first"


@pytest.mark.parametrize("pull", [60e3, -60e3])
@pytest.mark.parametrize(
    "take_up", [TakeUp(kind="gravity"), TakeUp(kind="fixed"), TakeUp(kind="gravity", after="head")]
)
def test_a_single_pulley_is_a_train_of_one(pull: float, take_up: TakeUp) -> None:
    """Other code: the growth of tensions of any number of pulleys."""
    pulls = np.array([[pull]])
    many = rises_of(pulls, 0, given_up(pulls, ["head"], take_up))
    alone = rise_among([pull], 0, take_up.fixed, 0 if take_up.after else -1)
    assert alone == pytest.approx([float(side[0]) for side in many])
