"""A test whose pull fits the others at another pressure: a pressure typed 40 for 400 kPa.

The pull is right and the load is not, so the friction is off by the factor of the load. A test
that is far off the others at its own pressure, and fits them at a usual factor of it (a place of
the decimal point, another unit), is asked about, with the value that would fit.
"""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.catalogue import design_friction
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.misfit import Misfit
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_fit import CurvePoints
from wraparc.units import in_each, quantity

# Off by more than this in ln mu is no scatter of samples; as near as this it fits. Ours.
_OFF, _FITS = 0.3, 0.12
# A pressure in ln p so far outside those of several others is asked about if it slipped. Ours.
_FAR, _SEVERAL = 1.4, 4
# Measured over set loads that differ by less than this are one factor. Ours.
_ONE_FACTOR = 1.2
# Powers of the pressure that friction may follow outside the other tests' pressures. Ours.
_STEEPEST, _FLATTEST = -0.85, 0.1
# A peak of friction over the design value of its surface. Ours; of 1.35 for rubber.
_MOST_OVER_DESIGN = 3.0
_PSI, _LBF, _KGF = 6.894757, 4.448222, 9.80665
_LOAD_FACTORS = (10.0, 1000.0, _PSI, _LBF, _KGF)
_PULL_FACTORS = (10.0, 1000.0, _LBF, _KGF, 2.0)


def load_questions(tests: Sequence[TestResult], points: CurvePoints, flagged: Flags) -> list[str]:
    """Ask about tests whose pull would fit the others at another pressure, or by a factor.

    Parameters
    ----------
    tests
        The tests.
    points
        Their curves.
    flagged
        Which disagree with their repeats; a test that agrees with some is not asked about.
    """
    found: list[str] = []
    for k, test in enumerate(tests):
        others = np.arange(len(tests)) != k
        repeated = bool((points.level[others] == points.level[k]).any())
        if len(tests) < 3 or (repeated and not flagged[k]):
            continue
        text = _question(points.only(others), float(points.pressure[k]), float(points.value[k, 1]))
        if text:
            action = "See pressure, force and their units of this test."
            found.append(
                Misfit(f"{test.name}: {text}", f"{text.headline} ({test.test.file})", action)
            )
    return found


def set_questions(plan: TestPlan, tests: Sequence[TestResult]) -> list[str]:
    """Ask about a measured normal force that is off the set one by one factor in all tests.

    Parameters
    ----------
    plan, tests
        The plan, and its tests of one condition.

    Returns
    -------
    list of str
        None where the tests agree with what was set, or each is off by its own.
    """
    ratios = np.array([
        test.curve.pressure * plan.rig.area / force
        for test in tests
        if test.record.normal_force is not None and (force := plan.set_force(test.test))
    ])  # fmt: skip
    if len(ratios) < 2 or float(ratios.max() / ratios.min()) > _ONE_FACTOR:
        return []
    factor = float(np.exp(np.log(ratios).mean()))
    if 1.0 / _ONE_FACTOR < factor < _ONE_FACTOR:
        return []
    text = (
        f"in {len(ratios)} of {len(tests)} tests the measured normal force is {factor:.3g} times "
        "what was set: see its column and unit (wraparc read FILE)"
    )
    if any(test.test.pressure is not None for test in tests):
        text += (
            f", and sample_area: {_area(plan.rig.area)} as input, "
            f"{_area(plan.rig.area * factor)} would agree"
        )
    head = f"the measured normal force is {factor:.3g} times what was set"
    action = "Check column and unit of the normal force, and sample_area."
    return [Misfit(f"{text}. The measured force was used", head, action)]


def _area(value: float) -> str:
    return in_each(value, "area", "cm2", "in2")


def surface_questions(surface: str, condition: str, peaks: Array, faces: int) -> list[str]:
    """Ask about friction that the surface usually has not: faces or area may be wrong in the plan.

    The published design values of the surface (CEMA, DIN 22101, practice: the catalogue's) are what
    a running drive may rely on; a peak lies above them, by three times at most. A factor of two
    inside that band is not seen.

    Parameters
    ----------
    surface, condition
        As in the plan.
    peaks
        Peak friction at the tested pressures [-].
    faces
        Faces that slide, as in the plan.
    """
    of = [item for item in design_friction() if item.surface == surface]
    if not of:
        return []
    same = [item for item in of if item.condition in {"", condition}] or of
    low = min(item.friction[0] for item in same)
    high = _MOST_OVER_DESIGN * max(item.friction[1] for item in of)
    mean = float(np.exp(np.log(peaks).mean()))
    if low <= mean <= high:
        return []
    text = (
        f"its mean peak friction, {mean:.3g}, is outside the {low:.3g} to {high:.3g} that "
        f"{surface} usually has (from the design values of CEMA and DIN 22101 to "
        f"{_MOST_OVER_DESIGN:g} times the highest): do {faces} of its faces slide, "
        "and is sample_area that of one face?"
    )
    head = f"mean peak friction {mean:.3g} is outside the {low:.3g} to {high:.3g} of {surface}"
    return [Misfit(text, head, "Check faces, sample_area and the unit of the force.")]


def _question(others: CurvePoints, pressure: float, ln_friction: float) -> Misfit:
    at = np.log(others.level_pressures)
    means = np.array([others.value[others.level == k, 1].mean() for k in np.unique(others.level)])
    beyond = max(at[0] - np.log(pressure), np.log(pressure) - at[-1])
    alone = len(at) >= _SEVERAL and beyond > _FAR  # what may be so far off proves nothing
    if not alone and _off(at, means, np.log(pressure), ln_friction) < _OFF:
        return Misfit("")
    friction = np.exp(ln_friction)
    for factor in _both(_LOAD_FACTORS):
        p = np.log(pressure * factor)
        inside = at[0] - 0.05 < p < at[-1] + 0.05
        if inside and _off(at, means, p, ln_friction - np.log(factor)) < _FITS:
            text = (
                f"was its pressure {quantity(np.exp(p), 'pressure')}, not "
                f"{quantity(pressure, 'pressure')}? At "
                f"{quantity(np.exp(p), 'pressure')} its force would fit the other tests (friction "
                f"{friction / factor:.3g} instead of {friction:.3g}); see the pressure or normal "
                "force in the plan and its unit"
            )
            own, other = (quantity(q, "pressure") for q in (pressure, float(np.exp(p))))
            return Misfit(text, f"a force as of {other}, not of {own}")
    for factor in () if alone else _both(_PULL_FACTORS):
        if _off(at, means, np.log(pressure), ln_friction + np.log(factor)) < _FITS:
            text = (
                f"its friction of {friction:.3g} would fit the other tests if its force were "
                f"{_times(factor)}; see unit and factor of the force, and how many faces slid"
            )
            return Misfit(
                text, f"friction {friction:.3g} would fit if its force were {_times(factor)}"
            )
    return Misfit("")


def _both(factors: Sequence[float]) -> list[float]:
    return [value for factor in factors for value in (factor, 1.0 / factor)]


def _times(factor: float) -> str:
    return f"{factor:.3g} times as large" if factor > 1.0 else f"{1.0 / factor:.3g} times smaller"


def _off(at: Array, means: Array, ln_pressure: float, ln_friction: float) -> float:
    """Distance in ln mu from the other tests, outside their pressures from what may be there."""
    nearest = float(np.clip(ln_pressure, at[0], at[-1]))
    beyond = ln_pressure - nearest
    base = float(np.interp(nearest, at, means))
    low, high = sorted((base + _STEEPEST * beyond, base + _FLATTEST * beyond))
    return float(max(low - ln_friction, ln_friction - high, 0.0))
