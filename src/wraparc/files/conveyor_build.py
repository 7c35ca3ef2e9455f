"""The ``[conveyor]`` table to the load cases of its drive pulleys."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from wraparc.conveyor import Conveyor, ConveyorCase, DrivePlace, State, choices
from wraparc.conveyor.description import UNCERTAIN
from wraparc.conveyor.keys import (
    CEMA,
    CONVEYOR,
    CONVEYOR_CASE,
    DRIVE_PLACE,
    FLIGHT,
    LOADING,
    LOCAL,
    TRAVEL,
)
from wraparc.conveyor.uncertain import uncertain_tensions
from wraparc.drive import Belt, Drive, LoadCase, TakeUp, Tensions
from wraparc.errors import InputError, name_remedy
from wraparc.files.tensions import KEYS
from wraparc.schema.problems import Report
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import read_uncertainty

_TWICE = "the [conveyor] table gives the tensions already"
_MASS = 'Write for example belt_mass = "22 kg/m", or mass in [belt].'
_LEAVE = "Leave it out, or the [conveyor] table."
#: Keys of the table that hold rows, with the table of each row and the field they fill.
_ROWS = (
    ("flight", FLIGHT, "flights"),
    ("loading", LOADING, "loadings"),
    ("drive", DRIVE_PLACE, "drives"),
    ("resistance", LOCAL, "locals"),
)


def build_conveyor(
    record: Record, belt: Belt | None, take_up: TakeUp, report: Report
) -> tuple[Conveyor | None, tuple[LoadCase, ...]]:
    """Return the conveyor of a drive file and its load cases; what is wrong is reported."""
    if len(record.get("pulley") or ()) > 1:
        message = f"has {len(record['pulley'])} drive pulleys and no [train] with their shares"
        report.add(("conveyor",), message, 'Write share = ["50 %", "50 %"] in [train].')
    conveyor = described_conveyor(record, belt, take_up, report)
    given = record.get("conveyor")
    pulleys = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    if conveyor is None or not isinstance(given, Record) or len(pulleys) > 1:
        return None, ()
    states = report.tried(conveyor.states, given.place, given.raw)
    if not states or not pulleys or "name" not in pulleys[0]:
        return conveyor, ()
    return conveyor, load_cases(conveyor, states, pulleys[0]["name"])


def described_conveyor(
    record: Record, belt: Belt | None, take_up: TakeUp, report: Report
) -> Conveyor | None:
    """Return the conveyor of a drive file without load cases; what is wrong is reported."""
    pulleys = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    _refuse_tensions(record, pulleys, report)
    if take_up.fixed:
        message = "a fixed take-up does not go with [conveyor]"
        remedy = "Give tensions of each load case."
        report.add(("take_up", "kind"), message, remedy, take_up.kind)
    given = record.get("conveyor")
    if not isinstance(given, Record):
        return None
    if take_up.after and len(pulleys) == 1:
        message = "contradicts take_up_distance of [conveyor]"
        report.add(("take_up", "after"), message, "Leave it out.", take_up.after)
    mass = None if belt is None else belt.mass
    names = [pulley["name"] for pulley in pulleys if "name" in pulley]
    more = _of_belt(belt) | _parts(given, names, take_up, report)
    return _conveyor(given, record.get("belt"), mass, take_up, more, report)


def load_cases(conveyor: Conveyor, states: Sequence[State], pulley: str) -> tuple[LoadCase, ...]:
    """Return the load cases of a conveyor as those of its drive pulley."""
    every = uncertain_tensions(conveyor, states)
    return tuple(load_case(state, pulley, of) for state, of in zip(states, every, strict=True))


def load_case(state: State, pulley: str, uncertainty: Mapping[str, float]) -> LoadCase:
    """Return a load case of a conveyor as one of its drive pulley."""
    why = "computed from the resistances of the conveyor"
    made = {"entry": why, "exit": why}
    tensions = Tensions(entry=state.entry, exit=state.exit, computed=made)
    kind: Any = state.kind
    stated = {pulley: uncertainty} if uncertainty else {}
    return LoadCase(name=state.name, tensions={pulley: tensions}, kind=kind, uncertainty=stated)


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
    cases = load_cases(conveyor, states, drive.pulleys[0].name)
    return conveyor if cases == drive.load_cases else None


def _of_belt(belt: Belt | None) -> dict[str, Any]:
    """Return what a conveyor takes from its belt: what its bending about pulleys needs."""
    if belt is None:
        return {}
    return {"width": belt.width, "thickness": _thickness(belt), "steel": belt.kind == "steel-cord"}


def _thickness(belt: Belt) -> float | None:
    """Return the thickness of a belt, by its layers where nothing else is said [m]."""
    layers = (belt.pulley_cover, belt.carry_cover, belt.cord)
    known = [layer for layer in layers if layer is not None]
    if belt.thickness is not None or len(known) < len(layers):
        return belt.thickness
    return sum(known)


def _parts(given: Record, names: Sequence[str], take_up: TakeUp, report: Report) -> dict[str, Any]:
    """Return flights, loading points, drives and the like, as far as they could be made."""
    parts: dict[str, Any] = {}
    for key, table, field in _ROWS:
        made = [table.built(row, report) for row in _tables(given, key)]
        parts |= _whole(given, key, field, made)
    cases = [_case(row, report) for row in _tables(given, "load_case")]
    parts |= _whole(given, "load_case", "cases", cases)
    for key, table in (("travel", TRAVEL), ("cema", CEMA)):
        if isinstance(given.get(key), Record):
            parts[key] = table.built(given[key], report)
    return parts | _drives(given, parts, names, take_up, report) | _sums(given, parts)


def _tables(given: Record, key: str) -> list[Record]:
    """Return the rows of a key that could be read."""
    return [row for row in given.get(key) or () if isinstance(row, Record)]


def _whole(given: Record, key: str, field: str, made: Sequence[Any]) -> dict[str, Any]:
    """Return what rows describe as a field; the key is faulty if one could not be made."""
    if any(one is None for one in made):
        given.faulty.add(key)
    return {field: tuple(made)} if len(made) > 0 else {}


def _drives(
    given: Record, parts: dict[str, Any], names: Sequence[str], take_up: TakeUp, report: Report
) -> dict[str, Any]:
    """Return where the drives stand, and behind which of them the take-up."""
    found: dict[str, Any] = {"take_up_after": take_up.after} if len(names) > 1 else {}
    if "drive" in given.faulty:
        return found
    if "drives" in parts:
        return found | {"drives": _placed(given, parts["drives"], names, report)}
    if len(names) > 1 or "flights" in parts:
        at = given.get("drive_at", "head")
        return found | {"drives": tuple(DrivePlace(pulley=name, at=at) for name in names)}
    return found


def _sums(given: Record, parts: dict[str, Any]) -> dict[str, Any]:
    """Return length and lift of flights, where they are not given."""
    flights = parts.get("flights", ())
    if len(flights) == 0 or None in flights:
        return {}
    sums = {
        "length": sum(flight.length for flight in flights),
        "lift": sum(flight.rise for flight in flights),
    }
    return {key: value for key, value in sums.items() if key not in {*given, *given.faulty}}


def _case(row: Record, report: Report) -> ConveyorCase | None:
    factors = dict(row.get("factor") or {})
    case: ConveyorCase | None = CONVEYOR_CASE.built(row, report, factor=factors)
    return case


def _placed(
    given: Record, drives: Sequence[DrivePlace], names: Sequence[str], report: Report
) -> tuple[DrivePlace, ...]:
    """Return the places of the drives in the order of their pulleys; those missing reported."""
    by_name = {drive.pulley: drive for drive in drives}
    for i, drive in enumerate(drives):
        if drive.pulley not in names:
            place = (*given.place, "drive", i + 1, "pulley")
            report.add(place, "no such pulley", name_remedy(drive.pulley, names), drive.pulley)
            given.faulty.add("drive")
    for name in names:
        if name not in by_name:
            message = f"pulley {name} is at no place"
            remedy = f'Write a [[conveyor.drive]] with pulley = "{name}" and at.'
            report.add((*given.place, "drive"), message, remedy)
            given.faulty.add("drive")
    return tuple(by_name[name] for name in names if name in by_name)


def _conveyor(
    given: Record,
    belt: Any,
    mass: float | None,
    take_up: TakeUp,
    parts: dict[str, Any],
    report: Report,
) -> Conveyor | None:
    more: dict[str, Any] = {"sheave_ratio": take_up.sheave_ratio, **parts}
    more["uncertainty"] = read_uncertainty(given, UNCERTAIN, report)
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
        message = "the [conveyor] table gives the load cases already"
        remedy = "Write [[conveyor.load_case]] for those of its own, or leave one of them out."
        report.add(("load_case",), message, remedy)
