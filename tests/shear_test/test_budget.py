"""The budget of uncertainty: sensitivities against laboratories that do err, and its sums."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import fitted, laboratory
from wraparc.answer.shear_test_budget import budget_table
from wraparc.answer.sheet import shown
from wraparc.arrays import Array
from wraparc.errors import InputError
from wraparc.shear_test import MachineRecord, TestPlan
from wraparc.shear_test.budget import Common, Uncertainty
from wraparc.shear_test.plan_file import plan_from_text
from wraparc.shear_test.pressure_fit import PressureFit
from wraparc.shear_test.student import t95

NONE = Uncertainty(
    force=0.0, normal_force=0.0, area=0.0, travel=0.0, compliance=0.0, shear_modulus=0.0
)
AT = np.array([120e3])
Records = dict[str, MachineRecord]


def law(plan: TestPlan, records: Records) -> PressureFit:
    found = fitted(plan, records).conditions[0].fit
    assert found is not None
    return found


def common(plan: TestPlan, records: Records, **limits: float | None) -> Common:
    """The errors of a laboratory with these limits and no others."""
    stated = replace(NONE, **limits)  # type: ignore[arg-type]
    found = law(replace(plan, uncertainty=stated), records).common
    assert found is not None
    return found


@pytest.fixture(scope="module")
def sound() -> tuple[TestPlan, Records]:
    """A laboratory with next to no noise: what moves its law is the error that is put in."""
    of = laboratory(repeats=2, pressures=[60e3, 110e3, 200e3], points=300, noise=1e-3, stroke=30e-3)
    return replace(of[0], options=replace(of[0].options, pieces=1)), of[1]


def each(records: Records, change: Callable[[MachineRecord], MachineRecord]) -> Records:
    return {name: change(record) for name, record in records.items()}


def unweighed(record: MachineRecord) -> MachineRecord:
    return replace(record, normal_force=None)


def pressed(record: MachineRecord, factor: float) -> MachineRecord:
    assert record.normal_force is not None
    return replace(record, normal_force=factor * record.normal_force)


# what errs by 2 %, the machine's files with the error, the plan with it; measured normal force
ERRORS: list[tuple[str, Callable[[MachineRecord], MachineRecord], float, bool]] = [
    ("pulling force", lambda r: replace(r, force=1.02 * r.force), 1.0, True),
    ("normal force", lambda r: pressed(r, 1.02), 1.0, True),
    ("travel", lambda r: replace(r, travel=1.02 * r.travel), 1.0, True),
    ("sample area", lambda r: r, 1.02, True),
    ("sample area", unweighed, 1.02, False),
]  # fmt: skip


@pytest.mark.parametrize(("part", "change", "area", "weighed"), ERRORS)
def test_the_law_moves_by_its_sensitivity_when_a_transducer_errs(
    sound: tuple[TestPlan, Records],
    part: str,
    change: Callable[[MachineRecord], MachineRecord],
    area: float,
    weighed: bool,
) -> None:
    """The laboratory fitted again with one error of 2 % in its files or its plan, within 10 %."""
    plan, records = sound
    base = records if weighed else each(records, unweighed)
    wrong = replace(plan, rig=replace(plan.rig, area=area * plan.rig.area))
    before, after = law(plan, base), law(wrong, each(base, change))
    moved = (after.peaks(AT) - before.peaks(AT))[0]
    limits = {"pulling force": "force", "normal force": "normal_force", "sample area": "area"}
    told = common(plan, base, **{limits.get(part, part): 0.02})
    expected = told.effects(before.peaks, AT)[part][0] * np.sqrt(3.0)
    assert np.abs(expected).max() > 3e-3
    np.testing.assert_allclose(moved, expected, atol=0.1 * np.abs(expected).max())


def test_a_rig_that_yields_moves_the_peak_slip() -> None:
    """Files of a rig of 0.05 mm/kN, read as of a rigid one: the law's peak lies beyond by c F."""
    made: dict[str, Any] = {
        "repeats": 1,
        "pressures": [100e3, 200e3],
        "points": 300,
        "noise": 1e-3,
        "stroke": 30e-3,
    }
    (plan, stiff), (_, soft) = laboratory(**made), laboratory(**made, compliance=0.05e-6)
    before, after = law(plan, stiff), law(plan, soft)
    told = common(plan, stiff, compliance=None)
    expected = told.effects(before.peaks, AT)["compliance of the rig"][0] * np.sqrt(3.0)
    moved = (after.peaks(AT) - before.peaks(AT))[0]
    assert expected[0] > 0.03
    np.testing.assert_allclose(moved, expected, atol=0.15 * expected[0])


@pytest.mark.parametrize(
    ("part", "key", "none"),
    [
        ("modulus of the belt cover", "cover_shear_modulus", {"cover_thickness": None}),
        ("modulus of the sample", "shear_modulus", {"remove_shear": False}),
    ],
)
def test_a_rubber_of_another_modulus_moves_the_peak_slip(
    sound: tuple[TestPlan, Records], part: str, key: str, none: dict[str, Any]
) -> None:
    """The same files, their rubber said to be 5 % softer: the law moves by its sensitivity."""
    plan, records = replace(sound[0], cover_thickness=4e-3, cover_shear_modulus=1e6), sound[1]
    softer = replace(plan, **{key: getattr(plan, key) / 1.05})
    before, after = law(plan, records), law(softer, records)
    told = common(plan, records, **{key: 0.05})
    expected = told.effects(before.peaks, AT)[part][0] * np.sqrt(3.0)
    moved = (before.peaks(AT) - after.peaks(AT))[0]
    assert expected[0] > 1e-3
    np.testing.assert_allclose(moved, expected, atol=0.15 * expected[0])
    assumed = common(plan, records, **{key: None})
    found = assumed.effects(before.peaks, AT)[part][0] * np.sqrt(3.0)
    np.testing.assert_allclose(found, 4.0 * expected, rtol=1e-12)
    without = common(replace(plan, **none), records).effects(before.peaks, AT)
    assert part not in without


def test_what_sample_and_cover_may_be_wrong_by_is_said(sound: tuple[TestPlan, Records]) -> None:
    plan, records = sound
    covered = replace(plan, cover_thickness=4e-3, cover_shear_modulus=1e6)
    for error, origin, said in (
        (None, "at most 20 %, assumed: 5 Shore A", "its modulus is within 20 % (assumed)"),
        (0.07, "at most 7 %, as stated", "its modulus is within 7 %"),
    ):
        limits = Uncertainty(shear_modulus=error, cover_shear_modulus=error)
        found = fitted(replace(covered, uncertainty=limits), records)
        table = shown(budget_table(found.conditions[0], ""), "si")
        assert table is not None
        assert [r.note for r in table.rows if r.title.startswith("modulus")] == [origin] * 2
        assert sum(r.endswith(said) for r in found.conditions[0].remarks) == 2


def test_the_parts_add_up_to_the_interval_of_the_law(sound: tuple[TestPlan, Records]) -> None:
    """Sum of the squares of the parts: the variance that intervals and lagging files have."""
    plan, records = sound
    found = fitted(replace(plan, uncertainty=Uncertainty()), records).conditions[0]
    assert found.fit is not None
    budget = found.fit.budget(found.found.points)
    own = np.sqrt(np.einsum("nii->ni", found.fit.own_covariance(budget.pressure)))
    np.testing.assert_allclose(budget.combined, own, rtol=0.02)
    slip, friction, half = found.peaks_at(budget.pressure)
    np.testing.assert_allclose(half, budget.expanded, rtol=0.02)
    assert slip.shape == friction.shape
    fit = found.lagging.fit
    assert fit is not None
    assert fit.coverage_factor == pytest.approx(budget.coverage_factor, rel=1e-3)
    # the least that a law from transducers of 1 % can be known to: 1 % / sqrt(3) of the pull
    spread = np.sqrt(np.diag(fit.log_covariance))
    assert spread.min() > 0.01 / np.sqrt(3.0)


def test_known_errors_bring_the_coverage_factor_near_to_2(sound: tuple[TestPlan, Records]) -> None:
    """Welch and Satterthwaite: few repeats matter less where known errors govern."""
    plan, records = sound
    alone = law(plan, records)
    large = law(replace(plan, uncertainty=Uncertainty(force=0.2, travel=0.2)), records)
    assert alone.coverage_factor == pytest.approx(t95(alone.freedom))
    assert alone.coverage_factor > 2.0
    assert large.coverage_factor == pytest.approx(1.96, abs=0.01)


PLAN = """
format = 1
[lagging]
name = "mine"
[rig]
sample_area = "400 cm2"
compliance = "0.02 mm/kN"
[uncertainty]
force = "0.5 %"
zero = "2 N"
compliance = "0.004 mm/kN"
[[test]]
file = "a.csv"
pressure = "34 kPa"
"""


def test_a_plan_states_largest_errors() -> None:
    found = plan_from_text(PLAN).uncertainty
    assert found == Uncertainty(force=0.005, zero=2.0, compliance=0.004e-3 / 1e3, stated=True)
    silent = plan_from_text(PLAN[: PLAN.index("[uncertainty]")] + PLAN[PLAN.index("[[test]]") :])
    assert silent.uncertainty == Uncertainty()
    assert found is not None
    assert silent.uncertainty is not None
    assert found.compliance_error(0.02e-6) == pytest.approx(0.004e-6)
    assert silent.uncertainty.compliance_error(0.02e-6) == pytest.approx(0.2 * 0.02e-6)
    assert silent.uncertainty.compliance_error(0.0) == pytest.approx(0.05e-6)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            '"0.5 %"',
            '"80 %"',
            'uncertainty.force: must be a percentage from 0 % to 50 %, got "80 %".',
        ),
        ('"0.5 %"', "0.5", 'uncertainty.force: must be a percentage, got 0.5. Write "0.5 %".'),
        ('"0.5 %"', '"0,5"', 'uncertainty.force: must be a percentage, got "0,5". Write "0.5 %".'),
        ('"2 N"', '"-2 N"', 'uncertainty.zero: must be at least 0 kN, got "-2 N".'),
        ('"0.004 mm/kN"', '"4"', 'uncertainty.compliance: must be a length over a force, got "4".'),
    ],
)
def test_errors_that_cannot_be_are_refused(old: str, new: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_from_text(PLAN.replace(old, new))
    assert said in str(caught.value)


def test_a_single_pressure_has_common_errors_too() -> None:
    plan, records = laboratory(repeats=2, pressures=[150e3], points=300, noise=1e-3)
    spread: list[Array] = []
    for limits in (None, Uncertainty(force=0.1)):
        lagging = fitted(replace(plan, uncertainty=limits), records).conditions[0].lagging
        assert lagging.fit is not None
        spread.append(np.sqrt(np.diag(lagging.fit.log_covariance)))
    # 10 % over the root of 3, and the 1 % of the normal force that is left; the shear taken off
    # with the stress takes less than 1 % of it
    added = np.sqrt(spread[1][1] ** 2 - spread[0][1] ** 2)
    assert added == pytest.approx(np.hypot(0.1, 0.01) / np.sqrt(3.0), rel=0.02)
