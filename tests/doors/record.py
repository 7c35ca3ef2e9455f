"""What a door says of a drive, in one form, and where two doors differ."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from doors.verdicts import verdict_of
from wraparc.arc import DriveResult, solve
from wraparc.checks import Check, Level, Verdict, judge
from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.train import Train, TrainResult, solve_train
from wraparc.train.file import load_drive_or_train

#: Relative difference of numbers that is none, and difference [SI] below which there is nothing.
NEAR, NOTHING = 1e-6, 1e-11
#: What is left of rounding: errors of the solution, and where a largest value is that is flat.
ROUNDING = (
    "identity_error", "balance", "train_balance", "peak_shear_position", "gross_slip_creep",
)  # fmt: skip
#: Relative accuracy of what rows search: at a kink of a law it is found no nearer; of shares, and
#: of what is a small difference, absolute.
SEARCHED = {"largest_effective_tension": 1e-3}
SHARES = {"outside_tested_share": 1e-6}
#: Of what these are a small difference, as accurate as that is. Where a belt overruns and then
#: creeps back, friction gives back nearly all the work it took: what is left is a part of the loss.
DIFFERENCE_OF = {
    "creep_global": "exit_creep", "entry_creep_ratio": "exit_creep_ratio",
    "sliding_power": "power_loss", "frictional_energy": "power_loss",
}  # fmt: skip
#: Where a number is: load case and pulley.
Spot = tuple[str, str]


@dataclass(frozen=True, kw_only=True)
class Record:
    """What a door says of a drive; what it does not say is missing.

    Attributes
    ----------
    verdict
        Of the whole drive: any of level, name, pulley, load_case, value, limit, text.
    spots
        Level of each pulley in each load case, and the check that governs there where it is said.
    numbers
        Results by load case, pulley and name [SI]; nan for none, inf for no bound.
    code
        Exit code.
    refusal
        Sentences of what is wrong with the file.
    near
        Relative accuracy of the numbers.
    """

    verdict: Mapping[str, Any] = field(default_factory=dict)
    spots: Mapping[Spot, tuple[str, str | None]] = field(default_factory=dict)
    numbers: Mapping[tuple[str, str, str], float] = field(default_factory=dict)
    code: int | None = None
    refusal: tuple[str, ...] = ()
    near: float = NEAR


@dataclass(frozen=True, eq=False)
class Case:
    """A drive file that every door is asked about."""

    number: int
    document: dict[str, Any]
    path: Path

    @cached_property
    def drive(self) -> Drive | Train:
        """What the file describes; several pulleys are a train."""
        found = load_drive_or_train(str(self.path))
        return Train.of(found) if isinstance(found, Drive) and len(found.pulleys) > 1 else found

    @cached_property
    def refusal(self) -> tuple[str, ...]:
        try:
            _ = self.result
        except InputError as error:
            return tuple(str(replace(problem, file="")) for problem in error.problems)
        return ()

    @cached_property
    def result(self) -> DriveResult | TrainResult:
        if isinstance(self.drive, Train):
            return solve_train(self.drive, raise_on_failure=False)
        return solve(self.drive, raise_on_failure=False)

    @cached_property
    def arcs(self) -> DriveResult:
        """The result pulley by pulley."""
        whole = self.result
        return whole.drive_result() if isinstance(whole, TrainResult) else whole

    @property
    def verdict(self) -> Verdict:
        return judge(self.result)

    @property
    def divided(self) -> bool:
        """Whether drives share their load in every load case: else there are no tensions."""
        whole = self.result
        return not isinstance(whole, TrainResult) or all(case.status.solved for case in whole)

    @cached_property
    def record(self) -> Record:
        """What the library says: all other doors are compared with it."""
        if self.refusal:
            return Record(refusal=self.refusal, code=2)
        verdict = self.verdict
        spots, numbers = {}, dict[tuple[str, str, str], float]()
        for result in self.arcs:
            case, pulley = result.arc.load_case, result.arc.pulley
            own = verdict.at(pulley, case)
            spots[case, pulley] = str(own.level), name_of(own.governing)
            numbers |= {(case, pulley, name): v for name, v in result.scalars().items()}
        return Record(
            verdict=verdict_of(verdict), spots=spots, numbers=numbers, code=code_of(verdict.level)
        )


def code_of(level: Level) -> int:
    return {Level.FAILS: 1, Level.FAULT: 3}.get(level, 0)


def name_of(check: Check | None) -> str:
    return "" if check is None else check.name


def told_of(numbers: Mapping[Any, float], case: Case) -> dict[Any, float]:
    """Return the numbers that the library has too, without those that a door has no word for.

    A door that knows no word for what has no bound leaves it out.
    """
    known = case.record.numbers
    return {
        place: value
        for place, value in numbers.items()
        if place in known and not (math.isnan(value) and math.isinf(known[place]))
    }


def is_equal(one: Any, other: Any, near: float) -> bool:
    if isinstance(one, float) and isinstance(other, float | int):
        if math.isnan(one) or math.isnan(other) or math.isinf(one) or math.isinf(other):
            return one == other or (math.isnan(one) and math.isnan(other))
        return math.isclose(one, other, rel_tol=near, abs_tol=NOTHING)
    return bool(one == other)


def differences(expected: Record, found: Record) -> Iterator[str]:
    """Yield where a door says something else, each with both."""
    if found.refusal or expected.refusal:
        if found.refusal != expected.refusal:
            yield f"refusal: {expected.refusal} and {found.refusal}"
        return
    yield from _verdicts(expected, found)
    for place, value in found.numbers.items():
        if place[-1] in ROUNDING:
            continue
        of_number = expected.numbers.get(place, math.nan)
        near = max(found.near, SEARCHED.get(place[-1], 0.0) if found.near > NEAR else 0.0)
        size = expected.numbers.get((*place[:-1], DIFFERENCE_OF.get(place[-1], "")), 0.0)
        alike = abs(of_number - value) < max(SHARES.get(place[-1], 0.0), near * abs(size))
        if not alike and not is_equal(of_number, value, near):
            yield f"{', '.join(place)}: {of_number!r} and {value!r}"


def _verdicts(expected: Record, found: Record) -> Iterator[str]:
    if found.code is not None and found.code != expected.code:
        yield f"exit code: {expected.code} and {found.code}"
    rounding = expected.verdict.get("name") in ROUNDING
    for key, value in found.verdict.items():
        of = expected.verdict.get(key)
        if not (rounding and key == "value") and not is_equal(of, value, found.near):
            yield f"{key}: {of!r} and {value!r}"
    for spot, (level, name) in found.spots.items():
        of_level, of_name = expected.spots[spot]
        if level != of_level or (name is not None and name != of_name):
            yield f"{', '.join(spot)}: {of_level} {of_name} and {level} {name}"
