"""How probable the level of a verdict is, its inputs being uncertain: draws of all at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from statistics import NormalDist
from weakref import WeakKeyDictionary

import numpy as np

from wraparc.arrays import Array
from wraparc.checks import Level
from wraparc.drive import NORMAL_95
from wraparc.errors import InputError
from wraparc.reserve.draws import DrawLevels, draw_levels
from wraparc.reserve.find import changed_inputs, find_reason
from wraparc.reserve.inputs import OF_DRIVES, Input
from wraparc.reserve.sobol import shifted_points
from wraparc.reserve.uncertainty import Uncertainty, uncertainty_of
from wraparc.train.whole import Whole, by_pulley

#: Draws, a power of 2, and what shifts them.
DRAWS, SEED = 4096, 54
#: Least and largest factor that is drawn [-].
_ENDS = (0.05, 4.0)
_LEVELS = (Level.OK, Level.ATTENTION, Level.FAILS)


@dataclass(frozen=True)
class Probability:
    """How the levels of a verdict are distributed.

    Attributes
    ----------
    shares
        Part of the draws with each level, OK first [-].
    draws
        How many there are; 0 where nothing is known.
    inputs
        What was drawn, with its uncertainty.
    reason
        Why nothing is known; empty where it is.
    """

    shares: Mapping[Level, float] = field(default_factory=dict)
    draws: int = 0
    inputs: tuple[tuple[Input, Uncertainty], ...] = ()
    reason: str = ""


_found: WeakKeyDictionary[Whole, Probability] = WeakKeyDictionary()


def find_probability(result: Whole) -> Probability:
    """Return how probable each level of the verdict on a drive or train is.

    All inputs of the reserve are drawn at once, each from a normal distribution about its value
    whose 95 % interval is its uncertainty, cut at 0.05 and 4 times the value: `DRAWS` Sobol points,
    always the same. What is one number is drawn once: friction, slip scale, G and E_c of a lagging
    on all its pulleys, the belt modulus, Te and T2 in all load cases. Draws are judged as rows;
    one of which there is no drive fails.
    """
    if result not in _found:
        _found[result] = _find(result)
    return _found[result]


def _find(result: Whole) -> Probability:
    drive, reason = by_pulley(result).drive, find_reason(result)
    if reason:
        return Probability(reason=reason)
    levels = drawn_levels(result)
    uncertainties = [uncertainty_of(drive, of) for of in levels.inputs]
    points = shifted_points(len(levels.inputs), DRAWS, SEED)
    try:
        rank = levels.of_draws(draw_factors(points, uncertainties))
    except InputError:
        return Probability(reason="drive without rows")
    rank = np.where(rank <= 0, Level.FAILS.rank, rank)
    shares = {level: float(np.mean(rank == level.rank)) for level in _LEVELS}
    return Probability(shares, DRAWS, tuple(zip(levels.inputs, uncertainties, strict=True)))


def drawn_levels(result: Whole) -> DrawLevels:
    """Return the levels of a drive by the inputs that are drawn, each number once."""
    inputs = tuple(of for of in changed_inputs(result) if of.name not in OF_DRIVES)
    single = {of.name for of in inputs if of.label}
    return draw_levels(result, tuple(of for of in inputs if of.label or of.name not in single))


def draw_factors(points: Array, uncertainties: list[Uncertainty]) -> Array:
    """Return factors on inputs at points of the unit cube, shape (n, inputs) [-]."""
    normal = NormalDist()
    factors = np.empty(points.shape)
    for k, of in enumerate(uncertainties):
        deviates = np.array([normal.inv_cdf(point) for point in points[:, k].tolist()])
        scale = np.where(deviates < 0.0, of.towards(-1.0), of.towards(1.0)) / NORMAL_95
        factors[:, k] = 1.0 + scale * deviates
    return np.clip(factors, *_ENDS)
