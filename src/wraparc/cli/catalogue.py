"""``wraparc laggings``, ``wraparc lagging`` and ``wraparc belts``."""

from typing import Any

import click

from wraparc import catalogue
from wraparc.answer.catalogue_sheets import belt_sheet, belts_sheet, lagging_sheet, laggings_sheet
from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import units_option
from wraparc.cli.show import Wanted, show
from wraparc.files import load_lagging_conditions
from wraparc.units import System


@click.command()
@units_option
def laggings(units: System) -> None:
    """List the laggings of the catalogue."""
    names = catalogue.lagging_names()
    found = [lagging for name in names for lagging in load_lagging_conditions(name)]
    show(laggings_sheet(found), Wanted(full=True, units=units))


@click.command()
@answers(
    "lagging",
    "friction",
    "coefficients",
    "constant",
    "cost",
    settings=False,
    argument="name",
    json="",
    plot="",
)
def lagging(answer: Answer, name: str) -> None:
    """Show one lagging: NAME in the catalogue, or the path of a lagging file."""
    conditions = load_lagging_conditions(name)
    if answer.paths["plot"]:
        from wraparc.plot import plot_lagging

        answer.write("plot", lambda: plot_lagging(conditions[0], answer.units).save)

    def document() -> dict[str, Any]:
        from wraparc.answer.document import lagging_data

        return {"conditions": [lagging_data(one) for one in conditions]}

    answer.give(lambda: lagging_sheet(conditions), document)


@click.command()
@click.argument("names", nargs=-1, metavar="[NAME]...")
@units_option
def belts(names: tuple[str, ...], units: System) -> None:
    """List the belts of the catalogue, or show belts by NAME: "EP 630/3", "ST 2000"."""
    rows = [catalogue.belt(name, with_modulus=False) for name in names]
    show(belt_sheet(rows) if rows else belts_sheet(), Wanted(full=True, units=units))
