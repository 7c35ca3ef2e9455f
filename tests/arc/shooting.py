"""The twin's own solution of an arc, by multiple shooting from the points of a profile.

A search of its own would ask the twin (tests/arc/twin.py: creep as the state, laws written out
again) for numbers that no march from one end can tell apart on a long arc.
"""

from __future__ import annotations

import math
import warnings

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import ode
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import MatrixRankWarning, spsolve

from arc.twin import Twin
from wraparc.arc import ArcResult, Distributed, Status, WrapArc

ACCURACY = 1e-5  # of creep and slip at the exit and of the largest shear stress
ALONG = 1e-4  # of creep and tension on the way: of nearly idle belts an end is the better known
REST = 1e-8  # of the largest creep
POINTS = (60, 180, 400, 1500)  # of profiles, more where pieces are too long for the twin
STEPS = 10_000  # of the twin in a piece, before shorter pieces are tried; ten times in the last
INTERPRETED = Distributed(capacities=False, points=POINTS[0])


class StiffError(Exception):
    """A piece is too long for an explicit method."""


def exponential(a: NDArray[np.float64]) -> NDArray[np.float64]:
    """e^A of a small matrix: a series, squared."""
    halvings = max(0, math.ceil(math.log2(max(float(np.max(np.abs(a))), 1e-300))) + 3)
    power = found = np.eye(len(a))
    for k in range(1, 10):
        power = power @ a / (2.0**halvings * k)
        found = found + power
    for _ in range(halvings):
        found = found @ found
    return found


class Shooting:
    """Pieces of an arc integrated by its twin, with their slopes, at one entry creep ratio."""

    def __init__(self, twin: Twin, g: float, creep: float, steps: int) -> None:
        self.twin, self.g, self.creep, self.steps = twin, g, creep, steps
        self.path: list[tuple[float, float, float, float]] = []  # stress, s, q, u

    def carry(self, s: float, to: float, start: tuple[float, float]) -> NDArray[np.float64]:
        """ln(T/T1) and creep at the other end of a piece."""
        return self._run(s, to, start, abs(to - s) / 4.0)

    def slopes(
        self, length: float, start: tuple[float, float], end: tuple[float, float]
    ) -> NDArray[np.float64]:
        """Slopes of that by ln(T/T1), creep and g, of equations made linear between both ends."""
        linear = np.zeros((3, 3))
        linear[1, 2] = 1.0
        for q, u in (start, end):
            here = np.array(self.rates(q, u))
            small = (1e-6, 1e-6 * self.creep)
            for k, at in enumerate(((q + small[0], u), (q, u + small[1]))):
                linear[:2, k] += 0.5 * (np.array(self.rates(*at)) - here) / small[k]
        return exponential(linear * length)[:2]

    def peak(self) -> float:
        """Largest shear stress: a finer piece around the largest of all steps."""
        path = sorted(self.path, key=lambda at: at[1])
        k = max(range(len(path)), key=lambda i: path[i][0])
        low, high = path[max(k - 1, 0)], path[min(k + 1, len(path) - 1)]
        best = path[k][0]
        if low is not path[k] and high is not path[k]:
            self.path = []
            fine = abs(high[1] - low[1]) / 100.0
            if abs(high[3]) < abs(low[3]):
                low, high = high, low
            self._run(high[1], low[1], high[2:], fine)
            best = max(best, *(at[0] for at in self.path))
        return best

    def rates(self, q: float, u: float) -> tuple[float, float]:
        """Rates of ln T and creep along the arc [1/m, -]."""
        twin, arc = self.twin, self.twin.arc
        tension = arc.entry_tension * math.exp(q)
        pressure = twin.pressure(tension)
        tau, _ = twin.stress(u, pressure)
        growth = self.g + (arc.entry_tension - tension) * twin.compliance
        return -tau / (pressure * twin.radius), growth

    def _run(
        self, s: float, to: float, start: tuple[float, float], longest: float
    ) -> NDArray[np.float64]:
        twin, arc = self.twin, self.twin.arc

        def keep(at: float, y: NDArray[np.float64]) -> None:
            tension = arc.entry_tension * math.exp(y[0])
            tau, _ = twin.stress(float(y[1]), twin.pressure(tension))
            self.path.append((abs(tau), at, float(y[0]), float(y[1])))

        # Hairer's own code: several times as fast as `solve_ivp`
        run = ode(lambda _, y: self.rates(float(y[0]), float(y[1])))
        run.set_integrator(
            "dop853", rtol=1e-9, atol=1e-12 * self.creep, nsteps=self.steps, max_step=longest
        )
        run.set_solout(keep)
        run.set_initial_value(start, s)
        there = run.integrate(to)
        if not run.successful():
            raise StiffError
        return np.array(there)


def misses(arc: WrapArc, result: ArcResult, steps: int) -> float:
    """Largest miss of a solution, in units of what is allowed.

    The twin integrates from each point of the profile to the next (creep as the state, laws written
    out again) and solves for the points that these pieces join to one arc with the given overrun
    and both tensions: multiple shooting, begun from the profile. One Newton step from there is the
    twin's own solution, if the two are near each other at all; the step is what is measured.
    """
    twin, p = Twin(arc), result.profile
    s, u, q = p.position * arc.radius, p.creep, np.log(p.tension / arc.entry_tension)
    keep = np.concatenate([np.diff(s) > 1e-9 * arc.length, [True]])
    keep[0] = True
    s, u, q = s[keep], u[keep], q[keep]
    creep = float(np.max(np.abs(u)))
    shooting = Shooting(twin, result.entry_creep_ratio, creep, steps)
    n = len(s)
    rows, right = np.zeros((2 * n + 1, 2 * n + 1)), np.zeros(2 * n + 1)
    rows[0, 0] = rows[1, 1] = rows[2, 2 * n - 2] = 1.0
    right[0], right[1] = -q[0], arc.entry_overrun - u[0]
    right[2] = math.log(arc.exit_tension / arc.entry_tension) - q[-1]
    for i in range(n - 1):
        # the way on which creep falls: on the other one any rounding grows like e^(s/l)
        a, b = (i, i + 1) if abs(u[i + 1]) < abs(u[i]) else (i + 1, i)
        k = 3 + 2 * i
        there = np.array([q[b], u[b]])  # at rest: e^(s/l) of nothing, which cannot be told
        if abs(u[a]) + abs(u[b]) > REST * creep:
            there = shooting.carry(s[a], s[b], (q[a], u[a]))
        slopes = shooting.slopes(s[b] - s[a], (q[a], u[a]), (q[b], u[b]))
        rows[k : k + 2, 2 * a : 2 * a + 2] = slopes[:, :2]
        rows[k : k + 2, 2 * b : 2 * b + 2] = -np.eye(2)
        rows[k : k + 2, -1] = slopes[:, 2]
        right[k : k + 2] = [q[b] - there[0], u[b] - there[1]]
    size = np.tile([1.0, creep], n + 1)[: 2 * n + 1]
    size[-1] = creep / arc.length
    rows *= size
    scale = np.max(np.abs(rows), axis=1)
    step = spsolve(csc_matrix(rows / scale[:, None]), right / scale) * size
    q_end, u_end = q[-1] + step[2 * n - 2], u[-1] + step[2 * n - 1]
    _, slip = twin.stress(u_end, twin.pressure(arc.entry_tension * math.exp(q_end)))
    slips = float(np.max(np.abs(p.slip)))
    return float(
        max(
            abs(u_end - result.exit_creep) / creep / ACCURACY,
            abs(slip - result.exit_slip) / max(slips, 1e-3 * creep) / ACCURACY,
            abs(shooting.peak() / result.peak_shear_stress - 1.0) / ACCURACY,
            abs(result.exit_tension / arc.exit_tension - 1.0) / 1e-8,
            np.max(np.abs(step[1:-1:2])) / creep / ALONG,
            np.max(np.abs(step[:-1:2])) / np.max(np.abs(q)) / ALONG,
        )
    )


def judged(arc: WrapArc, result: ArcResult) -> float:
    """`misses`; where pieces are long against the shear-lag length, the same of shorter ones."""
    miss = _missed(arc, result, STEPS)
    for points in POINTS[1:]:
        if miss <= 1.0:
            break
        finer = Distributed(capacities=False, points=points).solve(arc)
        assert abs(finer.exit_creep - result.exit_creep) <= 1e-9 * abs(result.exit_creep)
        miss = _missed(arc, finer, 10 * STEPS if points == POINTS[-1] else STEPS)
    return miss


def _missed(arc: WrapArc, result: ArcResult, steps: int) -> float:
    """`misses`, infinite where the twin cannot tell: its pieces are too long."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", MatrixRankWarning)
        warnings.filterwarnings("ignore", ".*problem is probably stiff")
        warnings.filterwarnings("ignore", ".*larger nsteps is needed")
        try:
            miss = misses(arc, result, steps)
        except StiffError:
            return math.inf
    return miss if miss == miss else math.inf


def breaks_away(arc: WrapArc) -> float:
    """Largest ln(tight/slack) of the twin over what is asked, for entry creep ratios up to 1.

    Above 1 a breakaway is none: the twin carries what was asked.
    """
    twin = Twin(arc)
    goal = abs(math.log(arc.entry_tension / arc.exit_tension))
    ratios = np.append(np.geomspace(1e-5, 0.5, 20), 0.999)
    carried = [-arc.side * twin.integrate(arc.side * float(g)).log_tension for g in ratios]
    return max(carried) / goal / (1.0 + 1e-6)


def verdict(arc: WrapArc, solver: Distributed = INTERPRETED) -> tuple[str, float]:
    """How a drive ends, and the largest miss of its solution."""
    result = solver.solve(arc)
    if result.status is not Status.SOLVED:
        return result.status.name.lower(), 0.0
    return "solved", judged(arc, result)
