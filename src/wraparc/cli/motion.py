"""``wraparc run`` and ``wraparc stability``: the drives of a file in time."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import click

from wraparc.checks import judge_run
from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import STANDARD_OUTPUT, Content, deliver
from wraparc.cli.run_rows import streamed
from wraparc.cli.solve import FAILS, SOLVED, code_of
from wraparc.errors import InputError, Problem
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.file import load_motion
from wraparc.motion.follow import simulate
from wraparc.motion.result import Outcome, RunResult
from wraparc.saving import interrupted
from wraparc.units import System, parse_quantity

_PICTURES = (".svg", ".png", ".pdf")
#: Rows that are written at once.
_BLOCK = 1000


@click.command()
@click.argument("file", type=click.Path())
@click.option("--event", metavar="NAME", default="", help="Event; the first if not given.")
@click.option("--step", metavar="TIME", help='Time step, --step "5 ms"; chosen if not given.')
@click.option("--every", metavar="TIME", help="Time between the rows of files; every step if not.")
@click.option(
    "--points", type=click.IntRange(10, 2000), default=100, show_default=True,
    help="Pieces of lagging on the shortest wrap.",
)  # fmt: skip
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--csv", "csv_file", metavar="FILE", help="Stream every row as CSV.")
@click.option("--parquet", "parquet_file", metavar="FILE", help="Write every row as Parquet.")
@click.option("--plot", "plot_file", metavar="FILE", help="Draw the run: .svg, .png or .pdf.")
@click.option(
    "--checkpoint",
    "state_file",
    metavar="FILE",
    help="Save the state here now and then: the same command goes on from it.",
)
@click.option("--quiet", is_flag=True, help="Show no progress.")
def run(
    file: str,
    event: str,
    step: str | None,
    every: str | None,
    points: int,
    units: System,
    settings: tuple[str, ...],
    csv_file: str | None,
    parquet_file: str | None,
    plot_file: str | None,
    state_file: str | None,
    quiet: bool,
) -> int:
    """Follow the drives of FILE through an event: start, stop, load step, splice ...

    The file needs a [motion] table with the inertias and the events. Interrupt it (Ctrl-C), and
    what was computed so far is shown.
    """
    check_outputs(
        {
            "--csv": (csv_file, (".csv",)),
            "--parquet": (parquet_file, (".parquet",)),
            "--plot": (plot_file, _PICTURES),
            "--checkpoint": (state_file, (".npz",)),
        },
        [file],
    )
    if state_file and (parquet_file or csv_file == "-"):
        message = "rows of a run that goes on later can only be written to a file of --csv"
        raise InputError(Problem(key="--checkpoint", value=state_file, message=message))
    if plot_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    motion = load_motion(file, overrides=settings)
    chosen = motion.event(event)
    rows_to = streamed(motion.station, csv_file, parquet_file, state_file)
    with rows_to as rows, _followed(quiet=quiet) as progress:
        result = simulate(
            motion.station,
            chosen,
            step=None if step is None else _time("--step", step),
            points=points,
            every=None if every is None else _time("--every", every),
            sink=rows.take if rows.wanted else None,
            progress=progress,
            checkpoint=Checkpoint(state_file, rows.resumed, rows.flush) if state_file else None,
        )
        rows.cancelled = result.outcome is Outcome.CANCELLED
    files: dict[str, Content] = {}
    if plot_file and not rows.cancelled:
        from wraparc.plot.motion import plot_run

        files[plot_file] = plot_run(result, units).save
    deliver(files, None if csv_file == STANDARD_OUTPUT else lambda: _run_sheet(result, units))
    if rows.cancelled:
        with interrupted(lambda: rows.kept([plot_file] if plot_file else [])):
            raise KeyboardInterrupt
    for path in rows.drafts:
        click.echo(f"Wrote {path}", err=True)
    return code_of(judge_run(result).level)


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--run-out",
    metavar="LENGTH",
    default="0.5 mm",
    show_default=True,
    help="Amplitude to report on.",
)
@click.option("--map", "map_file", metavar="FILE", help="Draw a map over droop and inertia.")
@click.option(
    "--over", type=click.Choice(["droop", "coupling slip"]), default="droop", show_default=True,
    help="What is varied beside inertia.",
)  # fmt: skip
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--plot", "plot_file", metavar="FILE", help="Draw responses and controls.")
def stability(
    file: str,
    run_out: str,
    map_file: str | None,
    over: str,
    units: System,
    settings: tuple[str, ...],
    plot_file: str | None,
) -> int:
    """Show whether the drives of FILE pulsate, why, how much, and which control cures it."""
    from wraparc.motion.vibration import stability as found_by
    from wraparc.motion.vibration import stability_map

    check_outputs({"--map": (map_file, _PICTURES), "--plot": (plot_file, _PICTURES)}, [file])
    if plot_file or map_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    motion = load_motion(file, overrides=settings)
    result = found_by(motion.station, run_out=_length("--run-out", run_out))
    files: dict[str, Content] = {}
    if plot_file:
        from wraparc.plot.motion import plot_stability

        files[plot_file] = plot_stability(result, units).save
    if map_file:
        from wraparc.plot.motion import plot_stability_map

        files[map_file] = plot_stability_map(stability_map(motion.station, what=over)).save

    def sheet() -> Any:
        from wraparc.present.motion_sheet import stability_sheet

        return stability_sheet(result, units)

    deliver(files, sheet)
    return SOLVED if result.stable else FAILS


def _run_sheet(result: RunResult, units: System) -> Any:
    from wraparc.present.motion_sheet import run_sheet

    return run_sheet(result, units)


@contextmanager
def _followed(*, quiet: bool) -> Iterator[Callable[[float], bool]]:
    """Give what shows progress on the error stream; an interruption ends the run and keeps it."""
    import signal
    import threading

    asked: list[bool] = []
    mine = threading.current_thread() is threading.main_thread()
    before = signal.getsignal(signal.SIGINT) if mine else None

    def stop(*_: object) -> None:
        asked.append(True)
        signal.signal(signal.SIGINT, before)  # a second one ends it at once

    shows = sys.stderr.isatty() and not quiet

    def progress(part: float) -> bool:
        if shows:
            sys.stderr.write(f"\r{100.0 * part:3.0f} %" + ("\r     \r" if part >= 0.999 else ""))
            sys.stderr.flush()
        return bool(asked)

    try:
        if mine:
            signal.signal(signal.SIGINT, stop)
        yield progress
    finally:
        if mine:
            signal.signal(signal.SIGINT, before)


def _time(option: str, text: str) -> float:
    return _positive(option, text, "time")


def _length(option: str, text: str) -> float:
    return _positive(option, text, "length")


def _positive(option: str, text: str, dimension: Any) -> float:
    from dataclasses import replace

    from wraparc.errors import shown

    try:
        value = parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(replace(error.problems[0], key=option, value=shown(text))) from None
    if value <= 0.0:
        message = "must be more than 0"
        raise InputError(Problem(message=message, key=option, value=shown(text)))
    return value
