"""One step of a march in position: the equations, and a sixth-order step of them.

Sliding: q = ln(T / T1), the logarithm of tension, and x, the slip (sections "The equations"
and "The numerical method" of the documentation). With p = p1 e^q and tau = mu(|x|, p) p sign(x):

    dq/ds = -tau / (p R)
    dx/ds = (g + (T1 - T) C + c (mu + p mu_p) mu p / R) / (1 + c p mu_x)

C = 1/EA', c = h/G. Steps are sixth order (J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179-194,
7 stages) on the mesh s = L xi^4, which resolves the logarithmic slope of the law at x = 0.
"""

from __future__ import annotations

from math import exp, expm1

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
from wraparc.friction.compact import CompactLaw, friction_at

MESH_POWER = 4
LARGEST_LOG = 50.0  # of T/T1: a trial stage far off the solution may ask for more


def pressure_at(par: Parameters, q: float) -> float:
    """Wrap pressure [Pa] at ln(T/T1); a trial far off the solution may ask for any."""
    return par.entry_pressure * exp(min(max(q, -LARGEST_LOG), LARGEST_LOG))


def rates(
    law: CompactLaw,
    par: Parameters,
    g: float,
    segment: int,
    branch: int,
    sign: float,
    q: float,
    x: float,
) -> tuple[float, float, float]:
    """dq/ds [1/m], dx/ds [-] and d(friction work)/ds = tau dx/ds [N/m2] of one piece of the law."""
    radius, shear = par.radius, par.shear
    if abs(q) < 0.1:  # tension lost, in T1: the difference would lose its digits
        lost = -expm1(q)
        e = 1.0 - lost
    else:
        e = exp(min(max(q, -LARGEST_LOG), LARGEST_LOG))
        lost = 1.0 - e
    p = par.entry_pressure * e
    mu, mu_x, mu_p = friction_at(law, segment, branch, x * sign, p)
    dq = -mu / radius
    dx = g + par.entry_tension * lost * par.compliance
    if shear > 0.0:
        sp = shear * p
        dx = (dx + sp * (mu + p * mu_p) * mu / radius) / (1.0 + sp * mu_x)
    return sign * dq, dx, sign * mu * p * dx


def step(
    law: CompactLaw,
    par: Parameters,
    g: float,
    segment: int,
    branch: int,
    sign: float,
    q: float,
    x: float,
    span: float,
    xi: float,
    h: float,
    k1: tuple[float, float, float],
) -> tuple[float, float, float]:
    """One step of length h in xi with the rates k1 at its start: q, x and friction work done."""
    # ds in h at the five places of the stages
    f = MESH_POWER * span
    z = xi * xi * xi * f * h
    a1, b1, w1 = k1[0] * z, k1[1] * z, k1[2] * z
    t = xi + h / 3.0
    z3 = t * t * t * f * h
    r = rates(law, par, g, segment, branch, sign, q + to_second(a1), x + to_second(b1))
    a2, b2 = r[0] * z3, r[1] * z3
    t = xi + h * 2.0 / 3.0
    z = t * t * t * f * h
    r = rates(law, par, g, segment, branch, sign, q + to_third(a2), x + to_third(b2))
    a3, b3, w3 = r[0] * z, r[1] * z, r[2] * z
    q4, x4 = q + to_fourth(a1, a2, a3), x + to_fourth(b1, b2, b3)
    r = rates(law, par, g, segment, branch, sign, q4, x4)
    a4, b4, w4 = r[0] * z3, r[1] * z3, r[2] * z3
    t = xi + 0.5 * h
    z = t * t * t * f * h
    q5, x5 = q + to_fifth(a1, a2, a3, a4), x + to_fifth(b1, b2, b3, b4)
    r = rates(law, par, g, segment, branch, sign, q5, x5)
    a5, b5, w5 = r[0] * z, r[1] * z, r[2] * z
    q6, x6 = q + to_sixth(a2, a3, a4, a5), x + to_sixth(b2, b3, b4, b5)
    r = rates(law, par, g, segment, branch, sign, q6, x6)
    a6, b6, w6 = r[0] * z, r[1] * z, r[2] * z
    t = xi + h
    z = t * t * t * f * h
    q7, x7 = q + to_last(a1, a2, a3, a4, a6), x + to_last(b1, b2, b3, b4, b6)
    r = rates(law, par, g, segment, branch, sign, q7, x7)
    a7, b7, w7 = r[0] * z, r[1] * z, r[2] * z
    return (
        q + to_end(a1, a3, a4, a5, a6, a7),
        x + to_end(b1, b3, b4, b5, b6, b7),
        to_end(w1, w3, w4, w5, w6, w7),
    )


def hermite(f: float, h: float, a: float, da: float, b: float, db: float) -> float:
    """Cubic through a and b with slopes da and db over h, at the fraction f."""
    e = 1.0 - f
    return e * e * ((1.0 + 2.0 * f) * a + f * h * da) + f * f * ((3.0 - 2.0 * f) * b - e * h * db)
