"""What every friction law is: friction as a function of slip and wrap pressure."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem
from wraparc.friction.compact import CompactLaw


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


@dataclass(frozen=True)
class Equation:
    """One equation, as documents show it.

    Attributes
    ----------
    title
        What it says.
    typst, latex
        The equation in either language.
    words
        The equation read aloud.
    """

    title: str
    typst: str
    latex: str
    words: str


#: What the slip of a law may hold besides the sliding, where its tests did not take it out.
SLIP_INCLUDES = LAGGING_SHEAR, COVER_SHEAR = ("lagging shear", "cover shear")


@dataclass(frozen=True, kw_only=True)
class FrictionLaw(ABC):
    """Friction of a lagging, mu(x, p): an odd function of slip x that depends on wrap pressure p.

    Below the lowest tested pressure friction is held; above the highest the traction mu p is held.
    Slip is never clamped. Laws are frozen data: equal numbers make equal laws.

    Attributes
    ----------
    slip_includes
        What the slip holds besides the sliding, of `SLIP_INCLUDES`; None where it is not known.
    """

    #: What engineers call the law.
    title: ClassVar[str]
    equation: ClassVar[Equation]

    slip_includes: tuple[str, ...] | None = None

    @property
    @abstractmethod
    def tested(self) -> TestedRange | None:
        """The range it was measured in, or None."""

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

    def scaled(self, friction: float = 1.0, slip: float = 1.0) -> Self:
        """Return the law with mu'(x, p) = friction * mu(x / slip, p).

        Parameters
        ----------
        friction
            Factor on the friction, > 0 [-].
        slip
            Factor on the slip axis, > 0 [-]: peaks move to this multiple of their slip.
        """
        return self if friction == slip == 1.0 else self._scaled(friction, slip)

    @abstractmethod
    def _scaled(self, friction: float, slip: float) -> Self:
        """Return the law scaled by factors of which one is not 1."""


def held_pressure(edges: ArrayLike, pressure: ArrayLike) -> tuple[Array, Array]:
    """Pressure clamped to the edges [Pa], and the factor that holds the traction above them [-]."""
    p = np.asarray(pressure, dtype=float)
    e = np.asarray(edges, dtype=float)
    if e.size == 0:
        return p, np.ones_like(p)
    return np.clip(p, e[0], e[-1]), np.where(p > e[-1], e[-1] / p, 1.0)


#: What no pair of materials falls short of by far; below, digits of the solvers would be lost [-].
LEAST_FRICTION = 1e-6
#: Between points of a table, and up to a peak [m]; the most is more than any belt can slip.
LEAST_SLIP, MOST_SLIP = 1e-9, 1e3


def check(*tests: tuple[bool, str, str, str]) -> None:
    """Raise one InputError with every failed test (passed, key, value as given, sentence)."""
    failed = [
        Problem(key=key, value=value, message=message)
        for passed, key, value, message in tests
        if not passed
    ]
    if failed:
        raise InputError(failed)
