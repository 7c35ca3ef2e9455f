"""The march of the lane kernel: many arcs side by side, tension as the independent variable.

With q = ln(T1/T) of a driving pulley (the equations of
:mod:`wraparc.arc.kernel.tension_march`), slip
x > 0 and the entry creep ratio g as parameter:

    ds/dq = R / mu,
    dx/dq = [(g + (T1 - T) C) R / mu + c (mu + p mu_p) p] / (1 + c p mu_x),

on the mesh q = q0 + (Q - q0) eta^4, eta in equal parts, so that x and s are nearly straight
lines in eta. Pressure depends on the node alone: what the law needs there is found once, and an
evaluation costs one logarithm and one division. Steps are the classical ones of fourth order.

Everything runs over lanes (see :mod:`wraparc.batch.elementwise`) and has no branches. A
lane's numbers are kept in `w`, slot by slot: w[slot, lane].
"""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    ex,
    lanes,
    ln,
    lower,
    root,
    select,
    upper,
)
from wraparc.batch.lane_fall import friction_of, lay_tail, rates_of
from wraparc.batch.lane_look import (
    look_up,
)
from wraparc.batch.lane_slots import (
    AT,
    AT_Z,
    BEND,
    END,
    FRICTION_AT,
    FRICTION_P,
    G_Z,
    HIGH,
    KICK,
    LOW,
    NODE,
    P1,
    PASS_HIGH,
    PASS_LOW,
    PEAK_FRICTION,
    PEAK_SLIP,
    PRESSURE,
    Q0,
    RADIUS,
    RATIO,
    S_Z,
    SHARE,
    SHEAR,
    SLIP_AT,
    SLIP_P,
    SMALLEST,
    SUM_S,
    SUM_SZ,
    SUM_X,
    SUM_XZ,
    X_Z,
    G,
    S,
    X,
)

#: None for laws that are flat past their peak: code for the others is then not compiled
Falls = float | None


def start(w: Lanes) -> None:
    """Begin a march at ln tension Q0: at the slip of the kick, or a short way past no slip.

    Without a kick the first stretch, where creep is u = g s, is closed analytically: u = x + c tau
    and dq/ds = mu/R give R g q = Phi(x) + c p mu^2/2 with Phi = int mu dx.
    """
    n = lanes()
    for i in range(n):
        kick, slip = w[KICK, i], w[PEAK_SLIP, i]
        stiffness = w[PEAK_FRICTION, i] / slip
        bend = w[SHEAR, i] * w[P1, i] * stiffness
        work = w[RADIUS, i] * upper(w[G, i], SMALLEST) * w[Q0, i]
        kicked = kick / (1.0 + bend * (1.0 - ln(lower(upper(kick / slip, SMALLEST), 1.0))))
        # mu = 10 x mu_pk/x_pk is about right at the small slips of the first stretch
        free = root(upper(work, SMALLEST) / (stiffness * (5.0 + 50.0 * bend)))
        w[X, i] = select(kick <= 0.0, free, kicked)
    for _ in range(5):
        find_start(w)
    for i in range(n):
        g, x = upper(w[G, i], SMALLEST), w[X, i]
        slip, shear = w[PEAK_SLIP, i], w[SHEAR, i] * w[P1, i]
        log_r = lower(ln(upper(x / slip, SMALLEST)), 0.0)
        mu = w[PEAK_FRICTION, i] * lower(x / slip, 1.0) * (1.0 - log_r)
        stiff = 1.0 - shear * w[PEAK_FRICTION, i] / slip * log_r
        s = (x + shear * mu) / g
        x_z = w[RADIUS, i] * w[Q0, i] * w[G_Z, i] / (mu * stiff)
        free = w[KICK, i] <= 0.0
        w[S, i] = select(free, s, 0.0)
        w[X_Z, i] = select(free, x_z, 0.0)
        w[S_Z, i] = select(free, (stiff * x_z - s * w[G_Z, i]) / g, 0.0)


def find_start(w: Lanes) -> None:
    """One Newton step of the slip at the start: its creep is the kick, or its work R g Q0."""
    n = lanes()
    for i in range(n):
        kick, x, slip = w[KICK, i], w[X, i], w[PEAK_SLIP, i]
        friction, shear = w[PEAK_FRICTION, i], w[SHEAR, i] * w[P1, i]
        work = w[RADIUS, i] * upper(w[G, i], SMALLEST) * w[Q0, i]
        r = upper(x / slip, SMALLEST)
        log_r = lower(ln(r), 0.0)
        r = lower(r, 1.0)
        mu = friction * r * (1.0 - log_r)
        stiff = 1.0 - shear * friction / slip * log_r
        done = friction * slip * r * r * (0.75 - 0.5 * log_r) + 0.5 * shear * mu * mu
        free = kick <= 0.0
        miss = select(free, done - work, x + shear * mu - kick)
        w[X, i] = upper(x - miss / select(free, mu * stiff, stiff), 0.1 * x)


def lay_nodes(w: Lanes, laws: Table, steps: int, stride: int, nodes: Lanes, falls: Falls) -> None:
    """Numbers of every `stride`-th node of a mesh: what the stages need of the law there.

    Nodes are the ends and the middle of every step. Of a node: 1/x_pk, R/mu_pk dq, (T1 - T) C,
    c p mu_pk/R, the two parts of mu + p mu_p, c p mu_pk/x_pk, mu_pk p, and p dq; dq is the q of a
    step there.

    Where the pressure passes an end of the law's range, mu_p jumps. In the middle of the step where
    it does, the jump is weighted so that Simpson's rule over the step has the right share of it.
    """
    n = lanes()
    for i in range(n):
        span = w[END, i] - w[Q0, i]
        w[BEND, i] = w[SHEAR, i] / w[RADIUS, i]
        high = (ln(w[P1, i] / w[HIGH, i]) - w[Q0, i]) / span
        low = (ln(w[P1, i] / w[LOW, i]) - w[Q0, i]) / span
        # negative: passed before the entry
        w[PASS_HIGH, i] = select(high > 0.0, steps * root(root(upper(high, 0.0))), -1.0)
        w[PASS_LOW, i] = select(low > 0.0, steps * root(root(upper(low, 0.0))), -1.0)
    for k in range(0, 2 * steps + 1, stride):
        eta = k / (2.0 * steps)
        for i in range(n):
            q0 = w[Q0, i]
            fall = ex(-(q0 + (w[END, i] - q0) * (eta * eta * eta * eta)))
            w[PRESSURE, i] = w[P1, i] * fall
            nodes[NODE * k + 2, i] = w[RATIO, i] * (1.0 - fall)
        look_up(w, laws)
        lay_node(w, k, 4.0 / steps * eta * eta * eta, nodes)
        if falls is not None:
            lay_tail(w, k, nodes)


def lay_node(w: Lanes, k: int, growth: float, nodes: Lanes) -> None:
    """Numbers of one node, where q grows by `growth` of its span in a step."""
    n = lanes()
    o = NODE * k
    j = float(k // 2)
    # of what begins within the step: nothing at its ends, Simpson's due in its middle
    constant, slope = (1.25, 1.5) if k % 2 == 1 else (0.0, 0.0)
    for i in range(n):
        slip, friction = w[SLIP_AT, i], w[FRICTION_AT, i]
        # shares of the node below the range and not above it
        below = past(j - w[PASS_LOW, i], constant, slope)
        not_above = past(j - w[PASS_HIGH, i], constant, slope)
        inside = not_above - below
        friction_p = inside * w[FRICTION_P, i] - (1.0 - not_above) * friction
        traction = friction * w[PRESSURE, i]
        span = growth * (w[END, i] - w[Q0, i])
        inverse = 1.0 / slip
        w[SHARE, i] = inside
        nodes[o, i] = inverse
        nodes[o + 1, i] = w[RADIUS, i] * span / friction
        nodes[o + 3, i] = w[BEND, i] * traction
        nodes[o + 4, i] = friction + friction_p
        nodes[o + 5, i] = inside * friction * w[SLIP_P, i] * inverse
        nodes[o + 6, i] = w[SHEAR, i] * traction * inverse
        nodes[o + 7, i] = traction
        nodes[o + 8, i] = w[PRESSURE, i] * span


def past(ahead: Number, constant: float, slope: float) -> Number:
    """Weight at a node of what begins `-ahead` steps after the node's step does.

    1 past it, 0 a step and more before it. For a node in the middle of the step in which it begins,
    (5 - 6 theta)/4 with theta = -ahead: Simpson's rule over the step then gives 1 - theta.
    """
    within = select(ahead < -1.0, 0.0, constant + slope * ahead)
    return select(ahead >= 0.0, 1.0, within)


def rates_z(
    x: Number,
    x_z: Number,
    g: Number,
    g_z: Number,
    inverse: Number,
    weight: Number,
    shrinkage: Number,
    bend: Number,
    part_1: Number,
    part_2: Number,
    steep: Number,
) -> tuple[Number, Number, Number, Number]:
    """Rates of slip and arc by step, and of their derivatives by z."""
    r = x * inverse
    log_r = lower(ln(upper(r, SMALLEST)), 0.0)
    y = lower(r, 1.0)
    t = 1.0 - log_r
    form = y * t
    stiff = 1.0 - steep * log_r
    one = 1.0 / (form * stiff)
    part = weight * one
    traction = part_1 * t + part_2 * log_r
    creep = g + shrinkage + bend * form * y * traction
    dx, ds = creep * part, stiff * part
    # by ln x: of ln r is 1, of form -y ln r, of stiff -steep, on the rising branch
    log_x = select(r < 1.0, x_z * inverse * t * stiff * one, 0.0)
    fall = log_r * y * stiff * one
    creep_x = bend * y * y * ((2.0 * t - 1.0) * traction + t * (part_2 - part_1))
    dx_x = part * creep_x + dx * (fall + steep * form * one)
    return dx, ds, dx_x * log_x + part * g_z, ds * fall * log_x


def march_z(w: Lanes, nodes: Lanes, steps: int, stride: int, falls: Falls) -> None:
    """March on every `stride`-th step of the mesh, with the derivatives by z.

    X, S and their derivatives end at the exit, SUM_X and SUM_S as the rates there by step of the
    finest mesh.
    """
    h = float(stride)
    set_out(w)
    for j in range(0, steps, stride):
        stage_z(w, nodes, 2 * j, 0.5 * h, 1.0, falls)
        stage_z(w, nodes, 2 * j + stride, 0.5 * h, 2.0, falls)
        stage_z(w, nodes, 2 * j + stride, h, 2.0, falls)
        stage_z(w, nodes, 2 * (j + stride), 0.0, 1.0, falls)
        arrive(w, h / 6.0)
    stage_z(w, nodes, 2 * steps, 0.0, 1.0, falls)


def set_out(w: Lanes) -> None:
    """Make ready for the first step."""
    n = lanes()
    for i in range(n):
        zero = 0.0 * w[X, i]
        w[AT, i], w[AT_Z, i] = w[X, i], w[X_Z, i]
        w[SUM_X, i] = w[SUM_S, i] = w[SUM_XZ, i] = w[SUM_SZ, i] = zero


def arrive(w: Lanes, weight: float) -> None:
    """End a step: add the weighted sum of its rates."""
    n = lanes()
    for i in range(n):
        zero = 0.0 * w[SUM_X, i]
        w[X, i] = w[AT, i] = w[X, i] + weight * w[SUM_X, i]
        w[X_Z, i] = w[AT_Z, i] = w[X_Z, i] + weight * w[SUM_XZ, i]
        w[S, i] = w[S, i] + weight * w[SUM_S, i]
        w[S_Z, i] = w[S_Z, i] + weight * w[SUM_SZ, i]
        w[SUM_X, i] = w[SUM_S, i] = w[SUM_XZ, i] = w[SUM_SZ, i] = zero


def stage_z(w: Lanes, nodes: Lanes, node: int, ahead: float, weight: float, falls: Falls) -> None:
    """One stage: rates at AT added to the sums with a weight, AT put `ahead` in the step."""
    n = lanes()
    o = NODE * node
    for i in range(n):
        if falls is None:
            dx, ds, dxz, dsz = rates_z(
                w[AT, i],
                w[AT_Z, i],
                w[G, i],
                w[G_Z, i],
                nodes[o, i],
                nodes[o + 1, i],
                nodes[o + 2, i],
                nodes[o + 3, i],
                nodes[o + 4, i],
                nodes[o + 5, i],
                nodes[o + 6, i],
            )
        else:
            r = w[AT, i] * nodes[o, i]
            log_r = lower(ln(upper(r, SMALLEST)), 0.0)
            form, form_r, traction, traction_r = friction_of(
                r,
                log_r,
                nodes[o + 4, i],
                nodes[o + 5, i],
                nodes[o + 9, i],
                nodes[o + 10, i],
                nodes[o + 11, i],
                nodes[o + 12, i],
            )
            dx, ds, dx_r, ds_r, dx_g = rates_of(
                form,
                form_r,
                traction,
                traction_r,
                w[G, i] + nodes[o + 2, i],
                nodes[o + 1, i],
                nodes[o + 3, i],
                nodes[o + 6, i],
                select(r < 1.0, 1.0 - log_r, 0.0),
            )
            r_z = w[AT_Z, i] * nodes[o, i]
            dxz, dsz = dx_r * r_z + dx_g * w[G_Z, i], ds_r * r_z
        w[SUM_X, i] = w[SUM_X, i] + weight * dx
        w[SUM_S, i] = w[SUM_S, i] + weight * ds
        w[SUM_XZ, i] = w[SUM_XZ, i] + weight * dxz
        w[SUM_SZ, i] = w[SUM_SZ, i] + weight * dsz
        w[AT, i] = w[X, i] + ahead * dx
        w[AT_Z, i] = w[X_Z, i] + ahead * dxz
