"""The tension of every strip at the entry, and the drum number: Newton on multiple shooting.

Unknown are the entry tensions t1 and the drum number Gamma, as many as there are conditions: the
mean tensions at entry and exit, and for each mode of the label line that the path closes,

    E1 + E2 + u(L) - u(0) + Lam1 f/M = (Lam1 t1 + Lam2 t2)/M .

Errors of a march grow along the arc like the exponential of its length over the shortest shear
length of belt or lagging, so that it is cut where they have grown enough; the states at the cuts
are unknown too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.across.compiled import PLAIN, Marches
from wraparc.across.wide_arc import Array, WideArc
from wraparc.arc import ArcResult
from wraparc.arc.kernel.step import MESH_POWER

#: logarithm of the growth of errors over one piece of the arc; decides speed and safety only
GROWTH = 6.0
#: largest growth over one mesh step: beyond it the method of order 6 is no longer accurate
STEP_GROWTH = 1.0
MOST_STEPS = 400
TOLERANCE = 1e-10
MOST_ITERATIONS = 16


@dataclass(frozen=True)
class Mesh:
    """Where the arc is stepped and cut.

    Attributes
    ----------
    nodes
        Places s, from 0 to L [m].
    cuts
        Numbers of the nodes where a piece begins, the first 0, and the last node.
    """

    nodes: Array
    cuts: tuple[int, ...]


def mesh_of(wide: WideArc, even: ArcResult, steps: int) -> Mesh:
    """Mesh graded to the entry nip, cut where errors would have grown too far."""
    numbers = wide.numbers
    stiffness = float(np.min(wide.compliance))
    shortest = wide.shear_stiffness * float(wide.wave_numbers[-1]) ** 2
    onset = wide.arc.law.compact().onset_compliance
    lag = float(np.max(numbers.shear)) + onset
    s = even.profile.position * wide.arc.radius
    creep = np.maximum(np.abs(even.profile.creep), 1e-12)
    held = np.abs(even.profile.shear_stress) / creep
    if lag > 0.0:
        held = np.minimum(held, 1.0 / lag)
    growth = np.sqrt((held + shortest) * stiffness)
    whole = np.concatenate([[0.0], np.cumsum(0.5 * (growth[1:] + growth[:-1]) * np.diff(s))])
    length = wide.arc.length
    fewest = MESH_POWER * length * float(np.max(growth)) / STEP_GROWTH
    steps = max(steps, min(math.ceil(fewest), MOST_STEPS))
    nodes = length * np.linspace(0.0, 1.0, steps + 1) ** MESH_POWER
    pieces = max(1, math.ceil(whole[-1] / GROWTH))
    at = np.interp(nodes, s, whole)
    cuts = [int(np.searchsorted(at, whole[-1] * k / pieces)) for k in range(pieces)]
    return Mesh(nodes, tuple(sorted({*cuts, steps})))


@dataclass(frozen=True)
class Unknowns:
    """What Newton's method looks for.

    Attributes
    ----------
    tension
        t1 by strip, shape (n,) [N/m].
    drum
        Gamma [-].
    states
        Tension [N/m] above creep [m] at the cuts, shape (pieces - 1, 2 n).
    """

    tension: Array
    drum: float
    states: Array

    def moved(self, step: Array, factor: float) -> Unknowns:
        """Return the unknowns after a part of a step."""
        n = len(self.tension)
        return Unknowns(
            self.tension + factor * step[:n],
            self.drum + factor * float(step[n]),
            self.states + factor * step[n + 1 :].reshape(self.states.shape),
        )


def started(wide: WideArc, even: ArcResult, mesh: Mesh) -> Unknowns:
    """The even belt."""
    n = wide.strips
    t1 = even.entry_tension / wide.arc.width
    s = even.profile.position * wide.arc.radius
    at = mesh.nodes[list(mesh.cuts[1:-1])]
    tension = np.interp(at, s, even.profile.tension) / wide.arc.width
    creep = np.interp(at, s, even.profile.creep)
    states = np.concatenate([np.repeat(v[:, None], n, 1) for v in (tension, creep)], axis=1)
    drum = even.entry_creep_ratio + t1 * wide.arc.compliance * wide.arc.width
    return Unknowns(np.full(n, t1), drum, states)


@dataclass(frozen=True)
class System:
    """The conditions of one arc.

    Attributes
    ----------
    wide, mesh
        What is solved, and where it is stepped.
    marches
        What carries states along the arc.
    amount
        Share of the defects that is put on, 1 for all of them.
    """

    wide: WideArc
    mesh: Mesh
    marches: Marches = PLAIN
    amount: float = 1.0

    def entry(self, at: Unknowns, columns: bool) -> tuple[Array, Array, Array]:
        """State at the entry nip, what pulls and what drives the strips there.

        With their derivatives by t1 and Gamma in the columns behind them if asked for.
        """
        wide, n = self.wide, self.wide.strips
        numbers = wide.numbers
        kick, kick_t = wide.overrun(at.tension)
        before = wide.spread(wide.length_before) / wide.belt_modulus
        lag1 = self.amount * wide.spread(np.ones(n - 1)) @ wide.entry_misfit
        lag1 = lag1 + before @ (self.amount * wide.entry_profile - at.tension)
        squeeze = 0.0 * wide.give if wide.arc.recovery else wide.give
        drift = at.drum + self.amount * wide.radius_deviation / numbers.radius
        drift = drift - squeeze * at.tension
        state = np.concatenate([at.tension, kick])[:, None]
        pull = (numbers.coupling @ (lag1 - kick))[:, None]
        if not columns:
            return state, pull, drift[:, None]
        by = np.zeros((2 * n, n + 1))
        by[:n, :n] = np.eye(n)
        by[n:, :n] = np.diag(kick_t)
        pull_by = np.zeros((n, n + 1))
        pull_by[:, :n] = -numbers.coupling @ (before + np.diag(kick_t))
        drift_by = np.zeros((n, n + 1))
        drift_by[:, :n] = -np.diag(squeeze)
        drift_by[:, n] = 1.0
        return (
            np.hstack([state, by]),
            np.hstack([pull, pull_by]),
            np.hstack([drift[:, None], drift_by]),
        )

    def pieces(self, at: Unknowns, columns: bool) -> list[Array]:
        """States at the ends of the pieces of the arc, with their derivatives if asked for."""
        wide, n = self.wide, self.wide.strips
        law, numbers = wide.arc.law.compact(), wide.numbers
        y, pull, drift = self.entry(at, columns)
        ends = []
        for k, (first, last) in enumerate(zip(self.mesh.cuts, self.mesh.cuts[1:], strict=False)):
            if k == 1 and columns:
                room = np.zeros((n, 2 * n))
                pull = np.hstack([pull[:, :1], room, pull[:, 1:]])
                drift = np.hstack([drift[:, :1], room, drift[:, 1:]])
            if k > 0:
                y = at.states[k - 1][:, None]
                if columns:
                    y = np.hstack([y, np.eye(2 * n), np.zeros((2 * n, n + 1))])
            nodes = self.mesh.nodes[first : last + 1]
            ends.append(self.marches.march(law, numbers, pull, drift, y, nodes))
        return ends

    def misses(self, at: Unknowns, ends: list[Array]) -> Array:
        """How far the conditions are from being met [N/m, and m at the cuts]."""
        wide, n, arc = self.wide, self.wide.strips, self.wide.arc
        c, m = wide.modes, wide.belt_modulus
        last = ends[-1][:, 0]
        kick, _ = wide.overrun(at.tension)
        reach = wide.length_before + wide.length_after + arc.length
        path = self.amount * (wide.entry_misfit + wide.exit_misfit) + last[n:] - kick
        free = self.amount * wide.entry_profile
        closing = m * (c[1:] @ path) + wide.length_before * (c[1:] @ (free - at.tension))
        closing = (closing - wide.length_after * (c[1:] @ last[:n])) / reach
        return np.concatenate(
            [
                [np.mean(at.tension) - arc.entry_tension / arc.width],
                [np.mean(last[:n]) - arc.exit_tension / arc.width],
                closing,
                *(end[:, 0] - at.states[k] for k, end in enumerate(ends[:-1])),
            ]
        )

    def slopes(self, at: Unknowns, ends: list[Array]) -> Array:
        """Derivatives of the misses by the unknowns."""
        wide, n = self.wide, self.wide.strips
        c, m = wide.modes, wide.belt_modulus
        size = n + 1 + at.states.size
        out = np.zeros((size, size))
        reach = wide.length_before + wide.length_after + wide.arc.length
        # of the last piece, the derivatives of its end by all unknowns
        by = np.zeros((2 * n, size))
        for k, end in enumerate(ends):
            row = np.zeros((2 * n, size))
            row[:, : n + 1] = end[:, -(n + 1) :]
            if k > 0:
                row[:, n + 1 + 2 * n * (k - 1) : n + 1 + 2 * n * k] = end[:, 1 : 2 * n + 1]
            if k < len(ends) - 1:
                at_row = n + 1 + 2 * n * k
                row[:, at_row : at_row + 2 * n] -= np.eye(2 * n)
                out[at_row : at_row + 2 * n] = row
            else:
                by = row
        _, kick_t = wide.overrun(at.tension)
        path = by[n:].copy()
        path[:, :n] -= np.diag(kick_t)
        closing = m * (c[1:] @ path) - wide.length_after[:, None] * (c[1:] @ by[:n])
        closing[:, :n] -= wide.length_before[:, None] * c[1:]
        out[0, :n] = 1.0 / n
        out[1] = np.mean(by[:n], axis=0)
        out[2 : n + 1] = closing / reach[:, None]
        return out


@dataclass(frozen=True)
class Found:
    """Where Newton's method ended.

    Attributes
    ----------
    unknowns
        The unknowns there.
    solved
        Whether it met the conditions.
    iterations
        Steps taken.
    """

    unknowns: Unknowns
    solved: bool
    iterations: int


def newton(system: System, start: Unknowns) -> Found:
    """Solve the conditions from a start, damped so that no strip loses its tension on the way."""
    wide, n = system.wide, system.wide.strips
    tight = max(wide.arc.entry_tension, wide.arc.exit_tension) / wide.arc.width
    unit = np.concatenate([np.full(n, tight), np.full(n, 1e-3)])
    scale = np.concatenate([np.full(n + 1, tight), np.tile(unit, len(start.states))])
    at = start
    ends = system.pieces(at, columns=True)
    miss = system.misses(at, ends) / scale
    for iteration in range(1, MOST_ITERATIONS + 1):
        size = float(np.linalg.norm(miss))
        if not math.isfinite(size):
            return Found(at, False, iteration)
        try:
            step = -np.linalg.solve(system.slopes(at, ends) / scale[:, None], miss)
        except np.linalg.LinAlgError:
            return Found(at, False, iteration)
        factor = _longest(at, step)
        for _ in range(8):
            trial = at.moved(step, factor)
            ends = system.pieces(trial, columns=True)
            miss_there = system.misses(trial, ends) / scale
            if np.linalg.norm(miss_there) <= (1.0 - 0.25 * factor) * size or size < 1e-7:
                break
            factor *= 0.4
        else:
            return Found(at, False, iteration)
        at, miss = trial, miss_there
        if factor == 1.0 and float(np.max(np.abs(miss))) < TOLERANCE:
            return Found(at, True, iteration)
    return Found(at, False, MOST_ITERATIONS)


def _longest(at: Unknowns, step: Array) -> float:
    """Largest part of a step that leaves every unknown tension a tenth of itself."""
    n = len(at.tension)
    now = np.concatenate([at.tension, at.states[:, :n].ravel()])
    change = np.concatenate([step[:n], step[n + 1 :].reshape(at.states.shape)[:, :n].ravel()])
    worst = float(np.max(-change / now))
    return 1.0 if worst <= 0.9 else 0.9 / worst
