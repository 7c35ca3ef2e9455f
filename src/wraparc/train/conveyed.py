"""The load cases of several drives by the conveyor that they drive."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isnan
from typing import TYPE_CHECKING, Any

from wraparc.conveyor import Conveyor, State, course_state, standard_cases
from wraparc.conveyor.uncertain import uncertain_tensions
from wraparc.drive import Belt, Drive, TakeUp
from wraparc.files.conveyor_build import described_conveyor
from wraparc.schema.problems import Report
from wraparc.schema.tables import Record
from wraparc.train.train import Division, Shares, Train, TrainCase

if TYPE_CHECKING:
    from wraparc.train.result import TrainResult

#: Keys of [train] that the conveyor gives.
_COMPUTED = ("entry_tension", "exit_tension", "effective_tension", "power", "run", "uncertainty")


def build_train_conveyor(
    record: Record, belt: Belt | None, take_up: TakeUp, report: Report
) -> Conveyor | None:
    """Return the conveyor that a train drives; what is wrong is reported."""
    train = record.get("train")
    if isinstance(train, Record):
        message = "the [conveyor] table gives the tensions already"
        for key in (key for key in _COMPUTED if key in train):
            remedy = "Leave it out, or the [conveyor] table."
            report.add((*train.place, key), message, remedy, train.raw[key])
    return described_conveyor(record, belt, take_up, report)


def conveyor_cases(
    conveyor: Conveyor, division: Division, record: Record, report: Report
) -> tuple[Conveyor, list[TrainCase]]:
    """Return a conveyor with the shares of its drives, and its load cases as those of a train.

    Where speeds or motors divide the load, the tensions between the drives follow once they are
    solved; the take-up must then stand outside of them.

    Parameters
    ----------
    conveyor
        With its drives.
    division
        What divides the load.
    record
        The table of the conveyor.
    report
        Takes what is wrong.
    """
    count = len(conveyor.drives)
    given = isinstance(division, Shares)
    shares = division.fractions if isinstance(division, Shares) else (1.0 / count,) * count
    drives = zip(conveyor.drives, shares, strict=True)
    conveyor = replace(conveyor, drives=tuple(replace(d, share=s) for d, s in drives))
    if not given and conveyor.take_up_behind is not None:
        message = f"is between the drives, behind {conveyor.take_up_behind}"
        remedy = "List [[pulley]] from the take-up on, or write share in [train]."
        report.add((*record.place, "take_up_distance"), message, remedy)
    states = report.tried(conveyor.states, record.place, record.raw) or ()
    every = zip(states, uncertain_tensions(conveyor, states), strict=True)
    cases = report.tried(lambda: [_train_case(s, division, of) for s, of in every], record.place)
    return conveyor, cases or []


def _train_case(state: State, division: Division, uncertainty: Mapping[str, float]) -> TrainCase:
    """Return a load case of a conveyor as one of a train."""
    drives = state.drives
    runs = tuple(
        drives[i + 1].entry - drives[i].exit for i in range(len(drives) - 1)
    )  # fmt: skip
    if isinstance(division, Shares):
        division = Shares(tuple(drive.share for drive in drives))
    kind: Any = state.kind
    return TrainCase(
        name=state.name,
        entry_tension=state.entry,
        exit_tension=state.exit,
        division=division,
        runs=runs,
        kind=kind,
        uncertainty=uncertainty,
    )


def train_take_up(take_up: TakeUp, conveyor: Conveyor) -> TakeUp:
    """Return the take-up of a train, with the pulley behind which that of its conveyor stands."""
    behind = conveyor.take_up_behind
    return take_up if behind is None else replace(take_up, after=behind)


def conveyor_states(
    train: Train, shares: Mapping[str, Sequence[float]] | None = None
) -> tuple[State, ...]:
    """Return the load cases of the conveyor of a train that are still its own.

    Parameters
    ----------
    train
        The train.
    shares
        How the drives were found to share, by load case; as the conveyor has it if left out.
    """
    conveyor = train.conveyor
    if conveyor is None:
        return ()
    cases = {case.name: case for case in train.cases}
    own = {name.removesuffix(f", {c.condition}") if c.condition else name: c
           for name, c in cases.items()}  # fmt: skip
    full = conveyor.reckoned()[0].pull
    found: list[State] = []
    for case in standard_cases(conveyor):
        if case.name not in own:
            continue
        part = (shares or {}).get(own[case.name].name)
        now = conveyor
        if part is not None:
            drives = zip(conveyor.drives, part, strict=True)
            places = (replace(d, share=s, brake_share=None) for d, s in drives)
            now = replace(conveyor, drives=tuple(places))
        state = course_state(now, case, full)
        if _is_same(state, own[case.name]):
            found.append(state)
    return tuple(found)


def _is_same(state: State, case: TrainCase) -> bool:
    size = 1e-6 * max(case.entry_tension, case.exit_tension)
    ends = (state.entry - case.entry_tension, state.exit - case.exit_tension)
    return all(abs(end) <= size for end in ends)


def states_of(of: Drive | Train, result: "TrainResult | None" = None) -> tuple[State, ...]:
    """Return the load cases that still are what the conveyor gave."""
    if isinstance(of, Train):
        return conveyor_states(of, None if result is None else _shares(result))
    if of.conveyor is None or len(of.pulleys) != 1:
        return ()
    name = of.pulleys[0].name
    given = {
        case.name.removesuffix(f", {case.condition}"): case.tensions[name]
        for case in of.load_cases  # once for each of several conditions
    }
    return tuple(
        state
        for state in of.conveyor.states()
        if state.name in given
        and (given[state.name].entry, given[state.name].exit) == (state.entry, state.exit)
    )


def _shares(result: "TrainResult") -> Mapping[str, Sequence[float]]:
    """Return the shares of the drives by load case, of those that were solved."""
    return {
        case.case.name: case.shares
        for case in result
        if not any(isnan(share) for share in case.shares)
    }
