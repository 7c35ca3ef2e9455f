"""Every command takes a belt of covers, and says what its numbers miss without them.

The examples, with the layers and the mass of a belt put into their drives or not. What a command
tells of speeds comes with one line where the layers are not known, and with none where they are.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from cli.running import wraparc
from files.samples import example

pytestmark = pytest.mark.usefixtures("solved_once")

LAYERS = """[belt]
pulley_cover = "3 mm"
carry_cover = "7 mm"
carcass = "6 mm"
mass = "20 kg/m"
"""
SURFACE = "Pulley speeds are those at the lagging surface: 10 mm of belt on a pulley of "

COMMANDS = {
    "solve": ("solve", "head-drive-fabric.toml", "--full"),
    "solve a train": ("solve", "tandem-fabric.toml", "--full"),
    "solve across": ("solve", "worn-head-drive-fabric.toml", "--full"),
    "check": ("check", "tandem-fabric.toml"),
    "trim": ("trim", "tandem-fabric.toml", "--points", "3", "--full"),
    "run": ("run", "tandem-fabric.toml", "--event", "run-out", "--points", "10"),
    "stability": ("stability", "tandem-fabric.toml"),
    "field": ("field", "head-drive-fabric.toml", "--pulley", "head", "--full"),
    "what-if": ("what-if", "head-drive-fabric.toml", "--worn", "3 mm"),
    "seek": (
        "seek", "head-drive-fabric.toml", "--vary", "pulley.head.wrap_angle",
        "--result", "exit_creep", "--value", "6 mm",
    ),
    "family": ("family", "head-drive-fabric.toml", "--ratios", "1.5,2"),
    "choose": ("choose", "wet-season/choose.toml"),
    "calibrate": ("calibrate", "wet-season/wet-day-record.toml"),
    "overlay": ("overlay", "wet-season/wet-day-record.toml"),
    "study": ("study", "studies/wet-dry.toml", "--set", "sampling.samples=64", "--full"),
}  # fmt: skip
#: Those that tell a speed of drums; `run` and `stability` are held by their golden answers.
SPEEDS = ("solve a train", "solve across", "trim", "field")


@pytest.fixture(scope="module")
def covered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The examples with layers in every belt."""
    folder = tmp_path_factory.mktemp("covered") / "examples"
    shutil.copytree(example("tandem-fabric").parent, folder)
    for path in folder.rglob("*.toml"):
        text = path.read_text("utf-8")
        if "[belt]\n" in text:
            text = text.replace("[belt]\n", LAYERS, 1)
            second = 'name = "second"\n'
            path.write_text(text.replace(second, f'{second}side = "carry"\n', 1), "utf-8")
    return folder


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_with_a_belt_of_covers(
    name: str, covered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(covered)
    ran = wraparc(*COMMANDS[name])
    assert ran.code in (0, 1), ran.err
    assert SURFACE not in ran.words, ran.out


@pytest.mark.parametrize("name", SPEEDS)
def test_a_command_with_a_belt_of_unknown_layers(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(example("tandem-fabric").parent)
    ran = wraparc(*COMMANDS[name])
    assert ran.code in (0, 1), ran.err
    assert ran.words.count(SURFACE) == 1, ran.out


def test_the_answer_of_a_train_says_which_side_lies_on_each_drum(
    covered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # expected: as the file of the fixture has it
    monkeypatch.chdir(covered)
    answer = json.loads(wraparc("solve", "tandem-fabric.toml", "--json", "-")[1])
    for case in answer["train"]["load_cases"]:
        assert [drive["side"] for drive in case["drives"]] == ["pulley", "carry"]


OPEN = {
    "trim": ("trim", "tandem.toml", "--points", "3", "--full"),
    "run": ("run", "tandem.toml", "--event", "run-out", "--points", "10"),
    "study": ("study", "study.toml"),
    "what-if": ("what-if", "tandem.toml", "--worn", "3 mm"),
}
STUDY = """format = 1
drive = "tandem.toml"
pulley = "second"
[sampling]
samples = 8
seed = 1
[[axis]]
field = "belt.modulus"
distribution = "normal"
mean = "12960 kN/m"
standard_deviation = "900 kN/m"
"""


@pytest.mark.parametrize("drum", ['diameter = "1000 mm"', 'diameter = "800 mm"\nside = "carry"'])
@pytest.mark.parametrize("name", OPEN)
def test_no_ok_where_a_trim_is_open_without_the_thickness(
    name: str, drum: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Drums of two diameters, or on opposite sides: the study of the trimmed drum asks too."""
    monkeypatch.chdir(tmp_path)
    text = example("tandem-fabric").read_text("utf-8")
    own = 'name = "own"\nkind = "fabric"\nmodulus = "12960 kN/m"\nrating = "175 kN/m"'
    text = text.replace('preset = "Plylon Plus 1000/4"', own)
    head, tail = text.split('name = "second"\n', 1)
    tail = tail.replace('diameter = "800 mm"', drum, 1)
    Path("tandem.toml").write_text(f'{head}name = "second"\n{tail}', "utf-8")
    Path("study.toml").write_text(STUDY, "utf-8")
    ran = wraparc(*OPEN[name])
    before, attention, _ = ran.words.partition("ATTENTION")
    assert attention, ran.err
    assert "OK" not in before.split()
    shift = "0.25" if "1000 mm" in drum else "1"
    missing = f"Speed trim uncertain by {shift} %: belt thickness missing (second, "
    if name == "study":
        missing = "miss a check; governing: a trim without the thickness of the belt."
    elif name == "trim":  # its own action leads
        assert "Action Set trim to " in ran.words
    else:
        assert "Action Give pulley_cover, carry_cover and carcass." in ran.words
    assert missing in ran.words, ran.out


@pytest.fixture(scope="module")
def named(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The examples with a belt by its standard name in every drive."""
    folder = tmp_path_factory.mktemp("named") / "examples"
    shutil.copytree(example("tandem-fabric").parent, folder)
    for path in folder.rglob("*.toml"):
        text = re.sub(r'^preset = "(Ply|Flex).*"', NAMED, path.read_text("utf-8"), flags=re.M)
        path.write_text(text, "utf-8")
    return folder


NAMED = 'name = "EP 1250/4 6+3 Y"'


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_takes_a_belt_by_its_standard_name(
    name: str, named: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(named)
    ran = wraparc(*COMMANDS[name])
    assert ran.code in (0, 1), ran.err
    assert ran.err == "" or "Error" not in ran.err
    if name == "solve":
        for word in ("EP 1250/4 6+3 Y", "Breaking strength 1250 kN/m by its name", "Cover"):
            assert word.lower() in ran.words.lower()


CHOOSE = """format = 1
drive = "head-drive-fabric.toml"
[candidates]
belts = ["EP 1250/4", "ST 1600"]
[cost]
currency = "AUD"
years = 10
hours.design = 6000
[cost.belt."EP 1250/4"]
price = 100
life_years = 5
[cost.belt."ST 1600"]
price = 200
life_years = 10
"""
VARIED = """format = 1
drive = "head-drive-fabric.toml"
[[axis]]
field = "belt.preset"
values = ["EP 1250/4", "ST 1600", "Plylon Plus 1000/4"]
"""


def test_belts_of_standard_names_are_compared_varied_and_chosen(
    named: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(named)
    Path("choose.toml").write_text(CHOOSE, "utf-8")
    Path("varied.toml").write_text(VARIED, "utf-8")
    for of in (
        ("choose", "choose.toml"),
        ("study", "varied.toml"),
        ("what-if", "head-drive-fabric.toml", "--belt", "EP 1250/4", "--belt", "ST 1600"),
    ):
        ran = wraparc(*of)
        assert ran.code in (0, 1), ran.err
        assert "EP 1250/4" in ran.words or "ST 1600" in ran.words
    wrong = wraparc("what-if", "head-drive-fabric.toml", "--belt", "EP 12500/4")
    assert wrong.code == 2
    assert '"EP 1250/4"' in wrong.err.partition("Did you mean")[2]
