"""The station marched in time: drums, runs, take-up and conveyor around the moving arcs.

Trapezium rule on S, m, the tensions of the runs, omega and the speed of the conveyor. Flows of belt
appear only as their integrals over a step, so that belt is conserved to rounding. Newton's method
on m and omega of every drum, every tension and the speed of the conveyor, with the arcs as affine
maps: one sweep of each arc an iteration.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from wraparc.arc import Distributed
from wraparc.errors import InputError, Problem
from wraparc.motion import arc_kernel as k
from wraparc.motion.arc import MovingArc
from wraparc.motion.control import Duty, Follower, Trimming, Turning
from wraparc.motion.event import Event, LoadStep, Measured, OnBelt, OnDrum, PowerFailure, Start
from wraparc.motion.station import Station
from wraparc.train import CaseResult
from wraparc.train.solve import arc_of, solve_case

_ITERATIONS = 16
_SETTLED, _NEARLY = 1e-9, 1e-4
#: Speed over running speed below which friction of the conveyor and brakes let go softly.
_SOFT = 1e-3
#: Part of the wrap by which a drum may turn back.
_BACK = 0.05


class HaltError(ArithmeticError):
    """The run cannot go on; says why."""

    def __init__(self, what: str, place: str) -> None:
        super().__init__(what, place)
        self.what, self.place = what, place


@dataclass
class DrumState:
    """One drum on the march."""

    arc: MovingArc
    duty: Duty
    turning: Turning
    inertia: float
    run: float
    radius: float
    squeeze: float
    recovery: float
    give: float
    backstop: bool
    brake: float
    master: int
    trimming: Trimming | None
    omega: float = 0.0
    moment: float = 0.0
    torque: float = 0.0
    level: float = 0.0
    angle: float = 0.0
    turned_back: float = 0.0
    locked: bool = False
    extra: float = 0.0  # torque ripple [N m]
    riders: list[tuple[OnBelt, float]] = field(default_factory=list)
    on_drum: list[OnDrum] = field(default_factory=list)
    measured: Measured | None = None
    out: Any = None


class March:
    """A station on the march; `step` takes it one step further.

    Parameters
    ----------
    station, event
        What moves, and what happens.
    step
        [s]; None for one piece of lagging a step at running speed.
    points
        Pieces on the shortest wrap.
    """

    def __init__(
        self, station: Station, event: Event, step: float | None = None, points: int = 100
    ) -> None:
        self.station, self.event = station, event
        train = station.train
        self.case = case = train.case(station.load_case)
        self.steady = steady_of(station)
        self.stretch = 1.0 / train.belt.axial_stiffness
        self.runs = [case.run(i) for i in range(len(train.pulleys) - 1)]
        self.drums = [self._drum(i, points) for i in range(len(train.pulleys))]
        self.n = len(self.drums)
        # masters before those that follow them
        self.order = sorted(range(self.n), key=lambda i: self.drums[i].master >= 0)
        self.names = station.names
        lead = self.drums[0]
        self.speed = lead.duty.speed * lead.duty.radius
        finest = min(d.arc.spacing for d in self.drums)
        self.h = step or 1.2 * finest / self.speed
        self.t = 0.0
        self.pull = case.entry_tension - case.exit_tension
        self.slack = case.exit_tension
        self.loads = [h for h in event.of(LoadStep) if isinstance(h, LoadStep)]
        self.failures = [h for h in event.of(PowerFailure) if isinstance(h, PowerFailure)]
        self.belt_error, self.forgotten = 0.0, 0
        self.T = [case.entry_tension, *self._between(), case.exit_tension]
        self.v = self.speed if not event.from_rest else 0.0
        self.dT = [0.0] * (self.n + 1)
        if event.from_rest:
            self._rest()
        else:
            self._run()
        self._place_riders()
        self.belt_before = self.belt()

    # --- beginning ---

    def _between(self) -> list[float]:
        return [m.arc.exit_tension for m in self.steady.members[:-1]]

    def _drum(self, i: int, points: int) -> DrumState:
        station, member = self.station, self.steady.members[i]
        pulley, drum = station.train.pulleys[i], station.drums[i]
        pair = (member.arc.entry_tension, member.arc.exit_tension)
        arc = MovingArc(arc_of(station.train, self.case, pulley, pair), points)
        squeeze = 2.0 * arc.arc.compression_compliance / (arc.arc.width * arc.arc.diameter)
        duty = duty_of(station, self.steady, i)
        control, master = drum.control, -1
        turning = control.turning(duty)
        if isinstance(control, Follower):
            master = station.index(control.master)
            if control.ratio is None:
                lead = duty_of(station, self.steady, master).torque
                turning.ratio = duty.torque / lead if lead else 1.0  # type: ignore[attr-defined]
        return DrumState(
            arc=arc,
            duty=duty,
            turning=turning,
            inertia=drum.inertia,
            run=drum.run,
            radius=pulley.radius,
            squeeze=squeeze,
            recovery=arc.arc.recovery_compliance,
            give=arc.arc.compliance,
            backstop=drum.backstop,
            brake=drum.brake_torque,
            master=master,
            trimming=Trimming(drum.trim, member.share) if drum.trim else None,
            on_drum=[
                h
                for h in self.event.of(OnDrum)
                if isinstance(h, OnDrum) and h.pulley == pulley.name
            ],
            measured=next(
                (
                    h
                    for h in self.event.of(Measured)
                    if isinstance(h, Measured) and h.pulley == pulley.name
                ),
                None,
            ),
        )

    def _run(self) -> None:
        """Begin in the steady state."""
        for d, member in zip(self.drums, self.steady.members, strict=True):
            pair = (member.arc.entry_tension, member.arc.exit_tension)
            d.arc.settle(*pair, wraps=5.0)
            d.omega, d.level = d.duty.speed, 1.0
            d.moment = d.torque = self._moment(d, *pair, 0.0, 0.0)[0]
            d.turning.run(1.0, d.omega, d.torque)
        self.v = self.steady.belt_speed / (1.0 + self.T[0] * self.stretch)

    def _rest(self) -> None:
        """Begin at rest, the belt as tight all around as its take-up makes it."""
        for d in self.drums:
            d.arc.lay_at_rest(self.slack)
            d.locked = True
            d.turning.run(0.0, 0.0, 0.0)
        self.T = [self.slack] * (self.n + 1)
        for i, rise in enumerate(self.runs):
            if rise:
                message = "a rise of tension over a run at rest is not known"
                remedy = "Leave [train.run] out for an event that begins at rest."
                raise InputError(Problem(key=f"run[{i + 1}]", message=message, remedy=remedy))
        lift = self.station.lift_share * self.pull
        if lift <= 0.0:
            return
        holder = [i for i, d in enumerate(self.drums) if d.backstop or d.brake]
        if not holder:
            message = "nothing holds an inclined conveyor at rest"
            remedy = "Give a drum backstop = true or a brake_torque."
            raise InputError(Problem(key="lift_share", message=message, remedy=remedy))
        for j in range(1, 41):  # the load hangs itself into the drums, which stand
            self.T[0] = self.slack + lift * j / 40.0
            self._hang()

    def _hang(self) -> None:
        """Find the tensions between standing drums for the outer ones: no belt runs through."""
        for i, d in enumerate(self.drums):
            last = i == self.n - 1
            exit_ = self.slack if last else self.slack + (self.T[0] - self.slack) * 0.5
            if not last:
                self.T[i + 1] = exit_
            d.arc.begin(d.arc.travel)
            m = d.arc.m
            for _ in range(30):
                out = d.arc.sweep(d.arc.travel, m, exit_)
                dm = (self.T[i] - out[k.IN]) / out[k.IN_M]
                m += dm
                if abs(dm) < 1e-12:
                    break
            d.arc.finish(m, exit_)

    def _place_riders(self) -> None:
        """Where on the travel of every drum the things that ride on the belt come in."""
        for rider in self.event.of(OnBelt):
            if not isinstance(rider, OnBelt):
                continue
            ahead = self._travel_by(rider.at)
            for d in self.drums:
                if d is not self.drums[0]:
                    ahead += d.run
                d.riders.append((rider, d.arc.travel + ahead))
                ahead += d.arc.shape.length

    def _travel_by(self, at: float) -> float:
        """Travel of the belt by a time, as its set speed goes [m]."""
        count = max(int(at / 0.01), 1)
        levels = [self.event.level(at * (j + 0.5) / count) for j in range(count)]
        return self.speed * at * sum(levels) / count

    # --- one step ---

    def step(self, h: float | None = None, halvings: int = 6) -> None:
        """Take one step, in halves where it is hard.

        Raises
        ------
        HaltError
            If the run cannot go on: a slack belt, a drive that breaks away, a drum that turns back.
        """
        h = h or self.h
        try:
            z, flows = self._tried(h)
        except HaltError:
            if not halvings:
                raise
            self.step(0.5 * h, halvings - 1)
            self.step(0.5 * h, halvings - 1)
            return
        self._accept(h, self.t + h, z, flows)

    def _tried(self, h: float) -> tuple[list[float], dict[str, Any]]:
        """Solve for the end of a step; drums that would turn back against a stop stand."""
        self._command(h, self.t + h)
        for d in self.drums:
            if d.locked and self._released(d):
                d.locked = False
        for _ in range(4):
            z, flows = self._solve(h, self.t + h)
            stopped = [
                d
                for d, w in zip(self.drums, z[2 * self.n + 1 : 3 * self.n + 1], strict=True)
                if w < 0.0 and not d.locked and (d.backstop or self._braked(d))
            ]
            if not stopped:
                break
            for d in stopped:
                d.locked = True
        return z, flows

    def _command(self, h: float, t1: float) -> None:
        """Tell the drives what is asked of them at the end of the step."""
        level = self.event.level(t1)
        failed = any(t1 >= f.at for f in self.failures)
        for d in self.drums:
            own = level
            if d.trimming is not None:
                total = math.fsum(o.moment for o in self.drums)
                share = d.moment / total if abs(total) > 1e-9 else d.trimming.goal
                own = level * (1.0 + d.trimming.next(h, share))
            if d.measured is not None and d.measured.what == "speed":
                own = d.measured.value(t1) / d.duty.speed
            d.level = own
            d.turning.on = 0.0 if failed else 1.0
            fill = getattr(d.turning, "fill", None)
            if fill is not None:
                d.turning.fill = self._fill(t1)  # type: ignore[attr-defined]
            d.turning.begin(h, own)
            d.extra = 0.0

    def _fill(self, t1: float) -> float:
        starts = [s for s in self.event.of(Start) if isinstance(s, Start)]
        filling = [s for s in starts if s.shape == "coupling-fill" and t1 >= s.at]
        return max(filling[-1].level(t1), 1e-6) if filling else 1.0

    def _braked(self, d: DrumState) -> bool:
        return d.brake > 0.0 and any(f.brakes and self.t >= f.at for f in self.failures)

    def _released(self, d: DrumState) -> bool:
        """Whether a drum that stands is turned by its motor."""
        if self._braked(d):
            return False
        if d.turning.holds and d.turning.on:
            return d.level > 0.0
        lead = self.drums[d.master].torque if d.master >= 0 else 0.0
        driven = self._torque(d, 0.0, lead)[0]
        return driven > d.moment

    def _torque(self, d: DrumState, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque on a drum from its motor and brake, with slopes by speed and by the master's."""
        if d.measured is not None and d.measured.what == "torque":
            return d.turning.on * d.measured.value(self.t + d.turning.h), 0.0, 0.0
        value, slope, by_lead = d.turning.torque(omega, lead)
        value += d.extra * d.turning.on
        if self._braked(d):
            soft = _SOFT * d.duty.speed
            root = math.hypot(omega, soft)
            value -= d.brake * omega / root
            slope -= d.brake * soft * soft / root**3
        return value, slope, by_lead

    def _moment(
        self, d: DrumState, entry: float, exit_: float, rise_in: float, rise_out: float
    ) -> tuple[float, float, float]:
        """Moment of the belt on a drum, with its slopes by entry and exit tension [N m, m, m]."""
        arm, pull = d.radius - d.squeeze * entry, entry - exit_
        grown = 1.0 + 0.5 * d.recovery * pull
        moment = arm * pull * grown + rise_in * entry - rise_out * exit_
        slope = arm * (1.0 + d.recovery * pull)
        return moment, slope - d.squeeze * pull * grown + rise_in, -slope - rise_out

    def _resistance(self, v: float, t: float) -> tuple[float, float]:
        """Resistance of the conveyor and its slope by speed."""
        load = 1.0
        for step in self.loads:
            if t >= step.at:
                load = step.share(t)
        soft, lift = _SOFT * self.speed, self.station.lift_share
        root = math.hypot(v, soft)
        full = self.pull * load
        part, slope = v / root, soft * soft / root**3
        return full * (lift + (1.0 - lift) * part), full * (1.0 - lift) * slope

    def _rise(self, d: DrumState, angle: float) -> float:
        return math.fsum(o.rise(angle, d.radius) for o in d.on_drum if self.t >= o.at)

    def _at_nip(self, d: DrumState, travel: float, angle: float) -> tuple[float, float, float]:
        """Rise, compliance of belt and recovery, and share of friction at the nip."""
        if not d.riders and not d.on_drum:
            return 0.0, d.give, 1.0
        rise, more, dry = self._rise(d, angle), 0.0, 1.0
        for rider, front in d.riders:
            part = rider.part(travel - front, 2.0 * d.arc.spacing)
            rise += part * rider.rise
            more += part * (rider.compliance - 1.0) * self.stretch
            dry += part * (rider.friction - 1.0)
        return rise, d.give + more, dry

    def _softer_run(self, i: int, travels: list[float]) -> float:
        """What a splice in the run behind drum i adds to its compliance [m/N]."""
        more = 0.0
        d, e = self.drums[i], self.drums[i + 1]
        for (rider, front), (_, next_front) in zip(d.riders, e.riders, strict=True):
            if rider.compliance != 1.0:
                left = min(max(travels[i] - d.arc.shape.length - front, 0.0), rider.length)
                come = min(max(travels[i + 1] - next_front, 0.0), rider.length)
                more += (left - come) * (rider.compliance - 1.0) * self.stretch
        return more

    def _solve(self, h: float, t1: float) -> tuple[list[float], dict[str, Any]]:  # noqa: C901
        """Newton's method for the end of the step: the unknowns there, and the flows."""
        n = self.n
        z = self._guess(h)
        begun = False
        before, stretch, half = self.T, self.stretch, 0.5 * h
        old_travel = [d.arc.travel for d in self.drums]
        worst_place, change = "", 0.0
        softer0 = [self._softer_run(i, old_travel) for i in range(n - 1)]
        for iteration in range(_ITERATIONS):
            size = 3 * n + 2
            jac = np.zeros((size, size))
            r = np.zeros(size)
            m1, after = z[:n], z[n : 2 * n + 1]
            w1 = z[2 * n + 1 : 3 * n + 1]
            flow_in: list[tuple[float, float, float, float]] = []
            flow_out: list[tuple[float, float, float, float, float, float]] = []
            travels, angles, surfaces = [], [], []
            change = 0.0
            for i, d in enumerate(self.drums):
                arc, entry0 = d.arc, before[i] + self._run_rise(i)
                entry1, exit1 = after[i] + self._run_rise(i), after[i + 1]
                angle = d.angle + half * (d.omega + w1[i])
                rise0, give0, _ = arc.rise, arc.give, arc.dry
                near = old_travel[i] + half * (d.omega + w1[i]) * d.radius
                rise, give, dry = self._at_nip(d, near, angle)
                v_0 = d.omega * (d.radius - d.squeeze * entry0 + rise0)
                v_1 = w1[i] * (d.radius - d.squeeze * entry1 + rise)
                travel = old_travel[i] + half * (v_0 + v_1)
                travels.append(travel)
                angles.append(angle)
                surfaces.append((rise, give, dry))
                if not begun:
                    arc.begin(travel)
                nip = arc.rows[arc.span[1]]
                if arc.span[2]:
                    nip[k.GIVE], nip[k.RISE], nip[k.DRY] = give, rise, dry
                out = d.out = arc.sweep(max(travel, old_travel[i] + 1e-13), m1[i], exit1)
                if out[k.CHANGE] > change and iteration:
                    change, worst_place = float(out[k.CHANGE]), self.names[i]
                # the arc: T_in = its affine map
                r[i] = entry1 - out[k.IN]
                jac[i, n + i], jac[i, n + i + 1], jac[i, i] = 1.0, -out[k.IN_X], -out[k.IN_M]
                # belt through the entry nip: a = 1/EA' there, belt alone without the recovery
                own0, own1 = give0 - d.recovery, give - d.recovery
                down = 1.0 + half / h * (own0 * entry0 + own1 * entry1)
                up = half * (v_0 * (1.0 + give0 * entry0) + v_1 * (1.0 + give * entry1))
                q = (up - (m1[i] - arc.m)) / down
                by_t = (
                    half * (v_1 * give - w1[i] * d.squeeze * (1.0 + give * entry1)) - 0.5 * q * own1
                ) / down
                by_w = half * (v_1 / w1[i] if w1[i] else d.radius) * (1.0 + give * entry1) / down
                flow_in.append((q, -1.0 / down, by_t, by_w))
                # belt through the exit nip: Q + dW - d Lambda
                lifted = (out[k.LIFTED] - arc.lifted) / d.radius
                flow_out.append(
                    (
                        q + float(out[k.WRAPPED]) - arc.wrapped - lifted,
                        -1.0 / down + out[k.WRAPPED_M],
                        by_t,
                        float(out[k.WRAPPED_X]),
                        by_w,
                        travel,
                    )
                )
            begun = True
            # runs between the drums
            for i in range(n - 1):
                row, length = n + i, self.drums[i + 1].run
                c0 = length * stretch + softer0[i]
                c1 = length * stretch + self._softer_run(i, travels)
                q, by_m, by_t, by_w = flow_in[i + 1]
                p, p_m, p_t, p_x, p_w, _ = flow_out[i]
                rise = 0.5 * self._run_rise(i + 1)
                r[row] = (after[i + 1] + rise) * c1 - (before[i + 1] + rise) * c0 - q + p
                jac[row, n + i + 1] += c1 - by_t + p_x
                jac[row, n + i] += p_t
                jac[row, i + 1] -= by_m
                jac[row, i] += p_m
                jac[row, 2 * n + 1 + i + 1] -= by_w
                jac[row, 2 * n + 1 + i] += p_w
            self._ends(h, t1, z, r, jac, flow_in, flow_out)
            self._turn(h, t1, z, r, jac, angles)
            try:
                dz = np.linalg.solve(jac, -r)
            except np.linalg.LinAlgError:
                raise HaltError("breaks away", worst_place or self.names[-1]) from None
            if not np.all(np.isfinite(dz)):
                raise HaltError("breaks away", worst_place or self.names[-1])
            fall = max(-dz[n + i] / after[i] for i in range(n + 1))
            if fall > 0.8:  # too far: no tension may turn into a push on the way
                dz *= 0.8 / fall
            z = (np.array(z) + dz).tolist()
            moved = max(abs(dz[n + i]) / max(abs(after[i]), 1.0) for i in range(n + 1))
            # Newton's method: what is left is of the order of the square of the last change
            if iteration and (moved < _SETTLED or change < _NEARLY):
                flows = {"surfaces": surfaces, "angles": angles, "travels": travels, "change": dz}
                return z, flows
        if min(z[n : 2 * n + 1]) < 0.05 * self.slack:
            raise self._slack(z[n : 2 * n + 1])
        raise HaltError("breaks away", worst_place or self.names[-1])

    def _slack(self, tensions: list[float]) -> HaltError:
        least = min(range(self.n + 1), key=lambda i: tensions[i])
        places = [f"before {self.names[0]}", *(f"behind {n}" for n in self.names)]
        return HaltError("the belt goes slack", places[least])

    def _run_rise(self, i: int) -> float:
        """Rise of tension over the run before drum i [N]."""
        return self.runs[i - 1] if 0 < i <= len(self.runs) else 0.0

    def _guess(self, h: float) -> list[float]:
        w = []
        for d in self.drums:
            if d.locked:
                w.append(0.0)
            elif d.turning.holds and d.turning.on:
                w.append(d.duty.speed * d.level)
            else:
                w.append(d.omega)
        m = [d.arc.m + h * d.arc._slope for d in self.drums]
        return [
            *m,
            *(max(t + dt, 0.5 * t) for t, dt in zip(self.T, self.dT, strict=True)),
            *w,
            self.v,
        ]

    def _ends(
        self, h: float, t1: float, z: list[float], r: Any, jac: Any, flow_in: Any, flow_out: Any
    ) -> None:
        """Equations of the first and last tension, and of the conveyor."""
        n, station, half = self.n, self.station, 0.5 * h
        before, after, v0, v1 = self.T, z[n : 2 * n + 1], self.v, z[3 * n + 1]
        first, last, own = 2 * n - 1, 2 * n, 3 * n + 1
        at = 3 * n + 1
        if station.conveyor_mass is None:
            load = 1.0
            for step in self.loads:
                if t1 >= step.at:
                    load = step.share(t1)
            r[first] = after[0] - (self.slack + self.pull * load)
            jac[first, n] = 1.0
            r[last] = after[n] - self.slack
            jac[last, 2 * n] = 1.0
            jac[own, at] = 1.0
            return
        carry, back = station.carry_run * self.stretch, station.return_run * self.stretch
        q, by_m, by_t, by_w = flow_in[0]
        r[first] = carry * (after[0] - before[0]) - q + half * (v0 + v1)
        jac[first, n], jac[first, 0] = carry - by_t, -by_m
        jac[first, 2 * n + 1], jac[first, at] = -by_w, half
        if station.take_up == "gravity":
            r[last] = after[n] - self.slack
            jac[last, 2 * n] = 1.0
        else:
            p, p_m, p_t, p_x, p_w, _ = flow_out[-1]
            r[last] = back * (after[n] - before[n]) - half * (v0 + v1) + p
            jac[last, 2 * n], jac[last, 2 * n - 1] = back + p_x, p_t
            jac[last, n - 1], jac[last, 3 * n], jac[last, at] = p_m, p_w, -half
            if station.take_up == "winch":
                miss = (self.slack - before[n]) / (0.05 * self.slack)
                r[last] -= h * station.winch_speed * min(max(miss, -1.0), 1.0)
        f0, _ = self._resistance(v0, self.t)
        f1, slope = self._resistance(v1, t1)
        mass = station.conveyor_mass
        r[own] = mass * (v1 - v0) - half * (before[0] - before[n] - f0 + after[0] - after[n] - f1)
        jac[own, n], jac[own, 2 * n], jac[own, at] = -half, half, mass + half * slope

    def _turn(self, h: float, t1: float, z: list[float], r: Any, jac: Any, angles: Any) -> None:
        """Equations of the drums."""
        n, half = self.n, 0.5 * h
        after, w1 = z[n : 2 * n + 1], z[2 * n + 1 : 3 * n + 1]
        leads: dict[int, tuple[float, float, float]] = {}
        for i in self.order:
            d, row, col = self.drums[i], 2 * n + 1 + i, 2 * n + 1 + i
            entry = after[i] + self._run_rise(i)
            rise_in, rise_out = self._rises(d, angles[i])
            moment, by_in, by_out = self._moment(d, entry, after[i + 1], rise_in, rise_out)
            if d.on_drum:
                d.extra = d.duty.torque * math.fsum(
                    o.ripple * math.sin(o.order * angles[i]) for o in d.on_drum if self.t >= o.at
                )
            jac[row, col] = 1.0
            if d.locked:
                r[row] = w1[i]
                leads[i] = (0.0, 0.0, 0.0)
                continue
            if (
                d.turning.holds
                and d.turning.on
                and not (d.measured and d.measured.what == "torque")
            ):
                r[row] = w1[i] - d.duty.speed * d.level
                # what holds the speed gives the torque that the belt and the drum's inertia ask
                held = moment + d.inertia * (w1[i] - d.omega) / h
                leads[i] = (held, d.inertia / h, 0.0)
                continue
            lead = leads[d.master] if d.master >= 0 else (0.0, 0.0, 0.0)
            torque, slope, by_lead = self._torque(d, w1[i], lead[0])
            scale = 1.0 / d.inertia
            r[row] = w1[i] - d.omega - half * scale * (d.torque - d.moment + torque - moment)
            jac[row, col] = 1.0 - half * scale * slope
            jac[row, n + i] += half * scale * by_in
            jac[row, n + i + 1] += half * scale * by_out
            if d.master >= 0 and by_lead:
                jac[row, 2 * n + 1 + d.master] -= half * scale * by_lead * lead[1]
                if self.drums[d.master].turning.holds:
                    master = self.drums[d.master]
                    arm = master.radius - master.squeeze * after[d.master]
                    jac[row, n + d.master] -= half * scale * by_lead * arm
                    jac[row, n + d.master + 1] += half * scale * by_lead * arm
            leads[i] = (torque, slope, by_lead)

    def _rises(self, d: DrumState, angle: float) -> tuple[float, float]:
        """Extra radius at the entry and at the exit nip."""
        if not d.on_drum and not d.riders:
            return 0.0, 0.0
        arc = d.arc
        first = int(arc.span[0])
        a, b = arc.rows[first], arc.rows[first + 1]
        w = (arc.shape.length - arc.at[0] + b[k.TRAVEL]) / (b[k.TRAVEL] - a[k.TRAVEL])
        return float(arc.rows[arc.span[1], k.RISE]), float(b[k.RISE] + w * (a[k.RISE] - b[k.RISE]))

    def _accept(self, h: float, t1: float, z: list[float], flows: dict[str, Any]) -> None:
        n, dz = self.n, flows["change"]
        after, w1 = z[n : 2 * n + 1], z[2 * n + 1 : 3 * n + 1]
        torques: list[float] = [0.0] * n
        for i in self.order:
            d = self.drums[i]
            entry = after[i] + self._run_rise(i)
            moment = self._moment(d, entry, after[i + 1], *self._rises(d, flows["angles"][i]))[0]
            lead = torques[d.master] if d.master >= 0 else 0.0
            if d.locked:
                torque, own = moment, 0.0
            elif d.turning.holds and d.turning.on:
                torque = moment + d.inertia * (w1[i] - d.omega) / h
                own = torque
            else:
                torque = own = self._torque(d, w1[i], lead)[0]
            if not d.locked:
                d.turning.accept(w1[i], own - d.extra, lead)
            torques[i] = own
            d.torque, d.moment = torque, moment
            arc = d.arc
            old = arc.m
            if arc.span[2]:
                arc.rise, arc.give, arc.dry = flows["surfaces"][i]
            d.turned_back = min(d.turned_back + flows["travels"][i] - arc.travel, 0.0)
            arc.finish(z[i], after[i + 1])
            arc._slope = (arc.m - old) / h
            d.omega, d.angle = w1[i], flows["angles"][i]
            if d.turned_back < -_BACK * arc.shape.length:
                raise HaltError("turns back", self.names[i])
        del dz
        self.dT = [a - b for a, b in zip(after, self.T, strict=True)]
        self.T, self.v, self.t = list(after), z[3 * n + 1], t1
        floor = 0.05 * self.slack
        if min(self.T) < floor:
            raise self._slack(self.T)

    def belt(self) -> float:
        """Unstretched belt on drums and runs, less a constant [m]; closed trains keep it."""
        total = 0.0
        for i, d in enumerate(self.drums):
            total += d.arc.lifted / d.radius - d.arc.wrapped
            if i + 1 < self.n:
                c = self.drums[i + 1].run * self.stretch + self._softer_run(
                    i, [e.arc.travel for e in self.drums]
                )
                total -= (self.T[i + 1] + 0.5 * self._run_rise(i + 1)) * c
        if self.station.conveyor_mass is not None:
            total -= self.T[0] * self.station.carry_run * self.stretch
            total -= self.T[self.n] * self.station.return_run * self.stretch
        return total


def steady_of(station: Station) -> CaseResult:
    """Return the steady state of a station.

    Raises
    ------
    InputError
        If there is none to move from.
    """
    train = station.train
    result = solve_case(train, train.case(station.load_case), Distributed(capacities=False))
    if not result.status.solved:
        message = f"there is no steady state to move from: {result.reason} {result.status}"
        raise InputError(Problem(key="motion", message=message))
    if not result.belt_speed > 0.0:
        message = "what moves needs a belt speed"
        raise InputError(Problem(key="belt.speed", message=message, remedy="Give [belt] speed."))
    return result


def duty_of(station: Station, steady: CaseResult, i: int) -> Duty:
    """Return what a drum does in the steady state."""
    member = steady.members[i]
    radius = member.surface_speed / member.rotation_speed
    return Duty(member.rotation_speed, member.drum_torque, station.drums[i].inertia, radius)
