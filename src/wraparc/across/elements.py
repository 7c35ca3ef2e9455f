"""The arc in elements with Gauss points: how integrals along it come from values at points.

Three stages an element, so that what smooth elements end with is of sixth order. Friction is taken
at the friction points of an element and made a parabola there (the best one, by Legendre
polynomials). With three points they are the stages themselves, and the parabola goes through them:
Gauss collocation. Where friction has kinks, more points than stages meet them more closely, and
the system to solve stays as small.

Values at stages or points are arrays of shape (m, n) or (k, n), the first stage of all elements
first, then the second.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from wraparc.arrays import Array

_WEIGHTS = np.array([5.0, 8.0, 5.0]) / 18.0
_STAGES = 0.5 + np.sqrt(0.15) * np.array([-1.0, 0.0, 1.0])
#: elements are finer at the entry nip, where friction rises steeply with slip: s = L (i/E)^1.5
_GRADING = 1.5


def graded(length: float, count: int) -> Array:
    """Ends of elements from 0 to a length, finer at the entry nip [m]."""
    return length * np.linspace(0.0, 1.0, count + 1) ** _GRADING


def _legendre(x: Array) -> Array:
    """Legendre polynomials of degree 0 to 2 on 0 .. 1, shape (..., 3)."""
    z = 2.0 * x - 1.0
    return np.stack([np.ones_like(z), z, 1.5 * z**2 - 0.5], axis=-1)


def _risen(x: Array) -> Array:
    """Their integrals from 0 to x."""
    z = 2.0 * x - 1.0
    return 0.5 * np.stack([z + 1.0, 0.5 * (z**2 - 1.0), 0.5 * (z**3 - z)], axis=-1)


#: from values at the stages to the coefficients of the polynomials
_THROUGH = np.linalg.inv(_legendre(_STAGES))


@dataclass(frozen=True, eq=False)
class Elements:
    """An arc in elements.

    Attributes
    ----------
    nodes
        Ends of the elements, from 0 to L [m].
    fineness
        Parts of an element with three friction points each.
    """

    nodes: Array
    fineness: int = 1

    @cached_property
    def lengths(self) -> Array:
        """Length of each element [m]."""
        return np.diff(self.nodes)

    @cached_property
    def stages(self) -> Array:
        """Places of the stages, shape (m,) [m]."""
        return np.asarray((self.nodes[:-1] + np.outer(_STAGES, self.lengths)).ravel())

    @cached_property
    def points(self) -> Array:
        """Places of the friction points, shape (k,) [m]."""
        return np.asarray((self.nodes[:-1] + np.outer(self._shares, self.lengths)).ravel())

    def at_points(self, at_stages: Array) -> Array:
        """Values at the points of parabolas through those at the stages."""
        if self.fineness == 1:
            return at_stages
        return self._rows(_legendre(self._shares) @ _THROUGH, at_stages)

    def integral_at_points(self, at_stages: Array) -> Array:
        """Integrals from the entry to the points of values at the stages."""
        within = self._rows(_risen(self._shares) @ _THROUGH, at_stages)
        return self._summed(within, self._rows(_WEIGHTS[None, :], at_stages))

    def integral_at_stages(self, at_points: Array) -> Array:
        """Integrals from the entry to the stages of values at the points."""
        within = self._rows(_risen(_STAGES) @ self._projection, at_points)
        return self._summed(within, self._rows(self._weights[None, :], at_points))

    def total(self, at_points: Array) -> Array:
        """Integral over the arc of values at the points, shape (n,)."""
        return np.asarray(np.outer(self._weights, self.lengths).ravel() @ at_points)

    def total_of_stages(self, at_stages: Array) -> Array:
        """Integral over the arc of values at the stages, shape (n,)."""
        return np.asarray(np.outer(_WEIGHTS, self.lengths).ravel() @ at_stages)

    def integral(self, at_points: Array, places: Array) -> Array:
        """Integrals from the entry to places [m] of values at the points, shape (places, n)."""
        element = np.minimum(np.searchsorted(self.nodes[1:], places), len(self.lengths) - 1)
        share = (places - self.nodes[element]) / self.lengths[element]
        own = self.parabolas(at_points)
        before = np.cumsum(own[0], axis=0) - own[0]
        return np.asarray(before[element] + np.einsum("pi,ipn->pn", _risen(share), own[:, element]))

    def parabolas(self, at_points: Array) -> Array:
        """Legendre coefficients of the parabolas, times the lengths: shape (3, elements, n)."""
        own = self._rows(self._projection, at_points).reshape(3, len(self.lengths), -1)
        return np.asarray(own * self.lengths[:, None])

    def _rows(self, table: Array, values: Array) -> Array:
        """A table applied in every element to values at its stages or points."""
        n = values.shape[-1]
        return (table @ values.reshape(table.shape[1], -1)).reshape(-1, n)

    def _summed(self, within: Array, whole: Array) -> Array:
        """Integrals within the elements and over all before, from those over a unit length."""
        whole = whole * self.lengths[:, None]
        before = np.cumsum(whole, axis=0) - whole
        within = within.reshape(-1, *whole.shape) * self.lengths[:, None]
        return (within + before).reshape(-1, whole.shape[1])

    @cached_property
    def _shares(self) -> Array:
        """Friction points of an element, as shares of it."""
        parts = (np.arange(self.fineness)[:, None] + _STAGES) / self.fineness
        return np.asarray(parts.ravel())

    @cached_property
    def _weights(self) -> Array:
        return np.tile(_WEIGHTS / self.fineness, self.fineness)

    @cached_property
    def _projection(self) -> Array:
        """From values at the points of an element to the coefficients of the nearest parabola."""
        return (2.0 * np.arange(3.0)[:, None] + 1.0) * _legendre(self._shares).T * self._weights
