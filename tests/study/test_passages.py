"""Passages of a train, compiled: the same as one after the other.

Expected values: `wraparc.train.passage_table.one_by_one`, the plain kernel in the interpreter.
"""

import numpy as np
import pytest

from train.trains import FABRIC, QUICK, case, pulleys, train
from wraparc.study.passages import all_at_once
from wraparc.train import Axis, Shares, share_map, solve_train
from wraparc.train.member import Member
from wraparc.train.passage_table import one_by_one
from wraparc.train.solve import arc_of


@pytest.mark.parametrize("overrun", [None, 0.0])
@pytest.mark.parametrize("law", ["rubber", "softening"])
def test_compiled_passages_are_the_plain_ones(law: str, overrun: float | None) -> None:
    """Bit for bit but for the logarithm that one of the two takes of the exit tension."""
    of = train(pulleys(1, law, overrun=overrun), case(Shares((1.0,))), belt=FABRIC)
    member = Member.of(arc_of(of, of.cases[0], of.pulleys[0], (150e3, 50e3)))
    logs, efforts = np.meshgrid(np.log([30e3, 80e3, 210e3]), np.linspace(-9.2, 9.2, 13))
    found = all_at_once(member, logs.ravel(), efforts.ravel())
    expected = one_by_one(member, logs.ravel(), efforts.ravel())
    assert found[0] == pytest.approx(expected[0], rel=1e-13, abs=1e-15)
    assert found[1] == pytest.approx(expected[1], rel=1e-13, abs=1e-18)
    assert np.ptp(found[0]) > 0.5


def test_a_map_by_compiled_passages_is_the_plain_map() -> None:
    result = solve_train(train(pulleys(2), case(Shares((0.5, 0.5)))), method=QUICK)
    x, y = result.cases[0]["p2"].speed_trim + np.linspace(-4e-3, 4e-3, 9), np.linspace(0.4, 1.2, 5)
    plain = share_map(result, x=x, y=y, down=Axis.LOAD)
    fast = share_map(result, x=x, y=y, down=Axis.LOAD, passages=all_at_once)
    assert fast.shares == pytest.approx(plain.shares, abs=1e-9, nan_ok=True)
    assert fast.creeps == pytest.approx(plain.creeps, rel=1e-9, nan_ok=True)
