"""One arc of a batch by the solver of one arc: numbers in, numbers out."""

from __future__ import annotations

from math import log, nan

from wraparc.arc.answer import operating_point
from wraparc.arc.capacity import (
    CAPACITIES,
    CREEP_LIMIT,
    GROSS_SLIP,
    LEAST,
    TESTED_SLIP,
    find_capacities,
)
from wraparc.arc.collocation import compliance_of
from wraparc.arc.profile import Range, along_slip, read
from wraparc.arc.quantities import REFUSED, SOLVED, Buffer, Geometry, Load
from wraparc.arc.summary import overrun_loosens
from wraparc.friction.compact import CompactLaw

#: what is wanted of an arc, to be added up with the capacities
TENSIONS = 1
RATIO = 32  # of the operating point creep and creep ratio alone, and how that answers to tensions
EVERYTHING = TENSIONS + CAPACITIES

#: numbers of one arc, as they are read
INPUTS = (*Geometry._fields[:8], *Load._fields)

# places in a row of results
(
    OUTCOME,
    LOG_RATIO,  # ln(T2/T1)
    EXIT_CREEP,
    EXIT_SLIP,
    EXIT_STRESS,
    ENTRY_STRESS,
    WORK,  # int tau dx [J/m2]
    CREEP_RATIO,  # g
    STUCK_LENGTH,
    PEAK_STRESS,
    PEAK_AT,
    ACTIVE,
    OUTSIDE,
    CREEP_CAPACITY,  # ln(tight/slack)
    SLIP_CAPACITY,
    GROSS_CAPACITY,
    GROSS_CREEP,
    LEAST_SLACK,  # [N]
    MOST_PULL,  # [N]
    LARGEST_SLIP,  # along the arc [m]
    STEEPEST_SLIP,  # along the arc [-]
    RATIO_BY_ENTRY,  # dg/dT1 and dg/dT2 [1/N]; nan where not known
    RATIO_BY_EXIT,
) = range(23)
FOUND_NUMBERS = 23

#: places that each part fills
PLACES = {
    TENSIONS: (*range(OUTCOME, OUTSIDE + 1), LARGEST_SLIP, STEEPEST_SLIP),
    RATIO: (OUTCOME, EXIT_CREEP, CREEP_RATIO, RATIO_BY_ENTRY, RATIO_BY_EXIT),
    CREEP_LIMIT: (CREEP_CAPACITY,),
    TESTED_SLIP: (SLIP_CAPACITY,),
    LEAST: (LEAST_SLACK, MOST_PULL),
    GROSS_SLIP: (GROSS_CAPACITY, GROSS_CREEP),
}


def geometry_of(given: Buffer) -> Geometry:
    """What of an arc does not depend on its tensions, from its row of `INPUTS`."""
    g = given
    return Geometry(g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], None)


def load_of(given: Buffer) -> Load:
    """What an arc is asked, from its row of `INPUTS`."""
    g = given
    return Load(g[8], g[9], g[10], g[11], g[12], g[13], g[14])


def tensions_of_row(law: CompactLaw, given: Buffer, parts: int, found: Buffer) -> None:
    """Begin the row of an arc, and find its operating point if that is wanted.

    Parameters
    ----------
    law
        Its friction law.
    given
        Its numbers, in the order of `INPUTS`.
    parts
        Which results are wanted; the others become nan.
    found
        A row of results.
    """
    for k in range(FOUND_NUMBERS):
        found[k] = nan
    geometry, load = geometry_of(given), load_of(given)
    found[OUTCOME] = SOLVED
    if refused(law, geometry, load):
        found[OUTCOME] = REFUSED
    elif parts & (TENSIONS | RATIO):
        find_tensions(law, geometry, load, found)


def capacities_of_row(law: CompactLaw, given: Buffer, parts: int, found: Buffer) -> None:
    """Find the capacities that are wanted of an arc whose row is begun."""
    if not parts & CAPACITIES or found[OUTCOME] == REFUSED:
        return
    carried = find_capacities(law, geometry_of(given), load_of(given), parts)
    found[CREEP_CAPACITY], found[SLIP_CAPACITY] = carried.creep_limit, carried.tested_slip
    found[GROSS_CAPACITY], found[GROSS_CREEP] = carried.gross_slip, carried.gross_creep
    found[LEAST_SLACK], found[MOST_PULL] = carried.least_slack, carried.most_pull


def refused(law: CompactLaw, geometry: Geometry, load: Load) -> bool:
    """Whether slip or creep would not be unique, as `wraparc.arc.WrapArc` says in words."""
    top = max(load.entry_tension, load.exit_tension) / (geometry.width * geometry.radius)
    if geometry.shear * top * load.steepest_fall <= -1.0:
        return True
    return overrun_loosens(law, geometry, load.entry_tension / (geometry.width * geometry.radius))


def find_tensions(law: CompactLaw, geometry: Geometry, load: Load, found: Buffer) -> None:
    """Solve for the tensions and read the course."""
    solved = operating_point(law, geometry, load.entry_tension, load.exit_tension)
    found[OUTCOME] = solved.outcome
    if solved.outcome != SOLVED:
        return
    met = solved.met
    if met.rest == 0.0:
        first = met.slopes.first
        found[RATIO_BY_ENTRY] = 1.0 / first - compliance_of(geometry)
        found[RATIO_BY_EXIT] = -met.slopes.first_goal / first
    told = read(geometry, met, Range(load.pressure_min, load.pressure_max, load.slip_max))
    shear = geometry.shear
    found[LOG_RATIO] = log(load.exit_tension / load.entry_tension)
    found[EXIT_SLIP], found[EXIT_CREEP], found[EXIT_STRESS] = told.slip, told.creep, told.stress
    found[WORK] = told.loss - 0.5 * shear * (told.stress**2 - told.entry_stress**2)
    found[CREEP_RATIO], found[ENTRY_STRESS] = told.creep_ratio, told.entry_stress
    found[STUCK_LENGTH], found[ACTIVE] = told.stuck, told.active
    found[PEAK_STRESS], found[PEAK_AT], found[OUTSIDE] = told.peak, told.peak_at, told.outside
    found[LARGEST_SLIP], found[STEEPEST_SLIP] = along_slip(geometry, met)
