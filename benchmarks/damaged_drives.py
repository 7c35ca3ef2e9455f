"""Damaged drives that still read: python benchmarks/damaged_drives.py [drives] [seed].

What reads (tests/arc/damaged.py) must end solved with finite numbers, in breakaway or refused with
its reason, within 2 s of processor time an arc. Each has a seed of its own:
``python benchmarks/damaged_drives.py --drive 1234``.
"""

from __future__ import annotations

import signal
import sys
import time
import traceback
import warnings
from collections import Counter
from pathlib import Path

import numpy as np

from wraparc.arc import Distributed, WrapArc
from wraparc.errors import InputError
from wraparc.files import drive_from_document

sys.path[0] = str(Path(__file__).parents[1] / "tests")  # its `arc`, not the benchmark of it
LONGEST = 2.0  # s CPU an arc


def ends_of(seed: int) -> list[tuple[str, float]]:
    """How each arc of a damaged drive ends, and its CPU time [s]."""
    from arc.damaged import damaged, judged

    ends = []
    start = time.process_time()
    signal.setitimer(signal.ITIMER_PROF, 20.0)
    try:
        drive = drive_from_document(damaged(seed))
        for case in drive.load_cases:
            for pulley in drive.pulleys:
                start = time.process_time()
                signal.setitimer(signal.ITIMER_PROF, 20.0)
                said = judged(Distributed().solve(WrapArc.of(drive, pulley, case)))
                ends.append((said, time.process_time() - start))
    except InputError as error:
        said = "refused" if all(p.message for p in error.problems) else "FAILED: no reason"
        ends.append((said, time.process_time() - start))
    except Exception:  # noqa: BLE001 - that is what is counted
        last = traceback.format_exc().splitlines()
        where = next((line.strip() for line in last[::-1] if "wraparc/" in line), "")
        said = f"FAILED: {last[-1]} at {where.partition('wraparc/')[2]}"
        ends.append((said, time.process_time() - start))
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    return ends


def main() -> None:
    def too_long(*_: object) -> None:
        raise TimeoutError("more than 20 s")

    signal.signal(signal.SIGPROF, too_long)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    warnings.simplefilter("error")
    if sys.argv[1:2] == ["--drive"]:
        print(ends_of(int(sys.argv[2])))
        return
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 5000
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    ends: Counter[str] = Counter()
    times: list[tuple[float, int]] = []
    done = 0
    try:
        for seed in range(first, first + count):
            for said, cpu in ends_of(seed):
                ends[said] += 1
                times.append((cpu, seed))
                if said.startswith("FAILED") or cpu > LONGEST:
                    print(f"seed {seed}: {said}, {cpu:.2f} s", file=sys.stderr, flush=True)
            done += 1
    except KeyboardInterrupt:
        pass  # ended before, it tells what it has
    print(f"| {done} damaged drives, {len(times)} arcs | |\n|---|---|")
    for said, often in ends.most_common():
        print(f"| {said} | {often} |")
    slow = sum(cpu > LONGEST for cpu, _ in times)
    middle = float(np.median([cpu for cpu, _ in times]))
    print(f"| over {LONGEST:g} s | {slow} |")
    print(f"| CPU time of an arc, median and largest [s] | {middle:.3f}, {max(times)[0]:.2f} |")
    print(f"| seed of the slowest | {max(times)[1]} |")


if __name__ == "__main__":
    main()
