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
        pressure = max(rows[j, TENSION] * per, 1.0)
        by_t = 0.0
        if fresh and j == nip:
            root = pressure**0.5
            u = shape.kick + shape.kick_coefficient * pressure * root
            by_t = 1.5 * shape.kick_coefficient * root * per
        else:
            u = m - rows[j, KEPT] - rows[j, SHORT]
        at = moved(
            law, shape.shear, u, pressure, turns, j * ROOM, counts[j], rows[j, SIDE], rows[j, SLIP],
            rows[j, STRESS], rows[j, REACH], rows[j, DRY],
        )  # fmt: skip
        rows[j, NEW_SLIP], rows[j, NEW_STRESS], rows[j, NEW_SIDE] = at.slip, at.stress, at.side
        rows[j, NEW_TURNS] = at.turns
        rows[j, BY_TENSION] = at.by_pressure * per
        rows[j, BY_CREEP] = at.by_creep
        if fresh and j == nip:
            rows[j, BY_TENSION] += at.by_creep * by_t if by_t > 0.0 else 0.0
            rows[j, BY_CREEP] = 0.0


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
    at: Any,
    out: Any,
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
    at
        S, m, T_out; and the change of m and of T_out since the last sweep, which with its residual
        is added to the rows first if the sixth number is not 0.
    out
        Takes the answers.
    """
    law, shape = arc_of(what, edges, coefficients, slips)
    travel, m, exit_tension = at[0], at[1], at[2]
    if at[5] != 0.0:
        worst = 0.0
        for j in range(span[0], span[1] + 1):
            change = rows[j, T_0] + rows[j, T_M] * at[3] + rows[j, T_X] * at[4]
            worst = max(worst, abs(change) / rows[j, TENSION])
            # a step far off the solution may not leave the belt without tension
            rows[j, TENSION] += max(change, -0.8 * rows[j, TENSION])
            rows[j, SHORT] += rows[j, I_0] + rows[j, I_M] * at[3] + rows[j, I_X] * at[4]
        out[CHANGE] = worst
    points(law, shape, rows, turns, counts, span, m)
    exit_cell(shape, rows, span, travel, exit_tension)
    for j in range(span[0] + 1, span[1]):
        carry(shape.width, rows, j, j + 1, rows[j, ALPHA], rows[j, BETA], 1.0)
    back(shape, rows, span, travel, exit_tension, out)


def carry(
    width: float, rows: Any, d: int, u: int, alpha: float, beta: float, own: float
) -> tuple[float, float]:
    """Carry alpha dT + beta dI = gamma from the lower end of a cell to its upper end.

    With `own` = 1 gamma is that of the lower row and the relation goes into the upper row, scaled;
    with 0 the two multipliers of the equations of the cell are returned and nothing is written.
    """
    h = rows[u, TRAVEL] - rows[d, TRAVEL]
    b, a_down, a_up = 0.5 * width * h, 0.5 * h * rows[d, GIVE], 0.5 * h * rows[u, GIVE]
    # the cell: T_d - T_u + b (tau_d + tau_u) = 0, I_d - I_u - (a T)_d - (a T)_u = 0
    m11, m12 = 1.0 + b * rows[d, BY_TENSION], -b * rows[d, BY_CREEP]
    det = m11 + m12 * a_down
    one = (alpha + a_down * beta) / det
    two = (m11 * beta - m12 * alpha) / det
    if own == 0.0:
        return one, two
    miss = rows[d, TENSION] - rows[u, TENSION] + b * (rows[d, NEW_STRESS] + rows[u, NEW_STRESS])
    short = rows[d, SHORT] - rows[u, SHORT] - a_down * rows[d, TENSION] - a_up * rows[u, TENSION]
    alpha_up = one * (1.0 - b * rows[u, BY_TENSION]) + two * a_up
    scale = 1.0 / abs(alpha_up) if alpha_up != 0.0 else 1.0
    rows[u, ALPHA] = alpha_up * scale
    rows[u, BETA] = (one * b * rows[u, BY_CREEP] + two) * scale
    rows[u, GAMMA_0] = (rows[d, GAMMA_0] + one * miss + two * short) * scale
    rows[u, GAMMA_M] = (
        rows[d, GAMMA_M] + one * b * (rows[d, BY_CREEP] + rows[u, BY_CREEP])
    ) * scale
    rows[u, GAMMA_X] = rows[d, GAMMA_X] * scale
    return one, two


def exit_cell(shape: Shape, rows: Any, span: Any, travel: float, exit_tension: float) -> None:
    """Begin the relation at the piece before the exit nip, which lies inside the last cell."""
    d, u = span[0], span[0] + 1
    h = rows[u, TRAVEL] - rows[d, TRAVEL]
    f = (shape.length - travel + rows[u, TRAVEL]) / h
    e = shape.width * f * h
    near, far = e * (1.0 - 0.5 * f), e * 0.5 * f
    # T_u - near tau_u - far tau_d = T_out, with T_d and I_d by the equations of the cell
    miss = rows[u, TENSION] - near * rows[u, NEW_STRESS] - far * rows[d, NEW_STRESS] - exit_tension
    one, two = carry(
        shape.width, rows, d, u, -far * rows[d, BY_TENSION], far * rows[d, BY_CREEP], 0.0
    )
    b, a_down, a_up = 0.5 * shape.width * h, 0.5 * h * rows[d, GIVE], 0.5 * h * rows[u, GIVE]
    cell = rows[d, TENSION] - rows[u, TENSION] + b * (rows[d, NEW_STRESS] + rows[u, NEW_STRESS])
    short = rows[d, SHORT] - rows[u, SHORT] - a_down * rows[d, TENSION] - a_up * rows[u, TENSION]
    rows[u, ALPHA] = (
        1.0 - near * rows[u, BY_TENSION] + one * (1.0 - b * rows[u, BY_TENSION]) + two * a_up
    )
    rows[u, BETA] = near * rows[u, BY_CREEP] + one * b * rows[u, BY_CREEP] + two
    rows[u, GAMMA_0] = -miss + one * cell + two * short
    rows[u, GAMMA_M] = (
        near * rows[u, BY_CREEP]
        + far * rows[d, BY_CREEP]
        + one * b * (rows[u, BY_CREEP] + rows[d, BY_CREEP])
    )
    rows[u, GAMMA_X] = 1.0


def back(shape: Shape, rows: Any, span: Any, travel: float, exit_tension: float, out: Any) -> None:
    """From the nip, where I = 0, to the exit: the changes of every row, and the answers."""
    n = span[1]
    rows[n, T_0] = rows[n, GAMMA_0] / rows[n, ALPHA]
    rows[n, T_M] = rows[n, GAMMA_M] / rows[n, ALPHA]
    rows[n, T_X] = rows[n, GAMMA_X] / rows[n, ALPHA]
    rows[n, I_0], rows[n, I_M], rows[n, I_X] = 0.0, 0.0, 0.0
    out[IN], out[IN_M], out[IN_X] = rows[n, TENSION] + rows[n, T_0], rows[n, T_M], rows[n, T_X]
    lifted = 0.0
    for j in range(span[1] - 1, span[0], -1):
        d, u = j, j + 1
        h = rows[u, TRAVEL] - rows[d, TRAVEL]
        a_down, a_up = 0.5 * h * rows[d, GIVE], 0.5 * h * rows[u, GIVE]
        lifted += 0.5 * h * (rows[d, RISE] + rows[u, RISE])
        short = (
            rows[d, SHORT] - rows[u, SHORT] - a_down * rows[d, TENSION] - a_up * rows[u, TENSION]
        )
        i_0 = rows[u, I_0] + a_up * rows[u, T_0] - short
        i_m, i_x = rows[u, I_M] + a_up * rows[u, T_M], rows[u, I_X] + a_up * rows[u, T_X]
        alpha, beta = rows[d, ALPHA], rows[d, BETA]
        det = alpha + beta * a_down
        rows[d, T_0] = (rows[d, GAMMA_0] - beta * i_0) / det
        rows[d, T_M] = (rows[d, GAMMA_M] - beta * i_m) / det
        rows[d, T_X] = (rows[d, GAMMA_X] - beta * i_x) / det
        rows[d, I_0] = i_0 + a_down * rows[d, T_0]
        rows[d, I_M] = i_m + a_down * rows[d, T_M]
        rows[d, I_X] = i_x + a_down * rows[d, T_X]
    beyond(shape.width, rows, span[0], span[0] + 1)
    leaving(shape, rows, span[0], span[0] + 1, travel, exit_tension, out)
    d, u = span[0], span[0] + 1
    h = rows[u, TRAVEL] - rows[d, TRAVEL]
    f = (shape.length - travel + rows[u, TRAVEL]) / h
    out[LIFTED] = lifted + 0.5 * f * h * (2.0 * rows[u, RISE] + f * (rows[d, RISE] - rows[u, RISE]))


def beyond(width: float, rows: Any, d: int, u: int) -> None:
    """Change T and I of the piece beyond the exit by the equations of its cell."""
    h = rows[u, TRAVEL] - rows[d, TRAVEL]
    b, a_down, a_up = 0.5 * width * h, 0.5 * h * rows[d, GIVE], 0.5 * h * rows[u, GIVE]
    m11, m12 = 1.0 + b * rows[d, BY_TENSION], -b * rows[d, BY_CREEP]
    det = m11 + m12 * a_down
    miss = rows[d, TENSION] - rows[u, TENSION] + b * (rows[d, NEW_STRESS] + rows[u, NEW_STRESS])
    short = rows[d, SHORT] - rows[u, SHORT] - a_down * rows[d, TENSION] - a_up * rows[u, TENSION]
    rest, slope = 1.0 - b * rows[u, BY_TENSION], b * rows[u, BY_CREEP]
    moving = -b * (rows[d, BY_CREEP] + rows[u, BY_CREEP])
    t_0 = rest * rows[u, T_0] + slope * rows[u, I_0] - miss
    t_m = rest * rows[u, T_M] + slope * rows[u, I_M] + moving
    t_x = rest * rows[u, T_X] + slope * rows[u, I_X]
    i_0, i_m, i_x = (
        rows[u, I_0] + a_up * rows[u, T_0] - short,
        rows[u, I_M] + a_up * rows[u, T_M],
        rows[u, I_X] + a_up * rows[u, T_X],
    )
    rows[d, T_0], rows[d, I_0] = (t_0 - m12 * i_0) / det, (a_down * t_0 + m11 * i_0) / det
    rows[d, T_M], rows[d, I_M] = (t_m - m12 * i_m) / det, (a_down * t_m + m11 * i_m) / det
    rows[d, T_X], rows[d, I_X] = (t_x - m12 * i_x) / det, (a_down * t_x + m11 * i_x) / det


def leaving(
    shape: Shape, rows: Any, d: int, u: int, travel: float, exit_tension: float, out: Any
) -> None:
    """W = I at the exit nip with its slopes, and what the belt leaves with."""
    h = rows[u, TRAVEL] - rows[d, TRAVEL]
    f = (shape.length - travel + rows[u, TRAVEL]) / h
    a_up = 0.5 * f * h * rows[u, GIVE]
    a_out = 0.5 * f * h * (rows[u, GIVE] + f * (rows[d, GIVE] - rows[u, GIVE]))
    out[WRAPPED] = rows[u, SHORT] + rows[u, I_0] + a_out * exit_tension
    out[WRAPPED] += a_up * (rows[u, TENSION] + rows[u, T_0])
    out[WRAPPED_M] = rows[u, I_M] + a_up * rows[u, T_M]
    out[WRAPPED_X] = rows[u, I_X] + a_up * rows[u, T_X] + a_out
    out[EXIT_STRESS] = rows[u, NEW_STRESS] + f * (rows[d, NEW_STRESS] - rows[u, NEW_STRESS])


def keep(
    width: float, length: float, rows: Any, turns: Any, counts: Any, span: Any, travel: float
) -> float:
    """Take the trial for good; the friction work of the step over the wrap [J].

    `travel` is that at the middle of the step: what leaves on the way works half of it.
    """
    first, nip = span[0], span[1]
    before = 0.0
    work = 0.0
    for j in range(first, nip + 1):
        new = span[2] != 0 and j == nip
        done = 0.5 * (rows[j, STRESS] + rows[j, NEW_STRESS]) * (rows[j, NEW_SLIP] - rows[j, SLIP])
        if new:
            done = 0.0
        if j > first:
            h = rows[j, TRAVEL] - rows[j - 1, TRAVEL]
            if j == first + 1:
                f = (length - travel + rows[j, TRAVEL]) / h
                work += f * h * (done + 0.5 * f * (before - done))
            else:
                work += 0.5 * h * (before + done)
        before = done
        rows[j, SLIP], rows[j, STRESS] = rows[j, NEW_SLIP], rows[j, NEW_STRESS]
        rows[j, SIDE] = rows[j, NEW_SIDE]
        rows[j, REACH] = max(rows[j, REACH], abs(rows[j, SLIP]))
        counts[j] = shortened(turns, j * ROOM, int(rows[j, NEW_TURNS]))
    return work * width
