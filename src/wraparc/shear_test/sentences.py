"""What is to be said of a condition's law: where it fails, and what must be known of it."""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Integers
from wraparc.shear_test.analysis import Findings, LeftOut, TestResult
from wraparc.shear_test.budget import UNKNOWN_COMPLIANCE, Uncertainty
from wraparc.shear_test.campaign import lot_sentences, order_sentences
from wraparc.shear_test.consistency import FAR, USUAL
from wraparc.shear_test.copies import copy_sentences
from wraparc.shear_test.curve_fit import fit_curve
from wraparc.shear_test.lash import lash_sentences
from wraparc.shear_test.load_slips import load_questions, set_questions, surface_questions
from wraparc.shear_test.misfit import OTHER_PRESSURE, Misfit, Sentence
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_choice import PressureChoice
from wraparc.shear_test.pressure_fit import PressureFit
from wraparc.shear_test.reduce import UNKNOWN_ZERO
from wraparc.shear_test.rig_faults import one_force, rig_sentences
from wraparc.shear_test.speeds import per_minute, speed_sentences
from wraparc.shear_test.student import chi_square, t95
from wraparc.units import Cell, Dimension, per_stress, quantity

_FEW = 3
_CLEARLY = 100.0
_FAR_FROM_LAW = 3.5
# Two standard errors of ln mu beyond which no law is relied on without a word. Ours.
_WIDE = 0.25
# Standard deviation of ln mu_pk between samples beyond which they are not of one kind, and how
# sure it must be beyond. Ours.
_LOOSE, _LOOSE_LEVEL = 0.06, 0.95
# Peak friction that goes up by more than this, and than chance, where it falls elsewhere. Ours.
_RISE = 0.05


def law_sentences(plan: TestPlan, found: Findings) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Sentences on misfit, and remarks, of one condition's law."""
    tests, law, choice = found.tests, found.fit, found.choice
    by_speed, speed_remarks = speed_sentences(
        tests, found.points, told=found.separated.by_slip_speed is not None
    )
    order_remarks: list[str] = []
    misfit = set_questions(plan, tests)
    given = one_force(plan, found)  # what gives way makes odd curves: the cause comes first
    misfit += given + _of_curves(tests, OTHER_PRESSURE if misfit else "")
    misfit += rig_sentences(plan, found, gives_way=bool(given)) + copy_sentences(tests)
    misfit += lash_sentences(tests) + _repeats(tests, found) + by_speed
    misfit += load_questions(tests, found.points, found.flagged)
    if law is not None:
        misfit += _curves_off(tests, law, found)
        misfit += _predictions(found.left_out) + _rises(law, found)
        misfit += [] if plan.digitised else _wide(tests, law, found)  # nobody repeats a figure
        by_order, order_remarks = order_sentences(tests, law, found.points, found.flagged)
        misfit += by_order + lot_sentences(tests, found.levels)
        order_remarks = [] if plan.digitised else order_remarks
    peaks = np.array([test.fit.parameters.peak_friction for test in tests])
    misfit += surface_questions(plan.surface, found.condition, peaks, plan.rig.faces)
    remarks = [
        _shear_sentence(plan),
        _cover_sentence(plan),
        _tests_sentence(tests, found.levels),
        *_unused(plan),
        *_held(plan),
        *order_remarks,
        *([] if plan.digitised else _scatter(found)),
        *speed_remarks,
        *found.separated.remarks,
        *_compliance(plan, tests),
        *_zero(tests),
    ]
    if law is None or choice is None:
        pressure = quantity(tests[0].curve.pressure, "pressure")
        remarks.append(
            f"tested at {pressure} only: the law does not depend on pressure, which real "
            "laggings do; test at other pressures before relying on it elsewhere"
        )
    else:
        remarks += form_sentences(plan, found)
    if not all(found.tails.reached):
        remarks.append(
            "where the residual friction was not reached, the lowest friction seen is used for it"
        )
    beyond = sum(not t.fit.peak_inside for t in tests)
    if beyond:
        remarks.append(
            f"the peak is outside the tested slip in {beyond} of {len(tests)} tests: past that "
            "slip the law is an extrapolation"
        )
    return tuple(misfit), tuple(remarks)


def form_sentences(plan: TestPlan, found: Findings) -> list[str]:
    """Sentences on the form of a law over pressure; none of one that does not depend on it."""
    if found.fit is None or found.choice is None:
        return []
    return _form(found.fit, found.choice) + _transition(plan, found)


def _scatter(found: Findings) -> list[str]:
    """What the scatter of samples means for a further one."""
    scatter = found.scatter
    if scatter is None:
        return []
    apart = "between tests of one pressure" if scatter.of == "repeats" else "about the law"
    off = 100 * t95(scatter.freedom) * scatter.value
    return [
        f"{scatter.words}: a standard deviation {apart}, of {scatter.freedom} degrees of freedom. "
        f"Of 20 further samples about one is off by more than {off:.2g} %"
    ]


def _rises(law: PressureFit, found: Findings) -> list[str]:
    """Friction that goes up to a pressure among those over which it falls, no trend line there."""
    at, of = found.level_pressures(), found.points.level
    if not law.form.nodes or len(at) < 3:
        return []
    counts = np.bincount(of)
    mean = np.bincount(of, found.points.value[:, 1]) / np.maximum(counts, 1)
    if not np.all(counts) or mean[-1] > mean[0]:
        return []
    scatter = USUAL if found.scatter is None else found.scatter.value
    error = scatter * np.sqrt(1.0 / counts[1:] + 1.0 / counts[:-1])
    rise = np.diff(mean) - np.maximum(_RISE, 3.0 * error)
    k = int(np.argmax(rise))
    if rise[k] <= 0.0:
        return []
    low, high = (quantity(at[j], "pressure") for j in (k, k + 1))
    text = (
        f"peak friction rises from {np.exp(mean[k]):.3g} at {low} to {np.exp(mean[k + 1]):.3g} "
        f"at {high}, and falls over all "
        "pressures: see whether a set pressure, a normal force or a sample of these is another"
    )
    head = f"peak friction rises from {low} to {high}, and falls over all"
    return [Misfit(text, head, "Check pressure, normal force and samples of these two.")]


def _wide(tests: Sequence[TestResult], law: PressureFit, found: Findings) -> list[str]:
    """Pressures at which the law's friction, at the tested slip, is hardly known."""
    at = found.level_pressures()
    reached = np.array([
        max(t.fit.slip_max for t, level in zip(tests, found.levels, strict=True) if level == k)
        for k in np.unique(found.levels)
    ])  # fmt: skip
    r = np.minimum(reached / np.exp(law.peaks(at)[:, 0]), 1.0)
    by_peak = np.stack([np.log(r) / (1.0 - np.log(r)), np.ones_like(r)], axis=-1)
    error = np.sqrt(np.einsum("ni,nij,nj->n", by_peak, law.own_covariance(at), by_peak))
    half = 2.0 * error
    worst = int(np.argmax(half))
    scatter = float(np.sqrt(law.scatter[1, 1]))
    text = (
        f"samples scatter by {100 * scatter:.0f} % in peak friction about the law, surely more "
        f"than the {100 * _LOOSE:.0f} % of samples that are alike: see which of them differ, and "
        "why"
    )
    head = f"samples scatter by {100 * scatter:.0f} % in peak friction"
    loose: list[str] = [Misfit(text, head, "See which samples differ, and test more of one kind.")]
    if half[worst] < _WIDE:
        freedom = max(float((~found.flagged).sum()) - 0.5 * law.form.size, 1.0)
        least = scatter * float(np.sqrt(freedom / chi_square(freedom, _LOOSE_LEVEL)))
        return loose if least > _LOOSE else []
    where, factor = quantity(at[worst], "pressure"), f"a factor of {np.exp(half[worst]):.2g}"
    text = (
        f"the law's friction at {where} and {quantity(reached[worst], 'length')} of slip is known "
        f"within {factor} only (two standard errors): more repeats, or a look at the "
        "tests that disagree"
    )
    head = f"friction at {where} is known within {factor} only"
    return [Misfit(text, head, "Repeat tests, or see which of them disagree.")]


def _compliance(plan: TestPlan, tests: Sequence[TestResult]) -> list[str]:
    """What a usual compliance of the rig would do to the result, where none is given."""
    stated = plan.uncertainty is not None and plan.uncertainty.compliance is not None
    if plan.rig.compliance > 0.0 or stated:
        return []
    test = tests[-1]
    more = UNKNOWN_COMPLIANCE * plan.rig.faces * test.curve.pressure * plan.rig.area
    other = fit_curve(test.curve, bending=test.fit.bending + more, start=test.fit)
    own, moved = (fit.parameters.peak_slip for fit in (test.fit, other))
    return [
        "the rig's own travel is missing (compliance): 0.05 mm/kN, for example, would put the "
        f"peak slip at {quantity(test.curve.pressure, 'pressure')} at "
        f"{quantity(moved, 'length')} instead of {quantity(own, 'length')} "
        f"({100 * (moved / own - 1.0):+.1f} %)"
    ]


def _zero(tests: Sequence[TestResult]) -> list[str]:
    unknown = sum(test.curve.zero_unknown > 0.0 for test in tests)
    if not unknown:
        return []
    return [
        f"{unknown} of {len(tests)} records have no flat part before the slip starts, or a short "
        "one: their zero of the force cannot be verified, and the intervals include up to "
        f"{100 * UNKNOWN_ZERO:.0f} % of the maximum force for it (one standard deviation)"
    ]


def _tests_sentence(tests: Sequence[TestResult], levels: Integers) -> str:
    """What was tested, as far as the plan says: pressures, slip, temperature, speed, dates."""
    planned = [test.test for test in tests]
    speeds = [per_minute(v) for v in sorted({t.speed for t in planned if t.speed is not None})]
    parts = [
        _range([test.curve.pressure for test in tests], "pressure"),
        _slip_reached(tests, levels),
        _range([t.temperature for t in planned if t.temperature is not None], "temperature"),
        _ends(speeds),
    ]
    dates = sorted({test.date for test in planned if test.date})
    parts.append(_ends(dates))
    count = f"{len(tests)} tests" if len(tests) > 1 else "1 test"
    return f"{count}: {', '.join(part for part in parts if part)}"


def _ends(ordered: Sequence[str]) -> str:
    """The first and the last of texts in order; one alone by itself."""
    return " to ".join(dict.fromkeys([*ordered[:1], *ordered[-1:]]))


def _unused(plan: TestPlan) -> list[str]:
    """Tests that the plan itself leaves out, and why."""
    unused = plan.unused_tests
    if not unused:
        return []
    many = f"{len(unused)} tests were" if len(unused) > 1 else "1 test was"
    named = "; ".join(f"{test.file} ({test.reason})" for test in unused[:_FEW])
    more = "; ..." if len(unused) > _FEW else ""
    return [f"{many} not used, as the plan says: {named}{more}"]


def _held(plan: TestPlan) -> list[str]:
    """What was not fitted but given."""
    held = plan.held
    said = [
        f"peak slip {quantity(held.peak_slip, 'length', 4)}" if held.peak_slip is not None else "",
        f"peak friction {held.peak_friction:.4g}" if held.peak_friction is not None else "",
        f"lash {quantity(held.lash, 'length', 4)}" if held.lash is not None else "",
    ]
    text = ", ".join(part for part in said if part)
    return [f"fixed in every curve, as the plan says, not fitted: {text}"] if text else []


def _slip_reached(tests: Sequence[TestResult], levels: Integers) -> str:
    reached = np.array([test.fit.slip_max for test in tests])
    everywhere = min(float(reached[levels == k].max()) for k in np.unique(levels))
    less = f", {quantity(everywhere, 'length')} at every pressure"
    short = less if everywhere < 0.9 * reached.max() else ""
    return f"slip up to {quantity(reached.max(), 'length')}{short}"


def _range(values: Sequence[float], of: Dimension) -> str:
    return Cell(max(values), of, 3, "to", min(values)) if values else ""


def _of_curves(tests: Sequence[TestResult], told: str) -> list[str]:
    """What single curves show, but for what is told; the same of more than a few is said once."""
    about: dict[str, list[tuple[TestResult, Sentence]]] = {}
    for test in tests:
        for sentence in (s for s in test.judged.misfit if s.about != told):
            about.setdefault(sentence.about, []).append((test, sentence))
    found: list[str] = []
    for cases in about.values():
        test, said = cases[0]
        many = f" and {len(cases) - 1} more" if len(cases) > 1 else ""
        head = f"{said.headline} ({test.test.file}{many})" if said.headline else ""
        if len(cases) <= _FEW:
            texts = [f"{test.name}: {sentence.text}" for test, sentence in cases]
        else:
            texts = [f"{len(cases)} of {len(tests)} tests, as {test.name}: {said.text}"]
        found += [Misfit(texts[0], head, said.action), *texts[1:]]
    return found


def _repeats(tests: Sequence[TestResult], found: Findings) -> list[str]:
    sentences: list[str] = []
    for k in np.flatnonzero(found.flagged).tolist():
        alone = not np.any((found.levels == found.levels[k]) & ~found.flagged)
        friction = tests[k].fit.parameters.peak_friction
        which = "; which of them is wrong is not known" if alone else "; it counts little"
        by = f"disagrees with its repeats by {found.repeat_distances[k]:.1f} standard deviations"
        text = (
            f"{tests[k].name}: {by} (peak friction {friction:.3f}){which}; see whether sample, "
            "load and surface were as planned"
        )
        action = "Check sample, load and surface of these repeats, or repeat them."
        sentences.append(Misfit(text, f"{tests[k].test.file} {by}", action))
    return sentences


def _curves_off(tests: Sequence[TestResult], law: PressureFit, found: Findings) -> list[str]:
    sentences: list[str] = []
    again = "Repeat this test, or leave it out of the plan."
    for k, test in enumerate(tests):
        if found.flagged[k]:
            continue
        if law.distances[k] > _FAR_FROM_LAW:
            far = f"{law.distances[k]:.1f} standard deviations from the law of all"
            sentences.append(
                Misfit(f"{test.name}: lies {far}", f"{test.test.file} lies {far}", again)
            )
        elif found.lone_distances[k] > FAR:
            far = f"{found.lone_distances[k]:.1f} standard deviations from the trend of the others"
            advice = "it has no repeat: repeat it, or take it out of the plan"
            text = f"{test.name}: lies {far} over pressure; {advice}"
            sentences.append(Misfit(text, f"{test.test.file} lies {far}", again))
    return sentences


def _predictions(left_out: Sequence[LeftOut]) -> list[str]:
    """Pressures inside the tested range that the others miss by more than chance explains."""
    poor = [item for item in left_out if item.missed]
    if not poor:
        return []
    listed = ", ".join(
        f"{quantity(item.pressure, 'pressure')} by {item.error:.3f} ({_in_noise(item)}, "
        f"{item.distance:.1f} standard deviations where chance reaches {item.limit:.1f})"
        for item in poor
    )
    most = max(poor, key=lambda item: item.error / item.peak_friction)
    head = (
        f"the law of the other pressures misses {quantity(most.pressure, 'pressure')} by "
        f"{100 * most.error / most.peak_friction:.0f} % of friction"
    )
    text = f"left out, these pressures are missed by the law of the others: {listed}"
    return [Misfit(text, head, "Repeat this pressure, and test one on either side of it.")]


def _in_noise(item: LeftOut) -> str:
    levels = item.noise_levels
    return f"{levels:.1f} noise levels" if levels < _CLEARLY else "far above the noise"


def _cover_sentence(plan: TestPlan) -> str:
    """Say what became of the shear of the test belt's cover."""
    if plan.cover_compliance > 0.0:
        return (
            f"the shear of the test belt's cover, h/G = {per_stress(plan.cover_compliance)} times "
            f"the shear stress, is taken off the travel{_within(plan, 'cover_shear_modulus')}"
        )
    if plan.cover_thickness is not None:
        return "the test belt has no cover that shears, as the plan says"
    if plan.digitised is not None:
        return "whether the slip of the figure includes the shear of a belt cover is not stated"
    return (
        "the shear of the test belt's cover is in the slip, for its thickness and modulus are "
        "missing ([test_belt])"
    )


def _within(plan: TestPlan, modulus: str) -> str:
    """Say what a modulus may be wrong by, and whether that was stated."""
    stated = getattr(plan.uncertainty, modulus, 0.0)
    error, assumed = Uncertainty.modulus_error(stated), "" if stated is not None else " (assumed)"
    return f"; its modulus is within {100.0 * error:.3g} %{assumed}" if error else ""


def _shear_sentence(plan: TestPlan) -> str:
    if plan.removes_shear:
        return (
            f"slip is travel less lash and less the sample's own shear, h/G = "
            f"{per_stress(plan.shear_compliance)} times the shear stress"
            f"{_within(plan, 'shear_modulus')}"
        )
    if plan.shear_compliance > 0.0:
        return (
            "the sample's own shear was left in the slip, as asked; the lagging is therefore "
            "written without thickness, so that the shear is not counted twice"
        )
    return (
        "the sample's own shear is in the slip, for thickness and shear modulus are missing; "
        "the lagging is written without thickness, so that the shear is not counted twice"
    )


def _form(law: PressureFit, choice: PressureChoice) -> list[str]:
    remarks = [f"pressure dependence: {law.form}", *choice.notes]
    if law.form.nodes:
        remarks.append(
            "no trend line follows the curves within their scatter, so the law has a value of "
            "its own at each tested pressure; between them it interpolates"
        )
    return remarks


def _transition(plan: TestPlan, found: Findings) -> list[str]:
    transition, saturation = found.transition, plan.saturation_pressure
    estimate = (
        f"; the saturation estimate E * roughness / thickness is {quantity(saturation, 'pressure')}"
        if saturation is not None
        else ""
    )
    if transition is None:
        few = found.choice is None or found.choice.two_pieces is None
        if few:
            return [f"too few pressures to look for a transition{estimate}"]
        return [f"no transition is shown: a smooth law does as well{estimate}"]
    at = quantity(transition.pressure, "pressure")
    if transition.given:
        return [f"transition pressure, input: {at}{estimate}"]
    # no interval: where samples scatter, that of the profile is too narrow
    text = f"transition pressure about {at}, which samples that scatter can shift far{estimate}"
    if not transition.in_law:
        text = f"the law has no transition; the best law of two pieces has its {text}"
    remarks = [text]
    if not transition.inside:
        remarks.append(
            "that transition lies at the edge of where these pressures could show one: test at "
            "more pressures past it"
        )
    return remarks
