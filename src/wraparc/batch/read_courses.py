"""What rows of results say of courses: exit, largest shear, active arc, share outside the tests."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, reduce

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import row
from wraparc.batch.traction import Stress, Tables
from wraparc.batch.two_point import Block, Courses, Curves, Solved

ACTIVE_SHARE = 0.01  # of the change of tension that lies before the active arc
HALVINGS, REGULA = 45, 8
NEARER = 2  # times that the largest shear is looked for, each by two tries
#: Fractions of an element where it is looked at, and where the law is a table: that has more kinks.
LOOKS: Array = np.linspace(0.0, 1.0, 3)
CLOSER: Array = np.linspace(0.0, 1.0, 5)
#: The steepest slip: cells that are looked into, equal parts of them, and how often again.
CELLS, INNER, CLOSER_LOOKS = 3, 9, 12


def read_courses(
    block: Block, met: Solved, tested: tuple[Array, Array, Array], timed: Flags
) -> dict[int, Array]:
    """Columns of operating points by their places in a row of results.

    Parameters
    ----------
    block, met
        Arcs and their courses.
    tested
        Least and largest tested pressure [Pa] and largest tested slip [m], nan without.
    timed
        Of which arcs the steepest slip is exact; of others it is that of some points of the course.
    """
    lowest, highest, furthest = tested
    at, every = met.courses, met.curves
    # at the ends of elements and between them
    looks = CLOSER if isinstance(block.laws, Tables) else LOOKS
    c = looks[1:-1, None, None]
    inner = every.tension_at(c)
    s = Stress(*map(_merged, met.ends, block.stress(inner, every.creep_at(c))))
    tension = _merged(at.tension, inner)
    shares = _merged(at.shares, every.start + c * every.width)
    g = at.ratio - block.compliance * at.tension[0]
    pull = at.tension[0] - at.tension[-1]
    work = pull * (g + 0.5 * pull * block.compliance) / block.width
    work = work - 0.5 * block.shear * (s.stress[-1] ** 2 - s.stress[0] ** 2)
    size = np.abs(s.slip)
    # by the place along the arc: x' = u' - c tau', tau' by creep and tension
    growth = at.ratio - block.compliance * tension
    rise = _rise(block, s, growth)
    steep = growth - block.shear * rise
    apart = np.diff(shares, axis=0) * block.length
    grows, slips = rise * np.sign(s.stress), steep * np.sign(s.slip)
    growths = grows[:-1] * apart, grows[1:] * apart
    peak, where = _largest_stress(block, every, looks, np.abs(s.stress), growths)
    largest_slip = _tops(size, (slips[:-1] * apart, slips[1:] * apart)).max(axis=0)
    outside = np.full(len(block), np.nan)
    known = np.flatnonzero(np.isfinite(furthest))
    if len(known):
        limits = (lowest[known], highest[known], furthest[known])
        some = [column.take(known, axis=-1) for column in (shares, tension, size)]
        part, along = block.rows(known), every.take_rows(known)
        outside[known] = _outside(part, along, looks, some[0], some[1], some[2], limits)
    steepest = np.abs(steep).max(axis=0)
    exact = np.flatnonzero(timed)
    if len(exact):
        part, along = block.rows(exact), every.take_rows(exact)
        growth = np.abs(steep.take(exact, axis=-1))
        found = _steepest(part, along, looks, at.ratio[exact], growth)
        steepest[exact] = np.maximum(steepest[exact], found)
    return {
        row.LOG_RATIO: np.log(at.tension[-1] / at.tension[0]),
        row.EXIT_CREEP: at.creep[-1],
        row.EXIT_SLIP: s.slip[-1],
        row.EXIT_STRESS: s.stress[-1],
        row.ENTRY_STRESS: s.stress[0],
        row.WORK: work,
        row.CREEP_RATIO: g,
        row.STUCK_LENGTH: _stuck(block, every, looks, size) * block.length,
        row.PEAK_STRESS: peak,
        row.PEAK_AT: where * block.length,
        row.ACTIVE: (1.0 - _begins(at, every)) * block.length,
        row.OUTSIDE: outside,
        row.LARGEST_SLIP: largest_slip,
        row.STEEPEST_SLIP: steepest,
    }


def _merged(ends: Array, between: Array) -> Array:
    """What is at the ends of elements, and at places between them, in order."""
    parts = len(between) + 1
    out = np.empty((parts * (len(ends) - 1) + 1, ends.shape[1]))
    for k, row_of in enumerate((ends, *between)):
        out[k::parts] = row_of
    return out


def _cell(
    every: Curves, looks: Array, low: Integers, rows: Integers
) -> tuple[Curves, Array, Array]:
    """Elements that hold cells between samples, and the fractions that these begin and end at."""
    parts = len(looks) - 1
    part = every.take(low // parts * every.start.shape[1] + rows)
    return part, looks[low % parts], looks[low % parts + 1]


def _rise(block: Block, s: Stress, growth: Array) -> Array:
    """How traction grows along the arc where creep does so [Pa/m]."""
    return s.by_creep * growth - s.by_pressure * (block.width / block.area) * s.stress


def _tops(size: Array, rise: tuple[Array, Array]) -> Array:
    """Largest value between samples next to each other, by cubics, shape (samples - 1, n).

    `rise` has the slopes at the beginnings and at the ends, times the distance.
    """
    (f_a, f_b), (d_a, d_b) = (size[:-1], size[1:]), rise
    return np.where((d_a > 0.0) & (d_b < 0.0), _top(f_a, f_b, d_a, d_b)[1], np.maximum(f_a, f_b))


def _top(f_a: Array, f_b: Array, d_a: Array, d_b: Array) -> tuple[Array, Array]:
    """Place from 0 to 1 and value of the top of the cubic through two values and slopes."""
    square, cube = 3.0 * (f_b - f_a) - 2.0 * d_a - d_b, d_a + d_b - 2.0 * (f_b - f_a)
    root = np.sqrt(np.maximum(square * square - 3.0 * cube * d_a, 0.0))
    at = _inside(d_a / (root - square))
    return at, f_a + at * (d_a + at * (square + at * cube))


def _inside(share: Array) -> Array:
    return np.where((share > 0.0) & (share < 1.0), share, 0.5)


def _largest_stress(
    block: Block, every: Curves, looks: Array, size: Array, rise: tuple[Array, Array]
) -> tuple[Array, Array]:
    """Largest magnitude of shear stress [Pa], and its place as a share of the arc.

    Between the two samples that promise most: where the slope of the cubic through two values and
    slopes is nothing, and where two tangents meet, should a kink lie there.

    Parameters
    ----------
    block, every, looks
        Arcs, their elements, and where these are looked at.
    size, rise
        Magnitude at the samples; its growth to the next by the slopes here and there [Pa].
    """
    rows = np.arange(len(block))
    low = _tops(size, rise).argmax(axis=0)
    f_a, f_b = size[low, rows], size[low + 1, rows]
    part, a, b = _cell(every, looks, low, rows)
    d_a, d_b = (slopes[low, rows] / (b - a) for slopes in rise)
    length = part.width * block.length
    most, where = np.maximum(f_a, f_b), np.where(f_b > f_a, b, a)
    for k in range(2 * NEARER):
        h = b - a
        meet = _inside((f_b - d_b * h - f_a) / ((d_a - d_b) * h))
        c = a + h * (meet if k % 2 else _top(f_a, f_b, h * d_a, h * d_b)[0])
        s = block.stress(part.tension_at(c), part.creep_at(c))
        f = np.abs(s.stress)
        d = _rise(block, s, part.ratio(c, block.length)) * np.sign(s.stress) * length
        higher, grows = f > most, d > 0.0
        most, where = np.where(higher, f, most), np.where(higher, c, where)
        a, f_a, d_a = (np.where(grows, *pair) for pair in ((c, a), (f, f_a), (d, d_a)))
        b, f_b, d_b = (np.where(grows, *pair) for pair in ((b, c), (f_b, f), (d_b, d)))
    return most, part.start + where * part.width


def _steepest(block: Block, every: Curves, looks: Array, ratio: Array, size: Array) -> Array:
    """Largest growth of slip per length, also between samples, shape (n,) [-].

    It has tops, and jumps where the law has a kink. Looked at closer and closer are the cells in
    which it is largest if it goes on as beside them, for one side of a jump is as it is there.

    Parameters
    ----------
    block, every, looks
        Arcs, their elements, and where these are looked at.
    ratio
        K, shape (n,) [-].
    size
        Growth of slip at the samples [-].
    """
    n, cells = len(block), len(size) - 1
    rows = np.arange(n)
    shares = _merged(
        np.concatenate([every.start, every.start[-1:] + every.width[-1:]]),
        every.start + looks[1:-1, None, None] * every.width,
    )
    promise = _promise(size, np.diff(shares, axis=0))
    which = np.argsort(-promise, axis=0, kind="stable")[: min(CELLS, cells)]
    place, parts = which // (len(looks) - 1), which % (len(looks) - 1)
    part = every.take(place * n + rows)
    low, high = looks[parts], looks[parts + 1]
    most = size.max(axis=0)
    inner = np.linspace(0.0, 1.0, INNER + 1)[:, None, None]
    for _ in range(CLOSER_LOOKS):
        c = low + (high - low) * inner
        f = _slip_growth(block, part, ratio, c)
        most = np.maximum(most, f.max(axis=(0, 1)))
        best = _promise(f, np.diff(c, axis=0)).argmax(axis=0)
        first = np.clip(best - 1, 0, INNER - 3)
        wide = (high - low) / INNER
        low = low + first * wide
        high = low + 3.0 * wide
    return np.asarray(most)


def _slip_growth(block: Block, part: Curves, ratio: Array, c: Array) -> Array:
    """Magnitude of x' at fractions of elements [-]; 0 where the belt does not slip."""
    tension = part.tension_at(c)
    s = block.stress(tension, part.creep_at(c))
    growth = ratio - block.compliance * tension
    return np.where(s.slip == 0.0, 0.0, np.abs(growth - block.shear * _rise(block, s, growth)))


def _promise(size: Array, apart: Array) -> Array:
    """Largest value between samples if it goes on as beside, shape (samples - 1, n)."""
    slope = np.diff(size, axis=0) / apart
    most = np.maximum(size[:-1], size[1:])
    most[1:] = np.maximum(most[1:], size[1:-1] + slope[:-1] * apart[1:])
    most[:-1] = np.maximum(most[:-1], size[1:-1] - slope[1:] * apart[:-1])
    return most


def crossing(
    value: Callable[[Array], Array], low: Array, high: Array, f_low: Array, f_high: Array
) -> Array:
    """Where values cross nothing between two places: the Illinois method."""
    at, before = low, np.zeros(len(low))
    for _ in range(REGULA):
        span = f_low - f_high
        share = f_low / np.where(span == 0.0, 1.0, span)
        at = low + (high - low) * np.minimum(np.maximum(share, 0.0), 1.0)
        f = value(at)
        same = (f > 0.0) == (f_low > 0.0)
        # an end that is kept twice counts half
        f_high = np.where(same, np.where(before > 0.0, 0.5, 1.0) * f_high, f)
        f_low = np.where(same, f, np.where(before < 0.0, 0.5, 1.0) * f_low)
        low, high = np.where(same, at, low), np.where(same, high, at)
        before = np.where(same, 1.0, -1.0)
    return at


def _begins(at: Courses, every: Curves) -> Array:
    """Where the active arc begins, as a share of the arc."""
    n = len(at.ratio)
    change = at.tension[0] - at.tension[-1]
    goal = at.tension[0] - ACTIVE_SHARE * change
    before = (at.tension[0] - at.tension) * np.sign(change) <= ACTIVE_SHARE * np.abs(change)
    # the last element that begins with less
    place = len(before) - 2 - before[-2::-1].argmax(axis=0)
    rows = np.arange(n)
    part, ends = (
        every.take(place * n + rows),
        (at.tension[place, rows], at.tension[place + 1, rows]),
    )
    f_low, f_high = (t - goal for t in ends)
    c = crossing(lambda c: part.tension_at(c) - goal, np.zeros(n), np.ones(n), f_low, f_high)
    return np.asarray(np.where(change == 0.0, 1.0, part.start + part.width * c))


def _stuck(block: Block, every: Curves, looks: Array, slip: Array) -> Array:
    """Entry part of the arc at rest under a law that jumps, as a share of it."""
    out = np.zeros(len(block))
    held = slip == 0.0
    which = np.flatnonzero(held[0] & held[1])
    if not len(which):
        return out
    count = held.take(which, axis=1).cumprod(axis=0).sum(axis=0)
    # between the last sample that rests and the next; the end of the arc where all rest
    last = len(slip) - 1
    all_rest = count > last
    first = np.minimum(count - 1, last - 1)
    (part, low, high), rows = _cell(every, looks, first, which), block.rows(which)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        rests = rows.stress(part.tension_at(middle), part.creep_at(middle)).slip == 0.0
        low, high = np.where(rests, middle, low), np.where(rests, high, middle)
    out[which] = np.where(all_rest, 1.0, part.start + part.width * low)
    return out


def _outside(
    block: Block,
    every: Curves,
    looks: Array,
    shares: Array,
    tension: Array,
    slip: Array,
    limits: tuple[Array, Array, Array],
) -> Array:
    """Share of an arc outside the tested range: between samples, up to where they cross a limit."""
    n = len(block)
    lowest, highest, furthest = limits
    low, high = np.zeros((len(shares) - 1, n)), np.ones((len(shares) - 1, n))
    for sign, most in ((-1.0, lowest * block.area), (1.0, highest * block.area), (0.0, furthest)):
        f = sign * (tension - most) if sign else slip - most
        out = f > 0.0
        if not out.any():
            continue
        high[out[:-1] & out[1:]] = -1.0
        where, rows = np.nonzero(out[:-1] != out[1:])
        if not len(rows):
            continue
        (part, a, b), cells = _cell(every, looks, where, rows), (where, rows)
        over = partial(_over, block.rows(rows), part, sign, most[rows])
        place = (crossing(over, a, b, f[cells], f[where + 1, rows]) - a) / (b - a)
        leaves = out[cells]
        low[cells] = np.where(leaves, np.maximum(low[cells], place), low[cells])
        high[cells] = np.where(leaves, high[cells], np.minimum(high[cells], place))
    beyond = (1.0 - np.maximum(high - low, 0.0)) * np.diff(shares, axis=0)
    # one after the other: a sum in pairs would depend on how many rows there are
    return np.asarray(reduce(np.add, beyond))


def _over(block: Block, part: Curves, sign: float, most: Array, c: Array) -> Array:
    """How far a tension is over a limit, or below it, or else slip over it."""
    tension = part.tension_at(c)
    if sign:
        return sign * (tension - most)
    return np.abs(block.stress(tension, part.creep_at(c)).slip) - most
