"""A train as a drive before anything is solved."""

from __future__ import annotations

from collections.abc import Sequence

from wraparc.drive import Drive, LoadCase, Tensions
from wraparc.train.result import drive_with
from wraparc.train.train import Pulls, Shares, Train, TrainCase, tensions_at


def unsolved_drive(train: Train) -> Drive:
    """Return a train as a drive with the tensions that are known before anything is solved.

    Where the drums turn as given those at both ends are: they stand for the pulleys there.
    """
    cases = []
    for case in train.cases:
        if case.pulls_given:
            pairs = given_pairs(case)
        else:
            first, behind = (case.entry_tension,) * 2, (case.exit_tension,) * 2
            pairs = [first, *[behind] * (len(train.pulleys) - 1)]
        cases.append(load_case(train, case, pairs))
    return drive_with(train, cases)


def load_case(train: Train, case: TrainCase, pairs: Sequence[tuple[float, float]]) -> LoadCase:
    """Return a load case of a train with the tensions of its pulleys."""
    names = [p.name for p in train.pulleys]
    tensions = {n: Tensions(entry=a, exit=b) for n, (a, b) in zip(names, pairs, strict=True)}
    return LoadCase(
        name=case.name,
        kind=case.kind,
        condition=case.condition,
        description=case.description,
        tensions=tensions,
        uncertainty={"": case.uncertainty} if case.uncertainty else {},
    )


def given_pairs(case: TrainCase) -> Sequence[tuple[float, float]]:
    """Return the tensions of the pulleys where their shares or pulls are given [N]."""
    division, total = case.division, case.effective_tension
    if isinstance(division, Shares):
        return tensions_at(case, [f * total for f in division.fractions])
    if isinstance(division, Pulls):
        return tensions_at(case, division.effective_tensions)
    raise TypeError("the load of this case is divided by what turns its drums")
