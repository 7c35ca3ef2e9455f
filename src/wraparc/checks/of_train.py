"""Checks that only several drives on one belt can miss: motors, opposing drives, the balance."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from wraparc.arrays import Number
from wraparc.checks.check import Amount, Check, Level, Place, escaped
from wraparc.checks.numbers import pull_against
from wraparc.checks.of_arc import REPORT
from wraparc.checks.of_drive import meeting, unknown_trims
from wraparc.checks.rule import CheckText, Rule, State, idle, not_checked
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
from wraparc.train.turning import beyond_motor

#: Largest relative miss of tensions, speeds and torques that a solved train is trusted with [-].
TRAIN_BALANCE = 1e-5
#: Tension that drives oppose each other with over Te from which it fails with others [-]; ours.
OPPOSES = 0.1
#: Titles of the checks that only a train has.
OPPOSING = "Opposing drives"
NO_DIVISION = "load not divided"
_MOTOR = {False: "Motor torque, running", True: "Motor torque, momentary"}
MOMENTARY_SOURCE = (
    "IEC 60034-1: 1.6 times the rated torque for 15 s; no stall at 90 % of the voltage (NEMA MG "
    "1-12.44, condensed edition of 2011: torque falls with its square)"
)
BALANCE = "Balance of drives"


def of_case(train: Train, case: CaseResult) -> Iterator[Check]:
    """Yield what only a train can miss: motors, opposing drives, the balance of the whole."""
    place = Place("", case.case.name)
    if case.adrift or case.status in (TrainStatus.BEYOND_MOTOR, TrainStatus.UNSOLVED):
        overrun = any(
            m.motor is not None and m.motor.motor_load < 0.0 and not motor.brakes
            for m, motor in zip(case.members, _motors(case.case), strict=False)
            if isinstance(motor, Motor)
        )
        beyond = _beyond(case)
        at = place if beyond is None else place._replace(pulley=beyond.name)
        yield operating_point(case.status, case.reason, at, overrun=overrun, beyond=beyond)
    several = len(case.members) > 1
    if not case.status.solved:
        yield from not_working(place) if several else ()
        return
    if several:
        lost = pull_against([m.arc.effective_tension for m in case.members])
        yield check_opposing_drives(lost, place, case.case.division)
        driven = [
            p for p, m in zip(train.pulleys, case.members, strict=True) if not idle(m.arc.arc)
        ]
        yield from unknown_trims(train.belt, driven, place)
    yield train_balance(max(case.tension_error, case.speed_error), place)
    motors = _motors(case.case)
    driven_by = [*zip(case.members, motors, strict=False)]
    helps = not all(_motor(m, motor, case.case, True).missed for m, motor in driven_by)
    yield from (_motor(m, motor, case.case, helps) for m, motor in driven_by)


class Beyond(NamedTuple):
    """A motor that would have to leave its curve: its pulley, and loads in rated torques [-]."""

    name: str
    load: float
    end: float


def _beyond(case: CaseResult) -> Beyond | None:
    """Return the first motor that would have to leave its curve, of a train that ends at it."""
    if case.status is not TrainStatus.BEYOND_MOTOR:
        return None
    for member, motor in zip(case.members, _motors(case.case), strict=False):
        point, turns = member.motor, member.rotation_speed
        if not isinstance(motor, Motor) or point is None:
            continue
        if beyond_motor(member.name, turns, motor, point):
            low, high = motor.limits()
            end = high if point.motor_load > 0.0 else -low
            return Beyond(member.name, abs(point.motor_load), end)
    return None


def _motors(case: TrainCase) -> Sequence[Motor | TorqueFollower]:
    return case.division.motors if isinstance(case.division, Motors) else ()


def _motor(
    member: MemberResult, motor: Motor | TorqueFollower, case: TrainCase, helps: bool
) -> Check:
    """Check the torque of the motors of a drum; a drive that follows another states no rating."""
    at, momentary = Place(member.name, case.name), case.kind != "running"
    if member.motor is None or not isinstance(motor, Motor):
        return unrated(momentary, at)
    load, most = member.motor.motor_load, motor.bears(momentary)
    return motor_load(load, most, momentary, at, helps, motor.rated_power)


def meetings(case: CaseResult) -> Iterator[Check]:
    """Yield what is asked about pulleys that each give their tensions."""
    for one, other in pairwise(m.arc.arc for m in case.members):
        ends = one.exit_tension, other.pulley, other.entry_tension
        place = Place(other.pulley, case.case.name)
        yield from meeting(one.pulley, *ends, place)


def unrated(momentary: bool, place: Place) -> Check:
    """Return that motors were not judged whose rating is not given."""
    name = "momentary_load" if momentary else "motor_load"
    title = _MOTOR[momentary]
    return not_checked(name, title, MOTOR_NOUN, place, why="a follower has no motor rating")


MOTOR_NOUN = "motor torque"


def motor_load(
    load: float, most: float, momentary: bool, place: Place, helps: bool, power: float
) -> Check:
    """Check the torque of motors over their rated torque against what they bear [-].

    Parameters
    ----------
    load, most
        Torque over rated torque, and what is allowed.
    momentary, place
        As the check has them.
    helps
        Whether another division of the load does: not where every motor bears too much.
    power
        Rated power of each motor; nan if unknown [W].
    """
    more = "motors of {times} times this torque"
    action = f"Try a slower start, or {more}." if momentary else f"Use {more}."
    if helps and not momentary:
        action = f"Try torque sharing, or {more}."
    if math.isfinite(power):
        action = "Use motors of {power} or more (now {rated})."
    text = CheckText(
        title=_MOTOR[momentary],
        noun=MOTOR_NOUN,
        source=MOMENTARY_SOURCE if momentary else "rating of the motor, continuous duty",
        label="motor torque",
        headline="Motor torque {value} exceeds the {limit} "
        + ("momentary limit" if momentary else "rating"),
        action=action,
        full=""
        if momentary
        else "Above 115 % no usual service factor covers it (NEMA MG 1-14.37).",
        more={
            "power": Amount(power * abs(load) / most, "power", "up"),
            "times": Amount(abs(load) / most, "number", "up"),
            "rated": Amount(power, "power"),
        },
    )
    return (MOMENTARY_LOAD if momentary else MOTOR_LOAD).compare(abs(load), most, place, text)


def _motor_torque(state: State[Number]) -> Number:
    return state.motor


MOTOR_LOAD = Rule(
    "motor_load", "the rating of a motor", fails_beyond=1.15, is_percent=True, value=_motor_torque
)
MOMENTARY_LOAD = Rule(
    "momentary_load", "the momentary torque of a motor", is_percent=True, value=_motor_torque
)
MOTOR_HEAT = Rule("motor_heat", "the heating limit of a motor", dimension="time", of_rows=False)
OF_MOTORS = (MOTOR_LOAD, MOMENTARY_LOAD, MOTOR_HEAT)


def operating_point(
    status: TrainStatus,
    reason: str,
    place: Place,
    *,
    overrun: bool = False,
    beyond: Beyond | None = None,
) -> Check:
    """Return the check that a train without an operating point misses.

    `overrun` is whether a motor that cannot hold back is asked to, `beyond` a motor whose curve
    ends before its load.
    """
    fault = status is TrainStatus.UNSOLVED
    headline, label, action = _NO_POINT[status]
    load = end = math.nan
    if beyond is not None and not overrun:
        headline = "Motor torque {value} exceeds {limit}, the end of its curve"
        load, end = beyond.load, beyond.end
    return Check(
        name="operating_point",
        title="Operating point",
        noun="operating point",
        level=Level.FAULT if fault else Level.FAILS,
        label=label,
        headline="The belt drives the motors: no operating point" if overrun else headline,
        action="Set brakes = true if the drive can brake." if overrun else action,
        full=escaped(reason),
        place=place,
        value=load,
        limit=end,
        is_percent=True,
    )


#: What a train says that has no operating point, in a few words, and what to do.
_NO_POINT = {
    TrainStatus.BREAKAWAY: ("Gross slip: one drive cannot transmit its share", "gross slip", ""),
    TrainStatus.BEYOND_MOTOR: (
        "Motor limit reached: no operating point", "motor limit", "Try another speed or motor."
    ),
    TrainStatus.UNSOLVED: ("No solution", "not solved", REPORT),
}  # fmt: skip


def not_working(place: Place) -> Iterator[Check]:
    """Yield what is not checked of drives that do not carry the load."""
    for name, title, noun in (
        ("opposing_drives", OPPOSING, "opposing drives"),
        ("train_balance", BALANCE, "balance of drives"),
    ):
        yield not_checked(name, title, noun, place, why="no operating point")


def check_opposing_drives(opposing: float, place: Place, division: Division) -> Check:
    """Check that drives work together: with so much tension they oppose each other [N]."""
    opposes = opposing > 0.0
    action = "Try torque sharing or closer speeds: run wraparc trim."
    if isinstance(division, Shares):
        action = "Set every load share above 0 %."
    elif isinstance(division, Pulls):
        action = "Give tensions with which every pulley drives."
    return Check(
        name="opposing_drives",
        title=OPPOSING,
        noun="opposing drives",
        level=Level.ATTENTION if opposes else Level.OK,
        label="drives oppose" if opposes else "",
        headline="Drives oppose each other by {value}" if opposes else "",
        action=action if opposes else "",
        quantity="opposing_tension",
        value=opposing if opposes else math.nan,
        dimension="force",
        place=place,
    )


def train_balance(error: float, place: Place) -> Check:
    """Check that tensions, speeds and torques of a solved train agree."""
    text = CheckText(
        title=BALANCE,
        noun="drive balance error",
        source="tolerance of the program",
        label="internal error",
        headline="Drive balance error {value} exceeds {limit}",
        action=REPORT,
    )
    return TRAIN_BALANCE_RULE.compare(error, TRAIN_BALANCE, place, text)


TRAIN_BALANCE_RULE = Rule(
    "train_balance", "the balance of the train", missed=Level.FAULT, binding=False, of_rows=False
)
