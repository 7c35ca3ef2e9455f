"""What turns a drum in time: motors with their electrical side, and controllers of speed.

A description is frozen; `turning` makes what marches with the steps. Torques and speeds are those
of the drum shaft, and refer to the steady state of the load case: its torque is the rating unless
one is given, its speed the set speed.
"""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from wraparc.drive import Limit
from wraparc.schema.limits import limit_problems, raise_all


@dataclass(frozen=True)
class Duty:
    """A drum in its steady state.

    Attributes
    ----------
    speed
        omega [rad/s].
    torque
        On the drum [N m].
    inertia
        J of everything that turns with the drum, as seen at its shaft [kg m2].
    radius
        Of the loaded lagging [m].
    """

    speed: float
    torque: float
    inertia: float
    radius: float


@dataclass(frozen=True, kw_only=True)
class Control(ABC):
    """How a drum is driven.

    Attributes
    ----------
    rated_torque
        Torque at the drum that droop, slip and limits refer to [N m]; that of the load case if
        it is None.
    """

    LIMITS: ClassVar[dict[str, Limit]] = {"rated_torque": Limit("torque", open=True, most=1e9)}
    #: as it is said in a sentence
    words: ClassVar[str]
    rated_torque: float | None = None

    def __post_init__(self) -> None:
        given = {key: limit for key, limit in self.LIMITS.items() if getattr(self, key) is not None}
        raise_all(limit_problems(self, given))

    def rating(self, duty: Duty) -> float:
        """Torque that ratios refer to [N m]."""
        return self.rated_torque or max(abs(duty.torque), 1e-3)

    def most_torque(self, duty: Duty) -> float:
        """Torque that its set limit leaves, inf where it has none [N m]."""
        limit: float = getattr(self, "torque_limit", math.inf)
        return limit * self.rating(duty)

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Fall of torque per speed of the drum for small vibrations, -dM/d omega [N m s].

        Parameters
        ----------
        duty
            The steady state.
        lam
            Laplace variable, i omega for a vibration; a number or an array [1/s].
        """
        raise NotImplementedError


@dataclass(frozen=True, kw_only=True)
class ExactSpeed(Control):
    """The speed is held whatever the torque."""

    words = "exact speed"

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Infinite: as stiff as makes no difference."""
        return complex(math.inf)


@dataclass(frozen=True, kw_only=True)
class Droop(Control):
    """A speed that falls with the torque: a converter or a motor on its line.

    Attributes
    ----------
    droop
        Fall of speed at rated torque over set speed [-].
    lag
        Of the torque behind what is asked of it [s].
    torque_limit
        Largest torque over rated torque [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Control.LIMITS | {
        "droop": Limit("number", least=1e-5, most=0.5),
        "lag": Limit("time", most=10.0),
        "torque_limit": Limit("number", open=True, most=100.0),
    }
    words = "droop"
    droop: float = 0.01
    lag: float = 0.0
    torque_limit: float = 2.5

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Rated torque over droop, behind the lag."""
        return self.rating(duty) / (self.droop * duty.speed) / (1.0 + lam * self.lag)


@dataclass(frozen=True, kw_only=True)
class SpeedLoop(Control):
    """A drive with a speed controller: proportional and integral, with a limit of torque.

    Attributes
    ----------
    bandwidth
        Of the loop with the drum's own inertia [1/s]: gain J 2 pi f, f in Hz.
    reset
        Time of the integral part [s].
    lag, torque_limit
        As in `Droop`.
    """

    LIMITS: ClassVar[dict[str, Limit]] = Control.LIMITS | {
        "bandwidth": Limit("number", open=True, most=100.0),
        "reset": Limit("time", open=True, most=1e3),
        "lag": Limit("time", most=10.0),
        "torque_limit": Limit("number", open=True, most=100.0),
    }
    words = "speed loop"
    bandwidth: float
    reset: float
    lag: float = 0.0
    torque_limit: float = 2.5

    def gain(self, duty: Duty) -> float:
        """Torque per miss of speed [N m s]."""
        return 2.0 * math.pi * self.bandwidth * duty.inertia

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Gain of both parts, behind the lag."""
        return self.gain(duty) * (1.0 + 1.0 / (lam * self.reset)) / (1.0 + lam * self.lag)


@dataclass(frozen=True, kw_only=True)
class InductionMotor(Control):
    """A motor on the mains: Kloss's curve up to breakdown, above it the starting torque.

    Attributes
    ----------
    rated_slip
        At rated torque [-].
    breakdown_ratio, starting_ratio
        Breakdown and starting torque over rated torque [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Control.LIMITS | {
        "rated_slip": Limit("number", least=1e-4, most=0.2),
        "breakdown_ratio": Limit("number", least=1.1, most=10.0),
        "starting_ratio": Limit("number", open=True, most=10.0),
    }
    words = "induction motor"
    starting_ratio: float
    rated_slip: float = 0.01
    breakdown_ratio: float = 2.5

    def curve(self, slip: float) -> tuple[float, float]:
        """Torque over rated torque and its slope by slip."""
        b = self.breakdown_ratio
        peak = self.rated_slip * (b + math.sqrt(b * b - 1.0))
        if slip > peak:  # a straight line to the starting torque: Kloss's gives far too little
            w = min((slip - peak) / (1.0 - peak), 1.0)
            slope = (self.starting_ratio - b) / (1.0 - peak) if w < 1.0 else 0.0
            return b + w * (self.starting_ratio - b), slope
        d = peak * peak + slip * slip
        return 2.0 * b * peak * slip / d, 2.0 * b * peak * (peak * peak - slip * slip) / (d * d)

    def slip_at(self, load: float) -> float:
        """Slip at a load in rated torques, below breakdown [-]."""
        b = self.breakdown_ratio
        x = min(max(load / b, -0.999), 0.999)
        return self.rated_slip * (b + math.sqrt(b * b - 1.0)) * x / (1.0 + math.sqrt(1.0 - x * x))

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Slope of the curve at the steady torque."""
        slip, top = self.slip_at(duty.torque / self.rating(duty)), duty.speed
        return self.curve(slip)[1] * self.rating(duty) * (1.0 - slip) / top


@dataclass(frozen=True, kw_only=True)
class CoupledMotor(Control):
    """An induction motor behind a fluid coupling: its torque goes with the pump speed squared.

    Attributes
    ----------
    coupling_slip
        At rated torque [-].
    coupling_limit
        Torque of the full coupling at standstill over rated torque [-].
    pump_inertia
        Of motor and pump, as seen at the drum [kg m2].
    rated_slip, breakdown_ratio, starting_ratio
        Of the motor, as in `InductionMotor`.
    """

    LIMITS: ClassVar[dict[str, Limit]] = InductionMotor.LIMITS | {
        "coupling_slip": Limit("number", least=1e-3, most=0.3),
        "coupling_limit": Limit("number", least=1.05, most=10.0),
        "pump_inertia": Limit("moment_of_inertia", open=True, most=1e9),
    }
    words = "fluid coupling"
    pump_inertia: float
    coupling_slip: float = 0.03
    coupling_limit: float = 1.8
    rated_slip: float = 0.01
    breakdown_ratio: float = 2.5
    starting_ratio: float = 1.8

    @property
    def motor(self) -> InductionMotor:
        """The motor alone."""
        return InductionMotor(
            rated_slip=self.rated_slip,
            breakdown_ratio=self.breakdown_ratio,
            starting_ratio=self.starting_ratio,
        )

    def transmitted(self, slip: float) -> tuple[float, float]:
        """Torque at the rated pump speed over rated torque, and its slope by slip.

        limit (1 - exp(-slip/s0)), through 1 at the rated slip; odd.
        """
        s0 = -self.coupling_slip / math.log1p(-1.0 / self.coupling_limit)
        fall = math.exp(-abs(slip) / s0)
        return (
            math.copysign(self.coupling_limit * (1.0 - fall), slip),
            self.coupling_limit * fall / s0,
        )

    def slip_at(self, load: float) -> float:
        """Slip at a load in rated torques, at the rated pump speed [-]."""
        s0 = -self.coupling_slip / math.log1p(-1.0 / self.coupling_limit)
        x = min(abs(load) / self.coupling_limit, 0.999)
        return math.copysign(-s0 * math.log1p(-x), load)

    def running(self, duty: Duty) -> tuple[float, float]:
        """Steady speed of the pump, and of the motor without load [rad/s]."""
        load = duty.torque / self.rating(duty)
        pump = duty.speed / (1.0 - self.slip_at(load))
        return pump, pump / (1.0 - self.motor.slip_at(load))

    def through(
        self, rating: float, rated_pump: float, pump: float, omega: float
    ) -> tuple[float, float, float]:
        """Torque [N m] and its slopes by the speeds of pump and drum [rad/s]."""
        size = max(abs(pump), 1e-3 * rated_pump)
        value, slope = self.transmitted((pump - omega) / size)
        part = rating * (size / rated_pump) ** 2
        torque = part * value
        by_pump = part * slope * (omega / (size * size)) + 2.0 * torque / size
        return torque, by_pump, -part * slope / size

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """Coupling against the pump, whose inertia hangs on the motor."""
        rating = self.rating(duty)
        pump, top = self.running(duty)
        _, by_pump, by_drum = self.through(rating, pump, pump, duty.speed)
        motor = rating * self.motor.curve(1.0 - pump / top)[1] / top + lam * self.pump_inertia
        return -by_drum * motor / (motor + by_pump)


@dataclass(frozen=True, kw_only=True)
class Follower(Control):
    """A drive whose torque follows that of another one, behind a lag and a dead time.

    Attributes
    ----------
    master
        Name of the pulley that it follows.
    ratio
        Torque over that of the master [-]; that of the load case if it is None.
    lag, dead_time
        Of the torque behind the master's [s].
    damping
        Droop of an added speed feedback [-]; None for none.
    """

    LIMITS: ClassVar[dict[str, Limit]] = Control.LIMITS | {
        "ratio": Limit("number", least=-10.0, most=10.0),
        "lag": Limit("time", most=10.0),
        "dead_time": Limit("time", most=10.0),
        "damping": Limit("number", least=1e-4, most=10.0),
    }
    words = "torque follower"
    master: str
    ratio: float | None = None
    lag: float = 0.1
    dead_time: float = 0.0
    damping: float | None = None

    def speed_gain(self, duty: Duty) -> float:
        """Torque per miss of speed [N m s]."""
        return 0.0 if self.damping is None else self.rating(duty) / (self.damping * duty.speed)

    def behind(self, lam: Any) -> Any:
        """F: torque over the master's torque, without the ratio."""
        return np.exp(-lam * self.dead_time) / (1.0 + lam * self.lag)

    def yielding(self, duty: Duty, lam: Any) -> Any:
        """The speed feedback alone."""
        return complex(self.speed_gain(duty))


@dataclass(frozen=True, kw_only=True)
class Trim:
    """Load sharing: the set speed of a drive is trimmed until it takes its share.

    trim' = gain (share set - share measured), the measured share behind a filter and a dead time.

    Attributes
    ----------
    gain
        k, per second and share [-].
    filter_time, dead_time
        Of the measurement [s].
    """

    LIMITS: ClassVar[dict[str, Limit]] = {
        "gain": Limit("number", open=True, most=100.0),
        "filter_time": Limit("time", most=100.0),
        "dead_time": Limit("time", most=100.0),
    }
    gain: float
    filter_time: float = 0.0
    dead_time: float = 0.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))
