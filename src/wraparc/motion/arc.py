"""One arc in time: the pieces of lagging on the wrap, carried along with the belt."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import WrapArc
from wraparc.batch.native import available, compiled
from wraparc.errors import InputError, Problem
from wraparc.friction.compact import LIMIT
from wraparc.friction.memory import ROOM, has_memory
from wraparc.motion import arc_kernel as k
from wraparc.units import display

Array = NDArray[np.float64]

#: Travel of a step below which a drum stands [m].
STANDS = 1e-10
#: Steps of Newton's method for one arc alone, and how far it goes.
_ITERATIONS, _SETTLED = 40, 1e-10


@dataclass
class MovingArc:
    """An arc that moves: its pieces, what they remember, and where Newton's method stands.

    The only thing in this room that changes: a march owns its arcs.

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
    give, rise, dry
        What the piece at the nip gets: compliance of belt and lagging recovery [1/N], extra
        radius [m], share of the friction [-].
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
    give: float = field(init=False)
    rise: float = 0.0
    dry: float = 1.0

    def __post_init__(self) -> None:
        arc = self.arc
        _refuse(arc)
        self.entry = self.exit = arc.exit_tension
        self.give = arc.compliance
        self.shape, self.spacing = shape_of(arc), arc.length / self.points
        self.what, *law = numbers_of(arc, self.spacing)
        room = 6 * self.points + 40
        self.rows = np.zeros((room, k.COLUMNS))
        self.turns = np.zeros(room * ROOM)
        self.counts = np.zeros(room, dtype=np.int64)
        self.span = np.zeros(3, dtype=np.int64)
        self.out = np.zeros(k.ANSWERS)
        self.tables = (self.what, *law, self.rows, self.turns, self.counts, self.span)
        fast = available()
        self._sweep: Any = compiled(k.sweep) if fast else k.sweep
        self._change: Any = compiled(k.change) if fast else k.change
        self._keep: Any = compiled(k.keep) if fast else k.keep
        self.open, self.begun, self.ahead, self.h = False, False, 0.0, 1.0
        self.given, self.to = (0.0, 0.0), 0.0
        self.lay_at_rest(arc.exit_tension)

    def lay_at_rest(self, tension: float) -> None:
        """Put fresh pieces under a belt of one tension that has not crept."""
        n = self.points + 2
        self.rows[:], self.counts[:] = 0.0, 0
        place = self.travel - self.spacing * np.arange(n - 1, -1, -1)
        self.rows[:n, k.TRAVEL], self.rows[:n, k.GIVE] = place, self.give
        self.rows[:n, k.TENSION], self.rows[:n, k.DRY] = tension, 1.0
        self.rows[:n, k.SHORT] = self.give * tension * (self.travel - place)
        self.rows[:n, k.KEPT] = self.m - self.rows[:n, k.SHORT]
        beyond = self.travel - place[1] >= self.shape.length
        self.span[:] = int(beyond), n - 1, 0
        self.out[:] = 0.0
        self.entry = self.exit = tension
        self.wrapped = self.give * tension * self.shape.length

    # --- one step, in three parts: begin, sweep and change as often as needed, finish ---

    def begin(self, travel: float, h: float = 1.0) -> None:
        """Begin a step of h [s] that will end at about a travel [m]."""
        ahead = travel - self.travel
        moving = ahead > STANDS
        nip = int(self.span[1])
        if nip + 3 >= len(self.rows):
            nip = self._shift()
        if moving and not self.span[2]:  # the piece at the nip stood there and remembers: it stays
            jumped = abs(self.m - self.rows[nip, k.KEPT] - self.overrun(self.entry))
            for _ in range(2 if jumped > 1e-9 else 1):  # old and fresh contact may meet there
                nip += 1
                self._fresh(nip, self.m - self.overrun(self.entry), nip - 1)
            self.span[1] = nip
        self.span[2] = int(moving)
        self.ahead, self.h, self.begun = ahead if moving else 0.0, h, True

    def sweep(self, travel: float, m: float, exit_tension: float) -> list[float]:
        """One Newton step for the end of the step; see :mod:`wraparc.motion.arc_kernel`."""
        if self.open:
            self.change(m, exit_tension)
        self.to = travel if self.span[2] else self.travel
        self.given = m, exit_tension
        first = (self.ahead, self.h) if self.begun else (0.0, 0.0)
        self._sweep(*self.tables, self.out, self.to, m, exit_tension, *first)
        self.begun, self.open = False, True
        self.found: list[float] = self.out.tolist()
        return self.found

    def change(self, m: float, exit_tension: float) -> float:
        """Change tensions and creep as the sweep found, for m and T_out; the largest dT/T."""
        at = self.given
        worst: float = self._change(
            self.what, self.rows, self.span, m - at[0], exit_tension - at[1]
        )
        self.open = False
        return worst

    def undo(self) -> None:
        """Go back to before the step that was begun; the next one is guessed without rates."""
        if self.begun:  # it was not swept
            return
        part = self.rows[self.span[0] : self.span[1] + 1]
        ahead = self.ahead
        part[:, k.TENSION] = part[:, k.T_CARRIED] + self.shape.width * part[:, k.STRESS] * ahead
        part[:, k.SHORT] = part[:, k.I_CARRIED] - part[:, k.GIVE] * part[:, k.TENSION] * ahead
        part[:, k.T_RATE : k.I_RATE_0 + 1] = 0.0
        if self.span[2]:
            part[-1, k.SHORT] = 0.0
        self.open = False

    def finish(self, m: float, exit_tension: float) -> None:
        """Take the step for good."""
        if self.open:
            self.change(m, exit_tension)
        out, at = self.found, self.given
        dm, dx = m - at[0], exit_tension - at[1]
        self.entry = out[k.IN] + out[k.IN_M] * dm + out[k.IN_X] * dx
        self.wrapped = out[k.WRAPPED] + out[k.WRAPPED_M] * dm + out[k.WRAPPED_X] * dx
        self.lifted = out[k.LIFTED]
        if self.span[2]:
            self.at_nip(self.give, self.rise, self.dry)
        self.work += self._keep(
            self.what, self.rows, self.turns, self.counts, self.span, self.out,
            self.travel, self.to, m, self.entry, self.h,
        )  # fmt: skip
        self.travel, self.m, self.exit = self.to, m, exit_tension

    def at_nip(self, give: float, rise: float, dry: float) -> None:
        """Say what the belt and the lagging at the nip are like."""
        row = self.rows[self.span[1]]
        row[k.GIVE], row[k.RISE], row[k.DRY] = give, rise, dry

    # --- with the tensions at both nips held, nothing depends on time ---

    def roll(self, ahead: float, entry: float, exit_tension: float) -> None:
        """Travel on with given tensions at both nips [N].

        Raises
        ------
        ArithmeticError
            If there is no creep with which the arc holds them.
        """
        self.begin(self.travel + ahead)
        # a belt that does not creep is laid on stretched
        rate = self.slope or self.give * entry
        m, travel = self.m + rate * ahead, self.travel + ahead
        for _ in range(_ITERATIONS):
            out = self.sweep(travel, m, exit_tension)
            dm = (entry - out[k.IN]) / out[k.IN_M] if out[k.IN_M] != 0.0 else np.inf
            if not abs(dm) < 0.1:
                raise ArithmeticError
            m += dm
            settled = self.change(m, exit_tension) < _SETTLED
            if settled and abs(dm) < 1e-14 + 1e-9 * self.spacing:
                break
        else:
            raise ArithmeticError
        self.slope = (m - self.m) / ahead if ahead > STANDS else 0.0
        self.finish(m, exit_tension)

    def settle(self, entry: float, exit_tension: float, wraps: float = 3.0) -> None:
        """Bring the arc into its steady state between two tensions."""
        for i in range(1, 21):  # the pull is put on little by little while the belt travels
            self.roll(
                2.0 * self.spacing, exit_tension + (entry - exit_tension) * i / 20.0, exit_tension
            )
        for _ in range(int(wraps * self.points)):
            self.roll(self.spacing, entry, exit_tension)
        self.work = 0.0

    # --- what it is like ---

    def overrun(self, tension: float) -> float:
        """x_c at an entry tension [m]."""
        return k.overrun(self.what, tension)

    def place(self) -> Array:
        """Positions on the wrap of the pieces, from the entry nip to the exit nip [m]."""
        part = self.rows[self.span[0] : self.span[1] + 1]
        s = self.travel - part[::-1, k.TRAVEL]
        s[-1] = self.shape.length
        return np.asarray(s)

    def along(self, column: int) -> Array:
        """Values at :meth:`place`; the last one is interpolated at the exit nip."""
        part = self.rows[self.span[0] : self.span[1] + 1][::-1]
        values = np.array(part[:, column])
        s = self.travel - part[:, k.TRAVEL]
        w = (self.shape.length - s[-2]) / (s[-1] - s[-2])
        values[-1] = values[-2] + w * (values[-1] - values[-2])
        return values

    def creep(self) -> Array:
        """Creep u = x + c tau at :meth:`place` [m]."""
        return self.along(k.SLIP) + self.shape.shear * self.along(k.STRESS)

    # --- housekeeping ---

    def _fresh(self, j: int, kept: float, like: int) -> None:
        row = self.rows[j]
        tension = self.rows[j - 1, k.TENSION] if row[k.TENSION] == 0.0 else row[k.TENSION]
        rates = self.rows[like, k.T_RATE], self.rows[like, k.T_RATE_0]
        row[:] = 0.0
        row[k.T_RATE], row[k.T_RATE_0] = rates
        row[k.TENSION], row[k.KEPT], row[k.TRAVEL] = tension, kept, self.travel
        row[k.GIVE], row[k.RISE], row[k.DRY] = self.give, self.rise, self.dry
        self.counts[j] = 0

    def _shift(self) -> int:
        first, nip = int(self.span[0]), int(self.span[1])
        n = nip - first + 1
        for table in (self.rows, self.turns.reshape(-1, ROOM), self.counts):
            table[:n] = table[first : nip + 1].copy()
        self.rows[n:, k.TENSION] = 0.0
        self.span[0], self.span[1] = 0, n - 1
        return n - 1


def numbers_of(arc: WrapArc, spacing: float) -> tuple[Array, Array, Array, Array]:
    """Return law, shape and spacing of an arc in arrays; see `arc_kernel.arc_of`."""
    law = arc.law.compact()
    what = np.array([law.kind, law.onset_compliance, *shape_of(arc), spacing], dtype=float)
    edges, coefficients, slips = (
        np.array(v, dtype=float) for v in (law.edges, law.coefficients, law.slips)
    )
    return what, edges, coefficients, slips


def shape_of(arc: WrapArc) -> k.Shape:
    """Return what of an arc stays the same in time."""
    g = arc.geometry()
    return k.Shape(arc.width, arc.diameter, arc.length, g.shear, g.kick, g.kick_coefficient)


def _refuse(arc: WrapArc) -> None:
    of = f"{arc.pulley}." if arc.pulley else ""
    where = f"{of}lagging"
    law = arc.law.compact()
    if arc.entry_overrun < 0.0:
        raise InputError(
            Problem(
                key=f"{of}overrun",
                value=display(arc.entry_overrun, "length"),
                message="is towards travel: slip then turns just behind the entry nip of a driving "
                "pulley, and no step in time follows that reliably",
                remedy='Set overrun = "0 mm" for what happens in time, or give it rearward.',
            )
        )
    if not has_memory(arc.law):
        raise InputError(
            Problem(
                key=where,
                message="the measured table does not rise from 0 along a concave curve, so that "
                "its unloading is not known",
                remedy="Fit an integral-log law to it, or smooth it.",
            )
        )
    if law.kind == LIMIT and arc.shear_compliance + law.onset_compliance == 0.0:
        raise InputError(
            Problem(
                key=where,
                message="friction that holds without slip on a lagging that does not shear has no "
                "unique creep in time",
                remedy="Give the thickness and the shear modulus of the lagging.",
            )
        )
