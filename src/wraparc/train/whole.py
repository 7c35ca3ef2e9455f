"""A drive as every door solves it: one pulley alone, several on one belt as a train."""

from __future__ import annotations

from wraparc.arc import Distributed, DriveResult, Method, solve
from wraparc.drive import Drive
from wraparc.train.result import TrainResult
from wraparc.train.train import Train

#: What a drive file describes, and the same solved.
Described = Drive | Train
Whole = DriveResult | TrainResult


def solved(described: Described, method: Method | None = None) -> Whole:
    """Solve a drive in all its load cases; several pulleys on one belt are a train.

    `method` is for a pulley alone: trains have a solver of their own.
    """
    if isinstance(described, Drive) and len(described.pulleys) == 1:
        return solve(described, method=method or Distributed(), raise_on_failure=False)
    from wraparc.train.solve import solve_train  # a pulley alone starts without it

    train = Train.of(described) if isinstance(described, Drive) else described
    return solve_train(train, raise_on_failure=False)


def by_pulley(whole: Whole) -> DriveResult:
    """Return a solved drive or train pulley by pulley."""
    return whole.drive_result() if isinstance(whole, TrainResult) else whole
