"""Friction that a rig shows at a given travel, for one integral-log curve, with derivatives.

Travel u since the lash was taken up holds the slip z and the shear of the sample and rig,
u = z + K mu(z), with K = (h/G) p + c n F_n: the travel that friction 1 would bend away.
"""

from dataclasses import dataclass, fields

import numpy as np

from wraparc.arrays import Array

_NEWTON = 12
PARAMETERS = (
    "ln_peak_slip",
    "ln_peak_friction",
    "lash",
    "post_peak_slope",
    "residual_friction",
    "zero",
)


@dataclass(frozen=True)
class CurveParameters:
    """One friction curve, mu/mu_pk = r (1 - ln r) with r = x/x_pk, then a line to a level.

    Parameters
    ----------
    ln_peak_slip
        Natural logarithm of x_pk in metres.
    ln_peak_friction
        Natural logarithm of mu_pk.
    lash
        Travel before the slip starts; negative if the record starts after it [m].
    post_peak_slope
        Slope past the peak, <= 0 [1/m].
    residual_friction
        Level that the line does not fall below [-].
    zero
        Friction shown where there is none, an error of the force's zero [-].
    """

    ln_peak_slip: float
    ln_peak_friction: float
    lash: float = 0.0
    post_peak_slope: float = 0.0
    residual_friction: float = 0.0
    zero: float = 0.0

    @property
    def peak_slip(self) -> float:
        """x_pk [m]."""
        return float(np.exp(self.ln_peak_slip))

    @property
    def peak_friction(self) -> float:
        """mu_pk [-]."""
        return float(np.exp(self.ln_peak_friction))

    def vector(self) -> Array:
        """Return the parameters in the order of `PARAMETERS`."""
        return np.array([getattr(self, f.name) for f in fields(self)])


def friction_and_slope(slip: Array, q: CurveParameters) -> tuple[Array, Array]:
    """Friction [-] and its slope [1/m] at `slip` >= 0 [m]; 0 below."""
    x_pk, mu_pk = q.peak_slip, q.peak_friction
    r = np.maximum(slip, 1e-12) / x_pk
    logarithm = np.log(r)
    line = mu_pk + q.post_peak_slope * (slip - x_pk)
    level = min(q.residual_friction, mu_pk)
    rising = r <= 1.0
    friction = np.where(rising, mu_pk * r * (1.0 - logarithm), np.maximum(line, level))
    slope = np.where(
        rising, -mu_pk / x_pk * logarithm, np.where(line > level, q.post_peak_slope, 0.0)
    )
    on = slip > 0.0
    return np.where(on, friction, 0.0), np.where(on, slope, 0.0)


def slip_at(travel: Array, bending: float, q: CurveParameters) -> Array:
    """Slip z at machine travel, from travel - lash = z + bending mu(z) [m].

    Newton from the left of the root, where the concave left side cannot overshoot.

    Parameters
    ----------
    travel
        Machine travel [m].
    bending
        K, travel bent away at friction 1 [m].
    q
        The curve.
    """
    u = np.maximum(travel - q.lash, 0.0)
    if bending == 0.0:
        return u
    z = np.maximum(u - bending * friction_and_slope(u, q)[0], 1e-3 * u)
    for _ in range(_NEWTON):
        friction, slope = friction_and_slope(z, q)
        step = (u - z - bending * friction) / np.maximum(1.0 + bending * slope, 0.05)
        z = np.clip(z + step, 0.0, u)
        if np.abs(step).max(initial=0.0) < 1e-10:
            break
    return z


def friction_and_jacobian(travel: Array, bending: float, q: CurveParameters) -> tuple[Array, Array]:
    """Friction at machine travel and its derivatives by `PARAMETERS`.

    Implicit differentiation of u = z + K mu(z; q): d mu = mu_q dq / (1 + K mu_z) and
    d mu/d lash = -mu_z / (1 + K mu_z).

    Returns
    -------
    friction
        Shape (n,).
    jacobian
        Shape (n, 6).
    """
    z = slip_at(travel, bending, q)
    friction, slope = friction_and_slope(z, q)
    on = z > 0.0
    rising = on & (z <= q.peak_slip)
    line = q.peak_friction + q.post_peak_slope * (z - q.peak_slip)
    level = min(q.residual_friction, q.peak_friction)
    falling = on & ~rising & (line > level)
    flat = on & ~rising & ~falling
    jacobian = np.zeros((len(travel), 6))
    # By ln x_pk: mu_pk r (1 - ln r) scales with r, so the derivative is -z mu_z.
    jacobian[:, 0] = np.where(rising, -z * slope, 0.0)
    jacobian[falling, 0] = -q.post_peak_slope * q.peak_slip
    jacobian[:, 1] = np.where(rising, friction, np.where(falling, q.peak_friction, 0.0))
    if q.residual_friction >= q.peak_friction:
        jacobian[flat, 1] = q.peak_friction
    else:
        jacobian[flat, 4] = 1.0
    jacobian[falling, 3] = z[falling] - q.peak_slip
    jacobian[:, 2] = -slope
    jacobian /= (1.0 + bending * slope)[:, None]
    jacobian[:, 5] = 1.0
    return friction + q.zero, jacobian
