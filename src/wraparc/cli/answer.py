"""What the commands that answer share: options for units, settings, files and how much is printed.

``@answers`` adds the options to a command and gives it an `Answer`, which knows what was asked for
and leaves it: the files first, then the sheet on standard output.
"""

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, wraps
from typing import Any

import click

from wraparc.answer.sheet import Sheet
from wraparc.cli.options import check_outputs, set_option, units_option
from wraparc.cli.output import Content, deliver
from wraparc.cli.show import Wanted, no_table
from wraparc.errors import InputError
from wraparc.units import System

PICTURES = (".svg", ".png", ".pdf")
#: Endings of the files that are written, by option.
SUFFIXES: dict[str, tuple[str, ...]] = {
    "json": (".json",), "csv": (".csv",), "parquet": (".parquet",), "plot": PICTURES,
    "map": PICTURES, "tension": PICTURES, "report": (".html",), "output": (".toml",),
    "checkpoint": (".npz",),
}  # fmt: skip
#: What is said of an option of files where a command says nothing of its own.
_HELP = {
    "json": "Write the result as JSON; - prints it.",
    "output": "Write it as a file, .toml.",
    "plot": "Draw it: .svg, .png or .pdf.",
}

_NONE: Mapping[str, tuple[str | None, tuple[str, ...]]] = {}


@dataclass
class Answer:
    """What is asked of a command, and what it leaves.

    Attributes
    ----------
    units
        To show.
    wanted
        How much of the answer is printed.
    paths
        By option, where a file is to be written, or None.
    files
        What has been made of them.
    """

    units: System
    wanted: Wanted
    paths: dict[str, str | None]
    files: dict[str, Content] = field(default_factory=dict)

    @property
    def whole(self) -> bool:
        """Whether more than the short answer is printed."""
        return self.wanted.full or bool(self.wanted.table)

    def check(
        self, inputs: Sequence[str], more: Mapping[str, tuple[str | None, tuple[str, ...]]] = _NONE
    ) -> None:
        """Refuse files that cannot be written, and pictures that cannot be drawn.

        Parameters
        ----------
        inputs
            Files that are read.
        more
            Further files to be written, by option: path, and the endings it may have.
        """
        own = {f"--{name}": (path, SUFFIXES[name]) for name, path in self.paths.items()}
        check_outputs({**more, **own}, [path for path in inputs if os.path.exists(path)])
        if any(self.paths.get(name) for name in ("plot", "map", "tension", "report")):
            from wraparc.plot import require_matplotlib

            require_matplotlib()

    def write(self, option: str, make: Callable[[], Content]) -> None:
        """Make what is to be written by an option, if it was given."""
        path = self.paths.get(option)
        if path:
            self.files[path] = make()

    def give(
        self,
        sheet: Callable[[], Sheet] | None,
        document: Callable[[], Mapping[str, Any]] | None = None,
        shows: bool = True,
    ) -> None:
        """Write the files, then print the sheet.

        Parameters
        ----------
        sheet
            Makes the sheet, if any.
        document
            Makes what the JSON holds besides the answer of the sheet.
        shows
            Whether the sheet is printed.
        """
        path, made = self.paths.get("json"), sheet and cache(sheet)
        if path and made and document:
            from wraparc.answer.answer_data import answer_json

            self.files = {path: answer_json(document(), made()), **self.files}
        deliver(self.files, made if shows else None, self.wanted)


def answers(
    *tables: str, settings: bool = True, argument: str = "file", checked: bool = True, **files: str
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Add the options that commands share to one, which takes an `Answer` as ``answer``.

    Parameters
    ----------
    *tables
        Names of the tables that ``--table`` may ask for; without any the answer is one screen.
    settings
        Whether values can be put over those of the file: `settings`.
    argument
        The file that is read; empty where the command says itself which it reads.
    checked
        Whether files are refused here that cannot be written; otherwise the command does it.
    **files
        By option of `SUFFIXES`, its help; the usual one if empty.
    """

    def decorate(command: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(command)
        def call(**given: Any) -> Any:
            paths = {name: given.pop(f"{name}_file") for name in files}
            units: System = given.pop("units")
            table = given.pop("table", None) or ""
            wanted = Wanted(given.pop("full", not tables), table, units)
            if wanted.table and wanted.table not in tables:
                raise InputError(no_table(wanted.table, list(tables)))
            answer = Answer(units, wanted, paths)
            if checked:
                answer.check([given[argument]])
            return command(answer=answer, **given)

        found: Callable[..., Any] = call
        for option in reversed([units_option, *_settings(settings), *_shown(tables), *_to(files)]):
            found = option(found)
        return click.argument(argument, type=click.Path())(found) if argument else found

    return decorate


def _settings(wanted: bool) -> list[Callable[..., Any]]:
    return [set_option] if wanted else []


def _shown(tables: tuple[str, ...]) -> list[Callable[..., Any]]:
    if not tables:
        return []
    full = click.option("--full", is_flag=True, help="Print everything, not one screen of it.")
    names = ", ".join(tables)
    table = click.option("--table", metavar="NAME", help=f"Print one table alone: {names}.")
    return [full, table]


def _to(files: dict[str, str]) -> list[Callable[..., Any]]:
    names = {name: ["-o"] if name == "output" else [] for name in files}
    return [
        click.option(
            *names[name], f"--{name}", f"{name}_file", metavar="FILE", help=said or _HELP[name]
        )
        for name, said in files.items()
    ]
