"""Numbers of a test report."""

import math

from wraparc.answer.sheet import NONE
from wraparc.units import bare, either, plus_minus, unit_factor

# A number this much smaller than what it is set against is rounding of the fit.
_NOTHING = 1e-6


def slope(value: float, error: float, scale: float) -> str:
    """Return a slope with its error; 0 where it is nothing beside `scale`, a dash without one.

    Parameters
    ----------
    value, error
        Of the slope [1/m].
    scale
        A slope that would be noticed [1/m].
    """
    if not math.isfinite(value):
        return NONE
    if abs(value) < _NOTHING * scale:
        return bare(0.0, "per_length")
    return plus_minus(value, error, "per_length")


def rig_compliance(compliance: float) -> str:
    """Return a compliance of a rig [m/N] as it is read in each system of units."""
    us = compliance * 1e3 * unit_factor("lbf", "force") / unit_factor("in", "length")
    return either(f"{1e6 * compliance:.3g} mm/kN", f"{us:.3g} in/klbf")
