"""The one unknown of an arc: how far the whole belt creeps.

The unknown is carried as an *effort* z that grows with creep towards the slack side. For laws that
rise from zero it is the logarithm of the entry creep ratio (with a kick, where the ratio may have
either sign, its inverse hyperbolic sine). For laws that start with a jump it is -1 .. 0 while the
belt sticks over the whole wrap, in proportion to its creep at the exit, and sets the length of the
stuck zone above that; where that vanishes (no shear of the lagging), the entry creep ratio.
"""

from __future__ import annotations

from math import asinh, exp, log, sinh, sqrt

from wraparc.arc.kernel.march import stress_and_creep, sweep
from wraparc.arc.kernel.quantities import Parameters, Shot, Sliding
from wraparc.arc.kernel.stick import (
    onset_stress,
    stick_slip,
    zone_creep_ratio,
    zone_end,
    zone_point,
)
from wraparc.arc.quantities import jumps
from wraparc.friction.compact import (
    LIMIT,
    TABLE,
    CompactLaw,
    friction_at,
    peak,
    segment_of,
)

# what is aimed at
TENSION = 0  # ln(tight / slack)
CREEP = 1  # creep at the exit towards the slack side [m]
SLIP = 2  # slip at the exit towards the slack side [m]

#: entry creep ratio where the scale of z turns from logarithmic to linear
SMALL_RATIO = 1e-7
LARGEST_RATIO = 1.0
MOST_LAGS = 100.0  # that a mesh resolves: beyond, layers solve what is not gross slip
#: shear-lag lengths beyond which an arc is solved by its layers: fabric and steel cord on rubber
#: have up to 12
FAR = 13.0
LAGS_PER_MESH = 2.0  # shear-lag lengths that the given number of mesh steps resolves, fitted
#: creep over the arc that a unit of effort stands for once a rest arc has vanished [m]; the creep
#: limit of the paper, decides speed only
CREEP_SCALE = 6.35e-3


def ratio_of(par: Parameters, z: float) -> float:
    """Entry creep ratio of an effort, laws without a jump [-]."""
    if par.kick != 0.0:
        return par.side * SMALL_RATIO * sinh(z)
    return par.side * SMALL_RATIO * exp(z)


def effort_of(par: Parameters, g: float) -> float:
    """Effort of an entry creep ratio, laws without a jump; the inverse of :func:`ratio_of`."""
    r = par.side * g / SMALL_RATIO
    if par.kick != 0.0:
        return asinh(r)
    return log(r) if r > 0.0 else -60.0


def largest_effort(law: CompactLaw, par: Parameters) -> float:
    """Effort at which the entry creep ratio is 1."""
    if not jumps(law):
        return effort_of(par, par.side * LARGEST_RATIO)
    compliance = par.shear + par.onset
    if compliance == 0.0:
        return 1.0 + LARGEST_RATIO * par.length / CREEP_SCALE
    u = compliance * onset_stress(law, par.entry_pressure)[0]
    return max(par.length / u, 10.0)


def mesh_steps(law: CompactLaw, par: Parameters, steps: int) -> int:
    """Mesh steps for an arc: more where the belt hands over its tension in a short exit part."""
    return int(steps * max(1.0, min(lags(law, par), MOST_LAGS) / LAGS_PER_MESH))


def lags(law: CompactLaw, par: Parameters) -> float:
    """Shear-lag lengths in the arc [-]; 0 for a law without slip before its limit.

    Creep grows like exp(s/l) where friction is nearly proportional to slip; l follows from the
    shear of the lagging and the slip at small friction, in series.
    """
    p = par.entry_pressure
    segment = segment_of(law, p)
    if law.kind == LIMIT and law.coefficients[3] == 0.0:
        return 0.0
    if law.kind == LIMIT:
        slip, mu = law.coefficients[3], 1.0 / p
    elif law.kind == TABLE:
        mu, _, _ = friction_at(law, segment, 1, law.slips[1], p)
        slip = law.slips[1]
    else:
        slip_pk, mu_pk, _, _ = peak(law, segment, p)
        slip, mu = 0.18 * slip_pk, mu_pk
    lag = sqrt((par.shear + slip / (mu * p)) / (par.width * par.compliance))
    return par.length / lag


def shoot_from(law: CompactLaw, par: Parameters, z: float, steps: int) -> Shot:
    """March one arc to its exit at effort z."""
    zone = 0.0
    steps = mesh_steps(law, par, steps)
    if jumps(law):
        length = par.length
        compliance = par.shear + par.onset
        end = g = 0.0
        if compliance == 0.0:
            zone = length * min(max(1.0 - z, 0.0), 1.0)
            if z > 1.0:
                g = par.side * (z - 1.0) * CREEP_SCALE / length
        else:
            zone = length / (1.0 + max(z, 0.0))
            end = zone_end(law, par, zone)[1]
            if z < 0.0:
                end *= 1.0 + z
            g = zone_creep_ratio(par, zone, end)
        state = stick_slip(law, par, zone, end, g, steps)
        if zone >= length:
            creep = zone_point(par, length, length, end)[1]
            tau = creep / compliance if compliance > 0.0 else 0.0
            return Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone)
    else:
        g = ratio_of(par, z)
        state = sweep(law, par, g, steps)
    return shot_of(law, par, state, g, zone)


def shot_of(law: CompactLaw, par: Parameters, state: Sliding, g: float, zone: float) -> Shot:
    """Exit quantities of a state at the exit."""
    tau, creep = stress_and_creep(law, par, state)
    return Shot(state.log_tension, state.slip, creep, tau, state.work, g, zone)
