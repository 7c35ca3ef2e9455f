"""The law of all curves at once stays with its curves: a known rubber that no law follows."""

import numpy as np
import pytest

from shear_test.virtual import verdicts


@pytest.mark.parametrize("seed", [1, 2, 6])
def test_pressures_left_out_are_told_as_well_as_by_plain_least_squares(seed: int) -> None:
    """Seeds 1 and 2 were missed by 1.4 % and 3.1 % of the peak, plain least squares by 0.8 %.

    Of 200 seeds (benchmarks/shear_test_verdicts.py --part "left out") both miss by 0.7 % on
    average, and the worst ratio is 1.1.
    """
    law, plain, scatter = verdicts().left_out_errors(seed)
    assert law < 0.015
    assert law < 1.2 * plain
    # None was drawn; the second seed was told 5.4 %.
    assert scatter < 0.005


def test_scatter_of_samples_is_told_as_it_was_drawn() -> None:
    """3 % were drawn for six tests, which leaves 4 degrees of freedom about a power of pressure.

    Who knew that form would tell it within a factor of two in 91 of 100 laboratories: chi-square
    of 4 between 1 and 16. What the fit took off for the noise of its readings left 72.
    """
    told = np.array([verdicts().told_scatter(seed, 0.03) for seed in range(1, 11)])
    assert 0.7 < float(np.sqrt(np.mean(told[:, 0] ** 2))) < 1.4
    assert np.sum((told[:, 0] > 0.5) & (told[:, 0] < 2.0)) >= 9
    assert told[:, 1].sum() >= 9
