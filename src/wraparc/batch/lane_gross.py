"""Gross slip of laws that fall past their peak, in lanes: the largest tension ratio over creep.

First scans over the entry creep ratio, on one mesh that reaches as far as the plateau of the law
would carry: where a march passes the end of the arc tells its ratio. Static and residual friction
may each have a maximum; the scan decides for the larger. Then Newton's method on dQ/dz = 0, with
Q = ln(T1/T2): marches with their derivatives by z, and secants for the second derivative.
"""

from __future__ import annotations

from math import log

from wraparc.batch.elementwise import (
    Lanes,
    Table,
    ex,
    lanes,
    ln,
    lower,
    root,
    select,
    upper,
)
from wraparc.batch.lane_fall import friction_of
from wraparc.batch.lane_march import arrive, lay_nodes, set_out, start
from wraparc.batch.lane_slots import (
    AT,
    BEST,
    BEST_AT,
    CARRIED,
    CENTRE,
    CREST,
    DETERMINANT,
    END,
    EXIT_CREEP,
    FALLEN,
    GAMMA,
    GOAL,
    GOAL_MISS,
    KEPT,
    KEPT_GOAL,
    LAST,
    LENGTH,
    MISS,
    NODE,
    Q0,
    RISEN,
    S_BY_Q,
    S_BY_Z,
    S_LAST,
    S_RATE,
    SMALLEST,
    SUM_S,
    SUM_X,
    V_BY_Q,
    V_BY_Z,
    G,
    S,
    X,
    Z,
)
from wraparc.batch.lane_solve import measure, place, set_origin, set_ratio

SPAN = -log(1e-5)  # of ln of the entry creep ratios that are looked at; the highest is 1
SCANS = 8  # equal parts of it, at first; and of two of the parts, then
SCAN_STRIDE = 6  # of steps of the mesh
REACH, TRUSTED = 0.4, 8.0  # of a step of z; factor by which a second derivative may change
AT_TOP = -0.1  # a second derivative to begin with where the largest ratio is at the highest creep
Z_SHARE = 0.1  # of a correction of z in what is left: the largest ratio hardly feels it


def meet_gross(w: Lanes, laws: Table, nodes: Lanes, steps: int) -> None:
    """Find z and END of the largest tension ratio; END is what the plateau carries at first.

    MISS is the largest of the miss of the arc and the last corrections. DETERMINANT is the place
    of the maximum in the first scan; 0 at its low end, where nothing is found.
    """
    scan(w, laws, nodes, steps)
    for k, stride in enumerate((4, 2, 1, 1)):
        place(w, laws, nodes, steps, stride, False, 1.0)
        measure(w, nodes, steps, 0.0, 1.0)
        to_crest(w, k > 0)


def scan(w: Lanes, laws: Table, nodes: Lanes, steps: int) -> None:
    """Z and END near the largest tension ratio, and the second derivative CREST there."""
    n = lanes()
    for i in range(n):
        w[G, i] = ex(-SPAN + 0.0 * w[END, i])
        w[CENTRE, i] = -0.5 * SPAN + 0.0 * w[END, i]
    set_origin(w)
    lay_nodes(w, laws, steps, SCAN_STRIDE, nodes, 1.0)
    look_along(w, nodes, steps, SPAN / SCANS)
    for i in range(n):
        w[DETERMINANT, i] = (w[BEST_AT, i] + SPAN) * (SCANS / SPAN)
        w[CENTRE, i] = w[BEST_AT, i]
    h = 2.0 * SPAN / (SCANS * SCANS)
    look_along(w, nodes, steps, h)
    for i in range(n):
        inside = w[BEST_AT, i] < 0.0
        bend = lower(w[RISEN, i] + w[FALLEN, i] - 2.0 * w[BEST, i], -1e-6)
        part = lower(upper(0.5 * (w[RISEN, i] - w[FALLEN, i]) / bend, -1.0), 1.0)
        g = ex(lower(w[BEST_AT, i] + select(inside, h * part, 0.0), 0.0))
        by_z = (g + w[GAMMA, i]) / (g * h)
        w[CREST, i] = select(inside, bend * by_z * by_z, AT_TOP)
        w[Z, i] = ln(g + w[GAMMA, i])
        w[END, i] = w[BEST, i]


def look_along(w: Lanes, nodes: Lanes, steps: int, h: float) -> None:
    """Ratios carried at places `h` apart about CENTRE in ln g.

    The largest is BEST, at BEST_AT; RISEN is the one before it and FALLEN the one after it.
    """
    n = lanes()
    for i in range(n):
        none = -1.0 + 0.0 * w[CENTRE, i]
        w[BEST, i] = w[BEST_AT, i] = w[LAST, i] = w[RISEN, i] = w[FALLEN, i] = none
    for k in range(SCANS + 1):
        for i in range(n):
            at = lower(w[CENTRE, i] + h * (k - 0.5 * SCANS), 0.0)
            w[KEPT, i] = at
            w[Z, i] = ln(ex(at) + w[GAMMA, i])
        set_ratio(w)
        start(w)
        carry(w, nodes, steps)
        for i in range(n):
            value, last = w[CARRIED, i], w[LAST, i]
            w[FALLEN, i] = select(last == w[BEST, i], value, w[FALLEN, i])
            better = value > w[BEST, i]
            w[RISEN, i] = select(better, last, w[RISEN, i])
            w[BEST_AT, i] = select(better, w[KEPT, i], w[BEST_AT, i])
            w[BEST, i] = select(better, value, w[BEST, i])
            w[LAST, i] = value


def carry(w: Lanes, nodes: Lanes, steps: int) -> None:
    """March on the scan's mesh. CARRIED is where it passes the end of the arc, END at most."""
    n = lanes()
    h = float(SCAN_STRIDE)
    set_out(w)
    for i in range(n):
        w[CARRIED, i] = w[END, i]
    for j in range(0, steps, SCAN_STRIDE):
        stage(w, nodes, 2 * j, 0.5 * h, 1.0)
        for i in range(n):
            w[S_LAST, i], w[S_RATE, i] = w[S, i], h * w[SUM_S, i]
        stage(w, nodes, 2 * j + SCAN_STRIDE, 0.5 * h, 2.0)
        stage(w, nodes, 2 * j + SCAN_STRIDE, h, 2.0)
        stage(w, nodes, 2 * (j + SCAN_STRIDE), 0.0, 1.0)
        arrive(w, h / 6.0)
        for i in range(n):
            # a parabola through both ends, with the slope at the first
            due, slope = w[LENGTH, i] - w[S_LAST, i], w[S_RATE, i]
            bend = w[S, i] - w[S_LAST, i] - slope
            part = 2.0 * due / (slope + root(upper(slope * slope + 4.0 * bend * due, 0.0)))
            eta = (j + h * part) / steps
            q = w[Q0, i] + (w[END, i] - w[Q0, i]) * (eta * eta * eta * eta)
            passes = (due > 0.0) & (w[S, i] >= w[LENGTH, i])
            w[CARRIED, i] = select(passes, q, w[CARRIED, i])


def stage(w: Lanes, nodes: Lanes, node: int, ahead: float, weight: float) -> None:
    """`lane_march.stage` of a law that falls."""
    n = lanes()
    o = NODE * node
    for i in range(n):
        r = w[AT, i] * nodes[o, i]
        form, form_r, traction, _ = friction_of(
            r,
            lower(ln(upper(r, SMALLEST)), 0.0),
            nodes[o + 4, i],
            nodes[o + 5, i],
            nodes[o + 9, i],
            nodes[o + 10, i],
            nodes[o + 11, i],
            nodes[o + 12, i],
        )
        ds = nodes[o + 1, i] / form
        creep = w[G, i] + nodes[o + 2, i] + nodes[o + 3, i] * form * traction
        dx = creep * ds / (1.0 + nodes[o + 6, i] * form_r)
        w[SUM_X, i] = w[SUM_X, i] + weight * dx
        w[SUM_S, i] = w[SUM_S, i] + weight * ds
        w[AT, i] = w[X, i] + ahead * dx


def to_crest(w: Lanes, again: bool) -> None:
    """One step of z and END towards s = L and dQ/dz = 0, or a creep ratio of 1.

    `again`: it is not the first.
    """
    n = lanes()
    for i in range(n):
        miss, s_q = w[MISS, i], w[S_BY_Q, i]
        slope, crest = -w[S_BY_Z, i] / s_q, w[CREST, i]
        if again:
            secant = (slope - w[KEPT, i]) / (w[Z, i] - w[KEPT_GOAL, i])
            # not, where it is no maximum's or the two are too near each other to tell
            sound = (secant < crest / TRUSTED) & (secant > crest * TRUSTED)
            crest = select(sound, secant, crest)
        top = ln(1.0 + w[GAMMA, i]) - w[Z, i]
        dz = lower(lower(upper(-slope / crest, -REACH), REACH), top)
        dq = (slope + 0.5 * crest * dz) * dz - miss / s_q
        w[KEPT, i], w[KEPT_GOAL, i], w[CREST, i] = slope, w[Z, i], crest
        w[Z, i], w[END, i] = w[Z, i] + dz, w[END, i] + lower(upper(dq, -0.5), 0.5)
        growth = w[GOAL_MISS, i] + w[V_BY_Z, i] * dz + w[V_BY_Q, i] * dq
        w[EXIT_CREEP, i] = w[GOAL, i] * ex(lower(upper(growth, -50.0), 50.0))
        left = upper(upper(miss, -miss), Z_SHARE * upper(dz, -dz))
        w[MISS, i] = upper(left, upper(dq, -dq))
