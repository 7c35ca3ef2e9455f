"""What the drive page answers by itself while a slider moves: translated to `static/kernel.js`.

The server prepares the numbers of a drive (`wraparc.web.answers.prepared`) and the words of its
checks (`wraparc.web.answers.judged`), the page replaces the numbers that are moved.
"""

from __future__ import annotations

from math import copysign, inf, nan
from typing import NamedTuple

from wraparc.arc.answer import operating_point
from wraparc.arc.capacity import CAPACITIES, find_capacities, highest_tight
from wraparc.arc.gross_slip import Line
from wraparc.arc.profile import steepest_slip
from wraparc.arc.quantities import BREAKAWAY, SOLVED, Buffer, Load
from wraparc.arc.sliding import (
    Loaded,
    at_limits,
    lift_for_safety,
    pull_at_sliding,
    wet_creep,
    with_friction,
)
from wraparc.arc.summary import (
    CapacityNumbers,
    Columns,
    Description,
    Summary,
    capacity_numbers,
    columns_of,
    geometry_of,
    overrun_loosens,
    pressure_of,
    solved_arc,
    stretches_outside,
    summary_of,
    too_steep,
)
from wraparc.checks.least_numbers import Pull, least_for_creep, least_for_slip
from wraparc.checks.numbers import largest
from wraparc.drive.load_case import (
    LEAST_TENSION,
    MOST_TENSION,
    Resultant,
    exit_behind,
    pull_of_power,
    pull_of_torque,
    resultant,
)
from wraparc.drive.pitch import centrifugal_force
from wraparc.drive.pull import idles
from wraparc.friction import TestedRange
from wraparc.friction.compact import CompactLaw


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
    pitch_offset: float
    cover_compliance: float
    mass: float
    slip_with_shear: bool
    belt_speed: float  # where the belt meets the pulley, nan where that is `speed`


def described(given: Given) -> tuple[float, float]:
    """Entry and exit tension of an arc by its numbers [N]."""
    arc = description_of(given)
    return arc.entry_tension, arc.exit_tension


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
        return pull_of_torque(given.torque, given.diameter + 2.0 * given.pitch_offset)
    if given.power == given.power:
        return pull_of_power(given.power, given.speed)
    return given.effective_tension


def description_of(given: Given) -> Description:
    """Arc of a drive by its numbers."""
    pull, entry, leaving = pull_of(given), given.entry_tension, given.exit_tension
    first = entry if entry == entry else leaving + pull
    return Description(
        entry_tension=first,
        exit_tension=exit_behind(first, leaving if leaving == leaving else entry - pull),
        diameter=given.diameter,
        wrap_angle=given.wrap_angle,
        width=given.width,
        axial_stiffness=given.modulus * given.width,
        thickness=given.thickness,
        shear_modulus=given.shear_modulus,
        compression_modulus=given.compression_modulus,
        overrun=given.overrun,
        recovery=given.recovery,
        belt_speed=given.belt_speed if given.belt_speed == given.belt_speed else given.speed,
        wear_coefficient=given.wear_coefficient,
        shear_compliance=(0.0 if given.slip_with_shear else given.thickness / given.shear_modulus)
        + given.cover_compliance,
        pitch_offset=given.pitch_offset,
        centrifugal=lift_of(given),
    )


def lift_of(given: Given) -> float:
    """M v^2 of a belt [N]; 0 where its mass or its speed is not known."""
    force = centrifugal_force(given.mass, given.speed)
    return force if force == force else 0.0


def refused(law: CompactLaw, arc: Description, fall: float) -> bool:
    """Whether it is for the server to say what is wrong with an arc."""
    entry, leaving = arc.entry_tension, arc.exit_tension
    if not (min(entry, leaving) >= LEAST_TENSION and max(entry, leaving) <= MOST_TENSION):
        return True
    if arc.centrifugal >= min(entry, leaving):
        return True
    geometry = geometry_of(arc)
    pressure = pressure_of(arc, entry)
    return too_steep(arc, fall) or overrun_loosens(law, geometry, pressure)


def load_of(given: Given, arc: Description, tested: TestedRange | None) -> Load:
    """Tensions and limits of an arc."""
    low = high = slip = nan
    if tested is not None:
        low, high, slip = tested.pressure_min, tested.pressure_max, tested.slip_max
    limit, fall = given.creep_limit, given.steepest_fall
    lift = arc.centrifugal
    return Load(arc.entry_tension - lift, arc.exit_tension - lift, limit, low, high, slip, fall)


def quick(law: CompactLaw, given: Given, tested: TestedRange | None, points: int) -> Quick | None:
    """Answer for one arc; None where it is for the server to say what is wrong."""
    arc = description_of(given)
    if refused(law, arc, given.steepest_fall):
        return None
    geometry = geometry_of(arc)
    load = load_of(given, arc, None)
    found, out, count = solved_arc(law, geometry, load, points)
    if not (found.outcome == SOLVED or found.outcome == BREAKAWAY):
        return None
    profile = columns_of(law, arc, found.met.rest, out, count)
    outside, stretches = stretches_outside(tested, profile, count)
    summary = summary_of(geometry, arc, tested, found)
    return Quick(found.outcome == SOLVED, summary, profile, outside, stretches)


class Criteria(NamedTuple):
    """What the checks ask of the grip of an arc."""

    safety: float  # factor on gross slip [-]
    tight_rise: float  # growth of the tight side with the pull of all [N]
    slack_rise: float
    cover: float  # compliance of a cover that the slip of the law may hold or not [m/Pa]
    strength: float  # breaking strength of the belt, nan if not known [N]
    pulley_mass: float  # nan if not known [kg]
    wet: float  # wet friction over dry friction, nan if not known; 0 for no estimate [-]


class Found(NamedTuple):
    """What the checks ask of one arc, and what it could carry."""

    solved: bool
    summary: Summary
    capacities: CapacityNumbers
    place: float  # where the belt slides, see `Sliding`
    cause: int
    lift: float  # of all tensions, for the safety factor [N]
    least_for_slip: float  # slack-side tension that keeps the slip within the tests [N]
    least_when_covered: float  # that for the creep with the cover in series [N]
    least_when_wet: float  # that for the creep when wet [N]
    largest_slip: float  # [m]
    slip_speed: float  # [m/s]
    covered_creep: float  # with the cover in series, see `ArcResult` [m]
    wet: float  # creep when wet: inf in gross slip, nan if not known [m]
    loads: Resultant


def judged(
    law: CompactLaw, given: Given, tested: TestedRange | None, criteria: Criteria, points: int
) -> Found | None:
    """Numbers of the checks of one arc; None where they are for the server to find."""
    arc = description_of(given)
    entry, leaving = arc.entry_tension, arc.exit_tension
    if refused(law, arc, given.steepest_fall) or idles(entry, leaving):
        return None
    geometry, load = geometry_of(arc), load_of(given, arc, tested)
    found, out, count = solved_arc(law, geometry, load, points)
    if not (found.outcome == SOLVED or found.outcome == BREAKAWAY):
        return None
    profile = columns_of(law, arc, found.met.rest, out, count)
    carried = find_capacities(law, geometry, load, CAPACITIES)
    loaded = Loaded(law, geometry, load, given.steepest_fall < 0.0 and carried.gross_creep != inf)
    tight, slack = max(entry, leaving) - arc.centrifugal, min(entry, leaving) - arc.centrifugal
    line, begin = Line(tight, slack, criteria.tight_rise, criteria.slack_rise), at_limits(loaded)
    sliding = pull_at_sliding(loaded, line, begin)
    if sliding.place != sliding.place:
        return None
    by_slip = covered = when_wet = nan
    top = highest_tight(load.pressure_max, arc.width * (0.5 * arc.diameter), tight)
    pull, limit = Pull(abs(entry - leaving), tight, top), given.creep_limit
    if criteria.cover != 0.0:
        series = geometry._replace(shear=geometry.shear + criteria.cover)
        covered = least_for_creep(law, series, pull, limit) + arc.centrifugal
    if criteria.wet > 0.0:
        wetted = with_friction(geometry, criteria.wet)
        when_wet = least_for_creep(law, wetted, pull, limit) + arc.centrifugal
    if load.slip_max < limit:
        by_slip = least_for_slip(law, geometry, pull, load.slip_max) + arc.centrifugal
    runs = arc.belt_speed * 0.5 * arc.diameter / (0.5 * arc.diameter + arc.pitch_offset)
    return Found(
        solved=found.outcome == SOLVED,
        summary=summary_of(geometry, arc, tested, found),
        capacities=capacity_numbers(arc, carried),
        place=sliding.place,
        cause=sliding.cause,
        lift=lift_for_safety(loaded, criteria.safety, criteria.tight_rise, begin),
        least_for_slip=by_slip,
        least_when_covered=covered,
        least_when_wet=when_wet,
        largest_slip=largest(profile.slip, count),
        slip_speed=runs * steepest_slip(geometry, found.met) if count > 0 else nan,
        covered_creep=covered_creep(law, given, criteria.cover),
        wet=wet_creep(loaded, criteria.wet) if criteria.wet != 0.0 else nan,
        loads=resultant(entry, leaving, arc.wrap_angle, criteria.strength, criteria.pulley_mass),
    )


def covered_creep(law: CompactLaw, given: Given, cover: float) -> float:
    """Creep at the exit with a cover in series, see `ArcResult.covered_creep` [m].

    Parameters
    ----------
    law, given
        The arc.
    cover
        Compliance of the cover, 0 for none [m/Pa].
    """
    if cover == 0.0:
        return nan
    arc = description_of(given._replace(cover_compliance=given.cover_compliance + cover))
    load = load_of(given, arc, None)
    geometry = geometry_of(arc)
    found = operating_point(law, geometry, load.entry_tension, load.exit_tension)
    return found.met.course.creep[-1] if found.outcome == SOLVED else copysign(inf, geometry.side)
