"""A station at one instant of the march, and the forces and lengths that follow of it."""

from __future__ import annotations

import math
from collections.abc import Callable

from wraparc.arc import Distributed
from wraparc.errors import input_error
from wraparc.motion.control import Follower
from wraparc.motion.drum_state import SOFT, drum_of
from wraparc.motion.event import Event, LoadStep, Measured, OnBelt, OnDrum, PowerFailure
from wraparc.motion.station import Station
from wraparc.motion.wraps import Wraps
from wraparc.train import CaseResult
from wraparc.train.solve import solve_case

#: Part of the shortest wrap that the lagging moves in a step where nothing asks for less.
_STEP = 0.07
#: Angle of the conveyor's swing in such a step [rad].
_SWING = 0.25
#: Part of the set tension by which it may be missed before the winch goes at its full speed.
_WINCH = 0.05


class HaltError(ArithmeticError):
    """The run cannot go on; says why."""

    def __init__(self, what: str, place: str) -> None:
        super().__init__(what, place)
        self.what, self.place = what, place


class StationState:
    """A station at one instant, running steadily; see `March` for what its numbers are given by.

    Attributes
    ----------
    t, h
        Time and length of a step [s].
    T, v
        Tensions before, between and behind the drums [N]; speed of the conveyor [m/s].
    rates, v_rate
        dT/dt [N/s] and dv/dt [m/s2] of the last step; with _0 of the one before.
    drums, wraps
        In belt order; their arcs as one table.
    pull, slack
        Effective tension of all drums, and tension of the take-up [N].
    stretch
        1/EA of the belt [1/N].
    mass, swing
        Of the conveyor, infinite without [kg], and how fast it swings on its belt [1/s].
    finest, divides, went
        Step with one piece of lagging at running speed [s]; whether steps are taken in parts where
        much happens, and how long the last part was [s].
    watch
        Called after every step or part of one.
    """

    def __init__(
        self,
        station: Station,
        event: Event,
        step: float | None = None,
        points: int = 100,
        every: float | None = None,
    ) -> None:
        self.station, self.event = station, event
        train = station.train
        self.case = case = train.case(station.load_case)
        self.steady = steady_of(station)
        self.stretch = 1.0 / train.belt.axial_stiffness
        self.runs = [case.run(i) for i in range(len(train.pulleys) - 1)]
        self.run_rises = [0.0, *self.runs]  # of tension over the run before every drum [N]
        self.splices = [
            h for h in event.of(OnBelt) if isinstance(h, OnBelt) and h.compliance != 1.0
        ]
        self.n = len(train.pulleys)
        self.drums = [drum_of(station, event, self.steady, i, points) for i in range(self.n)]
        self.wraps = Wraps([d.arc for d in self.drums])
        # masters before those that follow them
        self.order = sorted(range(self.n), key=lambda i: self.drums[i].master >= 0)
        self.names = station.names
        lead = self.drums[0]
        self.speed = lead.duty.speed * lead.duty.radius
        finest = min(d.arc.spacing / d.share for d in self.drums)
        self.finest = 1.2 * finest / self.speed
        self.divides = step is None and not self._delayed()
        self.watch: Callable[[], None] = lambda: None
        self.mass = station.conveyor_mass or math.inf
        self.swing = self._swing()
        self.h = step or (self._longest(every) if self.divides else self.finest)
        self.went = self.h
        self.t = 0.0
        self.pull = case.entry_tension - case.exit_tension
        self.slack = case.exit_tension
        self.loads = [h for h in event.of(LoadStep) if isinstance(h, LoadStep)]
        self.failures = [h for h in event.of(PowerFailure) if isinstance(h, PowerFailure)]
        between = [m.arc.exit_tension for m in self.steady.members[:-1]]
        self.T = [case.entry_tension, *between, case.exit_tension]
        self.least = min(self.T)  # where the belt is slack: of brakes where it enters [N]
        self.v = self.speed if not event.from_rest else 0.0
        # dT/dt and dv/dt, and in the step before
        self.rates, self.rates_0 = [0.0] * (self.n + 1), [0.0] * (self.n + 1)
        self.v_rate = self.v_rate_0 = 0.0
        self.h_before = self.h_0 = 0.0  # length of the last step and of the one before [s]

    def _swing(self) -> float:
        """Angular frequency of the conveyor on its belt, the drums standing [1/s]."""
        station = self.station
        runs = [station.carry_run]
        if station.take_up != "gravity":
            runs.append(station.return_run)
        return math.sqrt(math.fsum(1.0 / (run * self.stretch) for run in runs) / self.mass)

    def _longest(self, every: float | None) -> float:
        """Length of a step where nothing asks for less; the event is a number of them [s]."""
        shortest = min(d.arc.shape.length / d.share for d in self.drums)
        longest = _STEP * shortest / self.speed
        if self.swing:
            longest = min(longest, _SWING / self.swing)
        longest = max(longest, self.finest)
        if every and every < longest:  # rows are due more often
            return max(every, self.finest)
        return self.event.duration / math.ceil(self.event.duration / longest)

    def _delayed(self) -> bool:
        """Whether something needs short steps of one length: what turns, rides or comes late."""
        delayed = (OnDrum, OnBelt, Measured)
        return (
            self.station.take_up == "winch"
            or any(isinstance(h, delayed) for h in self.event.happenings)
            or any(
                d.trim is not None or isinstance(d.control, Follower) for d in self.station.drums
            )
        )

    def onward(self, h: float) -> float:
        """Weight of the change of a rate in the guess of what it will be over the next step [-]."""
        known = self.h_before + self.h_0
        return (h + self.h_before) / known if known else 1.0

    def load(self, t: float) -> float:
        """Resistance over that of the load case [-]."""
        share = 1.0
        for step in self.loads:
            if t >= step.at:
                share = step.share(t)
        return share

    def resistance(self, v: float, t: float) -> tuple[float, float]:
        """Resistance of the conveyor [N] and its slope by speed."""
        soft, lift = SOFT * self.speed, self.station.lift_share
        root = math.hypot(v, soft)
        part, slope = v / root, soft * soft / root**3
        full = self.pull * self.load(t)
        return full * (lift + (1.0 - lift) * part), full * (1.0 - lift) * slope

    def winch(self, tension: float) -> float:
        """Speed with which the winch takes belt in [m/s]."""
        miss = (self.slack - tension) / (_WINCH * self.slack)
        return self.station.winch_speed * min(max(miss, -1.0), 1.0)

    def softer_run(self, i: int, travels: list[float]) -> float:
        """What a splice in the run behind drum i adds to its compliance [m/N]."""
        if not self.splices:
            return 0.0
        more = 0.0
        d, e = self.drums[i], self.drums[i + 1]
        for (rider, front), (_, next_front) in zip(d.riders, e.riders, strict=True):
            if rider.compliance != 1.0:
                left = d.past_exit(travels[i], rider.length, front)
                come = min(max(travels[i + 1] / e.share - next_front, 0.0), rider.length)
                more += (left - come) * (rider.compliance - 1.0) * self.stretch
        return more

    def slackens(self, tensions: list[float]) -> bool:
        """Whether some tension, above m v^2, has become next to nothing."""
        now = max(d.arc.lift for d in self.drums)
        steady = max(d.arc.arc.centrifugal for d in self.drums)
        return min(tensions) - now < 0.05 * (self.least - steady)

    def goes_slack(self, tensions: list[float]) -> HaltError:
        """The end of a run whose belt goes slack."""
        least = min(range(self.n + 1), key=lambda i: tensions[i])
        places = [f"before {self.names[0]}", *(f"behind {n}" for n in self.names)]
        return HaltError("the belt goes slack", places[least])

    def belt(self) -> float:
        """Unstretched belt on drums and runs, less a constant [m]; closed trains keep it."""
        total = 0.0
        travels = [d.arc.travel for d in self.drums]
        for i, d in enumerate(self.drums):
            total += (d.arc.lifted / d.radius - d.arc.wrapped) / d.share
            if i + 1 < self.n:
                c = self.drums[i + 1].run * self.stretch + self.softer_run(i, travels)
                total -= (self.T[i + 1] + 0.5 * self.run_rises[i + 1]) * c
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
        message = f"no steady state to start from: {result.reason} {result.status}"
        raise input_error(key="motion", message=message)
    if not result.belt_speed > 0.0:
        message = "missing"
        raise input_error(key="belt.speed", message=message, remedy="Give [belt] speed.")
    return result
