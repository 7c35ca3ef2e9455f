"""Sobol points without SciPy: evenly spread, the same on every machine."""

from __future__ import annotations

import numpy as np

from wraparc.arrays import Array

#: Primitive polynomials over GF(2), their degree and inner coefficients as bits, and first
#: direction numbers of the dimensions after the first (S. Joe and F. Y. Kuo, SIAM J. Sci. Comput.
#: 30 (2008) 2635, new-joe-kuo-6.21201).
_DIRECTIONS: tuple[tuple[int, int, tuple[int, ...]], ...] = (
    (1, 0, (1,)),
    (2, 1, (1, 3)),
    (3, 1, (1, 3, 1)),
    (3, 2, (1, 1, 1)),
    (4, 1, (1, 1, 3, 3)),
    (4, 4, (1, 3, 5, 13)),
    (5, 2, (1, 1, 5, 5, 17)),
    (5, 4, (1, 1, 5, 5, 5)),
    (5, 7, (1, 1, 7, 11, 19)),
    (5, 11, (1, 1, 5, 1, 1)),
    (5, 13, (1, 1, 1, 3, 11)),
    (5, 14, (1, 3, 5, 5, 31)),
    (6, 1, (1, 3, 3, 9, 7, 49)),
    (6, 13, (1, 1, 1, 15, 21, 21)),
    (6, 16, (1, 3, 1, 13, 27, 49)),
    (6, 19, (1, 1, 1, 15, 7, 5)),
    (6, 22, (1, 3, 1, 15, 13, 25)),
    (6, 25, (1, 1, 5, 5, 19, 61)),
    (7, 1, (1, 3, 7, 11, 23, 15, 103)),
    (7, 4, (1, 3, 7, 13, 13, 15, 69)),
)
#: Dimensions that there are numbers for, and bits of a point.
MOST_DIMENSIONS, _BITS = len(_DIRECTIONS) + 1, 30


def sobol_points(dimensions: int, count: int) -> Array:
    """Return the first Sobol points of the unit cube, the origin among them.

    Parameters
    ----------
    dimensions
        At most `MOST_DIMENSIONS`.
    count
        Of points, a power of 2: each dimension then has one in every interval of 1/count.

    Returns
    -------
    Points, shape (count, dimensions) [-].
    """
    index = np.arange(count, dtype=np.int64)
    gray = index ^ (index >> 1)
    points = np.zeros((count, dimensions), dtype=np.int64)
    for k in range(dimensions):
        numbers = _numbers(k)
        for bit in range(max(count - 1, 1).bit_length()):
            points[:, k] ^= np.where((gray >> bit) & 1 == 1, numbers[bit], 0)
    return points / float(1 << _BITS)


def shifted_points(dimensions: int, count: int, seed: int) -> Array:
    """Return Sobol points moved by one random vector, none of them 0; shape (count, dimensions).

    Dimensions beyond `MOST_DIMENSIONS` are shuffled midpoints of equal intervals.
    """
    rng = np.random.default_rng(seed)
    known = min(dimensions, MOST_DIMENSIONS)
    points = np.empty((count, dimensions))
    shift = rng.integers(0, 1 << _BITS, known)
    bits = (sobol_points(known, count) * float(1 << _BITS)).astype(np.int64)
    points[:, :known] = ((bits ^ shift) + 0.5) / float(1 << _BITS)
    for k in range(known, dimensions):
        points[:, k] = (rng.permutation(count) + 0.5) / count
    return points


def _numbers(dimension: int) -> list[int]:
    """Return the direction numbers of a dimension, as whole numbers of `_BITS` bits."""
    if dimension == 0:
        return [1 << (_BITS - 1 - i) for i in range(_BITS)]
    degree, inner, first = _DIRECTIONS[dimension - 1]
    numbers = [m << (_BITS - 1 - i) for i, m in enumerate(first)]
    for i in range(degree, _BITS):
        new = numbers[i - degree] ^ (numbers[i - degree] >> degree)
        for k in range(1, degree):
            if (inner >> (degree - 1 - k)) & 1:
                new ^= numbers[i - k]
        numbers.append(new)
    return numbers
