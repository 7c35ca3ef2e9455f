"""The reserves of many designs given by column, as `solve_batch` takes them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import isnan
from typing import Any

from numpy.typing import ArrayLike

from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.drive import Drive, Lagging, LoadCase, Pulley, Tensions
from wraparc.errors import InputError, Problem
from wraparc.reserve.find import Reserve, find_reserve
from wraparc.train.whole import solved

#: Columns that follow from the belt of a drive.
_OF_BELT = ("pitch_offset", "cover_compliance", "centrifugal_force")


def find_reserves(
    table: Mapping[str, ArrayLike],
    laggings: Sequence[Lagging] | Lagging,
    like: Drive,
    *,
    rows: Iterable[int] | None = None,
    every: bool = True,
) -> list[Reserve]:
    """Return the reserve of designs given by column, each that of its drive alone.

    Parameters
    ----------
    table, laggings
        As for `wraparc.solve_batch`.
    like
        What a table does not have: rating, layers and mass of the belt, take-up, standard, safety
        factors, name and side of the pulley, name and kind of the load case; of one pulley in one
        load case.
    rows
        The designs that are asked, by place; all of them if left out. A reserve takes about as
        long as the solving of a drive.
    every
        As for `find_reserve`.

    Raises
    ------
    InputError
        As of `solve_batch`; where `like` has several pulleys or load cases, a row is no drive, or a
        column follows from the belt.
    """
    problems = [
        Problem(key=f"column {name}", message="follows from the belt", remedy="Leave it out.")
        for name in _OF_BELT
        if name in table
    ]
    for key, count in (("pulley", len(like.pulleys)), ("load_case", len(like.load_cases))):
        if count != 1:
            message = f"must have one {key.replace('_', ' ')}"
            problems.append(Problem(key=f"like.{key}", value=str(count), message=message))
    if problems:
        raise InputError(problems)
    arcs, every_lagging = arcs_of_table(table, laggings), _listed(laggings)
    asked = range(len(arcs)) if rows is None else rows
    return [
        find_reserve(solved(_drive(arcs, row, every_lagging, like, table)), every=every)
        for row in asked
    ]


def _listed(laggings: Sequence[Lagging] | Lagging) -> list[Lagging]:
    return [laggings] if isinstance(laggings, Lagging) else list(laggings)


def _drive(
    arcs: Arcs, row: int, laggings: list[Lagging], like: Drive, table: Mapping[str, Any]
) -> Drive:
    """Return the drive of a row."""

    def of(name: str) -> float:
        return float(getattr(arcs, name)[row])

    def known(name: str, other: float | None) -> float | None:
        return of(name) if name in table and not isnan(of(name)) else other

    pulley, case, belt = like.pulleys[0], like.load_cases[0], like.belt
    lagging = replace(
        laggings[int(arcs.law[row])].with_thickness(of("lagging_thickness")),
        shear_modulus=of("shear_modulus"),
        compression_modulus=of("compression_modulus"),
    )
    lagging = replace(lagging, wear_coefficient=known("wear_coefficient", lagging.wear_coefficient))
    made: Pulley = replace(
        pulley,
        diameter=of("diameter"),
        wrap_angle=of("wrap_angle"),
        lagging=lagging,
        conditions=(),
        overrun=known("overrun", pulley.overrun),
        recovery=bool(of("recovery")) if "recovery" in table else pulley.recovery,
        creep_limit=known("creep_limit", pulley.creep_limit),
    )
    belt = replace(
        belt,
        width=of("belt_width"),
        modulus=of("belt_modulus"),
        speed=known("belt_speed", belt.speed),
    )
    at = Tensions(entry=of("entry_tension"), exit=of("exit_tension"))
    loaded: LoadCase = replace(case, tensions={pulley.name: at}, condition="")
    return replace(
        like, belt=belt, pulleys=(made,), load_cases=(loaded,), conveyor=None, read_from=None
    )
