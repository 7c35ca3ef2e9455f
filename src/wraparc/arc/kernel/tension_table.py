"""What a march in tension meets at the nodes: a table made once for all marches of a solve.

Pressure, and with it everything in the integral-log law but the slip, depends on the node alone,
and the knots of the law are nodes. Nodes are Q = Q_a eta^10 up to Q_a, which is s ~ eta^5, and
equal parts after that; Q = |ln(T/T1)|.
"""

from __future__ import annotations

from math import exp, log

from wraparc.arc.kernel.quantities import Buffer, Parameters
from wraparc.friction.compact import KNOT_STRIDE, KNOTS, PIECES, CompactLaw, peak, segment_of, tail

# numbers of a node, see `_node`; some are scaled by the dQ of the step
NODE = 11
#: a step: its end Q, its segment, then nodes at 0, 1/3, 1/2, 2/3 and 1 of the step
STEP = 2 + 5 * NODE
#: a table: number of steps, Q reached, segment there, last Q, graded steps, step, entry pressure,
#: a spare, weight of the last node; then nodes for a part of a step; then the steps
PART = 9
FIRST = PART + 5 * NODE
GRADED_END = 0.1  # Q_a
GRADED_POWER = 10


def applies(law: CompactLaw, par: Parameters) -> bool:
    """Whether the march may be tried: integral-log law, no kick against the direction of slip."""
    return law.kind in (KNOTS, PIECES) and par.kick * par.side >= 0.0


def table_size(end: float, steps: int) -> int:
    """Numbers that a table needs, see `open_table`; with room for 60 pieces of the law."""
    return FIRST + STEP * (int(0.75 * steps + end * steps / 1.44) + 64)


def open_table(law: CompactLaw, par: Parameters, end: float, steps: int, table: Buffer) -> None:
    """Prepare a table; one that is of the same drive, end and fineness is kept.

    Parameters
    ----------
    end
        Last Q, a node.
    steps
        Fineness: 24 makes 18 graded steps, and parts of 0.06 in Q after them.
    table
        Buffer of `table_size` numbers, zeros at first.
    """
    if table[3] == end and table[4] == 0.75 * steps and table[6] == par.entry_pressure:
        return  # it is there already
    segment = segment_of(law, par.entry_pressure)
    if par.side > 0.0 and segment >= 0 and par.entry_pressure <= law.edges[segment] * (1.0 + 1e-14):
        segment -= 1
    table[0], table[1], table[2], table[3] = 0.0, 0.0, float(segment), end
    table[4], table[5], table[6] = 0.75 * steps, 1.44 / steps, par.entry_pressure


def _node(
    law: CompactLaw, par: Parameters, segment: int, q: float, weight: float, table: Buffer, o: int
) -> None:
    """Numbers of the law at Q in one of its segments, with dQ (times a Jacobian) as weight."""
    shear, sigma = par.shear, par.side
    fall = exp(-sigma * q)
    p = par.entry_pressure * fall
    last = len(law.edges) - 1
    if law.kind == KNOTS and 0 <= segment < last:
        # the common case of `peak`, written out
        c, k = law.coefficients, segment * KNOT_STRIDE
        t = p - law.edges[segment]
        x1, x2, x3 = c[k + 1], c[k + 2], c[k + 3]
        m1, m2, m3 = c[k + 5], c[k + 6], c[k + 7]
        slip_pk = c[k] + t * (x1 + t * (x2 + t * x3))
        mu_pk = c[k + 4] + t * (m1 + t * (m2 + t * m3))
        slip_pk_p = x1 + t * (2.0 * x2 + 3.0 * t * x3)
        mu_pk_p = m1 + t * (2.0 * m2 + 3.0 * t * m3)
        softens = c[k + 8] != 0.0 or c[k + 9] != 0.0 or c[k + 10] != 0.0 or c[k + 11] != 0.0
    else:
        slip_pk, mu_pk, slip_pk_p, mu_pk_p = peak(law, segment, p)
        softens = True
    held = 1.0
    if segment >= last >= 0:
        held = law.edges[last] / p  # traction held: mu falls as 1/p
        mu_pk, mu_pk_p, slip_pk_p = mu_pk * held, -mu_pk * held / p, 0.0
    bend = weight * sigma * shear * p
    r_mu = weight * par.radius / mu_pk
    table[o] = 1.0 / slip_pk
    table[o + 1] = r_mu
    table[o + 2] = r_mu * par.entry_tension * abs(1.0 - fall) * par.compliance
    table[o + 3] = bend * (mu_pk + p * mu_pk_p)
    table[o + 4] = bend * p * mu_pk * slip_pk_p / slip_pk
    table[o + 5] = shear * p * mu_pk / slip_pk
    table[o + 6] = mu_pk * p
    table[o + 7] = table[o + 8] = table[o + 10] = 0.0
    table[o + 9] = 1.0
    if not softens:
        return
    slope, residual, slope_p, residual_p = tail(law, segment, p)
    mu_0, mu_0_p = mu_pk / held, mu_pk_p
    if held != 1.0:  # above the tested pressures the law is that of the last of them
        mu_0_p = slope_p = residual_p = 0.0
    if slope < 0.0 and residual < mu_0:
        table[o + 7] = slope * slip_pk / mu_0
        table[o + 8] = bend * p * mu_pk * slip_pk * (slope_p - slope * mu_0_p / mu_0) / mu_0
        table[o + 9] = residual / mu_0
        table[o + 10] = bend * p * mu_pk * (residual_p - residual * mu_0_p / mu_0) / mu_0


def _weight(graded: bool, top: float, e: float, h: float) -> float:
    """Weight dQ of a step h at e: h, times dQ/d eta in the graded part."""
    if not graded:
        return h
    e3 = e * e * e
    return GRADED_POWER * top * e3 * e3 * e3 * h


def fill(
    law: CompactLaw,
    par: Parameters,
    segment: int,
    graded: bool,
    top: float,
    start: float,
    h: float,
    table: Buffer,
    o: int,
    known: int,
) -> None:
    """Nodes of one step, from eta (graded) or Q = start over h.

    `known` is the place of the end node of the step before, if that has the same segment, or -1.
    """
    first = 0
    if known >= 0:
        # the same node, but for its weight, the first of its numbers
        scale = _weight(graded, top, start, h) / table[8]
        for k in range(NODE):
            scaled = k in (1, 2, 3, 4, 8, 10)
            table[o + k] = table[known + k] * scale if scaled else table[known + k]
        first = 1
    for i in range(first, 5):
        part = 0.0 if i == 0 else (1.0 if i == 4 else (1.0 + i) / 6.0)
        e = start + h * part
        q = top * e**GRADED_POWER if graded else e
        _node(law, par, segment, q, _weight(graded, top, e, h), table, o + NODE * i)


def extend(law: CompactLaw, par: Parameters, table: Buffer) -> bool:
    """Add one step to a table; False at its end."""
    n, q, segment, end = int(table[0]), table[1], int(table[2]), table[3]
    o = FIRST + n * STEP
    if q >= end * (1.0 - 1e-14) or o + STEP > len(table):
        return False
    sigma, top = par.side, min(GRADED_END, end)
    # the next boundary between pieces of the law, or the end
    wall = end
    if sigma > 0.0 and segment >= 0:
        wall = min(end, log(par.entry_pressure / law.edges[segment]))
    elif sigma < 0.0 and segment < len(law.edges) - 1:
        wall = min(end, log(law.edges[segment + 1] / par.entry_pressure))
    table[o + 1] = table[2]
    known = o - NODE if n > 0 and table[o - STEP + 1] == table[2] else -1
    if q < top * (1.0 - 1e-12):
        power = 1.0 / GRADED_POWER
        eta, part = (q / top) ** power, 1.0 / table[4]
        most = (min(wall, top) / top) ** power
        to = most if most - eta < 1.3 * part else eta + part
        fill(law, par, segment, True, top, eta, to - eta, table, o + 2, known)
        table[8] = _weight(True, top, to, to - eta)
        q = min(wall, top) if to == most else top * to**GRADED_POWER
    else:
        h = table[5] if wall - q > 1.3 * table[5] else wall - q
        fill(law, par, segment, False, top, q, h, table, o + 2, known)
        table[8] = h
        q = wall if q + h >= wall * (1.0 - 1e-13) else q + h
    if q >= wall * (1.0 - 1e-13) and wall < end:
        table[2] += -1.0 if sigma > 0.0 else 1.0
    table[o] = table[1] = q
    table[0] = float(n + 1)
    return True
