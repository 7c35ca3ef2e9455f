"""The ``[conveyor]`` table to the load cases of its drive pulley."""

from dataclasses import replace
from typing import Any

from wraparc.conveyor import Conveyor, State, choices
from wraparc.conveyor.keys import CONVEYOR
from wraparc.drive import Belt, Drive, LoadCase, TakeUp, Tensions
from wraparc.errors import InputError
from wraparc.files.tensions import KEYS
from wraparc.schema.problems import Report
from wraparc.schema.tables import Record

_TWICE = "the [conveyor] table gives the tensions already"
_MASS = 'Write for example belt_mass = "22 kg/m", or mass in [belt].'
_LEAVE = "Leave it out, or the [conveyor] table."


def build_conveyor(
    record: Record, belt: Belt | None, take_up: TakeUp, report: Report
) -> tuple[Conveyor | None, tuple[LoadCase, ...]]:
    """Return the conveyor of a drive file and its load cases; what is wrong is reported."""
    pulleys = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    _refuse_tensions(record, pulleys, report)
    if take_up.fixed:
        message = "a fixed take-up does not go with [conveyor]"
        remedy = "Give tensions of each load case."
        report.add(("take_up", "kind"), message, remedy, take_up.kind)
    if len(record.get("pulley") or ()) > 1:
        message = f"goes with one drive pulley, not {len(record['pulley'])}"
        report.add(("conveyor",), message, "Put the tensions of a train into [train].")
    given = record.get("conveyor")
    if not isinstance(given, Record):
        return None, ()
    if take_up.after:
        message = "contradicts take_up_distance of [conveyor]"
        report.add(("take_up", "after"), message, "Leave it out.", take_up.after)
    mass = None if belt is None else belt.mass
    conveyor = _conveyor(given, record.get("belt"), mass, take_up, report)
    states = conveyor and report.tried(conveyor.states, given.place, given.raw)
    if not states or not pulleys or "name" not in pulleys[0]:
        return conveyor, ()
    return conveyor, tuple(load_case(state, pulleys[0]["name"]) for state in states)


def load_case(state: State, pulley: str) -> LoadCase:
    """Return a load case of a conveyor as one of its drive pulley."""
    why = "computed from the resistances of the conveyor"
    made = {"entry": why, "exit": why}
    tensions = Tensions(entry=state.entry, exit=state.exit, computed=made)
    kind: Any = state.kind
    return LoadCase(name=state.name, tensions={pulley: tensions}, kind=kind)


def conveyor_of(drive: Drive) -> Conveyor | None:
    """Return the conveyor of a drive while all its load cases still follow from it, or None."""
    if drive.conveyor is None or len(drive.pulleys) != 1:
        return None
    ratio = drive.criteria.take_up.sheave_ratio
    try:
        conveyor = replace(drive.conveyor, speed=drive.belt.speed, sheave_ratio=ratio)
        states = conveyor.states()
    except InputError:
        return None
    cases = tuple(load_case(state, drive.pulleys[0].name) for state in states)
    return conveyor if cases == drive.load_cases else None


def _conveyor(
    given: Record, belt: Any, mass: float | None, take_up: TakeUp, report: Report
) -> Conveyor | None:
    more: dict[str, Any] = {"sheave_ratio": take_up.sheave_ratio}
    if not {"belt_mass"} & {*given, *given.faulty}:
        more["belt_mass"] = mass
        if mass is None:
            given.faulty.add("belt_mass")
            if not isinstance(belt, Record) or belt.sound("mass"):
                report.add((*given.place, "belt_mass"), "missing", _MASS)
    speed = belt.get("speed") if isinstance(belt, Record) else None
    if speed is not None:
        more["speed"] = speed
    # what cannot be built has still to be told with everything else
    unsure = not isinstance(belt, Record) or not belt.sound("speed")
    if given.sound() and not unsure:
        conveyor: Conveyor | None = CONVEYOR.built(given, report, **more)
        return conveyor
    told = choices({*given, *given.faulty, *more, *(("speed",) if unsure else ())})
    if told:
        report.take(InputError(told), given.place, given.raw)
    return None


def _refuse_tensions(record: Record, pulleys: list[Record], report: Report) -> None:
    """Report tensions beside a conveyor, and load cases of one's own."""
    for pulley in pulleys:
        for key in (key for key in KEYS if key in pulley):
            report.add((*pulley.place, key), _TWICE, _LEAVE, pulley.raw[key])
    if "load_case" in record:
        report.add(("load_case",), "the [conveyor] table gives the load cases already", _LEAVE)
