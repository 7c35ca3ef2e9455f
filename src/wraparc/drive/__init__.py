"""Descriptions of a drive: frozen, checked, in SI. Nothing here solves anything."""

from wraparc.drive.belt import Belt
from wraparc.drive.compression import SHAPES, Block, compression_modulus
from wraparc.drive.drive import CREEP_LIMIT, MOST_PULLEYS, Drive, repeated
from wraparc.drive.lagging import SURFACES, Cost, Fit, Lagging
from wraparc.drive.load_case import DESIGN, LoadCase, Tensions
from wraparc.drive.pulley import Pulley
from wraparc.drive.remarks import design_remarks
from wraparc.schema.limits import Limit

__all__ = [
    "CREEP_LIMIT",
    "DESIGN",
    "MOST_PULLEYS",
    "SHAPES",
    "SURFACES",
    "Belt",
    "Block",
    "Cost",
    "Drive",
    "Fit",
    "Lagging",
    "Limit",
    "LoadCase",
    "Pulley",
    "Tensions",
    "compression_modulus",
    "design_remarks",
    "repeated",
]
