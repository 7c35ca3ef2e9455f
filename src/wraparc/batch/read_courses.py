"""What rows of results say of courses: exit, largest shear, active arc, share outside the tests."""

from __future__ import annotations

import numpy as np

from wraparc.batch import row
from wraparc.batch.two_point import (
    Array,
    Block,
    Courses,
    Integers,
    between,
    cubic_through,
    stage_creeps,
    stage_shares,
)

ACTIVE_SHARE = 0.01  # of the change of tension that lies before the active arc
HALVINGS, REGULA = 45, 9
FINE, LOOKS = 8, 5  # parts of a neighbourhood in which the largest shear is looked for, how often


def read_courses(
    block: Block, at: Courses, lowest: Array, highest: Array, furthest: Array
) -> dict[int, Array]:
    """Columns of operating points by their places in a row of results.

    Parameters
    ----------
    block, at
        Arcs and their courses.
    lowest, highest, furthest
        Tested pressures [Pa] and largest tested slip [m], nan without.
    """
    shares, tension, creep = _samples(block, at)
    s = block.stress(tension, creep)
    g = at.ratio - block.compliance * at.tension[0]
    pull = at.tension[0] - at.tension[-1]
    work = pull * (g + 0.5 * pull * block.compliance) / block.width
    work = work - 0.5 * block.shear * (s.stress[-1] ** 2 - s.stress[0] ** 2)
    size = np.abs(s.slip)
    # x' = u' - c tau', tau' by creep and tension
    growth = at.ratio - block.compliance * tension
    loss = -block.width * s.stress / block.area
    steep = growth - block.shear * (s.by_creep * growth + s.by_pressure * loss)
    peak, where = _largest_stress(block, at, shares, s.stress)
    outside = np.full(len(block), np.nan)
    tested = np.flatnonzero(np.isfinite(furthest))
    if len(tested):
        limits = (lowest[tested], highest[tested], furthest[tested])
        p = tension[:, tested] / block.area[tested]
        of_tests = block.rows(tested), at.rows(tested), shares[:, tested]
        outside[tested] = _outside(*of_tests, (p, size[:, tested]), limits)
    return {
        row.LOG_RATIO: np.log(at.tension[-1] / at.tension[0]),
        row.EXIT_CREEP: at.creep[-1],
        row.EXIT_SLIP: s.slip[-1],
        row.EXIT_STRESS: s.stress[-1],
        row.ENTRY_STRESS: s.stress[0],
        row.WORK: work,
        row.CREEP_RATIO: g,
        row.STUCK_LENGTH: _stuck(block, at, shares, s.slip) * block.length,
        row.PEAK_STRESS: peak,
        row.PEAK_AT: where * block.length,
        row.ACTIVE: (1.0 - _begins(at)) * block.length,
        row.OUTSIDE: outside,
        row.LARGEST_SLIP: size.max(axis=0),
        row.STEEPEST_SLIP: np.abs(steep).max(axis=0),
    }


def _samples(block: Block, at: Courses) -> tuple[Array, Array, Array]:
    """Shares of the arc, tensions and creeps at the ends and stages of elements, in order."""
    steps = np.diff(at.shares, axis=0) * block.length
    creeps = stage_creeps(block, steps, at)
    elements, n = steps.shape

    def merged(ends: Array, stages: Array) -> Array:
        out = np.empty((4 * elements + 1, n))
        out[::4] = ends
        for k in range(3):
            out[k + 1 :: 4] = stages[k]
        return out

    return (
        merged(at.shares, stage_shares(at.shares)),
        merged(at.tension, at.stage),
        merged(at.creep, creeps),
    )


def _largest_stress(block: Block, at: Courses, shares: Array, stress: Array) -> tuple[Array, Array]:
    """Largest magnitude of shear stress [Pa], and its place as a share of the arc."""
    best = np.abs(stress).argmax(axis=0)
    rows = np.arange(len(block))
    most, where = np.abs(stress)[best, rows], shares[best, rows]
    low = shares[np.maximum(best - 1, 0), rows]
    high = shares[np.minimum(best + 1, len(shares) - 1), rows]
    for _ in range(LOOKS):
        points = low + (high - low) * (np.arange(FINE + 1) / FINE)[:, None]
        creep, tension = between(block, at, points)
        size = np.abs(block.stress(tension, creep).stress)
        k = size.argmax(axis=0)
        better = size[k, rows] > most
        most, where = (
            np.where(better, size[k, rows], most),
            np.where(better, points[k, rows], where),
        )
        low = points[np.maximum(k - 1, 0), rows]
        high = points[np.minimum(k + 1, FINE), rows]
    k = np.clip(k, 1, FINE - 1)
    before, here, after = (size[k + d, rows] for d in (-1, 0, 1))
    bend = before - 2.0 * here + after
    move = np.where(bend < 0.0, 0.5 * (before - after) / bend, 0.0)
    inside = (np.abs(move) < 1.0) & (here >= most * (1.0 - 1e-9))
    top = here - 0.25 * (before - after) * move
    step = points[1, rows] - points[0, rows]
    return (
        np.where(inside, np.maximum(top, most), most),
        np.where(inside, points[k, rows] + move * step, where),
    )


def _begins(at: Courses) -> Array:
    """Where the active arc begins, as a share of the arc."""
    change = at.tension[0] - at.tension[-1]
    goal = at.tension[0] - ACTIVE_SHARE * change
    taken = (at.tension[0] - at.tension) / np.where(change == 0.0, 1.0, change)
    before = taken[:-1] <= ACTIVE_SHARE
    # the last element that begins with less
    place = len(before) - 1 - before[::-1].argmax(axis=0)
    rows = np.arange(len(goal))
    t0 = at.tension[place, rows]
    k0, k1, k2 = at.stage[:, place, rows]
    low, high, sign = np.zeros(len(goal)), np.ones(len(goal)), np.sign(change)
    f_low, f_high = sign * (t0 - goal), sign * (at.tension[place + 1, rows] - goal)
    c = low
    for _ in range(REGULA):  # Illinois
        c = np.clip(
            low + (high - low) * f_low / np.where(f_low == f_high, 1.0, f_low - f_high), 0, 1
        )
        f = sign * (cubic_through(c, t0, k0, k1, k2) - goal)
        less = f > 0.0
        f_high, f_low = np.where(less, 0.5 * f_high, f), np.where(less, f, 0.5 * f_low)
        low, high = np.where(less, c, low), np.where(less, high, c)
    a, b = at.shares[place, rows], at.shares[place + 1, rows]
    return np.asarray(np.where(change == 0.0, 1.0, a + (b - a) * c))


def _stuck(block: Block, at: Courses, shares: Array, slip: Array) -> Array:
    """Entry part of the arc at rest under a law that jumps, as a share of it."""
    held = (slip == 0.0).cumprod(axis=0).astype(bool)
    count = held.sum(axis=0)
    which = np.flatnonzero(count > 1)
    out = np.zeros(len(block))
    if not len(which):
        return out
    last = len(shares) - 1
    low = shares[np.minimum(count, last + 1)[which] - 1, which]
    high = shares[np.minimum(count[which], last), which]
    part, some = block.rows(which), at.rows(which)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        creep, tension = between(part, some, middle[None])
        rests = part.stress(tension, creep).slip[0] == 0.0
        low, high = np.where(rests, middle, low), np.where(rests, high, middle)
    out[which] = low
    return out


def _outside(
    block: Block,
    at: Courses,
    shares: Array,
    samples: tuple[Array, Array],
    limits: tuple[Array, ...],
) -> Array:
    """Share of an arc outside the tested range: between samples, up to where they cross a limit."""
    pressure, slip = samples
    lowest, highest, furthest = limits
    low, high = np.zeros((len(shares) - 1, len(block))), np.ones((len(shares) - 1, len(block)))
    for k, f in enumerate((lowest - pressure, pressure - highest, slip - furthest)):
        out = f > 0.0
        high = np.where(out[:-1] & out[1:], -1.0, high)
        where, rows = np.nonzero(out[:-1] != out[1:])
        if not len(rows):
            continue
        place = _crossing(block, at, (shares, f), where, rows, (k, limits[k][rows]))
        leaves = out[:-1][where, rows]
        cells = where, rows
        low[cells] = np.where(leaves, np.maximum(low[cells], place), low[cells])
        high[cells] = np.where(leaves, high[cells], np.minimum(high[cells], place))
    beyond = (1.0 - np.maximum(high - low, 0.0)) * np.diff(shares, axis=0)
    # one after the other: a sum in pairs would depend on how many rows there are
    return np.asarray(np.cumsum(beyond, axis=0)[-1])


def _crossing(
    block: Block,
    at: Courses,
    samples: tuple[Array, Array],
    where: Integers,
    rows: Integers,
    limit: tuple[int, Array],
) -> Array:
    """Where between two samples a pressure (0, 1) or a slip (2) crosses its limit: Illinois."""
    shares, f = samples
    kind, most = limit
    part, some = block.rows(rows), at.rows(rows)
    start, width = shares[where, rows], shares[where + 1, rows] - shares[where, rows]
    low, high = np.zeros(len(rows)), np.ones(len(rows))
    f_low, f_high = f[where, rows], f[where + 1, rows]
    place = low
    for _ in range(REGULA):
        place = low + (high - low) * f_low / np.where(f_low == f_high, 1.0, f_low - f_high)
        creep, tension = between(part, some, (start + place * width)[None])
        if kind < 2:
            value = (tension[0] / part.area - most) * (1.0 if kind == 1 else -1.0)
        else:
            value = np.abs(part.stress(tension, creep).slip[0]) - most
        same = (value > 0.0) == (f_low > 0.0)
        f_high, f_low = np.where(same, 0.5 * f_high, value), np.where(same, value, 0.5 * f_low)
        low, high = np.where(same, place, low), np.where(same, high, place)
    return place
