"""Solve one arc: the one arrangement, interpreted, compiled and in batches.

`solve_tension` finds the operating point, `answer` judges it, `trace` gives its profile, and
`find_capacities` what the arc could carry.
"""

from __future__ import annotations

from math import ceil, exp, expm1, inf, log, nan, sqrt
from typing import NamedTuple

from wraparc.arc.kernel.capacity import carry
from wraparc.arc.kernel.effort import (
    CREEP,
    SLIP,
    TENSION,
    Aim,
    first_guess,
    is_far,
    jumps,
    mesh_steps,
    ratio_of,
    shoot_from,
)
from wraparc.arc.kernel.gross_slip import largest_ratio, plateau_capacity
from wraparc.arc.kernel.layer_march import STEP_TOLERANCE, friction_of_creep
from wraparc.arc.kernel.layer_profile import KINKS, NODES, trace_layers
from wraparc.arc.kernel.layers import NO_LAYERS, Layers, shot_of_layers, solve_layers
from wraparc.arc.kernel.least_slack import highest_tight, least_slack
from wraparc.arc.kernel.quantities import (
    BREAKAWAY,
    NO_SHOT,
    RECORD,
    SOLVED,
    STUCK,
    UNSOLVED,
    Buffer,
    Geometry,
    Load,
    Parameters,
    Shot,
    parameters_at,
    zeros,
)
from wraparc.arc.kernel.search import NO_PULL, TOLERANCE, refine, tension_shot
from wraparc.arc.kernel.stick import held_exit, holds, stick_slip, zone_creep_ratio, zone_end
from wraparc.arc.kernel.tension_march import march
from wraparc.arc.kernel.tension_table import applies, open_table, table_size
from wraparc.arc.profile import sort
from wraparc.friction.compact import CompactLaw

#: largest relative miss of the loss of energy, which is exact for any law: beyond it the mesh has
#: not resolved the law
LOSS_MISS = 1e-6
TURNS, LEAST_TURN = 60, 1e-9  # points where the way of slip is looked at, and slip [m]
FINEST, FINER = 32, 8  # times the mesh until the loss of energy is met, in all and at once
BALANCE = 1e-8  # largest relative miss of T2 that counts as solved

# capacities that may be asked for, to be added up
CREEP_LIMIT, TESTED_SLIP, LEAST, GROSS_SLIP = 2, 4, 8, 16
CAPACITIES = CREEP_LIMIT + TESTED_SLIP + LEAST + GROSS_SLIP


class Found(NamedTuple):
    """What `solve_tension` finds.

    Attributes
    ----------
    outcome
        SOLVED; STUCK: the belt does not slip anywhere (z is good to the precision of a difference
        only); BREAKAWAY: no effort meets the tension; UNSOLVED.
    z
        Effort; -inf where nothing drives the arc, nan where it is solved by layers.
    shot
        The arc at its exit.
    layers
        Its layers, where it is solved by them.
    steps
        Mesh steps of the march that found it.
    """

    outcome: int
    z: float
    shot: Shot
    layers: Layers
    steps: int


def solve_tension(  # noqa: C901 - the ways an arc is solved, one after the other
    law: CompactLaw, par: Parameters, exit_tension: float, steps: int
) -> Found:
    """Effort at which the exit tension is met."""
    goal = par.side * log(par.entry_tension / exit_tension)
    if jumps(law):
        held, creep = held_exit(law, par, exit_tension)
        if held and not holds(law, par, par.length, creep):
            return by_layers(law, par, goal)
        if held:
            end = zone_end(law, par, par.length)[1]
            z = creep / end - 1.0 if end != 0.0 else 0.0
            shot, _ = stuck_shot(law, par, exit_tension, creep, 0, zeros(0))
            return Found(STUCK, z, shot, NO_LAYERS, steps)
    if abs(goal) < NO_PULL and par.kick == 0.0:
        still = Shot(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        return Found(SOLVED, -inf, still, NO_LAYERS, steps)
    if is_far(law, par):
        far = by_layers(law, par, goal)
        if far.outcome != UNSOLVED:
            return far
    tight = max(par.entry_tension, exit_tension) / (par.width * par.radius)
    if goal < plateau_capacity(law, tight, par.length / par.radius):
        found = _by_marches(law, par, goal, steps)
        if found.outcome != BREAKAWAY:
            holds_on = _held_throughout(law, par, found)
            if holds_on and _resolved(law, par, found):
                return found
            other = by_layers(law, par, goal)
            if other.outcome == SOLVED:
                return other
            outcome = found.outcome if holds_on else UNSOLVED
            return Found(outcome, found.z, found.shot, found.layers, found.steps)
    return Found(BREAKAWAY, -inf, NO_SHOT, NO_LAYERS, steps)


def _by_marches(law: CompactLaw, par: Parameters, goal: float, steps: int) -> Found:
    """Meet ln(tight/slack) by marches from the entry, on a finer mesh while it is not resolved."""
    aim = Aim(TENSION, goal)
    guess = first_guess(law, par, aim)
    found = Found(BREAKAWAY, nan, NO_SHOT, NO_LAYERS, steps)
    finer = 1
    while finer <= FINEST:
        outcome, z, shot = refine(law, par, aim, guess, finer * steps)
        if outcome == BREAKAWAY:
            break
        found = Found(outcome, z, shot, NO_LAYERS, finer * steps)
        miss = loss_miss(law, par, shot) if outcome == SOLVED else 0.0
        held = jumps(law) and par.shear == 0.0
        if miss < LOSS_MISS and (outcome == SOLVED or held or finer > 2):
            break  # resolved, or unsolved not for want of a mesh
        # a kink of the law inside a step leaves a miss of about its square
        finer *= int(min(max(ceil(sqrt(miss / LOSS_MISS)), 2), FINER))
    return found


def _resolved(law: CompactLaw, par: Parameters, found: Found) -> bool:
    """Whether a march has met its aim on a mesh fine enough for the law."""
    if found.outcome != SOLVED:
        return jumps(law) and par.shear == 0.0
    return loss_miss(law, par, found.shot) < LOSS_MISS


def _held_throughout(law: CompactLaw, par: Parameters, found: Found) -> bool:
    """Whether friction holds the belt all along the stuck zone of a march."""
    if not jumps(law) or par.shear == 0.0 or found.outcome != SOLVED:
        return True
    zone = found.shot.stuck_length
    if not holds(law, par, zone, zone_end(law, par, zone)[1]):
        return False
    return par.kick == 0.0 or not _turns(law, par, found)


def _turns(law: CompactLaw, par: Parameters, found: Found) -> bool:
    """Whether slip passes through zero in a march: a law that jumps would hold the belt there."""
    out = zeros(_march_size(law, par, found.steps, TURNS))
    _, count = shoot_from(law, par, found.z, found.steps, TURNS, out)
    low = high = 0.0
    for i in range(count):
        low, high = min(low, out[RECORD * i + 2]), max(high, out[RECORD * i + 2])
    return min(-low, high) > LEAST_TURN


def loss_miss(law: CompactLaw, par: Parameters, shot: Shot) -> float:
    """Miss of loss = (T1 - T2) (g + (T1 - T2)/(2 EA')), relative to the energies in it."""
    pull = par.entry_tension * -expm1(shot.log_tension)
    exact = pull * (shot.creep_ratio + 0.5 * pull * par.compliance)
    entry_stress, _ = friction_of_creep(law, par, par.entry_tension, par.kick)
    leaving, entering = 0.5 * par.shear * shot.stress**2, 0.5 * par.shear * entry_stress**2
    loss = par.width * (shot.work + leaving - entering)
    size = max(abs(exact), par.width * (abs(shot.work) + leaving + entering))
    return abs(loss - exact) / size if size > 0.0 else 0.0


def by_layers(law: CompactLaw, par: Parameters, goal: float) -> Found:
    """`solve_tension` by layers, where no effort at the entry tells what happens at the exit."""
    outcome, layers = solve_layers(law, par, Aim(TENSION, goal), nan, STEP_TOLERANCE, NO_LAYERS)
    return Found(outcome, nan, shot_of_layers(law, par, layers), layers, 0)


def stuck_shot(
    law: CompactLaw, par: Parameters, exit_tension: float, creep: float, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Exit quantities and profile of an arc that sticks throughout, with its creep at the exit."""
    length, compliance = par.length, par.shear + par.onset
    g = zone_creep_ratio(par, length, creep)
    state, count = stick_slip(law, par, length, creep, g, 0, points, out)
    tau = creep / compliance if compliance > 0.0 else 0.0
    q = log(exit_tension / par.entry_tension)
    return Shot(q, state.slip, creep, tau, state.work, g, length), count


class Answer(NamedTuple):
    """The operating point of an arc.

    Attributes
    ----------
    outcome
        SOLVED, BREAKAWAY or UNSOLVED.
    par
        The numbers it was solved with.
    z, shot, layers, steps
        As `Found` has them.
    """

    outcome: int
    par: Parameters
    z: float
    shot: Shot
    layers: Layers
    steps: int


def answer(law: CompactLaw, geometry: Geometry, load: Load, steps: int) -> Answer:
    """Operating point of an arc, judged by the balance T(phi) = T2."""
    par = parameters_at(load.entry_tension, geometry)
    outcome, z, shot, layers, marched = solve_tension(law, par, load.exit_tension, steps)
    if outcome != BREAKAWAY:
        miss = load.entry_tension * exp(shot.log_tension) / load.exit_tension - 1.0
        good = outcome in (SOLVED, STUCK) and abs(miss) <= BALANCE
        outcome = SOLVED if good else UNSOLVED
    return Answer(outcome, par, z, shot, layers, marched)


def profile_size(law: CompactLaw, found: Answer, points: int) -> int:
    """Numbers that the records of `trace` need: points, nodes and kinks."""
    if found.z != found.z:
        return RECORD * (points + 2 * (NODES + KINKS) + 10)
    return _march_size(law, found.par, found.steps, points)


def _march_size(law: CompactLaw, par: Parameters, steps: int, points: int) -> int:
    """Numbers that the records of a march need."""
    return RECORD * (points + 4 * mesh_steps(law, par, steps) + 600)


def trace(
    law: CompactLaw, found: Answer, exit_tension: float, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Profile of an arc solved by `solve_tension`: exit quantities and the number of records."""
    par, z, steps = found.par, found.z, found.steps
    goal = par.side * log(par.entry_tension / exit_tension)
    if z != z:
        return trace_layers(law, par, found.layers, points, out)
    if jumps(law):
        held, creep = held_exit(law, par, exit_tension)
        if held:
            return stuck_shot(law, par, exit_tension, creep, points, out)
    if applies(law, par) and goal > NO_PULL:
        fine = mesh_steps(law, par, steps)
        table = zeros(table_size(goal, fine))
        open_table(law, par, goal, fine, table)
        gamma = par.side * ratio_of(par, z)
        status, q, s, a, work, _ = march(law, par, gamma, False, table, 0, zeros(0))
        if status == SOLVED and abs(s / par.length - 1.0) < TOLERANCE * 100.0:
            count = march(law, par, gamma, False, table, points, out)[5]
            sort(out, count)
            return tension_shot(law, par, gamma, q, a, work), count
    shot, count = shoot_from(law, par, z, steps, points, out)
    sort(out, count)
    return shot, count


def profile_of(
    law: CompactLaw, found: Answer, exit_tension: float, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Exit quantities of an answer and the number of records of its profile, in `out`.

    `out` has room for `profile_size` zeros; an arc that nothing drives has a profile of them.
    """
    if found.z != -inf:
        return trace(law, found, exit_tension, points, out)
    for i in range(points + 1):
        out[RECORD * i] = found.par.length * i / points
    return found.shot, points + 1


class Carried(NamedTuple):
    """What an arc could carry with its tight side held, nan where it was not asked or not found."""

    creep_limit: float  # ln(tight/slack)
    tested_slip: float  # ln(tight/slack)
    gross_slip: float  # ln(tight/slack)
    gross_creep: float  # exit creep there [m]
    least_slack: float  # tension [N]
    most_pull: float  # where no tension carries the pull [N]


class Beginning(NamedTuple):
    """Where searches of capacities begin, nan where nothing is known."""

    creep_limit: float  # effort
    tested_slip: float  # effort
    least: float  # effort
    entry: float  # tension of the least slack side [N]


NO_BEGINNING = Beginning(nan, nan, nan, nan)


def find_capacities(
    law: CompactLaw, geometry: Geometry, load: Load, parts: int, steps: int
) -> Carried:
    """Capacities that are asked for by `parts`."""
    return find_capacities_near(law, geometry, load, parts, steps, NO_BEGINNING)


def find_capacities_near(
    law: CompactLaw, geometry: Geometry, load: Load, parts: int, steps: int, begin: Beginning
) -> Carried:
    """`find_capacities` where it is known about where they are."""
    tight = max(load.entry_tension, load.exit_tension)
    pull = abs(load.entry_tension - load.exit_tension)
    by_creep = by_slip = gross = gross_creep = least = most = nan
    if parts & (CREEP_LIMIT + LEAST):
        outcome, z, entry, shot = carry(
            law, geometry, tight, Aim(CREEP, load.creep_limit), begin.creep_limit, steps
        )
        if outcome == SOLVED:
            by_creep = abs(shot.log_tension)
        if parts & LEAST and outcome == SOLVED and pull > 1e-6 * tight:
            top = highest_tight(load.pressure_max, geometry.width * geometry.radius, tight)
            if z == z and begin.entry == begin.entry:
                entry, z = begin.entry, begin.least
            least, most = least_slack(
                law, geometry, pull, load.creep_limit, tight, entry, z, top, steps
            )
    if parts & TESTED_SLIP and load.slip_max == load.slip_max:
        outcome, _, _, shot = carry(
            law, geometry, tight, Aim(SLIP, load.slip_max), begin.tested_slip, steps
        )
        if outcome == SOLVED:
            by_slip = abs(shot.log_tension)
    if parts & GROSS_SLIP:
        softening = load.steepest_fall < 0.0
        gross, gross_creep = largest_ratio(law, geometry, tight, softening, steps)
        # past the largest ratio of a softening law creep grows and the ratio falls
        if gross_creep <= load.creep_limit:
            by_creep = gross
        if gross_creep <= load.slip_max:
            by_slip = gross
    return Carried(by_creep, by_slip, gross, gross_creep, least, most)
