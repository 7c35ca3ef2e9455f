"""How much more pull until gross slip, by the row.

Expected values: `wraparc.arc.gross_slip.slip_place`, which brackets the place and halves its
way to it, row by row in the interpreter.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from arc.drives import LAWS
from batch.batches import designs, lagging
from wraparc.arc.gross_slip import Grip, Line, plateau_capacity, slip_place
from wraparc.batch.arcs import arcs_of_table
from wraparc.batch.pull_factors import pull_factors


@pytest.mark.parametrize("name", ["rubber", "softening", "pieces", "power"])
@pytest.mark.parametrize("slack_share", [0.0, -0.4, 0.3])  # of the pull that the slack side takes
def test_factors_are_those_of_the_bracket(name: str, slack_share: float) -> None:
    n, rng = 12, np.random.default_rng(6)
    arcs = arcs_of_table(designs(n, 41), lagging(name, LAWS[name]))
    friction, gross = rng.uniform(0.7, 1.2, n), rng.uniform(5.0, 40.0, n)
    pull = arcs.entry_tension - arcs.exit_tension
    rises: tuple[NDArray[np.float64], ...] = ((1.0 + slack_share) * pull, slack_share * pull)
    found = pull_factors(arcs, friction, gross, (rises[0], rises[1]))
    law = arcs.laws.compact(0)
    for i in range(n):
        area, tight = arcs.belt_width[i] * arcs.diameter[i] / 2.0, arcs.entry_tension[i]
        wrap = arcs.wrap_angle[i] * friction[i]
        softens = arcs.laws.steepest_fall[0] < 0.0
        offset = math.log(gross[i]) - plateau_capacity(law, tight / area, wrap) if softens else 0.0
        grip = Grip(wrap, area, offset)
        line = Line(tight, arcs.exit_tension[i], rises[0][i], rises[1][i])
        assert found[i] == pytest.approx(slip_place(law, grip, line, 1.0, 0.0), rel=1e-8)
