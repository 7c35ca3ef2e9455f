"""How much more pull until gross slip, for many arcs at once."""

from __future__ import annotations

from math import exp, inf, log, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.gross_slip import Grip, Line, carried_log, plateau_capacity, slip_place
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.engineering import tables_of
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import law_of
from wraparc.friction.compact import plateau_at, segment_of

STARTS, MOST_STEPS = 8, 12
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
    starts = _starts(arcs, (wrap, area, known, tight, slack, *rises))
    columns = (wrap, area, known, tight, slack, *rises, starts)
    given = np.ascontiguousarray(np.stack(columns, axis=1))
    found = np.empty(len(arcs))
    if available():
        compiled(factor_rows)(given, arcs.laws.arrays, arcs.law, found)
        return found
    laws = [arcs.laws.compact(i) for i in range(len(arcs.laws))]
    for i, numbers in enumerate(given.tolist()):
        found[i] = _factor(laws[int(arcs.law[i])], numbers)
    return found


def _starts(arcs: Arcs, numbers: tuple[Array, ...]) -> Array:
    """Places of gross slip by the tables of plateaus, shape (n,); 1 where they lead nowhere.

    Secants of the same miss over the same coordinate as `_by_newton` has.
    """
    wrap, area, known, tight, slack, tight_rise, slack_rise = numbers
    _, plateaus = tables_of(arcs.laws)
    held = slack_rise >= 0.0

    def ratio(tension: Array) -> Array:
        return plateaus.capacity(arcs.law, tension / area, wrap)

    with np.errstate(all="ignore"):
        offset = np.where(np.isnan(known), 0.0, known - ratio(tight))

        def spare(at: Array) -> Array:
            k = np.where(held, np.exp(np.minimum(at, 10.0)), at)
            tension, other = tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise
            least = tension * np.exp(-np.maximum(ratio(tension) + offset, 0.0))
            return np.where(held, np.log(other / least), other - least)

        last = np.where(held, 0.0, 1.0)
        at, spare_last = last + 0.5, spare(last)
        for _ in range(STARTS):
            now = spare(at)
            step = -now * (at - last) / (now - spare_last)
            step = np.where(np.isfinite(step), step, 0.0)
            last, spare_last, at = at, now, at + step
        found = np.where(held, np.exp(np.minimum(at, 10.0)), at)
        good = (np.abs(at - last) < 1e-2) & (found > 0.0) & (found < HIGHEST)
    return np.where(good & (plateaus.table.row[arcs.law] >= 0), found, 1.0)


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
    grip, line = Grip(wrap, area, offset), Line(tight, slack, given[5], given[6])
    k = _by_newton(law, grip, line, given[7])
    return k if k == k else slip_place(law, grip, line, 1.0, 0.0)


def _by_newton(law: Any, grip: Grip, line: Line, start: float) -> float:
    """Place of gross slip by Newton's method from a start; nan where that does not lead there.

    What the slack side has more than the least tension that carries is nearly straight along the
    line if the slack side falls; its logarithm over ln k is, if the take-up holds it. The least
    tension grows with the tight side as the plateau at its end does over that at its beginning.
    """
    held = line.slack_rise >= 0.0
    at, most = (log(start), log(HIGHEST)) if held else (start, HIGHEST)
    for _ in range(MOST_STEPS):
        k = exp(at) if held else at
        tight = line.tight + (k - 1.0) * line.tight_rise
        slack = line.slack + (k - 1.0) * line.slack_rise
        if tight <= 0.0:
            return nan
        least = tight * exp(-carried_log(law, grip, tight))
        first, last = tight / grip.area, least * exp(grip.offset) / grip.area
        of_first = plateau_at(law, segment_of(law, first), first)
        growth = line.tight_rise / tight * plateau_at(law, segment_of(law, last), last) / of_first
        if held:
            spare, slope = log(slack / least), k * (line.slack_rise / slack - growth)
        else:
            spare, slope = slack - least, line.slack_rise - growth * least
        if not slope < 0.0:
            return nan
        step = -spare / slope
        at += step
        if not (held or at > 0.0) or at > most:
            return nan
        if abs(step) <= NEAR * max(abs(at), 1.0):
            return exp(at) if held else at
    return nan
