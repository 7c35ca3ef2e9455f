"""What a command leaves: the files that were asked for, then words on standard output."""

import sys
from collections.abc import Callable, Mapping

import click

from wraparc.answer.sheet import Sheet
from wraparc.cli.pipe import reader_may_leave, say
from wraparc.cli.show import Wanted, show
from wraparc.saving import as_bytes, interrupted, save_file

#: Written to standard output instead of a file.
STANDARD_OUTPUT = "-"
#: What a file is to hold, or what writes it when it is given the path.
Content = str | bytes | Callable[[str], object]


def deliver(
    files: Mapping[str, Content], sheet: Callable[[], Sheet] | None, wanted: Wanted
) -> None:
    """Write files and only then print: a reader who goes away takes no file with him.

    Parameters
    ----------
    files
        By path. What is meant for standard output is text, and printed in place of the sheet.
    sheet
        Makes the sheet that is printed, if any.
    wanted
        How much of it.
    """
    paths = [path for path in files if path != STANDARD_OUTPUT]
    written: list[str] = []
    with interrupted(lambda: "What was written before is whole." if written else ""):
        try:
            for path in paths:
                content = files[path]
                if callable(content):
                    content(path)
                else:
                    save_file(path, content)
                written.append(path)
            if STANDARD_OUTPUT in files:
                _print(str(files[STANDARD_OUTPUT]))
            elif sheet is not None:
                show(sheet(), wanted)
        finally:
            for path in written:
                click.echo(f"Wrote {path}", err=True)


def _print(text: str) -> None:
    """Print what would be a file: into a pipe or a file the same bytes, whatever the locale."""
    raw = getattr(sys.stdout, "buffer", None)
    if raw is None or sys.stdout.isatty():
        say(text, end="")
        return
    with reader_may_leave():
        sys.stdout.flush()
        raw.write(as_bytes(text))
