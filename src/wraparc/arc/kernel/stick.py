"""The zone at the entry nip where the belt sticks to the lagging, for laws that start with a jump.

A law with friction at zero slip (constant, power of pressure, a table that starts above zero) holds
the belt until the shear of the lagging alone asks for more than it can carry. There tau = u / c_e,
with c_e = h/G (plus 1/kappa_s of an elastic-plastic law), and the equations are linear:

    u'' = u / l^2,   l = sqrt(c_e EA' / B),
    u(s) = x_c e^(-s/l) + a sinh(s/l),
    T1 - T(s) = (EA'/l) [x_c (1 - e^(-s/l)) + a (cosh(s/l) - 1)].

The zone is described by its length s_j and the creep u_j at its end, not by g: for a long wrap g is
as small as e^(-L/l) and may underflow while the zone stays well defined. With c_e = 0 the zone is
the classical rest arc: no creep, T = T1.
"""

from __future__ import annotations

from math import exp, expm1, log, sqrt, tanh

from wraparc.arc.kernel.march import carry_to_exit
from wraparc.arc.kernel.quantities import Parameters, Sliding
from wraparc.friction.compact import (
    LIMIT,
    PLASTIC,
    CompactLaw,
    branch_of,
    friction_at,
    segment_of,
)


def onset_stress(law: CompactLaw, pressure: float) -> tuple[float, float]:
    """Shear stress a law holds without slip [Pa] and its derivative by pressure [-]."""
    segment = segment_of(law, pressure)
    branch = PLASTIC if law.kind == LIMIT else 0
    mu, _, mu_p = friction_at(law, segment, branch, 0.0, pressure)
    return mu * pressure, mu + pressure * mu_p


def shear_lag_length(par: Parameters) -> float:
    """Length l = sqrt(c_e EA' / B), over which a stuck belt hands over its tension [m]."""
    return sqrt((par.shear + par.onset) / (par.width * par.compliance))


def zone_end(law: CompactLaw, par: Parameters, length: float) -> tuple[float, float]:
    """Tension [N] and creep [m] at the end of a stuck zone of a given length, where slip begins."""
    compliance = par.shear + par.onset
    if compliance == 0.0:
        return par.entry_tension, 0.0
    lag = shear_lag_length(par)
    e, rise = exp(-length / lag), -expm1(-length / lag)
    half = tanh(0.5 * length / lag)
    ease = lag * par.compliance
    area = par.width * par.radius
    low, high = 0.0, par.entry_tension * 1e6
    t = par.entry_tension
    for _ in range(200):
        tau, tau_p = onset_stress(law, t / area)
        u = par.side * compliance * tau
        f = t - par.entry_tension + (par.kick * rise + (u - par.kick * e) * half) / ease
        if f > 0.0:
            high = t
        else:
            low = t
        slope = 1.0 + par.side * compliance * tau_p / area * half / ease
        new = t - f / slope if slope > 0.0 else 0.5 * (low + high)
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - t) <= 1e-15 * par.entry_tension:
            t = new
            break
        t = new
    return t, par.side * compliance * onset_stress(law, t / area)[0]


def zone_point(par: Parameters, s: float, length: float, end_creep: float) -> tuple[float, float]:
    """Tension [N] and creep [m] at s inside a stuck zone of a given length and end creep."""
    if par.shear + par.onset == 0.0:
        return par.entry_tension, 0.0
    lag = shear_lag_length(par)
    e, e_end = exp(-s / lag), exp(-length / lag)
    # a sinh(s/l) and a (cosh(s/l) - 1), written so that nothing overflows or cancels
    scale = (end_creep - par.kick * e_end) * exp((s - length) / lag) / -expm1(-2.0 * length / lag)
    rise = -expm1(-s / lag)
    creep = par.kick * e + scale * -expm1(-2.0 * s / lag)
    pull = par.kick * rise + scale * rise * rise
    # a trial far off the solution may ask for more than all of the tension
    return max(par.entry_tension - pull / (lag * par.compliance), 1e-6 * par.entry_tension), creep


def zone_creep_ratio(par: Parameters, length: float, end_creep: float) -> float:
    """Entry creep ratio g = (a - x_c) / l of a stuck zone [-]; may underflow to 0."""
    if par.shear + par.onset == 0.0:
        return 0.0
    lag = shear_lag_length(par)
    e = exp(-length / lag)
    a = 2.0 * (end_creep - par.kick * e) * e / -expm1(-2.0 * length / lag)
    return (a - par.kick) / lag


def stick_slip(
    law: CompactLaw,
    par: Parameters,
    zone: float,
    end_creep: float,
    g: float,
    steps: int,
) -> Sliding:
    """A stuck zone of length `zone`, then sliding to the exit with entry creep ratio g.

    A zone as long as the wrap is stuck throughout.
    """
    length = par.length
    compliance = par.shear + par.onset
    tension, creep = (
        zone_point(par, zone, zone, end_creep) if zone > 0.0 else (par.entry_tension, 0.0)
    )
    q = log(tension / par.entry_tension)
    tau = creep / compliance if compliance > 0.0 else 0.0
    entry_tau = par.kick / compliance if compliance > 0.0 else 0.0
    x = par.onset * tau
    work = 0.5 * par.onset * (tau * tau - entry_tau * entry_tau)
    p = par.entry_pressure * exp(q)
    segment = segment_of(law, p)
    branch = branch_of(law, segment, abs(x), p)
    state = Sliding(q, x, work, segment, branch, par.side)
    if zone >= length:
        return state
    return carry_to_exit(law, par, g, state, length - zone, 0, steps)
