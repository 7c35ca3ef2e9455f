"""``wraparc profile``: readings over the face of a pulley as rows of a drive file."""

from typing import Any

import click

from wraparc.cli.options import units_option
from wraparc.errors import input_error
from wraparc.units import System, display, parse_quantity


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option("--width", metavar="LENGTH", help="Belt width: readings beside it are left out.")
@click.option(
    "--new", metavar="LENGTH", help="Thickness when new, where the readings are thicknesses."
)
@click.option(
    "--unit", default="", metavar="UNIT", help="Unit of both columns, if the file has none."
)
@click.option(
    "--columns",
    metavar="POSITION,READING",
    help="Names or numbers, if the names are not recognised.",
)
@click.option("--centred/--from-edge", default=None, help="Where positions count from.")
def profile(
    file: str,
    units: System,
    width: str | None,
    new: str | None,
    unit: str,
    columns: str | None,
    centred: bool | None,
) -> int:
    """Read a FILE of depths, thicknesses, diameters or radii measured over the face of a pulley.

    Text with any delimiter, or Excel. Prints the rows for [pulley.across], smoothed, with their
    uncertainty.
    """
    from wraparc.across.measured import read_profile, within
    from wraparc.files.across_keys import ACROSS
    from wraparc.schema.file_kinds import refuse_toml

    refuse_toml(file)
    found = read_profile(
        file,
        new=None if new is None else parse_quantity(new, "length"),
        unit=unit,
        columns=None if columns is None else _pair(columns),
        centred=centred,
    )
    rows = found.profile if width is None else within(found, parse_quantity(width, "length"))
    click.echo(f"# {len(found.position)} readings of {found.reading} in {file}")
    if found.order:
        scatter = display(found.scatter, "length", units, 3)
        click.echo(f"# smoothed by a polynomial of order {found.order}; they scatter by {scatter}")
    else:
        click.echo("# too few to be smoothed: taken as they are")
    kind = next(e.kind for e in ACROSS.entries if e.key == found.key)
    click.echo(_table(found.key, kind.written(rows)), nl=False)
    return 0


def _table(key: str, written: Any) -> str:
    """Return a profile as it stands in a drive file, below its pulley."""
    from wraparc.schema.emit import document_text

    if isinstance(written, dict):
        return f"[pulley.across.{key}]\n{document_text(written)}"
    return f"[pulley.across]\n{document_text({key: written})}"


def _pair(text: str) -> tuple[str | int, str | int]:
    parts = [part.strip() for part in text.split(",")]
    if len(parts) != 2:
        remedy = "Write two names or numbers with a comma between, 1,3."
        raise input_error(key="--columns", value=text, message="not two", remedy=remedy)
    first, second = (int(p) if p.isdecimal() else p for p in parts)
    return first, second
