"""Which tests a developer runs before a commit: those of what changed, then those above it.

Prints one argument of pytest a line: what is always run (`SMOKE`), the tests of each room that
differs from HEAD, then those of the rooms that import it, by floor, the nearest first.
"""

import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from test_imports import FACADE, FLOORS, imported, modules, room  # noqa: E402

#: The answers of `solve`, every page once, and the floors, whatever changed.
SMOKE = (
    "tests/test_imports.py",
    "tests/golden/test_golden.py::test_answers_are_what_they_were[cli-solve]",
    "tests/web/test_pages.py::test_every_page_opens_without_a_word_of_complaint",
)
#: What is in no room, and the tests that look at it.
ELSEWHERE = {
    "examples": ("tests/golden",),
    "docs": ("tests/docs",),
    "tools": ("tests/web/test_page_kernel.py", "tests/web/test_static.py"),
    "README.md": ("tests/cli/test_readme.py",),
    "pyproject.toml": ("tests/test_public.py",),
}


def changed() -> list[str]:
    """Return the files that differ from HEAD, new ones too, from the root of the project."""
    lines = subprocess.run(
        ["git", "status", "--porcelain", "--untracked-files=all", "--no-renames", "-z"],
        cwd=ROOT, check=True, capture_output=True, encoding="utf-8",
    ).stdout.split("\0")  # fmt: skip
    return [line[3:] for line in lines if line]


def above(rooms: set[str]) -> list[str]:
    """Return the rooms that import some rooms, themselves or by others, the lowest floor first."""
    known = modules(ROOT / "src" / FACADE)
    uses: dict[str, set[str]] = {}
    for name, path in known.items():
        here = uses.setdefault(room(name), set())
        here |= {room(target) for target, _ in imported(name, path, known)} - {room(name)}
    reached = set(rooms)
    for one in TopologicalSorter(uses).static_order():
        if uses.get(one, set()) & reached:
            reached.add(one)
    return [one for floor in FLOORS for one in floor if one in reached - rooms]


def tests_of(name: str) -> list[str]:
    """Return the folder or file of tests of a room, if there is one."""
    there = (f"tests/{name}", f"tests/test_{name}.py")
    return [path for path in there if (ROOT / path).exists()]


def chosen(files: list[str]) -> list[str]:
    """Return the arguments of pytest for some changed files."""
    rooms: set[str] = set()
    found: list[str] = []
    for file in files:
        top, *rest = Path(file).parts
        if top == "src" and len(rest) > 1:
            rooms.add(Path(rest[1]).stem)
        elif top == "tests" and rest and Path(file).name.startswith("test_"):
            found += [file] if (ROOT / file).exists() else []
        elif top == "tests" and len(rest) > 1:
            found.append(f"tests/{rest[0]}")
        else:
            found += ELSEWHERE.get(top, ())
    there = {one for floor in FLOORS for one in floor}
    for one in [*sorted(rooms & there), *above(rooms & there)]:
        found += tests_of(one)
    return list(dict.fromkeys((*SMOKE, *found)))


if __name__ == "__main__":
    print("\n".join(chosen(changed())))
