"""Each pressure predicted by the written law of the others, and whether chance explains the miss.

What is written keeps its friction below its pressures and its traction above, so that an end that
is left out has the error that a drive at that pressure would have.

In (ln x_pk, ln mu_pk) the difference d of the mean of a pressure's curves from the prediction has
the covariance V = that of the mean (scatter between samples and readings) + that of the
prediction, other forms and lack of fit included. d' V^-1 d / 2 is compared with the quantile of
F(2, m), m the degrees of freedom of the others, at a level shared by all inner pressures, so that
a sound laboratory is accused as seldom as `FALSE_ALARM` says.
"""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.friction import IntegralLog
from wraparc.shear_test.analysis import LeftOut, TestResult
from wraparc.shear_test.consistency import towards_usual
from wraparc.shear_test.curve_model import CurveParameters, friction_and_jacobian
from wraparc.shear_test.lack_of_fit import with_lack_of_fit
from wraparc.shear_test.law import knot_pressures, law_through
from wraparc.shear_test.pressure_choice import leave_out
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit
from wraparc.shear_test.tails import Tails

#: How often a sound laboratory is told that its law misses a pressure that was left out.
FALSE_ALARM = 0.02
# Error of ln x_pk and ln mu_pk between the points of a law without a trend. Ours.
_BETWEEN = 0.03
_LEAST_OTHERS = 4


def left_out_pressures(
    law: PressureFit,
    points: CurvePoints,
    tests: Sequence[TestResult],
    levels: Integers,
    tails: Tails,
) -> tuple[LeftOut, ...]:
    """Predict each pressure by the law of the others.

    Parameters
    ----------
    law
        Of all tests.
    points
        The curves it was fitted to.
    tests, levels
        Tests that agree with their repeats, and the number of the pressure of each.
    tails
        What follows the peak, at all pressures.
    """
    present = np.unique(levels)
    inner = max(len(present) - 2, 1)
    found = []
    for level in present.tolist():
        rest = leave_out(law, points, level)
        if rest is None:
            continue
        inside = np.flatnonzero(levels == level).tolist()
        pressure = float(np.mean([tests[k].curve.pressure for k in inside]))
        written = _written(rest, points.only(points.level != level), _without(tails, level))
        slip, peak, slope, residual = (float(v) for v in written.parameters(pressure))
        held = float(written.friction(slip, pressure)) / peak  # traction, above its last pressure
        predicted = [slip, held * peak, held * slope, held * residual]
        squares = [_squared_error(tests[k], predicted) for k in inside]
        distance, freedom = _distance(law, rest, points, level)
        found.append(
            LeftOut(
                pressure=pressure,
                inside=bool(present[0] < level < present[-1]),
                error=float(np.sqrt(np.mean(squares))),
                noise=float(np.mean([tests[k].curve.noise for k in inside])),
                scatter=_friction_scatter(law, predicted[1]),
                peak_slip=predicted[0],
                peak_friction=predicted[1],
                distance=distance,
                limit=_limit(freedom, FALSE_ALARM / inner),
            )
        )
    return tuple(found)


def _written(rest: PressureFit, points: CurvePoints, tails: Tails) -> IntegralLog:
    """The law of the others as it would be written: at its ends it stays as it is there."""
    at = points.level_pressures
    knots = knot_pressures(rest, tails, (float(at[0]), float(at[-1])))
    return law_through(knots, rest.peaks(knots), tails, 1.0)


def _limit(freedom: float, level: float) -> float:
    """Distance that chance exceeds with probability `level`: 2 F(2, m), in closed form."""
    return float(np.sqrt(freedom * (level ** (-2.0 / freedom) - 1.0)))


def _distance(
    law: PressureFit, rest: PressureFit, points: CurvePoints, level: int
) -> tuple[float, float]:
    """Distance of a pressure's mean from its prediction [standard deviations]; its freedom.

    NaN where the others are hardly enough to draw the form through them: the error of such a
    prediction cannot be known.
    """
    own = points.only(points.level == level)
    others = len(np.unique(points.level)) - 1
    if others < _LEAST_OTHERS if rest.form.nodes else 2 * others < rest.form.size + 2:
        return float("nan"), float("nan")
    at = np.array([float(own.pressure.mean())])
    rest_points = points.only(points.level != level)
    scatter, freedom = _own_scatter(rest, rest_points)
    trust = law.weights[points.level == level][:, None, None]
    weights = np.linalg.inv(own.covariance + scatter) * trust
    mean_covariance = np.linalg.inv(weights.sum(0))
    mean = mean_covariance @ np.einsum("nij,nj->i", weights, own.value)
    predicted = rest.peaks(at)[0]
    rest = with_lack_of_fit(rest, rest_points, np.zeros(len(rest_points.level), dtype=bool))
    spread = mean_covariance + rest.own_covariance(at)[0]
    if rest.form.nodes:
        spread = spread + _BETWEEN**2 * np.eye(2)
    if rest.lack is not None:
        spread = spread + rest.lack  # of this pressure itself
    for weight, form in law.alternatives:
        other = None if form.form.nodes else leave_out(form, points, level)
        if other is not None:
            off = other.peaks(at)[0] - predicted
            spread = spread + weight * np.outer(off, off)
    off = mean - predicted
    return float(np.sqrt(off @ np.linalg.solve(spread, off))), freedom


def _own_scatter(rest: PressureFit, points: CurvePoints) -> tuple[Array, float]:
    """Scatter between samples as the others show it, and its degrees of freedom.

    Of the repeats; without them, about the law. Of few degrees of freedom, it is drawn towards a
    usual scatter.
    """
    freedom = len(points.level) - 0.5 * rest.form.size
    about = rest.scatter * (rest.chi_squared / max(2.0 * freedom, 1.0))
    return towards_usual(points, (about, max(freedom, 0.0)))


def _without(tails: Tails, level: int) -> Tails:
    kept = np.arange(len(tails.pressure)) != level
    return Tails(
        pressure=tails.pressure[kept],
        slope=tails.slope[kept],
        residual=tails.residual[kept],
        reached=tuple(np.array(tails.reached)[kept].tolist()),
    )


def _friction_scatter(law: PressureFit, peak_friction: float) -> float:
    """Standard deviation of friction between samples, halfway up the curve."""
    r = 0.5
    by_peak = np.array([np.log(r) / (1.0 - np.log(r)), 1.0])
    friction = peak_friction * r * (1.0 - np.log(r))
    return float(friction * np.sqrt(by_peak @ law.scatter @ by_peak))


def _squared_error(result: TestResult, predicted: Sequence[float]) -> float:
    """Mean square of predicted less measured friction of a curve, its lash and zero its own."""
    slip, friction, slope, residual = predicted
    own = result.fit.parameters
    q = CurveParameters(
        float(np.log(slip)), float(np.log(friction)), own.lash, slope, residual, own.zero
    )
    travel = result.curve.binned_travel
    grid = np.linspace(max(own.lash, 0.0), float(travel[-1]), 200)
    there, _ = friction_and_jacobian(grid, result.fit.bending, q)
    fitted, _ = friction_and_jacobian(grid, result.fit.bending, own)
    return float(np.mean((there - fitted) ** 2)) + result.fit.remainder**2
