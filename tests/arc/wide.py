"""Random drives over all that the readers accept, and an independent judgement of their solutions.

Cast over thousands by benchmarks/wide_net.py.

A solution is held against the equations themselves, not against another search: between the points
of its profile the twin of tests/arc/twin.py (creep as the state, laws written out again) integrates
from one to the next and must arrive there; the ends must have the overrun and both tensions. A
search of its own would ask the twin for numbers that no march from one end can tell apart on a long
arc.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import ode

from arc.drives import LAWS
from arc.twin import Twin
from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.batch.compiled import Compiled
from wraparc.friction import FrictionLaw, MeasuredTable

NAMES = (*LAWS, "any table")
ACCURACY = 1e-5
INTERPRETED = Distributed(capacities=False, points=400)
COMPILED = Compiled(capacities=False, points=400)


def log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(math.log(low), math.log(high))))


def any_table(rng: np.random.Generator) -> FrictionLaw:
    """A table of up to 8 slips and 4 pressures: rising, lazy at first, falling, jumping."""
    m, n = int(rng.integers(2, 9)), int(rng.integers(1, 5))
    steps = np.exp(rng.uniform(math.log(2e-5), math.log(5e-3), m - 1))
    slip = np.concatenate([[0.0], np.cumsum(steps)])
    pressure = np.cumsum(np.exp(rng.uniform(math.log(2e4), math.log(4e5), n)))
    rise, shape = np.sort(rng.uniform(0.01, 1.2, m)), int(rng.integers(4))
    if shape != 3:
        rise[0] = 0.0
    if shape == 1:
        rise[1 : m // 2] = np.linspace(1e-5, 1e-3, max(m // 2 - 1, 0))
    if shape == 2:
        rise[-1] *= 0.6
    rows = tuple(tuple((rise * (1.0 - 0.15 * k)).tolist()) for k in range(n))
    return MeasuredTable(slip=tuple(slip.tolist()), pressure=tuple(pressure.tolist()), values=rows)


def wide_arc(name: str, rng: np.random.Generator) -> WrapArc:
    """Wrap 30-720 deg, belt modulus 1e5-1e10 N/m, lagging 0.1-100 mm, ratio 1 + 1e-9 to 50.

    Raises
    ------
    InputError
        Where the reader refuses the drive.
    """
    law = any_table(rng) if name == "any table" else LAWS[name]
    diameter, width = log_uniform(rng, 0.2, 2.5), log_uniform(rng, 0.3, 3.0)
    tight = log_uniform(rng, 2e4, 1.5e6) * width * diameter / 2.0
    side = ("driving", "braking", "idling")[int(rng.choice(3, p=[0.5, 0.35, 0.15]))]
    ratio = 1.0 + (log_uniform(rng, 1e-9, 1e-3) if side == "idling" else log_uniform(rng, 1e-4, 49))
    brakes = side == "braking" or (side == "idling" and rng.random() < 0.5)
    tensions = (tight / ratio, tight) if brakes else (tight, tight / ratio)
    return WrapArc(
        law=law,
        entry_tension=tensions[0],
        exit_tension=tensions[1],
        diameter=diameter,
        width=width,
        wrap_angle=math.radians(float(rng.uniform(30.0, 720.0))),
        axial_stiffness=log_uniform(rng, 1e5, 1e10) * width,
        thickness=log_uniform(rng, 1e-4, 0.1),
        shear_modulus=log_uniform(rng, 3e5, 1e9),
        compression_modulus=log_uniform(rng, 2e6, 1e10),
        overrun=[None, 0.0, 2e-5][int(rng.integers(3))],
        recovery=bool(rng.random() < 0.7),
    )


def misses(arc: WrapArc, result: ArcResult, most: int = 40) -> float:
    """Largest miss of the equations along a solution, in units of what is allowed."""
    twin, p = Twin(arc), result.profile
    s, u, q = p.position * arc.radius, p.creep, np.log(p.tension / arc.entry_tension)
    creep, change = float(np.max(np.abs(u))), float(np.max(np.abs(q)))
    worst = [
        abs(u[0] - arc.entry_overrun) / creep / ACCURACY,
        abs(q[0]) / change / ACCURACY,
        abs(result.exit_tension / arc.exit_tension - 1.0) / 1e-8,
    ]

    def rates(_: float, y: NDArray[np.float64]) -> list[float]:
        tension = arc.entry_tension * math.exp(y[0])
        pressure = twin.pressure(tension)
        tau, _ = twin.stress(float(y[1]), pressure)
        growth = result.entry_creep_ratio + (arc.entry_tension - tension) * twin.compliance
        return [-tau / (pressure * twin.radius), growth]

    moving = np.flatnonzero(np.maximum(np.abs(u[1:]), np.abs(u[:-1])) > 1e-6 * creep)
    for i in moving[:: max(1, len(moving) // most)]:
        if s[i + 1] - s[i] < 1e-9 * arc.length:
            continue

        # the way on which creep falls: on the other one any rounding grows like e^(s/l)
        a, b = (i, i + 1) if abs(u[i + 1]) < abs(u[i]) else (i + 1, i)
        part = (s[i + 1] - s[i]) / 4.0
        run = ode(rates)  # Hairer's own code: several times as fast as `solve_ivp`
        run.set_integrator("dop853", rtol=1e-9, atol=1e-12 * creep, nsteps=100000, max_step=part)
        run.set_initial_value([q[a], u[a]], s[a])
        there = run.integrate(s[b])
        assert run.successful()
        worst.append(abs(there[1] - u[b]) / creep / ACCURACY)
        worst.append(abs(there[0] - q[b]) / change / ACCURACY)
    return float(max(worst))


def carries_more(arc: WrapArc) -> float:
    """Largest ln(tight/slack) of the twin over what is asked, for entry creep ratios up to 1."""
    twin = Twin(arc)
    goal = abs(math.log(arc.entry_tension / arc.exit_tension))
    ratios = [twin.integrate(arc.side * g) for g in (1e-3, 1e-2, 0.1, 0.999)]
    return max(-arc.side * e.log_tension for e in ratios) / goal


def verdict(arc: WrapArc, solver: Distributed | Compiled = INTERPRETED) -> tuple[str, float]:
    """How a drive ends, and the largest miss of its solution."""
    result = solver.solve(arc)
    if result.status is not Status.SOLVED:
        return result.status.name.lower(), 0.0
    return "solved", misses(arc, result)
