"""SI values to text for people, in metric or US units."""

import math
from decimal import Decimal
from functools import lru_cache
from typing import Literal

from wraparc.units.parse import parse_quantity, unit_factor
from wraparc.units.table import Dimension

System = Literal["si", "us"]

#: Significant digits of what was computed: no friction is known to more. Files hold every digit.
RESULT_DIGITS = 3
#: A number that so many digits hold entirely is one that somebody gave, and is shown as it is.
GIVEN_DIGITS = 4
_EXACT = 1e-9
#: What is less, in the unit shown, is what rounding leaves of a difference of equal numbers.
NOTHING = 1e-9
#: What people measure in numbers as small as that.
SMALL: tuple[Dimension, ...] = ("wear_coefficient",)

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
    "energy_per_area": ("J/m2", ()),
    "power_per_area": ("W/m2", ((10_000, "kW/m2"),)),
    "rotation_speed": ("rpm", ()),
    "mass": ("kg", ()),
    "mass_per_length": ("kg/m", ()),
    "mass_flow": ("t/h", ()),
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
    "moment_of_inertia": ("lbm ft2", ()),
}

_ROWS: dict[System, dict[Dimension, _Row]] = {"si": _SI, "us": _US}


def display_unit(dimension: Dimension, system: System = "si") -> tuple[str, float]:
    """Return the unit of a table column and the SI value of one such unit.

    Temperatures come in K in both systems: degC and degF have no mere factor.
    """
    unit = "K" if dimension == "temperature" else _ROWS[system][dimension][0]
    return unit, unit_factor(unit, dimension)


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
    return _shown(value, dimension, system, digits)


def on_safe_side(
    value: float, dimension: Dimension, system: System = "si", *, up: bool = True
) -> float:
    """Return the value that shows as a result does, rounded to the safe side: upwards, or down.

    What is recommended holds as it is shown: a least tension of 118.6 kN is 119 kN, a largest one
    118 kN.
    """
    _, size = display_unit(dimension, system)
    number = value / size
    if not math.isfinite(number) or abs(number) < NOTHING:
        return value
    shown = float(_rounded(number, RESULT_DIGITS))
    if math.isclose(shown, number, rel_tol=_EXACT):
        return value
    if (shown < number) == up:
        step = 10.0 ** (_exponent(f"{shown:.3e}") - RESULT_DIGITS + 1)
        shown += step if up else -step
    return shown * size


@lru_cache(maxsize=1024)  # limits and what was given come again and again
def _shown(value: float, dimension: Dimension, system: System, digits: int) -> str:
    unit, larger = _ROWS[system][dimension]
    if dimension == "temperature":
        return f"{_rounded(_degrees(value, unit), digits)} {unit}"
    number = value / unit_factor(unit, dimension)
    if abs(number) < NOTHING and dimension not in SMALL:
        number = 0.0
    size = abs(float(_rounded(number, digits)))
    for bound, larger_unit in larger:
        if bound <= size < math.inf:
            unit, number = larger_unit, value / unit_factor(larger_unit, dimension)
    return f"{_rounded(number, digits)} {unit}".rstrip()


def _degrees(kelvin: float, unit: str) -> float:
    zero = parse_quantity(f"0 {unit}", "temperature")
    return (kelvin - zero) / (parse_quantity(f"1 {unit}", "temperature") - zero)


def _rounded(number: float, digits: int) -> str:
    """Return the number with so many significant digits, in plain notation where it fits."""
    if not math.isfinite(number):
        return str(number)
    if number == 0:
        return "0"
    given = f"{number:.{GIVEN_DIGITS - 1}e}"
    whole = digits <= GIVEN_DIGITS and math.isclose(float(given), number, rel_tol=_EXACT)
    if whole and -4 <= _exponent(given) < 12:
        return f"{Decimal(given).normalize():f}"
    rounded = f"{number:.{digits - 1}e}"
    exponent = _exponent(rounded)
    if not -4 <= exponent < 12:
        return rounded
    return f"{float(rounded):.{max(0, digits - 1 - exponent)}f}"


def _exponent(scientific: str) -> int:
    return int(scientific.rpartition("e")[2])
