"""Everything a solve of a train has to say."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from enum import StrEnum
from functools import cached_property
from math import isfinite, isnan, nan

from wraparc.alike import largest
from wraparc.arc import ArcResult, DriveResult
from wraparc.arc.result import MORE_FRICTION
from wraparc.drive import Drive, LoadCase, Tensions
from wraparc.train.train import Train, TrainCase
from wraparc.views import Viewable


class TrainStatus(StrEnum):
    """How the solve of a load case ended; `CaseResult.reason` says more."""

    SOLVED = "The drives transmit the load."
    BREAKAWAY = (
        "Gross slip: a drive cannot transmit its share of the load. Raise the slack-side "
        f"tension (take-up), bring the speeds closer together, or {MORE_FRICTION}"
    )
    BEYOND_MOTOR = (
        "No operating point: a motor would have to work outside its curve. Change its set speed or "
        "gear, or choose another motor."
    )
    UNSOLVED = (
        "The solver did not reach its accuracy on this train. Please report the drive file; until "
        "then change a value slightly."
    )

    @property
    def solved(self) -> bool:
        """Whether the drives carry the load."""
        return self is TrainStatus.SOLVED


@dataclass(frozen=True)
class MotorPoint:
    """Where each motor on a drum works, and what is lost between it and the drum.

    Powers are negative where the motor holds back; losses never are.

    Attributes
    ----------
    motor_load
        Torque over rated torque [-].
    motor_torque
        Shaft torque of each motor [N m].
    motor_speed
        Speed of the motor; with a fluid coupling that of the pump [rad/s].
    motor_power
        Shaft power of each motor [W].
    gear_speed
        Speed of the motor side of the gear; with a fluid coupling that of the turbine [rad/s].
    electrical_power
        Power that all motors of the drum take from the mains; nan without a motor efficiency [W].
    motor_loss
        Lost in all motors of the drum; nan without a motor efficiency [W].
    coupling_loss
        Lost in their fluid couplings [W].
    gear_loss
        Lost in the gear [W].
    """

    motor_load: float
    motor_torque: float
    motor_speed: float
    motor_power: float
    gear_speed: float
    electrical_power: float
    motor_loss: float
    coupling_loss: float
    gear_loss: float

    @property
    def losses(self) -> float:
        """All that is known to be lost between the mains and the drum [W]."""
        known = 0.0 if isnan(self.motor_loss) else self.motor_loss
        return known + self.coupling_loss + self.gear_loss


@dataclass(frozen=True, eq=False)
class MemberResult:
    """One drive of a train in one load case.

    Speeds and powers are nan where no belt speed is known. The terms are those of the first order:
    speed_ratio - 1 = contraction_term + creep_term, and drum_ratio - 1 with compression_term too.

    Attributes
    ----------
    arc
        Everything that a single pulley reports.
    share
        Part of the total effective tension [-]; nan where the total is 0.
    speed_ratio
        v_i/v_1 at the entry nips, of the loaded drums at the tension member, exactly [-].
    contraction_term
        -(T_1 - T_i)/EA: the belt is shorter where its tension is lower [-].
    creep_term
        g_i - g_1: this pulley creeps more than the first [-].
    compression_term
        delta_i/R_i - delta_1/R_1: a less compressed lagging makes a larger drum [-].
    thickness_term
        (1 + e_1/R_1)/(1 + e_i/R_i) - 1: the tension member farther out makes a larger drum [-]; 0
        where the thickness of the belt is not known.
    drum_ratio
        omega_i R_i/(omega_1 R_1), the ratio of the drum speeds of equal drums, exactly [-]; 1 +
        contraction_term + creep_term + compression_term + thickness_term to first order.
    surface_speed
        v_i, at the radius of the tension member [m/s].
    rotation_speed
        omega_i = v_i/(R_i - delta_i + e_i) of the drum [rad/s].
    speed_trim
        omega_i D_i/(omega_1 D_1) with the nominal diameters [-].
    drum_torque
        (T1 - T2)(R - delta + e), the power of the surface over the speed of the drum [N m].
    drum_power
        Power to the belt, v_i (T1 - T2) [W].
    motor
        Where its motors work, or None.
    """

    arc: ArcResult
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
    motor: MotorPoint | None = None

    @property
    def name(self) -> str:
        """Name of the pulley."""
        return self.arc.arc.pulley

    @property
    def first_order_speed_ratio(self) -> float:
        """1 + contraction_term + creep_term [-]."""
        return 1.0 + self.contraction_term + self.creep_term

    def scalars(self) -> dict[str, float]:
        """Numbers of the drive within the train by their names in the glossary [SI]."""
        named = {
            f.name: getattr(self, f.name)
            for f in fields(self)
            if isinstance(getattr(self, f.name), float)
        }
        if self.motor is not None:
            named.update({f.name: getattr(self.motor, f.name) for f in fields(self.motor)})
        return named


@dataclass(frozen=True, eq=False)
class CaseResult:
    """A train in one load case.

    Attributes
    ----------
    case
        What was solved.
    status
        How it ended.
    reason
        A sentence on what stands in the way, empty when solved.
    members
        The drives in belt order. Those that break away have their tensions alone; where no
        division of the load is found, as in the state that comes nearest.
    sensitivity
        d share_i / d ln(speed of drive j), row i and column j [-].
    belt_speed
        At the first entry nip [m/s]; nan where not known.
    other_splits
        Shares of other solutions of the same speeds, all of them unstable.
    tension_error
        Largest relative miss of continuity of the tensions [-].
    speed_error
        Largest miss of the speeds, or of the torque of a motor, asked for [-].
    """

    case: TrainCase
    status: TrainStatus
    reason: str
    members: tuple[MemberResult, ...]
    sensitivity: tuple[tuple[float, ...], ...]
    belt_speed: float
    other_splits: tuple[tuple[float, ...], ...] = ()
    tension_error: float = 0.0
    speed_error: float = 0.0

    def __iter__(self) -> Iterator[MemberResult]:
        return iter(self.members)

    def __getitem__(self, pulley: str) -> MemberResult:
        for member in self.members:
            if member.name == pulley:
                return member
        raise KeyError(pulley)

    @property
    def adrift(self) -> bool:
        """Whether the drums turn as given, and friction holds no division of the load."""
        return self.status is TrainStatus.BREAKAWAY and not self.case.pulls_given

    @property
    def shares(self) -> tuple[float, ...]:
        """Shares in belt order [-]."""
        return tuple(m.share for m in self.members)

    @property
    def power_loss(self) -> float:
        """Power lost to creep on all pulleys [W]."""
        return sum(m.arc.energy.power_loss for m in self.members)

    @property
    def motor_losses(self) -> float:
        """Power that is known to be lost between the mains and the drums [W]; nan with no motor."""
        points = [m.motor for m in self.members if m.motor is not None]
        return sum(point.losses for point in points) if points else nan

    @property
    def loss_ratio(self) -> float:
        """Loss on all pulleys over the power at their surfaces, for any belt speed [-]."""
        loss = power = 0.0
        for m in self.members:
            pull = m.arc.effective_tension
            mean = m.arc.entry_creep_ratio + 0.5 * pull * m.arc.arc.compliance
            loss += m.speed_ratio * pull * mean
            power += m.speed_ratio * pull
        return loss / abs(power) if power != 0.0 else nan

    def share_per_trim(self, drive: int, trimmed: int | None = None, trim: float = 1e-3) -> float:
        """Change of a share for a change of trim, by default of the same drive by 0.1 % [-]."""
        return trim * self.sensitivity[drive][drive if trimmed is None else trimmed]

    @property
    def within_creep_limit(self) -> bool:
        """Whether it is solved and every creep within its limit."""
        return self.status.solved and all(m.arc.within_creep_limit for m in self.members)


@dataclass(frozen=True, eq=False)
class TrainResult(Viewable):
    """A train in all its load cases, in their order.

    In a notebook it shows its tables; `plot`, with ``case="name"``, draws one load case (the
    governing one without a name), and `to_frame` has a row for each load case and pulley.
    """

    train: Train
    cases: tuple[CaseResult, ...]

    def __iter__(self) -> Iterator[CaseResult]:
        return iter(self.cases)

    def __len__(self) -> int:
        return len(self.cases)

    def __getitem__(self, case: str) -> CaseResult:
        for result in self.cases:
            if result.case.name == case:
                return result
        raise KeyError(case)

    @property
    def adrift(self) -> bool:
        """Whether there is no division of the load in some load case, see `CaseResult`."""
        return any(c.adrift for c in self.cases)

    @property
    def solved(self) -> bool:
        """Whether the drives carry the load in every load case."""
        return all(c.status.solved for c in self.cases)

    @property
    def governing(self) -> CaseResult:
        """The load case that is nearest to, or furthest beyond, its limits."""

        def severity(case: CaseResult) -> float:
            creeps = [m.arc.share_of_limit for m in case.members]
            return max(c if isfinite(c) else 0.0 for c in creeps)

        solved = self.solved
        return largest((c for c in self.cases if solved or not c.status.solved), severity)

    def drive_result(self) -> DriveResult:
        """Return the pulleys one by one, as `wraparc.solve` gives them for a drive: always one."""
        return self._pulley_by_pulley

    @cached_property
    def _pulley_by_pulley(self) -> DriveResult:
        # judged, and asked for its least tension, once
        cases = [
            LoadCase(
                name=result.case.name,
                kind=result.case.kind,
                condition=result.case.condition,
                description=result.case.description,
                tensions={
                    m.name: Tensions(entry=m.arc.entry_tension, exit=m.arc.exit_tension)
                    for m in result.members
                },
                uncertainty={"": result.case.uncertainty} if result.case.uncertainty else {},
            )
            for result in self.cases
        ]
        arcs = tuple(m.arc for case in self.cases for m in case.members)
        return DriveResult(drive_with(self.train, cases), arcs)


def drive_with(train: Train, cases: Sequence[LoadCase]) -> Drive:
    """Return the drive that a train is with the tensions of its pulleys."""
    return Drive(
        title=train.title,
        description=train.description,
        belt=train.belt,
        pulleys=train.pulleys,
        creep_limit=train.creep_limit,
        criteria=train.criteria,
        load_cases=tuple(cases),
    )
