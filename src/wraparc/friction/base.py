"""What every friction law is: friction as a function of slip and wrap pressure."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from wraparc.errors import InputError, Problem
from wraparc.friction.compact import CompactLaw

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class TestedRange:
    """The pressures and slips a law was measured in; beyond them it is an extrapolation.

    Attributes
    ----------
    pressure_min, pressure_max
        Lowest and highest tested wrap pressure [Pa].
    slip_max
        Largest tested slip [m].
    slip_speed
        Speed of slip in the tests [m/s], or None where it is not said.
    """

    __test__ = False  # not a test class, whatever its name suggests to a test collector

    pressure_min: float
    pressure_max: float
    slip_max: float
    slip_speed: float | None = None

    def __post_init__(self) -> None:
        check(
            (
                0.0 < self.pressure_min <= self.pressure_max < np.inf,
                "pressure",
                f"{self.pressure_min:g} .. {self.pressure_max:g} Pa",
                "the tested pressures must be positive, finite and in order",
            ),
            (
                0.0 < self.slip_max < np.inf,
                "slip_max",
                f"{self.slip_max:g} m",
                "the largest tested slip must be positive and finite",
            ),
            (
                self.slip_speed is None or 0.0 < self.slip_speed < np.inf,
                "slip_speed",
                f"{self.slip_speed} m/s",
                "the speed of slip in the tests must be positive and finite",
            ),
        )


class FrictionLaw(ABC):
    """Friction of a lagging, mu(x, p): an odd function of slip x that depends on wrap pressure p.

    Below the lowest tested pressure friction is held; above the highest the traction mu p is held.
    Slip is never clamped. Laws are frozen data: equal numbers make equal laws.
    """

    tested: TestedRange | None

    @abstractmethod
    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """Friction coefficient.

        Parameters
        ----------
        slip
            Slip of the belt on the lagging surface, rearward positive [m]; any shape.
        pressure
            Wrap pressure, > 0 [Pa]; broadcast against `slip`.

        Returns
        -------
        numpy.ndarray
            mu(slip, pressure) with the sign of `slip` [-].
        """

    @abstractmethod
    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""

    @abstractmethod
    def steepest_fall(self) -> float:
        """Steepest fall of friction with slip, a number <= 0 [1/m]."""


def held_pressure(edges: ArrayLike, pressure: ArrayLike) -> tuple[Array, Array]:
    """Pressure clamped to the edges [Pa], and the factor that holds the traction above them [-]."""
    p = np.asarray(pressure, dtype=float)
    e = np.asarray(edges, dtype=float)
    if e.size == 0:
        return p, np.ones_like(p)
    return np.clip(p, e[0], e[-1]), np.where(p > e[-1], e[-1] / p, 1.0)


def check(*tests: tuple[bool, str, str, str]) -> None:
    """Raise one InputError with every failed test (passed, key, value as given, sentence)."""
    failed = [
        Problem(key=key, value=value, message=message)
        for passed, key, value, message in tests
        if not passed
    ]
    if failed:
        raise InputError(failed)
