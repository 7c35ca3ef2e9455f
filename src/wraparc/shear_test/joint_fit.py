"""All curves at once: poorly determined curves borrow from the others, the law gains from all.

A curve whose peak lies far beyond the tested slip has a skewed, not a normal, error. It is
therefore refitted with what the law of the others says as its prior, and enters the law by
the part of its likelihood near that solution (the alternation of Lindstrom and Bates 1990
for mixed-effects models), until the law no longer moves. Curves that fix their peaks by
themselves are the same before and after.
"""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.shear_test.curve_fit import CurveFit, Prior, bins_alike, fit_curve
from wraparc.shear_test.pressure_choice import settled
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit
from wraparc.shear_test.reduce import FrictionCurve

# A curve with a smaller error of ln x_pk than this is as good as normal by itself.
_SURE = 0.02
_ROUNDS = 4
_STEADY = 1e-4
_LARGEST = 0.7


def curve_points(
    curves: Sequence[FrictionCurve], fits: Sequence[CurveFit], levels: Integers
) -> CurvePoints:
    """Curves as points over pressure.

    An unknown zero of the force is no noise of theirs: where it differs between tests, their
    scatter shows it, and what is common to them is added to the law (`with_unknown_zero`).
    """
    return CurvePoints(
        pressure=np.array([curve.pressure for curve in curves]),
        value=np.array([_peak(fit) for fit in fits]),
        covariance=np.array([_of_readings(fit) for fit in fits]),
        level=levels,
    )


def _peak(fit: CurveFit) -> Array:
    return np.array([fit.parameters.ln_peak_slip, fit.parameters.ln_peak_friction])


def _of_readings(fit: CurveFit) -> Array:
    """Covariance of the peak by the scatter of the readings alone."""
    by_zero = fit.by_zero[:2]
    return np.asarray(fit.covariance[:2, :2] - np.outer(by_zero, by_zero))


def refine(
    curves: Sequence[FrictionCurve],
    fits: Sequence[CurveFit],
    points: CurvePoints,
    law: PressureFit,
    flagged: Flags,
) -> tuple[PressureFit, CurvePoints]:
    """Refine the law with all curves at once.

    Parameters
    ----------
    curves, fits
        Curves and their own fits.
    points
        From `curve_points`.
    law
        Fit over pressure, whose form is kept.
    flagged
        Curves that disagree with their repeats.

    Returns
    -------
    law, points
        After the last round.
    """
    unsure = [k for k, fit in enumerate(fits) if fit.error("ln_peak_slip") > _SURE]
    given = law.transition_pressure if law.transition_given else None
    for _ in range(_ROUNDS if unsure else 0):
        value, covariance = points.value.copy(), points.covariance.copy()
        mean = law.peaks(points.pressure)
        for k in unsure:
            value[k], covariance[k] = _informed(curves[k], fits[k], mean[k], law.scatter)
        moved = CurvePoints(points.pressure, value, covariance, points.level)
        refined = settled(law, moved, flagged, given)
        change = np.abs(refined.peaks(points.pressure) - mean).max()
        # Curves that together do not determine a peak would carry the law away.
        if not change < _LARGEST:
            break
        law, points = refined, moved
        if change < _STEADY:
            break
    return law, points


def _informed(
    curve: FrictionCurve, own: CurveFit, mean: Array, scatter: Array
) -> tuple[Array, Array]:
    """Point and covariance of a curve's likelihood near its solution under the law.

    With the prior N(m, P) the solution f is where H (y - f) = P^-1 (f - m), H the curvature of the
    loss that was minimised: the data alone, seen from f, say y = f + H^-1 P^-1 (f - m). With the
    covariance of y in the place of H^-1, larger by the memory of the noise, y would overshoot its
    own curve, and the law drift off all of them.
    """
    # Correlated readings tell less than the weights of the curve's fit assume.
    prior = scatter / bins_alike(curve, own)
    fit = fit_curve(curve, bending=own.bending, start=own, prior=Prior(mean=mean, covariance=prior))
    found = _peak(fit)
    return found + fit.flatness @ np.linalg.solve(prior, found - mean), _of_readings(fit)
