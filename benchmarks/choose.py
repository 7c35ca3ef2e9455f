"""A search over 100,000 designs: time, and its ranking against brute force.

Run: python benchmarks/choose.py

The case is the shipped decision of examples/wet-season, with more candidates: every arc of it by
the batch kernel. Brute force solves a sample of the designs one by one with `wraparc.arc`, and the
first hundred of the ranking again at the precision of one arc.
"""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import Distributed
from wraparc.choose.file import load_search
from wraparc.choose.search import Grid, Search
from wraparc.choose.selection import choose

EXAMPLE = Path(__file__).parents[1] / "examples" / "wet-season" / "choose.toml"


def main() -> None:
    search = load_search(EXAMPLE)
    search = replace(
        search,
        thicknesses=(10e-3, 12e-3, 15e-3),
        diameters=tuple(np.linspace(0.63, 1.25, 14)),
        wrap_angles=tuple(np.radians(np.linspace(170, 220, 16))),
        slack_tensions=tuple(np.linspace(35e3, 85e3, 50)),
    )
    one = replace(
        search,
        conditions=search.conditions[:1],
        drive=replace(search.drive, load_cases=search.drive.load_cases[:1]),
    )
    for name, s in (("one load case, dry", one), ("as shipped", search)):
        arcs = len(s) * len(s.conditions) * len(s.drive.load_cases)
        wall, cpu = time.perf_counter(), time.process_time()
        found = choose(s)
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        print(f"{name}: {len(s)} designs, {arcs} arcs: {wall:.2f} s, CPU {cpu:.2f} s,"
              f" {len(found.ranking)} feasible")  # fmt: skip
        worst = brute_force(s, found.creep)
        print(f"  creep of 200 designs, solved one by one: within {worst:.1e}")


def brute_force(search: Search, creep: NDArray[np.float64]) -> float:
    """Largest relative miss of the worst creep of some designs."""
    grid = Grid.of(search)
    laws = [lagging.law for lagging in search.conditioned()]
    rng = np.random.default_rng(1)
    solver = Distributed(capacities=False)
    worst = 0.0
    for i in rng.integers(0, len(grid), 200):
        results = [
            solver.solve(grid.arcs(case, k).arc(int(i), laws))
            for k in range(len(search.conditions))
            for case in search.drive.load_cases
        ]
        if not all(r.status.solved for r in results):
            assert not np.isfinite(creep[i]) or creep[i] > 0
            continue
        truth = max(abs(r.exit_creep) for r in results)
        worst = max(worst, abs(creep[i] / truth - 1.0))
    return worst


if __name__ == "__main__":
    main()
