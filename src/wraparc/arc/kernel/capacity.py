"""What an arc could carry within a limit of creep or slip.

The tight side is held (T1 driving, T2 braking) and the slack side falls. On a braking pulley the
held tension is at the exit, so that the entry tension is an unknown too.
"""

from __future__ import annotations

from math import exp, log, nan
from typing import NamedTuple

from wraparc.arc.kernel.effort import Aim, first_guess, is_far, jumps, mesh_steps
from wraparc.arc.kernel.gross_slip import plateau_capacity
from wraparc.arc.kernel.layer_march import COARSE_TOLERANCE, STEP_TOLERANCE
from wraparc.arc.kernel.layers import NO_LAYERS, Layers, shot_of_layers, solve_layers
from wraparc.arc.kernel.quantities import (
    NO_SHOT,
    SOLVED,
    UNSOLVED,
    Buffer,
    Geometry,
    Shot,
    parameters_at,
    zeros,
)
from wraparc.arc.kernel.search import LARGEST_LOG, TOLERANCE, attempt, refine
from wraparc.arc.kernel.tension_table import applies, open_table, table_size
from wraparc.friction.compact import CompactLaw

ALIKE = 1e-9  # relative, of an entry tension: what it leaves in the kick
MEET_STEPS = 12  # mesh steps of a first search; decides speed only
MOST_ROUNDS, SLOW_ROUNDS = 30, 8  # of Newton's method: 8 to 15 in all are usual


class Guess(NamedTuple):
    """What a search of an arc begins with: another of nearly the same."""

    z: float  # effort, or nan
    layers: Layers  # of a long arc, or NO_LAYERS


def carry(
    law: CompactLaw,
    geometry: Geometry,
    tight: float,
    aim: Aim,
    z: float,
    steps: int,
) -> tuple[int, float, float, Shot]:
    """Largest tension ratio of a held tight side at which a target of creep or slip is met.

    Parameters
    ----------
    tight
        Tension of the tight side [N].
    aim
        CREEP or SLIP at the exit towards the slack side, and its limit [m].
    z
        First guess of the effort, or nan.

    Returns
    -------
    outcome, z, entry tension [N], shot
    """
    if geometry.side > 0.0:
        outcome, guess, shot = carry_from(law, geometry, tight, aim, Guess(z, NO_LAYERS), steps)
        return outcome, guess.z, tight, shot
    # braking: the entry tension follows from the ratio found, and the ratio depends on it
    par = parameters_at(0.6 * tight, geometry)
    if is_far(law, par):
        outcome, entry, shot = _carry_far(law, geometry, tight, aim, steps)
        if outcome == SOLVED:
            return outcome, nan, entry, shot
        return _carry_bracketed(law, geometry, tight, aim, steps)
    first = z if z == z else first_guess(law, par, aim)
    met, z_met, entry, shot, _ = meet(
        law, geometry, aim, False, tight, 0.6 * tight, first, 4.0 * tight, steps
    )
    if met and entry <= tight:
        return SOLVED, z_met, entry, shot
    return _carry_bracketed(law, geometry, tight, aim, steps)


def _carry_far(
    law: CompactLaw, geometry: Geometry, tight: float, aim: Aim, steps: int
) -> tuple[int, float, Shot]:
    """`carry` of a long braking pulley: T1 is what its layers hand on, and sets only the kick."""
    t, mesh, t_last, miss_last = 0.6 * tight, MEET_STEPS, 0.0, 0.0
    layers = NO_LAYERS
    for _ in range(MOST_ROUNDS):
        par = parameters_at(t, geometry)
        outcome, layers = solve_layers(law, par, aim, tight, _tolerance(mesh), layers)
        if outcome != SOLVED:
            break
        miss = layers.entry_tension - t
        fixed = geometry.kick_coefficient == 0.0
        if mesh == steps and (fixed or abs(miss) < max(ALIKE, _tolerance(mesh)) * t):
            t = layers.entry_tension
            return SOLVED, t, shot_of_layers(law, parameters_at(t, geometry), layers)
        if mesh != steps and (fixed or abs(miss) < 1e-4 * t):
            mesh, t, t_last = steps, layers.entry_tension, 0.0
            continue
        new = t + miss
        if t_last > 0.0 and miss != miss_last:
            new = t - miss * (t - t_last) / (miss - miss_last)
        t_last, miss_last = t, miss
        t = new if 0.0 < new <= tight else t + miss
    return UNSOLVED, t, NO_SHOT


def _carry_bracketed(
    law: CompactLaw, geometry: Geometry, tight: float, aim: Aim, steps: int
) -> tuple[int, float, float, Shot]:
    """`carry` of a braking pulley where Newton's method fails: secants in ln T1, in a bracket."""
    radius, wrap, width = geometry.radius, geometry.wrap_angle, geometry.width
    goal = log(tight)
    t, t_last, f_last, slope, mesh = goal, goal, 0.0, 1.0, MEET_STEPS
    guess = Guess(nan, NO_LAYERS)
    bottom = goal - plateau_capacity(law, tight / (width * radius), wrap) - 1.0
    low, high = bottom, goal
    for _ in range(80):
        outcome, guess, shot = carry_from(law, geometry, exp(t), aim, guess, mesh)
        if outcome != SOLVED:
            return outcome, guess.z, exp(t), shot
        f = t + shot.log_tension - goal
        if mesh == steps and (abs(f) < 1e-9 or high - low < 1e-13):
            return (SOLVED if abs(f) < 1e-8 else UNSOLVED), guess.z, exp(t), shot
        if t != t_last:
            slope = (f - f_last) / (t - t_last)
        if mesh != steps and abs(f) < 1e-4:
            # good on the coarse mesh: on with the fine one, which moves it a little
            mesh, low, high, t_last = steps, bottom, goal, t
            continue
        low, high = (low, t) if f > 0.0 else (t, high)
        t_last, f_last = t, f
        t = t - f / slope if slope > 0.0 else nan
        if not low < t < high:
            t = 0.5 * (low + high)
    return UNSOLVED, guess.z, exp(t), shot


def _tolerance(steps: int) -> float:
    """Relative error of a step of layers, for the fineness of a mesh."""
    return COARSE_TOLERANCE if steps == MEET_STEPS else STEP_TOLERANCE


def carry_from(
    law: CompactLaw, geometry: Geometry, entry: float, aim: Aim, guess: Guess, steps: int
) -> tuple[int, Guess, Shot]:
    """Meet a target of creep or slip with the entry tension held [N]."""
    par = parameters_at(entry, geometry)
    if is_far(law, par):
        outcome, layers = solve_layers(law, par, aim, nan, _tolerance(steps), guess.layers)
        shot = shot_of_layers(law, par, layers) if outcome == SOLVED else NO_SHOT
        return outcome, Guess(nan, layers), shot
    z = guess.z if guess.z == guess.z else first_guess(law, par, aim)
    outcome, z, shot = refine(law, par, aim, z, steps)
    return outcome, Guess(z, guess.layers), shot


def meet(
    law: CompactLaw,
    geometry: Geometry,
    aim: Aim,
    of_pull: bool,
    tension: float,
    entry: float,
    z: float,
    most: float,
    steps: int,
) -> tuple[bool, float, float, Shot, float]:
    """Entry tension and effort that meet a target at the exit and a tension together.

    Newton's method on a coarse mesh, then its Jacobian kept up to date by Broyden's formula on the
    fine one.

    Parameters
    ----------
    aim
        CREEP or SLIP at the exit towards the slack side, and its value [m].
    of_pull, tension
        True: |T1 - T2| is `tension`; False: the exit tension is [N].
    entry, z
        First guess of the entry tension [N] and the effort.
    most
        Entry tension beyond which the search is given up [N].

    Returns
    -------
    met, z, entry tension [N], shot, growth
        growth is the sign of d(pull)/d(entry tension) along the target.
    """
    t = log(entry)
    j11 = j12 = j21 = j22 = 0.0
    fine = mesh_steps(law, parameters_at(entry, geometry), steps)
    table = zeros(table_size(LARGEST_LOG, 2 * fine))
    mesh, fresh = MEET_STEPS, True
    case = (aim, of_pull, tension)
    r1, r2, shot = _misses(law, geometry, case, t, z, mesh, table)
    for i in range(MOST_ROUNDS):
        size = max(abs(r1), abs(r2))
        if i > SLOW_ROUNDS and size > 0.3:
            break  # it goes astray
        if mesh == steps and size < TOLERANCE * 10.0:
            det = j11 * j22 - j12 * j21
            return True, z, exp(t), shot, det * (1.0 if j11 > 0.0 else -1.0)
        if mesh < steps and size < 3e-4:
            mesh = steps
            r1, r2, shot = _misses(law, geometry, case, t, z, mesh, table)
            continue
        far = max(1.0, abs(z)) if jumps(law) else 1.0  # the effort of a rest arc is no logarithm
        if fresh:
            dz, dt = 1e-4 * far, 1e-4
            a1, a2, _ = _misses(law, geometry, case, t, z + dz, mesh, table)
            b1, b2, _ = _misses(law, geometry, case, t + dt, z, mesh, table)
            j11, j21 = (a1 - r1) / dz, (a2 - r2) / dz
            j12, j22 = (b1 - r1) / dt, (b2 - r2) / dt
        det = j11 * j22 - j12 * j21
        if det == 0.0:
            return False, z, exp(t), shot, 0.0
        dz, dt = (r2 * j12 - r1 * j22) / det, (r1 * j21 - r2 * j11) / det
        scale = min(1.0, 1.5 * far / max(abs(dz), 1e-300), 0.5 / max(abs(dt), 1e-300))
        dz, dt = scale * dz, scale * dt
        z, t = z + dz, t + dt
        if t > log(most):
            return False, z, exp(t), shot, 0.0
        n1, n2, shot = _misses(law, geometry, case, t, z, mesh, table)
        shrunk = max(abs(n1), abs(n2)) < 0.3 * size
        fresh = mesh < steps and not shrunk
        # Broyden's update
        square = dz * dz + dt * dt
        if square > 0.0:
            e1 = (n1 - r1 - j11 * dz - j12 * dt) / square
            e2 = (n2 - r2 - j21 * dz - j22 * dt) / square
            j11, j12 = j11 + e1 * dz, j12 + e1 * dt
            j21, j22 = j21 + e2 * dz, j22 + e2 * dt
        r1, r2 = n1, n2
    return False, z, exp(t), shot, 0.0


def _misses(
    law: CompactLaw,
    geometry: Geometry,
    case: tuple[Aim, bool, float],
    t: float,
    z: float,
    steps: int,
    table: Buffer,
) -> tuple[float, float, Shot]:
    """Relative misses of the target and of the tension, for ln T1 = t and effort z."""
    aim, of_pull, tension = case
    par = parameters_at(exp(t), geometry)
    went = False
    if applies(law, par):
        open_table(law, par, LARGEST_LOG, mesh_steps(law, par, steps), table)
        went, miss, shot = attempt(law, par, aim, z, steps, table)
    if not went:
        _, miss, shot = attempt(law, par, aim, z, steps, zeros(0))
    miss /= aim.value
    if not of_pull:
        return miss, t + shot.log_tension - log(tension), shot
    pull = par.entry_tension * abs(1.0 - exp(shot.log_tension))
    return miss, log(max(pull, 1e-9 * tension) / tension), shot
