"""Arcs whose tensions are held at both nips: nothing then depends on time, only on travel."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from wraparc.motion.pieces import STANDS
from wraparc.motion.wraps import Wraps

#: Steps of Newton's method, and how far it goes.
_ITERATIONS, _SETTLED = 40, 1e-10
#: Step of m that leads nowhere [m]; rolls a wrap length.
_TOO_FAR, _ROLLS = 0.1, 25
_LEAST_PIECES = 0.1  # to be rolled at once


@np.errstate(all="ignore")  # a trial may be far off
def roll(
    wraps: Wraps, aheads: Sequence[float], entries: Sequence[float], exits: Sequence[float]
) -> None:
    """Travel on with given tensions at both nips [N].

    Raises
    ------
    ArithmeticError
        If there is no creep with which an arc holds them; it tells the place of the arc.
    """
    arcs = wraps.arcs
    travels = [a.travel + ahead for a, ahead in zip(arcs, aheads, strict=True)]
    # a belt that does not creep is laid on stretched
    m = [
        a.m + (a.slope or a.give * entry) * ahead
        for a, ahead, entry in zip(arcs, aheads, entries, strict=True)
    ]
    wraps.begin(travels)
    for _ in range(_ITERATIONS):
        try:
            found = wraps.sweep(travels, m, exits)
        except np.linalg.LinAlgError:
            raise ArithmeticError(0) from None
        steps = [
            (entry - out.entry) / out.entry_m if out.entry_m else np.inf
            for out, entry in zip(found, entries, strict=True)
        ]
        m = [a + dm for a, dm in zip(m, steps, strict=True)]
        worst = wraps.change(m, exits)
        off = [not abs(dm) < _TOO_FAR for dm in steps]
        if any(off):
            raise ArithmeticError(off.index(True))
        off = [
            w >= _SETTLED or abs(dm) >= 1e-14 + 1e-9 * a.spacing
            for a, dm, w in zip(arcs, steps, worst, strict=True)
        ]
        if not any(off):
            break
    else:
        raise ArithmeticError(off.index(True))
    for arc, m1, ahead in zip(arcs, m, aheads, strict=True):
        arc.slope = (m1 - arc.m) / ahead if ahead > STANDS else 0.0
    wraps.finish(m, exits)


def _onward(wraps: Wraps, pieces: float, entries: Sequence[float], exits: Sequence[float]) -> None:
    """Roll on by some pieces; in halves where what sticks and slips changes too much at once."""
    try:
        roll(wraps, [pieces * a.spacing for a in wraps.arcs], entries, exits)
    except ArithmeticError:
        if pieces < _LEAST_PIECES:
            raise
        wraps.undo()
        _onward(wraps, 0.5 * pieces, entries, exits)
        _onward(wraps, 0.5 * pieces, entries, exits)


def settle(
    wraps: Wraps, entries: Sequence[float], exits: Sequence[float], lengths: float = 3.0
) -> None:
    """Bring the arcs into their steady state between two tensions each, over some wrap lengths."""
    points = wraps.arcs[0].points
    pieces = max(points // _ROLLS, 1)
    for i in range(1, 21):  # the pull is put on little by little while the belt travels
        put_on = [x + (t - x) * i / 20.0 for t, x in zip(entries, exits, strict=True)]
        _onward(wraps, 2.0, put_on, exits)
    for _ in range(-(-int(lengths * points) // pieces)):
        _onward(wraps, float(pieces), entries, exits)
    for arc in wraps.arcs:
        arc.work = 0.0
