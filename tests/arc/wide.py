"""Random drives over all that the readers accept; cast over thousands by benchmarks/wide_net.py."""

from __future__ import annotations

import math

import numpy as np

from arc.drives import LAWS
from wraparc.arc import WrapArc
from wraparc.friction import FrictionLaw, MeasuredTable

NAMES = (*LAWS, "any table")


def log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(math.log(low), math.log(high))))


def any_table(rng: np.random.Generator) -> FrictionLaw:
    """A table of up to 8 slips and 4 pressures: rising, lazy at first, falling, jumping."""
    m, n = int(rng.integers(2, 9)), int(rng.integers(1, 5))
    steps = np.exp(rng.uniform(math.log(2e-5), math.log(5e-3), m - 1))
    slip = np.concatenate([[0.0], np.cumsum(steps)])
    pressure = np.cumsum(np.exp(rng.uniform(math.log(2e4), math.log(4e5), n)))
    rise, shape = np.sort(rng.uniform(0.01, 1.2, m)), int(rng.integers(4))
    if shape != 3:
        rise[0] = 0.0
    if shape == 1:
        rise[1 : m // 2] = np.linspace(1e-5, 1e-3, max(m // 2 - 1, 0))
    if shape == 2:
        rise[-1] *= 0.6
    rows = tuple(tuple((rise * (1.0 - 0.15 * k)).tolist()) for k in range(n))
    return MeasuredTable(slip=tuple(slip.tolist()), pressure=tuple(pressure.tolist()), values=rows)


def wide_arc(name: str, rng: np.random.Generator) -> WrapArc:
    """Wrap 30-720 deg, belt modulus 1e5-1e10 N/m, lagging 0.1-100 mm, ratio 1 + 1e-9 to 50.

    Raises
    ------
    InputError
        Where the reader refuses the drive.
    """
    law = any_table(rng) if name == "any table" else LAWS[name]
    diameter, width = log_uniform(rng, 0.2, 2.5), log_uniform(rng, 0.3, 3.0)
    tight = log_uniform(rng, 2e4, 1.5e6) * width * diameter / 2.0
    side = ("driving", "braking", "idling")[int(rng.choice(3, p=[0.5, 0.35, 0.15]))]
    ratio = 1.0 + (log_uniform(rng, 1e-9, 1e-3) if side == "idling" else log_uniform(rng, 1e-4, 49))
    brakes = side == "braking" or (side == "idling" and rng.random() < 0.5)
    tensions = (tight / ratio, tight) if brakes else (tight, tight / ratio)
    return WrapArc(
        law=law,
        entry_tension=tensions[0],
        exit_tension=tensions[1],
        diameter=diameter,
        width=width,
        wrap_angle=math.radians(float(rng.uniform(30.0, 720.0))),
        axial_stiffness=log_uniform(rng, 1e5, 1e10) * width,
        thickness=log_uniform(rng, 1e-4, 0.1),
        shear_modulus=log_uniform(rng, 3e5, 1e9),
        compression_modulus=log_uniform(rng, 2e6, 1e10),
        overrun=[None, 0.0, 2e-5][int(rng.integers(3))],
        recovery=bool(rng.random() < 0.7),
    )
