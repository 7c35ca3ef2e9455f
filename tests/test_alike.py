"""Equal to rounding is equal: the first governs, on every machine. Expected: by hand."""

import math

import numpy as np
import pytest

from wraparc.alike import alike, falling, largest, least, place_of_largest


def value(pair: tuple[str, float]) -> float:
    return pair[1]


def test_the_first_of_those_alike_stands_for_them() -> None:
    pairs = [("a", 3.0), ("b", 3.0 * (1.0 + 4e-16)), ("c", 3.0 * (1.0 - 4e-16))]
    assert largest(pairs, value)[0] == least(pairs, value)[0] == "a"
    apart = [*pairs, ("d", 3.0 * (1.0 + 3e-9)), ("e", 3.0 * (1.0 - 3e-9))]
    assert (largest(apart, value)[0], least(apart, value)[0]) == ("d", "e")
    endless = [("a", 1.0), ("b", math.inf), ("c", -math.inf)]
    assert (largest(endless, value)[0], least(endless, value)[0]) == ("b", "c")
    with pytest.raises(ValueError, match="nothing to choose from"):
        largest([], value)


def test_the_order_of_those_alike_is_their_own() -> None:
    pairs = [("a", 1e-17), ("b", 2.0), ("c", -3e-17), ("d", 2.0 * (1.0 + 4e-16)), ("e", math.inf)]
    assert [name for name, _ in falling(pairs, value)] == ["e", "b", "d", "a", "c"]
    assert falling([("a", 0.0), ("b", 0.0)], value) == [("a", 0.0), ("b", 0.0)]


def test_the_same_of_arrays() -> None:
    assert place_of_largest(np.array([1.0, 2.0, 2.0 + 4e-16, 0.0])) == 1
    assert place_of_largest(-np.array([[1.0, 2.0], [1.0 - 2e-16, 5.0]])) == 0
    assert alike([0.0, 0.0])
    assert alike([60e3, 60e3 * (1.0 + 2e-16)])
    assert not alike([60e3, 60e3 * (1.0 + 1e-8)])
