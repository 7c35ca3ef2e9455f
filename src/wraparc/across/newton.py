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
from dataclasses import dataclass, replace

import numpy as np

from wraparc.across.compiled import PLAIN, Marches
from wraparc.across.mesh import Mesh, bends, kinks
from wraparc.across.wide_arc import Array, WideArc
from wraparc.arc import ArcResult

TOLERANCE = 1e-10
MOST_ITERATIONS = 16
#: size of the misses from which one more step meets them
_NEAR = 1e-5
#: sizes between which the mesh follows the kinks of the law: they are about where they will be, and
#: not yet so near that a mesh that moves hinders the last steps
_SETTLED, _AROUND = 1e-4, 0.3


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

    def fitted(self, at: Unknowns, coarse: Mesh) -> System:
        """Return the system with a node at every kink of the friction law."""
        if not bends(self.wide):
            return self
        records, pull, drift = self.trace(at)
        state = records[:, : 2 * self.wide.strips]
        places = kinks(self.wide, self.mesh.nodes, state, pull, drift)
        return replace(self, mesh=coarse.with_nodes(places))

    def trace(self, at: Unknowns) -> tuple[Array, Array, Array]:
        """Tension, creep, work of friction and shear, and force of friction at the nodes.

        Shape (m, 4 n), with what pulls and what drives the strips, shape (n,).
        """
        wide, n = self.wide, self.wide.strips
        law, numbers = wide.arc.law.compact(), wide.numbers
        state, pull, drift = self.entry(at, columns=False)
        y = np.concatenate([state[:, 0], np.zeros(2 * n)])
        rows = [y[None, :]]
        for k, (first, last) in enumerate(zip(self.mesh.cuts, self.mesh.cuts[1:], strict=False)):
            if k > 0:
                y = np.concatenate([at.states[k - 1], rows[-1][-1, 2 * n :]])
            nodes = self.mesh.nodes[first : last + 1]
            part = self.marches.trace(law, numbers, pull, drift, y, nodes)
            rows.append(part[1:])
        return np.concatenate(rows), pull[:, 0], drift[:, 0]

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
    system
        The conditions, on the mesh that they were last looked at on.
    unknowns
        The unknowns there.
    solved
        Whether it met the conditions.
    iterations
        Steps taken.
    """

    system: System
    unknowns: Unknowns
    solved: bool
    iterations: int


def newton(system: System, start: Unknowns) -> Found:
    """Solve the conditions from a start, damped so that no strip loses its tension on the way."""
    coarse, scale = system.mesh, _scale(system.wide, start)
    at, ends = start, system.pieces(start, columns=True)
    miss = system.misses(at, ends) / scale
    for iteration in range(1, MOST_ITERATIONS + 1):
        size = float(np.linalg.norm(miss))
        if not math.isfinite(size):
            return Found(system, at, False, iteration)
        try:
            step = np.asarray(-np.linalg.solve(system.slopes(at, ends) / scale[:, None], miss))
        except np.linalg.LinAlgError:
            return Found(system, at, False, iteration)
        factor, near = _longest(at, step), size < _NEAR
        for _ in range(8):
            trial = at.moved(step, factor)
            tried = system.fitted(trial, coarse) if _SETTLED <= size < _AROUND else system
            # the last march need not say how its ends depend on the unknowns
            ends = tried.pieces(trial, columns=not near)
            miss_there = tried.misses(trial, ends) / scale
            if np.linalg.norm(miss_there) <= (1.0 - 0.25 * factor) * size or size < 1e-7:
                break
            factor *= 0.4
        else:
            return Found(system, at, False, iteration)
        at, miss, system = trial, miss_there, tried
        if factor == 1.0 and float(np.max(np.abs(miss))) < TOLERANCE:
            return Found(system, at, True, iteration)
        if near:
            ends = system.pieces(at, columns=True)
    return Found(system, at, False, MOST_ITERATIONS)


def _scale(wide: WideArc, start: Unknowns) -> Array:
    """What the conditions are measured by: the tight side, and a millimetre of creep."""
    n, tight = wide.strips, max(wide.arc.entry_tension, wide.arc.exit_tension) / wide.arc.width
    unit = np.concatenate([np.full(n, tight), np.full(n, 1e-3)])
    return np.concatenate([np.full(n + 1, tight), np.tile(unit, len(start.states))])


def _longest(at: Unknowns, step: Array) -> float:
    """Largest part of a step that leaves every unknown tension a tenth of itself."""
    n = len(at.tension)
    now = np.concatenate([at.tension, at.states[:, :n].ravel()])
    change = np.concatenate([step[:n], step[n + 1 :].reshape(at.states.shape)[:, :n].ravel()])
    worst = float(np.max(-change / now))
    return 1.0 if worst <= 0.9 else 0.9 / worst
