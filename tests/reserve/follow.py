"""Reserves followed: the changed drive, built here, solved and judged as every door does."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from doors.draw import document
from wraparc import Drive
from wraparc.checks import judge
from wraparc.drive import Lagging, LoadCase, Tensions
from wraparc.errors import InputError
from wraparc.reserve import Flip, Input, Reserve
from wraparc.train import Pulls, TrainResult
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.whole import Whole, by_pulley, solved

OF_LAGGING = {
    "lagging_thickness": "thickness",
    "shear_modulus": "shear_modulus",
    "compression_modulus": "compression_modulus",
}


#: Part of a change at which a level must hold that holds for little more.
_NARROW = 1.002


def random_results(count: int, seed: int = 54, first: int = 1) -> Iterator[tuple[int, Whole]]:
    """Yield so many solved random drives, with their numbers; what cannot be one is left out."""
    number, found = first - 1, 0
    while found < count:
        number += 1
        try:
            described = drive_or_train_from_document(document(seed, number))
        except InputError:
            continue
        found += 1
        yield number, solved(described)


def changed_drive(drive: Drive, of: Input, change: float) -> Drive:
    """Return the drive whose input is that much larger [-]."""
    times = 1.0 + change
    if of.name == "belt_modulus":
        return replace(drive, belt=replace(drive.belt, modulus=times * drive.belt.modulus))
    if of.name == "carcass":
        assert drive.belt.carcass is not None
        return replace(drive, belt=replace(drive.belt, carcass=times * drive.belt.carcass))
    if of.name in ("take_up_distance", "start_factor"):
        return _conveyed(drive, of.name, times)
    if of.name in ("effective_tension", "slack_tension"):
        take_up = drive.take_up_tension(drive.load_case())
        cases = tuple(_loaded(case, of.name, change, take_up) for case in drive.load_cases)
        return replace(drive, load_cases=cases)
    pulleys = []
    for pulley in drive.pulleys:
        made: Any = pulley
        if pulley.name in of.pulleys and of.name in ("diameter", "wrap_angle"):
            made = replace(pulley, **{of.name: times * getattr(pulley, of.name)})
        elif pulley.name in of.pulleys:
            every = [_lagged(own, of.name, times) for own in (pulley.lagging, *pulley.conditions)]
            made = replace(pulley, lagging=every[0], conditions=tuple(every[1:]))
        pulleys.append(made)
    return replace(drive, pulleys=tuple(pulleys))


def _conveyed(drive: Drive, name: str, times: float) -> Drive:
    """Return the drive at the tensions of its conveyor with a number that is so much larger."""
    conveyor, (pulley,) = drive.conveyor, drive.pulleys
    assert conveyor is not None
    more: dict[str, Any] = {name: times * getattr(conveyor, name)}
    made = replace(conveyor, **more)
    ends = {state.name: (state.entry, state.exit) for state in made.states()}
    cases = []
    for case in drive.load_cases:
        entry, leaving = ends[case.name]
        cases.append(replace(case, tensions={pulley.name: Tensions(entry=entry, exit=leaving)}))
    return replace(drive, load_cases=tuple(cases), conveyor=made)


def _loaded(case: LoadCase, name: str, change: float, take_up: float) -> LoadCase:
    ends = [t for at in case.tensions.values() for t in (at.entry, at.exit)]

    def end(tension: float) -> float:
        if name == "slack_tension":
            return tension + change * take_up
        return tension + change * (tension - min(ends))

    tensions = {
        key: Tensions(entry=end(at.entry), exit=end(at.exit)) for key, at in case.tensions.items()
    }
    return replace(case, tensions=tensions)


def _lagged(lagging: Lagging, name: str, times: float) -> Lagging:
    if name == "friction":
        return replace(lagging, law=lagging.law.scaled(times, 1.0))
    if name == "slip":
        return replace(lagging, law=lagging.law.scaled(1.0, times))
    value = times * getattr(lagging, OF_LAGGING[name])
    if name != "lagging_thickness":
        return replace(lagging, **{name: value})
    modulus = float(lagging.compression_modulus_at(np.array([value]))[0])
    block = lagging.block
    if block is not None:
        block = replace(block, height=max(block.height + value - lagging.thickness, 1e-4))
    return replace(lagging, thickness=value, compression_modulus=modulus, block=block)


def level_of(result: Whole, of: Input, change: float) -> str:
    """Return the level of the whole verdict with a change; each pulley keeps its share."""
    drive = by_pulley(result).drive
    verdict = judge(solved(changed_drive(drive, of, change)))
    divided = isinstance(result, TrainResult) and not all(
        isinstance(case.division, Pulls) for case in result.train.cases
    )  # what rises between pulleys is not known of tensions alone
    levels = [c.level for c in verdict.checks if not (divided and c.name == "meeting")]
    if isinstance(result, TrainResult):  # motors and what divides the load stay as they are
        made = {check.name for check in judge(solved(drive)).checks}
        levels += [c.level for c in judge(result).checks if c.name not in made]
    return str(max(levels, key=lambda level: level.rank))


def faults(result: Whole, reserve: Reserve, flips: tuple[Flip, ...]) -> Iterator[str]:
    """Yield what does not hold of some changes: at 0.97 and 1.03 of each.

    A level that holds for less than 3 % of the change is asked at 1.002 of it: equal diameters.
    """

    def found_at(flip: Flip, part: float) -> str:
        try:
            return level_of(result, flip.input, part * flip.change)
        except InputError:
            return "no drive"

    for flip in flips:
        for part, expected in ((0.97, reserve.level), (1.03, flip.level)):
            found = found_at(flip, part)
            if found != expected and part > 1.0 and found_at(flip, _NARROW) == expected:
                continue
            if found != expected:
                at = f"{flip.input.name} {flip.input.label} {100.0 * flip.change:+.4g} %"
                yield f"{at} to {flip.level}: {found} at {part:g} of it, expected {expected}"
