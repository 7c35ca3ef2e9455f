"""``wraparc warm``: whoever works after it waits for no compiler.

Expected: what is compiled of the program, looked for in its source; after `warm` the work of each
kind asks for nothing new.
"""

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest

import wraparc as package
from cli.running import wraparc
from wraparc.batch import native

#: Prints the entries that `warm` had compiled or loaded, then those that work after it wanted more.
WORK = """
import json, sys
import numpy as np
from wraparc import Setting, load_lagging, load_train, solve_batch
from numba.core.dispatcher import Dispatcher
from wraparc.batch import native

entries, asked, given, made = set(), [], native._cached, Dispatcher.compile
def kept(entry, *rest):
    entries.add(entry)
    return given(entry, *rest)
def noted(self, signature):  # compiled, or read from the disk
    if self.py_func in entries:
        asked.append(f"{self.py_func.__module__}.{self.py_func.__qualname__}")
    return made(self, signature)
native._cached, Dispatcher.compile = kept, noted

from wraparc.cli import run
code = run(["warm"])
by_warm = list(asked)

rng, n = np.random.default_rng(81), 120
entry = rng.uniform(6e4, 2.5e5, n)
table = dict(entry_tension=entry, exit_tension=entry / rng.uniform(0.8, 2.5, n), diameter=0.8,
             wrap_angle=3.4, belt_width=1.2, belt_modulus=rng.uniform(5e6, 9e7, n))
for name in ("diamond-rubber", "medium-ceramic", "full-ceramic"):
    for setting in Setting:
        solve_batch(table, load_lagging(name), setting=setting)
examples, new = sys.argv[1], sys.argv[2]
for words in (
    ["study", f"{examples}/studies/tolerances.toml", "-o", f"{new}/tolerances.parquet"],
    ["run", f"{examples}/tandem-steel-cord.toml", "--event", "splice", "--step", "100 ms"],
):
    code = code or run(words)
print(json.dumps([code, by_warm, asked[len(by_warm):]]), file=sys.stderr)
"""


def entries() -> set[str]:
    """Names that are handed to `compiled` somewhere in the program, as they stand there."""
    found = set()
    for path in Path(package.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "compiled":
                given = node.args[0]
                either = [given.body, given.orelse] if isinstance(given, ast.IfExp) else [given]
                found |= {ast.unparse(name).rpartition(".")[2] for name in either}
    return found


def test_after_it_nothing_is_left_to_compile(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-c", WORK, "examples", str(tmp_path)],
        capture_output=True,
        text=True,
        check=False,
    )
    *lines, last = run.stderr.splitlines()
    code, by_warm, later = json.loads(last)
    assert (code, later) == (0, []), run.stderr
    # "entry" stands for one of several: the work above needs those
    assert entries() - {"entry"} <= {name.rpartition(".")[2] for name in by_warm}
    assert len(by_warm) == len(set(by_warm)) > 12
    told = [line for line in lines if " of " in line]
    assert [line.partition(" ")[0] for line in told] == [str(i + 1) for i in range(len(told))]
    assert all(line.endswith(" s") for line in told)
    assert "Ready after " in run.stdout
    assert f"kept in {native.kept_in()}." in run.stdout


def test_without_a_compiler_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(native, "available", lambda: False)
    ran = wraparc("warm")
    assert ran.code == 2
    assert "pip install 'wraparc[fast]'" in ran.err


def test_without_a_place_it_says_so_and_compiles_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("", "utf-8")
    monkeypatch.setenv("WRAPARC_CACHE_DIR", str(blocked))
    monkeypatch.setattr(native, "compiled", None)
    ran = wraparc("warm")
    assert ran.code == 2
    assert "cannot be written" in ran.err
    assert "WRAPARC_CACHE_DIR" in ran.err
    assert list(tmp_path.iterdir()) == [blocked]
