"""First loading of a friction law in arrays: what the memory of its material points is made of.

With x_pk and A at the present pressure, f(z) = A F(z/x_pk) up to the peak; past it A falls with the
largest slip so far. A measured table has no peak: f is the table itself.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.friction.compact import (
    KNOT_STRIDE,
    LIMIT,
    PIECE_STRIDE,
    PIECES,
    TABLE,
    CompactLaw,
    limit_at,
    segment_of,
)

_SMALLEST = 1e-16  # slip over peak slip at which the logarithm is taken
_ITERATIONS = 60


class Loading(NamedTuple):
    """First loading at some pressures.

    Attributes
    ----------
    pressure
        Wrap pressure [Pa].
    strength, strength_p
        A [Pa] and its derivative by pressure [-]; of a measured table the share of it that is
        there.
    peak_slip, peak_slip_p
        x_pk [m] and its derivative by pressure [m/Pa].
    """

    pressure: Array
    strength: Array
    strength_p: Array
    peak_slip: Array
    peak_slip_p: Array

    def of(self, which: Any) -> Loading:
        """Return the loading of some of them."""
        return Loading(*(v[which] for v in self))


class FirstLoading(ABC):
    """First loading of a law.

    Below the lowest tested pressure friction is held, above the highest the traction is.
    """

    def __init__(self, law: CompactLaw) -> None:
        self.law = law
        self.edges = np.array(law.edges, dtype=float)
        self.low, self.high = (law.edges[0], law.edges[-1]) if law.edges else (0.0, 0.0)
        self.top = law.edges[-1] if law.edges else np.inf
        self.segments = max(len(law.edges) - 1, 1)

    @abstractmethod
    def at(self, pressure: Array, reach: Array | None, share: Any) -> Loading:
        """Loading at pressures [Pa], times a share, after a largest slip [m] or none."""

    def loaded(self, b: Loading, z: Array) -> tuple[Array, Array, Array]:
        """Return f(z) [Pa] and its derivatives by slip z >= 0 [Pa/m] and pressure [-]."""
        raise NotImplementedError

    def shared(self, b: Loading, c: float, w: Array, guess: Array) -> Array:
        """Slip z [m] with z + c f(z) = w, c the compliance in shear [m/Pa]; 0 where w <= 0."""
        raise NotImplementedError

    def past_peak(
        self, b: Loading, c: float, w: Array, share: Any
    ) -> tuple[Array, Array, Array, Array]:
        """Slip [m], stress [Pa], its fall by slip [Pa/m] and slope by pressure past the peak."""
        raise NotImplementedError

    def place(self, pressure: Array) -> tuple[Any, Array, Flags]:
        """Segment of pressures, the pressure its coefficients are taken at, whether that moves."""
        at = np.minimum(np.maximum(pressure, self.low), self.high)
        moves = (pressure >= self.low) & (pressure < self.high)
        if self.segments == 1:
            return np.zeros(len(pressure), dtype=np.int64), at, moves
        segment = self.edges[1:-1].searchsorted(pressure, "right")
        return segment, at, moves


class LogLoading(FirstLoading):
    """The integral-log law, peak friction and peak slip as cubics in pressure."""

    def __init__(self, law: CompactLaw) -> None:
        super().__init__(law)
        stride = PIECE_STRIDE if law.kind == PIECES else KNOT_STRIDE
        rows = np.array(law.coefficients).reshape(-1, stride)[: self.segments]
        self.columns = np.ascontiguousarray(rows.T)
        self.begins = self.edges[:-1] if len(self.edges) > 1 else np.array([self.low])

    def peaks(self, place: Any) -> tuple[Array, Array, Array, Array]:
        """Peak slip [m] and friction [-], and their derivatives by pressure."""
        segment, at, moves = place
        c, t = self.columns[:8].take(segment, axis=1), at - self.begins[segment]
        x, x_p = _cubic(c[:4], t)
        mu, mu_p = _cubic(c[4:], t)
        return x, mu, np.where(moves, x_p, 0.0), np.where(moves, mu_p, 0.0)

    def tails(self, place: Any) -> tuple[Array, Array, Array, Array]:
        """Post-peak slope [1/m] and residual friction [-], and their derivatives by pressure."""
        segment, at, moves = place
        c, t = self.columns[8:16].take(segment, axis=1), at - self.begins[segment]
        slope, slope_p = _cubic(c[:4], t)
        residual, residual_p = _cubic(c[4:], t)
        return slope, residual, np.where(moves, slope_p, 0.0), np.where(moves, residual_p, 0.0)

    def at(self, pressure: Array, reach: Array | None, share: Any) -> Loading:
        """Loading at pressures [Pa], times a share, after a largest slip [m] or none."""
        place = self.place(pressure)
        x, mu, x_p, mu_p = self.peaks(place)
        if reach is not None and (far := reach > x).any():
            slope, residual, slope_p, residual_p = self.tails(place)
            line = mu + slope * (reach - x)
            falls = far & (line > np.minimum(residual, mu))
            rests = far & ~falls & (residual < mu)
            by_line = mu_p + slope_p * (reach - x) - slope * x_p
            mu_p = np.where(falls, by_line, np.where(rests, residual_p, mu_p))
            mu = np.where(falls, line, np.where(rests, residual, mu))
        push = np.minimum(pressure, self.top)
        by_p = np.where(pressure < self.top, mu + pressure * mu_p, 0.0)
        return Loading(pressure, share * mu * push, share * by_p, x, x_p)

    def loaded(self, b: Loading, z: Array) -> tuple[Array, Array, Array]:
        """Return f(z) [Pa] and its derivatives by slip z >= 0 [Pa/m] and pressure [-]."""
        r = z / b.peak_slip
        over = r >= 1.0
        r = np.minimum(np.maximum(r, _SMALLEST), 1.0)
        lr = np.log(r)
        form, stiff = r - r * lr, -b.strength * lr / b.peak_slip
        return (
            b.strength * form,
            np.where(over, 0.0, stiff),
            b.strength_p * form - r * stiff * b.peak_slip_p,
        )

    def shared(self, b: Loading, c: float, w: Array, guess: Array) -> Array:
        """Slip z [m] with z + c f(z) = w, c the compliance in shear [m/Pa]; 0 where w <= 0."""
        if c == 0.0:
            return np.maximum(w, 0.0)
        k = c * b.strength / b.peak_slip
        goal = np.maximum(w, 1e-300) / b.peak_slip
        most = goal / (1.0 + k)  # 1 - ln r is at least 1
        over = goal >= 1.0 + k
        seeks = (w > 0.0) & ~over
        r = np.minimum(guess / b.peak_slip, most)
        bad = ~(r > 0.0)
        if bad.any():
            r = np.where(bad, most / (1.0 + k * (1.0 - np.log(np.maximum(most, _SMALLEST)))), r)
        for _ in range(_ITERATIONS):
            lr = np.log(r)
            step = (goal - r - k * (r - r * lr)) / (1.0 - k * lr)
            new = r + step
            r = np.where(new > 0.0, new, 0.05 * r)
            if not (seeks & (np.abs(step) > 1e-5 * r)).any():
                break  # what is left is of the order of its square
        z = np.where(over, w - c * b.strength, r * b.peak_slip)
        return np.where(w > 0.0, z, 0.0)

    def past_peak(
        self, b: Loading, c: float, w: Array, share: Any
    ) -> tuple[Array, Array, Array, Array]:
        """Slip [m], stress [Pa], its fall by slip [Pa/m] and slope by pressure past the peak."""
        slope, residual, _, _ = self.tails(self.place(b.pressure))
        push = share * np.minimum(b.pressure, self.top)
        fall = slope * push
        z = (w - c * (b.strength - fall * b.peak_slip)) / (1.0 + c * fall)
        least = np.minimum(residual * push, b.strength)
        rests = b.strength + fall * (z - b.peak_slip) <= least
        fall, z = np.where(rests, 0.0, fall), np.where(rests, w - c * least, z)
        there = self.at(b.pressure, z, share)
        return z, there.strength, fall, there.strength_p


class TrendLoading(LogLoading):
    """The integral-log law, its coefficients A and b as trend lines in pressure."""

    def peaks(self, place: Any) -> tuple[Array, Array, Array, Array]:
        """Peak slip [m] and friction [-], and their derivatives by pressure."""
        segment, at, moves = place
        c = self.columns.take(segment, axis=1)
        a, a_p = _trend(c[:6], at)
        b, b_p = _trend(c[6:12], at)
        number = np.exp(b / a - 1.0)
        number_p = number * (b_p - b * a_p / a) / a
        x_p, mu_p = c[24] * number_p, -a_p * number - a * number_p
        return c[24] * number, -a * number, np.where(moves, x_p, 0.0), np.where(moves, mu_p, 0.0)

    def tails(self, place: Any) -> tuple[Array, Array, Array, Array]:
        """Post-peak slope [1/m] and residual friction [-], and their derivatives by pressure."""
        segment, at, moves = place
        c = self.columns.take(segment, axis=1)
        slope, slope_p = _trend(c[12:18], at)
        residual, residual_p = _trend(c[18:24], at)
        return slope, residual, np.where(moves, slope_p, 0.0), np.where(moves, residual_p, 0.0)


class TableLoading(FirstLoading):
    """A measured table: a cubic in slip for each pressure, blended linearly in pressure."""

    def __init__(self, law: CompactLaw) -> None:
        super().__init__(law)
        self.slips = np.array(law.slips)
        self.cubics = np.array(law.coefficients).reshape(-1, len(law.slips), 4)

    def at(self, pressure: Array, reach: Array | None, share: Any) -> Loading:
        """Loading at pressures [Pa], times a share; a table that rises has nothing past a peak."""
        one = np.ones(len(pressure))
        return Loading(pressure, share * one, 0.0 * one, one, 0.0 * one)

    def loaded(self, b: Loading, z: Array) -> tuple[Array, Array, Array]:
        """Return f(z) [Pa] and its derivatives by slip z >= 0 [Pa/m] and pressure [-]."""
        pressure = np.broadcast_to(b.pressure, z.shape)
        cell = np.maximum(self.slips.searchsorted(z, "right") - 1, 0)
        row = np.clip(self.edges.searchsorted(pressure, "right") - 1, 0, self.segments - 1)
        next_row = np.minimum(row + 1, len(self.cubics) - 1)
        t = z - self.slips[cell]
        low, low_x = _cubic(np.moveaxis(self.cubics[row, cell], -1, 0), t)
        high, high_x = _cubic(np.moveaxis(self.cubics[next_row, cell], -1, 0), t)
        at = np.minimum(np.maximum(pressure, self.low), self.high)
        width = self.edges[next_row] - self.edges[row]
        per = np.divide(1.0, width, out=np.zeros_like(width), where=width > 0.0)
        part = (at - self.edges[row]) * per
        mu, mu_x = low + part * (high - low), low_x + part * (high_x - low_x)
        moves = (pressure >= self.low) & (pressure < self.high)
        push = b.strength * np.minimum(pressure, self.top)
        by_p = np.where(moves, mu + pressure * (high - low) * per, mu)
        return mu * push, mu_x * push, np.where(pressure < self.top, b.strength * by_p, 0.0)

    def shared(self, b: Loading, c: float, w: Array, guess: Array) -> Array:
        """Slip z [m] with z + c f(z) = w, c the compliance in shear [m/Pa]; 0 where w <= 0."""
        if c == 0.0:
            return np.maximum(w, 0.0)
        w_ = np.maximum(w, 1e-300)
        z = np.where((guess > 0.0) & (guess < w_), guess, 0.5 * w_)
        for _ in range(_ITERATIONS):
            value, slope, _ = self.loaded(b, z)
            step = (w_ - z - c * value) / (1.0 + c * slope)
            z = np.where(z + step > 0.0, z + step, 0.05 * z)
            if not ((w > 0.0) & (np.abs(step) > 1e-9 * z)).any():
                break
        return np.where(w > 0.0, z, 0.0)


class LimitLoading(FirstLoading):
    """Traction with a limit: its strength is all there is."""

    def at(self, pressure: Array, reach: Array | None, share: Any) -> Loading:
        """Loading at pressures [Pa], times a share."""
        limits = [limit_at(self.law, segment_of(self.law, p), p) for p in pressure.tolist()]
        mu, mu_p = np.array(limits).T
        one = np.ones(len(pressure))
        return Loading(
            pressure, share * mu * pressure, share * (mu + pressure * mu_p), one, 0 * one
        )


def first_loading_of(law: CompactLaw) -> FirstLoading:
    """Return the first loading of a law."""
    if law.kind == LIMIT:
        return LimitLoading(law)
    if law.kind == TABLE:
        return TableLoading(law)
    return TrendLoading(law) if law.kind == PIECES else LogLoading(law)


def _cubic(c: Array, t: Array) -> tuple[Array, Array]:
    """Value and derivative of cubics with coefficients c[0] .. c[3] at t."""
    return c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2.0 * c[2] + 3.0 * t * c[3])


def _trend(c: Array, p: Array) -> tuple[Array, Array]:
    """Value and derivative of trend lines, see :mod:`wraparc.friction.compact`."""
    logarithmic = c[4] != 0.0
    y, dy = _cubic(c, np.where(logarithmic, np.log(p), p))
    dy = np.where(logarithmic, dy / p, dy)
    exponential = np.where(c[5] != 0.0, c[5] * np.exp(np.where(c[5] != 0.0, y, 0.0)), y)
    return exponential, np.where(c[5] != 0.0, dy * exponential, dy)
