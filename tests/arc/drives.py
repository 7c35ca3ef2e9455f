"""Laws and random drives for the tests of the arc."""

from __future__ import annotations

import math

import numpy as np

from wraparc.arc import WrapArc
from wraparc.friction import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    Piece,
    PressureKnots,
    PressurePower,
    TestedRange,
    Trend,
)

RANGE = TestedRange(pressure_min=40e3, pressure_max=600e3, slip_max=12e-3)

RUBBER = IntegralLog(
    coefficients=PressureKnots(
        pressure=(40e3, 90e3, 170e3, 260e3, 400e3, 600e3),
        peak_friction=(1.25, 1.0, 0.85, 0.75, 0.6, 0.45),
        peak_slip=(15e-3, 17e-3, 19.5e-3, 22e-3, 24e-3, 25e-3),
    ),
    tested=RANGE,
)
SOFTENING = IntegralLog(
    coefficients=PressureKnots(
        pressure=(40e3, 90e3, 170e3, 260e3, 400e3, 600e3),
        peak_friction=(1.5, 1.45, 1.3, 1.1, 0.85, 0.6),
        peak_slip=(4e-3, 7e-3, 14e-3, 18e-3, 20e-3, 21e-3),
        post_peak_slope=(-13.0, -14.0, -4.0, 0.0, 0.0, 0.0),
        residual_friction=(1.42, 1.4, 1.28, 1.1, 0.85, 0.6),
    ),
    tested=RANGE,
)
#: A and b in two pieces that meet exactly at 170 kPa: peak slip 20 mm there from both sides
PIECEWISE = IntegralLog(
    coefficients=CoefficientPieces(
        pressure=(40e3, 170e3, 600e3),
        pieces=(
            Piece(
                a=Trend(coefficients=(-60.0, 1e-4)),
                b=Trend(coefficients=(175.0, -2.9e-4)),
            ),
            Piece(a=Trend(coefficients=(-47.25, 2.5e-5)), b=Trend(coefficients=(135.9, -6e-5))),
        ),
        continuity=0.01,
    ),
    tested=RANGE,
)
TABLE = MeasuredTable(
    slip=(0.0, 0.5e-3, 1.5e-3, 4e-3, 8e-3, 12e-3),
    pressure=(40e3, 150e3, 350e3, 600e3),
    values=(
        (0.0, 0.25, 0.5, 0.8, 0.95, 0.9),
        (0.0, 0.2, 0.42, 0.68, 0.8, 0.8),
        (0.0, 0.15, 0.33, 0.55, 0.66, 0.7),
        (0.0, 0.1, 0.22, 0.38, 0.46, 0.5),
    ),
)
JUMP_TABLE = MeasuredTable(
    slip=(0.0, 1e-3, 4e-3, 10e-3),
    pressure=(40e3, 200e3, 600e3),
    values=((0.3, 0.5, 0.7, 0.75), (0.25, 0.4, 0.55, 0.6), (0.15, 0.25, 0.35, 0.4)),
)
LAWS: dict[str, FrictionLaw] = {
    "rubber": RUBBER,
    "softening": SOFTENING,
    "pieces": PIECEWISE,
    "table": TABLE,
    "jump table": JUMP_TABLE,
    "constant": Constant(friction_coefficient=0.4),
    "power": PressurePower(
        friction_coefficient=0.55, reference_pressure=200e3, exponent=0.3, tested=RANGE
    ),
    "elastic-plastic": ElasticPlastic(stiffness=4e7, friction_coefficient=0.55),
}


def integral_log(
    peak: float = 0.8, slip: float = 9e-3, slope: float = 0.0, residual: float = 9.0
) -> IntegralLog:
    """A law free of pressure."""
    return IntegralLog(
        coefficients=PressureKnots(
            pressure=(2e5,),
            peak_friction=(peak,),
            peak_slip=(slip,),
            post_peak_slope=(slope,),
            residual_friction=(residual,),
        )
    )


#: a fabric belt on a driving pulley, without an overrun
ARC = WrapArc(
    law=Constant(friction_coefficient=0.4),
    entry_tension=150e3,
    exit_tension=60e3,
    diameter=0.8,
    wrap_angle=math.pi,
    width=1.2,
    axial_stiffness=12.96e6 * 1.2,
    thickness=12e-3,
    shear_modulus=2.3e6,
    compression_modulus=10e6,
    overrun=0.0,
)


def random_arc(law: FrictionLaw, rng: np.random.Generator) -> WrapArc:
    """A plausible drive: fabric or steel cord, driving, idling or braking, also without overrun.

    Of 100 drives about 55 drive, 30 brake, and 15 idle: their tensions differ by bearing friction.
    """
    diameter = float(rng.uniform(0.5, 1.6))
    width = float(rng.uniform(0.6, 2.0))
    modulus = float(np.exp(rng.uniform(math.log(4e6), math.log(3e8))))
    tight = float(rng.uniform(100e3, 500e3)) * width * diameter / 2
    idling = rng.random() < 0.15
    ratio = float(np.exp(rng.uniform(-9.0, -4.0)) + 1.0 if idling else rng.uniform(1.02, 3.0))
    entry, exit_ = (tight, tight / ratio) if rng.random() < 0.65 else (tight / ratio, tight)
    return WrapArc(
        law=law,
        entry_tension=entry,
        exit_tension=exit_,
        diameter=diameter,
        wrap_angle=float(rng.uniform(2.6, 3.9)),
        width=width,
        axial_stiffness=modulus * width,
        thickness=float(rng.uniform(8e-3, 20e-3)),
        shear_modulus=float(rng.uniform(1.5e6, 6e6)),
        compression_modulus=float(rng.uniform(5e6, 30e6)),
        overrun=[None, 0.0, 2e-5][int(rng.integers(3))],
        recovery=bool(rng.random() < 0.7),
        belt_speed=3.0,
    )
