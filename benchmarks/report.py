"""Time of the calculation note: solving, content, PDF, workbook, Markdown; and of the command.

Run it with ``python benchmarks/report.py [RUNS]``. The parts are processor time in one process, the
best of the runs; the commands run in fresh processes, wall clock and processor time.

Goal: a report in under 1 s.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from wraparc import PaperMarch, load_drive, solve
from wraparc.render import markdown, pdf, workbook
from wraparc.render.note import NoteHead, make_note

DRIVE = Path(__file__).parents[1] / "examples" / "head-drive-fabric.toml"
_MAIN = "from wraparc.cli import main; main()"


def best(runs: int, work: Callable[[], object], clock: Callable[[], float]) -> tuple[float, float]:
    """Return the first and the least time of some runs [s]."""
    times = []
    for _ in range(runs):
        start = clock()
        work()
        times.append(clock() - start)
    return times[0], min(times)


def children() -> float:
    """Return the processor time of all processes started so far [s]."""
    times = os.times()
    return times.children_user + times.children_system


def command(*arguments: str) -> Callable[[], object]:
    """Return what runs a command in a fresh process."""
    line = [sys.executable, "-c", _MAIN, *arguments]
    return lambda: subprocess.run(line, check=True, capture_output=True)


def main(runs: int) -> None:
    drive = load_drive(DRIVE)

    def both() -> list[object]:
        return [solve(drive), solve(drive, method=PaperMarch())]

    results = [solve(drive), solve(drive, method=PaperMarch())]
    print(f"{'processor time [ms]':28}{'first':>8}{'best':>8}")
    for title, work in (
        ("solve, 3 load cases, 2 ways", both),
        ("content and pictures", lambda: make_note(results, NoteHead())),
        ("PDF, all of it", lambda: pdf(results)),
        ("workbook, all of it", lambda: workbook(results)),
        ("Markdown, all of it", lambda: markdown(results)),
    ):
        first, least = best(runs, work, time.process_time)
        print(f"{title:28}{1e3 * first:8.0f}{1e3 * least:8.0f}")
    with tempfile.TemporaryDirectory() as folder:
        print(f"{'fresh process, best [s]':28}{'wall':>8}{'cpu':>8}")
        for title, arguments in (
            ("wraparc solve", ("solve", str(DRIVE))),
            ("wraparc report, PDF", ("report", str(DRIVE), "-o", f"{folder}/note.pdf")),
            ("wraparc report, Excel", ("report", str(DRIVE), "-o", f"{folder}/note.xlsx")),
            ("wraparc report, Markdown", ("report", str(DRIVE), "-o", f"{folder}/note.md")),
        ):
            run = command(*arguments)
            wall = best(runs, run, time.perf_counter)[1]
            print(f"{title:28}{wall:8.2f}{best(runs, run, children)[1]:8.2f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
