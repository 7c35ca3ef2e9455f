"""The law of one condition from its curves: pressure dependence, tails, predictions."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from wraparc.shear_test.analysis import (
    ConditionResult,
    Findings,
    LeftOut,
    TestResult,
    Transition,
)
from wraparc.shear_test.consistency import lone_distances, outliers
from wraparc.shear_test.curve_model import CurveParameters, friction_and_jacobian
from wraparc.shear_test.joint_fit import curve_points, refine
from wraparc.shear_test.lack_of_fit import with_lack_of_fit
from wraparc.shear_test.law import lagging_of
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_choice import (
    PressureChoice,
    choose_form,
    is_inside,
    leave_out,
    transition_interval,
)
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit, fit_form
from wraparc.shear_test.record import Array
from wraparc.shear_test.sentences import law_sentences
from wraparc.shear_test.tails import Tails, level_tails

Levels = NDArray[np.int64]


def fit_condition(
    plan: TestPlan, condition: str, tests: Sequence[TestResult], levels: Levels
) -> ConditionResult:
    """Fit the law of one condition.

    Parameters
    ----------
    plan
        The plan.
    condition
        Its name.
    tests
        Its tests, pressures ascending.
    levels
        Number of the pressure of each.
    """
    curves, fits = [t.curve for t in tests], [t.fit for t in tests]
    points = curve_points(curves, fits, levels)
    flagged, distances = outliers(points)
    tails = _tails(tests, levels, flagged)
    choice = law = None
    left_out: tuple[LeftOut, ...] = ()
    if len(np.unique(levels)) > 1:
        choice = choose_form(points, plan.options, flagged)
        law, points = refine(curves, fits, points, choice.fit, flagged)
        law = with_lack_of_fit(law, points, flagged)
        good = [test for test, off in zip(tests, flagged, strict=True) if not off]
        left_out = tuple(_left_out(law, points, good, levels[~flagged], tails))
    found = Findings(
        condition=condition,
        tests=tuple(tests),
        levels=levels,
        flagged=flagged,
        repeat_distances=distances,
        lone_distances=lone_distances(points),
        points=points,
        choice=choice,
        fit=law,
        transition=_transition(law, choice, points),
        tails=tails,
        left_out=left_out,
    )
    misfit, remarks = law_sentences(plan, found)
    lagging = lagging_of(plan, found, misfit, remarks)
    return ConditionResult(found=found, lagging=lagging, misfit=misfit, remarks=remarks)


def _transition(
    law: PressureFit | None, choice: PressureChoice | None, points: CurvePoints
) -> Transition | None:
    if law is None or choice is None:
        return None
    two = law if law.form.has_transition else choice.two_pieces
    if two is None or two.transition_pressure is None:
        return None
    if two is not law:
        given = two.transition_pressure if two.transition_given else None
        two = fit_form(two.form, points, two.scatter, transition=given, start=two.theta)
    return Transition(
        pressure=float(np.exp(two.theta[-1])),
        interval=transition_interval(two, points),
        given=two.transition_given,
        in_law=two is law,
        inside=is_inside(two, points),
    )


def _tails(tests: Sequence[TestResult], levels: Levels, flagged: NDArray[np.bool_]) -> Tails:
    rows = []
    for level in np.unique(levels):
        inside = np.flatnonzero(levels == level).tolist()
        kept = [k for k in inside if not flagged[k]] or inside
        pressure = float(np.mean([tests[k].curve.pressure for k in kept]))
        rows.append((pressure, [tests[k].fit for k in kept]))
    return level_tails(rows)


def _left_out(
    law: PressureFit,
    points: CurvePoints,
    tests: Sequence[TestResult],
    levels: Levels,
    tails: Tails,
) -> list[LeftOut]:
    found = []
    present = np.unique(levels)
    for level in present:
        rest = leave_out(law, points, int(level))
        if rest is None:
            continue
        inside = np.flatnonzero(levels == level).tolist()
        pressure = float(np.mean([tests[k].curve.pressure for k in inside]))
        kept = np.arange(len(tails.pressure)) != level
        others = Tails(
            pressure=tails.pressure[kept],
            slope=tails.slope[kept],
            residual=tails.residual[kept],
            reached=tuple(np.array(tails.reached)[kept].tolist()),
        )
        peak = rest.peaks(np.array([pressure]))[0]
        squares = [_squared_error(tests[k], peak, others, pressure) for k in inside]
        found.append(
            LeftOut(
                pressure=pressure,
                inside=bool(present[0] < level < present[-1]),
                error=float(np.sqrt(np.mean(squares))),
                noise=float(np.mean([tests[k].curve.noise for k in inside])),
                scatter=_friction_scatter(law, float(np.exp(peak[1]))),
                peak_slip=float(np.exp(peak[0])),
                peak_friction=float(np.exp(peak[1])),
            )
        )
    return found


def _friction_scatter(law: PressureFit, peak_friction: float) -> float:
    """Standard deviation of friction between samples, halfway up the curve."""
    r = 0.5
    by_peak = np.array([np.log(r) / (1.0 - np.log(r)), 1.0])
    friction = peak_friction * r * (1.0 - np.log(r))
    return float(friction * np.sqrt(by_peak @ law.scatter @ by_peak))


def _squared_error(result: TestResult, peak: Array, tails: Tails, pressure: float) -> float:
    """Mean square of predicted less measured friction of a curve, its lash and zero its own."""
    slope, ratio = (float(v[0]) for v in tails.at(np.array([pressure])))
    own = result.fit.parameters
    q = CurveParameters(
        float(peak[0]), float(peak[1]), own.lash, slope, ratio * float(np.exp(peak[1])), own.zero
    )
    travel = result.curve.binned_travel
    grid = np.linspace(max(own.lash, 0.0), float(travel[-1]), 200)
    predicted, _ = friction_and_jacobian(grid, result.fit.bending, q)
    fitted, _ = friction_and_jacobian(grid, result.fit.bending, own)
    return float(np.mean((predicted - fitted) ** 2)) + result.fit.remainder**2
