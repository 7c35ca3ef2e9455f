"""``wraparc demo``: an example drive solved and drawn, and all examples laid out to try."""

import os
import shutil
import sys
from pathlib import Path

import click

from wraparc.answer.drive_sheet import drive_sheet
from wraparc.arc import solve
from wraparc.cli.options import units_option
from wraparc.cli.pipe import say
from wraparc.errors import MissingExtraError, input_error, shown
from wraparc.files import load_drive
from wraparc.saving import save_file
from wraparc.units import System

_DRIVE = "head-drive-fabric.toml"
_PICTURE = "head-drive-fabric.svg"


@click.command()
@click.option(
    "--into",
    type=click.Path(path_type=Path),
    default=Path("wraparc-demo"),
    show_default=True,
    help="Folder for the examples and the picture.",
)
@units_option
def demo(into: Path, units: System) -> int:
    """Copy all examples to a folder, solve one and draw it.

    Files that are already there are used unchanged: edit one and run it again.
    """
    from wraparc.cli.show import Wanted, show
    from wraparc.cli.solve import exit_code

    kept = lay_out(into)
    result = solve(load_drive(into / _DRIVE), raise_on_failure=False)
    try:
        from wraparc.plot import plot_drive

        plot_drive([result], units).save(into / _PICTURE)
        picture = f"The picture is {into / _PICTURE}"
    except MissingExtraError as error:
        picture = f"There is no picture: it {error}"
    show(drive_sheet([result]), Wanted(units=units))
    say("\n".join(["", *(f"Unchanged: your own {into / name}." for name in kept), picture]))
    say(f"The calculator in the browser opens with: {command_name()} serve {into / _DRIVE}")
    say(_next_steps(into))
    return exit_code(result)


def lay_out(into: Path) -> list[str]:
    """Copy the examples into a folder; return the names of those that were there and differ.

    Raises
    ------
    InputError
        If they cannot be copied.
    """
    source, kept = examples_folder(), []
    for path in sorted(source.rglob("*")):
        if not path.is_file():
            continue
        name = path.relative_to(source)
        target, content = into / name, path.read_bytes()
        try:
            if target.exists():
                kept += [str(name)] if target.read_bytes() != content else []
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            message = f"cannot be used for the examples: {error.strerror}"
            remedy = "Name another folder with --into."
            given = shown(str(into))
            raise input_error(key="--into", value=given, message=message, remedy=remedy) from None
        save_file(target, content)
    return kept


def examples_folder() -> Path:
    """Return where the examples are: in the package, or beside it in a source tree."""
    package = Path(__file__).parents[1]
    folders = (package / "examples", package.parents[1] / "examples")
    found = next((folder for folder in folders if (folder / _DRIVE).is_file()), None)
    if found is None:
        message, remedy = "this installation lacks the examples", "Install wraparc again."
        raise input_error(message=message, remedy=remedy)
    return found


def _next_steps(into: Path) -> str:
    command, file = command_name(), into / _DRIVE
    steps = (
        (
            "The take-up 30 kN higher:",
            f'solve {file} --set pulley.head.entry_tension="180 kN" '
            '--set pulley.head.exit_tension="90 kN"',
        ),
        ("Another lagging:", f"solve {file} --set pulley.head.lagging=full-ceramic"),
        ("Compared with the paper's integration:", f"solve {file} --method both"),
        (
            "A pulley that brakes, in US units:",
            f"solve {into / 'downhill-braking.toml'} --units us",
        ),
        ("The calculation report:", f"report {file} -o {into / 'report.pdf'}"),
        ("What is known of a lagging:", "lagging diamond-rubber"),
        ("Everything else:", "--help"),
    )
    width = max(len(title) for title, _ in steps)
    lines = [f"  {title:<{width}}  {command} {rest}" for title, rest in steps]
    return "\n".join(("", "Try next:", *lines))


def command_name() -> str:
    """Return what to type to run this program: its name, or its path where that is needed."""
    started = sys.argv[0]
    found = shutil.which("wraparc")
    if not os.path.basename(started).startswith("wraparc"):
        return "wraparc"
    if found and os.path.realpath(found) == os.path.realpath(started):
        return "wraparc"
    try:
        return os.path.relpath(started)
    except ValueError:  # another drive on Windows
        return started
