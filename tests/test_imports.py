"""The floors of the house: imports only go down, never in a circle, extras stay outside.

The rule is that of CONTRIBUTING.md: a room (a module or package directly in wraparc)
imports from its own package and from floors below its own.
"""

import ast
import functools
import graphlib
import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

import wraparc

ROOT = Path(wraparc.__file__).parent
FACADE = "wraparc"
REPOSITORY = Path(__file__).parent.parent

# Lowest first; where a floor is a stair, one step a line.
FLOORS: tuple[tuple[str, ...], ...] = (
    ("version", "errors", "views", "alike", "arrays", "lazily"),
    ("units", "saving", "provenance"),
    ("glossary", "machine_tables"),
    ("schema",),
    ("friction", "catalogue", "conveyor"),
    ("drive",),
    ("arc", "shear_test"),
    ("files", "batch"),
    ("train", "across"),
    ("motion",),
    ("checks",),
    ("study", "choose", "calibrate", "learn", "actions"),
    ("reserve",),
    ("answer", "plot"),
    ("render",),
    ("web",),
    ("cli",),
    ("__main__", FACADE),
)
# A module, or ``module:function`` of one, given as a string: imported when somebody looks.
NAMED = re.compile(r"(wraparc(?:\.\w+)*)(?::(\w+))?")

# What the base install brings, and what only an extra does (by import name).
BASE = {"click", "numpy", "tomli_w"}
EXTRAS = (
    "alembic", "annotated_types", "calamine", "dask", "distributed", "emcee", "fastapi",
    "httptools", "matplotlib", "multipart", "pandas", "psycopg", "pyarrow", "pydantic",
    "python_calamine", "rich", "scipy", "sqlalchemy", "starlette", "typst", "uvicorn", "xlsxwriter",
)  # fmt: skip
# Libraries that come with one of an extra and are used beside it.
UNDER_THE_EXTRAS = {"typing_extensions"}
# Rooms that are nothing without their extra and may import it at the top.
OPTIONAL_ROOMS = {"web"}
# Modules that exist for their extra alone and are imported only where it is used.
OPTIONAL_MODULES: set[str] = set()


def modules(root: Path) -> dict[str, Path]:
    """Return every module below a package folder, by dotted name."""
    found = {}
    for path in sorted(root.rglob("*.py")):
        parts = (FACADE, *path.relative_to(root).with_suffix("").parts)
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@functools.cache
def tree(text: str) -> ast.Module:
    return ast.parse(text)


def imported(name: str, path: Path, known: dict[str, Path]) -> Iterator[tuple[str, int]]:
    """Yield every wraparc module that a module imports, wherever in its text, with the line."""
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    for node in ast.walk(tree(path.read_text("utf-8"))):
        targets: list[str] = []
        if isinstance(node, ast.Import):
            targets = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) + 1 - node.level]
            base = ".".join([*above, node.module] if node.module else above)
            base = base if node.level else node.module or ""
            within = [f"{base}.{alias.name}" for alias in node.names]
            targets = [target if target in known else base for target in within]
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
            targets = [str(a.value) for a in node.args if isinstance(a, ast.Constant)]
        for target in targets:
            if target == FACADE or target.startswith(FACADE + "."):
                yield target, getattr(node, "lineno", 0)


def named(path: Path, known: dict[str, Path]) -> Iterator[tuple[str, str, int]]:
    """Yield module, function and line of every string that names a module or a function of one."""
    for node in ast.walk(tree(path.read_text("utf-8"))):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found = NAMED.fullmatch(node.value)
            if found and (found[2] or (found[1] in known and found[1] != FACADE)):
                yield found[1], found[2] or "", node.lineno


def defines(path: Path) -> set[str]:
    """Return the names that a module has at its top."""
    found: set[str] = set()
    for node in tree(path.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.Import | ast.ImportFrom):
            found |= {alias.asname or alias.name for alias in node.names}
        else:
            found |= {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
    return found


def room(module: str) -> str:
    return module.split(".")[1] if "." in module else FACADE


def broken_rules(root: Path, floors: tuple[tuple[str, ...], ...] = FLOORS) -> list[str]:
    """Return one sentence for every import that goes up or sideways, for a cycle, for a room
    without a floor or a floor without its room, and for a name in a string that leads nowhere."""
    known = modules(root)
    floor = {name: number for number, rooms in enumerate(floors) for name in rooms}
    there = {room(name) for name in known}
    found = [f"{name} is in no room of the house" for name in known if room(name) not in floor]
    found += [f"the room {name} has a floor and is not there" for name in floor.keys() - there]
    graph: dict[str, set[str]] = {}
    for name, path in known.items():
        texts = list(named(path, known))
        graph[name] = {target for target, _ in imported(name, path, known)}
        uses = [*imported(name, path, known), *((target, line) for target, _, line in texts)]
        for target, line in uses:
            here, where = room(name), room(target)
            if here != where and floor.get(where, 99) >= floor.get(here, -1):
                found.append(f"{name}:{line} imports {target}, which is not on a floor below")
        for target, function, line in texts:
            if target not in known or function not in defines(known[target]) | {""}:
                found.append(f"{name}:{line} names {target}:{function}, which is not there")
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        found.append("imports go in a circle: " + " -> ".join(error.args[1]))
    return found


def test_imports_only_go_down() -> None:
    assert broken_rules(ROOT) == []


def test_the_walk_sees_the_package() -> None:
    # Guards the test above against passing on an empty folder.
    known = modules(ROOT)
    assert {"wraparc", "wraparc.errors", "wraparc.units.parse"} <= set(known)
    parse = known["wraparc.units.parse"]
    assert "wraparc.errors" in {t for t, _ in imported("wraparc.units.parse", parse, known)}


@pytest.mark.parametrize(
    ("where", "text", "complaint"),
    [
        ("errors.py", "import wraparc.units", "wraparc.errors:1 imports wraparc.units"),
        ("drive/belt.py", "from wraparc import arc", "wraparc.drive.belt:1 imports wraparc.arc"),
        ("drive/belt.py", "from ..arc import solver", "imports wraparc.arc.solver"),
        ("drive/belt.py", "from ..arc.solver import x", "imports wraparc.arc.solver"),
        ("drive/belt.py", "from wraparc import solve", "wraparc.drive.belt:1 imports wraparc,"),
        ("drive/belt.py", "def f():\n    import wraparc.cli", "wraparc.drive.belt:2 imports"),
        (
            "drive/belt.py",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from wraparc.arc import x",
            "wraparc.drive.belt:3 imports wraparc.arc",
        ),
        (
            "drive/belt.py",
            "import importlib\nimportlib.import_module('wraparc.arc')",
            "wraparc.drive.belt:2 imports wraparc.arc",
        ),
        ("train.py", "import wraparc.motion", "which is not on a floor below"),
        ("drive/belt.py", "from wraparc.drive import pulley", "imports go in a circle"),
        ("drive/belt.py", "VIEW = 'wraparc.arc.solver:solve'", "imports wraparc.arc.solver, which"),
        ("drive/belt.py", "WHERE = 'wraparc.arc'", "wraparc.drive.belt:1 imports wraparc.arc,"),
        (
            "arc/solver.py",
            "V = 'wraparc.drive.belt:width'",
            "names wraparc.drive.belt:width, which",
        ),
        (
            "arc/solver.py",
            "V = 'wraparc.drive.bolt:width'",
            "names wraparc.drive.bolt:width, which",
        ),
        ("attic.py", "", "wraparc.attic is in no room of the house"),
        ("motion.py", None, "the room motion has a floor and is not there"),
    ],
)
def test_a_bad_import_is_rejected(
    tmp_path: Path, where: str, text: str | None, complaint: str
) -> None:
    """A small house in order, and one bad line in it, or a file that is gone."""
    floors = (("errors",), ("drive",), ("arc",), ("train", "motion"), (FACADE,))
    for name, content in {
        "__init__.py": "from wraparc.arc.solver import solve",
        "errors.py": "",
        "arc/__init__.py": "",
        "arc/solver.py": "from wraparc.errors import WraparcError",
        "drive/__init__.py": "",
        "drive/pulley.py": "from wraparc.drive.belt import Belt",
        "drive/belt.py": "",
        "motion.py": "VIEW = 'wraparc.arc.solver:WraparcError'",
        "train.py": "",
    }.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(content, "utf-8")
    assert broken_rules(tmp_path, floors) == []
    if text is None:
        (tmp_path / where).unlink()
    else:
        (tmp_path / where).write_text(text, "utf-8")
    assert complaint in "\n".join(broken_rules(tmp_path, floors))


def loaded_by(code: str) -> set[str]:
    """Return the top-level modules that a fresh interpreter has loaded after running code."""
    script = f"{code}\nimport json, sys\nprint(json.dumps(sorted(sys.modules)))"
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return {name.partition(".")[0] for name in json.loads(run.stdout.splitlines()[-1])}


def test_the_base_import_pulls_no_extra() -> None:
    loaded = loaded_by("import wraparc")
    assert "wraparc" in loaded
    assert loaded.isdisjoint(EXTRAS)


def test_the_base_install_is_what_the_rooms_need() -> None:
    """What is installed without an extra, and nothing a room imports is in neither list."""
    project = tomllib.loads((ROOT.parents[1] / "pyproject.toml").read_text("utf-8"))["project"]
    named = {re.split(r"[^\w-]", d)[0].replace("-", "_") for d in project["dependencies"]}
    assert named == BASE
    known = {FACADE, *BASE, *EXTRAS, *sys.stdlib_module_names, *UNDER_THE_EXTRAS}
    assert {
        target.partition(".")[0]
        for path in ROOT.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        for target in (
            [a.name for a in node.names]
            if isinstance(node, ast.Import)
            else [node.module or FACADE]
            if isinstance(node, ast.ImportFrom) and not node.level
            else []
        )
    } <= known


def test_every_room_imports_with_every_extra_absent() -> None:
    names = [name for name in modules(ROOT) if room(name) not in OPTIONAL_ROOMS | {"__main__"}]
    names = [name for name in names if name not in OPTIONAL_MODULES]
    block = f"import sys\nsys.modules.update(dict.fromkeys({EXTRAS!r}))\n"
    assert "wraparc" in loaded_by(block + "\n".join(f"import {name}" for name in names))


def test_the_map_of_contributors_shows_every_floor() -> None:
    text = (REPOSITORY / "CONTRIBUTING.md").read_text("utf-8")
    rows = re.findall(r"^\| (\d+) \| ([^|]+) \|", text, re.MULTILINE)
    assert [int(number) for number, _ in rows] == list(range(len(FLOORS)))
    assert tuple(tuple(re.findall(r"`(\w+)`", rooms)) for _, rooms in rows) == FLOORS


def test_every_place_of_the_map_is_there() -> None:
    text = (REPOSITORY / "CONTRIBUTING.md").read_text("utf-8")
    places = text.split("### Where is what")[1].split("\n## ")[0]
    names = re.findall(r"`([a-z_]+/[a-z_/]+(?:\.py)?)`", places)
    assert len(names) >= 20
    for name in names:
        outside = name.startswith(("docs/", "tests/", "tools/"))
        assert ((REPOSITORY if outside else ROOT) / name).exists(), name
