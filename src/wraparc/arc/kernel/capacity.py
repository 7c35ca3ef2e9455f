"""What an arc could carry within a limit of creep or slip, and the least slack-side tension.

The tight side is held (T1 driving, T2 braking) and the slack side falls. On a braking pulley the
held tension is at the exit, so that the entry tension is an unknown too.
"""

from __future__ import annotations

from math import exp, inf, log, nan

from wraparc.arc.kernel.effort import CREEP, Aim, first_guess, jumps, mesh_steps
from wraparc.arc.kernel.gross_slip import plateau_capacity
from wraparc.arc.kernel.quantities import (
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
    side = geometry.side
    if side > 0.0:
        par = parameters_at(tight, geometry)
        guess = z if z == z else first_guess(law, par, aim)
        outcome, z, shot = refine(law, par, aim, guess, steps)
        return outcome, z, tight, shot
    # braking: the entry tension follows from the ratio found, and the ratio depends on it
    par = parameters_at(0.6 * tight, geometry)
    guess = z if z == z else first_guess(law, par, aim)
    met, z_met, entry, shot, _ = meet(
        law, geometry, aim, False, tight, 0.6 * tight, guess, inf, steps
    )
    if met:
        return SOLVED, z_met, entry, shot
    return _carry_bracketed(law, geometry, tight, aim, steps)


def _carry_bracketed(
    law: CompactLaw, geometry: Geometry, tight: float, aim: Aim, steps: int
) -> tuple[int, float, float, Shot]:
    """`carry` of a braking pulley where Newton's method fails: false position in ln T1."""
    radius, wrap, width = geometry.radius, geometry.wrap_angle, geometry.width
    high = log(tight)
    low = high - plateau_capacity(law, tight / (width * radius), wrap) - 1.0
    f_low, f_high, z = -1.0, 0.0, nan
    for i in range(80):
        if i == 0:
            t = high - 1e-3
        else:
            t = (low * f_high - high * f_low) / (f_high - f_low) if i > 3 else 0.5 * (low + high)
        par = parameters_at(exp(t), geometry)
        guess = z if z == z else first_guess(law, par, aim)
        outcome, z, shot = refine(law, par, aim, guess, steps)
        if outcome != SOLVED:
            return outcome, z, exp(t), shot
        f = t + shot.log_tension - log(tight)
        if abs(f) < 1e-10 or high - low < 1e-13:
            return SOLVED, z, exp(t), shot
        if f > 0.0:
            high, f_high, f_low = t, f, (0.5 * f_low if i > 3 else f_low)
        else:
            low, f_low, f_high = t, f, (0.5 * f_high if i > 3 else max(f_high, 1e-3))
    return UNSOLVED, z, exp(t), shot


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
    for _ in range(60):
        size = max(abs(r1), abs(r2))
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


def least_slack(  # noqa: C901 - one search, in order of effort
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
    met, _, entry_met, shot, growth = meet(
        law, geometry, Aim(CREEP, limit), True, pull, entry, z, 1.5 * tight_max, steps
    )
    if met and growth > 0.0:
        found = max(entry_met, entry_met * exp(shot.log_tension))
        if found <= tight_max:
            return found - pull, nan
    # off the easy road: does the pull still rise with tension at the top of the range?
    low, high = log(pull) + 1e-4, log(tight_max)
    if low >= high:
        return nan, _pull(law, geometry, tight_max, limit, z, steps)[0]
    p_top, z_top = _pull(law, geometry, exp(high), limit, nan, MEET_STEPS)
    step = min(0.02 * (high - low), 0.05)
    p_in, _ = _pull(law, geometry, exp(high - step), limit, z_top, MEET_STEPS)
    if p_in > p_top:
        bottom = max(low, high - 3.0)
        high, p_top = _most(law, geometry, limit, bottom, high, MEET_STEPS)
    if p_top < pull:
        return nan, _pull(law, geometry, exp(high), limit, z_top, steps)[0]
    z_last = nan
    for _ in range(60):
        t = 0.5 * (low + high)
        p, z_last = _pull(law, geometry, exp(t), limit, z_last, MEET_STEPS)
        if p < pull:
            low = t
        else:
            high = t
        if high - low < 0.02:
            break
    entry = exp(high) if geometry.side > 0.0 else exp(high) - pull
    met, _, entry_met, shot, _ = meet(
        law, geometry, Aim(CREEP, limit), True, pull, entry, z_last, inf, steps
    )
    found = max(entry_met, entry_met * exp(shot.log_tension))
    if met and found <= tight_max * (1.0 + 1e-9):
        return found - pull, nan
    # a flat road (friction that knows no slip): false position on the fine mesh (Illinois)
    low, high = low - 0.02, high + 0.02
    p_low, z_last = _pull(law, geometry, exp(low), limit, z_last, steps)
    p_high, z_last = _pull(law, geometry, exp(high), limit, z_last, steps)
    f_low, f_high = log(p_low / pull), log(p_high / pull)
    for _ in range(60):
        if f_low >= 0.0 or f_high <= 0.0:
            return nan, nan
        t = (low * f_high - high * f_low) / (f_high - f_low)
        p, z_last = _pull(law, geometry, exp(t), limit, z_last, steps)
        f = log(p / pull)
        if abs(f) < 1e-9 or high - low < 1e-12:
            return exp(t) - pull, nan
        if f > 0.0:
            high, f_high, f_low = t, f, 0.5 * f_low
        else:
            low, f_low, f_high = t, f, 0.5 * f_high
    return nan, nan


def _pull(
    law: CompactLaw,
    geometry: Geometry,
    tight: float,
    limit: float,
    z: float,
    steps: int,
) -> tuple[float, float]:
    """Pull carried at a creep limit with a held tight side [N], and the effort for it."""
    _, z, _, shot = carry(law, geometry, tight, Aim(CREEP, limit), z, steps)
    return tight * (1.0 - exp(-abs(shot.log_tension))), z


def _most(
    law: CompactLaw, geometry: Geometry, limit: float, a: float, b: float, steps: int
) -> tuple[float, float]:
    """ln(tight side) in [a, b] of the largest pull at a creep limit, and the pull [N]."""
    ratio = 0.6180339887498949
    z = nan
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    p_c, z = _pull(law, geometry, exp(c), limit, z, steps)
    p_d, z = _pull(law, geometry, exp(d), limit, z, steps)
    while b - a > 1e-2:
        if p_c >= p_d:
            b, d, p_d = d, c, p_c
            c = b - ratio * (b - a)
            p_c, z = _pull(law, geometry, exp(c), limit, z, steps)
        else:
            a, c, p_c = c, d, p_d
            d = a + ratio * (b - a)
            p_d, z = _pull(law, geometry, exp(d), limit, z, steps)
    return (c, p_c) if p_c >= p_d else (d, p_d)
