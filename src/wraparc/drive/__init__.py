"""Descriptions of a drive: frozen, checked, in SI. Nothing here solves anything."""

from wraparc.conveyor import GRAVITY
from wraparc.drive.across import Across, GrippingPulley, Transition, WidthProfile
from wraparc.drive.belt import Belt
from wraparc.drive.compression import SHAPES, Block, compression_modulus
from wraparc.drive.criteria import (
    CASE_KINDS,
    CONDITIONS,
    STANDARDS,
    TAKE_UPS,
    CaseKind,
    Criteria,
    DesignStandard,
    SafetyFactors,
    Sag,
    TakeUp,
)
from wraparc.drive.drive import (
    CREEP_LIMIT,
    MOST_PULLEYS,
    Drive,
    condition_problems,
    laggings_of,
    repeated,
)
from wraparc.drive.factors import ConditionFactor, Factors, FrictionFactor
from wraparc.drive.fit import NORMAL_95, Fit, half_interval, knots_of, with_peaks
from wraparc.drive.lagging import SURFACES, Cost, Lagging
from wraparc.drive.load_case import DESIGN, LoadCase, Tensions
from wraparc.drive.pulley import Pulley
from wraparc.drive.read_from import ReadFrom
from wraparc.schema.limits import Limit

__all__ = [
    "CASE_KINDS",
    "CONDITIONS",
    "CREEP_LIMIT",
    "DESIGN",
    "GRAVITY",
    "MOST_PULLEYS",
    "NORMAL_95",
    "SHAPES",
    "STANDARDS",
    "SURFACES",
    "TAKE_UPS",
    "Across",
    "Belt",
    "Block",
    "CaseKind",
    "ConditionFactor",
    "Cost",
    "Criteria",
    "DesignStandard",
    "Drive",
    "Factors",
    "Fit",
    "FrictionFactor",
    "GrippingPulley",
    "Lagging",
    "Limit",
    "LoadCase",
    "Pulley",
    "ReadFrom",
    "SafetyFactors",
    "Sag",
    "TakeUp",
    "Tensions",
    "Transition",
    "WidthProfile",
    "compression_modulus",
    "condition_problems",
    "half_interval",
    "knots_of",
    "laggings_of",
    "repeated",
    "with_peaks",
]
