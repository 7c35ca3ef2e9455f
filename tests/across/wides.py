"""Uneven arcs for the tests of the belt across its width: two illustrative drives."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from wraparc.across.spans import shear_lengths
from wraparc.across.wide_arc import WideArc, centres, wave_numbers
from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.friction import Constant, IntegralLog, PressureKnots, TestedRange

RANGE = TestedRange(pressure_min=34e3, pressure_max=690e3, slip_max=15e-3)
RUBBER = IntegralLog(
    coefficients=PressureKnots(
        pressure=(34e3, 103e3, 172e3, 276e3, 483e3, 690e3),
        peak_friction=(1.3, 1.0, 0.86, 0.745, 0.54, 0.385),
        peak_slip=(16e-3, 18e-3, 20e-3, 22.5e-3, 25e-3, 26e-3),
    ),
    tested=RANGE,
)
SOFTENING = IntegralLog(
    coefficients=PressureKnots(
        pressure=(34e3, 103e3, 172e3, 690e3),
        peak_friction=(1.55, 1.45, 1.31, 0.6),
        peak_slip=(2e-3, 3e-3, 4e-3, 6e-3),
        post_peak_slope=(-13.0, -13.0, -4.0, -4.0),
        residual_friction=(1.5, 1.4, 1.28, 0.55),
    ),
    tested=RANGE,
)
#: friction that no belt exhausts: the shear of the lagging alone decides
UNLIMITED = Constant(friction_coefficient=1e6)

#: fabric belt 1000/4 on diamond rubber, and a steel cord ST2000 on ceramic
FABRIC = WrapArc(
    law=RUBBER,
    entry_tension=150e3,
    exit_tension=60e3,
    diameter=0.8,
    wrap_angle=math.pi,
    width=1.2,
    axial_stiffness=12.75e6 * 1.2,
    thickness=12e-3,
    shear_modulus=2.3e6,
    compression_modulus=10e6,
    overrun=0.0,
)
CORD = replace(
    FABRIC,
    entry_tension=351e3,
    exit_tension=130e3,
    diameter=1.0,
    wrap_angle=math.radians(200.0),
    axial_stiffness=144e6 * 1.2,
    compression_modulus=18e6,
)


def wide(arc: WrapArc = FABRIC, strips: int = 8, stiffness: float = 1e5, **more: Any) -> WideArc:
    """An arc cut into strips, even but for what is given, its spans far."""
    none = np.zeros(strips)
    decay = shear_lengths(
        wave_numbers(arc.width, strips), arc.axial_stiffness / arc.width, max(stiffness, 1.0)
    )
    return WideArc(
        **{
            "arc": arc,
            "shear_stiffness": stiffness,
            "radius_deviation": none,
            "thickness": np.full(strips, arc.thickness),
            "compression_modulus": np.full(strips, arc.compression_modulus),
            "entry_profile": none,
            "entry_misfit": none,
            "exit_misfit": none,
            "length_before": decay,
            "length_after": decay,
            **more,
        }
    )


def braking(arc: WrapArc) -> WrapArc:
    """The same arc, holding back as much as it drove."""
    return replace(arc, entry_tension=arc.exit_tension, exit_tension=arc.entry_tension)


def mode(number: int, strips: int) -> Array:
    """Mode of a number at the strips, amplitude 1."""
    shape: Array = np.cos(number * math.pi * (np.arange(strips) + 0.5) / strips)
    return shape


def crown(height: float, strips: int) -> Array:
    """A parabola of a height [m]."""
    y = centres(1.0, strips)
    shape: Array = height * (1.0 - 4.0 * y**2)
    return shape
