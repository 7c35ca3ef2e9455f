"""Damaged drives that still read end with finite numbers, in breakaway, or refused with a reason.

Expected: nothing but that; what the numbers are is asked by tests/arc/test_wide_net.py.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import replace

import pytest

from arc.damaged import damaged, judged
from arc.shooting import INTERPRETED, verdict
from wraparc.arc import Distributed, Status, WrapArc, answer, capacity
from wraparc.arc.capacity import CREEP_LIMIT, LEAST, find_capacities
from wraparc.arc.quantities import CAPACITY_STEPS
from wraparc.errors import InputError
from wraparc.files import drive_from_document

#: hung, divided by zero, unsolved or took longer than 2 s once
FAILED = (6, 41, 69, 804, 1061, 2126, 3402, 4396, 4460, 4743, 4786, 202291)


def ends_of(seed: int) -> list[str]:
    try:
        drive = drive_from_document(damaged(seed))
        return [
            judged(Distributed(points=20).solve(WrapArc.of(drive, pulley, case)))
            for case in drive.load_cases
            for pulley in drive.pulleys
        ]
    except InputError as error:
        reasons = [problem.message for problem in error.problems]
    return ["refused" if all(reasons) else "no reason"]


@pytest.mark.parametrize("first", range(0, 60, 15))
def test_damaged_drives_end_well(first: int) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ends = [end for seed in range(first, first + 15) for end in ends_of(seed)]
    assert {"solved", "refused"} <= set(ends) <= {"solved", "refused", "breakaway"}


@pytest.mark.parametrize("seed", FAILED)
def test_damaged_drives_that_once_failed(seed: int) -> None:
    assert set(ends_of(seed)) <= {"solved", "refused", "breakaway"}


def arc_of(seed: int, case: int = 0) -> WrapArc:
    drive = drive_from_document(damaged(seed))
    return WrapArc.of(drive, drive.pulleys[0], drive.load_cases[case])


@pytest.mark.parametrize(("seed", "case"), [(804, 0), (804, 1), (3402, 0), (3402, 1)])
def test_an_arc_hundreds_of_shear_lag_lengths_long(seed: int, case: int) -> None:
    """Pulleys of 100 m and 300 m. Expected: the twin's own solution."""
    end, miss = verdict(arc_of(seed, case))
    assert end == "solved"
    assert miss <= 1.0


def test_the_least_slack_side_far_above_the_present_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """4.2 MN, where 60 kN are given: within a fifth of the steps that capacities may take.

    Expected: with that slack side, asked as tensions, the belt creeps to the limit.
    """
    monkeypatch.setattr(capacity, "CAPACITY_STEPS", 0.2 * CAPACITY_STEPS)
    arc = arc_of(3402)
    pull, load = arc.effective_tension, arc.load()
    least = find_capacities(arc.law.compact(), arc.geometry(), load, CREEP_LIMIT + LEAST)
    there = replace(arc, entry_tension=least.least_slack + pull, exit_tension=least.least_slack)
    assert INTERPRETED.solve(there).exit_creep == pytest.approx(arc.creep_limit, rel=1e-6)


def test_what_may_take_no_more_steps_is_unsolved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Expected: by hand, 8 elements at the least a step."""
    arc = arc_of(804)
    monkeypatch.setattr(answer, "POINT_STEPS", 100.0)
    monkeypatch.setattr(capacity, "CAPACITY_STEPS", 7.0)
    result = Distributed().solve(arc)
    assert result.status is Status.UNSOLVED
    assert math.isnan(result.capacities.creep_limit_capacity)
    assert result.capacities.gross_slip_capacity > 1.0  # in closed form
