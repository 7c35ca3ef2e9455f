"""The kernel of the page beside that of Python: python benchmarks/page_kernel.py [drives] [seed].

Random drives of every law, driving, braking and idling, solved by both, their profiles beside each
other; of every tenth the capacities too. Prints the largest misses by quantity and the times. Where
one is beyond 1e-12, Python is asked again with its exponentials and logarithms moved by their last
digit at random: what that moves, nobody knows better. Ends with 1 where a miss is beyond both.
"""

from __future__ import annotations

import importlib
import math
import pkgutil
import random
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import patch

import wraparc.arc
from wraparc.arc import WrapArc

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it

ALLOWED, LEAST_DIGITS = 1e-12, 3.0  # relative; times what the last digits of exp and log do
_INEXACT = ("exp", "log", "sinh", "cosh", "asinh", "tanh", "expm1", "log1p")
_KERNEL = pkgutil.iter_modules(wraparc.arc.__path__, "wraparc.arc.")
_MODULES = ["wraparc.friction.compact", *(m.name for m in _KERNEL)]


def last_digit_moved(function: Callable[[float], float], rng: random.Random) -> Any:
    """A function whose value is moved by its last digit in two of five calls."""

    def moved(x: float) -> float:
        return math.nextafter(function(x), rng.choice((-math.inf, math.inf)))

    return lambda x: moved(x) if rng.random() < 0.4 else function(x)


def unsure(arc: WrapArc, capacities: bool) -> dict[str, float]:
    """How far the last digits of exp, log ... move the quantities of an answer."""
    from web.kernel_cases import apart, in_python

    here, worst = in_python(arc, capacities), dict[str, float]()
    for seed in range(6):
        rng, patches = random.Random(seed), []  # noqa: S311 - repeatable
        for module in map(importlib.import_module, _MODULES):
            of = [f for f in _INEXACT if hasattr(module, f)]
            moved = {f: last_digit_moved(getattr(math, f), rng) for f in of}
            patches += [patch.object(module, f, own) for f, own in moved.items()]
        for each in patches:
            each.start()
        for what, miss in apart(here, in_python(arc, capacities)).items():
            worst[what] = max(worst.get(what, 0.0), miss)
        patch.stopall()
    return worst


def main() -> int:
    """Solve, compare and print."""
    from web.kernel_cases import ALL_LAWS, apart, arcs, case_of, in_node, in_python

    count, seed = (int(a) for a in [*sys.argv[1:], "2000", "1"][:2])
    drives = list(arcs(count // len(ALL_LAWS), seed))
    asked = [k % 10 == 0 for k in range(len(drives))]
    start = time.perf_counter()
    there = in_node([case_of(arc, c) for (_, arc), c in zip(drives, asked, strict=True)])
    page, start = time.perf_counter() - start, time.process_time()
    worst: dict[str, float] = {}
    beyond = []
    for (name, arc), capacities, found in zip(drives, asked, there, strict=True):
        misses = apart(in_python(arc, capacities), found)
        worst |= {what: max(worst.get(what, 0.0), miss) for what, miss in misses.items()}
        if max(misses.values(), default=0.0) > ALLOWED:
            beyond.append((name, arc, capacities, misses))
    ends = Counter(found["outcome"] for found in there)
    print(f"{len(drives)} drives of {len(ALL_LAWS)} laws: {ends[0]} solved, {ends[1]} break away,")
    print(f"{len(drives) - ends[0] - ends[1]} unsolved; every tenth with its capacities")
    print(f"page {page:.1f} s, Python {time.process_time() - start:.1f} s\n")
    print("| quantity | largest miss |\n|---|---|")
    print(*(f"| {what} | {miss:.1e} |" for what, miss in sorted(worst.items())), sep="\n")
    print("\n| beyond 1e-12 | T1/T2 | quantity | miss | last digits |\n|---|---|---|---|---|")
    return 0 if min([explained(*drive) for drive in beyond], default=True) else 1


def explained(name: str, arc: WrapArc, capacities: bool, misses: dict[str, float]) -> bool:
    """Print what of a drive is beyond 1e-12; whether the last digits explain it."""
    unknown = unsure(arc, capacities)
    for what, miss in misses.items():
        if miss > ALLOWED:
            ratio = arc.entry_tension / arc.exit_tension
            print(f"| {name} | {ratio:.5f} | {what} | {miss:.1e} | {unknown[what]:.1e} |")
    return all(m <= max(ALLOWED, LEAST_DIGITS * unknown[what]) for what, m in misses.items())


if __name__ == "__main__":
    sys.exit(main())
