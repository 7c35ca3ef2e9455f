"""Learn files: which logs, which tag is what, the take-up, how wrong each may be."""

from __future__ import annotations

import datetime as dt
import os
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from glob import glob
from typing import Any

from wraparc.drive import Drive, Limit
from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.files.conditions import refuse_several
from wraparc.learn.errors import ERROR_KINDS, LogErrors
from wraparc.schema.kinds import Choice, Kind, Name, OneOrMore, Percent, Quantity, Rows, Text
from wraparc.schema.overrides import Overrides, load, put_over
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import FORMAT_ENTRY
from wraparc.schema.source import Document, read_tables
from wraparc.schema.tables import Entry, Record, Table, need
from wraparc.train import Train
from wraparc.train.file import load_drive_or_train
from wraparc.train.motors import Motor
from wraparc.train.train import Motors

_PLACES = ("tail", "slack", "entry")
_KINDS = ("gravity", "fixed", "winch")
_EVENTS = ("relagged", "wheel", "belt", "take-up")
_TORQUE = Quantity("torque", Limit("torque", open=True))
_TAG = Name(200)


class _Day(Kind):
    """A day, as TOML writes it or as text."""

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return the day in seconds since 1970."""
        try:
            day = raw if isinstance(raw, dt.date) else dt.date.fromisoformat(str(raw)[:10])
        except ValueError:
            report.add(place, "must be a day", "Write for example 2026-04-02.", raw)
            return NOTHING
        return 86400.0 * (dt.date(day.year, day.month, day.day) - dt.date(1970, 1, 1)).days

    def schema(self) -> dict[str, Any]:
        """A day as text."""
        return {"type": "string", "format": "date"}


BELT_SPEED = Table(
    "Belt speed",
    Entry("column", "Name of the tag; recognised by its words if left out.", _TAG),
    Entry("unit", "Where the log has none.", Text(20)),
    Entry("at", "Tension of the belt at the wheel; tail if left out.", Choice(_PLACES)),
)
PULLEY = Table(
    "Pulley",
    need("name", "Of the drive file.", Name()),
    Entry("speed", "Name of the tag of the motor speed.", _TAG),
    Entry("speed_unit", "Where the log has none.", Text(20)),
    Entry(
        "speed_is", "estimated by the converter if left out.", Choice(("encoder", "estimated"))
    ),
    Entry(
        "gear_ratio", "Motor speed over pulley speed.",
        Quantity("number", Limit("number", open=True, most=1e4)),
    ),
    Entry("torque", "Name of the tag of the motor torque or power.", _TAG),
    Entry("torque_unit", "Where the log has none.", Text(20)),
    Entry("rated_torque", "Of one motor: what 100 % of torque is.", _TORQUE),
    Entry("motors", "Equal motors on the pulley; 1 if left out.",
          Quantity("number", Limit("number", least=1.0, most=8.0))),
    Entry("current", "Currents in A, rising, where torque is logged as current.",
          Rows(Quantity("number", Limit("number")), 2, 50)),
    Entry("current_torque", "Torque of the motor at each of them.",
          Rows(Quantity("torque", Limit("torque")), 2, 50)),
)  # fmt: skip
TAKE_UP = Table(
    "Take-up",
    Entry("kind", "fixed: T2 falls as Te rises. gravity if left out.", Choice(_KINDS)),
    Entry("tension", "Name of the tag of its tension, where one is measured.", _TAG),
)
EVENT = Table(
    "Event",
    need("when", "Day.", _Day(), example="when = 2026-04-02"),
    need("what", "What was changed.", Choice(_EVENTS)),
)
ERRORS = Table(
    "Standard deviations of the errors of the log; each left out is assumed",
    *(Entry(key, kind.meaning, Percent(1.0)) for key, kind in ERROR_KINDS.items()),
)
LEARN = Table(
    "Learn file",
    FORMAT_ENTRY,
    Entry("title", kind=Text()),
    need("drive", "Drive file, relative to this one.", Name(1000)),
    need("files", "Logs, relative to this one.", OneOrMore(Name(1000)),
         example='files = ["trend.csv"]'),
    Entry("time", "Name of the column of clock times.", _TAG),
    Entry("dates", "Where the dates do not prove it.", Choice(("day first", "month first"))),
    Entry("zone", "Of times without an offset, Europe/Berlin.", Text(60)),
    Entry("between", "Between two readings the last one is valid.", Choice(("hold",))),
    Entry("belt_speed", kind=BELT_SPEED, title="Belt speed"),
    Entry("pulley", "The pulleys that the log has.", Rows(PULLEY, 1, 2), title="Pulleys"),
    Entry("take_up", kind=TAKE_UP, title="Take-up"),
    Entry("errors", "How wrong the log may be.", ERRORS),
    Entry("event", "What was changed on the drive.", Rows(EVENT, 0, 20), title="Events"),
)  # fmt: skip


@dataclass(frozen=True)
class Event:
    """What was changed on the drive, and when [s since 1970]."""

    when: float
    what: str


@dataclass(frozen=True, kw_only=True)
class TagChoice:
    """Which tags of the log a pulley has, and what turns it.

    Attributes
    ----------
    pulley
        Name in the drive file.
    speed, torque
        Names of its tags; empty where they are to be found.
    speed_unit, torque_unit
        Where the log has none.
    is_estimated
        Whether the converter estimates the speed.
    gear_ratio
        Motor speed over pulley speed [-], None where it is not known.
    gear_efficiency
        Power out over power in [-].
    rated_torque
        Of one motor [N m], None where it is not known.
    motors
        Equal motors on the pulley [-].
    current, current_torque
        Torque of a motor by its current [A, N m].
    """

    pulley: str
    speed: str = ""
    torque: str = ""
    speed_unit: str = ""
    torque_unit: str = ""
    is_estimated: bool = True
    gear_ratio: float | None = None
    gear_efficiency: float = 1.0
    rated_torque: float | None = None
    motors: float = 1.0
    current: tuple[float, ...] = ()
    current_torque: tuple[float, ...] = ()


@dataclass(frozen=True, kw_only=True)
class LearnPlan:
    """What is to be learned from which logs.

    Attributes
    ----------
    file
        Of the plan, for errors.
    drive
        The drive as described.
    drive_file
        Its path.
    logs
        Paths of the logs.
    pulleys
        Those that the log has, in belt order.
    belt_speed, belt_unit, wheel
        Tag of the belt speed, its unit where the log has none, and where the wheel runs.
    take_up, tension
        Kind of the take-up, and the tag of its tension.
    title, dates, zone
        As in the file.
    errors
        How wrong the log may be.
    events
        What was changed.
    """

    file: str
    drive: Drive
    drive_file: str
    logs: tuple[str, ...]
    pulleys: tuple[TagChoice, ...]
    belt_speed: str = ""
    belt_unit: str = ""
    wheel: str = "tail"
    take_up: str = "gravity"
    tension: str = ""
    title: str = ""
    dates: str = ""
    zone: str = ""
    errors: LogErrors = field(default_factory=LogErrors)
    events: tuple[Event, ...] = ()


def load_plan(paths: Sequence[str], overrides: Overrides = ()) -> LearnPlan:
    """Return what a learn file says, or what logs and a drive file say without one.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    if len(paths) == 1 and paths[0].lower().endswith(".toml"):
        plan = load(paths[0], plan_from_document, overrides, file_kind="learn")
        return replace(plan, logs=tuple(path for name in plan.logs for path in _matching(name)))
    drives = [path for path in paths if path.lower().endswith(".toml")]
    logs = [path for path in paths if path not in drives]
    if len(drives) != 1 or not logs:
        raise input_error(
            file=paths[0], message="needs logs and one drive file",
            remedy="Write wraparc learn trend.csv drive.toml.",
        )  # fmt: skip
    document: Document = {"format": 1, "drive": drives[0], "files": logs}
    described, _ = _read_drive(drives[0])
    document["pulley"] = [{"name": pulley.name} for pulley in described.pulleys[:2]]
    document["belt_speed"], document["take_up"], document["errors"] = {}, {}, {}
    return plan_from_document(put_over(document, overrides, LEARN), file=logs[0])


def _matching(path: str) -> list[str]:
    """Return the files that a name with wildcards is of, in order; the name where it is of none."""
    return (not os.path.exists(path) and sorted(glob(path))) or [path]


def plan_from_document(document: Document, *, file: str = "", folder: str = "") -> LearnPlan:
    """Return what a learn file says that is already parsed."""
    record, report = read_tables(LEARN, document, file)
    report.raise_all()
    path = os.path.join(folder, record["drive"])
    read = report.tried(lambda: _read_drive(path), ("drive",))
    report.raise_all()
    assert read is not None  # noqa: S101 - else it was reported
    drive, motors = read
    order = [pulley.name for pulley in drive.pulleys]
    tables: list[Record] = list(record.get("pulley", ()))
    names = [table["name"] for table in tables] or order[:1]
    for name, table in zip(names, tables, strict=False):
        report.tried(lambda name=name: drive.pulley(name), (*table.place, "name"))  # type: ignore[misc]
    if set(order) - set(names):
        report.add(
            ("pulley",), f"the log needs all {len(order)} pulleys of the drive",
            f"Write [[pulley]] for {', '.join(shown(n) for n in order if n not in names)}.",
        )  # fmt: skip
    report.raise_all()
    choices = [_choice(table, motors.get(table["name"])) for table in tables]
    choices = choices or [_choice({"name": order[0]}, motors.get(order[0]))]
    stated = {key: value for key, value in record.get("errors", {}).items() if value > 0.0}
    for key, value in record.get("errors", {}).items():
        if not value > 0.0:
            report.add(("errors", key), "must be more than 0", "Leave it out where it is unknown.")
    report.raise_all()
    belt, take_up = record.get("belt_speed", {}), record.get("take_up", {})
    return LearnPlan(
        file=file,
        drive=drive,
        drive_file=path,
        logs=tuple(os.path.join(folder, name) for name in record["files"]),
        pulleys=tuple(sorted(choices, key=lambda c: order.index(c.pulley))),
        belt_speed=belt.get("column", ""),
        belt_unit=belt.get("unit", ""),
        wheel=belt.get("at", "tail"),
        take_up=take_up.get("kind", "gravity"),
        tension=take_up.get("tension", ""),
        title=record.get("title", ""),
        dates=record.get("dates", ""),
        zone=record.get("zone", ""),
        errors=LogErrors(stated),
        events=tuple(Event(e["when"], e["what"]) for e in record.get("event", ())),
    )


def _choice(table: Any, motor: Motor | None) -> TagChoice:
    """Return the tags of a pulley; what turns it is that of the drive where nothing is said."""
    choice = TagChoice(
        pulley=table["name"],
        speed=table.get("speed", ""),
        torque=table.get("torque", ""),
        speed_unit=table.get("speed_unit", ""),
        torque_unit=table.get("torque_unit", ""),
        is_estimated=table.get("speed_is", "estimated") == "estimated",
        gear_ratio=table.get("gear_ratio"),
        rated_torque=table.get("rated_torque"),
        motors=table.get("motors", 1.0),
        current=tuple(table.get("current", ())),
        current_torque=tuple(table.get("current_torque", ())),
    )
    if motor is None:
        return choice
    return replace(
        choice,
        gear_ratio=choice.gear_ratio or motor.gear_ratio,
        gear_efficiency=motor.gear_efficiency,
        rated_torque=choice.rated_torque or motor.rated_torque,
        motors=table.get("motors", float(motor.count)),
    )


def _read_drive(path: str) -> tuple[Drive, dict[str, Motor]]:
    """Return the drive of a file with its tensions, and what turns each pulley."""
    described = load_drive_or_train(path)
    motors: dict[str, Motor] = {}
    if isinstance(described, Train):
        for case in described.cases:
            if isinstance(case.division, Motors):
                pairs = zip(described.pulleys, case.division.motors, strict=True)
                motors = {p.name: m for p, m in pairs if isinstance(m, Motor)}
        from wraparc.train.file import load_drive

        drive = load_drive(path)
    else:
        drive = described
    refuse_several(drive, "this file needs")
    if len(drive.pulleys) > 2:
        raise InputError(
            Problem(
                message=f"the drive has {len(drive.pulleys)} pulleys, more than 2",
                remedy="Learn it from a drive file of the two that the log has.",
            )
        )
    return drive, motors
