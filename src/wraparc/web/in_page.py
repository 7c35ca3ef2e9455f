"""What the drive page answers by itself while a slider moves: translated to `static/kernel.js`.

The server prepares the numbers of a drive (`wraparc.web.answers.prepared`), the page replaces those
that are moved. Verdicts stay with the server: the page shows none of its own.
"""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from wraparc.arc.kernel.quantities import BREAKAWAY, SOLVED, Buffer, Load
from wraparc.arc.summary import (
    Columns,
    Description,
    Summary,
    columns_of,
    geometry_of,
    kicked_loose,
    operating_point,
    stretches_outside,
    summary_of,
    too_steep,
)
from wraparc.drive.load_case import LEAST_TENSION, MOST_TENSION, pull_of_power, pull_of_torque
from wraparc.friction import TestedRange
from wraparc.friction.compact import CompactLaw

STEPS = 24


class Given(NamedTuple):
    """The numbers of a drive that one of its arcs depends on [SI]; nan where they are not given."""

    entry_tension: float
    exit_tension: float
    effective_tension: float
    torque: float
    power: float
    diameter: float
    wrap_angle: float
    overrun: float
    recovery: bool
    width: float
    modulus: float
    speed: float
    thickness: float
    shear_modulus: float
    compression_modulus: float
    wear_coefficient: float
    creep_limit: float
    steepest_fall: float


class Quick(NamedTuple):
    """One arc as the page shows it."""

    solved: bool
    summary: Summary
    profile: Columns
    outside: Buffer  # pairs of places [rad]
    stretches: int  # how many


def pull_of(given: Given) -> float:
    """Effective tension that a drive gives, nan where it gives both tensions [N]."""
    if given.torque == given.torque:
        return pull_of_torque(given.torque, given.diameter)
    if given.power == given.power:
        return pull_of_power(given.power, given.speed)
    return given.effective_tension


def description_of(given: Given) -> Description:
    """Arc of a drive by its numbers."""
    pull, entry, leaving = pull_of(given), given.entry_tension, given.exit_tension
    return Description(
        entry_tension=entry if entry == entry else leaving + pull,
        exit_tension=leaving if leaving == leaving else entry - pull,
        diameter=given.diameter,
        wrap_angle=given.wrap_angle,
        width=given.width,
        axial_stiffness=given.modulus * given.width,
        thickness=given.thickness,
        shear_modulus=given.shear_modulus,
        compression_modulus=given.compression_modulus,
        overrun=given.overrun,
        recovery=given.recovery,
        belt_speed=given.speed,
        wear_coefficient=given.wear_coefficient,
    )


def quick(law: CompactLaw, given: Given, tested: TestedRange | None, points: int) -> Quick | None:
    """Answer for one arc; None where it is for the server to say what is wrong."""
    arc = description_of(given)
    entry, leaving = arc.entry_tension, arc.exit_tension
    if not (min(entry, leaving) >= LEAST_TENSION and max(entry, leaving) <= MOST_TENSION):
        return None
    geometry = geometry_of(arc, law.onset_compliance)
    pressure = 2.0 * entry / (arc.width * arc.diameter)
    if too_steep(arc, given.steepest_fall) or kicked_loose(law, geometry, pressure):
        return None
    load = Load(entry, leaving, given.creep_limit, nan, nan, nan, given.steepest_fall)
    found, out, count = operating_point(law, geometry, load, STEPS, points)
    if not (found.outcome == SOLVED or found.outcome == BREAKAWAY):
        return None
    profile = columns_of(law, arc, found, out, count)
    outside, stretches = stretches_outside(tested, profile, count)
    summary = summary_of(law, arc, tested, found, out, count)
    return Quick(found.outcome == SOLVED, summary, profile, outside, stretches)
