"""Slip that belongs to a creep under a measured table.

Every stage of a march in creep asks for it. The pressure stands meanwhile, so the table is one
cubic of slip for each cell, and is read once for a cell and not at every trial.
"""

from __future__ import annotations

from wraparc.friction.compact import CompactLaw, cell_of

_MOST_TRIALS = 200


def slip_under_table(
    law: CompactLaw, segment: int, ease: float, pressure: float, creep: float, share: float
) -> tuple[float, float]:
    """Friction mu [-] and slip x [m] with x + ease mu(x, p) = creep (Newton, inside a bracket).

    Parameters
    ----------
    law
        A measured table.
    segment
        Segment of the pressure.
    ease
        Shear of the lagging for a friction of 1, h p/G [m].
    pressure
        Wrap pressure p [Pa].
    creep
        Magnitude of the creep [m].
    share
        A first guess of slip over creep; 1 where nothing is known.
    """
    edges, c, slips = law.edges, law.coefficients, law.slips
    last, cells = len(edges) - 1, len(slips)
    row, above, weight, factor = 0, 0, 0.0, 1.0
    if last >= 0 and segment >= last:  # above the tested pressures the traction is held
        row, factor = last, edges[last] / pressure
    elif segment >= 0:
        row, above = segment, 4 * cells
        weight = (pressure - edges[segment]) / (edges[segment + 1] - edges[segment])
    o = 4 * row * cells
    ease *= factor
    held = c[o] + weight * (c[o + above] - c[o])
    # a table that starts with a jump holds the belt: the lagging alone gives way
    if ease > 0.0 and creep <= ease * held:
        return factor * creep / ease, 0.0
    low, high = 0.0, creep
    x = share * creep if share > 0.0 else creep
    cell = -1
    start = a0 = a1 = a2 = a3 = 0.0
    mu = mu_x = change = 0.0
    for _ in range(_MOST_TRIALS):
        found = cell_of(slips, x)
        if found != cell:
            cell, start = found, slips[found]
            i = o + 4 * cell
            j = i + above
            a0 = c[i] + weight * (c[j] - c[i])
            a1 = c[i + 1] + weight * (c[j + 1] - c[i + 1])
            a2 = c[i + 2] + weight * (c[j + 2] - c[i + 2])
            a3 = c[i + 3] + weight * (c[j + 3] - c[i + 3])
        t = x - start
        mu = a0 + t * (a1 + t * (a2 + t * a3))
        mu_x = a1 + t * (2.0 * a2 + 3.0 * t * a3)
        miss = x + ease * mu - creep
        if miss > 0.0:
            high = x
        else:
            low = x
        slope = 1.0 + ease * mu_x
        trial = x - miss / slope if slope > 0.0 else low
        change = trial - x
        if abs(change) > 1e-15 * x and not low < trial < high:
            trial = 0.5 * (low + high)
            change = trial - x
        if abs(change) <= 1e-15 * x:
            break
        x = trial
    return factor * (mu + mu_x * change), x + change
