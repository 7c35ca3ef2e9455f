"""``wraparc choose``: rank candidates, and say why the others fall out."""

from typing import TYPE_CHECKING

import click

from wraparc.choose.belt_rating import LighterBelt
from wraparc.choose.selection import Selection
from wraparc.cli.answer import Answer, answers
from wraparc.cli.output import Content
from wraparc.cli.solve import code_told
from wraparc.units import System

if TYPE_CHECKING:
    from wraparc.reserve.of_designs import DesignReserve


@click.command()
@click.option(
    "--rows",
    type=click.IntRange(1, 1000),
    default=15,
    show_default=True,
    help="Designs to print at most, with --full.",
)
@click.option("--lightest-belt", is_flag=True, help="Also find the lightest belt of the catalogue.")
@click.option("--by-reserve", is_flag=True, help="List the first 12 by the reserve of the verdict.")
@answers(
    "ranking",
    "rejected",
    json="",
    csv="Write every design as CSV; - prints it.",
    plot="Draw cost against creep and T2.",
)
def choose(
    answer: Answer,
    file: str,
    settings: tuple[str, ...],
    rows: int,
    lightest_belt: bool,
    by_reserve: bool,
) -> int:
    """Rank the candidates of a choose FILE: lagging, belt, pulley and take-up.

    Prints the feasible designs by cost over the years, and why each other one was rejected. Exit
    code 1 if none is feasible, or the cheapest fails.
    """
    from wraparc.answer.choose_sheet import choose_csv, choose_document, choose_sheet
    from wraparc.choose.file import load_search
    from wraparc.choose.selection import choose as choose_design

    selection = choose_design(load_search(file, overrides=settings))
    lighter = _lightest(selection) if lightest_belt else None
    answer.write("csv", lambda: choose_csv(selection))
    answer.write("plot", lambda: _picture(selection, answer.units))
    reserves = _by_reserve(selection) if by_reserve else ()
    told = choose_sheet(selection, lighter, rows, reserves)
    answer.give(lambda: told, lambda: choose_document(selection, lighter, reserves))
    return code_told(told)


def _picture(selection: Selection, units: System) -> Content:
    from wraparc.plot.choice import plot_selection

    return plot_selection(selection, units).save


def _by_reserve(selection: Selection) -> "tuple[DesignReserve, ...]":
    from wraparc.reserve.of_designs import rank_by_reserve

    return rank_by_reserve(selection)


def _lightest(selection: Selection) -> LighterBelt | None:
    from wraparc import catalogue
    from wraparc.choose.belt_rating import least_belt
    from wraparc.drive.changes import with_belt

    if not len(selection.ranking):
        return None
    best = int(selection.ranking[0])
    now = selection.grid.drive(best)
    kinds = [row for row in catalogue.belts() if row.kind == now.belt.kind]
    return least_belt(selection, best, [with_belt(now, row).belt for row in kinds])
