"""The integral-log law of a lagging: mu = A x ln x - b x up to its peak, a straight line past it.

B. DeVries, "A model of lagging friction as a function of creep history and wrap pressure", eq. 2.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.friction.base import Equation, FrictionLaw, TestedRange, check, held_pressure
from wraparc.friction.coefficients import CoefficientPieces, PressureKnots, ab_from_peak
from wraparc.friction.compact import KNOTS, PIECES, CompactLaw
from wraparc.friction.interpolation import evaluate, pchip


@dataclass(frozen=True, kw_only=True)
class IntegralLog(FrictionLaw):
    """mu = A x ln x - b x up to its peak, then a straight line down to a residual level.

    With r = x / x_pk: mu = mu_pk r (1 - ln r) for r <= 1, then
    max(mu_pk + m (x - x_pk), min(residual, mu_pk)).

    Attributes
    ----------
    coefficients
        How the curve depends on pressure: knots, or pieces of A(p) and b(p).
    tested
        Tested range; its pressures are the ends of the coefficients. None makes a law with no
        stated range.
    """

    title = "integral-log law"
    equation = Equation(
        "Friction up to its peak; past it a straight line down to the residual friction",
        "mu = A x ln x - b x, quad x_p = e^(b\\/A - 1), quad mu_p = -A x_p; quad "
        "x > x_p: mu = max(mu_p + m (x - x_p), mu_r)",
        r"\mu = A x \ln x - b x,\quad x_p = e^{b/A - 1},\quad \mu_p = -A x_p;\quad "
        r"x > x_p:\ \mu = \max(\mu_p + m(x - x_p), \mu_r)",
        "mu equals A x logarithm of x minus b x; its peak lies at x p equal to e to the b over A "
        "minus 1 and is mu p equal to minus A x p; past it mu is the larger of mu p plus m times "
        "x minus x p and mu r",
    )

    coefficients: PressureKnots | CoefficientPieces
    tested: TestedRange | None = None

    def __post_init__(self) -> None:
        if self.tested is None or len(self.coefficients.pressure) < 2:
            return
        p = self.coefficients.pressure
        t = self.tested
        check(
            (
                abs(t.pressure_min / p[0] - 1.0) < 1e-6
                and abs(t.pressure_max / p[-1] - 1.0) < 1e-6,
                "tested",
                f"{t.pressure_min:g} .. {t.pressure_max:g} Pa",
                f"the tested pressures must be the ends of the law, {p[0]:g} .. {p[-1]:g} Pa",
            )
        )

    def parameters(self, pressure: ArrayLike) -> tuple[Array, Array, Array, Array]:
        """Peak slip [m], peak friction [-], post-peak slope [1/m] and residual friction [-].

        Held at the ends of the tested pressures; shape of `pressure` [Pa].
        """
        c = self.coefficients
        at, _ = held_pressure(c.pressure if len(c.pressure) > 1 else (), pressure)
        if isinstance(c, CoefficientPieces):
            return c.at(at)
        p, x, mu, slope, residual = c.columns()
        if len(p) == 1:
            x_at, mu_at, slope_at, residual_at = (
                np.full(at.shape, v[0]) for v in (x, mu, slope, residual)
            )
        else:
            x_at, mu_at, slope_at, residual_at = (evaluate(p, v, at) for v in _cubics(c))
        return x_at, mu_at, slope_at, np.minimum(residual_at, mu_at)

    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """Friction with the sign of the slip [-]; see the class for the formula."""
        x, p = np.broadcast_arrays(np.asarray(slip, float), np.asarray(pressure, float))
        ends = self.coefficients.pressure
        _, factor = held_pressure(ends if len(ends) > 1 else (), p)
        peak_slip, peak, slope, residual = self.parameters(p)
        r = np.abs(x) / peak_slip
        rising = peak * r * (1.0 - np.log(np.where(r > 0.0, r, 1.0)))
        tail = np.maximum(peak + slope * (np.abs(x) - peak_slip), residual)
        return np.asarray(np.sign(x) * factor * np.where(r <= 1.0, rising, tail))

    def coefficients_ab(self, pressure: float, unit: float = 1e-3) -> tuple[float, float]:
        """A and b at a pressure [Pa] for slip in a unit of length [m], millimetres by default."""
        x, mu, _, _ = self.parameters(pressure)
        return ab_from_peak(float(mu), float(x) / unit)

    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""
        return _compact(self.coefficients)

    def steepest_fall(self) -> float:
        """Return the steepest post-peak slope, <= 0 [1/m]; 0 where no residual allows a fall."""
        return _steepest_fall(self.coefficients)

    def _scaled(self, friction: float, slip: float) -> Self:
        return replace(self, coefficients=self.coefficients.scaled(friction, slip))


@lru_cache(maxsize=128)  # every solve of an arc asks for it several times, as for `_compact`
def _steepest_fall(c: PressureKnots | CoefficientPieces) -> float:
    if isinstance(c, PressureKnots):
        _, _, peak, slope, residual = c.columns()
    else:
        _, peak, slope, residual = c.at(np.linspace(c.pressure[0], c.pressure[-1], 501))
    return float(np.min(slope)) if np.any(residual < peak) else 0.0


@lru_cache(maxsize=128)
def _cubics(c: PressureKnots) -> tuple[Array, ...]:
    p, *columns = c.columns()
    return tuple(pchip(p, v) for v in columns)


@lru_cache(maxsize=128)
def _compact(c: PressureKnots | CoefficientPieces) -> CompactLaw:
    if isinstance(c, CoefficientPieces):
        rows = [
            (
                *(*s.a.row(), *s.b.row()),
                *(*s.post_peak_slope.row(), *s.residual_friction.row()),
                c.slip_unit,
            )
            for s in c.pieces
        ]
        return CompactLaw(PIECES, c.pressure, tuple(v for row in rows for v in row))
    p, x, mu, slope, residual = c.columns()
    if len(p) == 1:
        columns = [(v[0], 0.0, 0.0, 0.0) for v in (x, mu, slope, residual)]
        return CompactLaw(KNOTS, (), tuple(float(v) for col in columns for v in col))
    block = np.concatenate(_cubics(c), axis=1)
    return CompactLaw(KNOTS, c.pressure, tuple(block.ravel().tolist()))
