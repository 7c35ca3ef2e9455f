"""Friction as a measured table of slip and pressure."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf, isfinite
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arrays import Array
from wraparc.friction.base import (
    LEAST_FRICTION,
    LEAST_SLIP,
    MOST_SLIP,
    Equation,
    FrictionLaw,
    TestedRange,
    check,
)
from wraparc.friction.compact import TABLE, CompactLaw
from wraparc.friction.interpolation import evaluate, pchip


@dataclass(frozen=True, kw_only=True)
class MeasuredTable(FrictionLaw):
    """Friction at a grid of slips and pressures: monotone cubic in slip, linear in pressure.

    Past the last slip friction stays at its last value. A first row at slip 0 that is not 0 makes
    a law that starts with a jump: below that friction the belt sticks to the lagging.

    Attributes
    ----------
    slip
        Slips of the rows, ascending from 0 [m], shape (m,), m >= 2.
    pressure
        Pressures of the columns, ascending, > 0 [Pa], shape (n,), n >= 1.
    values
        Friction, one tuple for each pressure, shape (n, m), at least 1e-6 past slip 0, that or 0
        there [-].
    """

    title = "measured table"
    equation = Equation(
        "Friction by monotone interpolation of the measured table",
        'mu = mu(x, p) "interpolated"',
        r"\mu = \mu(x, p)\ \text{interpolated}",
        "mu of x and p interpolated",
    )

    slip: tuple[float, ...]
    pressure: tuple[float, ...]
    values: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        m = len(self.slip)
        numbers = (*self.slip, *self.pressure, *(v for row in self.values for v in row))
        check(
            (all(map(isfinite, numbers)), "values", "", "the table must hold finite numbers only"),
            (
                m >= 2 and self.slip[0] == 0.0,
                "slip",
                f"{m} slips",
                "at least two slips, the first of them 0, are needed",
            ),
            (_ascending(self.slip), "slip", "", "the slips must be in ascending order"),
            (
                all(b - a >= LEAST_SLIP for a, b in pairwise(self.slip))
                or not _ascending(self.slip),
                "slip",
                "",
                "the slips must be at least 1 nm apart",
            ),
            (
                not any(MOST_SLIP < slip < inf for slip in self.slip),
                "slip",
                f"{max(self.slip, default=0.0):g} m",
                "the slips must be at most 1 km",
            ),
            (
                bool(self.pressure)
                and _ascending(self.pressure)
                and all(p > 0 for p in self.pressure),
                "pressure",
                "",
                "the pressures must be positive and in ascending order",
            ),
            (
                len(self.values) == len(self.pressure)
                and all(len(row) == m for row in self.values),
                "friction",
                "",
                f"the table must have a row of {m} values for each of {len(self.pressure)} "
                "pressures",
            ),
            (
                all(v == 0.0 or v >= LEAST_FRICTION for row in self.values for v in row[:1])
                and all(v >= LEAST_FRICTION for row in self.values for v in row[1:]),
                "friction",
                "",
                f"friction must be at least {LEAST_FRICTION:g} past slip 0, that or 0 at slip 0",
            ),
            (
                len({row[0] > 0 for row in self.values if row}) <= 1,
                "friction",
                "",
                "friction at slip 0 must be 0 at every pressure or positive at every pressure",
            ),
        )

    @property
    def tested(self) -> TestedRange:
        """The range of the table."""
        return TestedRange(
            pressure_min=self.pressure[0], pressure_max=self.pressure[-1], slip_max=self.slip[-1]
        )

    def _cubics(self) -> list[Array]:
        slip = np.array(self.slip)
        return [pchip(slip, np.array(row)) for row in self.values]

    def friction(self, slip: ArrayLike, pressure: ArrayLike) -> Array:
        """Friction with the sign of the slip [-]; see the class for the interpolation."""
        x, p = np.broadcast_arrays(np.asarray(slip, float), np.asarray(pressure, float))
        knots = np.array(self.slip)
        a = np.minimum(np.abs(x), knots[-1])
        rows = np.array([evaluate(knots, c, a) for c in self._cubics()])
        edges = np.array(self.pressure)
        at = np.clip(p, edges[0], edges[-1])
        factor = np.where(p > edges[-1], edges[-1] / p, 1.0)
        i = np.clip(np.searchsorted(edges, at, side="right") - 1, 0, max(len(edges) - 2, 0))
        if len(edges) == 1:
            mu = rows[0]
        else:
            w = (at - edges[i]) / (edges[i + 1] - edges[i])
            low = np.take_along_axis(rows, i[None], 0)[0]
            high = np.take_along_axis(rows, i[None] + 1, 0)[0]
            mu = low + w * (high - low)
        return np.asarray(np.sign(x) * factor * mu)

    def compact(self) -> CompactLaw:
        """Return the law in the numeric form that the solvers read."""
        c: list[float] = []
        for row, cubics in zip(self.values, self._cubics(), strict=True):
            c += [*cubics.ravel().tolist(), row[-1], 0.0, 0.0, 0.0]
        return CompactLaw(TABLE, self.pressure, tuple(c), slips=self.slip)

    def steepest_fall(self) -> float:
        """Return the steepest fall of the interpolant, <= 0 [1/m]."""
        width = np.diff(np.array(self.slip))
        slopes = []
        for _, c1, c2, c3 in (c.T for c in self._cubics()):
            with np.errstate(divide="ignore", invalid="ignore"):
                vertex = np.nan_to_num(-c2 / (3.0 * c3), posinf=0.0, neginf=0.0)
            slopes += [
                c1 + t * (2.0 * c2 + 3.0 * c3 * t)
                for t in (0.0 * width, np.clip(vertex, 0.0, width), width)
            ]
        fall = min(float(np.min(slopes)), 0.0)
        # a rising row whose interpolant is level at a node falls there by rounding alone
        return fall if fall < -1e-12 * float(np.max(np.abs(slopes))) else 0.0

    def _scaled(self, friction: float, slip: float) -> Self:
        rows = tuple(tuple(mu * friction for mu in row) for row in self.values)
        return replace(self, slip=tuple(x * slip for x in self.slip), values=rows)


def _ascending(values: tuple[float, ...]) -> bool:
    return all(a < b for a, b in pairwise(values))
