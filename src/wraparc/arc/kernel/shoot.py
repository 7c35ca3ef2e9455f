"""Find the one unknown of an arc: how far the whole belt creeps, so that a target is met.

The unknown is carried as an *effort* z that grows with creep towards the slack side. For laws that
rise from zero it is the logarithm of the entry creep ratio (with a kick, where the ratio may have
either sign, its inverse hyperbolic sine). For laws that start with a jump it is -1 .. 0 while the
belt sticks over the whole wrap, in proportion to its creep at the exit, and sets the length of the
stuck zone above that; where that vanishes (no shear of the lagging), the entry creep ratio.
"""

from __future__ import annotations

from math import asinh, exp, inf, log, sinh, sqrt

from wraparc.arc.kernel import tension_march
from wraparc.arc.kernel.march import (
    COMPLIANCE,
    KICK,
    LENGTH,
    ONSET,
    P1,
    RADIUS,
    SHEAR,
    SIDE,
    T1,
    WIDTH,
    Buffer,
    Law,
    Parameters,
    State,
    stress_and_creep,
    sweep,
)
from wraparc.arc.kernel.stick import (
    onset_stress,
    stick_slip,
    zone_creep_ratio,
    zone_end,
    zone_point,
)
from wraparc.friction.compact import (
    KNOTS,
    LIMIT,
    PIECES,
    TABLE,
    friction_at,
    peak,
    plateau_at,
    segment_of,
)

# what a target is of
TENSION = 0  # ln(tight / slack)
CREEP = 1  # creep at the exit towards the slack side [m]
SLIP = 2  # slip at the exit towards the slack side [m]

# outcomes
FOUND, EXHAUSTED, STALLED, LOST = 0, 1, 2, 4

#: entry creep ratio where the scale of z turns from logarithmic to linear
SMALL_RATIO = 1e-7
LARGEST_RATIO = 1.0
LAGS_PER_MESH = 2.0  # shear-lag lengths that the given number of mesh steps resolves
CREEP_SCALE = (
    6.35e-3  # of the ratio that follows on a vanished rest arc, z in units of it per arc [m]
)

#: an arc marched to its exit: ln(T2/T1), slip, creep, shear stress, friction work, g, stuck length
Shot = tuple[float, float, float, float, float, float, float]


def jumps(law: Law) -> bool:
    """Whether a law holds the belt without slip."""
    kind, _, c, _ = law
    return (kind == LIMIT and c[3] == 0.0) or (kind == TABLE and c[0] > 0.0)


def ratio_of(par: Parameters, z: float) -> float:
    """Entry creep ratio of an effort, laws without a jump [-]."""
    if par[KICK] > 0.0:
        return par[SIDE] * SMALL_RATIO * sinh(z)
    return par[SIDE] * SMALL_RATIO * exp(z)


def effort_of(par: Parameters, g: float) -> float:
    """Effort of an entry creep ratio, laws without a jump; the inverse of :func:`ratio_of`."""
    r = par[SIDE] * g / SMALL_RATIO
    if par[KICK] > 0.0:
        return asinh(r)
    return log(r) if r > 0.0 else -60.0


def largest_effort(law: Law, par: Parameters) -> float:
    """Effort at which the entry creep ratio is 1."""
    if not jumps(law):
        return effort_of(par, par[SIDE] * LARGEST_RATIO)
    compliance = par[SHEAR] + par[ONSET]
    if compliance == 0.0:
        return 1.0 + LARGEST_RATIO * par[LENGTH] / CREEP_SCALE
    u = compliance * onset_stress(law, par[P1])[0]
    return max(par[LENGTH] / u, 10.0)


def lowest_effort(law: Law, par: Parameters) -> float:
    """Effort below which nothing is sought: creep well beyond the kick towards the tight side."""
    if jumps(law):
        return -3.0
    if par[KICK] > 0.0:
        return effort_of(par, -par[SIDE] * 1e3 * par[KICK] / par[LENGTH])
    return -60.0


def mesh_steps(law: Law, par: Parameters, steps: int) -> int:
    """Mesh steps for an arc: more where the belt hands over its tension in a short exit part.

    Creep grows like exp(s/l) where friction is nearly proportional to slip; l follows from the
    shear of the lagging and the slip at small friction, in series.
    """
    kind, edges, c, slips = law
    p = par[P1]
    segment = segment_of(edges, p)
    if kind == LIMIT and c[3] == 0.0:
        return steps
    if kind == LIMIT:
        slip, mu = c[3], 1.0 / p
    elif kind == TABLE:
        mu, _, _ = friction_at(kind, edges, c, slips, segment, 1, slips[1], p)
        slip = slips[1]
    else:
        slip_pk, mu_pk, _, _ = peak(kind, edges, c, segment, p)
        slip, mu = 0.18 * slip_pk, mu_pk
    lag = sqrt((par[SHEAR] + slip / (mu * p)) / (par[WIDTH] * par[COMPLIANCE]))
    return int(steps * max(1.0, par[LENGTH] / (LAGS_PER_MESH * lag)))


def fire(
    law: Law, par: Parameters, z: float, steps: int, points: int, out: Buffer
) -> tuple[Shot, int]:
    """March one arc at effort z; `points` and `out` as :func:`wraparc.arc.kernel.march.sweep`."""
    zone = 0.0
    steps = mesh_steps(law, par, steps)
    if jumps(law):
        length = par[LENGTH]
        compliance = par[SHEAR] + par[ONSET]
        end = g = 0.0
        if compliance == 0.0:
            zone = length * min(max(1.0 - z, 0.0), 1.0)
            if z > 1.0:
                g = par[SIDE] * (z - 1.0) * CREEP_SCALE / length
        else:
            zone = length / (1.0 + max(z, 0.0))
            end = zone_end(law, par, zone)[1]
            if z < 0.0:
                end *= 1.0 + z
            g = zone_creep_ratio(par, zone, end)
        state, count = stick_slip(law, par, zone, end, g, steps, points, out)
        if zone >= length:
            creep = zone_point(par, length, length, end)[1]
            tau = creep / compliance if compliance > 0.0 else 0.0
            return (state[0], state[1], creep, tau, state[2], g, zone), count
    else:
        g = ratio_of(par, z)
        state, count = sweep(law, par, g, steps, points, out)
    return shot_of(law, par, state, g, zone), count


def shot_of(law: Law, par: Parameters, state: State, g: float, zone: float) -> Shot:
    """Exit quantities of a state at the exit."""
    tau, creep = stress_and_creep(law, par, state)
    return (state[0], state[1], creep, tau, state[2], g, zone)


def value_of(par: Parameters, shot: Shot, target: int) -> float:
    """Value of a shot that a target is compared with; it grows with effort."""
    if target == TENSION:
        return -par[SIDE] * shot[0]
    if target == CREEP:
        return par[SIDE] * shot[2]
    return par[SIDE] * shot[1]


def first_guess(law: Law, par: Parameters, target: int, goal: float) -> float:
    """Effort from the creep that a rigid belt of uniform pressure would need."""
    if jumps(law):
        if target != TENSION:
            return 1.0
        tau, _ = onset_stress(law, par[P1])
        share = min(goal * par[RADIUS] * par[P1] / (tau * par[LENGTH]), 0.98)
        return share if par[SHEAR] + par[ONSET] == 0.0 else share / (1.0 - share)
    length = par[LENGTH]
    if target == TENSION:
        pressure = par[P1] * exp(-0.5 * par[SIDE] * goal)
        mean = goal * par[RADIUS] / length
        slip = _slip_for(law, pressure, 1.6 * mean)
        creep = slip + par[SHEAR] * 1.4 * mean * pressure
        pull = par[T1] * abs(1.0 - exp(-par[SIDE] * goal))
    else:
        creep = goal
        pull = 0.5 * par[T1]
    shrinkage = 0.35 * par[COMPLIANCE] * pull * length
    spare = creep - shrinkage - par[SIDE] * par[KICK]
    spare = max(spare, 0.05 * creep if par[KICK] == 0.0 else -0.25 * par[KICK])
    return effort_of(par, par[SIDE] * spare / length)


def _slip_for(law: Law, pressure: float, friction: float) -> float:
    """Slip at which a law without a jump gives about this friction, its peak if it cannot [m]."""
    kind, edges, c, slips = law
    segment = segment_of(edges, pressure)
    if kind in (KNOTS, PIECES):
        slip_pk, mu_pk, _, _ = peak(kind, edges, c, segment, pressure)
        m = friction / mu_pk
        if m >= 0.95:
            return slip_pk
        if m < 1e-6:
            return 0.05 * m * slip_pk
        r = 0.3 * m
        for _ in range(4):  # r (1 - ln r) = m
            r = min(max(r + (m - r * (1.0 - log(r))) / -log(r), 0.3 * r), 0.9)
        return r * slip_pk
    if kind == LIMIT:
        return c[3] * pressure * min(friction, plateau_at(kind, edges, c, slips, segment, pressure))
    for i in range(1, len(slips)):
        mu, _, _ = friction_at(kind, edges, c, slips, segment, i, slips[i], pressure)
        if mu >= friction:
            return slips[i]
    return slips[len(slips) - 1]


def attempt(
    law: Law,
    par: Parameters,
    target: int,
    goal: float,
    z: float,
    steps: int,
    table: Buffer,
    scratch: Buffer,
    none: Buffer,
) -> tuple[bool, float, Shot]:
    """March at effort z, in tension where there is a table: whether it went, value - goal, shot."""
    if len(table) == 0:
        shot, _ = fire(law, par, z, steps, 0, none)
        return True, value_of(par, shot, target) - goal, shot
    gamma = par[SIDE] * ratio_of(par, z)
    status, q, s, a, work, _ = tension_march.march(
        law, par, gamma, target != TENSION, table, scratch, 0, none
    )
    shot = tension_shot(law, par, gamma, q, a, work)
    if status != tension_march.ARRIVED:
        return False, 0.0, shot
    if target == TENSION:
        # the tensions are met at s; they would be at the exit if s were L
        return True, goal * log(par[LENGTH] / s), shot
    return True, value_of(par, shot, target) - goal, shot


def tension_shot(law: Law, par: Parameters, gamma: float, q: float, a: float, work: float) -> Shot:
    """Exit quantities of a march in tension."""
    side = par[SIDE]
    tau, creep = tension_march.exit_state(law, par, q, a)
    return (-side * q, side * a, side * creep, side * tau, work, side * gamma, 0.0)


def search(  # noqa: C901 - one root search with its ways out
    law: Law,
    par: Parameters,
    target: int,
    goal: float,
    z: float,
    slope: float,
    steps: int,
    tolerance: float,
    table: Buffer,
    scratch: Buffer,
    none: Buffer,
) -> tuple[int, float, float, Shot]:
    """Least effort at which the value of a target meets its goal.

    Secant steps, first until the goal is bracketed, then kept inside the bracket. Where the value
    falls with effort before it meets the goal (a softening law), its largest value is sought.

    Parameters
    ----------
    target, goal
        TENSION, CREEP or SLIP, and its value.
    z, slope
        First guess and the slope of the value there; slope 0 for an estimate.
    steps
        Mesh steps of a march.
    tolerance
        Largest distance from the goal.
    table, scratch
        Buffers of a march in tension, see :mod:`wraparc.arc.kernel.tension_march`; empty for one in
        position.
    none
        An empty buffer.

    Returns
    -------
    outcome, z, slope, shot
        FOUND; EXHAUSTED: no effort gives the goal, z gives the largest value; STALLED: the goal
        lies between two neighbouring numbers; LOST: the march in tension does not apply.
    """
    top = largest_effort(law, par)
    jump = jumps(law)
    bottom = lowest_effort(law, par)
    low, high = bottom, inf
    z = min(z, top)
    went, f, shot = attempt(law, par, target, goal, z, steps, table, scratch, none)
    z_last, f_last = z, 0.0
    if slope <= 0.0:
        slope = 0.8 * max(f + goal, 0.2 * goal)
    width = inf
    climbed = False
    astray = 0
    for i in range(120):
        if not went:
            # too little effort for slip to keep its direction: look for more
            astray += 1
            low = max(low, z)
            new = 0.5 * (low + high) if high < inf else z + 3.0
            if astray > 8 or new > top:
                return LOST, z, slope, shot
            z_last = z = new
            went, f, shot = attempt(law, par, target, goal, z, steps, table, scratch, none)
            f_last = f
            continue
        if abs(f) <= tolerance:
            return FOUND, z, slope, shot
        if f < 0.0:
            low = max(low, z)
        else:
            high = min(high, z)
        if i > 0 and z != z_last and f != f_last:
            slope = (f - f_last) / (z - z_last)
        if f < 0.0 and high == inf and (slope < 1e-12 or z >= top):
            if climbed or target != TENSION or len(table) > 0:
                return EXHAUSTED, z, slope, shot
            climbed = True
            peak_low, peak_high = min(z, z_last) - 6.0, min(max(z, z_last) + 1.0, top)
            if jump:
                peak_low, peak_high = 0.0, top
            z, shot = climb(law, par, peak_low, peak_high, 1e-6, steps, none, none, none)
            f = value_of(par, shot, target) - goal
            if f < -tolerance:
                return EXHAUSTED, z, slope, shot
            low, z_last, f_last, slope = bottom, z, f, 0.5 * goal
            if f < 0.0:
                return FOUND, z, slope, shot
            high = z
        new = z - f / slope if slope > 0.0 else z - 1.0
        if high == inf or (low == bottom and f > 0.0 and z - low > 5.0):
            reach = 2.5 if not jump else max(1.0, 2.0 * z)
            new = min(max(new, z - reach), z + reach, top)
        elif i % 2 == 0:
            # inside the bracket; halve it when two secant steps have not
            if high - low > 0.5 * width:
                new = 0.5 * (low + high)
            width = high - low
        if not low < new < high:
            new = 0.5 * (low + high) if high < inf else top
        if new == z:
            return STALLED, z, slope, shot
        z_last, f_last = z, f
        z = new
        went, f, shot = attempt(law, par, target, goal, z, steps, table, scratch, none)
    return STALLED, z, slope, shot


def climb(  # noqa: C901 - Brent's method as published
    law: Law,
    par: Parameters,
    a: float,
    b: float,
    width: float,
    steps: int,
    table: Buffer,
    scratch: Buffer,
    none: Buffer,
) -> tuple[float, Shot]:
    """Effort in [a, b] of the largest tension ratio, to within `width`.

    Golden section, sped up by parabolas through the three best points (R. P. Brent, "Algorithms for
    minimization without derivatives", 1973, chapter 5).
    """
    golden = 0.3819660112501051
    x = a + golden * (b - a)
    f_x, shot = carried_ratio(law, par, x, steps, table, scratch, none)
    w = v = x
    f_w = f_v = f_x
    move = before = 0.0
    for _ in range(80):
        middle = 0.5 * (a + b)
        if abs(x - middle) + 0.5 * (b - a) <= 2.0 * width:
            break
        parabolic = False
        if abs(before) > width:
            r = (x - w) * (f_v - f_x)
            q = (x - v) * (f_w - f_x)
            p = (x - v) * q - (x - w) * r
            q = 2.0 * (q - r)
            p = -p if q > 0.0 else p
            q = abs(q)
            if abs(p) < abs(0.5 * q * before) and q * (a - x) < p < q * (b - x):
                before, move = move, p / q
                parabolic = True
                if x + move - a < 2.0 * width or b - x - move < 2.0 * width:
                    move = width if middle >= x else -width
        if not parabolic:
            before = (b - x) if x < middle else (a - x)
            move = golden * before
        u = x + (move if abs(move) >= width else (width if move > 0.0 else -width))
        f_u, shot_u = carried_ratio(law, par, u, steps, table, scratch, none)
        if f_u >= f_x:
            if u >= x:
                a = x
            else:
                b = x
            v, f_v, w, f_w, x, f_x, shot = w, f_w, x, f_x, u, f_u, shot_u
        else:
            if u < x:
                a = u
            else:
                b = u
            if f_u >= f_w or w == x:
                v, f_v, w, f_w = w, f_w, u, f_u
            elif f_u >= f_v or v in (x, w):
                v, f_v = u, f_u
    return x, shot


def carried_ratio(
    law: Law, par: Parameters, z: float, steps: int, table: Buffer, scratch: Buffer, none: Buffer
) -> tuple[float, Shot]:
    """ln(tight/slack) carried with effort z, and the shot."""
    if len(table) > 0:
        # the exit slip is a target that marches to the exit
        went, _, shot = attempt(law, par, SLIP, 0.0, z, steps, table, scratch, none)
        if went:
            return value_of(par, shot, TENSION), shot
    shot, _ = fire(law, par, z, steps, 0, none)
    return value_of(par, shot, TENSION), shot
