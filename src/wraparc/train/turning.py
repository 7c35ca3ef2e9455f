"""How the drums of a train turn, from tensions and creep: plain numbers, also those of the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import log, log1p, nan
from typing import NamedTuple

from wraparc.drive.pitch import USUAL_OFFSET, pitch_radius, strain_ratio
from wraparc.train.linear import Matrix
from wraparc.train.locate import Located
from wraparc.train.member import Passage
from wraparc.train.motors import Motor
from wraparc.train.newton import linearized
from wraparc.train.result import MotorPoint
from wraparc.train.system import Line, System
from wraparc.train.train import Pair, along
from wraparc.units import GIVEN_DIGITS, display, quantity

#: Pull over tension that is rounding only.
_IDLE = 1e-11


def rounded(pairs: Sequence[Pair], exit_: float, runs: Sequence[float]) -> list[Pair]:
    """Return tensions that meet the last one exactly; what is idle but for rounding is idle."""
    last = len(pairs) - 1
    exits = [at.exit if abs(at.entry - at.exit) > _IDLE * at.entry else at.entry for at in pairs]
    exits[last] = exit_
    if last > 0 and abs(pairs[last].entry - exit_) <= _IDLE * exit_:
        exits[last - 1] = exit_ - runs[last - 1]
    entries = [pairs[0].entry, *[b + run for b, run in zip(exits[:-1], runs[:-1], strict=True)]]
    return [Pair(a, b) for a, b in zip(entries, exits, strict=True)]


def as_asked(
    pairs: Sequence[Pair], entry: float, exit_: float, runs: Sequence[float]
) -> list[Pair]:
    """Return tensions between the ends that are asked for, the load divided as between others.

    Parameters
    ----------
    pairs
        Of the state that comes nearest, in which the drives pull less.
    entry, exit_
        Tensions of the belt before the first and behind the last pulley [N].
    runs
        What the belt gains behind each pulley [N].
    """
    pulls = [at.entry - at.exit for at in pairs]
    total = sum(pulls)
    if total == 0.0:
        return list(pairs)
    part = (entry - exit_ + sum(runs)) / total
    found = along(entry, exit_, runs, [part * pull for pull in pulls])
    return found if min(min(at.entry, at.exit) for at in found) > 0.0 else list(pairs)


class Nip(NamedTuple):
    """A drum where the belt meets it."""

    entry: float  # tension [N]
    pull: float  # T1 - T2 [N]
    creep_ratio: float  # g [-]
    radius: float  # over the unloaded lagging [m]
    compression: float  # of the lagging [m]
    offset: float  # of the tension member over the lagging [m]
    nominal: float  # nominal diameter [m]


class Turning(NamedTuple):
    """How a drum turns, see `MemberResult`."""

    share: float
    speed_ratio: float
    contraction_term: float
    creep_term: float
    compression_term: float
    thickness_term: float
    drum_ratio: float
    surface_speed: float
    rotation_speed: float
    speed_trim: float
    drum_torque: float
    drum_power: float


def turning(first: Nip, at: Nip, stiffness: float, total: float, belt_speed: float) -> Turning:
    """Return how a drum turns against the first one.

    Parameters
    ----------
    first, at
        The first drum, and this one.
    stiffness
        EA of the belt [N].
    total
        Pull of all together [N].
    belt_speed
        Where the belt meets the drum [m/s].
    """
    a, a1, g, g1 = at.entry, first.entry, at.creep_ratio, first.creep_ratio
    leaves = 1.0 - g if g < 1.0 else nan  # a drum that slides as much as it can moves no belt
    ratio = strain_ratio(a, a1, stiffness) * (1.0 - g1) / leaves
    arm = pitch_radius(at.radius, at.compression, at.offset)
    arm1 = pitch_radius(first.radius, first.compression, first.offset)
    surface = belt_speed / leaves
    pull = at.pull if g == g else nan  # what slides carries nothing that is known
    return Turning(
        share=pull / total if total != 0.0 else nan,
        speed_ratio=ratio,
        contraction_term=(a - a1) / stiffness,
        creep_term=g - g1,
        compression_term=at.compression / at.radius - first.compression / first.radius,
        thickness_term=(1.0 + first.offset / first.radius) / (1.0 + at.offset / at.radius) - 1.0,
        drum_ratio=ratio * arm1 / arm * at.radius / first.radius,
        surface_speed=surface,
        rotation_speed=surface / arm,
        speed_trim=ratio * arm1 / arm * at.nominal / first.nominal,
        drum_torque=pull * arm,
        drum_power=surface * at.pull,
    )


def surface_sentence(diameter: float) -> str:
    """Return what the speed of a drum [m] misses without the thickness of the belt."""
    shift = 100.0 * USUAL_OFFSET / (0.5 * diameter)
    belt, drum = (quantity(d, "length") for d in (2.0 * USUAL_OFFSET, diameter))
    return (
        f"Pulley speeds are those at the lagging surface: {belt} of belt on a pulley of {drum} "
        f"would lower them by {shift:.2f} %."
    )


def motor_point(motor: Motor, torque: float, rotation: float) -> MotorPoint:
    """Return where a motor works at a torque on its drum and a speed of it [N m, rad/s]."""
    load = motor.load(torque)
    each = load * motor.rated_torque
    gear_speed = rotation * motor.gear_ratio
    speed = motor.motor_speed(load, gear_speed)
    shaft = motor.count * each * speed
    electrical = nan
    if motor.motor_efficiency is not None:
        eta = motor.motor_efficiency
        electrical = shaft / eta if shaft >= 0.0 else shaft * eta
    return MotorPoint(
        motor_load=load,
        motor_torque=each,
        motor_speed=speed,
        motor_power=each * speed,
        gear_speed=gear_speed,
        electrical_power=electrical,
        motor_loss=electrical - shaft,
        coupling_loss=motor.count * each * (speed - gear_speed) + 0.0,
        gear_loss=motor.count * each * gear_speed - torque * rotation,
    )


def surface_of_first(speeds: Sequence[float], radii: Sequence[float]) -> float:
    """Return the speed of the first drum at R + e, without compression [m/s]."""
    return speeds[0] * radii[0]


def held_speeds(speeds: Sequence[float], radii: Sequence[float]) -> list[float]:
    """Return the logarithms of surface speeds over that of the first drum [-]."""
    first = surface_of_first(speeds, radii)
    return [log(speed * radius / first) for speed, radius in zip(speeds, radii, strict=True)]


class Driven(NamedTuple):
    """Lines of drums that turn as their motors do, and the speed that they refer to [m/s]."""

    lines: list[Line]
    reference: float


def driven(
    motors: Sequence[Motor | None],
    masters: Sequence[int],
    ratios: Sequence[float],
    radii: Sequence[float],
) -> Driven:
    """Return the lines of drums on motors.

    Parameters
    ----------
    motors
        Of each drum, None where its torque follows another.
    masters, ratios
        Which drum it follows (-1 for none), and the ratio of torques [-].
    radii
        R + e of the drums [m].
    """
    speeds = [
        motor.drum_speed(0.0) * radius
        for motor, radius in zip(motors, radii, strict=True)
        if motor is not None
    ]
    reference = speeds[0]
    lines = []
    for motor, master, ratio, radius in zip(motors, masters, ratios, radii, strict=True):
        if motor is None:
            lines.append(Line(master=master, ratio=ratio))
        elif motor.holds_speed:
            lines.append(Line(speed=log(motor.drum_speed(0.0) * radius / reference)))
        else:
            lines.append(Line(motor=motor, scale=radius / reference))
    return Driven(lines, reference)


def beyond_motor(name: str, rotation: float, motor: Motor, point: MotorPoint) -> str:
    """Say how a motor would have to leave its curve, or nothing; the drum turns at `rotation`."""
    low, high = motor.limits()
    rounding = 1e-9
    if point.motor_load < low - rounding:
        end = low / (motor.gear_efficiency if low >= 0.0 else 1.0 / motor.gear_efficiency)
        turns, top = _apart(rotation, motor.drum_speed(end * motor.drum_torque))
        means = "it cannot brake" if low == 0.0 else f"it brakes with {-low:.3g} rated torques"
        if turns == top:
            return f"The belt drives pulley {name} at {turns}, where its motor ends: {means}."
        return (
            f"The belt drives pulley {name} at {turns}, faster than its motor allows: "
            f"{top} at most, where {means}."
        )
    if point.motor_load > high + rounding:
        turns = display(rotation, "rotation_speed", "si", GIVEN_DIGITS)
        return (
            f"The motor of {name} needs {point.motor_load:.3g} times its rated torque, its curve "
            f"ends at {high:.3g}; its pulley turns at {turns}."
        )
    return ""


def _apart(one: float, other: float) -> tuple[str, str]:
    """Return two rotation speeds [rad/s] in as many digits as tell them apart, or alike."""
    for digits in (4, 5, 6, 4):  # alike in six, they are told alike
        told = tuple(display(of, "rotation_speed", "si", digits) for of in (one, other))
        if told[0] != told[1]:
            break
    return told[0], told[1]


def sensitivity(
    system: System, located: Located | None, passages: Sequence[Passage | None]
) -> Matrix:
    """Return d share_i / d ln(speed of drive j) [-]; nan where that is not known.

    Parameters
    ----------
    system, located
        The train, and where its tensions were found; None where they were given.
    passages
        Of all pulleys; None for those that friction cannot hold.
    """
    if located is not None and located.settled is not None:
        return located.settled.linear.share_slopes(system.pull)
    count = len(passages)
    known = [at for at in passages if at is not None]
    if len(known) < count:
        return [[nan] * count for _ in range(count)]
    rigid = replace(system, lines=tuple(Line() for _ in range(count)))
    return linearized(rigid, known)[0].share_slopes(system.pull)


def tension_error(
    leaving: Sequence[float], runs: Sequence[float], entries: Sequence[float], exit_: float
) -> float:
    """Largest relative miss between what leaves a pulley and what the next one takes [-]."""
    taken = [*entries[1:], exit_]
    return max(abs((out + run) / a - 1.0) for out, run, a in zip(leaving, runs, taken, strict=True))


def speed_error(
    system: System, nips: Sequence[Nip], torques: Sequence[float], level: float, lift: float
) -> float:
    """Largest miss of the speeds or torques asked for, from the arcs alone [-]; lift is m v^2."""
    misses = []
    for i, line in enumerate(system.lines):
        if line.follows:
            asked = line.ratio * torques[line.master]
            misses.append(abs(torques[i] - asked) / system.torque_scale)
        else:
            entry = nips[i].entry - lift
            left = -log1p(-nips[i].creep_ratio) + system.members[i].stretch_log(entry)
            misses.append(abs(left - line.log_speed(torques[i]) - level))
    return max(misses)
