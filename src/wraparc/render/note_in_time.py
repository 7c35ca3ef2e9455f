"""The section of a calculation note on drives in time, and what it adds to the verdict."""

from dataclasses import replace
from functools import partial

from wraparc.answer.motion_sheet import run_sheet, run_tables, stability_sheet
from wraparc.answer.sheet import Also, Table, Verdict, named, quantity
from wraparc.answer.words import format_verdict, under
from wraparc.checks import Level, judge_run
from wraparc.checks import Verdict as Judgement
from wraparc.motion.reported import InTime
from wraparc.motion.result import RunResult
from wraparc.plot.motion import plot_run, plot_stability
from wraparc.render.drawings import Drawing


def judged_with(before: Judgement, in_time: InTime) -> Judgement:
    """Return the checks of the drive with those that only its events can miss."""
    more = (c for run in in_time.runs for c in judge_run(run).checks if c.place.event)
    return Judgement((*before.checks, *more))


def told_with(before: Verdict, in_time: InTime) -> Verdict:
    """Return the answer; an event that is worse than everything else leads it."""
    found = [format_verdict(judge_run(run)) for run in in_time.runs]
    worst = max(found, key=lambda v: v.level.rank, default=None)
    if worst is None:
        return before
    if worst.level.rank > before.level.rank:
        return under(worst, before)
    missed = worst.level.rank > Level.OK.rank
    also = (Also(worst.level, worst.text, worst.check), *worst.also) if missed else ()
    return replace(before, also=(*before.also, *also))


def section(in_time: InTime) -> tuple[tuple[str, ...], tuple[Table, ...], tuple[Drawing, ...]]:
    """Return what each event comes to, and whether the drives pulsate: words, tables, pictures."""
    vibrations = stability_sheet(in_time.stability)
    sheets = [run_sheet(run) for run in in_time.runs]
    sentences = []
    for name, sheet in (
        *((run.event.name, sheet) for run, sheet in zip(in_time.runs, sheets, strict=True)),
        ("Is the drive stable?", vibrations),
    ):
        if sheet.verdict is not None:
            said = (sheet.verdict.text, *sheet.verdict.sentences)
            sentences.append(f"{name}{'' if name.endswith('?') else ':'} {' '.join(said)}")
    tables = [
        replace(table, title=f"{table.title}: {run.event.name}")
        for run in in_time.runs
        for table in run_tables(run)
    ]
    drawings = (
        *(_run_drawing(run) for run in in_time.runs[:1]),
        _stability_drawing(in_time),
    )
    return (*sentences, *vibrations.remarks), (*tables, *vibrations.tables), drawings


def _run_drawing(run: RunResult) -> Drawing:
    peak, tension = run.peak_creep, run.peak_tension
    alt = (
        f"Speed, tensions, Te and creep over time, and creep over the wraps. The peak creep, "
        f"{named('exit_creep', peak.value)}, comes at {peak.place} after "
        f"{quantity(peak.time, 'time')}; the peak tension, "
        f"{named('entry_tension', tension.value)}, {tension.place}."
    )
    return Drawing(partial(plot_run, run), f"Event {run.event.name}.", alt)


def _stability_drawing(in_time: InTime) -> Drawing:
    found = in_time.stability
    alt = (
        "Response of Te and creep to run-out of the last pulley over frequency, and other "
        "controls; the table has the numbers."
    )
    caption = f"Run-out of {named('exit_creep', found.run_out)}: answer by frequency."
    return Drawing(partial(plot_stability, found), caption, alt)
