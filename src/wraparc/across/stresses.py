"""What the lagging answers to creep, on all strips at once: shear stress tau(u, p).

Slip and shear of the lagging in series, u = x + (h/G) tau with tau = mu(x, p) p (section 2 of the
page on the model). Creep is the state across the width, not slip: neighbouring strips may creep
either way, and creep passes through zero where slip has no slope. Arrays of any one shape; the
coefficients are those of `wraparc.friction.compact`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.arrays import Array, Flags
from wraparc.friction.compact import (
    KNOT_STRIDE,
    KNOTS,
    LIMIT,
    PIECE_STRIDE,
    SMALLEST,
    TABLE,
    CompactLaw,
)

#: parts of an element along the arc where friction has kinks in creep, see `Law.bends`
FINENESS = 4
_MOST_ITERATIONS = 60


class Law(NamedTuple):
    """A `CompactLaw` as arrays.

    Its coefficients have shape (segments, 16 or 25) of an integral-log law, (4,) of a limit,
    (pressures, slips, 4) of a table.
    """

    kind: int
    edges: Array
    coefficients: Array
    slips: Array
    onset_compliance: float

    @classmethod
    def of(cls, law: CompactLaw) -> Law:
        """Return the law as arrays."""
        edges, slips = np.array(law.edges, dtype=float), np.array(law.slips, dtype=float)
        shape = {LIMIT: (-1,), KNOTS: (-1, KNOT_STRIDE), TABLE: (-1, len(slips), 4)}
        coefficients = np.array(law.coefficients).reshape(shape.get(law.kind, (-1, PIECE_STRIDE)))
        return cls(law.kind, edges, coefficients, slips, float(law.onset_compliance))

    @property
    def bends(self) -> bool:
        """Whether stress has a kink in creep: where a strip begins to slide, or between cells."""
        return self.kind in (LIMIT, TABLE)


class Stress(NamedTuple):
    """Shear stress of strips.

    Attributes
    ----------
    stress
        tau [Pa].
    by_creep, by_pressure
        Its derivatives by creep at fixed pressure [Pa/m] and by pressure at fixed creep [-].
    slip
        x [m].
    """

    stress: Array
    by_creep: Array
    by_pressure: Array
    slip: Array


class _Friction(NamedTuple):
    """Friction [-], its derivatives by slip [1/m] and pressure [1/Pa], and the slip [m]."""

    mu: Array
    by_slip: Array
    by_pressure: Array
    slip: Array


def stresses(law: Law, compliance: Array, creep: Array, pressure: Array) -> Stress:
    """Shear stress between belt and lagging; a strip without pressure carries nothing.

    Parameters
    ----------
    law
        The friction law.
    compliance
        h/G of the lagging, >= 0 [m/Pa].
    creep
        u, either sign [m].
    pressure
        Wrap pressure [Pa].
    """
    empty = pressure <= 0.0
    p, b = np.where(empty, 1.0, pressure), np.abs(creep)
    friction = {LIMIT: _limit, TABLE: _table}.get(law.kind, _integral_log)
    mu, mu_x, mu_p, slip = _held(law, p, friction(law, compliance, b, p))
    yielding = 1.0 + compliance * mu_x * p
    stress, by_creep = mu * p, mu_x * p / yielding
    by_pressure = (mu + p * mu_p) / yielding
    stuck, elastic = _stuck(law, compliance, b, p)
    if np.any(stuck):
        rigid = np.where(stuck & (elastic > 0.0), elastic, 1.0)
        stress = np.where(stuck, b / rigid, stress)
        by_creep = np.where(stuck, 1.0 / rigid, by_creep)
        by_pressure = np.where(stuck, 0.0, by_pressure)
        slip = np.where(stuck, law.onset_compliance * stress, slip)
    sign = np.where(creep < 0.0, -1.0, 1.0)
    if np.any(empty):
        stress, by_creep, by_pressure = (
            np.where(empty, 0.0, v) for v in (stress, by_creep, by_pressure)
        )
        slip = np.where(empty, b, slip)
    return Stress(sign * stress, by_creep, sign * by_pressure, sign * slip)


def pieces(law: Law, compliance: Array, creep: Array, pressure: Array) -> NDArray[np.intp]:
    """Number of the piece of its law that a strip is on; on each, stress is smooth."""
    p, b = np.maximum(pressure, 1e-12), np.abs(creep)
    if law.kind == TABLE:
        piece = np.sum(b[..., None] > _bounds(law, compliance, p), axis=-1)
    elif law.kind == LIMIT:
        piece = 1 - _stuck(law, compliance, b, p)[0].astype(int)
    else:
        at, held = _clipped(law, p)
        row, give = law.coefficients[_segment(law, at)], compliance * p * held
        slip, mu, _, _ = _peak(law, row, at)
        slope, residual, _, _ = _tail(law, row, at)
        past = b - slip - give * mu
        ended = mu + slope * past / (1.0 + give * slope) < np.minimum(residual, mu)
        piece = (past > 0.0) * (1 + ended)
    segment = np.searchsorted(law.edges, p, side="right")
    return np.asarray((len(law.slips) + 3) * segment + piece)


def _bounds(law: Law, compliance: Array, p: Array) -> Array:
    """Creep at which each cell of a table begins, shape (..., slips) [m]."""
    return law.slips + (np.asarray(compliance) * p)[..., None] * _cells(law, p)[3]


def _held(law: Law, p: Array, found: _Friction) -> _Friction:
    """Friction held below the tested pressures, the traction held above them."""
    if len(law.edges) == 0:
        return found
    mu, mu_x, mu_p, slip = found
    over = np.maximum(p / law.edges[-1], 1.0)
    above = p >= law.edges[-1]
    mu_p = np.where(above, -mu / (over * p), np.where(p < law.edges[0], 0.0, mu_p))
    return _Friction(mu / over, mu_x / over, mu_p, slip)


def _clipped(law: Law, p: Array) -> tuple[Array, Array]:
    """Pressure within the tested ones, and by how much friction is less above them."""
    if len(law.edges) == 0:
        return p, np.ones_like(p)
    at = np.minimum(np.maximum(p, law.edges[0]), law.edges[-1])
    return at, np.minimum(law.edges[-1] / p, 1.0)


def _stuck(law: Law, compliance: Array, b: Array, p: Array) -> tuple[Flags, Array]:
    """Which strips are held by the elastic give of lagging and law, and that give [m/Pa]."""
    elastic = compliance + np.zeros_like(b)
    if law.kind == LIMIT:
        at, held = _clipped(law, p)
        elastic = elastic + law.onset_compliance
        onset = _limit_at(law, at)[0] * held
    elif law.kind == TABLE:
        onset = _cells(law, p)[3][..., 0]
    else:
        onset = np.zeros_like(b)
    return (b <= elastic * onset * p) & (elastic > 0.0), elastic


def _limit(law: Law, compliance: Array, b: Array, p: Array) -> _Friction:
    at, held = _clipped(law, p)
    mu, mu_p = _limit_at(law, at)
    return _Friction(mu, np.zeros_like(b), mu_p, b - compliance * mu * held * p)


def _limit_at(law: Law, p: Array) -> tuple[Array, Array]:
    """The limit mu_0 (p / p_0)^-n and its derivative by pressure."""
    mu0, p0, exponent = law.coefficients[:3]
    if exponent == 0.0:
        return np.full_like(p, mu0), np.zeros_like(p)
    at = np.maximum(p, 1e-12)  # a trial far off the solution may have no pressure left
    mu = mu0 * (at / p0) ** -exponent
    return mu, -exponent * mu / at


def _integral_log(law: Law, compliance: Array, b: Array, p: Array) -> _Friction:
    at, held = _clipped(law, p)
    row = law.coefficients[_segment(law, at)]
    slip_pk, mu_pk, slip_p, mu_pk_p = _peak(law, row, at)
    give = compliance * p * held
    reach = give * mu_pk  # shear of the lagging at the peak
    whole = slip_pk + reach
    r = np.maximum(b / whole, SMALLEST)
    r = np.maximum(b / (slip_pk + reach * (1.0 - np.log(np.minimum(r, 1.0)))), SMALLEST)
    for _ in range(_MOST_ITERATIONS):
        lr = np.log(r)
        step = (slip_pk * r + reach * r * (1.0 - lr) - b) / (slip_pk - reach * lr)
        r = np.minimum(np.maximum(r - step, np.maximum(0.1 * r, SMALLEST)), 1.0)
        if np.all((np.abs(step) <= 1e-7 * r) | (b >= whole) | (r <= SMALLEST)):
            break  # the steps shrink quadratically
    lr = np.log(r)
    form = r - r * lr
    mu, mu_x = mu_pk * form, -mu_pk * lr / slip_pk
    mu_p = mu_pk_p * form + mu_pk * lr * r * slip_p / slip_pk
    rising = _Friction(mu, mu_x, mu_p, slip_pk * r)
    past = b > whole
    if not np.any(past):
        return rising
    slope, residual, slope_p, residual_p = _tail(law, row, at)
    # the residual friction of a law that does not fall is its peak
    falls = residual < mu_pk
    least, least_p = np.where(falls, residual, mu_pk), np.where(falls, residual_p, mu_pk_p)
    d = (b - whole) / (1.0 + give * slope)
    line = mu_pk + slope * d
    ended = line < least
    beyond = _Friction(
        np.where(ended, least, line),
        np.where(ended, 0.0, slope),
        np.where(ended, least_p, mu_pk_p + slope_p * d - slope * slip_p),
        np.where(ended, b - give * least, slip_pk + d),
    )
    return _Friction(*(np.where(past, y, x) for x, y in zip(rising, beyond, strict=True)))


def _segment(law: Law, at: Array) -> NDArray[np.intp]:
    """Segment of a pressure within the tested ones."""
    last = max(len(law.edges) - 2, 0)
    return np.minimum(np.searchsorted(law.edges[1:], at, side="right"), last)


def _peak(law: Law, row: Array, at: Array) -> tuple[Array, Array, Array, Array]:
    """Peak slip [m] and friction [-], and their derivatives by pressure."""
    if law.kind == KNOTS:
        (slip, slip_p), (mu, mu_p) = (_cubic(law, row, at, o) for o in (0, 4))
        return slip, mu, slip_p, mu_p
    (a, a_p), (b, b_p) = (_trend(row, at, o) for o in (0, 6))
    number = np.exp(b / a - 1.0)
    number_p = number * (b_p - b * a_p / a) / a
    unit = row[..., 24]
    return unit * number, -a * number, unit * number_p, -a_p * number - a * number_p


def _tail(law: Law, row: Array, at: Array) -> tuple[Array, Array, Array, Array]:
    """Slope after the peak [1/m] and residual friction [-], and their derivatives by pressure."""
    if law.kind == KNOTS:
        (slope, slope_p), (mu, mu_p) = (_cubic(law, row, at, o) for o in (8, 12))
    else:
        (slope, slope_p), (mu, mu_p) = (_trend(row, at, o) for o in (12, 18))
    return slope, mu, slope_p, mu_p


def _cubic(law: Law, row: Array, at: Array, o: int) -> tuple[Array, Array]:
    """Value and derivative of a column of a law with knots; held at the edges."""
    if len(law.edges) == 0:
        return row[..., o], np.zeros_like(at)
    t = at - law.edges[_segment(law, at)]
    c0, c1, c2, c3 = (row[..., o + k] for k in range(4))
    return c0 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2.0 * c2 + 3.0 * t * c3)


def _trend(row: Array, at: Array, o: int) -> tuple[Array, Array]:
    """Value and derivative of a trend line, see `wraparc.friction.compact`."""
    c0, c1, c2, c3, in_log, of_exp = (row[..., o + k] for k in range(6))
    v = np.where(in_log != 0.0, np.log(at), at)
    y = c0 + v * (c1 + v * (c2 + v * c3))
    dy = (c1 + v * (2.0 * c2 + 3.0 * v * c3)) * np.where(in_log != 0.0, 1.0 / at, 1.0)
    raised = of_exp * np.exp(np.where(of_exp != 0.0, y, 0.0))
    return np.where(of_exp != 0.0, raised, y), np.where(of_exp != 0.0, raised * dy, dy)


def _cells(law: Law, p: Array) -> tuple[NDArray[np.intp], NDArray[np.intp], Array, Array]:
    """Rows of a table about a pressure, the weight of the upper, and friction at its slips."""
    edges, last = law.edges, max(len(law.edges) - 1, 0)
    at, held = _clipped(law, p)
    low = np.minimum(_segment(law, at), last)
    high = np.minimum(low + 1, last)
    w = (at - edges[low]) / np.where(high > low, edges[high] - edges[low], 1.0)
    at_slips = law.coefficients[:, :, 0]
    mu = (1.0 - w[..., None]) * at_slips[low] + w[..., None] * at_slips[high]
    return low, high, w, mu * held[..., None]


def _table(law: Law, compliance: Array, b: Array, p: Array) -> _Friction:
    low, high, w, _ = _cells(law, p)
    give = compliance * p * _clipped(law, p)[1]
    begins = _bounds(law, compliance, p)
    cell = np.maximum(np.sum(b[..., None] > begins, axis=-1) - 1, 0)
    under, over = law.coefficients[low, cell], law.coefficients[high, cell]
    c = (1.0 - w[..., None]) * under + w[..., None] * over
    c0, c1, c2, c3 = (c[..., k] for k in range(4))
    start, ends = law.slips[cell], np.append(law.slips[1:], np.inf)[cell]
    least, most = np.zeros_like(b), np.minimum(ends - start, np.maximum(b - start, 0.0))
    x = 0.5 * most
    for _ in range(_MOST_ITERATIONS):
        slope = c1 + x * (2.0 * c2 + 3.0 * x * c3)
        miss = start + x + give * (c0 + x * (c1 + x * (c2 + x * c3))) - b
        most, least = np.where(miss > 0.0, x, most), np.where(miss > 0.0, least, x)
        trial = x - miss / (1.0 + give * slope)
        trial = np.where((trial < least) | (trial > most), 0.5 * (least + most), trial)
        moved, x = np.abs(trial - x), trial
        if np.all(moved <= 1e-14 * b):
            break
    mu = c0 + x * (c1 + x * (c2 + x * c3))
    mu_x = c1 + x * (2.0 * c2 + 3.0 * x * c3)
    d0, d1, d2, d3 = ((over - under)[..., k] for k in range(4))
    width = np.where(high > low, law.edges[high] - law.edges[low], 1.0)
    mu_p = (d0 + x * (d1 + x * (d2 + x * d3))) / width
    return _Friction(mu, mu_x, mu_p, start + x)
