"""Virtual laboratories that several tests share."""

import importlib.util
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from wraparc.friction import IntegralLog, PressureKnots, TestedRange
from wraparc.shear_test import (
    MachineRecord,
    PlannedTest,
    PlanResult,
    Rig,
    TestPlan,
    VirtualRig,
    VirtualTest,
    fit_plan,
    run_virtual_test,
)

PRESSURES = np.array([34, 69, 103, 138, 207, 276, 414, 690]) * 1e3
TRANSITION = 172e3
THICKNESS, SHEAR_MODULUS = 12e-3, 2.3e6


def single(peak_friction: float, peak_slip: float, **tail: float) -> IntegralLog:
    """A law that does not depend on pressure."""
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=(1e5,),
            peak_friction=(peak_friction,),
            peak_slip=(peak_slip,),
            **{name: (value,) for name, value in tail.items()},
        )
    )


def rubber() -> IntegralLog:
    """Peak slip and peak friction in two straight pieces that meet at 172 kPa."""
    ends = [34e3, TRANSITION, 690e3]
    p = np.unique(np.concatenate([np.linspace(34e3, 690e3, 400), ends]))
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=tuple(p.tolist()),
            peak_friction=tuple(np.interp(p, ends, [1.30, 0.86, 0.385]).tolist()),
            peak_slip=tuple(np.interp(p, ends, [0.016, 0.0205, 0.026]).tolist()),
        ),
        tested=TestedRange(pressure_min=34e3, pressure_max=690e3, slip_max=15e-3),
    )


def as_record(test: VirtualTest, name: str = "virtual") -> MachineRecord:
    count = len(test.travel)
    return MachineRecord(
        file=name, place="", encoding="", delimiter="", decimal=".", columns=(),
        travel=test.travel, force=test.force, normal_force=test.normal_force, time=test.time,
        lines=np.arange(1, count + 1), rows=count, dropped=(), notes=(), header=(), digest=name,
    )  # fmt: skip


Edit = Callable[[str, MachineRecord], MachineRecord]


def laboratory(
    *, seed: int = 1, repeats: int = 3, pressures: Any = PRESSURES, **rig: Any
) -> tuple[TestPlan, dict[str, MachineRecord]]:
    """A plan and its records: test ``pXrY`` is repeat Y at the X-th pressure, both from 0."""
    of = VirtualRig(law=rubber(), shear_compliance=THICKNESS / SHEAR_MODULUS, points=1500)
    of = replace(of, **rig)
    tests: list[PlannedTest] = []
    records: dict[str, MachineRecord] = {}
    for k, pressure in enumerate(pressures):
        for r in range(repeats):
            name = f"p{k}r{r}"
            drawn = run_virtual_test(of, float(pressure), seed * 1000 + 10 * k + r)
            records[name] = as_record(drawn, name)
            place = f"test[{len(tests) + 1}]"
            tests.append(PlannedTest(file=name, place=place, pressure=float(pressure)))
    plan = TestPlan(
        name="virtual",
        rig=Rig(area=of.area),
        tests=tuple(tests),
        thickness=THICKNESS,
        shear_modulus=SHEAR_MODULUS,
        elastic_modulus=3 * SHEAR_MODULUS,
        roughness=0.3e-3,
    )
    return plan, records


@cache
def benchmark_module(name: str) -> ModuleType:
    """A file of benchmarks, of which the tests make a short run."""
    path = Path(__file__).parents[2] / "benchmarks" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def verdicts() -> ModuleType:
    """benchmarks/shear_test_verdicts.py, whose laboratories are fitted here in small numbers."""
    return benchmark_module("shear_test_verdicts")


def fitted(plan: TestPlan, records: dict[str, MachineRecord]) -> PlanResult:
    return fit_plan(plan, read=lambda test: records[test.file])
