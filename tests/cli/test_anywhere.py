"""The command line in other languages and places: locales, names, homes, streams, widths.

What is printed and written is that of the usual place, to the byte: no other expectation is kept
here.
"""

import errno
import json
import locale
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from cli.running import DRIVE, drive_file, wraparc
from wraparc import saving
from wraparc.cli.pipe import has_left
from wraparc.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"
TITLED = DRIVE.replace("Head drive", "ırmak İstif Förderband Ω")
#: Every kind of output that does not need a compiler or long to make.
COMMANDS = [
    ["solve", "drive.toml", "--load-case", "design", "--json", "-", "--csv", "a.csv"],
    ["report", "drive.toml", "--case", "design", "--title", "Förderband İ", "-o", "a.md"],
    ["check", "drive.toml"],
    ["lagging", "full-ceramic"],
    ["read", "test.csv"],
]
MADE = ("a.csv", "a.md", "printed-0")
_RUN = """
import io, json, locale, os, sys
from contextlib import redirect_stdout
from wraparc.cli import run
locale.setlocale(locale.LC_ALL, "")
told = {"numbers": locale.str(1.5), "files": sys.getfilesystemencoding()}
for place, command in enumerate(json.loads(sys.argv[1])):
    with open(f"printed-{place}", "w") as out, redirect_stdout(out):
        assert run(command) == 0, command
print(ascii(told))
"""


def made(folder: Path, **environment: str) -> str:
    """Run all commands in a process of its own; return what it says of its locale."""
    folder.mkdir()
    drive_file(folder, TITLED)
    text = "Weg [mm];Kraft [N]\n0,0;0,0\n1,0;500,0\n2,0;800,0\n3,0;900,0\n4,0;950,0\n"
    (folder / "test.csv").write_text(text, "utf-8")
    kept = {n: v for n, v in os.environ.items() if n != "LANG" and not n.startswith("LC_")}
    ran = subprocess.run(
        [sys.executable, "-c", _RUN, json.dumps(COMMANDS)],
        cwd=folder, env=kept | environment, capture_output=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr.decode("utf-8", "replace")
    return ran.stdout.decode("ascii")


@pytest.fixture(scope="module")
def usual(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("usual") / "here"
    made(folder, LC_ALL="C.UTF-8")
    return folder


def system_locale(name: str, charset: str, folder: Path) -> dict[str, str]:
    """Return what sets a locale: one of the system, or one made for the test."""
    full = f"{name}.{charset}"
    try:
        before = locale.setlocale(locale.LC_ALL)
        locale.setlocale(locale.LC_ALL, full)
        locale.setlocale(locale.LC_ALL, before)
    except locale.Error:
        make = ["localedef", "--no-archive", "-i", name, "-f", charset, str(folder / full)]
        subprocess.run(make, check=True, capture_output=True)
        return {"LC_ALL": full, "LOCPATH": str(folder)}
    return {"LC_ALL": full}


@pytest.mark.parametrize(
    ("name", "charset"), [("de_DE", "ISO-8859-1"), ("tr_TR", "ISO-8859-9"), ("C", "ASCII")]
)
def test_a_locale_changes_no_byte_of_a_file(
    name: str, charset: str, usual: Path, tmp_path: Path
) -> None:
    """Commas in numbers, a Turkish i, and files that are not UTF-8 unless a program says so."""
    if name == "C":
        environment = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    else:
        environment = system_locale(name, charset, tmp_path)
    told = made(tmp_path / "there", **environment)
    expected = {"de_DE": "'1,5'", "tr_TR": "'1,5'", "C": "'1.5', 'files': 'ascii'"}[name]
    assert expected in told
    for file in MADE:
        assert (tmp_path / "there" / file).read_bytes() == (usual / file).read_bytes(), file
    for place in range(len(COMMANDS)):  # of what is printed, letters that are lacking
        shown = (tmp_path / "there" / f"printed-{place}").read_bytes()
        assert len(shown.splitlines()) == len(
            (usual / f"printed-{place}").read_bytes().splitlines()
        )


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have no names but UTF-8")
def test_names_that_are_no_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / os.fsdecode(b"F\xc3\xb6rder b\xfcnd")
    folder.mkdir()
    monkeypatch.chdir(folder)
    name = os.fsdecode(b"k\xfcrz 1.toml")
    drive_file(folder, name=name)
    out = [os.fsdecode(b"\xfc a" + kind) for kind in (b".json", b".csv", b".svg", b".md", b".xlsx")]
    one = ("--load-case", "design")
    ran = wraparc("solve", name, *one, "--json", out[0], "--csv", out[1], "--plot", out[2])
    assert ran.code == 0, ran.err
    assert "Wrote ? a.csv" in ran.err
    assert json.loads(Path(out[0]).read_text("utf-8"))["arcs"]
    for note in out[3:]:  # workbooks too, whose writer takes no such letters
        ran = wraparc("report", name, "--case", "design", "-o", note)
        assert ran.code == 0, ran.err
    assert all(Path(file).stat().st_size > 1000 for file in out)
    study = Path(__file__).parents[2] / "examples" / "studies" / "load-cases.toml"
    ran = wraparc("study", study, "-o", "a.parquet")  # in a folder that is no text
    assert ran.code == 2
    assert '--output: its path must be UTF-8, got "a.parquet"' in ran.err
    ran = wraparc("solve", os.fsdecode(b"\xfc.toml"))
    assert (ran.code, ran.err[:19]) == (2, "Error: \\udcfc.toml:")


def test_a_home_that_cannot_be_written() -> None:
    """It stops nothing; where designs go must be said."""
    nowhere = {"HOME": os.devnull + "/home"}
    lost = ("XDG_CACHE_HOME", "XDG_DATA_HOME", "MPLCONFIGDIR", "WRAPARC_DATA")
    kept = {name: value for name, value in os.environ.items() if name not in lost}
    code = (
        "from wraparc.cli import run; "
        "assert run(['lagging', 'full-ceramic']) == 0; "
        "raise SystemExit(run(['serve', '--port', '0']))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], env=kept | nowhere, capture_output=True, check=False
    )
    error = ran.stderr.decode()
    assert ran.returncode == 2, error
    assert "its folder cannot be made: Not a directory" in error


def test_a_user_without_a_home(monkeypatch: pytest.MonkeyPatch) -> None:
    """As a container has that runs as any number."""
    from wraparc.web.database.place import user_folder

    def none() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("WRAPARC_DATA", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", none)
    with pytest.raises(InputError, match="Set WRAPARC_DATA to a folder, or give --database"):
        user_folder()


@pytest.mark.parametrize("width", [1, 40])
def test_a_narrow_terminal(width: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No letter is lost or doubled; of a number and its unit, none is cut."""
    usual = wraparc("check", drive_file(tmp_path)), wraparc("lagging", "full-ceramic")
    monkeypatch.setenv("COLUMNS", str(width))
    narrow = wraparc("check", drive_file(tmp_path)), wraparc("lagging", "full-ceramic")
    for one, other in zip(narrow, usual, strict=True):
        assert one.code == 0
        assert sorted("".join(one.out.split())) == sorted("".join(other.out.split()))
    assert wraparc("--help").code == wraparc("solve", "--help").code == 0
    assert wraparc("laggings").code == wraparc("belts").code == 0


def test_a_verdict_is_broken_over_narrow_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    from wraparc.checks import Level
    from wraparc.render.lines import _marked

    assert _marked("ATT", Level.ATTENTION) == "ATT"
    assert _marked("ATTENTION b", Level.ATTENTION).endswith("ATTENTION\x1b[0m b")


@pytest.mark.skipif(sys.platform == "win32", reason="the shell of POSIX closes streams")
def test_streams_that_are_closed(tmp_path: Path) -> None:
    """As services and programs without a console are started."""
    script = f"{sys.executable} -c 'from wraparc.cli import main; main()'"
    drive, shell = drive_file(tmp_path), shutil.which("sh") or "sh"
    for closed, arguments, code in (
        (">&-", f"solve {drive} --load-case design --json {tmp_path}/a.json", 0),
        ("2>&-", "solve none.toml", 2),
        ("<&- >&- 2>&-", "belts", 0),
    ):
        ran = subprocess.run([shell, "-c", f"{script} {arguments} {closed}"], check=False,
                             capture_output=True)  # fmt: skip
        assert (ran.returncode, b"Traceback" in ran.stderr) == (code, False), ran.stderr
    assert (tmp_path / "a.json").stat().st_size > 1000


def test_what_other_systems_say_when_nobody_reads(monkeypatch: pytest.MonkeyPatch) -> None:
    """Windows: no broken pipe but an invalid argument, which names of files may be too."""
    gone, named = OSError(errno.EINVAL, "Invalid argument"), OSError(errno.EINVAL, "", "a?b")
    assert [has_left(error) for error in (gone, named, BrokenPipeError())] == [False, False, True]
    monkeypatch.setattr(sys, "platform", "win32")
    assert [has_left(error) for error in (gone, named, BrokenPipeError())] == [True, False, True]


@pytest.mark.parametrize("path", [r"C:\drives\a.toml", r"C:\users\a.toml"])
def test_paths_of_windows_in_a_file(path: str, tmp_path: Path) -> None:
    drive = drive_file(tmp_path, DRIVE.replace("diamond-rubber", path))
    assert "Write paths with / , or in single quotes" in wraparc("check", drive).err
    text = DRIVE.replace('"diamond-rubber"', '"diamond-rubber')
    assert "Text needs quotes" in wraparc("check", drive_file(tmp_path, text)).err


def test_a_system_that_limits_no_memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As macOS: its call is refused, and the work is done all the same."""
    import resource

    from wraparc.machine_tables import workbook_process
    from wraparc.web.work import _alone

    def refuse(*_: object) -> None:
        raise ValueError("current limit exceeds maximum limit")

    monkeypatch.setattr(resource, "setrlimit", refuse)
    monkeypatch.setattr(tempfile, "tempdir", None)
    workbook_process._limit()
    assert _alone(str(tmp_path), tempfile.gettempdir) == str(tmp_path)


def test_paths_of_databases(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from wraparc.web.database.place import database_url

    monkeypatch.chdir(tmp_path)
    assert database_url("C://a b/ü.sqlite").endswith("/C:/a b/ü.sqlite")
    with pytest.raises(
        InputError,
        match=(
            r"begins the options of a database, got .*\. Name "
            "another file"
        ),
    ):
        database_url("what?.sqlite")


@pytest.mark.parametrize(
    "command",
    [
        ["choose", str(EXAMPLES / "wet-season" / "choose.toml"), "--csv"],
        ["fit", str(EXAMPLES / "shear_tests" / "plan.toml"), "-o"],
    ],
    ids=("choose", "fit"),
)
def test_a_full_disk_leaves_what_was_there(
    command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / ("designs.csv" if command[0] == "choose" else "lagging.toml")
    target.write_text("of before", "utf-8")

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(saving, "put_in_place", full)
    ended = wraparc(*command, str(target))
    assert ended.code == 2
    assert f"Error: {target}: cannot be written: No space left on device." in ended.err
    assert target.read_text("utf-8") == "of before"
    assert list(tmp_path.iterdir()) == [target]
