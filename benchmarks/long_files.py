"""Long machine files: time and memory to read a million rows, as a fresh command.

Run it with ``python benchmarks/long_files.py`` (a number of rows may follow). CPU time and peak
memory of ``wraparc read FILE``, the start of Python and the page that it prints included; beside it
what NumPy takes to parse as many numbers, which tells how fast the computer is at that moment.

Goal: a million rows in 2 s and 300 MB.
"""

import io
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

ROWS = 1_000_000


def kinds(rows: int) -> Iterator[tuple[str, str]]:
    """Yield names and texts of files of the same readings."""
    plain = [f"{0.001 * k:.3f};{0.0001 * k:.4f};{0.5 * k:.1f}" for k in range(rows)]
    head = "Time [s];Extension [mm];Load [N]"
    yield "semicolons", "\n".join([head, *plain, ""])
    yield "commas, line ends of Windows", "\r\n".join([head, *plain, ""]).replace(";", ",")
    yield "decimal commas", "\n".join([head, *plain, ""]).replace(".", ",")
    yield "blanks", "\n".join([head, *plain, ""]).replace(" [", "_[").replace(";", "   ")
    notes = [line + (";" if k % 9973 else ";look here") for k, line in enumerate(plain)]
    yield "a sparse column of notes", "\n".join([f"{head};Note", *notes, ""])
    notes = [line.replace(";", ";;" if k % 10 else ";21.5;", 1) for k, line in enumerate(plain)]
    yield "a sparse column of numbers", "\n".join([head.replace(";", ";Temp;", 1), *notes, ""])
    broken = [line if k % 7919 else "-- pause --" for k, line in enumerate(plain)]
    yield "a line that is no row, now and then", "\n".join([head, *broken, ""])


def write(folder: Path, rows: int) -> None:
    for number, (name, text) in enumerate(kinds(rows)):
        (folder / f"{number} {name}.csv").write_bytes(text.encode())


def command(file: Path) -> tuple[float, float]:
    """CPU time [s] and peak memory [MB] of the command that reads a file."""
    code = f"from wraparc.cli import main; main(['read', {str(file)!r}])"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.DEVNULL) as child:
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    assert child.returncode == 0
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def parsing(rows: int) -> float:
    """CPU time that NumPy takes to parse three numbers a row [s]; of a tenth of them."""
    text = "123.456,0.1234,567.8\n" * (rows // 10)
    start = time.process_time()
    np.loadtxt(io.StringIO(text), delimiter=",")
    return 10.0 * (time.process_time() - start)


if __name__ == "__main__":
    if len(sys.argv) > 3:  # in a process of its own: the memory of a parent counts as its child's
        write(Path(sys.argv[3]), int(sys.argv[2]))
        sys.exit()
    rows = int(sys.argv[1]) if len(sys.argv) > 1 else ROWS
    print(f"| {rows:,} rows | CPU time [s] | x NumPy | memory [MB] |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, __file__, "--write", str(rows), folder], check=True)
        unit = float(min(parsing(rows) for _ in range(3)))
        for file in sorted(Path(folder).iterdir()):
            seconds, memory = min(command(file) for _ in range(3))
            print(f"| {file.stem[2:]} | {seconds:.2f} | {seconds / unit:.1f} | {memory:.0f} |")
