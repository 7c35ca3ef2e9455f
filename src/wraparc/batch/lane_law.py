"""Integral-log laws for the lane kernel: cells of pressure with cubics in them, in one flat table.

Laws by knots are taken over as they are. Laws by trend lines are sampled, finely enough for
`SAMPLED_WITHIN`. A law's row is a head, `BUCKETS` numbers that say in which cell (or just before
which) each equal part of its pressures begins, and its cells.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from wraparc.batch.laws import LawBank
from wraparc.friction.compact import KNOT_STRIDE, KNOTS, PIECES, CompactLaw, peak, tail

Array = NDArray[np.float64]

HEAD = 3  # first edge, last edge [Pa], buckets per pascal
BUCKETS = 128
#: numbers of a cell: where it begins and ends, and cubics: of peak slip and peak friction, of the
#: slope past the peak and the residual friction
CELL = 18
FRICTION_CUBIC, SLOPE_CUBIC, RESIDUAL_CUBIC = 6, 10, 14  # where they begin
FIRST_CELL = HEAD + BUCKETS
SAMPLED_WITHIN = 1e-6  # relative error allowed in sampling trend lines
MOST_CELLS = 64  # of a piece of a law by trend lines
#: jumps at the edge of a cell, of d ln/d ln p and of p^2 d2/dp2 over the value
SHARP_SLOPE, SHARP_CURVATURE = 0.02, 2.0


@dataclass(frozen=True, eq=False)
class LaneLaws:
    """The table of a bank.

    Attributes
    ----------
    numbers
        Rows one after the other.
    row
        Where the row of each law begins, -1 for a law that is not in the table: of another kind
        than integral-log, with knots too near each other, or with trend lines that meet at an
        angle, shape (m,).
    kinked
        Whether cells meet so sharply that a coarse mesh would feel it.
    """

    numbers: Array
    row: NDArray[np.int64]
    kinked: NDArray[np.bool_]

    @classmethod
    def of(cls, bank: LawBank) -> LaneLaws:
        """Return the table of a bank."""
        rows = [_row(bank.compact(i)) for i in range(len(bank))]
        sizes = np.array([len(row) for row in rows], dtype=np.int64)
        starts = np.cumsum(sizes) - sizes
        numbers = np.concatenate([*rows, np.zeros(FIRST_CELL + CELL)])
        kinked = np.array([len(row) > 0 and _kinked(row) for row in rows], dtype=bool)
        return cls(numbers, np.where(sizes > 0, starts, -1), kinked)


def _row(law: CompactLaw) -> Array:
    """Row of one law; empty if there is none."""
    found = _cells(law)
    if found is None:
        return np.empty(0)
    edges, cubics = found
    low, high = edges[0], edges[-1]
    begins = low + (high - low) * np.arange(BUCKETS) / BUCKETS
    cell = np.clip(np.searchsorted(edges, begins, side="right") - 1, 0, len(edges) - 2)
    following = np.append(cell[1:], len(edges) - 2)
    if np.any(following - cell > 1):
        return np.empty(0)
    cells = np.column_stack([edges[:-1], edges[1:], cubics])
    if _sharpest(cells)[0] > SHARP_SLOPE:
        return np.empty(0)
    return np.concatenate([[low, high, BUCKETS / (high - low)], cell.astype(float), cells.ravel()])


def _kinked(row: Array) -> bool:
    """Whether peak slip or friction bends sharply over ln p where cells meet."""
    return _sharpest(row[FIRST_CELL:].reshape(-1, CELL))[1] > SHARP_CURVATURE


def _sharpest(cells: Array) -> tuple[float, float]:
    """Largest jumps of first and second derivatives where cells meet, see `_bends`."""
    width = cells[:, 1] - cells[:, 0]
    jumps = [(0.0, 0.0)]
    for c in (cells[:, 2:6], cells[:, 6:10]):
        leaving = _bends(c[:-1], width[:-1], cells[:-1, 1])
        entering = _bends(c[1:], 0.0 * width[1:], cells[1:, 0])
        jumps += zip(*(np.abs(b - a) for a, b in zip(leaving, entering, strict=True)), strict=True)
    slopes, curvatures = zip(*jumps, strict=True)
    return float(max(slopes)), float(max(curvatures))


def _bends(c: Array, t: Array, p: Array) -> tuple[Array, Array]:
    """Derivatives over the value, p d/dp and p^2 d2/dp2."""
    value, slope = _value_and_slope(c, t)
    return p * slope / value, p * p * (2.0 * c[:, 2] + 6.0 * c[:, 3] * t) / value


def _value_and_slope(c: Array, t: Array) -> tuple[Array, Array]:
    value = c[:, 0] + t * (c[:, 1] + t * (c[:, 2] + t * c[:, 3]))
    return value, c[:, 1] + t * (2.0 * c[:, 2] + 3.0 * t * c[:, 3])


def _cells(law: CompactLaw) -> tuple[Array, Array] | None:
    """Edges and cubics of one law, shapes (n,) and (n - 1, 16); None if it is of another kind."""
    edges, c = np.array(law.edges), np.array(law.coefficients)
    if law.kind == KNOTS:
        if len(edges) == 0:
            # one law for all pressures; the top is far above any
            return np.array([1.0, 1e15]), c[:16].reshape(1, 16)
        return edges, c.reshape(-1, KNOT_STRIDE)
    if law.kind != PIECES:
        return None
    parts = [_sampled(law, i) for i in range(len(edges) - 1)]
    if any(p is None for p in parts):
        return None
    found = [p for p in parts if p is not None]
    lower_edges = np.concatenate([*(p[0][:-1] for p in found), edges[-1:]])
    return lower_edges, np.concatenate([p[1] for p in found])


def _sampled(law: CompactLaw, piece: int) -> tuple[Array, Array] | None:
    """Hermite cells of one piece of trend lines, as many as the accuracy asks for."""
    n = 2
    while n <= MOST_CELLS:
        p = np.linspace(law.edges[piece], law.edges[piece + 1], n + 1)
        values = [np.array([of(law, piece, float(v)) for v in p]) for of in (peak, tail)]
        cells = np.concatenate(
            [_hermite(p, v[:, k], v[:, k + 2]) for v in values for k in (0, 1)], axis=1
        )
        middle = 0.5 * (p[1:] + p[:-1])
        truth = np.array([peak(law, piece, float(v))[:2] for v in middle])
        t = 0.5 * np.diff(p)
        for_slip = cells[:, 0] + t * (cells[:, 1] + t * (cells[:, 2] + t * cells[:, 3]))
        for_friction = cells[:, 4] + t * (cells[:, 5] + t * (cells[:, 6] + t * cells[:, 7]))
        worst = np.max(np.abs(np.stack([for_slip, for_friction], axis=1) / truth - 1.0))
        if worst < SAMPLED_WITHIN:
            return p, cells
        n *= 2
    return None


def _hermite(x: Array, y: Array, slope: Array) -> Array:
    h = np.diff(x)
    d = np.diff(y) / h
    c2 = (3.0 * d - 2.0 * slope[:-1] - slope[1:]) / h
    c3 = (slope[:-1] + slope[1:] - 2.0 * d) / h**2
    return np.stack([y[:-1], slope[:-1], c2, c3], axis=1)
