"""Motors of many trains: the characteristics of `wraparc.train.motors` by column."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from wraparc.arrays import Array
from wraparc.train.motors import BEYOND, FluidCoupling, Induction, Motor, VariableSpeed


@dataclass(frozen=True, eq=False)
class MotorRows:
    """A motor, some of its numbers different from row to row.

    Attributes
    ----------
    motor
        The motor.
    own
        Its numbers by their names, shape (n,) each, or one number for all rows.
    """

    motor: Motor
    own: Mapping[str, Any]

    def rows(self, which: Any) -> MotorRows:
        """Return some of the rows."""
        some = {k: v[which] if np.ndim(v) else v for k, v in self.own.items()}
        return MotorRows(self.motor, some)

    def row(self, i: int) -> Motor:
        """Return the motor of one row."""
        one: dict[str, Any] = {k: float(v[i]) for k, v in self.own.items() if np.ndim(v)}
        return replace(self.motor, **one)

    def of(self, name: str) -> Any:
        """A number of the motor."""
        return self.own.get(name, getattr(self.motor, name))

    @property
    def rated_torque(self) -> Any:
        """Rated torque of one motor [N m]."""
        return self.of("rated_power") / self.of("rated_speed")

    @property
    def drum_torque(self) -> Any:
        """Rated torque of all motors at the drum, without losses [N m]."""
        return self.motor.count * self.of("gear_ratio") * self.rated_torque

    def load(self, drum_torque: Array) -> Array:
        """Torque of each motor over its rated torque."""
        gear = self.of("gear_efficiency")
        eta = np.where(drum_torque >= 0.0, gear, 1.0 / gear)
        return np.asarray(drum_torque / (eta * self.drum_torque))

    def drum_speed(self, drum_torque: Array) -> Array:
        """Speed of the drum [rad/s], see `Motor.drum_speed`."""
        load, end = self.load(drum_torque), self.largest_load
        within = np.minimum(np.maximum(load, -end), end)
        excess = load - within
        speed = self.shaft_speed(within) / self.of("gear_ratio")
        fall = np.copysign(np.log1p(np.abs(excess)), excess)
        return np.asarray(speed * np.exp(-BEYOND * fall))

    def shaft_speed(self, load: Any) -> Any:
        """Speed of the motor side of the gear [rad/s]."""
        if isinstance(self.motor, VariableSpeed):
            part = self.of("setting") - self.of("droop") * load
            return self.of("rated_speed") * np.maximum(part, 1e-3)
        pump = self._of_mains(load)
        if not isinstance(self.motor, FluidCoupling):
            return pump
        return pump * (1.0 - self._coupling_slip(load * (self.of("rated_speed") / pump) ** 2))

    def motor_speed(self, load: Array, gear_speed: Array) -> Array:
        """Speed of the motor itself [rad/s]."""
        if isinstance(self.motor, FluidCoupling):
            return np.asarray(self._of_mains(load))
        return gear_speed

    @cached_property
    def largest_load(self) -> Any:
        """Largest torque over rated torque [-]."""
        if isinstance(self.motor, VariableSpeed):
            droop, setting = np.asarray(self.of("droop")), self.of("setting")
            stall = np.where(droop > 0.0, 0.9 * setting / np.where(droop > 0.0, droop, 1.0), np.inf)
            return np.minimum(self.of("torque_limit"), stall)
        if isinstance(self.motor, FluidCoupling):
            return self._coupling_end(self.motor)
        return self.of("breakdown_ratio")

    @property
    def limits(self) -> tuple[Any, Any]:
        """Least and largest load that the motor can bear, in rated torques [-]."""
        end = self.largest_load
        return (-end if self.motor.brakes else 0.0), end

    def _of_mains(self, load: Any) -> Any:
        """Speed of an induction motor on the stable branch [rad/s]."""
        assert isinstance(self.motor, Induction)  # noqa: S101 - the kinds there are
        ratio, synchronous = self.of("breakdown_ratio"), self.of("synchronous_speed")
        x = load / ratio
        part = x / (1.0 + np.sqrt(np.maximum(1.0 - x * x, 0.0)))
        rated_slip = 1.0 - self.of("rated_speed") / synchronous
        breakdown_slip = rated_slip * (ratio + np.sqrt(ratio * ratio - 1.0))
        return synchronous * np.maximum(1.0 - breakdown_slip * part, 1e-3)

    def _coupling_slip(self, load: Any) -> Any:
        assert isinstance(self.motor, FluidCoupling)  # noqa: S101 - asked of couplings only
        loads, slips = np.array(self.motor.coupling_load), np.array(self.motor.coupling_slip)
        size = np.abs(load)
        i = np.clip(np.searchsorted(loads, size, side="left") - 1, 0, len(loads) - 2)
        weight = (size - loads[i]) / (loads[i + 1] - loads[i])
        slip = slips[i] + weight * (slips[i + 1] - slips[i])
        return np.copysign(np.minimum(slip, 0.95), load)

    def _coupling_end(self, motor: FluidCoupling) -> Any:
        """Largest load at which the slowed pump still stays on the curve, by bisection [-]."""
        top = np.asarray(self.of("breakdown_ratio"), dtype=float)
        shape = np.broadcast_shapes(*(np.shape(v) for v in self.own.values()), top.shape)
        high = np.broadcast_to(top, shape).copy()
        low = np.zeros_like(high)
        for _ in range(60):
            load = 0.5 * (low + high)
            on = load * (self.of("rated_speed") / self._of_mains(load)) ** 2
            stays = on <= motor.coupling_load[-1]
            low, high = np.where(stays, load, low), np.where(stays, high, load)
        return np.where(high == top, high, low)
