"""Search the effort that meets an aim, or that carries the largest tension ratio."""

from __future__ import annotations

from math import inf, log

from wraparc.arc.kernel import tension_march
from wraparc.arc.kernel.effort import (
    SLIP,
    TENSION,
    Aim,
    jumps,
    largest_effort,
    lowest_effort,
    mesh_steps,
    ratio_of,
    shoot_from,
    value_of,
)
from wraparc.arc.kernel.quantities import (
    BREAKAWAY,
    LOST,
    SOLVED,
    UNSOLVED,
    Buffer,
    Parameters,
    Shot,
    zeros,
)
from wraparc.arc.kernel.tension_table import applies, open_table, table_size
from wraparc.friction.compact import CompactLaw

LARGEST_LOG = 8.0  # largest |ln(T1/T2)| that a march in tension goes to
COARSE_STEPS = 8  # of the first search in position; decides speed only
COARSE_TOLERANCE = 1e-4  # relative
TOLERANCE = 1e-10
NO_PULL = 1e-11  # ln(tight/slack) that counts as none: of the size of rounding in a march
NEARLY_IDLE = 1e-4  # ln(tight/slack) below which a miss counts as one of this


def refine(
    law: CompactLaw, par: Parameters, aim: Aim, z: float, steps: int
) -> tuple[int, float, Shot]:
    """Meet an aim: by marches in tension where they apply, else in position, coarse then fine."""
    size = max(abs(aim.value), NEARLY_IDLE) if aim.of == TENSION else abs(aim.value)
    if applies(law, par) and aim.value > NO_PULL:
        fine = mesh_steps(law, par, steps)
        end = aim.value if aim.of == TENSION else LARGEST_LOG
        table = zeros(table_size(end, fine))
        open_table(law, par, end, fine, table)
        outcome, z_met, _, shot = search(law, par, aim, z, 0.0, steps, TOLERANCE * size, table)
        if outcome == SOLVED:
            return outcome, z_met, shot
    no_table = zeros(0)
    outcome, z, slope, shot = search(
        law, par, aim, z, 0.0, COARSE_STEPS, COARSE_TOLERANCE * size, no_table
    )
    if outcome != SOLVED:
        slope = 0.0
    outcome, z, _, shot = search(law, par, aim, z, slope, steps, TOLERANCE * size, no_table)
    if outcome == UNSOLVED and abs(value_of(par, shot, aim.of) - aim.value) < 1e-8 * size:
        outcome = SOLVED
    return outcome, z, shot


def attempt(
    law: CompactLaw,
    par: Parameters,
    aim: Aim,
    z: float,
    steps: int,
    table: Buffer,
) -> tuple[bool, float, Shot]:
    """March at effort z, in tension where there is a table: whether it went, the miss, the shot."""
    if len(table) == 0:
        shot, _ = shoot_from(law, par, z, steps, 0, zeros(0))
        return True, value_of(par, shot, aim.of) - aim.value, shot
    gamma = par.side * ratio_of(par, z)
    to_exit = aim.of != TENSION
    status, q, s, a, work, _ = tension_march.march(law, par, gamma, to_exit, table, 0, zeros(0))
    shot = tension_shot(law, par, gamma, q, a, work)
    if status != SOLVED:
        return False, 0.0, shot
    if aim.of == TENSION:
        # the tensions are met at s; they would be at the exit if s were L
        return True, aim.value * log(par.length / s), shot
    return True, value_of(par, shot, aim.of) - aim.value, shot


def tension_shot(
    law: CompactLaw, par: Parameters, gamma: float, q: float, a: float, work: float
) -> Shot:
    """Exit quantities of a march in tension."""
    side = par.side
    tau, creep = tension_march.exit_state(law, par, q, a)
    return Shot(-side * q, side * a, side * creep, side * tau, work, side * gamma, 0.0)


def search(  # noqa: C901 - one root search with its ways out
    law: CompactLaw,
    par: Parameters,
    aim: Aim,
    z: float,
    slope: float,
    steps: int,
    tolerance: float,
    table: Buffer,
) -> tuple[int, float, float, Shot]:
    """Least effort at which the value of a target meets its goal.

    Secant steps, first until the goal is bracketed, then kept inside the bracket. Where the value
    falls with effort before it meets the goal (a softening law), its largest value is sought.

    Parameters
    ----------
    aim
        TENSION, CREEP or SLIP, and its value.
    z, slope
        First guess and the slope of the value there; slope 0 for an estimate.
    steps
        Mesh steps of a march.
    tolerance
        Largest distance from the goal.
    table
        Of a march in tension, see :mod:`wraparc.arc.kernel.tension_march`; empty for one in
        position.

    Returns
    -------
    outcome, z, slope, shot
        SOLVED; BREAKAWAY: no effort gives the goal, z gives the largest value; UNSOLVED: the goal
        lies between two neighbouring numbers; LOST: the march in tension does not apply.
    """
    top = largest_effort(law, par)
    jump = jumps(law)
    bottom = lowest_effort(law, par)
    low, high = bottom, inf
    z = min(z, top)
    went, f, shot = attempt(law, par, aim, z, steps, table)
    z_last, f_last = z, 0.0
    if slope <= 0.0:
        slope = 0.8 * max(f + aim.value, 0.2 * aim.value)
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
            went, f, shot = attempt(law, par, aim, z, steps, table)
            f_last = f
            continue
        if abs(f) <= tolerance:
            return SOLVED, z, slope, shot
        if f < 0.0:
            low = max(low, z)
        else:
            high = min(high, z)
        if i > 0 and z != z_last and f != f_last:
            slope = (f - f_last) / (z - z_last)
        if f < 0.0 and high == inf and (slope < 1e-12 or z >= top):
            if climbed or aim.of != TENSION or len(table) > 0:
                return BREAKAWAY, z, slope, shot
            climbed = True
            peak_low, peak_high = min(z, z_last) - 6.0, min(max(z, z_last) + 1.0, top)
            if jump:
                peak_low, peak_high = 0.0, top
            z, shot = climb(law, par, peak_low, peak_high, 1e-6, steps, zeros(0))
            f = value_of(par, shot, aim.of) - aim.value
            if f < -tolerance:
                return BREAKAWAY, z, slope, shot
            low, z_last, f_last, slope = bottom, z, f, 0.5 * aim.value
            if f < 0.0:
                return SOLVED, z, slope, shot
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
            return UNSOLVED, z, slope, shot
        z_last, f_last = z, f
        z = new
        went, f, shot = attempt(law, par, aim, z, steps, table)
    return UNSOLVED, z, slope, shot


def climb(  # noqa: C901 - Brent's method as published
    law: CompactLaw,
    par: Parameters,
    a: float,
    b: float,
    width: float,
    steps: int,
    table: Buffer,
) -> tuple[float, Shot]:
    """Effort in [a, b] of the largest tension ratio, to within `width`.

    Golden section, sped up by parabolas through the three best points (R. P. Brent, "Algorithms for
    minimization without derivatives", 1973, chapter 5).
    """
    golden = 0.3819660112501051
    x = a + golden * (b - a)
    f_x, shot = carried_ratio(law, par, x, steps, table)
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
        f_u, shot_u = carried_ratio(law, par, u, steps, table)
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
    law: CompactLaw, par: Parameters, z: float, steps: int, table: Buffer
) -> tuple[float, Shot]:
    """ln(tight/slack) carried with effort z, and the shot."""
    if len(table) > 0:
        # the exit slip is a target that marches to the exit
        went, _, shot = attempt(law, par, Aim(SLIP, 0.0), z, steps, table)
        if went:
            return value_of(par, shot, TENSION), shot
    shot, _ = shoot_from(law, par, z, steps, 0, zeros(0))
    return value_of(par, shot, TENSION), shot
