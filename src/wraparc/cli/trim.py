"""``wraparc trim``: how closely the drives on one belt must be matched."""

from dataclasses import replace
from typing import Any

import click

from wraparc.arc import Distributed
from wraparc.cli.options import check_outputs, load_whole, units_option
from wraparc.cli.output import Content, deliver
from wraparc.errors import InputError, Problem, placed, shown
from wraparc.present.sheet import Sheet
from wraparc.train import Matching, ShareMap, Train, TrainResult, match_drives, solve_train
from wraparc.train.matching import WEAR, wet_laggings
from wraparc.units import System, display, parse_quantity


@click.command()
@click.argument("file", type=click.Path())
@click.option("--drive", "pulley", metavar="PULLEY", help="Drive to vary; the second if not given.")
@click.option("--load-case", metavar="NAME", default="", help="Load case; the first if not given.")
@click.option(
    "--span",
    nargs=2,
    metavar="LOW HIGH",
    help='Ends of the trims: --span "99 %" "101 %". Left out, wide enough for the load to change '
    "over.",
)
@click.option(
    "--points",
    type=click.IntRange(3, 1001),
    default=61,
    show_default=True,
    help="Points of every curve.",
)
@click.option("--wear", metavar="DEPTH", help="Wear of a drum; 1 mm if not given.")
@click.option("--map", "with_map", is_flag=True, help="Add a map of share over trim and load.")
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--json", "json_file", metavar="FILE", help="Write the curves as JSON; - prints.")
@click.option("--csv", "csv_file", metavar="FILE", help="Write the trim curve as CSV; - prints.")
@click.option("--plot", "plot_file", metavar="FILE", help="Draw the curves: .svg, .png or .pdf.")
def trim(
    file: str,
    pulley: str | None,
    load_case: str,
    span: tuple[str, str] | None,
    points: int,
    wear: str | None,
    with_map: bool,
    units: System,
    settings: tuple[str, ...],
    json_file: str | None,
    csv_file: str | None,
    plot_file: str | None,
) -> int:
    """Show how the drives of a train FILE share the load as one speed is trimmed.

    Shares are computed against speed trim, diameter and load with all other speeds held, with the
    places where a drive begins to brake or reaches its creep limit, and with one drum worn or wet.
    Verdict and exit code are those of wraparc solve; a train that does not carry its load has no
    speeds to trim.
    """
    from wraparc.cli.solve import exit_code

    outputs = {
        "--json": (json_file, (".json",)),
        "--csv": (csv_file, (".csv",)),
        "--plot": (plot_file, (".svg", ".png", ".pdf")),
    }
    check_outputs(outputs, [file])
    if plot_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    read = load_whole(file, overrides=settings)
    train = read if isinstance(read, Train) else Train.of(read)
    drive = _drive(train, pulley, file)
    depth = WEAR if wear is None else _wear(wear, train)
    ends = None if not span else (_trim(span[0]), _trim(span[1]))
    _check_case(train, load_case, file)
    files: dict[str, Content] = {}
    result = solve_train(train, method=Distributed(capacities=False), raise_on_failure=False)
    if not (result[load_case] if load_case else result.cases[0]).status.solved:
        if json_file:
            files[json_file] = _verdict_json(result)
        deliver(files, lambda: _verdict(result, units))
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
    if json_file:
        files[json_file] = _json(result, matching, over_load, file)
    if csv_file:
        files[csv_file] = _csv(matching)
    if plot_file:
        from wraparc.plot.train import plot_matching

        files[plot_file] = plot_matching(matching, over_load, title=train.title).save
    deliver(files, lambda: _sheet(result, matching, units))
    return exit_code(result)


def _sheet(result: TrainResult, matching: Matching, units: System) -> Sheet:
    from wraparc.present.train_sheet import matching_sheet

    return matching_sheet(result, matching, units)


def _verdict(result: TrainResult, units: System) -> Sheet:
    from wraparc.present.train_words import train_verdict

    title = f"{result.train.title or 'Train'}: nothing to trim"
    return Sheet(title=title, verdict=train_verdict(result, units))


def _verdict_json(result: TrainResult) -> str:
    from wraparc.checks import judge
    from wraparc.present.checks_table import verdict_document
    from wraparc.present.document import json_text

    return json_text({"format": 1, "verdict": verdict_document(judge(result))})


def _json(result: TrainResult, matching: Matching, over_load: ShareMap | None, file: str) -> str:
    from wraparc.present.document import json_text
    from wraparc.present.train_document import matching_document

    return json_text(matching_document(result, matching, over_load, file=file))


def _csv(matching: Matching) -> str:
    from wraparc.present.train_document import curve_csv

    return curve_csv(matching.trim)


def _drive(train: Train, pulley: str | None, file: str) -> int:
    names = [p.name for p in train.pulleys]
    if len(names) < 2:
        message = "the file has one pulley, which shares its load with nobody"
        raise InputError(Problem(message=message, file=file, key="pulley"))
    if pulley is None:
        return 1
    if pulley in names[1:]:
        return names.index(pulley)
    message = "trims are relative to the first drive" if pulley in names else "no such pulley"
    there = ", ".join(map(shown, names[1:]))
    raise InputError(
        Problem(
            message=message,
            remedy=f"Choose one of {there}.",
            file=file,
            key="--drive",
            value=shown(pulley),
        )
    )


def _check_case(train: Train, name: str, file: str) -> None:
    with placed("--load-case", file):
        train.case(name)


def _quantity(option: str, text: str, dimension: Any) -> float:
    try:
        return parse_quantity(text, dimension)
    except InputError as error:
        problem = replace(error.problems[0], key=option, value=shown(text))
        raise InputError(problem) from None


def _wear(text: str, train: Train) -> float:
    depth = _quantity("--wear", text, "length")
    thickest = max(pulley.lagging.thickness for pulley in train.pulleys)
    if not 0.0 <= depth <= thickest:
        message = f"must be between 0 and the thickness of a lagging, {display(thickest, 'length')}"
        raise InputError(Problem(message=message, key="--wear", value=shown(text)))
    return depth


def _trim(text: str) -> float:
    return _quantity("--span", text, "number")


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
