"""Memory of a friction law under reversal: the material points of a lagging, in arrays.

The integral-log law F(r) = r (1 - ln r) is the integral of min(r/xi, 1) over xi from 0 to 1: a set
of elastic-sliding elements in parallel whose break-away slips are spread evenly up to the peak.
Unloading therefore has no free parameter (Masing's rule): with f(z) = A F(z/x_pk),

    tau = s1 f(|x1|) + sum_j 2 s_j f(|x_j - x_(j-1)|/2) + 2 s f(|x - x_k|/2),

x_1..x_k the turning points of the slip, s the signs of the differences, A and x_pk at the present
pressure. Passing x_(k-1) forgets x_k and x_(k-1), passing -x_1 forgets all. Strength lost past the
peak stays lost: A is taken at the largest slip so far. A measured table is such a set as well if
it is concave; a law with a limit is one element (return mapping).
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.friction.base import FrictionLaw
from wraparc.friction.compact import LIMIT, CompactLaw
from wraparc.friction.first_loading import FirstLoading, Loading, first_loading_of
from wraparc.friction.table import MeasuredTable

#: turning points that are kept, and the least reversal that makes one [m]
MOST_TURNS = 24
ROOM = MOST_TURNS + 2  # places that a point needs
LEAST_TURN = 1e-12


class Past(NamedTuple):
    """What material points remember.

    Attributes
    ----------
    turns, held
        Turning points of the slip, shape (n, ROOM) [m], and how many of them hold. The place behind
        the last one is written to where the slip has just turned.
    side, slip, stress
        Direction of the slip (0 without any), slip [m] and shear stress [Pa].
    reach
        Largest slip so far [m].
    share
        Part of the friction that is there: less than 1 on a wet patch [-].
    """

    turns: Array
    held: Integers
    side: Array
    slip: Array
    stress: Array
    reach: Array
    share: Array


class Points(NamedTuple):
    """Material points after a step, not yet taken for good.

    Attributes
    ----------
    slip, stress
        x [m], tau [Pa].
    by_creep, by_pressure
        Slopes of tau by creep [Pa/m] and by pressure [-].
    held
        Turning points that are left.
    side
        Direction of the slip, +1 or -1; 0 of a law with a limit.
    """

    slip: Array
    stress: Array
    by_creep: Array
    by_pressure: Array
    held: Integers
    side: Array


def has_memory(law: FrictionLaw) -> bool:
    """Whether the elements of a law exist: a measured table must rise from 0 and be concave."""
    if not isinstance(law, MeasuredTable):
        return True
    if any(row[0] != 0.0 for row in law.values):
        return False
    slips = [row * law.slip[-1] / 200.0 for row in range(201)]
    for pressure in law.pressure:
        values = [float(law.friction(x, pressure)) for x in slips]
        rises = [b - a for a, b in pairwise(values)]
        small = 1e-9 * max(values)
        if min(rises) < -small or any(b > a + small for a, b in pairwise(rises)):
            return False
    return True


class Lagging:
    """A friction law on a lagging that shears: stress and slip of its points under creep.

    Parameters
    ----------
    law
        The law.
    shear
        c = h/G, compliance of the lagging in shear [m/Pa].
    """

    def __init__(self, law: CompactLaw, shear: float) -> None:
        self.law, self.shear = law, shear
        self.first: FirstLoading = first_loading_of(law)

    def moved(self, creep: Array, pressure: Array, past: Past, near: Array) -> Points:
        """State of material points after their creep and pressure have changed.

        Parameters
        ----------
        creep, pressure
            The new creep u = x + c tau [m] and wrap pressure [Pa], shape (n,).
        past
            What the points remember. Nothing of it is changed but the places behind the turning
            points that hold, so that a solver can try.
        near
            A guess of the new slip [m]: the closer, the faster.
        """
        if self.law.kind == LIMIT:
            return self.stuck_or_sliding(creep, pressure, past)
        side = np.where(past.side == 0.0, np.where(creep >= 0.0, 1.0, -1.0), past.side)
        count = np.where(past.side == 0.0, 0, past.held)
        free = np.flatnonzero(count == 0)
        if len(free) == len(creep):
            at = self.virgin(creep, pressure, side, np.abs(near), past.share)
        else:
            four = np.zeros((4, len(creep)))
            at = Points(four[0], four[1], four[2], four[3], count, side)
            _put(at, free, self._virgin(free, creep, pressure, side, np.abs(near), past))
        # of those without turning points the ones that have just turned
        turns = side[free] * (at.slip[free] - past.slip[free]) < -LEAST_TURN
        turned = free[turns | (side[free] * creep[free] < 0.0)]
        if not turned.size and len(free) == len(creep):
            return at
        fresh = np.abs(past.slip[turned]) < LEAST_TURN
        over, turned = turned[fresh], turned[~fresh]
        side[over] *= -1.0
        _put(at, over, self._virgin(over, creep, pressure, side, 0.0 * near, past))
        past.turns[turned, 0] = past.slip[turned]
        count[turned], side[turned] = 1, -side[turned]
        has_turned = np.zeros(len(creep), dtype=bool)
        has_turned[turned] = True
        self._turning(creep, pressure, past, near, count, side, has_turned, at)
        return Points(*at[:4], count, side)

    def virgin(
        self, creep: Array, pressure: Array, side: Array, guess: Array, share: Any
    ) -> Points:
        """State of points that have slipped one way only, at a creep of that side."""
        c, first = self.shear, self.first
        b = first.at(pressure, None, share)
        w = side * creep
        z = first.shared(b, c, w, guess)
        f, f_z, f_p = first.loaded(b, z)
        give = 1.0 + c * f_z
        slip, stress, by_creep, by_pressure = side * z, side * f, f_z / give, side * f_p / give
        none = w <= 0.0
        if none.any():
            slip[none] = stress[none] = by_pressure[none] = 0.0
            by_creep[none] = 0.0 if c == 0.0 else 1.0 / c
        past = w > b.peak_slip + c * b.strength
        if past.any():
            x, tau, fall, by_p = first.past_peak(b.of(past), c, w[past], _of(share, past))
            slip[past], stress[past] = side[past] * x, side[past] * tau
            by_creep[past] = fall / (1.0 + c * fall)
            by_pressure[past] = side[past] * by_p / (1.0 + c * fall)
        return Points(slip, stress, by_creep, by_pressure, np.zeros(len(w), dtype=np.int64), side)

    def stuck_or_sliding(self, creep: Array, pressure: Array, past: Past) -> Points:
        """Return mapping of a law with a limit: one element, elastic until the limit is reached."""
        b, c = self.first.at(pressure, None, past.share), self.shear
        give = c + self.law.onset_compliance
        trial = past.stress + (creep - past.slip - c * past.stress) / give
        slides = np.abs(trial) > b.strength
        side = np.where(trial > 0.0, 1.0, -1.0)
        stress = np.where(slides, side * b.strength, trial)
        return Points(
            creep - c * stress,
            stress,
            np.where(slides, 0.0, 1.0 / give),
            np.where(slides, side * b.strength_p, 0.0),
            np.zeros(len(creep), dtype=np.int64),
            np.zeros(len(creep)),
        )

    def _virgin(
        self, i: Integers, creep: Array, pressure: Array, side: Array, guess: Array, past: Past
    ) -> Points:
        return self.virgin(creep[i], pressure[i], side[i], guess[i], past.share[i])

    def _turning(
        self, creep: Array, pressure: Array, past: Past, near: Array,
        count: Integers, side: Array, turned: Flags, at: Points,
    ) -> None:  # fmt: skip
        """Find the state of points that have turned; turning points come and go until they fit."""
        turns, live = past.turns, np.flatnonzero(count)
        while live.size:
            free = live[count[live] == 0]
            if free.size:
                _put(at, free, self._virgin(free, creep, pressure, side, np.abs(near), past))
                live = live[count[live] > 0]
                continue
            b = self.first.at(pressure[live], past.reach[live], past.share[live])
            base, base_p = self._carried(b, turns[live], count[live])
            n, s = count[live], side[live]
            top = turns[live, n - 1]
            w = 0.5 * s * (creep[live] - top - self.shear * base)
            z = self.first.shared(b, self.shear, w, 0.5 * s * (near[live] - top))
            x = top + 2.0 * s * z
            turn = ~turned[live] & ((w < 0.0) | (s * (x - past.slip[live]) < -LEAST_TURN))
            # back to a turning point just made, it turns no more
            again = turn & (np.abs(past.slip[live] - top) <= LEAST_TURN)
            other = np.where(n == 1, -top, turns[live, np.maximum(n - 2, 0)])
            closes = ~turn & (z > 0.5 * np.abs(top - other))
            new = live[turn & ~again]
            turns[new, count[new]] = past.slip[new]
            count[new] += 1
            count[live[again]] -= 1
            side[live[turn]] *= -1.0
            closed = live[closes]
            count[closed] = np.where(count[closed] == 1, 0, count[closed] - 2)
            turned[live[turn | closes]] = True
            done = ~(turn | closes)
            i = live[done]
            if i.size:
                f, f_z, f_p = self.first.loaded(b.of(done), z[done])
                give, s = 1.0 + self.shear * f_z, s[done]
                at.slip[i], at.stress[i] = x[done], base[done] + 2.0 * s * f
                at.by_creep[i], at.by_pressure[i] = (
                    f_z / give,
                    (base_p[done] + 2.0 * s * f_p) / give,
                )
            live = live[~done]

    def _carried(self, b: Loading, turns: Array, count: Integers) -> tuple[Array, Array]:
        """Shear stress at the last turning point [Pa], and its derivative by pressure [-]."""
        most = int(count.max())
        legs = np.diff(turns[:, :most], axis=1, prepend=0.0)
        holds = np.arange(most) < count[:, None]
        legs = np.where(holds, legs, 0.0)
        half = np.full(most, 0.5)
        half[0] = 1.0
        f, _, f_p = self.first.loaded(b.of((slice(None), None)), np.abs(legs) * half)
        sign = np.where(legs >= 0.0, 1.0, -1.0) * holds / half
        return (sign * f).sum(axis=1), (sign * f_p).sum(axis=1)


def shorten(turns: Array, count: Integers) -> None:
    """Forget the smallest loop of every point without room for another turning point, in place."""
    for i in np.flatnonzero(count >= MOST_TURNS):
        n = int(count[i])
        smallest = 1 + int(np.argmin(np.abs(np.diff(turns[i, :n]))))
        turns[i, smallest - 1 : n - 2] = turns[i, smallest + 1 : n].copy()
        count[i] = n - 2


def _put(at: Points, i: Integers, found: Points) -> None:
    for values, new in zip(at[:4], found[:4], strict=True):
        values[i] = new


def _of(share: Any, which: Flags) -> Any:
    return share[which] if np.ndim(share) else share
