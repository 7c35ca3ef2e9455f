"""``wraparc import``: load cases of other programs' print-outs into a drive file."""

import os

import click

from wraparc.cli.options import typed
from wraparc.errors import input_error


@click.command()
@click.argument("file", type=click.Path())
@click.option("--drive", metavar="FILE", help="Drive file that takes the load cases.")
@click.option("-o", "--output", metavar="FILE", help="Where the drive file goes.")
@click.option("--pulley", metavar="NAME", help="The pulley, where the table names none.")
@click.option(
    "--unit", default="", metavar="UNIT", help="Unit of the tensions, if the file has none."
)
@click.option(
    "--decimal",
    default="",
    type=click.Choice(["", ".", ","]),
    help="Decimal sign, where it is unclear.",
)
@click.option(
    "--kind", "kinds", multiple=True, metavar="CASE=KIND", help="Running, starting or braking."
)
def import_table(
    file: str,
    drive: str | None,
    output: str | None,
    pulley: str | None,
    unit: str,
    decimal: str,
    kinds: tuple[str, ...],
) -> int:
    """Read a FILE of tensions by load case and pulley, as other programs print them.

    Text with any delimiter, or Excel: columns T1, T2 or Te with their units. Prints the load cases
    for a drive file, or writes them into one: --drive and -o.
    """
    from wraparc.files.print_out import put_into, read_print_out
    from wraparc.saving import save_file
    from wraparc.schema.emit import document_text
    from wraparc.schema.file_kinds import refuse_toml
    from wraparc.schema.source import parse, read_text

    refuse_toml(file)
    if (drive is None) != (output is None):
        lacks = "--drive" if drive is None else "-o"
        raise input_error(key=lacks, message="missing", remedy="Give both, or neither.")
    document = None if drive is None else parse(read_text(drive), drive)
    names = [] if document is None else [p.get("name") for p in document.get("pulley", ())]
    name = pulley or (str(names[0]) if len(names) == 1 else "")
    found = read_print_out(
        file, unit=unit, decimal=decimal, pulley=name, kinds=dict(map(_kind, kinds))
    )
    if document is None or drive is None or output is None:
        click.echo(document_text({"load_case": list(found.cases)}), nl=False)
        return 0
    made = put_into(document, found, drive, os.path.dirname(drive))
    save_file(output, document_text(made))
    counted = "1 load case" if len(found.cases) == 1 else f"{len(found.cases)} load cases"
    click.echo(f"Wrote {output}: {counted} of {', '.join(found.pulleys)}.")
    return 0


def _kind(text: str) -> tuple[str, str]:
    name, equals, kind = text.rpartition("=")
    with typed("--kind", text):
        if not equals or not name:
            raise input_error(message="no load case with a kind", remedy="Write CASE=KIND.")
    return name, kind
