"""The ``[train]`` table: what it says, and everything that is wrong with it at once.

Expected values: written out here from the text of the file.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from wraparc.errors import InputError
from wraparc.files import drive_from_text
from wraparc.train import (
    FluidCoupling,
    Induction,
    Motors,
    Pulls,
    Shares,
    Speeds,
    TorqueFollower,
    VariableSpeed,
    solve_train,
)
from wraparc.train.file import load_train, train_from_text

ROOT = Path(__file__).parents[2]
HEAD = """
format = 1
title = "Tandem"
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
"""
PULLEYS = """
[[pulley]]
name = "a"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
[[pulley]]
name = "b"
diameter = "820 mm"
wrap_angle = "200 deg"
lagging = "full-ceramic"
"""
TENSIONS = 'entry_tension = "150 kN"\nexit_tension = "50 kN"\n'
RPM = math.pi / 30.0


def text(train: str, tensions: str = TENSIONS, more: str = "") -> str:
    return f"{HEAD}{PULLEYS}[train]\n{tensions}{train}\n{more}"


def problems(of: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        train_from_text(of, file="t.toml")
    return [str(problem) for problem in caught.value.problems]


def test_shares() -> None:
    (case,) = train_from_text(text('share = ["60 %", 0.4]')).cases
    assert case.division == Shares((0.6, 0.4))
    assert (case.name, case.entry_tension, case.exit_tension) == ("design", 150e3, 50e3)
    assert case.runs == ()


def test_shares_as_powers_make_the_pull() -> None:
    given = 'exit_tension = "50 kN"\n'
    (case,) = train_from_text(text('share = ["200 kW", "100 kW"]', given)).cases
    assert isinstance(case.division, Shares)
    assert case.division.fractions == pytest.approx((2 / 3, 1 / 3))
    assert case.entry_tension == pytest.approx(150e3)  # 300 kW at 3 m/s


def test_speeds() -> None:
    (case,) = train_from_text(text('speeds = ["100 %", "99.7 %"]')).cases
    assert isinstance(case.division, Speeds)
    slow = case.division.rotation_speeds
    assert slow[1] * 0.82 / (slow[0] * 0.8) == pytest.approx(0.997)
    assert train_from_text(text('speeds = "equal"')).cases[0].division == Speeds((1.0, 1.0))
    (case,) = train_from_text(text('speeds = ["71 rpm", "69 rpm"]')).cases
    assert isinstance(case.division, Speeds)
    assert case.division.absolute
    assert case.division.rotation_speeds == pytest.approx((71 * RPM, 69 * RPM))


def test_diameters_are_the_worn_ones() -> None:
    train = train_from_text(text('diameters = ["800 mm", "816 mm"]'))
    assert [p.diameter for p in train.pulleys] == [0.8, 0.816]
    assert train.nominal == (0.8, 0.82)
    (division,) = (case.division for case in train.cases)
    assert isinstance(division, Speeds)
    result = solve_train(train).cases[0]
    assert [m.speed_trim for m in result] == pytest.approx([1.0, 1.0], abs=1e-12)


def test_motors() -> None:
    motors = """
[train.motor.a]
kind = "converter"
rated_power = "250 kW"
rated_speed = "1485 rpm"
gear_ratio = 20.5
droop = "1 %"
[train.motor.b]
kind = "follower"
master = "a"
ratio = 0.8
"""
    (case,) = train_from_text(text(motors)).cases
    assert isinstance(case.division, Motors)
    drive, follower = case.division.motors
    assert isinstance(drive, VariableSpeed)
    assert (drive.rated_power, drive.gear_ratio, drive.droop) == (250e3, 20.5, 0.01)
    assert drive.rated_speed == pytest.approx(1485 * RPM)
    assert follower == TorqueFollower(master="a", ratio=0.8)


def test_runs_and_load_cases() -> None:
    more = """
run.b = "6 kN"
[[load_case]]
name = "empty"
train.effective_tension = "30 kN"
[[load_case]]
name = "equal speeds"
train.speeds = "equal"
train.run.b = "0 N"
"""
    given = 'exit_tension = "50 kN"\neffective_tension = "100 kN"\n'
    design, empty, equal = train_from_text(text("share = [0.5, 0.5]", given, more)).cases
    assert [c.name for c in (design, empty, equal)] == ["design", "empty", "equal speeds"]
    assert design.runs == (6e3,)
    assert design.entry_tension == 50e3 + 100e3 - 6e3
    assert design.effective_tension == 100e3
    assert empty.entry_tension == 50e3 + 30e3 - 6e3
    assert empty.division == Shares((0.5, 0.5))
    assert equal.division == Speeds((1.0, 1.0))
    assert equal.runs == ()
    assert equal.entry_tension == 150e3


def test_a_drive_file_without_the_table_is_a_train_of_its_tensions(tmp_path: Path) -> None:
    own = PULLEYS.replace('lagging = "diamond-rubber"', 'lagging = "diamond-rubber"\n' + TENSIONS_A)
    path = tmp_path / "plain.toml"
    path.write_text(HEAD + own + 'power = "150 kW"\n', "utf-8")
    train = load_train(path)
    division = train.cases[0].division
    assert isinstance(division, Pulls)
    assert division.effective_tensions == pytest.approx((50e3, 50e3))


TENSIONS_A = 'entry_tension = "150 kN"\npower = "150 kW"'


@pytest.mark.parametrize("name", ["tandem-fabric", "tandem-steel-cord", "triple-steel-cord"])
def test_the_examples_solve(name: str) -> None:
    result = solve_train(load_train(ROOT / "examples" / f"{name}.toml"))
    for case in result:
        assert case.status.solved
        assert case.tension_error < 1e-10
        assert case.speed_error < 1e-9
    design = result["design"]
    if name == "tandem-fabric":  # contradicts the rule of the slightly faster second drive
        assert design["second"].drum_ratio < 1.0 < 1.0 + design["second"].creep_term
    elif name == "tandem-steel-cord":  # and confirms it
        assert design["second"].drum_ratio > 1.0
        assert design["second"].arc.entry_creep_ratio > design["first"].arc.exit_creep_ratio
    else:
        assert [type(m) for m in _motors(design)] == [Induction, FluidCoupling, Induction]


def _motors(case: object) -> tuple[object, ...]:
    division = case.case.division  # type: ignore[attr-defined]
    assert isinstance(division, Motors)
    return division.motors


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (
            text('share = ["60 %", "50 %"]'),
            (
                "t.toml: train.share: must sum to 1, not to 1.1, got [0.6, 0.5]. Give fractions "
                "like 0.5 or 50 %."
            ),
        ),
        (
            text('share = ["60 %", "40 %"]\nspeeds = "equal"'),
            (
                "t.toml: train: share and speeds each decide how the load divides. Remove one of "
                "them."
            ),
        ),
        (
            text('share = ["100 %"]'),
            "t.toml: train.share: must have one value for each of the 2 pulleys, in belt "
            'order, got ["100 %"].',
        ),
        (
            text('share = ["60 %", "40 kW"]'),
            't.toml: train.share: must be all of one kind, got ["60 %", "40 kW"].',
        ),
        (
            text('share = ["60 %", "forty"]'),
            't.toml: train.share[2]: must be a share like 0.5 or "50 %", or a power like '
            '"300 kW", got "forty".',
        ),
        (
            text('speeds = "fast"'),
            't.toml: train.speeds: must be "equal" or an array of speeds, got "fast".',
        ),
        (
            text("share = [0.5, 0.5]", TENSIONS + 'effective_tension = "90 kN"\n'),
            (
                "t.toml: train: effective_tension makes 90 kN, the tensions 100 kN. Leave one of "
                "them out."
            ),
        ),
        (
            text("share = [0.5, 0.5]\nrun.a = '3 kN'"),
            't.toml: train.run.a: the first pulley has no run before it. Write one of "b".',
        ),
        (
            text('motor.a = {kind = "induktion"}\nmotor.b = {kind = "follower", master = "a"}'),
            't.toml: train.motor.a.kind: must be one of "converter", "induction", '
            '"fluid-coupling", "follower", got "induktion". Did you mean "induction"?',
        ),
        (
            text('motor.b = {kind = "follower", master = "a"}'),
            't.toml: train.motor.a: missing. Write [train.motor.a] with kind = "converter".',
        ),
        (
            text('share = ["200 kW", "200 kW"]'),
            (
                "t.toml: train.share: the powers make 133.3 kN, the tensions 100 kN. Leave one "
                "of them out."
            ),
        ),
        (
            text("share = [1.8, -0.8]"),
            (
                "t.toml: train.share: leaves a belt tension of -30 kN. Give other shares, or "
                "raise T2."
            ),
        ),
        (
            text(""),
            't.toml: train: nothing says how the load divides. Write share = ["50 %", "50 %"], '
            'speeds = "equal" or [train.motor.NAME].',
        ),
    ],
)
def test_what_is_wrong_is_told(given: str, sentence: str) -> None:
    assert problems(given) == [sentence]


def test_every_follower_cannot_follow() -> None:
    motors = (
        'motor.a = {kind = "follower", master = "b"}\nmotor.b = {kind = "follower", master = "c"}'
    )
    told = " ".join(problems(text(motors)))
    assert 'must not follow another drive itself, got "b"' in told
    assert "no such pulley" in told
    assert "every drive follows another one" in told


def test_everything_wrong_is_told_at_once() -> None:
    given = text(
        'share = [0.5, 0.5]\nunknown = 1\nexit_tnsion = "1 kN"', 'entry_tension = "1,5 kN"\n'
    )
    told = problems(given.replace('lagging = "full-ceramic"', ""))
    assert len(told) >= 4
    assert any("pulley.b.lagging: missing" in t for t in told)


def test_too_many_and_no_pulleys() -> None:
    one = PULLEYS.split("[[pulley]]")[1]
    many = "".join(
        f"[[pulley]]{one.replace(chr(34) + 'a' + chr(34), f'{chr(34)}p{i}{chr(34)}')}"
        for i in range(11)
    )
    assert "must have 1 to 10 entries, got 11" in " ".join(
        problems(f'{HEAD}{many}[train]\n{TENSIONS}speeds = "equal"')
    )
    assert "pulley: missing" in " ".join(problems(f'{HEAD}[train]\n{TENSIONS}speeds = "equal"'))


def test_tensions_of_single_pulleys_are_refused() -> None:
    own = PULLEYS.replace('name = "a"', 'name = "a"\nentry_tension = "150 kN"')
    assert problems(f'{HEAD}{own}[train]\n{TENSIONS}speeds = "equal"') == [
        "t.toml: pulley.a.entry_tension: the tensions of single pulleys follow from [train], "
        'got "150 kN". Leave it out.'
    ]


def test_a_plain_drive_reader_says_what_the_file_is() -> None:
    with pytest.raises(InputError, match=r"Use wraparc\.load_train"):
        drive_from_text(text('speeds = "equal"'))
