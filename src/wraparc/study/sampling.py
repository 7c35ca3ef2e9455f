"""Points of the unit cube by their index: any part of a sample is made without the rest.

So every chunk of a study is self-describing, and the same numbers come out however it is cut.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array
from wraparc.errors import MissingExtraError

Words = NDArray[np.uint64]

_PER_COUNTER = 4  # numbers that Philox makes for one step of its counter
_ROUNDS = 8
_SMALLEST = 2.0**-54


class Sampling(ABC):
    """A way to spread points; `name` is what a study file calls it."""

    name: str

    @abstractmethod
    def points(self, dimensions: int, count: int, seed: int, start: int, stop: int) -> Array:
        """Points `start` to `stop` of a sample.

        Parameters
        ----------
        dimensions
            Of the unit cube.
        count
            Points of the whole sample.
        seed
            Any whole number >= 0: the same seed gives the same sample.
        start, stop
            Which points, 0 <= start <= stop <= count.

        Returns
        -------
        numpy.ndarray
            Points inside the open unit cube, shape (stop - start, dimensions).
        """


@dataclass(frozen=True)
class Random(Sampling):
    """Independent points (plain Monte Carlo), by the counter-based generator Philox.

    Every dimension has a stream of its own: another axis changes none of the others. The first
    points of a larger sample are those of a smaller one.
    """

    name = "random"

    def points(self, dimensions: int, count: int, seed: int, start: int, stop: int) -> Array:
        """Points `start` to `stop`."""
        return _columns(stop - start, [_stream(seed, k, start, stop) for k in range(dimensions)])


@dataclass(frozen=True)
class LatinHypercube(Sampling):
    """In every dimension one point in each of `count` equal intervals, at a random place in it.

    The intervals are shuffled by a keyed permutation that is computed by index (a Feistel network
    with cycle walking), so that no list of all points is ever made.

    References
    ----------
    M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979) 239; J. Black and P. Rogaway,
    "Ciphers with arbitrary finite domains", CT-RSA 2002.
    """

    name = "latin-hypercube"

    def points(self, dimensions: int, count: int, seed: int, start: int, stop: int) -> Array:
        """Points `start` to `stop`."""
        index = np.arange(start, stop, dtype=np.uint64)
        columns = []
        for k in range(dimensions):
            keys = (
                np.random.SeedSequence((seed, k, 1))
                .generate_state(_ROUNDS, np.uint64)
                .astype(np.uint64)
            )
            interval = _permuted(index, count, keys).astype(float)
            columns.append((interval + _stream(seed, k, start, stop)) / count)
        return _columns(stop - start, columns)


@dataclass(frozen=True)
class Sobol(Sampling):
    """Scrambled Sobol points: fill the cube evenly; best with a power of 2 of them.

    References
    ----------
    `scipy.stats.qmc.Sobol`; S. Joe and F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635.
    """

    name = "sobol"

    def points(self, dimensions: int, count: int, seed: int, start: int, stop: int) -> Array:
        """Points `start` to `stop`."""
        try:
            from scipy.stats import qmc
        except ImportError as error:
            raise MissingExtraError("scipy", "study") from error
        if not dimensions or stop == start:
            return np.empty((stop - start, dimensions))
        made = qmc.Sobol(dimensions, scramble=True, rng=np.random.default_rng(seed))
        wanted = stop - start
        if start:
            made.fast_forward(start)
        else:  # the first call warns of any other number than a power of 2
            wanted = 1 << (wanted - 1).bit_length()
        points: Array = np.asarray(made.random(wanted), dtype=float)[: stop - start]
        inside: Array = np.clip(points, _SMALLEST, 1.0 - 2.0 * _SMALLEST)
        return inside


#: by the name in a study file
SAMPLINGS: dict[str, Sampling] = {s.name: s for s in (Random(), LatinHypercube(), Sobol())}


def _columns(rows: int, columns: list[Array]) -> Array:
    return np.stack(columns, axis=1) if columns else np.empty((rows, 0))


def _stream(seed: int, dimension: int, start: int, stop: int) -> Array:
    """Numbers `start` to `stop` of the stream of a dimension, in the open interval (0, 1)."""
    key = np.random.SeedSequence((seed, dimension)).generate_state(2, np.uint64)
    first = start // _PER_COUNTER
    made = np.random.Generator(np.random.Philox(key=key, counter=first))
    skipped = first * _PER_COUNTER
    numbers: Array = made.random(stop - skipped)[start - skipped :]
    return numbers + _SMALLEST


def _permuted(index: Words, count: int, keys: Words) -> Words:
    """Place of each index in a keyed permutation of 0 .. count - 1."""
    half = np.uint64(max(1, ((count - 1).bit_length() + 1) // 2))
    place = _feistel(index, half, keys)
    while len(outside := np.flatnonzero(place >= count)):
        place[outside] = _feistel(place[outside], half, keys)
    return place


def _feistel(index: Words, half: np.uint64, keys: Words) -> Words:
    """A permutation of the numbers of 2 * half bits."""
    mask = (np.uint64(1) << half) - np.uint64(1)
    left, right = index >> half, index & mask
    for key in keys:
        left, right = right, left ^ (_mixed(right + key) & mask)
    return (left << half) | right


def _mixed(word: Words) -> Words:
    """The finaliser of SplitMix64: every bit of the word stirs every bit of the result."""
    word = (word ^ (word >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    word = (word ^ (word >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return word ^ (word >> np.uint64(31))
