"""A train as a drive: its pulleys one by one, at the tensions that its load divides into."""

from __future__ import annotations

from collections.abc import Sequence
from math import nan

from wraparc.arc import Distributed
from wraparc.drive import Drive
from wraparc.errors import InputError, Problem, input_error
from wraparc.train.result import drive_with
from wraparc.train.solve import solve_case, solve_train
from wraparc.train.train import Train, TrainCase
from wraparc.train.unsolved import given_pairs, load_case


def as_drive(train: Train) -> Drive:
    """Return a train as a drive with the tensions of every pulley.

    Where shares or pulls are given the tensions follow; where speeds or motors divide the load the
    train is solved for them.

    Raises
    ------
    InputError
        If a load case has no solution, with the reason.
    """
    return with_speeds(train)[0]


def with_speeds(train: Train) -> tuple[Drive, dict[str, float]]:
    """Return a train as a drive, and the speed of its belt at the first pulley by load case.

    Drums that turn as they do decide the speed [m/s]; else it is that of the belt, nan if unknown.

    Raises
    ------
    InputError
        As of `as_drive`.
    """
    problems: list[Problem] = []
    cases, speeds = [], {}
    for case in train.cases:
        try:
            pairs, speeds[case.name] = _pairs(train, case)
        except InputError as error:
            problems += error.problems
            continue
        cases.append(load_case(train, case, pairs))
    if problems:
        raise InputError(problems)
    return drive_with(train, cases), speeds


def nearest_drive(train: Train, method: Distributed | None = None) -> Drive:
    """Return a train as a drive; with the nearest tensions where its load has no division."""
    solver = method or Distributed(capacities=False)
    return solve_train(train, method=solver, raise_on_failure=False).drive_result().drive


def _pairs(train: Train, case: TrainCase) -> tuple[Sequence[tuple[float, float]], float]:
    if case.pulls_given:
        return given_pairs(case), train.belt.speed or nan
    solved = solve_case(train, case, Distributed(capacities=False))
    if not solved.status.solved:
        message = f"load case {case.name}: {solved.reason} {solved.status}"
        raise input_error(key="train", message=message)
    return [(m.arc.entry_tension, m.arc.exit_tension) for m in solved], solved.belt_speed
