"""What the solver of an arc passes around: named tuples of plain numbers, outcomes."""

from __future__ import annotations

from collections.abc import MutableSequence
from typing import NamedTuple

from wraparc.friction.compact import LIMIT, TABLE, CompactLaw

Buffer = MutableSequence[float]

#: Steps over one element each, 20-50 us, for an operating point or a passage, and for capacities.
POINT_STEPS, CAPACITY_STEPS = 20_000.0, 25_000.0

#: Outcomes.
SOLVED, BREAKAWAY, UNSOLVED, REFUSED = range(4)

LEAST_COMPLIANCE = 1e-16  # of belt and lagging [1/N]: a rigid belt has a strain of 1e-10 at 1 MN


class Geometry(NamedTuple):
    """What of an arc does not depend on its tensions.

    Attributes
    ----------
    side
        +1 driving (T1 >= T2), -1 braking.
    radius, wrap_angle, width
        R [m], phi [rad], B [m].
    compliance
        1/EA' [1/N].
    shear
        h/G [m/Pa].
    overrun_constant, overrun_coefficient
        The overrun is overrun_constant + overrun_coefficient p1^1.5, negative towards travel
        [m, m/Pa^1.5].
    left
        Steps of Newton's method over one element each that may still be taken, counted down while
        a question is answered, else None. See `counted`.
    """

    side: float
    radius: float
    wrap_angle: float
    width: float
    compliance: float
    shear: float
    overrun_constant: float
    overrun_coefficient: float
    left: Buffer | None


class Load(NamedTuple):
    """What an arc is asked: tensions, and the limits that capacities are held against.

    Attributes
    ----------
    entry_tension, exit_tension
        T1 and T2 [N].
    creep_limit
        Creep that is accepted at the exit [m].
    pressure_min, pressure_max, slip_max
        Tested range of the law, nan without one [Pa, Pa, m].
    steepest_fall
        Steepest fall of friction with slip, <= 0 [1/m].
    """

    entry_tension: float
    exit_tension: float
    creep_limit: float
    pressure_min: float
    pressure_max: float
    slip_max: float
    steepest_fall: float


def counted(arc: Geometry, most: float) -> Geometry:
    """An arc whose solver ends after so many steps, unless they are counted already.

    What a question has not found by then is unsolved: no arc hangs, whatever is asked of it.
    """
    return arc._replace(left=[most]) if arc.left is None else arc


def zeros(size: int) -> Buffer:
    """A buffer of zeros."""
    return [0.0] * size


def jumps(law: CompactLaw) -> bool:
    """Whether a law holds the belt without slip: its friction begins above zero."""
    return (law.kind == LIMIT and law.coefficients[3] == 0.0) or (
        law.kind == TABLE and law.coefficients[0] > 0.0
    )
