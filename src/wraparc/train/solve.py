"""Solve a train: shares to speeds, speeds to shares, motors to their operating point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import exp, log, log1p, nan

import numpy as np

from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.drive import Pulley
from wraparc.errors import BreakawayError, ConvergenceError, InputError, Problem
from wraparc.train.locate import Located, locate
from wraparc.train.member import Member, Passage
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.newton import linearized
from wraparc.train.result import CaseResult, MemberResult, MotorPoint, TrainResult, TrainStatus
from wraparc.train.system import Line, System
from wraparc.train.train import Motors, Pulls, Shares, Speeds, Train, TrainCase, tensions_at
from wraparc.units import display

#: Pull over tension that is rounding only.
_IDLE = 1e-11


def solve_train(
    train: Train, *, method: Distributed | None = None, raise_on_failure: bool = True
) -> TrainResult:
    """Solve a train in all its load cases.

    Parameters
    ----------
    train
        The train, see `wraparc.load_train`.
    method
        `Distributed()` unless given: how finely each arc is reported.
    raise_on_failure
        Raise if a load case has no solution; otherwise its result says so.

    Raises
    ------
    InputError
        If a law is unfit for an arc, or a motor would have to work beyond its curve.
    BreakawayError
        If a drive cannot hold its part of the load; the error carries the result.
    ConvergenceError
        If the solver did not reach its accuracy.

    Notes
    -----
    Belt mass flow is continuous, so that between two pulleys of a train

        v_2/v_1 = (1 + T2/EA)(1 - g_1) / ((1 + T1/EA)(1 - g_2)),

    to first order v_2/v_1 - 1 = (g_2 - g_1) - (T1 - T2)/EA, with the entry tensions T1 and T2 and
    the entry creep ratios g. Shafts turn at v/(R - delta), delta the compression of the lagging at
    the entry.
    """
    solver = method or Distributed()
    result = TrainResult(train, tuple(solve_case(train, case, solver) for case in train.cases))
    if raise_on_failure and not result.solved:
        worst = next(c for c in result.cases if not c.status.solved)
        where = f"load case {worst.case.name}: {worst.reason}"
        if worst.status is TrainStatus.BEYOND_MOTOR:
            raise InputError(Problem(key="train.motor", message=where))
        if worst.status is TrainStatus.BREAKAWAY:
            raise BreakawayError(f"{where} {worst.status}", result)
        raise ConvergenceError(f"{where} {worst.status}")
    return result


def solve_case(train: Train, case: TrainCase, method: Distributed) -> CaseResult:
    """Solve one load case of a train; a failure is told by the status."""
    train = train.in_case(case)
    setup = Setup.of(train, case)
    division = case.division
    if isinstance(division, Shares | Pulls) or (
        len(train.pulleys) == 1 and isinstance(division, Speeds) and not division.absolute
    ):
        return _reported(setup, method, setup.given_tensions(), None)
    softening = any(p.lagging.law.steepest_fall() < 0.0 for p in train.pulleys)
    located = locate(setup.system, [p.name for p in train.pulleys], softening)
    pairs = [(p.entry, p.exit) for p in located.passages]
    if located.status.solved:
        pairs = _rounded(pairs, case)
    return _reported(setup, method, pairs, located)


def _rounded(pairs: Sequence[tuple[float, float]], case: TrainCase) -> list[tuple[float, float]]:
    """Return tensions that meet the last one exactly; what is idle but for rounding is idle."""
    exits = [b if abs(a - b) > _IDLE * a else a for a, b in pairs]
    exits[-1] = case.exit_tension
    if abs(pairs[-1][0] - exits[-1]) <= _IDLE * exits[-1] and len(exits) > 1:
        exits[-2] = exits[-1] - case.run(len(exits) - 2)
    entries = [pairs[0][0], *(b + case.run(i) for i, b in enumerate(exits[:-1]))]
    return list(zip(entries, exits, strict=True))


@dataclass(frozen=True)
class Setup:
    """A load case, ready for numbers.

    Attributes
    ----------
    train, case
        What is solved.
    system
        Its equations.
    reference
        V, the speed that the levels refer to [m/s]; nan where no speed is known.
    """

    train: Train
    case: TrainCase
    system: System
    reference: float

    @classmethod
    def of(cls, train: Train, case: TrainCase) -> Setup:
        """Return a load case of a train, ready for numbers."""
        train = train.in_case(case)
        arcs = [arc_of(train, case, p, (case.entry_tension,) * 2) for p in train.pulleys]
        lines, reference = _lines(train, case)
        count = len(arcs)
        system = System(
            members=tuple(Member.of(arc) for arc in arcs),
            lines=lines,
            entry=case.entry_tension,
            exit=case.exit_tension,
            runs=(*(case.run(i) for i in range(count - 1)), 0.0),
        )
        return cls(train, case, system, reference)

    @property
    def motors(self) -> tuple[Motor | TorqueFollower | None, ...]:
        """Return the motor of each pulley, if there is one."""
        division = self.case.division
        if isinstance(division, Motors):
            return division.motors
        return (None,) * len(self.train.pulleys)

    def given_tensions(self) -> list[tuple[float, float]]:
        """Return entry and exit tensions of pulleys whose pulls are given [N]."""
        division, total = self.case.division, self.case.effective_tension
        pulls: Sequence[float] = (total,)
        if isinstance(division, Shares):
            pulls = [f * total for f in division.fractions]
        elif isinstance(division, Pulls):
            pulls = division.effective_tensions
        return tensions_at(self.case, pulls)


def arc_of(
    train: Train,
    case: TrainCase,
    pulley: Pulley,
    tensions: tuple[float, float],
    belt_speed: float | None = None,
) -> WrapArc:
    """Return the arc of a pulley of a train."""
    lagging = pulley.lagging
    return WrapArc(
        law=lagging.law,
        entry_tension=tensions[0],
        exit_tension=tensions[1],
        diameter=pulley.diameter,
        wrap_angle=pulley.wrap_angle,
        width=train.belt.width,
        axial_stiffness=train.belt.axial_stiffness,
        thickness=lagging.thickness,
        shear_modulus=lagging.shear_modulus,
        compression_modulus=lagging.compression_modulus,
        overrun=pulley.overrun,
        recovery=pulley.recovery,
        creep_limit=train.creep_limit_of(pulley),
        belt_speed=belt_speed,
        wear_coefficient=lagging.wear_coefficient,
        pulley=pulley.name,
        load_case=case.name,
    )


def _lines(train: Train, case: TrainCase) -> tuple[tuple[Line, ...], float]:
    """Return what turns each drum, and the reference speed."""
    division, pulleys = case.division, train.pulleys
    if isinstance(division, Speeds):
        reference = division.rotation_speeds[0] * pulleys[0].radius
        return tuple(
            Line(speed=log(omega * p.radius / reference))
            for omega, p in zip(division.rotation_speeds, pulleys, strict=True)
        ), (reference if division.absolute else nan)
    if not isinstance(division, Motors):
        return (Line(),) * len(pulleys), nan
    names = [p.name for p in pulleys]
    turning = [
        (m, p) for m, p in zip(division.motors, pulleys, strict=True) if isinstance(m, Motor)
    ]
    reference = turning[0][0].drum_speed(0.0) * turning[0][1].radius
    lines = []
    for m, p in zip(division.motors, pulleys, strict=True):
        if isinstance(m, TorqueFollower):
            lines.append(Line(master=names.index(m.master), ratio=m.ratio))
        elif m.holds_speed:
            lines.append(Line(speed=log(m.drum_speed(0.0) * p.radius / reference)))
        else:
            lines.append(Line(motor=m, scale=p.radius / reference))
    return tuple(lines), reference


def _reported(
    setup: Setup,
    method: Distributed,
    pairs: Sequence[tuple[float, float]],
    located: Located | None,
) -> CaseResult:
    """Solve the arcs for their tensions and put everything together."""
    train, case, system = setup.train, setup.case, setup.system
    stretch = train.belt.axial_stiffness
    at_first = train.belt.speed or nan
    if located is not None and setup.reference == setup.reference:
        at_first = setup.reference * exp(-located.level) * (1.0 + pairs[0][0] / stretch)
    speeds = [at_first * (1.0 + a / stretch) / (1.0 + pairs[0][0] / stretch) for a, _ in pairs]
    arcs = [
        method.solve(arc_of(train, case, p, pair, v if v == v else None))
        for p, pair, v in zip(train.pulleys, pairs, speeds, strict=True)
    ]
    ratios = [arc.entry_creep_ratio for arc in arcs]
    if located is not None and not located.status.solved:  # a sliding drive creeps as it must
        ratios = [
            p.ratio if p.ratio == p.ratio else g
            for p, g in zip(located.passages, ratios, strict=True)
        ]
    members = tuple(_member(setup, i, arcs, ratios, v) for i, v in enumerate(speeds))
    status, reason = _status(setup, members, located)
    passages = located.settled.passages if located and located.settled else None
    return CaseResult(
        case=case,
        status=status,
        reason=reason,
        members=members,
        sensitivity=_sensitivity(system, arcs, located),
        belt_speed=at_first,
        other_splits=located.other_splits if located else (),
        tension_error=_tension_error(setup, arcs) if passages or not located else nan,
        speed_error=_speed_error(setup, members, located),
    )


def _member(
    setup: Setup,
    i: int,
    arcs: Sequence[ArcResult],
    ratios: Sequence[float],
    belt_speed: float,
) -> MemberResult:
    first, arc = arcs[0], arcs[i]
    stretch = setup.train.belt.axial_stiffness
    nominal = setup.train.nominal
    total = setup.case.effective_tension
    a, a1 = arc.entry_tension, first.entry_tension
    g, g1 = ratios[i], ratios[0]
    leaves = 1.0 - g if g < 1.0 else nan  # a drum that slides as much as it can moves no belt
    ratio = (1.0 + a / stretch) * (1.0 - g1) / ((1.0 + a1 / stretch) * leaves)
    arm, arm1 = (r.arc.radius - r.arc.compression for r in (arc, first))
    surface = belt_speed / leaves
    torque, rotation = arc.effective_tension * arm, surface / arm
    return MemberResult(
        arc=arc,
        share=arc.effective_tension / total if total != 0.0 else nan,
        speed_ratio=ratio,
        contraction_term=-(a1 - a) / stretch,
        creep_term=g - g1,
        compression_term=arc.arc.compression / arc.arc.radius
        - first.arc.compression / first.arc.radius,
        drum_ratio=ratio * arm1 / arm * arc.arc.radius / first.arc.radius,
        surface_speed=surface,
        rotation_speed=rotation,
        speed_trim=ratio * arm1 / arm * nominal[i] / nominal[0],
        drum_torque=torque,
        drum_power=surface * arc.effective_tension,
        motor=_motor_point(setup, i, torque, rotation),
    )


def _motor_point(setup: Setup, i: int, torque: float, rotation: float) -> MotorPoint | None:
    motor = setup.motors[i]
    if not isinstance(motor, Motor):
        return None
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
        coupling_loss=motor.count * each * (speed - gear_speed),
        gear_loss=motor.count * each * gear_speed - torque * rotation,
    )


def _status(
    setup: Setup, members: Sequence[MemberResult], located: Located | None
) -> tuple[TrainStatus, str]:
    if located is not None and not located.status.solved:
        return located.status, located.reason
    stuck = [m for m in members if m.arc.status is not Status.SOLVED]
    if any(m.arc.status is Status.UNSOLVED for m in stuck):
        return TrainStatus.UNSOLVED, f"{stuck[0].name}: {stuck[0].arc.status}"
    if stuck:
        names = " and ".join(m.name for m in stuck)
        verb = "breaks" if len(stuck) == 1 else "break"
        return TrainStatus.BREAKAWAY, f"{names} {verb} away: no creep makes enough friction."
    for member, motor in zip(members, setup.motors, strict=True):
        if isinstance(motor, Motor) and member.motor is not None:
            reason = _beyond(member, motor, member.motor)
            if reason:
                return TrainStatus.BEYOND_MOTOR, reason
    return TrainStatus.SOLVED, ""


def _apart(one: float, other: float) -> tuple[str, str]:
    """Return two rotation speeds [rad/s] in as many digits as tell them apart."""
    told = ("", "")
    for digits in range(4, 10):
        told = (
            display(one, "rotation_speed", digits=digits),
            display(other, "rotation_speed", digits=digits),
        )
        if told[0] != told[1]:
            break
    return told


def _beyond(member: MemberResult, motor: Motor, point: MotorPoint) -> str:
    """Say how a motor would have to leave its curve, or nothing."""
    low, high = motor.limits()
    rounding = 1e-9
    if point.motor_load < low - rounding:
        end = low / (motor.gear_efficiency if low >= 0.0 else 1.0 / motor.gear_efficiency)
        most = motor.drum_speed(end * motor.drum_torque)
        turns, top = _apart(member.rotation_speed, most)
        means = "it cannot hold back" if low == 0.0 else f"it holds back {-low:.3g} rated torques"
        return (
            f"The belt drives the drum of {member.name} at {turns}, faster than its motor allows: "
            f"{top} at most, where {means}."
        )
    if point.motor_load > high + rounding:
        turns = display(member.rotation_speed, "rotation_speed")
        return (
            f"The motor of {member.name} would need {point.motor_load:.3g} times its rated torque "
            f"at {turns} of its drum; its curve ends at {high:.3g}."
        )
    return ""


def _sensitivity(
    system: System, arcs: Sequence[ArcResult], located: Located | None
) -> tuple[tuple[float, ...], ...]:
    count = len(arcs)
    if located is not None and located.settled is not None:
        slopes = located.settled.linear.share_slopes(system.pull)
    else:
        passages = [_passage(m, arc) for m, arc in zip(system.members, arcs, strict=True)]
        known = [p for p in passages if p is not None]
        rigid = replace(system, lines=(Line(),) * count)
        slopes = np.full((count, count), nan)
        if len(known) == count and all(a.status.solved for a in arcs):
            slopes = linearized(rigid, known)[0].share_slopes(system.pull)
    return tuple(tuple(float(v) for v in row) for row in slopes)


def _passage(member: Member, arc: ArcResult) -> Passage | None:
    if member.holds:
        return member.between(arc.entry_tension, arc.exit_tension)
    g = arc.entry_creep_ratio
    effort = member.effort_at(g)
    return Passage(
        arc.entry_tension, arc.exit_tension, effort, g, arc.exit_creep, arc.exit_slip, False
    )


def _tension_error(setup: Setup, arcs: Sequence[ArcResult]) -> float:
    """Largest relative miss between what leaves a pulley and what the next one takes."""
    if not all(arc.status.solved for arc in arcs):
        return nan
    misses = []
    for i, arc in enumerate(arcs):
        leaving = float(arc.profile.tension[-1]) + setup.system.runs[i]
        taken = arcs[i + 1].entry_tension if i + 1 < len(arcs) else setup.case.exit_tension
        misses.append(abs(leaving / taken - 1.0))
    return max(misses)


def _speed_error(setup: Setup, members: Sequence[MemberResult], located: Located | None) -> float:
    """Largest miss of the speeds or torques asked for, from the reported arcs alone."""
    if located is None or not located.status.solved:
        return 0.0 if located is None else nan
    system = setup.system
    misses = []
    for i, (m, line) in enumerate(zip(members, system.lines, strict=True)):
        if line.follows:
            asked = line.ratio * members[line.master].drum_torque
            misses.append(abs(m.drum_torque - asked) / system.torque_scale)
            continue
        arc = m.arc
        left = -log1p(-arc.entry_creep_ratio) + system.members[i].stretch_log(arc.entry_tension)
        misses.append(abs(left - line.log_speed(m.drum_torque) - located.level))
    return max(misses)
