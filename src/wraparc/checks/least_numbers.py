"""What the checks of one arc ask of the slack side: plain numbers only, see `checks.numbers`."""

from __future__ import annotations

from math import exp, inf, nan
from typing import NamedTuple

from wraparc.arc.kernel.answer import solve_tension
from wraparc.arc.kernel.capacity import carry, meet
from wraparc.arc.kernel.effort import SLIP, Aim
from wraparc.arc.kernel.quantities import SOLVED, Geometry, parameters_at
from wraparc.friction.compact import CompactLaw

_STEPS = 24


class Pull(NamedTuple):
    """An arc whose slack-side tension is sought, its pull held [N]."""

    pull: float  # |T1 - T2|
    tight: float  # the larger tension
    top: float  # the largest tight-side tension to consider


def least_for_slip(law: CompactLaw, geometry: Geometry, of: Pull, limit: float) -> float:
    """Least slack-side tension with which the slip at the exit keeps a limit [N]; inf if none."""
    outcome, z, entry, _ = carry(law, geometry, of.tight, Aim(SLIP, limit), nan, _STEPS)
    if outcome == SOLVED:
        met, _, entry, shot, growth = meet(
            law, geometry, Aim(SLIP, limit), True, of.pull, entry, z, 1.5 * of.top, _STEPS
        )
        found = max(entry, entry * exp(shot.log_tension))
        if met and growth > 0.0 and found <= of.top:
            return found - of.pull
    return _by_halving(law, geometry, of, limit)


def _by_halving(law: CompactLaw, geometry: Geometry, of: Pull, limit: float) -> float:
    low, high = of.pull * (1.0 + 1e-6), of.top
    if low >= high or _slips(law, geometry, of.pull, high) > limit:
        return inf
    while high - low > 1e-6 * high:
        middle = 0.5 * (low + high)
        if _slips(law, geometry, of.pull, middle) > limit:
            low = middle
        else:
            high = middle
    return high - of.pull


def _slips(law: CompactLaw, geometry: Geometry, pull: float, tight: float) -> float:
    """Slip at the exit with a tension of the tight side [m]; inf where it is not carried."""
    entry = tight if geometry.side > 0.0 else tight - pull
    leaving = tight - pull if geometry.side > 0.0 else tight
    found = solve_tension(law, parameters_at(entry, geometry), leaving, _STEPS)
    return abs(found.shot.slip) if found.outcome == SOLVED else inf
