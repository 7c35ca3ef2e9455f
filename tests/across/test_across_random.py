"""Random uneven drives are solved, or say why not."""

from __future__ import annotations

from statistics import median

import numpy as np
import pytest

from across.randoms import random_wide
from across.wides import RUBBER, SOFTENING
from wraparc.across import AcrossSolver, AcrossStatus
from wraparc.friction import Constant, FrictionLaw

LAWS: dict[str, FrictionLaw] = {
    "rubber": RUBBER,
    "softening": SOFTENING,
    "constant": Constant(friction_coefficient=0.45),
}


@pytest.mark.parametrize("name", LAWS)
def test_random_drives(name: str) -> None:
    """300 of them: python benchmarks/belt_width.py 300."""
    rng, steps = np.random.default_rng(20), []
    for _ in range(10):
        found = AcrossSolver(32).solve(random_wide(LAWS[name], rng, strips=6))
        assert found.status is not AcrossStatus.UNSOLVED
        if found.status is AcrossStatus.SOLVED:
            steps.append(found.iterations)
            assert found.identity_error < 1e-3
            assert found.least_tension > 0.0
    assert len(steps) >= 7
    assert median(steps) <= 6
