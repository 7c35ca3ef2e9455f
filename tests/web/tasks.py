"""What processes of tests are asked to do: such a process loads this module, and no test."""

import errno
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from wraparc.errors import InputError, Problem


def note(folder: str) -> int:
    Path(folder, str(time.monotonic_ns())).write_text("")
    return os.getpid()


def held(file: str) -> str:
    while not Path(file).exists():
        time.sleep(0.001)
    return "held"


def works(folder: str, file: str) -> str:
    """Use the processor until a file is there."""
    note(folder)
    while not Path(file).exists():
        sum(range(10_000))
    return "worked"


def noted_and_held(folder: str, file: str) -> None:
    note(folder)
    held(file)


def sleeps(folder: str, seconds: float) -> None:
    note(folder)
    time.sleep(seconds)


def fills() -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


def raises(message: str) -> None:
    raise InputError(Problem(message=message))


def folder() -> str:
    return tempfile.mkdtemp()


def exit_code(code: int) -> int:
    return subprocess.run([sys.executable, "-c", f"exit({code})"], check=False).returncode


def true() -> bool:
    return True
