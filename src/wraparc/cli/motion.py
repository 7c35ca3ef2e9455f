"""``wraparc run`` and ``wraparc stability``: the drives of a file in time."""

from __future__ import annotations

import csv
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import click

from wraparc.checks import judge_run
from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import Content, deliver
from wraparc.cli.solve import FAILS, SOLVED, code_of
from wraparc.errors import InputError, MissingExtraError, Problem
from wraparc.motion.checkpoint import Checkpoint
from wraparc.motion.file import load_motion
from wraparc.motion.follow import simulate
from wraparc.motion.keeper import row_names
from wraparc.motion.result import Outcome, RunResult
from wraparc.motion.station import Station
from wraparc.saving import replacing
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
    with _Rows(motion.station, csv_file, parquet_file, goes_on=bool(state_file)) as rows:
        result = simulate(
            motion.station,
            chosen,
            step=None if step is None else _time("--step", step),
            points=points,
            every=None if every is None else _time("--every", every),
            sink=rows.take if rows.wanted else None,
            progress=None if quiet else _told(),
            checkpoint=Checkpoint(state_file, rows.resumed, rows.flush) if state_file else None,
        )
        if state_file and result.outcome is Outcome.CANCELLED:
            rows.later = True
            click.echo(f"The same command goes on from {state_file}.", err=True)
    written = [p for p in (csv_file, parquet_file) if p and p != "-" and not rows.later]
    files: dict[str, Content] = {}
    if plot_file:
        from wraparc.plot.motion import plot_run

        files[plot_file] = plot_run(result, units).save
    if csv_file != "-":
        deliver(files, lambda: _run_sheet(result, units))
    for path in written:
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


class _Rows:
    """Streams rows as they come, into drafts that take the places of the files at the end.

    The draft of a run that may go on later (`goes_on`) is FILE.part, which stays if it is broken
    off.
    """

    def __init__(
        self,
        station: Station,
        csv_file: str | None,
        parquet_file: str | None,
        *,
        goes_on: bool = False,
    ) -> None:
        self.goes_on, self.later = goes_on, False
        self.part: Any = None
        self.names = row_names(station)
        self.csv_file, self.parquet_file = csv_file, parquet_file
        self.block: list[Sequence[float]] = []
        self.stack = ExitStack()
        self.sinks: list[Callable[[list[Sequence[float]]], object]] = []

    def __enter__(self) -> _Rows:
        if self.csv_file == "-":
            self._csv(sys.stdout)
        elif self.csv_file and self.goes_on:
            path = Path(os.path.realpath(self.csv_file) + ".part")
            mode = "r+" if path.exists() else "w+"
            self.part = self.stack.enter_context(path.open(mode, encoding="utf-8", newline=""))
        elif self.csv_file:
            draft = self.stack.enter_context(replacing(Path(os.path.realpath(self.csv_file))))
            self._csv(self.stack.enter_context(draft.open("w", encoding="utf-8", newline="")))
        if self.parquet_file:
            self._parquet(Path(os.path.realpath(self.parquet_file)))
        return self

    def __exit__(self, *error: Any) -> None:
        if error[0] is None:
            self.flush()
        self.stack.__exit__(*error)
        if self.part is not None and error[0] is None and not self.later:
            os.replace(self.part.name, self.part.name.removesuffix(".part"))

    def resumed(self, rows: int) -> None:
        """Go on behind the rows that were streamed before."""
        if self.part is None:
            return
        kept = 0
        while kept < (rows + 1 if rows else 0) and self.part.readline():
            kept += 1
        if rows and kept < rows + 1:
            message = f"has {max(kept - 1, 0)} rows; the saved state follows on row {rows}"
            remedy = "Remove the saved state, and begin anew."
            raise InputError(
                Problem(key="--csv", value=self.part.name, message=message, remedy=remedy)
            )
        self.part.seek(self.part.tell())
        self.part.truncate()
        self._csv(self.part, head=not rows)

    @property
    def wanted(self) -> bool:
        return bool(self.sinks) or self.part is not None

    def take(self, row: Sequence[float]) -> None:
        self.block.append(row)
        if len(self.block) >= _BLOCK:
            self.flush()

    def flush(self) -> None:
        """Write what has come so far."""
        for sink in self.sinks if self.block else ():
            sink(self.block)
        self.block = []
        if self.part is not None:
            self.part.flush()

    def _csv(self, stream: Any, *, head: bool = True) -> None:
        writer = csv.writer(stream, lineterminator="\n")
        if head:
            writer.writerow(self.names)
        self.sinks.append(lambda rows: writer.writerows([f"{v:.10g}" for v in r] for r in rows))

    def _parquet(self, target: Path) -> None:
        try:
            import pyarrow as pa
            import pyarrow.parquet as pq
        except ImportError:
            raise MissingExtraError("pyarrow", "study") from None
        schema = pa.schema([(name, pa.float64()) for name in self.names])
        draft = self.stack.enter_context(replacing(target))
        writer = self.stack.enter_context(pq.ParquetWriter(draft, schema))

        def sink(rows: list[Sequence[float]]) -> None:
            columns = [pa.array([float(v) for v in c]) for c in zip(*rows, strict=True)]
            writer.write_table(pa.table(columns, schema=schema))

        self.sinks.append(sink)


def _run_sheet(result: RunResult, units: System) -> Any:
    from wraparc.present.motion_sheet import run_sheet

    return run_sheet(result, units)


def _told() -> Callable[[float], bool]:
    """Show progress on the error stream; an interruption ends the run and keeps it."""
    import signal
    import threading

    asked: list[bool] = []
    if threading.current_thread() is threading.main_thread():
        before = signal.getsignal(signal.SIGINT)

        def stop(*_: object) -> None:
            asked.append(True)
            signal.signal(signal.SIGINT, before)

        signal.signal(signal.SIGINT, stop)
    shows = sys.stderr.isatty()

    def progress(part: float) -> bool:
        if shows:
            sys.stderr.write(f"\r{100.0 * part:3.0f} %" + ("\r     \r" if part >= 0.999 else ""))
            sys.stderr.flush()
        return bool(asked)

    return progress


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
