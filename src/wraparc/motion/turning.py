"""What turns a drum, on the march: the states of motors and controllers from step to step."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections import deque

from wraparc.motion.control import (
    Control,
    CoupledMotor,
    Droop,
    Duty,
    Follower,
    InductionMotor,
    SpeedLoop,
    Trim,
)


class Turning(ABC):
    """The march of one drive. `level` is the set speed over that of the steady state."""

    #: whether the speed is given whatever the torque
    holds = False
    #: how full a fluid coupling is, and a follower's torque over that of its master
    fill = 1.0
    ratio = 1.0

    def __init__(self, duty: Duty, rating: float) -> None:
        self.duty, self.rating = duty, rating
        self.on = 1.0  # of the torque: 0 after a power failure

    def begin(self, h: float, level: float) -> None:
        """Begin a step of h [s] that ends at a level of the set speed [-]."""
        self.h, self.level = h, level

    @abstractmethod
    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, its slopes by speed and by the master's torque."""

    def accept(self, omega: float, torque: float, lead: float) -> None:  # noqa: B027
        """Take the step for good."""

    def run(self, level: float, omega: float, torque: float) -> None:  # noqa: B027
        """Be in a state that has lasted: a level of the set speed, a speed and a torque."""


def turning_of(control: Control, duty: Duty) -> Turning:
    """Return what marches of a control, in the steady state."""
    rating = control.rating(duty)
    if isinstance(control, Droop):
        gain = rating / (control.droop * duty.speed)
        return Lagging(duty, rating, gain, 0.0, control.lag, control.torque_limit)
    if isinstance(control, SpeedLoop):
        gain, reset = control.gain(duty), control.reset
        return Lagging(duty, rating, gain, reset, control.lag, control.torque_limit)
    if isinstance(control, InductionMotor):
        return Mains(duty, rating, control)
    if isinstance(control, CoupledMotor):
        return Coupled(duty, rating, control)
    if isinstance(control, Follower):
        return Following(duty, rating, control)
    return Exact(duty, rating)


class Exact(Turning):
    """The speed is given."""

    holds = True

    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, and its slopes."""
        return 0.0, 0.0, 0.0


class Lagging(Turning):
    """Droop and the speed loop: a gain on the miss of speed, an integral, a lag, a limit."""

    def __init__(
        self, duty: Duty, rating: float, gain: float, reset: float, lag: float, limit: float
    ) -> None:
        super().__init__(duty, rating)
        self.gain, self.reset, self.lag, self.limit = gain, reset, lag, limit
        # droop: the set speed is above the steady one by what the steady torque takes
        self.above = 0.0 if reset else duty.torque / gain
        self.held = self.miss = self.asked = self.given = 0.0

    def run(self, level: float, omega: float, torque: float) -> None:
        """Be in a state that has lasted."""
        self.miss = level * self.duty.speed + self.above * level - omega
        self.held = torque - self.gain * self.miss if self.reset else 0.0
        self.asked = self.given = torque

    def _asked(self, omega: float) -> tuple[float, float, float]:
        """Torque asked for, its slope, and the integral part."""
        miss = self.level * (self.duty.speed + self.above) - omega
        held, slope = self.held, -self.gain
        if self.reset:
            held += 0.5 * self.h * self.gain / self.reset * (self.miss + miss)
            slope -= 0.5 * self.h * self.gain / self.reset
        asked, end = self.gain * miss + held, self.limit * self.rating
        if abs(asked) > end:  # the integral stands still at the limit
            return math.copysign(end, asked), 0.0, self.held
        return asked, slope, held

    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, and its slopes."""
        asked, slope, _ = self._asked(omega)
        if self.lag == 0.0:
            return self.on * asked, self.on * slope, 0.0
        w = 0.5 * self.h / self.lag
        value = (self.given * (1.0 - w) + w * (self.asked + self.on * asked)) / (1.0 + w)
        return value, self.on * w * slope / (1.0 + w), 0.0

    def accept(self, omega: float, torque: float, lead: float) -> None:
        """Take the step for good."""
        asked, _, self.held = self._asked(omega)
        self.miss = self.level * (self.duty.speed + self.above) - omega
        self.asked, self.given = self.on * asked, torque


class Mains(Turning):
    """A motor on the mains."""

    def __init__(self, duty: Duty, rating: float, motor: InductionMotor) -> None:
        super().__init__(duty, rating)
        self.motor = motor
        self.top = duty.speed / (1.0 - motor.slip_at(duty.torque / rating))
        self.level = 1.0

    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, and its slopes."""
        on = self.on if self.level > 0.0 else 0.0
        value, slope = self.motor.curve(1.0 - omega / self.top)
        return on * self.rating * value, -on * self.rating * slope / self.top, 0.0


class Coupled(Turning):
    """A motor behind a fluid coupling: the speed of its pump is a state."""

    def __init__(self, duty: Duty, rating: float, control: CoupledMotor) -> None:
        super().__init__(duty, rating)
        self.control, self.motor = control, control.motor
        self.pump, self.top = control.running(duty)
        self.rated_pump = self.pump
        self.pump_before, self.h_before = self.pump, 0.0
        self.level = 1.0

    def mains(self, pump: float) -> tuple[float, float]:
        """Motor torque and its slope by speed."""
        on = self.on if self.level > 0.0 else 0.0
        value, slope = self.motor.curve(1.0 - pump / self.top)
        return on * self.rating * value, -on * self.rating * slope / self.top

    def through(self, pump: float, omega: float) -> tuple[float, float, float]:
        """Torque of the coupling and its slopes by pump and drum speed."""
        return self.control.through(self.fill * self.rating, self.rated_pump, pump, omega)

    def run(self, level: float, omega: float, torque: float) -> None:
        """Be in a state that has lasted."""
        self.level = level
        if omega == 0.0:
            self.pump = self.pump_before = 0.0

    def _solved(self, omega: float) -> tuple[float, float, float]:
        """Pump speed at the end of the step, torque and its slope by drum speed.

        Backward differences of second order: a pump that runs up without load is stiff. What is
        asked rises with the pump's speed: Newton's method, halving where it leaves the bracket.
        """
        ratio = self.h / self.h_before if self.h_before else 0.0
        share = (1.0 + ratio) / (1.0 + 2.0 * ratio) * self.h / self.control.pump_inertia
        start = self.pump + ratio**2 / (1.0 + 2.0 * ratio) * (self.pump - self.pump_before)
        most = 2.0 * max(self.top, abs(omega), abs(self.pump))
        low, high, pump = -most, most, self.pump
        torque = by_drum = by_pump = slope = 0.0
        for _ in range(80):
            motor, motor_slope = self.mains(pump)
            torque, by_pump, by_drum = self.through(pump, omega)
            miss = pump - start - share * (motor - torque)
            slope = 1.0 - share * (motor_slope - by_pump)
            if miss > 0.0:
                high = pump
            else:
                low = pump
            new = pump - miss / slope if slope > 0.0 else math.nan
            if not low < new < high:
                new = 0.5 * (low + high)
            done, pump = abs(new - pump) < 1e-12 * self.top, new
            if done:
                break
        # d pump / d omega from the same equation
        follow = -share * by_drum / slope
        return pump, torque, by_drum + by_pump * follow

    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, and its slopes."""
        _, torque, slope = self._solved(omega)
        return torque, slope, 0.0

    def accept(self, omega: float, torque: float, lead: float) -> None:
        """Take the step for good."""
        self.pump_before, self.pump = self.pump, self._solved(omega)[0]
        self.h_before = self.h


class Following(Turning):
    """A torque that follows another one, behind a lag and a dead time."""

    def __init__(self, duty: Duty, rating: float, control: Follower) -> None:
        super().__init__(duty, rating)
        self.control, self.gain = control, control.speed_gain(duty)
        self.ratio = control.ratio or 1.0
        self.asked = self.given = 0.0
        self.past: deque[float] = deque()

    def run(self, level: float, omega: float, torque: float) -> None:
        """Be in a state that has lasted."""
        # at rest the master's torque is 0 as well
        self.given = torque - self.gain * (level * self.duty.speed - omega)
        self.asked = self.given
        self.past.clear()

    def _asked(self, lead: float) -> tuple[float, float]:
        dead = self.control.dead_time
        if dead < self.h:
            return self.ratio * lead, self.ratio
        count = round(dead / self.h)
        return (self.past[-count] if len(self.past) >= count else self.asked), 0.0

    def torque(self, omega: float, lead: float) -> tuple[float, float, float]:
        """Torque at the end of the step, and its slopes."""
        asked, by_lead = self._asked(lead)
        w = 0.5 * self.h / self.control.lag if self.control.lag > 0.0 else math.inf
        if math.isinf(w):
            given, share = asked, 1.0
        else:
            given, share = (
                (self.given * (1.0 - w) + w * (self.asked + asked)) / (1.0 + w),
                w / (1.0 + w),
            )
        miss = self.level * self.duty.speed - omega
        return (
            self.on * (given + self.gain * miss),
            -self.on * self.gain,
            self.on * share * by_lead,
        )

    def accept(self, omega: float, torque: float, lead: float) -> None:
        """Take the step for good."""
        asked, _ = self._asked(lead)
        miss = self.level * self.duty.speed - omega
        self.given = torque / self.on - self.gain * miss if self.on else 0.0
        self.asked = asked
        if self.control.dead_time >= self.h:
            self.past.append(self.ratio * lead)
            while len(self.past) > round(self.control.dead_time / self.h):
                self.past.popleft()


class Trimming:
    """The march of a trim: second order, by what was measured up to the step."""

    def __init__(self, trim: Trim, share: float) -> None:
        self.trim, self.goal = trim, share
        self.value, self.rate, self.filtered = 0.0, 0.0, share
        self.past: deque[float] = deque()

    def next(self, h: float, share: float) -> float:
        """Return the trim one step after a share was measured."""
        count = round(self.trim.dead_time / h)
        self.past.append(share)
        measured = self.past.popleft() if len(self.past) > count else self.goal
        if self.trim.filter_time > 0.0:
            self.filtered += (measured - self.filtered) * -math.expm1(-h / self.trim.filter_time)
        else:
            self.filtered = measured
        rate = self.trim.gain * (self.goal - self.filtered)
        self.value += h * (1.5 * rate - 0.5 * self.rate)
        self.rate = rate
        return self.value

    def state(self) -> tuple[float, float, float, tuple[float, ...]]:
        """What :meth:`next` changes."""
        return self.value, self.rate, self.filtered, tuple(self.past)

    def back(self, state: tuple[float, float, float, tuple[float, ...]]) -> None:
        """Go back to a state."""
        self.value, self.rate, self.filtered = state[:3]
        self.past = deque(state[3])
