"""What leaves a pulley, tabulated over entry tension and effort: many answers at once.

Between the nodes of an even grid the table is interpolated by polynomials, of fifth order in effort
and third order in the logarithm of the entry tension.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asinh, exp, log

import numpy as np
from numpy.typing import NDArray

from wraparc.train.member import RATIO_SCALE, SHARP, Member

Array = NDArray[np.float64]
Places = NDArray[np.intp]

#: Entry creep ratio up to which a table goes, either way; a creep of 5 % of the wrap.
LARGEST_RATIO = 0.05
_EFFORT_STEP = 0.38
_TENSION_STEP = 0.25  # of the logarithm
_EFFORT_POINTS, _TENSION_POINTS = 6, 4


def _passages(member: Member, logs: Array, efforts: Array) -> Array:
    """Send the belt over a pulley once for each ln(entry tension) and effort, (n,) each.

    Returns ln(exit over entry tension) [-] and exit creep [m], (2, n).
    """
    found = np.empty((2, len(logs)))
    for i, (log_entry, effort) in enumerate(zip(logs, efforts, strict=True)):
        at = member.passage(exp(log_entry), float(effort), SHARP)
        found[:, i] = log(at.exit / at.entry), at.creep
    return found


@dataclass(frozen=True, eq=False)
class PassageTable:
    """One pulley of a train, for a law that rises from zero friction.

    Attributes
    ----------
    start, step
        First effort and first ln(entry tension), and their steps [-].
    values
        ln(exit over entry tension) [-] and exit creep [m], (2, efforts, tensions).
    """

    start: tuple[float, float]
    step: tuple[float, float]
    values: Array

    @classmethod
    def of(cls, member: Member, lowest: float, highest: float) -> PassageTable:
        """Tabulate a pulley for entry tensions from `lowest` to `highest` [N]."""
        end = asinh(LARGEST_RATIO / RATIO_SCALE)
        half = int(end / _EFFORT_STEP) + 1
        efforts = np.linspace(-end, end, 2 * half + 1)
        parts = max(_TENSION_POINTS, int(log(highest / lowest) / _TENSION_STEP) + 2)
        logs = np.linspace(log(lowest), log(highest), parts)
        places = np.meshgrid(efforts, logs, indexing="ij")
        found = _passages(member, places[1].ravel(), places[0].ravel())
        values = found.reshape(2, len(efforts), len(logs))
        steps = (float(efforts[1] - efforts[0]), float(logs[1] - logs[0]))
        return cls((float(efforts[0]), float(logs[0])), steps, values)

    def exit_log(self, entry_log: Array, ratio: Array) -> Array:
        """ln(exit tension) for ln(entry tension) and the entry creep ratio; arrays of one shape."""
        return entry_log + self._at(0, entry_log, ratio)

    def creep(self, entry_log: Array, ratio: Array) -> Array:
        """Exit creep [m]."""
        return self._at(1, entry_log, ratio)

    def _at(self, which: int, entry_log: Array, ratio: Array) -> Array:
        table = self.values[which]
        effort = np.arcsinh(np.clip(ratio, -LARGEST_RATIO, LARGEST_RATIO) / RATIO_SCALE)
        first, weights = _weights(effort, self.start[0], self.step[0], len(table), _EFFORT_POINTS)
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
