"""The kernel of the page beside that of Python: python benchmarks/page_kernel.py [drives] [seed].

Random drives of every law, driving, braking and idling, solved by both, their profiles beside each
other; of every tenth the capacities too. Prints the largest misses by quantity and the times; ends
with 1 where one is beyond 1e-12.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it

ALLOWED = 1e-12


def main() -> int:
    """Solve, compare and print."""
    from web.kernel_cases import ALL_LAWS, apart, arcs, case_of, in_node, in_python

    count, seed = (int(a) for a in [*sys.argv[1:], "2000", "1"][:2])
    drives = [arc for _, arc in arcs(count // len(ALL_LAWS), seed)]
    asked = [k % 10 == 0 for k in range(len(drives))]
    start = time.perf_counter()
    there = in_node([case_of(arc, c) for arc, c in zip(drives, asked, strict=True)])
    page, start = time.perf_counter() - start, time.process_time()
    worst: dict[str, float] = {}
    for arc, capacities, found in zip(drives, asked, there, strict=True):
        for what, miss in apart(in_python(arc, capacities), found).items():
            worst[what] = max(worst.get(what, 0.0), miss)
    ends = Counter(found["outcome"] for found in there)
    print(f"{len(drives)} drives of {len(ALL_LAWS)} laws: {ends[0]} solved, {ends[1]} break away,")
    print(f"{len(drives) - ends[0] - ends[1]} unsolved; every tenth with its capacities")
    print(f"page {page:.1f} s, Python {time.process_time() - start:.1f} s\n")
    print("| quantity | largest miss |\n|---|---|")
    for what, miss in sorted(worst.items()):
        print(f"| {what} | {miss:.1e} |")
    return 0 if max(worst.values()) <= ALLOWED else 1


if __name__ == "__main__":
    sys.exit(main())
