"""A pulley of a drive, uneven across its width, to the arc that the solver reads."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from wraparc.across.spans import (
    TransitionSpan,
    extra_path,
    length_after,
    length_before,
    shear_lengths,
)
from wraparc.across.wide_arc import WideArc, centres, cosines, wave_numbers
from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.drive import Across, Belt, Drive, LoadCase, Pulley, Transition, WidthProfile
from wraparc.provenance import Kind, Provenance
from wraparc.units import unit_factor


@dataclass(frozen=True)
class Stiffness:
    """In-plane shear stiffness of a belt.

    Attributes
    ----------
    value
        S = G_b t_b [N/m].
    low, high
        Between which it lies [N/m]; equal to `value` where it is given.
    source
        Where it came from.
    """

    value: float
    low: float
    high: float
    source: Provenance

    @property
    def estimated(self) -> bool:
        """Whether nobody has said it."""
        return self.low < self.high


#: carcass -> estimate and its factors down and up: a plain-weave fabric, and a steel cord ST2000 by
#: the rubber between and over the cords (Halpin-Tsai, G_r 1.5 MPa)
_ESTIMATES = {"steel cord": (40e3, 0.25, 4.0), "": (100e3, 0.2, 4.0)}


def in_plane_stiffness(belt: Belt) -> Stiffness:
    """Return the in-plane shear stiffness of a belt, estimated from its carcass if not given."""
    given = belt.in_plane_shear_stiffness
    if given is not None:
        return Stiffness(given, given, given, belt.source_of("in_plane_shear_stiffness"))
    value, down, up = _ESTIMATES.get(belt.kind, _ESTIMATES[""])
    carcass = belt.kind if belt.kind in _ESTIMATES else "fabric"
    piw = unit_factor("PIW", "force_per_width")
    ends = [f"{down * value / unit:.3g} and {up * value / unit:.3g}" for unit in (1e3, piw)]
    note = f"estimated for {carcass}, between {ends[0]} kN/m ({ends[1]} PIW)"
    return Stiffness(value, down * value, up * value, Provenance(Kind.ILLUSTRATIVE, note=note))


def wide_arc(
    drive: Drive,
    pulley: Pulley,
    case: LoadCase,
    *,
    strips: int | None = None,
    stiffness: float | None = None,
) -> WideArc:
    """Return one pulley of a drive in one load case, cut into strips.

    Parameters
    ----------
    drive, pulley, case
        The pulley may be even: without its own `Across` everything is even.
    strips
        Number of strips, or None for that of the pulley.
    stiffness
        In-plane shear stiffness of the belt [N/m], or None for its own or the estimate.
    """
    arc = WrapArc.of(drive, pulley, case)
    lagging = pulley.lagging_in(case.condition)
    across = pulley.across or Across()
    own = in_plane_stiffness(drive.belt)
    shear = own.value if stiffness is None else stiffness
    n = across.strips if strips is None else strips
    y = centres(arc.width, n)
    worn = _at(across.worn_depth, y, arc.width)
    thickness = arc.thickness - worn
    skew = math.sin(0.5 * arc.wrap_angle)
    bend = across.deflection * (1.0 - (2.0 * y / arc.width) ** 2)
    misfit = (across.misalignment * y - bend) * skew
    decay = shear_lengths(wave_numbers(arc.width, n), arc.axial_stiffness / arc.width, shear)
    wide = WideArc(
        arc=arc,
        shear_stiffness=shear,
        radius_deviation=_at(across.shell_profile, y, arc.width)
        + _at(across.build_up, y, arc.width)
        - worn,
        thickness=thickness,
        compression_modulus=lagging.compression_modulus_at(thickness),
        entry_profile=_evened(_at(across.entry_profile, y, arc.width)),
        entry_misfit=misfit,
        exit_misfit=misfit,
        length_before=length_before(decay, across.before),
        length_after=length_after(decay, across.after),
        lagging=lagging,
        stiffness_source=own.source if stiffness is None else Provenance(),
    )
    return _with_transition(wide, across.before, y, decay)


def _with_transition(wide: WideArc, before: object, y: Array, decay: Array) -> WideArc:
    """Add a trough transition to what pulls on the belt before the pulley."""
    if not isinstance(before, Transition):
        return wide
    c = cosines(wide.strips)[1:]
    strain = extra_path(before, y, wide.arc.width)
    span = TransitionSpan(wide.belt_modulus, c @ strain, decay, before.length)
    return replace(
        wide,
        entry_profile=wide.entry_profile + span.free_profile() @ c,
        static_profile=wide.entry_profile + wide.belt_modulus * _evened(strain),
        transition=span,
    )


def _at(profile: WidthProfile | None, y: Array, width: float) -> Array:
    return np.zeros_like(y) if profile is None else profile.at(y, width)


def _evened(values: Array) -> Array:
    """Return values without their mean, which is the tension of the load case."""
    return np.asarray(values - np.mean(values))
