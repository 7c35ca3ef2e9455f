"""Where gross slip begins or ends along a line of tensions.

Expected: the root of ln(tight/slack) less what friction carries there (`carried_log`, by
`plateau_capacity`), by SciPy's Brent's method.
"""

import math
from functools import partial

import numpy as np
import pytest
from scipy.optimize import brentq

from arc.drives import LAWS
from wraparc.arc.gross_slip import (
    Grip,
    Line,
    carried_log,
    plateau_capacity,
    slip_place,
)
from wraparc.friction.compact import CompactLaw

MOST = 1e4


def excess(k: float, law: CompactLaw, grip: Grip, line: Line) -> float:
    """ln(tight/slack) at a place of a line less what friction carries there."""
    tight = line.tight + (k - 1.0) * line.tight_rise
    slack = line.slack + (k - 1.0) * line.slack_rise
    return math.log(tight / slack) - carried_log(law, grip, tight)


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("softens", [False, True])
def test_more_pull_until_gross_slip(name: str, softens: bool) -> None:
    """The slack side held, falling or growing with the pull; loads of a tenth to ten times."""
    law, rng = LAWS[name].compact(), np.random.default_rng(81)
    for slack_share in (0.0, -0.4, -1.0, 0.3):
        for _ in range(4):
            tight = math.exp(rng.uniform(math.log(2e4), math.log(6e5)))
            slack = tight / (1.0 + math.exp(rng.uniform(-4.0, 3.0)))
            pull = tight - slack
            wrap, area = rng.uniform(2.0, 9.0), rng.uniform(0.2, 1.2)
            less = rng.uniform(0.0, 0.3) if softens else 0.0
            grip = Grip(wrap, area, -less * plateau_capacity(law, tight / area, wrap))
            line = Line(tight, slack, (1.0 + slack_share) * pull, slack_share * pull)
            most = 1.0 - slack / line.slack_rise if slack_share < 0.0 else MOST
            most = min(most * (1.0 - 1e-9), MOST)
            over = partial(excess, law=law, grip=grip, line=line)
            if slack_share > 0.0 and over(1.0) > 0.0:
                continue  # it slips already, and less the more it pulls
            found = slip_place(law, grip, line, 1.0, 0.0)
            if over(most) < 0.0:
                assert found == math.inf
                continue
            expected = brentq(over, 1e-12, most, xtol=1e-14)
            assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("name", LAWS)
def test_more_slack_tension_until_it_grips(name: str) -> None:
    """Tensions T2 + P and T2 with T2 growing from nothing."""
    law, rng = LAWS[name].compact(), np.random.default_rng(82)
    for _ in range(8):
        pull = math.exp(rng.uniform(math.log(1e3), math.log(6e5)))
        grip = Grip(rng.uniform(1.0, 9.0), rng.uniform(0.2, 1.2), -rng.uniform(0.0, 0.02))
        line = Line(pull, 0.0, pull, pull)
        over = partial(excess, law=law, grip=grip, line=line)
        found = slip_place(law, grip, line, -1.0, 1.0)
        if found == math.inf:
            assert all(over(1.0 + k) > 0.0 for k in np.geomspace(1e-9, MOST, 200))
            continue
        expected = brentq(over, 1.0 + 1e-12, 1.5 * found, xtol=1e-14)
        assert found - 1.0 == pytest.approx(expected - 1.0, rel=1e-8)


def test_what_no_pull_makes_slip_is_told_at_once() -> None:
    """Both sides growing alike, as of a belt that is only tensioned."""
    law = LAWS["constant"].compact()
    line = Line(1e5, 9e4, 1e5, 9e4)
    assert slip_place(law, Grip(3.0, 0.5, 0.0), line, 1.0, 0.0) == math.inf
