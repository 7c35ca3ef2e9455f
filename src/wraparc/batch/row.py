"""One arc of a batch by the scalar kernel: numbers in, numbers out.

Rows of numbers around :mod:`wraparc.arc.kernel.answer`, in functions of plain numbers and buffers
only, so that the same source runs in the interpreter and compiled.
"""

from __future__ import annotations

from math import nan

from wraparc.arc.kernel.answer import (
    CAPACITIES,
    CREEP_LIMIT,
    GROSS_SLIP,
    LEAST,
    TESTED_SLIP,
    answer,
    find_capacities,
    profile_of,
    profile_size,
)
from wraparc.arc.kernel.effort import jumps
from wraparc.arc.kernel.quantities import (
    REFUSED,
    SOLVED,
    Buffer,
    Geometry,
    Load,
    Parameters,
    Shot,
    parameters_at,
    zeros,
)
from wraparc.arc.kernel.stick import onset_stress
from wraparc.arc.profile import (
    active_length,
    largest_slip,
    peak_stress,
    share_outside,
    steepest_slip,
)
from wraparc.friction.compact import CompactLaw

#: what is wanted of an arc, to be added up with the capacities
TENSIONS = 1
EVERYTHING = TENSIONS + CAPACITIES

#: numbers that a kernel reads for one arc
INPUTS = (*Geometry._fields, *Load._fields)

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
    STEEPEST_SLIP,  # along the arc [-]; of the lanes a bound from below, see `engineering`
) = range(21)
FOUND_NUMBERS = 21

#: places that each part fills
PLACES = {
    TENSIONS: (*range(OUTCOME, OUTSIDE + 1), LARGEST_SLIP, STEEPEST_SLIP),
    CREEP_LIMIT: (CREEP_CAPACITY,),
    TESTED_SLIP: (SLIP_CAPACITY,),
    LEAST: (LEAST_SLACK, MOST_PULL),
    GROSS_SLIP: (GROSS_CAPACITY, GROSS_CREEP),
}


def geometry_of(given: Buffer) -> Geometry:
    """What of an arc does not depend on its tensions, from its row of `INPUTS`."""
    g = given
    return Geometry(g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8])


def load_of(given: Buffer) -> Load:
    """What an arc is asked, from its row of `INPUTS`."""
    g = given
    return Load(g[9], g[10], g[11], g[12], g[13], g[14], g[15])


def tensions_of_row(
    law: CompactLaw, given: Buffer, parts: int, steps: int, points: int, found: Buffer
) -> None:
    """Begin the row of an arc, and find its operating point if that is wanted.

    Parameters
    ----------
    law
        Its friction law.
    given
        Its numbers, in the order of `INPUTS`.
    parts
        Which results are wanted; the others become nan.
    steps, points
        Mesh steps, and equal parts of the wrap at which its profile is looked at.
    found
        A row of results.
    """
    for k in range(FOUND_NUMBERS):
        found[k] = nan
    geometry, load = geometry_of(given), load_of(given)
    found[OUTCOME] = SOLVED
    if refused(law, geometry, load):
        found[OUTCOME] = REFUSED
    elif parts & TENSIONS:
        find_tensions(law, geometry, load, steps, points, found)


def capacities_of_row(
    law: CompactLaw, given: Buffer, parts: int, steps: int, found: Buffer
) -> None:
    """Find the capacities that are wanted of an arc whose row is begun."""
    if not parts & CAPACITIES or found[OUTCOME] == REFUSED:
        return
    carried = find_capacities(law, geometry_of(given), load_of(given), parts, steps)
    found[CREEP_CAPACITY], found[SLIP_CAPACITY] = carried.creep_limit, carried.tested_slip
    found[GROSS_CAPACITY], found[GROSS_CREEP] = carried.gross_slip, carried.gross_creep
    found[LEAST_SLACK], found[MOST_PULL] = carried.least_slack, carried.most_pull


def refused(law: CompactLaw, geometry: Geometry, load: Load) -> bool:
    """Whether slip or creep would not be unique, as `wraparc.arc.WrapArc` says in words."""
    top = max(load.entry_tension, load.exit_tension) / (geometry.width * geometry.radius)
    if geometry.shear * top * load.steepest_fall <= -1.0:
        return True
    par = parameters_at(load.entry_tension, geometry)
    if par.kick != 0.0 and jumps(law):
        return abs(par.kick) > (par.shear + par.onset) * onset_stress(law, par.entry_pressure)[0]
    return False


def find_tensions(
    law: CompactLaw, geometry: Geometry, load: Load, steps: int, points: int, found: Buffer
) -> None:
    """Solve for the tensions and read the profile."""
    par = parameters_at(load.entry_tension, geometry)
    solved = answer(law, geometry, load, steps)
    found[OUTCOME] = solved.outcome
    if solved.outcome != SOLVED:
        return
    out = zeros(profile_size(law, solved, points))
    shot, count = profile_of(law, solved, load.exit_tension, points, out)
    read_profile(law, par, load, shot, out, count, found)


def read_profile(
    law: CompactLaw,
    par: Parameters,
    load: Load,
    shot: Shot,
    out: Buffer,
    count: int,
    found: Buffer,
) -> None:
    """Write what an arc at its exit and its profile say into a row of results."""
    found[LOG_RATIO], found[EXIT_SLIP], found[EXIT_CREEP] = shot.log_tension, shot.slip, shot.creep
    found[EXIT_STRESS], found[WORK], found[CREEP_RATIO] = shot.stress, shot.work, shot.creep_ratio
    found[STUCK_LENGTH], found[ENTRY_STRESS] = shot.stuck_length, out[4]
    found[PEAK_STRESS], found[PEAK_AT] = peak_stress(law, par, shot.creep_ratio, out, count)
    found[ACTIVE] = active_length(out, count)
    found[LARGEST_SLIP] = largest_slip(out, count)
    found[STEEPEST_SLIP] = steepest_slip(out, count, par.length)
    if load.pressure_min == load.pressure_min:
        found[OUTSIDE] = share_outside(
            par, out, count, load.pressure_min, load.pressure_max, load.slip_max
        )
