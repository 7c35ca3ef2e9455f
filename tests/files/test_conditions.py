"""Drives in conditions: each column equals the drive whose laggings were scaled by hand."""

from dataclasses import astuple
from pathlib import Path

import pytest

from cli.running import DRIVE, drive_file, wraparc
from worded import worded
from wraparc import Drive, InputError, load_drive, load_lagging, solve
from wraparc.checks import Level, judge, least_tension
from wraparc.drive.changes import with_lagging, worn_to
from wraparc.drive.conditions import Condition
from wraparc.files import drive_from_text, drive_text
from wraparc.train import Train, solve_train
from wraparc.train.file import load_drive_or_train

pytestmark = pytest.mark.usefixtures("solved_once")

SEVERAL = 'condition = ["dry", "wet"]\n' + DRIVE
WET = 'condition = "wet"\n' + DRIVE
DUSTY = 'condition = { name = "dusty", friction_factor = 0.7 }\n' + DRIVE
START = DRIVE + '[[load_case]]\nname = "wet start"\nkind = "starting"\ncondition = "wet"\n'
TRAIN = "examples/tandem-fabric.toml"


def by_hand(condition: str, factor: float | None = None) -> Drive:
    drive = drive_from_text(DRIVE)
    lagging = Condition(name=condition, factor=factor).lagging(drive.pulley().lagging)
    return with_lagging(drive, "head", lagging)


def test_a_drive_in_one_condition_is_the_drive_with_its_laggings_in_it() -> None:
    assert drive_from_text(WET) == by_hand("wet")
    assert drive_from_text(DUSTY).pulley().lagging.law == by_hand("dusty", 0.7).pulley().lagging.law


def test_every_load_case_is_solved_in_every_condition() -> None:
    several = solve(drive_from_text(SEVERAL))
    names = [case.name for case in several.drive.load_cases]
    assert names == ["design, dry", "design, wet", "empty, dry", "empty, wet"]
    for condition, alone in (("dry", drive_from_text(DRIVE)), ("wet", by_hand("wet"))):
        for arc in solve(alone):
            found = several.arc("head", f"{arc.arc.load_case}, {condition}")
            assert found.exit_creep == arc.exit_creep
            numbers = astuple(found.capacities)
            assert numbers == pytest.approx(astuple(arc.capacities), rel=0.0, abs=0.0, nan_ok=True)


def test_the_worst_condition_gives_verdict_and_least_tension() -> None:
    several, wet = solve(drive_from_text(SEVERAL)), solve(by_hand("wet"))
    found, alone = least_tension(several), least_tension(wet)
    assert found is not None
    assert alone is not None
    assert found.tension == alone.tension
    assert found.governing.place.load_case.endswith(", wet")
    creep = next(c for c in judge(several).listed if c.name == "creep")
    assert creep.place.load_case == "design, wet"


def test_a_scaled_law_asks_for_attention_with_the_source_of_its_factor() -> None:
    verdict = judge(solve(by_hand("wet")))
    check = next(c for c in verdict.checks if c.name == "condition")
    assert check.level is Level.ATTENTION
    assert "DIN 22101" in check.source
    assert check.text == (
        "diamond-rubber not tested wet: dry friction times 0.824 used (head, design)."
    )
    assert check.action_text == "Test lagging diamond-rubber wet."
    assert check.full_text.startswith("Source of the factor: published: DIN 22101 by works that ")
    assert check in verdict.missed
    assert verdict.data.text.startswith("Friction, block, E_c illustrative; "), (
        "scaling makes no data better"
    )
    assert not [c for c in judge(solve(drive_from_text(DRIVE))).checks if c.name == "condition"]


def test_a_load_case_may_have_a_condition_of_its_own() -> None:
    result = solve(drive_from_text(START))
    assert result.arc("head", "wet start").exit_creep == solve(by_hand("wet")).arcs[0].exit_creep
    assert result.arc("head", "design").exit_creep < result.arc("head", "wet start").exit_creep


@pytest.mark.parametrize("text", [SEVERAL, WET, DUSTY, START])
def test_a_drive_in_conditions_reads_back_equal(text: str) -> None:
    drive = drive_from_text(text)
    again = drive_from_text(drive_text(drive))
    assert again == drive
    read = {(lag.name, lag.condition): lag.scaled_by for lag in again.laggings}
    assert read == {(lag.name, lag.condition): lag.scaled_by for lag in drive.laggings}


def test_a_train_in_two_conditions_is_the_train_in_each() -> None:
    both = load_drive_or_train(TRAIN, conditions=("dry", "wet"))
    wet = load_drive_or_train(TRAIN, overrides=["condition=wet"])
    assert isinstance(both, Train)
    assert isinstance(wet, Train)
    of_both = {case.case.name: case for case in solve_train(both)}
    for case in solve_train(wet):
        beside = of_both[f"{case.case.name}, wet"]
        assert [m.arc.exit_creep for m in beside.members] == [
            m.arc.exit_creep for m in case.members
        ]


def test_conditions_on_the_command_line_win_over_those_of_the_file(tmp_path: Path) -> None:
    pulley = DRIVE.replace('name = "head"\n', 'name = "head"\ncondition = "wet and dirty"\n', 1)
    path = drive_file(tmp_path, pulley)
    assert load_drive(path).pulley().lagging.condition == "wet and dirty"
    ran = wraparc("solve", path, "--conditions", "dry, dusty=0.98")
    assert "Conditions side by side dry dusty Verdict" in ran.words
    answer = wraparc("solve", path, "--conditions", "dry,dusty=0.98", "--json", "-").json
    dry, dusty = answer["conditions"]
    assert (dry["condition"], dusty["condition"]) == ("dry", "dusty")
    alone = solve(by_hand("dusty", 0.98)).arcs[0].exit_creep
    assert dusty["checks"]["creep"] == alone > dry["checks"]["creep"]
    assert dry["least_tension"] < dusty["least_tension"]


def test_a_note_and_the_page_show_the_same_table(tmp_path: Path) -> None:
    from wraparc.web.answers.drives import solve_all
    from wraparc.web.asked import SolveRequest

    path = drive_file(tmp_path)
    note = wraparc("report", path, "--conditions", "dry,wet", "-o", "-").out
    assert "Conditions side by side" in note
    assert (
        "diamond-rubber not tested wet: dry friction times 0.824 used (head, design, wet)." in note
    )
    document = {
        "format": 1,
        "condition": ["dry", "wet"],
        "belt": {"preset": "Plylon Plus 1000/4", "width": "1200 mm", "speed": "3 m/s"},
        "pulley": [
            {"name": "head", "diameter": "800 mm", "wrap_angle": "180 deg",
             "lagging": "diamond-rubber", "entry_tension": "150 kN", "exit_tension": "60 kN"}
        ],
    }  # fmt: skip
    table = solve_all(SolveRequest(document=document)).conditions
    assert table is not None
    assert [worded(head) for head in table.heads] == ["dry", "wet"]
    for row in table.rows:
        if row.title == "Creep at exit":
            assert all(value in note for value in map(worded, row.values))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            DUSTY.replace(", friction_factor = 0.7", ""),
            ('condition: lagging "diamond-rubber" has no friction in this condition, got "dusty".'),
        ),
        (WET.replace('"wet"', '["wet", "wet"]'), 'condition.name: used 2 times, got "wet".'),
        (WET.replace('"wet"', "[]"), "condition: must have 1 to 8 entries, got 0"),
        (WET.replace('"wet"', "7"), "condition: must be text, got 7."),
        (START.replace('"wet"', '"oily"'), 'load_case."wet start".condition: lagging'),
    ],
)
def test_a_condition_that_cannot_be_is_a_sentence_with_its_place(text: str, said: str) -> None:
    with pytest.raises(InputError) as raised:
        drive_from_text(text)
    assert said in str(raised.value)


def test_a_lagging_without_a_surface_has_no_published_ratio() -> None:
    own = WET.replace('lagging = "diamond-rubber"', 'lagging = "own"') + (
        '[lagging.own]\nthickness = "0 mm"\nlaw = { kind = "constant", friction = 0.4 }\n'
    )
    with pytest.raises(InputError, match="or add surface to the lagging"):
        drive_from_text(own)
    rubber = drive_from_text(own.replace('"0 mm"', '"0 mm"\nsurface = "rubber"'))
    assert rubber.pulley().lagging.law.friction(1e-3, 1e5) == pytest.approx(0.4 * 0.35 / 0.425)


def test_what_takes_one_condition_refuses_several(tmp_path: Path) -> None:
    ran = wraparc("what-if", drive_file(tmp_path, SEVERAL), "--worn", "6 mm")
    assert ran.code == 2
    assert "what-if changes a drive in one condition" in ran.err


def test_another_lagging_is_put_into_the_conditions_of_the_load_cases() -> None:
    drive = drive_from_text(SEVERAL)
    other = load_lagging("full-ceramic")
    changed = with_lagging(drive, "head", other)
    names = {(lag.name, lag.condition) for lag in changed.laggings}
    assert names == {("full-ceramic", "dry"), ("full-ceramic", "wet")}
    worn = worn_to(drive, "head", 0.006)
    assert {lag.thickness for lag in worn.laggings} == {0.006}
    assert all("worn" in lag.sources for lag in worn.laggings)
    assert drive_from_text(drive_text(worn)).pulley("head").diameter == worn.pulleys[0].diameter


def test_a_condition_without_a_name_is_refused(tmp_path: Path) -> None:
    ran = wraparc("solve", drive_file(tmp_path), "--conditions", "dry,,wet")
    assert ran.code == 2
    assert "a condition without a name" in ran.err
