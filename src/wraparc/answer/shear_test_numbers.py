"""Numbers of a test report: three digits, and no more of an interval than fits the value."""

import math

from wraparc.answer.sheet import NONE

_DIGITS, _MOST_DIGITS = 3, 4
# A number this much smaller than what it is set against is rounding of the fit.
_NOTHING = 1e-6


def number(value: float, digits: int = 4) -> str:
    """Return a number with so many significant digits."""
    return f"{value:.{digits}g}"


def with_error(value: float, error: float) -> str:
    """Return ``value ± error``: the value to three digits, the error to the same place.

    Where the error is less than one of that place, both get a fourth digit; an error below
    even that is said to be below it. No error is shown that is none (0, or not finite).

    Parameters
    ----------
    value
        The value.
    error
        Half its 95 % interval.
    """
    if not math.isfinite(error) or error <= 0.0:
        return number(value, _DIGITS)
    if error >= abs(value):  # not known, not even its sign
        return f"{value:.2g} \u00b1 {error:.2g}"
    first = math.floor(math.log10(abs(value)))
    own = 1 - math.floor(math.log10(error))
    places = max(0, min(own, _DIGITS - 1 - first))
    if error < 0.5 * 10.0**-places:
        places = max(0, _MOST_DIGITS - 1 - first)
    least = 10.0**-places
    shown = f"{error:.{places}f}" if error >= 0.5 * least else f"< {least:.{places}f}"
    return f"{value:.{places}f} \u00b1 {shown}"


def slope(value: float, error: float, scale: float) -> str:
    """Return a slope with its error; 0 where it is nothing beside `scale`, a dash without one.

    Parameters
    ----------
    value, error
        Of the slope.
    scale
        A slope that would be noticed, in the same unit.
    """
    if not math.isfinite(value):
        return NONE
    return "0" if abs(value) < _NOTHING * scale else with_error(value, error)
