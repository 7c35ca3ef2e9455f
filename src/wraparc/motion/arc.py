"""One arc in time: what it is, where it has come to, and what can be read of it.

Its pieces of lagging are carried along by :mod:`wraparc.motion.wraps`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf, sqrt
from typing import NamedTuple, Protocol

import numpy as np

from wraparc.arc import WrapArc
from wraparc.arrays import Array
from wraparc.errors import input_error
from wraparc.friction.compact import LIMIT
from wraparc.friction.memory import has_memory
from wraparc.units import display


class Shape(NamedTuple):
    """What of an arc stays the same in time.

    Attributes
    ----------
    width, diameter, length
        B, D and L [m], those of the same arc without thickness, see `wraparc.drive.pitch`; lengths,
        travel and W are along the surface of the lagging.
    shear
        c = h/G [m/Pa].
    overrun_constant, overrun_coefficient
        The overrun is overrun_constant + overrun_coefficient p1^1.5 [m, m/Pa^1.5].
    """

    width: float
    diameter: float
    length: float
    shear: float
    overrun_constant: float
    overrun_coefficient: float

    def overrun(self, pressing: float) -> float:
        """x_c at an entry tension above m v^2 [m]."""
        pressure = max(2.0 / (self.width * self.diameter) * pressing, 0.0)
        return self.overrun_constant + self.overrun_coefficient * pressure * sqrt(pressure)


class Felt(NamedTuple):
    """What friction came to in a step.

    Attributes
    ----------
    exit_slip, exit_stress
        Slip [m] and shear stress [Pa] at the exit nip.
    most_slip, most_stress
        The largest on the wrap, with their signs.
    slip_speed
        Largest speed of slip, either way [m/s].
    """

    exit_slip: float = 0.0
    exit_stress: float = 0.0
    most_slip: float = 0.0
    most_stress: float = 0.0
    slip_speed: float = 0.0


class Pieces(NamedTuple):
    """The pieces on one wrap, from beyond the exit nip to the entry nip; shape (n,) each.

    Attributes
    ----------
    travel, kept, rise
        zeta, n and rho [m].
    slip, stress, tension
        x [m], tau [Pa], T [N].
    """

    travel: Array
    kept: Array
    rise: Array
    slip: Array
    stress: Array
    tension: Array


class Carried(Protocol):
    """What carries the pieces of arcs along."""

    def pieces(self, arc: MovingArc) -> Pieces:
        """Return the pieces on the wrap of an arc."""


@dataclass
class MovingArc:
    """An arc that moves, as one number each; its pieces are in the table of its `wraps`.

    Attributes
    ----------
    arc
        What it is; its tensions do not matter.
    points
        Pieces on the wrap.
    travel, m
        S and m [m].
    entry, exit
        Tensions at the nips [N].
    wrapped
        W = int a T ds over the wrap [m].
    lifted
        int rho ds over the wrap [m2].
    work
        Friction work so far [J].
    slope
        dm/dS of the last roll [-].
    lift
        m v^2 of the belt, at first that of the arc [N].
    give, rise, dry
        What the piece at the nip gets: compliance of belt and lagging recovery [1/N], extra
        radius [m], share of the friction [-].
    nip, moves
        Place of the piece at the entry nip in the table; whether it came there in this step.
    joint
        S where it began to move after it stood [m].
    past_travel, past_kept
        S at the ends of the steps before and what pieces laid there keep [m], the last first.
    felt
        What friction came to in the last step.
    """

    arc: WrapArc
    points: int = 100
    travel: float = 0.0
    m: float = 0.0
    entry: float = field(init=False)
    exit: float = field(init=False)
    wrapped: float = 0.0
    lifted: float = 0.0
    work: float = 0.0
    slope: float = 0.0
    lift: float = field(init=False)
    give: float = field(init=False)
    rise: float = 0.0
    dry: float = 1.0
    nip: int = 0
    moves: bool = False
    joint: float = -inf
    past_travel: list[float] = field(default_factory=list)
    past_kept: list[float] = field(default_factory=list)
    felt: Felt = field(default_factory=Felt)

    def __post_init__(self) -> None:
        arc = self.arc
        _refuse(arc)
        self.entry = self.exit = arc.exit_tension
        self.lift, self.give = arc.centrifugal, arc.compliance
        self.shape, self.spacing = shape_of(arc), arc.length / self.points

    def on(self, wraps: Carried, place: int) -> None:
        """Say which wrap of a table is its own."""
        self.wraps, self.own = wraps, place

    def overrun(self, tension: float) -> float:
        """x_c at an entry tension [m]."""
        return self.shape.overrun(tension - self.lift)

    def place(self) -> Array:
        """Positions on the wrap of the pieces, from the entry nip to the exit nip [m]."""
        s = self.travel - self.wraps.pieces(self).travel[::-1]
        s[-1] = self.shape.length
        return np.asarray(s)

    def along(self, values: Array) -> Array:
        """Values of the pieces at :meth:`place`; the last one is interpolated at the exit nip."""
        s, values = self.travel - self.wraps.pieces(self).travel, np.array(values[::-1])
        w = (self.shape.length - s[1]) / (s[0] - s[1])
        values[-1] = values[-2] + w * (values[-1] - values[-2])
        return values

    def stress(self) -> Array:
        """Shear stress at :meth:`place` [Pa]."""
        return self.along(self.wraps.pieces(self).stress)

    def tension(self) -> Array:
        """Tension at :meth:`place` [N]."""
        return self.along(self.wraps.pieces(self).tension)

    def creep(self) -> Array:
        """Creep u = x + c tau at :meth:`place` [m]."""
        pieces = self.wraps.pieces(self)
        return self.along(pieces.slip) + self.shape.shear * self.along(pieces.stress)

    def rises(self, travel: float) -> tuple[float, float]:
        """Extra radius at the entry and at the exit nip after a travel [m]."""
        pieces = self.wraps.pieces(self)
        (z_d, z_u), (d, u) = pieces.travel[:2].tolist(), pieces.rise[:2].tolist()
        w = (self.shape.length - travel + z_u) / (z_u - z_d)
        return float(pieces.rise[-1]), u + w * (d - u)


def shape_of(arc: WrapArc) -> Shape:
    """Return what of an arc stays the same in time."""
    g = arc.geometry()
    return Shape(
        g.width, 2.0 * g.radius, arc.length, g.shear, g.overrun_constant, g.overrun_coefficient
    )


def _refuse(arc: WrapArc) -> None:
    of = f"{arc.pulley}." if arc.pulley else ""
    where = f"{of}lagging"
    law = arc.law.compact()
    if arc.entry_overrun < 0.0:
        raise input_error(
            key=f"{of}overrun",
            value=display(arc.entry_overrun, "length"),
            message="must be rearward for an event in time",
            remedy='Write overrun = "0 mm".',
        )
    if not has_memory(arc.law):
        raise input_error(
            key=where,
            message="the measured table must be concave from 0",
            remedy="Fit an integral-log law, or smooth it.",
        )
    if law.kind == LIMIT and arc.shear_compliance + law.onset_compliance == 0.0:
        raise input_error(
            key=where,
            message="creep in time is not unique on a rigid lagging without slip",
            remedy="Give thickness and shear modulus.",
        )
