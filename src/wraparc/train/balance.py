"""The tensions of many trains from what turns their drums: all arcs of all rows side by side.

The unknowns are the tensions between the pulleys. Each arc is solved for its tensions by the batch
kernel, which gives its entry creep ratio and how that answers to them; the speed that each drum
then asks of the belt,

    L = -ln(1 - g) + ln(1 + T1/EA) - ln(1 - delta/R) - ln(omega(M) R),

must be the same for all drums, and a torque that follows another must do so. Between two drums L of
the second less that of the first rises with the tension between them, past breakaway to infinity:
the root is kept in a bracket and none can be missed. Between more, Newton's method alone; what it
does not find is left to the solver of one train.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from wraparc.arc.quantities import BREAKAWAY, SOLVED, jumps
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import Setting, row
from wraparc.batch.scaled import solve_scaled
from wraparc.train.rows import Followers, TrainRows

#: Miss of a speed equation that counts as none, by setting [-].
MISSES = {Setting.ENGINEERING: 1e-8, Setting.PRECISE: 1e-11}
_SCALE = 1e-2  # miss from which on misses are counted by their logarithm: creep is exponential
_LEAST, _MOST = 1e-5, 30.0  # tensions between the drums, over the largest at the ends
_CLOSE = 1e-12  # width of a bracket that holds one number, over the largest tension
_FIRST_STEP = 0.03  # of the total pull
_DIFFERENCE = 1e-5  # of a tension, for slopes
_CLOSINGS, _NEWTON_STEPS, _HALVINGS = 80, 25, 10


class Arcs(NamedTuple):
    """Arcs of trains between tensions, shape (k, turned) each.

    Attributes
    ----------
    ratio
        Entry creep ratios, inf towards the slack side where an arc breaks away, else nan [-].
    by_entry, by_exit
        How they change with the tensions at both ends, nan where that is not known [1/N].
    """

    ratio: Array
    by_entry: Array
    by_exit: Array


@dataclass(frozen=True, eq=False)
class Balanced:
    """Tensions of trains.

    Attributes
    ----------
    between
        Tensions behind all pulleys but the last, shape (n, drums - 1) [N].
    found
        Which trains have a balance (an arc may break away at given pulls), shape (n,).
    fallen
        Which drums break away where there is none, shape (n, drums).
    unsure
        Trains left to the solver of one train, shape (n,).
    """

    between: Array
    found: Flags
    fallen: Flags
    unsure: Flags


def balance(equations: Equations, shares: tuple[float, ...]) -> Balanced:
    """Return the tensions of trains, looked for from shares of the drums [-]."""
    rows = equations.rows
    n, count = len(rows), equations.count
    pulls = rows.pulls
    if pulls is None:
        pulls = np.array(shares) * rows.total[:, None]
    before = np.cumsum(pulls, axis=1)[:, :-1] - np.cumsum(rows.drums["run"], axis=1)[:, :-1]
    between = rows.whole["entry_tension"][:, None] - before
    none, nobody = np.zeros(n, dtype=bool), np.zeros((n, count), dtype=bool)
    if rows.pulls is not None or count == 1:
        return Balanced(between, ~none, nobody, none)
    if equations.rests:
        return Balanced(between, none, nobody, ~none)
    if equations.setting is Setting.PRECISE:  # the last steps are enough
        near = balance(Equations(rows, Setting.ENGINEERING), shares)
        between = np.where(near.found[:, None], near.between, between)
    if count == 2 and not equations.followers:
        return _between_two(equations, between[:, 0])
    return _newton(equations, between)


class Equations:
    """What must balance, for some or all of the rows at once."""

    def __init__(self, rows: TrainRows, setting: Setting) -> None:
        self.rows, self.setting = rows, setting
        self.arcs = rows.arcs()
        self.count = len(rows.names)
        self.followers = [i for i, m in enumerate(rows.motors) if isinstance(m, Followers)]
        self.turned = [i for i in range(self.count) if i not in self.followers]
        lift = rows.lift  # tensions are those above m v^2
        self.entry, self.exit = (rows.whole[f"{end}_tension"] - lift for end in ("entry", "exit"))
        self.largest = np.maximum(self.entry, self.exit)
        drums = rows.drums
        area = rows.whole["belt_width"][:, None] * drums["diameter"]
        self.radius = 0.5 * drums["diameter"] + rows.offsets  # R + e
        self.squeeze = 2.0 * drums["lagging_thickness"] / (drums["compression_modulus"] * area)

    @property
    def rests(self) -> bool:
        """Whether a belt rests on a drum whatever the load: no speed tells its tensions."""
        stiff = self.arcs.shear_compliance.reshape(-1, self.count) == 0.0
        laws = self.rows.bank
        return any(
            jumps(laws.compact(i)) and laws.onset_compliance[i] == 0.0 and stiff[:, i].any()
            for i in range(self.count)
        )

    def tensions(self, which: Integers, between: Array) -> tuple[Array, Array]:
        """Entry and exit tensions, shape (k, drums) each [N]."""
        first, last = self.entry[which, None], self.exit[which, None]
        entries = np.concatenate([first, between + self.rows.runs[which]], axis=1)
        return entries, np.concatenate([between, last], axis=1)

    def torques(self, which: Integers, entries: Array, exits: Array) -> Array:
        """Torques on the drums, shape (k, drums) [N m]."""
        arm = self.radius[which] - self.squeeze[which] * entries
        return np.asarray((entries - exits) * arm)

    def levels(
        self, which: Integers, between: Array, arcs: Arcs, moved: Array | None = None
    ) -> Array:
        """L of the drums that do not follow, inf of those that break away, shape (k, turned).

        With tensions that are `moved`, by the slopes of arcs between others.
        """
        entries, exits = self.tensions(which, between)
        if moved is None:
            return self.asked(which, entries, exits, arcs.ratio)
        new, left = self.tensions(which, moved)
        drums = np.array(self.turned)
        with np.errstate(invalid="ignore"):
            ratios = arcs.ratio + arcs.by_entry * (new - entries)[:, drums]
            ratios += arcs.by_exit * (left - exits)[:, drums]
        return self.asked(which, new, left, ratios)

    def asked(self, which: Integers, entries: Array, exits: Array, ratios: Array) -> Array:
        """L of the drums that do not follow, from their entry creep ratios, shape (k, turned)."""
        drums = np.array(self.turned)
        at, a = np.ix_(which, drums), entries[:, drums]
        finite = np.isfinite(ratios)
        level = np.log1p(a / self.rows.light_stiffness[which, None])
        level -= np.log1p(-self.squeeze[at] * a / self.radius[at])
        level -= np.log1p(-np.where(finite, np.minimum(ratios, 0.99), 0.0))
        speeds = self.drum_speeds(which, self.torques(which, entries, exits))[:, drums]
        return np.where(finite, level - np.log(speeds * self.radius[at]), ratios)

    def drum_speeds(self, which: Integers, torques: Array) -> Array:
        """Speeds of the drums, 1 of those that follow, shape (k, drums) [rad/s]."""
        if self.rows.speeds is not None:
            return self.rows.speeds[which]
        speeds = np.ones_like(torques)
        for i in self.turned:
            motor = self.rows.motors[i]
            assert not isinstance(motor, Followers)  # noqa: S101 - those turn as they must
            speeds[:, i] = motor.rows(which).drum_speed(torques[:, i])
        return speeds

    def solved(self, which: Integers, between: Array) -> Arcs:
        """Arcs of the drums that do not follow."""
        drums = np.array(self.turned)
        a, b = (tensions[:, drums] for tensions in self.tensions(which, between))
        places = (which[:, None] * self.count + drums).ravel()
        arcs = self.arcs.rows(places)
        arcs = replace(arcs, entry_tension=a.ravel(), exit_tension=b.ravel())
        factors = (self.rows.drums[k].ravel()[places] for k in ("friction_factor", "slip_factor"))
        found = solve_scaled(arcs, *factors, setting=self.setting, parts=row.RATIO).found
        gone = found[:, row.OUTCOME] == BREAKAWAY
        away = np.where(arcs.entry_tension >= arcs.exit_tension, np.inf, -np.inf)
        solved = np.where(found[:, row.OUTCOME] == SOLVED, found[:, row.CREEP_RATIO], np.nan)
        slopes = (found[:, place] for place in (row.RATIO_BY_ENTRY, row.RATIO_BY_EXIT))
        return Arcs(*(c.reshape(a.shape) for c in (np.where(gone, away, solved), *slopes)))

    def misses(
        self, which: Integers, between: Array, arcs: Arcs, moved: Array | None = None
    ) -> Array:
        """Misses of all equations, shape (k, drums - 1) [-]; see `levels`."""
        levels = self.levels(which, between, arcs, moved)
        with np.errstate(invalid="ignore"):
            speeds = np.diff(levels, axis=1)
        entries, exits = self.tensions(which, between if moved is None else moved)
        return np.concatenate([speeds, self.unfollowed(which, entries, exits)], axis=1)

    def unfollowed(self, which: Integers, entries: Array, exits: Array) -> Array:
        """Misses of the torques that follow others, shape (k, followers) [-]."""
        torques = self.torques(which, entries, exits)
        scale = self.largest[which] * self.radius[which, 0]
        misses = np.empty((len(which), len(self.followers)))
        for k, i in enumerate(self.followers):
            motor = self.rows.motors[i]
            assert isinstance(motor, Followers)  # noqa: S101 - see `followers`
            misses[:, k] = torques[:, i] - motor.ratio[which] * torques[:, motor.master]
        return np.asarray(misses / scale[:, None])


def _between_two(equations: Equations, start: Array) -> Balanced:
    """Close in on the tension between two drums, in every row: Newton's method in a bracket."""
    n, tolerance = len(start), MISSES[equations.setting]
    largest = equations.largest
    low = np.maximum(_LEAST * largest, _LEAST * largest - equations.rows.runs[:, 0])
    high = _MOST * largest
    x = np.clip(start, low, high)
    before, f_before = np.full(n, np.nan), np.full(n, np.nan)
    broken = np.zeros((2, n, 2), dtype=bool)  # at the lower and at the upper end
    done, lost, nowhere = (np.zeros(n, dtype=bool) for _ in range(3))
    size = np.full(n, np.inf)
    total = np.maximum(np.abs(equations.rows.total), 1e-3 * largest)
    for i in range(_CLOSINGS):
        live = np.flatnonzero(~(done | lost | nowhere))
        if not len(live):
            break
        at = x[live]
        arcs = equations.solved(live, at[:, None])
        levels = equations.levels(live, at[:, None], arcs)
        gone = np.isinf(levels)
        with np.errstate(invalid="ignore"):
            f = levels[:, 1] - levels[:, 0]
        opposed = gone.all(axis=1) & (levels[:, 0] == levels[:, 1])
        lost[live] = np.isnan(f) & ~opposed
        # both break away, each wanting less: no tension between them helps
        nowhere[live] = opposed
        broken[0][live] |= gone & (opposed | (f < 0.0))[:, None]
        broken[1][live] |= gone & (f > 0.0)[:, None]
        done[live] = np.abs(f) <= tolerance
        below = f < 0.0
        low[live], high[live] = np.where(below, at, low[live]), np.where(below, high[live], at)
        closed = (high[live] - low[live] <= _CLOSE * largest[live]) & ~done[live]
        # a jump between two ways of solving an arc is no edge of friction
        done[live] |= closed & (np.abs(f) <= 1e3 * tolerance)
        nowhere[live] |= closed & ~done[live]
        there = at + _DIFFERENCE * largest[live]
        with np.errstate(invalid="ignore"):
            f_there = np.diff(equations.levels(live, at[:, None], arcs, there[:, None]), axis=1)
        f, f_there = np.arcsinh(f / _SCALE), np.arcsinh(f_there[:, 0] / _SCALE)
        new = _next(at, f, there, f_there)
        # without slopes by the one before, at first by a step that leads across more often than not
        blind = at - np.sign(f) * _FIRST_STEP * total[live]
        other = _next(at, f, before[live], f_before[live]) if i > 0 else blind
        new = np.where(f_there > f, new, other)
        inside = (low[live] < new) & (new < high[live])
        slow = np.zeros(len(live), dtype=bool)
        if i % 3 == 2:
            slow = ~(np.abs(f) < 0.5 * size[live])
            size[live] = np.abs(f)
        new = np.where(inside & ~slow, new, 0.5 * (low[live] + high[live]))
        before[live], f_before[live] = at, f
        x[live] = np.where(done[live], at, new)
    unsure = ~(done | nowhere)
    return Balanced(x[:, None], done, broken.any(axis=0) & nowhere[:, None], unsure)


def _next(x: Array, f: Array, before: Array, f_before: Array) -> Array:
    """Where a straight line through two points is zero, nan or infinite where there is none."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(x - f * (x - before) / (f - f_before))


def _newton(equations: Equations, start: Array) -> Balanced:
    """Newton's method in every row, its steps shortened until they serve."""
    n, k = start.shape
    tolerance = MISSES[equations.setting]
    low = _LEAST * equations.largest[:, None]
    x = np.maximum(start, np.maximum(low, low - equations.rows.runs))
    everywhere = np.arange(n)
    arcs = equations.solved(everywhere, x)
    f = equations.misses(everywhere, x, arcs)
    lost = np.asarray(~np.isfinite(f).all(axis=1))
    size = _size(f)
    for _ in range(_NEWTON_STEPS):
        live = np.flatnonzero(~lost & (size > tolerance))
        if not len(live):
            break
        step, solvable = _step(_slopes(equations, live, x[live], f[live], arcs), f[live])
        lost[live[~solvable]] = True
        left = np.flatnonzero(solvable)
        factor = 1.0
        for _ in range(_HALVINGS):
            rows = live[left]
            if not len(rows):
                break
            new = x[rows] + factor * step[left]
            held = (new > low[rows]) & (new + equations.rows.runs[rows] > low[rows])
            new = np.where(held, new, x[rows])
            there = equations.solved(rows, new)
            f_new = equations.misses(rows, new, there)
            size_new = _size(f_new)
            better = size_new < size[rows]
            good = rows[better]
            x[good], f[good], size[good] = new[better], f_new[better], size_new[better]
            for column, told in zip(arcs, there, strict=True):
                column[good] = told[better]
            left, factor = left[~better], 0.5 * factor
        lost[live[left]] = True
    found = size <= tolerance
    found |= lost & (size <= 1e3 * tolerance)  # as near as the arcs are solved
    return Balanced(x, found, np.zeros((n, k + 1), dtype=bool), ~found)


def _size(misses: Array) -> Array:
    """Largest miss of each row; infinite where an arc breaks away."""
    size = np.abs(misses).max(axis=1)
    return np.where(np.isfinite(size), size, np.inf)


def _slopes(equations: Equations, which: Integers, x: Array, f: Array, arcs: Arcs) -> Array:
    """Slopes of the misses by the tensions, shape (k, drums - 1, drums - 1).

    By those of the arcs, else by differences.
    """
    made, here = np.empty((len(which), x.shape[1], x.shape[1])), Arcs(*(c[which] for c in arcs))
    for j in range(x.shape[1]):
        moved = x.copy()
        moved[:, j] *= 1.0 + _DIFFERENCE
        there = equations.misses(which, x, here, moved)
        rest = np.flatnonzero(np.isnan(there).any(axis=1))
        if len(rest):
            rows, at = which[rest], moved[rest]
            there[rest] = equations.misses(rows, at, equations.solved(rows, at))
        with np.errstate(invalid="ignore"):
            made[:, :, j] = (there - f) / (moved - x)[:, j, None]
    return made


def _step(slopes: Array, f: Array) -> tuple[Array, Flags]:
    """Steps of the linear equations, and where they have one."""
    good = np.asarray(np.isfinite(slopes).all(axis=(1, 2)) & np.isfinite(f).all(axis=1))
    good &= np.abs(np.linalg.det(np.where(good[:, None, None], slopes, 0.0))) > 0.0
    step = np.zeros_like(f)
    if good.any():
        step[good] = np.linalg.solve(slopes[good], -f[good][..., None])[..., 0]
    return step, good
