"""Shear tests to a lagging: machine exports, friction curves, law, pressure dependence."""

from wraparc.machine_tables import DELIMITER_NAMES
from wraparc.shear_test.analysis import ConditionResult, LeftOut, PlanResult, TestResult
from wraparc.shear_test.curve_fit import CurveFit, fit_curve
from wraparc.shear_test.dialects import DIALECTS, Dialect
from wraparc.shear_test.fit_plan import fit_plan
from wraparc.shear_test.plan import PlannedTest, Rig, TestPlan
from wraparc.shear_test.pressure_choice import PressureOptions
from wraparc.shear_test.reader import read_machine_bytes, read_machine_file, read_machine_tests
from wraparc.shear_test.record import Choices, MachineRecord
from wraparc.shear_test.reduce import FrictionCurve, Sample, reduce_record
from wraparc.shear_test.virtual_rig import VirtualRig, VirtualTest, run_virtual_test

__all__ = [
    "DELIMITER_NAMES",
    "DIALECTS",
    "Choices",
    "ConditionResult",
    "CurveFit",
    "Dialect",
    "FrictionCurve",
    "LeftOut",
    "MachineRecord",
    "PlanResult",
    "PlannedTest",
    "PressureOptions",
    "Rig",
    "Sample",
    "TestPlan",
    "TestResult",
    "VirtualRig",
    "VirtualTest",
    "fit_curve",
    "fit_plan",
    "read_machine_bytes",
    "read_machine_file",
    "read_machine_tests",
    "reduce_record",
    "run_virtual_test",
]
