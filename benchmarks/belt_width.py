"""Time and reach of the solver across the width: python benchmarks/belt_width.py [random drives].

32 strips, going slack at a crown, the 16 modes of the screening, and random drives with how they
end. Times are processor time, best of seven, and as a ratio to NumPy's inverses of 32 matrices of
73 rows in the same run, which holds across machines; beside it what the march that was compiled
took on the day it left. With `twin` in place of a number: how far the twin
by finite volumes of the tests is away, which may be 2e-2, 7e-3, 3e-3 of the deviation of the entry
tension and 3e-2, 1e-2, 6e-3 of that of the exit tension at 8, 16, 32 strips; it was

    steel cord, 8 strips: entry 3.5e-03, exit 2.1e-02
    steel cord, 16 strips: entry 6.9e-04, exit 6.3e-03
    steel cord, 32 strips: entry 1.1e-04, exit 3.4e-03
    fabric braking, 8 strips: entry 1.3e-03, exit 1.9e-02
    fabric braking, 16 strips: entry 2.3e-04, exit 5.3e-03
    fabric braking, 32 strips: entry 7.2e-05, exit 2.8e-03
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from across.randoms import random_wide
from across.test_across_twin import misses
from across.wides import CORD, FABRIC, RUBBER, SOFTENING, braking, crown, wide
from wraparc.across import AcrossSolver, AcrossStatus, mode_response
from wraparc.friction import Constant

LAWS = (RUBBER, SOFTENING, Constant(friction_coefficient=0.45))


def best(work: Callable[[], object]) -> float:
    """Processor time of a piece of work [s]."""
    times = []
    for _ in range(7):
        begun = time.process_time()
        work()
        times.append(time.process_time() - begun)
    return min(times)


def times() -> None:
    """Print the times of a solve, of one that goes slack, and of the modes."""
    table = np.eye(73) + 0.1 * np.random.default_rng(0).standard_normal((32, 73, 73))
    unit = best(lambda: np.linalg.inv(table))

    def told(name: str, work: Callable[[], object], target: float) -> None:
        took = best(work)
        print(f"{name}: {1e3 * took:.1f} ms, {took / unit:.1f} units; target {target:g}")

    for name, arc, stiffness, target in (
        ("fabric", FABRIC, 1e5, 12.0),
        ("steel cord", CORD, 4e4, 11.0),
    ):
        given = wide(arc, 32, stiffness, radius_deviation=crown(1e-3, 32))
        high = wide(arc, 32, stiffness, radius_deviation=crown(16e-3, 32))
        told(f"{name}, 32 strips", lambda given=given: AcrossSolver().solve(given), target)  # type: ignore[misc]
        told(f"{name}, slack", lambda given=high: AcrossSolver().solve(given), 390.0)  # type: ignore[misc]
        told(f"{name}, 16 modes", lambda given=given: mode_response(given, 16), 6.5)  # type: ignore[misc]


def main(drives: int) -> None:
    times()
    rng = np.random.default_rng(1)
    ends: Counter[str] = Counter()
    steps = []
    for k in range(drives):
        found = AcrossSolver().solve(random_wide(LAWS[k % 3], rng, strips=8))
        ends[found.status.name.lower()] += 1
        if found.status is AcrossStatus.SOLVED:
            steps.append(found.iterations)
    if drives:
        print(f"{drives} random drives: {dict(ends)}, median {median(steps):g} Newton steps")


def twins() -> None:
    """Print how far the twin is away, as a share of the deviation."""
    for name, arc, stiffness in (
        ("steel cord", CORD, 4e4),
        ("fabric braking", braking(FABRIC), 1e5),
    ):
        for strips in (8, 16, 32):
            entry, leaving = misses(arc, stiffness, strips)
            print(f"{name}, {strips} strips: entry {entry:.1e}, exit {leaving:.1e}", flush=True)


if __name__ == "__main__":
    if sys.argv[1:] == ["twin"]:
        twins()
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 0)
