"""The inputs of a drive that a reserve is sought for, and the drive with one of them changed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import inf
from typing import NamedTuple

from wraparc.checks.variant_rows import FRICTION, SLIP
from wraparc.drive import Drive, Lagging, LoadCase, Pulley, Tensions
from wraparc.drive.pull import idles

#: Inputs that are no column of arcs: effective tension with T2 fixed, and T2 with that fixed.
PULL, SLACK = "effective_tension", "slack_tension"
MODULUS, DIAMETER, WRAP = "belt_modulus", "diameter", "wrap_angle"
SHEAR, COMPRESSION, THICKNESS = "shear_modulus", "compression_modulus", "lagging_thickness"
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
    return (*found, *([Input(PULL)] if pulls else []), Input(SLACK))


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
    name = changed.name
    if name == MODULUS:
        return replace(drive, belt=replace(drive.belt, modulus=drive.belt.modulus * factor))
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
