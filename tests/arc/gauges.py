"""What instruments on a drive would read: the slow twin's arc, moments and the mass of the belt.

Torque by moments about the axis of the drum. Speeds from the mass of belt that passes in a second,
which is the same before, on and behind the drum: a length of belt of the mass 1 is as long as its
tension stretches it, 1 + T/EA, whatever the lagging under it did meanwhile. Nothing of this is
taken from `wraparc`: the arc is a description only.
"""

from __future__ import annotations

from math import log
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from arc.thick_twin import ThickTwin
from wraparc.arc import WrapArc


class Gauges(NamedTuple):
    """Readings of a drum that turns at 1 rad/s."""

    torque: float  # on the shaft [N m]
    surface_speed: float  # omega R, R over the unloaded lagging [m/s]
    before: float  # speed of the belt that comes [m/s]
    behind: float  # of the belt that leaves [m/s]
    creep: float  # against the shell, at the exit nip [m]
    entry_ratio: float  # g [-]


def entry_ratio(arc: WrapArc) -> float:
    """Entry creep ratio that leaves the exit tension, bracketed from none on [-]."""
    twin = ThickTwin(arc)
    goal = log((arc.exit_tension - twin.lift) / (arc.entry_tension - twin.lift))

    def excess(g: float) -> float:
        return twin.ends(g)[0] - goal

    inner, left = 0.0, excess(0.0)
    step = 5e-4 if left > 0.0 else -5e-4
    while (excess(inner + step) > 0.0) is (left > 0.0):
        inner, step = inner + step, 2.0 * step
        assert abs(step) < 0.5, "friction cannot transmit this"
    low, high = min(inner, inner + step), max(inner, inner + step)
    return float(brentq(excess, low, high, xtol=1e-15, rtol=1e-13))


def gauges(arc: WrapArc) -> Gauges:
    """Return what instruments read of a drum that turns at 1 rad/s."""
    twin, g = ThickTwin(arc), entry_ratio(arc)
    pressed = twin.pressure(arc.entry_tension) * arc.thickness / arc.compression_modulus
    lever = twin.radius - pressed + twin.e
    before = lever * (1.0 - g)
    mass = before / (1.0 + arc.entry_tension / arc.axial_stiffness)  # of the belt, over its own
    return Gauges(
        torque=(arc.entry_tension - arc.exit_tension) * lever,
        surface_speed=twin.radius,
        before=before,
        behind=mass * (1.0 + arc.exit_tension / arc.axial_stiffness),
        creep=twin.ends(g)[1].creep,
        entry_ratio=g,
    )


class Courses(NamedTuple):
    """What sensors in the shell would read on the wrap."""

    position: np.ndarray  # from the entry nip [rad]
    creep: np.ndarray  # [m]
    shear_angle: np.ndarray  # of the lagging [rad]


def courses(arc: WrapArc, count: int) -> Courses:
    """Return creep and shear angle at places that are evenly spaced on the wrap."""
    twin, g = ThickTwin(arc), entry_ratio(arc)
    first, ratio = arc.entry_tension - twin.lift, twin.radius / (twin.radius + twin.e)

    def state(y: np.ndarray) -> tuple[float, float, float]:
        tension = first * np.exp(y[0]) + twin.lift
        p = twin.pressure(tension)
        return tension, p, twin.stress(float(y[1]), p)[0]

    def rates(xi: float, y: np.ndarray) -> list[float]:
        d_theta = 4.0 * arc.wrap_angle * xi**3
        tension, p, tau = state(y)
        du = twin.radius * (g + (arc.entry_tension - tension) * twin.compliance)
        return [-tau / p * ratio * d_theta, du * d_theta]

    position = np.linspace(0.0, arc.wrap_angle, count)
    at = (position / arc.wrap_angle) ** 0.25
    ran = solve_ivp(
        rates, (0.0, 1.0), [0.0, twin.overrun_constant], "DOP853", at, rtol=1e-9, atol=1e-13
    )
    stress = np.array([state(y)[2] for y in ran.y.T])
    return Courses(position, ran.y[1], np.arctan(stress / arc.shear_modulus))
