"""Speed of shear tests: from files to a report, and of reading a long file.

Run it with ``python benchmarks/shear_test.py``. CPU time of the process that works, best of a few;
beside it the ratio to what NumPy takes to parse as many numbers in the same run. A loop of ten
million additions, timed beside it, says how fast the machine is: 0.6 s where the goals hold.

Goals: 24 tests of 5,000 readings from files to a PDF report in under 3 s, the start of Python
included, its modules compiled before; a file of 200,000 rows read in under 0.5 s.
"""

import io
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np

from wraparc.cli import run
from wraparc.files import load_lagging
from wraparc.render.shear_test import make_report
from wraparc.shear_test import (
    DIALECTS,
    Choices,
    VirtualRig,
    fit_plan,
    read_machine_bytes,
    run_virtual_test,
)
from wraparc.shear_test.plan_file import load_plan

LONG = 200_000


def best(work: Callable[[], object], rounds: int = 3) -> float:
    """Least CPU time of a few rounds [s]."""
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def parsing(numbers: int) -> float:
    """What NumPy takes to parse as many numbers, one after another [s]."""
    text = "\n".join(["1234.56789,0.123456"] * (numbers // 2))
    return best(lambda: np.loadtxt(io.StringIO(text), delimiter=","))


def additions() -> float:
    """What Python takes for ten million additions [s]."""

    def work() -> None:
        total = 0
        for number in range(10_000_000):
            total += number

    return best(work)


def command(arguments: list[str]) -> float:
    """CPU time of a process of its own, its start included [s]."""
    before = os.times()
    subprocess.run(
        [sys.executable, "-c", f"from wraparc.cli import main; main({arguments!r})"],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    after = os.times()
    used = after.children_user - before.children_user
    return used + after.children_system - before.children_system


def laboratory(folder: Path) -> None:
    print("24 tests of 5,000 readings, eight dialects, from files to a report")
    with redirect_stdout(io.StringIO()):
        run(["rig", str(folder), "--points", "5000"])
    plan = load_plan(folder / "plan.toml")
    result = fit_plan(plan)
    unit = parsing(24 * 5000 * 4)
    report = make_report(result)
    rows = [
        ("reading and fitting", best(lambda: fit_plan(plan))),
        ("drawing the report", best(lambda: make_report(result))),
        ("typesetting it as PDF", best(lambda: report.save(folder / "fit.pdf"))),
    ]
    fit = ["fit", str(folder / "plan.toml"), "-o", str(folder / "lagging.toml")]
    whole = min(command([*fit, "--report", str(folder / "fit.pdf")]) for _ in range(3))
    rows.append(("wraparc fit plan.toml -o lagging.toml --report fit.pdf", whole))
    for name, seconds in rows:
        print(f"  {name:56} {seconds:6.2f} s   {seconds / unit:5.1f} x parsing the numbers")
    loop = additions()
    print(f"  {'ten million additions':56} {loop:6.2f} s   the command takes {whole / loop:.1f} x")


def long_file() -> None:
    print(f"a file of {LONG:,} rows of four numbers, in each dialect")
    law = load_lagging("diamond-rubber").law
    test = run_virtual_test(VirtualRig(law=law, points=LONG), 207e3, 1)
    unit = parsing(LONG * 4)
    for name, dialect in DIALECTS.items():
        if name == "excel":
            continue
        data, choices = dialect.write(test), Choices(units=dict(dialect.units))

        def read(data: bytes = data, choices: Choices = choices) -> object:
            return read_machine_bytes(data, "long", choices)

        seconds = best(read)
        print(f"  {name:56} {seconds:6.2f} s   {seconds / unit:5.1f} x parsing the numbers")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        laboratory(Path(folder) / "lab")
    long_file()
