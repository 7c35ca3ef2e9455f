"""What was learned as a drive file: friction and wet factor of laggings, levels in [learned]."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from wraparc.drive import ConditionFactor, Drive, Lagging, half_interval
from wraparc.files.drive_keys import DRIVE
from wraparc.files.write import drive_document
from wraparc.learn.grid import moment_of
from wraparc.learn.learn import Learned, LearnedPulley
from wraparc.provenance import Kind, Provenance
from wraparc.schema.emit import document_text
from wraparc.schema.kinds import Name, Percent, Quantity, Rows, Text
from wraparc.schema.overrides import read_document
from wraparc.schema.source import Document, read_tables
from wraparc.schema.tables import Entry, Record, Table, need
from wraparc.schema.uncertain import UNCERTAINTY

#: Half an interval of friction above which no factor is written [-]; hours of an episode that the
#: wet factor is taken from.
MOST_WIDTH, LEAST_HOURS = 0.30, 0.5
_SHARES = Rows(Quantity("number"), 2, 50)
LEARNED_PULLEY = Table(
    "Learned of a pulley",
    need("name", kind=Name()),
    need("speed_zero", kind=Quantity("number")),
    need("torque", "Over rated torque.", _SHARES),
    need("normal", "1 - v/(omega R/i).", _SHARES),
    need("alarm", kind=_SHARES),
    need("trip", kind=_SHARES),
    Entry("false_alarms", "A running year, and at most.", Rows(Quantity("number"), 2, 2)),
    Entry("friction", "Factor on the law, and its 95 % interval.", Rows(Quantity("number"), 3, 3)),
)
LEARNED = Table(
    "Learned from logs",
    need("until", "Last day of the log.", Text(20)),
    need("days", "Length of the log.", Quantity("number")),
    need("pulley", kind=Rows(LEARNED_PULLEY, 1, 2)),
    Entry("share", "Of the running time that was left out.", Percent(1.0)),
)


@dataclass(frozen=True)
class LearnedLevels:
    """Levels of a pulley that a drive file has from a log.

    Attributes
    ----------
    pulley
        Its name.
    until
        Last day of the log.
    torque, normal, alarm, trip
        Over rated torque, and differences there [-].
    false_alarms
        A running year, and at most.
    """

    pulley: str
    until: str
    torque: tuple[float, ...]
    normal: tuple[float, ...]
    alarm: tuple[float, ...]
    trip: tuple[float, ...]
    false_alarms: tuple[float, ...]


def learned_text(learned: Learned) -> str:
    """Return the drive file with what was learned: it is solved and chosen by as any other."""
    document = dict(read_document(learned.plan.drive_file))
    drive = learned.plan.drive
    pulleys = tuple(
        replace(on, lagging=_lagging(learned, own, on.lagging))
        for on, own in zip(drive.pulleys, learned.pulleys, strict=True)
    )
    made = drive_document(_with(drive, pulleys))
    rows = [dict(row) for row in document["pulley"]]
    for row, new in zip(rows, made["pulley"], strict=True):
        row["lagging"] = new["lagging"]
    document["pulley"] = rows
    if "lagging" in made:
        document["lagging"] = {**document.get("lagging", {}), **made["lagging"]}
    _state_errors(document, learned)
    document["learned"] = _table(learned)
    return document_text(document, DRIVE)


def _with(drive: Drive, pulleys: Any) -> Drive:
    return replace(drive, pulleys=pulleys)


def _lagging(learned: Learned, own: LearnedPulley, lagging: Lagging) -> Lagging:
    """Return a lagging with the friction and the wet factor that were learned, where known."""
    source = _source(learned)
    factors = dict(lagging.condition_factors)
    deep = [e.change for e in learned.episodes.found if e.stop - e.start >= 3600.0 * LEAST_HOURS]
    if deep and lagging.condition != "wet":
        wet = replace(source, note=f"deepest of {len(deep)} wet or dirty episodes")
        factors["wet"] = ConditionFactor(factor=round(1.0 + min(deep), 3), source=wet)
    f, uncertain = own.friction, dict(lagging.uncertainty)
    if f is None or 0.5 * math.log(f.high / f.low) > MOST_WIDTH:
        return replace(lagging, condition_factors=factors)
    errors = learned.plan.errors.stated
    for error, key in (("peak_slip", "slip"), ("lagging_shear", "shear_modulus")):
        if error in errors:
            uncertain.setdefault(key, half_interval(errors[error]))
    uncertain["friction"] = round(max(f.high / f.value - 1.0, 1.0 - f.low / f.value), 4)
    note = f"friction {f.value:.3g} ({f.low:.3g} to {f.high:.3g}, 95 %) of {lagging.name}"
    kept = {
        part: lagging.source_of(part)
        for part in lagging.LIMITS
        if getattr(lagging, part) is not None
    }
    return replace(
        lagging,
        name=f"{lagging.name}-learned"[:60],
        title=f"{lagging.title or lagging.name}, learned",
        law=lagging.law.scaled(round(f.value, 4)),
        condition_factors=factors,
        provenance=replace(source, note=note),
        sources=kept,
        uncertainty=uncertain,
        fit=None,
    )


def _state_errors(document: Document, learned: Learned) -> None:
    """State the errors of a log as uncertainties, those that are of numbers of the drive.

    The modulus of the belt, and the tension at the take-up; what the drive file states stays.
    """
    errors, drive = learned.plan.errors.stated, learned.plan.drive
    if "belt_modulus" in errors:
        document["belt"] = _uncertain(document["belt"], "modulus", errors["belt_modulus"])
    if "exit_tension" not in errors:
        return
    case = drive.load_case()
    driving = math.fsum(at.effective for at in case.tensions.values()) > 0.0
    place, end = ("last", "exit_tension") if driving else ("first", "entry_tension")
    for table, key in (("conveyor", "take_up_tension"), ("train", end)):
        if table in document:
            weighed = "counterweight" in document[table]
            name = "counterweight" if table == "conveyor" and weighed else key
            document[table] = _uncertain(document[table], name, errors["exit_tension"])
            return
    index = -1 if place == "last" else 0
    rows = [dict(row) for row in document["pulley"]]
    rows[index] = _uncertain(rows[index], end, errors["exit_tension"])
    document["pulley"] = rows


def _uncertain(table: Document, key: str, sd: float) -> Document:
    """Return a table with the uncertainty of a number, unless it has one."""
    stated = dict(table.get(UNCERTAINTY, {}))
    stated.setdefault(key, f"{100.0 * half_interval(sd):.3g} %")
    return {**table, UNCERTAINTY: stated}


def _source(learned: Learned) -> Provenance:
    days = f"{learned.stop:.0f} days to {_day(learned)}"
    title = learned.plan.title or learned.plan.drive.title or "a drive"
    return Provenance(Kind.CALIBRATED, f"learned from logs of {title}, {days}")


def _day(learned: Learned) -> str:
    seconds = learned.grid.start + 86400.0 * (learned.stop - 0.02)
    return moment_of(seconds).date().isoformat()


def _table(learned: Learned) -> Document:
    rows = []
    for own in learned.pulleys:
        line = own.line
        row: Document = {
            "name": own.name,
            "speed_zero": round(own.zero.value, 6),
            "torque": [round(m, 3) for m in line.torque.tolist()],
            "normal": [round(m, 6) for m in line.normal.tolist()],
            "alarm": [round(m, 6) for m in line.alarm.tolist()],
            "trip": [round(m, 6) for m in line.trip.tolist()],
        }
        if all(map(math.isfinite, line.false_alarms)):
            row["false_alarms"] = [round(v, 2) for v in line.false_alarms]
        if own.friction is not None:
            f = own.friction
            row["friction"] = [round(v, 4) for v in (f.value, f.low, f.high)]
        rows.append(row)
    share = f"{100.0 * learned.grid.share_left_out:.2g} %"
    return {"until": _day(learned), "days": round(learned.stop, 1), "share": share, "pulley": rows}


def learned_levels(document: Document, file: str = "") -> tuple[LearnedLevels, ...]:
    """Return the levels that a drive document has from a log; none where it has none.

    Raises
    ------
    InputError
        With everything that is wrong in its table.
    """
    if "learned" not in document:
        return ()
    table, report = read_tables(LEARNED, document["learned"], file)
    report.raise_all()
    rows: list[Record] = table["pulley"]
    return tuple(
        LearnedLevels(
            row["name"], table["until"], tuple(row["torque"]), tuple(row["normal"]),
            tuple(row["alarm"]), tuple(row["trip"]), tuple(row.get("false_alarms", ())),
        )
        for row in rows
    )  # fmt: skip
