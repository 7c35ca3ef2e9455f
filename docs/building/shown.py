"""Runs of the command line for the documentation, cut down to the parts that a page is about."""

import io
import os
import shlex
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from IPython.display import Markdown

from wraparc.cli import run

os.environ["COLUMNS"] = "98"
os.environ.pop("FORCE_COLOR", None)


def wraparc(command: str, *parts: str, lines: int = 0) -> None:
    """Run a command and print it with its answer; of its paragraphs only those that begin so.

    A part that is in no paragraph is an error: the page would show less than it says. With `lines`
    the answer ends after so many.
    """
    out = io.StringIO()
    with redirect_stdout(out), redirect_stderr(out):
        code = run(shlex.split(command))
    paragraphs = out.getvalue().rstrip().split("\n\n")
    for part in parts:
        if not any(p.startswith(part) for p in paragraphs):
            raise ValueError(f"{command}: nothing begins with {part!r}")
    told = "\n\n".join(p for p in paragraphs if p.startswith(parts or "")).splitlines()
    if lines:
        told = [*told[:lines], "..."]
    print(f"$ wraparc {as_typed(command)}", *told, sep="\n")
    if code:
        print(f"(exit code {code})")


def as_typed(command: str) -> str:
    """Return a command as a reader types it where `wraparc demo` has laid out the examples."""
    return command.replace("../../examples/", "wraparc-demo/")


def file(name: str, text: str) -> Markdown:
    """Write a file, and show it."""
    Path(name).write_text(text, "utf-8")
    return Markdown(f"```toml\n# {name}\n{text}```")


def table(*rows: tuple[object, ...]) -> Markdown:
    """Return rows as a table; the first one has the heads."""
    lines = ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    return Markdown("\n".join([lines[0], "|---" * len(rows[0]) + "|", *lines[1:]]))
