"""What the checks of one arc compare, and how a list of them is ordered: plain numbers only.

`judge` makes its checks of them; the page of the calculator runs them translated while a slider
moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, inf, isfinite, isnan, nan
from typing import Generic, NamedTuple

from wraparc.arc.quantities import Buffer
from wraparc.arrays import Number
from wraparc.drive.pitch import USUAL_OFFSET

#: Pull against each other over the largest pull that counts as none [-].
SMALL_PULL = 1e-3
#: Difference of shares used that is rounding: of alike ones the first governs on every machine.
ALIKE = 1e-9
#: Largest share of a limit that orders checks, and distance of one kind of check from the next [-].
MOST_USED, KIND_STEP = 4e3, 1e4
#: Kinds of checks in the order in which they govern a verdict, those of one level.
KINDS = (
    ("balance", "train_balance", "across_balance"),
    ("gross_slip", "operating_point", "slack_edge"),
    ("opposing_drives", "run", "vibration"),
    (
        "belt_tension", "momentary_tension", "belt_safety", "face_pressure", "pulley_diameter",
        "edge_tension", "static_edge_tension", "static_centre_tension", "transition_length",
        "uneven_face_pressure", "crown", "sag", "taut", "motor_load", "momentary_load",
        "motor_heat",
    ),
    ("bond_stress", "fatigue_stress", "uneven_bond_stress", "uneven_fatigue_stress"),
    ("creep", "uneven_creep"),
    ("design_standard",),
    (
        "tested_slip", "tested_slip_speed", "tested_pressure_max", "tested_pressure_min",
        "uneven_pressure",
    ),
    ("creep_interval", "cover_creep"),
    ("wet_creep",),
    ("condition", "fit", "belt_thickness", "take_up", "meeting", "case_kind", "uneven_wear"),
    ("usual_sizes", "profile_extent"),
    ("reserve",),
)  # fmt: skip
#: The place of a check among the kinds, by its name.
KIND_OF = {name: float(kind) for kind, names in enumerate(KINDS) for name in names}
#: Part by which what a take-up holds may differ between load cases: belt mass on slopes, and what
#: runs between take-up and drive [-].
HELD = 0.1


def same_shown(value: float, limit: float) -> bool:
    """Whether two numbers are equal in the four digits they are compared in."""
    if not (isfinite(value) and isfinite(limit)):
        return value == limit
    return f"{value:.3e}" == f"{limit:.3e}"


def kept(value: float, limit: float, at_most: bool) -> bool:
    """Whether a value keeps its limit, compared in four digits; one that is not known does not."""
    if isnan(value):
        return False
    within = value <= limit if at_most else value >= limit
    return within or same_shown(value, limit)


def beyond(value: float, fails: float, at_most: bool) -> bool:
    """Whether a value that misses its limit fails: nan where it never does."""
    return value > fails if at_most else value < fails


def margin_of(value: float, limit: float, at_most: bool) -> float:
    """How far a value is from its limit, over the limit: positive on the safe side, or nan [-]."""
    if isnan(value) or isnan(limit) or limit == 0.0:
        return nan
    if not isfinite(value):
        return nan if at_most else inf
    return (1.0 if at_most else -1.0) * (1.0 - value / limit) + 0.0  # no -0.0


def used_of(value: float, limit: float, at_most: bool) -> float:
    """How much of a limit is used: value over a maximum, a minimum over the value; or nan [-]."""
    if isnan(value) or isnan(limit) or limit == 0.0:
        return nan
    if at_most:
        return value / limit
    return limit / value if value > 0.0 else inf


def kind_of(name: str, fails: bool) -> float:
    """Return the place of a check among `KINDS`; what stands nowhere is one of the data.

    A creep that fails is one at which the belt slides.
    """
    if fails and name in ("creep", "uneven_creep"):
        return KIND_OF["gross_slip"]
    return KIND_OF.get(name, KIND_OF["condition"])


def order_of(used: float, missed: bool, kind: float) -> float:
    """Return the place of a check among those of its level: the least governs.

    Of what is missed the kind decides, then how much of the limit is used; what has no number comes
    first of its kind. Of what passes only the use decides, and what has no number comes last.
    """
    if isnan(used) and not missed:
        return inf
    share = MOST_USED if isnan(used) else min(used, MOST_USED)
    place = kind * KIND_STEP if missed else 0.0
    return place - floor(share / ALIKE + 0.5) * ALIKE


def usual(value: float, least: float, most: float) -> bool:
    """Whether a size is one that conveyor drives have; one that is not given or rigid is."""
    return not (value < least or (value > most and isfinite(value)))


class Sizes(NamedTuple, Generic[Number]):
    """What is given of belt, pulley and lagging; nan where something is not [SI]."""

    width: Number
    modulus: Number
    speed: Number
    diameter: Number
    idle_wrap: Number  # wrap angle of a pulley that does not pull, else nan
    wrap_angle: Number  # of one that does
    creep_limit: Number
    overrun: Number
    thickness: Number
    shear_modulus: Number
    compression_modulus: Number
    rating: Number
    strength: Number
    bond_strength: Number
    fatigue_limit: Number
    face_pressure: Number
    least_diameter: Number
    sag: Number
    entry: Number
    leaving: Number
    pull: Number  # nan where there is none, or where it is found and not given
    mass: Number  # of the belt per length


def compared_sizes(of: Sizes[Number]) -> list[Number]:
    """Sizes, and the ratios between them that a wrong unit shows in, in the order of their ends."""
    return [
        of.width, of.modulus, of.speed, of.diameter, of.idle_wrap, of.wrap_angle,
        of.creep_limit, of.overrun, of.thickness, of.shear_modulus, of.compression_modulus,
        of.rating, of.bond_strength, of.fatigue_limit, of.face_pressure, of.least_diameter,
        of.sag / of.width,
        of.strength / of.rating, of.modulus / of.rating, 2.0 * of.rating / of.diameter,
        of.entry / of.width, of.leaving / of.width, abs(of.pull) * of.speed,
        of.mass / of.width,
    ]  # fmt: skip


#: Rated power of all motors over that of the largest pull that is given, at most [-].
LARGE_MOTORS = 6.0
#: Rated power and speed of motors [W, rad/s], and speed of the drum surface at it over that of the
#: belt [-], least and most: motors slip by a few per cent, a belt by less.
USUAL_MOTORS = ((250.0, 2e7), (10.0, 400.0), (0.95, 1.05))


def compared_motor(
    power: float, speed: float, drum: float, radius: float, belt: float
) -> list[float]:
    """What `USUAL_MOTORS` are the ends of; speeds of motor and drum in rad/s, nan if unknown."""
    return [power, speed, drum * radius / belt]


def has_equal_tension(least: float, most: float) -> bool:
    """Return whether one take-up can give both tensions."""
    return most - least <= HELD * most


def pull_against(pulls: Sequence[float]) -> float:
    """Pull of drives against each other, 0 where they work together [N]."""
    small = SMALL_PULL * max(abs(pull) for pull in pulls)
    if not (min(pulls) < -small and max(pulls) > small):
        return 0.0
    return min(sum(max(p, 0.0) for p in pulls), sum(max(-p, 0.0) for p in pulls))


#: For the size of what is missing without the layers of a belt: how much covers differ [m]; least
#: shift of a trim that is told [-].
COVERS_APART, LEAST_SHIFT = 4e-3, 1e-4


def trim_shift(first: Number, other: Number, opposite: bool) -> Number:
    """How far a trim is off for a belt of 10 mm taken without thickness [-].

    Parameters
    ----------
    first, other
        Diameters of the drums [m].
    opposite
        Whether they meet opposite sides of the belt: by covers that differ by 4 mm.
    """
    if opposite:
        return COVERS_APART / (0.5 * min(first, other))
    return abs(USUAL_OFFSET / (0.5 * first) - USUAL_OFFSET / (0.5 * other))


def required_slack(factor: float, start: float, pull: float) -> float:
    """Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]."""
    return factor * start * abs(pull)


def as_printed(factor: float) -> float:
    """Drive factor as a table of two decimals prints it, where that is less; 0.38 for 0.3835 [-].

    CEMA prints its factors so: a slack side of the printed one keeps the standard.
    """
    return min(factor, floor(100.0 * factor + 0.5) / 100.0)


def largest(column: Buffer, count: int) -> float:
    """Largest magnitude in a column."""
    found = 0.0
    for i in range(count):
        found = max(found, abs(column[i]))
    return found


def balance_miss(error: float, pull: float, g: float, entry: float, compliance: float) -> float:
    """Miss of the energy balance, of an idle pulley relative to the strain of the belt [-]."""
    exact = abs(pull * (g + 0.5 * pull * compliance))
    told = max(exact, 1e-6 * entry * abs(g), 1e-300)  # what the error is relative to
    scale = max(exact, 1e-6 * entry * (abs(g) + entry * compliance))
    return abs(error) * told / scale if scale > 0.0 else 0.0
