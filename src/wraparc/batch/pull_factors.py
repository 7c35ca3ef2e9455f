"""How much more pull until gross slip, for many arcs at once."""

from __future__ import annotations

from math import inf, log

import numpy as np

from wraparc.arc.gross_slip import Grip, Line, plateau_capacity, slip_place
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.gross_slip import ratio_at_gross_slip
from wraparc.batch.traction import Laws
from wraparc.friction.compact import CompactLaw

KNOWN, TIGHT, SLACK = 2, 3, 4  # columns of what is given
MOST_STEPS = 12
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
    found = np.full(len(arcs), inf)
    pulls = tight != slack
    for kind in np.unique(arcs.laws.kind[arcs.law]).tolist():
        which = np.flatnonzero(pulls & (arcs.laws.kind[arcs.law] == kind))
        if len(which):
            with np.errstate(all="ignore"):
                found[which] = _newton(arcs.laws.traction(arcs.law[which]), given[which].T)
    for i in np.flatnonzero(np.isnan(found)).tolist():
        found[i] = _factor(arcs.laws.compact(int(arcs.law[i])), given[i].tolist())
    return found


def _carried(laws: Laws, top: Array, wrap: Array) -> tuple[Array, Array]:
    """ln(tight/slack) that plateaus carry from a pressure [Pa], and friction there over here."""
    q = ratio_at_gross_slip(laws, top, wrap)
    return q, laws.plateau(top * np.exp(-q)) / laws.plateau(top)


def _newton(laws: Laws, numbers: Array) -> Array:
    """Factors by Newton's method, shape (n,); nan where it does not lead there.

    What the slack side has more than the least tension that carries is nearly straight along the
    line if the slack side falls; its logarithm over ln k is, if the take-up holds it. The least
    tension grows with the tight side as the plateau at its end does over that at its beginning.
    """
    softens = ~np.isnan(numbers[KNOWN])
    offset = np.zeros(len(softens))
    if softens.any():
        wrap, area, known, tight = numbers[: TIGHT + 1]
        offset = np.where(softens, known - _carried(laws, tight / area, wrap)[0], 0.0)
    held = numbers[-1] >= 0.0
    at, found = np.where(held, 0.0, 1.0), np.full(len(held), np.nan)
    open_ = np.arange(len(held))
    for _ in range(MOST_STEPS):
        if not len(open_):
            break
        step = _step(laws.rows(open_), numbers[:, open_], offset[open_], at[open_])
        at[open_] += step
        last = at[open_]
        good = np.where(held[open_], last <= log(HIGHEST), (last > 0.0) & (last <= HIGHEST))
        met = good & (np.abs(step) <= NEAR * np.maximum(np.abs(last), 1.0))
        found[open_[met]] = np.where(held[open_], np.exp(np.minimum(last, 10.0)), last)[met]
        open_ = open_[good & ~met]
    return found


def _step(laws: Laws, numbers: Array, offset: Array, at: Array) -> Array:
    """One step of Newton's method, nan where there is none."""
    wrap, area, _, tight, slack, tight_rise, slack_rise = numbers
    held = slack_rise >= 0.0
    k = np.where(held, np.exp(at), at)
    top, other = tight + (k - 1.0) * tight_rise, slack + (k - 1.0) * slack_rise
    sound = top > 0.0
    top = np.where(sound, top, tight)
    q, rise = _carried(laws, top / area, wrap)
    least, growth = top * np.exp(-np.maximum(q + offset, 0.0)), tight_rise / top * rise
    spare = np.where(held, np.log(other / least), other - least)
    slope = np.where(held, k * (slack_rise / other - growth), slack_rise - growth * least)
    return np.where(sound & (slope < 0.0), -spare / slope, np.nan)


def _factor(law: CompactLaw, given: list[float]) -> float:
    """Factor of one row, by a search."""
    wrap, area, known, tight, slack, tight_rise, slack_rise = given
    offset = 0.0
    if known == known:
        offset = known - plateau_capacity(law, tight / area, wrap)
    line = Line(tight, slack, tight_rise, slack_rise)
    return slip_place(law, Grip(wrap, area, offset), line, 1.0, 0.0)
