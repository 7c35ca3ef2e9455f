"""What the train page of one file answers by itself: translated to `static/train_kernel.js`.

The page reads the drive file; its numbers come here, and go through the functions that solve trains
for `wraparc solve`.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, nan
from typing import NamedTuple

from wraparc.arc.summary import geometry_of
from wraparc.friction.compact import CompactLaw
from wraparc.train.linear import Matrix
from wraparc.train.locate import Located, away, locate
from wraparc.train.member import Member, Passage
from wraparc.train.motors import Motor
from wraparc.train.result import MotorPoint, TrainStatus
from wraparc.train.system import Line, System
from wraparc.train.train import Pair, along
from wraparc.train.turning import (
    Nip,
    Turning,
    as_asked,
    beyond_motor,
    held_speeds,
    motor_point,
    rounded,
    sensitivity,
    speed_error,
    tension_error,
    turning,
)
from wraparc.web.in_page import Given, Quick, description_of, lift_of


def total_of(powers: Sequence[float], speed: float) -> float:
    """Pull that powers of the drives make [N]."""
    return sum(powers) / speed


def parts_of(values: Sequence[float]) -> list[float]:
    """Part of each in their sum [-]."""
    total = sum(values)
    return [value / total for value in values]


def miss_of(entry: float, exit_: float, runs: float, pull: float) -> float:
    """How far tensions at both ends miss a pull, in parts of it [-]."""
    return abs(entry - exit_ + runs - pull) / abs(pull)


def trimmed(trims: Sequence[float], nominal: Sequence[float]) -> list[float]:
    """Rotation speeds of drums by their trims, in any one unit."""
    return [trim / diameter for trim, diameter in zip(trims, nominal, strict=True)]


def shared(fractions: Sequence[float], total: float) -> list[float]:
    """Pulls of drums that take parts of it all [N]."""
    return [fraction * total for fraction in fractions]


def least_of(pairs: Sequence[Pair]) -> float:
    """Least tension of pulleys [N]."""
    return min(min(at.entry, at.exit) for at in pairs)


def member_of(law: CompactLaw, given: Given) -> Member:
    """A pulley of a train, by its numbers."""
    arc = description_of(given)
    squeeze = 2.0 * (arc.thickness / arc.compression_modulus) / (arc.width * arc.diameter)
    geometry = geometry_of(arc)
    stretch = 1.0 / (arc.axial_stiffness + arc.centrifugal)
    e = arc.pitch_offset
    return Member(law, geometry, 0.5 * arc.diameter + e, stretch, squeeze, e)


class Belt(NamedTuple):
    """A belt as its train has it: tensions at both ends, m v^2 [N], and EA [N]."""

    entry: float
    exit: float
    lift: float
    stiffness: float


def belt_of(given: Given, entry: float, exit_: float) -> Belt:
    """The belt of a train with tensions at its ends [N]."""
    return Belt(entry, exit_, lift_of(given), given.modulus * given.width)


def system_of(
    members: tuple[Member, ...], lines: tuple[Line, ...], belt: Belt, runs: tuple[float, ...]
) -> System:
    """The equations of a train, whose tensions are those above m v^2."""
    return System(members, lines, belt.entry - belt.lift, belt.exit - belt.lift, runs)


class Divided(NamedTuple):
    """How the load of a train divides."""

    pairs: list[Pair]
    located: Located | None  # None where the pulls are given
    belt_speeds: list[float]  # where the belt meets the drums [m/s]
    belt: Belt


def divided(
    system: System,
    names: Sequence[str],
    softening: bool,
    pulls: Sequence[float],
    speed: float,
    reference: float,
    belt: Belt,
) -> Divided:
    """Tensions of all pulleys, from what is given: their pulls, or what turns their drums.

    Parameters
    ----------
    system
        The train.
    names
        Of its pulleys.
    softening
        Whether friction falls anywhere with slip.
    pulls
        Of the pulleys, where they are given; else empty [N].
    speed
        Of the belt, nan where it is not known [m/s].
    reference
        Speed that the levels refer to, nan where only ratios of speeds are known [m/s].
    belt
        The belt.
    """
    lift, stiffness = belt.lift, belt.stiffness
    found: Located | None = None
    if len(pulls) > 0:
        pairs = along(belt.entry, belt.exit, system.runs, pulls)
    else:
        found = locate(system, names, softening)
        pairs = [Pair(at.entry + lift, at.exit + lift) for at in found.passages]
        if found.status == TrainStatus.SOLVED:
            pairs = rounded(pairs, belt.exit, system.runs)
        elif found.status == TrainStatus.BREAKAWAY:
            pairs = as_asked(pairs, belt.entry, belt.exit, system.runs)
    at_first = speed
    if found is not None and reference == reference:
        light = 1.0 + (pairs[0].entry - lift) / (stiffness + lift)
        at_first = reference * exp(-found.level) * light
    first = 1.0 + pairs[0].entry / stiffness
    speeds = [at_first * (1.0 + at.entry / stiffness) / first for at in pairs]
    return Divided(pairs, found, speeds, belt)


def fallen_of(of: Divided) -> list[int]:
    """The drives that break away where no division of the load is found, by index."""
    return [] if of.located is None else list(of.located.fallen)


class Told(NamedTuple):
    """What a train has beside its arcs, see `CaseResult`."""

    status: TrainStatus
    reason: str
    turnings: list[Turning]
    points: list[MotorPoint | None]
    sensitivity: Matrix
    other_splits: Sequence[Sequence[float]]
    tension_error: float
    speed_error: float


def told(
    system: System,
    names: Sequence[str],
    of: Divided,
    arcs: Sequence[Quick],
    nominal: Sequence[float],
    motors: Sequence[Motor | None],
) -> Told:
    """What a train has beside its arcs, these solved for their tensions."""
    located, fallen, lift = of.located, fallen_of(of), of.belt.lift
    nips = [
        _nip(at, arc, diameter, lift)
        for at, arc, diameter in zip(system.members, arcs, nominal, strict=True)
    ]
    for i in fallen:  # what slides has no state at rest
        nips[i] = nips[i]._replace(creep_ratio=nan)
    failed = located is not None and located.status != TrainStatus.SOLVED
    turnings = [
        turning(nips[0], nip, of.belt.stiffness, system.pull, speed)
        for nip, speed in zip(nips, of.belt_speeds, strict=True)
    ]
    points = [
        None if motor is None else motor_point(motor, at.drum_torque, at.rotation_speed)
        for motor, at in zip(motors, turnings, strict=True)
    ]
    stuck = [i for i, arc in enumerate(arcs) if not arc.solved or i in fallen]
    passages: list[Passage | None] = [None for _ in arcs]
    if len(stuck) == 0:
        passages = [
            m.between(arc.summary.entry_tension - lift, arc.summary.exit_tension - lift)
            for m, arc in zip(system.members, arcs, strict=True)
        ]
    torques = [at.drum_torque for at in turnings]
    tension_miss = nan
    if len(stuck) == 0 and (located is None or located.settled is not None):
        leaving = [arc.profile.tension[len(arc.profile.tension) - 1] for arc in arcs]
        entries = [arc.summary.entry_tension for arc in arcs]
        tension_miss = tension_error(leaving, system.runs, entries, of.belt.exit)
    speed_miss = nan if failed else 0.0
    if located is not None and not failed:
        speed_miss = speed_error(system, nips, torques, located.level, lift)
    status, reason = TrainStatus.SOLVED, ""
    if located is not None and failed:
        status, reason = located.status, located.reason
    elif len(stuck) > 0:
        status, reason = TrainStatus.BREAKAWAY, away(names, stuck)
    for name, at, motor, point in zip(names, turnings, motors, points, strict=True):
        beyond = ""
        if status is TrainStatus.SOLVED and motor is not None and point is not None:
            beyond = beyond_motor(name, at.rotation_speed, motor, point)
        if beyond != "":
            status, reason = TrainStatus.BEYOND_MOTOR, beyond
    return Told(
        status=status,
        reason=reason,
        turnings=turnings,
        points=points,
        sensitivity=sensitivity(system, located, passages),
        other_splits=() if located is None else located.other_splits,
        tension_error=tension_miss,
        speed_error=speed_miss,
    )


def _nip(member: Member, arc: Quick, nominal: float, lift: float) -> Nip:
    found = arc.summary
    return Nip(
        entry=found.entry_tension,
        pull=found.effective_tension,
        creep_ratio=found.entry_creep_ratio,
        radius=member.radius - member.offset,
        compression=member.squeeze * (found.entry_tension - lift),
        offset=member.offset,
        nominal=nominal,
    )


def turned(speeds: Sequence[float], radii: Sequence[float]) -> list[Line]:
    """Lines of drums that turn at given speeds, in any one unit."""
    return [Line(speed=at) for at in held_speeds(speeds, radii)]
