"""Drives in time: a run through an event thinned to be played, and whether the drives pulsate."""

import os
from typing import Any, Literal

import numpy as np

from wraparc.answer.motion_sheet import run_sheet, stability_sheet
from wraparc.checks import judge_run
from wraparc.drive.pitch import whole_thickness
from wraparc.motion import RunResult, simulate, stability, stability_map
from wraparc.motion.file import Motion, motion_from_document
from wraparc.motion.follow import check_event
from wraparc.plot.motion import plot_stability, plot_stability_map
from wraparc.units import positive_quantity
from wraparc.web.answers.documents import without_none
from wraparc.web.answers.shown import Answer, Bar, Numbers, Sheet, bars, rounded, sheet
from wraparc.web.asked import EventRequest
from wraparc.web.progress import tell

#: Parts that progress is told by; rows of the histories, frames and places over a wrap at most.
PARTS, _ROWS, _FRAMES, _PLACES = 100, 400, 180, 31
_USUAL = (
    "The file has no events: these are the usual ones, with ramps of 20 s up and 15 s down. "
    "Write [[motion.event]] tables for others."
)


class Named(Answer):
    """What a run is called."""

    title: str


class DrumPlayed(Answer):
    """One drum in time [SI]: histories by row, creep and shear over the wrap by frame."""

    name: str
    diameter: float
    wrap_angle: float
    belt_thickness: float | None
    creep_limit: float
    entry_tension: Numbers
    exit_tension: Numbers
    speed: Numbers
    torque: Numbers
    share: Numbers
    exit_creep: Numbers
    peak_shear: Numbers
    creep: list[Numbers]
    shear: list[Numbers]


class Played(Answer):
    """A run thinned to be played [SI]."""

    event: str
    outcome: Literal["whole", "slack", "breakaway", "turned-back", "cancelled"]
    duration: float
    time: Numbers
    travel: Numbers
    belt_speed: Numbers
    frame_time: Numbers
    drums: list[DrumPlayed]


class EventResult(Answer):
    """What came out: of a run, of the question whether the drives pulsate, or a map."""

    run: Sheet | None
    bars: list[Bar]
    stability: Sheet | None
    note: str
    played: Played | None
    pictures: dict[str, str]


def check(asked: EventRequest) -> Named:
    """Say what a run is called, or everything that is wrong with it."""
    motion = _motion(asked)
    positive_quantity(asked.run_out, "length", "run_out")
    if asked.what != "run":
        return Named(title="Is the drive stable?" if asked.what == "stability" else "Stability map")
    event = motion.event(asked.event or "")
    if asked.step is not None:
        positive_quantity(asked.step, "time", "step")
    check_event(motion.station, event)
    return Named(title=event.name)


def run(asked: EventRequest) -> EventResult:
    """Follow an event, or find whether the drives pulsate; tells of its progress."""
    if hasattr(os, "nice"):
        os.nice(10)  # others are served meanwhile
    motion = _motion(asked)
    tell(0, PARTS, "preparing")
    if asked.what == "map":
        found = stability_map(motion.station, what=asked.over)
        drawn = {"map": plot_stability_map(found)}
        return _result(motion, None, None, drawn)
    run_out = positive_quantity(asked.run_out, "length", "run_out")
    if asked.what == "stability":
        told = stability(motion.station, run_out=run_out)
        return _result(motion, None, told, {"stability": plot_stability(told)})
    followed = simulate(
        motion.station,
        motion.event(asked.event or ""),
        step=None if asked.step is None else positive_quantity(asked.step, "time", "step"),
        points=asked.points,
        progress=_follow,
    )
    tell(PARTS, PARTS, "looking for vibrations")
    told = stability(motion.station, run_out=run_out)
    return _result(motion, followed, told, {})


def _follow(part: float) -> None:
    tell(round(PARTS * part), PARTS, "following the event")


def _motion(asked: EventRequest) -> Motion:
    return motion_from_document(without_none(asked.document))


def _result(motion: Motion, followed: Any, told: Any, drawn: dict[str, Any]) -> EventResult:
    return EventResult(
        run=followed and Sheet(**sheet(run_sheet(followed))),
        bars=bars(judge_run(followed).listed) if followed else [],
        stability=told and Sheet(**sheet(stability_sheet(told))),
        note=_USUAL if motion.assumed else "",
        played=followed and played(followed),
        pictures={f"{n}.svg": p.to_bytes("svg").decode("utf-8") for n, p in drawn.items()},
    )


def played(run: RunResult) -> Played:
    """Return a run thinned to some hundred rows and frames; its largest values stay."""
    travel = np.concatenate(
        [[0.0], np.cumsum(0.5 * np.diff(run.time) * (run.belt_speed[1:] + run.belt_speed[:-1]))]
    )
    rows, frames = _rows_kept(run), _evenly(len(run.picture_time), _FRAMES)
    train = run.station.train
    drums = []
    for pulley, drum in zip(train.pulleys, run.drums, strict=True):
        kept = _evenly(len(drum.place), _PLACES)
        history = {
            name: rounded(getattr(drum, name)[rows], 5)
            for name in (
                "entry_tension", "exit_tension", "speed", "torque", "share", "exit_creep",
                "peak_shear",
            )
        }  # fmt: skip
        drums.append(
            DrumPlayed(
                name=pulley.name,
                diameter=pulley.diameter,
                wrap_angle=pulley.wrap_angle,
                belt_thickness=whole_thickness(train.belt),
                creep_limit=train.creep_limit_of(pulley),
                creep=rounded(drum.creep[frames][:, kept], 3),
                shear=rounded(drum.shear[frames][:, kept], 3),
                **history,
            )
        )
    return Played(
        event=run.event.name,
        outcome=run.outcome.name.lower().replace("_", "-"),
        duration=run.event.duration,
        time=rounded(run.time[rows], 6),
        travel=rounded(travel[rows], 6),
        belt_speed=rounded(run.belt_speed[rows], 5),
        frame_time=rounded(run.picture_time[frames], 6),
        drums=drums,
    )


def _evenly(count: int, most: int) -> Any:
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(int))


def _rows_kept(run: RunResult) -> Any:
    """Return rows evenly in time, and those of the least and largest of everything shown."""
    columns = [run.belt_speed]
    for d in run.drums:
        columns += [d.entry_tension, d.exit_tension, d.torque, d.exit_creep, d.peak_shear]
    ends = [f(column) for column in columns for f in (np.argmin, np.argmax)]
    return np.union1d(_evenly(len(run.time), _ROWS), np.array(ends, int))
