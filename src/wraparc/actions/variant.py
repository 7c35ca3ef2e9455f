"""A drive with some values changed, and what a judgement of it comes to: plain numbers only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, floor, log10
from typing import NamedTuple

#: Numbers of three digits in a decade.
_DECADE = 900
#: Part by which a number may be over one of three digits and is still that [-].
_ROUNDING = 1e-9
#: What may be changed, in the order in which it is tried.
RAISE, LOWER, WRAP, LAGGING = "raise", "lower", "wrap", "lagging"
RATING, STRENGTH, DIAMETER, SPACING = "rating", "strength", "diameter", "spacing"


class Variant(NamedTuple):
    """What is other than in the drive as it is; 0, or an empty name, where nothing is.

    Attributes
    ----------
    tension
        Of the belt at the take-up; all tensions shift alike [N].
    wrap
        Wrap angle of the only pulley [deg].
    lagging
        Name in the catalogue, of every pulley that is changed.
    rating, strength
        Of the belt [N/m].
    diameter
        Of every pulley that is changed [m].
    spacing
        Of the idlers behind the drive [m].
    pull
        Factor on the effective tension, T2 fixed [-].
    """

    tension: float = 0.0
    wrap: float = 0.0
    lagging: str = ""
    rating: float = 0.0
    strength: float = 0.0
    diameter: float = 0.0
    spacing: float = 0.0
    pull: float = 0.0


def key_of(variant: Variant) -> str:
    """Return what tells a variant from every other one."""
    return " ".join([str(value) for value in variant])


class Outcome(NamedTuple):
    """What the judgement of a variant comes to.

    Attributes
    ----------
    possible
        Whether there is such a drive.
    levels
        Rank of the level by name of every check that is missed.
    passed
        Names of the checks that pass at every place where they are made.
    used
        By name of a missed check, value over a maximum or minimum over value, at its worst [-].
    creep
        Maximum creep at an exit [m].
    least, most
        Minimum and maximum tension at the take-up by its checks, 0 where none is known [N].
    """

    possible: bool
    levels: Mapping[str, int]
    passed: Sequence[str] = ()
    used: Mapping[str, float] = {}
    creep: float = 0.0
    least: float = 0.0
    most: float = 0.0


#: Of a variant that is no drive.
IMPOSSIBLE = Outcome(False, {})


class Task(NamedTuple):
    """What the search begins with.

    Attributes
    ----------
    now
        Outcome of the drive as it is.
    first, kinds
        What may be changed: for the governing check, and for any that is missed.
    tension, lowest, highest
        At the take-up: as it is, and within what it is tried [N].
    wrap
        Wrap angle of the only pulley, 0 where it is not to be changed [deg].
    laggings
        Names of the catalogue that are tried.
    rating, strength, diameter, spacing
        As they are; 0 where they are not known [N/m, N/m, m, m].
    points
        Tensions that are tried between the ends; 0 for those alone that the checks state.
    wrap_step
        Between the wraps that are tried first [deg].
    splits
        Values that are tried at once between one that leaves more and one that leaves as little.
    within
        Rounded tensions within which the nearest one is found.
    """

    now: Outcome
    first: tuple[str, ...]
    kinds: tuple[str, ...]
    tension: float
    lowest: float
    highest: float
    wrap: float
    laggings: tuple[str, ...]
    rating: float
    strength: float
    diameter: float
    spacing: float
    points: int
    wrap_step: int
    splits: int
    within: int


def rung_above(value: float) -> int:
    """Return the place of the least number of three digits that is not below a value."""
    power = floor(log10(value)) - 2
    digits = ceil(value / 10.0**power * (1.0 - _ROUNDING))
    return _DECADE * power + digits - 100


def rung_below(value: float) -> int:
    """Return the place of the largest number of three digits that is not above a value."""
    power = floor(log10(value)) - 2
    digits = floor(value / 10.0**power * (1.0 + _ROUNDING))
    return _DECADE * power + digits - 100


def at_rung(place: int) -> float:
    """Return the number of three digits at a place."""
    power = place // _DECADE
    digits = place - _DECADE * power + 100
    return digits * 10.0**power if power >= 0 else digits / 10.0**-power


def rounded_up(value: float) -> float:
    """Return a value rounded up to three digits."""
    return at_rung(rung_above(value))


def rounded_down(value: float) -> float:
    """Return a value rounded down to three digits."""
    return at_rung(rung_below(value))
