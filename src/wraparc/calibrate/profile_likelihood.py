"""How far a fitted variable may move before the data mind: intervals by profile likelihood.

The curvature at the best fit describes the data near it only. Where they tell little, the best fit
may lie where the model happens to be steep, and the curvature then promises what the data do not
hold. The profile asks again at every value: with this variable held and all others fitted anew, how
much worse do the data become (Venzon and Moolgavkar, 1988).
"""

from __future__ import annotations

import math
from collections.abc import Callable

from wraparc.arrays import Array

#: Refits along one side at most.
_MOST = 8
#: The end is where the root of the deviance is this near its goal.
_NEAR = 0.03
_STRETCH = 2.5


def profile_end(
    refit: Callable[[float, Array], tuple[float, Array]],
    best: Array,
    index: int,
    cost: float,
    step: float,
    goal: float,
    limit: float,
) -> float | None:
    """Return where the root of the deviance reaches its goal on one side, None if nowhere.

    Parameters
    ----------
    refit
        Gives the least sum of squares with the variable held at a value, and all variables there;
        the second argument is where to start.
    best
        Variables at the best fit, shape (n,).
    index
        Which one is moved.
    cost
        Sum of squares at the best fit.
    step
        First step, with its sign; the end by curvature.
    goal
        Half width of the interval in standard deviations.
    limit
        Where to give up: the farthest value worth asking for.
    """
    start, side = float(best[index]), math.copysign(1.0, step)
    inner, inner_root, x = start, 0.0, best
    outer: tuple[float, float] | None = None
    value = _within(start + step, limit, side)
    for _ in range(_MOST):
        sum_of_squares, x = refit(value, x)
        root = math.sqrt(max(sum_of_squares - cost, 0.0))
        if abs(root - goal) < _NEAR * goal:
            return value
        if root < goal:
            if value == limit:
                return None
            inner, inner_root = value, root
            if outer is None:
                ahead = _extrapolated(start, value, root, goal)
                value = _within(ahead, limit, side)
                continue
        else:
            outer = (value, root)
        value = inner + (outer[0] - inner) * (goal - inner_root) / (outer[1] - inner_root)
    return value if outer is not None else None


def _extrapolated(start: float, value: float, root: float, goal: float) -> float:
    """Return where a root that grows in proportion would reach its goal, not too far ahead."""
    share = goal / root if root > 0.0 else _STRETCH
    return start + (value - start) * min(1.05 * share, _STRETCH)


def _within(value: float, limit: float, side: float) -> float:
    return min(value, limit) if side > 0.0 else max(value, limit)
