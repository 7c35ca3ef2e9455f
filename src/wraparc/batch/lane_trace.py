"""The last march of the tensions: every step of the mesh, recorded and looked at.

Derivatives by z are not wanted any more; :mod:`wraparc.batch.lane_read` reads what is recorded.
"""

from __future__ import annotations

from wraparc.batch.elementwise import Lanes, Number, lanes, ln, lower, select, upper
from wraparc.batch.lane_march import set_out
from wraparc.batch.lane_slots import (
    AT,
    NODE,
    PEAK_NODE,
    PEAK_STRESS,
    SLIP_MAX,
    SLIP_STEPS,
    SMALLEST,
    STEEPEST,
    SUM_S,
    SUM_X,
    TRACE,
    G,
    S,
    X,
)


def march(w: Lanes, nodes: Lanes, steps: int, trace: Lanes) -> None:
    """March on every step of the mesh and record where the steps begin, and the exit.

    X and S end at the exit. SLIP_STEPS is the number of steps that begin within SLIP_MAX, PEAK_NODE
    the place of the largest shear stress before the exit, STEEPEST the largest x/x_pk.
    """
    n = lanes()
    set_out(w)
    for i in range(n):
        zero = 0.0 * w[X, i]
        w[SLIP_STEPS, i] = w[PEAK_NODE, i] = w[PEAK_STRESS, i] = w[STEEPEST, i] = zero
    for j in range(steps):
        first_stage(w, nodes, trace, j)
        watch(w, nodes, trace, j)
        stage(w, nodes, 2 * j + 1, 0.5, 2.0)
        stage(w, nodes, 2 * j + 1, 1.0, 2.0)
        last_stage(w, nodes, 2 * j + 2)
    first_stage(w, nodes, trace, steps)
    for i in range(n):
        w[STEEPEST, i] = upper(w[STEEPEST, i], w[X, i] * nodes[NODE * 2 * steps, i])


def rates(
    x: Number,
    g: Number,
    inverse: Number,
    weight: Number,
    shrinkage: Number,
    bend: Number,
    part_1: Number,
    part_2: Number,
    steep: Number,
) -> tuple[Number, Number]:
    """Rates of slip and arc by step at one node; arguments as `lay_nodes` says."""
    r = x * inverse
    log_r = lower(ln(upper(r, SMALLEST)), 0.0)
    t = 1.0 - log_r
    form = lower(r, 1.0) * t
    stiff = 1.0 - steep * log_r
    part = weight / (form * stiff)
    creep = g + shrinkage + bend * form * lower(r, 1.0) * (part_1 * t + part_2 * log_r)
    return creep * part, stiff * part


def stage(w: Lanes, nodes: Lanes, node: int, ahead: float, weight: float) -> None:
    """The same without derivatives."""
    n = lanes()
    o = NODE * node
    for i in range(n):
        dx, ds = rates(
            w[AT, i],
            w[G, i],
            nodes[o, i],
            nodes[o + 1, i],
            nodes[o + 2, i],
            nodes[o + 3, i],
            nodes[o + 4, i],
            nodes[o + 5, i],
            nodes[o + 6, i],
        )
        w[SUM_X, i] = w[SUM_X, i] + weight * dx
        w[SUM_S, i] = w[SUM_S, i] + weight * ds
        w[AT, i] = w[X, i] + ahead * dx


def last_stage(w: Lanes, nodes: Lanes, node: int) -> None:
    """The last stage of a step without derivatives, and its end."""
    n = lanes()
    o = NODE * node
    for i in range(n):
        dx, ds = rates(
            w[AT, i],
            w[G, i],
            nodes[o, i],
            nodes[o + 1, i],
            nodes[o + 2, i],
            nodes[o + 3, i],
            nodes[o + 4, i],
            nodes[o + 5, i],
            nodes[o + 6, i],
        )
        w[X, i] = w[X, i] + (w[SUM_X, i] + dx) / 6.0
        w[S, i] = w[S, i] + (w[SUM_S, i] + ds) / 6.0


def first_stage(w: Lanes, nodes: Lanes, trace: Lanes, place: int) -> None:
    """The first stage of a step without derivatives.

    It records s and x, ds, the shear stress and its change by step.
    """
    n = lanes()
    o, k = TRACE * place, NODE * 2 * place
    for i in range(n):
        x, inverse, traction = w[X, i], nodes[k, i], nodes[k + 7, i]
        r = x * inverse
        log_r = lower(ln(upper(r, SMALLEST)), 0.0)
        y, t = lower(r, 1.0), 1.0 - log_r
        form = y * t
        stiff = 1.0 - nodes[k + 6, i] * log_r
        part = nodes[k + 1, i] / (form * stiff)
        by_p = y * (nodes[k + 4, i] * t + nodes[k + 5, i] * log_r)
        dx = (w[G, i] + nodes[k + 2, i] + nodes[k + 3, i] * form * by_p) * part
        ds = stiff * part
        trace[o, i], trace[o + 1, i], trace[o + 2, i] = w[S, i], x, ds
        trace[o + 3, i] = form * traction
        trace[o + 4, i] = -traction * log_r * inverse * dx - by_p * nodes[k + 8, i]
        w[SUM_X, i], w[SUM_S, i] = dx, ds
        w[AT, i] = x + 0.5 * dx


def watch(w: Lanes, nodes: Lanes, trace: Lanes, place: int) -> None:
    """Count the steps within SLIP_MAX, and keep the largest stress and the steepest slip so far."""
    n = lanes()
    o, k = TRACE * place, NODE * 2 * place
    at = float(place)
    for i in range(n):
        x, stress = trace[o + 1, i], trace[o + 3, i]
        w[SLIP_STEPS, i] = w[SLIP_STEPS, i] + select(x <= w[SLIP_MAX, i], 1.0, 0.0)
        w[PEAK_NODE, i] = select(stress > w[PEAK_STRESS, i], at, w[PEAK_NODE, i])
        w[PEAK_STRESS, i] = upper(w[PEAK_STRESS, i], stress)
        w[STEEPEST, i] = upper(w[STEEPEST, i], x * nodes[k, i])
