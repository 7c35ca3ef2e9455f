"""The inputs of a drive that a reserve is sought for, and the drive with one of them changed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import inf
from typing import Any, NamedTuple

from wraparc.checks.variant_rows import FRICTION, SLIP
from wraparc.conveyor import Conveyor, State, course_state, standard_cases
from wraparc.drive import Belt, Drive, Lagging, LoadCase, Pulley, Tensions
from wraparc.drive.pull import idles
from wraparc.files.conveyor_build import conveyor_of, load_case
from wraparc.schema.limits import raise_all

#: Inputs that are no column of arcs: effective tension with T2 fixed, and T2 with that fixed.
PULL, SLACK = "effective_tension", "slack_tension"
MODULUS, DIAMETER, WRAP = "belt_modulus", "diameter", "wrap_angle"
SHEAR, COMPRESSION, THICKNESS = "shear_modulus", "compression_modulus", "lagging_thickness"
#: Those of a belt by its standard name, and of a conveyor that gives the tensions.
CARCASS, TAKE_UP_PLACE, START = "carcass", "take_up_distance", "start_factor"
#: Inputs that neither a column nor a shift of all tensions follows: each value is a drive.
OF_DRIVES = (CARCASS, TAKE_UP_PLACE, START)
#: Those of a lagging: one number wherever it is, and those of a pulley.
OF_LAGGING, OF_PULLEY = (FRICTION, SLIP, SHEAR, COMPRESSION), (THICKNESS, DIAMETER, WRAP)


class Input(NamedTuple):
    """A number that is changed.

    Attributes
    ----------
    name
        What it is: a column of arcs, `FRICTION`, `SLIP`, `PULL` or `SLACK`.
    pulleys
        Names of the pulleys where it is changed; empty for what all have in common.
    label
        Pulley or lagging that it is of, where not all are.
    """

    name: str
    pulleys: tuple[str, ...] = ()
    label: str = ""


def inputs_of(drive: Drive) -> tuple[Input, ...]:
    """Return the inputs of a drive that a verdict may depend on.

    What is of laggings is one number for all pulleys of the same lagging; where several differ,
    each is an input, and all of them together are.
    """
    found: list[Input] = []
    for name in OF_LAGGING:
        found += _grouped(name, drive, lambda p: p.lagging.name)
    found += [Input(MODULUS)] if drive.belt.modulus < inf else []
    for name in OF_PULLEY:
        found += _grouped(name, drive, lambda p: p.name)
    pulls = any(
        not idles(at.entry, at.exit) for case in drive.load_cases for at in case.tensions.values()
    )
    found += [Input(CARCASS)] if drive.belt.carcass_ends is not None else []
    found += [Input(PULL)] if pulls else []
    return (*found, Input(SLACK), *_of_conveyor(drive))


def _of_conveyor(drive: Drive) -> Iterator[Input]:
    """Yield the inputs of the conveyor from whose resistances the tensions are."""
    conveyor = conveyor_of(drive)
    if conveyor is not None and conveyor.take_up_distance > 0.0:
        yield Input(TAKE_UP_PLACE)
    if conveyor is not None and conveyor.start_factor is not None:
        yield Input(START)


def _grouped(name: str, drive: Drive, label: Callable[[Pulley], str]) -> Iterator[Input]:
    """Yield an input for each group of pulleys that have it, and for all of them together."""
    pulleys = [pulley for pulley in drive.pulleys if _has(name, pulley)]
    groups: dict[str, list[str]] = {}
    for pulley in pulleys:
        groups.setdefault(label(pulley), []).append(pulley.name)
    every = tuple(pulley.name for pulley in pulleys)
    if every:
        yield Input(name, every)
    if len(groups) > 1:
        yield from (Input(name, tuple(names), of) for of, names in groups.items())


def _has(name: str, pulley: Pulley) -> bool:
    """Return whether a number of a pulley is one that a factor changes."""
    return any(_has_lagging(name, lagging) for lagging in (pulley.lagging, *pulley.conditions))


def _has_lagging(name: str, lagging: Lagging) -> bool:
    if name == SLIP:
        other = lagging.law.scaled(slip=2.0)  # of a table of tests it is the slip of the tests
        return other != lagging.law and other.tested == lagging.law.tested
    if name == SHEAR:
        return lagging.thickness > 0.0 and lagging.shear_modulus < inf
    if name == COMPRESSION:
        return lagging.thickness > 0.0 and lagging.compression_modulus < inf
    return name != THICKNESS or lagging.thickness > 0.0


def change_drive(drive: Drive, changed: Input, factor: float) -> Drive:
    """Return a drive with a factor on one of its inputs.

    Every pulley keeps its share of the load. With `SLACK` all tensions shift by as much as that at
    the take-up; with `PULL` the lowest tension of each load case stays.

    Raises
    ------
    InputError
        If there is no such drive.
    """
    name, belt = changed.name, drive.belt
    if name == MODULUS:
        return replace(drive, belt=replace(belt, modulus=belt.modulus * factor))
    if name == CARCASS:
        return replace(drive, belt=_with_carcass(belt, factor))
    if name in (TAKE_UP_PLACE, START):
        return _with_conveyor(drive, name, factor)
    if name == PULL:
        return _with_tensions(drive, lambda slack, at: slack + factor * (at - slack))
    if name == SLACK:
        lift = lift_of(drive, factor)
        return _with_tensions(drive, lambda _, at: at + lift)
    pulleys = (
        _change_pulley(pulley, name, factor) if pulley.name in changed.pulleys else pulley
        for pulley in drive.pulleys
    )
    return replace(drive, pulleys=tuple(pulleys))


def _with_carcass(belt: Belt, factor: float) -> Belt:
    return belt if belt.carcass is None else replace(belt, carcass=belt.carcass * factor)


def _with_conveyor(drive: Drive, name: str, factor: float) -> Drive:
    """Return a drive whose tensions are those of its conveyor with another number."""
    conveyor, (pulley,) = drive.conveyor, drive.pulleys
    if conveyor is None:
        return drive
    ratio = drive.criteria.take_up.sheave_ratio
    more: dict[str, Any] = {name: factor * getattr(conveyor, name)}
    made = replace(conveyor, speed=drive.belt.speed, sheave_ratio=ratio, **more)
    states = _starts(made, drive) if name == START else made.states()
    cases = {state.name: load_case(state, pulley.name, {}) for state in states}
    changed = tuple(cases.get(case.name, case) for case in drive.load_cases)
    return replace(drive, conveyor=made, load_cases=changed)


def _starts(conveyor: Conveyor, drive: Drive) -> list[State]:
    """Return the load cases that a start factor is of: the others stay as they are."""
    full = drive.load_case("full").tensions[drive.pulleys[0].name].effective
    starts = [case for case in standard_cases(conveyor) if case.kind == "starting"]
    states = [course_state(conveyor, case, full) for case in starts]
    problems = [state.slack_problem() for state in states]
    raise_all([problem for problem in problems if problem is not None])
    return states


def lift_of(drive: Drive, factor: float) -> float:
    """Return by how much all tensions rise with a factor on that at the take-up [N]."""
    return (factor - 1.0) * drive.take_up_tension(drive.load_case())


def _change_pulley(pulley: Pulley, name: str, factor: float) -> Pulley:
    if name == DIAMETER:
        return replace(pulley, diameter=pulley.diameter * factor)
    if name == WRAP:
        return replace(pulley, wrap_angle=pulley.wrap_angle * factor)
    lagging, *others = (
        _change_lagging(lagging, name, factor) for lagging in (pulley.lagging, *pulley.conditions)
    )
    return replace(pulley, lagging=lagging, conditions=tuple(others))


def _change_lagging(lagging: Lagging, name: str, factor: float) -> Lagging:
    if name == FRICTION:
        return replace(lagging, law=lagging.law.scaled(friction=factor))
    if name == SLIP:
        return replace(lagging, law=lagging.law.scaled(slip=factor))
    if name == THICKNESS:
        return lagging.with_thickness(lagging.thickness * factor)
    if name == SHEAR:
        return replace(lagging, shear_modulus=lagging.shear_modulus * factor)
    return replace(lagging, compression_modulus=lagging.compression_modulus * factor)


def _with_tensions(drive: Drive, of: Callable[[float, float], float]) -> Drive:
    """Return a drive at other tensions, each by the lowest one of its load case and itself [N]."""
    return replace(drive, load_cases=tuple(_changed_case(case, of) for case in drive.load_cases))


def _changed_case(case: LoadCase, of: Callable[[float, float], float]) -> LoadCase:
    slack = min(min(at.entry, at.exit) for at in case.tensions.values())
    tensions = {
        name: Tensions(entry=of(slack, at.entry), exit=of(slack, at.exit))
        for name, at in case.tensions.items()
    }
    return replace(case, tensions=tensions)
