"""``wraparc solve`` and ``wraparc check``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

import click

from wraparc.alike import largest
from wraparc.answer.drive_sheet import drive_sheet, input_sheet
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sheet import ReserveWanted, Sheet
from wraparc.arc import Distributed, DriveResult, Method, PaperMarch
from wraparc.arc import solve as solve_drive
from wraparc.checks import Level
from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import conditions_option, load_whole, named_conditions, typed
from wraparc.drive import Drive
from wraparc.errors import input_error, placed
from wraparc.units import System, parse_quantity

if TYPE_CHECKING:
    from wraparc.train import Train, TrainResult

_Whole = TypeVar("_Whole", Drive, "Train")
#: Methods by the name they have on the command line.
METHODS: dict[str, tuple[type[Method], ...]] = {
    "distributed": (Distributed,),
    "paper": (PaperMarch,),
    "both": (Distributed, PaperMarch),
}
SOLVED, FAILS, FAULT = 0, 1, 3


#: Table of what changes the verdict.
RESERVE = "reserve"
#: Table of how probable its level is.
PROBABILITY = "probability"
#: Tables of a solved drive, and those that only a train has.
TABLES = (
    "checks", "least", "cases", "figures", "drives", "conditions", "conveyor",
    "tensions", "flights", "sag", "curves", "take-up", "standstill", "loads", "width",
    "strips", RESERVE, PROBABILITY, "defects", "result", "creep", "capacity", "margins", "constant",
    "energy", "wear", "life", "inputs",
)  # fmt: skip


@click.command()
@click.option(
    "--method",
    type=click.Choice(list(METHODS)),
    default="distributed",
    show_default=True,
    help="The main solver, the paper's integration, or both side by side.",
)
@click.option("--load-case", metavar="NAME", help="Solve this load case only.")
@conditions_option
@click.option("--creep-limit", metavar="LENGTH", help='Creep accepted on every pulley: "10 mm".')
@click.option("--all", "everything", is_flag=True, help="Show every arc in full; as --full.")
@click.option("--no-reserve", is_flag=True, help="Do not seek what changes the verdict: faster.")
@click.option("--probability", is_flag=True, help="Draw all uncertain inputs: how often it is OK.")
@click.option("--decimal-comma", is_flag=True, help="CSV with decimal commas and semicolons.")
@answers(
    *TABLES,
    json="",
    csv="Write the profiles as CSV; - prints them.",
    plot="Draw it, or the reserve with --table reserve: .svg, .png or .pdf.",
    map="Draw an uneven pulley over wrap and width: .svg, .png or .pdf.",
    tension="Draw the belt tension along the conveyor: .svg, .png or .pdf.",
)
def solve(
    answer: Answer,
    file: str,
    method: str,
    settings: tuple[str, ...],
    load_case: str | None,
    conditions: str | None,
    creep_limit: str | None,
    everything: bool,
    no_reserve: bool,
    probability: bool,
    decimal_comma: bool,
) -> int:
    """Check every pulley of a drive FILE in every load case and print the answer.

    One screen: verdict and action, checks that fail or are nearest to their limits, load cases,
    missing data. Several pulleys on one belt share its load.
    """
    drive = load_whole(file, overrides=settings, conditions=named_conditions(conditions))
    results, train = solved(drive, method, load_case, creep_limit, file)
    units = answer.units
    answer.write("csv", lambda: _csv(results, units, decimal_comma))
    of_reserve = answer.wanted.table == RESERVE and not no_reserve
    picture = _reserve_picture if of_reserve else _picture
    answer.write("plot", lambda: picture(results, units, train).save)
    answer.write("map", lambda: _map(results[0], units).save)
    answer.write("tension", lambda: _tension_picture(drive, units, train).save)
    if everything and not answer.wanted.table:
        answer.wanted = replace(answer.wanted, full=True)
    detailed = answer.whole and (everything or load_case is not None)
    reserve = "" if no_reserve or method == "paper" else _reserve_wanted(answer)
    probability = (probability or answer.wanted.table == PROBABILITY) and method != "paper"
    answer.give(
        lambda: _sheet(results, detailed, train, reserve, probability=probability),
        lambda: _document(results, train, file, reserve=bool(reserve), probability=probability),
    )
    return exit_code(results[0] if train is None else train)


def _reserve_wanted(answer: Answer) -> ReserveWanted:
    """Return how much of the reserve is shown: data and its table have that of every input."""
    if answer.paths["json"] or answer.wanted.full or answer.wanted.table == RESERVE:
        return "all"
    return "" if answer.wanted.table else "line"


def solved(
    read: "Drive | Train", method: str, load_case: str | None, creep_limit: str | None, file: str
) -> "tuple[list[DriveResult], TrainResult | None]":
    """Solve what was read by the methods of a name in `METHODS`; several pulleys are a train.

    The main solver always divides the load of a train: the paper's integration knows no speeds.
    """
    if isinstance(read, Drive) and len(read.pulleys) == 1:
        drive = _with_limit(_with_case(read, load_case, file), creep_limit)
        return [_solved(drive, m) for m in METHODS[method]], None
    from wraparc.train import Train, solve_train

    train = Train.of(read) if isinstance(read, Drive) else read
    if load_case is not None:
        with placed("--load-case", file):
            train = replace(train, cases=(train.case(load_case),))
    result = solve_train(_with_limit(train, creep_limit), raise_on_failure=False)
    own = result.drive_result()
    methods = METHODS[method]
    return [own if m is Distributed else _solved(own.drive, m) for m in methods], result


def _solved(drive: Drive, method: type[Method]) -> DriveResult:
    return solve_drive(drive, method=method(), raise_on_failure=False)


def _document(
    results: Sequence[DriveResult],
    train: "TrainResult | None",
    file: str,
    *,
    reserve: bool,
    probability: bool,
) -> dict[str, Any]:
    from wraparc.answer.document import solved_document

    return solved_document(results, train, file=file, reserve=reserve, probability=probability)


def _csv(results: Sequence[DriveResult], units: System, decimal_comma: bool) -> str:
    from wraparc.render.profile_csv import profile_csv

    arcs = [arc for result in results for arc in result]
    return profile_csv(arcs, units, decimal_comma=decimal_comma)


def exit_code(result: "DriveResult | TrainResult") -> int:
    """Return the exit code of a verdict: 0, 1 where it fails, 3 for a fault of the program."""
    return code_of(judge_uncertain(result).level)


def code_told(sheet: Sheet) -> int:
    """Return the exit code of an answer."""
    return code_of(sheet.verdict.level) if sheet.verdict else SOLVED


def code_of(level: Level) -> int:
    """Return the exit code of the level of a verdict."""
    if level is Level.FAULT:
        return FAULT
    return FAILS if level is Level.FAILS else SOLVED


@click.command()
@answers(
    "checks", "conveyor", "tensions", "flights", "sag", "curves", "take-up", "standstill", "inputs",
    plot="Draw the belt tension along the conveyor: .svg, .png or .pdf.",
)  # fmt: skip
def check(answer: Answer, file: str, settings: tuple[str, ...]) -> int:
    """Validate a drive FILE: report all its errors; solve nothing."""
    read = load_whole(file, overrides=settings)
    answer.write("plot", lambda: _tension_picture(read, answer.units).save)
    if isinstance(read, Drive):
        answer.give(lambda: input_sheet(read))
        return SOLVED
    from wraparc.answer.train_sheet import train_input_sheet

    answer.give(lambda: train_input_sheet(read))
    return SOLVED


def _sheet(
    results: Sequence[DriveResult],
    everything: bool,
    train: "TrainResult | None",
    reserve: ReserveWanted,
    *,
    probability: bool,
) -> Sheet:
    detail = range(len(results[0])) if everything else None
    if train is None:
        return drive_sheet(results, detail, reserve=reserve, probability=probability)
    from wraparc.answer.train_sheet import train_sheet

    return train_sheet(train, detail, results, reserve=reserve, probability=probability)


def _picture(results: Sequence[DriveResult], units: System, train: "TrainResult | None") -> Any:
    if train is None:
        from wraparc.plot import plot_drive

        return plot_drive(results, units)
    from wraparc.plot.train import plot_train

    return plot_train(train, units=units)


def _reserve_picture(
    results: Sequence[DriveResult], units: System, train: "TrainResult | None"
) -> Any:
    from wraparc.answer.reserve_words import flips_by_input
    from wraparc.plot.reserve import Bars, plot_reserve

    found = flips_by_input(results[0] if train is None else train)
    return plot_reserve([Bars(name, flips) for name, flips in found.items()], units)


def _tension_picture(
    read: "Drive | Train", units: System, result: "TrainResult | None" = None
) -> Any:
    from wraparc.plot import plot_conveyor

    return plot_conveyor(read, units, result)


def _map(result: DriveResult, units: System) -> Any:
    """Return the map over arc and width of the uneven pulley that wears most unevenly."""
    from wraparc.across import across_of
    from wraparc.plot import plot_across

    found = across_of(result)
    if not found:
        message = "no pulley of this drive is uneven across its width"
        remedy = "Say what is uneven in [pulley.across]."
        raise input_error(key="--map", message=message, remedy=remedy)
    return plot_across(largest(found, lambda r: r.energy_unevenness), units)


def _with_case(drive: Drive, name: str | None, file: str) -> Drive:
    """Return the drive with one load case only."""
    if name is None:
        return drive
    with placed("--load-case", file):
        return replace(drive, load_cases=(drive.load_case(name),))


def _with_limit(whole: _Whole, text: str | None) -> _Whole:
    """Return a drive or train with one creep limit for all pulleys, as it was typed."""
    if text is None:
        return whole
    with typed("--creep-limit", text):
        limit = parse_quantity(text, "length")
        pulleys = tuple(replace(pulley, creep_limit=limit) for pulley in whole.pulleys)
        return replace(whole, creep_limit=limit, pulleys=pulleys)
