"""What the checks of one arc compare, and how a list of them is ordered: plain numbers only.

`judge` makes its checks of them; the page of the calculator runs them translated while a slider
moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, inf, isfinite, isnan, nan, pi
from typing import NamedTuple

from wraparc.arc.kernel.quantities import Buffer

#: Pull over tension that counts as none [-].
IDLE = 1e-6
#: Pull against each other over the largest pull that counts as none [-].
SMALL_PULL = 1e-3
#: More than any margin.
BEHIND = 1e9
#: Difference of margins that is rounding: of alike ones the first governs on every machine.
ALIKE = 1e-9
#: Where what is missed without a number stands: before every margin.
NUMBERLESS = -2.0 * BEHIND
#: By how much what leads stands before its margin: before that too.
AHEAD = 4.0 * BEHIND
#: Part by which what a take-up holds may differ between load cases: belt mass on slopes, and what
#: runs between take-up and drive [-].
HELD = 0.1
#: Sizes that conveyor drives have, least and most [m, N/m, m/s, m].
WIDTHS, MODULI, SPEEDS, DIAMETERS = (0.2, 4.0), (1e5, 1e9), (0.05, 15.0), (0.15, 3.0)
#: Tensions that the belt of a conveyor has, over its width: from a light belt that just does not
#: sag to the strength of the strongest steel cord [N/m].
USUAL_TENSION = (0.5e3, 1e7)


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


#: Times the limit from which a value is told so, and not by a margin in percent.
FAR = 10.0


def times_of(value: float, limit: float) -> float:
    """How many times its limit a value is, where it is far from it; nan where it is not [-]."""
    if isnan(value) or isnan(limit) or limit <= 0.0 or not isfinite(value):
        return nan
    return value / limit if value / limit >= FAR else nan


def order_of(margin: float, missed: bool, binding: bool, advises: bool, leads: bool) -> float:
    """Place of a check among those of its level: the least governs, equal ones the first.

    What leads comes first whatever its margin, then what is missed without a number where it
    binds a design, advice last.
    """
    found = floor(margin / ALIKE + 0.5) * ALIKE if abs(margin) < BEHIND else margin
    if isnan(margin):
        found = NUMBERLESS if missed and binding else inf
    if leads:
        return min(found, BEHIND) - AHEAD
    return max(found, -BEHIND) + 2.0 * BEHIND if missed and advises else found


def idles(entry: float, leaving: float) -> bool:
    """Whether an arc hands nothing over: its pulley is not driven."""
    return abs(entry - leaving) <= IDLE * entry


def usual(value: float, least: float, most: float) -> bool:
    """Whether a size is one that conveyor drives have; one that is not given is."""
    return not (value < least or value > most)


def usual_tension(tension: float, width: float) -> bool:
    """Whether a tension is one that the belt of a conveyor has."""
    return usual(tension, USUAL_TENSION[0] * width, USUAL_TENSION[1] * width)


def usual_sizes(width: float, modulus: float, speed: float, diameter: float) -> bool:
    """Whether belt and pulley have sizes that those of a conveyor have."""
    belt = usual(width, WIDTHS[0], WIDTHS[1]) and usual(modulus, MODULI[0], MODULI[1])
    found = usual(speed, SPEEDS[0], SPEEDS[1]) and usual(diameter, DIAMETERS[0], DIAMETERS[1])
    return belt and found


def held_alike(least: float, most: float) -> bool:
    """Whether one take-up can hold both tensions."""
    return most - least <= HELD * most


class Compared(NamedTuple):
    """A number for each check of an arc: values, or limits; nan where there is none [SI]."""

    gross_slip: float
    design_standard: float
    creep: float
    belt_tension: float
    momentary_tension: float
    face_pressure: float
    bond_stress: float
    fatigue_stress: float
    tested_pressure_max: float
    tested_pressure_min: float
    tested_slip: float
    tested_slip_speed: float
    balance: float
    sag: float
    pulley_diameter: float
    share: float = nan  # of the rating, in percent
    passes: float = nan  # in an hour


class Criteria(NamedTuple):
    """What the arc of a drive of one pulley is held against, nan where it is not."""

    safety: float  # factor on gross slip [-]
    standard: float  # design friction [-]
    factor: float  # slack side over pull by a table of the standard [-]
    start: float  # factor on the pull that the standard is applied to [-]
    belt_tension: float  # per width [N/m]
    rating: float  # per width [N/m]
    face_pressure: float  # [Pa]
    bond_strength: float  # [Pa]
    fatigue_limit: float  # [Pa]
    slip_speed: float  # tested [m/s]
    balance: float  # [-]
    sag: float  # [N]
    pulley_diameter: float  # [m]
    fixed: bool  # whether the take-up holds the sum of both tensions
    behind: bool  # whether it holds the tension behind the pulley
    customary: bool  # whether the creep limit is the customary one
    wrap_angle: float  # where a table of the standard holds for this wrap alone [rad]
    wet: float = 0.0  # what wet leaves of dry friction, nan if not known; 0 where it is not dry [-]


def rise_alone(pull: float, fixed: bool, behind: bool) -> tuple[float, float]:
    """Growth of the tight and of the slack side of a single pulley with its pull [N].

    The take-up holds the slack side, the sum of both (`fixed`), or the belt behind the pulley.
    """
    size = abs(pull)
    lost = 0.5 * size if fixed else size if behind and pull < 0.0 else 0.0
    return size - lost, -lost


def rise_among(pulls: Sequence[float], index: int, fixed: bool, after: int) -> tuple[float, float]:
    """Growth of the tight and of the slack side of one of several pulleys with the pull of all [N].

    As `gross_slip.rises`; `after` is the pulley behind which the take-up stands, -1 for none.
    """
    total, mine = sum(pulls), pulls[index]
    ahead = sum(pulls[:index])
    behind = sum(pulls[index + 1 :])
    lost = 0.5 * abs(total) if fixed else 0.0
    if not fixed and after >= 0:
        lost = sum(pulls[after + 1 :]) if total >= 0.0 else -sum(pulls[: after + 1])
    entry = (mine + behind if total >= 0.0 else -ahead) - lost
    leaving = (behind if total >= 0.0 else -ahead - mine) - lost
    return (entry, leaving) if mine >= 0.0 else (leaving, entry)


def pull_against(pulls: Sequence[float]) -> float:
    """Pull of drives against each other, 0 where they work together [N]."""
    small = SMALL_PULL * max(abs(pull) for pull in pulls)
    if not (min(pulls) < -small and max(pulls) > small):
        return 0.0
    return min(sum(max(p, 0.0) for p in pulls), sum(max(-p, 0.0) for p in pulls))


def wrap_pressure_of(tension: float, width: float, diameter: float) -> float:
    """Pressure of the belt on the pulley, 2 T/(B D) [Pa]."""
    return 2.0 * tension / (width * diameter)


def asked_slack(factor: float, start: float, pull: float) -> float:
    """Slack-side tension by a wrap factor, Cw times the pull that is designed for [N]."""
    return factor * start * abs(pull)


def passes_an_hour(speed: float, diameter: float) -> float:
    """How often the pulley turns in an hour [-]."""
    return 3600.0 * speed / (pi * diameter)


def largest(column: Buffer, count: int) -> float:
    """Largest magnitude in a column."""
    found = 0.0
    for i in range(count):
        found = max(found, abs(column[i]))
    return found


def steepest(position: Buffer, slip: Buffer, count: int, radius: float, length: float) -> float:
    """Largest change of the slip per length of arc [-]; nan without a stretch of arc."""
    found, least = nan, 1e-9 * length
    for i in range(1, count):
        step = (position[i] - position[i - 1]) * radius
        if step > least:
            change = abs(slip[i] - slip[i - 1]) / step
            if not change <= found:  # so also where nothing is found yet
                found = change
    return found


def balance_miss(error: float, pull: float, g: float, entry: float, compliance: float) -> float:
    """Miss of the energy balance, of an idle pulley relative to the strain of the belt [-]."""
    exact = abs(pull * (g + 0.5 * pull * compliance))
    told = max(exact, 1e-6 * entry * abs(g), 1e-300)  # what the error is relative to
    scale = max(exact, 1e-6 * entry * (abs(g) + entry * compliance))
    return abs(error) * told / scale if scale > 0.0 else 0.0
