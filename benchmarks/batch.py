"""Speed and accuracy of the batch kernel.

    python benchmarks/batch.py figures     what a design costs in every setting, beside its aim
    python benchmarks/batch.py [designs]   mesh, accuracy, size, and SciPy beside them; then these

Random driving designs of the shipped diamond-rubber lagging, and of the others where said. The
general way beside it, in the same run, is SciPy's solve_ivp inside brentq, slip as the state. Wall
times drift with the machine and its other work; ratios
of processor time hold.
"""

from __future__ import annotations

import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from wraparc.batch.lane_kernel import GUESSED, TENSIONS

from wraparc import load_lagging
from wraparc.batch import Setting, engineering, lane_slots, row, solve_arcs
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.friction import Constant, FrictionLaw, MeasuredTable
from wraparc.friction.compact import branch_of, friction_at, segment_of

Table = dict[str, NDArray[np.float64]]
RUBBER = load_lagging("diamond-rubber")
Row = tuple[str, str, str]  # what, figure, aim
TABLE = MeasuredTable(
    slip=(0.0, 0.5e-3, 1.5e-3, 4e-3, 8e-3, 12e-3),
    pressure=(40e3, 150e3, 350e3, 600e3),
    values=(
        (0.0, 0.25, 0.5, 0.8, 0.95, 0.9),
        (0.0, 0.2, 0.42, 0.68, 0.8, 0.8),
        (0.0, 0.15, 0.33, 0.55, 0.66, 0.7),
        (0.0, 0.1, 0.22, 0.38, 0.46, 0.5),
    ),
)


def designs(n: int, seed: int = 1) -> Table:
    """Fabric and steel-cord drives within the tested pressures."""
    rng = np.random.default_rng(seed)
    diameter, width = rng.uniform(0.6, 1.2, n), rng.uniform(0.8, 1.6, n)
    entry = rng.uniform(150e3, 450e3, n) * width * diameter / 2.0
    return {
        "entry_tension": entry,
        "exit_tension": entry / rng.uniform(1.3, 3.0, n),
        "diameter": diameter,
        "wrap_angle": rng.uniform(2.9, 3.7, n),
        "belt_width": width,
        "belt_modulus": np.exp(rng.uniform(np.log(8e6), np.log(2e8), n)),
    }


def cost(run: Callable[[], object], repeats: int = 3) -> tuple[float, float]:
    """Least wall and processor time [s]."""
    walls, cpus = [], []
    for _ in range(repeats):
        wall, cpu = time.perf_counter(), time.process_time()
        run()
        walls.append(time.perf_counter() - wall)
        cpus.append(time.process_time() - cpu)
    return min(walls), min(cpus)


def generally(arcs: Arcs, i: int) -> float:
    """Exit creep of one arc by SciPy [m]: solve_ivp at 1e-6 inside brentq.

    The best of the general ways: slip as the state, so that no root is left inside, and the law
    by the same scalar function. g is sought within a factor of 30 of what it is.
    """
    compact = arcs.laws.compact(0)
    given = arcs.inputs()[i].tolist()
    radius, angle, width, compliance, soft = given[1:6]
    entry, goal = given[9], math.log(given[10] / given[9])
    kick = given[7] * (entry / (width * radius)) ** 1.5

    def law(slip: float, p: float) -> tuple[float, float, float]:
        segment = segment_of(compact, p)
        branch = branch_of(compact, segment, slip, p)
        return friction_at(compact, segment, branch, slip, p)

    def rates(_: float, y: NDArray[np.float64], g: float) -> list[float]:
        tension = entry * math.exp(y[1])
        p = tension / (width * radius)
        mu, mu_x, mu_p = law(max(float(y[0]), 1e-12), p)
        creep = g + (entry - tension) * compliance
        slip = (creep + soft * (mu + p * mu_p) * p * mu / radius) / (1.0 + soft * p * mu_x)
        return [slip, -mu / radius]

    p1 = entry / (width * radius)
    start = brentq(lambda x: x + soft * law(x, p1)[0] * p1 - kick, 1e-12, kick)
    end: dict[str, float] = {}

    def miss(log_g: float) -> float:
        g = math.exp(log_g)
        run = solve_ivp(
            rates, (0.0, radius * angle), [start, 0.0], args=(g,), rtol=1e-6, atol=1e-10
        )
        tension = entry * math.exp(run.y[1, -1])
        p = tension / (width * radius)
        end["creep"] = run.y[0, -1] + soft * law(run.y[0, -1], p)[0] * p
        return float(run.y[1, -1] - goal)

    guess = math.log(max(exact_ratio(arcs, i), 1e-7))
    brentq(miss, guess - 2.0, guess + 1.5, xtol=1e-6)
    return end["creep"]


def exact_ratio(arcs: Arcs, i: int) -> float:
    """G of one arc [-], to bracket the root of the general way."""
    one = solve_arcs(arcs.rows(slice(i, i + 1)), setting=Setting.PRECISE, capacities=False)
    return float(one["entry_creep_ratio"][0])


def against_scipy(arcs: Arcs) -> float:
    """Processor time of the general way [s]."""
    times, misses = [], []
    exact = solve_arcs(arcs.rows(slice(0, 60)), setting=Setting.PRECISE, capacities=False)
    for i in range(60):
        if exact["entry_creep_ratio"][i] <= 0.0:
            continue
        cpu = time.process_time()
        creep = generally(arcs, i)
        times.append(time.process_time() - cpu)
        misses.append(abs(creep / exact["exit_creep"][i] - 1.0))
    print(f"solve_ivp + brentq: {1e3 * np.median(times):.1f} ms CPU a design,"
          f" creep within {max(misses):.0e} of the precise setting")  # fmt: skip
    return float(np.median(times))


def speed(arcs: Arcs, scipy: float) -> None:
    n = len(arcs)
    print(f"\n{n} designs, diamond rubber: operating point, peak shear, energy, active arc")
    for threads in (1, 2):
        wall, cpu = cost(lambda t=threads: solve_arcs(arcs, capacities=False, threads=t))  # type: ignore[misc]
        print(f"  engineering, {threads} thread(s): {wall:.3f} s, CPU {cpu:.3f} s:"
              f" {n / wall:,.0f} a second, {1e6 * cpu / n:.2f} us CPU each,"
              f" {scipy * n / cpu:,.0f} times less CPU than SciPy")  # fmt: skip
    few = arcs.rows(slice(0, n // 20))
    wall, cpu = cost(lambda: solve_arcs(few, capacities=False, setting=Setting.PRECISE, threads=1))
    print(f"  precise, 1 thread: {1e6 * cpu / len(few):.0f} us CPU each,"
          f" {scipy * len(few) / cpu:,.0f} times less than SciPy")  # fmt: skip
    wall, cpu = cost(lambda: solve_arcs(few), 1)
    print(f"  engineering with all capacities: {1e6 * cpu / len(few):.0f} us CPU each")
    wall, cpu = cost(lambda: solve_arcs(few, setting=Setting.PRECISE, threads=1), 1)
    print(f"  precise with all capacities: {1e6 * cpu / len(few):.0f} us CPU each")


def steps(arcs: Arcs) -> None:
    """What each part of the way brought."""
    n = len(arcs)
    exact = solve_arcs(arcs, setting=Setting.PRECISE, capacities=False)
    batch = engineering.LaneBatch(arcs)
    batch.find_gross(row.TENSIONS)
    rows = batch.rows(np.arange(n), 1.0)
    place = engineering._FOUND[lane_slots.EXIT_CREEP]
    print("\nmesh steps of the lane kernel, one thread (before anything is handed over)")
    for mesh in (16, 24, 32, 48, 64, 96):
        _, cpu = cost(
            lambda m=mesh: engineering.run_lanes(
                rows, batch.laws.numbers, TENSIONS, GUESSED, m, False
            )  # type: ignore[misc]
        )
        out = engineering.run_lanes(rows, batch.laws.numbers, TENSIONS, GUESSED, mesh, False)
        miss = np.abs(out[:, place] / exact["exit_creep"] - 1.0)
        print(f"  {mesh}: {1e6 * cpu / n:.2f} us CPU, creep median {np.median(miss):.0e},"
              f" 99.9 % {np.percentile(miss, 99.9):.0e}, worst {np.max(miss):.0e}")  # fmt: skip
    with patch.object(engineering, "available", lambda: False):
        _, cpu = cost(lambda: solve_arcs(arcs, capacities=False, threads=1), 1)
    print(f"  without numba, the same on NumPy: {1e6 * cpu / n:.0f} us CPU each")


def accuracy(n: int) -> None:
    print(f"\nengineering against precise, {n} random designs each (relative miss)")
    for name in ("diamond-rubber", "medium-ceramic", "full-ceramic"):
        arcs = arcs_of_table(designs(n, 7), load_lagging(name))
        near = solve_arcs(arcs, capacities=False)
        exact = solve_arcs(arcs, setting=Setting.PRECISE, capacities=False)
        parts = []
        for column in ("exit_creep", "peak_shear_stress", "frictional_energy"):
            miss = np.abs(near[column] / exact[column] - 1.0)
            high, worst = np.nanpercentile(miss, 99), np.nanmax(miss)
            parts.append(f"{column} {high:.0e} / {worst:.0e}")
        print(f"  {name}: 99 % / worst: {', '.join(parts)}")


FIRST = """
import time
begin = time.process_time()
import numpy as np
from wraparc import load_lagging
from wraparc.batch import Setting, solve_batch
n = {rows}
ratio = np.linspace(1.3, 2.0, n)
ratio[:{braking}] = 0.8
table = dict(entry_tension=np.full(n, 1e5), exit_tension=1e5 / ratio, diameter=0.8,
             wrap_angle=3.1, belt_width=1.0, belt_modulus=1e7)
solve_batch(table, load_lagging("diamond-rubber"), capacities={capacities},
            setting=Setting.{setting})
print(time.process_time() - begin)
"""
START = """
import time
begin = time.perf_counter()
from wraparc import load_lagging
from wraparc.batch import Setting, solve_batch
table = dict(entry_tension=[1e5], exit_tension=[5e4], diameter=0.8, wrap_angle=3.1,
             belt_width=1.0, belt_modulus=1e7)
lag = load_lagging("diamond-rubber")
ready = time.perf_counter()
solve_batch(table, lag, capacities=False)
print(time.perf_counter() - begin, end=" ")
solve_batch(table, lag, setting=Setting.PRECISE, capacities=False)
print(time.perf_counter() - begin)
"""


def starts() -> None:
    print(
        "\na process from its first line to its first batch (wall; engineering, then precise too)"
    )
    with tempfile.TemporaryDirectory() as folder:
        for name in ("first of all, compiling", "later, from disk", "later, from disk"):
            run = subprocess.run(
                [sys.executable, "-c", START],
                capture_output=True,
                text=True,
                check=True,
                env={**os.environ, "WRAPARC_CACHE_DIR": folder},
            )
            lanes, both = map(float, run.stdout.split())
            print(f"  {name}: {lanes:.2f} s, {both:.2f} s")


def scaling() -> None:
    print("\ncost and memory with the number of designs (chunks of 100,000, one after another)")
    for n in (1_000, 10_000, 100_000, 1_000_000, 10_000_000):
        size, cpu, wall = min(n, 100_000), 0.0, 0.0
        for k in range(n // size):
            arcs = arcs_of_table(designs(size, k), RUBBER)
            c, w = time.process_time(), time.perf_counter()
            solve_arcs(arcs, capacities=False)
            cpu, wall = cpu + time.process_time() - c, wall + time.perf_counter() - w
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(f"  {n:>10,}: {1e6 * cpu / n:.2f} us CPU, {1e6 * wall / n:.2f} us each,"
              f" peak memory {peak:.0f} MB")  # fmt: skip


def machine() -> float:
    """Processor time of a plain loop, to know the machine by [s]."""
    start, total = time.process_time(), 0.0
    for i in range(3_000_000):
        total += i * 0.5
    return time.process_time() - start


def cost_of(arcs: Arcs, setting: Setting, capacities: bool, repeats: int) -> float:
    """Least processor time of one thread [us a design]."""
    few = arcs.rows(slice(0, 300))
    solve_arcs(few, setting=setting, capacities=capacities, threads=1)  # compiled
    return least(
        lambda: solve_arcs(arcs, setting=setting, capacities=capacities, threads=1),
        len(arcs),
        repeats,
    )


def least(run: Callable[[], object], count: int, repeats: int) -> float:
    times = []
    for _ in range(repeats):
        start = time.process_time()
        run()
        times.append(time.process_time() - start)
    return 1e6 * min(times) / count


def driving(n: int, name: str = "diamond-rubber", law: FrictionLaw | None = None) -> Arcs:
    """Random driving designs under a shipped lagging, or under another law."""
    lagging = load_lagging(name)
    return arcs_of_table(designs(n), lagging if law is None else replace(lagging, law=law))


def braking(n: int) -> Arcs:
    """The same that brake."""
    table = designs(n)
    table["entry_tension"], table["exit_tension"] = table["exit_tension"], table["entry_tension"]
    return arcs_of_table(table, RUBBER)


def idling(n: int) -> Arcs:
    """The same with nearly the same tension on both sides."""
    table = designs(n)
    table["exit_tension"] = table["entry_tension"] * (1.0 - 1e-6)
    return arcs_of_table(table, RUBBER)


def settings() -> Iterator[Row]:
    """Rows of the table: what, figure, aim."""
    plain, precise = Setting.ENGINEERING, Setting.PRECISE
    cases: list[tuple[str, Arcs, Setting, bool, str, int]] = [
        ("engineering, operating point, diamond rubber", driving(50_000), plain, False, "0.8", 5),
        ("engineering, operating point, full ceramic", driving(20_000, "full-ceramic"), plain,
         False, "", 3),
        ("engineering, all capacities, diamond rubber", driving(20_000), plain, True, "6", 3),
        ("engineering, all capacities, medium ceramic", driving(8_192, "medium-ceramic"), plain,
         True, "6", 2),
        ("engineering, all capacities, full ceramic", driving(8_192, "full-ceramic"), plain, True,
         "6", 2),
        ("precise, operating point", driving(4_000), precise, False, "10", 3),
        ("precise, all capacities", driving(1_000), precise, True, "60", 2),
        ("precise, all capacities, full ceramic", driving(600, "full-ceramic"), precise, True, "60",
         1),
        ("engineering, operating point, braking", braking(6_000), plain, False, "", 2),
        ("engineering, operating point, idling", idling(6_000), plain, False, "", 2),
        ("engineering, operating point, measured table", driving(6_000, law=TABLE), plain, False,
         "", 2),
        ("engineering, operating point, constant friction",
         driving(600, law=Constant(friction_coefficient=0.5)), plain, False, "", 2),
    ]  # fmt: skip
    for name, some, setting, capacities, aim, repeats in cases:
        yield name, f"{cost_of(some, setting, capacities, repeats):.1f} us", aim and f"{aim} us"
    run = [sys.executable, str(Path(__file__).with_name("study.py")), "row"]
    row = subprocess.run(run, capture_output=True, text=True, check=True).stdout
    yield "a row of a study, all results, solving alone", f"{float(row):.1f} us", "4 us"


def first_calls() -> Iterator[Row]:
    """First calls of a process, from its first line, with nothing compiled on the disk."""
    cases = (
        ("engineering, operating point", 1000, 0, False, "ENGINEERING", "3 s"),
        ("engineering, three of the rows brake", 1000, 3, False, "ENGINEERING", "3 s"),
        ("engineering, all capacities", 1000, 0, True, "ENGINEERING", ""),
        ("precise, ten rows, all capacities", 10, 0, True, "PRECISE", ""),
        ("precise, 1,000 rows, all capacities", 1000, 0, True, "PRECISE", ""),
    )
    for name, count, brake, capacities, setting, aim in cases:
        code = FIRST.format(rows=count, braking=brake, capacities=capacities, setting=setting)
        told = []
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "WRAPARC_CACHE_DIR": folder}
            for _ in range(2):
                run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                                     check=True, env=environment)  # fmt: skip
                told.append(f"{float(run.stdout):.1f} s")
        yield f"first call: {name}; the next process", "; ".join(told), aim


def figures() -> None:
    """Print the table of benchmarks/results/batch.md."""
    print("| what | processor time | aim |\n|---|---|---|")
    loops = [machine()]
    for some in (settings(), first_calls()):
        for told in some:
            print(f"| {' | '.join(told)} |", flush=True)
            loops.append(machine())
    print(f"\nA plain loop of 3 million steps took {min(loops):.2f} s to {max(loops):.2f} s of"
          f" processor time meanwhile, {np.median(loops):.2f} s in the middle.")  # fmt: skip


def main() -> None:
    if sys.argv[1:] == ["figures"]:
        figures()
        return
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    arcs = arcs_of_table(designs(n), RUBBER)
    for setting in Setting:
        solve_arcs(arcs.rows(slice(0, 40)), setting=setting)  # compile, or load what is compiled
    scaling()
    scipy = against_scipy(arcs)
    speed(arcs, scipy)
    steps(arcs.rows(slice(0, 10_000)))
    accuracy(10_000)
    starts()
    figures()
    print(f"\nload of the machine while this ran: {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
