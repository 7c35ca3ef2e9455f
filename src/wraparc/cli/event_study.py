"""``wraparc study`` of a file that names an event: each design is followed in time."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass

import click

from wraparc.cli.bar import bar
from wraparc.cli.options import check_outputs
from wraparc.cli.output import Content, deliver
from wraparc.cli.pipe import say
from wraparc.errors import InputError, Problem
from wraparc.saving import interrupted
from wraparc.study.event_rows import SUFFIXES, run_event_study
from wraparc.study.event_study import EventStudy, load_event_study
from wraparc.units import System


@dataclass(frozen=True)
class Wanted:
    """What a study over an event was asked to leave."""

    output: str | None
    json: str | None
    plot: str | None
    units: System
    resume: bool
    dry_run: bool


def over_an_event(file: str) -> bool:
    """Whether a study file follows an event in time."""
    from wraparc.schema.source import parse, read_text

    return "event" in parse(read_text(file), file)


def event_study(
    file: str, settings: tuple[str, ...], wanted: Wanted, spare: Mapping[str, object]
) -> int:
    """Follow an event for every design: rows to a file, a table on standard output."""
    from wraparc.plot.picture import SUFFIXES as PICTURES

    for option in (option for option, given in spare.items() if given):
        message = "is not for a study over an event"
        remedy = "It knows -o, --set, --units, --json, --plot, --resume and --dry-run."
        raise InputError(Problem(key=option, message=message, remedy=remedy))
    path = wanted.output or f"{os.path.splitext(os.path.basename(file))[0]}.csv"
    check_outputs(
        {
            "--output": (path, SUFFIXES),
            "--json": (wanted.json, (".json",)),
            "--plot": (wanted.plot, PICTURES),
        },
        [file],
    )
    asked = load_event_study(file, overrides=settings)
    if wanted.dry_run:
        say(f"{len(asked.designs)} designs, each followed through {asked.event}.")
        return 0
    if wanted.plot:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    _run(asked, path, wanted)
    return 0


def _run(asked: EventStudy, path: str, wanted: Wanted) -> None:
    from wraparc.present.document import json_text
    from wraparc.present.event_study_sheet import event_study_document, event_study_sheet

    with bar(len(asked.designs), "Following") as tell:
        rows = run_event_study(asked, path, resume=wanted.resume, progress=tell)
    click.echo(f"Wrote {path}", err=True)
    with interrupted(lambda: f"{path} is whole."):
        files: dict[str, Content] = {}
        if wanted.json:
            files[wanted.json] = json_text(event_study_document(asked, rows))
        if wanted.plot:
            from wraparc.plot.event_study import plot_event_study

            files[wanted.plot] = plot_event_study(asked, rows, wanted.units).save
        deliver(files, lambda: event_study_sheet(asked, rows, wanted.units))
