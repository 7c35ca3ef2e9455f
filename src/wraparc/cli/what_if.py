"""``wraparc what-if``: a drive before and after changes, in one table."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import click

from wraparc.choose.what_if import Change
from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import load_whole, options, place_options
from wraparc.drive import Drive
from wraparc.errors import input_error, placed

if TYPE_CHECKING:
    from wraparc.choose.named_changes import Named


@click.command("what-if")
@place_options
@click.option(
    "--belt",
    "belts",
    multiple=True,
    metavar="NAME",
    help="A belt of the catalogue, or a standard name: EP 630/3.",
)
@click.option(
    "--other-carcass",
    is_flag=True,
    help="Steel cord for fabric, fabric for steel cord.",
)
@click.option("--lagging", "laggings", multiple=True, metavar="NAME", help="Another lagging.")
@click.option(
    "--thickness", "thicknesses", multiple=True, metavar="LENGTH", help="Lagging of this thickness."
)
@click.option("--worn", multiple=True, metavar="LENGTH", help="Lagging worn to this thickness.")
@click.option("--bare", metavar="STANDARD", help='Bare pulley: "CEMA" or "DIN 22101".')
@click.option(
    "--wet", metavar="FACTOR", help='Friction when wet over dry, or "DIN 22101" for its ratio.'
)
@click.option(
    "--change",
    "changes",
    multiple=True,
    metavar="KEY=VALUE",
    help="Any other value: belt.width=1400 mm.",
)
@answers("changes", "width", settings=False, json="")
def what_if(
    answer: Answer, file: str, pulley: str | None, load_case: str | None, **said: object
) -> int:
    """Compare a pulley of a drive FILE before and after changes, with the reason for each.

    Every change is one column, made to the drive of the file. Verdicts are for the whole
    drive, as in wraparc solve; the exit code is that of the unchanged drive. Where a check of the
    pulley is missed, its load case is shown unless one is named.
    """
    from wraparc.answer.what_if_sheet import what_if_document, what_if_sheet
    from wraparc.choose.named_changes import changes_of
    from wraparc.choose.what_if import what_if as solve_both
    from wraparc.cli.solve import exit_code
    from wraparc.files.conditions import refuse_several
    from wraparc.train.as_drive import nearest_drive

    read = load_whole(file)
    drive = read if isinstance(read, Drive) else nearest_drive(read)
    refuse_several(drive, "what-if changes")
    with placed("--pulley", file):
        name = drive.pulley(pulley).name
    with placed("--load-case", file):
        drive.load_case(load_case)
    with options():
        changes = list(changes_of(read, drive, name, _named(said)))
    changes += _settings(file, said)
    if not changes:
        raise input_error(
            message="nothing is to be changed",
            remedy="Name a change: --other-carcass, --belt, --lagging, --thickness, --worn, "
            "--wet, --bare or --change.",
        )
    found = solve_both(read, name, load_case, changes)
    title = drive.title or "What if"
    answer.give(lambda: what_if_sheet(found, title), lambda: what_if_document(found))
    return exit_code(found.wholes[0])


def _settings(file: str, said: dict[str, object]) -> Iterator[Change]:
    from wraparc.train.file import load_drive_or_train

    for text in _texts(said["changes"]):
        key, _, value = text.partition("=")
        yield Change(f"{key.strip()} {value.strip()}", load_drive_or_train(file, overrides=[text]))


def _texts(value: object) -> tuple[str, ...]:
    return value if isinstance(value, tuple) else ()


def _named(said: dict[str, object]) -> "Named":
    from wraparc.choose.named_changes import Named

    names = ("belts", "laggings", "thicknesses", "worn")
    return Named(
        other_carcass=bool(said["other_carcass"]),
        bare=str(said["bare"] or ""),
        wet=str(said["wet"] or ""),
        **{name: _texts(said[name]) for name in names},
    )
