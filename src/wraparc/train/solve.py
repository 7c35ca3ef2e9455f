"""Solve a train: shares to speeds, speeds to shares, motors to their operating point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, nan

from wraparc.arc import ArcResult, Distributed, Status, WrapArc
from wraparc.drive import Pulley
from wraparc.drive.load_case import exit_behind
from wraparc.drive.pitch import centrifugal_of, pitch_offset, strain_ratio
from wraparc.drive.pull import ALONE, Growth, growth_among
from wraparc.errors import BreakawayError, ConvergenceError, input_error
from wraparc.train.locate import Located, away, locate
from wraparc.train.member import Member, Passage
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.result import CaseResult, MemberResult, TrainResult, TrainStatus
from wraparc.train.system import Line, System
from wraparc.train.train import (
    Motors,
    Pair,
    Pulls,
    Shares,
    Speeds,
    Train,
    TrainCase,
    tensions_at,
)
from wraparc.train.turning import (
    Nip,
    as_asked,
    beyond_motor,
    driven,
    held_speeds,
    motor_point,
    rounded,
    sensitivity,
    speed_error,
    surface_of_first,
    tension_error,
    turning,
)


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
    the entry creep ratios g. Shafts turn at v/(R - delta + e), delta the compression of the lagging
    at the entry, e the offset of the tension member.
    """
    solver = method or Distributed()
    result = TrainResult(train, tuple(solve_case(train, case, solver) for case in train.cases))
    if raise_on_failure and not result.solved:
        worst = next(c for c in result.cases if not c.status.solved)
        where = f"load case {worst.case.name}: {worst.reason}"
        if worst.status is TrainStatus.BEYOND_MOTOR:
            raise input_error(key="train.motor", message=where)
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
    lift = centrifugal_of(train.belt)
    pairs = [Pair(p.entry + lift, p.exit + lift) for p in located.passages]
    if located.status.solved:
        pairs = rounded(pairs, case.exit_tension, setup.system.runs)
    elif located.status is TrainStatus.BREAKAWAY:
        pairs = as_asked(pairs, case.entry_tension, case.exit_tension, setup.system.runs)
    return _reported(setup, method, pairs, located)


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
        count, lift = len(arcs), centrifugal_of(train.belt)
        system = System(
            members=tuple(Member.of(arc) for arc in arcs),
            lines=lines,
            entry=case.entry_tension - lift,
            exit=case.exit_tension - lift,
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

    def given_tensions(self) -> list[Pair]:
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
    growth: Growth = ALONE,
) -> WrapArc:
    """Return the arc of a pulley of a train."""
    return WrapArc.on(
        train.belt,
        pulley,
        pulley.lagging,
        entry_tension=tensions[0],
        exit_tension=exit_behind(*tensions),
        creep_limit=train.creep_limit_of(pulley),
        belt_speed=belt_speed,
        growth=growth,
        load_case=case.name,
    )


def _growths(train: Train, pairs: Sequence[Pair]) -> list[Growth]:
    """Return how the tensions of the pulleys grow with the pull of all."""
    names, take_up = [p.name for p in train.pulleys], train.criteria.take_up
    after = take_up.place_among(names)
    pulls = [entry - exit_behind(entry, leaving) for entry, leaving in pairs]
    return [growth_among(pulls, i, take_up.fixed, after) for i in range(len(pulls))]


def _lines(train: Train, case: TrainCase) -> tuple[tuple[Line, ...], float]:
    """Return what turns each drum, and the reference speed."""
    division, pulleys = case.division, train.pulleys
    radii = [p.radius + (pitch_offset(train.belt, p.side) or 0.0) for p in pulleys]
    if isinstance(division, Speeds):
        speeds = division.rotation_speeds
        lines = tuple(Line(speed=at) for at in held_speeds(speeds, radii))
        return lines, (surface_of_first(speeds, radii) if division.absolute else nan)
    if not isinstance(division, Motors):
        return (Line(),) * len(pulleys), nan
    names = [p.name for p in pulleys]
    follows = [m.master if isinstance(m, TorqueFollower) else "" for m in division.motors]
    found = driven(
        [m if isinstance(m, Motor) else None for m in division.motors],
        [names.index(name) if name else -1 for name in follows],
        [m.ratio if isinstance(m, TorqueFollower) else 1.0 for m in division.motors],
        radii,
    )
    return tuple(found.lines), found.reference


def _reported(
    setup: Setup,
    method: Distributed,
    pairs: Sequence[Pair],
    located: Located | None,
) -> CaseResult:
    """Solve the arcs for their tensions and put everything together."""
    train, case, system = setup.train, setup.case, setup.system
    stiffness, lift = train.belt.axial_stiffness, centrifugal_of(train.belt)
    at_first = train.belt.speed or nan
    if located is not None and setup.reference == setup.reference:
        light = 1.0 + (pairs[0][0] - lift) / (stiffness + lift)
        at_first = setup.reference * exp(-located.level) * light
    speeds = [at_first * strain_ratio(a, pairs[0][0], stiffness) for a, _ in pairs]
    growths = _growths(train, pairs)
    arcs = [
        method.solve(arc_of(train, case, p, pair, v if v == v else None, growth))
        for p, pair, v, growth in zip(train.pulleys, pairs, speeds, growths, strict=True)
    ]
    for i in () if located is None else located.fallen:  # what slides has no state at rest
        if arcs[i].status is Status.SOLVED:
            arcs[i] = arcs[i].without_state(
                Status.BREAKAWAY, arcs[i].method, arcs[i].arc, arcs[i].capacities
            )
    nips = [
        Nip(
            entry=arc.entry_tension,
            pull=arc.effective_tension,
            creep_ratio=arc.entry_creep_ratio,
            radius=arc.arc.radius,
            compression=arc.arc.compression,
            offset=arc.arc.offset,
            nominal=nominal,
        )
        for arc, nominal in zip(arcs, train.nominal, strict=True)
    ]
    total = case.effective_tension
    turnings = [
        turning(nips[0], nip, stiffness, total, v) for nip, v in zip(nips, speeds, strict=True)
    ]
    members = tuple(
        MemberResult(
            arc=arc,
            motor=motor_point(motor, t.drum_torque, t.rotation_speed)
            if isinstance(motor, Motor)
            else None,
            **t._asdict(),
        )
        for arc, motor, t in zip(arcs, setup.motors, turnings, strict=True)
    )
    status, reason = _status(setup, members, located)
    settled = located is not None and located.status.solved
    torques = [t.drum_torque for t in turnings]
    return CaseResult(
        case=case,
        status=status,
        reason=reason,
        members=members,
        sensitivity=_sensitivity(system, arcs, located),
        belt_speed=at_first,
        other_splits=located.other_splits if located else (),
        tension_error=_tension_error(setup, arcs) if not located or located.settled else nan,
        speed_error=0.0
        if located is None
        else speed_error(system, nips, torques, located.level, lift)
        if settled
        else nan,
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
        return TrainStatus.BREAKAWAY, away([m.name for m in stuck], range(len(stuck)))
    for member, motor in zip(members, setup.motors, strict=True):
        if isinstance(motor, Motor) and member.motor is not None:
            reason = beyond_motor(member.name, member.rotation_speed, motor, member.motor)
            if reason:
                return TrainStatus.BEYOND_MOTOR, reason
    return TrainStatus.SOLVED, ""


def _sensitivity(
    system: System, arcs: Sequence[ArcResult], located: Located | None
) -> tuple[tuple[float, ...], ...]:
    passages: list[Passage | None] = [None] * len(arcs)
    if all(a.status.solved for a in arcs):
        passages = [
            member.between(
                arc.entry_tension - arc.arc.centrifugal, arc.exit_tension - arc.arc.centrifugal
            )
            for member, arc in zip(system.members, arcs, strict=True)
        ]
    return tuple(tuple(row) for row in sensitivity(system, located, passages))


def _tension_error(setup: Setup, arcs: Sequence[ArcResult]) -> float:
    """Largest relative miss between what leaves a pulley and what the next one takes."""
    if not all(arc.status.solved for arc in arcs):
        return nan
    leaving = [float(arc.profile.tension[-1]) for arc in arcs]
    entries = [arc.entry_tension for arc in arcs]
    return tension_error(leaving, setup.system.runs, entries, setup.case.exit_tension)
