"""Reserves of random drives followed from both sides: benchmarks/reserve.py [numbers] [first].

Draws drives and trains of so many numbers (tests/doors/draw.py; some are no drive), and at 0.97 and
1.03 of every change that a reserve states solves and judges the drive that is changed so, built in
tests/reserve/follow.py. Prints what does not hold, why a reserve is not calculated, and what they
take. The gate runs the same with few (tests/reserve/test_find.py).
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it


def main() -> None:
    from reserve.follow import faults, random_results
    from wraparc.checks import judge
    from wraparc.reserve import find_reserve

    count, first = (int(text) for text in (*sys.argv[1:], *("300", "1")[len(sys.argv) - 1 :]))
    wrong, flips, times = 0, 0, list[float]()
    kinds = Counter[str]()
    for number, result in random_results(count, first=first):
        if number >= first + count:
            break
        judge(result)
        begin = time.process_time()
        reserve = find_reserve(result)
        times.append(time.process_time() - begin)
        kinds[reserve.reason or f"{reserve.level}, {'some' if reserve.flips else 'none'}"] += 1
        flips += len(reserve.flips)
        for text in faults(result, reserve, reserve.flips):
            wrong += 1
            print(f"drive {number}: {text}", flush=True)
    times.sort()
    for kind, number in kinds.most_common():
        print(f"{number:5} {kind}")
    print(f"{flips} changes followed, {wrong} sides do not hold")
    print(f"a reserve takes {times[len(times) // 2]:.3f} s, {times[-1]:.2f} s at most (processor)")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
