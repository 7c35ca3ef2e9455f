"""The pieces of lagging on moving wraps, of all drums in one table, and how they travel.

In a wrap the oldest piece, just beyond the exit nip, comes first, that at the entry nip last;
behind it the table is filled up with pieces like it, of no length, so that all wraps have as many.
One that has entered is never interpolated. A step lays as many pieces as it passes: what those
between its ends keep is interpolated in travel.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array
from wraparc.friction.memory import ROOM
from wraparc.motion.arc import MovingArc, Pieces
from wraparc.motion.two_point import PANEL

#: Travel of a step below which a drum stands [m].
STANDS = 1e-10
#: A piece is laid for good once the surface has moved on by so much of a spacing.
_LAID = 0.999
#: Ends of steps before this one that n of the pieces between is interpolated with.
_KNOWN = 2
#: Part of a step that such an end must lie before its beginning.
_APART = 0.05

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


class Table:
    """The pieces of some moving arcs: the only thing in this room that changes; a march owns it.

    Parameters
    ----------
    arcs
        The arcs.
    """

    def __init__(self, arcs: Sequence[MovingArc]) -> None:
        self.arcs = tuple(arcs)
        self.width, self.length = (
            np.array([[getattr(a.shape, key)] for a in arcs]) for key in ("width", "length")
        )
        nodes = PANEL * -(-(max(a.points for a in arcs) + 2) // PANEL) + 1
        self.table = np.zeros((COLUMNS, len(arcs), nodes))
        self.turns = np.zeros((len(arcs), nodes, ROOM))
        self.count = np.zeros((len(arcs), nodes), dtype=np.int64)
        self.kept = np.zeros((len(arcs), nodes))  # n without the part that goes with m - x_c
        self.tension_0 = self.table[TENSION]  # at the beginning of a step
        self.open = self.lays = False
        self.h, self.laid = 1.0, [0] * len(arcs)
        self.to = [a.travel for a in arcs]
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

    # --- a step: what leaves, what is laid, what is guessed ---

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
        self.h, self.open = h, False
        ends = [
            t if t - a.travel > STANDS else a.travel
            for a, t in zip(self.arcs, travels, strict=True)
        ]
        plans = [self._plan(a, end - a.travel) for a, end in zip(self.arcs, ends, strict=True)]
        self._carry(ends, plans)
        for arc, end, (_, fresh, laid) in zip(self.arcs, ends, plans, strict=True):
            if laid:
                self._lay(arc, end, fresh, laid)
        self.laid = [laid for *_, laid in plans]
        self.lays = max(self.laid) > 1
        if self.lays:
            self.kept = self.table[KEPT].copy()
        self._guess(ends, onward)

    def _plan(self, arc: MovingArc, ahead: float) -> tuple[int, int, int]:
        """Whether the piece at the nip stays, a fresh one is put there, and how many are laid."""
        if not ahead:
            return 1, 0, 0
        laid = max(round(ahead / arc.spacing), 1)
        if not arc.moves:  # the piece at the nip stood there and remembers: it stays
            kept = float(self.table[KEPT, arc.own, arc.nip])
            jumped = abs(arc.m - kept - arc.overrun(arc.entry))
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
        """Make the fresh pieces of a step: put at the nip as it was, and laid on the way."""
        rows, nip, first = self.table[:, arc.own], arc.nip, arc.nip - laid + 1
        rows[SLIP : REACH + 1, first - fresh :] = 0.0
        self.count[arc.own, first - fresh :] = 0
        if fresh:
            rows[KEPT, first - 1] = arc.m - arc.overrun(arc.entry)
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
        # n at the ends of steps, interpolated in travel: a part goes with the end of this one
        known = [(arc.travel, arc.m - arc.overrun(arc.entry))]
        if moved:
            least = _APART * (end - arc.travel)
            earlier = zip(arc.past_travel, arc.past_kept, strict=True)
            known += [(s, n) for s, n in earlier if arc.travel - s > least]
        weights = _lagrange(z, [end, *(s for s, _ in known)])
        rows[KEPT, first:nip] = sum(w * n for w, (_, n) in zip(weights[1:], known, strict=True))
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

    def come(self, arc: MovingArc, end: float) -> None:
        """Bring the nip of an arc to a travel; a piece that has left on the way goes."""
        rows = self.table[:, arc.own]
        if arc.moves:
            rows[TRAVEL, arc.nip :] = end
        while arc.nip > 2 and end - rows[TRAVEL, 1] >= arc.shape.length:
            rows[:, :-1] = rows[:, 1:].copy()
            own = self.turns[arc.own], self.count[arc.own]
            more = (
                (self.tension_0[arc.own], self.kept[arc.own])
                if self.lays
                else (self.tension_0[arc.own],)
            )
            for values in (*own, *more):
                values[:-1] = values[1:].copy()
            arc.nip -= 1

    def at_nip(self, arc: MovingArc, rise: float, give: float, dry: float) -> None:
        """Say what belt and lagging are like at the nip; between the ends of a step, in between."""
        laid = self.laid[arc.own]
        for column, old, new in (
            (GIVE, arc.give, give),
            (RISE, arc.rise, rise),
            (DRY, arc.dry, dry),
        ):
            row = self.table[column, arc.own]
            row[arc.nip :] = new
            if laid > 1:
                row[arc.nip - laid + 1 : arc.nip] = old + np.arange(1, laid) / laid * (new - old)

    def undo(self) -> None:
        """Go back to before the step that was begun; the next one is guessed without rates."""
        self.table, self.turns, self.count, nips = self.before
        for arc, (nip, moves) in zip(self.arcs, nips, strict=True):
            arc.nip, arc.moves = nip, moves
        self.table[T_RATE : I_RATE_0 + 1] = 0.0
        self.open = self.lays = False

    def remember(self, arc: MovingArc, kept: float) -> None:
        """Take what the piece keeps that was laid at the end of a step."""
        self.table[KEPT, arc.own, arc.nip :] = kept
        moved = self.before[3][arc.own][1]
        known = min(len(arc.past_travel) + 1, _KNOWN) if moved else 1
        arc.past_travel = [self.to[arc.own], *arc.past_travel][:known]
        arc.past_kept = [kept, *arc.past_kept][:known]


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
