"""The march with creep as the state: in position, whatever the direction of slip.

    dt/ds = -t mu/R,   du/ds = g + (T1 - T) C,   t = T/T1,

with the friction that belongs to a creep u (see :mod:`wraparc.batch.lane_creep_law`). Nothing is
singular where slip passes zero, or where the friction of a measured table steps up. Equal steps, of
fourth order; derivatives by the unknown z go along.
"""

from __future__ import annotations

from wraparc.batch.elementwise import Lanes, Table, lanes, select, upper
from wraparc.batch.lane_creep_law import Cells, friction_of_creep
from wraparc.batch.lane_slots import (
    AT_T,
    AT_TZ,
    AT_U,
    AT_UZ,
    FASTEST,
    FRICTION,
    FRICTION_T,
    FRICTION_U,
    G_Z,
    KICK,
    LARGEST,
    LENGTH,
    P1,
    PEAK_NODE,
    PEAK_STRESS,
    RADIUS,
    RATIO,
    RISES_TO,
    SHEAR,
    SLIP,
    STEEPEST,
    STEP,
    SUM_T,
    SUM_TZ,
    SUM_U,
    SUM_UZ,
    T_Z,
    U_Z,
    G,
    T,
    U,
)

#: steps of the meshes: of a first search, then two, each of twice the steps of the one before it
FIRST_STEPS, MESHES = 8, (48, 128)
NOTED = 5  # numbers of a node in a trace, see `note`
LEAST_TENSION = 1e-6  # of T1: a try that is far off may ask for none at all


def set_off(w: Lanes, steps: int) -> None:
    """Begin a march of `steps` steps at the entry."""
    n = lanes()
    for i in range(n):
        zero = 0.0 * w[KICK, i]
        w[STEP, i] = w[LENGTH, i] / steps
        w[T, i] = w[AT_T, i] = zero + 1.0
        w[U, i] = w[AT_U, i] = w[KICK, i]
        w[T_Z, i] = w[U_Z, i] = w[AT_TZ, i] = w[AT_UZ, i] = zero
        w[SUM_T, i] = w[SUM_U, i] = w[SUM_TZ, i] = w[SUM_UZ, i] = zero
        w[PEAK_NODE, i] = w[PEAK_STRESS, i] = w[LARGEST, i] = zero
        w[FASTEST, i] = w[STEEPEST, i] = zero


def march(w: Lanes, laws: Table, cells: Cells, steps: int, traced: bool, trace: Lanes) -> None:
    """March to the exit, T, U and their derivatives by z; recorded, if `traced`, see `note`."""
    set_off(w, steps)
    for j in range(steps):
        for k in range(4):
            ahead, weight = (0.0, 1.0) if k == 3 else (0.5 if k < 2 else 1.0, 1.0 + min(k, 1))
            friction_of_creep(w, laws, cells)
            if traced and k == 0:
                note(w, trace, j, False)
            stage(w, ahead, weight)
        arrive(w)
    if traced:
        friction_of_creep(w, laws, cells)
        note(w, trace, steps, True)


def stage(w: Lanes, ahead: float, weight: float) -> None:
    """One stage: rates added to the sums with a weight, the state put `ahead` in the step."""
    n = lanes()
    for i in range(n):
        h, t, t_z, mu = w[STEP, i], w[AT_T, i], w[AT_TZ, i], w[FRICTION, i]
        per = -h / w[RADIUS, i]
        dt, du = per * t * mu, h * (w[G, i] + w[RATIO, i] * (1.0 - t))
        mu_z = w[FRICTION_U, i] * w[AT_UZ, i] + w[FRICTION_T, i] * t_z
        dtz, duz = per * (t_z * mu + t * mu_z), h * (w[G_Z, i] - w[RATIO, i] * t_z)
        w[SUM_T, i] = w[SUM_T, i] + weight * dt
        w[SUM_U, i] = w[SUM_U, i] + weight * du
        w[SUM_TZ, i] = w[SUM_TZ, i] + weight * dtz
        w[SUM_UZ, i] = w[SUM_UZ, i] + weight * duz
        w[AT_T, i] = upper(w[T, i] + ahead * dt, LEAST_TENSION)
        w[AT_U, i] = w[U, i] + ahead * du
        w[AT_TZ, i] = w[T_Z, i] + ahead * dtz
        w[AT_UZ, i] = w[U_Z, i] + ahead * duz


def arrive(w: Lanes) -> None:
    """End a step."""
    n = lanes()
    for i in range(n):
        zero, part = 0.0 * w[KICK, i], 1.0 / 6.0
        w[T, i] = w[AT_T, i] = upper(w[T, i] + part * w[SUM_T, i], LEAST_TENSION)
        w[U, i] = w[AT_U, i] = w[U, i] + part * w[SUM_U, i]
        w[T_Z, i] = w[AT_TZ, i] = w[T_Z, i] + part * w[SUM_TZ, i]
        w[U_Z, i] = w[AT_UZ, i] = w[U_Z, i] + part * w[SUM_UZ, i]
        w[SUM_T, i] = w[SUM_U, i] = w[SUM_TZ, i] = w[SUM_UZ, i] = zero


def note(w: Lanes, trace: Lanes, place: int, last: bool) -> None:
    """Record a node: t and u, their changes by step, and slip; look at stress and slip there.

    PEAK_STRESS and LARGEST are the largest stress and slip before the exit, PEAK_NODE where that
    stress is, FASTEST the largest change of slip along the arc, STEEPEST the largest slip over that
    up to which friction rises.
    """
    n = lanes()
    o, at = NOTED * place, float(place)
    before = 0.0 if last else 1.0
    for i in range(n):
        t, u, mu = w[T, i], w[U, i], w[FRICTION, i]
        sign, h = select(u < 0.0, -1.0, 1.0), w[STEP, i]
        dt, du = -h * t * mu / w[RADIUS, i], h * (w[G, i] + w[RATIO, i] * (1.0 - t))
        stress = w[P1, i] * t * mu * sign * before
        growth = sign * w[P1, i] * (dt * mu + t * (w[FRICTION_U, i] * du + w[FRICTION_T, i] * dt))
        trace[o, i], trace[o + 1, i], trace[o + 2, i], trace[o + 3, i] = t, dt, u, du
        trace[o + 4, i] = w[SLIP, i]
        w[PEAK_NODE, i] = select(stress > w[PEAK_STRESS, i], at, w[PEAK_NODE, i])
        w[PEAK_STRESS, i] = upper(w[PEAK_STRESS, i], stress)
        w[LARGEST, i] = upper(w[LARGEST, i], w[SLIP, i] * before)
        w[STEEPEST, i] = upper(w[STEEPEST, i], w[SLIP, i] / w[RISES_TO, i])
        change = (sign * du - w[SHEAR, i] * growth) / h
        w[FASTEST, i] = upper(w[FASTEST, i], upper(change, -change))
