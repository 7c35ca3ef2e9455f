"""``wraparc run`` and ``wraparc stability``: the drives of a file in time."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import positive
from wraparc.cli.output import STANDARD_OUTPUT, Content
from wraparc.cli.run_rows import streamed
from wraparc.cli.solve import code_told
from wraparc.errors import input_error, shown
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.file import load_motion
from wraparc.motion.follow import simulate
from wraparc.motion.result import Outcome, RunResult
from wraparc.saving import interrupted
from wraparc.units import System


@click.command()
@click.option("--event", metavar="NAME", default="", help="Event; the first if left out.")
@click.option("--step", metavar="TIME", help='Time step, --step "5 ms"; chosen if left out.')
@click.option("--every", metavar="TIME", help="Time between rows of files; every step if left out.")
@click.option(
    "--points", type=click.IntRange(10, 2000), default=100, show_default=True,
    help="Pieces of lagging on the shortest wrap.",
)  # fmt: skip
@click.option("--quiet", is_flag=True, help="Show no progress.")
@answers(
    "event",
    "drums",
    "checks",
    json="",
    csv="Stream every row as CSV.",
    parquet="Write every row as Parquet.",
    plot="Draw the run: .svg, .png or .pdf.",
    checkpoint="Write checkpoints here; rerun to resume.",
)
def run(
    answer: Answer,
    file: str,
    event: str,
    step: str | None,
    every: str | None,
    points: int,
    settings: tuple[str, ...],
    quiet: bool,
) -> int:
    """Simulate the drives of FILE through an event: start, stop, load step, splice ...

    The file needs a [motion] table with inertias and events. Ctrl-C ends the run and shows what was
    computed so far.
    """
    from wraparc.answer.motion_sheet import run_document, run_sheet

    csv_file, parquet_file, plot_file, state_file = map(
        answer.paths.get, ("csv", "parquet", "plot", "checkpoint")
    )
    if state_file and (parquet_file or csv_file == STANDARD_OUTPUT):
        message = "a run resumed later writes its rows to a CSV file"
        remedy = "Give --csv FILE."
        raise input_error(
            key="--checkpoint", value=shown(state_file), message=message, remedy=remedy
        )
    motion = load_motion(file, overrides=settings)
    chosen = motion.event(event)
    rows_to = streamed(motion.station, csv_file, parquet_file, state_file)
    with rows_to as rows, _followed(quiet=quiet) as progress:
        result = simulate(
            motion.station,
            chosen,
            step=positive("--step", step, "time"),
            points=points,
            every=positive("--every", every, "time"),
            sink=rows.take if rows.wanted else None,
            progress=progress,
            checkpoint=Checkpoint(state_file, rows.resumed, rows.flush) if state_file else None,
        )
        rows.cancelled = result.outcome is Outcome.CANCELLED
    if not rows.cancelled:
        answer.write("plot", lambda: _picture(result, answer.units))
    printed = csv_file == STANDARD_OUTPUT
    told = run_sheet(result)
    answer.give(lambda: told, lambda: run_document(result), shows=not printed)
    if rows.cancelled:
        with interrupted(lambda: rows.kept([plot_file] if plot_file else [])):
            raise KeyboardInterrupt
    for path in rows.drafts:
        click.echo(f"Wrote {path}", err=True)
    return code_told(told)


@click.command()
@click.option(
    "--run-out",
    metavar="LENGTH",
    default="0.5 mm",
    show_default=True,
    help="Amplitude of the run-out.",
)
@click.option(
    "--over", type=click.Choice(["droop", "coupling slip"]), default="droop", show_default=True,
    help="What is varied beside inertia.",
)  # fmt: skip
@answers(
    "vibrations",
    "controls",
    json="",
    map="Draw a map over droop and inertia.",
    plot="Draw responses and controls.",
)
def stability(answer: Answer, file: str, run_out: str, over: str, settings: tuple[str, ...]) -> int:
    """Check the drives of FILE for self-excited oscillation: cause, size, and what cures it."""
    from wraparc.answer.motion_sheet import stability_document, stability_sheet
    from wraparc.motion.vibration import stability as found_by
    from wraparc.motion.vibration import stability_map

    motion = load_motion(file, overrides=settings)
    result = found_by(motion.station, run_out=positive("--run-out", run_out, "length") or 0.0)
    if answer.paths["plot"] or answer.paths["map"]:
        from wraparc.plot.motion import plot_stability, plot_stability_map

        answer.write("plot", lambda: plot_stability(result, answer.units).save)
        answer.write(
            "map", lambda: plot_stability_map(stability_map(motion.station, what=over)).save
        )
    told = stability_sheet(result)
    answer.give(lambda: told, lambda: stability_document(result))
    return code_told(told)


def _picture(result: RunResult, units: System) -> Content:
    from wraparc.plot.motion import plot_run

    return plot_run(result, units).save


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
