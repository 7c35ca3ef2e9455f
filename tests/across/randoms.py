"""Random uneven arcs, plausible ones: driving, idling, braking, with all kinds of defects."""

from __future__ import annotations

import math

import numpy as np

from wraparc.across.spans import length_after, length_before, shear_lengths
from wraparc.across.wide_arc import WideArc, centres, wave_numbers
from wraparc.arc import WrapArc
from wraparc.drive import GrippingPulley
from wraparc.friction import FrictionLaw


def random_wide(law: FrictionLaw, rng: np.random.Generator, strips: int) -> WideArc:
    """An arc of fabric or steel cord with a mixture of defects."""
    cord = bool(rng.random() < 0.5)
    width, diameter = float(rng.uniform(0.8, 1.8)), float(rng.uniform(0.6, 1.4))
    modulus = float(rng.uniform(60e6, 200e6) if cord else rng.uniform(6e6, 20e6))
    tight = float(rng.uniform(120e3, 300e3)) * diameter / 2.0 * width
    ratio = float(rng.uniform(1.02, 2.4))
    entry, leaving = (tight, tight / ratio) if rng.random() < 0.75 else (tight / ratio, tight)
    thickness = float(rng.uniform(8e-3, 20e-3))
    arc = WrapArc(
        law=law,
        entry_tension=entry,
        exit_tension=leaving,
        diameter=diameter,
        wrap_angle=math.radians(float(rng.uniform(150.0, 230.0))),
        width=width,
        axial_stiffness=modulus * width,
        thickness=thickness,
        shear_modulus=2.3e6,
        compression_modulus=float(rng.uniform(8e6, 25e6)),
        overrun=0.0 if rng.random() < 0.7 else 2e-5,
        recovery=bool(rng.random() < 0.9),
    )
    stiffness = float(rng.uniform(20e3, 80e3) if cord else rng.uniform(30e3, 200e3))
    decay = shear_lengths(wave_numbers(width, strips), modulus, stiffness)
    before = GrippingPulley(distance=float(rng.uniform(1.0, 6.0))) if rng.random() < 0.3 else None
    after = GrippingPulley(distance=float(rng.uniform(1.0, 6.0))) if rng.random() < 0.3 else None
    y = centres(1.0, strips)
    size = 0.4e-3 if cord else 1.2e-3
    worn = size * float(rng.uniform(0.0, 1.0)) * np.cos(math.pi * y) ** 2
    skew = float(rng.uniform(-1e-3, 1e-3)) * width
    return WideArc(
        arc=arc,
        shear_stiffness=stiffness,
        radius_deviation=size * (rng.uniform(-1.0, 1.0) * (1.0 - 4.0 * y**2)
                                 + rng.uniform(-0.5, 0.5) * y) - worn,
        thickness=thickness - worn,
        compression_modulus=np.full(strips, arc.compression_modulus),
        entry_profile=0.05 * entry / width * float(rng.uniform(-1.0, 1.0)) * y,
        entry_misfit=skew * y,
        exit_misfit=skew * y,
        length_before=length_before(decay, before),
        length_after=length_after(decay, after),
    )  # fmt: skip
