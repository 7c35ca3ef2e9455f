"""Gross slip of many arcs: ln(tight/slack) with one friction of a law everywhere, by quadrature."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from wraparc.batch.two_point import Array, Block

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
PARTS = 2  # of ln T between two edges of pressure
ROUNDS, NEAR = 40, 1e-13


def ratio_at_gross_slip(
    block: Block, tight: Array, friction: Callable[[Array], Array]
) -> Array:
    """ln(tight/slack) that friction carries, shape (n,) [-].

    d ln T/d theta = -mu(p), so that the wrap angle is int dq/mu(p1 exp(-q)); Newton's method on it,
    piece by piece between the edges of pressure of the laws.

    Parameters
    ----------
    block
        The arcs.
    tight
        Tension of the tight side [N].
    friction
        mu(p) of each row: `Laws.plateau` or `Laws.residual`.
    """
    top, wrap = tight / block.area, block.length / block.radius
    edges = np.log(np.maximum(top / block.laws.edges(), 1.0))  # falls of ln p to each edge
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


def wrap_needed(
    block: Block, tight: Array, fall: Array, friction: Callable[[Array], Array]
) -> Array:
    """Wrap angle over which ln T falls so far from the tight side, shape (n,) [rad]."""
    top = tight / block.area
    return _angle(top, fall, np.log(np.maximum(top / block.laws.edges(), 1.0)), friction)


def _angle(top: Array, q: Array, edges: Array, friction: Callable[[Array], Array]) -> Array:
    """`wrap_needed`, with the falls to each edge of pressure; Gauss's rule of 8 points a piece."""
    ends = np.sort(np.minimum(edges, q), axis=0)
    ends = np.concatenate([np.zeros((1, len(q))), ends, q[None]])
    total = np.zeros(len(q))
    for low, high in zip(ends[:-1], ends[1:], strict=True):
        width = high - low
        if not (width > 0.0).any():
            continue
        part = width / PARTS
        at = low + part * (np.arange(PARTS)[:, None, None] + 0.5 + 0.5 * _NODES[:, None])
        mean = (_WEIGHTS[:, None] / friction(top * np.exp(-at))).sum(axis=(0, 1))
        total += 0.5 * part * mean
    return total
