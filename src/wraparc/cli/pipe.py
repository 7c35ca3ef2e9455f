"""Standard output: its reader may go away (``wraparc belts | head -1``), or its disk be full."""

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import click

from wraparc.errors import input_error
from wraparc.saving import FULL


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
    except OSError as error:
        if has_left(error):
            _nowhere()
            return
        if error.errno not in (*FULL, errno.EIO) or error.filename is not None:
            raise
        _nowhere()
        message = f"cannot be written: {error.strerror}"
        remedy = "What is printed is not whole: print it to another place."
        raise input_error(key="standard output", message=message, remedy=remedy) from None


def has_left(error: OSError) -> bool:
    """Whether an error of writing says that nobody reads any more; Windows says it by EINVAL."""
    unnamed = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
    return isinstance(error, BrokenPipeError) or unnamed


def _nowhere() -> None:
    """Let what is printed from here on, and what the interpreter flushes at its end, be lost."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
