"""A travel that is a unit's factor off: of its fellows, or of what a shear test can have."""

import math
from collections.abc import Sequence

import numpy as np

from wraparc.machine_tables import read_unit

_UNITS = ("mm", "in", "um", "thou", "cm", "m")
# Travel of a test over that of its fellows by which it is another unit's: where it is near the
# factor of two units, and whatever it is; how near. Ours.
_LEAST, _FAR, _NEAR = 8.0, 50.0, 0.25
# Travels that shear tests of laggings have [m]. Ours.
_USUAL = (1e-3, 0.1)


def odd_travel(travel: float, others: Sequence[float], unit: str) -> tuple[str, str] | None:
    """Return what is wrong with a travel beside those of the other tests, and what to do.

    Parameters
    ----------
    travel, others
        Of the test, and of all others [m].
    unit
        Of the column as the file has it; empty where it is not known.

    Returns
    -------
    None where it is of their size, or they are too few to say.
    """
    if travel <= 0.0 or not others:
        return None
    if len(others) < 2 and _USUAL[0] < travel < _USUAL[1]:
        return None  # of two, the one that no test has
    usual = float(np.median(others))
    ratio = usual / travel
    if 1.0 / _LEAST < ratio < _LEAST:
        return None
    meant = _meant(ratio, unit)
    if unit and not meant and 1.0 / _FAR < ratio < _FAR:
        return None
    size = ratio if ratio > 1.0 else 1.0 / ratio
    which = "shorter" if ratio > 1.0 else "longer"
    fault = f"its travel is {size:,.0f} times {which} than that of the others{meant}"
    return fault, "Correct the unit of its travel: wraparc read FILE."


def meant_travel(travel: float, unit: str) -> str:
    """Return which unit would make a travel that a test can have, in brackets; empty for none."""
    return _meant(math.sqrt(_USUAL[0] * _USUAL[1]) / travel, unit, near=math.log(10.0))


def _meant(ratio: float, unit: str, near: float = _NEAR) -> str:
    """Name the unit by which a travel would be `ratio` times as long, if there is one."""
    own = read_unit(unit, "length")
    if own is None or own.dimension != "length":
        return ""
    off = {
        name: abs(math.log(ratio * own.factor / other.factor))
        for name in _UNITS
        if (other := read_unit(name, "length")) is not None and other.factor != own.factor
    }
    best = min(off, key=lambda name: off[name])
    return f" ({best} instead of {unit} would fit)" if off[best] < near else ""
