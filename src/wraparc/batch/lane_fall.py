"""Friction past its peak in the lanes: a straight line, then the residual level.

With r = x/x_pk the friction is mu_pk form(r): r (1 - ln r) up to the peak, then 1 + k (r - 1), at
least rho; k = m x_pk/mu_pk and rho = mu_res/mu_pk depend on the pressure alone, as all that a node
holds does. Kinks are not cut: a law that falls is marched on the finer mesh.

Functions of a lane are so short that LLVM puts them into the loops over lanes: a loop with a call
is not vectorised.
"""

from __future__ import annotations

from wraparc.batch.elementwise import Lanes, Number, lanes, ln, lower, select, upper
from wraparc.batch.lane_law import RESIDUAL_CUBIC, SLOPE_CUBIC
from wraparc.batch.lane_slots import (
    CELL_AT,
    FRICTION_AT,
    FRICTION_P,
    HIGH,
    INSIDE,
    NODE,
    PRESSURE,
    SHARE,
    SLIP_AT,
    SLIP_P,
    SMALLEST,
)


def lay_tail(w: Lanes, k: int, nodes: Lanes) -> None:
    """Numbers of one node past the peak: k, rho, and what p mu_p has of their slopes."""
    n = lanes()
    o = NODE * k
    a, b = CELL_AT + SLOPE_CUBIC, CELL_AT + RESIDUAL_CUBIC
    for i in range(n):
        p = w[INSIDE, i]
        t = p - w[CELL_AT, i]
        m1, m2, m3 = w[a + 1, i], w[a + 2, i], w[a + 3, i]
        r1, r2, r3 = w[b + 1, i], w[b + 2, i], w[b + 3, i]
        fall = w[a, i] + t * (m1 + t * (m2 + t * m3))
        residual = w[b, i] + t * (r1 + t * (r2 + t * r3))
        fall_p = p * (m1 + t * (2.0 * m2 + 3.0 * t * m3))
        residual_p = p * (r1 + t * (2.0 * r2 + 3.0 * t * r3))
        friction, held = w[FRICTION_AT, i], w[HIGH, i] / upper(w[PRESSURE, i], w[HIGH, i])
        peak, slip = friction / held, w[SLIP_AT, i]
        part = w[SHARE, i] * friction
        line, rho = fall * slip / peak, residual / peak
        falls = (rho < 1.0) & (fall < 0.0)
        by_pressure = slip * fall_p / peak + line * (w[SLIP_P, i] / slip - w[FRICTION_P, i] / peak)
        nodes[o + 9, i] = select(falls, line, 0.0)
        nodes[o + 10, i] = select(falls, rho, 1.0)
        nodes[o + 11, i] = select(falls, part * by_pressure, 0.0)
        nodes[o + 12, i] = select(
            falls, part * (residual_p - rho * w[FRICTION_P, i]) / peak, w[SHARE, i] * 0.0
        )


def form_of(r: Number, line: Number, rho: Number) -> tuple[Number, Number]:
    """Friction over that of the peak, and its slope by r."""
    log_r = lower(ln(upper(r, SMALLEST)), 0.0)
    past = 1.0 + line * (r - 1.0)
    on_line = past > rho
    form = select(r < 1.0, r * (1.0 - log_r), select(on_line, past, rho))
    return form, select(r < 1.0, -log_r, select(on_line, line, 0.0))


def friction_of(
    r: Number,
    log_r: Number,
    part_1: Number,
    part_2: Number,
    line: Number,
    rho: Number,
    line_p: Number,
    rho_p: Number,
) -> tuple[Number, Number, Number, Number]:
    """Friction over that of the peak and mu + p mu_p, each with its slope by r.

    Arguments as `lane_march.lay_nodes` and `lay_tail` say; `log_r` is 0 past the peak.
    """
    rises, past = r < 1.0, 1.0 + line * (r - 1.0)
    on_line = past > rho
    form = select(rises, r * (1.0 - log_r), select(on_line, past, rho))
    form_r = select(rises, -log_r, select(on_line, line, 0.0))
    traction_r = select(rises, part_2 * (1.0 + log_r), select(on_line, line_p - line * part_2, 0.0))
    # r times the slope, and on the line what that has too much; the residual level has no slope
    rest = select(on_line, -line_p, part_1 * 0.0 + rho_p)
    traction = part_1 * form + select(rises, part_2 * r * log_r, rest + r * traction_r)
    return form, form_r, traction, traction_r + part_1 * form_r


def rates_of(
    form: Number,
    form_r: Number,
    traction: Number,
    traction_r: Number,
    creep: Number,
    weight: Number,
    bend: Number,
    steep: Number,
    rise: Number,
) -> tuple[Number, Number, Number, Number, Number]:
    """Rates of slip and arc by step, their derivatives by r, and that of slip by g.

    Of what `friction_of` gives; `creep` is g and shrinkage, `rise` form/r where friction rises and
    else 0.
    """
    stiff = 1.0 + steep * form_r
    one = 1.0 / (form * stiff)
    part = weight * one
    dx = (creep + bend * form * traction) * part
    ds = stiff * part
    bent = part * bend * (form_r * traction + form * traction_r)
    dx_r = bent - dx * one * (form_r * stiff - steep * rise)
    return dx, ds, dx_r, -ds * form_r * stiff * one, part
