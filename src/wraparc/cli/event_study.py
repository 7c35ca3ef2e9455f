"""``wraparc study`` of a file that names an event: each design is followed in time."""

from __future__ import annotations

import os
from collections.abc import Mapping

import click

from wraparc.cli.answer import Answer
from wraparc.cli.bar import bar
from wraparc.cli.pipe import say
from wraparc.cli.solve import code_told
from wraparc.errors import input_error
from wraparc.saving import interrupted
from wraparc.study.event_rows import SUFFIXES, run_event_study
from wraparc.study.event_study import EventStudy, load_event_study


def over_an_event(file: str) -> bool:
    """Whether a study file follows an event in time."""
    from wraparc.schema.file_kinds import parse_kind

    return "event" in parse_kind(file, "study")


def event_study(
    answer: Answer,
    file: str,
    output: str | None,
    settings: tuple[str, ...],
    spare: Mapping[str, object],
    *,
    resume: bool,
    dry_run: bool,
) -> int:
    """Follow an event for every design: rows to a file, a table on standard output."""
    for option in (option for option, given in spare.items() if given):
        message = "not for a study over an event"
        remedy = f"Leave {option} out."
        raise input_error(key=option, message=message, remedy=remedy)
    path = output or f"{os.path.splitext(os.path.basename(file))[0]}.csv"
    answer.check([file], {"--output": (path, SUFFIXES)})
    asked = load_event_study(file, overrides=settings)
    if dry_run:
        say(f"{len(asked.designs)} designs, each followed through {asked.event}.")
        return 0
    return _run(asked, path, answer, resume=resume)


def _run(asked: EventStudy, path: str, answer: Answer, *, resume: bool) -> int:
    from wraparc.answer.event_study_sheet import event_study_document, event_study_sheet

    with bar(len(asked.designs), "Following", unit="designs") as tell:
        rows = run_event_study(asked, path, resume=resume, progress=tell)
    click.echo(f"Wrote {path}", err=True)
    with interrupted(lambda: f"{path} is whole."):
        if answer.paths["plot"]:
            from wraparc.plot.event_study import plot_event_study

            answer.write("plot", lambda: plot_event_study(asked, rows, answer.units).save)
        told = event_study_sheet(asked, rows)
        answer.give(lambda: told, lambda: event_study_document(asked, rows))
    return code_told(told)
