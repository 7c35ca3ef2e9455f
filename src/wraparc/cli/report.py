"""``wraparc report``."""

import datetime as dt
import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from wraparc.answer.sheet import Sheet
from wraparc.arc import DriveResult
from wraparc.cli.options import (
    check_outputs,
    conditions_option,
    load_whole,
    named_conditions,
    set_option,
    units_option,
)
from wraparc.cli.output import STANDARD_OUTPUT
from wraparc.cli.page import NEEDED, made_page, save_page
from wraparc.cli.page import SUFFIXES as PAGES
from wraparc.cli.pipe import say
from wraparc.cli.show import Wanted, show
from wraparc.cli.solve import SOLVED, code_of, exit_code, solved
from wraparc.errors import InputError, require
from wraparc.render.note import PAPERS, NoteHead, Paper, compose_note
from wraparc.saving import save_file
from wraparc.schema.source import printable
from wraparc.units import System

if TYPE_CHECKING:
    from wraparc.motion.reported import InTime
    from wraparc.train import TrainResult

SUFFIXES = (".pdf", ".xlsx", ".md")


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "-o",
    "--output",
    required=True,
    metavar="FILE",
    help="The document: .pdf, .xlsx or .md; - prints Markdown.",
)
@units_option
@click.option("--case", "--load-case", "case", metavar="NAME", help="Report this load case only.")
@conditions_option
@set_option
@click.option("--creep-limit", metavar="LENGTH", help='Creep accepted on every pulley: "10 mm".')
@click.option("--title", default="", metavar="TEXT", help="Title; that of the drive if left out.")
@click.option("--project", default="", metavar="TEXT", help="Project or customer.")
@click.option("--number", default="", metavar="TEXT", help="Number of the document.")
@click.option("--revision", default="", metavar="TEXT", help="Its revision.")
@click.option("--author", default="", metavar="TEXT", help="Who prepared it.")
@click.option("--date", metavar="TEXT", help="Date to print; today if left out.")
@click.option(
    "--page",
    "page_file",
    metavar="FILE",
    help="Write the drive as a calculator of one file too, .html, to go with the document.",
)
@click.option(
    "--paper",
    type=click.Choice(PAPERS),
    help="Paper; A4, with US units US Letter.",
)
def report(
    file: str,
    output: str,
    units: System,
    case: str | None,
    conditions: str | None,
    settings: tuple[str, ...],
    creep_limit: str | None,
    title: str,
    project: str,
    number: str,
    revision: str,
    author: str,
    date: str | None,
    page_file: str | None,
    paper: Paper | None,
) -> int:
    """Write the calculation report of a drive FILE: PDF, Excel or Markdown.

    Inputs and where they came from, assumptions, equations, results by both methods, pictures,
    checks against limits, a box to sign.
    """
    check_outputs({"--output": (output, SUFFIXES), "--page": (page_file, PAGES)}, [file])
    head = _head(
        title=title,
        project=project,
        number=number,
        revision=revision,
        author=author,
        date=dt.date.today().isoformat() if date is None else date,  # noqa: DTZ011 - the user's
        file=printable(os.path.basename(file))[-120:],
        changes=_changes(settings, conditions, creep_limit, case),
        paper=paper or ("us-letter" if units == "us" else "a4"),
    )
    asked = named_conditions(conditions)
    read = load_whole(file, overrides=settings, conditions=asked)
    if page_file is not None:
        require("web", *NEEDED)
    carried = None if page_file is None else made_page(file, settings, asked, creep_limit)
    results, train = solved(read, "both", case, creep_limit, file)
    in_time = _in_time(file, settings)
    told = compose_note(results, head, train, in_time)
    if output != STANDARD_OUTPUT:
        show(Sheet(told.title, verdict=replace(told.told, sentences=())), Wanted(units=units))
    _write(output, results, head, units, train, in_time)
    if page_file is not None and carried is not None:
        save_page(page_file, carried)
    code = exit_code(results[0] if train is None else train)
    if in_time is not None and code == SOLVED:
        from wraparc.checks import judge_run

        code = max((code_of(judge_run(run).level) for run in in_time.runs), default=SOLVED)
    return code


def _in_time(file: str, settings: tuple[str, ...]) -> "InTime | None":
    """Follow the events that the file wants in its note."""
    from wraparc.motion.reported import load_followed

    return load_followed(file, overrides=settings)


def _changes(
    settings: tuple[str, ...], conditions: str | None, creep_limit: str | None, case: str | None
) -> tuple[str, ...]:
    """What the command puts over the file, as it shall be printed."""
    more = {"conditions": conditions, "creep limit": creep_limit, "load case": case}
    told = (*settings, *(f"{name} {value}" for name, value in more.items() if value))
    return tuple(printable(text)[:120] for text in told)


def _head(**values: Any) -> NoteHead:
    try:
        return NoteHead(**values)
    except InputError as error:
        raise InputError(replace(p, key=f"--{p.key}") for p in error.problems) from None


def _write(
    output: str,
    results: Sequence[DriveResult],
    head: NoteHead,
    units: System,
    train: "TrainResult | None",
    in_time: "InTime | None",
) -> None:
    from wraparc.render import markdown, pdf, workbook

    if output == STANDARD_OUTPUT:
        say(markdown(results, head, system=units, train=train, in_time=in_time), end="")
        return
    makers: dict[str, Callable[..., str | bytes]]
    makers = {".pdf": pdf, ".xlsx": workbook, ".md": markdown}
    make = makers[os.path.splitext(output)[1].lower()]
    save_file(output, make(results, head, system=units, train=train, in_time=in_time))
    click.echo(f"Wrote {output}", err=True)
