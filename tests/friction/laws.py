"""One law of every kind and form, for the tests that all laws go through."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from arc.drives import LAWS as DRIVE_LAWS
from arc.drives import RANGE
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

#: every trend form, A and b in 1/mm, two pieces that meet at 172 kPa: ln x_pk = b/A - 1 = 2.9 there
TRENDS = IntegralLog(
    coefficients=CoefficientPieces(
        pressure=(34e3, 172e3, 690e3),
        pieces=(
            Piece(
                # -0.05 (172 kPa / p)^0.9, and a b that makes the peak slip fall below 172 kPa
                a=Trend(
                    form="power",
                    coefficients=(math.log(0.05) + 0.9 * math.log(172e3), -0.9),
                    sign=-1,
                ),
                b=Trend(form="logarithmic", coefficients=(-0.195 - 0.224 * math.log(172e3), 0.224)),
                post_peak_slope=Trend(coefficients=(-9.0, 9.0 / 172e3)),
                residual_friction=Trend(form="exponential", coefficients=(0.05, -1e-6)),
            ),
            Piece(
                a=Trend(form="exponential", coefficients=(math.log(0.05) + 0.172, -1e-6), sign=-1),
                b=Trend(coefficients=(-0.195 - 0.0172 * 1.5, 1.5e-7)),
            ),
        ),
        slip_unit=1e-3,
    ),
    tested=TestedRange(pressure_min=34e3, pressure_max=690e3, slip_max=15e-3),
)
#: friction levels that cross between two knots: the residual may not rise above the peak there
CROSSING = IntegralLog(
    coefficients=PressureKnots(
        pressure=(40e3, 90e3, 200e3, 600e3),
        peak_friction=(1.4, 1.35, 0.8, 0.5),
        peak_slip=(5e-3, 6e-3, 12e-3, 18e-3),
        post_peak_slope=(-10.0, -20.0, -6.0, -1.0),
        residual_friction=(1.2, 1.35, 0.9, 0.5),
    ),
    tested=RANGE,
)

LAWS: dict[str, FrictionLaw] = {
    **DRIVE_LAWS,
    "trends": TRENDS,
    "crossing": CROSSING,
    "one knot": IntegralLog(
        coefficients=PressureKnots(
            pressure=(200e3,),
            peak_friction=(0.8,),
            peak_slip=(9e-3,),
            post_peak_slope=(-12.0,),
            residual_friction=(0.6,),
        )
    ),
    "two knots": IntegralLog(
        coefficients=PressureKnots(
            pressure=(40e3, 600e3), peak_friction=(1.0, 0.5), peak_slip=(8e-3, 20e-3)
        ),
        tested=RANGE,
    ),
    "one-pressure table": MeasuredTable(
        slip=(0.0, 1e-3, 5e-3), pressure=(150e3,), values=((0.0, 0.4, 0.6),)
    ),
    "held constant": Constant(friction_coefficient=0.4, tested=RANGE),
    "free power": PressurePower(friction_coefficient=0.5, reference_pressure=150e3, exponent=0.25),
    "held elastic-plastic": ElasticPlastic(stiffness=3e7, friction_coefficient=0.45, tested=RANGE),
}


def edges(law: FrictionLaw) -> tuple[float, ...]:
    """Pressures where a law changes its formula [Pa], read off its description."""
    if isinstance(law, IntegralLog):
        return law.coefficients.pressure if len(law.coefficients.pressure) > 1 else ()
    if isinstance(law, MeasuredTable):
        return law.pressure
    return () if law.tested is None else (law.tested.pressure_min, law.tested.pressure_max)


def kinks(law: FrictionLaw, pressure: float) -> list[float]:
    """Slips where a law changes its formula at a pressure [m], read off its description."""
    if isinstance(law, MeasuredTable):
        return list(law.slip[1:])
    if isinstance(law, ElasticPlastic):
        limit = law.friction_coefficient * pressure
        if law.tested is not None:
            limit *= min(1.0, law.tested.pressure_max / pressure)
        return [limit / law.stiffness]
    if isinstance(law, IntegralLog):
        slip, peak, slope, residual = (float(v) for v in law.parameters(pressure))
        return [slip] if slope == 0.0 else [slip, slip + (residual - peak) / slope]
    return []


def starts_with_a_jump(law: FrictionLaw) -> bool:
    return bool(law.friction(1e-15, 200e3) > 1e-9)


def smooth_points(law: FrictionLaw) -> list[tuple[float, float]]:
    """Slips and pressures over the whole range and beyond, clear of every change of formula."""
    points = []
    ends = np.array([10e3, *edges(law), 1.5e6])
    pressures = [a + w * (b - a) for a, b in pairwise(ends) for w in (0.2, 0.7)]
    for p in pressures:
        cells = [1e-5, *kinks(law, p), 40e-3]
        points += [
            (a + w * (b - a), p)
            for a, b in pairwise(cells)
            for w in (0.03, 0.4, 0.9)
            if b > 1.001 * a
        ]
    return points
