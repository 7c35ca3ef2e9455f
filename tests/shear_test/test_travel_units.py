"""A travel in another unit than its fellows', and noise that is no stick-slip.

Expected: the factor by which the travel was changed; noise of AR(2), which a swinging rig makes.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import as_record, fitted, laboratory, single
from wraparc.shear_test import MachineRecord, Sample, VirtualRig, reduce_record, run_virtual_test
from wraparc.shear_test.record import ColumnInfo
from wraparc.shear_test.record_faults import excess_kurtosis

PRESSURES = np.array([69, 138, 276]) * 1e3


def with_travel(factor: float, unit: str, count: int = 3) -> tuple[Any, dict[str, MachineRecord]]:
    plan, records = laboratory(
        seed=1, repeats=2 if count > 2 else 1, pressures=PRESSURES[:count], points=250
    )
    column = ColumnInfo(name="Travel", unit=unit, role="travel")
    of = records["p1r0"]
    records["p1r0"] = replace(of, travel=factor * of.travel, columns=(column,))
    return plan, records


@pytest.mark.parametrize(
    ("factor", "unit", "said"),
    [
        (1e-3, "um", "1,000 times shorter than that of the others (mm instead of um would fit)"),
        (1e-3, "", "1,000 times shorter than that of the others."),
        (1 / 25.4, "mm", "25 times shorter than that of the others (in instead of mm would fit)"),
        (25.4, "in", "25 times longer than that of the others (mm instead of in would fit)"),
        (0.1, "mm", "10 times shorter than that of the others (cm instead of mm would fit)"),
    ],
)
def test_a_travel_of_another_unit_is_said_to_be_one(factor: float, unit: str, said: str) -> None:
    result = fitted(*with_travel(factor, unit))
    (problem,) = result.left_out
    assert f"its travel is {said}" in str(problem)
    assert "matrix" not in str(problem).lower()
    assert len(result.conditions[0].tests) == 5


def test_of_two_tests_the_one_that_no_laboratory_does_is_named() -> None:
    result = fitted(*with_travel(1e-3, "um", count=2))
    assert [problem.file for problem in result.left_out] == ["p1r0"]


def test_a_travel_of_metres_is_refused_with_its_unit() -> None:
    result = fitted(*with_travel(1e3, "m"))
    assert "(mm instead of m would fit)" in str(result.left_out[0])


def test_a_test_that_was_stopped_early_is_no_other_unit() -> None:
    plan, records = laboratory(seed=1, repeats=2, pressures=PRESSURES, points=250)
    of = records["p1r0"]
    end = 60
    records["p1r0"] = replace(
        of, travel=of.travel[:end], force=of.force[:end], time=None, lines=of.lines[:end],
        normal_force=None if of.normal_force is None else of.normal_force[:end], rows=end,
    )  # fmt: skip
    assert not fitted(plan, records).left_out


def swinging(seed: int, kind: str, points: int) -> MachineRecord:
    """A test whose friction swings by a tenth: as noise of a rig does, or as stick-slip."""
    rng = np.random.default_rng(seed)
    record = as_record(run_virtual_test(VirtualRig(law=single(0.9, 8e-3), points=points), 1e5, 1))
    if kind == "noise":
        damped, period = rng.uniform(0.9, 0.99), points / 40
        wave = np.zeros(points + 300)
        for k in range(2, len(wave)):
            turn = 2.0 * damped * np.cos(2.0 * np.pi / period)
            wave[k] = turn * wave[k - 1] - damped**2 * wave[k - 2] + rng.normal()
        wave = 0.03 * wave[300:] / wave.std()
    else:
        ends = np.cumsum(points / 40 * rng.uniform(0.75, 1.25, 200))
        place = np.searchsorted(ends, np.arange(points))
        left = ends[place] - np.arange(points)
        wave = 0.1 * (0.5 - left / np.diff(ends, prepend=0.0)[place])
    return replace(record, force=record.force * (1.0 + wave))


@pytest.mark.parametrize("points", [250, 2000])
def test_noise_of_a_rolling_rig_is_no_stick_slip(points: int) -> None:
    """One of 100 may be called so; sawteeth of the same size all are."""
    named = {
        kind: sum(
            reduce_record(swinging(seed, kind, points), Sample(area=0.04)).swing is not None
            for seed in range(25)
        )
        for kind in ("noise", "teeth")
    }
    assert named["noise"] <= 2
    assert named["teeth"] >= 24


def test_kurtosis_of_known_shapes() -> None:
    """Expected: -3/2 of a sine, -6/5 of even readings, in closed form."""
    at = np.linspace(0.0, 1.0, 20001)[:-1]
    assert excess_kurtosis(np.sin(2.0 * np.pi * at)) == pytest.approx(-1.5, abs=1e-3)
    assert excess_kurtosis(at) == pytest.approx(-1.2, abs=1e-3)
