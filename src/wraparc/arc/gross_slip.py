"""Gross slip in closed form: one friction of a law everywhere, by quadrature.

The tight side is held (T1 driving, T2 braking) and the slack side falls.
"""

from __future__ import annotations

from math import exp, log, sqrt
from typing import NamedTuple

from wraparc.arc.quantities import Geometry
from wraparc.friction.compact import CompactLaw, excess_at, plateau_at, residual_at, segment_of

_PIECE = 0.25  # of ln T: where friction is smooth, 5 points are exact to rounding
PRESSURES = 5  # of an arc, at which a falling law is looked at


def plateau_capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float) -> float:
    """ln(tight/slack) at gross slip with the largest friction of the law everywhere."""
    return _capacity(law, tight_pressure, wrap_angle, False)


def residual_capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float) -> float:
    """ln(tight/slack) at gross slip with what friction is left with at slips without bound."""
    return _capacity(law, tight_pressure, wrap_angle, True)


def _friction(law: CompactLaw, segment: int, pressure: float, left: bool) -> float:
    """Largest friction of a law at a pressure, or what is left of it [-]."""
    if left:
        return residual_at(law, segment, pressure)
    return plateau_at(law, segment, pressure)


def _capacity(law: CompactLaw, tight_pressure: float, wrap_angle: float, left: bool) -> float:
    """ln(tight/slack) at gross slip.

    d ln T / d theta = -mu(p), integrated in ln p from the tight side: exact to rounding,
    piece by piece (Gauss-Legendre, 5 points, with the last piece closed by Newton's method).
    """
    q, angle = 0.0, wrap_angle
    for _ in range(4 * len(law.edges) + 400):
        segment, span = _piece(law, tight_pressure * exp(-q))
        taken = _angle(law, tight_pressure, segment, q, span, left)
        if taken < angle:
            angle -= taken
            q += span
            continue
        part = span * angle / taken
        for _ in range(50):
            f = _angle(law, tight_pressure, segment, q, part, left) - angle
            mu = _friction(law, segment, tight_pressure * exp(-q - part), left)
            change = f * mu
            part -= change
            if abs(change) < 1e-15:
                break
        return q + part
    return q


def _piece(law: CompactLaw, p: float) -> tuple[int, float]:
    """Segment below a pressure [Pa], and how far ln p may fall in it in one piece."""
    segment = segment_of(law, p * (1.0 - 1e-12))
    return segment, min(_PIECE, log(p / law.edges[segment])) if segment >= 0 else _PIECE


def _angle(
    law: CompactLaw, pressure: float, segment: int, q: float, span: float, left: bool
) -> float:
    """Wrap angle over which ln T falls from -q to -q - span in one piece."""
    total = 0.0
    for node, weight in (
        (0.0, 128.0 / 225.0),
        (-0.5384693101056831, 0.47862867049936647),
        (0.5384693101056831, 0.47862867049936647),
        (-0.906179845938664, 0.23692688505618908),
        (0.906179845938664, 0.23692688505618908),
    ):
        p = pressure * exp(-q - 0.5 * span * (1.0 + node))
        total += weight / _friction(law, segment, p, left)
    return 0.5 * span * total


class Line(NamedTuple):
    """Tensions of an arc along a line: those at k = 1, and how they grow with k [N]."""

    tight: float
    slack: float
    tight_rise: float
    slack_rise: float


def outweighs(law: CompactLaw, geometry: Geometry, tight: float, residual: float) -> bool:
    """Whether some creep may carry more than the residual friction everywhere.

    Only if what friction has over its residual past the rise outweighs what it lacks on it,
    int (mu - mu_residual) dx > 0 from the overrun on at some pressure of the arc: with more creep
    the belt passes the rise sooner, and where the belt is tight.
    """
    area = geometry.width * geometry.radius
    for i in range(PRESSURES):
        p = tight / area * exp(-residual * i / (PRESSURES - 1))
        segment = segment_of(law, p)
        start = abs(geometry.overrun_constant + geometry.overrun_coefficient * p * sqrt(p))
        if excess_at(law, segment, p) + start * residual_at(law, segment, p) > 0.0:
            return True
    return False
