"""Friction laws of a lagging: mu as a function of slip and wrap pressure."""

from wraparc.friction.base import (
    COVER_SHEAR,
    LAGGING_SHEAR,
    SLIP_INCLUDES,
    Equation,
    FrictionLaw,
    TestedRange,
)
from wraparc.friction.coefficients import (
    CoefficientPieces,
    Piece,
    PressureKnots,
    ab_from_peak,
    convert_ab,
    peak_from_ab,
)
from wraparc.friction.compact import CompactLaw
from wraparc.friction.integral_log import IntegralLog
from wraparc.friction.simple import Constant, ElasticPlastic, PressurePower
from wraparc.friction.table import MeasuredTable
from wraparc.friction.trend import Trend

__all__ = [
    "COVER_SHEAR",
    "LAGGING_SHEAR",
    "SLIP_INCLUDES",
    "CoefficientPieces",
    "CompactLaw",
    "Constant",
    "ElasticPlastic",
    "Equation",
    "FrictionLaw",
    "IntegralLog",
    "MeasuredTable",
    "Piece",
    "PressureKnots",
    "PressurePower",
    "TestedRange",
    "Trend",
    "ab_from_peak",
    "convert_ab",
    "peak_from_ab",
]
