"""What was found as a lagging: the law at its knots, and their covariance."""

from dataclasses import replace
from datetime import UTC, datetime
from typing import Any

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import NORMAL_95, Factors, Fit, Lagging
from wraparc.friction import IntegralLog, PressureKnots, TestedRange
from wraparc.friction.interpolation import evaluate, pchip
from wraparc.provenance import Kind, Provenance
from wraparc.shear_test.analysis import Findings
from wraparc.shear_test.budget import Common
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit, at_least, scatter_within
from wraparc.shear_test.tails import Tails
from wraparc.units import in_units

_MOST_KNOTS = 24
_CLOSE = 1e-3
# A pressure nearer to an end than this, by rounding, is that end.
_APART = 1.001
_ONE_PRESSURE_SCATTER = 0.02
_METHOD = (
    "integral-log law to each curve (soft-L1), then over pressure by generalised least squares "
    "with the scatter between samples; covariance of the knots"
)


def knot_pressures(
    fit: PressureFit, tails: Tails, ends: tuple[float, float] | None = None
) -> Array:
    """Pressures [Pa] at which the law is written down.

    Knots are added where the monotone cubics through them are farthest from the fit, until
    they follow it within 0.1 %, its corner at a transition included.

    Parameters
    ----------
    fit, tails
        The law, and what follows the peak.
    ends
        Lowest and highest pressure of a law of fewer tests than the fit was made for [Pa].
    """
    low, high = ends or fit.ends
    if fit.form.nodes:
        return np.array(fit.form.nodes)
    at = fit.transition_pressure
    changing = tails.pressure[_changing(tails)].tolist()
    places = {low, high, *(p for p in changing if low * _APART < p < high / _APART)}
    if at is not None and low * 1.01 < at < high / 1.01:
        places = {p for p in places if p in (low, high) or abs(p / at - 1.0) > 0.02} | {at}
    fine = np.geomspace(low, high, 601)
    wanted = np.exp(fit.peaks(fine))
    while len(places) < _MOST_KNOTS:
        knots = np.array(sorted(places))
        values = np.exp(fit.peaks(knots))
        cubics = [pchip(knots, values[:, k]) for k in (0, 1)]
        off = [np.abs(evaluate(knots, c, fine) / wanted[:, k] - 1) for k, c in enumerate(cubics)]
        worst = np.maximum(*off)
        if worst.max() < _CLOSE:
            break
        # Halving the gap of the worst place beats a knot at the place, beside another.
        gap = int(np.searchsorted(knots, fine[int(np.argmax(worst))])) or 1
        places.add(float(np.sqrt(knots[gap - 1] * knots[gap])))
    return np.array(sorted(places))


def _changing(tails: Tails) -> Array:
    falls = tails.slope < 0.0
    beside = falls.copy()
    beside[1:] |= falls[:-1]
    return np.asarray(beside)


def rounded(values: Array) -> Array:
    """Six significant digits: more would only make a file harder to read."""
    return _to_digits(values, 6)


def _to_digits(values: Array, digits: int) -> Array:
    return np.array([float(f"{v:.{digits}g}") for v in values.ravel()]).reshape(values.shape)


def law_through(
    pressure: Array, peaks: Array, tails: Tails, slip_max: float, slip_speed: float | None = None
) -> IntegralLog:
    """Return the law with knots at pressures.

    Parameters
    ----------
    pressure
        Knots [Pa], shape (n,).
    peaks
        (ln x_pk, ln mu_pk) there, shape (n, 2).
    tails
        What follows the peak.
    slip_max
        Largest tested slip [m].
    slip_speed
        Speed of slip in the tests [m/s], or None where it is not said.
    """
    pressure = rounded(pressure)
    slip, friction = rounded(np.exp(peaks)).T
    slope, ratio = tails.at(pressure)
    slope, residual = rounded(slope), rounded(ratio * friction)
    falls = bool(np.any(slope < 0.0))
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=tuple(map(float, pressure)),
            peak_friction=tuple(map(float, friction)),
            peak_slip=tuple(map(float, slip)),
            post_peak_slope=tuple(map(float, slope)) if falls else (),
            residual_friction=tuple(map(float, residual)) if falls else (),
        ),
        tested=TestedRange(
            pressure_min=float(pressure[0]),
            pressure_max=float(pressure[-1]),
            slip_max=float(rounded(np.array([slip_max]))[0]),
            slip_speed=slip_speed,
        ),
    )


def _knot_statistics(
    law: IntegralLog, covariance: Array, found: Findings, misfit: tuple[str, ...]
) -> Fit:
    """Names, values and covariance of the law's knots, in SI units.

    `covariance` is that of (ln x_pk, ln mu_pk) at the knots, shape (n, n, 2, 2).
    """
    knots = law.coefficients
    count = len(knots.pressure)
    assert isinstance(knots, PressureKnots)  # noqa: S101 - as made above
    values = np.concatenate([knots.peak_slip, knots.peak_friction])
    names = [
        f"knots[{k + 1}].{quantity}" for quantity in ("peak_slip", "peak_friction")
        for k in range(count)
    ]  # fmt: skip
    logs = covariance.transpose(2, 0, 3, 1).reshape(2 * count, 2 * count)
    matrix = values[:, None] * 0.5 * (logs + logs.T) * values
    return Fit(
        parameters=tuple(names),
        values=tuple(values.tolist()),
        # Of fewer digits it would have negative eigenvalues: the knots outnumber the parameters.
        covariance=tuple(tuple(row) for row in _to_digits(matrix, 9).tolist()),
        coverage_factor=NORMAL_95 if found.fit is None else round(found.fit.coverage_factor, 4),
        residual_noise=float(np.median([test.curve.noise for test in found.tests])),
        date=datetime.now(UTC).date().isoformat(),
        method=_METHOD,
        misfit=tuple(map(in_units, misfit)),
    )


def lagging_of(
    plan: TestPlan, found: Findings, misfit: tuple[str, ...], remarks: tuple[str, ...]
) -> Lagging:
    """Return the lagging with the law that was found.

    Parameters
    ----------
    plan
        The plan.
    found
        What the tests have shown.
    misfit, remarks
        Sentences that go with it; its file has them in metric units.
    """
    if found.fit is None:
        pressure, peaks, covariance = _single_pressure(found.points, found.common)
    else:
        pressure = knot_pressures(found.fit, found.tails)
        peaks, covariance = found.fit.peaks(pressure), found.fit.peak_covariance(pressure)
    of = found.separated
    speed = slip_speed(plan, found.condition)
    if of.by_slip_speed is not None:
        speed = of.by_slip_speed.at[0]
    law = law_through(pressure, peaks, found.tails, _slip_max(found), speed)
    law = replace(law, slip_includes=plan.slip_includes)
    factors = None
    if of.by_slip_speed is not None or of.by_temperature is not None:
        factors = Factors(law=law, by_slip_speed=of.by_slip_speed, by_temperature=of.by_temperature)
    statistics = _knot_statistics(law, covariance, found, misfit)
    return Lagging(
        name=plan.name,
        title=plan.title,
        description=plan.description,
        surface=plan.surface,
        condition=found.condition,
        law=law if factors is None else factors.used,
        fit=statistics,
        factors=factors,
        provenance=plan.provenance,
        notes=tuple(map(in_units, remarks)),
        **_sourced(elasticity(plan), factors),
    )


def _sourced(given: dict[str, Any], factors: Factors | None) -> dict[str, Any]:
    """Name the sources of factors beside those of thickness and moduli."""
    more = factors.sources if factors is not None else {}
    return given | {"sources": given["sources"] | more}


def slip_speed(plan: TestPlan, condition: str) -> float | None:
    """Fastest crosshead of the tests of a condition [m/s]; None where the plan says none.

    The belt slips on the sample as fast as the crosshead moves, less what the sample shears.
    """
    said = [test.speed for test in plan.used_tests if test.condition == condition]
    return max((speed for speed in said if speed is not None), default=None)


def _slip_max(found: Findings) -> float:
    """Slip that was reached at every pressure [m]."""
    reached = np.array([test.fit.slip_max for test in found.tests])
    return float(min(reached[found.levels == k].max() for k in np.unique(found.levels)))


def _single_pressure(points: CurvePoints, common: Common | None) -> tuple[Array, Array, Array]:
    """One knot: the mean of the curves, with the scatter between samples if it is known."""
    scatter = scatter_within(points)
    if scatter is None:
        scatter = at_least(np.eye(2) * _ONE_PRESSURE_SCATTER**2)
    weights = np.linalg.inv(points.covariance + scatter)
    covariance = np.linalg.inv(weights.sum(0))
    mean = covariance @ np.einsum("nij,nj->i", weights, points.value)
    pressure = np.array([float(points.pressure.mean())])
    whole = covariance[None, None]
    if common is not None:
        whole = whole + common.covariance(lambda p: np.tile(mean, (len(p), 1)), pressure)
    return pressure, mean[None], whole


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
