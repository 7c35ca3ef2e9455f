"""What is to be said of a condition's law: where it fails, and what must be known of it."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from wraparc.shear_test.analysis import Findings, LeftOut, TestResult
from wraparc.shear_test.consistency import FAR
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_choice import PressureChoice
from wraparc.shear_test.pressure_fit import PressureFit
from wraparc.shear_test.record import Array

_PREDICTED = 2.0
_FAR_FROM_LAW = 3.5


def law_sentences(plan: TestPlan, found: Findings) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Sentences on misfit, and remarks, of one condition's law."""
    tests, law, choice = found.tests, found.fit, found.choice
    misfit = [f"{t.name}: {s}" for t in tests for s in t.judged.misfit]
    misfit += _repeats(tests, found.repeat_distances, found.flagged)
    if law is not None:
        misfit += _curves_off(tests, law, found.flagged)
        misfit += _predictions(found.left_out)
    remarks = [_shear_sentence(plan)]
    if law is None or choice is None:
        pressure = tests[0].curve.pressure / 1e3
        remarks.append(
            f"tested at {pressure:.4g} kPa only: the law does not depend on pressure, which real "
            "laggings do; test at other pressures before relying on it elsewhere"
        )
    else:
        remarks += _form(law, choice) + _transition(plan, law, choice)
    if not all(found.tails.reached):
        remarks.append(
            "where the residual friction was not reached, the lowest friction seen is used for it"
        )
    beyond = sum(not t.fit.peak_inside for t in tests)
    if beyond:
        remarks.append(
            f"the peak lies beyond the tested slip in {beyond} of {len(tests)} tests: past that "
            "slip the law is an extrapolation"
        )
    return tuple(misfit), tuple(remarks)


def _repeats(
    tests: Sequence[TestResult], distances: Array, flagged: NDArray[np.bool_]
) -> list[str]:
    found = []
    for k in np.flatnonzero(flagged).tolist():
        friction = tests[k].fit.parameters.peak_friction
        found.append(
            f"{tests[k].name}: disagrees with its repeats by {max(distances[k], FAR):.1f} standard "
            f"deviations (peak friction {friction:.3f}); it counts little in the law; see "
            "whether sample, load and surface were as planned"
        )
    return found


def _curves_off(
    tests: Sequence[TestResult], law: PressureFit, flagged: NDArray[np.bool_]
) -> list[str]:
    return [
        f"{tests[k].name}: lies {law.distances[k]:.1f} standard deviations from the law of all"
        for k in range(len(tests))
        if law.distances[k] > _FAR_FROM_LAW and not flagged[k]
    ]


def _predictions(left_out: Sequence[LeftOut]) -> list[str]:
    poor = [
        item
        for item in left_out
        if item.inside and item.error > _PREDICTED * np.hypot(item.noise, item.scatter)
    ]
    if not poor:
        return []
    listed = ", ".join(
        f"{item.pressure / 1e3:.4g} kPa by {item.error:.3f} ({item.noise_levels:.1f} noise levels)"
        for item in poor
    )
    return [f"left out, these pressures are missed by the law of the others: {listed}"]


def _shear_sentence(plan: TestPlan) -> str:
    if plan.removes_shear:
        return (
            f"slip is travel less lash and less the sample's own shear, h/G = "
            f"{plan.shear_compliance * 1e9:.3g} mm/MPa times the shear stress"
        )
    if plan.shear_compliance > 0.0:
        return (
            "the sample's own shear was left in the slip, as asked; the lagging is therefore "
            "written without thickness, so that the shear is not counted twice"
        )
    return (
        "the sample's own shear is in the slip, for thickness and shear modulus were not given; "
        "the lagging is written without thickness, so that the shear is not counted twice"
    )


def _form(law: PressureFit, choice: PressureChoice) -> list[str]:
    remarks = [f"pressure dependence: {law.form}", *choice.notes]
    if law.form.nodes:
        remarks.append(
            "no trend line follows the curves within their scatter, so the law holds a value of "
            "its own at each tested pressure; between them it interpolates"
        )
    return remarks


def _transition(plan: TestPlan, law: PressureFit, choice: PressureChoice) -> list[str]:
    two, interval = choice.two_pieces, choice.transition_interval
    saturation = plan.saturation_pressure
    estimate = (
        f"; the saturation estimate E * roughness / thickness is {saturation / 1e3:.3g} kPa"
        if saturation is not None
        else ""
    )
    if two is None or interval is None or two.transition_pressure is None:
        return [f"too few pressures to look for a transition{estimate}"]
    at = (law if law.form.has_transition else two).transition_pressure or two.transition_pressure
    if two.transition_given:
        return [f"transition pressure given: {at / 1e3:.4g} kPa{estimate}"]
    low, high = (end / 1e3 for end in interval)
    text = f"transition pressure {at / 1e3:.4g} kPa (95 %: {low:.4g} to {high:.4g}){estimate}"
    if not law.form.has_transition:
        text = f"the law needs no transition; the best law of two pieces has its {text}"
    remarks = [text]
    if not choice.transition_inside:
        remarks.append(
            "that transition lies at the edge of where these pressures could show one: test at "
            "more pressures beyond it"
        )
    return remarks
