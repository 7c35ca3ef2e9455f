"""Solve arcs in lanes: the entry creep ratio that meets the tensions, and what they could carry.

The unknown is carried as z = ln(g + x_c/l), l the shear-lag length of small slip: the length of arc
found for the tensions is nearly ln s = const - z where the belt is stiff and s = l (const - z)
where it is soft. Newton's method on ln(s/L), on finer and finer meshes, takes one step on each.
"""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Table,
    ex,
    lanes,
    ln,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_fall import form_of
from wraparc.batch.lane_guess import (
    end_of_pull,
)
from wraparc.batch.lane_march import (
    Falls,
    lay_nodes,
    march_z,
    start,
)
from wraparc.batch.lane_slots import (
    CHANGE,
    COARSE_X,
    DETERMINANT,
    END,
    EXIT_X,
    EXIT_X_Z,
    G_Z,
    GAMMA,
    GOAL,
    GOAL_MISS,
    KEPT,
    KEPT_GOAL,
    KEPT_SZ,
    KEPT_VZ,
    KICK,
    LENGTH,
    MISS,
    NODE,
    PULL,
    Q0,
    RATIO,
    S_BY_Q,
    S_BY_T,
    S_BY_Z,
    S_Z,
    SHEAR,
    SLOPE_Z,
    SMALLEST,
    SUM_S,
    SUM_X,
    TENSION,
    V_BY_Q,
    V_BY_T,
    V_BY_Z,
    X_Z,
    G,
    S,
    X,
    Z,
)
from wraparc.batch.lane_trace import march

TENSION_STEP = 1e-3
START_SHARE, START_GROWTH = 1e-6, 3e-4  # Q0 in Q, and of g in the creep ratio at Q0


def set_ratio(w: Lanes) -> None:
    """G and dg/dz of z."""
    n = lanes()
    for i in range(n):
        e = ex(lower(upper(w[Z, i], -60.0), 3.0))
        w[G, i], w[G_Z, i] = e - w[GAMMA, i], e


def set_origin(w: Lanes) -> None:
    """Q0: 0 with a kick, else so small that creep is still g s there."""
    n = lanes()
    for i in range(n):
        g, ratio = upper(w[G, i], SMALLEST), w[RATIO, i]
        q = lower(START_SHARE * w[END, i], START_GROWTH * g / upper(ratio, SMALLEST))
        w[Q0, i] = select(w[KICK, i] <= 0.0, q, 0.0)


def correct(w: Lanes, reach: float) -> None:
    """One Newton step of z for ln(s/L) = 0, at most `reach` long; upwards where it is lost."""
    n = lanes()
    for i in range(n):
        miss = ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])
        slope = w[S_Z, i] / w[S, i]
        good = (slope < 0.0) & (miss < 50.0) & (miss > -50.0)
        step = lower(upper(miss / lower(slope, -SMALLEST), -reach), reach)
        w[Z, i] = w[Z, i] - select(good, step, -1.0)


def meet_tensions(w: Lanes, laws: Table, nodes: Lanes, trace: Lanes, steps: int) -> None:
    """Find z for the tensions: a Newton step on every fourth and on every second step of a mesh.

    EXIT_X, the exit slip of the last march, and Z are brought to s = L by the derivatives. MISS is
    the larger of |ln(s/L)| and of the relative change of EXIT_X by that: what is left is about its
    square, and a sixteenth for the mesh.
    """
    n = lanes()
    set_ratio(w)
    set_origin(w)
    lay_nodes(w, laws, steps, 1, nodes, None)
    for stride in (4, 2):
        set_ratio(w)
        start(w)
        march_z(w, nodes, steps, stride, None)
        correct(w, 2.0)
    for i in range(n):
        slope = lower(w[S_Z, i] / w[S, i], -SMALLEST)
        miss = ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])
        w[SLOPE_Z, i] = slope
        w[EXIT_X_Z, i] = w[X_Z, i]
        w[COARSE_X, i] = w[X, i] - w[X_Z, i] * lower(upper(miss / slope, -1.0), 1.0)
    set_ratio(w)
    start(w)
    march(w, nodes, steps, trace)
    for i in range(n):
        miss = ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])
        step = lower(upper(miss / w[SLOPE_Z, i], -1.0), 1.0)
        change = w[EXIT_X_Z, i] * step
        w[EXIT_X, i] = w[X, i] - change
        w[Z, i] = w[Z, i] - step
        change = change / w[X, i]
        w[MISS, i] = upper(upper(miss, -miss), upper(change, -change))
        change = w[COARSE_X, i] / w[EXIT_X, i] - 1.0
        w[CHANGE, i] = upper(change, -change)


def meet_creep(
    w: Lanes,
    laws: Table,
    nodes: Lanes,
    steps: int,
    of_slip: float,
    least: bool,
    first: int,
    last: int,
    falls: Falls,
) -> None:
    """Find z and END at which the exit creep (the exit slip, if `of_slip` is 1) is GOAL.

    Marches are those from `first` to before `last` of: -1 and 0 on every fourth step, 1 on every
    second, 2 and 3 on single ones. With `least` the pull is given, and the
    entry tension is found instead of END. MISS is the larger relative miss before the last
    correction, or the correction if it is larger.
    """
    for k in range(first, last):
        stride = max(4 >> max(k, 0), 1)
        place(w, laws, nodes, steps, stride, least, falls)
        measure(w, nodes, steps, of_slip, falls)
        if least and k == first:
            vary_tension(w, laws, nodes, steps, stride, of_slip, falls)
        correct_pair(w, least)


def place(
    w: Lanes, laws: Table, nodes: Lanes, steps: int, stride: int, least: bool, falls: Falls
) -> None:
    """March the arc of z and END, or of z and TENSION."""
    if least:
        end_of_pull(w, laws)
    set_ratio(w)
    set_origin(w)
    lay_nodes(w, laws, steps, stride, nodes, falls)
    start(w)
    march_z(w, nodes, steps, stride, falls)


def measure(w: Lanes, nodes: Lanes, steps: int, of_slip: float, falls: Falls) -> None:
    """Misses of the arc and of the goal after a march, and their derivatives by z and END."""
    n = lanes()
    last = NODE * 2 * steps
    for i in range(n):
        x, c = w[X, i], w[SHEAR, i]
        r = upper(x * nodes[last, i], SMALLEST)
        if falls is None:
            log_r = lower(ln(r), 0.0)
            form, form_r = lower(r, 1.0) * (1.0 - log_r), -log_r
        else:
            form, form_r = form_of(r, nodes[last + 9, i], nodes[last + 10, i])
        value = x + (1.0 - of_slip) * c * form * nodes[last + 7, i]
        stiff = 1.0 + (1.0 - of_slip) * nodes[last + 6, i] * form_r
        # rates by step of the finest mesh to rates by q
        per_q = steps / (4.0 * (w[END, i] - w[Q0, i]))
        s_q, x_q = w[SUM_S, i] * per_q, w[SUM_X, i] * per_q
        creep_q = (w[G, i] + nodes[last + 2, i]) * s_q
        w[MISS, i] = ln(upper(w[S, i], SMALLEST) / w[LENGTH, i])
        w[GOAL_MISS, i] = ln(upper(value, SMALLEST) / w[GOAL, i])
        w[S_BY_Z, i], w[S_BY_Q, i] = w[S_Z, i] / w[S, i], s_q / w[S, i]
        w[V_BY_Z, i] = stiff * w[X_Z, i] / value
        w[V_BY_Q, i] = (of_slip * x_q + (1.0 - of_slip) * creep_q) / value


def vary_tension(
    w: Lanes, laws: Table, nodes: Lanes, steps: int, stride: int, of_slip: float, falls: Falls
) -> None:
    """Derivatives of the misses by ln T2 at a given pull, from a second march."""
    n = lanes()
    for i in range(n):
        w[KEPT, i], w[KEPT_GOAL, i] = w[MISS, i], w[GOAL_MISS, i]
        w[KEPT_SZ, i], w[KEPT_VZ, i] = w[S_BY_Z, i], w[V_BY_Z, i]
        w[TENSION, i] = w[TENSION, i] + TENSION_STEP * (w[TENSION, i] - w[PULL, i])
    place(w, laws, nodes, steps, stride, True, falls)
    measure(w, nodes, steps, of_slip, falls)
    for i in range(n):
        w[S_BY_T, i] = (w[MISS, i] - w[KEPT, i]) / TENSION_STEP
        w[V_BY_T, i] = (w[GOAL_MISS, i] - w[KEPT_GOAL, i]) / TENSION_STEP
        w[MISS, i], w[GOAL_MISS, i] = w[KEPT, i], w[KEPT_GOAL, i]
        w[S_BY_Z, i], w[V_BY_Z, i] = w[KEPT_SZ, i], w[KEPT_VZ, i]
        w[TENSION, i] = (w[TENSION, i] + TENSION_STEP * w[PULL, i]) / (1.0 + TENSION_STEP)


def correct_pair(w: Lanes, least: bool) -> None:
    """One Newton step of z and END, or of z and ln T2. MISS is the largest miss, as above."""
    n = lanes()
    for i in range(n):
        f, v = w[MISS, i], w[GOAL_MISS, i]
        fz, vz = w[S_BY_Z, i], w[V_BY_Z, i]
        if least:
            fq, vq = w[S_BY_T, i], w[V_BY_T, i]
        else:
            fq, vq = w[S_BY_Q, i], w[V_BY_Q, i]
        det = fz * vq - fq * vz
        dz, dq = (f * vq - v * fq) / det, (v * fz - f * vz) / det
        # along the goal the arc grows with END, and shrinks with T2 at a given pull
        sound = det > 0.0 if least else det < 0.0
        good = sound & (dz < 1e6) & (dz > -1e6)
        w[DETERMINANT, i] = det
        w[Z, i] = w[Z, i] - select(good, lower(upper(dz, -1.5), 1.5), -0.5)
        if least:
            move = ex(-select(good, lower(upper(dq, -1.0), 1.0), 0.0))
            w[TENSION, i] = w[PULL, i] + (w[TENSION, i] - w[PULL, i]) * move
        else:
            most = 0.5 * w[END, i]
            w[END, i] = w[END, i] - select(good, lower(upper(dq, -most), most), 0.0)
        miss = upper(upper(f, -f), upper(v, -v))
        w[MISS, i] = upper(miss, upper(dq, -dq))
