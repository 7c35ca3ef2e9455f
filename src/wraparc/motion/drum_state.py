"""One drum on the march: its arc, its motor, its brake, and what turns or rides on it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from wraparc.motion.arc import MovingArc
from wraparc.motion.control import Duty, Follower
from wraparc.motion.event import Event, Measured, OnBelt, OnDrum
from wraparc.motion.station import Station
from wraparc.motion.turning import Trimming, Turning, turning_of
from wraparc.train import CaseResult
from wraparc.train.solve import arc_of

#: Speed over running speed below which friction of the conveyor and brakes let go softly.
SOFT = 1e-3


@dataclass
class DrumState:
    """One drum on the march.

    Attributes
    ----------
    arc, duty, turning, trimming
        The belt on it, its steady state, its motor in time, its load sharing or None.
    inertia, run, radius
        J [kg m2], belt from the drum before [m], R + e of the tension member over the unloaded
        lagging [m].
    share
        R/(R + e), how far the surface of the lagging travels over the tension member [-].
    squeeze, recovery, give
        Fall of the radius by entry tension [m/N]; compliance of the lagging's recovery, and of it
        and the belt together [1/N].
    backstop, brake, master
        Whether it cannot turn back, torque of its brake [N m], place of the drum that it follows.
    omega, moment, torque, level, angle
        Speed [rad/s], moment of the belt, torque of motor and brake [N m], set speed [-], turn
        [rad].
    turned_back, locked, held, braked, extra
        How far it has turned back [m]; whether it stands held, whether the motor gives the speed
        whatever the torque, whether its brake is on; torque ripple [N m].
    """

    arc: MovingArc
    duty: Duty
    turning: Turning
    inertia: float
    run: float
    radius: float
    share: float
    squeeze: float
    recovery: float
    give: float
    backstop: bool
    brake: float
    master: int
    trimming: Trimming | None
    on_drum: list[OnDrum]
    measured: Measured | None
    omega: float = 0.0
    moment: float = 0.0
    torque: float = 0.0
    level: float = 0.0
    angle: float = 0.0
    turned_back: float = 0.0
    locked: bool = False
    held: bool = False
    braked: bool = False
    extra: float = 0.0
    t1: float = 0.0
    riders: list[tuple[OnBelt, float]] = field(default_factory=list)
    slope: float = 0.0  # dm/dt [m/s], and in the step before
    slope_0: float = 0.0
    rate: float = 0.0  # d omega/dt [rad/s2], and in the step before
    rate_0: float = 0.0

    def command(self, h: float, t1: float, level: float, on: bool, braked: bool) -> None:
        """Begin a step of h [s] that ends at t1 at a level of the set speed."""
        given = self.measured is not None and self.measured.what == "torque"
        if self.measured is not None and not given:
            level = self.measured.value(t1) / self.duty.speed
        self.level, self.t1, self.extra = level, t1, 0.0
        self.braked = braked and self.brake > 0.0
        self.turning.on = 1.0 if on else 0.0
        self.held = self.turning.holds and on and not given
        self.turning.begin(h, level)

    def guessed(self, h: float, onward: float) -> float:
        """Speed at the end of a step of h [s], as far as it is known before [rad/s]."""
        if self.locked:
            return 0.0
        if self.held:
            return self.duty.speed * self.level
        return self.omega + h * (self.rate + onward * (self.rate - self.rate_0))

    def driven(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque of motor and brake at the end of the step, its slopes by speed and master's."""
        if self.measured is not None and self.measured.what == "torque":
            return self.turning.on * self.measured.value(self.t1), 0.0, 0.0
        value, slope, by_lead = self.turning.torque(omega, lead)
        value += self.extra * self.turning.on
        if self.braked:
            soft = SOFT * self.duty.speed
            root = math.hypot(omega, soft)
            value -= self.brake * omega / root
            slope -= self.brake * soft * soft / root**3
        return value, slope, by_lead

    def moment_of(
        self, entry: float, exit_: float, rise_in: float, rise_out: float
    ) -> tuple[float, float, float]:
        """Moment of the belt, with its slopes by entry and exit tension [N m, m, m]."""
        lift = self.arc.lift
        arm, pull = self.radius - self.squeeze * (entry - lift), entry - exit_
        grown = 1.0 + 0.5 * self.recovery * pull
        moment = arm * pull * grown + rise_in * (entry - lift) - rise_out * (exit_ - lift)
        slope = arm * (1.0 + self.recovery * pull)
        return moment, slope - self.squeeze * pull * grown + rise_in, -slope - rise_out

    def lift_at(self, omega: float) -> float:
        """M v^2 of a belt as fast over its steady speed as the drum [N]."""
        return self.arc.arc.centrifugal * (omega / self.duty.speed) ** 2

    def at_nip(self, travel: float, angle: float, stretch: float) -> tuple[float, float, float]:
        """Rise, compliance of belt and recovery, and share of friction at the nip."""
        if not self.riders and not self.on_drum:
            return 0.0, self.give, 1.0
        rise, more, dry = 0.0, 0.0, 1.0
        for thing in self.on_drum:
            if self.t1 > thing.at:
                rise += thing.rise(angle, self.arc.arc.radius)
        for rider, front in self.riders:
            part = rider.part(travel / self.share - front, 2.0 * self.arc.spacing)
            rise += part * rider.rise
            more += part * (rider.compliance - 1.0) * stretch
            dry += part * (rider.friction - 1.0)
        return rise, self.give + more, dry

    def ripple(self, angle: float) -> float:
        """Torque ripple of the motor at an angle [N m]."""
        there = (o for o in self.on_drum if self.t1 > o.at)
        return self.duty.torque * math.fsum(o.ripple * math.sin(o.order * angle) for o in there)

    def rises(self, travel: float) -> tuple[float, float]:
        """Extra radius at the entry and at the exit nip after a travel [m]."""
        if not self.on_drum and not self.riders:
            return 0.0, 0.0
        return self.arc.rises(max(travel, self.arc.travel))

    def past_exit(self, travel: float, length: float, front: float) -> float:
        """How much of a piece of the belt has left this drum [m]."""
        return min(max((travel - self.arc.shape.length) / self.share - front, 0.0), length)


def drum_of(station: Station, event: Event, steady: CaseResult, i: int, points: int) -> DrumState:
    """Return one drum of a station, at rest."""
    member, drum = steady.members[i], station.drums[i]
    pulley, case = station.pulleys[i], station.train.case(station.load_case)
    pair = (member.arc.entry_tension, member.arc.exit_tension)
    arc = MovingArc(arc_of(station.train, case, pulley, pair), points)
    duty = duty_of(station, steady, i)
    control, master = drum.control, -1
    turning = turning_of(control, duty)
    if isinstance(control, Follower):
        master = station.index(control.master)
        if control.ratio is None:
            lead = duty_of(station, steady, master).torque
            turning.ratio = duty.torque / lead if lead else 1.0
    turns = [h for h in event.of(OnDrum) if isinstance(h, OnDrum) and h.pulley == pulley.name]
    records = [h for h in event.of(Measured) if isinstance(h, Measured) and h.pulley == pulley.name]
    return DrumState(
        arc=arc,
        duty=duty,
        turning=turning,
        inertia=drum.inertia,
        run=drum.run,
        radius=pulley.radius + arc.arc.offset,
        share=pulley.radius / (pulley.radius + arc.arc.offset),
        squeeze=2.0 * arc.arc.compression_compliance / (arc.arc.width * arc.arc.diameter),
        recovery=arc.arc.recovery_compliance,
        give=arc.arc.compliance,
        backstop=drum.backstop,
        brake=drum.brake_torque,
        master=master,
        trimming=Trimming(drum.trim, member.share) if drum.trim else None,
        on_drum=turns,
        measured=records[0] if records else None,
    )


def duty_of(station: Station, steady: CaseResult, i: int) -> Duty:
    """Return what a drum does in the steady state."""
    member = steady.members[i]
    radius = member.surface_speed / member.rotation_speed
    return Duty(member.rotation_speed, member.drum_torque, station.drums[i].inertia, radius)
