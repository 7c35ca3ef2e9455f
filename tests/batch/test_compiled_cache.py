"""Compiled code on disk is never that of another source.

Expected values: the interpreter, which has no cache.
"""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import wraparc
from wraparc.arc.kernel.butcher import to_last
from wraparc.batch import native, sixth
from wraparc.batch.lane_kernel import solve_rows as lane_rows
from wraparc.batch.lane_sixth import march
from wraparc.batch.precise import capacity_rows, tension_rows

RUN = """
import sys
sys.path.insert(0, sys.argv[1])
import wraparc.batch.native as native
from wraparc.batch.probe import entry
assert native.__file__.startswith(sys.argv[1])
print(native.compiled(entry)(2.0), entry(2.0))
"""
ENTRY = """
from wraparc.batch.probe_helper import inner

def entry(x):
    return inner(x) + 1.0
"""
HELPER = """
FACTOR = {factor}

def deepest(x):
    return {body}

def inner(x):
    return FACTOR * deepest(x)
"""


def test_an_edited_helper_in_another_module_is_compiled_anew(tmp_path: Path) -> None:
    """What numba's own cache gets wrong: it looks at the file of the entry alone."""
    package = tmp_path / "source" / "wraparc"
    shutil.copytree(Path(wraparc.__file__).parent, package)
    folder = package / "batch"
    (folder / "probe.py").write_text(ENTRY, "utf-8")
    for factor, body, expected in (
        ("3.0", "x * x", "13.0 13.0"),
        ("3.0", "x * x", "13.0 13.0"),  # from disk
        ("5.0", "x * x", "21.0 21.0"),  # a constant
        ("5.0", "x + x + x", "31.0 31.0"),  # a function two calls away
    ):
        (folder / "probe_helper.py").write_text(HELPER.format(factor=factor, body=body), "utf-8")
        run = subprocess.run(
            [sys.executable, "-B", "-c", RUN, str(package.parent)],
            capture_output=True,
            text=True,
            check=False,
            env={**os.environ, "WRAPARC_CACHE_DIR": str(tmp_path / "cache")},
        )
        assert run.stdout.strip() == expected, run.stderr
    assert len(list((tmp_path / "cache" / "compiled").iterdir())) == 3


def test_a_full_disk_costs_only_the_code_on_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from numba.core.caching import IndexDataCacheFile

    asked = []

    def full(*_: object) -> None:
        asked.append(1)
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(IndexDataCacheFile, "save", full)
    monkeypatch.setenv("WRAPARC_CACHE_DIR", str(tmp_path))
    numbers = tuple(map(float, range(to_last.__code__.co_argcount)))
    assert native.compiled(to_last)(*numbers) == to_last(*numbers)
    assert asked


MARCH = """
from math import log
from wraparc.arc.kernel.butcher import to_end, to_fifth, to_fourth, to_last, to_second
from wraparc.arc.kernel.butcher import to_sixth, to_third

def rate(x):
    return 0.01 * log(1.0 + x) * x

def entry(x):
    for _ in range(50):
        k1 = rate(x)
        k2 = rate(x + to_second(k1))
        k3 = rate(x + to_third(k2))
        k4 = rate(x + to_fourth(k1, k2, k3))
        k5 = rate(x + to_fifth(k1, k2, k3, k4))
        k6 = rate(x + to_sixth(k2, k3, k4, k5))
        k7 = rate(x + to_last(k1, k2, k3, k4, k6))
        x += to_end(k1, k3, k4, k5, k6, k7)
    return x
"""


def test_numba_left_as_it_is_gives_the_same_numbers(tmp_path: Path) -> None:
    """With its private parts untouched: the switch, and the interpreter as the plain way."""
    package = tmp_path / "source" / "wraparc"
    shutil.copytree(Path(wraparc.__file__).parent, package)
    (package / "batch" / "probe.py").write_text(MARCH, "utf-8")
    found = []
    for switch in ("", "1"):
        run = subprocess.run(
            [sys.executable, "-B", "-c", RUN, str(package.parent)],
            capture_output=True,
            text=True,
            check=False,
            env={
                **os.environ,
                native.AS_IT_IS: switch,
                "WRAPARC_CACHE_DIR": str(tmp_path / "cache"),
            },
        )
        compiled, interpreted = map(float, run.stdout.split())
        assert compiled == interpreted, run.stderr
        found.append(compiled)
    assert found[0] == found[1]
    assert len(list((tmp_path / "cache" / "compiled").iterdir())) == 2


def test_the_fingerprint_covers_all_that_is_compiled() -> None:
    entries = (tension_rows, capacity_rows, lane_rows)
    modules = {f.__module__ for entry in entries for f in native.called(entry)}
    assert {
        "wraparc.friction.compact",
        "wraparc.arc.kernel.march",
        "wraparc.arc.kernel.tension_march",
        "wraparc.arc.kernel.stick",
        "wraparc.arc.kernel.effort",
        "wraparc.arc.kernel.search",
        "wraparc.arc.kernel.answer",
        "wraparc.arc.kernel.capacity",
        "wraparc.arc.profile",
        "wraparc.batch.row",
        "wraparc.batch.lane_march",
        "wraparc.batch.lane_look",
    } <= modules


def test_a_place_that_cannot_be_written_costs_the_cache_only(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("", "utf-8")
    run = subprocess.run(
        [
            sys.executable,
            "-c",
            "from wraparc.batch.native import _folder; print(_folder('abc'))",
        ],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "WRAPARC_CACHE_DIR": str(blocked)},
    )
    assert run.stdout.strip() == "None", run.stderr


THREADS = """
import numpy as np
from wraparc import Setting, load_lagging, solve_batch
n = 40_000
table = dict(entry_tension=np.full(n, 1e5), exit_tension=5e4, diameter=0.8, wrap_angle=3.1,
             belt_width=1.0, belt_modulus=1e7)
laggings = [load_lagging(name) for name in ("diamond-rubber", "full-ceramic")]
first = solve_batch(table, laggings[0], capacities=False, threads=4)
few = {k: v[:4] if np.ndim(v) else v for k, v in table.items()} | {"lagging": [0, 1, 0, 1]}
for setting in Setting:
    again = solve_batch(few, laggings, setting=setting)
    assert again.solved.all()
print(np.ptp(first["exit_creep"]), abs(again["exit_creep"][0] / first["exit_creep"][0] - 1) < 1e-4)
"""


def test_threads_may_be_the_first_to_compile_or_load() -> None:
    """Many threads at once are the first to want an entry, and others are wanted after it."""
    run = subprocess.run(
        [sys.executable, "-X", "faulthandler", "-c", THREADS],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.stdout.split() == ["0.0", "True"], run.stderr


def test_one_process_compiles_a_state_at_a_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What another process would ask for meanwhile is refused, and granted afterwards."""
    fcntl = pytest.importorskip("fcntl", reason="Windows compiles in each process")
    monkeypatch.setenv("WRAPARC_CACHE_DIR", str(tmp_path))
    lock = tmp_path / "compiled" / "a-state" / "lock"
    with native._alone("a-state"), open(lock, "ab") as other, pytest.raises(BlockingIOError):
        fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)
    with open(lock, "ab") as other:
        fcntl.flock(other, fcntl.LOCK_EX | fcntl.LOCK_NB)


def test_the_scalar_kernel_is_never_contracted() -> None:
    """A function is handed to numba once: where the lanes call it, it is to stay as it is."""
    entries = (tension_rows, capacity_rows, sixth.tension_rows, sixth.carried_rows, lane_rows)
    of_kernel = {f for entry in entries[:2] for f in native.called(entry)}
    of_lanes = {f for entry in entries[2:] for f in native.called(entry)}
    assert of_kernel & of_lanes
    assert not any(map(native.contracts, of_kernel - {tension_rows, capacity_rows}))
    assert native.contracts(march)
