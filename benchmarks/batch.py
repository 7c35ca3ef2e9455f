"""Many arcs at once: python benchmarks/batch.py [designs]

Processor time of a row beside its target [us], and the largest miss of a finer solution; all in one
process on one thread. Then what a fresh command waits for: the first batch of a process, with its
imports, beside the second [s]; and the general way, SciPy's `solve_ivp` in `brentq`.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from wraparc.batch import Setting, row, solve_arcs
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.batch.rows import solve_rows
from wraparc.batch.solve import CHUNK
from wraparc.drive import Lagging
from wraparc.files import load_lagging

sys.path[0] = str(Path(__file__).parents[1] / "tests")

#: name; law; side; what is asked; accuracy; target [us]
CASES = (
    ("rubber, operating point", "diamond-rubber", "driving", row.TENSIONS, 1e-4, 8),
    ("ceramic, operating point", "full-ceramic", "driving", row.TENSIONS, 1e-4, 15),
    ("ceramic past its peak", "full-ceramic", "past", row.TENSIONS, 1e-4, 40),
    ("rubber, braking", "diamond-rubber", "braking", row.TENSIONS, 1e-4, 15),
    ("rubber, idling", "diamond-rubber", "idling", row.TENSIONS, 1e-4, 15),
    ("rubber, all capacities", "diamond-rubber", "driving", row.EVERYTHING, 1e-4, 60),
    ("ceramic, all capacities", "full-ceramic", "driving", row.EVERYTHING, 1e-4, 150),
    ("rubber braking, all capacities", "diamond-rubber", "braking", row.EVERYTHING, 1e-4, 150),
    ("rubber at 1e-6", "diamond-rubber", "driving", row.TENSIONS, 1e-6, 120),
    ("rubber at 1e-6, all capacities", "diamond-rubber", "driving", row.EVERYTHING, 1e-6, 250),
)
FIRST = """
import time
start = time.process_time()
import numpy as np
from wraparc import load_lagging, solve_batch
table = dict(entry_tension=np.linspace(1e5, 2e5, 1000), exit_tension=7e4, diameter=0.8,
             wrap_angle=3.3, belt_width=1.2, belt_modulus=12e6)
lag = load_lagging("diamond-rubber")
for _ in range(2):
    solve_batch(table, lag, threads=1)
    print(time.process_time() - start)
    start = time.process_time()
"""


def designs(n: int, side: str, lag: Lagging) -> Arcs:
    """Random drives with fabric and steel-cord belts."""
    rng = np.random.default_rng(1)
    tight, ratio = rng.uniform(60e3, 250e3, n), rng.uniform(1.2, 3.0, n)
    if side == "idling":
        ratio = 1.0 + np.exp(rng.uniform(np.log(1e-4), np.log(2e-2), n))
    table: dict[str, Any] = {
        "entry_tension": tight,
        "exit_tension": tight / ratio,
        "diameter": rng.uniform(0.5, 1.4, n),
        "wrap_angle": rng.uniform(2.8, 3.8, n),
        "belt_width": rng.uniform(0.8, 1.8, n),
        "belt_modulus": np.exp(rng.uniform(np.log(5e6), np.log(1.5e8), n)),
        "lagging_thickness": rng.uniform(8e-3, 18e-3, n),
    }
    if side == "braking":
        table["entry_tension"], table["exit_tension"] = table["exit_tension"], tight
    if side == "past":
        table["exit_tension"], table["belt_modulus"] = tight / rng.uniform(4.0, 9.0, n), 3e6
    return arcs_of_table(table, lag)


def rows(n: int) -> None:
    print(
        "| | us a row | target | left to the scalar solver | miss of creep, of the largest slip |"
    )
    print("|---|---|---|---|---|")
    for name, law, side, parts, accuracy, target in CASES:
        arcs = designs(n, side, load_lagging(law))
        best = np.inf
        for _ in range(2):
            start = time.process_time()
            found, left = [], []
            for begin in range(0, n, CHUNK):
                some, late = solve_rows(arcs.rows(slice(begin, begin + CHUNK)), parts, accuracy)
                found.append(some)
                left.append(late)
            best = min(best, time.process_time() - start)
        few = arcs.rows(slice(0, 500))
        fine = solve_rows(few, row.TENSIONS, 1e-7)[0]
        miss = np.abs(np.concatenate(found)[:500, row.EXIT_CREEP] - fine[:, row.EXIT_CREEP])
        miss /= fine[:, row.LARGEST_SLIP]  # creep of an idle pulley passes through none
        share = np.mean(np.concatenate(left))
        print(f"| {name} | {1e6 * best / n:.1f} | {target} | {share:.2%} | {np.nanmax(miss):.1e} |")


def threads(n: int) -> None:
    arcs = designs(n, "driving", load_lagging("diamond-rubber"))
    for count in (1, 2):
        start = time.perf_counter()
        solve_arcs(arcs, capacities=False, threads=count, setting=Setting.ENGINEERING)
        print(f"{n:,} operating points, {count} threads: {time.perf_counter() - start:.2f} s")


def general(n: int = 20) -> None:
    from arc.twin import Twin

    arcs = designs(n, "driving", load_lagging("diamond-rubber"))
    found = solve_arcs(arcs, capacities=False)["entry_creep_ratio"]
    start = time.process_time()
    for i in range(n):
        Twin(arcs.arc(i, [load_lagging("diamond-rubber").law])).solve_near(float(found[i]))
    print(f"SciPy, near the answer: {1e3 * (time.process_time() - start) / n:.1f} ms a row")


def main() -> None:
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 20_000
    rows(n)
    threads(5 * n)
    ran = subprocess.run([sys.executable, "-c", FIRST], capture_output=True, text=True, check=True)
    first, second = map(float, ran.stdout.split())
    print(f"first batch of 1,000 in a process, imports included: {first:.2f} s (target 0.5)")
    print(f"the second: {second:.2f} s")
    general()


if __name__ == "__main__":
    main()
