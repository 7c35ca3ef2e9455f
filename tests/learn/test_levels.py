"""Draws of the posterior along friction: expected are those of one unknown, integrated by hand."""

import numpy as np
import pytest

from wraparc.learn.levels import DRAWS, _quantiles, evenly
from wraparc.learn.lines import draws_interval


def test_quantiles_of_a_skewed_density_are_those_of_its_distribution() -> None:
    """Of x = ln(gamma), shape 3: its distribution is 1 - exp(-g)(1 + g + g^2/2), g = e^x."""
    values = np.linspace(-3.5, 3.0, 14)
    found = _quantiles(values, 3.0 * values - np.exp(values), np.array([0.025, 0.5, 0.975]))
    g = np.exp(found)
    reached = 1.0 - np.exp(-g) * (1.0 + g + 0.5 * g * g)
    # a cubic between two of 14 values each, so not exactly
    assert reached == pytest.approx([0.025, 0.5, 0.975], abs=0.002)


def test_an_interval_of_draws_is_that_of_the_normal_distribution() -> None:
    """The sum of independent normal draws of 0.3 and 0.4 has the standard deviation 0.5."""
    even = np.random.default_rng(3).permutation(evenly(DRAWS))
    found = draws_interval(1.0 + 0.3 * even, 0.4)
    assert found.value == pytest.approx(1.0, abs=0.03)
    assert 0.5 * (found.high - found.low) == pytest.approx(1.96 * 0.5, rel=0.06)
