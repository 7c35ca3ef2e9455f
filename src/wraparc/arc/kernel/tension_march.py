"""March around one wrap arc with tension as the independent variable.

Where the belt slips towards the slack side all along the arc, tension changes monotonically and can
take the place of position: with Q = |ln(T/T1)|, a = |x| and gamma = g towards the slack side,

    ds/dQ = R / mu,
    da/dQ = [(gamma + |T1 - T| C) R / mu + sigma c (mu + p mu_p) p] / (1 + c p mu_x),

sigma = +1 driving, -1 braking. Pressure, and with it everything in the integral-log law but the
slip, then depends on the node alone: it is tabulated once for all the marches that a solve needs
(:mod:`wraparc.arc.kernel.tension_table`), and a march costs a quarter of one in position
(:mod:`wraparc.arc.kernel.march`), which remains for everything else.
"""

from __future__ import annotations

from math import exp, log

from wraparc.arc.kernel.butcher import to_end, to_fifth, to_fourth, to_last, to_second, to_sixth
from wraparc.arc.kernel.creep_step import slip_at_entry
from wraparc.arc.kernel.quantities import LOST, RECORD, SOLVED, Buffer, Parameters
from wraparc.arc.kernel.step import hermite, rates
from wraparc.arc.kernel.tension_table import FIRST, NODE, PART, STEP, extend, fill
from wraparc.friction.compact import (
    LINE,
    RESIDUAL,
    RISE,
    SMALLEST,
    CompactLaw,
    branch_of,
    friction_at,
    peak,
    segment_of,
)

LANDING = 1e-12  # relative, of a march that ends within a step


def _rates(t: Buffer, o: int, branch: int, gamma: float, a: float) -> tuple[float, float, float]:
    """Weight dQ times ds/dQ [m], da/dQ [m] and d(friction work)/dQ [J/m2] at a node."""
    r = a * t[o]
    if branch == RISE and (r < 1.0 or t[o + 7] < 0.0):
        if r < SMALLEST:
            r = SMALLEST
        lr = log(r)
        rl = r * lr
        f = r - rl
        if f == 0.0:  # r = e, of a trial that is cut long before
            f = SMALLEST
        w = 1.0 / f
        da = (gamma * t[o + 1] + t[o + 2]) * w + t[o + 3] * f + t[o + 4] * rl
        da /= 1.0 - t[o + 5] * lr
        return t[o + 1] * w, da, t[o + 6] * f * da
    if branch == RESIDUAL:
        f = t[o + 9]
        da = (gamma * t[o + 1] + t[o + 2]) / f + t[o + 3] * f + t[o + 10]
        return t[o + 1] / f, da, t[o + 6] * f * da
    # the line past the peak; flat (z = 0) also where a law without a slope passes its peak
    z = t[o + 7]
    f = 1.0 + z * (r - 1.0)
    da = (gamma * t[o + 1] + t[o + 2]) / f + t[o + 3] * f + t[o + 8] * (r - 1.0) - t[o + 4] * z
    da /= 1.0 + t[o + 5] * z
    return t[o + 1] / f, da, t[o + 6] * f * da


def _step(
    t: Buffer, o: int, branch: int, gamma: float, s: float, a: float, work: float
) -> tuple[float, float, float]:
    """One sixth-order step (Butcher, as in arc.kernel.step) over five nodes: s, a, work."""
    n1, n2, n3, n4 = o + NODE, o + 2 * NODE, o + 3 * NODE, o + 4 * NODE
    s1, b1, w1 = _rates(t, o, branch, gamma, a)
    _, b2, _ = _rates(t, n1, branch, gamma, a + to_second(b1))
    s3, b3, w3 = _rates(t, n3, branch, gamma, a + b2 * (2.0 / 3.0))
    s4, b4, w4 = _rates(t, n1, branch, gamma, a + to_fourth(b1, b2, b3))
    s5, b5, w5 = _rates(t, n2, branch, gamma, a + to_fifth(b1, b2, b3, b4))
    s6, b6, w6 = _rates(t, n2, branch, gamma, a + to_sixth(b2, b3, b4, b5))
    s7, b7, w7 = _rates(t, n4, branch, gamma, a + to_last(b1, b2, b3, b4, b6))
    return (
        s + to_end(s1, s3, s4, s5, s6, s7),
        a + to_end(b1, b3, b4, b5, b6, b7),
        work + to_end(w1, w3, w4, w5, w6, w7),
    )


def start_of(
    law: CompactLaw, par: Parameters, gamma: float, table: Buffer
) -> tuple[int, int, float, float, float]:
    """State at the first node: status, steps done, s [m], slip [m], friction work [J/m2].

    Without a kick the first step is closed analytically: at constant pressure
    Q gamma R = int mu du = mu_pk x_pk r^2 (3/4 - ln(r)/2) + c p mu^2 / 2.
    """
    kick = par.side * par.kick  # towards the slack side, as all here; never against it, `applies`
    if gamma * par.length < -0.1 * kick:
        # the mesh expects slip to grow; a kick that is used up is for the march in position
        return LOST, 0, 0.0, 0.0, 0.0
    if kick > 0.0:
        return SOLVED, 0, 0.0, slip_at_entry(law, par, kick, 0.0), 0.0
    if gamma <= 1e-12:
        return LOST, 0, 0.0, 0.0, 0.0
    p = par.entry_pressure
    slip_pk, mu_pk, _, _ = peak(law, segment_of(law, p), p)
    last = len(law.edges) - 1
    if last >= 0 and p > law.edges[last]:
        mu_pk *= law.edges[last] / p
    goal = log(table[FIRST] * gamma * par.radius)
    shear = par.shear * p * mu_pk * mu_pk
    y = -14.0
    for _ in range(60):
        r = exp(y)
        f = r * (1.0 - y)
        work = mu_pk * slip_pk * r * r * (0.75 - 0.5 * y) + 0.5 * shear * f * f
        change = (log(work) - goal) * work
        change /= mu_pk * slip_pk * r * r * (1.0 - y) - shear * f * r * y
        y -= change
        if y > -1.0:
            return LOST, 0, 0.0, 0.0, 0.0
        if abs(change) < 1e-13:
            break
    r = exp(y)
    mu = mu_pk * r * (1.0 - y)
    s = (r * slip_pk + par.shear * p * mu) / gamma
    return SOLVED, 1, s, r * slip_pk, mu_pk * p * slip_pk * r * r * (0.75 - 0.5 * y)


def _next_branch(t: Buffer, o: int, branch: int, a: float) -> int:
    """Branch of a state at a node, among the neighbours of the branch it comes from."""
    z = t[o + 7]
    r = a * t[o]
    if branch == RISE:
        return LINE if r > 1.0 else RISE
    if z == 0.0:
        return branch if r >= 1.0 else RISE
    over = 1.0 + z * (r - 1.0) >= t[o + 9]
    if branch == RESIDUAL:
        return LINE if over and t[o + 9] < 1.0 else RESIDUAL
    if r < 1.0:
        return RISE
    return LINE if over else RESIDUAL


def _gap(t: Buffer, o: int, branch: int, to: int, a: float) -> float:
    """How far a state at a node is beyond the boundary to another branch; negative before."""
    r = a * t[o]
    if branch == RISE:
        return r - 1.0
    if to == RISE:
        return 1.0 - r
    below = t[o + 9] - 1.0 - t[o + 7] * (r - 1.0)
    return below if to == RESIDUAL else -below


def march(  # noqa: C901 - one loop over steps and cuts
    law: CompactLaw,
    par: Parameters,
    gamma: float,
    to_exit: bool,
    table: Buffer,
    points: int,
    out: Buffer,
) -> tuple[int, float, float, float, float, int]:
    """March from the entry to the last Q of a table, or to the exit nip.

    Parameters
    ----------
    gamma
        Entry creep ratio towards the slack side [-].
    to_exit
        Stop at the exit nip, s = L, instead of the last Q.
    table
        See `open_table`; extended as far as needed.
    points, out
        Equal parts of the arc to record, as in :func:`wraparc.arc.kernel.march.sweep`.

    Returns
    -------
    status, Q, s [m], slip towards the slack side [m], friction work [J/m2], count of records
        LOST where the march does not apply: slip does not keep its direction, or the table ends
        before the arc.
    """
    length = par.length
    if table[0] == 0.0:
        extend(law, par, table)
    status, i, s, a, work = start_of(law, par, gamma, table)
    count = 0
    if status == LOST:
        return LOST, 0.0, 0.0, 0.0, 0.0, count
    q = table[FIRST] if i == 1 else 0.0
    if len(out) > 0:
        for j in range(RECORD):
            out[j] = 0.0
        if i == 0:
            record_point(law, par, 0.0, 0.0, a, 0.0, out, 0)
        count = 1
    segment = segment_of(law, par.entry_pressure)
    branch = branch_of(law, segment, a, par.entry_pressure)
    least = 0.5 * a if i == 0 else 0.0
    inside = False  # whether q lies within step i
    for _ in range(4000):
        if i >= int(table[0]) and not extend(law, par, table):
            there = not to_exit and q >= table[3] * (1.0 - 1e-13)
            return (SOLVED if there else LOST), q, s, a, work, count
        o = FIRST + i * STEP
        q_end, segment = table[o], int(table[o + 1])
        o += 2
        if inside:
            fill(law, par, segment, False, 1.0, q, q_end - q, table, PART, -1)
            o = PART
        if branch == RISE and table[o + 4 * NODE + 7] < 0.0 and a * table[o] > 1.0 + 1e-9:
            branch = LINE
        s1, a1, work1 = _step(table, o, branch, gamma, s, a, work)
        if not (a1 > least and s1 > s and a1 < 1e3 and s1 < 1e6):
            return LOST, q, s, a, work, count
        to = _next_branch(table, o + 4 * NODE, branch, a1)
        q1, kink = q_end, False
        if to != branch:
            kink = True
            gap_0 = _gap(table, o, branch, to, a)
            gap_1 = _gap(table, o + 4 * NODE, branch, to, a1)
            part, s1, a1, work1 = _cut(
                law, par, gamma, branch, to, segment, q, q_end, s, a, work, gap_0, gap_1, table
            )
            q1 = q + part * (q_end - q)
        done = to_exit and s1 >= length
        if done:
            part, s1, a1, work1 = _cut(
                law, par, gamma, branch, -1, segment, q, q1, s, a, work,
                s / length - 1.0, s1 / length - 1.0, table,
            )  # fmt: skip
            q1, kink = q + part * (q1 - q), False
        if len(out) > 0:
            start, end = (q, s, a, work), (q1, s1, a1, work1)
            count = record_step(
                law, par, gamma, segment, branch, start, end, points, table, out, count
            )
        q, s, a, work = q1, s1, a1, work1
        if done:
            return SOLVED, q, s, a, work, count
        inside = kink and q < q_end * (1.0 - 1e-13)
        if kink:
            branch = to
        if not inside:
            i += 1
    return LOST, q, s, a, work, count


def record_step(
    law: CompactLaw,
    par: Parameters,
    gamma: float,
    segment: int,
    branch: int,
    start: tuple[float, float, float, float],
    end: tuple[float, float, float, float],
    points: int,
    table: Buffer,
    out: Buffer,
    count: int,
) -> int:
    """Record the points of the equal division inside a step (Q, s, a, work), and its end."""
    if _divided(par, points, start[1], end[1]):
        # halve the step: cubics through its ends and middle are good to 1e-6
        half = 0.5 * (end[0] - start[0])
        fill(law, par, segment, False, 1.0, start[0], half, table, PART, -1)
        sm, am, work_m = _step(table, PART, branch, gamma, start[1], start[2], start[3])
        middle = (start[0] + half, sm, am, work_m)
        count = _between(law, par, gamma, segment, branch, start, middle, points, out, count)
        start = middle
    count = _between(law, par, gamma, segment, branch, start, end, points, out, count)
    record_point(law, par, end[0], end[1], end[2], end[3], out, count)
    return count + 1


def record_point(
    law: CompactLaw,
    par: Parameters,
    q: float,
    s: float,
    a: float,
    work: float,
    out: Buffer,
    count: int,
) -> None:
    """Write one point of a profile, see wraparc.arc.kernel.march.record."""
    side = par.side
    tau, creep = exit_state(law, par, q, a)
    i = RECORD * count
    out[i], out[i + 1], out[i + 2] = s, -side * q, side * a
    out[i + 3], out[i + 4], out[i + 5] = side * creep, side * tau, work


def _divided(par: Parameters, points: int, s: float, s_end: float) -> bool:
    """Whether a point of the equal division of the arc lies inside a step."""
    part = par.length / max(points, 1)
    j = int(s / part * (1.0 + 1e-12)) + 1
    return j < points and j * part < s_end * (1.0 - 1e-12)


def _between(
    law: CompactLaw,
    par: Parameters,
    gamma: float,
    segment: int,
    branch: int,
    start: tuple[float, float, float, float],
    end: tuple[float, float, float, float],
    points: int,
    out: Buffer,
    count: int,
) -> int:
    """Record the points of the equal division inside a step (Q, s, a, work): cubics in s."""
    length = par.length
    s, ds = start[1], end[1] - start[1]
    if not _divided(par, points, s, end[1]):
        return count
    j = int(s / length * points * (1.0 + 1e-12)) + 1
    d0 = _slopes(law, par, gamma, segment, branch, start[0], start[2])
    d1 = _slopes(law, par, gamma, segment, branch, end[0], end[2])
    while j < points and j * length / points < end[1] * (1.0 - 1e-12):
        at = j * length / points
        f = (at - s) / ds
        q = hermite(f, ds, start[0], d0[0], end[0], d1[0])
        a = hermite(f, ds, start[2], d0[1], end[2], d1[1])
        record_point(law, par, q, at, a, hermite(f, ds, start[3], d0[2], end[3], d1[2]), out, count)
        count += 1
        j += 1
    return count


def _slopes(
    law: CompactLaw, par: Parameters, gamma: float, segment: int, branch: int, q: float, a: float
) -> tuple[float, float, float]:
    """Slopes dQ/ds, da/ds and d(friction work)/ds in a piece, past a flat peak too."""
    side = par.side
    if branch == RISE:
        p = par.entry_pressure * exp(-side * q)
        if branch_of(law, segment, a, p) != RISE:
            branch = LINE
    r = rates(law, par, side * gamma, segment, branch, side, -side * q, side * a)
    return -side * r[0], side * r[1], r[2]


def _cut(
    law: CompactLaw,
    par: Parameters,
    gamma: float,
    branch: int,
    to: int,
    segment: int,
    q: float,
    q_end: float,
    s: float,
    a: float,
    work: float,
    gap_0: float,
    gap_1: float,
    table: Buffer,
) -> tuple[float, float, float, float]:
    """The part of a step after which a gap closes, and s, a, work there.

    The gap to another branch, or with `to` = -1 to the exit nip.
    """
    low, high, f_low, f_high = 0.0, 1.0, gap_0, gap_1
    part, s1, a1, work1 = 0.0, s, a, work
    if gap_0 >= 0.0:
        return part, s1, a1, work1
    part = gap_0 / (gap_0 - gap_1)
    for _ in range(60):
        if not low < part < high:
            part = 0.5 * (low + high)
        fill(law, par, segment, False, 1.0, q, part * (q_end - q), table, PART, -1)
        s1, a1, work1 = _step(table, PART, branch, gamma, s, a, work)
        ds, _, _ = _rates(table, PART + 4 * NODE, branch, gamma, a1)
        gap = s1 / par.length - 1.0 if to < 0 else _gap(table, PART + 4 * NODE, branch, to, a1)
        if abs(gap) < LANDING or high - low < 1e-15:
            break
        if gap > 0.0:
            high, f_high = part, gap
        else:
            low, f_low = part, gap
        if to >= 0:
            part = low - f_low * (high - low) / (f_high - f_low)
            # regula falsi keeps one end: halve its weight (Illinois)
            if gap > 0.0:
                f_low *= 0.5
            else:
                f_high *= 0.5
        else:
            part -= gap * part * par.length / ds if ds > 0.0 else part
    return part, s1, a1, work1


def exit_state(law: CompactLaw, par: Parameters, q: float, a: float) -> tuple[float, float]:
    """Shear stress [Pa] and creep [m] towards the slack side of a state at Q with slip a."""
    p = par.entry_pressure * exp(-par.side * q)
    segment = segment_of(law, p)
    branch = branch_of(law, segment, a, p)
    mu, _, _ = friction_at(law, segment, branch, a, p)
    return mu * p, a + par.shear * mu * p
