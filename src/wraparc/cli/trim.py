"""``wraparc trim``: how closely the drives on one belt must be matched."""

from typing import Any

import click

from wraparc.answer.sheet import Sheet
from wraparc.arc import Distributed
from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import load_whole, typed
from wraparc.cli.output import Content
from wraparc.errors import input_error, placed, shown
from wraparc.train import Matching, ShareMap, Train, TrainResult, match_drives, solve_train
from wraparc.train.matching import WEAR, wet_laggings
from wraparc.units import display, parse_quantity


@click.command()
@click.option("--drive", "pulley", metavar="PULLEY", help="Drive to trim; the second if left out.")
@click.option(
    "--load-case", metavar="NAME", default="", help="Load case; the running one of maximum Te."
)
@click.option(
    "--span",
    nargs=2,
    metavar="LOW HIGH",
    help='Range of trims: --span "99 %" "101 %"; wide enough for the load to change over if left '
    "out.",
)
@click.option(
    "--points",
    type=click.IntRange(3, 1001),
    default=61,
    show_default=True,
    help="Points of every curve.",
)
@click.option("--wear", metavar="DEPTH", help="Wear of a pulley; 1 mm if left out.")
@click.option("--map", "with_map", is_flag=True, help="Add a map of share over trim and load.")
@answers(
    "drives",
    "trim",
    "diameter",
    "load",
    "changed",
    json="Write the curves as JSON; - prints them.",
    csv="Write the trim curve as CSV; - prints it.",
    plot="Draw the curves: .svg, .png or .pdf.",
)
def trim(
    answer: Answer,
    file: str,
    pulley: str | None,
    load_case: str,
    span: tuple[str, str] | None,
    points: int,
    wear: str | None,
    with_map: bool,
    settings: tuple[str, ...],
) -> int:
    """Show how the drives of a train FILE share the load as one speed is trimmed.

    Load shares over speed trim, diameter and load, all other speeds constant; where a drive begins
    to brake or reaches its creep limit; shares with one pulley worn or wet. Verdict and exit code
    are those of wraparc solve. In gross slip there is nothing to trim.
    """
    from wraparc.cli.solve import exit_code

    read = load_whole(file, overrides=settings)
    train = read if isinstance(read, Train) else Train.of(read)
    drive = _drive(train, pulley, file)
    depth = WEAR if wear is None else _wear(wear, train)
    ends = None if not span else (_trim(span[0]), _trim(span[1]))
    with placed("--load-case", file):
        load_case = train.case(load_case).name
    result = solve_train(train, method=Distributed(capacities=False), raise_on_failure=False)
    if not result[load_case].status.solved:
        answer.give(lambda: _verdict(result), lambda: _verdict_document(result))
        return exit_code(result)
    matching = match_drives(
        result,
        load_case,
        drive=drive,
        wear=depth,
        laggings=wet_laggings(train),
        span=ends,
        points=points,
    )
    over_load = _map(result, load_case, drive, matching) if with_map else None
    answer.write("csv", lambda: _csv(matching))
    answer.write("plot", lambda: _picture(matching, over_load, train.title))
    answer.give(
        lambda: _sheet(result, matching), lambda: _document(result, matching, over_load, file)
    )
    return exit_code(result)


def _picture(matching: Matching, over_load: ShareMap | None, title: str) -> Content:
    from wraparc.plot.train import plot_matching

    return plot_matching(matching, over_load, title=title).save


def _sheet(result: TrainResult, matching: Matching) -> Sheet:
    from wraparc.answer.train_sheet import matching_sheet

    return matching_sheet(result, matching)


def _verdict(result: TrainResult) -> Sheet:
    from wraparc.answer.train_words import train_verdict

    title = f"{result.train.title or 'Train'}: nothing to trim"
    return Sheet(title=title, verdict=train_verdict(result))


def _verdict_document(result: TrainResult) -> dict[str, Any]:
    from wraparc.answer.checks_table import verdict_document
    from wraparc.checks import judge

    return {"format": 1, "verdict": verdict_document(judge(result))}


def _document(
    result: TrainResult, matching: Matching, over_load: ShareMap | None, file: str
) -> dict[str, Any]:
    from wraparc.answer.train_document import matching_document

    return matching_document(result, matching, over_load, file=file)


def _csv(matching: Matching) -> str:
    from wraparc.answer.train_document import curve_csv

    return curve_csv(matching.trim)


def _drive(train: Train, pulley: str | None, file: str) -> int:
    names = [p.name for p in train.pulleys]
    if len(names) < 2:
        message = "trim needs two or more drive pulleys; this file has one"
        raise input_error(message=message, file=file, key="pulley")
    if pulley is None:
        return 1
    if pulley in names[1:]:
        return names.index(pulley)
    message = "trims are relative to the first drive" if pulley in names else "no such pulley"
    there = ", ".join(map(shown, names[1:]))
    raise input_error(
        message=message,
        remedy=f"Choose one of {there}.",
        file=file,
        key="--drive",
        value=shown(pulley),
    )


def _wear(text: str, train: Train) -> float:
    thickest = max(pulley.lagging.thickness for pulley in train.pulleys)
    with typed("--wear", text):
        depth = parse_quantity(text, "length")
        if not 0.0 <= depth <= thickest:
            most = display(thickest, "length")
            message = f"must be between 0 and the thickness of a lagging, {most}"
            raise input_error(message=message)
    return depth


def _trim(text: str) -> float:
    with typed("--span", text):
        return parse_quantity(text, "number")


def _map(result: TrainResult, load_case: str, drive: int, matching: Matching) -> ShareMap:
    import numpy as np

    from wraparc.train import share_map

    values = matching.trim.values
    return share_map(
        result,
        load_case,
        drive=drive,
        x=np.linspace(values[0], values[-1], 101),
        y=np.linspace(0.1, 1.25, 101),
    )
