"""How much more pull until gross slip, for many arcs at once."""

from __future__ import annotations

from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.gross_slip import Grip, Line, plateau_capacity, slip_place
from wraparc.batch.arcs import Arcs, Array
from wraparc.batch.native import available, compiled
from wraparc.batch.precise import law_of


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
    columns = (arcs.wrap_angle * friction_factor, area, known, tight, slack, *rises)
    given = np.ascontiguousarray(np.stack(columns, axis=1))
    found = np.empty(len(arcs))
    if available():
        compiled(factor_rows)(given, arcs.laws.arrays, arcs.law, found)
        return found
    laws = [arcs.laws.compact(i) for i in range(len(arcs.laws))]
    for i, numbers in enumerate(given.tolist()):
        found[i] = _factor(laws[int(arcs.law[i])], numbers)
    return found


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
