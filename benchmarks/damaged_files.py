"""Damaged machine files and damaged folders of tests: sentences, never a traceback.

Run it with ``python benchmarks/damaged_files.py 5000 2000`` (files, folders). Each item has a seed
of its own, so that one can be repeated: ``python benchmarks/damaged_files.py --file 1234`` or
``--folder 77``. An item fails if it raises anything but `InputError`, or warns. CPU time and
peak memory are of the item; a workbook is read in a process of its own, whose memory is not in it.
"""

import io
import random
import signal
import sys
import time
import traceback
import warnings
import zipfile
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import numpy as np

from wraparc.answer.document import json_text
from wraparc.answer.shear_test_document import plan_document
from wraparc.answer.shear_test_tables import plan_sheet
from wraparc.errors import InputError
from wraparc.files.write import lagging_text
from wraparc.friction import IntegralLog, PressureKnots
from wraparc.shear_test import (
    DIALECTS,
    Choices,
    PlannedTest,
    Rig,
    Sample,
    TestPlan,
    VirtualRig,
    VirtualTest,
    fit_plan,
    read_machine_bytes,
    reduce_record,
    run_virtual_test,
)

LAW = IntegralLog(
    coefficients=PressureKnots(
        pressure=(34e3, 172e3, 690e3),
        peak_friction=(1.30, 0.86, 0.385),
        peak_slip=(0.016, 0.0205, 0.026),
    )
)
PRESSURES = (34e3, 138e3, 276e3, 690e3)
Rng = random.Random

SWAPS = [(b",", b";"), (b".", b","), (b",", b"."), (b"\n", b"\r"), (b'"', b""), (b"\t", b" "),
         (b";", b"\t"), (b"mm", b"mN"), (b"N", b"Q"), (b"0", b""), (b"0", b"7"), (b"1", b""),
         (b",", b",,"), (b";", b" ;"), (b"-", b""), (b"\n", b"\n\n"), (b"mm", b"m")]  # fmt: skip
WORDS = [b"nan", b"1e999", b"_1", b"--", b"inf", b"0x1", b"1 ", b"1e300", b"-1e308", b"9" * 40]


def cut(data: bytes, rng: Rng) -> bytes:
    return data[: rng.randrange(len(data))]


def behead(data: bytes, rng: Rng) -> bytes:
    return data[rng.randrange(len(data)) :]


def flip(data: bytes, rng: Rng) -> bytes:
    changed = bytearray(data)
    for _ in range(rng.randrange(1, 30)):
        changed[rng.randrange(len(changed))] = rng.randrange(256)
    return bytes(changed)


def remove(data: bytes, rng: Rng) -> bytes:
    start = rng.randrange(len(data))
    return data[:start] + data[start + rng.randrange(200) :]


def insert(data: bytes, rng: Rng) -> bytes:
    place = rng.randrange(len(data))
    return data[:place] + rng.randbytes(rng.randrange(50)) + data[place:]


def swap(data: bytes, rng: Rng) -> bytes:
    return data.replace(*rng.choice(SWAPS))


def shuffle(data: bytes, rng: Rng) -> bytes:
    lines = data.split(b"\n")
    rng.shuffle(lines)
    return b"\n".join(lines)


def spoil(data: bytes, rng: Rng) -> bytes:
    return data.replace(b"1", rng.choice(WORDS), rng.randrange(1, 40))


def repeat(data: bytes, rng: Rng) -> bytes:
    """Write a stretch of lines again and again, elsewhere."""
    lines = data.split(b"\n")
    start = rng.randrange(len(lines))
    stretch = lines[start : start + rng.randrange(1, 30)] * rng.randrange(1, 20)
    place = rng.randrange(len(lines))
    return b"\n".join([*lines[:place], *stretch, *lines[place:]])


def lengthen(data: bytes, rng: Rng) -> bytes:
    """Make one line very long."""
    lines = data.split(b"\n")
    place = rng.randrange(len(lines))
    lines[place] = (lines[place] + rng.choice([b"", b",", b";", b"\t", b" "])) * rng.randrange(2000)
    return b"\n".join(lines)


MUTATIONS: list[Callable[[bytes, Rng], bytes]] = [
    cut, behead, flip, remove, insert, swap, shuffle, spoil, repeat, lengthen,
]  # fmt: skip


@cache
def samples() -> list[tuple[bytes, dict[str, str]]]:
    """Return a test as every kind of machine writes it, and the units that have to be told."""
    test = run_virtual_test(VirtualRig(law=LAW, points=160, wander=0.01), 207e3, 2)
    return [(dialect.write(test), dict(dialect.units)) for dialect in DIALECTS.values()]


def mutated(data: bytes, rng: Rng) -> bytes:
    """Damage a file one to three times; of a workbook, what is packed in it as well."""
    if data.startswith(b"PK") and rng.random() < 0.7:
        return repacked(data, rng)
    for _ in range(rng.randrange(1, 4)):
        data = rng.choice(MUTATIONS)(data, rng) if data else data
    return data


def repacked(data: bytes, rng: Rng) -> bytes:
    """Damage one part of a workbook and pack it again."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w", 8) as new:
        names = old.namelist()
        chosen = rng.choice([*names, *[n for n in names if "sheet" in n] * 4])
        for name in names:
            part = old.read(name)
            if name == chosen and part:
                part = rng.choice(MUTATIONS)(part, rng)
                part = part.replace(b'r="B', rng.choice([b'r="B', b'r="XFD', b's="B']), 3)
            new.writestr(name, part)
    return out.getvalue()


def use_file(seed: int) -> str:
    """Read and reduce one damaged file; say in a word what came of it."""
    rng = Rng(seed)
    data, units = rng.choice(samples())
    try:
        record = read_machine_bytes(mutated(data, rng), "damaged", Choices(units=units))
    except InputError as error:
        return _said(error, "refused")
    assert np.isfinite(record.travel).all()
    assert np.isfinite(record.force).all()
    assert len(record.travel) == len(record.force) == len(record.lines)
    try:
        reduce_record(record, Sample(area=0.04, normal_force=8000.0))
    except InputError:
        return "read, no curve"
    return "read"


def _said(error: InputError, word: str) -> str:
    assert all(problem.message and problem.remedy for problem in error.problems)
    return word


Damage = Callable[[VirtualTest, Rng], VirtualTest]


def _some(test: VirtualTest, rng: Rng) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    count = len(test.travel)
    return np.array(rng.sample(range(count), rng.randrange(1, max(2, count // 8))))


def scaled_travel(test: VirtualTest, rng: Rng) -> VirtualTest:
    """As metres under a header of millimetres, and the like."""
    return replace(test, travel=test.travel * rng.choice([1e-3, 1e3, 1 / 25.4, 25.4, 1e-6]))


def scaled_force(test: VirtualTest, rng: Rng) -> VirtualTest:
    return replace(test, force=test.force * rng.choice([1e-3, 1e3, 4.448, 0.5, 2.0, -1.0, 20.0]))


def spikes(test: VirtualTest, rng: Rng) -> VirtualTest:
    force = test.force.copy()
    force[_some(test, rng)] *= rng.choice([100.0, -100.0, 0.0, 1e6])
    return replace(test, force=force)


def falling_normal_force(test: VirtualTest, rng: Rng) -> VirtualTest:
    ends = rng.choice([0.01, 0.1, 0.5, 3.0, 100.0])
    return replace(test, normal_force=test.normal_force * np.geomspace(1, ends, len(test.travel)))


def spiked_normal_force(test: VirtualTest, rng: Rng) -> VirtualTest:
    normal = test.normal_force.copy()
    normal[_some(test, rng)] *= rng.choice([0.0, 1e-3, -1.0, 100.0])
    return replace(test, normal_force=normal)


def constant_force(test: VirtualTest, rng: Rng) -> VirtualTest:
    level = rng.choice([0.0, 1.0, float(test.force.max())])
    return replace(test, force=np.full_like(test.force, level))


def straight_force(test: VirtualTest, _: Rng) -> VirtualTest:
    return replace(test, force=test.travel / test.travel.max() * test.force.max())


def falling_force(test: VirtualTest, _: Rng) -> VirtualTest:
    return replace(test, force=test.force[::-1].copy())


def step_force(test: VirtualTest, rng: Rng) -> VirtualTest:
    place = rng.randrange(1, len(test.force))
    return replace(test, force=np.where(np.arange(len(test.force)) < place, 0.0, test.force.max()))


def noise(test: VirtualTest, rng: Rng) -> VirtualTest:
    random_numbers = np.random.default_rng(rng.randrange(2**31))
    level = rng.choice([0.1, 0.5, 2.0]) * np.abs(test.force).max()
    return replace(test, force=test.force + random_numbers.normal(0, level, len(test.force)))


def offset(test: VirtualTest, rng: Rng) -> VirtualTest:
    return replace(test, force=test.force + rng.choice([-2.0, -0.5, 0.5, 5.0]) * test.force.max())


def short(test: VirtualTest, rng: Rng) -> VirtualTest:
    stop = rng.randrange(2, len(test.travel))
    return replace(
        test, travel=test.travel[:stop], force=test.force[:stop],
        normal_force=test.normal_force[:stop], time=test.time[:stop],
    )  # fmt: skip


def coarse(test: VirtualTest, rng: Rng) -> VirtualTest:
    step = rng.choice([1e-5, 1e-4, 1e-3, 5e-3])
    return replace(test, travel=np.round(test.travel / step) * step)


def stuck_travel(test: VirtualTest, rng: Rng) -> VirtualTest:
    travel = test.travel.copy()
    travel[rng.randrange(1, len(travel)) :] = travel[rng.randrange(len(travel))]
    return replace(test, travel=travel)


def saturated(test: VirtualTest, rng: Rng) -> VirtualTest:
    limit = rng.choice([0.05, 0.3, 0.8]) * test.force.max()
    return replace(test, force=np.minimum(test.force, limit))


def whole(test: VirtualTest, _: Rng) -> VirtualTest:
    return test


DAMAGES: list[Damage] = [
    scaled_travel, scaled_force, spikes, falling_normal_force, spiked_normal_force,
    constant_force, straight_force, falling_force, step_force, noise, offset, short, coarse,
    stuck_travel, saturated,
]  # fmt: skip


@cache
def laboratory(points: int = 120) -> list[tuple[float, VirtualTest]]:
    """Return two sound tests at each pressure."""
    rig = VirtualRig(law=LAW, points=points, noise=0.01, lash=0.4e-3, scatter_friction=0.02)
    return [
        (pressure, run_virtual_test(rig, pressure, 10 * k + n))
        for k, pressure in enumerate(PRESSURES)
        for n in range(2)
    ]


def use_folder(seed: int) -> str:
    """Fit a folder in which some tests, or all, are damaged; say in a word what came of it."""
    rng = Rng(seed)
    tests = rng.sample(laboratory(), rng.randrange(2, len(laboratory()) + 1))
    share = rng.choice([0.15, 0.3, 0.6, 1.0])
    files, planned = {}, []
    for number, (pressure, test) in enumerate(tests, start=1):
        damaged = test
        for damage in rng.sample(DAMAGES, rng.choice([1, 1, 2])) if rng.random() < share else ():
            damaged = damage(damaged, rng)
        name = f"{number}.txt"
        files[name] = DIALECTS["logger"].write(damaged)
        set_pressure = pressure * rng.choice([1, 1, 1, 1, 1, 10, 1e-3, 0.5])
        choices = Choices() if rng.random() < 0.8 else Choices(normal_force="Time")
        planned.append(
            PlannedTest(
                file=name, place=f"test[{number}]", pressure=set_pressure, choices=choices,
                condition=rng.choice(["dry", "dry", "dry", "wet"]),
            )
        )  # fmt: skip
    plan = TestPlan(name="damaged", rig=Rig(area=0.04), tests=tuple(planned))
    if rng.random() < 0.5:
        plan = replace(plan, thickness=12e-3, shear_modulus=2.3e6)
    try:
        result = fit_plan(
            plan, read=lambda test: read_machine_bytes(files[test.file], test.file, test.choices)
        )
    except InputError as error:
        return _said(error, "no test can be used")
    lagging_text(result.laggings)
    json_text(plan_document(result))
    plan_sheet(result)
    used = sum(len(condition.tests) for condition in result.conditions)
    assert used + len({problem.key for problem in result.left_out}) >= len(tests)
    return "all tests fitted" if used == len(tests) else "some tests left out"


def _peak() -> int:
    status = Path("/proc/self/status").read_text("ascii")
    return int(status.split("VmHWM:")[1].split()[0])


def measured(use: Callable[[int], str], seed: int) -> tuple[str, float, float]:
    """What came of an item, its CPU time [s] and how much memory the process has [MB]."""
    Path("/proc/self/clear_refs").write_text("5", "ascii")
    start = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            said = use(seed)
    except Exception:  # noqa: BLE001 - that is what is counted
        said = f"FAILED: {traceback.format_exc().splitlines()[-1]}"
        print(f"seed {seed}", traceback.format_exc(), file=sys.stderr)
    return said, time.process_time() - start, _peak() / 1024


def run(name: str, use: Callable[[int], str], count: int) -> None:
    results: list[tuple[str, float, float]] = []
    with suppress(KeyboardInterrupt):  # ended before, it tells what it has
        results.extend(map(partial(measured, use), range(count)))
    times, peaks = np.array([r[1] for r in results]), np.array([r[2] for r in results])
    print(f"| {len(results)} {name} | |\n|---|---|")
    for said, often in Counter(r[0] for r in results).most_common():
        print(f"| {said} | {often} |")
    print(f"| CPU time, median and largest [s] | {np.median(times):.3f}, {times.max():.2f} |")
    print(f"| seed of the slowest | {int(times.argmax())} |")
    print(f"| memory of the process, largest [MB] | {peaks.max():.0f} |\n", flush=True)


if __name__ == "__main__":
    kind, *more = sys.argv[1:] or ["5000", "2000"]
    if kind in {"--file", "--folder"}:
        print(measured(use_file if kind == "--file" else use_folder, int(more[0])))
    else:
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        for name, use, count in (
            ("damaged files", use_file, int(kind)),
            ("folders with damaged tests", use_folder, int(more[0])),
        ):
            if count:
                run(name, use, count)
