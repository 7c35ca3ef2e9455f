"""The gate: every part of ``make test`` or ``make check``, each with its log, and a line a part.

``python tools/gate.py`` runs all of it, ``python tools/gate.py --changed`` what a developer runs
before a commit (`changed.py` says which tests). A stage begins when the one before it has passed;
the parts of a stage run side by side. What a part prints goes to ``build/gate/PART.log``; the tests
are shown while they run. A part that takes longer than its limit is ended, and the others go on.
At the end stand what ran, how long, how it ended, where its log is, and for what failed the command
that repeats it alone.
"""

import contextlib
import os
import re
import shlex
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

ROOT = Path(__file__).resolve().parent.parent
LOGS = ROOT / "build" / "gate"
STAGES = (("dev", "system"), ("format", "lint"), ("types", "docs", "installed", "tests"))
CHECKED = (("dev", "system"), ("format", "lint"), ("types", "near"))
#: After so long [s], several times what a part takes, it is taken to hang.
LIMITS = {
    "dev": 1800, "system": 1800, "format": 300, "lint": 300, "types": 1200, "docs": 1200,
    "installed": 1800, "tests": 5400, "near": 900,
}  # fmt: skip
#: The exit code of a part that hangs, as `timeout` of GNU has it.
HANGS = 124
#: What is interrupted has so long [s] to end by itself: pytest says what failed, and stops servers.
GRACE = 20.0
#: The parts that are pytest, shown while they run.
TESTS = ("tests", "near")
#: Commands of failed tests that are printed; the log has all.
MOST = 10
#: The processes of the parts.
RUNNING: list["subprocess.Popen[bytes]"] = []
_FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+\.py(?:::.*?)?)(?: - .*)?$", re.MULTILINE)
_CLOSING = re.compile(r"^=+ (.*) in [\d.]+s.*$", re.MULTILINE)
_COUNTED = re.compile(r"(\d+) (passed|failed|errors?|skipped)")


@dataclass(frozen=True)
class Ran:
    """One part that ran: its name, how long [s], its exit code, where its log is."""

    part: str
    seconds: float
    code: int
    log: Path

    def counts(self) -> dict[str, int]:
        """Return how many tests passed, failed (errors too) and were skipped, as pytest says."""
        found = dict.fromkeys(("passed", "failed", "skipped"), 0)
        closing = _CLOSING.findall(self.log.read_text("utf-8", "replace"))
        for number, word in _COUNTED.findall(closing[-1] if closing else ""):
            found["failed" if word.startswith("error") else word] += int(number)
        return found

    def line(self) -> str:
        """Return the line of the part."""
        how = {0: "passed", HANGS: "HANGS, ended"}.get(self.code, "FAILED")
        counts = self.counts() if self.part in TESTS else {}
        number = ", ".join(f"{n} {word}" for word, n in counts.items() if n)
        log = self.log.relative_to(ROOT).as_posix()
        return f"  {self.part:10s}{self.seconds:6.0f} s  {how}  {log}  {number}".rstrip()

    def again(self) -> list[str]:
        """Return the commands that repeat what failed, each alone."""
        if self.part not in TESTS:
            return [f"make {self.part}"]
        failed = dict.fromkeys(_FAILED.findall(self.log.read_text("utf-8", "replace")))
        alone = [f"make tests WORKERS=0 TESTS={shlex.quote(name)}" for name in failed]
        more = [f"... and {len(alone) - MOST} more, in the log"] if len(alone) > MOST else []
        return [*alone[:MOST], *more] or [f"make {self.part}"]


def run(part: str) -> Ran:
    """Run one part by make, its output into its log, that of tests to the terminal too."""
    log, begin = LOGS / f"{part}.log", time.monotonic()
    command = [os.environ.get("MAKE", "make"), "--no-print-directory", part]
    with log.open("wb") as file:
        # a group of its own, which can be ended with all that it started
        process = subprocess.Popen(
            command,
            cwd=ROOT,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        RUNNING.append(process)
        # what outlives the part may hold the pipe open: nobody waits for its end
        copying = threading.Thread(
            target=copy, args=(process.stdout, file, part in TESTS), daemon=True
        )
        copying.start()
        code = wait_or_end(process, LIMITS[part])
        copying.join(GRACE)
    ran = Ran(part, time.monotonic() - begin, code, log)
    if part not in TESTS:
        print(ran.line().strip(), flush=True)
    return ran


def copy(output: BinaryIO, log: BinaryIO, shown: bool) -> None:
    """Copy what a part prints into its log, and to the terminal if it is shown."""
    with output, contextlib.suppress(ValueError):  # the log is closed
        while chunk := os.read(output.fileno(), 1 << 16):
            log.write(chunk)
            log.flush()
            if shown:
                sys.stdout.buffer.write(chunk)
                sys.stdout.buffer.flush()


def wait_or_end(process: "subprocess.Popen[bytes]", limit: float) -> int:
    """Return the exit code of a part; after its limit [s] end it, by Ctrl-C and then by force."""
    try:
        return process.wait(limit)
    except subprocess.TimeoutExpired:
        send(process, signal.SIGINT)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(GRACE)
        send(process, signal.SIGKILL)
        process.wait()
        return HANGS


def send(process: "subprocess.Popen[bytes]", number: signal.Signals) -> None:
    """Send a signal to a part and all that it started."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, number)


def interrupt(number: int, _frame: object) -> None:
    """End the parts that run with the gate: they are in groups of their own."""
    for process in RUNNING:
        if process.poll() is None:
            send(process, signal.Signals(number))
    raise SystemExit(128 + number)


def side_by_side(parts: tuple[str, ...]) -> list[Ran]:
    """Run the parts of a stage at the same time."""
    with ThreadPoolExecutor(len(parts)) as pool:
        return list(pool.map(run, parts))


def stages(which: tuple[tuple[str, ...], ...]) -> list[Ran]:
    """Run the stages, each after the one before it has passed."""
    # one environment is made by one of them
    ran = [run(part) for part in which[0]]
    for parts in which[1:]:
        if not any(one.code for one in ran):
            ran += side_by_side(parts)
    return ran


def told(ran: list[Ran]) -> Iterator[str]:
    """Yield what stands at the end: a line a part, and what failed, with the commands for it."""
    yield from (one.line() for one in ran)
    for one in ran:
        if one.code and one.part not in TESTS:
            yield f"\n{one.part}, the end of its log:"
            yield from one.log.read_text("utf-8", "replace").splitlines()[-15:]
        if one.code:
            yield f"\n{one.part}, to repeat what failed alone:"
            yield from (f"  {command}" for command in one.again())
    for one in ran:
        if one.part in TESTS:
            # the closing line stands for all: a part that failed beside the tests counts as one
            counts = one.counts()
            failed = counts["failed"] + sum(o.code != 0 and o.part not in TESTS for o in ran)
            failed = failed or int(one.code != 0)
            skipped = f", {counts['skipped']} skipped" if counts["skipped"] else ""
            yield f"\n{counts['passed']} passed, {failed} failed{skipped}"


def main(arguments: list[str]) -> int:
    """Run the stages, print the lines, and return 0 only if every part passed."""
    which = CHECKED if "--changed" in arguments else STAGES
    LOGS.mkdir(parents=True, exist_ok=True)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, interrupt)
    begin = time.monotonic()
    ran = stages(which)
    done = {one.part for one in ran}
    left = [part for parts in which for part in parts if part not in done]
    print(f"\n== {time.monotonic() - begin:.0f} s", *(["not run:", *left] if left else []))
    print("\n".join(told(ran)), flush=True)
    return int(any(one.code for one in ran))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
