"""Text to SI values: the unit grammar and the dimension check.

A unit text is a product of units with small powers and at most one division, whose
divisor is one unit or a product in brackets: ``kN``, ``kN/m``, ``lbf*ft``, ``N·m``,
``ft-lb``, ``mm2``, ``mm^-1``, ``1/mm``, ``mm3/(N m)``.
"""

import re
from decimal import Decimal
from functools import cache, lru_cache
from typing import NamedTuple

from wraparc.errors import InputError, did_you_mean, input_error, near, placed, shown
from wraparc.units.numbers import finite, split_number
from wraparc.units.table import (
    BASE_UNITS,
    DEFINITIONS,
    DIMENSION_TEXT,
    DIMENSIONS,
    OF_MASS,
    TONS,
    Dimension,
)

_FACTOR = r'[A-Za-z°%"]+(?:\^?-?[1-9])?'
_PRODUCT = rf"{_FACTOR}(?:(?:\s*[*.]\s*|\s+|-(?=[A-Za-z])){_FACTOR})*"
_UNIT = re.compile(
    rf"(?P<over>1|{_PRODUCT})?\s*(?:/\s*(?:(?P<one>{_FACTOR})|\(\s*(?P<under>{_PRODUCT})\s*\)))?"
)
#: Names alike that are looked through for those of the dimension.
_MOST_NEAR = 8
_NAME_AND_POWER = re.compile(r'([A-Za-z°%"]+)(?:\^?(-?[1-9]))?')
_LOOKALIKES = str.maketrans(
    {
        "µ": "u",
        "μ": "u",
        "″": '"',
        "”": '"',
        "º": "°",
        "·": "*",
        "⋅": "*",
        "×": "*",
        "²": "2",
        "³": "3",
        "⁻": "-",
    }
    | {"¹": "1", "\N{NO-BREAK SPACE}": " ", "\N{NARROW NO-BREAK SPACE}": " "}
)


class Unit(NamedTuple):
    """A unit in SI: its size, its powers of `BASE_UNITS`, and where its zero lies."""

    factor: Decimal
    powers: tuple[int, ...]
    zero: Decimal = Decimal(0)


class _UnitTextError(Exception):
    def __init__(
        self, message: str, remedy: str = "", name: str = "", meant: tuple[str, ...] = ()
    ) -> None:
        super().__init__(message)
        self.remedy, self.name, self.meant = remedy, name, meant


def parse_quantity(value: object, dimension: Dimension, example: str = "") -> float:
    """Return the SI value of a quantity written with its unit.

    Parameters
    ----------
    value
        Text such as ``"150 kN"``; for the dimension ``"number"`` also an int or float.
    dimension
        What it must measure.
    example
        What a refusal shows as an example, that of the dimension if left out.

    Returns
    -------
    float
        Value in the SI unit of the dimension (rad for angles, K for temperatures), the
        float nearest to the number as written.

    Raises
    ------
    InputError
        With one problem that says what is wrong: no number, a number that can be read
        in two ways, not finite, no unit, an unknown unit (with the nearest ones), or a
        unit of another dimension. File and key are the caller's to add.
    """
    kind = DIMENSION_TEXT[dimension]
    if isinstance(value, int | float) and not isinstance(value, bool):
        if dimension == "number":
            return finite(value, value)
        raise _no_unit(value, dimension, example)
    if not isinstance(value, str):
        problem = f"neither text nor a number, where {kind.name} is needed"
        raise _refused(value, problem, _for_example(dimension, example))
    return _read(value, dimension, example)


def positive_quantity(text: str, dimension: Dimension, key: str) -> float:
    """Return what `parse_quantity` does, of more than 0.

    Raises
    ------
    InputError
        With the problem, of a key.
    """
    with placed(key):
        value = parse_quantity(text, dimension)
    if not value > 0.0:
        raise input_error(key=key, value=shown(text), message="must be more than 0")
    return value


@lru_cache(maxsize=2048)  # of a drive that is changed step by step most stays as it was
def _read(text: str, dimension: Dimension, example: str) -> float:
    number, unit_text = split_number(text)
    if not unit_text and dimension != "number":
        raise _no_unit(text, dimension, example)
    unit = _checked_unit(unit_text, dimension, text, example)
    return finite((number - unit.zero) * unit.factor, text)


def unit_factor(unit: str, dimension: Dimension) -> float:
    """Return the SI value of one unit, for whole columns of data.

    Raises
    ------
    InputError
        If the unit is unknown, of another dimension, or has its zero elsewhere than SI
        (degC, degF), so that a factor alone would be wrong.
    """
    resolved = _checked_unit(unit, dimension, unit)
    if resolved.zero:
        raise _refused(unit, "has its zero elsewhere than 0 K", "Convert the column to K.")
    return float(resolved.factor)


def dimension_of(unit: str) -> Dimension | None:
    """Return what a unit text measures, or None if it is unknown or of no use here.

    N/m and J/m2 are the same in SI: with joules it is an energy per area, else a force
    per width.
    """
    try:
        powers = _resolve(unit).powers
    except _UnitTextError:
        return None
    if "J" in unit and powers == _powers("energy_per_area"):
        return "energy_per_area"
    return next((name for name in DIMENSIONS if _powers(name) == powers), None)


#: Units that are taken for each other, the likeliest first.
_CONFUSED: dict[Dimension, tuple[str, ...]] = {
    "length": ("mm", "m", "cm", "in", "ft"),
    "force": ("kN", "N", "lbf", "kgf", "tf", "MN"),
    "force_per_width": ("kN/m", "N/m", "PIW", "N/mm", "MN/m"),
    "pressure": ("kPa", "MPa", "Pa", "psi", "bar", "GPa"),
    "speed": ("m/s", "m/min", "ft/min", "km/h"),
    "angle": ("deg", "rad"),
    "power": ("kW", "W", "hp", "MW"),
    "mass": ("t", "kg", "g"),
    "mass_per_length": ("kg/m", "g/m", "t/m"),
    "mass_flow": ("t/h", "kg/s", "kg/h"),
    "density": ("kg/m3", "t/m3", "g/cm3"),
    "moment_of_inertia": ("kg m2", "t m2", "kg cm2"),
    "torque": ("kN m", "N m", "MN m"),
    "time": ("s", "min", "ms", "h"),
}


def meant_by(value: float, dimension: Dimension, least: float, most: float) -> list[str]:
    """Return what may have been meant by a value that is outside its usual range, at most two.

    The number as it was probably written, three digits at most, with another unit; of those that
    mean one value the first, numbers below 1 or of four digits, centimetres and feet last,
    and what is both only where nothing else is.

    Parameters
    ----------
    value, least, most
        The value and its usual range [SI].
    dimension
        What it measures.
    """
    found: list[tuple[int, float, str]] = []
    units = _CONFUSED.get(dimension, ())
    for written in units:
        number = value / unit_factor(written, dimension)
        short = float(f"{number:.3g}")
        if abs(number - short) > 1e-9 * abs(short):
            continue
        for unit in units:
            means = short * unit_factor(unit, dimension)
            if least <= means <= most and unit != written:
                seldom = 2 * (unit in ("cm", "ft")) + (not 1.0 <= short < 1e3)
                found.append((seldom, means, f"{short:g} {unit}"))
    texts = dict[str, str]()  # by the value that is meant
    found.sort(key=lambda one: one[0])
    for seldom, means, text in found:
        if seldom < 3 or not texts:
            texts.setdefault(f"{means:.9g}", text)
    return list(texts.values())[:2]


def unit_names() -> tuple[str, ...]:
    """Return every unit name that is read, base units first."""
    return tuple(_units())


def _checked_unit(text: str, dimension: Dimension, given: object, example: str = "") -> Unit:
    kind = DIMENSION_TEXT[dimension]
    try:
        unit = _resolve(text, dimension in OF_MASS)
    except _UnitTextError as error:
        remedy = error.remedy or _meant(text, error, dimension, example)
        raise _refused(given, str(error), remedy) from None
    if unit.powers != _powers(dimension):
        measured = dimension_of(text)
        found = DIMENSION_TEXT[measured].name if measured else "of no dimension used here"
        message = f"{found}, where {kind.name} is needed"
        remedy = _by_gravity(text, dimension) or _for_example(dimension, example)
        raise _refused(given, message, remedy)
    return unit


#: Units of mass and of force that are taken for each other, one by standard gravity.
_BY_GRAVITY = tuple(
    (re.compile(rf"\b{one}(?![A-Za-z])"), other, meant)
    for mass, force in (("kg", "kgf"), ("t", "tf"), ("g", "gf"), ("lbm", "lbf"))
    for one, other, meant in ((mass, force, "a force"), (force, mass, "a mass"))
)


def _by_gravity(text: str, dimension: Dimension) -> str:
    """Return which unit to write where one of mass is given for one of force, or the reverse."""
    for pattern, other, meant in _BY_GRAVITY:
        replaced = pattern.sub(other, text)
        if replaced != text and _fits(replaced, dimension):
            return f"Write {replaced.strip()} if it is {meant}."
    return ""


def _fits(text: str, dimension: Dimension) -> bool:
    """Return whether a unit text can be read and measures a dimension."""
    try:
        return _resolve(text, dimension in OF_MASS).powers == _powers(dimension)
    except _UnitTextError:
        return False


@cache
def _powers(dimension: Dimension) -> tuple[int, ...]:
    return _resolve(DIMENSION_TEXT[dimension].si_unit).powers


@cache
def _units() -> dict[str, Unit]:
    """Return every known unit by name, the definitions resolved in order."""
    size = len(BASE_UNITS)
    known = {
        name: Unit(Decimal(1), tuple(int(i == j) for j in range(size)))
        for i, name in enumerate(BASE_UNITS)
    }
    for definition in DEFINITIONS:
        of = _evaluate(definition.unit, known)
        unit = Unit(definition.factor * of.factor, of.powers, definition.zero)
        known.update(dict.fromkeys(definition.names, unit))
    return known


@cache
def _units_of_mass() -> dict[str, Unit]:
    """Return the units where a mass is measured: pounds are of mass there."""
    known = _units()
    return known | dict.fromkeys(("lb", "lbs"), known["lbm"])


@lru_cache(maxsize=512)
def _resolve(text: str, of_mass: bool = False) -> Unit:
    return _evaluate(text, _units_of_mass() if of_mass else _units())


def _evaluate(text: str, known: dict[str, Unit]) -> Unit:
    plain = text.translate(_LOOKALIKES).strip().replace("**", "^")
    if plain in known:
        return known[plain]
    match = _UNIT.fullmatch(plain) if len(plain) <= 40 else None
    if match is None:
        raise _UnitTextError(f"the unit {shown(text)} cannot be read")
    over, under = match["over"] or "", match["one"] or match["under"] or ""
    factors = [(name, int(power or 1)) for name, power in _NAME_AND_POWER.findall(over)]
    factors += [(name, -int(power or 1)) for name, power in _NAME_AND_POWER.findall(under)]
    if len(factors) == 1 and factors[0][1] == 1:
        return _named(factors[0][0], known)
    product = Unit(Decimal(1), (0,) * len(BASE_UNITS))
    for name, power in factors:
        unit = _named(name, known)
        if unit.zero:
            message = f"{name} cannot be part of a compound unit: its zero is not 0 K"
            raise _UnitTextError(message, "Use K.")
        powers = tuple(a + power * b for a, b in zip(product.powers, unit.powers, strict=True))
        product = Unit(product.factor * unit.factor**power, powers)
    return product


def _named(name: str, known: dict[str, Unit]) -> Unit:
    unit = known.get(name)
    if unit is not None:
        return unit
    if name in TONS:
        raise _UnitTextError(f"{name} may be metric, short or long", "", name)
    same_but_case = [other for other in known if other.casefold() == name.casefold()]
    meant = tuple(same_but_case or near(name, known, _MOST_NEAR))
    raise _UnitTextError(f"unknown unit {shown(name)}", "", name, meant)


def _meant(text: str, error: _UnitTextError, dimension: Dimension, example: str) -> str:
    """Return the units that may be meant, else an example; neither of another dimension."""
    if error.name in TONS:
        tons = (("t", "1000 kg"), ("ston", "2000 lb"), ("lton", "2240 lb"))
        forces = (("tf", "1000 kgf"), ("kip", "1000 lbf"))
        for units in (tons, forces):
            if _fits(text.replace(error.name, units[0][0]), dimension):
                texts = [f"{text.replace(error.name, unit)} ({size})" for unit, size in units]
                return f"Write {', '.join(texts[:-1])} or {texts[-1]}."
    fits = [name for name in error.meant if _fits(text.replace(error.name, name), dimension)]
    fits = fits or _corrected(text, dimension, _MOST_SLIPS)
    if fits:
        return did_you_mean(fits[:2])
    return _for_example(dimension, example)


#: Names of one unit text that are corrected.
_MOST_SLIPS = 3


def _corrected(text: str, dimension: Dimension, most: int) -> list[str]:
    """Return a unit text of a dimension with the nearest name for each that is unknown."""
    try:
        _resolve(text, dimension in OF_MASS)
    except _UnitTextError as error:
        for name in error.meant if most else ():
            found = _corrected(text.replace(error.name, name), dimension, most - 1)
            if found:
                return found
        return []
    return [text.strip()] if _fits(text, dimension) else []


def _for_example(dimension: Dimension, example: str) -> str:
    return f"Write for example {shown(example or DIMENSION_TEXT[dimension].example)}."


def _no_unit(value: object, dimension: Dimension, example: str) -> InputError:
    kind = DIMENSION_TEXT[dimension]
    message = f"no unit, where {kind.name} is needed"
    return _refused(
        value, message, f"Write the unit too, for example {shown(example or kind.example)}."
    )


def _refused(given: object, message: str, remedy: str) -> InputError:
    return input_error(message=message, remedy=remedy, value=shown(given))
