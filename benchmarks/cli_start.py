"""Time and memory of the command line, from start to finish.

Run it with ``python benchmarks/cli_start.py [RUNS]``. Every command runs in a fresh process, the
commands in turn, so that what else the machine does falls on all of them alike. Times are wall
clock; the ratio to the import of numpy alone, which nothing here can avoid, holds across machines.

Processor time, user and system, stands beside it, and tells more where other work runs.

Goals: ``wraparc solve`` of one drive, all its checks, in under 0.5 s of processor time and 80 MB.
"""

import compileall
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
DRIVE = ROOT / "examples" / "head-drive-fabric.toml"

_MAIN = "from wraparc.cli import main; main()"
CASES: dict[str, list[str]] = {
    "python, nothing": ["-c", "pass"],
    "import numpy": ["-c", "import numpy"],
    "import wraparc": ["-c", "import wraparc"],
    "wraparc --help": ["-c", _MAIN, "--help"],
    "wraparc check FILE": ["-c", _MAIN, "check", str(DRIVE)],
    "wraparc solve FILE": ["-c", _MAIN, "solve", str(DRIVE)],
    "wraparc solve FILE --json -": ["-c", _MAIN, "solve", str(DRIVE), "--json", "-"],
    "wraparc solve FILE --method both": ["-c", _MAIN, "solve", str(DRIVE), "--method", "both"],
}


def measure(arguments: list[str]) -> tuple[float, float, float]:
    """Return wall time [s], processor time [s] and peak memory [MB] of one process."""
    start = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode in (0, 1), arguments
    worked = usage.ru_utime + usage.ru_stime
    return time.perf_counter() - start, worked, usage.ru_maxrss / 1024.0


def main() -> None:
    """Measure and print the table."""
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 11
    # as an installer does; where nothing may be cached, every start would compile again
    compileall.compile_dir(ROOT / "src", quiet=1)
    times: dict[str, list[float]] = {name: [] for name in CASES}
    work: dict[str, list[float]] = {name: [] for name in CASES}
    memory: dict[str, float] = {}
    for _ in range(runs + 1):
        for name, arguments in CASES.items():
            seconds, worked, megabytes = measure(arguments)
            times[name].append(seconds)
            work[name].append(worked)
            memory[name] = max(memory.get(name, 0.0), megabytes)
    # the first run of each fills the caches of the machine
    medians = {name: statistics.median(taken[1:]) for name, taken in times.items()}
    print(f"{runs} runs of each; Python {sys.version.split()[0]}, load {os.getloadavg()[0]:.1f}\n")
    print(
        "| command | least [s] | median [s] | over import numpy | least processor time [s] "
        "| peak memory [MB] |"
    )
    print("|---|---|---|---|---|---|")
    for name, taken in times.items():
        ratio = medians[name] / medians["import numpy"]
        least = min(work[name][1:])
        row = (f"{min(taken[1:]):.3f}", f"{medians[name]:.3f}", f"{ratio:.2f}", f"{least:.3f}")
        print(f"| {name} | {' | '.join(row)} | {memory[name]:.0f} |")


if __name__ == "__main__":
    main()
