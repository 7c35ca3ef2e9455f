"""Gross slip of many arcs: ln(tight/slack) with one friction of a law everywhere, by quadrature.

d ln T/d theta = -mu(p) along the arc, so that angles are differences of one function of the
pressure, Theta(p) = int d ln p/mu(p): known at the edges of pressure of a law once for all its
rows, from there on by Gauss's rule.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch.traction import Laws

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(12)
ANYWHERE = 1e5  # an edge for laws that have none [Pa]
ROUNDS, NEAR = 40, 1e-13


def ratio_at_gross_slip(laws: Laws, top: Array, wrap: Array, *, residual: bool = False) -> Array:
    """ln(tight/slack) that friction carries, shape (n,) [-].

    Parameters
    ----------
    laws
        Their laws.
    top
        Wrap pressure at the tight side, shape (n,) [Pa].
    wrap
        Wrap angle, shape (n,) [rad].
    residual
        Whether with the friction that is left at slips without bound; else with the largest.
    """
    angles, friction = _Angles.of(laws, residual), laws.residual if residual else laws.plateau
    wanted = angles.at(top, friction) - wrap
    cell = np.zeros(len(top), dtype=np.int64)
    for angle in angles.angle[1:]:
        cell += wanted >= angle[angles.law]
    low, short = angles.edge[cell, angles.law], wanted - angles.angle[cell, angles.law]
    x = short * friction(low)
    done = np.zeros(len(top), dtype=bool)
    for _ in range(ROUNDS):
        change = (short - _integral(low, x, friction)) * friction(low * np.exp(x))
        # a row keeps what it had when it was done, whatever it is solved with
        x = np.where(done, x, x + change)
        done |= ~(np.abs(change) > NEAR * np.maximum(np.abs(x), 1.0))
        if done.all():
            break
    return np.log(top / low) - x


def breaks_away(laws: Laws, top: Array, wrap: Array, fall: Array) -> Flags:
    """Whether the largest friction carries no such fall of ln T from the tight side, shape (n,)."""
    angles = _Angles.of(laws, False)
    needed = angles.at(top, laws.plateau) - angles.at(top * np.exp(-fall), laws.plateau)
    return np.asarray(needed >= wrap)


class _Angles(NamedTuple):
    """Theta at the edges of pressure of laws.

    Attributes
    ----------
    law
        Place of the law of each row, shape (n,).
    edge, angle
        Edges, and Theta there, shape (edges, laws) [Pa, rad]; inf where there is none.
    """

    law: Integers
    edge: Array
    angle: Array

    @classmethod
    def of(cls, laws: Laws, residual: bool) -> _Angles:
        """Those of the laws of some rows."""
        _, first, law = np.unique(laws.row, return_index=True, return_inverse=True)
        each = laws.rows(first)
        edge = np.sort(each.edges(), axis=0)
        edge[0] = np.where(np.isfinite(edge[0]), edge[0], ANYWHERE)
        angle = np.zeros_like(edge)
        for k in range(1, len(edge)):
            x = np.log(edge[k] / edge[k - 1])
            part = _integral(edge[k - 1], x, each.residual if residual else each.plateau)
            angle[k] = np.where(np.isfinite(x), angle[k - 1] + part, np.inf)
        return cls(law, edge, angle)

    def at(self, pressure: Array, friction: Callable[[Array], Array]) -> Array:
        """Theta at pressures of the rows."""
        cell = np.zeros(len(pressure), dtype=np.int64)
        for edge in self.edge[1:]:
            cell += pressure >= edge[self.law]
        low = self.edge[cell, self.law]
        return self.angle[cell, self.law] + _integral(low, np.log(pressure / low), friction)


def _integral(low: Array, x: Array, friction: Callable[[Array], Array]) -> Array:
    """Integral of 1/mu over ln p, from a pressure on."""
    at = low * np.exp(x * (0.5 + 0.5 * _POINTS[:, None]))
    # one after the other: a sum in pairs would depend on how many rows there are
    return np.asarray(0.5 * x * reduce(np.add, _WEIGHTS[:, None] / friction(at)))
