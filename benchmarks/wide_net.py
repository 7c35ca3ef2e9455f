"""Random drives over all that the readers accept: python benchmarks/wide_net.py [drives] [seed].

How each ended, with its capacities, and every solution and breakaway held against the twin
(tests/arc/shooting.py), with the CPU time of the answer. Each drive has a seed of its own, and its
row goes to build/wide_net_SEED.jsonl: a run that was ended goes on there. With `2500-5000`
for the drives a second process does that half. Prints a table, and the drives that miss by more
than is allowed, end otherwise than solved, in breakaway or refused, or take longer than 2 s.
"""

from __future__ import annotations

import json
import signal
import sys
import time
import warnings
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from wraparc.arc import Distributed
from wraparc.errors import InputError

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it
GOOD, LONGEST = ("solved", "breakaway", "refused"), 2.0
SOLVER = Distributed(points=60)


def row_of(name: str, seed: int, k: int) -> dict[str, Any]:
    """How one drive ends, in s CPU; its largest miss or what it carries; both in allowed units."""
    from arc.shooting import breaks_away, judged
    from arc.wide import wide_arc

    row: dict[str, Any] = {"k": k, "law": name, "miss": 0.0}
    start = time.process_time()
    signal.setitimer(signal.ITIMER_PROF, 30.0)
    try:
        arc = wide_arc(name, np.random.default_rng([seed, k]))
        result = SOLVER.solve(arc)
        row |= {"end": result.status.name.lower(), "cpu": time.process_time() - start}
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        if row["end"] == "solved":
            row["miss"] = judged(arc, result)
        if row["end"] == "breakaway":
            row["miss"] = breaks_away(arc)
    except InputError as error:
        end = "refused" if all(p.message for p in error.problems) else "no reason"
        row |= {"end": end, "cpu": time.process_time() - start}
    except Exception as error:  # noqa: BLE001 - that is what is counted
        row |= {"end": f"{type(error).__name__}: {error}", "cpu": time.process_time() - start}
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    return row


def bad(row: dict[str, Any]) -> bool:
    return row["end"] not in GOOD or not row["miss"] <= 1.0 or row["cpu"] > LONGEST


def table(rows: list[dict[str, Any]]) -> str:
    ends = Counter(row["end"] for row in rows)
    times = np.array([row["cpu"] for row in rows])
    worst = max((row["miss"] for row in rows if row["end"] == "solved"), default=0.0)
    lines = [f"| {len(rows)} drives | |", "|---|---|"]
    lines += [f"| {end} | {often} |" for end, often in ends.most_common()]
    lines += [
        f"| largest miss of a solved drive, of 1e-5 | {worst:.2f} |",
        f"| missed, hung, slow or raised | {sum(map(bad, rows))} |",
        f"| complete answers in plain Python | {len(times)} |",
        f"| their time, median, 99 % and largest [s CPU] "
        f"| {np.median(times):.3f}, {np.quantile(times, 0.99):.2f}, {times.max():.2f} |",
    ]
    return "\n".join(lines)


def main() -> None:
    from arc.wide import NAMES

    drives, seed = (sys.argv[1:] + ["5000", "1"][len(sys.argv) - 1 :])[:2]
    first, _, last = drives.rpartition("-")
    start, end = int(first or 0), int(last)

    def too_long(*_: object) -> None:
        raise TimeoutError("more than 30 s")

    signal.signal(signal.SIGPROF, too_long)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    warnings.simplefilter("error")
    kept = Path(f"build/wide_net_{seed}{'_' + first if first else ''}.jsonl")
    kept.parent.mkdir(exist_ok=True)
    rows = []
    if kept.exists():
        rows = [json.loads(line) for line in kept.read_text("ascii").splitlines()]
    rows = rows[: end - start]
    with kept.open("a", encoding="ascii") as file:
        try:
            for k in range(start + len(rows), end):
                rows.append(row_of(NAMES[k % len(NAMES)], int(seed), k))
                print(json.dumps(rows[-1]), file=file, flush=True)
        except KeyboardInterrupt:
            pass  # ended before, it tells what it has
    print(table(rows))
    for row in filter(bad, rows):
        print(f"\n{row['law']}, seed [{seed}, {row['k']}]: {row}", end="")
    print()


if __name__ == "__main__":
    main()
