"""Wraps in time: pieces of lagging that are carried along with the belt, of all drums in one table.

Belt laid on a piece of lagging stays laid on it. With m(t) the surface passed less the unstretched
belt fed and n what a piece keeps of it since it passed the nip,

    u(s, t) = m(t) - n - int_0^s a T ds',      dT/ds = -B tau.

The nodes are pieces of lagging; one that has entered is never interpolated. In a wrap the oldest
piece, just beyond the exit nip, comes first, that at the entry nip last; behind it the table is
filled up with pieces like it, of no length, so that all wraps have as many. A step lays as many
pieces as it passes: n of those between its ends is interpolated in travel. At an instant the wraps
are two-point problems, solved by Newton's method, one linear step a call of `sweep`, which gives
every arc as an affine map of m and T_out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.friction.memory import ROOM, Lagging, Past, shorten
from wraparc.motion.arc import MovingArc
from wraparc.motion.two_point import PANEL, Cells, changes

Array = NDArray[np.float64]
Index = NDArray[np.int64]

#: Travel of a step below which a drum stands [m].
STANDS = 1e-10
#: Steps of Newton's method for arcs alone, and how far it goes.
_ITERATIONS, _SETTLED = 40, 1e-10
#: A piece is laid for good once the surface has moved on by so much of a spacing.
_LAID = 0.999
#: Part of the curvature that a trapezium of stress over slip misses, and of a logarithm from 0.
_ALONG, _FROM_NIP = 1.0 / 6.0, 1.0 / 4.0
_SMALL = 1e-6  # of 1 - c K: with less nothing slips
#: Ends of steps before this one that n of the pieces between is interpolated with.
_KNOWN = 2

#: Columns of the table: what a piece is, what it remembers, the iterate, the trial, the rates.
(
    TRAVEL,  # zeta, travel at which it passed the entry nip [m]
    KEPT,  # n [m]
    GIVE,  # a, compliance of belt and lagging recovery [1/N]
    RISE,  # rho, extra radius [m]
    DRY,  # share of the friction that is there: less than 1 on a wet patch [-]
    SLIP, STRESS, SIDE, REACH,  # of the friction: x [m], tau [Pa], direction, largest slip [m]
    TENSION, SHORT,  # T [N], I = int a T ds from the nip [m]
    NEW_SLIP, NEW_STRESS, NEW_SIDE,
    BY_CREEP, BY_TENSION,  # K [Pa/m], P [1/m2]
    BY_M,  # how creep follows m at fixed I [-]
    T_CARRIED, I_CARRIED,  # T, I at the end of the step if nothing but the travel changed them
    T_RATE, I_RATE, T_RATE_0, I_RATE_0,  # what did [N/s, m/s], in the last step and the one before
) = range(23)  # fmt: skip
COLUMNS = 23


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


class Wraps:
    """Moving arcs with their pieces: the only thing in this room that changes; a march owns it.

    Parameters
    ----------
    arcs
        The arcs, all with as many points.
    """

    def __init__(self, arcs: Sequence[MovingArc]) -> None:
        self.arcs = tuple(arcs)
        shapes = np.array([a.shape for a in arcs])
        self.width, diameter, self.length, self.shear = shapes[:, :4].T[:, :, None]
        self.per = 2.0 / (self.width * diameter)
        keys = [(a.arc.law.compact(), a.shape.shear) for a in arcs]
        self.laggings: list[tuple[Lagging, slice]] = []
        for key, group in groupby(range(len(keys)), keys.__getitem__):
            own = list(group)
            self.laggings.append((Lagging(*key), slice(own[0], own[-1] + 1)))
        nodes = PANEL * -(-(max(a.points for a in arcs) + 2) // PANEL) + 1
        self.table = np.zeros((COLUMNS, len(arcs), nodes))
        self.turns = np.zeros((len(arcs), nodes, ROOM))
        self.count = np.zeros((len(arcs), nodes), dtype=np.int64)
        self.new_count = self.count
        self.kept = np.zeros((len(arcs), nodes))  # n without the part that goes with m - x_c
        self.open = self.lays = False
        self.h, self.laid = 1.0, [0] * len(arcs)
        for i, arc in enumerate(arcs):
            arc.on(self, i)
            self.lay_at_rest(arc, arc.exit)

    def lay_at_rest(self, arc: MovingArc, tension: float) -> None:
        """Put fresh pieces under a belt of one tension that has not crept."""
        n = arc.points + 2
        place = arc.travel - arc.spacing * np.arange(n - 1, -1, -1)
        if arc.travel - place[1] >= arc.shape.length:
            place = place[1:]
        arc.nip, arc.moves = len(place) - 1, False
        rows = self.table[:, arc.own]
        rows[:], self.count[arc.own] = 0.0, 0
        rows[TRAVEL], rows[TRAVEL, : len(place)] = arc.travel, place
        rows[GIVE], rows[TENSION], rows[DRY], rows[BY_M] = arc.give, tension, 1.0, 1.0
        rows[SHORT] = arc.give * tension * (arc.travel - rows[TRAVEL])
        rows[KEPT] = arc.m - rows[SHORT]
        arc.entry = arc.exit = tension
        arc.wrapped = arc.give * tension * arc.shape.length
        arc.past_travel, arc.past_kept = [], []

    def pieces(self, arc: MovingArc) -> Pieces:
        """Return the pieces on the wrap of an arc."""
        rows = self.table[:, arc.own, : arc.nip + 1]
        return Pieces(*(rows[c] for c in (TRAVEL, KEPT, RISE, SLIP, STRESS, TENSION)))

    # --- one step, in three parts: begin, sweep and change as often as needed, finish ---

    def begin(self, travels: Sequence[float], h: float = 1.0, onward: float = 1.0) -> None:
        """Begin a step that will end at about these travels [m].

        Parameters
        ----------
        travels
            S at its end, about [m].
        h
            How long it takes [s].
        onward
            Weight of the last change of a rate in the guess of what it will be [-].
        """
        nips = [(a.nip, a.moves) for a in self.arcs]
        self.before = self.table, self.turns, self.count, nips
        self.h, self.open, self.lays = h, False, False
        ends = [t if t - a.travel > STANDS else a.travel for a, t in zip(self.arcs, travels, strict=True)]
        plans = [self._plan(a, end - a.travel) for a, end in zip(self.arcs, ends, strict=True)]
        self._carry(ends, plans)
        for arc, end, (_, fresh, laid) in zip(self.arcs, ends, plans, strict=True):
            if laid:
                self._lay(arc, end, fresh, laid)
        self.laid = [laid for *_, laid in plans]
        self._guess(ends, onward)

    def _plan(self, arc: MovingArc, ahead: float) -> tuple[int, int, int]:
        """Whether the piece at the nip stays, whether a fresh one is put there, how many are laid."""
        if not ahead:
            return 1, 0, 0
        laid = max(round(ahead / arc.spacing), 1)
        if not arc.moves:  # the piece at the nip stood there and remembers: it stays
            kept = float(self.table[KEPT, arc.own, arc.nip])
            jumped = abs(arc.m - kept - arc.shape.overrun(arc.entry))
            arc.joint = arc.travel
            return 1, int(jumped > 1e-9), laid  # old and fresh contact may meet there
        gone = arc.travel - float(self.table[TRAVEL, arc.own, arc.nip - 1])
        return int(laid > 1 or gone >= _LAID * arc.spacing), 0, laid

    def _carry(self, ends: Sequence[float], plans: Sequence[tuple[int, int, int]]) -> None:
        """Drop the pieces that will have left, and make room for those that are laid."""
        wraps, nodes = self.count.shape
        left = (self.table[TRAVEL] <= np.array(ends)[:, None] - self.length).sum(axis=1).tolist()
        drop, last = [], []
        for arc, (stays, fresh, laid), gone in zip(self.arcs, plans, left, strict=True):
            last.append(arc.nip)
            nip = arc.nip - 1 + stays + fresh + laid
            drop.append(max(min(gone - 1, nip - 2), 0))
            arc.nip, arc.moves = nip - drop[-1], laid > 0
        most = max(a.nip for a in self.arcs)
        wide = nodes if most < nodes else PANEL * -(-most // PANEL) + 1
        places = np.minimum(np.array(drop)[:, None] + np.arange(wide), np.array(last)[:, None])
        flat = (places + nodes * np.arange(wraps)[:, None]).ravel()
        self.table = self.table.reshape(COLUMNS, -1).take(flat, axis=1)
        self.table = self.table.reshape(COLUMNS, wraps, wide)
        if self.count.any() or wide > nodes:
            turns = self.turns.reshape(-1, ROOM).take(flat, axis=0)
            self.turns = turns.reshape(wraps, wide, ROOM)
        self.count = self.count.ravel().take(flat).reshape(wraps, wide)
        self.table[BY_M] = 1.0

    def _lay(self, arc: MovingArc, end: float, fresh: int, laid: int) -> None:
        """Make the fresh pieces of a step: those put at the nip as it was, those laid on the way."""
        rows, nip, first = self.table[:, arc.own], arc.nip, arc.nip - laid + 1
        rows[SLIP : REACH + 1, first - fresh :] = 0.0
        self.count[arc.own, first - fresh :] = 0
        if fresh:
            rows[KEPT, first - 1] = arc.m - arc.shape.overrun(arc.entry)
            rows[SHORT, first - 1] = 0.0
        rows[TRAVEL, nip:] = end
        if laid == 1:
            return
        before, (nip_0, moved) = self.before[0][:, arc.own], self.before[3][arc.own]
        z = arc.travel + np.arange(1, laid) / laid * (end - arc.travel)
        rows[TRAVEL, first:nip] = z
        if nip_0 >= laid:  # as pieces so near to the nip were before
            like = slice(nip_0 - laid + 1, nip_0)
            for column in (NEW_SLIP, NEW_STRESS, BY_CREEP, TENSION):
                rows[column, first:nip] = before[column, like]
        if not self.lays:
            self.kept, self.lays = self.table[KEPT].copy(), True
        # n at the ends of steps, interpolated in travel: a part goes with the end of this one
        known = list(zip(arc.past_travel, arc.past_kept, strict=True)) if moved else []
        known = known or [(arc.travel, arc.m - arc.shape.overrun(arc.entry))]
        weights = _lagrange(z, [end, *(s for s, _ in known)])
        self.kept[arc.own, first:nip] = sum(w * n for w, (_, n) in zip(weights[1:], known, strict=True))
        rows[BY_M, first:nip] = 1.0 - weights[0]

    def _guess(self, ends: Sequence[float], onward: float) -> None:
        """Guess the end of a step: what travel carries on, and what else changed, extrapolated."""
        table, h = self.table, self.h
        ahead = np.array([[e - a.travel] for a, e in zip(self.arcs, ends, strict=True)])
        t, i = table[TENSION], table[SHORT]
        self.tension_0 = t.copy()
        i += table[GIVE] * t * ahead
        t -= self.width * table[STRESS] * ahead
        for arc, laid, end in zip(self.arcs, self.laid, ends, strict=True):
            if laid:
                own = arc.own, slice(arc.nip - laid + 1, None)
                i[own] = table[GIVE][own] * t[own] * (end - table[TRAVEL][own])
        table[T_CARRIED], table[I_CARRIED] = t, i
        t += h * (table[T_RATE] + onward * (table[T_RATE] - table[T_RATE_0]))
        np.maximum(t, np.array([[0.1 * a.exit] for a in self.arcs]), out=t)
        i += h * (table[I_RATE] + onward * (table[I_RATE] - table[I_RATE_0]))

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
            self._come(arc, end)
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

    def _come(self, arc: MovingArc, end: float) -> None:
        """Bring the nip of an arc to a travel; a piece that has left on the way goes."""
        rows = self.table[:, arc.own]
        if arc.moves:
            rows[TRAVEL, arc.nip :] = end
        while arc.nip > 2 and end - rows[TRAVEL, 1] >= arc.shape.length:
            rows[:, :-1] = rows[:, 1:].copy()
            own = self.turns[arc.own], self.count[arc.own]
            for values in (*own, self.kept[arc.own]) if self.lays else own:
                values[:-1] = values[1:].copy()
            arc.nip -= 1

    def _rub(self, m: Array) -> list[float]:
        """Find stress and slip of every piece, with slopes; those of the overruns by T_in."""
        table = self.table
        pressure = np.maximum(table[TENSION] * self.per, 1.0)
        if self.lays:
            x_c = [a.shape.overrun(float(table[TENSION, a.own, -1])) for a in self.arcs]
            table[KEPT] = self.kept + (1.0 - table[BY_M]) * (m - np.array(x_c)[:, None])
        creep = m - table[KEPT] - table[SHORT]
        by_t = []
        for arc in self.arcs:
            p, shape = float(pressure[arc.own, -1]), arc.shape
            root = p**0.5
            by_t.append(1.5 * shape.kick_coefficient * root * float(self.per[arc.own, 0]))
            if arc.moves:
                creep[arc.own, arc.nip :] = shape.kick + shape.kick_coefficient * p * root
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
            self.new_count[own] = at.count.reshape(shape)
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
                x_c = arc.shape.overrun(float(t[arc.own, -1]))
                at = arc.own, slice(arc.nip, None)
                du[at] = x_c - table[NEW_SLIP][at] - arc.shape.shear * table[NEW_STRESS][at]
        table[NEW_STRESS] += dtau
        table[NEW_SLIP] += du - self.shear * dtau
        self.open = False
        return worst

    def undo(self) -> None:
        """Go back to before the step that was begun; the next one is guessed without rates."""
        self.table, self.turns, self.count, nips = self.before
        for arc, (nip, moves) in zip(self.arcs, nips, strict=True):
            arc.nip, arc.moves = nip, moves
        self.table[T_RATE : I_RATE_0 + 1] = 0.0
        self.open = self.lays = False

    def finish(self, m: Sequence[float], exits: Sequence[float]) -> None:
        """Take the step for good."""
        if self.open:
            self.change(m, exits)
        entries = []
        for arc, out, m1, t1, m0, t0 in zip(
            self.arcs, self.found, m, exits, *self.given, strict=True
        ):
            dm, dx = m1 - m0, t1 - t0
            arc.entry = out.entry + out.entry_m * dm + out.entry_x * dx
            arc.wrapped = out.wrapped + out.wrapped_m * dm + out.wrapped_x * dx
            arc.lifted = out.lifted
            entries.append(m1 - arc.shape.overrun(arc.entry))
        table = self.table
        if self.lays:
            table[KEPT] = self.kept + (1.0 - table[BY_M]) * np.array(entries)[:, None]
        self._keep()
        for arc, m1, t1, end, kept in zip(self.arcs, m, exits, self.to, entries, strict=True):
            if arc.moves:
                table[KEPT, arc.own, arc.nip :] = kept
                known = min(len(arc.past_travel) + 1, _KNOWN) if self.before[3][arc.own][1] else 1
                arc.past_travel = [end, *arc.past_travel][: known]
                arc.past_kept = [kept, *arc.past_kept][: known]
            arc.travel, arc.m, arc.exit = end, m1, t1

    def _keep(self) -> None:
        """Take the trial of the pieces for good, and what friction came to."""
        table, h = self.table, self.h
        slid, began = table[NEW_SLIP] - table[SLIP], table[STRESS].copy()
        fastest, bend = slid.copy(), np.full(slid.shape, _ALONG)
        pulled = table[TENSION] - self.tension_0
        table[T_RATE_0 :] = table[T_RATE : T_RATE_0]
        table[T_RATE] = (table[TENSION] - table[T_CARRIED]) / h
        table[I_RATE] = (table[SHORT] - table[I_CARRIED]) / h
        for arc, laid in zip(self.arcs, self.laid, strict=True):
            if laid:  # what was laid in this step slips on from the overrun
                new = arc.own, slice(arc.nip - laid + 1, None)
                slid[new] = table[NEW_SLIP][new] - table[NEW_SLIP, arc.own, -1]
                pulled[new] = table[TENSION][new] - table[TENSION, arc.own, -1]
                began[new], fastest[new] = table[NEW_STRESS, arc.own, -1], 0.0
                bend[new] = _FROM_NIP
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
        z, length = table[TRAVEL], self.length[:, 0]
        dz = z[:, 1:] - z[:, :-1]
        begins = np.array([a.travel for a in self.arcs])
        ends = np.array(self.to)
        # what leaves on the way works half of it
        f = (length - 0.5 * (begins + ends) + z[:, 1]) / dz[:, 0]
        work = f * dz[:, 0] * (done[:, 1] + 0.5 * f * (done[:, 0] - done[:, 1]))
        work += 0.5 * (dz[:, 1:] * (done[:, 1:-1] + done[:, 2:])).sum(axis=1)
        # trapezia miss how steeply work rises to the exit, and so does half a step
        ahead = ends - begins
        work -= (ahead**2 / 24.0 + dz[:, 0] ** 2 / 12.0) * (done[:, 0] - done[:, 1]) / dz[:, 0]
        f = (length - ends + z[:, 1]) / dz[:, 0]
        # over the step a piece was as fast as pieces are half of it further back
        back = [max(laid // 2, 1) for laid in self.laid]
        own = np.arange(len(self.arcs))
        along = (fastest[:, 0] - fastest[own, back]) / (z[own, back] - z[:, 0])
        at_exit = fastest[:, 1] + f * (fastest[:, 0] - fastest[:, 1]) + 0.5 * ahead * along
        felt = [np.maximum(np.abs(fastest[:, 1:]).max(axis=1), np.abs(at_exit)) / h]
        for value in (table[STRESS], table[SLIP]):
            at_exit = value[:, 1] + f * (value[:, 0] - value[:, 1])
            most = np.take_along_axis(value, _largest(value[:, 1:])[:, None] + 1, 1)[:, 0]
            felt += [np.where(np.abs(most) > np.abs(at_exit), most, at_exit), at_exit]
        for arc, done_, (speed, stress, exit_stress, slip, exit_slip) in zip(
            self.arcs, (work * self.width[:, 0]).tolist(), np.array(felt).T.tolist(), strict=True
        ):
            arc.work += done_
            arc.felt = exit_slip, exit_stress, slip, stress, speed

    def at_nip(self, arc: MovingArc, rise: float, give: float, dry: float) -> None:
        """Say what belt and lagging are like at the nip; between the ends of a step, in between."""
        laid = self.laid[arc.own]
        for column, old, new in (
            (GIVE, arc.give, give), (RISE, arc.rise, rise), (DRY, arc.dry, dry)
        ):
            row = self.table[column, arc.own]
            row[arc.nip :] = new
            if laid > 1:
                row[arc.nip - laid + 1 : arc.nip] = old + np.arange(1, laid) / laid * (new - old)

    # --- with the tensions at both nips held, nothing depends on time ---

    def roll(
        self, aheads: Sequence[float], entries: Sequence[float], exits: Sequence[float]
    ) -> None:
        """Travel on with given tensions at both nips [N].

        Raises
        ------
        ArithmeticError
            If there is no creep with which an arc holds them; it tells the place of the arc.
        """
        arcs = self.arcs
        travels = [a.travel + ahead for a, ahead in zip(arcs, aheads, strict=True)]
        # a belt that does not creep is laid on stretched
        m = [
            a.m + (a.slope or a.give * entry) * ahead
            for a, ahead, entry in zip(arcs, aheads, entries, strict=True)
        ]
        self.begin(travels)
        for _ in range(_ITERATIONS):
            steps = [
                (entry - out.entry) / out.entry_m if out.entry_m else np.inf
                for out, entry in zip(self.sweep(travels, m, exits), entries, strict=True)
            ]
            for arc, dm in zip(arcs, steps, strict=True):
                if not abs(dm) < 0.1:
                    raise ArithmeticError(arc.own)
            m = [a + dm for a, dm in zip(m, steps, strict=True)]
            worst = self.change(m, exits)
            open_ = [
                a.own for a, dm, w in zip(arcs, steps, worst, strict=True)
                if w >= _SETTLED or abs(dm) >= 1e-14 + 1e-9 * a.spacing
            ]  # fmt: skip
            if not open_:
                break
        else:
            raise ArithmeticError(open_[0])
        for arc, m1, ahead in zip(arcs, m, aheads, strict=True):
            arc.slope = (m1 - arc.m) / ahead if ahead > STANDS else 0.0
        self.finish(m, exits)

    def settle(
        self, entries: Sequence[float], exits: Sequence[float], wraps: float = 3.0
    ) -> None:
        """Bring the arcs into their steady state between two tensions each."""
        spacings = [a.spacing for a in self.arcs]
        for i in range(1, 21):  # the pull is put on little by little while the belt travels
            put_on = [x + (t - x) * i / 20.0 for t, x in zip(entries, exits, strict=True)]
            self.roll([2.0 * s for s in spacings], put_on, exits)
        for _ in range(int(wraps * self.arcs[0].points)):
            self.roll(spacings, entries, exits)
        for arc in self.arcs:
            arc.work = 0.0


def _largest(values: Array) -> Index:
    """Place of the largest of every row, either way."""
    return np.abs(values).argmax(axis=1)


def _lagrange(z: Array, ends: Sequence[float]) -> list[Array]:
    """Weights at z of values at some ends: the polynomial through all of them."""
    weights = []
    for s in ends:
        weight = np.ones(len(z))
        for o in ends:
            if o != s:
                weight = weight * (z - o) / (s - o)
        weights.append(weight)
    return weights
