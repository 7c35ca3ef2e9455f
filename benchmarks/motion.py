"""Drives in time: python benchmarks/motion.py.

A start and stop of 60 s of the fabric tandem with 100 pieces of lagging a wrap (some 2,000 steps),
from the first line of a process and again, and a map of stability of 41 x 41; processor time. Aims
on a free core: 2 s for the event as a fresh process, 10 s for the map.
"""

from __future__ import annotations

import time

from wraparc import load_motion, simulate
from wraparc.motion import stability_map


def main() -> None:
    motion = load_motion("examples/tandem-fabric.toml")
    for since in (0.0, None):  # from the start of the process, or of the run
        start = time.process_time() if since is None else since
        run = simulate(motion.station, motion.event("start and stop"))
        taken = time.process_time() - start
        what = "again" if since is None else "and what is imported"
        print(f"{run.steps} steps of a start and stop, {what:20s} {taken:6.2f} s")
    start = time.process_time()
    stability_map(motion.station)
    taken = time.process_time() - start
    print(f"map of stability, 41 x 41 {taken:31.2f} s")


if __name__ == "__main__":
    main()
