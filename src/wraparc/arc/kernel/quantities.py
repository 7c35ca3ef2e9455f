"""What the march of trains passes around: named tuples of plain numbers."""

from __future__ import annotations

from math import nan, sqrt
from typing import NamedTuple

from wraparc.arc.quantities import (
    LEAST_COMPLIANCE,
    Geometry,
)


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


class Sliding(NamedTuple):
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
