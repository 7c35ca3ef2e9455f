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
    """3 % were drawn. Counting an unknown zero of 2 % as noise of the curves left 1.9 %."""
    told = [verdicts().claimed_scatter(seed, 0.03) for seed in range(1, 11)]
    assert 0.7 < float(np.sqrt(np.mean(np.square(told)))) < 1.4
