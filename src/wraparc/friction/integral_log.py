"""The integral-log law of a lagging: mu = A x ln x - b x up to its peak, a straight line past it.

B. DeVries, "A model of lagging friction as a function of creep history and wrap pressure", eq. 2.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from math import exp, isfinite, log
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from wraparc.errors import InputError, Problem
from wraparc.friction.base import Array, FrictionLaw, TestedRange, check, held_pressure
from wraparc.friction.compact import KNOTS, PIECES, CompactLaw
from wraparc.friction.interpolation import evaluate, pchip


def ab_from_peak(peak_friction: float, peak_slip: float) -> tuple[float, float]:
    """Coefficients A and b of mu = A x ln x - b x from its peak.

    A = -mu_pk / x_pk, b = A (1 + ln x_pk). The unit of A and b follows from the unit of
    `peak_slip`: metres give A, b for x in metres, millimetres for x in millimetres.

    Parameters
    ----------
    peak_friction
        mu_pk, > 0 [-].
    peak_slip
        x_pk, > 0 [any unit of length].

    Returns
    -------
    A, b
        [1 / unit of `peak_slip`].
    """
    a = -peak_friction / peak_slip
    return a, a * (1.0 + log(peak_slip))


def peak_from_ab(a: float, b: float) -> tuple[float, float]:
    """Peak friction [-] and peak slip [the unit of x] of mu = A x ln x - b x, A < 0.

    x_pk = exp(b/A - 1), mu_pk = -A x_pk.
    """
    slip = exp(b / a - 1.0)
    return -a * slip, slip


def convert_ab(a: float, b: float, from_unit: float, to_unit: float) -> tuple[float, float]:
    """A and b for another unit of slip.

    With y = c x, c = from_unit / to_unit: A_y = A / c, b_y = (b + A ln c) / c.

    Parameters
    ----------
    a, b
        Coefficients for x in `from_unit`.
    from_unit, to_unit
        Length of one unit of x [m], e.g. 1e-3 for millimetres.
    """
    c = from_unit / to_unit
    return a / c, (b + a * log(c)) / c


Form = Literal["polynomial", "logarithmic", "power", "exponential"]
#: form -> (v = ln p, y = exp), see friction.compact._trend
_FORM_CODES: dict[str, tuple[bool, bool]] = {
    "polynomial": (False, False),
    "logarithmic": (True, False),
    "power": (True, True),
    "exponential": (False, True),
}


@dataclass(frozen=True, kw_only=True)
class Trend:
    """A trend line over pressure, in the forms a spreadsheet fits.

    Attributes
    ----------
    form
        polynomial: c0 + c1 p + c2 p^2 + c3 p^3; logarithmic: c0 + c1 ln p (+ c2 ln^2 p ...);
        power: sign exp(c0 + c1 ln p); exponential: sign exp(c0 + c1 p). p is in pascal.
    coefficients
        c0 .. c3, one to four numbers.
    sign
        Sign of a power or exponential form, +1 or -1.
    """

    form: Form = "polynomial"
    coefficients: tuple[float, ...]
    sign: int = 1

    def __post_init__(self) -> None:
        n = len(self.coefficients)
        check(
            (
                self.form in _FORM_CODES,
                "form",
                self.form,
                f"the form must be one of {', '.join(_FORM_CODES)}",
            ),
            (1 <= n <= 4, "coefficients", str(n), "one to four coefficients are needed"),
            (
                all(map(isfinite, self.coefficients)),
                "coefficients",
                str(self.coefficients),
                "must be finite",
            ),
            (self.sign in (1, -1), "sign", str(self.sign), "the sign must be 1 or -1"),
        )

    def __call__(self, pressure: ArrayLike) -> Array:
        """Value at a pressure [Pa]."""
        p = np.asarray(pressure, dtype=float)
        logarithmic, exponential = _FORM_CODES[self.form]
        y = np.polynomial.polynomial.polyval(np.log(p) if logarithmic else p, self.coefficients)
        return np.asarray(self.sign * np.exp(y) if exponential else y)

    def row(self) -> tuple[float, ...]:
        """Return c0 .. c3 and the two form codes that the solvers read."""
        logarithmic, exponential = _FORM_CODES[self.form]
        c = self.coefficients + (0.0,) * (4 - len(self.coefficients))
        return (*c, float(logarithmic), float(self.sign) if exponential else 0.0)


@dataclass(frozen=True, kw_only=True)
class Piece:
    """A and b over one interval of pressure, with the tail past the peak.

    Attributes
    ----------
    a, b
        Trend lines of A and b [1 / slip unit of the law].
    post_peak_slope
        Trend line of the slope past the peak, <= 0 [1/m].
    residual_friction
        Trend line of the residual friction [-], or None for the peak friction.
    """

    a: Trend
    b: Trend
    post_peak_slope: Trend = field(default_factory=lambda: Trend(coefficients=(0.0,)))
    residual_friction: Trend = field(default_factory=lambda: Trend(coefficients=(1e9,)))


@dataclass(frozen=True, kw_only=True)
class PressureKnots:
    """Peak friction, peak slip and tail at knots of pressure; monotone cubics (PCHIP) in between.

    Attributes
    ----------
    pressure
        Knots, ascending, > 0 [Pa], shape (n,). One knot makes a law free of pressure.
    peak_friction
        mu_pk, > 0 [-], shape (n,).
    peak_slip
        x_pk, > 0 [m], shape (n,).
    post_peak_slope
        Slope of the straight line past the peak, <= 0 [1/m], shape (n,) or empty for 0.
    residual_friction
        Level the line does not fall below, > 0 [-], shape (n,) or empty for the peak friction.
    """

    pressure: tuple[float, ...]
    peak_friction: tuple[float, ...]
    peak_slip: tuple[float, ...]
    post_peak_slope: tuple[float, ...] = ()
    residual_friction: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        n = len(self.pressure)
        check(
            (n >= 1, "pressure", str(n), "at least one knot is needed"),
            *(
                (
                    len(values) == n or (optional and not values),
                    name,
                    f"{len(values)} values",
                    f"must have {n} values, one for each pressure",
                )
                for name, values, optional in self._columns()
            ),
            *(
                (all(map(isfinite, values)), name, str(values), "must be finite numbers")
                for name, values, _ in self._columns()
            ),
            (
                all(a < b for a, b in zip(self.pressure, self.pressure[1:], strict=False))
                and all(p > 0 for p in self.pressure),
                "pressure",
                _list(self.pressure, "Pa"),
                "the pressures of the knots must be positive and in ascending order",
            ),
            (
                all(v > 0 for v in self.peak_friction),
                "peak_friction",
                _list(self.peak_friction),
                "friction must be positive",
            ),
            (
                all(v > 0 for v in self.peak_slip),
                "peak_slip",
                _list(self.peak_slip, "m"),
                "slip at the peak must be positive",
            ),
            (
                all(v <= 0 for v in self.post_peak_slope),
                "post_peak_slope",
                _list(self.post_peak_slope, "1/m"),
                "the slope past the peak must be 0 or negative",
            ),
            (
                all(v > 0 for v in self.residual_friction),
                "residual_friction",
                _list(self.residual_friction),
                "residual friction must be positive",
            ),
        )

    def _columns(self) -> tuple[tuple[str, tuple[float, ...], bool], ...]:
        return (
            ("pressure", self.pressure, False),
            ("peak_friction", self.peak_friction, False),
            ("peak_slip", self.peak_slip, False),
            ("post_peak_slope", self.post_peak_slope, True),
            ("residual_friction", self.residual_friction, True),
        )

    def columns(self) -> tuple[Array, Array, Array, Array, Array]:
        """Return pressure, peak slip, peak friction, slope, residual (<= peak), shape (n,) each."""
        p, mu, x = (np.array(v, float) for v in (self.pressure, self.peak_friction, self.peak_slip))
        slope = np.array(self.post_peak_slope, float) if self.post_peak_slope else np.zeros_like(p)
        residual = np.array(self.residual_friction, float) if self.residual_friction else mu
        return p, x, mu, slope, np.minimum(residual, mu)


def _list(values: tuple[float, ...], unit: str = "") -> str:
    return ", ".join(f"{v:g}" for v in values) + (f" {unit}" if unit else "")


@dataclass(frozen=True, kw_only=True)
class CoefficientPieces:
    """A(p) and b(p) in pieces that meet at transition pressures.

    Attributes
    ----------
    pressure
        Ends of the pieces, ascending: lowest tested, transitions, highest tested [Pa],
        shape (n + 1,).
    pieces
        The pieces, shape (n,).
    slip_unit
        Unit of slip that A and b are for [m]: b of another unit is b + A ln c, which a trend line
        of b cannot hold when A has another form.
    continuity
        Largest relative step of peak friction, peak slip, slope past the peak or residual friction
        allowed where two pieces meet [-].
        Printed coefficients are rounded; more than this is an error.
    """

    pressure: tuple[float, ...]
    pieces: tuple[Piece, ...]
    slip_unit: float = 1.0
    continuity: float = 0.02

    def __post_init__(self) -> None:
        n = len(self.pieces)
        check(
            (n >= 1, "pieces", str(n), "at least one piece is needed"),
            (
                len(self.pressure) == n + 1,
                "pressure",
                _list(self.pressure, "Pa"),
                f"must have {n + 1} pressures, the ends of {n} pieces",
            ),
            (
                0.0 < self.slip_unit < np.inf,
                "slip_unit",
                f"{self.slip_unit:g} m",
                "the unit of slip must be positive and finite",
            ),
            (
                all(a < b for a, b in zip(self.pressure, self.pressure[1:], strict=False))
                and all(0 < p < np.inf for p in self.pressure),
                "pressure",
                _list(self.pressure, "Pa"),
                "the transition pressures must be positive, finite and in ascending order",
            ),
        )
        problems = [p for i in range(n) for p in self._piece_problems(i)] or self._jumps()
        if problems:
            raise InputError(problems)

    def _piece_problems(self, i: int) -> list[Problem]:
        p = np.linspace(self.pressure[i], self.pressure[i + 1], 101)
        piece = self.pieces[i]
        where = f"between {self.pressure[i]:g} and {self.pressure[i + 1]:g} Pa"
        key = f"pieces[{i + 1}]"
        with np.errstate(all="ignore"):
            a, b = piece.a(p), piece.b(p)
            slip = np.exp(b / a - 1.0)
            slope, residual = piece.post_peak_slope(p), piece.residual_friction(p)
        bad: list[Problem] = []
        if not (np.all(np.isfinite(a)) and np.all(a < 0.0)):
            worst = float(np.nanmax(a))
            bad.append(
                Problem(
                    key=f"{key}.a",
                    value=f"{worst:g} 1/m",
                    message=f"A must be negative {where}, else the law gives no positive friction",
                )
            )
        elif not (np.all(np.isfinite(slip)) and np.all(slip > 0.0)):
            bad.append(
                Problem(
                    key=f"{key}.b",
                    value=f"{float(b[0]):g} 1/m",
                    message=f"the slip at the peak exp(b/A - 1) must be finite {where}",
                )
            )
        if not np.all(slope <= 0.0):
            bad.append(
                Problem(
                    key=f"{key}.post_peak_slope",
                    value=f"{float(slope.max()):g} 1/m",
                    message=f"the slope past the peak must be 0 or negative {where}",
                )
            )
        if not np.all(residual > 0.0):
            bad.append(
                Problem(
                    key=f"{key}.residual_friction",
                    value=f"{float(residual.min()):g}",
                    message=f"residual friction must be positive {where}",
                )
            )
        return bad

    def _jumps(self) -> list[Problem]:
        bad: list[Problem] = []
        for i in range(len(self.pieces) - 1):
            p = self.pressure[i + 1]
            low, high = (peak_from_ab(float(s.a(p)), float(s.b(p))) for s in self.pieces[i : i + 2])
            for name, u, v in (("peak friction", low[0], high[0]), ("peak slip", low[1], high[1])):
                if abs(v / u - 1.0) > self.continuity:
                    bad.append(
                        Problem(
                            key=f"pieces[{i + 2}]",
                            value=f"{u:g} and {v:g}",
                            message=(
                                f"{name} jumps at the transition pressure {p:g} Pa; "
                                f"pieces must meet within {100 * self.continuity:g} %"
                            ),
                        )
                    )
            bad += self._tail_jumps(i, p, low, high)
        return bad

    def _tail_jumps(
        self, i: int, p: float, low: tuple[float, float], high: tuple[float, float]
    ) -> list[Problem]:
        """Jumps of the line past the peak between pieces i and i + 1, and of its lower end.

        A slope counts by what friction it takes off over a peak slip, and not where the residual
        level is the peak friction; levels count as parts of the peaks, which have their own check,
        and where there is a slope down to them.
        """
        levels, slopes = [], []
        for piece, (friction, _) in zip(self.pieces[i : i + 2], (low, high), strict=True):
            levels.append(min(float(piece.residual_friction(p)), friction))
            slopes.append(float(piece.post_peak_slope(p)) if levels[-1] < friction else 0.0)
        apart = abs(slopes[1] - slopes[0]) * self.slip_unit * low[1] / low[0]
        lower = levels[1] * low[0] / (levels[0] * high[0]) if all(slopes) else 1.0
        return [
            Problem(
                key=f"pieces[{i + 2}].{key}",
                value=f"{pair[0]:g} and {pair[1]:g}{unit}",
                message=(
                    f"{name} jumps at the transition pressure {p:g} Pa; pieces must meet within "
                    f"{100 * self.continuity:g} %{of}"
                ),
            )
            for name, key, pair, unit, of, jump in (
                ("the slope past the peak", "post_peak_slope", slopes, " 1/m",
                 " of the peak friction over a peak slip", apart),
                ("residual friction", "residual_friction", levels, "", "",
                 abs(lower - 1.0)),
            )
            if jump > self.continuity
        ]  # fmt: skip

    def at(self, pressure: Array) -> tuple[Array, Array, Array, Array]:
        """Peak slip [m], peak friction, slope [1/m] and residual friction inside the ends."""
        shape, pressure = np.shape(pressure), np.atleast_1d(pressure)
        out = np.empty((4, *pressure.shape))
        index = np.clip(
            np.searchsorted(self.pressure, pressure, side="right") - 1, 0, len(self.pieces) - 1
        )
        for i, piece in enumerate(self.pieces):
            mask = index == i
            p = pressure[mask]
            a, b = piece.a(p), piece.b(p)
            number = np.exp(b / a - 1.0)
            out[0][mask], out[1][mask] = self.slip_unit * number, -a * number
            out[2][mask], out[3][mask] = piece.post_peak_slope(p), piece.residual_friction(p)
        out[3] = np.minimum(out[3], out[1])
        return (
            out[0].reshape(shape),
            out[1].reshape(shape),
            out[2].reshape(shape),
            out[3].reshape(shape),
        )


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
            x_at, mu_at, slope_at, residual_at = (
                evaluate(p, pchip(p, v), at) for v in (x, mu, slope, residual)
            )
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
        c = self.coefficients
        if isinstance(c, PressureKnots):
            _, _, peak, slope, residual = c.columns()
        else:
            _, peak, slope, residual = c.at(np.linspace(c.pressure[0], c.pressure[-1], 501))
        return float(np.min(slope)) if np.any(residual < peak) else 0.0


@lru_cache(maxsize=128)  # every solve of an arc asks for it several times
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
    block = np.concatenate([pchip(p, v) for v in (x, mu, slope, residual)], axis=1)
    return CompactLaw(KNOTS, c.pressure, tuple(block.ravel().tolist()))
