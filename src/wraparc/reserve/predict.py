"""Levels of many draws from the solved ones among them, where no limit is near."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.checks.check import Level

#: Part of the solved draws that a fit is made of; the others show how good it is [-].
_FITTED = 2.0 / 3.0
#: What a prediction may be off by, over the largest miss of the fit, and at least [-].
_SAFETY, _LEAST = 2.0, 2e-3
#: Logarithm of the used part of a limit that is far from it.
_FAR = 3.0


class Uses(NamedTuple):
    """What one check at one place uses of its limit in solved draws, shape (n,).

    Attributes
    ----------
    used
        Part of the limit [-]; more is worse. Not finite where nothing is compared, or no number.
    rank
        Of the level, 0 where nothing is compared.
    most
        The highest rank that the check can have.
    is_open
        Whether it is also missed without a number: a miss may then have any of its ranks.
    """

    used: Array
    rank: Integers
    most: int
    is_open: bool = False


class Bounds(NamedTuple):
    """Lowest and highest rank that draws may have, shape (m,)."""

    low: Integers
    high: Integers

    @property
    def are_sure(self) -> Flags:
        """Whether there is one rank alone."""
        return np.asarray(self.low == self.high)


def predict_ranks(solved: Array, uses: Sequence[Uses], others: Array) -> Bounds:
    """Return between which ranks the worst of some checks is in draws that are not solved.

    The logarithm of what each check uses is fitted by a quadratic in those of the factors, on two
    thirds of the solved draws; the rest shows its largest miss. A draw passes a check where the
    prediction does by twice that; it misses it with a rank where all solved draws as near have it.

    Parameters
    ----------
    solved, others
        Factors of the draws, shape (n, inputs) and (m, inputs) [-].
    uses
        The checks of the solved draws.
    """
    low, high = (np.zeros(len(others), dtype=np.int64) for _ in range(2))
    logs = np.log(solved)
    drawn = logs.std(axis=0) > 0.0
    centre, scale = logs[:, drawn].mean(axis=0), logs[:, drawn].std(axis=0)
    here, there = (_terms((np.log(part[:, drawn]) - centre) / scale) for part in (solved, others))
    for known, some in _alike([one for one in uses if one.rank.any()]):
        for bounds in _bounds(here[known], [_compared(one, known) for one in some], there):
            low, high = np.maximum(low, bounds.low), np.maximum(high, bounds.high)
    return Bounds(low, high)


def _alike(uses: Sequence[Uses]) -> Iterator[tuple[Flags, list[Uses]]]:
    """Yield where checks compare a number, and those that do there."""
    groups: dict[bytes, list[Uses]] = {}
    for one in uses:
        groups.setdefault(np.isfinite(one.used).tobytes(), []).append(one)
    for key, some in groups.items():
        yield np.frombuffer(key, dtype=bool), some


def _compared(of: Uses, known: Flags) -> Uses:
    """Return a check where it compares a number.

    What is not compared misses another check of its place, and is as bad as a miss of this one.
    """
    return Uses(of.used[known], of.rank[known], of.most, bool(of.rank[~known].any()))


def can_fit(count: int, inputs: int) -> bool:
    """Return whether so many solved draws are enough for a fit."""
    return int(_FITTED * count) >= 2 * (1 + inputs + inputs * (inputs + 1) // 2)


def _terms(factors: Array) -> Array:
    """Return the terms of a quadratic, shape (n, terms)."""
    left, right = np.triu_indices(factors.shape[1])
    ones = np.ones((len(factors), 1))
    return np.concatenate([ones, factors, factors[:, left] * factors[:, right]], axis=1)


def _bounds(here: Array, uses: Sequence[Uses], there: Array) -> Iterator[Bounds]:
    """Yield the bounds of checks that compare a number in the same draws."""
    n, terms = here.shape
    fitted = int(_FITTED * n)
    if fitted < 1.5 * terms:
        for of in uses:
            yield Bounds(np.zeros(len(there), dtype=np.int64), np.full(len(there), of.most))
        return
    ends = np.exp(-_FAR), np.exp(_FAR)
    logs = np.log(np.clip(np.stack([of.used for of in uses], axis=1), *ends))
    # sums of our own: a library would take every processor for so little
    square = np.einsum("ni,nj->ij", here[:fitted], here[:fitted])
    model = np.linalg.solve(square, np.einsum("ni,nk->ik", here[:fitted], logs[:fitted]))
    misses = np.abs(np.einsum("ni,ik->nk", here[fitted:], model) - logs[fitted:]).max(axis=0)
    predicted = np.einsum("ni,ik->nk", there, model)
    for k, of in enumerate(uses):
        yield _bounds_of(of, logs[:, k], predicted[:, k], _SAFETY * float(misses[k]) + _LEAST)


def _bounds_of(of: Uses, log: Array, predicted: Array, band: float) -> Bounds:
    order = np.argsort(log)
    logs, ranks = log[order], of.rank[order]
    first = np.maximum(np.searchsorted(logs, predicted - band, "left") - 1, 0)
    last = np.searchsorted(logs, predicted + band, "right")
    beyond = (last >= len(logs)) | of.is_open
    low = np.where(predicted > band, ranks[first], Level.OK.rank)
    high = np.where(beyond, of.most, ranks[np.minimum(last, len(logs) - 1)])
    high = np.where(predicted < -band, Level.OK.rank, high)
    return Bounds(low, np.maximum(low, high))
