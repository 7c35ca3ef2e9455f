"""Faults of recording and of the campaign: known ones, put into sound virtual laboratories.

Each fault passed as OK before it was looked for.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import fitted, laboratory, verdicts
from wraparc.answer.shear_test_tables import plan_sheet, verdict
from wraparc.answer.sheet import shown
from wraparc.checks import Level
from wraparc.shear_test import Choices, MachineRecord, Sample, reduce_record
from wraparc.shear_test.campaign import order_of
from wraparc.shear_test.load_slips import surface_questions
from wraparc.shear_test.record_faults import saturated
from wraparc.units import in_units

SAID = {
    "one load cell at its end": "132 of 250 readings of the force are clipped at ",
    "one travel sensor at its end": "the travel is constant at its maximum",
    "a tenth of the readings of one test lost": "readings are missing at 1 place",
    "a tenth of the readings of one test written twice": "rows repeat those before them",
    "5 % less friction a test, pressures upwards": "the pressures were tested in their order",
    "5 % less friction a test, mixed order": "from the first test to the last",
    "stick-slip of 10 % in every curve": "stick-slip: friction varies by 1",
    "1 face in the plan, 2 slid": "do 1 of its faces slide",
}


def faulty(fault: str, seed: int) -> Any:
    lab = verdicts().laboratory(verdicts().smooth(), "4 x 2", seed)
    verdicts().FAULTS[fault](lab, seed)
    return lab.fit()


@pytest.mark.parametrize("fault", SAID)
def test_a_fault_is_named_in_the_verdict(fault: str) -> None:
    result = faulty(fault, 3)
    told = in_units(" ".join([*map(str, result.left_out), *result.misfit]))
    assert SAID[fault] in told
    assert shown(verdict(result), "si").level is Level.ATTENTION


def one(**rig: Any) -> MachineRecord:
    options: Any = {"points": 250, "seed": 5, "repeats": 1, "pressures": np.array([103e3])} | rig
    return laboratory(**options)[1]["p0r0"]


def reduced(record: MachineRecord, **sample: Any) -> Any:
    return reduce_record(record, Sample(area=0.04, **sample))


def test_a_measured_normal_force_can_be_at_its_end_too() -> None:
    record = one()
    assert record.normal_force is not None
    noisy = record.normal_force * (1.0 + np.random.default_rng(1).normal(0.0, 0.005, 250))
    held = np.minimum(noisy, np.quantile(noisy, 0.3))
    with pytest.raises(Exception, match="readings of the normal force are clipped at "):
        reduced(replace(record, normal_force=held))


@pytest.mark.parametrize("resolution", [1e-9, 2.0, 100.0])
def test_a_flat_peak_is_no_end_of_a_load_cell(resolution: float) -> None:
    """Without noise friction past a flat peak is one number; the curve comes to it flat."""
    x = np.linspace(0.0, 15e-3, 400)
    r = np.clip(x / 8e-3, 1e-9, 1.0)
    force = np.round(5000.0 * r * (1.0 - np.log(r)) / resolution) * resolution
    assert not saturated(force, x)
    clipped = np.minimum(force, np.floor(4200.0 / resolution) * resolution)
    assert bool(saturated(clipped, x)) is (resolution < 50.0)


def test_a_hold_in_which_the_force_relaxes_is_no_fault() -> None:
    record = one()
    hold = 40
    force = record.force[-1] * (0.9 + 0.1 * np.exp(-np.arange(hold) / 8.0))
    held = replace(
        record,
        travel=np.append(record.travel, np.full(hold, record.travel.max())),
        force=np.append(record.force, force), normal_force=None, time=None,
        lines=np.arange(len(record.lines) + hold), rows=len(record.lines) + hold,
    )  # fmt: skip
    assert not reduced(held, normal_force=103e3 * 0.04).faults


def test_a_travel_that_stands_at_the_start_is_told() -> None:
    record = one()
    travel = np.maximum(record.travel, 1.5e-3)
    (fault,) = reduced(replace(record, travel=travel)).faults
    assert "is constant at its first value" in fault.text


def slack_again(record: MachineRecord, least: float) -> MachineRecord:
    """The pull stands still for 1 mm of travel at 2.5 mm, or falls to a share of its force."""
    x = record.travel
    way = np.where(x < 2.5e-3, x, np.where(x < 3.5e-3, 2.5e-3, x - 1e-3))
    factor = np.where((x > 2.5e-3) & (x < 3.5e-3), least, 1.0)
    return replace(record, force=factor * np.interp(way, x, record.force))


@pytest.mark.parametrize("least", [1.0, 0.8])
@pytest.mark.parametrize("seed", range(1, 6))
def test_slack_that_is_taken_up_again_is_told(seed: int, least: float) -> None:
    record = one(seed=seed)
    assert not reduced(record).faults
    (fault,) = reduced(slack_again(record, least)).faults
    assert in_units(fault.text).startswith("friction rises less from 2")


def test_noise_that_remembers_is_neither_stick_slip_nor_slack() -> None:
    """2 % of noise, over 3 and 9.5 readings: 27 of 64 such laboratories were told of stick-slip."""
    told = 0
    for seed in range(1, 21):
        for readings in (3.0, 9.5):
            curve = reduced(one(seed=seed, noise=0.02, correlation=readings, points=600))
            assert curve.faults == ()
            told += curve.swing is not None
    assert told <= 1  # of 40; 3.5 standard deviations at some of the lags


COPIES: dict[str, Any] = {
    "as it is": {},
    "renamed": {"digest": "another"},
    "rounded": {"digest": "another", "digits": 6},
}


@pytest.mark.parametrize("copy", COPIES)
@pytest.mark.parametrize("place", ["p0r1", "p1r0"])
def test_a_copy_is_left_out_and_named(copy: str, place: str) -> None:
    """Of a repeat or at another pressure; two pulls of one sample never have the same noise."""
    plan, records = laboratory(pressures=[69e3, 207e3], repeats=2, points=300)
    assert not fitted(plan, records).left_out
    first, change = records["p0r0"], dict(COPIES[copy])
    if digits := change.pop("digits", None):
        change |= {"force": np.round(first.force), "travel": np.round(first.travel, digits)}
    records[place] = replace(first, **change)
    (problem,) = fitted(plan, records).left_out
    assert "contains the same data as test[1]. Name the right file" in str(problem)


def test_lots_at_pressures_of_their_own_are_told() -> None:
    plan, records = laboratory(pressures=[69e3, 138e3, 207e3], repeats=2, points=250)
    of = {"p0": "A", "p1": "B", "p2": "B"}
    tests = tuple(replace(test, lot=of[test.file[:2]]) for test in plan.tests)
    told = "lots 'A', 'B' were tested at pressures of their own"
    assert any(told in text for text in fitted(replace(plan, tests=tests), records).misfit)
    mixed = (replace(tests[0], lot="B"), *tests[1:])
    assert not any(told in text for text in fitted(replace(plan, tests=mixed), records).misfit)


@pytest.mark.parametrize(("which", "least", "most"), [("upper", 1.02, 1.07), ("lower", 0.93, 0.98)])
def test_the_plan_says_which_part_of_stick_slip_is_fitted(
    which: str, least: float, most: float
) -> None:
    """A sawtooth of 10 %: its ends are 5 % above and below its middle."""
    module = verdicts()
    peaks = []
    for part in ("mean", which):
        lab = module.laboratory(module.smooth(), "3 x 2", 2)
        module.FAULTS["stick-slip of 10 % in every curve"](lab, 2)
        tests = [replace(test, stick_slip=part) for test in lab.plan.tests]
        lab.plan = replace(lab.plan, tests=tuple(tests))
        result = lab.fit()
        assert not any("stick-slip" in text for text in result.misfit)
        peaks.append(result.conditions[0].peaks_at(np.array([138e3]))[1][0])
    assert least < peaks[1] / peaks[0] < most


def test_the_order_of_tests_is_asked_for_and_read_from_dates() -> None:
    plan, records = laboratory(seed=2, repeats=2, points=250)
    remarks = fitted(plan, records).conditions[0].remarks
    assert any("the order of the tests is not stated" in text for text in remarks)
    dated = [replace(plan.tests[k], date=f"2026-03-0{3 - k}") for k in range(3)]
    assert order_of(dated).tolist() == [2, 1, 0]  # type: ignore[union-attr]
    assert order_of([replace(dated[0], date="in March"), *dated[1:]]) is None
    worn = replace(plan, tests=tuple(replace(test, sample="A") for test in plan.tests))
    assert any("one sample served for 16 tests" in text for text in fitted(worn, records).misfit)


def test_a_trend_within_chance_is_told_with_its_error() -> None:
    """1.5 % less a test, eight tests: 10 % in all, to a scatter of 3 %. It may be chance."""
    module = verdicts()
    lab = module.laboratory(module.smooth(), "4 x 2", 3)
    for test in lab.plan.tests:
        record = lab.records[test.file]
        lab.records[test.file] = replace(record, force=0.985 ** (test.order - 1) * record.force)
    told = "friction shows no significant trend with the order of the tests: "
    (text,) = (in_units(s) for s in lab.fit().conditions[0].remarks if s.startswith(told))
    assert float(text.removeprefix(told).split()[0]) == pytest.approx(-10.0, abs=5.0)
    assert text.endswith("standard error 3 %")


def test_a_sample_that_wears_shows_in_its_repeats_where_no_order_is_stated() -> None:
    """5 % less from each test to the next of its pressure, as the plan lists them; else nothing."""
    plan, records = laboratory(seed=2, repeats=3, points=250)
    sound = fitted(plan, records)
    told = "from a test to the next of its pressure in the plan"
    assert not any(told in text for text in sound.misfit)
    assert any(
        also.text.endswith("; test order missing: wear is not detectable.")
        for also in shown(verdict(sound), "si").also
    )
    for name, record in records.items():
        records[name] = replace(record, force=0.95 ** int(name[-1]) * record.force)
    worn = fitted(plan, records)
    (text,) = (in_units(text) for text in worn.misfit if told in text)
    # 0.95 - 1, to the scatter of 2 % over the root of 16
    assert float(text.split("%")[0].split()[-1]) == pytest.approx(-5.0, abs=1.0)
    assert shown(verdict(worn), "si").level is Level.ATTENTION


def test_a_pressure_typed_wrong_for_all_its_tests_is_asked_about_where_friction_rises() -> None:
    """Of a power -0.3 of pressure: 1.5 times at 103 kPa, friction is (2/3) 103^-0.3 at 155 kPa.

    That is a fifth below the 207^-0.3 of the next pressure.
    """
    module = verdicts()
    lab = module.laboratory(module.smooth(), "4 x 2", 3)
    rises = "peak friction rises from"
    assert not any(text.startswith(rises) for text in lab.fit().misfit)
    lab.scale([name for name in lab.records if name.startswith("p1")], load=1.5)
    result = lab.fit()
    (text,) = (in_units(text) for text in result.misfit if text.startswith(rises))
    assert "at 154.5 kPa to" in text
    assert "at 207 kPa" in text
    assert shown(verdict(result), "si").level is Level.ATTENTION


def test_scatter_is_what_the_repeats_show() -> None:
    """ln mu of two tests of a pressure 4 % apart has a standard deviation of 0.04 / sqrt 2."""
    plan, records = laboratory(seed=2, repeats=2, points=250)
    for name in [name for name in records if name.endswith("r1")]:
        records[name] = replace(records[name], force=1.04 * records[name].force)
    condition = fitted(plan, records).conditions[0]
    scatter = condition.found.scatter
    assert scatter is not None
    assert scatter.value == pytest.approx(0.04 / np.sqrt(2.0), rel=0.2)
    # of 8 pressures; chi-square of 8 degrees of freedom: 2.180 and 17.535 (tables)
    assert scatter.freedom == 8
    expected = scatter.value * np.sqrt(8.0 / np.array([17.535, 2.180]))
    np.testing.assert_allclose(scatter.ends, expected, rtol=1e-3)
    told = "repeats scatter by 2.8 % in peak friction (between 1.9 and 5.3 %, with 95 %)"
    assert any(text.startswith(told) for text in condition.remarks)


def test_a_low_zero_is_no_contradiction() -> None:
    """5 % of the largest force stand before the slip: below the 10 % of the sentence."""
    record = one(lash=0.8e-3)
    off = replace(record, force=record.force + 0.05 * float(record.force.max()))
    curve = reduced(off)
    assert curve.zero_unknown < 0.05 * curve.top


def test_friction_outside_the_band_of_its_surface_is_asked_about() -> None:
    """Rubber: design values from 0.35 dry (CEMA) to 0.45 (DIN 22101), times 3."""
    assert not surface_questions("rubber", "dry", np.array([0.9, 0.8]), 2)
    assert not surface_questions("", "dry", np.array([5.0]), 2)
    (text,) = surface_questions("rubber", "dry", np.array([1.6, 1.5]), 1)
    assert text.startswith("its mean peak friction, 1.55, is outside the 0.35 to 1.35 that rubber")
    assert surface_questions("rubber", "dry", np.array([0.3]), 2)


def test_sheets_of_one_workbook_are_named_by_their_sheets() -> None:
    test = laboratory(repeats=1, points=20)[0].tests[0]
    named = replace(test, file="all.xlsx", choices=Choices(sheet="34 kPa"))
    assert named.label == "all.xlsx, sheet 34 kPa"
    assert test.label == test.file


def test_the_report_says_what_slip_includes_and_the_order() -> None:
    lab = verdicts().laboratory(verdicts().smooth(), "3 x 2", 1)
    rows = {r.title: r.values for t in shown(plan_sheet(lab.fit()), "si").tables for r in t.rows}
    assert rows["Slip includes"] == ("sliding and cover shear and the rig's own travel",)
    assert rows["Order of the tests"] == ("p0r0, p1r0, p2r0, ... p0r1",)


def test_a_pressure_typed_far_beyond_all_others_is_asked_about() -> None:
    """5500 for 550 kPa: a tenth of the friction there, as a law that falls so steeply may have."""
    module = verdicts()
    lab = module.laboratory(module.two_pieces(), "9 x 1", 16)
    module.FAULTS["one pressure typed 10 times off"](lab, 16)
    (text, *_) = verdict(lab.fit()).sentences
    assert "was its pressure 550 kPa, not 5500 kPa?" in in_units(text)
