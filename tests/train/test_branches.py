"""Friction that falls with slip: several splits for the same speeds, or none.

Expected values: every solution of a tandem found by brute force, from the two arcs alone, each
followed over its creeps to past its peak.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

from arc.drives import integral_log
from train.trains import QUICK, case, lagging, pulleys, solved, train, tried
from wraparc.errors import BreakawayError
from wraparc.train import Shares, Speeds, TrainStatus, solve_train
from wraparc.train.member import COARSE, FINE, Member
from wraparc.train.solve import Setup

SOFT = lagging(integral_log(0.5, 3e-3, -30.0, 0.25))
ENTRY = 150e3


def members(exit_: float) -> tuple[Member, Member]:
    given = case(Shares((0.5, 0.5)), ENTRY, exit_)
    system = Setup.of(train(pulleys(2, SOFT), given), given).system
    return system.members[0], system.members[1]


def all_splits(exit_: float, trim: float) -> list[float]:
    """Shares of drive 1 at which the speeds agree, for creeps up to 10 % of the wrap.

    Each creep of the first drum has one tension and one speed behind it, and these one creep of the
    second.
    """
    first, second = members(exit_)
    last = [first.passage(ENTRY, 1e-3, None, FINE), second.passage(exit_, 1e-3, None, FINE)]

    def last_tension(creep: float, tol: float) -> tuple[float, float]:
        one = first.passage(ENTRY, creep, last[0].met, tol)
        stretch = second.stretch_log(one.exit) - first.stretch_log(ENTRY)
        ratio = 1.0 - (1.0 - one.ratio) * math.exp(stretch) / trim
        two, there = last[1], last[1].place
        for _ in range(50):
            two = second.passage(one.exit, there, two.met, tol)
            change = (two.ratio - ratio) / two.slopes.ratio_by_place
            there -= change
            if abs(change) < 1e-12:
                break
        last[:] = [one, two]
        return two.exit, one.exit

    def miss(creep: float, tol: float = FINE) -> float:
        return math.log(exit_ / last_tension(creep, tol)[0])

    nodes = np.sinh(np.linspace(-8.0, 8.0, 280)) * 1e-4
    nodes = nodes[abs(nodes) < 0.1 * first.length]
    values = [miss(float(c), COARSE) for c in nodes]
    roots = [
        brentq(miss, float(a), float(b), xtol=1e-11)
        for (a, b), (fa, fb) in zip(pairwise(nodes), pairwise(values), strict=True)
        if fa * fb < 0.0
    ]
    return sorted((ENTRY - last_tension(c, FINE)[1]) / (ENTRY - exit_) for c in roots)


@pytest.mark.parametrize(
    ("exit_", "trim"),
    [(40e3, 1.0), (40e3, 0.992), (20e3, 0.995), (15e3, 0.995)],
)
def test_all_splits_are_found_and_the_stable_one_given(exit_: float, trim: float) -> None:
    expected = all_splits(exit_, trim)
    result = solved(train(pulleys(2, SOFT), case(Speeds((1.0, trim)), ENTRY, exit_)))
    found = sorted([result.shares[0], *(s[0] for s in result.other_splits)])
    assert found == pytest.approx(expected, abs=1e-6)
    assert len(expected) in (1, 2)
    # stable: each drive pulls more if it creeps more
    for member, m in zip(members(exit_), result, strict=True):
        at = member.between(m.arc.entry_tension, m.arc.arc.exit_tension)
        assert at is not None
        more = member.passage(at.entry, 1.001 * at.place, at.met, FINE)
        assert more.exit < at.exit


def test_several_splits_are_told() -> None:
    result = solved(train(pulleys(2, SOFT), case(Speeds((1.0, 0.995)), ENTRY, 20e3)))
    assert len(result.other_splits) == 1
    assert sum(result.other_splits[0]) == pytest.approx(1.0, abs=1e-9)
    assert (
        max(abs(p - q) for p, q in zip(result.shares, result.other_splits[0], strict=True)) > 0.02
    )


def test_a_pull_that_is_just_carried_is_found() -> None:
    """Two splits side by side, where the pull that the drums make turns back.

    So near to one another that none of the levels looked at lies between them.
    """
    soft = lagging(integral_log(0.5, 4.8e-3, -30.0, 0.25))
    of = train(pulleys(2, soft), case(Speeds((1.0, 0.995)), ENTRY, 14.55e3))
    result = solved(of)
    assert len(result.other_splits) == 1
    apart = abs(result.shares[0] - result.other_splits[0][0])
    assert 1e-3 < apart < 5e-2
    more = replace(of, cases=(case(Speeds((1.0, 0.995)), ENTRY, 14.2e3),))
    assert tried(more).status is TrainStatus.BREAKAWAY


@pytest.mark.parametrize("trim", [1.006, 1.01, 0.98])
def test_no_stable_split_names_the_drive_that_breaks_away(trim: float) -> None:
    of = train(pulleys(2, SOFT), case(Speeds((1.0, trim)), ENTRY, 40e3))
    failed = tried(of)
    assert failed.status is TrainStatus.BREAKAWAY
    sliding = "p2" if trim > 1.0 else "p1"
    assert failed.reason == (
        f"At these speeds gross slip on {sliding}: the only balance has it sliding, past "
        "the peak of friction."
    )
    with pytest.raises(BreakawayError, match=f"gross slip on {sliding}"):
        solve_train(of, method=QUICK)


def test_nothing_carries_the_load() -> None:
    capacity = solved(train(pulleys(1, SOFT), case(Shares((1.0,)), ENTRY, 100e3)), FULL)
    ratio = capacity.members[0].arc.capacities.gross_slip_capacity
    of = train(pulleys(2, SOFT), case(Speeds((1.0, 0.995)), ENTRY, ENTRY / ratio**2 * 0.9))
    failed = tried(of)
    assert failed.status is TrainStatus.BREAKAWAY
    assert "Gross slip" in failed.reason or "together cannot transmit" in failed.reason
    assert all(math.isnan(m.speed_trim) or m.speed_trim > 0.0 for m in failed)


FULL = type(QUICK)(points=20)
