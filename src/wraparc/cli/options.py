"""Options that several commands share, and the checks that go before any work."""

import contextlib
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

import click

from wraparc.cli.output import STANDARD_OUTPUT
from wraparc.errors import InputError, Problem, shown
from wraparc.saving import saving_problems
from wraparc.units import Dimension, positive_quantity

if TYPE_CHECKING:
    from wraparc.drive import Drive
    from wraparc.schema.source import Document
    from wraparc.train import Train

_F = TypeVar("_F", bound=Callable[..., Any])


def units_option(command: _F) -> _F:
    """Add ``--units``."""
    return click.option(
        "--units",
        type=click.Choice(["si", "us"]),
        default="si",
        show_default=True,
        envvar="WRAPARC_UNITS",
        show_envvar=True,
        help="Units of the output.",
    )(command)


def set_option(command: _F) -> _F:
    """Add ``--set``."""
    return click.option(
        "--set",
        "settings",
        multiple=True,
        metavar="KEY=VALUE",
        help='Override a value of the file: --set pulley.head.exit_tension="55 kN".',
    )(command)


def place_options(command: _F) -> _F:
    """Add ``--pulley`` and ``--load-case``."""
    case = click.option(
        "--load-case", metavar="NAME", help="Load case; the running one of maximum Te."
    )
    pulley = click.option("--pulley", metavar="NAME", help="Which pulley; the first if left out.")
    return pulley(case(command))


@contextlib.contextmanager
def typed(option: str, text: str) -> Iterator[None]:
    """Say of a problem raised within that it is of an option, and what was typed."""
    try:
        yield
    except InputError as error:
        raise InputError(replace(error.problems[0], key=option, value=shown(text))) from None


def positive(option: str, text: str | None, dimension: Dimension) -> float | None:
    """Return a quantity [SI] of more than 0 that was typed for an option; None if it was not."""
    return None if text is None else positive_quantity(text, dimension, option)


@contextlib.contextmanager
def options() -> Iterator[None]:
    """Say of the problems raised within which option they are of, by the name of the field."""
    try:
        yield
    except InputError as error:
        raise InputError(map(_of_option, error.problems)) from None


#: Options of values by name: ``--hours design=6000``.
_BY_NAME = ("hours", "wear_hours")


def _of_option(problem: Problem) -> Problem:
    name, _, of = problem.key.partition(".")
    if not (problem.key.isidentifier() or name in _BY_NAME):
        return problem
    return replace(problem, key=" ".join(filter(None, (f"--{name.replace('_', '-')}", of))))


def conditions_option(command: _F) -> _F:
    """Add ``--conditions``."""
    return click.option(
        "--conditions",
        metavar="NAMES",
        help="Conditions to solve side by side, dry,wet; dusty=0.8 gives the friction left.",
    )(command)


def named_conditions(text: str | None) -> tuple[str, ...]:
    """Return the conditions of ``--conditions``; none if it was left out."""
    return () if text is None else tuple(text.split(","))


def load_whole(
    file: str, *, overrides: Sequence[str] = (), conditions: Sequence[str] = ()
) -> "Drive | Train":
    """Return what a drive file describes; its faults are told with those of tables not used here.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    from wraparc.train.file import load_drive_or_train

    return load_drive_or_train(file, overrides=overrides, conditions=conditions, also=_motion)


def _motion(document: "Document", *, file: str) -> None:
    if "motion" in document:  # the room of drives in time is loaded for these alone
        from wraparc.motion.file import check_motion

        check_motion(document, file=file)


def check_outputs(
    outputs: dict[str, tuple[str | None, tuple[str, ...]]], inputs: Sequence[str] = ()
) -> None:
    """Refuse files that cannot be written, before anything is solved.

    Parameters
    ----------
    outputs
        By option: the path given or None, and the endings it may have.
    inputs
        Files that are read.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    problems: list[Problem] = []
    taken: dict[str, str] = {}
    for option, (path, suffixes) in outputs.items():
        if not path:
            continue
        place = path
        if path != STANDARD_OUTPUT:
            place = os.path.realpath(path)
            problems += saving_problems(path, suffixes=suffixes, inputs=inputs, key=option)
        other = taken.setdefault(place, option)
        if other != option:
            message, remedy = f"{other} writes to the same place", "Name two files."
            problems.append(Problem(key=option, value=shown(path), message=message, remedy=remedy))
    if problems:
        raise InputError(problems)
