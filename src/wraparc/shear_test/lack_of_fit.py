"""How far the chosen form may be from the truth, told by the repeats.

No lagging follows a trend line exactly. Repeats show how far samples of one pressure differ;
where the pressures' means lie further from the law than that explains, the rest is lack of
fit: it does not shrink with more samples, and belongs to the uncertainty of the law.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from wraparc.arrays import Flags
from wraparc.shear_test.curve_fit import CurveFit
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit, scatter_within

# Of the scatter about the law, what is lack of fit where repeats do not tell them apart.
_OF_SCATTER = 0.2


def with_lack_of_fit(law: PressureFit, points: CurvePoints, flagged: Flags) -> PressureFit:
    """Return the law with its lack of fit, where the repeats show one.

    Compared are the means of the pressures' curves less the law, r r', with what scatter
    and noise let expect, V. If the sum of r' V^-1 r is above its expected value, the mean of
    r r' (corrected for the fitted parameters) less V is taken; else none. Too few repeats cannot
    tell it from scatter: then a fifth of the variance about the law is taken for it. Ours, by
    simulation (benchmarks/shear_test_verdicts.py).

    Parameters
    ----------
    law
        The fit; one with a value of its own at each pressure lacks nothing.
    points
        The curves.
    flagged
        Curves that disagree with their repeats, and are left out of this.
    """
    good = points.only(~flagged)
    within = scatter_within(good)
    levels = np.unique(good.level)
    freedom = 2 * len(levels) - law.form.size
    if law.form.nodes or freedom < 1:
        return law
    reach = float(np.log(law.ends[1] / law.ends[0])) / max(len(levels) - 1, 1)
    if within is None:
        return replace(law, lack=_OF_SCATTER * law.scatter, lack_reach=reach)
    squares, expected, distance = np.zeros((2, 2)), np.zeros((2, 2)), 0.0
    for level in levels:
        inside = good.level == level
        off = (good.value[inside] - law.peaks(good.pressure[inside])).mean(0)
        spread = (within + good.covariance[inside].mean(0)) / int(inside.sum())
        distance += float(off @ np.linalg.solve(spread, off))
        squares += np.outer(off, off)
        expected += spread
    if distance <= freedom:
        return law
    values, vectors = np.linalg.eigh((squares * 2 * len(levels) / freedom - expected) / len(levels))
    lack = (vectors * np.maximum(values, 0.0)) @ vectors.T
    return replace(law, lack=lack, lack_reach=reach)


def with_unknown_zero(law: PressureFit, fits: Sequence[CurveFit]) -> PressureFit:
    """Return the law with the zero of the force that its records do not show, common to them."""
    parts = np.array([fit.by_zero[:2] for fit in fits])
    common = np.einsum("ni,nj->ij", parts, parts) / len(parts)
    if not common.any():
        return law
    lack = common if law.lack is None else law.lack + common
    return replace(law, lack=lack)
