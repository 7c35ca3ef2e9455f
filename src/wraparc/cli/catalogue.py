"""``wraparc laggings``, ``wraparc lagging`` and ``wraparc belts``."""

import os

import click

from wraparc import catalogue
from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import Content, deliver
from wraparc.cli.show import show
from wraparc.files import load_lagging_conditions
from wraparc.present.catalogue_sheets import belts_sheet, lagging_sheet, laggings_sheet
from wraparc.units import System


@click.command()
@units_option
def laggings(units: System) -> None:
    """List the laggings of the catalogue."""
    names = catalogue.lagging_names()
    found = [lagging for name in names for lagging in load_lagging_conditions(name)]
    show(laggings_sheet(found, units))


@click.command()
@click.argument("name")
@units_option
@click.option("--plot", "plot_file", metavar="FILE", help="Draw it: .svg, .png or .pdf.")
def lagging(name: str, units: System, plot_file: str | None) -> None:
    """Show one lagging: NAME in the catalogue, or the path of a lagging file."""
    read = [name] if os.path.exists(name) else []
    check_outputs({"--plot": (plot_file, (".svg", ".png", ".pdf"))}, read)
    conditions = load_lagging_conditions(name)
    files: dict[str, Content] = {}
    if plot_file:
        from wraparc.plot import plot_lagging

        files[plot_file] = plot_lagging(conditions[0], units).save
    deliver(files, lambda: lagging_sheet(conditions, units))


@click.command()
@units_option
def belts(units: System) -> None:
    """List the belts of the catalogue."""
    show(belts_sheet(units))
