"""``wraparc field``: what a healthy drive shows, when to alarm, how long the lagging lasts."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

import click

from wraparc.calibrate.on_site import OnSite, on_site
from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import load_whole, options, typed
from wraparc.errors import input_error, placed
from wraparc.schema.overrides import read_document
from wraparc.units import parse_number

if TYPE_CHECKING:
    from wraparc.answer.sheet import Table


@click.command()
@click.option("--pulley", metavar="NAME", help="Which pulley; the first if left out.")
@click.option("--hours", multiple=True, metavar="CASE=HOURS", help="Hours of running in a year.")
@click.option("--wear-coefficient", metavar="VALUE", help='Energetic wear: "0.001 mm3/J".')
@click.option("--measured-wear", metavar="DEPTH", help="Depth worn off so far, to calibrate it.")
@click.option(
    "--wear-hours",
    multiple=True,
    metavar="CASE=HOURS",
    help="Hours of running in which the measured wear came about.",
)
@click.option(
    "--depth",
    metavar="LENGTH",
    help="Depth of lagging that may be worn off; half its thickness if left out.",
)
@answers("speeds", "levels", "learned", "wear", json="")
def field(
    answer: Answer,
    file: str,
    settings: tuple[str, ...],
    pulley: str | None,
    hours: tuple[str, ...],
    wear_hours: tuple[str, ...],
    **said: str | None,
) -> int:
    """Show what to expect of a drive FILE on site: normal slip, alarm levels, wear.

    The numbers are for one pulley; verdict and exit code for the whole drive, as in wraparc solve.
    """
    from wraparc.answer.field_sheet import field_document, field_sheet
    from wraparc.answer.words import whole_verdict
    from wraparc.checks import judge
    from wraparc.cli.solve import exit_code
    from wraparc.train.whole import by_pulley, solved

    whole = solved(load_whole(file, overrides=settings))
    drive = by_pulley(whole).drive
    with placed("--pulley", file):
        name = drive.pulley(pulley).name
    asked = OnSite(
        hours=_hours(hours, "--hours"),
        wear_hours=_hours(wear_hours, "--wear-hours"),
        **{key: text or "" for key, text in said.items()},
    )
    with options():
        found, source = on_site(whole, name, asked)
    judged, title = judge(whole), drive.title or "Drive"
    levels = _levels(file, name)
    answer.give(
        lambda: field_sheet(found, whole_verdict(whole), title, name, source, levels),
        lambda: field_document(found, judged),
    )
    return exit_code(whole)


def _levels(file: str, pulley: str) -> "tuple[Table, ...]":
    """Return the levels that a drive file has from its logs, of one pulley."""
    document = read_document(file)
    if "learned" not in document:
        return ()
    from wraparc.answer.learn_sheet import levels_table
    from wraparc.learn.write import learned_levels

    return tuple(
        levels_table(own) for own in learned_levels(document, file) if own.pulley == pulley
    )


def _hours(texts: Iterable[str], option: str) -> dict[str, float]:
    found = {}
    for text in texts:
        name, equals, number = text.rpartition("=")
        with typed(option, text):
            if not equals or not name:
                raise input_error(message="no load case with hours", remedy="Write CASE=HOURS.")
            found[name] = parse_number(number)
    return found
