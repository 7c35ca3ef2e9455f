"""How much more pull until gross slip: by what the take-up holds."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.arc import gross_slip as kernel
from wraparc.arc.capacity import largest_ratio
from wraparc.checks.least_numbers import tight_at_slip
from wraparc.checks.numbers import rise_among
from wraparc.drive import TakeUp

Array = NDArray[np.float64]

nan, inf = math.nan, math.inf


class Grip:
    """Largest ln(tight/slack) that the friction of an arc can carry, by tension of the tight side.

    A law flat past its peak has it in closed form. Where friction falls past its peak the largest
    ratio is sought at one tension, and taken from there to others as the plateau changes.

    Parameters
    ----------
    arc
        The arc; its tensions say where to seek.
    ratio
        Its gross-slip capacity where that is known already [-].
    """

    def __init__(self, arc: WrapArc, ratio: float = nan) -> None:
        self.law, self._arc = arc.law.compact(), arc
        #: Pull factors that were found, by how the tensions grow.
        self.places: dict[kernel.Line, float] = {}
        #: Whether friction falls past its peak, so that the offset holds near one tension only.
        self.softens = arc.law.steepest_fall() < 0.0
        self._known = math.log(ratio) if ratio > 0.0 else nan
        self._at = max(arc.entry_tension, arc.exit_tension)

    @cached_property
    def _offset(self) -> float:
        if not self.softens:
            return 0.0
        known = self._known
        if math.isnan(known):
            known = largest_ratio(self.law, self._arc.geometry(), self._at, True)[0]
        pressure = self._at / (self._arc.width * self._arc.radius)
        return known - kernel.plateau_capacity(self.law, pressure, self._arc.wrap_angle)

    @cached_property
    def numbers(self) -> kernel.Grip:
        """What the kernel knows of it."""
        arc = self._arc
        return kernel.Grip(arc.wrap_angle, arc.width * arc.radius, self._offset)

    def __call__(self, tight: float) -> float:
        """Return ln(tight/slack) at gross slip for a tension of the tight side [N]."""
        return kernel.carried_log(self.law, self.numbers, tight)

    def tight_for(self, pull: float) -> float:
        """Return the tension of the tight side that just carries a pull at gross slip [N].

        The root of ln(T/(T - pull)) = q(T); inf if no tension carries it.
        """
        return tight_at_slip(self.law, self.numbers, pull)


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


def rises(arcs: Sequence[ArcResult], index: int, take_up: TakeUp) -> Rise:
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
    pulls, names = [r.arc.effective_tension for r in arcs], [r.arc.pulley for r in arcs]
    after = names.index(take_up.after) if take_up.after else -1
    return Rise(*map(float, rise_among(pulls, index, take_up.fixed, after)))


def _pulls_of(arcs: Sequence[ArcResult]) -> Array:
    return np.array([[r.arc.effective_tension] for r in arcs])


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


def pull_factor(arc: WrapArc, grip: Grip, rise: Rise) -> float:
    """Pull at gross slip over the pull of the load case, the whole drive growing alike [-].

    The root k of ln(T_tight(k)/T_slack(k)) = q(T_tight(k)); inf if it never slips.
    """
    tight = max(arc.entry_tension, arc.exit_tension)
    slack = min(arc.entry_tension, arc.exit_tension)
    if tight == slack:
        return inf
    line = kernel.Line(tight, slack, rise.tight, rise.slack)
    if line not in grip.places:  # it is asked for every table, in both systems of units
        grip.places[line] = kernel.slip_place(grip.law, grip.numbers, line, 1.0, 0.0)
    return grip.places[line]


@dataclass(frozen=True)
class Margins:
    """Pull at gross slip over the pull, by what the take-up holds [-].

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


def margins(arcs: Sequence[ArcResult], index: int, grip: Grip, after: str = "") -> Margins:
    """Return the margins of one of the arcs of a load case to gross slip.

    `after` is the pulley behind which a gravity take-up stands, see `TakeUp`.
    """
    pulls, names = _pulls_of(arcs), [r.arc.pulley for r in arcs]
    total = np.abs(pulls.sum(axis=0))
    held = given_up(pulls, names, TakeUp(after=after))
    rise = (_rise(pulls, index, lost) for lost in (held, 0.5 * total, total))
    return Margins(*(pull_factor(arcs[index].arc, grip, r) for r in rise))


def grip_of(result: ArcResult) -> Grip:
    """Return what the friction of a solved arc can carry: the same one whenever it is asked."""
    if result not in _grips:
        _grips[result] = Grip(result.arc, result.capacities.gross_slip_capacity)
    return _grips[result]


_grips: WeakKeyDictionary[ArcResult, Grip] = WeakKeyDictionary()


def margins_of(result: DriveResult, arc: ArcResult) -> Margins:
    """Return the margins to gross slip of an arc among the others of its load case."""
    arcs = [a for a in result if a.arc.load_case == arc.arc.load_case]
    return margins(arcs, arcs.index(arc), grip_of(arc), result.drive.criteria.take_up.after)
