"""Repeats that disagree: each curve against the others tested at its pressure."""

import numpy as np
from numpy.typing import NDArray

from wraparc.shear_test.pressure_choice import leave_out
from wraparc.shear_test.pressure_fit import (
    CurvePoints,
    PressureFit,
    scatter_between,
    scatter_within,
)
from wraparc.shear_test.record import Array

#: Standard deviations from its repeats at which a curve is called an outlier.
FAR = 4.5
_MOST = 0.25
_OTHERS = 5


def repeat_distances(points: CurvePoints, flagged: NDArray[np.bool_]) -> Array:
    """Distance of each curve from the mean of its repeats [standard deviations].

    The scatter between samples is taken from all other curves that are not flagged, so
    that a curve does not hide behind the scatter it makes itself. NaN without a repeat.
    """
    distances = np.full(len(points.level), np.nan)
    for k in range(len(points.level)):
        others = ~flagged
        others[k] = False
        repeats = others & (points.level == points.level[k])
        scatter = scatter_within(points.only(others))
        if not repeats.any() or scatter is None:
            continue
        count = int(repeats.sum())
        off = points.value[k] - points.value[repeats].mean(0)
        spread = scatter * (1.0 + 1.0 / count) + points.covariance[k]
        spread = spread + points.covariance[repeats].sum(0) / count**2
        distances[k] = float(np.sqrt(off @ np.linalg.solve(spread, off)))
    return distances


def outliers(points: CurvePoints) -> tuple[NDArray[np.bool_], Array]:
    """Curves that disagree with their repeats, the farthest first, at most a quarter of all.

    Of only two repeats that disagree neither can be told to be the wrong one; both are then
    flagged.

    Returns
    -------
    flagged
        Shape (n,).
    distances
        Of each curve, of the flagged ones when they were flagged, shape (n,).
    """
    flagged = np.zeros(len(points.level), dtype=bool)
    distances = repeat_distances(points, flagged)
    for _ in range(int(_MOST * len(flagged))):
        open_ones = np.where(flagged | ~np.isfinite(distances), -1.0, distances)
        worst = int(np.argmax(open_ones))
        if open_ones[worst] < FAR:
            break
        same = points.level == points.level[worst]
        if int((same & ~flagged).sum()) == 2:
            flagged |= same
        flagged[worst] = True
        distances = np.where(flagged, distances, repeat_distances(points, flagged))
    return flagged, distances


def lone_distances(law: PressureFit, points: CurvePoints) -> Array:
    """Distance of each unrepeated curve from the law of all others [standard deviations].

    Form kept, parameters and scatter fitted anew without the curve; NaN for a repeated one,
    and where fewer than five other pressures are left to tell it by.
    """
    distances = np.full(len(points.level), np.nan)
    for k, level in enumerate(points.level.tolist()):
        rest = points.only(points.level != level)
        if (points.level == level).sum() > 1 or len(np.unique(rest.level)) < _OTHERS:
            continue
        without = leave_out(law, points, level)
        if without is None:
            continue
        if without.form.nodes:
            scatter = without.scatter
        else:
            scatter = scatter_between(
                without.form, rest, without.scatter, start=without.theta, ends=without.ends
            )
        at = points.pressure[k : k + 1]
        spread = scatter + points.covariance[k] + without.own_covariance(at)[0]
        off = points.value[k] - without.peaks(at)[0]
        distances[k] = float(np.sqrt(off @ np.linalg.solve(spread, off)))
    return distances
