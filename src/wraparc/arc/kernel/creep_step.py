"""A step of a measured table where friction steps up within a few hundredths of a millimetre.

There slip all but stops while the lagging shears, and the equation of slip is stiff: every stage
of a step that continues a piece of the table beyond its cell runs away. The creep u = x + c tau
grows smoothly whatever the table, du/ds = g + (T1 - T) C, so it is the state here; the slip that
belongs to a creep is solved for at every stage.
"""

from __future__ import annotations

from math import inf, log, nan, sqrt

from wraparc.arc.kernel.butcher import (
    to_end,
    to_fifth,
    to_fourth,
    to_last,
    to_second,
    to_sixth,
    to_third,
)
from wraparc.arc.kernel.quantities import Parameters
from wraparc.arc.kernel.step import MESH_POWER, pressure_at
from wraparc.arc.kernel.table_slip import slip_under_table
from wraparc.friction.compact import (
    KNOTS,
    PIECES,
    SMALLEST,
    TABLE,
    CompactLaw,
    branch_of,
    friction_at,
    peak,
    segment_of,
)

STEEP = 0.5  # shear of the lagging over slip in a cell of a table, beyond which it is steep
CELL_PARTS = 3.0  # steps in a steep cell, the more the more of its creep is shear of the lagging


def slip_at_entry(law: CompactLaw, par: Parameters, creep: float, q: float) -> float:
    """Slip x in (0, creep] that solves x + (h/G) mu(x, p) p = creep, creep > 0 [m]."""
    p = pressure_at(par, q)
    shear = par.shear
    segment = segment_of(law, p)
    if law.kind == TABLE:
        return slip_under_table(law, segment, shear * p, p, creep, 1.0)[1]
    low, high = 0.0, creep
    x = creep
    if law.kind in (KNOTS, PIECES):
        slip_pk, mu_pk, _, _ = peak(law, segment, p)
        r = min(creep / slip_pk, 1.0)
        x = creep / (1.0 + shear * p * mu_pk / slip_pk * (1.0 - log(max(r, SMALLEST))))
    for _ in range(200):
        branch = branch_of(law, segment, x, p)
        mu, mu_x, _ = friction_at(law, segment, branch, x, p)
        f = x + shear * mu * p - creep
        if f > 0.0:
            high = x
        else:
            low = x
        dx = f / (1.0 + shear * p * mu_x)
        x_new = x - dx
        if abs(dx) <= 1e-15 * x:
            return x_new
        if not low < x_new < high:
            x_new = 0.5 * (low + high)
        if abs(x_new - x) <= 1e-15 * x:
            return x_new
        x = x_new
    return x


def creep_step(
    law: CompactLaw,
    par: Parameters,
    g: float,
    sign: float,
    q: float,
    x: float,
    span: float,
    xi: float,
    h: float,
) -> tuple[float, float, float]:
    """`wraparc.arc.kernel.step.step` with creep as the state, and the table as it is throughout."""
    f = MESH_POWER * span
    z = xi**3 * f * h
    p = pressure_at(par, q)
    segment = segment_of(law, p)
    mu, _, _ = friction_at(law, segment, branch_of(law, segment, sign * x, p), sign * x, p)
    tau = sign * mu * p
    u = x + par.shear * tau
    a1, b1, w1, n = _creep_rates(law, par, g, z, q, u, sign * x / abs(u) if u != 0.0 else 1.0)
    z3 = (xi + h / 3.0) ** 3 * f * h
    a2, b2, _, n = _creep_rates(law, par, g, z3, q + to_second(a1), u + to_second(b1), n)
    z = (xi + h * 2.0 / 3.0) ** 3 * f * h
    a3, b3, w3, n = _creep_rates(law, par, g, z, q + to_third(a2), u + to_third(b2), n)
    q4, u4 = q + to_fourth(a1, a2, a3), u + to_fourth(b1, b2, b3)
    a4, b4, w4, n = _creep_rates(law, par, g, z3, q4, u4, n)
    z = (xi + 0.5 * h) ** 3 * f * h
    q5, u5 = q + to_fifth(a1, a2, a3, a4), u + to_fifth(b1, b2, b3, b4)
    a5, b5, w5, n = _creep_rates(law, par, g, z, q5, u5, n)
    q6, u6 = q + to_sixth(a2, a3, a4, a5), u + to_sixth(b2, b3, b4, b5)
    a6, b6, w6, n = _creep_rates(law, par, g, z, q6, u6, n)
    z = (xi + h) ** 3 * f * h
    q7, u7 = q + to_last(a1, a2, a3, a4, a6), u + to_last(b1, b2, b3, b4, b6)
    a7, b7, w7, n = _creep_rates(law, par, g, z, q7, u7, n)
    q_end, u_end = q + to_end(a1, a3, a4, a5, a6, a7), u + to_end(b1, b3, b4, b5, b6, b7)
    tau_end, x_end = _stress_of_creep(law, par, q_end, u_end, n)
    # work on the creep, less what the shear of the lagging has taken up: tau dx = tau (du - c dtau)
    stored = 0.5 * par.shear * (tau_end**2 - tau**2)
    return q_end, x_end, to_end(w1, w3, w4, w5, w6, w7) - stored


def _stress_of_creep(
    law: CompactLaw, par: Parameters, q: float, u: float, share: float
) -> tuple[float, float]:
    """Shear stress [Pa] and slip [m] that belong to a creep, with a guess of slip over creep."""
    size = abs(u)
    p = pressure_at(par, q)
    mu, x = slip_under_table(law, segment_of(law, p), par.shear * p, p, size, share)
    tau = p * mu
    if size - x > 1e-6 * size:  # else the difference has lost its digits, and the law is not steep
        tau = (size - x) / par.shear
    return (tau, x) if u > 0.0 else (-tau, -x)


def _creep_rates(
    law: CompactLaw, par: Parameters, g: float, z: float, q: float, u: float, share: float
) -> tuple[float, float, float, float]:
    """Changes of q, creep u and tau du over z of the arc, and slip over creep."""
    p = pressure_at(par, q)
    tau, x = _stress_of_creep(law, par, q, u, share)
    share = x / u if u != 0.0 else 1.0
    du = (g + par.entry_tension * (1.0 - p / par.entry_pressure) * par.compliance) * z
    return -tau / (p * par.radius) * z, du, tau * du, share


def cell_step(
    law: CompactLaw,
    par: Parameters,
    g: float,
    segment: int,
    branch: int,
    sign: float,
    q: float,
    x: float,
) -> float:
    """Longest step in a steep cell of a measured table [m], nan where the cell is not steep."""
    if branch >= len(law.slips) - 1:
        return nan
    low, high = law.slips[branch], law.slips[branch + 1]
    p = pressure_at(par, q)
    change = friction_at(law, segment, branch, high, p)[0]
    change -= friction_at(law, segment, branch, low, p)[0]
    shear = par.shear * p * abs(change) / (high - low)
    if shear < STEEP:
        return nan
    first = low + par.shear * p * friction_at(law, segment, branch, low, p)[0]
    last = high + par.shear * p * friction_at(law, segment, branch, high, p)[0]
    here = sign * x + par.shear * p * friction_at(law, segment, branch, sign * x, p)[0]
    rate = sign * (g + par.entry_tension * (1.0 - p / par.entry_pressure) * par.compliance)
    if rate == 0.0:
        return inf
    part = abs(last - first) / (1.0 + CELL_PARTS * min(shear, 6.0))
    left = last - here if rate > 0.0 else here - first
    return min(part, max(1.02 * left, 0.0) + 0.01 * part) / abs(rate)


def cell_lag(
    law: CompactLaw,
    par: Parameters,
    segment: int,
    branch: int,
    q: float,
    slip: float,
    friction: float,
) -> float:
    """Shear-lag length sqrt(dx / (dmu p B C)) of what is ahead in a cell of a table [m]."""
    ahead = law.slips[branch + 1] - slip
    if ahead <= 0.0:
        return inf
    p = pressure_at(par, q)
    change = friction_at(law, segment, branch, law.slips[branch + 1], p)[0] - friction
    stiffness = abs(change) * p * par.width * par.compliance
    return sqrt(ahead / stiffness) if stiffness > 0.0 else inf
