"""How much more pull until gross slip, for many arcs at once."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import inf, log
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.gross_slip import Grip, Line, plateau_capacity, slip_place
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.engineering import tables_of
from wraparc.batch.laws import LawBank, law_of
from wraparc.batch.native import available, compiled, pays
from wraparc.friction.compact import KNOTS

#: ln(tight/slack) that plateaus carry, and friction at the end over that at the start, for
#: logarithms of the first pressure and wrap angles
Carried = Callable[[Array, Array], tuple[Array, Array]]

KNOWN, TIGHT, SLACK = 2, 3, 4  # columns of what is given
MOST_STEPS = 12
FEW = 20  # rows left to the interpreter, which takes some 20 ms for one
NEAR = 1e-8  # last step over k: what is left is of the size of rounding
HIGHEST = 1e4  # as `slip_place` has it


def pull_factors(
    arcs: Arcs, friction_factor: Array, gross_slip_capacity: Array, rises: tuple[Array, Array]
) -> Array:
    """Pull at gross slip over the pull of each arc, shape (n,) [-]; inf where it never slips.

    Parameters
    ----------
    arcs
        The arcs, with their laws unscaled.
    friction_factor
        Factor on the friction of each law, shape (n,) [-].
    gross_slip_capacity
        Largest tension ratio of each arc at its tight-side tension, shape (n,) [-]; counts where
        friction falls past its peak.
    rises
        Growth of the tight and of the slack side as the pull doubles, shapes (n,) [N].
    """
    tight = np.maximum(arcs.entry_tension, arcs.exit_tension)
    slack = np.minimum(arcs.entry_tension, arcs.exit_tension)
    softens = arcs.laws.steepest_fall[arcs.law] < 0.0
    known = np.full(len(arcs), np.nan)
    np.log(gross_slip_capacity, out=known, where=softens & (gross_slip_capacity > 0.0))
    area = arcs.belt_width * 0.5 * arcs.diameter
    # the plateau of f mu over an angle is that of mu over f times the angle
    wrap = arcs.wrap_angle * friction_factor
    given = np.stack((wrap, area, known, tight, slack, *rises), axis=1)
    found = _by_tables(arcs, given)
    left = np.flatnonzero(np.isnan(found))
    if len(left):
        found[left] = _by_rows(arcs.laws, arcs.law[left], given[left])
    return found


def _by_rows(bank: LawBank, law: Integers, given: Array) -> Array:
    """Factors row by row; few of them by the interpreter."""
    found = np.empty(len(given))
    if available() and pays(len(given), FEW):
        compiled(factor_rows)(given, bank.arrays, law, found)
        return found
    for i, numbers in enumerate(given.tolist()):
        found[i] = _factor(bank.compact(int(law[i])), numbers)
    return found


def _by_tables(arcs: Arcs, given: Array) -> Array:
    """Factors of the rows under laws by knots, shape (n,); nan of others and of those not met."""
    _, plateaus, _ = tables_of(arcs.laws)
    found = np.full(len(given), np.nan)
    fit = (arcs.laws.kind == KNOTS) & (plateaus.table.row >= 0)
    for i in np.unique(arcs.law[fit[arcs.law]]).tolist():
        which = np.flatnonzero((arcs.law == i) & (given[:, TIGHT] != given[:, SLACK]))
        with np.errstate(all="ignore"):
            found[which] = _newton(partial(plateaus.finely, i), given[which].T)
    found[given[:, TIGHT] == given[:, SLACK]] = inf
    return found


def _newton(carried: Carried, numbers: Array) -> Array:
    """Factors by Newton's method, shape (n,); nan where it does not lead there.

    What the slack side has more than the least tension that carries is nearly straight along the
    line if the slack side falls; its logarithm over ln k is, if the take-up holds it. The least
    tension grows with the tight side as the plateau at its end does over that at its beginning.
    """
    softens = ~np.isnan(numbers[KNOWN])
    offset = np.zeros(len(softens))
    if softens.any():
        wrap, area, known, tight = numbers[: TIGHT + 1]
        offset = np.where(softens, known - carried(np.log(tight / area), wrap)[0], 0.0)
    held = numbers[-1] >= 0.0
    at, found = np.where(held, 0.0, 1.0), np.full(len(held), np.nan)
    open_ = np.arange(len(held))
    for _ in range(MOST_STEPS):
        if not len(open_):
            break
        step = _step(carried, numbers[:, open_], offset[open_], at[open_])
        at[open_] += step
        last = at[open_]
        good = np.where(held[open_], last <= log(HIGHEST), (last > 0.0) & (last <= HIGHEST))
        met = good & (np.abs(step) <= NEAR * np.maximum(np.abs(last), 1.0))
        found[open_[met]] = np.where(held[open_], np.exp(np.minimum(last, 10.0)), last)[met]
        open_ = open_[good & ~met]
    return found


def _step(carried: Carried, numbers: Array, offset: Array, at: Array) -> Array:
    """One step of Newton's method, nan where there is none."""
    wrap, area, _, tight, slack, tight_rise, slack_rise = numbers
    held = slack_rise >= 0.0
    k = np.where(held, np.exp(at), at)
    top, other = tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise
    sound = top > 0.0
    top = np.where(sound, top, tight)
    q, rise = carried(np.log(top / area), wrap)
    least, growth = top * np.exp(-np.maximum(q + offset, 0.0)), tight_rise / top * rise
    spare = np.where(held, np.log(other / least), other - least)
    slope = np.where(held, k * (slack_rise / other - growth), slack_rise - growth * least)
    return np.where(sound & (slope < 0.0), -spare / slope, np.nan)


def factor_rows(given: Any, bank: Any, which: Any, found: NDArray[np.float64]) -> None:
    """Fill `found` row by row; compiled only."""
    for i in range(len(given)):
        found[i] = _factor(law_of(bank, which[i]), given[i])


def _factor(law: Any, given: Any) -> float:
    wrap, area, known, tight, slack = given[0], given[1], given[2], given[3], given[4]
    if tight == slack:
        return inf
    offset = 0.0
    if known == known:
        offset = known - plateau_capacity(law, tight / area, wrap)
    line = Line(tight, slack, given[5], given[6])
    return slip_place(law, Grip(wrap, area, offset), line, 1.0, 0.0)
