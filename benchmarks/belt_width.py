"""Time and reach of the solver across the width: python benchmarks/belt_width.py [random drives].

32 strips, the 16 modes of the screening, and random drives with how they end. Times are processor
time, best of three; they drift with the machine.
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
from across.wides import CORD, FABRIC, RUBBER, SOFTENING, crown, wide
from wraparc.across import AcrossSolver, AcrossStatus, mode_response, prepare
from wraparc.friction import Constant

LAWS = (RUBBER, SOFTENING, Constant(friction_coefficient=0.45))


def best(work: Callable[[], object]) -> float:
    """Processor time of a piece of work [s]."""
    times = []
    for _ in range(3):
        begun = time.process_time()
        work()
        times.append(time.process_time() - begun)
    return min(times)


def times(how: str) -> None:
    """Print the times of a solve and of the modes."""
    for name, arc, stiffness in (("fabric", FABRIC, 1e5), ("steel cord", CORD, 4e4)):
        given = wide(arc, 32, stiffness, radius_deviation=crown(1e-3, 32))
        whole = best(lambda given=given: AcrossSolver().solve(given))  # type: ignore[misc]
        modes = best(lambda given=given: mode_response(given, 16))  # type: ignore[misc]
        print(f"{name}, {how}: 32 strips {whole:.3f} s, 16 modes {1e3 * modes:.0f} ms")


def main(drives: int) -> None:
    times("arrays")
    if prepare():
        AcrossSolver().solve(wide(FABRIC, 8))
        times("compiled")
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


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 0)
