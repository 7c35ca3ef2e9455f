"""What the README shows is what the program does."""

import re
import shlex
from pathlib import Path

import pytest

from cli.running import wraparc

pytestmark = pytest.mark.usefixtures("solved_once")

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text("utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


def test_the_first_two_commands_need_nothing_else_and_the_gate_is_the_second() -> None:
    first = [line.partition("#")[0].strip() for line in blocks("sh")[0].splitlines()]
    assert first == ["make demo", "make test"]
    assert (ROOT / ".ci" / "run").read_text("utf-8").endswith(f"exec {first[1]}\n")


def test_the_printed_run_is_a_real_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Regenerate: COLUMNS=80 wraparc solve examples/head-drive-fabric.toml."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("COLUMNS", "80")
    (block,) = blocks("text")
    command, *shown = block.splitlines()
    ran = wraparc(*shlex.split(command.removeprefix("$ wraparc ")))
    assert shown == ran.out.splitlines()


def test_the_drive_and_the_commands_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (drive,) = blocks("toml")
    Path("drive.toml").write_text(drive, "utf-8")
    commands = [line for text in blocks("sh") for line in text.splitlines()]
    commands = [line for line in commands if line.startswith("wraparc ")]
    assert len(commands) == 17
    # it would not end; no log of a plant is shipped
    commands = [c for c in commands if not c.startswith(("wraparc serve", "wraparc learn"))]
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    for command in commands:
        few = ("--set", "sampling.samples=40") if command.startswith("wraparc study ") else ()
        assert wraparc(*shlex.split(command, comments=True)[1:], *few).code == 0, command
    written = {path.name for path in tmp_path.iterdir()}
    assert written >= {"result.json", "profile.csv", "picture.pdf", "report.pdf", "lagging.svg",
                       "lagging.toml", "wet-dry.parquet"}  # fmt: skip


def test_the_python_example_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    (code,) = blocks("python")
    exec(compile(code, "README.md", "exec"), {})  # noqa: S102 - our own text
    told = capsys.readouterr().out
    assert re.match(r"creep 7\.5 mm, minimum T2 94\d\d\d N\nHead drive, ROM conveyor\n", told)
    assert (tmp_path / "picture.svg").exists()


def test_the_picture_is_there() -> None:
    (path,) = re.findall(r"\]\((docs/_static/.*?\.svg)\)", README)
    assert "<svg" in (ROOT / path).read_text("utf-8")
