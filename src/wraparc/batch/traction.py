"""Traction of many arcs at once: :mod:`wraparc.arc.traction` over columns.

Every array has the rows in its last axis. The laws of a block of rows are of one kind; each row has
its own law. Twin of the scalar source, which the tests hold it against.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np

from wraparc.arc.traction import LEAST_CREEP, LEAST_SHARE
from wraparc.arrays import Array, Integers
from wraparc.friction.compact import (
    KNOT_STRIDE,
    KNOTS,
    LIMIT,
    PIECE_STRIDE,
    PIECES,
    CompactLaw,
)

#: Of the rise of the integral-log law: its first guess, of what is too much, and steps.
BELOW, RISE_STEPS = 0.4, 2


class Stress(NamedTuple):
    """Traction [Pa], its slopes by creep [Pa/m] and by pressure [-], and slip [m]."""

    stress: Array
    by_creep: Array
    by_pressure: Array
    slip: Array


class Laws(Protocol):
    """Laws of a block of rows."""

    row: Integers  # place of the law of each row

    def stress(self, shear: Array, pressure: Array, creep: Array) -> Stress:
        """Traction at creeps of either sign; `shear` is h/G, shape (n,)."""

    def plateau(self, pressure: Array) -> Array:
        """Largest friction at any slip [-]."""

    def residual(self, pressure: Array) -> Array:
        """Friction that is left at slips without bound [-]."""

    def jump(self, pressure: Array) -> Array:
        """Friction that holds a belt before it slips, 0 for laws that rise from nothing [-]."""

    def excess(self, pressure: Array) -> Array:
        """Friction beyond its residual over all slips, int (mu - mu_residual) dx [m]."""

    def edges(self) -> Array:
        """Pressures where friction has kinks, shape (some, n) [Pa]; inf where there is none."""

    def rows(self, which: slice | Integers) -> Laws:
        """Laws of some of the rows."""


def laws_of(laws: Sequence[CompactLaw], row: Integers) -> Laws:
    """Laws of one kind for rows that each have the place of theirs."""
    kind = laws[0].kind
    if kind in (KNOTS, PIECES):
        return IntegralLog.of(laws, row)
    return Limits.of(laws, row) if kind == LIMIT else Tables.of(laws, row)


class _Columns(NamedTuple):
    """Peak slip, peak friction, slope, residual at a pressure, each with its slope by pressure."""

    slip: Array
    friction: Array
    slope: Array
    residual: Array
    slip_p: Array
    friction_p: Array
    slope_p: Array
    residual_p: Array


class _Bank(NamedTuple):
    """Integral-log laws of some rows, each once.

    Attributes
    ----------
    knots
        Pressures where their pieces meet, shape (some, laws) [Pa]; inf past the last of a law.
    bases
        Pressure that the cubics of each cell begin at, shape (laws, some - 1) [Pa].
    cells
        Coefficients of the cells, shape (stride, laws, some - 1).
    ends
        First and last knot of each law, shape (2, laws) [Pa].
    softens
        Whether friction of any of them falls past its peak.
    pieces
        Whether they are in pieces, else by knots.
    """

    knots: Array
    bases: Array
    cells: Array
    ends: Array
    softens: bool
    pieces: bool


class IntegralLog:
    """Integral-log laws, by knots or in pieces: columns of the pressure, cubics in cells.

    A trend line in ln p or of an exponential is one of cubics too, of another argument: `form` has
    the code of each column, see `wraparc.friction.compact`.
    """

    def __init__(self, bank: _Bank, row: Integers) -> None:
        self.bank, self.row = bank, row
        self.knots, self.bases, self.cells, self.ends, self.softens, self.pieces = bank
        # a count of small numbers is quicker
        self.count = np.uint8 if len(self.knots) < 257 else np.int64

    @classmethod
    def of(cls, laws: Sequence[CompactLaw], row: Integers) -> IntegralLog:
        """Return them from compact laws: cells from below the first edge to above the last."""
        most = max(2, *(len(law.edges) for law in laws))
        pieces = laws[0].kind == PIECES
        stride = PIECE_STRIDE if pieces else KNOT_STRIDE
        edges = np.full((most, len(laws)), np.inf)
        bases = np.zeros((len(laws), most - 1))
        cells = np.zeros((stride, len(laws), most - 1))
        softens = False
        for i, law in enumerate(laws):
            knots = law.edges or (0.0, np.inf)  # one without a tested range has one cell
            n = len(knots)
            edges[:n, i] = knots
            # from its last knot on a law of fewer knots than others has its last cell again, and
            # the cubics of that begin at the knot before
            bases[i, : n - 1], bases[i, n - 1 :] = knots[:-1], knots[-2]
            numbers = np.reshape(law.coefficients, (n - 1, stride))
            cells[:, i, : n - 1] = numbers.T
            cells[:, i, n - 1 :] = numbers[-1][:, None]
            tail = numbers[:, 12:18] if pieces else numbers[:, 8:12]
            softens = softens or bool(np.any(tail))
        ends = [(law.edges[0], law.edges[-1]) if law.edges else (0.0, np.inf) for law in laws]
        return cls(_Bank(edges, bases, cells, np.array(ends).T, softens, pieces), row)

    def edges(self) -> Array:
        """Pressures where friction has kinks, shape (some, n) [Pa]; inf where there is none."""
        return self.knots[:, self.row]

    def rows(self, which: slice | Integers) -> IntegralLog:
        """Laws of some of the rows."""
        return IntegralLog(self.bank, self.row[which])

    def _cells(self, pressure: Array) -> tuple[Array, Integers, Array, Array, Array]:
        """Numbers of all cells; cells of pressures; these held inside the edges; both edges."""
        row, one = self.row, len(self.knots[0]) == 1
        first, last = (self.ends[:, 0]) if one else self.ends[:, row]
        at = np.minimum(np.maximum(pressure, first), last)
        passed = np.zeros(at.shape, dtype=self.count)
        for edge in self.knots[1:-1]:
            passed += at >= (edge[0] if one else edge[row])
        cell = passed.astype(np.int64)
        if not one:
            cell += row * self.cells.shape[2]
        return self.cells.reshape(self.cells.shape[0], -1), cell, at, first, last

    def _columns(self, pressure: Array) -> tuple[_Columns, Array]:
        """Columns at pressures, held outside the edges; the top edge."""
        flat, cell, at, first, last = self._cells(pressure)
        found = self._trends(flat, cell, at) if self.pieces else self._cubics(flat, cell, at)
        inside = (pressure >= first) & (pressure < last)
        slopes = found[4:] if inside.all() else [np.where(inside, s, 0.0) for s in found[4:]]
        return _Columns(*found[:4], *slopes), last

    def _cubics(self, flat: Array, cell: Integers, at: Array) -> tuple[Array, ...]:
        t = at - self.bases.take(cell)
        values: list[Array] = []
        slopes: list[Array] = []
        for o in (0, 4, 8, 12):
            if o > 4 and not self.softens:
                values.append(np.zeros(1) if o == 8 else values[1])
                slopes.append(np.zeros(1) if o == 8 else slopes[1])
                continue
            a1, a2, a3 = (flat[o + k].take(cell) for k in (1, 2, 3))
            values.append(flat[o].take(cell) + t * (a1 + t * (a2 + t * a3)))
            slopes.append(a1 + t * (2.0 * a2 + 3.0 * t * a3))
        return (*values, *slopes)

    def _trends(self, flat: Array, cell: Integers, at: Array) -> tuple[Array, ...]:
        v = []
        for o in (0, 6, 12, 18):
            logs = flat[o + 4][cell] != 0.0
            t = np.where(logs, np.log(at), at)
            a1, a2, a3 = flat[o + 1][cell], flat[o + 2][cell], flat[o + 3][cell]
            y = flat[o][cell] + t * (a1 + t * (a2 + t * a3))
            dy = (a1 + t * (2.0 * a2 + 3.0 * t * a3)) / np.where(logs, at, 1.0)
            sign = flat[o + 5][cell]
            grown = sign * np.exp(np.where(sign != 0.0, y, 0.0))
            v.append((np.where(sign != 0.0, grown, y), np.where(sign != 0.0, dy * grown, dy)))
        (a, a_p), (b, b_p), (slope, slope_p), (residual, residual_p) = v
        number = np.exp(b / a - 1.0)
        number_p = number * (b_p - b * a_p / a) / a
        unit = flat[24][cell]
        return (
            unit * number,
            -a * number,
            slope,
            residual,
            unit * number_p,
            -a_p * number - a * number_p,
            slope_p,
            residual_p,
        )

    def stress(self, shear: Array, pressure: Array, creep: Array) -> Stress:
        """Traction at creeps of either sign.

        Choices are made by what is larger: by a mask they would cost ten times as much.
        """
        c, last = self._columns(pressure)
        held = np.minimum(pressure, last)  # traction is held above the last edge
        size = np.maximum(np.abs(creep), LEAST_CREEP)
        ease = shear * held
        most = ease * c.friction
        r, log_r = _risen(most / c.slip, size / c.slip)
        form = r - r * log_r
        mu, mu_x = c.friction * form, -c.friction * log_r / c.slip
        mu_p = c.friction_p * form + c.friction * log_r * r * c.slip_p / c.slip
        past = np.maximum(size - c.slip - most, 0.0)
        x = r * c.slip
        if self.softens and past.any():
            # on the line past the peak, then on what is left
            left = np.minimum(c.residual, c.friction)
            d = past / (1.0 + ease * c.slope)
            further = past + ease * (c.friction - left)
            line = c.friction + c.slope * d
            low = line < left
            falls = (past > 0.0) ^ low
            left_p = np.where(c.residual < c.friction, c.residual_p, c.friction_p)
            mu += np.maximum(line, left) - c.friction
            mu_x += falls * c.slope
            mu_p += falls * (c.slope_p * d - c.slope * c.slip_p) + low * (left_p - c.friction_p)
            x += np.minimum(d, further)
        else:
            x += past
        stiff = 1.0 / (1.0 + ease * mu_x)
        by_pressure = (mu + pressure * mu_p) * (pressure < last)
        scale = creep / size
        return Stress(
            scale * mu * held, held * mu_x * stiff, scale * by_pressure * stiff, scale * x
        )

    def plateau(self, pressure: Array) -> Array:
        """Largest friction at any slip [-]."""
        if self.pieces:
            c, last = self._columns(pressure)
            return np.asarray(c.friction * np.minimum(last / pressure, 1.0))
        flat, cell, at, _, last = self._cells(pressure)
        t = at - self.bases.take(cell)
        m0, m1, m2, m3 = (flat[k].take(cell) for k in (4, 5, 6, 7))
        mu = m0 + t * (m1 + t * (m2 + t * m3))
        return np.asarray(mu * np.minimum(last / pressure, 1.0))

    def residual(self, pressure: Array) -> Array:
        """Friction that is left at slips without bound [-]."""
        c, last = self._columns(pressure)
        left = np.where(c.slope < 0.0, np.minimum(c.residual, c.friction), c.friction)
        return np.asarray(left * np.minimum(last / pressure, 1.0))

    def excess(self, pressure: Array) -> Array:
        """Friction beyond its residual over all slips [m]; up to the peak 3/4 mu_pk x_pk."""
        c, last = self._columns(pressure)
        left = np.where(c.slope < 0.0, np.minimum(c.residual, c.friction), c.friction)
        fall = c.friction - left
        line = np.where(
            fall > 0.0, -0.5 * fall * fall / np.where(c.slope < 0.0, c.slope, -1.0), 0.0
        )
        found = c.slip * (0.75 * c.friction - left) + line
        return np.asarray(found * np.minimum(last / pressure, 1.0))

    def jump(self, pressure: Array) -> Array:
        """No friction before the belt slips [-]."""
        return np.zeros_like(pressure)


def _risen(k: Array, w: Array) -> tuple[Array, Array]:
    """Slip over peak slip r with r + k r (1 - ln r) = w, at most 1, and ln r.

    Between what the slope at w makes of it, which is too much, and the parabola at the peak, too
    little; two steps of Householder's method of order four, and Newton's with what the last
    logarithm tells: 1e-15.
    """
    w = np.minimum(w, 1.0 + k)
    short = 1.0 + k - w
    near = 1.0 - 2.0 * short / (1.0 + np.sqrt(1.0 + 2.0 * k * short))
    far = BELOW * w / (1.0 + k * (1.0 - np.log(np.minimum(w, 1.0))))
    r = np.minimum(np.maximum(near, far), 1.0)
    for _ in range(RISE_STEPS):
        log_r = np.log(r)
        slope = 1.0 - k * log_r
        step = (r + k * r * (1.0 - log_r) - w) / slope
        bend = k * step / (r * slope)
        r -= step * (1.0 + 0.5 * bend) / (1.0 + bend * (1.0 + step / (6.0 * r)))
        r = np.minimum(np.maximum(r, LEAST_SHARE), 1.0)
    log_r = np.log(r)
    part = (r + k * r * (1.0 - log_r) - w) / (r * (1.0 - k * log_r))
    return np.minimum(r - r * part, 1.0), np.minimum(log_r - part, 0.0)


class Limits:
    """Laws with a limit: constant, of a power of pressure, elastic-plastic."""

    def __init__(self, numbers: Array, ends: Array, row: Integers) -> None:
        self.numbers, self.ends, self.row = numbers, ends, row

    @classmethod
    def of(cls, laws: Sequence[CompactLaw], row: Integers) -> Limits:
        """Return them from compact laws."""
        numbers = np.array([law.coefficients for law in laws], dtype=float).T
        ends = np.array(
            [(law.edges[0], law.edges[-1]) if law.edges else (0.0, np.inf) for law in laws]
        )
        return cls(numbers, ends.T, row)

    def edges(self) -> Array:
        """Pressures where friction has kinks, shape (some, n) [Pa]; inf where there is none."""
        return np.where(self.ends > 0.0, self.ends, np.inf)[:, self.row]

    def rows(self, which: slice | Integers) -> Limits:
        """Laws of some of the rows."""
        return Limits(self.numbers, self.ends, self.row[which])

    def _limit(self, pressure: Array) -> tuple[Array, Array]:
        """Traction at the limit [Pa], and its slope by pressure [-]."""
        mu_0, p_0, n = self.numbers[:3, self.row]
        first, last = self.ends[:, self.row]
        at = np.minimum(np.maximum(pressure, first), last)
        mu = mu_0 * np.where(
            n == 0.0, 1.0, (np.maximum(at, 1e-12) / np.where(n == 0.0, 1.0, p_0)) ** -n
        )
        inside = (pressure >= first) & (pressure < last)
        slope = np.where(pressure >= last, 0.0, mu * np.where(inside, 1.0 - n, 1.0))
        return mu * np.minimum(pressure, last), slope

    def stress(self, shear: Array, pressure: Array, creep: Array) -> Stress:
        """Traction at creeps of either sign."""
        top, top_p = self._limit(pressure)
        soft = shear + self.numbers[3, self.row]
        size, sign = np.abs(creep), np.where(creep >= 0.0, 1.0, -1.0)
        slips = (size > soft * top) | (soft == 0.0)
        stiff = np.where(soft > 0.0, soft, 1.0)
        stress = np.where(slips, top, size / stiff)
        return Stress(
            sign * stress,
            np.where(slips, 0.0, 1.0 / stiff),
            np.where(slips, sign * top_p, 0.0),
            sign * np.where(slips, size - shear * top, size * self.numbers[3, self.row] / stiff),
        )

    def plateau(self, pressure: Array) -> Array:
        """Largest friction at any slip [-]."""
        return np.asarray(self._limit(pressure)[0] / pressure)

    residual = plateau

    def excess(self, pressure: Array) -> Array:
        """Nothing: friction does not fall [m]."""
        return np.zeros_like(pressure)

    def jump(self, pressure: Array) -> Array:
        """Friction that holds a belt before it slips [-]."""
        return np.where(self.numbers[3, self.row] == 0.0, self._limit(pressure)[0] / pressure, 0.0)


class Tables:
    """Measured tables: cubics in slip, linear in pressure."""

    def __init__(self, slips: Array, knots: Array, numbers: Array, row: Integers) -> None:
        self.slips, self.knots, self.numbers, self.row = slips, knots, numbers, row

    @classmethod
    def of(cls, laws: Sequence[CompactLaw], row: Integers) -> Tables:
        """Return them from compact laws: cells and pressures filled up with the last ones."""
        cells, rows = max(len(law.slips) for law in laws), max(len(law.edges) for law in laws)
        slips, edges = np.full((cells, len(laws)), np.inf), np.full((rows, len(laws)), np.inf)
        numbers = np.zeros((4, len(laws), rows, cells))
        for i, law in enumerate(laws):
            m, n = len(law.slips), len(law.edges)
            slips[:m, i], edges[:n, i] = law.slips, law.edges
            given = np.reshape(law.coefficients, (n, m, 4))
            numbers[:, i, :n, :m] = np.moveaxis(given, 2, 0)
            numbers[:, i, n:, :m] = numbers[:, i, n - 1 : n, :m]
            numbers[0, i, :, m:] = numbers[0, i, :, m - 1 : m]
        return cls(slips, edges, numbers, row)

    def edges(self) -> Array:
        """Pressures where friction has kinks, shape (some, n) [Pa]; inf where there is none."""
        return self.knots[:, self.row]

    def rows(self, which: slice | Integers) -> Tables:
        """Laws of some of the rows."""
        return Tables(self.slips, self.knots, self.numbers, self.row[which])

    def _between(self, pressure: Array) -> tuple[Array, Integers, Array, Array]:
        """Pressure that traction is held at, place of the row below, weight of the next, width."""
        row, rows, cells = self.row, self.knots.shape[0], self.slips.shape[0]
        held, at = pressure, np.zeros(pressure.shape, dtype=np.int64)
        for k in range(1, rows):
            at += pressure >= self.knots[k][row]
        lasts = np.where(np.isfinite(self.knots), self.knots, -np.inf).max(axis=0)[row]
        held = np.minimum(pressure, lasts)
        low = self.knots.T[row, at]
        high = self.knots.T[row, np.minimum(at + 1, rows - 1)]
        width = np.where(np.isfinite(high) & (high > low), high - low, np.inf)
        weight = np.maximum(held - low, 0.0) / width
        return held, (row * rows + at) * cells, weight, np.where(pressure < low, np.inf, width)

    def _blend(self, k: int, place: Integers, weight: Array) -> tuple[Array, Array]:
        """One coefficient at a pressure, and its difference from row to row."""
        flat, cells = self.numbers[k].reshape(-1), self.slips.shape[0]
        low = flat[place]
        more = flat[np.minimum(place + cells, len(flat) - 1)] - low
        more = np.where(weight > 0.0, more, np.where(weight == 0.0, more, 0.0))
        return low + weight * more, more

    def stress(self, shear: Array, pressure: Array, creep: Array) -> Stress:
        """Traction at creeps of either sign."""
        held, place, weight, width = self._between(pressure)
        size, sign = np.abs(creep), np.where(creep >= 0.0, 1.0, -1.0)
        ease, slips = shear * held, self.slips
        begin = self._blend(0, place, weight)[0]
        stuck = size <= ease * begin
        cell, low, u_low = np.zeros(size.shape, dtype=np.int64), np.zeros(size.shape), ease * begin
        high, u_high = np.full(size.shape, np.inf), np.full(size.shape, np.inf)
        open_ = np.ones(size.shape, dtype=bool)
        for k in range(1, len(slips)):
            end = np.broadcast_to(slips[k][self.row], size.shape)
            u_end = end + ease * self._blend(0, place + k, weight)[0]
            passed = open_ & (size > u_end)
            ends = open_ & ~passed & np.isfinite(end)
            high, u_high = np.where(ends, end, high), np.where(ends, u_end, u_high)
            last = open_ & ~np.isfinite(end)
            cell, low = np.where(passed, k, cell), np.where(passed, end, low)
            u_low = np.where(passed, u_end, u_low)
            open_ = passed & ~last
        place = place + cell
        coefficients = [self._blend(k, place, weight) for k in range(4)]
        (c0, d0), (c1, d1), (c2, d2), (c3, d3) = coefficients
        span = np.where(np.isfinite(high), high - low, np.inf)
        t = np.where(
            np.isfinite(span),
            (size - u_low) / np.where(np.isfinite(span), u_high - u_low, 1.0),
            0.0,
        ) * np.where(np.isfinite(span), span, 0.0)
        done = stuck.copy()
        a, b = np.zeros(size.shape), np.where(np.isfinite(span), span, 0.0)
        for _ in range(60):
            miss = low + t + ease * (c0 + t * (c1 + t * (c2 + t * c3))) - size
            a, b = np.where(miss > 0.0, a, t), np.where(miss > 0.0, t, b)
            slope = 1.0 + ease * (c1 + t * (2.0 * c2 + 3.0 * t * c3))
            new = t - miss / np.where(slope > 0.0, slope, 1.0)
            new = np.where((new > a) & (new < b), new, 0.5 * (a + b))
            new = np.where(np.isfinite(span), new, size - ease * c0 - low)
            change = np.abs(new - t)
            t = np.where(done, t, new)  # a row keeps what it had, whatever it is solved with
            done |= change <= 1e-13 * (low + t)
            if done.all():
                break
        mu = c0 + t * (c1 + t * (c2 + t * c3))
        mu_x = c1 + t * (2.0 * c2 + 3.0 * t * c3)
        mu_p = (d0 + t * (d1 + t * (d2 + t * d3))) / width
        stiff = 1.0 / (1.0 + ease * mu_x)
        soft = np.where(shear > 0.0, shear, 1.0)
        by_p = np.where(held < pressure, 0.0, mu + pressure * mu_p)
        return Stress(
            sign * np.where(stuck, size / soft, mu * held),
            np.where(stuck, 1.0 / soft, held * mu_x * stiff),
            np.where(stuck, 0.0, sign * by_p * stiff),
            sign * np.where(stuck, 0.0, low + t),
        )

    def plateau(self, pressure: Array) -> Array:
        """Largest friction at any slip [-]."""
        held, place, weight, _ = self._between(pressure)
        best = self._blend(0, place, weight)[0]
        for k in range(1, len(self.slips)):
            best = np.maximum(best, self._blend(0, place + k, weight)[0])
        return np.asarray(best * held / pressure)

    def residual(self, pressure: Array) -> Array:
        """Friction that is left at slips without bound [-]."""
        held, place, weight, _ = self._between(pressure)
        mu = self._blend(0, place + len(self.slips) - 1, weight)[0]
        return np.asarray(mu * held / pressure)

    def excess(self, pressure: Array) -> Array:
        """Friction beyond its residual over all slips [m], cell by cell."""
        held, place, weight, _ = self._between(pressure)
        left = self._blend(0, place + len(self.slips) - 1, weight)[0]
        total = np.zeros(pressure.shape)
        for k in range(len(self.slips) - 1):
            start, end = self.slips[k][self.row], self.slips[k + 1][self.row]
            width = np.where(np.isfinite(end), end, 0.0) - np.where(np.isfinite(end), start, 0.0)
            c0, c1, c2, c3 = (self._blend(j, place + k, weight)[0] for j in range(4))
            mean = c0 + width * (c1 / 2.0 + width * (c2 / 3.0 + width * c3 / 4.0))
            total = total + width * (mean - left)
        return np.asarray(total * held / pressure)

    def jump(self, pressure: Array) -> Array:
        """Friction that holds a belt before it slips [-]."""
        held, place, weight, _ = self._between(pressure)
        return np.asarray(self._blend(0, place, weight)[0] * held / pressure)
