"""Damaged drives that still read end with finite numbers, in breakaway, or refused with a reason.

Expected: nothing but that; what the numbers are is asked by tests/arc/test_wide_net.py.
"""

from __future__ import annotations

import warnings

import pytest

from arc.damaged import damaged, judged
from wraparc.arc import Distributed, WrapArc
from wraparc.errors import InputError
from wraparc.files import drive_from_document

#: hung, or divided by zero, once
FAILED = (6, 41, 69, 2126, 4460, 4743, 202291)


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
