"""The grip of a solved arc: where its belt slides, and what is known once it was asked."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol
from weakref import WeakKeyDictionary

from wraparc.arc.gross_slip import Line, outweighs, residual_capacity
from wraparc.arc.sliding import (
    AtLimit,
    Loaded,
    Sliding,
    at_limits,
    lift_for_safety,
    pull_at_sliding,
    wet_creep,
)
from wraparc.arc.wrap_arc import WrapArc


class _Capacities(Protocol):
    @property
    def gross_slip_creep(self) -> float: ...


class SolvedArc(Protocol):
    """The part of an `ArcResult` that its grip needs; the result takes its safety from here."""

    @property
    def arc(self) -> WrapArc:
        """What was solved."""
        ...

    @property
    def capacities(self) -> _Capacities:
        """How much it carries."""
        ...


def loaded(result: SolvedArc) -> Loaded:
    """Return an arc as it is asked when its belt slides."""
    return loaded_arc(result.arc, result.capacities.gross_slip_creep)


def loaded_arc(arc: WrapArc, most_creep: float = math.nan) -> Loaded:
    """Return the same of an arc whose creep at the largest ratio may be known [m]."""
    law, geometry, load = arc.law.compact(), arc.geometry(), arc.load()
    peaks = load.steepest_fall < 0.0 and most_creep != math.inf
    if peaks and math.isnan(most_creep):
        tight = max(load.entry_tension, load.exit_tension)
        pressure = tight / (geometry.width * geometry.radius)
        left = residual_capacity(law, pressure, geometry.wrap_angle)
        peaks = outweighs(law, geometry, tight, left)
    return Loaded(law, geometry, load, peaks)


@dataclass(frozen=True)
class Rise:
    """How the tensions of an arc grow with the pull of the whole drive, the take-up holding.

    Attributes
    ----------
    tight, slack
        Growth of the tight and the slack side per growth of the pull [N].
    """

    tight: float
    slack: float


def sliding(result: SolvedArc, rise: Rise | None = None) -> Sliding:
    """Return the pull at which the belt of an arc slides over its pull, the whole growing alike.

    Parameters
    ----------
    result
        The arc, solved.
    rise
        How its tensions grow with the pull, if not as the take-up of its drive lets them.
    """
    arc = result.arc
    if rise is None:
        pull = abs(arc.effective_tension)
        rise = Rise(arc.growth.tight * pull, arc.growth.slack * pull)
    tight = max(arc.entry_tension, arc.exit_tension)
    slack = min(arc.entry_tension, arc.exit_tension)
    line = Line(tight - arc.centrifugal, slack - arc.centrifugal, rise.tight, rise.slack)
    known = _grip_of(result)
    if line not in known.slidings:  # it is asked for every table, in both systems of units
        known.slidings[line] = pull_at_sliding(known.of, line, known.begin)
    return known.slidings[line]


def lift(result: SolvedArc, factor: float, tight_rise: float) -> float:
    """Return by how much all tensions must rise for a safety factor against sliding [N].

    As `wraparc.arc.sliding.lift_for_safety`.
    """
    known = _grip_of(result)
    if (factor, tight_rise) not in known.lifts:
        known.lifts[factor, tight_rise] = lift_for_safety(known.of, factor, tight_rise, known.begin)
    return known.lifts[factor, tight_rise]


def wet(result: SolvedArc, factor: float) -> float:
    """Return the creep at the exit of an arc with a factor on its friction, see `wet_creep` [m]."""
    return wet_creep(loaded(result), factor)


@dataclass
class _Grip:
    """What is known of the grip of an arc, and with what further questions of it begin."""

    of: Loaded
    begin: list[AtLimit]
    slidings: dict[Line, Sliding]
    lifts: dict[tuple[float, float], float]


def _grip_of(result: SolvedArc) -> _Grip:
    """Return what is known of the grip of an arc, by whichever method it was solved."""
    of, known = loaded(result), _grips.setdefault(result.arc, {})
    if of.peaks not in known:
        known[of.peaks] = _Grip(of, at_limits(of), {}, {})
    return known[of.peaks]


_grips: WeakKeyDictionary[WrapArc, dict[bool, _Grip]] = WeakKeyDictionary()
