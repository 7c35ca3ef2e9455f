"""What the kernel passes around: named tuples of plain numbers, flat buffers, outcomes.

One source runs in the interpreter and compiled: nothing here is more than a tuple or a list.
"""

from __future__ import annotations

from collections.abc import MutableSequence
from math import nan, sqrt
from typing import NamedTuple

Buffer = MutableSequence[float]

#: Outcomes. The first four are answers. STUCK: solved, the belt sticks over the whole wrap. LOST:
#: the march in tension does not apply, another must be tried.
SOLVED, BREAKAWAY, UNSOLVED, REFUSED, STUCK, LOST = range(6)

#: numbers recorded for each point of a profile: s, q, slip, creep, shear stress, friction work
RECORD = 6

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
    kick, kick_coefficient
        The overrun is kick + kick_coefficient p1^1.5, negative towards travel [m, m/Pa^1.5].
    onset
        Slip per shear stress before the limit of an elastic-plastic law [m/Pa].
    """

    side: float
    radius: float
    wrap_angle: float
    width: float
    compliance: float
    shear: float
    kick: float
    kick_coefficient: float
    onset: float


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


class Parameters(NamedTuple):
    """Numbers of one arc at an entry tension, as a march reads them; see `Geometry`."""

    entry_tension: float
    entry_pressure: float  # p1 [Pa]
    radius: float
    length: float  # L = R phi [m]
    compliance: float
    shear: float
    kick: float  # creep at the entry nip, negative towards travel [m]
    width: float
    side: float
    onset: float


class State(NamedTuple):
    """A sliding belt somewhere on the arc, and the piece of the law that holds there."""

    log_tension: float  # q = ln(T/T1)
    slip: float  # x [m]
    work: float  # of friction since the entry [J/m2]
    segment: int
    branch: int
    sign: float  # of the slip


class Shot(NamedTuple):
    """An arc marched to its exit."""

    log_tension: float  # ln(T2/T1)
    slip: float  # [m]
    creep: float  # [m]
    stress: float  # shear stress [Pa]
    work: float  # of friction [J/m2]
    creep_ratio: float  # g at the entry [-]
    stuck_length: float  # of the arc [m]


NO_SHOT = Shot(nan, nan, nan, nan, nan, nan, nan)


def zeros(size: int) -> Buffer:
    """A buffer of zeros. Compiled code replaces it by an array."""
    return [0.0] * size


def parameters_at(entry_tension: float, geometry: Geometry) -> Parameters:
    """Numbers of one arc at an entry tension [N]."""
    pressure = entry_tension / (geometry.width * geometry.radius)
    return Parameters(
        entry_tension,
        pressure,
        geometry.radius,
        geometry.radius * geometry.wrap_angle,
        max(geometry.compliance, LEAST_COMPLIANCE),
        geometry.shear,
        geometry.kick + geometry.kick_coefficient * pressure * sqrt(pressure),
        geometry.width,
        geometry.side,
        geometry.onset,
    )
