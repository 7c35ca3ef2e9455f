"""Wraps in time: the arcs of all drums at an instant, and what friction does on them.

Belt laid on a piece of lagging stays laid on it. With m(t) the surface passed less the unstretched
belt fed and n what a piece keeps of it since it passed the nip,

    u(s, t) = m(t) - n - int_0^s a T ds',      dT/ds = -B tau.

At an instant the wraps are two-point problems, solved by Newton's method, one linear step a call of
`sweep`, which gives every arc as an affine map of m and T_out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array
from wraparc.friction.memory import ROOM, Lagging, Past, shorten
from wraparc.motion.arc import Felt, MovingArc
from wraparc.motion.pieces import (
    BY_CREEP,
    BY_M,
    BY_TENSION,
    DRY,
    GIVE,
    I_CARRIED,
    I_RATE,
    KEPT,
    NEW_SIDE,
    NEW_SLIP,
    NEW_STRESS,
    REACH,
    RISE,
    SHORT,
    SIDE,
    SLIP,
    STRESS,
    T_CARRIED,
    T_RATE,
    T_RATE_0,
    TENSION,
    TRAVEL,
    Table,
)  # fmt: skip
from wraparc.motion.two_point import Cells, changes

#: Part of the curvature that a trapezium of stress over slip misses, and of a logarithm from 0.
_ALONG, _FROM_NIP = 1.0 / 6.0, 1.0 / 4.0
_SMALL = 1e-6  # of 1 - c K: with less nothing slips


class Found(NamedTuple):
    """An arc as an affine map of m and T_out about the values that were given.

    Attributes
    ----------
    entry, entry_m, entry_x
        T_in [N], and its slopes by m [N/m] and T_out [-].
    wrapped, wrapped_m, wrapped_x
        W = int a T ds [m], and its slopes.
    lifted
        int rho ds [m2].
    """

    entry: float
    entry_m: float
    entry_x: float
    wrapped: float
    wrapped_m: float
    wrapped_x: float
    lifted: float


class Wraps(Table):
    """Moving arcs: a step is begun, swept and changed as often as needed, and finished."""

    def __init__(self, arcs: Sequence[MovingArc]) -> None:
        super().__init__(arcs)
        diameter, self.shear = (
            np.array([[getattr(a.shape, key)] for a in arcs]) for key in ("diameter", "shear")
        )
        self.per = 2.0 / (self.width * diameter)
        self.whole_width = np.array([a.arc.width for a in arcs])  # that friction works on [m]
        self.new_count = self.count
        keys = [(a.arc.law.compact(), a.shape.shear) for a in arcs]
        self.laggings: list[tuple[Lagging, slice]] = []
        for key, group in groupby(range(len(keys)), keys.__getitem__):
            own = list(group)
            self.laggings.append((Lagging(*key), slice(own[0], own[-1] + 1)))

    def sweep(
        self, travels: Sequence[float], m: Sequence[float], exits: Sequence[float]
    ) -> list[Found]:
        """One step of Newton's method for the end of the step: the arcs as affine maps.

        Parameters
        ----------
        travels, m, exits
            S, m [m] and T_out [N] of every arc.

        Raises
        ------
        numpy.linalg.LinAlgError
            If an arc has no change that would solve it.
        """
        if self.open:
            self.change(m, exits)
        self.given, self.open = (tuple(m), tuple(exits)), True
        self.to = [t if a.moves else a.travel for a, t in zip(self.arcs, travels, strict=True)]
        for arc, end in zip(self.arcs, self.to, strict=True):
            self.come(arc, end)
        table = self.table
        by_t = self._rub(np.array(m)[:, None])
        for arc, slope in zip(self.arcs, by_t, strict=True):
            if arc.moves:  # at the nip creep is the overrun
                nip = arc.own, slice(arc.nip, None)
                table[BY_TENSION][nip] += table[BY_CREEP][nip] * slope
                table[BY_CREEP][nip] = 0.0
        z, a = table[TRAVEL], table[GIVE]
        dz = z[:, 1:] - z[:, :-1]
        cells = Cells(
            0.5 * self.width * dz, 0.5 * dz * a[:, :-1], 0.5 * dz * a[:, 1:],
            table[NEW_STRESS], table[BY_CREEP], table[BY_TENSION], table[BY_M],
            table[TENSION], table[SHORT],
        )  # fmt: skip
        out = np.array(exits)
        inside = (self.length[:, 0] - np.array(self.to) + z[:, 1]) / dz[:, 0]
        self.by_t, self.by_i = changes(cells, out, inside)
        self.found = self._answers(cells, dz, inside, out)
        return self.found

    def _rub(self, m: Array) -> list[float]:
        """Find stress and slip of every piece, with slopes; those of the overruns by T_in."""
        table = self.table
        lift = np.array([[a.lift] for a in self.arcs])
        pressure = np.maximum((table[TENSION] - lift) * self.per, 1.0)
        if self.lays:
            x_c = [a.overrun(float(table[TENSION, a.own, -1])) for a in self.arcs]
            table[KEPT] = self.kept + (1.0 - table[BY_M]) * (m - np.array(x_c)[:, None])
        creep = m - table[KEPT] - table[SHORT]
        by_t = []
        for arc in self.arcs:
            p, shape = float(pressure[arc.own, -1]), arc.shape
            root = p**0.5
            by_t.append(1.5 * shape.overrun_coefficient * root * float(self.per[arc.own, 0]))
            if arc.moves:
                creep[arc.own, arc.nip :] = (
                    shape.overrun_constant + shape.overrun_coefficient * p * root
                )
        slip, stress = table[NEW_SLIP], table[NEW_STRESS]
        near = slip + (1.0 - self.shear * table[BY_CREEP]) * (creep - slip - self.shear * stress)
        self.new_count = np.zeros_like(self.count)
        for lagging, own in self.laggings:
            past = Past(
                self.turns[own].reshape(-1, ROOM), self.count[own].ravel(),
                *(table[c, own].ravel() for c in (SIDE, SLIP, STRESS, REACH, DRY)),
            )  # fmt: skip
            at = lagging.moved(creep[own].ravel(), pressure[own].ravel(), past, near[own].ravel())
            shape = creep[own].shape
            for column, values in zip((NEW_SLIP, NEW_STRESS, BY_CREEP), at[:3], strict=True):
                table[column, own] = values.reshape(shape)
            table[BY_TENSION, own] = at.by_pressure.reshape(shape)
            table[NEW_SIDE, own] = at.side.reshape(shape)
            self.new_count[own] = at.held.reshape(shape)
        table[BY_TENSION] *= self.per
        return by_t

    def _answers(self, cells: Cells, dz: Array, inside: Array, out: Array) -> list[Found]:
        """The arcs as affine maps; the exit nip lies inside the first cell."""
        table, f = self.table, inside
        t, i, rise = table[TENSION], table[SHORT], table[RISE]
        up, d0 = f * cells.half_give_u[:, 0], dz[:, 0]
        a_d, a_u = table[GIVE, :, 0], table[GIVE, :, 1]
        over = 0.5 * f * d0 * (a_u + f * (a_d - a_u))
        found = np.zeros((7, len(self.arcs)))
        found[:3], found[3:6] = self.by_t[:, :, -1], self.by_i[:, :, 1] + up * self.by_t[:, :, 1]
        found[0] += t[:, -1]
        found[3] += i[:, 1] + over * out + up * t[:, 1]
        found[5] += over
        if rise.any():
            found[6] = 0.5 * (dz[:, 1:] * (rise[:, 1:-1] + rise[:, 2:])).sum(axis=1)
            found[6] += 0.5 * f * d0 * (2.0 * rise[:, 1] + f * (rise[:, 0] - rise[:, 1]))
        return [Found(*row) for row in found.T.tolist()]

    def change(self, m: Sequence[float], exits: Sequence[float]) -> list[float]:
        """Change tensions and creep as the sweep found, for m and T_out; the largest dT/T each."""
        table = self.table
        dm, dx = (
            np.array(new)[:, None] - np.array(given)[:, None]
            for new, given in zip((m, exits), self.given, strict=True)
        )
        t = table[TENSION]
        dt = self.by_t[0] + self.by_t[1] * dm + self.by_t[2] * dx
        di = self.by_i[0] + self.by_i[1] * dm + self.by_i[2] * dx
        worst: list[float] = (np.abs(dt) / t).max(axis=1).tolist()
        # a step far off the solution may not leave the belt without tension
        dt = np.maximum(dt, -0.8 * t)
        t += dt
        table[SHORT] += di
        # the trial follows to first order
        du = table[BY_M] * dm - di
        dtau = table[BY_TENSION] * dt + table[BY_CREEP] * du
        for arc in self.arcs:
            if arc.moves:
                x_c = arc.overrun(float(t[arc.own, -1]))
                at = arc.own, slice(arc.nip, None)
                du[at] = x_c - table[NEW_SLIP][at] - arc.shape.shear * table[NEW_STRESS][at]
        table[NEW_STRESS] += dtau
        table[NEW_SLIP] += du - self.shear * dtau
        self.open = False
        return worst

    def finish(self, m: Sequence[float], exits: Sequence[float]) -> None:
        """Take the step for good."""
        if self.open:
            self.change(m, exits)
        kept = []
        for arc, out, m1, t1, m0, t0 in zip(
            self.arcs, self.found, m, exits, *self.given, strict=True
        ):
            dm, dx = m1 - m0, t1 - t0
            arc.entry = out.entry + out.entry_m * dm + out.entry_x * dx
            arc.wrapped = out.wrapped + out.wrapped_m * dm + out.wrapped_x * dx
            arc.lifted = out.lifted
            kept.append(m1 - arc.overrun(arc.entry))
        if self.lays:
            self.table[KEPT] = self.kept + (1.0 - self.table[BY_M]) * np.array(kept)[:, None]
        self._take()
        for arc, m1, t1, end, own in zip(self.arcs, m, exits, self.to, kept, strict=True):
            if arc.moves:
                self.remember(arc, own)
            arc.travel, arc.m, arc.exit = end, m1, t1

    def _take(self) -> None:
        """Take the trial of the pieces for good, and what friction came to."""
        table, h = self.table, self.h
        table[T_RATE_0:] = table[T_RATE:T_RATE_0]
        table[T_RATE] = (table[TENSION] - table[T_CARRIED]) / h
        table[I_RATE] = (table[SHORT] - table[I_CARRIED]) / h
        slid, began = table[NEW_SLIP] - table[SLIP], table[STRESS].copy()
        pulled, bend = table[TENSION] - self.tension_0, np.full(slid.shape, _ALONG)
        fast = slid.copy()
        for arc, laid in zip(self.arcs, self.laid, strict=True):
            if laid:  # what was laid in this step slips on from the overrun
                new = arc.own, slice(arc.nip - laid + 1, None)
                slid[new] -= slid[arc.own, -1]
                pulled[new] = table[TENSION][new] - table[TENSION, arc.own, -1]
                began[new], bend[new], fast[new] = table[NEW_STRESS, arc.own, -1], _FROM_NIP, 0.0
                table[T_RATE][new], table[I_RATE][new] = table[T_RATE, arc.own, -1], 0.0
        # stress against slip is curved: by how much tells its tangent at the end
        stiff, gain = table[BY_CREEP], table[NEW_STRESS] - began
        ease = np.maximum(1.0 - self.shear * stiff, _SMALL)
        curved = gain - (table[BY_TENSION] * pulled + stiff * slid) / ease
        done = (0.5 * (began + table[NEW_STRESS]) + bend * curved) * slid
        table[SLIP : SIDE + 1] = table[NEW_SLIP : NEW_SIDE + 1]
        np.maximum(table[REACH], np.abs(table[SLIP]), out=table[REACH])
        self.count = self.new_count
        if self.count.any():
            shorten(self.turns.reshape(-1, ROOM), self.count.reshape(-1))
        self._tell(done, fast)

    def _tell(self, done: Array, fast: Array) -> None:
        """Add up the work of the pieces, done [J/m2]; say what slips most, and how fast [m]."""
        z, arcs = self.table[TRAVEL], self.arcs
        dz, end = z[:, 1:] - z[:, :-1], np.array(self.to)
        ahead, d0 = end - np.array([a.travel for a in arcs]), z[:, 1] - z[:, 0]
        inside = (self.length[:, 0] - end + z[:, 1]) / d0
        # what leaves on the way works half of it
        f = inside + 0.5 * ahead / d0
        work = f * d0 * (done[:, 1] + 0.5 * f * (done[:, 0] - done[:, 1]))
        work += 0.5 * (dz[:, 1:] * (done[:, 1:-1] + done[:, 2:])).sum(axis=1)
        # trapezia miss how steeply work rises to the exit, and so does half a step
        work -= (ahead**2 / 24.0 + d0**2 / 12.0) * (done[:, 0] - done[:, 1]) / d0
        # over the step a piece was as fast as pieces are half of it further back
        own, back = np.arange(len(arcs)), [max(laid // 2, 1) for laid in self.laid]
        along = (fast[:, 0] - fast[own, back]) / (z[own, back] - z[:, 0])
        leaves = fast[:, 1] + inside * (fast[:, 0] - fast[:, 1]) + 0.5 * ahead * along
        speed = np.maximum(np.abs(fast[:, 1:]).max(axis=1), np.abs(leaves)) / self.h
        told = [work * self.whole_width, speed]
        for value in (self.table[SLIP], self.table[STRESS]):
            at_exit = value[:, 1] + inside * (value[:, 0] - value[:, 1])
            most = value[own, 1 + np.abs(value[:, 1:]).argmax(axis=1)]
            told += [at_exit, np.where(np.abs(most) > np.abs(at_exit), most, at_exit)]
        for arc, row in zip(arcs, np.array(told).T.tolist(), strict=True):
            arc.work += row[0]
            arc.felt = Felt(row[2], row[4], row[3], row[5], row[1])
