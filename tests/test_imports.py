"""The floors of the house: imports only go down, never in a circle, extras stay outside.

The rule is that of CONTRIBUTING.md: a room (a module or package directly in wraparc)
imports from its own package and from floors below its own.
"""

import ast
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

# Lowest first; where a floor is a stair, one step a line.
FLOORS: tuple[tuple[str, ...], ...] = (
    ("version", "errors", "views"),
    ("units", "saving", "provenance"),
    ("glossary", "machine_tables"),
    ("schema",),
    ("friction", "catalogue"),
    ("drive",),
    ("arc", "shear_test"),
    ("files", "batch"),
    ("train", "across", "motion"),
    ("checks",),
    ("study", "choose", "calibrate"),
    ("plot", "present"),
    ("report",),
    ("web",),
    ("cli",),
    ("__main__", FACADE),
)
FLOOR = {room: number for number, rooms in enumerate(FLOORS) for room in rooms}

# What the base install brings, and what only an extra does (by import name).
BASE = {"click", "numpy", "tomli_w"}
EXTRAS = (
    "alembic", "annotated_types", "calamine", "dask", "distributed", "emcee", "fastapi",
    "matplotlib", "multipart", "numba", "pandas", "psycopg", "pyarrow", "pydantic",
    "python_calamine", "rich", "scipy", "sqlalchemy", "starlette", "typst", "uvicorn", "xlsxwriter",
)  # fmt: skip
# Libraries that come with one of an extra and are used beside it.
UNDER_THE_EXTRAS = {"llvmlite"}
# Rooms that are nothing without their extra and may import it at the top.
OPTIONAL_ROOMS = {"web"}
# Modules that exist for their extra alone and are imported only where it is used.
OPTIONAL_MODULES = {"wraparc.batch.underlay"}


def modules(root: Path) -> dict[str, Path]:
    """Return every module below a package folder, by dotted name."""
    found = {}
    for path in sorted(root.rglob("*.py")):
        parts = (FACADE, *path.relative_to(root).with_suffix("").parts)
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imported(name: str, path: Path, known: dict[str, Path]) -> Iterator[tuple[str, int]]:
    """Yield every wraparc module that a module imports, wherever in its text, with the line."""
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path))):
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


def room(module: str) -> str:
    return module.split(".")[1] if "." in module else FACADE


def broken_rules(root: Path) -> list[str]:
    """Return one sentence for every import that goes up or sideways, and for a cycle."""
    known = modules(root)
    found = [f"{name} is in no room of the house" for name in known if room(name) not in FLOOR]
    graph: dict[str, set[str]] = {}
    for name, path in known.items():
        graph[name] = set()
        for target, line in imported(name, path, known):
            graph[name].add(target)
            here, there = room(name), room(target)
            if here != there and FLOOR.get(there, 99) >= FLOOR.get(here, -1):
                found.append(f"{name}:{line} imports {target}, which is not on a floor below")
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
        ("attic.py", "", "wraparc.attic is in no room of the house"),
    ],
)
def test_a_bad_import_is_rejected(tmp_path: Path, where: str, text: str, complaint: str) -> None:
    """A small house in order, and one bad line in it."""
    for name, content in {
        "__init__.py": "from wraparc.arc.solver import solve",
        "errors.py": "",
        "arc/__init__.py": "",
        "arc/solver.py": "from wraparc.errors import WraparcError",
        "drive/__init__.py": "",
        "drive/pulley.py": "from wraparc.drive.belt import Belt",
        "drive/belt.py": "",
        "motion.py": "",
    }.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(content, "utf-8")
    assert broken_rules(tmp_path) == []
    (tmp_path / where).write_text(text, "utf-8")
    assert complaint in "\n".join(broken_rules(tmp_path))


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
