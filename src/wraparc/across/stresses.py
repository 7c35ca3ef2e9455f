"""Shear stress of all strips at once.

What :func:`wraparc.across.interface.stress_of` answers strip by strip; the rising branch of the
integral-log law with knots, where nearly all strips of nearly all laggings are, in arrays.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.across.interface import stress_of
from wraparc.friction.compact import KNOT_STRIDE, KNOTS, SMALLEST, CompactLaw

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

#: least strips for which arrays are quicker than numbers one by one, measured
FEWEST = 4
_ITERATIONS = 12


class Knots(NamedTuple):
    """The coefficients of an integral-log law with knots, as arrays; empty for other laws.

    Attributes
    ----------
    edges
        Pressures where the segments meet [Pa].
    coefficients
        Shape (segments, 16), see `wraparc.friction.compact`.
    """

    edges: Array
    coefficients: Array


def knots_of(law: CompactLaw) -> Knots:
    """Return the knots of a law."""
    if law.kind != KNOTS:
        return Knots(np.zeros(0), np.zeros((0, KNOT_STRIDE)))
    return Knots(np.array(law.edges), np.array(law.coefficients).reshape(-1, KNOT_STRIDE))


def stresses(
    law: CompactLaw, knots: Knots, compliance: Array, creep: Array, pressure: Array
) -> Array:
    """Shear stress [Pa], its derivatives by creep [Pa/m] and pressure [-], and slip [m].

    Parameters
    ----------
    law, knots
        The friction law, and its knots.
    compliance
        h/G by strip, shape (n,) [m/Pa].
    creep
        u by strip, shape (n,) [m].
    pressure
        Wrap pressure by strip, shape (n,) [Pa].

    Returns
    -------
    numpy.ndarray
        Shape (4, n).
    """
    if law.kind != KNOTS or len(creep) < FEWEST:
        return _one_by_one(law, compliance, creep, pressure)
    out, beyond = _rising(knots, compliance, creep, pressure)
    if np.any(beyond):
        some = np.nonzero(beyond)[0]
        out[:, some] = _one_by_one(law, compliance[some], creep[some], pressure[some])
    return out


def _one_by_one(law: CompactLaw, compliance: Array, creep: Array, pressure: Array) -> Array:
    rows = zip(compliance.tolist(), creep.tolist(), pressure.tolist(), strict=True)
    return np.array([stress_of(law, *row) for row in rows]).T.reshape(4, len(creep))


def _rising(knots: Knots, compliance: Array, creep: Array, pressure: Array) -> tuple[Array, Flags]:
    """Stress before the peak, and which strips are past it or without pressure."""
    empty = pressure <= 0.0
    pressure = np.where(empty, 1.0, pressure)
    peak_slip, peak, slip_p, peak_p, held = _peaks(knots, pressure)
    b = np.abs(creep)
    reach = compliance * pressure * peak
    whole = peak_slip + reach
    r = np.maximum(b / whole, SMALLEST)
    r = np.maximum(b / (peak_slip + reach * (1.0 - np.log(np.minimum(r, 1.0)))), SMALLEST)
    for _ in range(_ITERATIONS):
        lr = np.log(r)
        step = (peak_slip * r + reach * r * (1.0 - lr) - b) / (peak_slip - reach * lr)
        r = np.minimum(np.maximum(r - step, np.maximum(0.1 * r, SMALLEST)), 1.0)
        if np.all(np.abs(step) <= 1e-7 * r):  # the steps shrink quadratically
            break
    lr = np.log(r)
    form = r - r * lr
    mu = peak * form
    slope = -peak * lr / peak_slip * pressure
    mu_p = np.where(held, -mu / pressure, peak_p * form + peak * lr * r * slip_p / peak_slip)
    yielding = 1.0 + compliance * slope
    sign = np.sign(creep)
    by_creep = np.where(
        (b == 0.0) & (compliance > 0.0), 1.0 / np.maximum(compliance, 1e-300), slope / yielding
    )
    out = np.stack(
        [
            sign * mu * pressure,
            by_creep,
            sign * (mu + pressure * mu_p) / yielding,
            sign * peak_slip * r,
        ]
    )
    return out, (b > whole) | empty


def _peaks(knots: Knots, pressure: Array) -> tuple[Array, Array, Array, Array, Flags]:
    """Peak slip and friction with their derivatives by pressure, and where traction is held."""
    edges, c = knots
    if len(edges) == 0:
        one, none = np.ones_like(pressure), np.zeros_like(pressure)
        return c[0, 0] * one, c[0, 4] * one, none, none, none > 0.0
    at = np.minimum(np.maximum(pressure, edges[0]), edges[-1])
    i = np.minimum(np.searchsorted(edges, at, side="right") - 1, len(edges) - 2)
    row, t = c[i].T, at - edges[i]
    inside = (pressure >= edges[0]) & (pressure < edges[-1])
    held = pressure >= edges[-1]
    slip = row[0] + t * (row[1] + t * (row[2] + t * row[3]))
    mu = row[4] + t * (row[5] + t * (row[6] + t * row[7]))
    slip_p = inside * (row[1] + t * (2.0 * row[2] + 3.0 * t * row[3]))
    mu_p = inside * (row[5] + t * (2.0 * row[6] + 3.0 * t * row[7]))
    mu = np.where(held, mu * edges[-1] / np.maximum(pressure, edges[-1]), mu)
    return slip, mu, slip_p, mu_p, held
