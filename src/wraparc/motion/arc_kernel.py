"""One arc at one instant: the static two-point problem whose creep the pieces of lagging remember.

Belt laid on a piece of lagging stays laid on it. With m(t) the surface passed less the unstretched
belt fed and n what a piece keeps of it since it passed the nip,

    u(s, t) = m(t) - n - int_0^s a T ds',      dT/ds = -B tau.

The nodes are pieces of lagging; one that has entered is never interpolated. In a table of rows the
oldest piece, just beyond the exit nip, comes first and the entry nip last. The box scheme in
(T, I = int a T ds) is solved by Newton's method, one linear sweep a call: a relation
dT + beta dI = gamma is carried from the exit to the nip, then the changes back. (Shooting from the
nip would grow like exp(L/l).) gamma and the changes have three parts: of the residual, of m and of
the exit tension, so that a caller has the arc as an affine map.

Plain functions on flat numbers: one source runs interpreted and compiled.
"""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple

from wraparc.batch.elementwise import memory
from wraparc.friction.compact import CompactLaw
from wraparc.friction.memory import ROOM, moved, shortened

#: Columns of a row: what a piece is, what it remembers, the iterate, the trial, the sweep.
(
    TRAVEL,  # zeta, travel at which it passed the entry nip [m]
    KEPT,  # n [m]
    GIVE,  # a, compliance of belt and lagging recovery [1/N]
    RISE,  # rho, extra radius [m]
    DRY,  # share of the friction that is there: less than 1 on a wet patch [-]
    SLIP, STRESS, SIDE, REACH,  # of the friction: x [m], tau [Pa], direction, largest slip [m]
    TENSION, SHORT,  # T [N], I [m]
    NEW_SLIP, NEW_STRESS, NEW_SIDE, NEW_TURNS,
    BY_CREEP, BY_TENSION,  # K [Pa/m], P [1/m2]
    T_0, I_0, T_M, I_M, T_X, I_X,  # changes of T, I: of the residual, by m, by the exit tension
    BETA, GAMMA_0, GAMMA_M, GAMMA_X,
    T_CARRIED, I_CARRIED,  # T, I at the end of the step if nothing but the travel changed them
    T_RATE, I_RATE, T_RATE_0, I_RATE_0,  # what did [N/s, m/s], in the last step and the one before
) = range(33)  # fmt: skip
COLUMNS = 33

#: What an arc answers in its array: a sweep the arc as an affine map, a step that is kept what
#: friction came to: slip [m] and stress [Pa] at the exit nip, the largest ones with their signs,
#: the largest speed of slip [m/s].
(
    IN, IN_M, IN_X, WRAPPED, WRAPPED_M, WRAPPED_X, LIFTED,
    EXIT_SLIP, EXIT_STRESS, MOST_SLIP, MOST_STRESS, SLIP_SPEED,
) = range(12)  # fmt: skip
ANSWERS = 12


class Shape(NamedTuple):
    """What of an arc stays the same in time.

    Attributes
    ----------
    width, diameter, length
        B, D and L [m].
    shear
        c = h/G [m/Pa].
    kick, kick_coefficient
        The overrun is kick + kick_coefficient p1^1.5 [m, m/Pa^1.5].
    """

    width: float
    diameter: float
    length: float
    shear: float
    kick: float
    kick_coefficient: float


def arc_of(what: Any, edges: Any, coefficients: Any, slips: Any) -> tuple[CompactLaw, Shape]:
    """Law and shape of an arc out of flat numbers, which compiled code takes at once."""
    law = CompactLaw(
        int(what[0]),
        memory(edges, "edges"),
        memory(coefficients, "coefficients"),
        memory(slips, "slips"),
        what[1],
    )
    return law, Shape(what[2], what[3], what[4], what[5], what[6], what[7])


def sweep(
    what: Any,
    edges: Any,
    coefficients: Any,
    slips: Any,
    rows: Any,
    turns: Any,
    counts: Any,
    span: Any,
    out: Any,
    travel: float,
    m: float,
    exit_tension: float,
    ahead: float,
    h: float,
) -> None:
    """One Newton step of an arc.

    Parameters
    ----------
    what, edges, coefficients, slips
        The lagging's law and the arc in numbers, see :func:`arc_of`.
    rows, turns, counts
        The table of the pieces, their turning points and how many of them hold.
    span
        First row, row of the nip, whether the piece there is new: integers.
    out
        Takes the answers.
    travel, m, exit_tension
        S, m [m] and T_out [N].
    ahead, h
        How far the surface moves in the step [m] and how long that takes [s] if this is its first
        sweep, which begins with a guess; else 0.
    """
    law, shape = arc_of(what, edges, coefficients, slips)
    width, c = shape.width, shape.shear
    if h > 0.0:
        guess(width, rows, counts, span, exit_tension, ahead, h)
    if span[2] != 0:
        rows[span[1], TRAVEL] = travel
        while span[0] + 2 < span[1] and travel - rows[span[0] + 1, TRAVEL] >= shape.length:
            span[0] += 1
    history = memory(turns, "turns")
    per = 2.0 / (width * shape.diameter)
    first, nip = span[0], span[1]
    f, b, a_d, a_u = 0.0, 0.0, 0.0, 0.0
    t_d, i_d, tau_d, k_d, p_d, z_d, give_d = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    beta, gamma_0, gamma_m, gamma_x = 0.0, 0.0, 0.0, 0.0
    for j in range(first, nip + 1):
        # friction, and its slopes
        t, i, z, give = rows[j, TENSION], rows[j, SHORT], rows[j, TRAVEL], rows[j, GIVE]
        pressure = max(t * per, 1.0)
        u, by_t = m - rows[j, KEPT] - i, 0.0
        new = j == nip and span[2] != 0
        if new:
            root = sqrt(pressure)
            u = shape.kick + shape.kick_coefficient * pressure * root
            by_t = 1.5 * shape.kick_coefficient * root * per
        near, tau, k = rows[j, NEW_SLIP], rows[j, NEW_STRESS], rows[j, BY_CREEP]
        near += (1.0 - c * k) * (u - near - c * tau)
        point = moved(
            law, c, u, pressure, history, j * ROOM, counts[j], rows[j, SIDE], rows[j, SLIP],
            rows[j, STRESS], rows[j, REACH], rows[j, DRY], near,
        )  # fmt: skip
        tau, k, p = point.stress, point.by_creep, point.by_pressure * per
        rows[j, NEW_SLIP], rows[j, NEW_STRESS], rows[j, NEW_SIDE] = point.slip, tau, point.side
        rows[j, NEW_TURNS] = point.turns
        if new:
            p += k * by_t
            k = 0.0
        rows[j, BY_CREEP], rows[j, BY_TENSION] = k, p
        # the cell between this piece and the one before:
        # T_d - T_u + b (tau_d + tau_u) = 0, I_d - I_u - (a T)_d - (a T)_u = 0
        if j > first:
            dz = z - z_d
            b, a_d, a_u = 0.5 * width * dz, 0.5 * dz * give_d, 0.5 * dz * give
            m12 = -b * k_d
            det = 1.0 + b * p_d + m12 * a_d
            cell = t_d - t + b * (tau_d + tau)
            short = i_d - i - a_d * t_d - a_u * t
            alpha = 0.0
            if j == first + 1:  # the exit nip is inside: T_u - near tau_u - far tau_d = T_out
                f = (shape.length - travel + z) / dz
                near, far = 2.0 * b * f * (1.0 - 0.5 * f), b * f * f
                one = -far * (p_d - k_d * a_d) / det
                two = far * k_d - one * m12
                alpha, beta = 1.0 - near * p, near * k
                gamma_0 = exit_tension - t + near * tau + far * tau_d
                gamma_m, gamma_x = near * k + far * k_d, 1.0
            else:
                one = (1.0 + beta * a_d) / det
                two = beta - one * m12
                beta = 0.0
            alpha += one * (1.0 - b * p) + two * a_u
            scale = 1.0 / alpha if alpha != 0.0 else 1.0
            beta = (beta + one * b * k + two) * scale
            gamma_0 = (gamma_0 + one * cell + two * short) * scale
            gamma_m = (gamma_m + one * b * (k_d + k)) * scale
            gamma_x = gamma_x * scale
            rows[j, BETA] = beta
            rows[j, GAMMA_0], rows[j, GAMMA_M], rows[j, GAMMA_X] = gamma_0, gamma_m, gamma_x
        t_d, i_d, tau_d, k_d, p_d, z_d, give_d = t, i, tau, k, p, z, give
    back(shape, rows, span, exit_tension, travel, out)


def guess(
    width: float, rows: Any, counts: Any, span: Any, least: float, ahead: float, h: float
) -> None:
    """Guess the end of a step: what travel carries on, and what else changed, extrapolated."""
    first, nip = span[0], span[1]
    if span[2] != 0:  # the piece at the nip is fresh
        for column in (KEPT, SLIP, STRESS, SIDE, REACH, NEW_SLIP, NEW_STRESS, BY_CREEP):
            rows[nip, column] = 0.0
        counts[nip] = 0
    for j in range(first, nip + 1):
        t, i = rows[j, TENSION], rows[j, SHORT]
        if j < nip or span[2] == 0:
            i += rows[j, GIVE] * t * ahead
            t -= width * rows[j, STRESS] * ahead
        else:
            i = 0.0
        rows[j, T_CARRIED], rows[j, I_CARRIED] = t, i
        t += h * (2.0 * rows[j, T_RATE] - rows[j, T_RATE_0])
        rows[j, TENSION] = max(t, 0.1 * least)
        if j < nip or span[2] == 0:
            i += h * (2.0 * rows[j, I_RATE] - rows[j, I_RATE_0])
        rows[j, SHORT] = i


def back(shape: Shape, rows: Any, span: Any, exit_tension: float, travel: float, out: Any) -> None:
    """From the nip, where I = 0, to the exit: the changes of every row, and the answers."""
    first, nip, width = span[0], span[1], shape.width
    t_0, t_m, t_x = rows[nip, GAMMA_0], rows[nip, GAMMA_M], rows[nip, GAMMA_X]
    i_0, i_m, i_x = 0.0, 0.0, 0.0
    rows[nip, T_0], rows[nip, T_M], rows[nip, T_X] = t_0, t_m, t_x
    rows[nip, I_0], rows[nip, I_M], rows[nip, I_X] = i_0, i_m, i_x
    t_u, i_u, z_u, give_u = (
        rows[nip, TENSION], rows[nip, SHORT], rows[nip, TRAVEL], rows[nip, GIVE],
    )  # fmt: skip
    rise_u, lifted = rows[nip, RISE], 0.0
    out[IN], out[IN_M], out[IN_X] = t_u + t_0, t_m, t_x
    for j in range(nip - 1, first - 1, -1):
        t, i, z, give = rows[j, TENSION], rows[j, SHORT], rows[j, TRAVEL], rows[j, GIVE]
        rise, h = rows[j, RISE], z_u - z
        a_d, a_u = 0.5 * h * give, 0.5 * h * give_u
        r_0 = i_0 + a_u * t_0 - (i - i_u - a_d * t - a_u * t_u)
        r_m, r_x = i_m + a_u * t_m, i_x + a_u * t_x
        if j > first:
            lifted += 0.5 * h * (rise + rise_u)
            beta = rows[j, BETA]
            det = 1.0 / (1.0 + beta * a_d)
            t_0 = (rows[j, GAMMA_0] - beta * r_0) * det
            t_m = (rows[j, GAMMA_M] - beta * r_m) * det
            t_x = (rows[j, GAMMA_X] - beta * r_x) * det
        else:
            # the exit nip lies in this cell: W = I there; then the piece beyond it
            f = (shape.length - travel + z_u) / h
            up = f * a_u
            over = 0.5 * f * h * (give_u + f * (give - give_u))
            out[WRAPPED] = i_u + i_0 + over * exit_tension + up * (t_u + t_0)
            out[WRAPPED_M], out[WRAPPED_X] = i_m + up * t_m, i_x + up * t_x + over
            out[LIFTED] = lifted + 0.5 * f * h * (2.0 * rise_u + f * (rise - rise_u))
            b = 0.5 * width * h
            k_d, k_u, rest = rows[j, BY_CREEP], rows[j + 1, BY_CREEP], rows[j + 1, BY_TENSION]
            cell = t - t_u + b * (rows[j, NEW_STRESS] + rows[j + 1, NEW_STRESS])
            rest, m12 = 1.0 - b * rest, -b * k_d
            det = 1.0 / (1.0 + b * rows[j, BY_TENSION] + m12 * a_d)
            t_0 = (rest * t_0 + b * k_u * i_0 - cell - m12 * r_0) * det
            t_m = (rest * t_m + b * k_u * i_m - b * (k_d + k_u) - m12 * r_m) * det
            t_x = (rest * t_x + b * k_u * i_x - m12 * r_x) * det
        i_0, i_m, i_x = r_0 + a_d * t_0, r_m + a_d * t_m, r_x + a_d * t_x
        rows[j, T_0], rows[j, T_M], rows[j, T_X] = t_0, t_m, t_x
        rows[j, I_0], rows[j, I_M], rows[j, I_X] = i_0, i_m, i_x
        t_u, i_u, z_u, give_u, rise_u = t, i, z, give, rise


def change(what: Any, rows: Any, span: Any, dm: float, dx: float) -> float:
    """Change the rows by what the sweep found, for a change of m and T_out; the largest dT/T."""
    shear, worst = what[5], 0.0
    for j in range(span[0], span[1] + 1):
        t = rows[j, TENSION]
        dt = rows[j, T_0] + rows[j, T_M] * dm + rows[j, T_X] * dx
        di = rows[j, I_0] + rows[j, I_M] * dm + rows[j, I_X] * dx
        worst = max(worst, abs(dt) / t)
        dt = max(dt, -0.8 * t)  # a step far off the solution may not leave the belt without tension
        rows[j, TENSION] = t + dt
        rows[j, SHORT] += di
        # the trial follows to first order
        du = dm - di
        dtau = rows[j, BY_TENSION] * dt + rows[j, BY_CREEP] * du
        if span[2] != 0 and j == span[1]:
            du = overrun(what, t + dt) - rows[j, NEW_SLIP] - shear * rows[j, NEW_STRESS]
        rows[j, NEW_STRESS] += dtau
        rows[j, NEW_SLIP] += du - shear * dtau
    return worst


def overrun(what: Any, tension: float) -> float:
    """x_c at an entry tension [m]."""
    pressure: float = max(2.0 / (what[2] * what[3]) * tension, 0.0)
    return float(what[6] + what[7] * pressure * sqrt(pressure))


def keep(
    what: Any, rows: Any, turns: Any, counts: Any, span: Any, out: Any, before: float,
    travel: float, m: float, entry: float, h: float,
) -> float:  # fmt: skip
    """Take the trial for good; the friction work of the step over the wrap [J].

    Parameters
    ----------
    out
        Takes slips and stresses at the exit nip, and the largest on the wrap.
    before, travel
        S at the beginning and the end of the step [m]: what leaves on the way works half of it.
    m, entry
        m [m] and T_in [N] at its end.
    h
        How long it took [s].
    """
    first, nip, length = span[0], span[1], what[4]
    history = memory(turns, "turns")
    last, work, furthest = 0.0, 0.0, 0.0
    for j in range(first, nip + 1):
        slid = rows[j, NEW_SLIP] - rows[j, SLIP]
        if span[2] != 0 and j == nip:
            slid = 0.0
        furthest = max(furthest, abs(slid))
        done = 0.5 * (rows[j, STRESS] + rows[j, NEW_STRESS]) * slid
        if j > first:
            d = rows[j, TRAVEL] - rows[j - 1, TRAVEL]
            if j == first + 1:
                f = (length - 0.5 * (before + travel) + rows[j, TRAVEL]) / d
                work += f * d * (done + 0.5 * f * (last - done))
            else:
                work += 0.5 * d * (last + done)
        last = done
        rows[j, SLIP], rows[j, STRESS] = rows[j, NEW_SLIP], rows[j, NEW_STRESS]
        rows[j, SIDE] = rows[j, NEW_SIDE]
        rows[j, REACH] = max(rows[j, REACH], abs(rows[j, SLIP]))
        if counts[j] != 0 or rows[j, NEW_TURNS] != 0.0:
            counts[j] = shortened(history, j * ROOM, int(rows[j, NEW_TURNS]))
        rows[j, T_RATE_0], rows[j, I_RATE_0] = rows[j, T_RATE], rows[j, I_RATE]
        rows[j, T_RATE] = (rows[j, TENSION] - rows[j, T_CARRIED]) / h
        rows[j, I_RATE] = (rows[j, SHORT] - rows[j, I_CARRIED]) / h
    out[SLIP_SPEED] = furthest / h
    tell(rows, span, length, travel, out)
    if span[2] != 0:
        rows[nip, KEPT] = m - overrun(what, entry)
        # laid for good once the surface has moved on by a spacing: the next one begins like it
        if travel - rows[nip - 1, TRAVEL] >= 0.999 * what[8]:
            for column in range(COLUMNS):
                rows[nip + 1, column] = rows[nip, column]
            counts[nip + 1] = counts[nip]
            span[1] = nip + 1
    return float(work * what[2])


def tell(rows: Any, span: Any, length: float, travel: float, out: Any) -> None:
    """Say what friction came to: slip and stress at the exit nip, and the largest on the wrap."""
    first = span[0]
    near, far = rows[first + 1, TRAVEL], rows[first, TRAVEL]
    f = (length - travel + near) / (near - far)
    for kept, at_exit, most in ((SLIP, EXIT_SLIP, MOST_SLIP), (STRESS, EXIT_STRESS, MOST_STRESS)):
        value = rows[first + 1, kept] + f * (rows[first, kept] - rows[first + 1, kept])
        out[at_exit] = value
        for j in range(first + 1, span[1] + 1):
            if abs(rows[j, kept]) > abs(value):
                value = rows[j, kept]
        out[most] = value
