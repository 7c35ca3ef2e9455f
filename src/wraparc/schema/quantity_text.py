"""SI values to text with a unit that reads back to the same number."""

from decimal import Decimal

from wraparc.units import DIMENSION_TEXT, Dimension, display_unit, parse_quantity


def quantity_text(value: float, dimension: Dimension) -> str:
    """Return a finite SI value as a short text with a usual unit; it reads back equal."""
    unit, factor = display_unit(dimension)
    number = value / factor
    exact = Decimal(repr(value)) / Decimal(repr(factor))
    for digits in (f"{number:.15g}", f"{number:.16g}", f"{number:.17g}", str(exact)):
        plain = f"{Decimal(digits):f}"
        text = f"{plain if len(plain) < 20 else digits} {unit}"
        if parse_quantity(text, dimension) == value:
            return text
    return f"{value!r} {DIMENSION_TEXT[dimension].si_unit}"
