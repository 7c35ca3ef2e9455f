"""What a study varies, and how: every design by its index."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.study.distributions import Distribution
from wraparc.study.sampling import Random, Sampling, Sobol
from wraparc.units import Dimension

#: Values of designs by column, numbers in SI; words by their place in the list of the axis.
Values = Mapping[str, Array]


@dataclass(frozen=True, kw_only=True)
class Levels:
    """A field at some values, every one combined with everything else.

    Attributes
    ----------
    field
        Its key path in the drive file.
    values
        Numbers [SI], words or truth values.
    dimension
        What it measures, or None for words and truth values.
    """

    field: str
    values: tuple[float, ...] | tuple[str, ...] | tuple[bool, ...]
    dimension: Dimension | None = None

    @property
    def numeric(self) -> bool:
        """Whether the values are numbers."""
        return self.dimension is not None

    def at(self, place: Integers) -> Array:
        """Values at places in the list; the places themselves for words."""
        if not self.numeric:
            return place.astype(float)
        return np.array(self.values, dtype=float)[place]


class Drawn(ABC):
    """Something drawn at random, from one number in (0, 1) or several."""

    @property
    @abstractmethod
    def columns(self) -> dict[str, Dimension]:
        """Names of the columns it makes, each with what it measures."""

    @property
    @abstractmethod
    def dimensions(self) -> int:
        """How many numbers it takes."""

    @abstractmethod
    def draw(self, points: Array) -> dict[str, Array]:
        """Columns from points of the unit cube, shape (n, dimensions)."""


@dataclass(frozen=True, kw_only=True)
class DrawnField(Drawn):
    """A field drawn from a distribution.

    Attributes
    ----------
    field
        Its key path in the drive file, and the name of its column.
    distribution
        The distribution [SI].
    dimension
        What it measures.
    """

    field: str
    distribution: Distribution
    dimension: Dimension

    @property
    def columns(self) -> dict[str, Dimension]:
        """The field."""
        return {self.field: self.dimension}

    @property
    def dimensions(self) -> int:
        """One number."""
        return 1

    def draw(self, points: Array) -> dict[str, Array]:
        """Quantiles of the points."""
        return {self.field: self.distribution.quantile(points[:, 0])}


@dataclass(frozen=True, kw_only=True)
class Plan(ABC):
    """Designs by index.

    Attributes
    ----------
    levels
        Fields at given values, the last one changing fastest.
    drawn
        What is drawn at random.
    sampling
        How the draws are spread.
    samples
        Draws for every combination of levels: the same ones, so that levels are compared on equal
        terms. 1 where nothing is drawn.
    seed
        Of the draws.
    """

    levels: tuple[Levels, ...] = ()
    drawn: tuple[Drawn, ...] = ()
    sampling: Sampling = field(default_factory=Random)
    samples: int = 1
    seed: int = 0

    @property
    @abstractmethod
    def points(self) -> int:
        """Points of the unit cube for every combination of levels."""

    @abstractmethod
    def cube(self, start: int, stop: int) -> Array:
        """Points `start` to `stop` of the unit cube, shape (stop - start, dimensions)."""

    @property
    def combinations(self) -> int:
        """Combinations of the levels."""
        return math.prod(len(axis.values) for axis in self.levels)

    def __len__(self) -> int:
        return self.combinations * self.points

    @property
    def dimensions(self) -> int:
        """Numbers that a draw of everything takes."""
        return sum(axis.dimensions for axis in self.drawn)

    @property
    def quantities(self) -> dict[str, Dimension | None]:
        """What each column of the designs measures; None for words."""
        known: dict[str, Dimension | None] = {axis.field: axis.dimension for axis in self.levels}
        for drawn in self.drawn:
            known.update(drawn.columns)
        return known

    def combination(self, index: int) -> dict[str, int]:
        """Place in the list of each axis of levels, of one of the combinations."""
        shape = tuple(len(axis.values) for axis in self.levels)
        places = np.unravel_index(index, shape) if shape else ()
        return {axis.field: int(p) for axis, p in zip(self.levels, places, strict=True)}

    def values(self, start: int, stop: int) -> dict[str, Array]:
        """Columns of the designs `start` to `stop`."""
        index = np.arange(start, stop, dtype=np.int64)
        combination, point = np.divmod(index, self.points)
        columns: dict[str, Array] = {}
        shape = tuple(len(axis.values) for axis in self.levels)
        places = np.unravel_index(combination, shape) if shape else ()
        for axis, place in zip(self.levels, places, strict=True):
            columns[axis.field] = axis.at(place)
        return columns | (self._drawn_at(point) if self.drawn else {})

    def _drawn_at(self, point: Integers) -> dict[str, Array]:
        """Columns of what is drawn at points that follow each other, over and over."""
        if len(point) >= self.points:
            return {k: v[point] for k, v in self.draw(self.cube(0, self.points)).items()}
        turn = int(np.argmin(point)) if len(point) else 0
        runs = [run for run in (point[:turn], point[turn:]) if len(run)]
        cubes = [self.cube(int(run[0]), int(run[-1]) + 1) for run in runs]
        return self.draw(np.concatenate(cubes) if cubes else np.empty((0, self.dimensions)))

    def draw(self, cube: Array) -> dict[str, Array]:
        """Columns of what is drawn, from points of the unit cube."""
        columns: dict[str, Array] = {}
        place = 0
        for axis in self.drawn:
            columns |= axis.draw(cube[:, place : place + axis.dimensions])
            place += axis.dimensions
        return columns


@dataclass(frozen=True, kw_only=True)
class Sweep(Plan):
    """Every combination of the levels, with `samples` draws each."""

    @property
    def points(self) -> int:
        """The samples."""
        return self.samples if self.drawn else 1

    def cube(self, start: int, stop: int) -> Array:
        """Points of the sampling."""
        return self.sampling.points(self.dimensions, self.samples, self.seed, start, stop)


@dataclass(frozen=True, kw_only=True)
class Saltelli(Plan):
    """Two samples A and B, and for every axis that is drawn A with that axis taken from B.

    The points come in blocks of `samples`: A, B, then one block for each axis.

    References
    ----------
    A. Saltelli and others, Comput. Phys. Commun. 181 (2010) 259.
    """

    sampling: Sampling = field(default_factory=Sobol)

    @property
    def points(self) -> int:
        """Samples (axes + 2)."""
        return self.samples * (len(self.drawn) + 2)

    def cube(self, start: int, stop: int) -> Array:
        """Points of A, B and the mixed blocks."""
        size, d = self.samples, self.dimensions
        parts = []
        for block in range(start // size, (stop - 1) // size + 1):
            low, high = max(start - block * size, 0), min(stop - block * size, size)
            both = self.sampling.points(2 * d, size, self.seed, low, high)
            a, b = both[:, :d], both[:, d:]
            if block >= 2:
                own = self._own(block - 2)
                a = a.copy()
                a[:, own] = b[:, own]
            parts.append(b if block == 1 else a)
        return np.concatenate(parts) if parts else np.empty((0, d))

    def _own(self, axis: int) -> slice:
        begin = sum(a.dimensions for a in self.drawn[:axis])
        return slice(begin, begin + self.drawn[axis].dimensions)
