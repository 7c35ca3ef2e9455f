"""Gross-slip capacity of laws that are flat past their peak, for many arcs at once.

With the friction of the plateau everywhere d(theta) = d(ln p) / mu_pk(p) along a driving pulley, so
that the wrap angle is a difference of one function of pressure, tabulated once for a law.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from wraparc.batch.lane_law import CELL, FIRST_CELL, HEAD, LaneLaws

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

PARTS = 1024  # of a law's range of ln p
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


class Plateaus:
    """Angle as a function of ln p for every law of a table."""

    def __init__(self, table: LaneLaws, parts: int = PARTS) -> None:
        self.table, self.parts = table, parts

    @cached_property
    def _tables(self) -> tuple[Array, Array, Array]:
        """Per law: ln p at points, angle there, friction at both ends; shapes (m, k), (m, 2)."""
        rows = np.flatnonzero(self.table.row >= 0)
        size = len(self.table.row)
        logs = np.zeros((size, self.parts + 1))
        angles, ends = np.zeros_like(logs), np.ones((size, 2))
        for i in rows:
            low, high, edges, cubics = _law(self.table, int(self.table.row[i]))
            x = np.linspace(np.log(low), np.log(high), self.parts + 1)
            h = np.diff(x)[:, None]
            at = np.exp(0.5 * (x[1:] + x[:-1])[:, None] + 0.5 * h * _NODES)
            angle = (0.5 * h * _WEIGHTS / _friction(edges, cubics, at)).sum(axis=1)
            logs[i], angles[i, 1:] = x, np.cumsum(angle)
            ends[i] = _friction(edges, cubics, np.array([low, high]))
        return logs, angles, ends

    def capacity(self, law: Integers, pressure: Array, wrap_angle: Array) -> Array:
        """ln(T1/T2) at gross slip of driving arcs with their entry pressure held, shape (n,) [-].

        Parameters
        ----------
        law
            Law of each arc, in the table.
        pressure
            Wrap pressure at the entry [Pa].
        wrap_angle
            phi [rad].
        """
        result = np.full(len(law), np.nan)
        for i in np.unique(law[self.table.row[law] >= 0]):
            which = law == i
            result[which] = self._of_law(int(i), np.log(pressure[which]), wrap_angle[which])
        return result

    def _of_law(self, i: int, start: Array, angle: Array) -> Array:
        logs, angles, ends = (t[i] for t in self._tables)
        low, high, (mu_low, mu_high) = logs[0], logs[-1], ends
        # angle from the pressure to the bottom of the range; above it p mu is held, below it mu
        within = np.interp(start, logs, angles)
        above = np.expm1(np.maximum(start - high, 0.0)) / mu_high
        below = np.minimum(start - low, 0.0) / mu_low
        left = within + above + below - angle
        end = np.where(
            left >= 0.0,
            np.interp(left, angles, logs) + np.log1p(np.maximum(left - angles[-1], 0.0) * mu_high),
            low + left * mu_low,
        )
        return np.asarray(start - end)


def _law(table: LaneLaws, row: int) -> tuple[float, float, Array, Array]:
    low, high = table.numbers[row], table.numbers[row + 1]
    edges, cubics = [low], []
    o = row + HEAD + (FIRST_CELL - HEAD)
    while edges[-1] < high:
        cell = table.numbers[o : o + CELL]
        edges.append(cell[1])
        cubics.append(cell[6:10])
        o += CELL
    return float(low), float(high), np.array(edges), np.array(cubics)


def _friction(edges: Array, cubics: Array, p: Array) -> Array:
    i = np.clip(np.searchsorted(edges, p, side="right") - 1, 0, len(cubics) - 1)
    t, c = p - edges[i], cubics[i]
    mu: Array = c[..., 0] + t * (c[..., 1] + t * (c[..., 2] + t * c[..., 3]))
    return mu
