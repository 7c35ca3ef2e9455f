"""How the tensions of pulleys grow with the pull of a whole drive, and which pull is none."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.drive.criteria import TakeUp
from wraparc.drive.drive import Drive
from wraparc.drive.load_case import LoadCase
from wraparc.drive.pulley import Pulley

#: Pull over tension that counts as none [-].
IDLE = 1e-6


def idles(entry: float, leaving: float) -> bool:
    """Whether an arc hands nothing over: its pulley is not driven."""
    return abs(entry - leaving) <= IDLE * entry


def idle_rows(entry: Array, leaving: Array) -> Flags:
    """Return `idles` of many arcs, as flags of the same shape."""
    return np.asarray(np.abs(entry - leaving) <= IDLE * entry)


class Growth(NamedTuple):
    """How the tensions of a pulley grow, over the growth of its pull [-]."""

    tight: float
    slack: float


#: Of a drive of one pulley whose take-up holds the slack side.
ALONE = Growth(1.0, 0.0)


def growth_among(pulls: Sequence[float], index: int, fixed: bool, after: int) -> Growth:
    """Return how the tensions of one of several pulleys grow over its pull, see `rise_among`.

    Every pulley keeps its share of the pull; one that pulls nothing has no growth of its own.
    """
    mine = abs(pulls[index])
    if mine == 0.0:
        return ALONE
    tight, slack = rise_among(pulls, index, fixed, after)
    return Growth(tight / mine, slack / mine)


def growth_in(drive: Drive, case: LoadCase, pulley: Pulley) -> Growth:
    """Return how the tensions of a pulley grow in a load case, by what the take-up holds."""
    names, take_up = [p.name for p in drive.pulleys], drive.criteria.take_up
    pulls = [case.tensions[name].effective for name in names]
    index = names.index(pulley.name)
    return growth_among(pulls, index, take_up.fixed, take_up.place_among(names))


def rise_among(pulls: Sequence[float], index: int, fixed: bool, after: int) -> tuple[float, float]:
    """Growth of the tight and of the slack side of one of several pulleys with the pull of all [N].

    Every pulley keeps its share; `after` is the pulley that the take-up stands behind, or -1.
    """
    total, mine = sum(pulls), pulls[index]
    ahead = sum(pulls[:index])
    behind = sum(pulls[index + 1 :])
    lost = 0.5 * abs(total) if fixed else 0.0
    if not fixed and after >= 0:
        lost = sum(pulls[after + 1 :]) if total >= 0.0 else -sum(pulls[: after + 1])
    entry = (mine + behind if total >= 0.0 else -ahead) - lost
    leaving = (behind if total >= 0.0 else -ahead - mine) - lost
    return (entry, leaving) if mine >= 0.0 else (leaving, entry)


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
    after = take_up.place_among(names) + 1
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
