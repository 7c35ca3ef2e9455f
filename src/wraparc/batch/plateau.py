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
        """Per law: ln p at points, angle there, 1/friction there; shapes (m, k)."""
        rows = np.flatnonzero(self.table.row >= 0)
        size = len(self.table.row)
        logs = np.zeros((size, self.parts + 1))
        angles, slopes = np.zeros_like(logs), np.ones_like(logs)
        for i in rows:
            low, high, edges, cubics = _law(self.table, int(self.table.row[i]))
            x = np.linspace(np.log(low), np.log(high), self.parts + 1)
            ends = np.union1d(x, np.log(edges[1:-1]))
            h = np.diff(ends)[:, None]
            at = np.exp(0.5 * (ends[1:] + ends[:-1])[:, None] + 0.5 * h * _NODES)
            angle = (0.5 * h * _WEIGHTS / _friction(edges, cubics, at)).sum(axis=1)
            taken = np.concatenate([[0.0], np.cumsum(angle)])
            logs[i], angles[i] = x, taken[np.searchsorted(ends, x)]
            slopes[i] = 1.0 / _friction(edges, cubics, np.clip(np.exp(x), low, high))
        return logs, angles, slopes

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

    def finely(self, i: int, start: Array, angle: Array) -> tuple[Array, Array]:
        """`capacity` of one law by knots to 1e-9, and friction at its end over that at its start.

        Parameters
        ----------
        i
            The law, in the table.
        start
            Logarithm of the wrap pressure at the entry, shape (n,).
        angle
            phi [rad].
        """
        tables = tuple(t[i] for t in self._tables)
        logs, angles, slopes = tables
        high = logs[-1]
        above = np.maximum(start - high, 0.0)
        within, first = _cubic(tables, start)
        left = within - angle + np.expm1(above) * slopes[-1]
        left += np.minimum(start - logs[0], 0.0) * slopes[0]
        end = np.interp(left, angles, logs)
        within, last = _cubic(tables, end)
        # one step of Newton's method
        end = end - (within - np.clip(left, 0.0, angles[-1])) / last
        beyond = np.log1p(np.maximum(left - angles[-1], 0.0) / slopes[-1])
        end = end + beyond + np.minimum(left, 0.0) / slopes[0]
        return start - end, np.exp(above - beyond) * first / last

    def _of_law(self, i: int, start: Array, angle: Array) -> Array:
        logs, angles, slopes = (t[i] for t in self._tables)
        low, high, mu_low, mu_high = logs[0], logs[-1], 1.0 / slopes[0], 1.0 / slopes[-1]
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


def _cubic(tables: tuple[Array, ...], at: Array) -> tuple[Array, Array]:
    """Cubic between the equidistant points of a table with slopes, its ends beyond them."""
    x, y, slope = tables
    h = (x[-1] - x[0]) / (len(x) - 1)
    place = np.clip((at - x[0]) / h, 0.0, len(x) - 1.0)
    k = np.minimum(place.astype(np.int64), len(x) - 2)
    t, y0 = place - k, y[k]
    rise = y[k + 1] - y0
    d0, d1 = h * slope[k] - rise, h * slope[k + 1] - rise
    bow = d0 - t * (d0 + d1)
    value = y0 + t * (rise + (1.0 - t) * bow)
    return value, (rise + (1.0 - 2.0 * t) * bow - t * (1.0 - t) * (d0 + d1)) / h


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
