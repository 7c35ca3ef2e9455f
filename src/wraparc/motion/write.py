"""A station and its events to a ``[motion]`` table that reads back equal."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from typing import Any

from wraparc.errors import input_error
from wraparc.motion.event import Event, Happening, Measured, OnBelt, OnDrum, PowerFailure
from wraparc.motion.file import Motion
from wraparc.motion.keys import CONTROL, DRUM, EVENT, HAPPENING, MOTION
from wraparc.motion.station import Drum
from wraparc.schema.emit import document_text
from wraparc.schema.tables import Entry, Table

Tables = dict[str, Any]

_FILE = Table("Motion", Entry("motion", "Drives in time.", MOTION))
#: What a happening of one class is called, by the keys that say something.
_WORDS: dict[type[Happening], dict[str, tuple[str, ...]]] = {
    OnBelt: {"wet-patch": ("friction",), "splice": ("rise", "compliance")},
    OnDrum: {
        "run-out": ("run_out",),
        "lagging-joints": ("joint_rise",),
        "torque-ripple": ("ripple",),
    },
}


def motion_text(motion: Motion) -> str:
    """Return the text of a ``[motion]`` table, to stand in the file of its drive.

    It reads back as this station and these events. One thing that is a wet patch and a splice, or
    run-out and ripple, at once becomes two that together do the same.

    Raises
    ------
    InputError
        If nothing happens in an event.
    """
    return document_text(motion_document(motion), _FILE)


def motion_document(motion: Motion) -> Tables:
    """Return the ``[motion]`` table of a document; see `motion_text`."""
    station = motion.station
    drums = {n: _drum(d) for n, d in zip(station.names, station.drums, strict=True)}
    # the usual events of a file that has none are not written
    events = [] if motion.assumed else [_event(e) for e in motion.events]
    return {"motion": MOTION.written(station, drum=drums, event=events or None)}


def _drum(drum: Drum) -> Tables:
    # without a control the drum has that of its motor in the train
    return DRUM.written(drum, control=CONTROL.written(drum.control))


def _event(event: Event) -> Tables:
    happens = [row for h in event.happenings for row in _happenings(h)]
    if not happens:
        message = "an event in which nothing happens cannot stand in a file"
        raise input_error(key="event", value=f'"{event.name}"', message=message)
    return EVENT.written(event, happens=happens)


def _happenings(happening: Happening) -> Iterator[Tables]:
    if isinstance(happening, Measured):
        yield _row("measured", happening, record=_record(happening), file=None)
    elif isinstance(happening, PowerFailure):
        yield _row("emergency-stop" if happening.brakes else "power-failure", happening)
    elif type(happening) in _WORDS:
        words = _WORDS[type(happening)]
        usual = {f.name: f.default for f in fields(happening)}
        said = [
            word
            for word, keys in words.items()
            if any(getattr(happening, key) != usual[key] for key in keys)
        ]
        for word in said or list(words)[-1:]:
            yield _row(word, happening)
    else:
        yield HAPPENING.written(happening)


def _row(word: str, happening: Happening, **instead: Any) -> Tables:
    table = HAPPENING.tables[word]
    return {HAPPENING.tag: word, **table.written(happening, **{HAPPENING.tag: None}, **instead)}


def _record(record: Measured) -> str:
    unit = "speed [rad/s]" if record.what == "speed" else "torque [N m]"
    pairs = zip(record.times, record.values, strict=True)
    return "\n".join([f"time [s],{unit}", *(f"{t!r},{v!r}" for t, v in pairs)])
