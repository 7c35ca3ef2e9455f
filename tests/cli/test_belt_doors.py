"""Every command takes a belt of covers, and says what its numbers miss without them.

The examples, with the layers and the mass of a belt put into their drives or not. What a command
tells of speeds comes with one line where the layers are not known, and with none where they are.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from cli.running import wraparc
from files.samples import example

LAYERS = """[belt]
pulley_cover = "3 mm"
carry_cover = "7 mm"
carcass = "6 mm"
mass = "20 kg/m"
"""
SURFACE = "Drum speeds are those at the lagging surface: 10 mm of belt on a drum of "

#: Command, file and options; whether it tells a speed of drums.
COMMANDS = {
    "solve": (("solve", "head-drive-fabric.toml", "--full"), False),
    "solve a train": (("solve", "tandem-fabric.toml", "--full"), True),
    "solve across": (("solve", "worn-head-drive-fabric.toml", "--full"), True),
    "check": (("check", "tandem-fabric.toml"), False),
    "trim": (("trim", "tandem-fabric.toml", "--full"), True),
    "run": (("run", "tandem-fabric.toml", "--event", "run-out"), True),
    "stability": (("stability", "tandem-fabric.toml"), True),
    "field": (("field", "head-drive-fabric.toml", "--pulley", "head"), True),
    "what-if": (("what-if", "head-drive-fabric.toml", "--worn", "3 mm"), False),
    "seek": (
        ("seek", "head-drive-fabric.toml", "--vary", "pulley.head.wrap_angle",
         "--result", "exit_creep", "--value", "6 mm"), False,
    ),
    "family": (("family", "head-drive-fabric.toml", "--ratios", "1.5,2"), False),
    "choose": (("choose", "wet-season/choose.toml"), False),
    "calibrate": (("calibrate", "wet-season/wet-day-record.toml"), False),
    "overlay": (("overlay", "wet-season/wet-day-record.toml"), False),
    "study": (("study", "studies/wet-dry.toml", "--full"), False),
}  # fmt: skip


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[bool, Path]:
    """The examples as they are, and with layers in every belt."""
    made = {}
    for covered in (False, True):
        folder = tmp_path_factory.mktemp("covered" if covered else "bare") / "examples"
        shutil.copytree(example("tandem-fabric").parent, folder)
        for path in folder.rglob("*.toml"):
            text = path.read_text("utf-8")
            if covered and "[belt]\n" in text:
                text = text.replace("[belt]\n", LAYERS, 1)
                second = 'name = "second"\n'
                path.write_text(text.replace(second, f'{second}side = "carry"\n', 1), "utf-8")
        made[covered] = folder
    return made


@pytest.mark.parametrize("covered", [False, True], ids=["none", "covers"])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_with_a_belt_of_covers_and_with_none(
    name: str, covered: bool, folders: dict[bool, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    (command, file, *options), speeds = COMMANDS[name]
    monkeypatch.chdir(folders[covered])
    ran = wraparc(command, file, *options)
    assert ran.code in (0, 1), ran.err
    assert ran.words.count(SURFACE) == int(speeds and not covered), ran.out
