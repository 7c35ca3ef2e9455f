"""The law of one condition from its curves: pressure dependence, tails, predictions."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from wraparc.arrays import Flags, Integers
from wraparc.shear_test.analysis import ConditionResult, Findings, LeftOut, Separated, TestResult
from wraparc.shear_test.budget import Common, bent_peak
from wraparc.shear_test.consistency import lone_distances, outliers
from wraparc.shear_test.joint_fit import curve_points, refine
from wraparc.shear_test.lack_of_fit import with_lack_of_fit, with_unknown_zero
from wraparc.shear_test.law import lagging_of
from wraparc.shear_test.left_out import left_out_pressures
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.pressure_choice import choose_form
from wraparc.shear_test.sentences import law_sentences
from wraparc.shear_test.speeds import by_speed, speed_groups
from wraparc.shear_test.tails import Tails, level_tails
from wraparc.shear_test.transition import find_transition


def fit_condition(
    plan: TestPlan,
    condition: str,
    tests: Sequence[TestResult],
    levels: Integers,
    separated: Separated | None = None,
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
    separated
        What was taken off the tests for their speed and temperature.
    """
    curves, fits = [t.curve for t in tests], [t.fit for t in tests]
    points = curve_points(curves, fits, levels)
    told = separated is not None and separated.by_slip_speed is not None
    alike = points if told else by_speed(points, speed_groups(tests)[0])
    flagged, distances = outliers(alike)
    tails = _tails(tests, levels, flagged)
    choice = law = None
    left_out: tuple[LeftOut, ...] = ()
    common = _common(plan, tests)
    if len(np.unique(levels)) > 1:
        choice = choose_form(points, plan.options, flagged)
        law, points = refine(curves, fits, points, choice.fit, flagged)
        law = with_unknown_zero(with_lack_of_fit(law, points, flagged), fits)
        law = replace(law, common=common)
        good = [test for test, off in zip(tests, flagged, strict=True) if not off]
        left_out = left_out_pressures(law, points, good, levels[~flagged], tails)
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
        transition=find_transition(law, choice, points),
        tails=tails,
        left_out=left_out,
        common=common,
        separated=separated or Separated(),
    )
    misfit, remarks = law_sentences(plan, found)
    lagging = lagging_of(plan, found, misfit, remarks)
    return ConditionResult(found=found, lagging=lagging, misfit=misfit, remarks=remarks)


def _common(plan: TestPlan, tests: Sequence[TestResult]) -> Common | None:
    if plan.uncertainty is None:
        return None
    return Common(
        limits=plan.uncertainty,
        force_at=plan.rig.faces * plan.rig.area,
        compliance=plan.uncertainty.compliance_error(plan.rig.compliance),
        sample_compliance=plan.sample_compliance,
        cover_compliance=plan.cover_compliance,
        weighed=all(t.record.normal_force is not None or t.test.pressure is None for t in tests),
        bent=np.mean([bent_peak(t.fit) for t in tests], axis=0),
    )


def _tails(tests: Sequence[TestResult], levels: Integers, flagged: Flags) -> Tails:
    rows = []
    for level in np.unique(levels):
        inside = np.flatnonzero(levels == level).tolist()
        kept = [k for k in inside if not flagged[k]] or inside
        pressure = float(np.mean([tests[k].curve.pressure for k in kept]))
        rows.append((pressure, [tests[k].fit for k in kept]))
    return level_tails(rows)
