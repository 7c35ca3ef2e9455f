"""What a command leaves: the files that were asked for, then words on standard output."""

from collections.abc import Callable, Mapping

import click

from wraparc.cli.pipe import say
from wraparc.cli.show import show
from wraparc.present.sheet import Sheet
from wraparc.saving import interrupted, save_file

#: Written to standard output instead of a file.
STANDARD_OUTPUT = "-"
#: What a file is to hold, or what writes it when it is given the path.
Content = str | bytes | Callable[[str], object]


def deliver(files: Mapping[str, Content], sheet: Callable[[], Sheet] | None) -> None:
    """Write files and only then print: a reader who goes away takes no file with him.

    Parameters
    ----------
    files
        By path. What is meant for standard output is text, and printed in place of the sheet.
    sheet
        Makes the sheet that is printed, if any.
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
                say(str(files[STANDARD_OUTPUT]), end="")
            elif sheet is not None:
                show(sheet())
        finally:
            for path in written:
                click.echo(f"Wrote {path}", err=True)
