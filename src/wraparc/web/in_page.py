"""What the drive page answers by itself while a slider moves: translated to `static/kernel.js`.

The server prepares the numbers of a drive (`wraparc.web.answers.prepared`) and the words of its
checks (`wraparc.web.answers.judged`), the page replaces the numbers that are moved.
"""

from __future__ import annotations

from math import inf, nan
from typing import NamedTuple

from wraparc.arc.answer import operating_point
from wraparc.arc.capacity import CAPACITIES, find_capacities, highest_tight
from wraparc.arc.constant_friction import wrap_factor
from wraparc.arc.gross_slip import Line
from wraparc.arc.quantities import BREAKAWAY, SOLVED, Buffer, Load
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
from wraparc.checks.least_numbers import Pull, least_for_slip
from wraparc.checks.numbers import (
    Compared,
    Criteria,
    Sizes,
    as_printed,
    asked_slack,
    balance_miss,
    idles,
    largest,
    rise_alone,
    safety_of,
    steepest,
    usual_sizes,
)
from wraparc.checks.sliding import (
    NOT_CARRIED,
    AtLimit,
    Loaded,
    at_limits,
    lift_for_safety,
    pull_at_sliding,
    wet_creep,
)
from wraparc.drive import CREEP_LIMIT
from wraparc.drive.load_case import (
    LEAST_TENSION,
    MOST_TENSION,
    Resultant,
    exit_behind,
    pull_of_power,
    pull_of_torque,
    resultant,
)
from wraparc.drive.pitch import centrifugal_force, turns_an_hour
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


#: Why the page cannot judge an arc.
STEEP, IDLE, UNUSUAL = 1, 2, 3


def sizes_of(given: Given, arc: Description, criteria: Criteria) -> Sizes:
    """What is given of an arc, to be compared with usual sizes."""
    entry, leaving = arc.entry_tension, arc.exit_tension
    return Sizes(
        width=given.width,
        modulus=given.modulus,
        speed=given.speed,
        diameter=given.diameter,
        idle_wrap=nan,  # those that do not pull are for the server
        wrap_angle=given.wrap_angle,
        creep_limit=given.creep_limit,
        overrun=given.overrun,
        thickness=given.thickness,
        shear_modulus=given.shear_modulus,
        compression_modulus=given.compression_modulus,
        rating=criteria.rating,
        strength=criteria.strength,
        bond_strength=criteria.bond_strength,
        fatigue_limit=criteria.fatigue_limit,
        face_pressure=criteria.face_pressure,
        least_diameter=criteria.pulley_diameter,
        sag=criteria.sag,
        entry=entry,
        leaving=leaving,
        pull=entry - leaving if criteria.alone and not idles(entry, leaving) else nan,
        mass=given.mass,
    )


def unjudged(law: CompactLaw, given: Given, criteria: Criteria) -> int:
    """Why the page cannot judge an arc; 0 where it can."""
    arc = description_of(given)
    if refused(law, arc, given.steepest_fall):
        return STEEP
    if idles(arc.entry_tension, arc.exit_tension):
        return IDLE
    return 0 if usual_sizes(sizes_of(given, arc, criteria)) else UNUSUAL


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


def covered_creep(law: CompactLaw, given: Given, cover: float) -> float:
    """Size of the creep at the exit with a cover in series, see `ArcResult.covered_creep` [m].

    Parameters
    ----------
    law, given
        The arc.
    cover
        Compliance of the cover [m/Pa].
    """
    arc = description_of(given._replace(cover_compliance=given.cover_compliance + cover))
    load = load_of(given, arc, None)
    geometry = geometry_of(arc)
    found = operating_point(law, geometry, load.entry_tension, load.exit_tension)
    return abs(found.met.course.creep[-1]) if found.outcome == SOLVED else inf


class Judged(NamedTuple):
    """What the checks of one arc compare, and what it could carry."""

    solved: bool
    summary: Summary
    capacities: CapacityNumbers
    values: Compared
    limits: Compared
    held: float  # what the take-up holds [N]
    asked: Asked
    loads: Resultant
    cause: int  # what comes first where the belt slides
    wet: float  # creep when wet: inf in gross slip, nan if not known, negative where not dry [m]


class Among(NamedTuple):
    """What a pulley shares with the others on its belt [N]."""

    end: float  # tension at the take-up
    held: float  # what the take-up holds
    slack_end: float  # tension of the belt that leaves all pulleys slack
    sagging: float  # the same, by the tensions at both ends
    tight_rise: float  # growth of the tight side with the pull of all
    slack_rise: float


def alone(arc: Description, criteria: Criteria) -> Among:
    """The same of a pulley that is alone on its belt."""
    entry, leaving = arc.entry_tension, arc.exit_tension
    slack = leaving if entry >= leaving else entry
    end = leaving if criteria.behind else slack
    held = entry + leaving if criteria.fixed else end
    tight_rise, slack_rise = rise_alone(entry - leaving, criteria.fixed, criteria.behind)
    return Among(end, held, slack, slack, tight_rise, slack_rise)


def judged(
    law: CompactLaw, given: Given, tested: TestedRange | None, criteria: Criteria, points: int,
    among: Among | None = None,
) -> Judged | None:  # fmt: skip
    """Numbers of the checks of one arc; None where they are for the server to find."""
    arc = description_of(given)
    others = alone(arc, criteria) if among is None else among
    entry, leaving = arc.entry_tension, arc.exit_tension
    if refused(law, arc, given.steepest_fall) or idles(entry, leaving):
        return None
    if given.creep_limit == CREEP_LIMIT:
        if not criteria.customary:
            return None
    elif criteria.customary:
        return None
    if criteria.wrap_angle == criteria.wrap_angle and arc.wrap_angle != criteria.wrap_angle:
        return None
    if not usual_sizes(sizes_of(given, arc, criteria)):
        return None
    geometry, load = geometry_of(arc), load_of(given, arc, tested)
    found, out, count = solved_arc(law, geometry, load, points)
    if not (found.outcome == SOLVED or found.outcome == BREAKAWAY):
        return None
    profile = columns_of(law, arc, found.met.rest, out, count)
    summary = summary_of(geometry, arc, tested, found)
    carried = find_capacities(law, geometry, load, CAPACITIES)
    solved = found.outcome == SOLVED
    limits = limits_of(given, arc, tested, criteria)
    loaded = Loaded(law, geometry, load, given.steepest_fall < 0.0 and carried.gross_creep != inf)
    pitch = 0.5 * arc.diameter + arc.pitch_offset
    tight, slack = max(entry, leaving) - arc.centrifugal, min(entry, leaving) - arc.centrifugal
    line, begin = Line(tight, slack, others.tight_rise, others.slack_rise), at_limits(loaded)
    sliding = pull_at_sliding(loaded, line, begin)
    if sliding.place != sliding.place:
        return None
    values = Compared(
        gross_slip=sliding.place if solved else min(sliding.place, NOT_CARRIED),
        design_standard=min(entry, leaving),
        creep=abs(summary.exit_creep),
        belt_tension=max(entry, leaving),
        momentary_tension=max(entry, leaving),
        belt_safety=safety_of(
            criteria.strength * arc.width, max(entry, leaving), criteria.belt_safety
        ),
        face_pressure=pressure_of(arc, max(entry, leaving)),
        bond_stress=summary.peak_shear_stress,
        fatigue_stress=summary.peak_shear_stress,
        tested_pressure_max=pressure_of(arc, max(entry, leaving)),
        tested_pressure_min=pressure_of(arc, min(entry, leaving)),
        tested_slip=largest(profile.slip, count),
        tested_slip_speed=arc.belt_speed
        * steepest(
            profile.position, profile.slip, count, pitch, pitch * arc.wrap_angle,
        ),
        balance=balance_miss(
            summary.identity_error, summary.effective_tension, summary.entry_creep_ratio, entry,
            geometry.compliance,
        ),
        sag=others.sagging,
        pulley_diameter=arc.diameter,
        share=100.0 * max(entry, leaving) / (criteria.rating * arc.width),
        passes=turns_an_hour(arc.belt_speed, pitch),
    )  # fmt: skip
    return Judged(
        solved,
        summary,
        capacity_numbers(arc, carried),
        values,
        limits,
        others.held,
        asked_of(
            loaded,
            begin,
            arc,
            carried.least_slack + arc.centrifugal,
            limits,
            given,
            criteria.safety,
            others,
        ),
        resultant(
            entry, leaving, arc.wrap_angle, criteria.strength * arc.width, criteria.pulley_mass
        ),
        sliding.cause,
        wet_creep(loaded, criteria.wet) if criteria.wet != 0.0 else -1.0,
    )


class Asked(NamedTuple):
    """Tension at the take-up that each check asks for or allows; nan where none does [N]."""

    creep: float
    tested_slip: float
    design_standard: float
    gross_slip: float
    tested_pressure_min: float
    tested_pressure_max: float
    face_pressure: float
    belt_tension: float
    sag: float
    given: float


def asked_of(
    loaded: Loaded, begin: list[AtLimit], arc: Description, least: float, limits: Compared,
    given: Given, factor: float, among: Among,
) -> Asked:  # fmt: skip
    """What the checks of an arc ask of the take-up, its pull held."""
    entry, leaving, end = arc.entry_tension, arc.exit_tension, among.end
    tight, slack = max(entry, leaving), min(entry, leaving)
    area, flung = arc.width * (0.5 * arc.diameter), arc.centrifugal
    top = highest_tight(limits.tested_pressure_max, area, tight - flung)
    of, by_slip = Pull(abs(entry - leaving), tight - flung, top), nan
    if limits.tested_slip < given.creep_limit:
        by_slip = flung + least_for_slip(loaded.law, loaded.geometry, of, limits.tested_slip)
    lift = lift_for_safety(loaded, factor, among.tight_rise, begin)
    of_slack, of_tight = end - slack, end - tight
    return Asked(
        creep=of_slack + (least if least == least else inf),
        tested_slip=of_slack + by_slip,
        design_standard=of_slack + limits.design_standard,
        gross_slip=end + (lift if lift == lift else inf),
        tested_pressure_min=limits.tested_pressure_min * area + flung + of_slack,
        tested_pressure_max=limits.tested_pressure_max * area + flung + of_tight,
        face_pressure=limits.face_pressure * area + flung + of_tight,
        belt_tension=of_tight + limits.belt_tension,
        sag=limits.sag + end - among.slack_end,
        given=end,
    )


def limits_of(
    given: Given, arc: Description, tested: TestedRange | None, criteria: Criteria
) -> Compared:
    """What the checks of an arc allow."""
    low = high = slip = nan
    if tested is not None:
        low, high, slip = tested.pressure_min, tested.pressure_max, tested.slip_max
    pull, factor = arc.entry_tension - arc.exit_tension, criteria.factor
    if factor != factor:
        factor = wrap_factor(criteria.standard, arc.wrap_angle)
        if criteria.printed:
            factor = as_printed(factor)
    return Compared(
        gross_slip=criteria.safety,
        design_standard=asked_slack(factor, criteria.start, pull),
        creep=given.creep_limit,
        belt_tension=criteria.belt_tension * arc.width,
        momentary_tension=criteria.belt_tension * arc.width,
        belt_safety=criteria.belt_safety,
        face_pressure=criteria.face_pressure,
        bond_stress=criteria.bond_strength,
        fatigue_stress=criteria.fatigue_limit,
        tested_pressure_max=high,
        tested_pressure_min=low,
        tested_slip=slip,
        tested_slip_speed=criteria.slip_speed,
        balance=criteria.balance,
        sag=criteria.sag,
        pulley_diameter=criteria.pulley_diameter,
    )
