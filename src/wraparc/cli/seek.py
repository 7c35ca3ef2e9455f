"""``wraparc seek``: which value of an input gives a wanted result."""

import click

from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import deliver
from wraparc.units import System


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option(
    "--vary", "field", required=True, metavar="KEY", help="The input: pulley.head.wrap_angle."
)
@click.option("--result", required=True, metavar="NAME", help="The result: exit_creep.")
@click.option("--value", required=True, metavar="VALUE", help='What it is to be: "6 mm".')
@click.option("--pulley", default="", metavar="NAME", help="Which pulley; the first if left out.")
@click.option(
    "--load-case", default="", metavar="NAME", help="Which load case; the first if left out."
)
@click.option(
    "--from", "least", default="", metavar="VALUE", help="Least input; a third if left out."
)
@click.option("--to", "most", default="", metavar="VALUE", help="Most; three times if left out.")
@click.option("--json", "json_file", metavar="FILE", help="Write the result as JSON; - prints it.")
def seek(
    file: str,
    units: System,
    settings: tuple[str, ...],
    json_file: str | None,
    **goal: str,
) -> int:
    """Find every value of an input of a drive FILE that gives a wanted result.

    wraparc seek drive.toml --vary pulley.head.wrap_angle --result exit_creep --value "6 mm"

    Exit code 1 if no value in the range does.
    """
    from os.path import dirname

    from wraparc.present.document import json_text
    from wraparc.present.seek_sheet import seek_document, seek_sheet
    from wraparc.schema.overrides import read_document
    from wraparc.study.seek import Goal
    from wraparc.study.seek import seek as search
    from wraparc.train.keys import TRAIN_FILE

    check_outputs({"--json": (json_file, (".json",))}, [file])
    document = read_document(file, settings, TRAIN_FILE)
    found = search(document, Goal(**goal), file=file, folder=dirname(file), allow_paths=True)
    title = str(document.get("title") or "Goal seek")
    deliver(
        {json_file: json_text(seek_document(found))} if json_file else {},
        lambda: seek_sheet(found, title, units),
    )
    return 0 if found.values else 1
