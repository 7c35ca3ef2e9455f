"""The ``[motion]`` table of a drive file to a station and its events."""

from __future__ import annotations

import csv
import os
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from wraparc.errors import InputError, Problem, input_error, name_remedy, shown
from wraparc.motion.control import Control, Droop, ExactSpeed, Follower
from wraparc.motion.event import Event, Happening, Measured, Start, Stop
from wraparc.motion.keys import CONTROL, DRUM, EVENT, HAPPENING, MOTION, TRIM
from wraparc.motion.station import Drum, Station
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import Report, place_text
from wraparc.schema.source import Document, parse, read_text
from wraparc.schema.tables import Record
from wraparc.train import Motor, Motors, TorqueFollower, Train, VariableSpeed
from wraparc.train.file import train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.units import parse_quantity

_WRITE = "Write a [motion] table with inertias and events."
#: What is followed where a file has no events.
USUAL_EVENTS = (
    Event(name="start", duration=40.0, happenings=(Start(time=20.0),)),
    Event(
        name="start and stop",
        duration=60.0,
        happenings=(Start(time=20.0), Stop(at=40.0, time=15.0)),
    ),
)
#: What decides the largest tension of a start and may be left out.
DECIDING = ("carry_run", "return_run")
_HEAD = re.compile(r"\s*(time|speed|torque)\s*\[([^\]]+)\]\s*", re.IGNORECASE)


@dataclass(frozen=True)
class Motion:
    """What a drive file says of its drives in time.

    Attributes
    ----------
    station
        What moves.
    events
        What may happen to it.
    assumed
        Whether the file has no events, and these are the usual ones.
    """

    station: Station
    events: tuple[Event, ...] = ()
    assumed: bool = False

    def event(self, name: str = "") -> Event:
        """Return the event of a name, the first without a name.

        Raises
        ------
        InputError
            If there is none, with those there are.
        """
        for event in self.events:
            if not name or event.name == name:
                return event
        names = [e.name for e in self.events]
        raise input_error(
            key="event", value=shown(name), message="no such event", remedy=name_remedy(name, names)
        )


def load_motion(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Motion:
    """Return station and events of a drive file with a ``[motion]`` table.

    Parameters
    ----------
    path, overrides, allow_paths
        As for `load_drive`; a measured record is a file too.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, motion_from_document, overrides, TRAIN_FILE, "drive", allow_paths=allow_paths)


def motion_from_text(text: str, *, file: str = "", folder: str = "") -> Motion:
    """Return station and events of the text of a drive file; paths are refused."""
    return motion_from_document(parse(text, file), file=file, folder=folder)


def motion_from_document(
    document: Document,
    *,
    file: str = "",
    folder: str = "",
    overrides: Overrides = (),
    allow_paths: bool = False,
) -> Motion:
    """Return station and events of a parsed drive file; the faults of both are told at once."""
    problems: list[Problem] = []
    train: Train | None = None
    try:
        train = train_from_document(
            document, file=file, folder=folder, overrides=overrides, allow_paths=allow_paths
        )
        problems += _between(train)
    except InputError as error:
        problems += error.problems
    report = Report(file)
    given = document.get("motion")
    if given is None and train is None:  # then nobody knows what its drums are called
        message = "missing"
        report.add(("motion",), message, _WRITE)
        record: Any = None
    else:  # every drum without an inertia is named
        record = MOTION.read({"drum": {}} if given is None else given, ("motion",), report)
    made = None
    if isinstance(record, Record):
        made = _Builder(record, train, folder if allow_paths else None, report).built()
    try:
        report.raise_all()
    except InputError as error:
        problems += error.problems
    if problems:
        raise InputError(problems)
    if made is None:  # pragma: no cover - something was reported then
        raise input_error(key="motion", message="could not be read", file=file)
    return made


def check_motion(document: Document, *, file: str = "") -> None:
    """Read the ``[motion]`` table of a document, for doors that do not use it.

    Raises
    ------
    InputError
        With everything that is wrong in it by itself.
    """
    if "motion" in document:
        report = Report(file)
        MOTION.read(document["motion"], ("motion",), report)
        report.raise_all()


class _Builder:
    def __init__(
        self, record: Record, train: Train | None, folder: str | None, report: Report
    ) -> None:
        self.record, self.train, self.folder, self.report = record, train, folder, report

    def built(self) -> Motion | None:
        """Return everything, or None after reporting."""
        events = [self._event(e) for e in self.record.get("event") or () if isinstance(e, Record)]
        if self.train is None:
            return None
        drums = self._drums(self.train)
        if drums is None or not self.record.sound() or None in events:
            return None
        taken = tuple(key for key in DECIDING if key not in self.record)
        station = MOTION.built(self.record, self.report, train=self.train, drums=drums, taken=taken)
        if station is None:
            return None
        made = tuple(e for e in events if e is not None)
        return Motion(station, made or USUAL_EVENTS, assumed=not made)

    def _drums(self, train: Train) -> tuple[Drum, ...] | None:
        tables, names = self.record.get("drum"), [p.name for p in train.pulleys]
        if not isinstance(tables, dict):
            return None
        for name in (n for n in tables if n not in names):
            place = ("motion", "drum", name)
            self.report.add(place, "no such pulley", name_remedy(name, names))
        missing = [n for n in names if n not in tables]
        for name in missing:
            remedy = f'Write [{place_text(("motion", "drum", name))}] with inertia = "2200 kg m2".'
            self.report.add(("motion", "drum", name, "inertia"), "missing", remedy)
        found = [self._drum(n, tables[n], train) for n in names if n in tables]
        made = tuple(d for d in found if d is not None)
        return made if len(made) == len(names) else None

    def _drum(self, name: str, record: Any, train: Train) -> Drum | None:
        if not isinstance(record, Record):
            return None
        more: dict[str, Any] = {}
        if "control" in record:
            control = CONTROL.built(record["control"], self.report)
            if control is None:
                return None
            more["control"] = control
        else:
            own = _of_train(train, name)
            if own is not None:
                more["control"] = own
        if "trim" in record:
            more["trim"] = TRIM.built(record["trim"], self.report)
            if more["trim"] is None:
                return None
        if record.sound():
            more["inertia"] = record["inertia"] + self._geared(name, record, train)
        drum: Drum | None = DRUM.built(record, self.report, **more)
        return drum

    def _geared(self, name: str, record: Record, train: Train) -> float:
        """Return the inertia of the motors as seen at the drum shaft, J i^2 [kg m2]."""
        inertia, ratio = record.get("motor_inertia"), record.get("gear_ratio")
        if inertia is None:
            if ratio is not None:
                message = "needs motor_inertia"
                self.report.add((*record.place, "gear_ratio"), message, "Give motor_inertia too.")
            return 0.0
        motor = _motor_of(train, name)
        if ratio is None and isinstance(motor, Motor):
            ratio = motor.gear_ratio
        if ratio is None:
            remedy = "Write gear_ratio = 25, motor over pulley speed."
            self.report.add(
                (*record.place, "gear_ratio"), "missing: motor_inertia needs it", remedy
            )
            return 0.0
        return float(inertia * ratio**2)

    def _event(self, record: Record) -> Event | None:
        happenings = [
            self._happening(h) for h in record.get("happens") or () if isinstance(h, Record)
        ]
        if None in happenings or not record.sound():
            return None
        event: Event | None = EVENT.built(
            record, self.report, happenings=tuple(h for h in happenings if h is not None)
        )
        return event

    def _happening(self, record: Record) -> Happening | None:
        if not record.sound():
            return None
        more: dict[str, Any] = {}
        if record["kind"] == "emergency-stop":
            more["brakes"] = True
        if record["kind"] == "measured":
            return self._measured(record)
        made: Happening | None = HAPPENING.built(record, self.report, **more)
        return made

    def _measured(self, record: Record) -> Measured | None:
        key = "record" if "record" in record else "file"
        place, pulley, at = (*record.place, key), record["pulley"], record.get("at", 0.0)
        if len({"record", "file"} & {*record}) != 1:
            message = "must be either file or record"
            self.report.add(place, message, 'Write file = "record.csv", for example.')
            return None
        if key == "file" and self.folder is None:
            message = "cannot be a path here"
            remedy = "Put its lines into record."
            self.report.add(place, message, remedy, record["file"])
            return None
        try:
            if key == "record":
                return parse_record(record["record"], pulley, at=at)
            return read_record(Path(str(self.folder)) / record["file"], pulley, at=at)
        except InputError as error:
            self.report.take(error, place)
            return None


def _between(train: Train) -> list[Problem]:
    """Report a take-up between drives: a station has its own behind the last one."""
    after = train.criteria.take_up.after
    if after in ("", train.pulleys[-1].name):
        return []
    message = "must be the last drive for events"
    remedy = "Leave it out."
    return [Problem(key="take_up.after", value=shown(after), message=message, remedy=remedy)]


def _motor_of(train: Train, name: str) -> Motor | TorqueFollower | None:
    """Return what turns a pulley in the train, if that is given."""
    division = train.cases[0].division
    if not isinstance(division, Motors):
        return None
    return division.motors[[p.name for p in train.pulleys].index(name)]


def _of_train(train: Train, name: str) -> Control | None:
    """Return the control that a motor of the train stands for."""
    motor = _motor_of(train, name)
    if isinstance(motor, TorqueFollower):
        return Follower(master=motor.master, ratio=motor.ratio)
    if isinstance(motor, VariableSpeed):
        rating = motor.drum_torque
        if motor.droop == 0.0:
            return ExactSpeed(rated_torque=rating)
        limit = min(motor.torque_limit, 100.0)
        return Droop(droop=motor.droop, torque_limit=limit, rated_torque=rating)
    return None


def read_record(path: str | os.PathLike[str], pulley: str, *, at: float = 0.0) -> Measured:
    """Read a measured record: a CSV with ``time [s]`` and ``speed [rpm]`` or ``torque [kN m]``.

    Parameters
    ----------
    path
        Of the file.
    pulley
        The drum that was measured.
    at
        When the record begins in the event [s].

    Raises
    ------
    InputError
        If columns, units or values are missing.
    """
    return parse_record(read_text(path), pulley, at=at, file=os.fspath(path))


def parse_record(text: str, pulley: str, *, at: float = 0.0, file: str = "") -> Measured:
    """Read the lines of a measured record; see `read_record`."""
    rows = [r for r in csv.reader(text.splitlines()) if any(c.strip() for c in r)]
    heads = [_HEAD.fullmatch(cell) for cell in rows[0]] if rows else []
    names = [h[1].lower() if h else "" for h in heads]
    if len(names) != 2 or names[0] != "time" or names[1] not in ("speed", "torque"):
        message = "must name both columns with their units"
        remedy = "Write time [s],speed [rpm] or time [s],torque [kN m]."
        raise input_error(message=message, remedy=remedy, file=file, line=1)
    units = [h[2] for h in heads if h]
    dimension: Any = "rotation_speed" if names[1] == "speed" else "torque"
    times, values = [], []
    for line, row in enumerate(rows[1:], start=2):
        if len(row) != 2 or not all(cell.strip() for cell in row):
            message = "a value is missing"
            remedy = "Cut the record before the gap."
            raise input_error(message=message, remedy=remedy, file=file, line=line)
        try:
            times.append(parse_quantity(f"{row[0].strip()} {units[0]}", "time"))
            values.append(parse_quantity(f"{row[1].strip()} {units[1]}", dimension))
        except InputError as error:
            raise InputError(replace(error.problems[0], file=file, line=line)) from None
    what: Any = names[1]
    return Measured(pulley=pulley, at=at, times=tuple(times), values=tuple(values), what=what)
