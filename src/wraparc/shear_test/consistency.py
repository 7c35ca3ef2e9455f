"""Repeats that disagree: each curve against the others tested at its pressure."""

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.shear_test.pressure_fit import CurvePoints, scatter_within

#: Standard deviations from the trend of the others at which an unrepeated curve is named.
FAR = 4.5
# How often a curve that is none is called an outlier.
_FALSE_ALARM = 0.002
_MOST = 0.25
_OTHERS = 5
#: Scatter of samples about a trend, in ln x_pk and ln mu_pk, and the degrees of freedom it counts.
USUAL, USUAL_WEIGHT = 0.03, 4.0


def repeat_distances(points: CurvePoints, flagged: Flags) -> Array:
    """Distance of each curve from the mean of its repeats [standard deviations].

    The scatter between samples is taken from all other curves that are not flagged, so
    that a curve does not hide behind the scatter it makes itself; of few degrees of freedom, it is
    drawn towards a usual one. NaN without a repeat.
    """
    distances = np.full(len(points.level), np.nan)
    for k in range(len(points.level)):
        others = ~flagged
        others[k] = False
        repeats = others & (points.level == points.level[k])
        if not repeats.any():
            continue
        scatter, _ = towards_usual(points.only(others))
        count = int(repeats.sum())
        off = points.value[k] - points.value[repeats].mean(0)
        spread = scatter * (1.0 + 1.0 / count) + points.covariance[k]
        spread = spread + points.covariance[repeats].sum(0) / count**2
        distances[k] = float(np.sqrt(off @ np.linalg.solve(spread, off)))
    return distances


def _freedom(points: CurvePoints) -> int:
    """Degrees of freedom of the scatter within the pressures."""
    return len(points.level) - len(np.unique(points.level))


def towards_usual(
    points: CurvePoints, otherwise: tuple[Array, float] | None = None
) -> tuple[Array, float]:
    """Scatter between samples, and a usual one that counts as a few more of them.

    Parameters
    ----------
    points
        The curves.
    otherwise
        Scatter and its degrees of freedom to take where there are too few repeats.

    Returns
    -------
    scatter, freedom
        Shape (2, 2); degrees of freedom of a Hotelling distance with it.
    """
    usual, found, freedom = USUAL**2 * np.eye(2), scatter_within(points), float(_freedom(points))
    if found is None:
        found, freedom = otherwise or (usual, 0.0)
    weighted = (freedom * found + USUAL_WEIGHT * usual) / (freedom + USUAL_WEIGHT)
    return weighted, freedom + USUAL_WEIGHT - 1.0


def outliers(points: CurvePoints) -> tuple[Flags, Array]:
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
        if open_ones[worst] < _far_off(points, flagged, worst):
            break
        same = points.level == points.level[worst]
        if int((same & ~flagged).sum()) == 2:
            flagged |= same
        flagged[worst] = True
        distances = np.where(flagged, distances, repeat_distances(points, flagged))
    return flagged, distances


def _far_off(points: CurvePoints, flagged: Flags, own: int) -> float:
    """Distance from its repeats at which a curve is an outlier: more, the fewer repeats there are.

    Hotelling's T^2 = 2 n/(n - 1) F(2, n - 1) for a scatter of n degrees of freedom; the
    quantile of F with 2 and m is (m/2) (alpha^(-2/m) - 1).
    """
    others = ~flagged
    others[own] = False
    m = _freedom(points.only(others)) + USUAL_WEIGHT - 1.0
    quantile = 0.5 * m * (_FALSE_ALARM ** (-2.0 / m) - 1.0)
    return float(np.sqrt(2.0 * (m + 1) / m * quantile))


def lone_distances(points: CurvePoints) -> Array:
    """Distance of each unrepeated curve from the trend of all other pressures [std deviations].

    The trend is a parabola of ln x_pk, and one of ln mu_pk, over the root of p through the
    means of the other pressures: no form of the law, whose choice suffers from the outlier. The
    spread about it, of few degrees of freedom, is drawn towards a usual scatter of samples.
    Counted is the larger of the two distances. NaN for a repeated curve, and where fewer than
    five other pressures are left to tell it by.
    """
    distances = np.full(len(points.level), np.nan)
    levels = np.unique(points.level)
    means = np.array([points.value[points.level == k].mean(0) for k in levels])
    roots = np.sqrt(points.level_pressures)
    roots, at = roots / roots[-1], np.sqrt(points.pressure) / roots[-1]
    for k, level in enumerate(points.level.tolist()):
        others = levels != level
        if (points.level == level).sum() > 1 or others.sum() < _OTHERS:
            continue
        x = roots[others] - at[k]
        design = np.stack([np.ones_like(x), x, x**2], axis=-1)
        inverse = np.linalg.inv(design.T @ design)
        trend = inverse @ design.T @ means[others]
        squares = ((means[others] - design @ trend) ** 2).sum(0)
        freedom = len(x) - 3
        variance = (squares + USUAL_WEIGHT * USUAL**2) / (freedom + USUAL_WEIGHT)
        own = np.diag(points.covariance[k])
        off = np.abs(points.value[k] - trend[0])
        distances[k] = float((off / np.sqrt(variance * (1.0 + inverse[0, 0]) + own)).max())
    return distances
