"""Gross slip of many arcs: ln(tight/slack) with one friction of a law everywhere, by quadrature."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from itertools import pairwise

import numpy as np

from wraparc.batch.traction import Array, Flags, Laws

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
PARTS = 2  # of ln T between two edges of pressure
ROUNDS, NEAR = 40, 1e-13
CLEAR = 0.8  # of the wrap angle: a first look that is less says enough


def ratio_at_gross_slip(
    laws: Laws, top: Array, wrap: Array, friction: Callable[[Array], Array]
) -> Array:
    """ln(tight/slack) that friction carries, shape (n,) [-].

    d ln T/d theta = -mu(p), so that the wrap angle is int dq/mu(p1 exp(-q)); Newton's method on it,
    piece by piece between the edges of pressure of the laws.

    Parameters
    ----------
    laws
        Their laws.
    top
        Wrap pressure at the tight side, shape (n,) [Pa].
    wrap
        Wrap angle, shape (n,) [rad].
    friction
        mu(p) of each row: `Laws.plateau` or `Laws.residual`.
    """
    edges = _falls(laws, top)
    q = wrap * friction(top)
    q = np.minimum(q, wrap * friction(top * np.exp(-0.5 * q)))
    done = np.zeros(len(q), dtype=bool)
    for _ in range(ROUNDS):
        angle = _angle(top, q, edges, friction)
        change = (wrap - angle) * friction(top * np.exp(-q))
        # a row keeps what it had when it was done, whatever it is solved with
        q = np.where(done, q, np.maximum(q + change, 0.1 * q))
        done |= np.abs(change) <= NEAR * q
        if done.all():
            break
    return q


def breaks_away(laws: Laws, top: Array, wrap: Array, fall: Array) -> Flags:
    """Whether the largest friction carries no such fall of ln T from the tight side, shape (n,).

    By the edges of pressure where one rule over all of the fall comes near to the wrap angle.
    """
    found = _angle(top, fall, np.empty((0, len(top))), laws.plateau) >= CLEAR * wrap
    near = np.flatnonzero(found)
    if len(near):
        some, top = laws.rows(near), top[near]
        found[near] = _angle(top, fall[near], _falls(some, top), some.plateau) >= wrap[near]
    return np.asarray(found)


def _falls(laws: Laws, top: Array) -> Array:
    """Falls of ln p from the tight side to each edge of pressure, >= 0."""
    return np.log(np.maximum(top / laws.edges(), 1.0))


def _angle(top: Array, q: Array, edges: Array, friction: Callable[[Array], Array]) -> Array:
    """Wrap angle over which ln T falls by q [rad]: Gauss's rule, 8 points a part of a piece.

    `edges` are the falls to the edges of pressure.
    """
    ends = np.sort(np.minimum(edges, q), axis=0)
    ends = np.concatenate([np.zeros((1, len(q))), ends, q[None]])
    # from the last that is nothing on, so that the pieces of most rows are few
    none = np.maximum((ends == 0.0).sum(axis=0) - 1, 0)
    place = np.minimum(np.arange(len(ends))[:, None] + none, len(ends) - 1)
    ends = np.take_along_axis(ends, place, 0)
    total = np.zeros(len(q))
    for low, high in pairwise(ends):
        width = high - low
        if not (width > 0.0).any():
            break
        part = width / PARTS
        at = low + part * (np.arange(PARTS)[:, None, None] + 0.5 + 0.5 * _NODES[:, None])
        angles = (_WEIGHTS[:, None] / friction(top * np.exp(-at))).reshape(-1, len(q))
        # one after the other: a sum in pairs would depend on how many rows there are
        total += 0.5 * part * reduce(np.add, angles)
    return total
