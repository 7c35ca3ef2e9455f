"""What the checks of one arc require of the slack side: plain numbers only."""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from wraparc.arc.capacity import Limit, carry, least_slack
from wraparc.arc.collocation import CREEP, SLIP
from wraparc.arc.quantities import Geometry
from wraparc.friction.compact import CompactLaw


class Pull(NamedTuple):
    """An arc whose slack-side tension is sought, its pull held [N]."""

    pull: float  # |T1 - T2|
    tight: float  # the larger tension
    top: float  # the largest tight-side tension to consider


def least_for_slip(law: CompactLaw, geometry: Geometry, of: Pull, limit: float) -> float:
    """Least slack-side tension with which the slip at the exit keeps a limit [N]; inf if none."""
    return _least_within(law, geometry, of, Limit(SLIP, limit))


def least_for_creep(law: CompactLaw, geometry: Geometry, of: Pull, limit: float) -> float:
    """Least slack-side tension with which the creep at the exit keeps a limit [N]; inf if none."""
    return _least_within(law, geometry, of, Limit(CREEP, limit))


def _least_within(law: CompactLaw, geometry: Geometry, of: Pull, limit: Limit) -> float:
    met = carry(law, geometry, of.tight, limit)
    least = least_slack(law, geometry, of.pull, limit, met, of.top).slack
    return least if least == least else inf
