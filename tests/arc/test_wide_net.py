"""Solved, breakaway or refused with a reason: every law over all that the readers accept.

Expected values: the twin's own solution, by multiple shooting from the points of each profile
(tests/arc/shooting.py), and for a breakaway the twin again, which carries no more at any creep.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from arc.finer import energy_miss, finer
from arc.shooting import ACCURACY, INTERPRETED, breaks_away, verdict
from arc.wide import NAMES, wide_arc
from wraparc.arc import Distributed, Status, WrapArc
from wraparc.arc.gross_slip import plateau_capacity
from wraparc.arc.profile import Range, read
from wraparc.drive.load_case import LEAST_TENSION
from wraparc.errors import InputError

DRIVES_PER_LAW = 6  # 54 in all; thousands in benchmarks/wide_net.py

#: law and seed of drives that once failed, and how they end
FAILED = [
    ("any table", [1, 26]),
    ("any table", [1, 53]),
    ("jump table", [1, 13]),
    ("elastic-plastic", [2, 70]),
    ("any table", [2, 152]),
    ("power", [2, 105]),
    ("constant", [1, 122]),  # an overrun takes tension down: the belt slips amid the wrap
    ("rubber", [1, 405]),  # braking, slip passes through zero amid the mesh
    ("softening", [1, 37]),  # the largest shear stress beside a kink
    ("table", [1, 75]),  # the same between the nodes of a layer
    ("any table", [1, 233]),  # steep cells of a table that holds the belt
    ("any table", [1, 305]),  # the largest shear stress at a kink of a layer
    ("softening", [1, 280]),
    ("any table", [1, 728]),  # the largest shear stress in a steep cell
    ("elastic-plastic", [1, 583]),  # idling, to the last digits
    ("any table", [1, 1619]),  # 0.3 m of creep along 9,500 shear-lag lengths
    ("constant", [1, 86]),  # sliding from 1 % of the wrap on, too near the entry for a rest arc
    ("any table", [1, 278]),  # 7 s: the least slack side by halving
    ("any table", [1, 602]),  # an overrun on an idle pulley: 1e5 times the pull
    ("softening", [1, 1810]),  # a belt that stretches twofold creeps by 2 m
    ("softening", [1, 3988]),  # kinks that come and go with the mesh
    ("softening", [1, 4330]),  # carries next to its largest at 10 m of creep
    ("pieces", [1, 3926]),  # braking, with an overrun larger than the creep at the exit
    ("any table", [1, 935]),  # a soft belt: carries most far past the peak of its law
    ("power", [1, 4362]),  # the overrun drives, and the belt sticks again behind it
]


def ends_well(name: str, seed: list[int], solver: Distributed = INTERPRETED) -> str:
    try:
        arc = wide_arc(name, np.random.default_rng(seed))
    except InputError:
        return "refused"
    end, miss = verdict(arc, solver)
    assert end in ("solved", "breakaway"), (name, seed)
    assert miss <= 1.0, (name, seed, miss)
    if end == "breakaway":
        assert breaks_away(arc) <= 1.0, (name, seed)
    return end


@pytest.mark.parametrize("name", NAMES)
def test_random_drives_end_well(name: str) -> None:
    place = NAMES.index(name)
    ends = [ends_well(name, [7, 1000 * place + k]) for k in range(DRIVES_PER_LAW)]
    assert ends.count("solved") > DRIVES_PER_LAW // 3


@pytest.mark.parametrize(("name", "seed"), FAILED)
def test_drives_that_once_failed(name: str, seed: list[int]) -> None:
    assert ends_well(name, seed) == "solved"


#: The same, of thousands of shear-lag lengths: they take the twin long, benchmarks/wide_net.py 5000
LONG = [
    ("any table", [1, 4391], 1e-6),
    ("rubber", [1, 1341], 5e-3),  # 1 mN: what is let stand is of 1e-7 of the tension at least
]


@pytest.mark.parametrize(("name", "seed", "close"), LONG)
def test_long_drives_that_once_failed(name: str, seed: list[int], close: float) -> None:
    """Expected: the balance of energy, and the solver on a finer mesh."""
    arc = wide_arc(name, np.random.default_rng(seed))
    result, fine = INTERPRETED.solve(arc), finer(arc)
    assert result.status is Status.SOLVED
    assert fine.done
    assert energy_miss(result) <= 3e-7 + 1e-3 * close
    assert result.exit_creep == pytest.approx(fine.course.creep[-1], rel=close)
    told = read(arc.geometry(), fine, Range(math.nan, math.nan, math.nan))
    assert result.peak_shear_stress == pytest.approx(told.peak, rel=close)


#: law and seed of drives whose capacities once overflowed, hung, divided by zero or were none
CAPACITIES = [
    ("any table", [1, 386]),
    ("constant", [1, 239]),
    ("constant", [1, 122]),
    ("constant", [1, 941]),  # an overrun on a rest arc; next to gross slip creep says all
    ("elastic-plastic", [1, 178]),
    ("elastic-plastic", [1, 718]),
    ("table", [1, 1110]),
    ("rubber", [1, 585]),
]


@pytest.mark.parametrize(("name", "seed"), CAPACITIES)
def test_capacities_that_once_failed(name: str, seed: list[int]) -> None:
    """Expected: by hand, no more than friction at its largest everywhere; and the solver itself."""
    arc = wide_arc(name, np.random.default_rng(seed))
    found = Distributed(points=20).solve(arc).capacities
    tight = max(arc.entry_tension, arc.exit_tension)
    most = plateau_capacity(arc.law.compact(), tight / (arc.width * arc.radius), arc.wrap_angle)
    assert 0.0 <= math.log(found.creep_limit_capacity) <= most * (1.0 + 1e-9)
    assert math.log(found.gross_slip_capacity) <= most * (1.0 + 1e-6)
    slack = found.least_exit_tension
    if slack >= LEAST_TENSION and not refused_with(
        arc, slack
    ):  # a little less does not do, a little more does, of 1e-5
        assert creep_with(arc, slack * (1.0 - ACCURACY)) > arc.creep_limit
        assert creep_with(arc, slack * (1.0 + ACCURACY)) < arc.creep_limit


@pytest.mark.parametrize(
    ("name", "seed"),
    [
        ("pieces", [1, 1244]),
        ("softening", [1, 1270]),
        ("softening", [1, 1297]),
        ("any table", [1, 80]),
        ("rubber", [1, 585]),  # a pull that no tension carries
    ],
)
def test_a_long_braking_pulley_carries_its_capacity(name: str, seed: list[int]) -> None:
    """Expected: with that ratio, asked as tensions, it creeps to the limit."""
    arc = wide_arc(name, np.random.default_rng(seed))
    assert arc.side < 0.0
    found = Distributed(points=20).solve(arc).capacities
    for share, more in ((1.0 - 5e-7, False), (1.0 + 5e-7, True)):
        entry = arc.exit_tension / found.creep_limit_capacity**share
        there = INTERPRETED.solve(replace(arc, entry_tension=entry))
        assert (abs(there.exit_creep) > arc.creep_limit) == more


def refused_with(arc: WrapArc, slack: float) -> bool:
    """Whether the overrun is more than the belt is held against with so little tension."""
    try:
        creep_with(arc, slack)
    except InputError:
        return True
    return False


def creep_with(arc: WrapArc, slack: float) -> float:
    """Exit creep with another slack-side tension and the same pull [m]; inf on breakaway."""
    tight = slack + abs(arc.effective_tension)
    pair = (tight, slack) if arc.side > 0.0 else (slack, tight)
    there = INTERPRETED.solve(replace(arc, entry_tension=pair[0], exit_tension=pair[1]))
    return abs(there.exit_creep) if there.status is Status.SOLVED else math.inf
