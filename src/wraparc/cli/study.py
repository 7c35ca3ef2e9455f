"""``wraparc study``: many variants of a drive, by a study file."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.bar import bar
from wraparc.cli.pipe import say
from wraparc.cli.solve import code_told
from wraparc.saving import interrupted

if TYPE_CHECKING:
    from wraparc.study.executor import Executor
    from wraparc.study.file import StudyFile
    from wraparc.study.parameter_study import Study

_DONE = 0


@click.command()
@click.option(
    "-o",
    "--output",
    metavar="FILE",
    help="Results, Parquet, of a study over an event CSV or Parquet; by default the name of the "
    "study file with .parquet or .csv.",
)
@click.option(
    "--setting",
    type=click.Choice(["engineering", "precise"]),
    help="Accuracy, instead of that of the file.",
)
@click.option("--threads", type=click.IntRange(1, 1024), help="One for each processor if left out.")
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Solve on a Dask cluster: tcp://host:8786; local or local:4 starts processes here.",
)
@click.option(
    "--part",
    type=click.IntRange(1, 10_000_000),
    metavar="DESIGNS",
    help="Designs solved at once by a thread or worker; by default what takes some 0.3 s.",
)
@click.option("--resume", is_flag=True, help="Finish a run that was interrupted.")
@click.option(
    "--confirm", type=int, metavar="ROWS", help="Run a large study; its number of rows confirms it."
)
@click.option(
    "--dry-run", is_flag=True, help="Check everything, show size and time; solve a sample alone."
)
@answers(
    "groups", "together", "convergence", "indices", "alone", "varied", "designs", checked=False,
    json="Write the summary as JSON; - prints it.", plot="Draw the summary.",
    report="Write summary and pictures as HTML.",
)  # fmt: skip
def study(
    answer: Answer,
    file: str,
    output: str | None,
    settings: tuple[str, ...],
    setting: str | None,
    threads: int | None,
    scheduler: str | None,
    part: int | None,
    resume: bool,
    confirm: int | None,
    dry_run: bool,
) -> int:
    """Solve a study FILE: grid, random samples, load cases, Monte Carlo or sensitivity.

    Results are written to a Parquet file as they are solved. Ctrl-C leaves them intact; --resume
    continues.
    """
    from wraparc.cli.event_study import event_study, over_an_event

    if over_an_event(file):
        spare = {
            "--setting": setting, "--threads": threads, "--scheduler": scheduler, "--part": part,
            "--confirm": confirm, "--report": answer.paths["report"],
        }  # fmt: skip
        return event_study(answer, file, output, settings, spare, resume=resume, dry_run=dry_run)
    from wraparc.study.executor import Threads, executor_named
    from wraparc.study.file import load_study
    from wraparc.study.run import Run, run_study

    answer.check([file])
    over = (*settings, *([f"setting={setting}"] if setting else []))
    asked = load_study(file, overrides=over)
    path = output or f"{os.path.splitext(os.path.basename(file))[0]}.parquet"
    executor: Executor = executor_named(scheduler) if scheduler else Threads(threads)
    if dry_run:
        say(f"{_size(asked.study)} {_time(asked.study, executor)}")
        return _DONE
    with bar(len(asked.study.plan), "Solving", len(asked.study.cases)) as tell:
        how = Run(
            executor=executor,
            part_designs=part,
            resume=resume,
            confirmed_rows=confirm,
            progress=tell,
        )
        run_study(asked.study, path, how)
    click.echo(f"Wrote {path}", err=True)
    with interrupted(lambda: f"{path} is whole."):
        return _tell(asked, path, answer)


def _size(asked: Study) -> str:
    from wraparc.study.parquet import schema_of
    from wraparc.study.run import part_designs

    columns = len(schema_of(asked).names)
    size = asked.rows * columns * 8
    return (
        f"{len(asked.plan):,} designs in {len(asked.cases)} cases: {asked.rows:,} rows of "
        f"{columns} columns, at most {size / 1e6:,.1f} MB, in parts of {part_designs(asked):,} "
        "designs."
    )


def _time(asked: Study, executor: Executor) -> str:
    from wraparc.study.executor import Threads
    from wraparc.study.run import expected_time

    workers = executor.workers if isinstance(executor, Threads) else 1
    minutes = expected_time(asked) / 60.0 / workers
    about = "Less than 0.1" if minutes < 0.1 else f"About {minutes:,.1f}"
    on = "1 processor" if workers == 1 else f"{workers} processors"
    return f"{about} minutes on {on}."


def _tell(asked: StudyFile, path: str, answer: Answer) -> int:
    from wraparc.answer.study_document import study_document
    from wraparc.answer.study_sheet import study_sheet
    from wraparc.render.page import study_page
    from wraparc.study.monte_carlo import summarise
    from wraparc.study.sensitivity import sensitivities

    summary = summarise(path)
    local, indices = sensitivities(path, asked.study, asked.sensitivity)
    dimensions = asked.study.plan.quantities
    sheet = study_sheet(
        summary,
        dimensions,
        local=local,
        indices=indices,
        remarks=asked.remarks,
        sources=asked.sources,
    )
    if answer.paths["plot"] or answer.paths["report"]:
        from wraparc.plot.study import study_pictures

        drawn = study_pictures(summary, local, indices, dimensions, answer.units)
        pictures = list(drawn.values())
        svg = [p.to_bytes("svg").decode("utf-8") for p in pictures]
        answer.write("plot", lambda: pictures[0].save)
        answer.write("report", lambda: study_page(sheet, svg, summary, answer.units))
    answer.give(lambda: sheet, lambda: study_document(summary, local=local, indices=indices))
    return code_told(sheet)
