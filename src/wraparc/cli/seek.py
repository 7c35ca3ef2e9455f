"""``wraparc seek``: which value of an input gives a wanted result."""

from os.path import dirname

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import place_options
from wraparc.cli.solve import code_told


@click.command()
@click.option(
    "--vary", "field", required=True, metavar="KEY", help="The input: pulley.head.wrap_angle."
)
@click.option("--result", required=True, metavar="NAME", help="The result: exit_creep.")
@click.option("--value", required=True, metavar="VALUE", help='What it is to be: "6 mm".')
@place_options
@click.option("--from", "least", metavar="VALUE", help="Minimum input; a third if left out.")
@click.option("--to", "most", metavar="VALUE", help="Most; three times if left out.")
@answers("values", json="")
def seek(answer: Answer, file: str, settings: tuple[str, ...], **goal: str | None) -> int:
    """Find every value of an input of a drive FILE that gives a wanted result.

    wraparc seek drive.toml --vary pulley.head.wrap_angle --result exit_creep --value "6 mm"

    Exit code 1 if no value in the range does, or the drive fails with it.
    """
    from wraparc.answer.seek_sheet import seek_document, seek_sheet
    from wraparc.schema.overrides import read_document
    from wraparc.study.seek import Goal
    from wraparc.study.seek import seek as search
    from wraparc.train.keys import TRAIN_FILE

    document = read_document(file, settings, TRAIN_FILE, "drive")
    wanted = Goal(**{key: text or "" for key, text in goal.items()})
    found = search(document, wanted, file=file, folder=dirname(file), allow_paths=True)
    title = str(document.get("title") or "Goal seek")
    told = seek_sheet(found, title)
    answer.give(lambda: told, lambda: seek_document(found))
    return code_told(told)
