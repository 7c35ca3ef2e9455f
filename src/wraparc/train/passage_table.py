"""What leaves a pulley, tabulated over entry tension and entry creep ratio: many answers at once.

Nodes are even in the logarithm of the tension and in asinh(g/1e-5): between them the table is
interpolated by polynomials, of fifth order in the ratio and third order in the tension. All nodes
are solved at once, by exit creeps.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asinh, log

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.collocation import CREEP
from wraparc.arc.traction import plateau_stress
from wraparc.arrays import Array
from wraparc.batch.traction import laws_of
from wraparc.batch.two_point import Block, Ends, first_courses, on_mesh, solved, spread
from wraparc.train.member import SHARP, Member, Passage
from wraparc.train.roots import sloped_root

Places = NDArray[np.intp]

#: Entry creep ratio up to which a table goes, either way; a creep of 5 % of the wrap. And the one
#: where its nodes turn from even to logarithmic.
LARGEST_RATIO, RATIO_SCALE = 0.05, 1e-5
_RATIO_STEP, _CREEP_STEP = 0.38, 0.19  # of asinh(g/1e-5), of the same of creep
_TENSION_STEP = 0.25  # of the logarithm
_RATIO_POINTS, _TENSION_POINTS = 6, 4
_MESHES, _FIRST_NEAR, _NEAR = (8, 16, 24), 0.05, 1e-5  # elements; change that ends Newton's method
_LARGEST_FALL = 6.0  # of ln T, of a first guess


def _passages(member: Member, logs: Array, ratios: Array) -> Array:
    """Send the belt over a pulley for each asinh(g/1e-5) and ln(entry tension).

    Returns ln(exit over entry tension) [-] and exit creep [m], (2, ratios, tensions).
    """
    entry, length = np.exp(logs), member.length
    area = member.geometry.width * member.geometry.radius
    wrap = member.geometry.wrap_angle
    mus = np.array([plateau_stress(member.law, a / area) * area / a for a in entry])
    widest = length * (LARGEST_RATIO + member.compliance * entry * np.expm1(mus * wrap))
    idle = np.array([_idle(member, float(a)) for a in entry])
    end = float(np.arcsinh(widest / (RATIO_SCALE * length)).max())
    places = np.linspace(-end, end, 2 * int(end / _CREEP_STEP) + 2)  # of no node creeps nothing
    creeps = idle + RATIO_SCALE * length * np.sinh(places)[:, None]
    exits, found = _solved(member, np.broadcast_to(entry, creeps.shape).ravel(), creeps.ravel())
    at = np.arcsinh(found.reshape(creeps.shape) / RATIO_SCALE)
    falls = np.log(exits.reshape(creeps.shape) / entry)
    made = np.empty((2, len(ratios), len(logs)))
    for j in range(len(logs)):
        made[0, :, j] = _through(at[:, j], falls[:, j], ratios)
        made[1, :, j] = _through(at[:, j], creeps[:, j], ratios)
    return made


def _idle(member: Member, entry: float) -> float:
    """Exit creep at no entry creep ratio [m]."""
    last: list[Passage] = []

    def ratio(creep: float) -> tuple[float, float]:
        at = member.passage(entry, creep, last[-1].met if last else None, SHARP)
        last.append(at)
        return at.ratio, at.slopes.ratio_by_place

    end = LARGEST_RATIO * member.length
    return sloped_root(ratio, RATIO_SCALE * member.length, -end, end, 1e-2 * RATIO_SCALE)[0]


def _solved(member: Member, entry: Array, creep: Array) -> tuple[Array, Array]:
    """Exit tensions [N] and entry creep ratios of entry tensions and exit creeps, (n,) each."""
    arc, n = member.geometry, len(entry)
    block = Block(
        laws=laws_of([member.law], np.zeros(n, dtype=np.int64)),
        side=np.sign(creep),
        radius=np.full(n, arc.radius),
        length=np.full(n, member.length),
        width=np.full(n, arc.width),
        compliance=np.full(n, member.compliance),
        shear=np.full(n, arc.shear),
        overrun_constant=np.full(n, arc.overrun_constant),
        overrun_coefficient=np.full(n, arc.overrun_coefficient),
    )
    one, none = np.ones(n), np.zeros(n)
    ends = Ends(one, none, entry, CREEP, creep, none * np.nan)
    with np.errstate(all="ignore"):
        used = block.laws.stress(block.shear, entry / block.area, 0.6 * creep).stress
        fall = 0.9 * used / entry * block.area * arc.wrap_angle
        fall = np.clip(fall, -_LARGEST_FALL, _LARGEST_FALL)
        at = first_courses(block, entry, entry * np.exp(-fall), creep, _MESHES[0])
        done = solved(block, ends, at, _FIRST_NEAR)
        met = done.met
        for elements in _MESHES[1:]:
            shares = spread(done.courses.shares, done.misfit, elements)
            done = solved(block, ends, on_mesh(done.courses, done.curves, shares), _NEAR)
            met = met & done.met
    exits = done.courses.tension[-1].copy()
    ratios = done.courses.ratio - block.compliance * done.courses.tension[0]
    for i in np.flatnonzero(~met).tolist():
        alone = member.passage(float(entry[i]), float(creep[i]), None, SHARP)
        exits[i], ratios[i] = alone.exit, alone.ratio
    return exits, ratios


def _through(at: Array, values: Array, wanted: Array) -> Array:
    """Lagrange's polynomials through the nodes around each place wanted; the nodes rise."""
    points = _RATIO_POINTS
    first = np.clip(np.searchsorted(at, wanted) - points // 2, 0, len(at) - points)
    near = first[:, None] + np.arange(points)
    total = np.zeros(len(wanted))
    for i in range(points):
        weight = np.ones(len(wanted))
        for j in range(points):
            if i != j:
                weight *= (wanted - at[near[:, j]]) / (at[near[:, i]] - at[near[:, j]])
        total += weight * values[near[:, i]]
    return total


@dataclass(frozen=True, eq=False)
class PassageTable:
    """One pulley of a train, for a law that rises from zero friction.

    Attributes
    ----------
    start, step
        First asinh(g/1e-5) and first ln(entry tension), and their steps [-].
    values
        ln(exit over entry tension) [-] and exit creep [m], (2, ratios, tensions).
    """

    start: tuple[float, float]
    step: tuple[float, float]
    values: Array

    @classmethod
    def of(cls, member: Member, lowest: float, highest: float) -> PassageTable:
        """Tabulate a pulley for entry tensions from `lowest` to `highest` [N]."""
        end = asinh(LARGEST_RATIO / RATIO_SCALE)
        half = int(end / _RATIO_STEP) + 1
        ratios = np.linspace(-end, end, 2 * half + 1)
        parts = max(_TENSION_POINTS, int(log(highest / lowest) / _TENSION_STEP) + 2)
        logs = np.linspace(log(lowest), log(highest), parts)
        steps = (float(ratios[1] - ratios[0]), float(logs[1] - logs[0]))
        return cls((float(ratios[0]), float(logs[0])), steps, _passages(member, logs, ratios))

    def exit_log(self, entry_log: Array, ratio: Array) -> Array:
        """ln(exit tension) for ln(entry tension) and the entry creep ratio; arrays of one shape."""
        return entry_log + self._at(0, entry_log, ratio)

    def creep(self, entry_log: Array, ratio: Array) -> Array:
        """Exit creep [m]."""
        return self._at(1, entry_log, ratio)

    def _at(self, which: int, entry_log: Array, ratio: Array) -> Array:
        table = self.values[which]
        place = np.arcsinh(np.clip(ratio, -LARGEST_RATIO, LARGEST_RATIO) / RATIO_SCALE)
        first, weights = _weights(place, self.start[0], self.step[0], len(table), _RATIO_POINTS)
        other, factors = _weights(
            entry_log, self.start[1], self.step[1], table.shape[1], _TENSION_POINTS
        )
        total = np.zeros(np.shape(entry_log))
        for i, weight in enumerate(weights):
            line = np.zeros_like(total)
            for j, factor in enumerate(factors):
                line += factor * table[first + i, other + j]
            total += weight * line
        return total


def _weights(at: Array, start: float, step: float, count: int, points: int) -> tuple[Places, Array]:
    """First node and weights of the Lagrange polynomial through `points` even nodes around `at`."""
    place = (at - start) / step
    first = np.clip(np.floor(place).astype(np.intp) - (points // 2 - 1), 0, count - points)
    local = place - first
    weights = np.ones((points, *np.shape(at)))
    for i in range(points):
        for j in range(points):
            if i != j:
                weights[i] *= (local - j) / (i - j)
    return first, weights
