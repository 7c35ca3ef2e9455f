"""Random drives over all that the readers accept: python benchmarks/wide_net.py [drives] [seed].

How each ended, and every solution held against the equations by tests/arc/wide.py. Prints those
that miss by more than is allowed, or end otherwise than solved, in breakaway or refused.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np

from wraparc.errors import InputError

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it


def main() -> None:
    from arc.wide import NAMES, verdict, wide_arc

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 5000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    ends: Counter[str] = Counter()
    slowest = 0.0
    for k in range(count):
        name = NAMES[k % len(NAMES)]
        start, miss = time.process_time(), 0.0
        try:
            end, miss = verdict(wide_arc(name, np.random.default_rng([seed, k])))
        except InputError:
            end = "refused"
        except (ArithmeticError, ValueError) as error:
            end = type(error).__name__
        slowest = max(slowest, time.process_time() - start)
        ends[end] += 1
        if end not in ("solved", "breakaway", "refused") or not miss <= 1.0:
            print(f"{name}, seed [{seed}, {k}]: {end}, {miss:.3g} times too far", flush=True)
    print(f"{count} drives: {dict(ends)}, slowest {slowest:.1f} s CPU with its check")


if __name__ == "__main__":
    main()
