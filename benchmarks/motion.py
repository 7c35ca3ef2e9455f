"""Drives in time: python benchmarks/motion.py.

A start and stop of 60 s of the fabric tandem with 100 pieces of lagging a wrap (some 12,000
steps), after the code is compiled or loaded, and a map of stability of 41 x 41; processor time.
Aims on a free core: 3 s for the event, 10 s for the map, 8 s to compile. Measured on 2 cores shared
with two to nine other loads: 3.3 to 5 s (277 to 400 us a step, 1.06 sweeps of an arc), 0.3 to 1.0
s, and 9.6 to 11 s to compile: the map is met, the others not shown there.
Before a step was guessed from the
two before it and a map changed one row of the equations: 11.4 s, 13.5 s and 12 s.
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
