"""The law of one condition from its curves: pressure dependence, tails, predictions, words."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.drive import Lagging
from wraparc.provenance import Kind, Provenance
from wraparc.shear_test.analysis import ConditionResult, LeftOut, TestResult
from wraparc.shear_test.consistency import outliers
from wraparc.shear_test.curve_model import CurveParameters, friction_and_jacobian
from wraparc.shear_test.joint_fit import curve_points, refine
from wraparc.shear_test.law import knot_pressures, knot_statistics, law_through
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_choice import choose_form, leave_out
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit, at_least, scatter_within
from wraparc.shear_test.record import Array
from wraparc.shear_test.sentences import Findings, law_sentences
from wraparc.shear_test.tails import Tails, level_tails

Levels = NDArray[np.int64]
_METHOD = (
    "integral-log law to each curve (soft-L1), then over pressure by generalised least "
    "squares with the scatter between samples; covariance of the knots"
)
_ONE_PRESSURE_SCATTER = 0.02


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
        left_out = tuple(_left_out(law, points, tests, levels, tails))
    misfit, remarks = law_sentences(
        Findings(
            plan=plan, tests=tests, choice=choice, law=law, left_out=left_out, tails=tails,
            distances=distances, flagged=flagged,
        )
    )  # fmt: skip
    lagging = _lagging(plan, condition, tests, points, law, tails, misfit, remarks)
    return ConditionResult(
        condition=condition,
        tests=tuple(tests),
        levels=levels,
        flagged=flagged,
        repeat_distances=distances,
        choice=choice,
        fit=law,
        tails=tails,
        left_out=left_out,
        lagging=lagging,
        misfit=misfit,
        remarks=remarks,
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
        pressure = float(points.pressure[inside].mean())
        kept = present != level
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


def _lagging(
    plan: TestPlan,
    condition: str,
    tests: Sequence[TestResult],
    points: CurvePoints,
    law: PressureFit | None,
    tails: Tails,
    misfit: tuple[str, ...],
    remarks: tuple[str, ...],
) -> Lagging:
    if law is None:
        pressure, peaks, covariance = _single_pressure(points)
    else:
        pressure = knot_pressures(law, tails)
        peaks, covariance = law.peaks(pressure), law.peak_covariance(pressure)
    friction_law = law_through(pressure, peaks, tails, _slip_max(tests))
    statistics = knot_statistics(
        friction_law,
        covariance,
        noise=float(np.median([t.curve.noise for t in tests])),
        date="",
        method=_METHOD,
        misfit=misfit,
    )
    return Lagging(
        name=plan.name,
        title=plan.title,
        description=plan.description,
        surface=plan.surface,
        condition=condition,
        law=friction_law,
        fit=statistics,
        provenance=plan.provenance,
        notes=remarks,
        **elasticity(plan),
    )


def _slip_max(tests: Sequence[TestResult]) -> float:
    """Slip that was reached at every pressure [m]."""
    reached: dict[float, float] = {}
    for result in tests:
        key = round(result.curve.pressure, -3)
        reached[key] = max(reached.get(key, 0.0), result.fit.slip_max)
    return min(reached.values())


def _single_pressure(points: CurvePoints) -> tuple[Array, Array, Array]:
    """One knot: the mean of the curves, with the scatter between samples if it is known."""
    scatter = scatter_within(points)
    if scatter is None:
        scatter = at_least(np.eye(2) * _ONE_PRESSURE_SCATTER**2)
    weights = np.linalg.inv(points.covariance + scatter)
    covariance = np.linalg.inv(weights.sum(0))
    mean = covariance @ np.einsum("nij,nj->i", weights, points.value)
    pressure = np.array([float(points.pressure.mean())])
    return pressure, mean[None], covariance[None, None]


def elasticity(plan: TestPlan) -> dict[str, Any]:
    """Thickness and moduli of the lagging, and how those not given were estimated.

    Without thickness or shear modulus, or with the shear left in the slip, the lagging is
    written as one that does not shear: its shear is in the law already.
    """
    given: dict[str, Any] = {}
    sources: dict[str, Provenance] = {}
    if plan.thickness is not None and plan.shear_modulus_used is not None and plan.removes_shear:
        young = plan.elastic_modulus or 3.0 * plan.shear_modulus_used
        given["thickness"] = plan.thickness
        given["shear_modulus"] = plan.shear_modulus_used
        given["compression_modulus"] = plan.compression_modulus or young
        if plan.shear_modulus is None:
            sources["shear_modulus"] = Provenance(Kind.GIVEN, note="estimated: G = E/3")
        if plan.compression_modulus is None:
            text = "E_c = E" if plan.elastic_modulus else "E_c = 3 G"
            note = f"estimated: {text}, no stiffening by the shape of blocks"
            sources["compression_modulus"] = Provenance(Kind.GIVEN, note=note)
        own = Provenance(Kind.GIVEN, note="as in the test plan")
        for key in ("thickness", "shear_modulus", "compression_modulus"):
            sources.setdefault(key, own)
    if plan.elastic_modulus is not None:
        given["elastic_modulus"] = plan.elastic_modulus
        sources["elastic_modulus"] = Provenance(Kind.GIVEN, note="as in the test plan")
    return given | {"sources": sources}
