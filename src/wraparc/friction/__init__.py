"""Friction laws of a lagging: mu as a function of slip and wrap pressure."""

from wraparc.friction.base import FrictionLaw, TestedRange
from wraparc.friction.compact import CompactLaw
from wraparc.friction.integral_log import (
    CoefficientPieces,
    IntegralLog,
    Piece,
    PressureKnots,
    Trend,
    ab_from_peak,
    convert_ab,
    peak_from_ab,
)
from wraparc.friction.simple import Constant, ElasticPlastic, PressurePower
from wraparc.friction.table import MeasuredTable

__all__ = [
    "CoefficientPieces",
    "CompactLaw",
    "Constant",
    "ElasticPlastic",
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
