"""Solve an arc for its tensions, and find what it could carry: three capacities.

In every capacity the tight side is held (T1 driving, T2 braking) and the slack side falls. On a
braking pulley the held tension is at the exit, so that the entry tension is an unknown too.
"""

from __future__ import annotations

from math import exp, inf, log, nan

from wraparc.arc.kernel.march import (
    KICK,
    LENGTH,
    ONSET,
    RADIUS,
    RECORD,
    SHEAR,
    SIDE,
    T1,
    WIDTH,
    Buffer,
    Law,
    Parameters,
    parameters,
    room,
)
from wraparc.arc.kernel.shoot import (
    CREEP,
    EXHAUSTED,
    FOUND,
    STALLED,
    TENSION,
    Shot,
    attempt,
    carried_ratio,
    climb,
    effort_of,
    fire,
    first_guess,
    jumps,
    largest_effort,
    mesh_steps,
    ratio_of,
    search,
    tension_shot,
    value_of,
)
from wraparc.arc.kernel.stick import held_exit, stick_slip, zone_creep_ratio, zone_end
from wraparc.arc.kernel.tension_march import ARRIVED, STEP, applies, march, open_table, table_size
from wraparc.arc.profile import sort
from wraparc.friction.compact import plateau_at, segment_of

#: side, radius, wrap angle, width, 1/EA', h/G, kick, kick coefficient, onset; `parameters` adds T1
Geometry = tuple[float, float, float, float, float, float, float, float, float]

#: largest |ln(T1/T2)| that a march in tension goes to
LARGEST_LOG = 8.0
COARSE_STEPS = 8
MEET_STEPS = 12
COARSE_TOLERANCE = 1e-4  # relative
TOLERANCE = 1e-10

NO_PULL = 1e-11  # ln(tight/slack) that counts as none: of the size of rounding in a march

STUCK = 3  # outcome: the belt sticks over the whole wrap


def parameters_at(entry_tension: float, geometry: Geometry) -> Parameters:
    """Numbers of one drive at an entry tension [N]."""
    side, radius, wrap, width, compliance, shear, kick, coefficient, onset = geometry
    return parameters(
        entry_tension, side, radius, wrap, width, compliance, shear, kick, coefficient, onset
    )


def solve_tension(
    law: Law, par: Parameters, exit_tension: float, steps: int, none: Buffer
) -> tuple[int, float, Shot]:
    """Effort at which the exit tension is met.

    Returns
    -------
    outcome, z, shot
        FOUND; STUCK: the belt does not slip anywhere, the last number of the shot is the arc length
        (z is good to the precision of a difference only); EXHAUSTED: breakaway, see `gross_slip`.
    """
    goal = par[SIDE] * log(par[T1] / exit_tension)
    if jumps(law):
        held, creep = held_exit(law, par, exit_tension)
        if held:
            end = zone_end(law, par, par[LENGTH])[1]
            z = creep / end - 1.0 if end != 0.0 else 0.0
            return STUCK, z, stuck_shot(law, par, exit_tension, creep, 0, none)[0]
    if abs(goal) < NO_PULL and par[KICK] == 0.0:
        return FOUND, -inf, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    tight = max(par[T1], exit_tension) / (par[WIDTH] * par[RADIUS])
    if goal < plateau_capacity(law, tight, par[LENGTH] / par[RADIUS]):
        guess = first_guess(law, par, TENSION, goal)
        outcome, z, shot = refine(law, par, TENSION, goal, guess, steps, none)
        if outcome != EXHAUSTED:
            return outcome, z, shot
    z = largest_effort(law, par)
    return EXHAUSTED, z, fire(law, par, z, steps, 0, none)[0]


def stuck_shot(
    law: Law, par: Parameters, exit_tension: float, creep: float, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Exit quantities and profile of an arc that sticks throughout, with its creep at the exit."""
    length, compliance = par[LENGTH], par[SHEAR] + par[ONSET]
    g = zone_creep_ratio(par, length, creep)
    state, count = stick_slip(law, par, length, creep, g, 0, points, out)
    tau = creep / compliance if compliance > 0.0 else 0.0
    q = log(exit_tension / par[T1])
    return (q, state[1], creep, tau, state[2], g, length), count


def refine(
    law: Law, par: Parameters, target: int, goal: float, z: float, steps: int, none: Buffer
) -> tuple[int, float, Shot]:
    """Meet a target: by marches in tension where they apply, else in position, coarse then fine."""
    size = max(abs(goal), 1e-2) if target == TENSION else abs(goal)
    if applies(law, par) and goal > NO_PULL:
        fine = mesh_steps(law, par, steps)
        end = goal if target == TENSION else LARGEST_LOG
        table, scratch = room(table_size(end, fine)), room(STEP)
        open_table(law, par, end, fine, table)
        outcome, z_met, _, shot = search(
            law, par, target, goal, z, 0.0, steps, TOLERANCE * size, table, scratch, none
        )
        if outcome == FOUND:
            return outcome, z_met, shot
    outcome, z, slope, shot = search(
        law, par, target, goal, z, 0.0, COARSE_STEPS, COARSE_TOLERANCE * size, none, none, none
    )
    if outcome != FOUND:
        slope = 0.0
    outcome, z, _, shot = search(
        law, par, target, goal, z, slope, steps, TOLERANCE * size, none, none, none
    )
    if outcome == STALLED and abs(value_of(par, shot, target) - goal) < 1e-8 * size:
        outcome = FOUND
    return outcome, z, shot


def plateau_capacity(law: Law, tight_pressure: float, wrap_angle: float) -> float:
    """ln(tight/slack) at gross slip with the largest friction of the law everywhere.

    d ln T / d theta = -mu_plateau(p), integrated in ln p from the tight side: exact to rounding,
    piece by piece (Gauss-Legendre, 5 points, with the last piece closed by Newton's method).
    """
    kind, edges, c, slips = law
    q, angle = 0.0, wrap_angle
    for _ in range(4 * len(edges) + 400):
        p = tight_pressure * exp(-q)
        segment = segment_of(edges, p * (1.0 - 1e-12))
        span = 0.25
        if segment >= 0:
            span = min(span, log(p / edges[segment]))
        taken = _plateau_angle(law, tight_pressure, segment, q, span)
        if taken < angle:
            angle -= taken
            q += span
            continue
        part = span * angle / taken
        for _ in range(50):
            f = _plateau_angle(law, tight_pressure, segment, q, part) - angle
            mu = plateau_at(kind, edges, c, slips, segment, tight_pressure * exp(-q - part))
            change = f * mu
            part -= change
            if abs(change) < 1e-15:
                break
        return q + part
    return q


def _plateau_angle(law: Law, pressure: float, segment: int, q: float, span: float) -> float:
    """Wrap angle over which ln T falls from -q to -q - span at the plateau of one piece."""
    kind, edges, c, slips = law
    total = 0.0
    for node, weight in (
        (0.0, 128.0 / 225.0),
        (-0.5384693101056831, 0.47862867049936647),
        (0.5384693101056831, 0.47862867049936647),
        (-0.906179845938664, 0.23692688505618908),
        (0.906179845938664, 0.23692688505618908),
    ):
        p = pressure * exp(-q - 0.5 * span * (1.0 + node))
        total += weight / plateau_at(kind, edges, c, slips, segment, p)
    return 0.5 * span * total


def carry(
    law: Law,
    geometry: Geometry,
    tight: float,
    target: int,
    goal: float,
    z: float,
    steps: int,
    none: Buffer,
) -> tuple[int, float, float, Shot]:
    """Largest tension ratio of a held tight side at which a target of creep or slip is met.

    Parameters
    ----------
    tight
        Tension of the tight side [N].
    target, goal
        CREEP or SLIP at the exit towards the slack side, and its limit [m].
    z
        First guess of the effort, or nan.

    Returns
    -------
    outcome, z, entry tension [N], shot
    """
    side = geometry[0]
    if side > 0.0:
        par = parameters_at(tight, geometry)
        guess = z if z == z else first_guess(law, par, target, goal)
        outcome, z, shot = refine(law, par, target, goal, guess, steps, none)
        return outcome, z, tight, shot
    # braking: the entry tension follows from the ratio found, and the ratio depends on it
    par = parameters_at(0.6 * tight, geometry)
    guess = z if z == z else first_guess(law, par, target, goal)
    met, z_met, entry, shot, _ = meet(
        law, geometry, target, goal, False, tight, 0.6 * tight, guess, inf, steps, none
    )
    if met:
        return FOUND, z_met, entry, shot
    return _carry_bracketed(law, geometry, tight, target, goal, steps, none)


def _carry_bracketed(
    law: Law, geometry: Geometry, tight: float, target: int, goal: float, steps: int, none: Buffer
) -> tuple[int, float, float, Shot]:
    """`carry` of a braking pulley where Newton's method fails: false position in ln T1."""
    radius, wrap, width = geometry[1], geometry[2], geometry[3]
    high = log(tight)
    low = high - plateau_capacity(law, tight / (width * radius), wrap) - 1.0
    f_low, f_high, z = -1.0, 0.0, nan
    for i in range(80):
        if i == 0:
            t = high - 1e-3
        else:
            t = (low * f_high - high * f_low) / (f_high - f_low) if i > 3 else 0.5 * (low + high)
        par = parameters_at(exp(t), geometry)
        guess = z if z == z else first_guess(law, par, target, goal)
        outcome, z, shot = refine(law, par, target, goal, guess, steps, none)
        if outcome != FOUND:
            return outcome, z, exp(t), shot
        f = t + shot[0] - log(tight)
        if abs(f) < 1e-10 or high - low < 1e-13:
            return FOUND, z, exp(t), shot
        if f > 0.0:
            high, f_high, f_low = t, f, (0.5 * f_low if i > 3 else f_low)
        else:
            low, f_low, f_high = t, f, (0.5 * f_high if i > 3 else max(f_high, 1e-3))
    return STALLED, z, exp(t), shot


def meet(
    law: Law,
    geometry: Geometry,
    target: int,
    goal: float,
    of_pull: bool,
    tension: float,
    entry: float,
    z: float,
    most: float,
    steps: int,
    none: Buffer,
) -> tuple[bool, float, float, Shot, float]:
    """Entry tension and effort that meet a target at the exit and a tension together.

    Newton's method on a coarse mesh, then its Jacobian kept up to date by Broyden's formula on the
    fine one.

    Parameters
    ----------
    target, goal
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
    table, scratch = _capacity_table(law, geometry, entry, steps), room(STEP)
    mesh, fresh = MEET_STEPS, True
    case = (target, goal, of_pull, tension)
    r1, r2, shot = _misses(law, geometry, case, t, z, mesh, table, scratch, none)
    for _ in range(60):
        size = max(abs(r1), abs(r2))
        if mesh == steps and size < TOLERANCE * 10.0:
            det = j11 * j22 - j12 * j21
            return True, z, exp(t), shot, det * (1.0 if j11 > 0.0 else -1.0)
        if mesh < steps and size < 3e-4:
            mesh = steps
            r1, r2, shot = _misses(law, geometry, case, t, z, mesh, table, scratch, none)
            continue
        if fresh:
            dz, dt = 1e-4, 1e-4
            a1, a2, _ = _misses(law, geometry, case, t, z + dz, mesh, table, scratch, none)
            b1, b2, _ = _misses(law, geometry, case, t + dt, z, mesh, table, scratch, none)
            j11, j21 = (a1 - r1) / dz, (a2 - r2) / dz
            j12, j22 = (b1 - r1) / dt, (b2 - r2) / dt
        det = j11 * j22 - j12 * j21
        if det == 0.0:
            return False, z, exp(t), shot, 0.0
        dz, dt = (r2 * j12 - r1 * j22) / det, (r1 * j21 - r2 * j11) / det
        scale = min(1.0, 1.5 / max(abs(dz), 1e-300), 0.5 / max(abs(dt), 1e-300))
        dz, dt = scale * dz, scale * dt
        z, t = z + dz, t + dt
        if t > log(most):
            return False, z, exp(t), shot, 0.0
        n1, n2, shot = _misses(law, geometry, case, t, z, mesh, table, scratch, none)
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


def _capacity_table(law: Law, geometry: Geometry, tension: float, steps: int) -> Buffer:
    """Buffer for the tables of marches to the exit at about an entry tension [N]."""
    fine = mesh_steps(law, parameters_at(tension, geometry), steps)
    return room(table_size(LARGEST_LOG, 2 * fine))


def _misses(
    law: Law,
    geometry: Geometry,
    case: tuple[int, float, bool, float],
    t: float,
    z: float,
    steps: int,
    table: Buffer,
    scratch: Buffer,
    none: Buffer,
) -> tuple[float, float, Shot]:
    """Relative misses of the target and of the tension, for ln T1 = t and effort z."""
    target, goal, of_pull, tension = case
    par = parameters_at(exp(t), geometry)
    went = False
    if applies(law, par):
        open_table(law, par, LARGEST_LOG, mesh_steps(law, par, steps), table)
        went, miss, shot = attempt(law, par, target, goal, z, steps, table, scratch, none)
    if not went:
        _, miss, shot = attempt(law, par, target, goal, z, steps, none, none, none)
    miss /= goal
    if not of_pull:
        return miss, t + shot[0] - log(tension), shot
    pull = par[T1] * abs(1.0 - exp(shot[0]))
    return miss, log(max(pull, 1e-9 * tension) / tension), shot


def profile_size(law: Law, par: Parameters, steps: int, points: int) -> int:
    """Numbers that the records of `trace` need: points, nodes and kinks."""
    return RECORD * (points + 4 * mesh_steps(law, par, steps) + 600)


def trace(
    law: Law, par: Parameters, exit_tension: float, z: float, steps: int, points: int, out: Buffer
) -> tuple[Shot, int]:
    """Profile of an arc solved by `solve_tension`: exit quantities and the number of records."""
    goal = par[SIDE] * log(par[T1] / exit_tension)
    if jumps(law):
        held, creep = held_exit(law, par, exit_tension)
        if held:
            return stuck_shot(law, par, exit_tension, creep, points, out)
    if applies(law, par) and goal > NO_PULL:
        fine = mesh_steps(law, par, steps)
        table, scratch = room(table_size(goal, fine)), room(STEP)
        open_table(law, par, goal, fine, table)
        gamma = par[SIDE] * ratio_of(par, z)
        status, q, s, a, work, _ = march(law, par, gamma, False, table, scratch, 0, out[:0])
        if status == ARRIVED and abs(s / par[LENGTH] - 1.0) < TOLERANCE * 100.0:
            count = march(law, par, gamma, False, table, scratch, points, out)[5]
            sort(out, count)
            return tension_shot(law, par, gamma, q, a, work), count
    shot, count = fire(law, par, z, steps, points, out)
    sort(out, count)
    return shot, count


def largest_ratio(
    law: Law,
    geometry: Geometry,
    tight: float,
    softening: bool,
    steps: int,
    none: Buffer,
) -> tuple[float, float]:
    """Gross-slip capacity of a held tight side: ln(tight/slack), and the exit creep there [m].

    A law flat past its peak has a supremum, with the friction of its plateau everywhere and no
    finite creep (inf). A softening law has a largest ratio over entry creep ratios below 1.
    """
    radius, wrap, width = geometry[1], geometry[2], geometry[3]
    supremum = plateau_capacity(law, tight / (width * radius), wrap)
    if not softening:
        return supremum, inf
    best, creep, _, _ = gross_slip(law, geometry, tight, supremum, steps, none)
    return best, creep


def gross_slip(
    law: Law, geometry: Geometry, tight: float, guess: float, steps: int, none: Buffer
) -> tuple[float, float, float, float]:
    """Largest tension ratio of a held tight side over entry creep ratios below 1.

    Parameters
    ----------
    tight
        Tension of the tight side [N].
    guess
        A guess of ln(tight/slack).

    Returns
    -------
    ratio, creep, entry, z
        ln(tight/slack), the exit creep towards the slack side [m], the entry tension [N] and the
        effort there.
    """
    side = geometry[0]
    table, scratch = _capacity_table(law, geometry, tight, steps), room(STEP)
    entry = tight if side > 0.0 else tight * exp(-guess)
    best, creep, z, last, miss_last, change = guess, 0.0, -inf, 0.0, 0.0, inf
    for i in range(40):
        par = parameters_at(entry, geometry)
        new, creep, z = _peak_of(law, par, z, steps, table, scratch, none)
        before, change, best = abs(change), new - best, new
        # a flat peak is found to some 1e-6 only: no use in going on where changes stop falling
        stalled = i > 7 and before < 1e-5 and abs(change) > 0.5 * before
        if side > 0.0 or abs(change) < 1e-8 or stalled:
            break
        # braking: ln T1 = ln T2 - best(T1), by secants after the first substitution
        aim = log(tight) - best
        miss = aim - log(entry)
        if i > 0 and miss != miss_last:
            aim = log(entry) - miss * (log(entry) - last) / (miss - miss_last)
        last, miss_last = log(entry), miss
        entry = exp(aim)
    return best, creep, entry, z


def _peak_of(
    law: Law,
    par: Parameters,
    near: float,
    steps: int,
    table: Buffer,
    scratch: Buffer,
    none: Buffer,
) -> tuple[float, float, float]:
    """Largest ln(tight/slack) over effort, the creep there [m] and the effort.

    `near` narrows the search to the neighbourhood of an earlier result.
    """
    coarse = min(MEET_STEPS, steps)
    top = largest_effort(law, par)
    if jumps(law):
        low, high = 0.0, top
    else:
        low, high = effort_of(par, par[SIDE] * 1e-5), top
    width = 1e-2
    if near > -inf:
        low, high, width = max(low, near - 0.2), min(high, near + 0.2), 1e-2
    buffer = none
    if applies(law, par):
        open_table(law, par, LARGEST_LOG, mesh_steps(law, par, coarse), table)
        buffer = table
    if near == -inf:
        # static and residual friction may each have a maximum: which is the larger?
        parts, best, at = 8, -inf, 0
        for i in range(parts + 1):
            z = low + (high - low) * i / parts
            value, _ = carried_ratio(law, par, z, coarse, buffer, scratch, none)
            if value > best:
                best, at = value, i
        span = (high - low) / parts
        low, high = low + span * max(at - 1, 0), low + span * min(at + 1, parts)
    z, shot = climb(law, par, low, high, width, coarse, buffer, scratch, none)
    value, _ = carried_ratio(law, par, high, coarse, buffer, scratch, none)
    if value > value_of(par, shot, TENSION):
        z = high
    # sought on the coarse mesh, told on the fine one; a sharp peak is sought there again
    if len(buffer) > 0:
        open_table(law, par, LARGEST_LOG, mesh_steps(law, par, steps), table)
    if z < high:
        low, high = max(low, z - 0.03), min(high, z + 0.03)
        z, shot = climb(law, par, low, high, 2e-4, steps, buffer, scratch, none)
        return value_of(par, shot, TENSION), par[SIDE] * shot[2], z
    value, shot = carried_ratio(law, par, z, steps, buffer, scratch, none)
    return value, par[SIDE] * shot[2], z


def least_slack(  # noqa: C901 - one search, in order of effort
    law: Law,
    geometry: Geometry,
    pull: float,
    limit: float,
    tight: float,
    entry: float,
    z: float,
    tight_max: float,
    steps: int,
    none: Buffer,
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
        law, geometry, CREEP, limit, True, pull, entry, z, 1.5 * tight_max, steps, none
    )
    if met and growth > 0.0:
        found = max(entry_met, entry_met * exp(shot[0]))
        if found <= tight_max:
            return found - pull, nan
    # off the easy road: does the pull still rise with tension at the top of the range?
    low, high = log(pull) + 1e-4, log(tight_max)
    if low >= high:
        return nan, _pull(law, geometry, tight_max, limit, z, steps, none)[0]
    p_top, z_top = _pull(law, geometry, exp(high), limit, nan, MEET_STEPS, none)
    step = min(0.02 * (high - low), 0.05)
    p_in, _ = _pull(law, geometry, exp(high - step), limit, z_top, MEET_STEPS, none)
    if p_in > p_top:
        bottom = max(low, high - 3.0)
        high, p_top = _most(law, geometry, limit, bottom, high, MEET_STEPS, none)
    if p_top < pull:
        return nan, _pull(law, geometry, exp(high), limit, z_top, steps, none)[0]
    z_last = nan
    for _ in range(60):
        t = 0.5 * (low + high)
        p, z_last = _pull(law, geometry, exp(t), limit, z_last, MEET_STEPS, none)
        if p < pull:
            low = t
        else:
            high = t
        if high - low < 0.02:
            break
    entry = exp(high) if geometry[0] > 0.0 else exp(high) - pull
    met, _, entry_met, shot, _ = meet(
        law, geometry, CREEP, limit, True, pull, entry, z_last, inf, steps, none
    )
    found = max(entry_met, entry_met * exp(shot[0]))
    if met and found <= tight_max * (1.0 + 1e-9):
        return found - pull, nan
    # a flat road (friction that knows no slip): false position on the fine mesh (Illinois)
    low, high = low - 0.02, high + 0.02
    p_low, z_last = _pull(law, geometry, exp(low), limit, z_last, steps, none)
    p_high, z_last = _pull(law, geometry, exp(high), limit, z_last, steps, none)
    f_low, f_high = log(p_low / pull), log(p_high / pull)
    for _ in range(60):
        if f_low >= 0.0 or f_high <= 0.0:
            return nan, nan
        t = (low * f_high - high * f_low) / (f_high - f_low)
        p, z_last = _pull(law, geometry, exp(t), limit, z_last, steps, none)
        f = log(p / pull)
        if abs(f) < 1e-9 or high - low < 1e-12:
            return exp(t) - pull, nan
        if f > 0.0:
            high, f_high, f_low = t, f, 0.5 * f_low
        else:
            low, f_low, f_high = t, f, 0.5 * f_high
    return nan, nan


def _pull(
    law: Law,
    geometry: Geometry,
    tight: float,
    limit: float,
    z: float,
    steps: int,
    none: Buffer,
) -> tuple[float, float]:
    """Pull carried at a creep limit with a held tight side [N], and the effort for it."""
    _, z, _, shot = carry(law, geometry, tight, CREEP, limit, z, steps, none)
    return tight * (1.0 - exp(-abs(shot[0]))), z


def _most(
    law: Law, geometry: Geometry, limit: float, a: float, b: float, steps: int, none: Buffer
) -> tuple[float, float]:
    """ln(tight side) in [a, b] of the largest pull at a creep limit, and the pull [N]."""
    ratio = 0.6180339887498949
    z = nan
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    p_c, z = _pull(law, geometry, exp(c), limit, z, steps, none)
    p_d, z = _pull(law, geometry, exp(d), limit, z, steps, none)
    while b - a > 1e-2:
        if p_c >= p_d:
            b, d, p_d = d, c, p_c
            c = b - ratio * (b - a)
            p_c, z = _pull(law, geometry, exp(c), limit, z, steps, none)
        else:
            a, c, p_c = c, d, p_d
            d = a + ratio * (b - a)
            p_d, z = _pull(law, geometry, exp(d), limit, z, steps, none)
    return (c, p_c) if p_c >= p_d else (d, p_d)
