"""A study over an event: every combination of values put over a drive file and followed in time."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.checks import judge_run
from wraparc.errors import InputError, shown
from wraparc.motion.file import load_motion
from wraparc.motion.follow import simulate
from wraparc.motion.linear import CALM, Linear
from wraparc.motion.result import RunResult
from wraparc.schema.kinds import Count, Name, Rows, Text
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import Report
from wraparc.schema.shared_keys import FORMAT_ENTRY
from wraparc.schema.source import Document, read_whole
from wraparc.schema.tables import Entry, Record, Table, need
from wraparc.study.keys import Raw
from wraparc.units import in_units
from wraparc.units.numbers import split_number

#: Designs of an event study at most: each is a march of seconds.
MOST_DESIGNS = 400
#: Level of a design that could not be followed.
REFUSED = "REFUSED"
#: Part of the run, at its end, that the swing of the pull is taken from.
_LAST = 0.25
#: Told the designs done and their number.
EventTell = Callable[[int, int], object]
_AXIS = Table(
    "Axis",
    need("field", "Key path in the drive file, as for --set.", Name(500), example='field = "..."'),
    Entry("values", "Each combined with all others.", Rows(Raw(), 1, MOST_DESIGNS)),
    Entry("from", "First value, with its unit.", Text(60)),
    Entry("to", "Last value, in the same unit.", Text(60)),
    Entry("count", "Values from the first to the last.", Count(2, MOST_DESIGNS)),
)
EVENT_STUDY = Table(
    "Study over an event",
    FORMAT_ENTRY,
    Entry("title", kind=Text()),
    Entry("description", kind=Text(5000, lines=True)),
    need("drive", "Drive file, relative to this one.", Name(1000), example='drive = "drive.toml"'),
    need("event", "The event that is followed.", Name(), example='event = "start"'),
    Entry("points", "Pieces of lagging on the shortest wrap; 40 if left out.", Count(10, 400)),
    Entry("set", "KEY=VALUE, put over the drive file.", Rows(Text(1000), 1, 200), title="Settings"),
    need("axis", "What is varied.", Rows(_AXIS, 1, 10), title="Axes", example="an [[axis]] table"),
)


@dataclass(frozen=True)
class EventStudy:
    """A study over an event.

    Attributes
    ----------
    title, drive, event
        What it is called, the drive file, the event that is followed.
    points
        Pieces of lagging on the shortest wrap.
    settings
        Put over the drive file of every design.
    fields, values
        Key paths that are varied, and the texts that each one takes.
    """

    title: str
    drive: str
    event: str
    points: int
    settings: tuple[str, ...]
    fields: tuple[str, ...]
    values: tuple[tuple[str, ...], ...]

    @property
    def designs(self) -> list[tuple[str, ...]]:
        """Every combination, the last axis fastest."""
        return list(itertools.product(*self.values))


@dataclass(frozen=True)
class EventRow:
    """What one design comes to; numbers are nan where it could not be followed.

    Attributes
    ----------
    values
        Of the axes.
    peak_creep, peak_tension, least_tension
        Largest exit creep of all drums [m], largest and least tension [N].
    swing
        Half the swing of the last drum's pull over its mean, in the last quarter of the run [-].
    friction_energy
        Friction work on all laggings [J].
    oscillation_frequency
        Of a vibration that grows by itself [Hz], 0 where none does.
    used, closest
        Part of its limit that the governing check uses [-], and its value, limit and place.
    level, label, text
        The worst check, the label of the verdict, and its sentence or why the design was refused.
    """

    values: tuple[str, ...]
    peak_creep: float = math.nan
    peak_tension: float = math.nan
    least_tension: float = math.nan
    swing: float = math.nan
    friction_energy: float = math.nan
    oscillation_frequency: float = math.nan
    used: float = math.nan
    closest: str = ""
    level: str = REFUSED
    label: str = "refused"
    text: str = ""

    @property
    def refused(self) -> bool:
        """Whether the design could not be followed."""
        return self.level == REFUSED


def load_event_study(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> EventStudy:
    """Return the study of a file that names an event.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, event_study_from_document, overrides, file_kind="study")


def event_study_from_document(
    document: Document, *, file: str = "", folder: str = ""
) -> EventStudy:
    """Return the study of a parsed file."""
    record, report = read_whole(EVENT_STUDY, document, file)
    axes = [(r["field"], _values(r, report)) for r in record["axis"]]
    report.raise_all()
    made = EventStudy(
        title=record.get("title", ""),
        drive=os.path.join(folder, record["drive"]),
        event=record["event"],
        points=record.get("points", 40),
        settings=tuple(record.get("set", ())),
        fields=tuple(field for field, _ in axes),
        values=tuple(values for _, values in axes),
    )
    if len(made.designs) > MOST_DESIGNS:
        message = f"{len(made.designs)} designs, more than {MOST_DESIGNS}: each is followed in time"
        report.add(("axis",), message, "Take fewer values.")
    if len({*made.fields}) < len(made.fields):
        report.add(("axis",), "a field is varied twice", "Remove one of them.")
    report.raise_all()
    load_motion(made.drive, overrides=made.settings).event(made.event)
    return made


def _values(record: Record, report: Report) -> tuple[str, ...]:
    """Return the texts that an axis takes."""
    ends = [key for key in ("from", "to", "count") if key in record]
    if ("values" in record) == bool(ends):
        report.add(record.place, "needs values, or from, to and count", "Write one of them.")
        return ()
    if "values" in record:
        return tuple(v if isinstance(v, str) else _plain(v) for v in record["values"])
    if len(ends) < 3:
        remedy = 'Write from = "10 s", to = "40 s", count = 4, for example.'
        report.add(record.place, "needs from, to and count", remedy)
        return ()
    try:
        (first, unit), (last, other) = (split_number(record[key]) for key in ("from", "to"))
    except InputError as error:
        report.take(error, record.place)
        return ()
    if unit != other:
        message = f"in another unit than from, {shown(record['from'])}"
        report.add((*record.place, "to"), message, "Write both in the same unit.", record["to"])
        return ()
    between = np.linspace(float(first), float(last), record["count"]).tolist()
    return tuple(f"{value:.6g} {unit}".strip() for value in between)


def _plain(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else f"{value}"


def follow_study(
    study: EventStudy, progress: EventTell | None = None, *, done: int = 0
) -> Iterator[EventRow]:
    """Yield a row for each design, in order; what is refused is a row too.

    Parameters
    ----------
    study
        What is followed.
    progress
        Called with the designs done and their number.
    done
        Designs to leave out: the first ones.
    """
    designs = study.designs
    for i, values in enumerate(designs[done:], start=done):
        if progress is not None:
            progress(i, len(designs))
        yield _followed(study, values)
    if progress is not None:
        progress(len(designs), len(designs))


def _followed(study: EventStudy, values: tuple[str, ...]) -> EventRow:
    over = [f"{field}={v}" for field, v in zip(study.fields, values, strict=True)]
    try:
        motion = load_motion(study.drive, overrides=[*study.settings, *over])
        run = simulate(motion.station, motion.event(study.event), points=study.points)
        root = Linear.of(motion.station).rightmost
    except InputError as error:
        return EventRow(values, text=str(error))
    return _row(values, run, root)


def _row(values: Sequence[str], run: RunResult, root: complex) -> EventRow:
    verdict = judge_run(run)
    late = run.time >= (1.0 - _LAST) * run.time[-1]
    pull = run.drums[-1].effective_tension[late]
    mean = abs(float(np.mean(pull)))
    return EventRow(
        tuple(values),
        peak_creep=run.peak_creep.value,
        peak_tension=run.peak_tension.value,
        least_tension=run.least_tension.value,
        swing=0.5 * float(np.ptp(pull)) / mean if mean > 0.0 else math.nan,
        friction_energy=math.fsum(d.friction_energy for d in run),
        oscillation_frequency=abs(root.imag) / (2.0 * math.pi) if root.real > CALM else 0.0,
        used=verdict.governing.used if verdict.governing else math.nan,
        closest=in_units(verdict.closest),
        level=str(verdict.level),
        label=verdict.label,
        text=in_units(verdict.text),
    )
