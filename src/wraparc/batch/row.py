"""One arc of a batch by the scalar kernel: numbers in, numbers out.

What `wraparc.arc.Distributed` does for one arc, in functions of plain numbers and buffers only, so
that the same source runs in the interpreter and compiled. A test holds the two together.
"""

from __future__ import annotations

from math import exp, inf, nan

from wraparc.arc.kernel.capacity import (
    STUCK,
    Geometry,
    carry,
    largest_ratio,
    least_slack,
    parameters_at,
    profile_size,
    solve_tension,
    trace,
)
from wraparc.arc.kernel.march import KICK, RECORD, SHEAR, Buffer, Law, Parameters, room
from wraparc.arc.kernel.shoot import CREEP, EXHAUSTED, FOUND, SLIP, jumps
from wraparc.arc.kernel.stick import onset_stress
from wraparc.arc.profile import active_length, peak_stress, share_outside

#: what is wanted of an arc, to be added up
TENSIONS, CREEP_LIMIT, TESTED_SLIP, LEAST, GROSS_SLIP = 1, 2, 4, 8, 16
CAPACITIES = CREEP_LIMIT + TESTED_SLIP + LEAST + GROSS_SLIP
EVERYTHING = TENSIONS + CAPACITIES

# outcomes
SOLVED, BREAKAWAY, UNSOLVED, REFUSED = 0, 1, 2, 3
BALANCE = 1e-8  # largest relative miss of T2 that counts as solved

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
) = range(19)
FOUND_NUMBERS = 19

#: places that each part fills
PLACES = {
    TENSIONS: tuple(range(OUTCOME, OUTSIDE + 1)),
    CREEP_LIMIT: (CREEP_CAPACITY,),
    TESTED_SLIP: (SLIP_CAPACITY,),
    LEAST: (LEAST_SLACK, MOST_PULL),
    GROSS_SLIP: (GROSS_CAPACITY, GROSS_CREEP),
}


def tensions_of_row(
    law: Law, given: Buffer, parts: int, steps: int, points: int, found: Buffer
) -> None:
    """Begin the row of an arc, and find its operating point if that is wanted.

    Parameters
    ----------
    law
        Its friction law, see :mod:`wraparc.friction.compact`.
    given
        Its numbers, in the order of `wraparc.batch.arcs.INPUTS`.
    parts
        Which results are wanted; the others become nan.
    steps, points
        Mesh steps, and equal parts of the wrap at which its profile is looked at.
    found
        A row of results.
    """
    for k in range(FOUND_NUMBERS):
        found[k] = nan
    par = parameters_at(given[9], geometry_of(given))
    tight = max(given[9], given[10])
    found[OUTCOME] = SOLVED
    if refused(law, par, tight / (given[3] * given[1]), given[15], given[8]):
        found[OUTCOME] = REFUSED
    elif parts & TENSIONS:
        find_tensions(law, par, given[10], given, steps, points, room(0), found)


def capacities_of_row(law: Law, given: Buffer, parts: int, steps: int, found: Buffer) -> None:
    """Find the capacities that are wanted of an arc whose row is begun."""
    if parts & CAPACITIES and found[OUTCOME] != REFUSED:
        tight, pull = max(given[9], given[10]), given[9] - given[10]
        find_capacities(law, geometry_of(given), tight, pull, given, parts, steps, room(0), found)


def geometry_of(given: Buffer) -> Geometry:
    """What of an arc does not depend on its tensions."""
    return (
        given[0],
        given[1],
        given[2],
        given[3],
        given[4],
        given[5],
        given[6],
        given[7],
        given[8],
    )


def refused(law: Law, par: Parameters, top: float, fall: float, onset: float) -> bool:
    """Whether slip or creep would not be unique, as `wraparc.arc.WrapArc` says in words."""
    if par[SHEAR] * top * fall <= -1.0:
        return True
    if par[KICK] > 0.0 and jumps(law):
        return par[KICK] > (par[SHEAR] + onset) * onset_stress(law, par[1])[0]
    return False


def find_tensions(
    law: Law,
    par: Parameters,
    exit_tension: float,
    given: Buffer,
    steps: int,
    points: int,
    none: Buffer,
    found: Buffer,
) -> None:
    """Solve for the tensions and read the profile."""
    outcome, z, shot = solve_tension(law, par, exit_tension, steps, none)
    if outcome == EXHAUSTED:
        found[OUTCOME] = BREAKAWAY
        return
    if (outcome not in (FOUND, STUCK)) or not abs(
        given[9] * exp(shot[0]) / exit_tension - 1.0
    ) <= BALANCE:
        found[OUTCOME] = UNSOLVED
        return
    out = room(profile_size(law, par, steps, points))
    length = given[1] * given[2]
    if z > -inf:
        shot, count = trace(law, par, exit_tension, z, steps, points, out)
    else:
        count = points + 1
        for i in range(count):
            out[RECORD * i] = length * i / points
    found[LOG_RATIO], found[EXIT_SLIP], found[EXIT_CREEP] = shot[0], shot[1], shot[2]
    found[EXIT_STRESS], found[WORK], found[CREEP_RATIO] = shot[3], shot[4], shot[5]
    found[STUCK_LENGTH], found[ENTRY_STRESS] = shot[6], out[4]
    found[PEAK_STRESS], found[PEAK_AT] = peak_stress(out, count)
    found[ACTIVE] = active_length(out, count)
    if given[12] == given[12]:
        found[OUTSIDE] = share_outside(par, out, count, given[12], given[13], given[14])


def find_capacities(
    law: Law,
    geometry: Geometry,
    tight: float,
    pull: float,
    given: Buffer,
    parts: int,
    steps: int,
    none: Buffer,
    found: Buffer,
) -> None:
    """What the arc could carry with its tight side held."""
    limit, pressure_max, slip_max = given[11], given[13], given[14]
    pull = abs(pull)
    if parts & (CREEP_LIMIT + LEAST):
        outcome, z, entry, shot = carry(law, geometry, tight, CREEP, limit, nan, steps, none)
        if outcome == FOUND:
            found[CREEP_CAPACITY] = abs(shot[0])
        if parts & LEAST and outcome == FOUND and pull > 1e-6 * tight:
            top = 1e3 * tight
            if pressure_max == pressure_max:
                top = pressure_max * given[3] * given[1]
            found[LEAST_SLACK], found[MOST_PULL] = least_slack(
                law, geometry, pull, limit, tight, entry, z, top, steps, none
            )
    if parts & TESTED_SLIP and slip_max == slip_max:
        outcome, _, _, shot = carry(law, geometry, tight, SLIP, slip_max, nan, steps, none)
        if outcome == FOUND:
            found[SLIP_CAPACITY] = abs(shot[0])
    if parts & GROSS_SLIP:
        gross, creep = largest_ratio(law, geometry, tight, given[15] < 0.0, steps, none)
        found[GROSS_CAPACITY], found[GROSS_CREEP] = gross, creep
        # past the largest ratio of a softening law creep grows and the ratio falls
        if creep <= limit:
            found[CREEP_CAPACITY] = gross
        if creep <= slip_max:
            found[SLIP_CAPACITY] = gross
