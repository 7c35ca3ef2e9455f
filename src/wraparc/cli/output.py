"""What a command leaves: the files that were asked for, then words on standard output."""

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from wraparc.present.sheet import Sheet

#: Written to standard output instead of a file.
STANDARD_OUTPUT = "-"
#: What a file is to hold, or what writes it when it is given the path.
Content = str | bytes | Callable[[str], object]


def deliver(files: Mapping[str, Content], sheet: "Callable[[], Sheet]") -> None:
    """Write files and only then print: a reader who goes away takes no file with him.

    Parameters
    ----------
    files
        By path. What is meant for standard output is text, and printed in place of the sheet.
    sheet
        Makes the sheet that is printed.
    """
    from wraparc.saving import save_file

    paths = [path for path in files if path != STANDARD_OUTPUT]
    for path in paths:
        content = files[path]
        if callable(content):
            content(path)
        else:
            save_file(path, content)
    if STANDARD_OUTPUT in files:
        say(str(files[STANDARD_OUTPUT]), end="")
    else:
        from wraparc.cli.show import show

        show(sheet())
    for path in paths:
        click.echo(f"Wrote {path}", err=True)


def say(text: str, end: str = "\n") -> None:
    """Print a text."""
    with reader_may_leave():
        click.echo(text + end, nl=False)


@contextmanager
def reader_may_leave() -> Iterator[None]:
    """Print what a reader may not want to its end: ``wraparc belts | head -1`` is no error."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        # what is printed from here on, and what the interpreter flushes at its end, goes nowhere
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
