"""What the checks of one arc ask of the slack side: plain numbers only, see `checks.numbers`."""

from __future__ import annotations

from math import inf
from typing import NamedTuple

from wraparc.arc.capacity import Limit, carry, largest_ratio, least_slack
from wraparc.arc.collocation import SLIP
from wraparc.arc.gross_slip import Grip, Line, slip_place
from wraparc.arc.quantities import Geometry
from wraparc.checks.numbers import grip_beyond
from wraparc.friction.compact import CompactLaw

#: Change of a tension that a largest ratio is sought anew for [-].
_SETTLED = 1e-4
#: How often at most.
ROUNDS = 6


class Pull(NamedTuple):
    """An arc whose slack-side tension is sought, its pull held [N]."""

    pull: float  # |T1 - T2|
    tight: float  # the larger tension
    top: float  # the largest tight-side tension to consider


def least_for_slip(law: CompactLaw, geometry: Geometry, of: Pull, limit: float) -> float:
    """Least slack-side tension with which the slip at the exit keeps a limit [N]; inf if none."""
    most = Limit(SLIP, limit)
    met = carry(law, geometry, of.tight, most)
    least = least_slack(law, geometry, of.pull, most, met, of.top).slack
    return least if least == least else inf


class Safety(NamedTuple):
    """What the safety against gross slip asks for."""

    factor: float  # [-]
    rise: float  # growth of the tight side with the pull of the whole drive [N]
    softens: bool  # whether friction falls past its peak


def tight_at_slip(law: CompactLaw, grip: Grip, pull: float) -> float:
    """Tension of the tight side that just carries a pull at gross slip [N]; inf if none."""
    if pull <= 0.0:
        return 0.0
    # in units of the pull: T = k pull
    return pull * slip_place(law, grip, Line(pull, 0.0, pull, pull), -1.0, 1.0)


def lift_for_grip(
    law: CompactLaw, geometry: Geometry, grip: Grip, of: Pull, safety: Safety, rounds: int
) -> float:
    """How much all tensions must rise for the safety against gross slip [N].

    Where friction falls past its peak the largest ratio is sought anew, so many times, at the
    tension that was found.
    """
    lift = 0.0
    for i in range(rounds):
        # all tensions rise by the lift, and then with the pull
        tight = tight_at_slip(law, grip, safety.factor * of.pull)
        found = tight - of.tight - (safety.factor - 1.0) * safety.rise
        settled = not safety.softens or abs(found - lift) <= _SETTLED * of.tight
        lift = found
        if settled or lift == inf or i == rounds - 1:
            break
        raised = of.tight + lift
        known = largest_ratio(law, geometry, raised, True)[0]
        beyond = grip_beyond(law, known, raised / grip.area, grip.wrap_angle)
        grip = Grip(grip.wrap_angle, grip.area, beyond)
    return lift
