"""``wraparc trim`` and ``wraparc solve`` on a train: what they print, write, draw and refuse.

Expected numbers: the library's own answers (tested in ``tests/train``), shown.
"""

import csv
import functools
import io
import re
from pathlib import Path

import numpy as np
import pytest

from cli.running import Ran, wraparc
from wraparc import Distributed, load_train, solve_train
from wraparc.train import MarkKind, Matching, match_drives

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
FABRIC = EXAMPLES / "tandem-fabric.toml"
STEEL = EXAMPLES / "tandem-steel-cord.toml"
SHARE = 'share = ["50 %", "50 %"]'
PULLEY = '[[pulley]]\nname = "{}"\ndiameter = "800 mm"\nwrap_angle = "180 deg"\n'


def changed(folder: Path, *changes: tuple[str, str]) -> Path:
    """The tandem with a fabric belt, its text changed."""
    text = FABRIC.read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "train.toml"
    path.write_text(text, "utf-8")
    return path


@functools.cache
def trimmed() -> Ran:
    """The normal answer, made once."""
    return wraparc("trim", FABRIC, "--points", 9, "--json", "-")


@functools.cache
def expected() -> Matching:
    result = solve_train(load_train(FABRIC), method=Distributed(capacities=False))
    return match_drives(result, points=9)


def test_json_has_the_curves_and_their_marks() -> None:
    assert (trimmed().code, trimmed().err) == (0, "")
    told = trimmed().json
    assert (told["drive"], told["load_case"]["load_case"]) == ("second", "design")
    matching = expected()
    curves = {curve["axis"]: curve for curve in told["curves"]}
    assert list(curves) == ["speed_trim", "diameter_ratio", "load_ratio"]
    for curve in (matching.trim, matching.diameter, matching.load):
        shown = curves[curve.quantity]
        assert shown["values"] == pytest.approx(curve.values)
        assert shown["shares"]["second"] == pytest.approx(curve.shares[:, 1], abs=1e-9)
        assert shown["exit_creep"]["first"] == pytest.approx(curve.creeps[:, 0])
        assert [m["what"] for m in shown["marks"]] == [m.kind.name.lower() for m in curve.marks]
        assert [m["at"] for m in shown["marks"]] == pytest.approx([m.value for m in curve.marks])
    drive = told["load_case"]["drives"][1]
    member = matching.case["second"]
    for name in ("contraction_term", "creep_term", "compression_term", "speed_trim"):
        assert drive[name] == getattr(member, name)
    worn = [c for c in told["changes"] if c["wear"] > 0.0]
    assert [c["pulley"] for c in worn] == ["first", "second"]
    assert {c["condition"] for c in told["changes"] if c["wear"] == 0.0} == {"wet"}


def test_the_words_answer_who_why_and_what_equalises(tmp_path: Path) -> None:
    """At one speed the second drum of the fabric tandem takes most; the slower trim equalises."""
    path = changed(tmp_path, (SHARE, 'speeds = "equal"'))
    ran = wraparc("trim", path, "--points", 5, "--full")
    assert (ran.code, ran.err) == (0, "")
    even = expected().equal["second"]
    trim = 100 * even.speed_trim
    assert (
        f"second takes more than its equal share because it turns {100 - trim:.3f} % faster than "
        f"equal shares need: at a trim of 100.000 %, where {trim:.3f} % equalises."
    ) in ran.words
    assert (
        f"second must turn {-100 * (even.drum_ratio - 1):.3f} % slower than first, "
        f"at equal diameters (belt contraction {100 * even.contraction_term:.3f} %, lagging "
        f"compression {100 * even.compression_term:.3f} %, extra creep "
        f"{100 * even.creep_term:+.3f} %): contraction and compression outweigh its extra creep, "
        "and the rule of the slightly faster second drive does not apply."
    ) in ran.words
    low, high = expected().trim.at(MarkKind.UNLOADED)
    assert (
        f"No drive brakes while the trim of second is between {100 * low:.3f} % and "
        f"{100 * high:.3f} %; outside, one brakes against the others."
    ) in ran.words
    assert "With 1 mm worn off second its share goes from 73.4 % to 57.0 %." in ran.words
    assert (
        "With first wet (wet: friction 0.824 of dry, DIN 22101 by works that follow it" in ran.words
    )


def test_the_rule_holds_on_the_steel_cord_belt() -> None:
    ran = wraparc("solve", STEEL, "--full")
    assert ran.code == 0
    assert re.search(
        r"second must turn 0\.\d{3} % faster than first, .*: its extra creep "
        r"outweighs contraction and compression, and the rule of the slightly faster second drive "
        r"applies\.",
        ran.words,
    )


def test_drives_that_fight_are_told(tmp_path: Path) -> None:
    path = changed(tmp_path, (SHARE, 'speeds = ["100 %", "99.655 %"]'), ('"40 kN"', '"20 kN"'))
    ran = wraparc("solve", path)
    assert ran.code == 0
    assert ran.words.startswith(
        "Tandem head drive, fabric belt ATTENTION Drives oppose each other by 8.57 kN (empty). "
        "Action Try torque sharing or closer speeds: run wraparc trim."
    )
    ran = wraparc("solve", path, "--load-case", "empty", "--full")
    pull = solve_train(load_train(path)).cases[1]["second"].arc.effective_tension
    assert (
        f"The drives oppose each other: first drives while second brakes, by {-pull / 1e3:#.3g} kN."
    ) in ran.words


def test_motors_are_told_by_their_setting() -> None:
    """Motors have their own way with speeds: what would equalise is a change of their setting."""
    path = EXAMPLES / "triple-steel-cord.toml"
    ran = wraparc("trim", path, "--points", 5, "--full")
    assert (ran.code, ran.err) == (0, "")
    found = re.search(
        r"head 2 takes more than its equal share: a motor set (0\.\d\d) % slower would", ran.words
    )
    assert found
    setting = 1.0 - float(found[1]) / 100
    ratio = f'train.motor."head 2".gear_ratio={15.7 / setting}'
    answer = wraparc("solve", path, "--set", ratio, "--load-case", "design", "--json", "-").json
    share = answer["train"]["load_cases"][0]["drives"][1]["share"]
    assert share == pytest.approx(1 / 3, abs=2e-3)  # the gear changes the torque a little, too


def test_csv_is_the_trim_curve() -> None:
    ran = wraparc("trim", FABRIC, "--points", 9, "--csv", "-")
    rows = list(csv.reader(io.StringIO(ran.out)))
    heads = [
        "speed_trim", "share first", "share second", "exit_creep first [m]",
        "exit_creep second [m]", "loss_ratio",
    ]  # fmt: skip
    assert rows[0] == heads
    curve = expected().trim
    table = np.array(rows[1:], float)
    assert table[:, 0] == pytest.approx(curve.values, abs=1e-8)
    assert table[:, 1:3] == pytest.approx(curve.shares, abs=1e-8)
    assert table[:, 3:5] == pytest.approx(curve.creeps, rel=1e-8)
    assert table[:, 5] == pytest.approx(curve.loss_ratio, rel=1e-8)


def test_a_drive_a_span_and_files(tmp_path: Path) -> None:
    picture, data = tmp_path / "trim.svg", tmp_path / "trim.json"
    ran = wraparc(
        "trim", STEEL, "--points", 3, "--drive", "second", "--load-case", "empty", "--wear", "0 mm",
        "--span", "99.9 %", "1.001", "--units", "us", "--plot", picture, "--json", data,
        "--full",
    )  # fmt: skip
    assert (ran.code, ran.err) == (0, f"Wrote {data}\nWrote {picture}\n")
    assert "Speed trim of second from 99.900 % to 100.100 %." in ran.words
    assert " lbf" in ran.out
    assert "worn off" not in ran.out
    assert picture.read_text("utf-8").lstrip().startswith("<?xml")
    assert '"load_case": "empty"' in data.read_text("utf-8")


def test_a_map_is_written_and_drawn(tmp_path: Path) -> None:
    picture = tmp_path / "map.png"
    ran = wraparc("trim", FABRIC, "--points", 3, "--map", "--json", "-", "--plot", picture)
    assert ran.code == 0
    told = ran.json["map"]
    assert (told["across"], told["down"]) == ("speed_trim", "load_ratio")
    shares = np.array(told["shares"]["second"], float)  # null where there is none
    assert shares.shape == (101, 101)
    middle = int(np.argmin(np.abs(np.array(told["x"]) - expected().case["second"].speed_trim)))
    full = int(np.argmin(np.abs(np.array(told["y"]) - 1.0)))
    assert shares[full, middle] == pytest.approx(0.5, abs=0.03)  # the nearest node
    assert picture.read_bytes().startswith(b"\x89PNG")


MOTOR = """[train.motor.first]
kind = "converter"
rated_power = "200 kW"
rated_speed = "1480 rpm"
gear_ratio = 20
brakes = false
[train.motor.second]
kind = "converter"
rated_power = "200 kW"
rated_speed = "1480 rpm"
gear_ratio = 19
[[load_case]]"""


@pytest.mark.parametrize("command", ["solve", "trim"])
@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ([(SHARE, 'share = ["50 %", "60 %"]')],
         ("train.share: must sum to 1, not to 1.1, got [0.5, 0.6]. Give fractions like 0.5 or "
          "50 %.")),
        ([(SHARE, 'share = ["50 %", "30 %", "20 %"]')],
         "train.share: must have one value for each of the 2 pulleys, in belt order, got "
         '["50 %", "30 %", "20 %"].'),
        ([(SHARE, SHARE + '\nspeeds = "equal"')],
         "train: share and speeds each decide how the load divides. Remove one of them."),
        ([("[train]", '[train]\nentry_tension = "160 kN"'),
          ('[[load_case]]\nname = "empty"\n', "")],
         "train: effective_tension makes 40 kN, the tensions 115 kN. Leave one of them out."),
        ([('lagging = "diamond-rubber"     # illustrative data\n', "")],
         'pulley.first.lagging: missing. Write lagging = "diamond-rubber".'),
        ([("[train]", "".join(
            PULLEY.format(i) + 'lagging = "diamond-rubber"\n' for i in range(9)) + "[train]")],
         "pulley: must have 1 to 10 entries, got 11."),
        ([("[[pulley]]", "[[pully]]")],
         'pully: unknown. Did you mean "pulley"?'),
    ],
    ids=["sum", "count", "two ways", "tensions", "no lagging", "eleven", "no pulley"],
)  # fmt: skip
def test_bad_files(
    command: str, changes: list[tuple[str, str]], sentence: str, tmp_path: Path
) -> None:
    if "makes 40 kN" in sentence:  # the other load case names the key again: leave one value
        changes = [*changes, ("train.effective_tension", "\n#"), ('"105 kN"', '"40 kN"')]
    path = changed(tmp_path, *changes)
    ran = wraparc(command, path)
    assert (ran.code, ran.out) == (2, "")
    if "pully" in sentence:
        assert ran.err.endswith('train.toml: pully: unknown key. Did you mean "pulley"?\n')
    else:
        assert ran.err == f"Error: {path}: {sentence}\n"


def test_a_drum_faster_than_its_motor_allows(tmp_path: Path) -> None:
    """The second drum drags the first one along, whose motor cannot brake."""
    comment = FABRIC.read_text("utf-8").split(SHARE)[1].partition("\n")[0]
    path = changed(tmp_path, (SHARE + comment, ""), ("[[load_case]]", MOTOR))
    ran = wraparc("solve", path, "--load-case", "empty")
    assert ran.code == 1
    assert "FAILS The belt drives the motors: no operating point (first, empty)." in ran.words
    assert "Action Set brakes = true if the drive can brake." in ran.words
    reason = "The belt drives pulley first at 74 rpm, where its motor ends: it cannot brake."
    assert reason in wraparc("solve", path, "--load-case", "empty", "--full").words
    ran = wraparc("trim", path, "--load-case", "empty")
    assert (ran.code, ran.err) == (1, "")
    assert "nothing to trim" in ran.words
    assert "FAILS The belt drives the motors: no operating point (first, " in ran.words


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["--drive", "first"], ("{}: --drive: trims are relative to the first drive, got "
                                '"first". Choose one of "second".')),
        (["--drive", "third"], ('{}: --drive: no such pulley, got "third". Choose one of '
                                '"second".')),
        (["--load-case", "full"], ("{}: --load-case: the train has no such load case, got "
                                    '"full". Write one of "design", "empty".')),
        (["--span", "1.1", "0.9"], "span: must be two positive numbers, the smaller one "
                                   "first, got [1.1, 0.9]."),
        (["--span", "a", "1"], ('--span: not a plain number, got "a". Write digits and a '
                                "decimal point: 1234.5.")),
        (["--wear", "1 kg"], '--wear: a mass, where a length is needed, got "1 kg". Write '
                             'for example "1200 mm".'),
        (["--wear", "-1 mm"], "--wear: must be between 0 and the thickness of a lagging, 12 "
                              'mm, got "-1 mm".'),
        (["--wear", "13 mm"], "--wear: must be between 0 and the thickness of a lagging, 12 "
                              'mm, got "13 mm".'),
        (["--plot", "trim.gif"], ('--plot: must end in .svg or .png or .pdf, got "trim.gif". '
                                  'Write for example "trim.svg".')),
    ],
)  # fmt: skip
def test_bad_options(options: list[str], sentence: str) -> None:
    ran = wraparc("trim", FABRIC, "--points", 3, *options)
    assert ran == (2, "", f"Error: {sentence.format(FABRIC)}\n")


def test_one_pulley_and_no_train(tmp_path: Path) -> None:
    text = FABRIC.read_text("utf-8")
    second = text[text.index('[[pulley]]\nname = "second"') : text.index("[train]")]
    path = tmp_path / "one.toml"
    path.write_text(text.replace(second, "").replace(SHARE, 'share = ["100 %"]'), "utf-8")
    ran = wraparc("trim", path)
    sentence = "pulley: trim needs two or more drive pulleys; this file has one."
    assert ran == (2, "", f"Error: {path}: {sentence}\n")
    assert wraparc("solve", path).code == 0
