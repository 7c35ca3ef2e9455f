"""Many wrap arcs as two-point problems: :mod:`wraparc.arc.collocation` over columns.

The same equations, end conditions and Newton's method; an element, its stages and the rows are axes
of arrays, the rows the last. All rows of a block have one mesh, graded to the entry, and laws of
one kind. What a mesh is too coarse for is said row by row (`Solved.misfit`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from typing import NamedTuple

import numpy as np

from wraparc.arc.collocation import (
    A00,
    A01,
    A02,
    A10,
    A11,
    A12,
    A20,
    A21,
    A22,
    B0,
    B1,
    B2,
    C0,
    C1,
    C2,
    GRADING,
    LEAST_LEFT,
    MOST_USED,
    TENSION,
    stage_matrix,
)
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch.traction import Laws, Stress

SPREAD = 1.0 / 3.0
#: Tension at the end of an element by those at its stages, less that at its start: b A^-1.
F0, F1, F2 = 5.0 / 3.0, -4.0 / 3.0, 5.0 / 3.0
_NODES = np.array([C0, C1, C2])
#: Coefficients of c, c^2, c^3 by the values at the stages: of the cubic through them and nothing at
#: the start; of the integral from there of the parabola through them.
_THROUGH = np.linalg.inv(_NODES[:, None] ** np.arange(1, 4)).tolist()
_BELOW = (np.linalg.inv(_NODES[:, None] ** np.arange(3)) / np.arange(1, 4)[:, None]).tolist()
#: First guess of the creep: from [m], in steps of a factor, upwards at most, nearer then.
LEAST_FIRST, WIDER, UPWARDS, BETWEEN = 1e-7, 8.0, 8, 3
IN_CACHE = 32_000  # numbers of an array
STEPS = 14  # of Newton's method: 4 to 8 are usual


@dataclass(frozen=True, eq=False, kw_only=True)
class Block:
    """Arcs whose laws are of one kind, each number of shape (n,); see `Geometry`.

    Attributes
    ----------
    laws
        Their laws.
    side, radius, length, width
        +1 driving or -1, R, R phi and B [m].
    compliance, shear
        1/EA' [1/N] and h/G [m/Pa].
    overrun_constant, overrun_coefficient
        Overrun overrun_constant + overrun_coefficient p1^1.5 [m, m/Pa^1.5].
    """

    laws: Laws
    side: Array
    radius: Array
    length: Array
    width: Array
    compliance: Array
    shear: Array
    overrun_constant: Array
    overrun_coefficient: Array

    def rows(self, which: Integers) -> Block:
        """Some of the arcs, also several times."""
        if len(which) == len(self) and (which == np.arange(len(self))).all():
            return self
        columns = {f.name: getattr(self, f.name)[which] for f in fields(self) if f.name != "laws"}
        return replace(self, laws=self.laws.rows(which), **columns)

    def __len__(self) -> int:
        return len(self.side)

    @property
    def area(self) -> Array:
        """B R: tension over wrap pressure [m2]."""
        return self.width * self.radius

    def overrun(self, tension: Array) -> tuple[Array, Array]:
        """Overrun at entry tensions [m], and its slope by them [m/N]."""
        grown = self.overrun_coefficient * (tension / self.area) ** 1.5
        return self.overrun_constant + grown, 1.5 * grown / tension

    def stress(self, tension: Array, creep: Array) -> Stress:
        """Traction at tensions and creeps, shape (points, n)."""
        found = [
            some.laws.stress(some.shear, tension[..., part] / some.area, creep[..., part])
            for part, some in self.parts(tension.size // len(self) if len(self) else 1)
        ]
        return found[0] if len(found) == 1 else Stress(*map(_joined, zip(*found, strict=True)))

    def parts(self, points: int) -> Iterator[tuple[slice, Block]]:
        """Parts of the rows, of so many that arrays of so many points a row stay in the cache."""
        size = max(1, IN_CACHE // points)
        if len(self) <= size:
            yield slice(None), self
            return
        for start in range(0, len(self), size):
            part = slice(start, start + size)
            columns = {f.name: getattr(self, f.name)[part] for f in fields(self)[1:]}
            yield part, replace(self, laws=self.laws.rows(part), **columns)


class Ends(NamedTuple):
    """What is asked at the ends: see `wraparc.arc.collocation.Ends`; the kind is that of all.

    SLIP is asked as CREEP, its goal moved with the tension there: `slip` is that slip, or nan.
    """

    at_entry: Array
    at_exit: Array
    tension: Array
    kind: int
    goal: Array
    slip: Array

    def rows(self, which: slice | Integers) -> Ends:
        """Those of some of the rows."""
        return Ends(
            self.at_entry[which],
            self.at_exit[which],
            self.tension[which],
            self.kind,
            self.goal[which],
            self.slip[which],
        )


class Courses(NamedTuple):
    """Creep and tension along arcs; see `wraparc.arc.collocation.Course`.

    Attributes
    ----------
    shares, creep, tension
        Of the ends of elements, shape (elements + 1, n): place as a share of the arc [-, m, N].
    stage
        Tensions at the stages, shape (3, elements, n) [N].
    ratio
        K, shape (n,) [-].
    """

    shares: Array
    creep: Array
    tension: Array
    stage: Array
    ratio: Array

    def rows(self, which: Integers) -> Courses:
        """Those of some of the rows."""
        if len(which) == len(self.ratio):
            return self
        return Courses(*(column.take(which, axis=-1) for column in self))


class Curves(NamedTuple):
    """Elements of courses as polynomials of the fraction c of an element, any shape.

    Attributes
    ----------
    start, width
        Where an element begins and how long it is, as shares of the arc [-].
    creep, tension
        Coefficients of the powers of c, from the constant on [m, N].
    """

    start: Array
    width: Array
    creep: tuple[Array, ...]
    tension: tuple[Array, ...]

    def take(self, place: Integers) -> Curves:
        """Those at places of the flattened arrays."""
        return Curves(
            self.start.take(place),
            self.width.take(place),
            tuple(k.take(place) for k in self.creep),
            tuple(k.take(place) for k in self.tension),
        )

    def take_rows(self, which: Integers) -> Curves:
        """Those of some of the rows."""
        n = self.start.shape[-1]
        if len(which) == n:
            return self
        return self.take(which + n * np.arange(len(self.start))[:, None])

    def creep_at(self, c: Array) -> Array:
        """Creep at a fraction of an element [m]."""
        u0, u1, u2, u3 = self.creep
        return u0 + c * (u1 + c * (u2 + c * u3))

    def ratio(self, c: Array, length: Array) -> Array:
        """How creep grows along the arc at a fraction of an element [-]."""
        _, u1, u2, u3 = self.creep
        return (u1 + c * (2.0 * u2 + 3.0 * c * u3)) / (self.width * length)

    def tension_at(self, c: Array) -> Array:
        """Tension at a fraction of an element [N]."""
        t0, t1, t2, t3 = self.tension
        return t0 + c * (t1 + c * (t2 + c * t3))


def curves(block: Block, at: Courses) -> Curves:
    """Polynomials of every element, shape (elements, n).

    Tension through the start and the three stages; creep by the integral of the parabola through
    the stages.
    """
    width = np.diff(at.shares, axis=0)
    h = width * block.length
    k, t0 = at.stage, at.tension[:-1]
    d = k - t0
    through = [m[0] * d[0] + m[1] * d[1] + m[2] * d[2] for m in _THROUGH]
    fall = h * block.compliance
    below = [fall * (m[0] * k[0] + m[1] * k[1] + m[2] * k[2]) for m in _BELOW]
    creep = (at.creep[:-1], h * at.ratio - below[0], -below[1], -below[2])
    return Curves(at.shares[:-1], width, creep, (t0, *through))


def mesh(elements: int) -> Array:
    """Ends of elements as shares of the arc, shape (elements + 1,)."""
    return np.asarray((np.arange(elements + 1) / elements) ** GRADING)


def stage_shares(shares: Array) -> Array:
    """Places of the stages as shares of the arc, shape (3, elements, n)."""
    width = np.diff(shares, axis=0)
    return np.stack([shares[:-1] + c * width for c in (C0, C1, C2)])


def mean_creep(block: Block, entry: Array, leaving: Array, used: float = MOST_USED) -> Array:
    """Creep at which the mean friction of an arc is used at its mean tension [m].

    At most the share `used` of the largest friction there is.
    """
    tension, fall = np.sqrt(entry * leaving), np.abs(np.log(entry / leaving))
    p = tension / block.area
    needed = fall * block.radius / block.length * p
    needed = np.minimum(needed, used * block.laws.plateau(p) * p)
    # the first creep that does, for friction may fall again
    shape = UPWARDS + 1, len(block)
    creeps = np.broadcast_to(LEAST_FIRST * WIDER ** np.arange(UPWARDS + 1.0)[:, None], shape)
    f = block.stress(np.broadcast_to(tension, shape), creeps).stress
    first = (f[:-1] < needed).cumprod(axis=0).sum(axis=0)
    rows = np.arange(len(block))
    high, f_high = creeps[first, rows], f[first, rows]
    f_low = np.where(first > 0, f[first - 1, rows], 0.0)
    # then by a power of the creep between two
    low = high / WIDER
    for _ in range(BETWEEN):
        share = np.log(needed / f_low) / np.log(f_high / f_low)
        middle = low * (high / low) ** np.where((share > 0.0) & (share < 1.0), share, 0.5)
        f = block.stress(tension, middle).stress
        less = f < needed
        low, high = np.where(less, middle, low), np.where(less, high, middle)
        f_low, f_high = np.where(less, f, f_low), np.where(less, f_high, f)
    return np.where(needed > 0.0, high, 0.0)


def first_courses(block: Block, entry: Array, leaving: Array, end: Array, elements: int) -> Courses:
    """First guesses: tension falls evenly, creep grows to `end` [m] evenly from the overrun."""
    shares = np.broadcast_to(mesh(elements)[:, None], (elements + 1, len(block)))
    fall = np.log(entry / leaving)
    start = block.overrun(entry)[0]
    creep = end - start
    return Courses(
        shares,
        start + shares * creep,
        entry * np.exp(-shares * fall),
        entry * np.exp(-stage_shares(shares) * fall),
        creep / block.length + block.compliance * 0.5 * (entry + leaving),
    )


def stage_creeps(block: Block, steps: Array, at: Courses) -> Array:
    """Creeps at the stages, shape (3, elements, n) [m]; `steps` are lengths of elements [m]."""
    k0, k1, k2 = at.stage
    u, hk, hc = at.creep[:-1], steps * at.ratio, steps * block.compliance
    return np.stack(
        [
            u + C0 * hk - hc * (A00 * k0 + A01 * k1 + A02 * k2),
            u + C1 * hk - hc * (A10 * k0 + A11 * k1 + A12 * k2),
            u + C2 * hk - hc * (A20 * k0 + A21 * k1 + A22 * k2),
        ]
    )


class _Linear(NamedTuple):
    """Elements made linear: stages (4 x 3) and ends (4 x 2) by constant, du, dT, dK."""

    stages: list[tuple[Array, Array, Array]]
    creep: list[Array]
    tension: list[Array]


def _condensed(block: Block, steps: Array, at: Courses) -> _Linear:
    hb, hc = steps * block.width, steps * block.compliance
    u, tension = at.creep[:-1], at.tension[:-1]
    k0, k1, k2 = at.stage
    s = block.stress(at.stage, stage_creeps(block, steps, at))
    (f0, f1, f2), (v0, v1, v2) = s.stress, s.by_creep
    _, a, det = stage_matrix(hb, hc, (v0, v1, v2), tuple(s.by_pressure / block.area))
    a00, a01, a02, a10, a11, a12, a20, a21, a22 = a
    over = 1.0 / det
    h0, h1, h2 = C0 * steps * v0, C1 * steps * v1, C2 * steps * v2
    right = (
        (
            tension - k0 - hb * (A00 * f0 + A01 * f1 + A02 * f2),
            tension - k1 - hb * (A10 * f0 + A11 * f1 + A12 * f2),
            tension - k2 - hb * (A20 * f0 + A21 * f1 + A22 * f2),
        ),
        (
            -hb * (A00 * v0 + A01 * v1 + A02 * v2),
            -hb * (A10 * v0 + A11 * v1 + A12 * v2),
            -hb * (A20 * v0 + A21 * v1 + A22 * v2),
        ),
        None,
        (
            -hb * (A00 * h0 + A01 * h1 + A02 * h2),
            -hb * (A10 * h0 + A11 * h1 + A12 * h2),
            -hb * (A20 * h0 + A21 * h1 + A22 * h2),
        ),
    )
    found = _Linear([], [], [])
    for column in right:
        if column is None:  # the tension at the start is that of every stage
            y0 = (a00 + a01 + a02) * over
            y1 = (a10 + a11 + a12) * over
            y2 = (a20 + a21 + a22) * over
        else:
            q0, q1, q2 = column
            y0 = (a00 * q0 + a01 * q1 + a02 * q2) * over
            y1 = (a10 * q0 + a11 * q1 + a12 * q2) * over
            y2 = (a20 * q0 + a21 * q1 + a22 * q2) * over
        found.stages.append((y0, y1, y2))
        found.creep.append(-hc * (B0 * y0 + B1 * y1 + B2 * y2))
        found.tension.append(F0 * y0 + F1 * y1 + F2 * y2)
    found.creep[0] += u + steps * at.ratio - hc * (B0 * k0 + B1 * k1 + B2 * k2) - at.creep[1:]
    found.tension[0] += F0 * k0 + F1 * k1 + F2 * k2 - tension - at.tension[1:]
    found.creep[1] += 1.0
    found.tension[2] -= 1.0
    found.creep[3] += steps
    return found


class Step(NamedTuple):
    """One Newton step of every row.

    Attributes
    ----------
    courses
        The courses after it.
    change
        Largest change of a tension, of the largest there is.
    grows, by_entry, by_exit
        See `Solved`.
    """

    courses: Courses
    change: Array
    grows: Array
    by_entry: Array
    by_exit: Array


def improved(block: Block, ends: Ends, at: Courses) -> Step:
    """One Newton step of every row."""
    steps = [
        _improved(some, ends.rows(part), Courses(*(column[..., part] for column in at)))
        for part, some in block.parts(at.stage.size // len(block))
    ]
    if len(steps) == 1:
        return steps[0]
    courses, *more = zip(*steps, strict=True)
    return Step(Courses(*map(_joined, zip(*courses, strict=True))), *map(_joined, more))


def _joined(parts: Sequence[Array]) -> Array:
    return np.concatenate(parts, axis=-1)


def _improved(block: Block, ends: Ends, at: Courses) -> Step:
    steps = np.diff(at.shares, axis=0) * block.length
    linear = _condensed(block, steps, at)
    overrun, by_tension = block.overrun(at.tension[0])
    b, r, d = -by_tension, overrun - at.creep[0], np.zeros(len(block))
    back = []
    for s0, s1, s2, s3, z0, z1, z2, z3 in zip(*linear.creep, *linear.tension, strict=True):
        over = 1.0 / (z2 - z1 * b)
        rt, kt = (z0 + z1 * r) * over, (z3 + z1 * d) * over
        back.append((r, d, b, rt, kt, over))
        turn = s2 - s1 * b
        b, r, d = -turn * over, s0 + s1 * r - turn * rt, s3 + s1 * d - turn * kt
    end, end_k = _exit(block, ends, at, b, r, d)
    first, first_k, through = end, end_k, np.ones(len(block))
    for _, _, _, rt, kt, over in reversed(back):
        first, first_k, through = over * first - rt, over * first_k - kt, over * through
    short = ends.tension - ends.at_entry * at.tension[0] - ends.at_exit * at.tension[-1]
    slope = ends.at_entry * first_k + ends.at_exit * end_k
    dk = (short - ends.at_entry * first - ends.at_exit * end) / slope
    dt = np.empty_like(at.tension)
    du = np.empty_like(at.creep)
    dt[-1] = end + end_k * dk
    du[-1] = r + d * dk - b * dt[-1]
    for i in range(len(back) - 1, -1, -1):
        r, d, b, rt, kt, over = back[i]
        dt[i] = over * dt[i + 1] - rt - kt * dk
        du[i] = r + d * dk - b * dt[i]
    change = np.stack(
        [
            y0 + y1 * du[:-1] + y2 * dt[:-1] + y3 * dk
            for y0, y1, y2, y3 in zip(*linear.stages, strict=True)
        ]
    )
    moved = Courses(
        at.shares,
        at.creep + du,
        np.maximum(at.tension + dt, LEAST_LEFT * at.tension),
        np.maximum(at.stage + change, LEAST_LEFT * at.stage),
        at.ratio + dk,
    )
    most = np.maximum(np.abs(change).max(axis=(0, 1)), np.abs(dt).max(axis=0))
    grows = slope if ends.kind == TENSION else slope / np.where(block.side > 0.0, first_k, end_k)
    change = most / np.maximum(at.tension[0], at.tension[-1])
    return Step(moved, change, grows, 1.0 / first_k, -through / first_k)


def _exit(
    block: Block, ends: Ends, at: Courses, b: Array, r: Array, d: Array
) -> tuple[Array, Array]:
    """Change of tension at the exit: constant, and by dK."""
    if ends.kind == TENSION:
        return ends.goal - at.tension[-1], np.zeros(len(block))
    goal, by_tension = ends.goal, np.zeros(len(block))
    slips = np.isfinite(ends.slip)
    if slips.any():
        p = at.tension[-1] / block.area
        s = block.laws.stress(np.zeros(len(block)), p, ends.slip)
        goal = np.where(slips, ends.slip + block.shear * s.stress, goal)
        by_tension = np.where(slips, -block.shear * s.by_pressure / block.area, 0.0)
    free = by_tension - b
    return (goal - at.creep[-1] - r) / free, -d / free


class Solved(NamedTuple):
    """Courses that met their ends, and how well.

    Attributes
    ----------
    courses, curves
        The courses, and their polynomials.
    met
        Whether Newton's method settled.
    grows
        > 0 where the tension at the entry grows with creep (the branch on which friction is not yet
        exhausted); at a creep that is asked, where what is carried does with the tight side.
    by_entry, by_exit
        How K changes with the tensions at both ends where these are given [1/N].
    ends
        Traction at the ends of elements, shape (elements + 1, n).
    misfit
        How far the slope of the tension misses the traction at the ends of elements, as a tension,
        of the largest change of tension along the arc; where a creep is asked, of the tension
        there; shape (elements, n) [-].
    """

    courses: Courses
    curves: Curves
    met: Flags
    grows: Array
    by_entry: Array
    by_exit: Array
    ends: Stress
    misfit: Array

    def rows(self, which: Integers) -> Solved:
        """Those of some of the rows."""
        if len(which) == len(self.met):
            return self
        return Solved(
            self.courses.rows(which),
            self.curves.take_rows(which),
            self.met[which],
            self.grows[which],
            self.by_entry[which],
            self.by_exit[which],
            Stress(*(column.take(which, axis=-1) for column in self.ends)),
            self.misfit.take(which, axis=-1),
        )


def solved(block: Block, ends: Ends, start: Courses, near: float) -> Solved:
    """Newton's method until a step changes no tension by `near` of the largest.

    A row keeps what it had when it was done, whatever it is solved with.
    """
    out, n = start, len(block)
    met, which = np.zeros(n, dtype=bool), np.arange(n)
    slopes = np.full((3, n), np.nan)
    for _ in range(STEPS):
        step = improved(block.rows(which), ends.rows(which), out.rows(which))
        if len(which) == n:
            out = step.courses
        else:
            for old, new in zip(out[1:], step.courses[1:], strict=True):
                _put(old, which, new)
        slopes[:, which], met[which] = step[2:], step.change < near
        which = which[(step.change < 1e4) & ~(step.change < near)]
        if not len(which):
            break
    along = curves(block, out)
    at_ends = block.stress(out.tension, out.creep)
    misfit = misfits(block, along, at_ends.stress)
    if ends.kind == TENSION:
        size = np.abs(out.tension - out.tension[0]).max(axis=0)
        misfit /= np.maximum(size, 1e-6 * out.tension[0])
    else:
        misfit /= np.minimum(out.tension[:-1], out.tension[1:])
    grows, by_entry, by_exit = slopes
    return Solved(out, along, met, grows, by_entry, by_exit, at_ends, misfit)


def _put(old: Array, which: Integers, new: Array) -> None:
    """Put columns in their places, row by row: all at once takes three times as long."""
    n = old.shape[-1]
    for row, told in zip(old.reshape(-1, n), new.reshape(-1, len(which)), strict=True):
        row[which] = told


def misfits(block: Block, along: Curves, stress: Array) -> Array:
    """See `Solved.misfit`, as a tension [N]; `stress` is that at the ends [Pa]."""
    pull = along.width * (block.length * block.width)
    _, t1, t2, t3 = along.tension
    left = np.abs(t1 + pull * stress[:-1])
    right = np.abs(t1 + 2.0 * t2 + 3.0 * t3 + pull * stress[1:])
    return np.maximum(left, right)


def spread(shares: Array, misfit: Array, elements: int) -> Array:
    """Ends of elements that share the misfit evenly, shape (elements + 1, n).

    Of an element it falls with the fourth power of its length, with the square where a kink lies in
    it: in between is best for both.
    """
    parts = np.maximum(misfit, 1e-16) ** SPREAD
    parts = np.maximum(parts, 0.02 * parts.max(axis=0))
    done = np.zeros_like(shares)
    for i, part in enumerate(parts):
        np.add(done[i], part, out=done[i + 1])
    done /= done[-1]
    wanted = (np.arange(1, elements) / elements)[:, None]
    cell = _cells_of(done, wanted)
    low, a = done.take(cell), shares.take(cell)
    cell += shares.shape[1]
    inner = a + (shares.take(cell) - a) * (wanted - low) / (done.take(cell) - low)
    return np.concatenate([shares[:1], inner, shares[-1:]])


def _cells_of(ends: Array, at: Array) -> Integers:
    """Places of cells, between ends of shape (cells + 1, n), that hold points (points, n or 1)."""
    n = ends.shape[1]
    place = np.zeros((len(at), n), dtype=np.uint8)
    for end in ends[1:-1]:
        place += at >= end
    cell = place.astype(np.int64)
    cell *= n
    cell += np.arange(n)
    return cell


def on_mesh(at: Courses, every: Curves, shares: Array) -> Courses:
    """Courses, and their polynomials, on other meshes."""
    n = shares.shape[1]
    ends = every.take(_cells_of(at.shares, shares))
    c = (shares - ends.start) / ends.width
    creep, tension = ends.creep_at(c), ends.tension_at(c)
    creep[-1], tension[-1] = at.creep[-1], at.tension[-1]
    places = stage_shares(shares)
    inner = every.take(_cells_of(at.shares, places.reshape(-1, n)))
    stage = inner.tension_at((places.reshape(-1, n) - inner.start) / inner.width)
    return Courses(shares, creep, tension, stage.reshape(places.shape), at.ratio)
