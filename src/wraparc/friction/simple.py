"""Laws with a fixed limit of friction: constant, elastic-plastic, power of pressure."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.friction.base import (
    LEAST_FRICTION,
    Equation,
    FrictionLaw,
    TestedRange,
    check,
    held_pressure,
)
from wraparc.friction.compact import LIMIT, CompactLaw


def _edges(tested: TestedRange | None) -> tuple[float, ...]:
    return () if tested is None else (tested.pressure_min, tested.pressure_max)


_POSITIVE = "must be positive and finite"


def _is_friction(mu: float) -> tuple[bool, str, str, str]:
    """Whether a coefficient of friction may be one, as `check` asks."""
    message = f"friction must be at least {LEAST_FRICTION:g} and finite"
    return LEAST_FRICTION <= mu < np.inf, "friction_coefficient", f"{mu:g}", message


@dataclass(frozen=True, kw_only=True)
class Constant(FrictionLaw):
    """Euler-Eytelwein: friction is one number once the belt slips.

    Attributes
    ----------
    friction_coefficient
        mu_0, >= 1e-6 [-].
    tested
        Range of the measurement behind it, or None.
    """

    title = "constant friction (Euler-Eytelwein)"
    equation = Equation("Constant friction", "mu = mu_0", r"\mu = \mu_0", "mu equals mu 0")

    friction_coefficient: float
    tested: TestedRange | None = None

    def __post_init__(self) -> None:
        mu = self.friction_coefficient
        check(_is_friction(mu))

    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """mu_0 with the sign of the slip, 0 without slip."""
        x, p = np.broadcast_arrays(np.asarray(slip, float), np.asarray(pressure, float))
        _, factor = held_pressure(_edges(self.tested), p)
        return np.asarray(np.sign(x) * self.friction_coefficient * factor)

    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""
        return CompactLaw(LIMIT, _edges(self.tested), (self.friction_coefficient, 1.0, 0.0, 0.0))

    def steepest_fall(self) -> float:
        """Return 0: friction does not fall with slip."""
        return 0.0

    def _scaled(self, friction: float, slip: float) -> Self:
        return replace(self, friction_coefficient=self.friction_coefficient * friction)


@dataclass(frozen=True, kw_only=True)
class ElasticPlastic(FrictionLaw):
    """Shear stress rises with slip up to a friction limit: mu = min(kappa_s x / p, mu_0).

    Attributes
    ----------
    stiffness
        kappa_s, shear stress per slip, > 0 [Pa/m].
    friction_coefficient
        mu_0, >= 1e-6 [-].
    tested
        Range of the measurement behind it, or None.
    """

    title = "elastic-plastic"
    equation = Equation(
        "Elastic-plastic friction",
        "mu = min(kappa_s x / p, mu_0)",
        r"\mu = \min(\kappa_s x / p, \mu_0)",
        "mu is the smaller of kappa s x over p and mu 0",
    )

    stiffness: float
    friction_coefficient: float
    tested: TestedRange | None = None

    def __post_init__(self) -> None:
        mu, k = self.friction_coefficient, self.stiffness
        check(
            _is_friction(mu),
            (0.0 < k < np.inf, "stiffness", f"{k:g} Pa/m", f"the stiffness {_POSITIVE}"),
        )

    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """min(kappa_s x / p, mu_0) with the sign of the slip."""
        x, p = np.broadcast_arrays(np.asarray(slip, float), np.asarray(pressure, float))
        _, factor = held_pressure(_edges(self.tested), p)
        limit = self.friction_coefficient * factor
        return np.asarray(np.sign(x) * np.minimum(self.stiffness * np.abs(x) / p, limit))

    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""
        c = (self.friction_coefficient, 1.0, 0.0, 1.0 / self.stiffness)
        return CompactLaw(LIMIT, _edges(self.tested), c, onset_compliance=1.0 / self.stiffness)

    def steepest_fall(self) -> float:
        """Return 0: friction does not fall with slip."""
        return 0.0

    def _scaled(self, friction: float, slip: float) -> Self:
        return replace(
            self,
            stiffness=self.stiffness * friction / slip,
            friction_coefficient=self.friction_coefficient * friction,
        )


@dataclass(frozen=True, kw_only=True)
class PressurePower(FrictionLaw):
    """Friction falls with a power of pressure: mu = mu_0 (p / p_0)^-n, whatever the slip.

    Attributes
    ----------
    friction_coefficient
        mu_0, friction at the reference pressure, >= 1e-6 [-].
    reference_pressure
        p_0, > 0 [Pa].
    exponent
        n, 0 <= n < 1 [-]: at n = 1 the traction would no longer grow with pressure.
    tested
        Range of the measurement behind it, or None.
    """

    title = "power of pressure"
    equation = Equation(
        "Friction as a power of pressure",
        "mu = mu_0 (p / p_0)^(-n)",
        r"\mu = \mu_0 (p/p_0)^{-n}",
        "mu equals mu 0 times p over p 0 to the minus n",
    )

    friction_coefficient: float
    reference_pressure: float
    exponent: float
    tested: TestedRange | None = None

    def __post_init__(self) -> None:
        mu, p, n = self.friction_coefficient, self.reference_pressure, self.exponent
        check(
            _is_friction(mu),
            (0.0 < p < np.inf, "reference_pressure", f"{p:g} Pa", f"the pressure {_POSITIVE}"),
            (0.0 <= n < 1.0, "exponent", f"{n:g}", "the exponent must lie in 0 <= n < 1"),
        )

    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """mu_0 (p / p_0)^-n with the sign of the slip."""
        x, p = np.broadcast_arrays(np.asarray(slip, float), np.asarray(pressure, float))
        at, factor = held_pressure(_edges(self.tested), p)
        mu = self.friction_coefficient * (at / self.reference_pressure) ** -self.exponent
        return np.asarray(np.sign(x) * mu * factor)

    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""
        c = (self.friction_coefficient, self.reference_pressure, self.exponent, 0.0)
        return CompactLaw(LIMIT, _edges(self.tested), c)

    def steepest_fall(self) -> float:
        """Return 0: friction does not fall with slip."""
        return 0.0

    def _scaled(self, friction: float, slip: float) -> Self:
        return replace(self, friction_coefficient=self.friction_coefficient * friction)
