"""``wraparc page``: the calculator as one file."""

import os
from collections.abc import Sequence
from dataclasses import dataclass

import click

from wraparc.cli.options import check_outputs
from wraparc.cli.output import STANDARD_OUTPUT
from wraparc.cli.pipe import say
from wraparc.errors import require
from wraparc.saving import save_file
from wraparc.schema.source import read_text

SUFFIXES = (".html", ".htm")
#: Libraries that a page is made with, as the answers of the server are.
NEEDED = ("pydantic", "fastapi")


@click.command()
@click.argument("file", type=click.Path(), required=False)
@click.option(
    "-o",
    "--output",
    required=True,
    metavar="FILE",
    help="The page, .html; - prints it.",
)
def page(file: str | None, output: str) -> int:
    """Write the calculator as one HTML file, beginning with a drive FILE or an example.

    It opens by a double click and computes by itself: no server, no network, no Python. It opens
    and saves drive files, which the command line solves to the same numbers.
    """
    check_outputs({"--output": (output, SUFFIXES)}, [file] if file else [])
    require("web", *NEEDED)
    save_page(output, made_page(file))
    return 0


@dataclass(frozen=True)
class Made:
    """A page, and a sentence on the drive where the page does not judge it."""

    text: str
    left: str


def save_page(output: str, made: Made) -> None:
    """Write a page to a file, or print it; say what it does not show."""
    text = made.text
    if made.left:
        click.echo(made.left, err=True)
    if output == STANDARD_OUTPUT:
        say(text, end="")
        return
    save_file(output, text)
    click.echo(f"Wrote {output}", err=True)


def made_page(
    file: str | None,
    overrides: Sequence[str] = (),
    conditions: Sequence[str] = (),
    creep_limit: str | None = None,
) -> Made:
    """Return the page of a drive file, or of the first example.

    `overrides`, `conditions` and `creep_limit` are put over what the file says, as by ``--set``,
    ``--conditions`` and ``--creep-limit``.
    """
    from wraparc.files import overridden
    from wraparc.files.conditions import asking
    from wraparc.web.opening import opened
    from wraparc.web.page_file import file_of, first_example, not_judged, page_file

    if file is None:
        return Made(page_file(*first_example()), "")
    document = overridden(opened(file), overrides, file=file)
    document = asking(document, conditions) if conditions else document
    if creep_limit is not None:
        pulleys = [
            {k: v for k, v in pulley.items() if k != "creep_limit"} for pulley in document["pulley"]
        ]
        document = {**document, "creep_limit": creep_limit, "pulley": pulleys}
    name = os.path.basename(file).removesuffix(".toml")
    text = page_file(document, name, file_of(document, read_text(file)))
    return Made(text, not_judged(document))
