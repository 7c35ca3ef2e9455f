"""The thickness of a belt: where its tension member runs over a pulley, and what shears below it.

The belt pulls along its tension member, the middle of the carcass, which runs an offset e above
the surface of the lagging; traction acts at that surface. Moments about the axis of the pulley and
equilibrium along the radius give, with T* = T - m v^2,

    p = T*/(B R),        d(ln T*)/d theta = -(tau/p) R/(R + e),

creep and slip being those at the surface. That is the arc of a belt without thickness on a pulley
of the radius R + e, the wrap angle phi R/(R + e) and the width B R/(R + e): arc length and
pressures are the same. Speed, torque and power belong to the pitch radius R - delta + e.

Where the belt meets the drum it runs at v1 = omega (R - delta + e)(1 - g). From there on its speed
follows its strain alone, as the mass that passes in a second is the same everywhere: behind the
drum v2/v1 = (1 + T2/EA)/(1 + T1/EA), EA being that of the belt. The recovery of the lagging under
it, part of 1/EA', moves the surface against the belt and so the friction, not the belt.
"""

from __future__ import annotations

from math import exp, isnan, log, nan, pi
from typing import NamedTuple

from wraparc.arrays import Number
from wraparc.drive.belt import COVER_SHEAR_BAND, COVER_SHEAR_MODULUS, Belt, Side
from wraparc.friction import FrictionLaw
from wraparc.provenance import Provenance

#: Offset of the tension member in a belt of 10 mm, for the size of what is missing without one [m].
USUAL_OFFSET = 5e-3


class Layers(NamedTuple):
    """The layers of a belt, nan where they are not known."""

    pulley_cover: float  # [m]
    carry_cover: float  # [m]
    carcass: float  # [m]


def layers(pulley_cover: float, carry_cover: float, carcass: float, thickness: float) -> Layers:
    """Layers of a belt: where one alone is not given, what the thickness leaves for it [m].

    Parameters
    ----------
    pulley_cover, carry_cover, carcass, thickness
        As they are given, nan where they are not [m].
    """
    known = thickness == thickness
    if known and isnan(carcass):
        return Layers(pulley_cover, carry_cover, thickness - pulley_cover - carry_cover)
    if known and isnan(carry_cover):
        return Layers(pulley_cover, thickness - pulley_cover - carcass, carcass)
    if known and isnan(pulley_cover):
        return Layers(thickness - carry_cover - carcass, carry_cover, carcass)
    return Layers(pulley_cover, carry_cover, carcass)


def touching_cover(of: Layers, carries: bool) -> float:
    """The cover on the side that meets the pulley, nan where it is not known [m]."""
    return of.carry_cover if carries else of.pulley_cover


def tension_offset(of: Layers, carries: bool) -> float:
    """Offset e of the tension member over the surface of the lagging, nan if not known [m].

    The cover that touches the pulley and half of the carcass.
    """
    return touching_cover(of, carries) + 0.5 * of.carcass


def layers_of(belt: Belt) -> Layers:
    """Return the layers of a belt."""
    given = (belt.pulley_cover, belt.carry_cover, belt.cord, belt.thickness)
    return layers(*(nan if value is None else value for value in given))


def pitch_offset(belt: Belt, side: Side) -> float | None:
    """Return e, tension member over the surface of the lagging [m]; None where it is not known.

    Parameters
    ----------
    belt
        The belt.
    side
        The side that meets the pulley.
    """
    found = tension_offset(layers_of(belt), side == "carry")
    return None if isnan(found) else found


def sheared_thickness(cover: float, diameter: float, pitch: float) -> float:
    """Return the thickness of flat rubber that shears as the rubber below a row of cords does [m].

    Shear between the surface of a cover and cords in one row is Laplace's equation: the
    displacement along the belt is constant on the surface and 0 on each cord, and no stress leaves
    the far side. The rubber between the cords shears too, which adds to the cover, with r = d/p,

        p F(r) [1 - 0.44 exp(-4 pi t/p)],
        F(r) = ln[1 + (1/pi + 0.65 r^2/(1 + 3.75 r^2))/r]/(2 pi).

    F is exact for thin cords; within 0.3 % of a solution of the equation for covers of 0.1
    pitches or more and cords of 0.1 to 0.9 pitches (``tests/drive/test_cords.py`` solves it).

    Parameters
    ----------
    cover, diameter, pitch
        Rubber between the surface and the cords t, diameter d of these, and distance p between
        their axes [m].
    """
    share = diameter / pitch
    between = log(1.0 + (1.0 / pi + 0.65 * share**2 / (1.0 + 3.75 * share**2)) / share) / (2.0 * pi)
    return cover + pitch * between * (1.0 - 0.44 * exp(-4.0 * pi * cover / pitch))


def sheared_cover(belt: Belt, side: Side) -> float:
    """Return h_b, the thickness of cover that shears below the tension member [m]; nan if unknown.

    The cover that touches the pulley, and what the rubber between steel cords adds to it where
    their pitch is known: see `sheared_thickness`.
    """
    of = layers_of(belt)
    cover = touching_cover(of, side == "carry")
    if belt.cord_pitch is None or isnan(cover):
        return cover
    return sheared_thickness(cover, of.carcass, belt.cord_pitch)


def cover_compliance(belt: Belt, side: Side) -> float:
    """Return h_b/G_b of the cover that touches the pulley [m/Pa]; 0 where it is not known.

    Without a modulus that of `COVER_SHEAR_MODULUS` is taken, an estimate.
    """
    cover = sheared_cover(belt, side)
    modulus = COVER_SHEAR_MODULUS if belt.cover_shear_modulus is None else belt.cover_shear_modulus
    return 0.0 if isnan(cover) else cover / modulus


def whole_thickness(belt: Belt) -> float | None:
    """Return covers and carcass of a belt in all [m]; None where that is not known."""
    total = sum(layers_of(belt)) if belt.thickness is None else belt.thickness
    return None if isnan(total) else total


def covered(belt: Belt) -> bool:
    """Whether a cover of the belt is known that could shear."""
    found = layers_of(belt)
    return found.pulley_cover > 0.0 or found.carry_cover > 0.0


#: Where the modulus of a cover comes from that is not given.
ESTIMATED_COVER = Provenance(
    note=f"estimated: belt covers have {COVER_SHEAR_BAND[0] / 1e6:g} to "
    f"{COVER_SHEAR_BAND[1] / 1e6:g} MPa (116 to 218 psi)"
)


def counts_shear(law: FrictionLaw, part: str) -> bool | None:
    """Return whether the slip of a law includes the shear of a part; None if it does not say."""
    return None if law.slip_includes is None else part in law.slip_includes


def thin_belt(
    radius: Number, wrap_angle: Number, width: Number, offset: Number
) -> tuple[Number, Number, Number]:
    """Radius [m], wrap angle [rad] and width [m] of the same arc without thickness.

    Parameters
    ----------
    radius, wrap_angle, width
        R over the unloaded lagging [m], phi [rad], B [m].
    offset
        e of the tension member over the surface of the lagging [m]; with 0 all stay as they are.
    """
    share = radius / (radius + offset)
    return radius + offset, wrap_angle * share, width * share


def pitch_radius(radius: Number, compression: Number, offset: Number) -> Number:
    """R - delta + e, at which the belt pulls and runs [m].

    Parameters
    ----------
    radius, compression
        R over the unloaded lagging, and how far that is squeezed at the entry nip, delta [m].
    offset
        e of the tension member over the surface of the lagging [m].
    """
    return radius - compression + offset


def strain_ratio(tension: Number, reference: Number, stiffness: Number) -> Number:
    """Speed of a belt over its speed at another place, (1 + T/EA)/(1 + T_0/EA) [-].

    Parameters
    ----------
    tension, reference
        T there, and T_0 at the other place [N]. Those above m v^2 give the same with EA + m v^2.
    stiffness
        EA of the belt alone [N].
    """
    return (1.0 + tension / stiffness) / (1.0 + reference / stiffness)


def belt_to_shaft(radius: Number, pitch: Number, creep_ratio: Number) -> Number:
    """Speed of the belt that meets a drum over omega R, (R - delta + e)(1 - g)/R [-].

    Parameters
    ----------
    radius, pitch
        R over the unloaded lagging; R - delta + e, see `pitch_radius` [m].
    creep_ratio
        g at the entry nip [-].
    """
    return pitch / radius * (1.0 - creep_ratio)


def turns_an_hour(speed: Number, pitch: Number) -> Number:
    """How often a pulley turns in an hour, v/(2 pi (R + e)), creep and compression left out [-].

    Parameters
    ----------
    speed, pitch
        Of the belt [m/s]; R + e, radius of its tension member [m].
    """
    return 3600.0 * speed / (2.0 * pi * pitch)


def centrifugal_force(mass: Number, speed: Number) -> Number:
    """M v^2, what of the tension presses on no pulley [N].

    Parameters
    ----------
    mass, speed
        Of the belt per length [kg/m]; of the belt [m/s].
    """
    return mass * speed * speed


def centrifugal_of(belt: Belt) -> float:
    """Return m v^2 of a belt [N]; 0 where its mass or its speed is not known."""
    if belt.mass is None or belt.speed is None:
        return 0.0
    return centrifugal_force(belt.mass, belt.speed)
