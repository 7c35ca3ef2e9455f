"""The arc of a belt with thickness, cover and mass, integrated from moments about the drum.

Written for the angle theta: p = (T - m v^2)/(B R), d ln(T - m v^2)/d theta = -(tau/p) R/(R + e)
and u = x + (h/G + h_b/G_b) tau, without the arc of a thin belt that the solver makes of it.
"""

from __future__ import annotations

from math import exp, log
from typing import Any, NamedTuple

from scipy.integrate import ode

from arc.twin import Twin
from wraparc.arc import WrapArc


class Ends(NamedTuple):
    """What the integration comes to: at the exit, and the work of friction against the shell."""

    entry_ratio: float
    creep: float  # [m]
    slip: float  # [m]
    work: float  # int tau du [J/m2]


class ThickTwin(Twin):
    """One arc, integrated at a given entry creep ratio."""

    def __init__(self, arc: WrapArc) -> None:
        self.lift, self.e = arc.centrifugal, arc.pitch_offset or 0.0
        super().__init__(arc)
        self.shear += arc.cover_compliance

    def pressure(self, tension: float) -> float:
        return (tension - self.lift) / (self.arc.width * self.arc.diameter / 2)

    def ends(self, g: float) -> tuple[float, Ends]:
        """ln of tension ratio above m v^2, and the rest, at an entry creep ratio."""
        arc, first = self.arc, self.arc.entry_tension - self.lift
        ratio = self.radius / (self.radius + self.e)

        def rates(xi: float, y: Any) -> list[float]:
            d_theta = 4 * arc.wrap_angle * xi**3
            tension = first * exp(y[0]) + self.lift
            p = self.pressure(tension)
            tau = self.stress(y[1], p)[0]
            du = self.radius * (g + (arc.entry_tension - tension) * self.compliance)
            return [-tau / p * ratio * d_theta, du * d_theta, tau * du * d_theta]

        scheme = ode(rates)
        scheme.set_integrator("dop853", rtol=1e-12, atol=1e-17, nsteps=200000, max_step=0.05)
        scheme.set_initial_value([0.0, self.overrun_constant, 0.0], 0.0)
        q, u, work = (float(v) for v in scheme.integrate(1.0))
        assert scheme.successful()
        slip = self.stress(u, self.pressure(first * exp(q) + self.lift))[1]
        return q, Ends(g, u, slip, work)

    def solve(self, g: float) -> Ends:
        """Ends that meet the exit tension, by secants from an entry creep ratio near theirs."""
        goal = log((self.arc.exit_tension - self.lift) / (self.arc.entry_tension - self.lift))
        step = 1e-6 * (abs(g) + 1e-5)
        points = [(g, *self.ends(g)), (g + step, *self.ends(g + step))]
        for _ in range(6):
            (g0, q0, _), (g1, q1, found) = points[-2:]
            if abs(q1 - goal) <= 1e-12 * abs(goal) or q1 == q0:
                return found
            new = g1 + (goal - q1) * (g1 - g0) / (q1 - q0)
            points.append((new, *self.ends(new)))
        return points[-1][2]
