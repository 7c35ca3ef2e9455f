"""The spans of belt before and after a pulley, mode by mode across the width.

A span is a membrane that its idlers hold to its track: M v_ss + S v_yy = 0 with v = -lag. Mode n
decays along it like exp(-|s|/lambda_n), lambda_n = (B/(n pi)) sqrt(M/S), so that a span is known
to the pulley by one effective length a mode.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import GrippingPulley, Transition


def shear_lengths(wave_numbers: Array, modulus: float, stiffness: float) -> Array:
    """Length lambda_n over which a mode decays along a span [m].

    Parameters
    ----------
    wave_numbers
        n pi/B of the modes [1/m].
    modulus
        Belt modulus M [N/m].
    stiffness
        In-plane shear stiffness S [N/m].
    """
    return np.asarray(np.sqrt(modulus / stiffness) / wave_numbers)


def length_before(decay: Array, end: GrippingPulley | Transition | None) -> Array:
    """Effective length Lam1_n of the span before a pulley [m].

    An even pulley that grips hands over straight label lines: lambda tanh(d/lambda). A transition
    and a far end: lambda.
    """
    if isinstance(end, GrippingPulley):
        return np.asarray(decay * np.tanh(end.distance / decay))
    return decay


def length_after(decay: Array, end: GrippingPulley | None) -> Array:
    """Effective length Lam2_n of the span after a pulley [m].

    An even pulley that grips asks for even strain: lambda coth(d/lambda). A far end: lambda.
    """
    if end is None:
        return decay
    return np.asarray(decay / np.tanh(end.distance / decay))


def extra_path(transition: Transition, position: Array, width: float) -> Array:
    """Extra path per length of a trough transition, eta(y) [-].

    eta = [(z sin beta - H)^2 + z^2 (1 - cos beta)^2] / (2 Lt^2), with z along the wing, 0 on the
    centre roll, and the height H of the pulley over the centre roll.
    """
    beta = transition.trough_angle
    wing = 0.5 * (width - transition.centre_roll)
    height = 0.5 * wing * np.sin(beta) if transition.depth == "half" else 0.0
    z = np.maximum(np.abs(position) - 0.5 * transition.centre_roll, 0.0)
    rise = (z * np.sin(beta) - height) ** 2 + (z * (1.0 - np.cos(beta))) ** 2
    return np.asarray(rise / (2.0 * transition.length**2))


@dataclass(frozen=True, eq=False)
class TransitionSpan:
    """A trough transition, by mode.

    Attributes
    ----------
    modulus
        M [N/m].
    strain
        Modes of the extra path, eta_n, shape (n - 1,) [-].
    decay
        lambda_n [m].
    length
        Lt [m].
    """

    modulus: float
    strain: Array
    decay: Array
    length: float

    def free_profile(self) -> Array:
        """Modes of the entry tension without lag, f_n = M eta_n (1 - exp(-Lt/lambda_n)) [N/m]."""
        return self.modulus * self.strain * -np.expm1(-self.length / self.decay)

    def tension(self, entry: Array, free: Array, distance: float) -> Array:
        """Modes of the tension at a distance before the pulley [N/m].

        Parameters
        ----------
        entry
            Modes t1_n of the entry tension [N/m].
        free
            Modes f_n of the free profile, the transition's own and any other [N/m].
        distance
            Distance before the tangent, >= 0 [m].
        """
        z, q = -distance / self.decay, self.length / self.decay
        lag = -(entry - free) / self.modulus
        other = free - self.free_profile()
        if distance <= self.length:
            path = self.strain * (0.5 * (np.exp(-z - q) + np.exp(z - q)) - 1.0)
        else:
            path = -0.5 * self.strain * (np.exp(z + q) - np.exp(z - q))
        return np.asarray(other - self.modulus * (lag * np.exp(z) + path))
