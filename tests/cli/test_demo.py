"""``wraparc demo``: works from nothing, keeps what the user changed."""

import sys
from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc.cli.demo import command_name, examples_folder

pytestmark = pytest.mark.usefixtures("solved_once")


def test_the_demo_lays_out_solves_and_draws(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = wraparc("demo")
    assert (ran.code, ran.err) == (0, "")
    folder = tmp_path / "wraparc-demo"
    for path in examples_folder().rglob("*.toml"):
        assert (folder / path.relative_to(examples_folder())).read_bytes() == path.read_bytes()
    assert "Head drive, ROM conveyor" in ran.out
    assert "ATTENTION Creep 11.4 mm exceeds the 6.35 mm limit (head, start)." in ran.words
    assert "<svg" in (folder / "head-drive-fabric.svg").read_text("utf-8")
    assert "The picture is wraparc-demo/head-drive-fabric.svg" in ran.out.replace("\\", "/")
    assert "Try next:" in ran.out
    assert "serve" in ran.out
    assert list(tmp_path.iterdir()) == [folder]


def test_what_it_says_to_try_next_works(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import shlex

    monkeypatch.chdir(tmp_path)
    lines = wraparc("demo").out.partition("Try next:")[2].strip().splitlines()
    assert len(lines) >= 5
    for line in lines:
        command = shlex.split(line.partition(":")[2].replace("\\", "/"))
        assert command[0] == "wraparc"
        assert wraparc(*command[1:]).code in (0, 1), line


def test_a_changed_example_is_kept_and_solved(tmp_path: Path) -> None:
    wraparc("demo", "--into", tmp_path)
    drive = tmp_path / "head-drive-fabric.toml"
    drive.write_text(drive.read_text("utf-8").replace("ROM conveyor", "my conveyor"), "utf-8")
    ran = wraparc("demo", "--into", tmp_path)
    assert ran.out.startswith("Head drive, my conveyor")
    assert f"Unchanged: your own {drive}." in ran.out
    assert "my conveyor" in drive.read_text("utf-8")


def test_without_matplotlib_it_says_how_to_get_the_picture(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("matplotlib", "matplotlib.figure"):
        monkeypatch.setitem(sys.modules, name, None)
    ran = wraparc("demo", "--into", tmp_path)
    assert ran.code == 0
    assert "There is no picture: it needs matplotlib: pip install 'wraparc[plot]'" in ran.out
    assert not (tmp_path / "head-drive-fabric.svg").exists()


def test_a_place_that_cannot_be_used(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("", "utf-8")
    ran = wraparc("demo", "--into", tmp_path / "taken")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith("Error: --into: cannot be used for the examples: File exists, got ")
    assert ran.err.endswith(" Name another folder with --into.\n")


def test_the_command_to_type(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    program = tmp_path / "bin" / "wraparc"
    program.parent.mkdir()
    program.write_text("", "utf-8")
    program.chmod(0o755)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", [str(program)])
    monkeypatch.setenv("PATH", "")
    assert Path(command_name()) == Path("bin") / "wraparc"
    monkeypatch.setenv("PATH", str(program.parent))
    assert command_name() == "wraparc"
