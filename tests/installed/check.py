"""The gate of what is handed out: wheel and sdist built, installed in several ways, and tried.

``make installed``. Everything stands in ``build/installed``; environments are kept there until
what they hold changes. Libraries come from uv's cache where it has them, else from the index.
"""

import hashlib
import os
import shlex
import subprocess
import sys
import tarfile
from collections.abc import Sequence
from glob import glob
from pathlib import Path
from tempfile import TemporaryDirectory
from zipfile import ZipFile

ROOT = Path(__file__).parents[2]
PLACE = ROOT / "build" / "installed"
LOWEST = Path(__file__).with_name("lowest.txt")
TRIAL = Path(__file__).with_name("trial.py")
UV = os.environ["UV"]
#: The Python that the lowest libraries have wheels for.
LEAST = (3, 11)
#: Extras that bring every library between them, for an environment that has all.
ALL = ("plot", "report", "bayes", "study", "dask", "web", "notebook")
#: After so long [s] a command is taken to hang.
LIMIT = 600.0
#: What new versions of Python break: compiled libraries, and the server.
NEWEST = ("plot", "web")


def main() -> None:
    """Check everything; the first fault ends it."""
    PLACE.mkdir(parents=True, exist_ok=True)
    wheel, sdist = built()
    check_wheel(wheel)
    check_sdist(sdist)
    locked = PLACE / "locked.txt"
    locked.write_text(
        uv("export", "--frozen", "--all-extras", "--no-default-groups", "--no-emit-project",
           "--no-hashes", "--no-header", "--no-annotate"),
        "utf-8",
    )  # fmt: skip
    check_first_lines(sdist, locked)
    own = sys.version_info[:2]
    here = {**pythons(), own: sys.executable}
    others = {version: python for version, python in here.items() if version > own}
    check_commands(environment("wheel", sys.executable, wheel, locked, whole=False))
    if LEAST in here:
        tried(environment("lowest", here[LEAST], wheel, LOWEST, whole=True), ALL)
    else:  # which alone has wheels of them
        say(f"no Python {LEAST[0]}.{LEAST[1]} is here: the lowest libraries were not tried")
    if not others:
        say(f"only Python {own[0]}.{own[1]} is here: no newer one was tried")
    for version, python in sorted(others.items()):
        newest = version == max(others)
        name = f"python{version[0]}.{version[1]}"
        tried(environment(name, python, wheel, locked, whole=newest), NEWEST if newest else ())


def say(text: str) -> None:
    """Tell what was done."""
    print(f"   installed: {text}", flush=True)  # noqa: T201


def run(*command: object, cwd: Path = ROOT, **more: str) -> str:
    """Run a command; what it printed, or the end of the gate with all of it."""
    try:
        done = subprocess.run(
            [str(part) for part in command], cwd=cwd, env=os.environ | more,
            capture_output=True, check=False, encoding="utf-8", timeout=LIMIT,
        )  # fmt: skip
    except subprocess.TimeoutExpired as hangs:
        raise SystemExit(f"installed: {hangs}") from None
    if done.returncode:
        told = f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
        raise SystemExit(f"installed: exit code {done.returncode} of {told}")
    return done.stdout


def uv(*arguments: object, cwd: Path = ROOT, **more: str) -> str:
    """Run uv, without the network if that suffices."""
    try:
        return run(UV, *arguments, cwd=cwd, **more, UV_OFFLINE="1")
    except SystemExit:
        return run(UV, *arguments, cwd=cwd, **more)


def built() -> tuple[Path, Path]:
    """Build the sdist, and the wheel from the sdist."""
    folder = PLACE / "dist"
    for old in folder.glob("wraparc-*"):
        old.unlink()
    uv("build", "--out-dir", folder)
    (wheel,), (sdist,) = folder.glob("*.whl"), folder.glob("*.tar.gz")
    return wheel, sdist


def built_from(path: Path) -> bool:
    """Whether a file is one that the pages are built from: what is built is handed out."""
    web = ROOT / "src" / "wraparc" / "web"
    if web / "static" in path.parents:
        return path.suffix in (".js", ".ts", ".css", ".html", ".svg") and "built" not in path.parts
    return path.parent == web / "one_file" and path.suffix == ".js"


def check_wheel(wheel: Path) -> None:
    """It holds the package and the examples to the byte, without sources of the pages, no more."""
    places = {"wraparc": ROOT / "src" / "wraparc", "wraparc/examples": ROOT / "examples"}
    here = {
        f"{start}/{path.relative_to(folder).as_posix()}": path.read_bytes()
        for start, folder in places.items()
        for path in folder.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts and not built_from(path)
    }
    with ZipFile(wheel) as archive:
        found = {name: archive.read(name) for name in archive.namelist()}
        about = {name for name in found if name.split("/")[0].endswith(".dist-info")}
    differ = set(found.keys() - about ^ here.keys())
    differ |= {name for name in here.keys() & found.keys() if here[name] != found[name]}
    assert not differ, f"wheel and folder differ: {sorted(differ)[:9]}"
    metadata = next(found[name].decode() for name in about if name.endswith("METADATA"))
    for part in (
        "License-Expression: Apache-2.0", "License-File: LICENSE", "Requires-Python: >=3.11",
        "Description-Content-Type: text/markdown",
        "Classifier: Programming Language :: Python :: 3.13", "# wraparc",
    ):  # fmt: skip
        assert part in metadata, f"the metadata lacks {part!r}"


def check_sdist(sdist: Path) -> None:
    """It holds all that the gate itself needs."""
    with tarfile.open(sdist) as archive:
        found = {name.partition("/")[2] for name in archive.getnames()}
    needed = {
        path.relative_to(ROOT).as_posix()
        for folder in ("src", "tests", "docs", "examples", "benchmarks")
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and not {"__pycache__", ".hypothesis"} & set(path.parts)
    }
    needed |= {"Makefile", "LICENSE", "README.md", "pyproject.toml", "uv.lock", "Containerfile"}
    assert needed <= found, f"the sdist lacks {sorted(needed - found)[:9]}"


def check_first_lines(sdist: Path, locked: Path) -> None:
    """What the README says first works as it is written, in an unpacked sdist."""
    readme = (ROOT / "README.md").read_text("utf-8")
    first = next(line for line in readme.splitlines() if line.startswith("uvx "))
    command = shlex.split(first, comments=True)
    with TemporaryDirectory(prefix="wraparc-installed-") as folder, tarfile.open(sdist) as archive:
        archive.extractall(folder, filter="data")
        (place,) = Path(folder).iterdir()
        assert command[-2:] == ["wraparc", "demo"], first  # which the trial of the wheel solves
        told = uv("tool", "run", *command[1:-1], "--version", cwd=place, UV_CONSTRAINT=str(locked))
    say(f"{first.partition('  ')[0]}: {told.strip()}")


def environment(name: str, python: str, wheel: Path, libraries: Path, *, whole: bool) -> Path:
    """Return the Python of an environment with the wheel and, if `whole`, every library."""
    folder = PLACE / name
    text = libraries.read_text("utf-8")
    state = hashlib.sha256(repr((python, sys.version, text, whole)).encode()).hexdigest()
    stamp = folder / "state"
    inside = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    install = ("pip", "install", "--quiet", "--python", inside)
    if not stamp.exists() or stamp.read_text("ascii") != state:
        uv("venv", "--quiet", "--clear", "--no-project", "--python", python, folder)
        what = ("--requirement", libraries) if whole else ("--constraint", libraries, wheel)
        uv(*install, *what)
        stamp.write_text(state, "ascii")
    uv(*install, "--no-deps", "--reinstall-package", "wraparc", wheel)
    return inside


def check_commands(python: Path) -> None:
    """Both ways to start it answer, without the source beside them, and the base alone solves."""
    tried(python, ())
    with TemporaryDirectory(prefix="wraparc-installed-") as folder:
        here = Path(folder)
        program = python.with_name("wraparc")
        told = run(program, "--version", cwd=here)
        assert run(python, "-m", "wraparc", "--version", cwd=here) == told
        where = run(python, "-c", "import wraparc; print(wraparc.__file__)", cwd=here)
        assert Path(where.strip()).is_relative_to(python.parents[1]), where


def tried(python: Path, extras: Sequence[str]) -> None:
    """Try extras in an environment."""
    with TemporaryDirectory(prefix="wraparc-installed-") as folder:
        say(run(python, TRIAL, *extras, cwd=Path(folder)).strip())


def pythons() -> dict[tuple[int, int], str]:
    """Return an interpreter of every version from 3.11 that is on this machine."""
    pyenv = os.environ.get("PYENV_ROOT") or str(Path.home() / ".pyenv")
    folders = [*os.environ.get("PATH", "").split(os.pathsep), f"{pyenv}/versions/*/bin"]
    paths = [path for folder in folders for path in glob(f"{folder}/python3.[1-9][0-9]")]
    found: dict[tuple[int, int], str] = {}
    for path in paths:
        asked = [path, "-c", "import sys; print(*sys.version_info[:2], sys.executable)"]
        done = subprocess.run(asked, capture_output=True, check=False, encoding="utf-8",
                              timeout=LIMIT)  # fmt: skip
        if done.returncode == 0:  # a shim of pyenv may lead nowhere
            major, minor, python = done.stdout.strip().split(" ", 2)
            found.setdefault((int(major), int(minor)), python)
    return {version: python for version, python in found.items() if version >= (3, 11)}


if __name__ == "__main__":
    main()
