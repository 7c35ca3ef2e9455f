"""The command line as a program: what it imports, how it ends, what it prints where."""

import json
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from cli.running import DRIVE, drive_file, wraparc, wraparc_process, wraparc_unread
from learn.plant import Made, readings, written
from wraparc import __version__
from wraparc.cli.group import COMMANDS, LazyGroup

HEAVY = {"scipy", "pandas", "matplotlib", "pydantic", "PIL", "tomli_w"}

#: What one drive, even and steady, has no need of.
ELSEWHERE = tuple(
    f"wraparc.{room}"
    for room in (
        "across", "batch", "calibrate", "choose", "machine_tables", "motion", "plot", "render.note",
        "shear_test", "study", "train.solve", "web",
    )
)  # fmt: skip

_TELL_MODULES = """
import atexit, json, sys
atexit.register(lambda: print(json.dumps(sorted(sys.modules)), file=sys.stderr))
"""


def loaded_by(*arguments: object) -> set[str]:
    """Return the modules that are loaded when a command has run."""
    ran = wraparc_process(*arguments, code=_TELL_MODULES)
    assert ran.returncode == 0, ran.stderr
    return set(json.loads(ran.stderr.splitlines()[-1]))


@pytest.mark.parametrize(("case", "more"), [("empty", set()), ("design", {"wraparc.batch"})])
def test_solving_loads_nothing_heavy(tmp_path: Path, case: str, more: set[str]) -> None:
    """The empty conveyor passes; of the design case many variants are tried for an action."""
    path, files = drive_file(tmp_path), (tmp_path / "a.json", tmp_path / "a.csv")
    asked = ("--load-case", case, "--no-reserve", "--json", files[0], "--csv", files[1])
    loaded = loaded_by("solve", path, *asked)
    tops = {name.partition(".")[0] for name in loaded}
    assert "wraparc.arc.solver" in loaded
    assert tops & HEAVY == set()
    elsewhere = {room for room in ELSEWHERE for name in loaded if name.startswith(room)}
    assert elsewhere == more


def test_help_loads_neither_numbers_nor_commands() -> None:
    for arguments in (("--help",), ("--version",), ()):
        ran = wraparc_process(*arguments, code=_TELL_MODULES)
        loaded = set(json.loads(ran.stderr.splitlines()[-1]))
        tops = {name.partition(".")[0] for name in loaded}
        assert tops & (HEAVY | {"numpy", "rich"}) == set()
        assert "wraparc.cli.solve" not in loaded


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_of_the_list_is_there(name: str) -> None:
    group = LazyGroup()
    command = group.get_command(click.Context(group), name)
    assert isinstance(command, click.Command)
    assert command.help
    assert COMMANDS[name].help.endswith(".")
    ran = wraparc(name, "--help")
    assert ran.code == 0
    assert ran.out.startswith(f"Usage: wraparc {name} ")


def test_help_lists_every_command_and_the_exit_codes() -> None:
    ran = wraparc("--help")
    assert ran.code == 0
    for name, command in COMMANDS.items():
        assert f"{name} {command.help}" in ran.words
    assert "1 FAILS: gross slip, or a mandatory limit exceeded" in ran.words


def test_version() -> None:
    assert wraparc("--version") == (0, f"wraparc {__version__}\n", "")
    module = [sys.executable, "-m", "wraparc", "--version"]
    assert subprocess.check_output(module, text=True) == f"wraparc {__version__}\n"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["solv"], 'no such command, got "solv". Did you mean "solve"?'),
        (["xyzzy"], 'no such command, got "xyzzy". See wraparc --help.'),
        (["solve"], "FILE: missing. Write wraparc solve [OPTIONS] FILE."),
        (["solve", "--metod", "x"], 'no such option. Did you mean "--method"?'),
        (["seek", "--change", "x"], "no such option. See wraparc seek --help."),
        (["family", "a.toml"], "--ratios: missing. Add --ratios R1,R2."),
        (["solve", "a.toml", "b.toml"], "extra argument (b.toml). Write wraparc solve [OPTIONS]"),
        (["solve", "a.toml", "--set"], "--set: value missing."),
        (["solve", "a.toml", "--units", "metric"], '--units: must be si or us, got "metric".'),
        (["read", "a", "--decimal", "\x1b"], '--decimal: must be "." or ",", got "\\u001b".'),
        (["read", "a", "--table", "x"], '--table: must be a whole number, got "x".'),
        (["run", "a", "--points", "1"], 'a whole number from 10 to 2,000, got "1".'),
        (["solve", "a", "--set", "b=1", "--set", "b=2"], "--set b: given 2 times. Leave all but"),
    ],
)
def test_wrong_usage_gives_exit_code_2(arguments: list[str], sentence: str) -> None:
    ran = wraparc(*arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith("Error: ")
    assert sentence in ran.err
    assert len(ran.err.split()) <= 21
    assert ran.err.count("\n") == 1


def test_a_wrong_setting_of_the_environment_is_told_as_an_option(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("WRAPARC_UNITS", "metric")
    assert '--units: must be si or us, got "metric".' in wraparc("solve", "a.toml").err


def test_the_usual_units_can_be_set_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("WRAPARC_UNITS", "us")
    assert "0.25 in" in wraparc("solve", drive_file(tmp_path)).out


def test_an_interrupt_ends_quietly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("wraparc.cli.solve.solve_drive", interrupt)
    assert wraparc("solve", drive_file(tmp_path)) == (
        130,
        "",
        "\nInterrupted.\nNothing was written.\n",
    )


@pytest.mark.processes
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no disk that is always full")
@pytest.mark.parametrize("arguments", [("solve", "--json", "-"), ("belts",), ("--help",)])
def test_a_full_disk_under_standard_output_is_told(
    tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    file = [drive_file(tmp_path)] if arguments[0] == "solve" else []
    command = [*arguments[:1], *map(str, file), *arguments[1:]]
    script = f"from wraparc.cli import main; main({command!r})"
    with open("/dev/full", "wb") as full:
        ran = subprocess.run(
            [sys.executable, "-c", script], stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert ran.returncode == 2
    assert ran.stderr.decode() == (
        "Error: standard output: cannot be written: No space left on device. What is printed is "
        "not whole: print it to another place.\n"
    )


def test_a_fault_is_one_line_and_a_traceback_only_on_request(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fault(*_: object, **__: object) -> None:
        raise ZeroDivisionError("by\nzero")

    monkeypatch.setattr("wraparc.cli.solve.solve_drive", fault)
    ran = wraparc("solve", drive_file(tmp_path))
    assert (ran.code, ran.out) == (3, "")
    assert ran.err == (
        f"Internal error in wraparc {__version__} (ZeroDivisionError: by\\nzero). Please report it "
        "with the input and the output of the same command after `wraparc --debug`.\n"
    )
    with pytest.raises(ZeroDivisionError):
        wraparc("--debug", "solve", drive_file(tmp_path))


@pytest.mark.processes
def test_a_reader_that_goes_away_is_no_fault() -> None:
    script = "from wraparc.cli import main; main(['belts'])"
    process = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    error = process.stderr.read()
    process.stderr.close()
    assert process.wait() == 0
    assert error == b""


EXAMPLES = Path(__file__).parents[2] / "examples"
# Every command that writes files, and which.
WRITING: dict[str, tuple[list[object], list[str]]] = {
    "solve": (
        [EXAMPLES / "head-drive-fabric.toml", "--json", "a.json", "--csv", "a.csv", "--plot"],
        ["a.json", "a.csv", "a.svg"],
    ),
    "check": ([EXAMPLES / "uphill-conveyor.toml", "--plot"], ["a.svg"]),
    "trim": ([EXAMPLES / "tandem-fabric.toml", "--points", "3", "--json"], ["a.json"]),
    "lagging": (["medium-ceramic", "--plot"], ["a.svg"]),
    "fit": (
        [EXAMPLES / "shear_tests" / "plan.toml", "--json", "a.json", "-o"],
        ["a.json", "a.toml"],
    ),
    "rig": (["rig", "--repeats", "1", "--points", "20"], ["rig/plan.toml"]),
    "choose": (
        [
            *(EXAMPLES / "wet-season" / "choose.toml", "--set"),
            *('candidates.laggings=["full-ceramic"]', "--json", "a.json", "--csv"),
        ],
        ["a.json", "a.csv"],
    ),
    "study": (
        [EXAMPLES / "studies" / "load-cases.toml", "--json", "a.json", "-o"],
        ["a.json", "a.parquet"],
    ),
    "what-if": ([EXAMPLES / "head-drive-fabric.toml", "--other-carcass", "--json"], ["a.json"]),
    "seek": (
        [
            *(EXAMPLES / "head-drive-fabric.toml", "--vary", "pulley.head.wrap_angle"),
            *("--result", "exit_creep", "--value", "6 mm", "--json"),
        ],
        ["a.json"],
    ),
    "overlay": ([EXAMPLES / "test-pulley" / "published-pair.toml", "--plot"], ["a.svg"]),
    "calibrate": (
        [EXAMPLES / "test-pulley" / "published-pair.toml", "--json", "a.json", "-o"],
        ["a.json", "a.toml"],
    ),
    "learn": (
        ["learn.toml", "--json", "a.json", "--plot", "a.svg", "-o"],
        ["a.json", "a.svg", "a.toml"],
    ),
    "family": (
        [EXAMPLES / "head-drive-fabric.toml", "--ratios", "1.5,2", "--plot", "a.svg", "--json"],
        ["a.svg", "a.json"],
    ),
    "field": ([EXAMPLES / "head-drive-fabric.toml", "--json"], ["a.json"]),
    "run": (
        [
            *(EXAMPLES / "tandem-fabric.toml", "--event", "splice", "--points", "10"),
            *("--csv", "a.csv", "--plot"),
        ],
        ["a.csv", "a.svg"],
    ),
    "stability": ([EXAMPLES / "tandem-fabric.toml", "--plot"], ["a.svg"]),
    "demo": (["--into", "demo"], ["demo/head-drive-fabric.svg"]),
}


@pytest.mark.parametrize("name", WRITING)
def test_files_are_written_though_nobody_reads(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    if name == "learn":
        written(tmp_path, readings(Made(days=4.0)))
    arguments, files = WRITING[name]
    last = [files[-1]] if str(arguments[-1]).startswith("-") else []
    code, error = wraparc_unread(name, *arguments, *last)
    assert (code, "Traceback" in error) == (0, False), error
    for file in files:
        assert (tmp_path / file).stat().st_size > 100, file


def test_every_command_that_writes_is_tried_without_a_reader() -> None:
    context = click.Context(LazyGroup())
    named = {
        name
        for name in COMMANDS
        for option in LazyGroup().get_command(context, name).params  # type: ignore[union-attr]
        if option.name in ("json_file", "csv_file", "plot_file", "into", "folder")
    }
    assert named == set(WRITING)


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "utf-8"])
def test_a_console_that_lacks_letters_shows_others(tmp_path: Path, encoding: str) -> None:
    path = drive_file(tmp_path, DRIVE.replace("Head drive", "Förderband ✓ Ω"))
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    ran = wraparc_process("solve", path, env=environment)
    assert (ran.returncode, ran.stderr) == (0, b"")
    title = ran.stdout.splitlines()[0]
    assert title == "Förderband ✓ Ω".encode(encoding, "replace")
    bad = wraparc_process("solve", tmp_path / "✓.toml", env=environment)
    assert bad.returncode == 2
    assert b".toml: file not found." in bad.stderr


def test_what_is_piped_is_plain_text(tmp_path: Path) -> None:
    """No colour codes, no drawn lines, no blanks at line ends: whatever the words need is words."""
    unsized = {name: value for name, value in os.environ.items() if name != "COLUMNS"}
    ran = wraparc_process("solve", drive_file(tmp_path), env=unsized)
    text = ran.stdout.decode("ascii")
    assert "\x1b" not in text
    assert all(line == line.rstrip() for line in text.splitlines())
    assert max(map(len, text.splitlines())) <= 110


def test_the_width_of_a_pipe_can_be_given(tmp_path: Path) -> None:
    ran = wraparc_process("solve", drive_file(tmp_path), env=os.environ | {"COLUMNS": "80"})
    text = ran.stdout.decode("ascii")
    assert max(map(len, text.splitlines())) <= 80
    for words in ("Peak shear stress", "2.5", "150", "ATTENTION creep"):
        assert words in " ".join(text.split())


@pytest.mark.processes
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals")
@pytest.mark.parametrize(("no_color", "coloured"), [("", True), ("1", False)])
def test_a_terminal_gets_colour_unless_it_wants_none(
    tmp_path: Path, no_color: str, coloured: bool
) -> None:
    import pty

    environment = os.environ | {"TERM": "xterm-256color", "COLUMNS": "120"}
    environment.pop("NO_COLOR", None)
    if no_color:
        environment["NO_COLOR"] = no_color
    ours, theirs = pty.openpty()
    script = (
        f"from wraparc.cli import main; main(['solve', {str(drive_file(tmp_path))!r}, '--full'])"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdout=theirs, env=environment) as run:
        os.close(theirs)
        parts = []
        try:
            while part := os.read(ours, 65536):
                parts.append(part)
        except OSError:  # Linux ends a pseudo-terminal with an error
            pass
        run.wait()
    os.close(ours)
    text = b"".join(parts).decode()
    assert run.returncode == 0
    assert ("\x1b[33m" in text) is coloured
    # the answer once more at the end, where the eye is
    assert text.count("Creep 7.49 mm exceeds the 6.35 mm limit (head, design).") == 2
