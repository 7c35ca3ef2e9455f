"""How much more pull until the belt slides: by what the take-up holds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.arc.gross_slip import Line, outweighs, residual_capacity
from wraparc.arrays import Array
from wraparc.checks.numbers import rise_among
from wraparc.checks.sliding import (
    AtLimit,
    Loaded,
    Sliding,
    at_limits,
    lift_for_safety,
    pull_at_sliding,
    wet_creep,
)
from wraparc.drive import TakeUp


def loaded(result: ArcResult) -> Loaded:
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


def rises(arcs: Sequence[WrapArc], index: int, take_up: TakeUp) -> Rise:
    """Return how the tensions of one of the arcs of a load case grow with the whole pull.

    Every pulley keeps its share of it.

    Parameters
    ----------
    arcs
        All arcs of the load case, in belt order.
    index
        Which.
    take_up
        What is held.
    """
    pulls, names = [arc.effective_tension for arc in arcs], [arc.pulley for arc in arcs]
    after = names.index(take_up.after) if take_up.after else -1
    return Rise(*map(float, rise_among(pulls, index, take_up.fixed, after)))


def _rise(pulls: Array, index: int, lost: Array) -> Rise:
    tight, slack = rises_of(pulls, index, lost)
    return Rise(float(tight[0]), float(slack[0]))


def given_up(pulls: Array, names: Sequence[str], take_up: TakeUp) -> Array:
    """Return how much less all tensions grow than if the slack end were held, shape (n,) [N].

    Parameters
    ----------
    pulls
        As for `rises_of`.
    names
        The pulleys.
    take_up
        What is held: the slack end, the belt behind one of the pulleys, or the sum of both ends.
    """
    total: Array = pulls.sum(axis=0)
    if take_up.fixed:
        return np.asarray(0.5 * np.abs(total))
    if not take_up.after:
        return np.zeros(len(total))
    # what the belt there would grow by
    after = names.index(take_up.after) + 1
    lost = np.where(total >= 0.0, pulls[after:].sum(axis=0), -pulls[:after].sum(axis=0))
    return np.asarray(lost)


def rises_of(pulls: Array, index: int, lost: Array) -> tuple[Array, Array]:
    """Return the same of many drives: growth of the tight and of the slack side, (n,) each [N].

    Parameters
    ----------
    pulls
        Effective tension of every pulley in belt order, shape (pulleys, n) [N].
    index
        As for `rises`.
    lost
        See `given_up`, shape (n,) [N].
    """
    total = pulls.sum(axis=0)
    behind, ahead = pulls[index + 1 :].sum(axis=0), pulls[:index].sum(axis=0)
    entry = np.where(total >= 0.0, pulls[index] + behind, -ahead) - lost
    leaving = np.where(total >= 0.0, behind, -ahead - pulls[index]) - lost
    driving = pulls[index] >= 0.0
    return np.where(driving, entry, leaving), np.where(driving, leaving, entry)


def sliding(result: ArcResult, rise: Rise) -> Sliding:
    """Return the pull at which the belt of an arc slides over its pull, the whole growing alike."""
    arc = result.arc
    tight = max(arc.entry_tension, arc.exit_tension)
    slack = min(arc.entry_tension, arc.exit_tension)
    line = Line(tight - arc.centrifugal, slack - arc.centrifugal, rise.tight, rise.slack)
    known = _grip_of(result)
    if line not in known.slidings:  # it is asked for every table, in both systems of units
        known.slidings[line] = pull_at_sliding(known.of, line, known.begin)
    return known.slidings[line]


def lift(result: ArcResult, factor: float, tight_rise: float) -> float:
    """Return by how much all tensions must rise for a safety factor against sliding [N].

    As `wraparc.checks.sliding.lift_for_safety`.
    """
    known = _grip_of(result)
    if (factor, tight_rise) not in known.lifts:
        known.lifts[factor, tight_rise] = lift_for_safety(known.of, factor, tight_rise, known.begin)
    return known.lifts[factor, tight_rise]


def wet(result: ArcResult, factor: float) -> float:
    """Return the creep at the exit of an arc with a factor on its friction, see `wet_creep` [m]."""
    return wet_creep(loaded(result), factor)


@dataclass
class _Grip:
    """What is known of the grip of an arc, and with what further questions of it begin."""

    of: Loaded
    begin: list[AtLimit]
    slidings: dict[Line, Sliding]
    lifts: dict[tuple[float, float], float]


def _grip_of(result: ArcResult) -> _Grip:
    """Return what is known of the grip of an arc, by whichever method it was solved."""
    of, known = loaded(result), _grips.setdefault(result.arc, {})
    if of.peaks not in known:
        known[of.peaks] = _Grip(of, at_limits(of), {}, {})
    return known[of.peaks]


_grips: WeakKeyDictionary[WrapArc, dict[bool, _Grip]] = WeakKeyDictionary()


@dataclass(frozen=True)
class Margins:
    """Pull at which the belt slides over the pull, by what the take-up holds [-].

    Attributes
    ----------
    slack_held
        Gravity take-up or winch: the belt keeps its tension there, on the slack side of the drives
        where nothing else is said.
    both_held
        Fixed take-up: the sum of both keeps.
    tight_held
        The tight side keeps its tension.
    """

    slack_held: float
    both_held: float
    tight_held: float

    def of(self, *, fixed: bool) -> float:
        """Return the margin of a take-up."""
        return self.both_held if fixed else self.slack_held


def margins_of(result: DriveResult, arc: ArcResult) -> Margins:
    """Return the margins to sliding of an arc among the others of its load case."""
    arcs = [a for a in result if a.arc.load_case == arc.arc.load_case]
    index, after = arcs.index(arc), result.drive.criteria.take_up.after
    pulls = np.array([[r.arc.effective_tension] for r in arcs])
    names = [r.arc.pulley for r in arcs]
    total = np.abs(pulls.sum(axis=0))
    held = given_up(pulls, names, TakeUp(after=after))
    rise = (_rise(pulls, index, lost) for lost in (held, 0.5 * total, total))
    return Margins(*(sliding(arc, r).place for r in rise))
