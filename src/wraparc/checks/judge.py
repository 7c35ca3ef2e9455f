"""The one judgement of a solved drive or train."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from weakref import WeakKeyDictionary

from wraparc.arc import ArcResult, DriveResult
from wraparc.checks import of_arc, of_data, of_drive, of_train
from wraparc.checks.case_kind import case_kinds
from wraparc.checks.check import Check, Level, Place
from wraparc.checks.rule import idle, not_checked
from wraparc.checks.rules import OF_PULLEY, spot_of
from wraparc.checks.usual import Owner, owners_of, usual_sizes
from wraparc.checks.verdict import Verdict
from wraparc.drive import Drive, LoadCase
from wraparc.train import Pulls, Train, TrainResult
from wraparc.train.unsolved import unsolved_drive

_verdicts: WeakKeyDictionary[DriveResult | TrainResult, Verdict] = WeakKeyDictionary()


def judge(result: DriveResult | TrainResult) -> Verdict:
    """Return every check of a solved drive or train, and so its verdict.

    The same result is judged once, however often it is asked about.
    """
    if result not in _verdicts:
        _verdicts[result] = Verdict(_placed(every_check(result), _conditions(result)))
    return _verdicts[result]


def every_check(result: DriveResult | TrainResult) -> tuple[Check, ...]:
    """Return every check at every place."""
    return tuple(_train(result) if isinstance(result, TrainResult) else _drive(result))


def _conditions(result: DriveResult | TrainResult) -> dict[str, str]:
    """Return the condition of every load case, where several are solved."""
    cases = result.train.cases if isinstance(result, TrainResult) else result.drive.load_cases
    conditions = {case.name: case.condition for case in cases}
    return conditions if len(set(conditions.values())) > 1 else {}


def _placed(checks: tuple[Check, ...], conditions: dict[str, str]) -> tuple[Check, ...]:
    """Return checks with the conditions of their load cases."""
    if not conditions:
        return checks
    return tuple(
        replace(check, place=check.place._replace(condition=conditions[check.place.load_case]))
        if check.place.load_case in conditions
        else check
        for check in checks
    )


def before(described: Drive | Train) -> Verdict:
    """Return the checks of a drive or train that need no solving.

    Where the load of a train is found by solving, its tensions are known at both ends alone.
    """
    drive = described if isinstance(described, Drive) else unsolved_drive(described)
    cases = () if isinstance(described, Drive) else described.cases
    divided = {case.name for case in cases if not case.pulls_given}
    checks: list[Check] = [of_data.data(drive, p) for p in drive.pulleys]
    checks += of_data.belt_mass(drive)
    checks += usual_sizes(drive, *(owners_of(described) if isinstance(described, Train) else ()))
    checks += of_drive.take_up(drive)
    checks += case_kinds(drive)
    checks += diameters(drive)
    for case in drive.load_cases:
        there = drive.in_case(case)
        ends = (there.pulleys[0], there.pulleys[-1])
        for pulley in ends if case.name in divided else there.pulleys:
            spot = spot_of(there, case, pulley)
            rules = (rule for rule in OF_PULLEY if not rule.pulls)
            checks += (check for rule in rules for check in rule.checks(spot))
    return Verdict(tuple(checks))


def diameters(drive: Drive) -> Iterator[Check]:
    """Yield whether each pulley is as large as its belt asks for."""
    for pulley in drive.pulleys:
        spot = spot_of(drive, drive.load_cases[0], pulley)
        yield from of_drive.PULLEY_DIAMETER.checks(replace(spot, place=Place(pulley.name)))


def _drive(result: DriveResult, *others: Owner) -> Iterator[Check]:
    drive = result.drive
    cases = {case.name: case for case in drive.load_cases}
    by_case: dict[str, list[ArcResult]] = {}
    for arc in result:
        by_case.setdefault(arc.arc.load_case, []).append(arc)
    for name, arcs in by_case.items():
        yield from _case(drive.in_case(cases[name]), cases[name], arcs)
    if any(pulley.across for pulley in drive.pulleys):
        yield from _across(result)
    yield from of_drive.take_up(drive)
    yield from case_kinds(drive)
    yield from diameters(drive)
    yield from usual_sizes(drive, *others)
    for pulley in drive.pulleys:
        yield of_data.data(drive, pulley)
    yield from of_data.belt_mass(drive)
    yield from of_drive.reserve(drive)


def _across(result: DriveResult) -> Iterator[Check]:
    """Yield what only an uneven pulley can miss; its solver is loaded for one alone."""
    from wraparc.across import across_of
    from wraparc.checks.of_across import across

    for uneven in across_of(result):
        case = result.drive.load_case(uneven.wide.arc.load_case)
        yield from across(result.drive.in_case(case), case, uneven)


def _case(drive: Drive, case: LoadCase, arcs: list[ArcResult]) -> Iterator[Check]:
    for index, result in enumerate(arcs):
        pulley = drive.pulley(result.arc.pulley)
        yield of_arc.grip(drive, case, arcs, index)
        spot = spot_of(drive, case, pulley, result)
        for rule in OF_PULLEY:
            yield from rule.checks(spot)
        if all(idle(arc.arc) for arc in arcs) or (result.arc.side < 0.0 and not idle(result.arc)):
            yield of_drive.sense(case, pulley)


def _train(result: TrainResult) -> Iterator[Check]:
    checks = [*_of_members(result)]
    failing = {check.place.load_case for check in checks if check.level is Level.FAILS}
    for check in checks:
        opposing = check.name == "opposing_drives" and check.missed
        if opposing and check.place.load_case in failing:
            case = result.train.case(check.place.load_case)
            if check.value > of_train.OPPOSES * abs(case.effective_tension):
                yield replace(check, level=Level.FAILS)
                continue
        yield check


def _of_members(result: TrainResult) -> Iterator[Check]:
    for case in result:
        yield from of_train.of_case(result.train, case)
        if isinstance(case.case.division, Pulls):
            yield from of_train.meetings(case)
    adrift = {case.case.name for case in result if case.adrift}
    for check in _drive(result.drive_result(), *owners_of(result.train)):
        if check.name == "gross_slip" and check.place.load_case in adrift:
            why = of_train.NO_DIVISION
            yield not_checked(check.name, of_arc.GRIP, of_arc.GRIP_NOUN, check.place, why=why)
        else:
            yield check
