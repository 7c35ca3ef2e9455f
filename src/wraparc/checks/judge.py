"""The one judgement of a solved drive or train."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from weakref import WeakKeyDictionary

from wraparc.arc import ArcResult, DriveResult
from wraparc.checks import of_arc, of_data, of_drive
from wraparc.checks.check import Check, Level, Place, Verdict, escaped
from wraparc.checks.gross_slip import wet
from wraparc.checks.least_tension import LeastTension, least_tension
from wraparc.checks.numbers import (
    kept,
    pull_against,
)
from wraparc.checks.rules import RULES, idle
from wraparc.checks.usual import Owner, of_train, usual_sizes
from wraparc.drive import Drive, LoadCase, Pulley
from wraparc.train import (
    CaseResult,
    Division,
    MemberResult,
    Motor,
    Motors,
    Pulls,
    Shares,
    TorqueFollower,
    Train,
    TrainCase,
    TrainResult,
    TrainStatus,
)
from wraparc.train.unsolved import unsolved_drive

#: Checks that more tension on the slack side helps against, and those that less does.
RAISING = frozenset({
    "gross_slip", "design_standard", "creep", "cover_creep", "creep_interval", "tested_slip",
    "tested_pressure_min", "sag", "uneven_creep",
})  # fmt: skip
LOWERING = frozenset({
    "belt_tension", "momentary_tension", "belt_safety", "face_pressure", "tested_pressure_max",
    "edge_tension", "uneven_pressure", "uneven_face_pressure",
})  # fmt: skip
#: The check of an even pulley that stands beside one across the width.
EVEN = {
    "uneven_creep": "creep", "uneven_pressure": "tested_pressure_max",
    "uneven_face_pressure": "face_pressure", "uneven_bond_stress": "bond_stress",
    "uneven_fatigue_stress": "fatigue_stress", "edge_tension": "belt_tension",
}  # fmt: skip
#: Largest relative miss of tensions, speeds and torques that a solved train is trusted with [-].
TRAIN_BALANCE = 1e-5
#: Pull of drives against each other over that of all from which it leads what else fails [-]; ours.
FIGHTS = 0.1
#: Titles of the checks that only a train has.
FIGHT = "Drives work together"
NO_DIVISION = "no division of the load is found"
_MOTOR = {
    False: "Motor torque over rated torque, running",
    True: "Motor torque over rated torque, momentary",
}
MOMENTARY_SOURCE = (
    "IEC 60034-1: 1.6 times the rated torque for 15 s; no stall at 90 % of the voltage (NEMA MG "
    "1-12.44, condensed edition of 2011: torque falls with its square)"
)
BALANCE = "Tensions, speeds and torques of the train agree"

_told: WeakKeyDictionary[DriveResult | TrainResult, Verdict] = WeakKeyDictionary()


def judge(result: DriveResult | TrainResult) -> Verdict:
    """Return every check of a solved drive or train, and so its verdict.

    The same result is judged once, however often it is asked about.
    """
    if result not in _told:
        verdict = Verdict(sound(every_check(result), least_tension(result)))
        if verdict.level is Level.OK:
            one = result.drive_result() if isinstance(result, TrainResult) else result
            most, over = _wet(one)
            verdict = replace(verdict, wet=most, over_wet=over)
        _told[result] = verdict
    return _told[result]


def every_check(result: DriveResult | TrainResult) -> tuple[Check, ...]:
    """Return every check, each with all that it may advise."""
    return tuple(_train(result) if isinstance(result, TrainResult) else _drive(result))


def _wet(result: DriveResult) -> tuple[float, bool]:
    """Largest creep when wet of a drive that was computed dry only, and whether one is too large.

    See `Verdict.wet`.
    """
    most, over, drive = -1.0, False, result.drive
    for arc in result:
        condition = drive.load_case(arc.arc.load_case).condition
        factor = of_data.wet_factor(drive.pulley(arc.arc.pulley).lagging_in(condition))
        if factor == 0.0:
            return -1.0, False
        if not idle(arc.arc):
            creep = wet(arc, factor)
            most = creep if math.isnan(creep) else max(most, creep)
            over = over or not (math.isnan(creep) or kept(creep, arc.arc.creep_limit, True))
    return most, over


def sound(checks: tuple[Check, ...], least: LeastTension | None) -> tuple[Check, ...]:
    """Return checks that advise nothing which does not help, or works against another check.

    A tension is raised or lowered only where one keeps every binding check, and a pulley is evened
    out only where an even one would do.
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
    top = least.highest
    too_much = own is not None and top is not None and own.at_least and own.tension > top.tension
    return math.isfinite(least.tension) and not too_much


def before(described: Drive | Train) -> Verdict:
    """Return the checks of a drive or train that need no solving.

    Where the load of a train is found by solving, its tensions are known at both ends alone.
    """
    drive = described if isinstance(described, Drive) else unsolved_drive(described)
    cases = () if isinstance(described, Drive) else described.cases
    divided = {case.name for case in cases if not case.pulls_given}
    checks: list[Check] = [of_data.data(drive, p) for p in drive.pulleys]
    checks += usual_sizes(drive, *(of_train(described) if isinstance(described, Train) else ()))
    checks += of_drive.take_up(drive)
    checks += (of_drive.pulley_diameter(drive, p) for p in drive.pulleys)
    for case in drive.load_cases:
        there = drive.in_case(case)
        known = (there.pulleys[0], there.pulleys[-1]) if case.name in divided else there.pulleys
        checks += _unsolved(there, case, known)
    return Verdict(tuple(checks))


def _unsolved(drive: Drive, case: LoadCase, pulleys: Sequence[Pulley]) -> Iterator[Check]:
    for pulley in pulleys:
        yield from of_drive.of_belt(drive, case, pulley)
        yield from of_drive.tested_pressure(drive, case, pulley)
        yield from of_data.condition(case, pulley)
        yield from of_data.fit(case, pulley)
    found = of_drive.sag(drive, case)
    if found is not None:
        yield found


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
    for pulley in drive.pulleys:
        yield of_drive.pulley_diameter(drive, pulley)
    yield from usual_sizes(drive, *others)
    for pulley in drive.pulleys:
        yield of_data.data(drive, pulley)


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
        found = (
            of_arc.grip(drive, case, arcs, index),
            of_arc.standard(drive, case, result),
            of_arc.creep(drive, result),
            of_arc.cover_creep(result),
            of_arc.creep_interval(drive, result),
        )
        yield from (check for check in found if check is not None)
        yield from of_drive.of_belt(drive, case, pulley)
        yield from of_arc.lagging_stress(pulley, result)
        yield from of_drive.tested_pressure(drive, case, pulley)
        yield from of_data.condition(case, pulley)
        yield from of_data.fit(case, pulley)
        yield from of_arc.tested_slip(pulley, result)
        if all(idle(arc.arc) for arc in arcs) or (result.arc.side < 0.0 and not idle(result.arc)):
            yield of_drive.sense(case, pulley)
        balanced = of_arc.balance(result)
        if balanced is not None:
            yield balanced
    sag = of_drive.sag(drive, case)
    if sag is not None:
        yield sag


def _meeting(case: CaseResult) -> Iterator[Check]:
    """Yield what is asked about pulleys that each give their tensions."""
    for one, other in pairwise(m.arc.arc for m in case.members):
        ends = one.exit_tension, other.pulley, other.entry_tension
        place = Place(other.pulley, case.case.name)
        yield from of_drive.meeting(one.pulley, *ends, place)


def _train(result: TrainResult) -> Iterator[Check]:
    checks = [*_of_members(result)]
    failing = {check.place.load_case for check in checks if check.level is Level.FAILS}
    for check in checks:
        if check.name == "fight" and check.missed and check.place.load_case in failing:
            case = result.train.case(check.place.load_case)
            if check.more["lost"][0] > FIGHTS * abs(case.effective_tension):
                yield replace(check, level=Level.FAILS)
                continue
        yield check


def _of_members(result: TrainResult) -> Iterator[Check]:
    for case in result:
        yield from _of_train(result.train, case)
        if isinstance(case.case.division, Pulls):
            yield from _meeting(case)
    adrift = {case.case.name for case in result if case.adrift}
    for check in _drive(result.drive_result(), *of_train(result.train)):
        if check.name == "gross_slip" and check.place.load_case in adrift:
            title = of_arc.GRIP.format(result.train.case(check.place.load_case).kind)
            yield of_drive.not_checked(check.name, title, NO_DIVISION, check.place)
        else:
            yield check


def _of_train(train: Train, case: CaseResult) -> Iterator[Check]:
    """Yield what only a train can miss: motors, drives that fight, the balance of the whole."""
    place = Place("", case.case.name)
    if case.adrift or case.status in (TrainStatus.BEYOND_MOTOR, TrainStatus.UNSOLVED):
        overrun = any(
            m.motor is not None and m.motor.motor_load < 0.0 and not motor.brakes
            for m, motor in zip(case.members, _motors(case.case), strict=False)
            if isinstance(motor, Motor)
        )
        yield operating_point(case.status, case.reason, place, overrun=overrun)
    several = len(case.members) > 1
    if not case.status.solved:
        yield from not_working(place) if several else ()
        return
    if several:
        lost = pull_against([m.arc.effective_tension for m in case.members])
        yield fight(lost, place, case.case.division)
        driven = [
            p for p, m in zip(train.pulleys, case.members, strict=True) if not idle(m.arc.arc)
        ]
        yield from of_drive.unknown_trims(train.belt, driven, place)
    yield train_balance(max(case.tension_error, case.speed_error), place)
    motors = _motors(case.case)
    driven_by = [*zip(case.members, motors, strict=False)]
    helps = not all(_motor(m, motor, case.case, True).missed for m, motor in driven_by)
    yield from (_motor(m, motor, case.case, helps) for m, motor in driven_by)


def _motors(case: TrainCase) -> Sequence[Motor | TorqueFollower]:
    return case.division.motors if isinstance(case.division, Motors) else ()


def _motor(
    member: MemberResult, motor: Motor | TorqueFollower, case: TrainCase, helps: bool
) -> Check:
    """Check the torque of the motors of a drum; a drive that follows another states no rating."""
    at, momentary = Place(member.name, case.name), case.kind != "running"
    if member.motor is None or not isinstance(motor, Motor):
        return unrated(momentary, at)
    return motor_load(member.motor.motor_load, motor.bears(momentary), momentary, at, helps)


def unrated(momentary: bool, place: Place) -> Check:
    """Return that motors were not judged whose rating is not given."""
    name = "momentary_load" if momentary else "motor_load"
    why = "a drive that follows another gives no rating of its motors"
    return of_drive.not_checked(name, _MOTOR[momentary], why, place)


def motor_load(load: float, most: float, momentary: bool, place: Place, helps: bool) -> Check:
    """Check the torque of motors over their rated torque against what they bear [-].

    `helps` is whether another division of the load does: not where every motor bears too much.
    """
    title = _MOTOR[momentary]
    remedy = "Divide the load otherwise (diameters, speeds, torque sharing), or take larger motors."
    if not helps:
        remedy = "Take larger motors: no other division of the load helps."
    if momentary:
        other = "divide the load otherwise, " if helps else ""
        remedy = f"Start and stop more slowly, {other}or take larger motors."
    return of_drive.judged(
        RULES["momentary_load" if momentary else "motor_load"],
        title,
        abs(load),
        most,
        "number",
        source=MOMENTARY_SOURCE if momentary else "rating of the motor, continuous duty",
        short="motor overloaded",
        says="The motors work at {percent} % of their rated torque, and may at {most} %.",
        because="The usual service factor, 1.15, does not cover that (NEMA MG 1-14.37: up to that "
        "of the nameplate).",
        remedy=remedy,
        more={"percent": (100.0 * abs(load), "number"), "most": (100.0 * most, "number")},
        place=place,
    )


def operating_point(
    status: TrainStatus, reason: str, place: Place, *, overrun: bool = False
) -> Check:
    """Return the check that a train without an operating point misses.

    `overrun` is whether a motor that cannot hold back is asked to.
    """
    says, _, remedy = str(status).partition(". ")
    if overrun:
        remedy = f"Set brakes = true for its motor if its drive can hold back. {remedy}"
    fault = status is TrainStatus.UNSOLVED
    shorts = {TrainStatus.BREAKAWAY: "gross slip", TrainStatus.BEYOND_MOTOR: "beyond a motor"}
    return Check(
        name="operating_point",
        title="Operating point of the drives",
        level=Level.FAULT if fault else Level.FAILS,
        short=shorts.get(status, "not solved"),
        says=escaped(f"{reason} {says}.".strip()),
        remedy=escaped(remedy),
        place=place,
    )


def not_working(place: Place) -> Iterator[Check]:
    """Yield what is not checked of drives that do not carry the load."""
    for name, title in (("fight", FIGHT), ("train_balance", BALANCE)):
        yield of_drive.not_checked(name, title, "the drives do not carry the load", place)


def fight(lost: float, place: Place, division: Division) -> Check:
    """Check that drives work together: so much pull is against each other [N]."""
    fights = lost > 0.0
    remedy = "Bring their speeds closer together, or divide the load by torque."
    if isinstance(division, Shares):
        remedy = "Correct the shares: one below 0 % brakes against the others."
    elif isinstance(division, Pulls):
        remedy = "Correct the tensions: one of the pulleys is given as braking."
    return Check(
        name="fight",
        title=FIGHT,
        level=Level.ATTENTION if fights else Level.OK,
        short="drives fight" if fights else "",
        says="The drives work against each other with {lost} of pull." if fights else "",
        remedy=remedy if fights else "",
        more={"lost": (lost, "force")},
        place=place,
    )


def train_balance(error: float, place: Place) -> Check:
    """Check that tensions, speeds and torques of a solved train agree."""
    return of_drive.judged(
        RULES["train_balance"],
        BALANCE,
        error,
        TRAIN_BALANCE,
        "number",
        source="tolerance of the program",
        short="out of balance",
        says="Tensions, speeds and torques of the train miss each other by {value}.",
        remedy="Please report the drive file; until then change a value slightly.",
        binding=False,
        place=place,
    )
