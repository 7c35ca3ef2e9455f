"""Resistances to motion of a belt conveyor, each on the carrying and the return strand."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

from wraparc.errors import Problem
from wraparc.schema.limits import raise_all
from wraparc.units import display

#: Standard acceleration of gravity [m/s2].
GRAVITY = 9.80665

MAIN = "DIN 22101:2002-08, 6.2; ISO 5048:1989: f L g (m'R + (m'G + m'L) cos delta)"
SECONDARY = "DIN 22101:2002-08, 6.3.3: (C - 1) times the main resistance"
SLOPE = "DIN 22101:2002-08, 6.4: g H (m'G + m'L), up on one strand and down on the other"
INERTIA = (
    "force to accelerate belt, material and rotating idlers (DIN 22101:2002-08, 7.3), the idlers "
    "with their whole rotating mass"
)
GIVEN = "given"

#: Coefficient C [-] by conveying length [m], for conveyors of at least 80 m filled to 0.7-1.1:
#: the values in general use with DIN 22101 and ISO 5048, as one public implementation holds
#: them; a second was compared at 80, 100, 200, 500 and 1000 m, and agrees. A compendium on the
#: length coefficient gives its ends: 9 at a few metres, 1.03 at 5000 m.
LENGTH_COEFFICIENTS: Mapping[float, float] = MappingProxyType({
    80.0: 1.92, 90.0: 1.86, 100.0: 1.78, 120.0: 1.70, 140.0: 1.63, 160.0: 1.56, 180.0: 1.50,
    200.0: 1.45, 250.0: 1.38, 300.0: 1.31, 350.0: 1.27, 400.0: 1.25, 450.0: 1.22, 500.0: 1.20,
    550.0: 1.18, 600.0: 1.17, 700.0: 1.14, 800.0: 1.12, 900.0: 1.10, 1000.0: 1.09, 1500.0: 1.06,
    2000.0: 1.05,
})  # fmt: skip


_ROWS = tuple(LENGTH_COEFFICIENTS.items())


@dataclass(frozen=True)
class Resistance:
    """One resistance of a conveyor.

    Attributes
    ----------
    name
        What it is: main, secondary, slope, special, inertia.
    carrying, returning
        Its part on the carrying and on the return strand [N]; negative where it drives.
    source
        Formula and where it comes from.
    """

    name: str
    carrying: float
    returning: float
    source: str

    @property
    def total(self) -> float:
        """On both strands [N]."""
        return self.carrying + self.returning


def length_coefficient(length: float) -> float:
    """Return the coefficient C that stands for all secondary resistances [-].

    Linear between the values of `LENGTH_COEFFICIENTS`; 1.05 beyond 2000 m.

    Parameters
    ----------
    length
        Conveying length L, at least 80 m [m].

    Raises
    ------
    InputError
        Below 80 m, where single secondary resistances have to be known.
    """
    raise_all(no_coefficient(length))
    return coefficient_at(length)


def no_coefficient(length: float) -> list[Problem]:
    """Return why a conveying length has no coefficient; nothing where it has one."""
    if not math.isnan(coefficient_at(length)):
        return []
    least = _ROWS[0][0]
    return [
        Problem(
            key="length",
            value=display(length, "length"),
            message=f"below {least:g} m, where no coefficient C is tabulated",
            remedy="Give secondary_resistance or length_coefficient.",
        )
    ]


def coefficient_at(length: float) -> float:
    """Return the same [-], nan below the table."""
    found = math.nan if length < _ROWS[0][0] else _ROWS[-1][1]
    for (start, high), (end, low) in pairwise(_ROWS):
        if start <= length <= end:
            return high + (low - high) * (length - start) / (end - start)
    return found


def main_resistance(
    friction_factor: float, length: float, lift: float, rotating: float, carried: float
) -> float:
    """Return the main resistance of one strand, f L g (m'_R + m' cos delta) [N].

    Parameters
    ----------
    friction_factor
        Artificial (hypothetical) friction factor f [-].
    length, lift
        Conveying length L and lift H; sin delta = H/L [m].
    rotating
        Rotating mass of the idlers per length of strand [kg/m].
    carried
        Mass of belt and material per length [kg/m].

    References
    ----------
    DIN 22101:2002-08, 6.2; ISO 5048:1989.
    """
    cosine = math.sqrt(1.0 - (lift / length) ** 2)
    return friction_factor * length * GRAVITY * (rotating + carried * cosine)


def slope_resistance(lift: float, carried: float) -> float:
    """Return the gradient resistance of a strand that carries a mass per length up by H [N].

    g H m', DIN 22101:2002-08, 6.4; `lift` [m], `carried` [kg/m].
    """
    return GRAVITY * lift * carried


def inertia(acceleration: float, length: float, moving: float) -> float:
    """Return the force that accelerates a strand, a L m' [N].

    `acceleration` [m/s2], `length` [m], `moving` mass of belt, material and idlers [kg/m].
    """
    return acceleration * length * moving
