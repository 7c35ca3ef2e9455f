"""``wraparc choose``: rank candidates, and say why the others fall out."""

import click

from wraparc.choose.belt_rating import LighterBelt
from wraparc.choose.selection import Selection
from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import Content, deliver
from wraparc.units import System

_FOUND, _NONE_FEASIBLE = 0, 1


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="KEY=VALUE",
    help='Put a value over that of the file: --set candidates.slack_tensions="least".',
)
@click.option(
    "--rows",
    type=click.IntRange(1, 1000),
    default=15,
    show_default=True,
    help="Designs to print at most.",
)
@click.option("--lightest-belt", is_flag=True, help="Also find the lightest belt of the catalogue.")
@click.option("--json", "json_file", metavar="FILE", help="Write the result as JSON; - prints it.")
@click.option("--csv", "csv_file", metavar="FILE", help="Write every design as CSV; - prints it.")
@click.option("--plot", "plot_file", metavar="FILE", help="Draw cost against creep and T2.")
def choose(
    file: str,
    units: System,
    settings: tuple[str, ...],
    rows: int,
    lightest_belt: bool,
    json_file: str | None,
    csv_file: str | None,
    plot_file: str | None,
) -> int:
    """Choose lagging, belt, pulley and take-up: solve every candidate of a choose FILE.

    Prints the designs that keep every limit, cheapest over the years first, and why each other
    one was rejected. Exit code 1 if no candidate keeps every limit.
    """
    from wraparc.choose.file import load_search
    from wraparc.choose.selection import choose as choose_design
    from wraparc.present.choose_sheet import choose_sheet

    outputs = {
        "--json": (json_file, (".json",)),
        "--csv": (csv_file, (".csv",)),
        "--plot": (plot_file, (".svg", ".png", ".pdf")),
    }
    check_outputs(outputs, [file])
    if plot_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    selection = choose_design(load_search(file, overrides=settings))
    lighter = _lightest(selection) if lightest_belt else None
    files = _texts(selection, lighter, json_file, csv_file)
    if plot_file:
        from wraparc.plot.choice import plot_selection

        files[plot_file] = plot_selection(selection, units).save
    deliver(files, lambda: choose_sheet(selection, units, lighter, rows))
    return _FOUND if len(selection.ranking) else _NONE_FEASIBLE


def _lightest(selection: Selection) -> LighterBelt | None:
    from wraparc import catalogue
    from wraparc.choose.belt_rating import least_belt
    from wraparc.drive.changes import belt_of

    if not len(selection.ranking):
        return None
    best = int(selection.ranking[0])
    now = selection.search.belts[selection.grid.places[2, best]]
    kinds = [row for row in catalogue.belts() if row.kind == now.kind]
    return least_belt(selection, best, [belt_of(row, now) for row in kinds])


def _texts(
    selection: Selection, lighter: LighterBelt | None, json_file: str | None, csv_file: str | None
) -> dict[str, Content]:
    from wraparc.present.choose_sheet import choose_csv, choose_document

    texts: dict[str, Content] = {}
    if json_file:
        from wraparc.present.document import json_text

        texts[json_file] = json_text(choose_document(selection, lighter))
    if csv_file:
        texts[csv_file] = choose_csv(selection)
    return texts
