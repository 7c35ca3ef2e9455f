"""What a command leaves: the files that were asked for, then words on standard output."""

from collections.abc import Callable, Mapping

import click

from wraparc.cli.pipe import say
from wraparc.cli.show import show
from wraparc.present.sheet import Sheet
from wraparc.saving import save_file

#: Written to standard output instead of a file.
STANDARD_OUTPUT = "-"
#: What a file is to hold, or what writes it when it is given the path.
Content = str | bytes | Callable[[str], object]


def deliver(files: Mapping[str, Content], sheet: Callable[[], Sheet]) -> None:
    """Write files and only then print: a reader who goes away takes no file with him.

    Parameters
    ----------
    files
        By path. What is meant for standard output is text, and printed in place of the sheet.
    sheet
        Makes the sheet that is printed.
    """
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
        show(sheet())
    for path in paths:
        click.echo(f"Wrote {path}", err=True)
