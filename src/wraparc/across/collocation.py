"""The belt on its arc as one system of equations, solved by Newton's method.

On every strip, with the tension per unit width t, the creep u and the lag of the label line,

    t = t1 + int (-tau(u, t/R) + S d2(lag)/dy2) ds,     lag = lag1 + u - u(0),
    u = u(0) + (Gamma + a/R) s - int t/M' ds,

by Gauss collocation (`wraparc.across.elements`): unknown are t at the stages of all elements, t1
and Gamma. As many conditions close the system: the mean tensions at entry and exit, and for each
mode of the label line that the path closes,

    E1 + E2 + u(L) - u(0) + Lam1 f/M = (Lam1 t1 + Lam2 t2)/M .

Nothing is marched, so that nothing grows along the arc. A belt that is even has modes that know
nothing of each other: their equations, with the slopes of friction taken in the mean over the
width, are inverted once, all modes together. What unevenness adds is little, and each Newton step
finds it in a few vectors (GMRES), without a matrix of all strips.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from wraparc.across.elements import Elements
from wraparc.across.stresses import Law, Stress, stresses
from wraparc.across.wide_arc import WideArc
from wraparc.arc import ArcResult
from wraparc.arrays import Array

#: largest step of a tension, over the mean of the tight side, at which the conditions are met
TOLERANCE = 1e-11
#: the same where rounding allows no less
_ROUNDED = 1e-8
MOST_ITERATIONS = 20
#: how much of a Newton step its vectors may leave undone, and how many they may be
_LEFT, _MOST_VECTORS = 1e-3, 80
_HALVINGS = 8


@dataclass(frozen=True)
class State:
    """What Newton's method looks for.

    Attributes
    ----------
    tension
        t at the stages, shape (m, n) [N/m].
    entry
        t1 by strip, shape (n,) [N/m].
    drum
        Gamma [-].
    """

    tension: Array
    entry: Array
    drum: float


def _across(values: Array, table: Array) -> Array:
    """A table of strips or modes applied to values at the stages, shape (m, n).

    A stage at a time: products so small are not split among threads, which would cost more.
    """
    n = len(table)
    return np.asarray((values.reshape(3, -1, n) @ table).reshape(-1, n))


class Point(NamedTuple):
    """The equations at a state.

    Attributes
    ----------
    state
        The state.
    miss
        How far each is from being met, by mode, shape (m + 1, n) [N/m].
    creep, stress
        u [m] and what friction answers to it at the points, shape (k, n).
    pulled
        dt/ds there [Pa].
    tension_end, creep_end
        t2 [N/m] and u(L) [m] by strip, shape (n,).
    """

    state: State
    miss: Array
    creep: Array
    stress: Stress
    pulled: Array
    tension_end: Array
    creep_end: Array


@dataclass(frozen=True)
class System:
    """The conditions of one arc.

    Attributes
    ----------
    wide, elements
        What is solved, and where.
    amount
        Share of the defects that is put on, 1 for all of them.
    """

    wide: WideArc
    elements: Elements
    amount: float = 1.0

    @cached_property
    def law(self) -> Law:
        """The friction law."""
        return Law.of(self.wide.arc.law.compact())

    @cached_property
    def misfit(self) -> Array:
        """E1 without its mean, which no lag sees [m]."""
        wide = self.wide
        return np.asarray(self.amount * wide.spread(np.ones(wide.strips - 1)) @ wide.entry_misfit)

    @cached_property
    def before(self) -> Array:
        """How the label line falls behind as t1 rises [m2/N]."""
        return np.asarray(self.wide.spread(self.wide.length_before) / self.wide.belt_modulus)

    @cached_property
    def free(self) -> Array:
        """f, the tension that there would be without lag, less its mean [N/m]."""
        return self.amount * self.wide.entry_profile

    @cached_property
    def squeeze(self) -> Array:
        """How the drift falls as t1 rises, where the lagging does not recover [m/N]."""
        return 0.0 * self.wide.give if self.wide.arc.recovery else self.wide.give

    @property
    def drum_unit(self) -> float:
        """Gamma that lets every strip creep as one newton a metre does."""
        return float(np.mean(self.wide.compliance_in_wrap))

    def entry_lag(self, entry: Array) -> Array:
        """Lag of the label line at the entry nip by strip, mean 0 [m]."""
        return np.asarray(self.misfit + self.before @ (self.free - entry))

    def drift(self, state: State) -> Array:
        """Gamma + a/(R + e) by strip, less what the lagging gives [-]."""
        wide = self.wide
        own = self.amount * wide.radius_deviation / wide.pitch
        own = own + wide.give * wide.lift  # which squeezes no lagging
        return np.asarray(state.drum + own - self.squeeze * state.entry)

    def at(self, state: State) -> Point:
        """Return the equations at a state."""
        wide, e, arc = self.wide, self.elements, self.wide.arc
        overrun, _ = wide.overrun(state.entry)
        drift = self.drift(state)
        pull = wide.coupling @ (self.entry_lag(state.entry) - overrun)
        compliance = wide.compliance_in_wrap
        creep = overrun + e.points[:, None] * drift
        creep -= e.integral_at_points(state.tension) * compliance
        pressure = wide.pressure(e.at_points(state.tension))
        stress = stresses(self.law, wide.shear, creep, pressure)
        pulled = self._coupled(overrun, drift, state.tension) + pull
        pulled -= wide.pulled_share * stress.stress
        end = state.entry + e.total(pulled)
        creep_end = overrun + arc.length * drift - compliance * e.total_of_stages(state.tension)
        own = state.tension - state.entry - e.integral_at_stages(pulled)
        paths = self.amount * (wide.entry_misfit + wide.exit_misfit) + creep_end - overrun
        last = self._closing(paths, state.entry - self.free, end)
        last[0] -= np.sqrt(wide.strips) * arc.exit_tension / arc.width
        miss = np.vstack([_across(own, wide.modes.T), last])
        return Point(state, miss, creep, stress, pulled, end, creep_end)

    def _coupled(self, overrun: Array, drift: Array, tension: Array) -> Array:
        """S d2u/dy2 at the points: as `creep`, of strips coupled before they are integrated."""
        wide, e = self.wide, self.elements
        strain = _across(tension * wide.compliance_in_wrap, wide.coupling)
        coupled = overrun @ wide.coupling + e.points[:, None] * (drift @ wide.coupling)
        return np.asarray(coupled - e.integral_at_points(strain))

    def _closing(self, path: Array, entry: Array, end: Array) -> Array:
        """How far the mean exit tension and the path of each mode are from closing [N/m]."""
        wide, c = self.wide, self.wide.modes
        closing = wide.belt_modulus * (c[1:] @ path) - wide.length_before * (c[1:] @ entry)
        closing = (closing - wide.length_after * (c[1:] @ end)) / self._reach
        return np.concatenate([[c[0] @ end], closing])

    @cached_property
    def _reach(self) -> Array:
        """What the conditions are divided by, so that endless spans stay finite [m]."""
        return self.wide.length_before + self.wide.length_after + self.wide.arc.length

    def step(self, z: Array) -> State:
        """The change of state of a vector by mode, shape (m + 1, n) [N/m].

        The last row is that of t1; its mean, which is given, makes room for Gamma.
        """
        c = self.wide.modes
        drum = float(z[-1, 0]) * self.drum_unit / np.sqrt(self.wide.strips)
        return State(_across(z[:-1], c), z[-1, 1:] @ c[1:], drum)

    def changed(self, point: Point, z: Array) -> Array:
        """How the misses change along a vector by mode: the derivative there."""
        wide, e, d = self.wide, self.elements, self.step(z)
        compliance = wide.compliance_in_wrap
        _, by_entry = wide.overrun(point.state.entry)
        overrun, drift = by_entry * d.entry, d.drum - self.squeeze * d.entry
        creep = overrun + e.points[:, None] * drift
        creep -= e.integral_at_points(d.tension) * compliance
        pulled = self._coupled(overrun, drift, d.tension)
        pulled -= wide.coupling @ (self.before @ d.entry + overrun)
        pulled -= wide.pulled_share * point.stress.by_creep * creep
        pulled -= point.stress.by_pressure / wide.pitch * e.at_points(d.tension)
        own = d.tension - d.entry - e.integral_at_stages(pulled)
        end = d.entry + e.total(pulled)
        path = wide.arc.length * drift - compliance * e.total_of_stages(d.tension)
        return np.vstack([_across(own, wide.modes.T), self._closing(path, d.entry, end)])

    def modal(self, point: Point) -> Array:
        """The same as a matrix by mode, friction in the mean over the width: (n, m + 1, m + 1)."""
        wide, e, n = self.wide, self.elements, self.wide.strips
        m, unit = len(e.stages), self.drum_unit
        by_creep = wide.pulled_share * np.mean(point.stress.by_creep, axis=1)
        by_tension = np.mean(point.stress.by_pressure, axis=1) / wide.pitch
        squeeze = float(np.mean(self.squeeze))
        overrun = float(np.mean(wide.overrun(point.state.entry)[1]))
        couple = -wide.shear_stiffness * np.concatenate([[0.0], wide.wave_numbers**2])
        before = np.concatenate([[0.0], wide.length_before])
        slope = couple[:, None] - by_creep  # of dt/ds by creep, (n, m)
        creep = np.tile(overrun - squeeze * e.points, (n, 1))
        creep[0] = unit * e.points
        by_last = slope * creep - (couple * (before / wide.belt_modulus + overrun))[:, None]
        each = np.eye(m)
        fallen = -unit * e.integral_at_points(each)  # creep by the tensions at the stages
        own = -by_creep[:, None] * fallen - by_tension[:, None] * e.at_points(each)
        out = np.empty((n, m + 1, m + 1))
        out[:, :m, :m] = each - e.integral_at_stages(own)
        out[:, :m, :m] -= couple[:, None, None] * e.integral_at_stages(fallen)
        out[:, :m, m] = -e.integral_at_stages(by_last.T).T
        out[1:, :m, m] -= 1.0
        over, over_last = e.total(own) + np.outer(couple, e.total(fallen)), e.total(by_last.T)
        out[0, m, :m], out[0, m, m] = over[0], over_last[0]
        after, reach = wide.length_after, self._reach
        path = wide.belt_modulus * unit * e.total_of_stages(each) + after[:, None] * over[1:]
        out[1:, m, :m] = -path / reach[:, None]
        path = wide.belt_modulus * squeeze * wide.arc.length + wide.length_before
        out[1:, m, m] = -(path + after * (1.0 + over_last[1:])) / reach
        return out


def started(system: System, even: ArcResult) -> State:
    """The even belt."""
    arc, n = system.wide.arc, system.wide.strips
    entry = even.entry_tension / arc.width
    tension = np.interp(
        system.elements.stages, even.profile.position * arc.radius, even.profile.tension
    )
    drum = even.entry_creep_ratio + entry * arc.compliance * arc.width
    drum -= arc.recovery_compliance * arc.centrifugal
    return State(np.repeat(tension[:, None] / arc.width, n, axis=1), np.full(n, entry), drum)


class Found(NamedTuple):
    """Where Newton's method ended.

    Attributes
    ----------
    system
        The conditions.
    point
        The equations there.
    solved
        Whether they are met.
    iterations
        Steps taken.
    """

    system: System
    point: Point
    solved: bool
    iterations: int


def between(found: Found, places: Array) -> State:
    """A solution with the tension at other places [m] than the stages."""
    state = found.point.state
    risen = found.system.elements.integral(found.point.pulled, places)
    return replace(state, tension=state.entry + risen)


def along(found: Found, places: Array) -> tuple[Array, Array]:
    """Creep [m] and tension [N/m] of a solution at places [m], shape (places, n) each."""
    system, point = found.system, found.point
    wide, state, e = system.wide, point.state, system.elements
    overrun, _ = wide.overrun(state.entry)
    strained = e.integral(e.at_points(state.tension), places) * wide.compliance_in_wrap
    creep = overrun + places[:, None] * system.drift(state) - strained
    return creep, state.entry + e.integral(point.pulled, places)


def newton(system: System, start: State) -> Found:
    """Solve the conditions from a start; a strip that would have to push carries nothing."""
    arc = system.wide.arc
    scale = max(arc.entry_tension, arc.exit_tension) / arc.width
    point = system.at(start)
    with np.errstate(all="ignore"):
        try:
            inverse = np.asarray(np.linalg.inv(system.modal(point)), dtype=float)
            return _steps(system, point, inverse, scale)
        except np.linalg.LinAlgError:
            return Found(system, point, False, 0)


def _steps(system: System, point: Point, inverse: Array, scale: float) -> Found:
    def uncoupled(miss: Array) -> Array:
        return np.asarray(np.einsum("nij,jn->in", inverse, miss))

    miss = uncoupled(point.miss)
    for iteration in range(1, MOST_ITERATIONS + 1):
        size = float(np.linalg.norm(miss))
        if not np.isfinite(size):
            return Found(system, point, False, iteration)
        here = point
        z = solved_by_vectors(lambda v: uncoupled(system.changed(here, v)), -miss)  # noqa: B023
        step = system.step(z)
        factor = 1.0
        for _ in range(_HALVINGS):
            trial = system.at(_moved(point.state, step, factor))
            miss_there = uncoupled(trial.miss)
            if np.linalg.norm(miss_there) <= (1.0 - 0.25 * factor) * size:
                break
            factor *= 0.4
        else:
            near = float(np.max(np.abs(miss))) < _ROUNDED * scale
            return Found(system, point, near, iteration)
        point, miss = trial, miss_there
        if factor == 1.0 and float(np.max(np.abs(miss))) < TOLERANCE * scale:
            return Found(system, point, True, iteration)
    return Found(system, point, False, MOST_ITERATIONS)


def _moved(state: State, step: State, factor: float) -> State:
    return State(
        state.tension + factor * step.tension,
        state.entry + factor * step.entry,
        state.drum + factor * step.drum,
    )


def solved_by_vectors(product: Callable[[Array], Array], right: Array) -> Array:
    """Solve a linear system that is near the identity by GMRES, from its products alone."""
    size = float(np.linalg.norm(right))
    if size == 0.0:
        return right
    vectors = np.empty((_MOST_VECTORS + 1, right.size))
    vectors[0] = right.ravel() / size
    table, left = np.zeros((_MOST_VECTORS, _MOST_VECTORS)), np.zeros(_MOST_VECTORS + 1)
    left[0] = size
    turns: list[tuple[float, float]] = []
    for k in range(_MOST_VECTORS):
        new = product(vectors[k].reshape(right.shape)).ravel()
        column = np.zeros(k + 2)
        for _ in range(2):  # the second time for what rounding left
            along = np.einsum("kv,v->k", vectors[: k + 1], new)
            column[: k + 1] += along
            new = new - np.einsum("k,kv->v", along, vectors[: k + 1])
        length = float(np.linalg.norm(new))
        column[k + 1] = length
        for i, (c, s) in enumerate(turns):
            column[i : i + 2] = c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]
        radius = math.hypot(column[k], length) or 1.0
        turns.append((column[k] / radius, length / radius))
        table[:k, k], table[k, k] = column[:k], radius
        left[k + 1] = -turns[k][1] * left[k]
        left[k] *= turns[k][0]
        if abs(left[k + 1]) <= _LEFT * size:
            break
        vectors[k + 1] = new / length
    weights = np.linalg.solve(table[: k + 1, : k + 1], left[: k + 1])
    return np.asarray((weights @ vectors[: k + 1]).reshape(right.shape))
