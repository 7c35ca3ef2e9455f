"""A record of a million samples: read, cut into revolutions, laid beside the prediction.

Run it with ``python benchmarks/pulley_record.py [SAMPLES]``. Times are of the processor. The ratio
to NumPy reading the same numbers, which nothing here can avoid, holds across machines.

Goal: a million samples in under 2 s.
"""

import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from wraparc.arc import Distributed, PaperMarch, WrapArc
from wraparc.calibrate.fold import fold
from wraparc.calibrate.record import read_record
from wraparc.calibrate.virtual_pulley import record_text, virtual_record
from wraparc.files import load_drive

DRIVE = Path(__file__).parents[1] / "examples" / "head-drive-fabric.toml"


def timed(what: str, work: Callable[[], object], unit: float = 1.0) -> float:
    """Print and return the processor time of some work [s]."""
    start = time.process_time()
    work()
    taken = time.process_time() - start
    print(f"{what:24} {taken:6.2f} s  {taken / unit:5.2f}")
    return taken


def main(samples: int) -> None:
    drive = load_drive(DRIVE)
    arc = WrapArc.of(drive, drive.pulleys[0], drive.load_cases[0])
    result = Distributed(points=360, capacities=False).solve(arc)
    record = virtual_record(result, samples=samples, revolutions=samples / 3333)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "record.csv"
        path.write_text(record_text(record), "utf-8")

        def overlay() -> None:
            fold(read_record(path), drive, "head", "design")
            Distributed().solve(arc)
            PaperMarch().solve(arc)

        unit = timed("numpy.loadtxt", lambda: np.loadtxt(path, delimiter=",", skiprows=1))
        timed("read, fold, overlay", overlay, unit)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
