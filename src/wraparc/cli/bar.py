"""The progress bar of a command that takes its time."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click


@contextmanager
def bar(length: int, label: str) -> Iterator[Callable[[int, int], object] | None]:
    """Show a bar with the time left on a terminal; nothing where the messages go elsewhere.

    Gives what is called with how much is done and the whole of it, or None.
    """
    if not sys.stderr.isatty():
        yield None
        return
    with click.progressbar(length=length, label=label, show_pos=True, file=sys.stderr) as shown:
        yield lambda done, total: shown.update(done - shown.pos)
