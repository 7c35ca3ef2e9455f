"""SI values to text for people, in metric or US units."""

import math
from functools import cache
from typing import Literal, NamedTuple

from wraparc.units.digits import GIVEN_DIGITS, NOTHING, read, rounded, safe
from wraparc.units.parse import parse_quantity, unit_factor
from wraparc.units.table import Dimension

System = Literal["si", "us"]

#: What people measure in numbers as small as that.
SMALL: Dimension = "wear_coefficient"

# Unit by the size from which it is used, in the first unit of the row: a value is shown
# in the last unit whose bound it reaches. The first unit is the one for tables.
_Row = tuple[str, tuple[tuple[float, str], ...]]

_SI: dict[Dimension, _Row] = {
    "length": ("mm", ((10_000, "m"),)),
    "force": ("kN", ()),
    "force_per_width": ("kN/m", ()),
    "spring_rate": ("kN/m", ()),
    "pressure": ("kPa", ((10_000, "MPa"),)),
    "pressure_per_length": ("kPa/mm", ()),
    "speed": ("m/s", ()),
    "angle": ("deg", ()),
    "power": ("kW", ()),
    "torque": ("kN m", ()),
    "area": ("m2", ()),
    "time": ("s", ()),
    "temperature": ("degC", ()),
    "per_length": ("1/mm", ()),
    "wear_coefficient": ("mm3/J", ()),
    "energy_per_area": ("J/m2", ((1_000_000, "MJ/m2"),)),
    "power_per_area": ("W/m2", ((10_000, "kW/m2"),)),
    "rotation_speed": ("rpm", ()),
    "frequency": ("Hz", ()),
    "mass": ("kg", ()),
    "mass_per_length": ("kg/m", ()),
    "mass_flow": ("t/h", ()),
    "density": ("kg/m3", ()),
    "moment_of_inertia": ("kg m2", ()),
    "number": ("", ()),
}

_US: dict[Dimension, _Row] = _SI | {
    "length": ("in", ((400, "ft"),)),
    "force": ("lbf", ()),
    "force_per_width": ("PIW", ()),
    "spring_rate": ("lbf/in", ()),
    "pressure": ("psi", ((10_000, "ksi"),)),
    "pressure_per_length": ("psi/in", ()),
    "speed": ("fpm", ()),
    "power": ("hp", ()),
    "torque": ("lbf ft", ()),
    "area": ("in2", ()),
    "temperature": ("degF", ()),
    "per_length": ("1/in", ()),
    "wear_coefficient": ("in3/(ft lbf)", ()),
    "energy_per_area": ("ft lbf/ft2", ()),
    "power_per_area": ("hp/ft2", ()),
    "mass": ("lbm", ()),
    "mass_per_length": ("lbm/ft", ()),
    "mass_flow": ("lbm/h", ()),
    "density": ("lbm/ft3", ()),
    "moment_of_inertia": ("lbm ft2", ()),
}

_ROWS: dict[System, dict[Dimension, _Row]] = {"si": _SI, "us": _US}


class UnitRow(NamedTuple):
    """What values of a dimension are shown in.

    Attributes
    ----------
    unit
        That of a table column.
    factor
        SI value of one of it.
    larger
        From how many of it on another unit reads better; that unit, its SI value, its zero [SI].
    """

    unit: str
    factor: float
    larger: tuple[tuple[float, str, float, float], ...]


@cache
def unit_row(dimension: Dimension, system: System) -> UnitRow:
    """Return what values of a dimension are shown in."""
    unit, more = _ROWS[system][dimension]
    if dimension == "temperature":  # in K in tables: degC and degF have no mere factor
        zero = parse_quantity(f"0 {unit}", dimension)
        one = parse_quantity(f"1 {unit}", dimension)
        return UnitRow("K", 1.0, ((0.0, unit, one - zero, zero),))
    larger = tuple((bound, name, unit_factor(name, dimension), 0.0) for bound, name in more)
    return UnitRow(unit, unit_factor(unit, dimension), larger)


def display_unit(dimension: Dimension, system: System = "si") -> tuple[str, float]:
    """Return the unit of a table column and the SI value of one such unit.

    Temperatures come in K in both systems: degC and degF have no mere factor.
    """
    row = unit_row(dimension, system)
    return row.unit, row.factor


def display(
    value: float, dimension: Dimension, system: System = "si", digits: int = GIVEN_DIGITS
) -> str:
    """Return an SI value as text with a unit of fitting size, ``"126 kN"``.

    Parameters
    ----------
    value
        In the SI unit of the dimension.
    dimension
        What it measures.
    system
        ``"si"`` (mm, kN, kPa, deg ...) or ``"us"`` (in, lbf, psi, deg ...).
    digits
        Significant digits, `RESULT_DIGITS` for results. What was given, which `GIVEN_DIGITS` hold
        entirely in the unit shown, is not rounded: ``"6.35 mm"``, ``"417.5 kN"``, ``"1250 mm"``.
        Less than 1e-9 of the unit is 0, but for wear coefficients.

    Notes
    -----
    What is shown can be read back: whole digits are not grouped, as a comma may be a decimal sign.
    Counts and money, which have no unit of measure, are grouped by thousands where they are shown.
    """
    return joined(parts(value, dimension, system, digits))


def joined(of: tuple[str, str]) -> str:
    """Return a number with its unit; of a plain number alone."""
    number, unit = of
    return number + (" " + unit if unit != "" else "")


def parts(value: float, dimension: Dimension, system: System, digits: int) -> tuple[str, str]:
    """Return the number and the unit that `display` shows."""
    row = unit_row(dimension, system)
    unit, number = row.unit, value / row.factor
    if abs(number) < NOTHING and dimension != SMALL:
        number = 0.0
    size = abs(read(rounded(number, digits)))
    for bound, other, factor, zero in row.larger:
        if bound <= size < math.inf:
            unit, number = other, (value - zero) / factor
    return rounded(number, digits), unit


def on_safe_side(
    value: float, dimension: Dimension, system: System = "si", *, up: bool = True
) -> float:
    """Return the value that shows as a result does, rounded to the safe side: upwards, or down.

    What is recommended holds as it is shown: a least tension of 118.6 kN is 119 kN, a largest one
    118 kN.
    """
    return safe(value, unit_row(dimension, system).factor, up)
