"""What turns a drum: torque-speed characteristics, seen at the drum shaft.

A characteristic is written as the speed at a torque, so that a drive that holds its speed whatever
the torque is one too. Beyond the largest torque of a curve the speed falls on steeply: a solver
may pass through there, an operating point may not lie there (`Motor.limits`).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import ClassVar

from wraparc.drive import Limit
from wraparc.errors import Problem
from wraparc.schema.limits import limit_problems, raise_all

#: Fall of speed per rated torque beyond the end of a curve, for solvers only [-].
BEYOND = 10.0
#: Torque over rated torque that an AC motor bears for 15 s (IEC 60034-1, excess torque) [-].
MOMENTARY = 1.6
#: Breakdown torque at the lowest voltage that a motor has to run at, 90 %, over the rated one, by
#: the square of the voltage [-] (NEMA MG 1-12.44.1 and 12.44.2, condensed edition of 2011, 9.9).
LOW_VOLTAGE = 0.81


@dataclass(frozen=True, kw_only=True)
class Motor(ABC):
    """One or several equal motors on a drum, through a gear.

    Attributes
    ----------
    rated_power
        Rated shaft power of one motor [W].
    rated_speed
        Speed of the motor at rated torque [rad/s].
    gear_ratio
        Motor speed over drum speed [-].
    gear_efficiency
        Power out over power in of the gear, either way [-].
    motor_efficiency
        Shaft power over electrical power at the operating point [-], either way, or None where it
        is not known.
    count
        Equal motors on the drum, a whole number [-].
    brakes
        Whether it can also hold back (regenerate).

    Raises
    ------
    InputError
        With every number outside its limit.
    """

    LIMITS: ClassVar[dict[str, Limit]] = {
        "rated_power": Limit("power", open=True, most=1e9),
        "rated_speed": Limit("rotation_speed", open=True, most=1e5),
        "gear_ratio": Limit("number", open=True, most=1e4),
        "gear_efficiency": Limit("number", least=0.05, most=1.0),
        "motor_efficiency": Limit("number", least=0.05, most=1.0),
        "count": Limit("number", least=1, most=8),
    }

    rated_power: float
    rated_speed: float
    gear_ratio: float = 1.0
    gear_efficiency: float = 1.0
    motor_efficiency: float | None = None
    count: int = 1
    brakes: bool = True

    def __post_init__(self) -> None:
        problems = limit_problems(self, self.LIMITS)
        if self.count != int(self.count):
            message = "must be a whole number of motors"
            problems.append(Problem(key="count", value=f"{self.count:g}", message=message))
        raise_all(problems + self._problems())

    def _problems(self) -> list[Problem]:
        """Return what else is wrong."""
        return []

    @property
    def holds_speed(self) -> bool:
        """Whether the speed does not depend on the torque."""
        return False

    @property
    def rated_torque(self) -> float:
        """Rated torque of one motor, power over speed [N m]."""
        return self.rated_power / self.rated_speed

    @property
    def drum_torque(self) -> float:
        """Rated torque of all motors at the drum, without losses [N m]."""
        return self.count * self.gear_ratio * self.rated_torque

    @abstractmethod
    def shaft_speed(self, load: float) -> float:
        """Speed of the motor side of the gear [rad/s] at a load in rated torques [-]."""

    def motor_speed(self, load: float, gear_speed: float) -> float:
        """Speed of the motor itself [rad/s] at a load, the gear turning at a speed [rad/s]."""
        return gear_speed

    @abstractmethod
    def largest_load(self) -> float:
        """Largest torque over rated torque [-]; inf where the curve has no end."""

    def bears(self, momentary: bool) -> float:
        """Torque over rated torque that it bears, lasting or for a start [-]."""
        return min(MOMENTARY, self.largest_load()) if momentary else 1.0

    def load(self, drum_torque: float) -> float:
        """Torque of each motor over its rated torque, for a torque at the drum [N m]."""
        eta = self.gear_efficiency if drum_torque >= 0.0 else 1.0 / self.gear_efficiency
        return drum_torque / (eta * self.drum_torque)

    def drum_speed(self, drum_torque: float) -> float:
        """Speed of the drum [rad/s] at a torque on it [N m]; falls as the torque rises."""
        load, end = self.load(drum_torque), self.largest_load()
        within = min(max(load, -end), end)
        excess = load - within
        speed = self.shaft_speed(within) / self.gear_ratio
        return speed * math.exp(-BEYOND * math.copysign(math.log1p(abs(excess)), excess))

    def limits(self) -> tuple[float, float]:
        """Least and largest load that the motor can bear, in rated torques [-]."""
        end = self.largest_load()
        return (-end if self.brakes else 0.0), end


@dataclass(frozen=True, kw_only=True)
class VariableSpeed(Motor):
    """A motor on a frequency converter: a set speed that droops with load.

    speed = rated_speed (setting - droop load). An open-loop converter without slip compensation
    has the rated slip of its motor for droop; one with an encoder has 0.

    Attributes
    ----------
    setting
        Set speed over rated speed, the speed trim [-].
    droop
        Fall of speed at rated torque over rated speed [-].
    torque_limit
        Largest torque over rated torque [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Motor.LIMITS | {
        "setting": Limit("number", least=0.01, most=3.0),
        "droop": Limit("number", most=0.5),
        "torque_limit": Limit("number", open=True, rigid=True),
    }

    setting: float = 1.0
    droop: float = 0.0
    torque_limit: float = math.inf

    @property
    def holds_speed(self) -> bool:
        """Whether the speed does not depend on the torque."""
        return self.droop == 0.0

    def shaft_speed(self, load: float) -> float:
        """Set speed less droop [rad/s]."""
        return self.rated_speed * max(self.setting - self.droop * load, 1e-3)

    def largest_load(self) -> float:
        """Return the torque limit [-]."""
        # where droop alone would stop the motor, the line has no meaning
        stall = 0.9 * self.setting / self.droop if self.droop > 0.0 else math.inf
        return min(self.torque_limit, stall)


@dataclass(frozen=True, kw_only=True)
class Induction(Motor):
    """An induction motor on the mains: slip that rises with torque up to the breakdown torque.

    Kloss's formula M/M_b = 2/(s/s_b + s_b/s), its stable branch, the same when regenerating.

    Attributes
    ----------
    synchronous_speed
        Speed without slip [rad/s], above the rated speed.
    breakdown_ratio
        Breakdown torque over rated torque [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Motor.LIMITS | {
        "synchronous_speed": Limit("rotation_speed", open=True, most=1e5),
        "breakdown_ratio": Limit("number", least=1.1, most=10.0),
    }

    synchronous_speed: float
    breakdown_ratio: float = 2.5

    def _problems(self) -> list[Problem]:
        if 0.8 * self.synchronous_speed <= self.rated_speed < self.synchronous_speed:
            return []
        message = (
            f"must be below the synchronous speed {_rpm(self.synchronous_speed)} by at most 20 %"
        )
        return [Problem(key="rated_speed", value=_rpm(self.rated_speed), message=message)]

    @property
    def rated_slip(self) -> float:
        """Slip at rated torque [-]."""
        return 1.0 - self.rated_speed / self.synchronous_speed

    def shaft_speed(self, load: float) -> float:
        """Speed on the stable branch [rad/s]."""
        ratio = self.breakdown_ratio
        x = load / ratio
        # slip over breakdown slip (1 - sqrt(1 - x^2))/x, written so that it holds at 0
        part = x / (1.0 + math.sqrt(max(1.0 - x * x, 0.0)))
        breakdown_slip = self.rated_slip * (ratio + math.sqrt(ratio * ratio - 1.0))
        return self.synchronous_speed * max(1.0 - breakdown_slip * part, 1e-3)

    def largest_load(self) -> float:
        """Return the breakdown torque over rated torque [-]."""
        return self.breakdown_ratio

    def bears(self, momentary: bool) -> float:
        """Torque that it bears, and does not stall at in low voltage [-]."""
        return min(super().bears(momentary), LOW_VOLTAGE * self.breakdown_ratio)


@dataclass(frozen=True, kw_only=True)
class FluidCoupling(Induction):
    """An induction motor behind a fluid coupling with its slip curve.

    The torque of a coupling at one slip goes with the square of the speed of its pump, the motor
    side. Between the points of the curve the slip is interpolated linearly in torque, the same
    when the drum drives the motor.

    Attributes
    ----------
    coupling_load, coupling_slip
        The curve at the rated speed of the motor: torque over rated torque of the motor, and
        slip, both rising from 0 [-, -].
    """

    coupling_load: tuple[float, ...]
    coupling_slip: tuple[float, ...]

    def _problems(self) -> list[Problem]:
        problems = super()._problems()
        loads, slips = self.coupling_load, self.coupling_slip
        if len(loads) != len(slips) or len(loads) < 2:
            count = f"{len(loads)} and {len(slips)}"
            message = "the curve needs as many torques as slips, two or more of each"
            problems.append(Problem(key="coupling_slip", value=count, message=message))
        for key, values, top in (("coupling_load", loads, 10.0), ("coupling_slip", slips, 0.9)):
            rising = all(a < b for a, b in pairwise(values))
            if not (values and values[0] == 0.0 and rising and values[-1] <= top):
                message = f"must rise from 0 to at most {top:g}"
                problems.append(Problem(key=key, value=str(list(values)), message=message))
        return problems

    def shaft_speed(self, load: float) -> float:
        """Speed of the turbine side [rad/s]."""
        pump = super().shaft_speed(load)
        return pump * (1.0 - self._slip(load * (self.rated_speed / pump) ** 2))

    def motor_speed(self, load: float, gear_speed: float) -> float:
        """Speed of the pump side [rad/s]."""
        return super().shaft_speed(load)

    def _slip(self, load: float) -> float:
        size, loads, slips = abs(load), self.coupling_load, self.coupling_slip
        i = 0
        while i < len(loads) - 2 and size > loads[i + 1]:
            i += 1
        weight = (size - loads[i]) / (loads[i + 1] - loads[i])
        slip = slips[i] + weight * (slips[i + 1] - slips[i])
        return math.copysign(min(slip, 0.95), load)

    def largest_load(self) -> float:
        """Return the end of the curve or the breakdown torque, whichever comes first [-]."""
        return self._end

    @cached_property
    def _end(self) -> float:
        """Largest load at which the slowed pump still stays on the curve, by bisection [-]."""
        low, high = 0.0, self.breakdown_ratio
        for _ in range(60):
            load = 0.5 * (low + high)
            pump = super().shaft_speed(load)
            if load * (self.rated_speed / pump) ** 2 <= self.coupling_load[-1]:
                low = load
            else:
                high = load
        return high if high == self.breakdown_ratio else low


@dataclass(frozen=True, kw_only=True)
class TorqueFollower:
    """A drive whose torque is held in proportion to that of another one.

    Attributes
    ----------
    master
        Name of the pulley that it follows.
    ratio
        Torque on this drum over torque on the other [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = {"ratio": Limit("number", least=-10.0, most=10.0)}

    master: str
    ratio: float = 1.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))


def _rpm(speed: float) -> str:
    return f"{speed * 30.0 / math.pi:.6g} rpm"
