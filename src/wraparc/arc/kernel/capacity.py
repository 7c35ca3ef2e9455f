"""What an arc could carry within a limit of creep or slip, and the least slack-side tension.

The tight side is held (T1 driving, T2 braking) and the slack side falls. On a braking pulley the
held tension is at the exit, so that the entry tension is an unknown too.
"""

from __future__ import annotations

from math import exp, inf, log, nan

from wraparc.arc.kernel.effort import CREEP, Aim, first_guess, is_far, jumps, mesh_steps
from wraparc.arc.kernel.gross_slip import plateau_capacity
from wraparc.arc.kernel.layer_march import COARSE_TOLERANCE, STEP_TOLERANCE
from wraparc.arc.kernel.layers import shot_of_layers, solve_layers
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

MEET_STEPS = 12  # mesh steps of a first search; decides speed only
PULL_TOLERANCE = 2e-9  # relative: what the steps of layers leave
GOLDEN = 0.6180339887498949
NEAR_TOP = 0.08  # of ln(tension): so near its top the pull is a parabola
MOST_ROUNDS, SLOW_ROUNDS = 30, 8  # of Newton's method: 8 to 15 in all are usual


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
        outcome, z, shot = _at_entry(law, geometry, tight, aim, z, steps)
        return outcome, z, tight, shot
    # braking: the entry tension follows from the ratio found, and the ratio depends on it
    par = parameters_at(0.6 * tight, geometry)
    if is_far(law, par):
        return _carry_bracketed(law, geometry, tight, aim, steps)
    guess = z if z == z else first_guess(law, par, aim)
    met, z_met, entry, shot, _ = meet(
        law, geometry, aim, False, tight, 0.6 * tight, guess, 4.0 * tight, steps
    )
    if met and entry <= tight:
        return SOLVED, z_met, entry, shot
    return _carry_bracketed(law, geometry, tight, aim, steps)


def _carry_bracketed(
    law: CompactLaw, geometry: Geometry, tight: float, aim: Aim, steps: int
) -> tuple[int, float, float, Shot]:
    """`carry` of a braking pulley where Newton's method fails: secants in ln T1, in a bracket."""
    radius, wrap, width = geometry.radius, geometry.wrap_angle, geometry.width
    goal = log(tight)
    t, t_last, f_last, z, slope, mesh = goal, goal, 0.0, nan, 1.0, MEET_STEPS
    bottom = goal - plateau_capacity(law, tight / (width * radius), wrap) - 1.0
    low, high = bottom, goal
    for _ in range(80):
        outcome, z, shot = _at_entry(law, geometry, exp(t), aim, z, mesh)
        if outcome != SOLVED:
            return outcome, z, exp(t), shot
        f = t + shot.log_tension - goal
        if mesh == steps and (abs(f) < 1e-9 or high - low < 1e-13):
            return (SOLVED if abs(f) < 1e-8 else UNSOLVED), z, exp(t), shot
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
    return UNSOLVED, z, exp(t), shot


def _at_entry(
    law: CompactLaw, geometry: Geometry, entry: float, aim: Aim, z: float, steps: int
) -> tuple[int, float, Shot]:
    """Meet a target of creep or slip with the entry tension held [N]; z may be nan."""
    par = parameters_at(entry, geometry)
    if is_far(law, par):
        tolerance = COARSE_TOLERANCE if steps == MEET_STEPS else STEP_TOLERANCE
        outcome, layers = solve_layers(law, par, aim, tolerance)
        return outcome, nan, shot_of_layers(law, par, layers) if outcome == SOLVED else NO_SHOT
    return refine(law, par, aim, z if z == z else first_guess(law, par, aim), steps)


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


def least_slack(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    tight: float,
    entry: float,
    z: float,
    tight_max: float,
    steps: int,
) -> tuple[float, float]:
    """Least slack-side tension that carries a pull within a creep limit.

    Parameters
    ----------
    pull
        |T1 - T2| to be carried [N].
    limit
        Exit creep towards the slack side [m].
    tight, entry, z
        A tight-side tension, and the entry tension and effort at its creep limit, to begin with
        [N, N, -].
    tight_max
        Largest tight-side tension to consider [N]: the top of the tested pressures.

    Returns
    -------
    least, most
        The smallest root [N] and nan; without a root nan and the largest pull there is [N].
    """
    if z != z:  # a long arc
        return _least_bracketed(law, geometry, pull, limit, tight_max, steps)
    met, _, entry_met, shot, growth = meet(
        law, geometry, Aim(CREEP, limit), True, pull, entry, z, 1.5 * tight_max, steps
    )
    if met and growth > 0.0:
        found = max(entry_met, entry_met * exp(shot.log_tension))
        if found <= tight_max:
            return found - pull, nan
    return _least_bracketed(law, geometry, pull, limit, tight_max, steps)


def _least_bracketed(
    law: CompactLaw, geometry: Geometry, pull: float, limit: float, tight_max: float, steps: int
) -> tuple[float, float]:
    """`least_slack` where Newton's method fails: the pull rises with tension to a largest one.

    In t, the logarithm of the entry tension, which a search of one unknown meets the limit at.
    """
    aim = Aim(CREEP, limit)
    _, z, entry, shot = carry(law, geometry, tight_max, aim, nan, MEET_STEPS)
    high, p_high = log(entry), entry * abs(1.0 - exp(shot.log_tension))
    if p_high < pull:
        high, p_high, z = _most(law, geometry, limit, pull, high, p_high, z)
    if p_high < pull:
        if high < log(entry):
            return nan, _pull(law, geometry, exp(high), limit, z, steps)[0]
        shot = carry(law, geometry, tight_max, aim, z, steps)[3]
        return nan, tight_max * (1.0 - exp(-abs(shot.log_tension)))
    low, p_low, high, p_high, z = _down(law, geometry, pull, limit, high, p_high, z)
    if p_low != p_low:
        return nan, nan
    f_low, f_high = log(max(p_low, 1e-9 * pull) / pull), log(p_high / pull)
    side, slope, t_last, f_last = 0, 1.0, high, f_high
    for _ in range(40):
        t = (low * f_high - high * f_low) / (f_high - f_low)
        p, z = _pull(law, geometry, exp(t), limit, z, MEET_STEPS)
        f = log(max(p, 1e-9 * pull) / pull)
        if t != t_last:
            slope = (f - f_last) / (t - t_last)
        if abs(f) < 1e-3:
            break
        # false position keeps one end: halve its weight when it does (Illinois)
        if f > 0.0:
            f_low *= 0.5 if side > 0 else 1.0
            high, f_high, side = t, f, 1
        else:
            f_high *= 0.5 if side < 0 else 1.0
            low, f_low, side = t, f, -1
        t_last, f_last = t, f
    t = _pull_closed(law, geometry, pull, limit, (t, slope), z, steps)
    return (exp(t) - pull if geometry.side > 0.0 else exp(t)), nan


def _down(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    high: float,
    p_high: float,
    z: float,
) -> tuple[float, float, float, float, float]:
    """Bracket of ln(entry tension) around a pull, from where more is carried downwards.

    Both ends with the pulls there, the lower one first, and the effort.
    """
    floor = log(pull) if geometry.side > 0.0 else -inf  # no belt pulls more than its tight side
    low, p_low = high, p_high
    while p_low >= pull:
        # where little tension is left, the pull goes with it
        high, p_high, low = low, p_low, low - 1.2 * log(p_low / pull) - 0.02
        if low <= floor:
            return floor, 0.5 * pull, high, p_high, z
        p_low, z = _pull(law, geometry, exp(low), limit, z, MEET_STEPS)
    return low, p_low, high, p_high, z


def _pull_closed(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    near: tuple[float, float],
    z: float,
    steps: int,
) -> float:
    """ln(entry tension) at which a pull is carried, by secants on the fine mesh; nan if not met.

    `near` is one close to it, and the slope of ln(pull) there, as the coarse mesh has them.
    """
    t, slope = near
    t_last = f_last = 0.0
    for i in range(12):
        p, z = _pull(law, geometry, exp(t), limit, z, steps)
        f = log(max(p, 1e-9 * pull) / pull)
        if abs(f) < PULL_TOLERANCE:
            return t
        if i > 0 and t != t_last:
            slope = (f - f_last) / (t - t_last)
        if slope <= 0.0:
            break
        t_last, f_last, t = t, f, t - f / slope
    return nan


def _pull(
    law: CompactLaw, geometry: Geometry, entry: float, limit: float, z: float, steps: int
) -> tuple[float, float]:
    """Pull carried at a creep limit with a held entry tension [N], and the effort for it."""
    _, z, shot = _at_entry(law, geometry, entry, Aim(CREEP, limit), z, steps)
    return entry * abs(1.0 - exp(shot.log_tension)), z


def _most(
    law: CompactLaw,
    geometry: Geometry,
    limit: float,
    enough: float,
    top: float,
    p_top: float,
    z: float,
) -> tuple[float, float, float]:
    """ln(entry tension) up to `top` of the largest pull at a creep limit, the pull [N], the effort.

    Golden section on the coarse mesh and a parabola; a pull of `enough` ends it. `p_top` and z
    belong to the top.
    """
    p_in, z_in = _pull(law, geometry, exp(top - 0.02), limit, z, MEET_STEPS)
    if p_in <= p_top:
        return top, p_top, z
    low, high, p_low, p_high = top - 3.0, top, -inf, p_top
    d = low + GOLDEN * (high - low)
    p_d, z = _pull(law, geometry, exp(d), limit, z_in, MEET_STEPS)
    c = high - GOLDEN * (high - low)
    p_c, z = _pull(law, geometry, exp(c), limit, z, MEET_STEPS)
    while high - low > NEAR_TOP and max(p_c, p_d) < enough:
        if p_c >= p_d:
            high, p_high, d, p_d = d, p_d, c, p_c
            c = high - GOLDEN * (high - low)
            p_c, z = _pull(law, geometry, exp(c), limit, z, MEET_STEPS)
        else:
            low, p_low, c, p_c = c, p_c, d, p_d
            d = low + GOLDEN * (high - low)
            p_d, z = _pull(law, geometry, exp(d), limit, z, MEET_STEPS)
    t, p_t = (c, p_c) if p_c >= p_d else (d, p_d)
    if p_t >= enough or p_low == -inf:
        return t, p_t, z
    # the top of the parabola through the best and its neighbours
    left, right = (low, d) if t == c else (c, high)
    p_left, p_right = (p_low, p_d) if t == c else (p_c, p_high)
    rise, fall = (p_t - p_left) / (t - left), (p_right - p_t) / (right - t)
    v = 0.5 * (left + t) + 0.5 * (right - left) * rise / (rise - fall)
    p_v, z_v = _pull(law, geometry, exp(v), limit, z, MEET_STEPS)
    return (v, p_v, z_v) if p_v > p_t else (t, p_t, z)
