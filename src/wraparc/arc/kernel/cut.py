"""Where a step of a march leaves the piece of the law that it began in."""

from __future__ import annotations

from math import log

from wraparc.arc.kernel.quantities import Parameters
from wraparc.arc.kernel.step import hermite, pressure_at
from wraparc.friction.compact import (
    ELASTIC,
    KNOTS,
    LIMIT,
    PIECES,
    RISE,
    TABLE,
    CompactLaw,
    branch_gap,
    peak,
)

# how near a cut lands on a boundary of the law (ln p, or slip [m]): where only the curvature of the
# law jumps, the square of the miss counts
CUT_TOLERANCE, SMOOTH_CUT_TOLERANCE, SLIP_CUT_TOLERANCE = 1e-6, 3e-4, 1e-9

# sides of a piece
LOWER_EDGE, UPPER_EDGE, NO_SLIP, PREVIOUS_BRANCH, NEXT_BRANCH = range(5)


def beyond(
    law: CompactLaw, par: Parameters, segment: int, branch: int, side: int, q: float, x: float
) -> float:
    """How far a state with slip magnitude x is beyond one side of a piece; negative inside."""
    last = len(law.edges) - 1
    if side == LOWER_EDGE:
        return log(law.edges[segment] / par.entry_pressure) - q if segment >= 0 else -1.0
    if side == UPPER_EDGE:
        return q - log(law.edges[segment + 1] / par.entry_pressure) if segment < last else -1.0
    if side == NO_SLIP:
        return -x
    p = pressure_at(par, q)
    if side == PREVIOUS_BRANCH:
        return -branch_gap(law, segment, branch - 1, x, p) if branch > 0 else -1.0
    if not _has_next(law, branch):
        return -1.0
    return branch_gap(law, segment, branch, x, p)


def first_crossing(
    law: CompactLaw,
    par: Parameters,
    segment: int,
    branch: int,
    sign: float,
    h: float,
    start: tuple[float, float, float, float],
    end: tuple[float, float, float, float],
) -> tuple[float, int]:
    """Where a step first leaves its piece: the fraction of the step and the side crossed.

    start and end are q, x and their slopes in xi. A fraction of 1 means that it does not leave.
    """
    first, crossed = 1.0, -1
    for side in range(5):
        fb = beyond(law, par, segment, branch, side, end[0], sign * end[1])
        if fb <= 0.0:
            continue
        a, b = 0.0, 1.0
        fa = beyond(law, par, segment, branch, side, start[0], sign * start[1])
        if fa >= 0.0:
            b = 0.0
        else:
            # regula falsi (Illinois) on the Hermite cubics of the step
            for _ in range(60):
                m = (a * fb - b * fa) / (fb - fa)
                qm = hermite(m, h, start[0], start[2], end[0], end[2])
                xm = hermite(m, h, start[1], start[3], end[1], end[3])
                fm = beyond(law, par, segment, branch, side, qm, sign * xm)
                if fm * fb <= 0.0:
                    a, fa = b, fb
                else:
                    fa *= 0.5
                b, fb = m, fm
                if abs(b - a) < 1e-12 or fm == 0.0:
                    break
        if b < first:
            first, crossed = b, side
    return first, crossed


def _has_next(law: CompactLaw, branch: int) -> bool:
    """Whether a branch ends at larger slips."""
    if law.kind == LIMIT:
        return branch == ELASTIC
    if law.kind == TABLE:
        return branch < len(law.slips) - 1
    return branch < 2


def cut_tolerance(law: CompactLaw, segment: int, side: int) -> float:
    """How near a cut must land: inner knots of pressure only bend the law's slope."""
    last = len(law.edges) - 1
    smooth = law.kind == KNOTS and (
        (side == LOWER_EDGE and segment > 0) or (side == UPPER_EDGE and 0 <= segment < last - 1)
    )
    if side in (LOWER_EDGE, UPPER_EDGE):
        return SMOOTH_CUT_TOLERANCE if smooth else CUT_TOLERANCE
    return SLIP_CUT_TOLERANCE


def within(law: CompactLaw, par: Parameters, segment: int, branch: int, q: float, x: float) -> bool:
    """Whether a state with slip magnitude x lies in a piece of the law."""
    p = pressure_at(par, q)
    last = len(law.edges) - 1
    if x < 0.0 or (segment >= 0 and p < law.edges[segment]):
        return False
    if segment < last and p >= law.edges[segment + 1]:
        return False
    if branch == RISE and law.kind in (KNOTS, PIECES):
        return x <= peak(law, segment, p)[0]
    return (
        beyond(law, par, segment, branch, PREVIOUS_BRANCH, q, x) <= 0.0
        and beyond(law, par, segment, branch, NEXT_BRANCH, q, x) <= 0.0
    )
