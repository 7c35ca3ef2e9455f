"""A fitted test plan as plain data for JSON, in SI units but for A and b."""

from dataclasses import asdict
from typing import Any

import numpy as np

from wraparc.shear_test.alternatives import alternative_laws
from wraparc.shear_test.analysis import ConditionResult, PlanResult, TestResult
from wraparc.shear_test.budget import Budget
from wraparc.shear_test.pressure_form import equations
from wraparc.shear_test.standard_values import (
    STANDARD_SLIPS,
    StandardValues,
    Statistic,
    law_at_slips,
    standard_values,
)
from wraparc.units import in_units

#: Counts up when a name goes or changes its meaning.
DOCUMENT_FORMAT = 1
_INTERVALS = ("peak_slip", "peak_friction", "lash", "post_peak_slope", "residual_friction")


def plan_document(result: PlanResult, *, laws: bool = False) -> dict[str, Any]:
    """Return everything that came out of a plan.

    Parameters
    ----------
    result
        From `fit_plan`.
    laws
        Whether to fit other laws to the same curves and tell them too.
    """
    return {
        "format": DOCUMENT_FORMAT,
        "lagging": result.plan.name,
        "date": result.date,
        "provenance": str(result.plan.provenance),
        "saturation_pressure": result.plan.saturation_pressure,
        "left_out": [str(problem) for problem in result.left_out],
        "not_used": [{"file": t.file, "reason": t.reason} for t in result.plan.unused_tests],
        "conditions": [_condition(condition, laws) for condition in result.conditions],
        "units": {
            "pressure": "Pa", "peak_slip": "m", "lash": "m", "slip_max": "m", "slip": "m",
            "post_peak_slope": "1/m", "A": "1/mm", "b": "1/mm",
        },
    }  # fmt: skip


def _condition(condition: ConditionResult, laws: bool) -> dict[str, Any]:
    found = condition.found
    pressures = found.level_pressures()
    slip, friction, half = condition.peaks_at(pressures)
    half = np.minimum(half, 700.0)  # e to more than that is no number
    transition = found.transition
    law = [
        {
            "pressure": float(p),
            "peak_slip": float(slip[k]),
            "peak_slip_interval": (slip[k] * np.exp([-half[k, 0], half[k, 0]])).tolist(),
            "peak_friction": float(friction[k]),
            "peak_friction_interval": (friction[k] * np.exp([-half[k, 1], half[k, 1]])).tolist(),
        }
        for k, p in enumerate(pressures)
    ]
    fit = found.fit
    return {
        "condition": condition.condition,
        "misfit": list(map(in_units, condition.misfit)),
        "remarks": list(map(in_units, condition.remarks)),
        "tests": [_test(t, bool(off)) for t, off in zip(found.tests, found.flagged, strict=True)],
        "law": law,
        "standard_values": [_standard(values) for values in standard_values(condition)],
        "law_at_standard_slips": _law_at_slips(condition),
        "budget": None if fit is None else _budget(fit.budget(found.points)),
        **({"laws": [asdict(law) for law in alternative_laws(condition)]} if laws else {}),
        "form": None if fit is None else str(fit.form),
        "equations": [] if fit is None else list(equations(fit.form, fit.theta, fit.ends)),
        "transition": None
        if transition is None
        else {
            "pressure": transition.pressure,
            "given": transition.given,
            "in_law": transition.in_law,
        },
        "left_out_pressures": [
            {
                "pressure": item.pressure,
                "inside": item.inside,
                "error": item.error,
                "noise": item.noise,
                "noise_levels": item.noise_levels,
            }
            for item in found.left_out
        ],
    }


def _budget(budget: Budget) -> dict[str, Any]:
    """Relative standard uncertainties of (x_pk, mu_pk) at the tested pressures."""
    return {
        "pressure": budget.pressure.tolist(),
        "coverage_factor": budget.coverage_factor,
        "parts": {name: part.tolist() for name, part in budget.parts.items()},
        "combined": budget.combined.tolist(),
        "expanded": budget.expanded.tolist(),
    }


def _standard(values: StandardValues) -> dict[str, Any]:
    def told(of: Statistic) -> dict[str, Any]:
        return {"mean": _or_none(of.mean), "deviation": _or_none(of.deviation), "tests": of.count}

    return {
        "pressure": values.pressure,
        "tests": values.tests,
        "static": {**told(values.static), "still_rising": values.rising},
        "kinetic": {**told(values.kinetic), "slip": [_or_none(s) for s in values.kinetic_slip]},
        "at_slip": [
            {"slip": slip, **told(of), "law_beyond_the_tests": _or_none(law)}
            for slip, of, law in zip(STANDARD_SLIPS, values.at_slip, values.beyond, strict=True)
        ],
    }


def _law_at_slips(condition: ConditionResult) -> list[dict[str, Any]]:
    """The law and its expanded uncertainty at the standard slips [m], pressures ascending."""
    return [
        {"slip": list(STANDARD_SLIPS), "friction": mu, "expanded": [_or_none(u) for u in error]}
        for mu, error in zip(*(part.tolist() for part in law_at_slips(condition)), strict=True)
    ]


def _or_none(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _test(test: TestResult, outlier: bool) -> dict[str, Any]:
    return {
        "file": test.test.file,
        "digest": test.record.digest,
        "pressure": test.curve.pressure,
        "rows": test.record.rows,
        "readings": len(test.curve.travel),
        "slip_max": test.fit.slip_max,
        "noise": test.curve.noise,
        "r_squared": test.fit.r_squared,
        "peak_inside": test.fit.peak_inside,
        "outlier": outlier,
        **_parameters(test),
        "misfit": [in_units(sentence.text) for sentence in test.judged.misfit],
        "remarks": list(map(in_units, test.judged.remarks)),
    }


def _parameters(test: TestResult) -> dict[str, Any]:
    fit = test.fit
    a, b = fit.coefficients()
    values: dict[str, Any] = {"A": a, "b": b}
    for name in _INTERVALS:
        key = f"ln_{name}" if name.startswith("peak") else name
        fitted = key in fit.free
        if fitted or name == "lash":
            values[name] = float(getattr(fit.parameters, name))
        values[f"{name}_interval"] = [float(v) for v in fit.interval(name)] if fitted else None
    if test.is_skewed:
        values["peak_slip_interval"] = [_or_none(end) for end in test.peak_slip_interval]
    return values
