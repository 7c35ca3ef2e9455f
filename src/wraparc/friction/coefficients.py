"""How the integral-log curve depends on pressure: knots of its peak, or pieces of A(p) and b(p)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import exp, inf, isfinite, log, nan

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError, Problem
from wraparc.friction.base import LEAST_FRICTION, LEAST_SLIP, MOST_SLIP, check
from wraparc.friction.trend import Trend

#: Powers of e that are floats other than 0.
_LEAST_POWER, _LARGEST_POWER = -700.0, 709.0


def ab_from_peak(peak_friction: float, peak_slip: float) -> tuple[float, float]:
    """Coefficients A and b of mu = A x ln x - b x from its peak.

    A = -mu_pk / x_pk, b = A (1 + ln x_pk). The unit of A and b follows from the unit of
    `peak_slip`: metres give A, b for x in metres, millimetres for x in millimetres.

    Parameters
    ----------
    peak_friction
        mu_pk, >= 1e-6 [-].
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
        mu_pk, >= 1e-6 [-], shape (n,).
    peak_slip
        x_pk, >= 1e-9 [m], shape (n,).
    post_peak_slope
        Slope of the straight line past the peak, <= 0 [1/m], shape (n,) or empty for 0.
    residual_friction
        Level the line does not fall below, >= 1e-6 [-], shape (n,) or empty for the peak friction.
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
                all(v >= LEAST_FRICTION for v in self.peak_friction),
                "peak_friction",
                _list(self.peak_friction),
                f"friction must be at least {LEAST_FRICTION:g}",
            ),
            (
                all(LEAST_SLIP <= v <= MOST_SLIP for v in self.peak_slip),
                "peak_slip",
                _list(self.peak_slip, "m"),
                "slip at the peak must be 1 nm to 1 km",
            ),
            (
                all(v <= 0 for v in self.post_peak_slope),
                "post_peak_slope",
                _list(self.post_peak_slope, "1/m"),
                "the slope past the peak must be 0 or negative",
            ),
            (
                all(v >= LEAST_FRICTION for v in self.residual_friction),
                "residual_friction",
                _list(self.residual_friction),
                f"residual friction must be at least {LEAST_FRICTION:g}",
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

    def scaled(self, friction: float, slip: float) -> PressureKnots:
        """Return the knots with friction and slip times a factor each."""
        return replace(
            self,
            peak_friction=tuple(v * friction for v in self.peak_friction),
            peak_slip=tuple(v * slip for v in self.peak_slip),
            post_peak_slope=tuple(v * friction / slip for v in self.post_peak_slope),
            residual_friction=tuple(v * friction for v in self.residual_friction),
        )


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
                0.0 < self.slip_unit < inf,
                "slip_unit",
                f"{self.slip_unit:g} m",
                "the unit of slip must be positive and finite",
            ),
            (
                all(a < b for a, b in zip(self.pressure, self.pressure[1:], strict=False))
                and all(0 < p < inf for p in self.pressure),
                "pressure",
                _list(self.pressure, "Pa"),
                "the transition pressures must be positive, finite and in ascending order",
            ),
        )
        problems = [p for i in range(n) for p in self._piece_problems(i)] or self._jumps()
        if problems:
            raise InputError(problems)

    def _piece_problems(self, i: int) -> list[Problem]:
        low, high = self.pressure[i : i + 2]
        places = [low + (high - low) * k / 100.0 for k in range(101)]
        piece = self.pieces[i]
        where = f"between {low:g} and {high:g} Pa"
        key = f"pieces[{i + 1}]"
        a, b = [piece.a.at(p) for p in places], [piece.b.at(p) for p in places]
        slope = [piece.post_peak_slope.at(p) for p in places]
        residual = [piece.residual_friction.at(p) for p in places]
        bad: list[Problem] = []
        if not all(isfinite(v) and v < 0.0 for v in a):
            worst = max([v for v in a if v == v], default=nan)
            bad.append(
                Problem(
                    key=f"{key}.a",
                    value=f"{worst:g} 1/m",
                    message=f"A must be negative {where}, else the law gives no positive friction",
                )
            )
        elif not all(
            _LEAST_POWER <= v / u - 1.0 < _LARGEST_POWER
            and LEAST_SLIP <= exp(v / u - 1.0) * self.slip_unit <= MOST_SLIP
            for u, v in zip(a, b, strict=True)
        ):
            bad.append(
                Problem(
                    key=f"{key}.b",
                    value=f"{b[0]:g} 1/m",
                    message=f"the slip at the peak exp(b/A - 1) must be 1 nm to 1 km {where}",
                )
            )
        if not all(v <= 0.0 for v in slope):
            bad.append(
                Problem(
                    key=f"{key}.post_peak_slope",
                    value=f"{max(slope):g} 1/m",
                    message=f"the slope past the peak must be 0 or negative {where}",
                )
            )
        if not all(v >= LEAST_FRICTION for v in residual):
            bad.append(
                Problem(
                    key=f"{key}.residual_friction",
                    value=f"{min(residual):g}",
                    message=f"residual friction must be at least {LEAST_FRICTION:g} {where}",
                )
            )
        return bad

    def _jumps(self) -> list[Problem]:
        bad: list[Problem] = []
        for i in range(len(self.pieces) - 1):
            p = self.pressure[i + 1]
            low, high = (peak_from_ab(s.a.at(p), s.b.at(p)) for s in self.pieces[i : i + 2])
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
            levels.append(min(piece.residual_friction.at(p), friction))
            slopes.append(piece.post_peak_slope.at(p) if levels[-1] < friction else 0.0)
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

    def scaled(self, friction: float, slip: float) -> CoefficientPieces:
        """Return the pieces with friction and slip times a factor each."""
        return replace(
            self,
            # x / s is x in a unit s times as long: that says it without touching the trend of b
            slip_unit=self.slip_unit * slip,
            pieces=tuple(
                replace(
                    piece,
                    a=piece.a.times(friction),
                    b=piece.b.times(friction),
                    post_peak_slope=piece.post_peak_slope.times(friction / slip),
                    residual_friction=piece.residual_friction.times(friction),
                )
                for piece in self.pieces
            ),
        )
