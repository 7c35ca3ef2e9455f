"""Drives in time: python benchmarks/motion.py.

A start and stop of 60 s of the fabric tandem with 100 pieces of lagging a wrap (some 12,000
steps), after the code is compiled or loaded, and a map of stability of 41 x 41; processor time.
Aims on a free core: 3 s for the event, 10 s for the map, 8 s to compile. Measured on a slow hour of
2 shared cores (where a loop of 3 million additions takes 0.6 s): 2.5 to 2.9 s (1.2 sweeps of an arc
a step), 0.5 s, and 8.4 to 10.1 s to compile: the event and the map are met, the last is not shown.
"""

from __future__ import annotations

import time

from wraparc import load_motion, simulate
from wraparc.motion import Event, stability_map


def main() -> None:
    motion = load_motion("examples/tandem-fabric.toml")
    start = time.process_time()
    simulate(motion.station, Event(duration=0.05))
    print(f"compiling or loading, and a first short run {time.process_time() - start:6.2f} s")
    start = time.process_time()
    run = simulate(motion.station, motion.event("start and stop"), every=0.05)
    taken = time.process_time() - start
    each = 1e6 * taken / run.steps
    print(f"{run.steps} steps of a start and stop           {taken:6.2f} s, {each:.0f} us a step")
    start = time.process_time()
    stability_map(motion.station)
    print(f"map of stability, 41 x 41                   {time.process_time() - start:6.2f} s")


if __name__ == "__main__":
    main()
