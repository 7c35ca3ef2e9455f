"""The order of the tests: what wears, warms or drifts over a campaign goes with it.

Where pressures rise with the order, what is the sample's wear cannot be told from what pressure
does, however good the fit: so the order is asked for, and tested for a trend where it is known.
"""

from collections.abc import Sequence
from datetime import datetime

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.shear_test.analysis import TestResult
from wraparc.shear_test.consistency import USUAL, USUAL_WEIGHT
from wraparc.shear_test.misfit import Misfit
from wraparc.shear_test.plan import PlannedTest
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit
from wraparc.shear_test.pressure_form import ln_peaks
from wraparc.shear_test.student import two_sided

#: What is said where no order is.
NOT_STATED = (
    "the order of the tests is not stated (order or date in each [[test]]): a sample that "
    "wears, or a rig that drifts, over the campaign would not be noticed"
)
# Correlation of order and ln p from which they cannot be told apart. Ours.
_CONFOUNDED = 0.9
# How sure a trend must be, and how much of friction it must take from the first test to the last.
_LEVEL, _MATTERS = 0.98, 0.02
_LEAST_FREEDOM = 2
_SAY = "Write order or date in each [[test]]."


def order_of(tests: Sequence[PlannedTest]) -> Array | None:
    """Place of each test in time, equal dates alike; None where the plan does not tell.

    The order of the plan counts where every test has one, else dates as 2026-03-05 or with a time.
    """
    said: list[float] = [float(test.order) for test in tests if test.order is not None]
    if len(said) < len(tests):
        try:
            said = [datetime.fromisoformat(test.date.strip()).timestamp() for test in tests]
        except (ValueError, OverflowError, OSError):
            return None
    _, place = np.unique(said, return_inverse=True)
    return place.astype(float) if place.max() > 0 else None


def order_sentences(
    tests: Sequence[TestResult], law: PressureFit, points: CurvePoints, flagged: Flags
) -> tuple[list[str], list[str]]:
    """Sentences on the order of the tests against the law, and remarks on it.

    Parameters
    ----------
    tests
        Of one condition.
    law, points
        Their law, and the curves as it has used them.
    flagged
        Tests that disagree with their repeats: they show no trend.
    """
    planned = [test.test for test in tests]
    order = order_of(planned)
    names = [test.sample for test in planned if test.sample]
    fresh = len(set(names)) == len(planned)
    if order is None:
        most = max((names.count(name) for name in set(names)), default=0)
        if most > 2:
            head = f"one sample served for {most} tests, their order is missing"
            return [Misfit(f"one sample served for {most} tests, and {NOT_STATED}", head, _SAY)], []
        listed = np.array([int("0" + "".join(filter(str.isdigit, test.place))) for test in planned])
        return _from_repeat_to_repeat(listed[~flagged], points.only(~flagged)), [NOT_STATED]
    ln_pressure = np.log(points.pressure)
    several = len(points.level_pressures) > 2
    together = float(np.corrcoef(order, ln_pressure)[0, 1]) if np.ptp(ln_pressure) > 0.0 else 0.0
    if several and abs(together) > _CONFOUNDED:
        way = "upwards" if together > 0.0 else "downwards"
        text = (
            f"the pressures were tested in their order, {way}: wear of the sample cannot be "
            "separated from the effect of pressure"
        )
        if fresh:
            return [], [f"{text}; each test had a sample of its own, so the rig's drift is left"]
        text += "; repeat the first pressure at the end, or test in mixed order"
        head = "pressures were tested in their order: wear looks like the effect of pressure"
        return [Misfit(text, head, "Repeat the first pressure, or test in mixed order.")], []
    return _trend(order[~flagged], law, points.only(~flagged), law.weights[~flagged])


def lot_sentences(tests: Sequence[TestResult], levels: Integers) -> list[str]:
    """Say of samples of several lots, each tested at pressures of its own, what cannot be told.

    Parameters
    ----------
    tests
        Of one condition.
    levels
        Number of the pressure of each.
    """
    lots = [test.test.lot for test in tests]
    at = {lot: {int(k) for k, own in zip(levels, lots, strict=True) if own == lot} for lot in lots}
    if len(at) < 2 or not all(lots) or sum(map(len, at.values())) > len(np.unique(levels)):
        return []
    text = (
        f"lots {', '.join(map(repr, at))} were tested at pressures of their own: their "
        "difference cannot be separated from the effect of pressure; test one pressure on all of "
        "them"
    )
    head = f"{len(at)} lots were tested at pressures of their own"
    return [Misfit(text, head, "Test one pressure on all lots.")]


def _from_repeat_to_repeat(listed: Integers, points: CurvePoints) -> list[str]:
    """Whether tests of one pressure go up or down as the plan lists them, which may be their order.

    By Student's t of the slope of ln mu_pk over their places, within the pressures.
    """
    place, value = np.zeros(len(points.level)), np.zeros(len(points.level))
    for k in np.unique(points.level):
        own = points.level == k
        place[own] = np.argsort(np.argsort(listed[own])) - 0.5 * (own.sum() - 1)
        value[own] = points.value[own, 1] - points.value[own, 1].mean()
    freedom = len(place) - len(np.unique(points.level)) - 1
    if freedom < _LEAST_FREEDOM or len(set(listed.tolist())) < len(listed):
        return []
    slope = float(place @ value / (place @ place))
    left = float(((value - slope * place) ** 2).sum()) / freedom
    error = float(np.sqrt(left / (place @ place)))
    if abs(slope) < max(_MATTERS, two_sided(freedom, _LEVEL) * error):
        return []
    text = (
        f"friction changes by {100 * np.expm1(slope):+.1f} % (standard error {100 * error:.1f} %) "
        "from a test to the next of its pressure in the plan: if they were done in this order the "
        "sample wears, or the rig drifts; say the order (order or date in each [[test]])"
    )
    head = f"friction changes by {100 * np.expm1(slope):+.1f} % from a repeat to the next"
    return [Misfit(text, head, _SAY)]


def _trend(
    order: Array, law: PressureFit, points: CurvePoints, weights: Array
) -> tuple[list[str], list[str]]:
    """Whether ln mu_pk, what pressure does taken off, goes with the order."""
    value, jacobian = ln_peaks(law.form, law.theta, law.ends, points.pressure)
    by_order = (order - order.mean()) / max(float(np.ptp(order)), 1.0)
    design = np.column_stack([jacobian[:, 1, np.abs(jacobian[:, 1]).max(0) > 0.0], by_order])
    root = np.sqrt(weights)
    rows, target = design * root[:, None], (points.value - value)[:, 1] * root
    found, _, rank, _ = np.linalg.lstsq(rows, target, rcond=1e-9)
    freedom = len(target) - int(rank)
    if freedom < _LEAST_FREEDOM or rank < design.shape[1]:
        return [], ["too few tests to see whether friction goes with their order"]
    left = float(((rows @ found - target) ** 2).sum())
    # Of few degrees of freedom, it is drawn towards a usual scatter.
    variance = (left + USUAL_WEIGHT * USUAL**2) / (freedom + USUAL_WEIGHT)
    error = float(np.sqrt(variance * np.linalg.inv(rows.T @ rows)[-1, -1]))
    change = float(found[-1])
    if abs(change) > max(_MATTERS, two_sided(freedom + USUAL_WEIGHT - 1.0, _LEVEL) * error):
        text = (
            f"friction changes by {100 * np.expm1(change):+.0f} % from the first test to the last, "
            f"what pressure does taken off (standard error {100 * error:.1f} %): the sample wears, "
            "or the rig drifts; repeat the first test, or take a new sample for each"
        )
        head = (
            f"friction changes by {100 * np.expm1(change):+.0f} % from the first test to the last"
        )
        return [Misfit(text, head, "Repeat the first test, or take a new sample for each.")], []
    return [], [
        "friction shows no significant trend with the order of the tests: "
        f"{100 * np.expm1(change):+.0f} % from the first to the last, standard error "
        f"{100 * error:.0f} %"
    ]
