"""Random uneven drives are solved, or say why not."""

from __future__ import annotations

from statistics import median

import numpy as np

from across.randoms import random_wide
from across.wides import RUBBER, SOFTENING
from wraparc.across import AcrossSolver, AcrossStatus
from wraparc.friction import Constant

LAWS = (RUBBER, SOFTENING, Constant(friction_coefficient=0.45))


def test_random_drives() -> None:
    """Source: the balance of energy; 300 of them: python benchmarks/belt_width.py 300."""
    rng, steps = np.random.default_rng(20), []
    for k in range(30):
        found = AcrossSolver().solve(random_wide(LAWS[k % 3], rng, strips=6))
        assert found.status is not AcrossStatus.UNSOLVED
        if found.status is AcrossStatus.SOLVED:
            steps.append(found.iterations)
            assert found.identity_error < 1e-5
            assert found.least_tension > 0.0
    assert len(steps) >= 25
    assert median(steps) <= 8  # on two meshes or more
