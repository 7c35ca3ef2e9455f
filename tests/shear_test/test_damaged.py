"""A damaged file or folder ends in sentences: a short run of benchmarks/damaged_files.py.

There is no expected number: that no other exception and no warning comes out is what is tested,
and that of a test that is left out the reason is told while the others go on.
"""

import sys
from collections.abc import Callable
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import as_record, benchmark_module, fitted
from wraparc.errors import InputError
from wraparc.shear_test import PlannedTest, PlanResult, Rig, TestPlan, VirtualTest

Damage = Callable[[VirtualTest], VirtualTest]
ROOM = sys.modules["wraparc.shear_test.fit_plan"]


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    return benchmark_module("damaged_files")


@pytest.mark.parametrize(("what", "seeds"), [("use_file", 60), ("use_folder", 3)])
def test_damaged_files_and_folders(benchmark: ModuleType, what: str, seeds: int) -> None:
    said = {benchmark.measured(getattr(benchmark, what), seed)[0] for seed in range(seeds)}
    assert said
    assert not [word for word in said if word.startswith("FAILED")]


def fit(benchmark: ModuleType, damages: dict[str, Damage] | None = None) -> PlanResult:
    """Fit a laboratory of 4 pressures x 2, some tests of it, t1 to t8, damaged."""
    planned, records = [], {}
    for number, (pressure, test) in enumerate(benchmark.laboratory(), start=1):
        name = f"t{number}"
        damage = (damages or {}).get(name)
        records[name] = as_record(damage(test) if damage else test, name)
        planned.append(PlannedTest(file=name, place=f"test[{number}]", pressure=pressure))
    return fitted(TestPlan(name="x", rig=Rig(area=0.04), tests=tuple(planned)), records)


def test_travel_in_metres_under_millimetres_leaves_one_test_out(benchmark: ModuleType) -> None:
    def metres(test: VirtualTest) -> VirtualTest:
        return replace(test, travel=test.travel * 1e3)

    result = fit(benchmark, {"t3": metres})
    assert [problem.key for problem in result.left_out] == ["test[3]"]
    assert "implausible travel 15.5 m at force 9.88e+03 N" in str(result.left_out[0])
    assert len(result.conditions[0].tests) == 7


def test_a_test_with_which_there_is_no_law_is_left_out_and_named(
    benchmark: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The computation ends for two of the eight tests, as it did for folders of real damage."""
    original, bad = ROOM.fit_condition, {"t2", "t5"}

    def ends(plan: TestPlan, name: str, tests: Any, *more: Any) -> Any:
        if bad & {test.test.file for test in tests}:
            raise np.linalg.LinAlgError("Singular matrix")
        return original(plan, name, tests, *more)

    monkeypatch.setattr(ROOM, "fit_condition", ends)
    result = fit(benchmark)
    assert {problem.key for problem in result.left_out} == {"test[2]", "test[5]"}
    said = str(result.left_out[0])
    assert "no law fits its condition with this test (its readings determine no peak)" in said
    assert len(result.conditions[0].tests) == 6
    bad |= {f"t{k}" for k in range(1, 9)}
    with pytest.raises(InputError, match="determine no peak") as caught:
        fit(benchmark)
    assert len(caught.value.problems) == 8


def test_tests_measured_at_one_pressure_are_of_one_pressure_whatever_was_set(
    benchmark: ModuleType,
) -> None:
    """A set pressure ten times too large made a law over two equal pressures: a traceback."""
    pressure, test = benchmark.laboratory()[0]
    records = {"a": as_record(test, "a"), "b": as_record(benchmark.laboratory()[1][1], "b")}
    tests = tuple(
        PlannedTest(file=name, place=name, pressure=pressure * factor)
        for name, factor in (("a", 1.0), ("b", 10.0))
    )
    result = fitted(TestPlan(name="x", rig=Rig(area=0.04), tests=tests), records)
    assert result.conditions[0].found.levels.tolist() == [0, 0]
    assert "were set; the measured one was used" in " ".join(result.conditions[0].misfit)
