"""One arc at one instant: the static two-point problem whose creep the pieces of lagging remember.

Belt laid on a piece of lagging stays laid on it. With m(t) the surface passed less the unstretched
belt fed and n what a piece keeps of it since it passed the nip,

    u(s, t) = m(t) - n - int_0^s a T ds',      dT/ds = -B tau.

The nodes are pieces of lagging; one that has entered is never interpolated. In a table of rows the
oldest piece, just beyond the exit nip, comes first and the entry nip last. The box scheme in
(T, I = int a T ds) is solved by Newton's method, one linear sweep a call: a relation
alpha dT + beta dI = gamma is carried from the exit to the nip, then the changes back. (Shooting
from the nip would grow like exp(L/l).) gamma and the changes have three parts: of the residual, of
m and of the exit tension, so that a caller has the arc as an affine map.

Plain functions on flat numbers: one source runs interpreted and compiled.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from wraparc.friction.compact import CompactLaw
from wraparc.friction.memory import moved, shortened

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
    ALPHA, BETA, GAMMA_0, GAMMA_M, GAMMA_X,
) = range(28)  # fmt: skip
COLUMNS = 28

#: What a sweep returns in its array: the arc as an affine map, and how far it is from settled.
(IN, IN_M, IN_X, WRAPPED, WRAPPED_M, WRAPPED_X, LIFTED, CHANGE, EXIT_STRESS, EXIT_CREEP) = range(10)
ANSWERS = 10


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


def points(
    law: CompactLaw, shape: Shape, rows: Any, turns: Any, counts: Any, span: Any, m: float
) -> None:
    """Put friction and its slopes into the rows from first to nip, for their T and I.

    `span` holds first, nip and whether the piece at the nip is new.
    """
    first, nip, fresh = span[0], span[1], span[2]
    per = 2.0 / (shape.width * shape.diameter)
    for j in range(first, nip + 1):
        row = rows[j]
        pressure = max(row[TENSION] * per, 1.0)
        by_t = 0.0
        if fresh and j == nip:
            root = pressure**0.5
            u = shape.kick + shape.kick_coefficient * pressure * root
            by_t = 1.5 * shape.kick_coefficient * root * per
        else:
            u = m - row[KEPT] - row[SHORT]
        at = moved(
            law, shape.shear, u, pressure, turns[j], counts[j], row[SIDE], row[SLIP],
            row[STRESS], row[REACH], row[DRY],
        )  # fmt: skip
        row[NEW_SLIP], row[NEW_STRESS], row[NEW_SIDE] = at.slip, at.stress, at.side
        row[NEW_TURNS] = at.turns
        row[BY_TENSION] = at.by_pressure * per
        row[BY_CREEP] = at.by_creep
        if fresh and j == nip:
            row[BY_TENSION] += at.by_creep * by_t if by_t > 0.0 else 0.0
            row[BY_CREEP] = 0.0


def sweep(
    law: CompactLaw,
    shape: Shape,
    rows: Any,
    turns: Any,
    counts: Any,
    span: Any,
    at: Any,
    out: Any,
) -> None:
    """One Newton step of an arc.

    Parameters
    ----------
    law, shape
        The lagging's law and the arc.
    rows, turns, counts
        The table of the pieces, their turning points and how many of them hold.
    span
        First row, row of the nip, whether the piece there is new: integers.
    at
        S, m, T_out; and the change of m and of T_out since the last sweep, which with its residual
        is added to the rows first if the sixth number is not 0.
    out
        Takes the answers.
    """
    travel, m, exit_tension = at[0], at[1], at[2]
    if at[5] != 0.0:
        worst = 0.0
        for j in range(span[0], span[1] + 1):
            row = rows[j]
            change = row[T_0] + row[T_M] * at[3] + row[T_X] * at[4]
            worst = max(worst, abs(change) / row[TENSION])
            # a step far off the solution may not leave the belt without tension
            row[TENSION] += max(change, -0.8 * row[TENSION])
            row[SHORT] += row[I_0] + row[I_M] * at[3] + row[I_X] * at[4]
        out[CHANGE] = worst
    points(law, shape, rows, turns, counts, span, m)
    exit_cell(shape, rows, span, travel, exit_tension)
    for j in range(span[0] + 1, span[1]):
        carry(shape.width, rows[j], rows[j + 1], rows[j][ALPHA], rows[j][BETA], 1.0)
    back(shape, rows, span, travel, exit_tension, out)


def carry(
    width: float, down: Any, up: Any, alpha: float, beta: float, own: float
) -> tuple[float, float]:
    """Carry alpha dT + beta dI = gamma from the lower end of a cell to its upper end.

    With `own` = 1 gamma is that of the lower row and the relation goes into the upper row, scaled;
    with 0 the two multipliers of the equations of the cell are returned and nothing is written.
    """
    h = up[TRAVEL] - down[TRAVEL]
    b, a_down, a_up = 0.5 * width * h, 0.5 * h * down[GIVE], 0.5 * h * up[GIVE]
    # the cell: T_d - T_u + b (tau_d + tau_u) = 0, I_d - I_u - (a T)_d - (a T)_u = 0
    m11, m12 = 1.0 + b * down[BY_TENSION], -b * down[BY_CREEP]
    det = m11 + m12 * a_down
    one = (alpha + a_down * beta) / det
    two = (m11 * beta - m12 * alpha) / det
    if own == 0.0:
        return one, two
    miss = down[TENSION] - up[TENSION] + b * (down[NEW_STRESS] + up[NEW_STRESS])
    short = down[SHORT] - up[SHORT] - a_down * down[TENSION] - a_up * up[TENSION]
    alpha_up = one * (1.0 - b * up[BY_TENSION]) + two * a_up
    scale = 1.0 / abs(alpha_up) if alpha_up != 0.0 else 1.0
    up[ALPHA] = alpha_up * scale
    up[BETA] = (one * b * up[BY_CREEP] + two) * scale
    up[GAMMA_0] = (down[GAMMA_0] + one * miss + two * short) * scale
    up[GAMMA_M] = (down[GAMMA_M] + one * b * (down[BY_CREEP] + up[BY_CREEP])) * scale
    up[GAMMA_X] = down[GAMMA_X] * scale
    return one, two


def exit_cell(shape: Shape, rows: Any, span: Any, travel: float, exit_tension: float) -> None:
    """Begin the relation at the piece before the exit nip, which lies inside the last cell."""
    down, up = rows[span[0]], rows[span[0] + 1]
    h = up[TRAVEL] - down[TRAVEL]
    f = (shape.length - travel + up[TRAVEL]) / h
    e = shape.width * f * h
    near, far = e * (1.0 - 0.5 * f), e * 0.5 * f
    # T_u - near tau_u - far tau_d = T_out, with T_d and I_d by the equations of the cell
    miss = up[TENSION] - near * up[NEW_STRESS] - far * down[NEW_STRESS] - exit_tension
    one, two = carry(shape.width, down, up, -far * down[BY_TENSION], far * down[BY_CREEP], 0.0)
    b, a_down, a_up = 0.5 * shape.width * h, 0.5 * h * down[GIVE], 0.5 * h * up[GIVE]
    cell = down[TENSION] - up[TENSION] + b * (down[NEW_STRESS] + up[NEW_STRESS])
    short = down[SHORT] - up[SHORT] - a_down * down[TENSION] - a_up * up[TENSION]
    up[ALPHA] = 1.0 - near * up[BY_TENSION] + one * (1.0 - b * up[BY_TENSION]) + two * a_up
    up[BETA] = near * up[BY_CREEP] + one * b * up[BY_CREEP] + two
    up[GAMMA_0] = -miss + one * cell + two * short
    up[GAMMA_M] = (
        near * up[BY_CREEP] + far * down[BY_CREEP] + one * b * (up[BY_CREEP] + down[BY_CREEP])
    )
    up[GAMMA_X] = 1.0


def back(shape: Shape, rows: Any, span: Any, travel: float, exit_tension: float, out: Any) -> None:
    """From the nip, where I = 0, to the exit: the changes of every row, and the answers."""
    nip = rows[span[1]]
    nip[T_0] = nip[GAMMA_0] / nip[ALPHA]
    nip[T_M] = nip[GAMMA_M] / nip[ALPHA]
    nip[T_X] = nip[GAMMA_X] / nip[ALPHA]
    nip[I_0], nip[I_M], nip[I_X] = 0.0, 0.0, 0.0
    out[IN], out[IN_M], out[IN_X] = nip[TENSION] + nip[T_0], nip[T_M], nip[T_X]
    lifted = 0.0
    for j in range(span[1] - 1, span[0], -1):
        down, up = rows[j], rows[j + 1]
        h = up[TRAVEL] - down[TRAVEL]
        a_down, a_up = 0.5 * h * down[GIVE], 0.5 * h * up[GIVE]
        lifted += 0.5 * h * (down[RISE] + up[RISE])
        short = down[SHORT] - up[SHORT] - a_down * down[TENSION] - a_up * up[TENSION]
        i_0 = up[I_0] + a_up * up[T_0] - short
        i_m, i_x = up[I_M] + a_up * up[T_M], up[I_X] + a_up * up[T_X]
        alpha, beta = down[ALPHA], down[BETA]
        det = alpha + beta * a_down
        down[T_0] = (down[GAMMA_0] - beta * i_0) / det
        down[T_M] = (down[GAMMA_M] - beta * i_m) / det
        down[T_X] = (down[GAMMA_X] - beta * i_x) / det
        down[I_0] = i_0 + a_down * down[T_0]
        down[I_M] = i_m + a_down * down[T_M]
        down[I_X] = i_x + a_down * down[T_X]
    beyond(shape.width, rows[span[0]], rows[span[0] + 1])
    leaving(shape, rows[span[0]], rows[span[0] + 1], travel, exit_tension, out)
    down, up = rows[span[0]], rows[span[0] + 1]
    h = up[TRAVEL] - down[TRAVEL]
    f = (shape.length - travel + up[TRAVEL]) / h
    out[LIFTED] = lifted + 0.5 * f * h * (2.0 * up[RISE] + f * (down[RISE] - up[RISE]))


def beyond(width: float, down: Any, up: Any) -> None:
    """Change T and I of the piece beyond the exit by the equations of its cell."""
    h = up[TRAVEL] - down[TRAVEL]
    b, a_down, a_up = 0.5 * width * h, 0.5 * h * down[GIVE], 0.5 * h * up[GIVE]
    m11, m12 = 1.0 + b * down[BY_TENSION], -b * down[BY_CREEP]
    det = m11 + m12 * a_down
    miss = down[TENSION] - up[TENSION] + b * (down[NEW_STRESS] + up[NEW_STRESS])
    short = down[SHORT] - up[SHORT] - a_down * down[TENSION] - a_up * up[TENSION]
    rest, slope = 1.0 - b * up[BY_TENSION], b * up[BY_CREEP]
    moving = -b * (down[BY_CREEP] + up[BY_CREEP])
    t_0 = rest * up[T_0] + slope * up[I_0] - miss
    t_m = rest * up[T_M] + slope * up[I_M] + moving
    t_x = rest * up[T_X] + slope * up[I_X]
    i_0, i_m, i_x = (
        up[I_0] + a_up * up[T_0] - short,
        up[I_M] + a_up * up[T_M],
        up[I_X] + a_up * up[T_X],
    )
    down[T_0], down[I_0] = (t_0 - m12 * i_0) / det, (a_down * t_0 + m11 * i_0) / det
    down[T_M], down[I_M] = (t_m - m12 * i_m) / det, (a_down * t_m + m11 * i_m) / det
    down[T_X], down[I_X] = (t_x - m12 * i_x) / det, (a_down * t_x + m11 * i_x) / det


def leaving(shape: Shape, down: Any, up: Any, travel: float, exit_tension: float, out: Any) -> None:
    """W = I at the exit nip with its slopes, and what the belt leaves with."""
    h = up[TRAVEL] - down[TRAVEL]
    f = (shape.length - travel + up[TRAVEL]) / h
    a_up = 0.5 * f * h * up[GIVE]
    a_out = 0.5 * f * h * (up[GIVE] + f * (down[GIVE] - up[GIVE]))
    out[WRAPPED] = up[SHORT] + up[I_0] + a_up * (up[TENSION] + up[T_0]) + a_out * exit_tension
    out[WRAPPED_M] = up[I_M] + a_up * up[T_M]
    out[WRAPPED_X] = up[I_X] + a_up * up[T_X] + a_out
    out[EXIT_STRESS] = up[NEW_STRESS] + f * (down[NEW_STRESS] - up[NEW_STRESS])


def keep(shape: Shape, rows: Any, turns: Any, counts: Any, span: Any, travel: float) -> float:
    """Take the trial for good; the friction work of the step over the wrap [J]."""
    first, nip = span[0], span[1]
    before = 0.0
    work = 0.0
    for j in range(first, nip + 1):
        row = rows[j]
        new = span[2] != 0 and j == nip
        done = 0.0 if new else 0.5 * (row[STRESS] + row[NEW_STRESS]) * (row[NEW_SLIP] - row[SLIP])
        if j > first:
            down = rows[j - 1]
            h = row[TRAVEL] - down[TRAVEL]
            if j == first + 1:
                f = (shape.length - travel + row[TRAVEL]) / h
                work += f * h * (done + 0.5 * f * (before - done))
            else:
                work += 0.5 * h * (before + done)
        before = done
        row[SLIP], row[STRESS], row[SIDE] = row[NEW_SLIP], row[NEW_STRESS], row[NEW_SIDE]
        row[REACH] = max(row[REACH], abs(row[SLIP]))
        counts[j] = shortened(turns[j], int(row[NEW_TURNS]))
    return work * shape.width
