"""Quantities as people write them, and the SI values that everything else works with."""

from wraparc.units.cell import (
    NONE,
    Cell,
    bare,
    cell_of,
    cells_in,
    distinct,
    either,
    in_each,
    in_unit,
    in_units,
    per_stress,
    percent,
    placed,
    quantity,
    unit_of,
)
from wraparc.units.digits import GIVEN_DIGITS, NOTHING, RESULT_DIGITS
from wraparc.units.display import (
    SMALL,
    System,
    display,
    display_unit,
    on_safe_side,
)
from wraparc.units.numbers import parse_number
from wraparc.units.parse import (
    dimension_of,
    meant_by,
    parse_quantity,
    positive_quantity,
    unit_factor,
    unit_names,
)
from wraparc.units.table import DEFINITIONS, DIMENSION_TEXT, DIMENSIONS, Dimension

__all__ = [
    "DEFINITIONS",
    "DIMENSIONS",
    "DIMENSION_TEXT",
    "GIVEN_DIGITS",
    "NONE",
    "NOTHING",
    "RESULT_DIGITS",
    "SMALL",
    "Cell",
    "Dimension",
    "System",
    "bare",
    "cell_of",
    "cells_in",
    "dimension_of",
    "display",
    "display_unit",
    "distinct",
    "either",
    "in_each",
    "in_unit",
    "in_units",
    "meant_by",
    "on_safe_side",
    "parse_number",
    "parse_quantity",
    "per_stress",
    "percent",
    "placed",
    "positive_quantity",
    "quantity",
    "unit_factor",
    "unit_names",
    "unit_of",
]
