"""Checks that only several drives on one belt can miss: motors, drives that fight, the balance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from wraparc.arrays import Number
from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.numbers import pull_against
from wraparc.checks.of_drive import meeting, unknown_trims
from wraparc.checks.rule import Rule, State, Words, idle, not_checked
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
    TrainStatus,
)

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


def of_case(train: Train, case: CaseResult) -> Iterator[Check]:
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
        yield from unknown_trims(train.belt, driven, place)
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


def meetings(case: CaseResult) -> Iterator[Check]:
    """Yield what is asked about pulleys that each give their tensions."""
    for one, other in pairwise(m.arc.arc for m in case.members):
        ends = one.exit_tension, other.pulley, other.entry_tension
        place = Place(other.pulley, case.case.name)
        yield from meeting(one.pulley, *ends, place)


def unrated(momentary: bool, place: Place) -> Check:
    """Return that motors were not judged whose rating is not given."""
    name = "momentary_load" if momentary else "motor_load"
    why = "a drive that follows another gives no rating of its motors"
    return not_checked(name, _MOTOR[momentary], why, place)


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
    words = Words(
        title=title,
        source=MOMENTARY_SOURCE if momentary else "rating of the motor, continuous duty",
        short="motor overloaded",
        says="The motors work at {percent} % of their rated torque, and may at {most} %.",
        because="The usual service factor, 1.15, does not cover that (NEMA MG 1-14.37: up to that "
        "of the nameplate).",
        remedy=remedy,
        more={"percent": (100.0 * abs(load), "number"), "most": (100.0 * most, "number")},
    )
    return (MOMENTARY_LOAD if momentary else MOTOR_LOAD).judged(abs(load), most, place, words)


def _motor_torque(state: State[Number]) -> Number:
    return state.motor


MOTOR_LOAD = Rule("motor_load", "the rating of a motor", fails_beyond=1.15, value=_motor_torque)
MOMENTARY_LOAD = Rule(
    "momentary_load", "the torque that a motor bears in a start", value=_motor_torque
)
MOTOR_HEAT = Rule("motor_heat", "the heat that a motor bears", dimension="time", of_rows=False)
OF_MOTORS = (MOTOR_LOAD, MOMENTARY_LOAD, MOTOR_HEAT)


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
        yield not_checked(name, title, "the drives do not carry the load", place)


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
    words = Words(
        title=BALANCE,
        source="tolerance of the program",
        short="out of balance",
        says="Tensions, speeds and torques of the train miss each other by {value}.",
        remedy="Please report the drive file; until then change a value slightly.",
    )
    return TRAIN_BALANCE_RULE.judged(error, TRAIN_BALANCE, place, words)


TRAIN_BALANCE_RULE = Rule(
    "train_balance", "the balance of the train", missed=Level.FAULT, binding=False, of_rows=False
)
