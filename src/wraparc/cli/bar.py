"""The progress of a command that takes its time: a bar on a terminal, lines in a log."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click

#: Time between two lines of a log [s].
EVERY = 30.0


@contextmanager
def bar(
    length: int, label: str, rows: int = 1, unit: str = "rows"
) -> Iterator[Callable[..., None]]:
    """Show how many rows are done, and the time left, on a terminal or in a log.

    Gives what is called with how much is done and the whole of it.

    Parameters
    ----------
    length
        The whole.
    label
        What is done.
    rows
        Rows of each of the whole.
    unit
        What they are called.
    """
    if not sys.stderr.isatty():
        yield _Log(label, rows, unit)
        return
    whole, label = length * rows, f"{label} {unit}"
    with click.progressbar(length=whole, label=label, show_pos=True, file=sys.stderr) as shown:
        yield lambda done, total: shown.update(done * rows - shown.pos)


class _Log:
    """Lines now and then: what is soon done writes none."""

    def __init__(self, label: str, rows: int, unit: str) -> None:
        self._label, self._rows, self._unit = label, rows, unit
        self._begin: tuple[float, int] | None = None
        self._last = 0.0

    def __call__(self, done: int, total: int) -> None:
        now = time.monotonic()
        if self._begin is None:  # what an earlier run has done says nothing of the time
            self._begin, self._last = (now, done), now
        begin, first = self._begin
        if now - self._last < EVERY or done in (first, total):
            return
        self._last = now
        left = (now - begin) * (total - done) / (done - first) / 60.0
        share = f"{done * self._rows:,} of {total * self._rows:,} {self._unit}"
        click.echo(f"{self._label}: {share}, about {left:.1f} minutes left.", err=True)
