"""Speed of trains, in ratios to one solve of one arc in the same run.

    python benchmarks/train.py          CPU time of this process, plain Python, best of a few
    python benchmarks/train.py batch    trains a second in batches, on all processors

Goals: all load cases of a two-drive file in under 50 ms of solving, a 101 x 101 map in under 2 s;
20,000 trains a second on two processors, wear of one drum, belt and friction drawn at random.
"""

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from wraparc.arc import Distributed
from wraparc.batch import Setting
from wraparc.train import (
    Axis,
    Motors,
    Speeds,
    Train,
    match_drives,
    share_curve,
    share_map,
    solve_train,
    solve_train_batch,
)
from wraparc.train.file import load_train
from wraparc.train.locate import locate
from wraparc.train.solve import Setup, arc_of

EXAMPLES = Path(__file__).parents[1] / "examples"
QUICK = Distributed(capacities=False)


def best(work: Callable[[], object], rounds: int) -> float:
    """Least CPU time of a few rounds [ms]."""
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


def at_held_speeds(train: Train) -> Train:
    """The train with the speeds of its first load case in all load cases."""
    first = solve_train(train, method=QUICK).cases[0]
    trims = zip((m.speed_trim for m in first), train.nominal, strict=True)
    speeds = Speeds(tuple(t / d for t, d in trims))
    return replace(train, cases=tuple(replace(c, division=speeds) for c in train.cases))


def tensions_only(train: Train) -> None:
    """Speeds to tensions of all load cases, without the profiles of the arcs."""
    softening = any(p.lagging.law.steepest_fall() < 0.0 for p in train.pulleys)
    for case in train.cases:
        locate(Setup.of(train, case).system, [p.name for p in train.pulleys], softening)


def machine() -> float:
    """CPU time of a plain loop, to know the machine by [s]."""
    start, total = time.process_time(), 0.0
    for i in range(3_000_000):
        total += i * 0.5
    return time.process_time() - start


def batches(n: int = 40_000) -> None:
    """Print trains a second, by CPU time of one processor and by the clock."""
    print(f"a plain loop of 3 million: {machine():.2f} s (0.25 where nothing else runs)")
    rng = np.random.default_rng(1)
    print(f"{'':44s}{'trains':>8s}{'CPU us':>9s}{'a second':>10s}  solved")
    for name in ("tandem-fabric", "tandem-steel-cord", "triple-steel-cord"):
        train = load_train(EXAMPLES / f"{name}.toml")
        first, second = (p.name for p in train.pulleys[:2])
        worn = {
            f"{second}.wear": rng.uniform(0.0, 5e-4, n),
            f"{first}.friction_factor": rng.uniform(0.85, 1.1, n),
            "belt_modulus": train.belt.modulus * rng.uniform(0.9, 1.1, n),
        }
        shares = {f"{first}.share": rng.uniform(0.35, 0.5, n)}
        kinds = [("wear, friction, belt", worn, n), ("shares", shares, n)]
        if not isinstance(train.cases[0].division, Motors):
            here = solve_train(train, method=QUICK).cases[0][second].speed_trim
            trims = {f"{second}.speed_trim": here * rng.uniform(0.9995, 1.0005, n)}
            brakes = {f"{second}.speed_trim": here * rng.uniform(1.005, 1.006, n // 10)}
            kinds += [("trim", trims, n), ("trim, one drum brakes", brakes, n // 10)]
        for kind, columns, count in [*kinds, ("wear ..., precise", worn, n // 40)]:
            some = {key: column[:count] for key, column in columns.items()}
            setting = Setting.PRECISE if "precise" in kind else Setting.ENGINEERING
            clock, used = time.perf_counter(), time.process_time()
            found = solve_train_batch(train, some, setting=setting, capacities=False)
            clock, used = time.perf_counter() - clock, time.process_time() - used
            told = f"{count:8d}{1e6 * used / count:9.1f}{count / clock:10.0f}"
            print(f"{name + ', ' + kind:44s}{told}  {np.mean(found.solved):.1%}", flush=True)


def main() -> None:
    tandem = load_train(EXAMPLES / "tandem-fabric.toml")
    held = at_held_speeds(tandem)
    triple = load_train(EXAMPLES / "triple-steel-cord.toml")
    case = tandem.cases[0]
    arc = arc_of(tandem, case, tandem.pulleys[0], (150e3, 97.5e3))
    solved = solve_train(tandem, method=QUICK)
    here = solved.cases[0]["second"].speed_trim
    x, y = here + np.linspace(-6e-3, 6e-3, 101), np.linspace(0.1, 1.25, 101)
    wide = np.linspace(0.995, 1.005, 101)
    rows: list[tuple[str, Callable[[], object], int]] = [
        ("one arc, no capacities", lambda: QUICK.solve(arc), 7),
        ("tandem, 2 cases, shares to speeds", lambda: solve_train(tandem, method=QUICK), 5),
        ("tandem, 2 cases, speeds to tensions", lambda: tensions_only(held), 5),
        ("tandem, 2 cases, speeds, arcs and all", lambda: solve_train(held, method=QUICK), 5),
        ("tandem, 2 cases, with capacities", lambda: solve_train(held), 3),
        ("triple, 3 cases, motors", lambda: solve_train(triple, method=QUICK), 2),
        ("curve of 41 trims", lambda: share_curve(solved, points=41), 2),
        ("all that trim tells, 41 points", lambda: match_drives(solved, points=41), 1),
        ("map 101 x 101, trim and load", lambda: share_map(solved, x=x, y=y), 2),
        (
            "map 101 x 101, trim and diameter",
            lambda: share_map(solved, x=x, y=wide, down=Axis.DIAMETER),
            1,
        ),
    ]
    unit = 0.0
    for name, work, rounds in rows:
        took = best(work, rounds)
        unit = unit or took
        print(f"{name:40s} {took:9.1f} ms  {took / unit:8.1f} arcs")


if __name__ == "__main__":
    batches() if sys.argv[1:] == ["batch"] else main()
