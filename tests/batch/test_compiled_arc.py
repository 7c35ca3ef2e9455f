"""One arc by the compiled kernel against `wraparc.arc.Distributed`, which runs interpreted."""

from dataclasses import replace

import numpy as np
import pytest

from arc.drives import ARC, LAWS, random_arc
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.batch.compiled import Compiled
from wraparc.friction import FrictionLaw


def agree(arc: WrapArc) -> None:
    mine, other = Compiled(points=40).solve(arc), Distributed(points=40).solve(arc)
    assert mine.status is other.status
    for name, value in other.scalars().items():
        found = mine.scalars()[name]
        if name == "identity_error":  # a remainder of rounding
            continue
        # the same operations in the same order, but for the rounding of exp and log
        assert found == pytest.approx(value, rel=1e-9, abs=1e-15, nan_ok=True), name
    assert len(mine.profile) == len(other.profile)
    columns = zip(mine.profile.columns(), other.profile.columns(), strict=True)
    for (name, column), (_, expected) in columns:
        assert column == pytest.approx(expected, rel=1e-9, abs=1e-9), name


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
def test_it_answers_as_the_interpreted_solver(law: FrictionLaw) -> None:
    rng = np.random.default_rng(3)
    for _ in range(3):
        agree(random_arc(law, rng))


def test_a_breakaway_is_told_the_same() -> None:
    far = replace(ARC, law=LAWS["softening"], exit_tension=2e3)
    assert Compiled(points=40).solve(far).status is Status.BREAKAWAY
    agree(far)
