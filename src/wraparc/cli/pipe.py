"""Standard output whose reader may go away: ``wraparc belts | head -1`` is no error."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import click


class NoReaderError(BrokenPipeError):
    """Whoever read the output has gone away; without a number, at which click would exit."""


def say(text: str, end: str = "\n") -> None:
    """Print a text."""
    with reader_may_leave():
        click.echo(text + end, nl=False)


@contextmanager
def reader_may_leave() -> Iterator[None]:
    """Print what a reader may not want to its end."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        # what is printed from here on, and what the interpreter flushes at its end, goes nowhere
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
