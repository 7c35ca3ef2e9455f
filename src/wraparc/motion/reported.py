"""What a calculation note says of drives in time; imports what that takes when it is asked for."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

from wraparc.schema.overrides import Overrides, read_document
from wraparc.schema.source import Document
from wraparc.train.keys import TRAIN_FILE

if TYPE_CHECKING:
    from wraparc.motion.file import Motion
    from wraparc.motion.result import RunResult
    from wraparc.motion.vibration import StabilityResult


@dataclass(frozen=True)
class InTime:
    """Drives in time, for a note.

    Attributes
    ----------
    stability
        Whether they pulsate.
    runs
        The events that the file wants in the note, followed.
    """

    stability: StabilityResult
    runs: tuple[RunResult, ...]


def asks(document: Document) -> bool:
    """Whether a drive file wants an event in its calculation note."""
    motion = document.get("motion")
    events = motion.get("event") if isinstance(motion, dict) else None
    rows = events if isinstance(events, list) else []
    return any(isinstance(e, dict) and e.get("report", False) is not False for e in rows)


def followed(motion: Motion, points: int = 60) -> InTime:
    """Follow the events that a file wants in its note.

    Parameters
    ----------
    motion
        Station and events.
    points
        Pieces of lagging on the shortest wrap.
    """
    from wraparc.motion.follow import simulate
    from wraparc.motion.vibration import stability

    runs = [simulate(motion.station, e, points=points) for e in motion.events if e.report]
    return InTime(stability(motion.station), tuple(runs))


def load_followed(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> InTime | None:
    """Return what the note of a drive file says of its drives in time; None if it asks nothing."""
    if not asks(read_document(path, overrides, TRAIN_FILE)):
        return None
    from wraparc.motion.file import load_motion

    return followed(load_motion(path, overrides=overrides))
