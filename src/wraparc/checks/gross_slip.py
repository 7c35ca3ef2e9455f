"""How much more pull until the belt slides: by what the take-up holds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wraparc.arc import ArcResult, DriveResult, WrapArc
from wraparc.arc.grip import Rise, sliding
from wraparc.arrays import Array
from wraparc.drive import TakeUp
from wraparc.drive.pull import given_up, rise_among, rises_of


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
    after = take_up.place_among(names)
    return Rise(*map(float, rise_among(pulls, index, take_up.fixed, after)))


def _rise(pulls: Array, index: int, lost: Array) -> Rise:
    tight, slack = rises_of(pulls, index, lost)
    return Rise(float(tight[0]), float(slack[0]))


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
