"""Steps and dents of friction over pressure, against laws that bend one way.

No form of a law is fair to all laggings: rubber whose contact saturates bends down, friction with a
constant part bends up, and a transition makes a kink. What they have in common is that ln mu over
ln p bends one way, or so nearly that few pressures do not show the rest. A damp sample, another
batch or another cell from a pressure on makes it bend both ways. So a step or a dent is what
improves the best convex **and** the best concave course, by Student's t.

Where it would be hidden: at three pressures or fewer every step is a bend, and at four or five a
small one may be. No statistic can tell it there; the document on shear tests says how often.
"""

from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.student import two_sided

# Least step of ln mu that is asked about, and how sure one of all those tried must be. Ours: of
# 400 drawn laboratories of four courses (power, saturation, constant part, transition), whose
# samples scatter by 1 to 4 %, 1.2 % are accused at most.
_STEP, _LEVEL = 0.05, 0.95
_LEAST_PRESSURES = 4


class Step(NamedTuple):
    """A step or a dent of friction over pressure.

    Attributes
    ----------
    size
        Of ln mu.
    pressure
        Number of the pressure in the dent, or of the first behind the step.
    is_dent
        Whether it is one pressure's, and not that of all from there on.
    """

    size: float
    pressure: int
    is_dent: bool


def step_over_pressure(
    pressure: Array, ln_friction: Array, variance: Array, freedom: float
) -> Step | None:
    """Return the step or dent that is surest, or None if chance and a bend explain all.

    Parameters
    ----------
    pressure
        Tested pressures, ascending [Pa], shape (n,).
    ln_friction
        Mean ln mu there, shape (n,).
    variance
        Of these means, shape (n,).
    freedom
        Degrees of freedom of the variance.
    """
    count = len(pressure)
    if count < _LEAST_PRESSURES:
        return None
    x, weights = np.log(pressure), 1.0 / np.sqrt(variance)
    place = np.arange(count)
    steps = [(Step(0.0, k, False), (place >= k) * 1.0) for k in range(2, count - 1)]
    dents = [(Step(0.0, k, True), (place == k) * 1.0) for k in range(1, count - 1)]
    sure = two_sided(freedom, 1.0 - (1.0 - _LEVEL) / len(steps + dents))
    without = [_bent(x, ln_friction, weights, way, None)[0] for way in (1.0, -1.0)]
    best, most = None, sure**2
    if min(without) < most:
        return None
    for step, shape in steps + dents:
        ways = [_bent(x, ln_friction, weights, way, shape) for way in (1.0, -1.0)]
        better = min(before - after for before, (after, _) in zip(without, ways, strict=True))
        size = min(ways)[1]
        if better > most and abs(size) > _STEP:
            best, most = step._replace(size=size), better
    return best


def _bent(
    x: Array, y: Array, weights: Array, way: float, shape: Array | None
) -> tuple[float, float]:
    """Sum of squares about the best course that bends one way, and the size of a shape beside it.

    A line and kinks at the inner pressures, whose sizes have one sign.
    """
    line = [np.ones_like(x), x, *([] if shape is None else [shape])]
    free = np.column_stack(line) * weights[:, None]
    kinks = way * np.maximum(x[:, None] - x[None, 1:-1], 0.0) * weights[:, None]
    base, _ = np.linalg.qr(free)
    across, target = kinks - base @ (base.T @ kinks), y * weights
    sizes = nonnegative(across, target - base @ (base.T @ target))
    off = target - kinks @ sizes
    found = np.linalg.lstsq(free, off, rcond=None)[0]
    return float(((off - free @ found) ** 2).sum()), float(found[-1])


def nonnegative(matrix: Array, target: Array) -> Array:
    """Least squares with no negative unknown, by active sets (Lawson and Hanson 1974, ch. 23).

    Parameters
    ----------
    matrix, target
        Shapes (m, n) and (m,).
    """
    count = matrix.shape[1]
    found, used = np.zeros(count), np.zeros(count, dtype=bool)
    least = 1e-10 * (1.0 + float(np.abs(matrix.T @ target).max(initial=0.0)))
    for _ in range(3 * count):
        slope = np.where(used, -np.inf, matrix.T @ (target - matrix @ found))
        if not count or slope.max() <= least:
            break
        used[int(np.argmax(slope))] = True
        while used.any():
            trial = np.zeros(count)
            trial[used] = np.linalg.lstsq(matrix[:, used], target, rcond=None)[0]
            low = used & (trial <= 0.0)
            if not low.any():
                found = trial
                break
            part = float((found[low] / np.maximum(found[low] - trial[low], 1e-300)).min())
            found = found + part * (trial - found)
            used &= found > 1e-12 * (1.0 + float(found.max()))
            found = np.where(used, found, 0.0)
    return found
