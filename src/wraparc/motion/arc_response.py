"""Small vibrations of one arc about its steady state: an initial-value problem along the profile.

With T_in and the creep ratio at the nip vibrating like e^(lambda t),

    dT/ds = -B (K u + P T),   dW/ds = a T,
    u = x_c' T_in e^(-lambda s/V) + c_hat (V/lambda)(1 - e^(-lambda s/V)) - W,

K and P the slopes of the shear stress by creep and tension at fixed history. V is the speed of the
surface here; what is answered is per unit of V c_hat at the tension member, and W along it. The
centrifugal force of the belt is held: what its speed vibrates by is far less than its creep.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from wraparc.arc import ArcResult
from wraparc.arrays import Array, Complex
from wraparc.friction.compact import LIMIT
from wraparc.friction.memory import Lagging, Past

_STEPS = 60  # of the initial-value problem; the profile has twice as many


@dataclass(frozen=True, eq=False)
class SteadyProfile:
    """The slopes along a wrap in its steady state, at 2 n + 1 places s = L xi^3.

    Attributes
    ----------
    length, width, give
        L [m], B [m], a = 1/EA' [1/N].
    speed, share
        V of the tension member over the loaded surface at the entry nip [m/s]; R/(R + e), how far
        the surface travels over it [-].
    overrun_slope
        x_c', of the overrun by entry tension [m/N].
    places
        xi, evenly from 0 to 1 [-].
    by_creep, by_tension
        K [Pa/m] and P [1/m2].
    tension, creep
        Steady T [N] and u [m].
    """

    length: float
    width: float
    give: float
    speed: float
    share: float
    overrun_slope: float
    places: Array
    by_creep: Array
    by_tension: Array
    tension: Array
    creep: Array

    @classmethod
    def of(cls, result: ArcResult, speed: float, steps: int = _STEPS) -> SteadyProfile:
        """Return the profile of a solved arc whose surface moves at a speed [m/s]."""
        arc, lagging = result.arc, Lagging(result.arc.law.compact(), result.arc.shear_compliance)
        g, entry, give = result.entry_creep_ratio, result.entry_tension, arc.compliance
        per, b = 2.0 / (arc.width * arc.diameter), arc.geometry().width
        count = 2 * steps
        xi = np.linspace(0.0, 1.0, count + 1)
        t, u = entry, arc.entry_overrun
        rows = []

        def state(t: float, u: float) -> tuple[float, float, float]:
            return _stress(lagging, max(t - arc.centrifugal, 1.0) * per, u)

        def slopes(x: float, t: float, u: float) -> tuple[float, float]:
            ds = 3.0 * arc.length * x * x
            return -b * state(t, u)[0] * ds, (g + give * (entry - t)) * ds

        for j in range(count + 1):
            _, by_u, by_p = state(t, u)
            rows.append((t, u, by_u, by_p * per))
            if j == count:
                break
            h, x = xi[j + 1] - xi[j], xi[j]
            k1 = slopes(x, t, u)
            k2 = slopes(x + 0.5 * h, t + 0.5 * h * k1[0], u + 0.5 * h * k1[1])
            k3 = slopes(x + 0.5 * h, t + 0.5 * h * k2[0], u + 0.5 * h * k2[1])
            k4 = slopes(x + h, t + h * k3[0], u + h * k3[1])
            t += h / 6.0 * (k1[0] + 2.0 * k2[0] + 2.0 * k3[0] + k4[0])
            u += h / 6.0 * (k1[1] + 2.0 * k2[1] + 2.0 * k3[1] + k4[1])
        table = np.array(rows)
        coefficient = arc.geometry().overrun_coefficient
        return cls(
            length=arc.length,
            width=b,
            give=give,
            speed=speed,
            share=arc.radius / (arc.radius + arc.offset),
            overrun_slope=1.5 * coefficient * arc.entry_pressure**0.5 * per,
            places=xi,
            by_creep=table[:, 2],
            by_tension=table[:, 3],
            tension=table[:, 0],
            creep=table[:, 1],
        )

    @property
    def transit(self) -> float:
        """Time that a piece of lagging takes from nip to nip [s]."""
        return self.length / (self.share * self.speed)

    def response(self, lam: Complex) -> ArcResponse:
        """How the arc answers to vibrations e^(lam t), lam != 0, shape (n,) [1/s]."""
        lam = np.asarray(lam, dtype=complex)
        n, v, a = len(lam), self.share * self.speed, self.give
        xi, h = self.places, self.places[2] - self.places[0]
        s = self.length * xi**3
        ds = 3.0 * self.length * xi**2
        # K may be infinite where slip begins; it is weighted by a vanishing length there
        stiff = np.where(np.isfinite(self.by_creep), self.by_creep, 0.0)
        slopes_u, slopes_t = -self.width * stiff * ds, -self.width * self.by_tension * ds
        # per unit T_in, and per unit V c_hat
        t = np.stack([np.ones(n, complex), np.zeros(n, complex)])
        w = np.zeros((2, n), complex)

        def told(j: int) -> Complex:
            """The part of u that does not come from W."""
            wave = np.exp(-lam * (s[j] / v))
            slid = -np.expm1(-lam * (s[j] / v)) / lam
            return np.stack([self.overrun_slope * wave, self.share * slid])

        before = told(0)
        for j in range(0, len(xi) - 2, 2):
            middle, after = told(j + 1), told(j + 2)

            def rate(i: int, given: Complex, t: Complex, w: Complex) -> tuple[Complex, Complex]:
                return slopes_u[i] * (given - w) + slopes_t[i] * t, (a * ds[i]) * t

            t1, w1 = rate(j, before, t, w)
            t2, w2 = rate(j + 1, middle, t + 0.5 * h * t1, w + 0.5 * h * w1)
            t3, w3 = rate(j + 1, middle, t + 0.5 * h * t2, w + 0.5 * h * w2)
            t4, w4 = rate(j + 2, after, t + h * t3, w + h * w3)
            t = t + h / 6.0 * (t1 + 2.0 * t2 + 2.0 * t3 + t4)
            w = w + h / 6.0 * (w1 + 2.0 * w2 + 2.0 * w3 + w4)
            before = after
        u, w = before - w, w / self.share
        return ArcResponse(lam, t[0], t[1], w[0], w[1], u[0], u[1])


@dataclass(frozen=True, eq=False)
class ArcResponse:
    """What a vibrating arc answers per unit of T_in and of V c_hat, at every lam; shape (n,).

    Attributes
    ----------
    lam
        Laplace variable [1/s].
    out_by_in, out_by_slip
        T_out [-, N s/m].
    wrapped_by_in, wrapped_by_slip
        W [m/N, s].
    creep_by_in, creep_by_slip
        Exit creep [m/N, s].
    """

    lam: Complex
    out_by_in: Complex
    out_by_slip: Complex
    wrapped_by_in: Complex
    wrapped_by_slip: Complex
    creep_by_in: Complex
    creep_by_slip: Complex

    @property
    def entry_impedance(self) -> Complex:
        """Z_2 = T_in/(V c_hat) with T_out held [N s/m]."""
        return np.asarray(-self.out_by_slip / self.out_by_in)

    @property
    def exit_impedance(self) -> Complex:
        """Z_1 = -T_out/(V c_hat - lam W) with T_in held [N s/m]."""
        return np.asarray(-self.out_by_slip / (1.0 - self.lam * self.wrapped_by_slip))


def _stress(lagging: Lagging, pressure: float, u: float) -> tuple[float, float, float]:
    """Shear stress and its slopes by creep and pressure in a steady state."""
    creep, one = np.array([u]), np.ones(1)
    at, side = np.array([pressure]), np.where(creep >= 0.0, 1.0, -1.0)
    if lagging.law.kind == LIMIT:
        none = 0.0 * one
        past = Past(none[:, None], none.astype(np.int64), none, none, none, none, one)
        found = lagging.stuck_or_sliding(creep, at, past)
    else:
        found = lagging.virgin(creep, at, side, np.abs(creep), 1.0)
    return float(found.stress[0]), float(found.by_creep[0]), float(found.by_pressure[0])
