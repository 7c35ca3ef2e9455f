"""Search of the least tension along curves of pull that are known.

Expected values: pull T exp(-T/b) has its largest, b/e, at T = b, and carries a pull P below it
from the lower root of T exp(-T/b) = P on, by SciPy's brentq.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from wraparc.arrays import Flags
from wraparc.batch.least import search_least

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

TOP = 100e3  # [N] of the largest pull


def least_of(share: float) -> float:
    """Least tension that carries a share of the largest pull [N]."""
    return TOP * float(brentq(lambda t: t * math.exp(1.0 - t) - share, 0.0, 1.0, xtol=1e-12))


def pull_of(log_tension: Array, _: Integers) -> tuple[Array, Flags]:
    tension = np.exp(log_tension)
    return tension * np.exp(-tension / TOP), np.ones(len(tension), dtype=bool)


@pytest.mark.parametrize("highest", [1.0001, 1.05, 1.5, 3.0, 7.0])
def test_the_largest_pull_and_the_least_tension(highest: float) -> None:
    share = np.array([0.5, 0.9, 0.99, 0.999, 1.001, 1.05])
    pull = share * TOP / math.e
    found = search_least(pull_of, pull, np.full(6, highest * TOP))
    assert found.good.all()
    least = [least_of(s) for s in share[:4]]
    np.testing.assert_allclose(found.least[:4], least, rtol=2e-6)
    assert np.isnan(found.least[4:]).all()
    np.testing.assert_allclose(found.most[4:], TOP / math.e, rtol=2e-5)
    assert np.isnan(found.most[:4]).all()


def test_a_pull_that_still_grows_at_the_top_of_the_range() -> None:
    found = search_least(pull_of, np.array([20e3, 31e3]), np.full(2, 0.5 * TOP))
    np.testing.assert_allclose(found.least[0], least_of(0.2 * math.e), rtol=1e-6)
    np.testing.assert_allclose(found.most[1], 0.5 * TOP * math.exp(-0.5), rtol=1e-12)


def test_what_cannot_be_told_is_left() -> None:
    def only_first(log_tension: Array, rows: Integers) -> tuple[Array, Flags]:
        pull, _ = pull_of(log_tension, rows)
        return pull, rows == 0

    pull = np.array([0.9, 0.9, 1.0]) * TOP / math.e
    found = search_least(only_first, pull, np.full(3, 1.2 * TOP))
    assert found.good.tolist() == [True, False, False]
    assert np.isnan(found.most).all()
    assert np.isnan(found.least[1:]).all()
    near = search_least(pull_of, pull, np.full(3, 1.2 * TOP))  # the third is at the very top
    assert near.good.tolist() == [True, True, False]
