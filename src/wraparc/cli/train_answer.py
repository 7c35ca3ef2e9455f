"""What ``wraparc solve`` does with several pulleys on one belt."""

from collections.abc import Sequence
from dataclasses import replace

from wraparc.answer.sheet import Sheet
from wraparc.arc import Distributed, DriveResult, Method
from wraparc.arc import solve as solve_drive
from wraparc.errors import placed
from wraparc.train import Train, TrainResult, solve_train


def with_case(train: Train, name: str | None, file: str, key: str = "--load-case") -> Train:
    """Return the train with one load case only."""
    if name is None:
        return train
    with placed(key, file):
        return replace(train, cases=(train.case(name),))


def with_limit(train: Train, limit: float) -> Train:
    """Return the train with one creep limit [m] for all pulleys."""
    pulleys = tuple(replace(pulley, creep_limit=limit) for pulley in train.pulleys)
    return replace(train, creep_limit=limit, pulleys=pulleys)


def solve_all(
    train: Train, methods: Sequence[type[Method]]
) -> tuple[TrainResult, list[DriveResult]]:
    """Solve a train, and its pulleys by each method.

    The load is always divided by the main solver: the paper's march knows no speeds.
    """
    result = solve_train(train, raise_on_failure=False)
    own = result.drive_result()
    results = [
        own
        if method is Distributed
        else solve_drive(own.drive, method=method(), raise_on_failure=False)
        for method in methods
    ]
    return result, results


def sheet_of(result: TrainResult, results: Sequence[DriveResult], everything: bool) -> Sheet:
    """Return the sheet of a train."""
    from wraparc.answer.train_sheet import train_sheet

    detail = range(len(results[0])) if everything else None
    return train_sheet(result, detail, results)
