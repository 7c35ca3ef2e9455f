"""How exactly the drives of a train must be matched: all that `wraparc trim` tells."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from wraparc.arc import Distributed
from wraparc.drive import Lagging
from wraparc.drive.conditions import Condition
from wraparc.errors import InputError
from wraparc.train.change import what_if
from wraparc.train.curve import ShareCurve, share_curve
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.solve import solve_case
from wraparc.train.train import Shares, Train
from wraparc.train.walk import Axis

#: Wear whose consequences are told, unless another is given [m].
WEAR = 1e-3


@dataclass(frozen=True, eq=False)
class Change:
    """What happened to one drum, and the load case after it.

    Attributes
    ----------
    pulley
        The drum.
    wear
        Depth worn off its lagging [m].
    lagging
        What its lagging became instead, or None.
    after
        The load case, the speeds held.
    """

    pulley: str
    wear: float
    lagging: Lagging | None
    after: CaseResult


@dataclass(frozen=True, eq=False)
class Matching:
    """How the shares of a train answer to trims, diameters, load, wear and water.

    Attributes
    ----------
    case
        The load case, solved.
    equal
        The same with equal shares: its trims are those that equalise.
    drive
        Whose trim and diameter are varied, by index.
    trim, diameter, load
        Shares against each of them.
    changes
        One drum worn, or its lagging changed.
    """

    case: CaseResult
    equal: CaseResult
    drive: int
    trim: ShareCurve
    diameter: ShareCurve
    load: ShareCurve
    changes: tuple[Change, ...]


def match_drives(
    result: TrainResult,
    case: str = "",
    *,
    drive: int = 1,
    wear: float = WEAR,
    laggings: Mapping[str, Lagging] | None = None,
    span: tuple[float, float] | None = None,
    points: int = 101,
) -> Matching:
    """Return how exactly the drives of a solved train must be matched.

    Parameters
    ----------
    result, case
        The solved train, and the load case (the first one without a name).
    drive
        Whose trim and diameter are varied, by index.
    wear
        Depth worn off the lagging of one drum after the other [m]; left out where a lagging is
        thinner.
    laggings
        By pulley: what its lagging becomes, one after the other, for example wet.
    span, points
        Ends of the trims, and points of each curve, as for `share_curve`.

    Raises
    ------
    InputError
        As `share_curve`.
    """
    trim = share_curve(result, case, axis=Axis.TRIM, drive=drive, span=span, points=points)
    diameter = share_curve(result, case, axis=Axis.DIAMETER, drive=drive, points=points)
    load = share_curve(result, case, axis=Axis.LOAD, drive=drive, points=points)
    quick = Distributed(capacities=False)
    count = len(result.train.pulleys)
    even = replace(trim.case.case, division=Shares((1.0 / count,) * count))
    equal = solve_case(replace(result.train, cases=(even,)), even, quick)
    changes = []
    for pulley in result.train.pulleys:
        if 0.0 < wear <= pulley.lagging.thickness:
            after = what_if(result, case, pulley=pulley.name, wear=wear, method=quick)
            changes.append(Change(pulley.name, wear, None, after))
    for name, lagging in (laggings or {}).items():
        after = what_if(result, case, pulley=name, lagging=lagging, method=quick)
        changes.append(Change(name, 0.0, lagging, after))
    return Matching(trim.case, equal, drive, trim, diameter, load, tuple(changes))


def wet_laggings(train: Train) -> dict[str, Lagging]:
    """Return laggings of the pulleys when wet, as `Condition` has them for a drive that asks.

    Pulleys that are wet already, and those of which nothing is known when wet, are left out.
    """
    wet = Condition(name="wet")
    found = {}
    for pulley in train.pulleys:
        asked = next((lag for lag in pulley.conditions if lag.condition == wet.name), None)
        if pulley.lagging.condition != wet.name:
            try:
                found[pulley.name] = asked or wet.lagging(pulley.lagging)
            except InputError:  # nothing is published on its surface
                continue
    return found
