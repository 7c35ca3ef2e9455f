"""One loaded wrap arc cut into strips: everything a solver across the width needs, in SI."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from wraparc.across.spans import TransitionSpan
from wraparc.arc import WrapArc
from wraparc.arc.quantities import jumps
from wraparc.arrays import Array
from wraparc.drive import Lagging
from wraparc.errors import input_error
from wraparc.provenance import Provenance
from wraparc.units import display


def cosines(strips: int) -> Array:
    """Orthonormal cosine transform (DCT-II) between strips and modes, shape (n, n).

    Row k holds mode k at the centres of the strips, cos(k pi (y/B + 1/2)), scaled to length 1.
    """
    k = np.arange(strips)[:, None]
    j = np.arange(strips)[None, :] + 0.5
    table: Array = np.sqrt(2.0 / strips) * np.cos(np.pi * k * j / strips)
    table[0] = 1.0 / np.sqrt(strips)
    return table


def centres(width: float, strips: int) -> Array:
    """Positions y of the centres of equal strips, 0 in the middle of the belt [m]."""
    return width * ((np.arange(strips) + 0.5) / strips - 0.5)


def wave_numbers(width: float, strips: int) -> Array:
    """Wave numbers k pi/B of the modes 1 .. n - 1 of a belt of n strips [1/m]."""
    return np.arange(1.0, strips) * (math.pi / width)


@dataclass(frozen=True, kw_only=True, eq=False)
class WideArc:
    """A belt on one pulley in one load case, cut into equal strips.

    Attributes
    ----------
    arc
        The even belt on the even pulley.
    shear_stiffness
        In-plane shear stiffness S of the belt in the wrap, >= 0 [N/m].
    radius_deviation
        a, radius of the unloaded lagging less R, by strip, shape (n,) [m].
    thickness, compression_modulus
        h [m] and E_c [Pa] of the lagging by strip, shape (n,).
    entry_profile
        f, deviation of the tension that there would be at the entry without lag, shape (n,) [N/m].
    entry_misfit, exit_misfit
        E1 and E2, extra length of the path at the tangents, shape (n,) [m].
    length_before, length_after
        Effective lengths Lam1 and Lam2 of the spans by mode 1 .. n - 1, shape (n - 1,) [m].
    static_profile
        Deviation of the tension at standstill, both label lines of the transition held, shape
        (n,) [N/m]; None where it is the entry profile.
    transition
        The trough transition before the pulley, or None.
    lagging
        The lagging, which says how a worn one compresses, or None to keep E_c.
    stiffness_source
        Where the in-plane shear stiffness came from.
    """

    arc: WrapArc
    shear_stiffness: float
    radius_deviation: Array
    thickness: Array
    compression_modulus: Array
    entry_profile: Array
    entry_misfit: Array
    exit_misfit: Array
    length_before: Array
    length_after: Array
    static_profile: Array | None = None
    transition: TransitionSpan | None = None
    lagging: Lagging | None = None
    stiffness_source: Provenance = field(default_factory=Provenance)

    def __post_init__(self) -> None:
        if np.any(self.thickness < 0.0):
            worst = int(np.argmin(self.thickness))
            raise input_error(
                key="worn_depth",
                value=display(self.arc.thickness - float(self.thickness[worst]), "length"),
                message="must be less than the lagging thickness "
                + display(self.arc.thickness, "length"),
                remedy="Give the depth worn off.",
            )
        if jumps(self.arc.law.compact()) and not np.all(self.shear > 0.0):
            raise input_error(
                key="lagging",
                message="creep is undetermined: the law starts with a jump on a rigid lagging",
                remedy="Give thickness and shear modulus.",
            )

    @property
    def strips(self) -> int:
        """Number of strips n."""
        return len(self.radius_deviation)

    @property
    def position(self) -> Array:
        """Positions y of the strips, 0 in the middle [m]."""
        return centres(self.arc.width, self.strips)

    @property
    def belt_modulus(self) -> float:
        """M [N/m]."""
        return self.arc.axial_stiffness / self.arc.width

    @property
    def shear(self) -> Array:
        """h/G + h_b/G_b of the strips, without what the slip of the law includes [m/Pa]."""
        own = (
            0.0 * self.thickness
            if self.arc.slip_with_shear
            else (self.thickness / self.arc.shear_modulus)
        )
        return own + self.arc.cover_compliance

    @property
    def pitch(self) -> float:
        """R + e of the tension member over the unloaded lagging [m]."""
        return self.arc.radius + self.arc.offset

    @property
    def pulled_share(self) -> float:
        """R/(R + e), what of the traction on the lagging the tension member feels [-]."""
        return self.arc.radius / self.pitch

    @property
    def lift(self) -> float:
        """M v^2/B, the tension per unit width that presses on no pulley [N/m]."""
        return self.arc.centrifugal / self.arc.width

    def pressure(self, tension: Array) -> Array:
        """Wrap pressure p = (t - m v^2/B)/R of a tension [Pa]."""
        return np.asarray((tension - self.lift) / self.arc.radius)

    @property
    def give(self) -> Array:
        """h/(R^2 E_c): how the compression of the lagging adds to 1/M, by strip [m/N]."""
        return self.thickness / (self.arc.radius**2 * self.compression_modulus)

    @property
    def compliance(self) -> Array:
        """1/M' = 1/M + h/(R^2 E_c) by strip [m/N]."""
        return 1.0 / self.belt_modulus + self.give

    @cached_property
    def modes(self) -> Array:
        """The cosine transform, see `cosines`."""
        return cosines(self.strips)

    @cached_property
    def wave_numbers(self) -> Array:
        """Wave numbers n pi/B of the modes 1 .. n - 1 [1/m]."""
        return wave_numbers(self.arc.width, self.strips)

    @cached_property
    def compliance_in_wrap(self) -> Array:
        """How much less a strip creeps per length and tension, shape (n,) [m/N].

        1/M', or 1/M where the lagging does not recover within the wrap.
        """
        recovery = self.give if self.arc.recovery else 0.0 * self.give
        return np.asarray(1.0 / self.belt_modulus + recovery)

    @cached_property
    def coupling(self) -> Array:
        """S d2/dy2 between strips, shape (n, n) [N/m3]."""
        c = self.modes[1:]
        return np.asarray(-(c.T * (self.shear_stiffness * self.wave_numbers**2)) @ c)

    def overrun(self, tension: Array) -> tuple[Array, Array]:
        """Creep at the entry nip x_c [m] and its derivative by the entry tension [m2/N]."""
        if self.arc.overrun is not None:
            given = np.full(self.strips, self.arc.overrun)
            return given, np.zeros(self.strips)
        squeeze = self.give * self.arc.radius  # delta = squeeze (t1 - m v^2/B)
        c = 1.25 * squeeze**1.5 / math.sqrt(self.arc.radius)
        root = np.sqrt(np.maximum(tension - self.lift, 0.0))
        return c * root**3, 1.5 * c * root

    def worn(self, depth: Array) -> WideArc:
        """Return the arc with more of its lagging worn off [m], shape (n,)."""
        thickness = self.thickness - depth
        modulus = self.compression_modulus
        if self.lagging is not None and np.all(thickness > 0.0):
            modulus = self.lagging.compression_modulus_at(thickness)
        return replace(
            self,
            radius_deviation=self.radius_deviation - depth,
            thickness=thickness,
            compression_modulus=modulus,
        )

    def spread(self, lengths: Array) -> Array:
        """Operator that multiplies the modes of a profile by lengths and drops its mean."""
        c = self.modes[1:]
        return np.asarray((c.T * lengths) @ c)
