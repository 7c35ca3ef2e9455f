"""The one judgement of a solved drive or train."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from weakref import WeakKeyDictionary

from wraparc.arc import ArcResult, DriveResult
from wraparc.checks import of_arc, of_data, of_drive, of_train
from wraparc.checks.check import Check, Level, Place, Verdict
from wraparc.checks.least_tension import LeastTension, least_tension
from wraparc.checks.rule import idle, not_checked
from wraparc.checks.rules import ACROSS_RULES, OF_PULLEY, RULES, spot_of
from wraparc.checks.usual import Owner, owners_of, usual_sizes
from wraparc.drive import Drive, LoadCase
from wraparc.train import Pulls, Train, TrainResult
from wraparc.train.unsolved import unsolved_drive

#: Checks that more tension on the slack side helps against, and those that less does.
RAISING, LOWERING = (
    frozenset(r.name for r in (*RULES.values(), *ACROSS_RULES.values()) if r.tension == way)
    for way in ("raise", "lower")
)
#: The check of an even pulley that stands beside one across the width.
EVEN = {
    "uneven_creep": "creep", "uneven_pressure": "tested_pressure_max",
    "uneven_face_pressure": "face_pressure", "uneven_bond_stress": "bond_stress",
    "uneven_fatigue_stress": "fatigue_stress", "edge_tension": "belt_tension",
}  # fmt: skip
_told: WeakKeyDictionary[DriveResult | TrainResult, Verdict] = WeakKeyDictionary()


def judge(result: DriveResult | TrainResult) -> Verdict:
    """Return every check of a solved drive or train, and so its verdict.

    The same result is judged once, however often it is asked about.
    """
    if result not in _told:
        _told[result] = Verdict(sound(every_check(result), least_tension(result)))
    return _told[result]


def every_check(result: DriveResult | TrainResult) -> tuple[Check, ...]:
    """Return every check, each with all that it may advise."""
    return tuple(_train(result) if isinstance(result, TrainResult) else _drive(result))


def sound(checks: tuple[Check, ...], least: LeastTension | None) -> tuple[Check, ...]:
    """Return checks that advise nothing which does not help, or works against another check.

    A tension is raised or lowered only where one keeps every binding check and this one, and a
    pulley is evened out only where an even one would do.
    """
    missed = [(c.name, c.place) for c in checks if c.missed]
    names = {name for name, _ in missed}
    both = bool(names & RAISING) and bool(names & LOWERING)

    def advised(check: Check) -> Check:
        if (EVEN.get(check.name, ""), check.place) in missed:
            return replace(check, remedy="Mend first what the even pulley lacks: it fails too.")
        if check.missed and check.otherwise and not _helps(check, least, both):
            return replace(check, remedy=check.otherwise)
        return check

    return tuple(map(advised, checks))


def _helps(check: Check, least: LeastTension | None, both: bool) -> bool:
    """Whether another tension helps against what a check misses."""
    if least is None:
        return not both
    own = next((f for f in least.figures if f.name == check.name), None)
    if own is None and both:  # across the width: one asks for more, another for less
        return False
    helps = own is None or not own.at_least or own in least.required
    return math.isfinite(least.tension) and helps


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
    yield from diameters(drive)
    yield from usual_sizes(drive, *others)
    for pulley in drive.pulleys:
        yield of_data.data(drive, pulley)
    yield from of_data.belt_mass(drive)


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
        if check.name == "fight" and check.missed and check.place.load_case in failing:
            case = result.train.case(check.place.load_case)
            if check.more["lost"][0] > of_train.FIGHTS * abs(case.effective_tension):
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
            title = of_arc.GRIP.format(result.train.case(check.place.load_case).kind)
            yield not_checked(check.name, title, of_train.NO_DIVISION, check.place)
        else:
            yield check
