"""Runs of the command line for the documentation, cut down to the parts that a page is about."""

import io
import os
import shlex
from contextlib import redirect_stdout

from wraparc.cli import run


def wraparc(command: str, *parts: str) -> None:
    """Run a command and print it with its answer; of its paragraphs only those that begin so.

    A part that is in no paragraph is an error: the page would show less than it says.
    """
    os.environ["COLUMNS"] = "100"
    os.environ.pop("FORCE_COLOR", None)
    out = io.StringIO()
    with redirect_stdout(out):
        run(shlex.split(command))
    paragraphs = out.getvalue().rstrip().split("\n\n")
    told = [p for p in paragraphs if p.startswith(parts)] if parts else paragraphs
    for part in parts:
        if not any(p.startswith(part) for p in told):
            raise ValueError(f"{command}: nothing begins with {part!r}")
    print(f"$ wraparc {as_typed(command)}", *told, sep="\n\n")


def as_typed(command: str) -> str:
    """Return a command as a reader types it where `wraparc demo` has laid out the examples."""
    return command.replace("../../examples/", "wraparc-demo/")
